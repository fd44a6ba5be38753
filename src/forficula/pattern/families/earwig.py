"""The earwig fan: radial veins tangent to a hub, and one ring fold across them, or two for thick sheets."""

from __future__ import annotations

import math
import numbers
from dataclasses import dataclass, replace
from functools import lru_cache
from itertools import pairwise
from typing import Literal, get_args

import numpy as np

from forficula.arrays import Array, Indices
from forficula.errors import InputError
from forficula.pattern.crease_pattern import CreasePattern

Tangent = Literal["left", "right"]
# dimensions that may differ between veins
_SHARES = ("proximal_shares", "distal_shares", "hub_shares", "sector_shares")
_POINT = 1e-15  # share of the proximal length; a smaller hub is below the rounding of the coordinates


@dataclass(frozen=True, kw_only=True)
class EarwigFan:
    """Dimensions of a fan; a fan with one ring fold is flat-foldable by construction.

    The fan is a simplification of the hindwing pattern of Saito et al. 2020, doi 10.1073/pnas.2005769117. Every
    proximal vein is tangent to the hub circle. At the ring fold the vein turns by twice epsilon, so that the line of
    the distal vein touches the hub on the other side.

    Lengths, hub radii and sector angles of single veins are shares of the common values. The direction of a distal vein
    then follows from Kawasaki's condition at its ring vertex, so that the fan folds flat with any shares, see
    docs/model/theory.md, section "Fan with different veins". Shares of veins need one ring fold.

    In a thick sheet the folded layers are one pitch apart. A stack cannot fold about one line, because its outer layers
    must pass around the inner ones. With two ring folds of 90 deg and a short gusset between them, every layer has its
    own path around the inner ones: k layers lie inside vein k, counted from the vein on whose side the folded distal
    stack lies (the first one for the tangent on the right). So the first ring fold of vein k is k pitches further out,
    and its gusset is 2 k pitches higher. The folded layers lie j pitches above the outermost one: 2 n proximal layers,
    then, beyond the lowest gusset, 2 n distal ones. The ring folds tilt between neighbouring veins, by about
    atan(pitch / chord) and atan(3 pitch / chord). So their vertices do not satisfy Kawasaki's condition, and such a fan
    does not fold flat as paper does: every vein folds along the crease without the tilt, see `ring_directions`, and its
    membrane deforms.

    Attributes:
        proximal_length: distance from the hub to the ring fold along a vein, m.
        distal_length: distance from the ring fold to the tip along a vein, m.
        hub_radius: radius of the circle that the lines of the veins touch, m; with 0 all veins meet in a point.
        sector_angle: angle between neighbouring veins, rad.
        units: number of fan units of two panels; n units have 2 n + 1 veins.
        tangent: side on which the proximal veins pass the centre of the hub, seen outwards along the vein.
        ring_folds: number of ring folds, 1, or 2 for a thick sheet.
        pitch: distance between neighbouring folded layers, m; 0 with one ring fold.
        gusset_height: distance between the folded bars of the innermost vein, m; 0 with one ring fold.
        proximal_shares: length of every proximal vein / `proximal_length`, (2 n + 1); all 1 if empty.
        distal_shares: length of every distal vein / `distal_length`, (2 n + 1); all 1 if empty.
        hub_shares: radius of the circle about the centre that every proximal vein touches / `hub_radius`, (2 n + 1);
            all 1 if empty.
        sector_shares: angle from every proximal vein to the next one / `sector_angle`, (2 n); all 1 if empty.
    """

    proximal_length: float
    distal_length: float
    hub_radius: float
    sector_angle: float
    units: int
    tangent: Tangent = "right"
    ring_folds: int = 1
    pitch: float = 0.0
    gusset_height: float = 0.0
    proximal_shares: tuple[float, ...] = ()
    distal_shares: tuple[float, ...] = ()
    hub_shares: tuple[float, ...] = ()
    sector_shares: tuple[float, ...] = ()

    def __post_init__(self) -> None:
        for key in ("proximal_length", "distal_length"):
            _check_number(key, getattr(self, key), 100, "cm")
            if getattr(self, key) <= 0:
                raise InputError(f"pattern.{key}: need > 0, got {_centimetres(getattr(self, key))}")
        _check_number("hub_radius", self.hub_radius, 100, "cm")
        if self.hub_radius < 0:
            raise InputError(f"pattern.hub_radius: need >= 0, got {_centimetres(self.hub_radius)}")
        _check_number("sector_angle", self.sector_angle, math.degrees(1), "deg")
        if not 0 < self.sector_angle < math.pi:
            raise InputError(f"pattern.sector_angle: need > 0 deg and < 180 deg, got {_degrees(self.sector_angle)}")
        if isinstance(self.units, bool) or not isinstance(self.units, numbers.Integral) or self.units < 1:
            raise InputError(f"pattern.units: need a whole number of fan units, 1 or more, got {self.units!r}")
        if self.tangent not in get_args(Tangent):
            raise InputError(f"pattern.tangent: need left or right, got {self.tangent!r}")
        _check_shares(self)
        _check_fan_stays_open(self)
        _check_ring_vertices(self)
        _check_ring_folds(self)

    @property
    def vein_count(self) -> int:
        """Number of veins, 2 n + 1 for n units."""
        return 2 * int(self.units) + 1

    @property
    def varied(self) -> tuple[str, ...]:
        """Names of the shares that are given."""
        return tuple(name for name in _SHARES if getattr(self, name))

    @property
    def proximal_lengths(self) -> tuple[float, ...]:
        """Length of every proximal vein, m, (2 n + 1)."""
        return tuple(self.proximal_length * share for share in self.proximal_shares or (1.0,) * self.vein_count)

    @property
    def distal_lengths(self) -> tuple[float, ...]:
        """Length of every distal vein, m, (2 n + 1)."""
        return tuple(self.distal_length * share for share in self.distal_shares or (1.0,) * self.vein_count)

    @property
    def ring_radius(self) -> float:
        """Distance of a ring vertex from the centre of the hub, with shares of 1, m (Pythagoras)."""
        return math.hypot(self.proximal_length, self.hub_radius)

    @property
    def epsilon(self) -> float:
        """Angle between a vein and the radius to its ring vertex, with shares of 1, asin(hub_radius / ring_radius)."""
        return math.atan2(self.hub_radius, self.proximal_length)


