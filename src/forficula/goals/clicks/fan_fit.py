"""Fit of a fan to clicked points: the four numbers of its pattern, and how far every vein deviates from them."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Annotated

import numpy as np
from scipy.optimize import least_squares
from scipy.stats import t as student

from forficula.arrays import Array, Indices
from forficula.design import Design
from forficula.errors import InputError
from forficula.pattern import EarwigFan, Picture, Tangent, hub_points, ring_vertices, tips
from forficula.quantities import show_value
from forficula.results import Result
from forficula.serial import Metres, Radians, Written

ROLES = ("base", "ring", "tip")
FEWEST = 4  # points: 8 coordinates for 4 numbers of the fan and 3 of its placement
_ANGLES = 360  # [chosen] sector angles of the scan, between which the last vein turns by 2 deg
_STARTS = 3  # [chosen] largest number of minima of the scan that are refined
_WORST_START = 25.0  # [chosen] ratio to the least sum of squares above which a minimum is not refined
_CONFIDENCE = 0.95
_CLEARLY = 4.0  # [chosen] ratio of the sums of squares above which veins count as not clicked
_ARC = 60  # points of the drawn arc of the hub
_LEAST_RANK = 1e-8  # [chosen] ratio of singular values below which points do not determine all numbers
_FEWEST_DIFFERENT = 5  # veins, from which on a fan with different veins has fewer unknowns than coordinates


@dataclass(frozen=True, kw_only=True, eq=False)
class FanClicks:
    """Clicked points of a fan.

    Attributes:
        points: position of the base, the ring vertex and the tip of every vein, m, y upwards, shape (veins, 3, 2); nan
            where a point was not clicked.
        hub: centre of the hub, m; None if it was not clicked.
        numbers: numbers of the veins; None to find out which veins were not clicked.
        matrix: homography from pixels to m, shape (3, 3).
        picture: the picture; None without one.
        name: name of the picture or of the file.
    """

    points: Array
    hub: Array | None = None
    numbers: tuple[int, ...] | None = None
    matrix: Array = field(default_factory=lambda: np.diag([1.0, -1.0, 1.0]))
    picture: Picture | None = None
    name: str = ""


@dataclass(frozen=True, kw_only=True)
class FittedLength:
    """Fitted length with the ends of its 95 % confidence interval.

    Attributes:
        value: least-squares value, m.
        low: lower end, m.
        high: upper end, m.
    """

    value: Metres
    low: Metres
    high: Metres


@dataclass(frozen=True, kw_only=True)
class FittedAngle:
    """Fitted angle with the ends of its 95 % confidence interval.

    Attributes:
        value: least-squares value, rad.
        low: lower end, rad.
        high: upper end, rad.
    """

    value: Radians
    low: Radians
    high: Radians


@dataclass(frozen=True, kw_only=True)
class FittedVein:
    """Deviations of one vein from the fitted fan, clicked minus fitted.

    Attributes:
        vein: number of the vein, in the order of the clicks.
        base: distance of the clicked base from the fitted one, m; None if it was not clicked.
        ring: distance of the ring vertices, m; None if it was not clicked.
        tip: distance of the tips, m; None if it was not clicked.
        rms: root mean square of these distances, m.
        rms_different: the same for the fan with different veins, m; None without one.
    """

    vein: int
    base: Metres | None
    ring: Metres | None
    tip: Metres | None
    rms: Metres
    rms_different: Metres | None


@dataclass(frozen=True, kw_only=True)
class FittedPoint:
    """Clicked point and the corresponding point of the fitted fan.

    Attributes:
        vein: number of the vein; None for the centre of the hub.
        role: "base", "ring", "tip" or "hub".
        x: clicked position, m.
        y: clicked position, upwards, m.
        fitted_x: position in the fitted fan, m.
        fitted_y: position in the fitted fan, upwards, m.
    """

    vein: int | None
    role: str
    x: Metres
    y: Metres
    fitted_x: Metres
    fitted_y: Metres


@dataclass(frozen=True, kw_only=True, eq=False)
class DifferentVeins:
    """Fit of a fan whose veins differ: a length of every part of a vein and a sector angle of every panel.

    Attributes:
        rms: root mean square distance of the clicked points, m.
        freedoms: number of coordinates minus the number of unknowns.
        unknowns: number of unknowns, with the placement.
        hub_radius: hub radius, m.
        proximal_lengths: length of every vein up to the ring fold, counterclockwise, m.
        distal_lengths: length of every vein beyond the ring fold, counterclockwise, m.
        sector_angles: angle from every vein to the next one, counterclockwise, rad.
        design: design with these veins; None where the fan family does not allow them.
    """

    rms: Metres
    freedoms: int
    unknowns: int
    hub_radius: Metres
    proximal_lengths: tuple[Metres, ...]
    distal_lengths: tuple[Metres, ...]
    sector_angles: tuple[Radians, ...]
    design: Annotated[Design | None, Written.NEVER] = None


@dataclass(frozen=True, kw_only=True, eq=False)
class FanFit(Result):
    """Fan that fits clicked points of a wing best, by least squares.

    Attributes:
        name: name of the picture or of the file of clicks.
        proximal_length: distance from the hub to the ring fold along a vein.
        distal_length: distance from the ring fold to the tip along a vein.
        hub_radius: radius of the circle that the lines of the veins touch.
        sector_angle: angle between neighbouring veins.
        tangent: side on which the veins pass the hub in the picture, "left" or "right"; mirror images differ in it.
        tangent_certain: whether the interval of the signed hub radius excludes the other side.
        vein_count: number of veins from the first to the last clicked one, with those between that were not clicked.
        centre_x: position of the centre of the hub, m.
        centre_y: position of the centre of the hub, upwards, m.
        turn: direction of the radius to the ring vertex of the first vein, counterclockwise from x, rad.
        clockwise: whether the veins were clicked clockwise.
        rms: root mean square distance of the clicked points from the fitted fan.
        standard_deviation: of a coordinate about the fitted fan, from the residuals, m.
        relative_rms: rms / (proximal_length + distal_length).
        freedoms: number of coordinates minus the 7 unknowns.
        veins: deviations by vein.
        points: clicked and fitted points.
        doubts: what is doubtful, as sentences.
        homography: matrix that maps pixels to m, shape (3, 3).
        different: fit of a fan with different veins; None where there are too few points.
        design: design with the fitted pattern; None where the fan family does not allow it.
        picture: the picture; None without one.
    """

    name: Annotated[str, Written.ALWAYS]
    proximal_length: FittedLength
    distal_length: FittedLength
    hub_radius: FittedLength
    sector_angle: FittedAngle
    tangent: Tangent
    tangent_certain: bool
    vein_count: int
    centre_x: Metres
    centre_y: Metres
    turn: Radians
    clockwise: bool
    rms: Metres
    standard_deviation: Metres
    relative_rms: float
    freedoms: int
    veins: tuple[FittedVein, ...]
    points: tuple[FittedPoint, ...]
    doubts: tuple[str, ...]
    homography: tuple[tuple[float, ...], ...]
    different: DifferentVeins | None = None
    design: Annotated[Design | None, Written.NEVER] = None
    picture: Annotated[Picture | None, Written.NEVER] = None

    def __repr__(self) -> str:
        """Return the picture, the four numbers and the residual."""
        numbers = (self.proximal_length, self.distal_length, self.hub_radius)
        lengths = ", ".join(show_value(number.value, "m", 3) for number in numbers)
        return (
            f"<Fan of {self.name or 'clicks'}: {self.vein_count} veins, {lengths},"
            f" {show_value(self.sector_angle.value, 'rad', 3)}, residual {show_value(self.rms, 'm', 2)}>"
        )


def fit_fan(clicks: FanClicks) -> FanFit:
    """Fit a fan to clicked points by least squares, without a start.

    With a fixed sector angle the points of a fan are linear in three complex unknowns: the centre, the radius to the
    first ring vertex and the first distal vein. A scan over sector angles of both senses therefore finds every start.
    The hub radius is signed: it is positive where the veins pass the hub on the right, so mirror images are not a
    separate case.

    Raises:
        InputError: too few points, or points that do not determine all numbers.
    """
    _check_enough(clicks)
    numbers, doubts = _vein_numbers(clicks)
    unknowns, residuals, jacobian = _fit_numbers(clicks, numbers)
    norms = np.linalg.norm(jacobian, axis=0)
    singular = np.linalg.svd(jacobian / np.where(norms > 0, norms, 1.0), compute_uv=False)
    if not singular[-1] > _LEAST_RANK * singular[0]:
        raise InputError(
            "the clicked points do not determine hub radius, lengths and sector angle; click the ring fold and the tip"
            " of at least 3 veins"
        )
    freedoms = residuals.size - len(unknowns)
    deviation = math.sqrt(float(residuals @ residuals) / freedoms)
    covariance = deviation**2 * np.linalg.inv(jacobian.T @ jacobian)
    half = float(student.ppf((1 + _CONFIDENCE) / 2, freedoms)) * np.sqrt(np.diag(covariance))
    hub, proximal, distal, sector = unknowns[:4].tolist()
    certain = abs(hub) > half[0]
    if not certain:
        doubts.append(
            "The interval of the hub radius contains 0, so the side on which the veins pass the hub is uncertain."
        )
    count = int(numbers.max()) + 1
    if count % 2 == 0:
        doubts.append(
            f"A fan of n units has 2 n + 1 veins. The number of clicked veins, {count}, is even, so the design has one"
            " more vein."
        )
    tangent: Tangent = "right" if hub >= 0 else "left"
    fitted = _model(unknowns, numbers)
    different = _fit_different(clicks, numbers, unknowns)
    apart = clicks.points - fitted
    rms = _rms(apart, clicks, unknowns)
    return FanFit(
        name=clicks.name,
        proximal_length=_length(proximal, half[1]),
        distal_length=_length(distal, half[2]),
        hub_radius=_length(abs(hub), half[0]),
        sector_angle=FittedAngle(
            value=abs(sector), low=max(abs(sector) - float(half[3]), 0.0), high=abs(sector) + float(half[3])
        ),
        tangent=tangent,
        tangent_certain=bool(certain),
        vein_count=count,
        centre_x=float(unknowns[4]),
        centre_y=float(unknowns[5]),
        turn=float(np.angle(np.exp(1j * unknowns[6]))),
        clockwise=sector < 0,
        rms=rms,
        standard_deviation=deviation,
        relative_rms=rms / (proximal + distal),
        freedoms=freedoms,
        veins=tuple(_by_vein(numbers, apart, different[1] if different else None)),
        points=tuple(_points(clicks, numbers, fitted, unknowns)),
        doubts=tuple(doubts),
        homography=tuple(tuple(row) for row in clicks.matrix.tolist()),
        different=different[0] if different else None,
        picture=clicks.picture,
    )


def _length(value: float, half: float) -> FittedLength:
    return FittedLength(value=value, low=max(value - float(half), 0.0), high=value + float(half))


def _check_enough(clicks: FanClicks) -> None:
    """Refuse fewer points than the unknowns need."""
    known = ~np.isnan(clicks.points[:, :, 0])
    count, hub = int(known.sum()), clicks.hub is not None
    if count + hub < FEWEST:
        raise InputError(
            f"need at least {FEWEST} clicked points, because a fan and its placement have 7 numbers, got {count + hub}"
        )
    for role, name in ((1, "ring fold"), (2, "tip")):
        if not known[:, role].any():
            raise InputError(f"{ROLES[role]}: need at least one point at the {name} of a vein, got none")
    if int(known.any(axis=1).sum()) < 2:
        raise InputError("need points of at least 2 veins, got 1")


def _vein_numbers(clicks: FanClicks) -> tuple[Indices, list[str]]:
    """Return the numbers of the veins, from 0, and sentences about veins that were not clicked."""
    if clicks.numbers is not None:
        return np.array(clicks.numbers, dtype=np.int64), []
    plain = np.arange(len(clicks.points), dtype=np.int64)
    unknowns, residuals, _ = _fit_numbers(clicks, plain)
    centre = unknowns[4:6]
    steps = None
    for role in (1, 2):
        azimuths = np.angle((clicks.points[:, role] - centre) @ np.array([1, 1j]))
        apart = np.abs(np.angle(np.exp(1j * np.diff(azimuths))))
        if len(apart) > 1 and not np.isnan(apart).any() and np.median(apart) > 0:
            steps = np.maximum(np.rint(apart / np.median(apart)), 1).astype(np.int64)
            break
    if steps is None or (steps == 1).all():
        return plain, []
    numbers = np.concatenate([[0], np.cumsum(steps)])
    _, other, _ = _fit_numbers(clicks, numbers)
    if _CLEARLY * float(other @ other) > float(residuals @ residuals):
        return plain, []
    missing = sorted(set(range(int(numbers[-1]))) - set(numbers.tolist()))
    veins = f"vein{'s' * (len(missing) > 1)} {', '.join(map(str, missing))}"
    return numbers, [
        f"The angles between the clicked veins show that {veins} {'were' if len(missing) > 1 else 'was'} not clicked;"
        " set numbers if this is wrong."
    ]


def _complex(points: Array) -> Array:
    return np.asarray(points[..., 0] + 1j * points[..., 1])


def _model(unknowns: Array, numbers: Array | Indices) -> Array:
    """Return base, ring vertex and tip of veins, m, shape (veins, 3, 2).

    Args:
        unknowns: signed hub radius, proximal and distal length, signed sector angle, x and y of the centre, direction
            of the first ring vertex.
        numbers: numbers of the veins.
    """
    hub, proximal, distal, sector, x, y, turn = unknowns
    epsilon = math.atan2(hub, proximal)
    ray = np.exp(1j * (turn + sector * numbers))
    base = hub * ray * np.exp(1j * (epsilon - math.pi / 2))
    ring = math.hypot(proximal, hub) * ray
    points = np.stack([base, ring, ring + distal * ray * np.exp(-1j * epsilon)], axis=1) + (x + 1j * y)
    return np.stack([points.real, points.imag], axis=-1)


def fitted_lines(fit: FanFit) -> dict[str, list[Array]]:
    """Return the lines of a fitted fan, m, shape (points, 2): "veins", "ring" and "hub", the arc that veins touch."""
    side = 1 if fit.tangent == "right" else -1
    sense = -1 if fit.clockwise else 1
    unknowns = np.array(
        [
            *(side * fit.hub_radius.value, fit.proximal_length.value, fit.distal_length.value),
            *(sense * fit.sector_angle.value, fit.centre_x, fit.centre_y, fit.turn),
        ]
    )
    veins = _model(unknowns, np.arange(fit.vein_count, dtype=np.int64))
    arc = _model(unknowns, np.linspace(0, fit.vein_count - 1, _ARC))
    return {"veins": list(veins), "ring": [veins[:, 1]], "hub": [arc[:, 0]]}


def _apart(unknowns: Array, clicks: FanClicks, numbers: Indices) -> Array:
    """Return the deviations of all clicked coordinates from a fan, m."""
    apart = (clicks.points - _model(unknowns, numbers)).ravel()
    of_hub = np.zeros(0) if clicks.hub is None else clicks.hub - unknowns[4:6]
    return np.concatenate([apart[~np.isnan(apart)], of_hub])


def _fit_numbers(clicks: FanClicks, numbers: Indices) -> tuple[Array, Array, Array]:
    """Return the unknowns of the best fan with these numbers of veins, its residuals, m, and the Jacobian."""
    best = None
    whole = clicks.points[~np.isnan(clicks.points[:, :, 0])]
    size = float(np.ptp(whole, axis=0).max())
    if size == 0:
        raise InputError("need clicked points at different positions, got one position")
    for start in _starts(clicks, numbers):
        scales = np.array([size, size, size, 1 / max(int(numbers.max()), 1), size, size, 1.0])
        done = least_squares(
            lambda unknowns: _apart(unknowns, clicks, numbers) / size,
            start,
            x_scale=scales,
            method="lm",
            max_nfev=2000,
        )
        if best is None or done.cost * size**2 < best[0]:
            best = done.cost * size**2, done.x, size * done.fun, size * done.jac
    assert best is not None
    unknowns = best[1]
    if unknowns[1] < 0:  # the same fan with the veins on the other side of the centre
        unknowns = unknowns * np.array([-1, -1, 1, 1, 1, 1, 1]) + np.array([0, 0, 0, 0, 0, 0, math.pi])
        best = best[0], unknowns, best[2], best[3] * np.array([-1, -1, 1, 1, 1, 1, 1])
    return unknowns, best[2], best[3]


def _starts(clicks: FanClicks, numbers: Indices) -> Iterator[Array]:
    """Yield starts: the minima of linear least squares over sector angles."""
    known = ~np.isnan(clicks.points[:, :, 0])
    vein, role = np.nonzero(known)
    places = _complex(clicks.points[vein, role])
    most = min(2 * math.pi / max(int(numbers.max()), 1), math.pi)
    angles = most * (np.arange(_ANGLES) + 0.5 - _ANGLES / 2) / (_ANGLES / 2)
    rays = np.exp(1j * angles[:, None] * numbers[vein])
    columns = [np.ones_like(rays), rays * (role >= 1), rays * (role == 2)]
    if (role == 0).any():
        columns.append(rays * (role == 0))
    matrix = np.stack(columns, axis=-1)
    if clicks.hub is not None:
        row = np.zeros((_ANGLES, 1, matrix.shape[-1]))
        row[..., 0] = 1
        matrix, places = np.concatenate([matrix, row], axis=1), np.append(places, _complex(clicks.hub))
    solved = np.linalg.pinv(matrix) @ places
    costs = np.sum(np.abs((matrix @ solved[..., None])[..., 0] - places) ** 2, axis=1)
    around = np.concatenate([[np.inf], costs, [np.inf]])
    minima = np.flatnonzero((costs <= around[:-2]) & (costs <= around[2:]))
    minima = minima[np.argsort(costs[minima])][:_STARTS]
    for index in minima[costs[minima] <= _WORST_START * costs[minima[0]]]:
        centre, radius, distal = solved[index, :3].tolist()
        epsilon = -float(np.angle(distal / radius)) if radius and distal else 0.0
        # a hub whose tangents point outwards
        epsilon = min(max(epsilon, -1.4), 1.4)
        yield np.array(
            [
                abs(radius) * math.sin(epsilon),
                abs(radius) * math.cos(epsilon),
                abs(distal),
                angles[index],
                centre.real,
                centre.imag,
                float(np.angle(radius)),
            ]
        )


def _rms(apart: Array, clicks: FanClicks, unknowns: Array) -> float:
    squares = (apart**2).sum(axis=-1)
    distances = squares[~np.isnan(squares)].tolist()
    if clicks.hub is not None:
        distances.append(float(((clicks.hub - unknowns[4:6]) ** 2).sum()))
    return math.sqrt(float(np.mean(distances)))


def _by_vein(numbers: Indices, apart: Array, other: Array | None) -> Iterator[FittedVein]:
    distances = np.linalg.norm(apart, axis=-1)
    for row, number in enumerate(numbers.tolist()):
        base, ring, tip = (None if math.isnan(distance) else distance for distance in distances[row].tolist())
        known = distances[row][~np.isnan(distances[row])]
        if not len(known):
            continue
        rms_other = None
        if other is not None:
            squares = (other[row] ** 2).sum(axis=-1)
            rms_other = math.sqrt(float(np.nanmean(squares)))
        yield FittedVein(
            vein=number,
            base=base,
            ring=ring,
            tip=tip,
            rms=math.sqrt(float(np.mean(known**2))),
            rms_different=rms_other,
        )


def _points(clicks: FanClicks, numbers: Indices, fitted: Array, unknowns: Array) -> Iterator[FittedPoint]:
    for row, number in enumerate(numbers.tolist()):
        for role, name in enumerate(ROLES):
            (x, y), (u, v) = clicks.points[row, role].tolist(), fitted[row, role].tolist()
            if not math.isnan(x):
                yield FittedPoint(vein=number, role=name, x=x, y=y, fitted_x=u, fitted_y=v)
    if clicks.hub is not None:
        (x, y), (u, v) = clicks.hub.tolist(), unknowns[4:6].tolist()
        yield FittedPoint(vein=None, role="hub", x=x, y=y, fitted_x=u, fitted_y=v)


def _fit_different(clicks: FanClicks, numbers: Indices, unknowns: Array) -> tuple[DifferentVeins, Array] | None:
    """Fit a fan whose veins differ; return it with the deviations of all points, m, shape (veins, 3, 2).

    Returns None where a vein lacks its ring vertex or its tip, for an even number of veins or fewer than 5, and where
    the family of fans allows no such fan near the common one.
    """
    count = len(numbers)
    whole = not np.isnan(clicks.points[:, 1:]).any() and (np.diff(numbers) == 1).all()
    if not whole or count % 2 == 0 or count < _FEWEST_DIFFERENT:
        return None
    order = np.arange(count) if unknowns[3] > 0 else np.arange(count)[::-1]
    clicked = clicks.points[order]
    size = float(unknowns[1] + unknowns[2])
    tangent: Tangent = "right" if unknowns[0] >= 0 else "left"

    def fan_of(values: Array) -> EarwigFan:
        proximal, distal, sectors = np.split(values[4:], [count, 2 * count])
        return EarwigFan(
            proximal_length=float(proximal.mean()) * size,
            distal_length=float(distal.mean()) * size,
            hub_radius=float(values[0]) * size,
            sector_angle=float(sectors.mean()),
            units=(count - 1) // 2,
            tangent=tangent,
            proximal_shares=tuple((proximal / proximal.mean()).tolist()),
            distal_shares=tuple((distal / distal.mean()).tolist()),
            sector_shares=tuple((sectors / sectors.mean()).tolist()),
        )

    def apart_of(values: Array) -> Array:
        fan = fan_of(values)
        drawn = np.stack([_complex(part) for part in (hub_points(fan), ring_vertices(fan), tips(fan))], axis=1)
        placed = drawn * np.exp(1j * values[3]) + size * (values[1] + 1j * values[2])
        return np.asarray(clicked - np.stack([placed.real, placed.imag], axis=-1))

    def residuals(values: Array) -> Array:
        try:
            apart = apart_of(values).ravel()
        except InputError:
            return np.full(coordinates, 10.0)
        of_hub = np.zeros(0) if clicks.hub is None else clicks.hub - size * values[1:3]
        return np.concatenate([apart[~np.isnan(apart)], of_hub]) / size

    coordinates = int((~np.isnan(clicked)).sum()) + (0 if clicks.hub is None else 2)
    middle = float(unknowns[6] + unknowns[3] * (count - 1) / 2)
    common = [unknowns[1] / size, unknowns[2] / size, abs(unknowns[3])]
    sides = [[value] * (count - (position == 2)) for position, value in enumerate(common)]
    start = np.array([abs(unknowns[0]) / size, *(unknowns[4:6] / size), middle, *itertools.chain(*sides)])
    freedoms = coordinates - len(start)
    if freedoms < 1 or residuals(start)[0] == 10.0:
        return None
    low = np.full(len(start), -np.inf)
    low[0], low[4:] = 0.0, 1e-3
    done = least_squares(residuals, np.maximum(start, low + 1e-9), bounds=(low, np.inf), x_scale="jac", max_nfev=60)
    best = done.x
    if done.fun[0] == 10.0:
        return None
    apart = apart_of(best)
    squares = (apart**2).sum(axis=-1)
    distances = squares[~np.isnan(squares)].tolist()
    if clicks.hub is not None:
        distances.append(float(((clicks.hub - size * best[1:3]) ** 2).sum()))
    proximal, distal, sectors = np.split(best[4:], [count, 2 * count])
    fit = DifferentVeins(
        rms=math.sqrt(float(np.mean(distances))),
        freedoms=freedoms,
        unknowns=len(best),
        hub_radius=float(best[0]) * size,
        proximal_lengths=tuple((size * proximal).tolist()),
        distal_lengths=tuple((size * distal).tolist()),
        sector_angles=tuple(sectors.tolist()),
    )
    return fit, apart[np.argsort(order)]
