"""The earwig's fan: radial veins that leave a hub as tangents, and a ring fold across them."""

from __future__ import annotations

import math
import numbers
from dataclasses import dataclass
from typing import Literal, get_args

import numpy as np
from numpy.typing import NDArray

from forficula.errors import InputError
from forficula.pattern.crease_pattern import CreasePattern

Tangent = Literal["left", "right"]
_POINT = 1e-15  # share of the proximal length; a smaller hub is lost in the rounding of the coordinates


@dataclass(frozen=True, kw_only=True)
class EarwigFan:
    """The few numbers that fix a fan; it is flat-foldable by construction.

    A simplification of the hindwing pattern of Saito et al. 2020, doi 10.1073/pnas.2005769117. Every proximal vein
    leaves the hub circle as a tangent; at the ring fold it turns by twice epsilon, so that the line of the distal vein
    touches the hub on its other side.

    Attributes:
        proximal_length: from the hub to the ring fold along a vein, m.
        distal_length: from the ring fold to the tip along a vein, m.
        hub_radius: of the circle that the lines of the veins touch, m; 0 lets all veins meet in a point.
        sector_angle: between neighbouring veins, rad.
        units: fan units of two panels each; n of them have 2 n + 1 veins.
        tangent: where the proximal veins pass the centre of the hub, seen along the vein outwards.
    """

    proximal_length: float
    distal_length: float
    hub_radius: float
    sector_angle: float
    units: int
    tangent: Tangent = "right"

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
        _check_fan_stays_open(self)
        _check_ring_vertices(self)

    @property
    def vein_count(self) -> int:
        """Number of veins, 2 n + 1."""
        return 2 * int(self.units) + 1

    @property
    def ring_radius(self) -> float:
        """Distance of the ring vertices from the centre of the hub, m (Pythagoras)."""
        return math.hypot(self.proximal_length, self.hub_radius)

    @property
    def epsilon(self) -> float:
        """Angle between a vein and the radius to its ring vertex, asin(hub_radius / ring_radius), rad."""
        return math.atan2(self.hub_radius, self.proximal_length)


def _centimetres(length: float) -> str:
    return f"{100 * length:.6g} cm"


def _degrees(angle: float) -> str:
    return f"{math.degrees(angle):.6g} deg"


def _check_number(key: str, value: object, factor: float, unit: str) -> None:
    """Refuse what is no finite number."""
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise InputError(f"pattern.{key}: need a number, got {value!r}")
    if not math.isfinite(value):
        raise InputError(f"pattern.{key}: need a finite number, got {factor * float(value):g} {unit}")


def _check_fan_stays_open(fan: EarwigFan) -> None:
    """Refuse a fan that closes on itself around the hub."""
    if 2 * fan.units * fan.sector_angle >= 2 * math.pi:
        most_units = math.ceil(math.pi / fan.sector_angle) - 1
        raise InputError(
            f"pattern.units: the fan closes on itself: need at most {most_units} at "
            f"{_degrees(fan.sector_angle)}, or pattern.sector_angle < "
            f"{_degrees(math.pi / fan.units)} at {fan.units}, got {fan.units} units"
        )


def _check_ring_vertices(fan: EarwigFan) -> None:
    """Refuse a hub so large that a ring crease falls onto a vein."""
    if fan.epsilon + fan.sector_angle / 2 >= math.pi / 2:
        largest = fan.proximal_length / math.tan(fan.sector_angle / 2)
        raise InputError(
            f"pattern.hub_radius: need < {_centimetres(largest)}, proximal_length / tan(sector_angle / 2), or the ring "
            f"fold meets no vein at an angle; take a smaller hub_radius or sector_angle or a longer proximal_length, "
            f"got {_centimetres(fan.hub_radius)}"
        )


def _azimuths(fan: EarwigFan, count: int) -> NDArray[np.float64]:
    """Polar angles of the radii to the ring vertices, rad, shape (count,), the middle vein at 0."""
    return np.array([(vein - int(fan.units)) * fan.sector_angle for vein in range(count)], dtype=np.float64)


def _on_circle(radius: float, azimuths: NDArray[np.float64]) -> NDArray[np.float64]:
    """Points around the origin at z = 0, shape (count, 3)."""
    points: NDArray[np.float64] = np.zeros((len(azimuths), 3))
    points[:, 0] = radius * np.cos(azimuths)
    points[:, 1] = radius * np.sin(azimuths)
    return points


def _side(fan: EarwigFan) -> int:
    """+1 where proximal veins pass the hub on the right, -1 on the left."""
    return 1 if fan.tangent == "right" else -1


def hub_points(fan: EarwigFan) -> NDArray[np.float64]:
    """Place the points where the proximal veins touch the hub.

    The radius to such a point is perpendicular to the tangent, so it stands 90 deg - epsilon beside the radius to the
    ring vertex.

    Returns:
        m, shape (2 n + 1, 3), counterclockwise, z = 0; the centre of the hub is the origin.
    """
    return _on_circle(fan.hub_radius, _azimuths(fan, fan.vein_count) - _side(fan) * (math.pi / 2 - fan.epsilon))