def _centimetres(length: float) -> str:
    return f"{100 * length:.6g} cm"


def _degrees(angle: float) -> str:
    return f"{math.degrees(angle):.6g} deg"


def _check_number(key: str, value: object, factor: float, unit: str) -> None:
    """Raise InputError for a value that is not a finite number."""
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise InputError(f"pattern.{key}: need a number, got {value!r}")
    if not math.isfinite(value):
        raise InputError(f"pattern.{key}: need a finite number, got {factor * float(value):g} {unit}")


def _check_shares(fan: EarwigFan) -> None:
    """Raise InputError for shares of another number of veins, or that are not numbers > 0."""
    for key in fan.varied:
        shares, count = getattr(fan, key), 2 * int(fan.units) + (key != "sector_shares")
        what = "panels" if key == "sector_shares" else "veins"
        if len(shares) != count:
            raise InputError(
                f"pattern.{key}: need {count} numbers, one for each of the {count} {what} with pattern.units ="
                f" {fan.units}, got {len(shares)}"
            )
        for number, share in enumerate(shares):
            _check_number(f"{key}: entry {number}", share, 1, "times")
            if share <= 0:
                raise InputError(f"pattern.{key}: entry {number}: need > 0, got {share:g}")
    if fan.varied and fan.ring_folds != 1:
        raise InputError(f"pattern.{fan.varied[0]}: needs one ring fold (pattern.ring_folds = 1), got {fan.ring_folds}")


