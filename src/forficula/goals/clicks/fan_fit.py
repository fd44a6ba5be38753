"""Fit of a fan to clicked points: the four numbers of its pattern, and how far every vein deviates from them."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated

import numpy as np
from scipy.stats import t as student

from forficula.arrays import Array, Indices
from forficula.design import Design
from forficula.errors import InputError
from forficula.goals.clicks.different_veins import DifferentVeins, fit_different_veins
from forficula.goals.clicks.fan_least_squares import FanClicks, fan_points, least_squares_fan
from forficula.pattern import Picture, Tangent
from forficula.quantities import show_value
from forficula.results import Result
from forficula.serial import Metres, Radians, Written

ROLES = ("base", "ring", "tip")
FEWEST = 4  # points: 8 coordinates for 4 numbers of the fan and 3 of its placement
_CONFIDENCE = 0.95
_CLEARLY = 4.0  # [chosen] ratio of the sums of squares above which veins count as not clicked
_ARC = 60  # points of the drawn arc of the hub
_LEAST_RANK = 1e-8  # [chosen] ratio of singular values below which points do not determine all numbers


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
        doubts: about the clicks and the fit, as sentences.
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
    unknowns, residuals, jacobian = least_squares_fan(clicks, numbers)
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
    fitted = fan_points(unknowns, numbers)
    different = fit_different_veins(clicks, numbers, unknowns)
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
    unknowns, residuals, _ = least_squares_fan(clicks, plain)
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
    _, other, _ = least_squares_fan(clicks, numbers)
    if _CLEARLY * float(other @ other) > float(residuals @ residuals):
        return plain, []
    missing = sorted(set(range(int(numbers[-1]))) - set(numbers.tolist()))
    veins = f"vein{'s' * (len(missing) > 1)} {', '.join(map(str, missing))}"
    return numbers, [
        f"The angles between the clicked veins show that {veins} {'were' if len(missing) > 1 else 'was'} not clicked;"
        " set numbers if this is wrong."
    ]


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
    veins = fan_points(unknowns, np.arange(fit.vein_count, dtype=np.int64))
    arc = fan_points(unknowns, np.linspace(0, fit.vein_count - 1, _ARC))
    return {"veins": list(veins), "ring": [veins[:, 1]], "hub": [arc[:, 0]]}


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