def ring_vertices(fan: EarwigFan, continued: bool = False) -> NDArray[np.float64]:
    """Place the points where the veins cross the ring fold, the middle one on +x.

    Args:
        fan: the fan.
        continued: add the next vertex of the pattern continued, which gives the last vein a ring crease to turn about.

    Returns:
        m, shape (2 n + 1, 3) or, continued, (2 n + 2, 3), counterclockwise, z = 0.
    """
    return _on_circle(fan.ring_radius, _azimuths(fan, fan.vein_count + continued))


def tips(fan: EarwigFan) -> NDArray[np.float64]:
    """Place the outer ends of the distal veins.

    The distal vein leaves the ring vertex at epsilon from the radius, on the other side than the proximal vein
    arrives (the deflection 2 epsilon satisfies Kawasaki 1989).

    Returns:
        m, shape (2 n + 1, 3), counterclockwise, z = 0.
    """
    directions = _azimuths(fan, fan.vein_count) - _side(fan) * fan.epsilon
    return ring_vertices(fan) + _on_circle(fan.distal_length, directions)


def vein_gaps(fan: EarwigFan, shares: NDArray[np.float64]) -> NDArray[np.float64]:
    """Measure how far the axis of a proximal vein is from that of its neighbour.

    Args:
        fan: the fan; all neighbours are alike.
        shares: where on the vein, 0 at the hub and 1 at the ring fold, shape (M,).

    Returns:
        Distance to the nearest point of the neighbouring proximal vein, m, shape (M,).
    """
    hub, ring = hub_points(fan)[:2], ring_vertices(fan)[:2]
    gaps = []
    for here, there in ((0, 1), (1, 0)):
        points = hub[here] + np.outer(shares, ring[here] - hub[here])
        along = (ring[there] - hub[there]) / fan.proximal_length
        nearest = np.clip((points - hub[there]) @ along, 0, fan.proximal_length)
        gaps.append(np.linalg.norm(points - hub[there] - np.outer(nearest, along), axis=1))
    return np.asarray(np.minimum(*gaps))


def _senses(fan: EarwigFan) -> tuple[NDArray[np.int64], NDArray[np.int64]]:
    """Senses of the veins (2 n + 1,) and of the ring creases (2 n,), +1 valley and -1 mountain.

    Neighbouring veins fold in opposite senses. The smallest sector of a ring vertex lies between the proximal crease
    and the ring crease on the vein's tangent side, and the two need opposite senses (big-little-big lemma).
    """
    veins = np.where(np.arange(fan.vein_count) % 2 == 1, 1, -1).astype(np.int64)
    ring = veins[:-1] if fan.tangent == "right" else veins[1:]
    return veins, ring.copy()


def earwig_pattern(fan: EarwigFan) -> CreasePattern:
    """Draw the crease pattern of a fan.

    Vertices: hub points, ring vertices, tips, each counterclockwise; with hub radius 0 the hub points are one vertex.
    Edges, by role: "proximal" and "distal" for every vein, then "ring", "hub" and "outer" for every panel; there are no
    "hub" edges with hub radius 0. The outermost veins are border, their roles stay. Faces: proximal panels, then distal
    ones.

    Inside, veins with odd k are valleys and with even k mountains, proximal and distal alike; ring crease k, from ring
    vertex k to k + 1, has the sense of vein k where the tangent is right and of vein k + 1 where it is left.

    Returns:
        The pattern, flat in z = 0, with the fold angles of the flat-folded fan: 180 deg on valleys, -180 deg on
        mountains, nan on borders.
    """
    count = fan.vein_count
    pointed = fan.hub_radius < _POINT * fan.proximal_length
    hub = [0] * count if pointed else list(range(count))
    ring = [max(hub) + 1 + vein for vein in range(count)]
    tip = [max(ring) + 1 + vein for vein in range(count)]
    veins, panels = range(count), range(count - 1)

    vein_senses, ring_senses = _senses(fan)
    vein_senses[[0, -1]] = 0  # the outermost veins are the rim of the sheet, they fold nothing
    none = [0] * (count - 1)
    groups = {
        "proximal": ([(hub[k], ring[k]) for k in veins], vein_senses.tolist()),
        "distal": ([(ring[k], tip[k]) for k in veins], vein_senses.tolist()),
        "ring": ([(ring[k], ring[k + 1]) for k in panels], ring_senses.tolist()),
        "hub": ([] if pointed else [(hub[k], hub[k + 1]) for k in panels], [] if pointed else none),
        "outer": ([(tip[k], tip[k + 1]) for k in panels], none),
    }
    senses = np.array([sense for _, group in groups.values() for sense in group])
    points = np.zeros((1, 3)) if pointed else hub_points(fan)
    proximal_faces = [(hub[k], ring[k], ring[k + 1]) + (() if pointed else (hub[k + 1],)) for k in panels]
    return CreasePattern(
        title=f"earwig fan, {fan.units} unit{'s' if fan.units > 1 else ''}, {count} veins",
        vertices_coords=np.concatenate([points, ring_vertices(fan), tips(fan)]),
        edges_vertices=np.array([ends for edges, _ in groups.values() for ends in edges]),
        edges_assignment=tuple({1: "V", -1: "M", 0: "B"}[sense] for sense in senses.tolist()),
        edges_fold_angle=np.where(senses == 0, np.nan, senses * math.pi),
        edges_role=tuple(role for role, (edges, _) in groups.items() for _ in edges),
        faces_vertices=tuple(proximal_faces) + tuple((ring[k], tip[k], tip[k + 1], ring[k + 1]) for k in panels),
    )