def _check_fan_stays_open(fan: EarwigFan) -> None:
    """Raise InputError for a fan that closes on itself around the hub."""
    if fan.sector_shares:
        whole = math.fsum(fan.sector_shares) * fan.sector_angle
        if whole >= 2 * math.pi:
            raise InputError(
                "pattern.sector_shares: the fan closes on itself: need a sum of all sector angles < 360 deg,"
                f" got {_degrees(whole)}"
            )
        return
    if 2 * fan.units * fan.sector_angle >= 2 * math.pi:
        most_units = math.ceil(math.pi / fan.sector_angle) - 1
        raise InputError(
            f"pattern.units: the fan closes on itself: need at most {most_units} at "
            f"{_degrees(fan.sector_angle)}, or pattern.sector_angle < "
            f"{_degrees(math.pi / fan.units)} at {fan.units}, got {fan.units} units"
        )


def _check_ring_vertices(fan: EarwigFan) -> None:
    """Raise InputError for a hub so large that a ring crease coincides with a vein, and for veins that fold inwards."""
    if fan.varied:
        _check_different_veins(fan)
        return
    if fan.epsilon + fan.sector_angle / 2 >= math.pi / 2:
        largest = fan.proximal_length / math.tan(fan.sector_angle / 2)
        raise InputError(
            f"pattern.hub_radius: need < {_centimetres(largest)}, proximal_length / tan(sector_angle / 2), so that the "
            f"ring fold meets the veins at an angle; choose a smaller hub_radius or sector_angle or a longer "
            f"proximal_length, got {_centimetres(fan.hub_radius)}"
        )


def _check_different_veins(fan: EarwigFan) -> None:
    """Raise InputError for veins that cannot fold in alternating senses, that cross, or whose panels bend inwards."""
    key = " and ".join(f"pattern.{name}" for name in fan.varied)
    before, after = ring_sectors(fan)
    ratios = ring_ratios(fan)
    for vein in range(fan.vein_count):
        sectors = f"{_degrees(before[vein])} to the previous and {_degrees(after[vein])} to the next ring crease"
        if not (0 < before[vein] < math.pi and 0 < after[vein] < math.pi):
            raise InputError(
                f"{key}: vein {vein} does not cross the ring fold: its proximal part needs angles > 0 deg and < 180 deg"
                f" with both ring creases, got {sectors}; choose more similar shares"
            )
        # without a hub the ring fold of equal ring vertices stays flat until the pleats are closed
        if ratios[vein] < 0 or (ratios[vein] == 0 and ratios.any()):
            least, most = ("previous", "next") if fan.tangent == "right" else ("next", "previous")
            raise InputError(
                f"{key}: vein {vein} would fold in the same sense as its neighbours: its proximal part needs a smaller"
                f" angle with the {least} ring crease than with the {most} one, got {sectors}; choose more similar"
                " shares or a larger pattern.hub_radius"
            )
    hub, ring = hub_points(fan), ring_vertices(fan)
    for vein in range(fan.vein_count - 1):
        if _cross((hub[vein], ring[vein]), (hub[vein + 1], ring[vein + 1])):
            raise InputError(
                f"{key}: the proximal parts of veins {vein} and {vein + 1} cross near the hub: choose more similar"
                " shares or a smaller pattern.hub_radius"
            )
    if (panel := _panel_bending_inwards(fan)) is not None:
        raise InputError(
            f"{key}: a panel between veins {panel} and {panel + 1} bends inwards: choose more similar shares or shorter"
            " distal veins"
        )


def _cross(one: tuple[Array, Array], other: tuple[Array, Array]) -> bool:
    """Return whether two segments in the plane cross."""

    def side(ends: tuple[Array, Array], point: Array) -> float:
        (x, y), (u, v) = (ends[1] - ends[0])[:2], (point - ends[0])[:2]
        return float(x * v - y * u)

    return all(side(a, b[0]) * side(a, b[1]) < 0 for a, b in ((one, other), (other, one)))


def _panel_bending_inwards(fan: EarwigFan) -> int | None:
    """Return the number of a panel that has a corner of more than 180 deg, other than at the hub; None without one."""
    lines = [hub_points(fan), *(ring_vertices(fan, fold=fold) for fold in range(fan.ring_folds)), tips(fan)]
    for line, (inner, outer) in enumerate(pairwise(lines)):
        corners = np.stack([inner[:-1], outer[:-1], outer[1:], inner[1:]])
        sides = np.roll(corners, -1, axis=0) - corners
        # at both outer corners, and at the inner ones except at the hub, where tangents lie beside its chords
        turns = np.cross(sides, np.roll(sides, -1, axis=0))[: 4 if line else 2, :, 2]
        if (turns <= 0).any():
            return int(np.argmax((turns <= 0).any(axis=0)))
    return None


def _check_ring_folds(fan: EarwigFan) -> None:
    """Raise InputError for other numbers of ring folds, sizes that contradict them, and panels that overlap flat."""
    if isinstance(fan.ring_folds, bool) or fan.ring_folds not in (1, 2):
        raise InputError(f"pattern.ring_folds: need 1 or 2, got {fan.ring_folds!r}")
    for key in ("pitch", "gusset_height"):
        length = getattr(fan, key)
        _check_number(key, length, 100, "cm")
        if fan.ring_folds == 1 and length:
            raise InputError(f"pattern.{key}: need two ring folds, got {_centimetres(length)} with one")
        if fan.ring_folds == 2 and length <= 0:
            raise InputError(f"pattern.{key}: need > 0 with two ring folds, got {_centimetres(length)}")
    if fan.ring_folds == 1:
        return
    if _panel_bending_inwards(fan) is not None:
        raise InputError(
            "pattern.pitch: the ring folds tilt so steeply that a panel bends inwards: need a smaller pitch, fewer"
            f" pattern.units or a larger pattern.sector_angle, got {_centimetres(fan.pitch)}"
        )


@dataclass(frozen=True, kw_only=True, eq=False)
class _Veins:
    """Polar coordinates of the veins, and of one more on each side, with which the ring fold continues.

    The share of an added vein follows from the three outermost ones by x = x_2 x_1 / x_3, from the rim inwards, so that
    equal shares, shares that alternate and shares in a geometric series continue as they are; the added sector equals
    the last but one.

    Attributes:
        hub_radii: radii of the circles that the veins touch, m, (2 n + 3).
        epsilon: angles between the veins and the radii to their ring vertices, rad, (2 n + 3).
        radii: distances of the ring vertices from the centre, m, (2 n + 3).
        azimuths: polar angles of the radii to the ring vertices, rad, (2 n + 3); that of the middle vein is 0.
        sectors: angles between neighbouring radii, rad, (2 n + 2).
        tilts: angles by which the ring creases deviate from the normal of the bisector of their sector, positive
            outwards in the counterclockwise direction, rad, (2 n + 2).
    """

    hub_radii: Array
    epsilon: Array
    radii: Array
    azimuths: Array
    sectors: Array
    tilts: Array


@lru_cache(maxsize=64)
def _veins(fan: EarwigFan) -> _Veins:
    side, middle = _side(fan), int(fan.units) + 1
    lengths = fan.proximal_length * _continued(fan.proximal_shares, fan.vein_count)
    hub_radii = fan.hub_radius * _continued(fan.hub_shares, fan.vein_count)
    panels = fan.sector_shares or (1.0,) * (fan.vein_count - 1)
    shares = np.array([panels[1], *panels, panels[-2]])
    # vein by vein, because the functions of arrays round differently
    pairs = list(zip(hub_radii.tolist(), lengths.tolist(), strict=True))
    epsilon = np.array([math.atan2(radius, length) for radius, length in pairs])
    radii = np.array([math.hypot(length, radius) for radius, length in pairs])
    positions = np.concatenate([[0.0], np.cumsum(shares)])
    # veins are one sector angle apart, and ring vertices differ by the difference of the angles epsilon
    azimuths = (positions - positions[middle]) * fan.sector_angle - side * (epsilon - epsilon[middle])
    sectors = shares * fan.sector_angle - side * np.diff(epsilon)
    steps, sums = np.diff(radii), radii[1:] + radii[:-1]
    tilts = np.arctan2(steps * np.cos(sectors / 2), sums * np.sin(sectors / 2))
    return _Veins(hub_radii=hub_radii, epsilon=epsilon, radii=radii, azimuths=azimuths, sectors=sectors, tilts=tilts)


def _continued(shares: tuple[float, ...], count: int) -> Array:
    """Return shares with one more on each side, (count + 2)."""
    veins = shares or (1.0,) * count
    first, last = veins[1] * veins[0] / veins[2], veins[-2] * veins[-1] / veins[-3]
    return np.array([first, *veins, last], dtype=np.float64)


def ring_sectors(fan: EarwigFan) -> tuple[Array, Array]:
    """Compute the angles between the proximal vein and the two ring creases at every ring vertex.

    The ring creases of the outermost veins beyond the rim are those of the continued pattern.

    Returns:
        Angles with the previous and with the next ring crease, rad, (2 n + 1,) each.
    """
    veins, side = _veins(fan), _side(fan)
    square = math.pi / 2 - veins.sectors / 2
    apart = side * veins.epsilon[1:-1]
    return square[:-1] - veins.tilts[:-1] - apart, square[1:] + veins.tilts[1:] + apart


def ring_ratios(fan: EarwigFan) -> Array:
    """Compute m of every vein, the ratio of the tangents of half the ring's and half the vein's fold angle.

    See docs/model/theory.md, sections "Fan pattern" and "Fan with different veins". It is positive where a vein folds
    in the sense of `earwig_pattern`, and 0 with a hub radius of 0 and equal shares.

    Returns:
        Ratios, (2 n + 1,).
    """
    veins, side = _veins(fan), _side(fan)
    half_difference = side * (
        side * veins.epsilon[1:-1] + (veins.tilts[:-1] + veins.tilts[1:]) / 2 - np.diff(veins.sectors) / 4
    )
    half_sum = (veins.sectors[:-1] + veins.sectors[1:]) / 4 - np.diff(veins.tilts) / 2
    # one by one, because the functions of arrays round differently
    return np.array(
        [math.sin(a) / math.cos(b) for a, b in zip(half_difference.tolist(), half_sum.tolist(), strict=True)]
    )


def _on_circle(radius: float | Array, azimuths: Array) -> Array:
    """Return points on one circle, or on one for each, around the origin at z = 0, shape (count, 3)."""
    points: Array = np.zeros((len(azimuths), 3))
    points[:, 0] = radius * np.cos(azimuths)
    points[:, 1] = radius * np.sin(azimuths)
    return points


def _layers(fan: EarwigFan, count: int) -> Indices:
    """Return the number of folded layers inside every vein, (count,)."""
    veins = np.arange(count, dtype=np.int64)
    return veins if fan.tangent == "right" else 2 * int(fan.units) - veins


def _side(fan: EarwigFan) -> int:
    """Return +1 where proximal veins pass the hub on the right, -1 on the left."""
    return 1 if fan.tangent == "right" else -1


def hub_points(fan: EarwigFan) -> Array:
    """Compute the points where the proximal veins touch the hub.

    The radius to such a point is perpendicular to the tangent, so the angle between it and the radius to the ring
    vertex is 90 deg - epsilon.

    Returns:
        Positions, m, shape (2 n + 1, 3), counterclockwise, z = 0; the centre of the hub is the origin.
    """
    veins = _veins(fan)
    return _on_circle(veins.hub_radii[1:-1], veins.azimuths[1:-1] - _side(fan) * (math.pi / 2 - veins.epsilon[1:-1]))


def ring_vertices(fan: EarwigFan, continued: bool = False, fold: int = 0) -> Array:
    """Compute the points where the veins cross a ring fold; with one ring fold the middle point is on +x.

    Args:
        fan: dimensions of the fan.
        continued: whether to add the next vertex of the continued pattern, which gives the last vein a ring crease.
        fold: number of the ring fold, counted outwards from the hub from 0.

    Returns:
        Positions, m, shape (2 n + 1, 3), or (2 n + 2, 3) if continued, counterclockwise, z = 0.
    """
    veins, shown = _veins(fan), slice(1, fan.vein_count + 1 + continued)
    azimuths = veins.azimuths[shown]
    vertices = _on_circle(veins.radii[shown], azimuths)
    if fan.ring_folds == 1:
        return vertices
    layers, apart = _layers(fan, len(azimuths))[:, None], _side(fan) * fan.epsilon
    # veins are oblique to their fold lines, see `ring_directions`, so the distance along a vein is longer
    along = fan.pitch * layers / math.cos(fan.sector_angle / 2 - apart)
    vertices = vertices + along * _on_circle(1.0, azimuths + apart)
    if fold == 0:
        return vertices
    along = (fan.gusset_height + 2 * fan.pitch * layers) / math.cos(fan.sector_angle / 2 + apart)
    return vertices + along * _on_circle(1.0, azimuths - apart)


def _beyond_ring(fan: EarwigFan) -> Array:
    """Return the directions of veins beyond the ring fold, rad, (2 n + 1,).

    The distal vein deviates from the line of the proximal one by the difference of the two sectors between the latter
    and the ring creases (Kawasaki 1989). With equal veins the angle between the vein and the radius is epsilon before
    and after the ring vertex, on opposite sides of the radius.
    """
    veins = _veins(fan)
    further = np.diff(veins.sectors) / 2 - veins.tilts[:-1] - veins.tilts[1:]
    return np.asarray(veins.azimuths[1:-1] - _side(fan) * veins.epsilon[1:-1] + further)


def ring_directions(fan: EarwigFan) -> Array:
    """Return the fold axes of the veins at their ring folds, from a ring vertex to the next of the continued pattern.

    With two ring folds these are the axes of the same fan with one: a layer folds about lines that are parallel to
    those of its neighbours, and it is one pitch further out than the previous layer only at the end of that layer.

    Returns:
        Unit vectors, shape (2 n + 1, 3).
    """
    flat = replace(fan, ring_folds=1, pitch=0.0, gusset_height=0.0)
    creases = np.diff(ring_vertices(flat, continued=True), axis=0)
    return np.array([crease / np.linalg.norm(crease) for crease in creases])


def tips(fan: EarwigFan) -> Array:
    """Compute the outer ends of the distal veins.

    Returns:
        Positions, m, shape (2 n + 1, 3), counterclockwise, z = 0.
    """
    lengths = np.array(fan.distal_lengths)
    return ring_vertices(fan, fold=fan.ring_folds - 1) + _on_circle(lengths, _beyond_ring(fan))


def vein_gaps(fan: EarwigFan, shares: Array) -> Array:
    """Compute the distance of the axis of a proximal vein from that of its neighbour.

    Args:
        fan: dimensions of the fan; with two ring folds the first two veins count, otherwise the closest two.
        shares: positions along the vein, 0 at the hub and 1 at the ring fold, shape (M,).

    Returns:
        Distance to the nearest point of the neighbouring proximal vein, m, shape (M,).
    """
    hub, ring = hub_points(fan), ring_vertices(fan)
    lengths, gaps = fan.proximal_lengths, []
    first = range(fan.vein_count - 1 if fan.varied else 1)
    for vein, neighbour in [pair for low in first for pair in ((low, low + 1), (low + 1, low))]:
        points = hub[vein] + np.outer(shares, ring[vein] - hub[vein])
        length = float(np.linalg.norm(ring[neighbour] - hub[neighbour])) if fan.pitch else lengths[neighbour]
        along = (ring[neighbour] - hub[neighbour]) / length
        nearest = np.clip((points - hub[neighbour]) @ along, 0, length)
        gaps.append(np.linalg.norm(points - hub[neighbour] - np.outer(nearest, along), axis=1))
    return np.asarray(np.min(gaps, axis=0))


def _senses(fan: EarwigFan) -> tuple[Indices, Indices]:
    """Return the senses of the veins (2 n + 1,) and of the ring creases (2 n,), +1 valley and -1 mountain.

    Neighbouring veins fold in opposite senses. The smallest sector of a ring vertex lies between the proximal crease
    and the ring crease on the vein's tangent side, and the two need opposite senses (big-little-big lemma).
    """
    veins = np.where(np.arange(fan.vein_count) % 2 == 1, 1, -1).astype(np.int64)
    ring = veins[:-1] if fan.tangent == "right" else veins[1:]
    return veins, ring.copy()


def vein_roles(ring_folds: int) -> tuple[str, ...]:
    """Return the names of the segments of a vein, from the hub outwards, for a number of ring folds."""
    return ("proximal", *["gusset"] * (ring_folds - 1), "distal")


def earwig_pattern(fan: EarwigFan) -> CreasePattern:
    """Draw the crease pattern of a fan.

    Vertices: hub points, ring vertices of every ring fold, tips, counterclockwise in every group; with hub radius 0 the
    hub points are one vertex. Edges, by role: "proximal", "gusset" between two ring folds, and "distal" for every vein,
    then "ring", "hub" and "outer" for every panel; there are no "hub" edges with hub radius 0. The outermost veins
    are borders with the roles of veins. Faces: proximal panels, panels between two ring folds, then distal ones.

    Interior veins with odd k are valleys along their whole length, those with even k mountains; ring crease k, from
    ring vertex k to k + 1, has the sense of vein k where the tangent is right and of vein k + 1 where it is left.

    Returns:
        The pattern, flat in z = 0, with the fold angles of the folded fan: 180 deg on valleys, -180 deg on mountains,
        half of it on either of two ring folds, nan on borders.
    """
    count = fan.vein_count
    pointed = fan.hub_radius < _POINT * fan.proximal_length
    hub = [0] * count if pointed else list(range(count))
    # from the hub outwards
    lines = [hub]
    for _ in range(fan.ring_folds + 1):
        lines.append([max(lines[-1]) + 1 + vein for vein in range(count)])
    veins, panels = range(count), range(count - 1)

    vein_senses, ring_senses = _senses(fan)
    vein_senses[[0, -1]] = 0  # the outermost veins are the rim of the sheet and do not fold
    none = [0] * (count - 1)
    groups: list[tuple[str, list[tuple[int, int]], list[int]]] = [
        *(
            (role, [(near[k], far[k]) for k in veins], vein_senses.tolist())
            for role, (near, far) in zip(vein_roles(fan.ring_folds), pairwise(lines), strict=True)
        ),
        *(("ring", [(ring[k], ring[k + 1]) for k in panels], ring_senses.tolist()) for ring in lines[1:-1]),
        ("hub", [] if pointed else [(hub[k], hub[k + 1]) for k in panels], [] if pointed else none),
        ("outer", [(lines[-1][k], lines[-1][k + 1]) for k in panels], none),
    ]
    edges_role = [role for role, edges, _ in groups for _ in edges]
    senses = np.array([sense for *_, group in groups for sense in group])
    shared = np.where(np.array(edges_role) == "ring", fan.ring_folds, 1)
    points = np.zeros((1, 3)) if pointed else hub_points(fan)
    proximal_faces = [(hub[k], lines[1][k], lines[1][k + 1]) + (() if pointed else (hub[k + 1],)) for k in panels]
    return CreasePattern(
        title=f"earwig fan, {fan.units} unit{'s' if fan.units > 1 else ''}, {count} veins"
        + (", two ring folds" if fan.ring_folds > 1 else "")
        + (" that differ" if fan.varied else ""),
        vertices_coords=np.concatenate(
            [points, *(ring_vertices(fan, fold=fold) for fold in range(fan.ring_folds)), tips(fan)]
        ),
        edges_vertices=np.array([ends for _, edges, _ in groups for ends in edges]),
        edges_assignment=tuple({1: "V", -1: "M", 0: "B"}[sense] for sense in senses.tolist()),
        edges_fold_angle=np.where(senses == 0, np.nan, senses * math.pi / shared),
        edges_role=tuple(edges_role),
        faces_vertices=tuple(proximal_faces)
        + tuple((near[k], far[k], far[k + 1], near[k + 1]) for near, far in pairwise(lines[1:]) for k in panels),
    )
