"""The earwig's fan: radial veins that leave a hub as tangents, and a ring fold across them, or two for thick sheets."""

from __future__ import annotations

import math
import numbers
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Literal, get_args

import numpy as np

from forficula.arrays import Array, Indices
from forficula.errors import InputError
from forficula.pattern.crease_pattern import CreasePattern

Tangent = Literal["left", "right"]
_POINT = 1e-15  # share of the proximal length; a smaller hub is lost in the rounding of the coordinates


@dataclass(frozen=True, kw_only=True)
class EarwigFan:
    """The few numbers that fix a fan; with one ring fold it is flat-foldable by construction.

    A simplification of the hindwing pattern of Saito et al. 2020, doi 10.1073/pnas.2005769117. Every proximal vein
    leaves the hub circle as a tangent; at the ring fold it turns by twice epsilon, so that the line of the distal vein
    touches the hub on its other side.

    A sheet with a thickness stacks at a pitch. A stack cannot fold about one line, for its outer layers would have to
    go round the inner ones. With two ring folds of 90 deg each and a short gusset between them every layer goes its own
    way round: k layers lie inside vein k, counted from the vein on whose side the distal stack comes to lie (the first
    one, with the tangent on the right), so its first ring fold is k pitches further out, and its gusset stands 2 k
    pitches higher. The folded layers lie j pitches above the outermost one, 2 n proximal ones, then, beyond the
    lowest gusset, 2 n distal ones. From vein to vein the ring folds tilt, by about atan(pitch / chord) and
    atan(3 pitch / chord), so their vertices are off Kawasaki and such a fan does not fold flat as paper does: every
    vein folds along the crease without that tilt, see `ring_directions`, and its membrane gives way.

    Attributes:
        proximal_length: from the hub to the ring fold along a vein, m.
        distal_length: from the ring fold to the tip along a vein, m.
        hub_radius: of the circle that the lines of the veins touch, m; 0 lets all veins meet in a point.
        sector_angle: between neighbouring veins, rad.
        units: fan units of two panels each; n of them have 2 n + 1 veins.
        tangent: where the proximal veins pass the centre of the hub, seen along the vein outwards.
        ring_folds: 1, or 2 for a thick sheet.
        pitch: from one folded layer to the next, m; 0 with one ring fold.
        gusset_height: between the folded bars of the innermost vein, m; 0 with one ring fold.
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
        _check_ring_folds(self)

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


def _check_ring_folds(fan: EarwigFan) -> None:
    """Refuse other numbers of ring folds, sizes that do not go with them, and panels that fold over themselves flat."""
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
    lines = [hub_points(fan), *(ring_vertices(fan, fold=fold) for fold in range(2)), tips(fan)]
    for line, (inner, outer) in enumerate(pairwise(lines)):
        corners = np.stack([inner[:-1], outer[:-1], outer[1:], inner[1:]])
        sides = np.roll(corners, -1, axis=0) - corners
        # at both outer corners, and at the inner ones but for those at the hub, where tangents lie beside its chords
        turns = np.cross(sides, np.roll(sides, -1, axis=0))[: 4 if line else 2, :, 2]
        if (turns <= 0).any():
            raise InputError(
                "pattern.pitch: the ring folds tilt so much that a panel bends inwards: need a smaller pitch, fewer"
                f" pattern.units or a larger pattern.sector_angle, got {_centimetres(fan.pitch)}"
            )


def _azimuths(fan: EarwigFan, count: int) -> Array:
    """Polar angles of the radii to the ring vertices, rad, shape (count,), the middle vein at 0."""
    return np.array([(vein - int(fan.units)) * fan.sector_angle for vein in range(count)], dtype=np.float64)


def _on_circle(radius: float, azimuths: Array) -> Array:
    """Points around the origin at z = 0, shape (count, 3)."""
    points: Array = np.zeros((len(azimuths), 3))
    points[:, 0] = radius * np.cos(azimuths)
    points[:, 1] = radius * np.sin(azimuths)
    return points


def _layers(fan: EarwigFan, count: int) -> Indices:
    """How many folded layers lie inside every vein, (count,)."""
    veins = np.arange(count, dtype=np.int64)
    return veins if fan.tangent == "right" else 2 * int(fan.units) - veins


def _side(fan: EarwigFan) -> int:
    """+1 where proximal veins pass the hub on the right, -1 on the left."""
    return 1 if fan.tangent == "right" else -1


def hub_points(fan: EarwigFan) -> Array:
    """Place the points where the proximal veins touch the hub.

    The radius to such a point is perpendicular to the tangent, so it stands 90 deg - epsilon beside the radius to the
    ring vertex.

    Returns:
        m, shape (2 n + 1, 3), counterclockwise, z = 0; the centre of the hub is the origin.
    """
    return _on_circle(fan.hub_radius, _azimuths(fan, fan.vein_count) - _side(fan) * (math.pi / 2 - fan.epsilon))


def ring_vertices(fan: EarwigFan, continued: bool = False, fold: int = 0) -> Array:
    """Place the points where the veins cross a ring fold, of a single one the middle one on +x.

    Args:
        fan: the fan.
        continued: add the next vertex of the pattern continued, which gives the last vein a ring crease to turn about.
        fold: which of the ring folds, from the hub outwards, from 0.

    Returns:
        m, shape (2 n + 1, 3) or, continued, (2 n + 2, 3), counterclockwise, z = 0.
    """
    azimuths = _azimuths(fan, fan.vein_count + continued)
    vertices = _on_circle(fan.ring_radius, azimuths)
    if fan.ring_folds == 1:
        return vertices
    layers, apart = _layers(fan, len(azimuths))[:, None], _side(fan) * fan.epsilon
    # veins are not square to what they fold about, see `ring_directions`: along them it is farther
    along = fan.pitch * layers / math.cos(fan.sector_angle / 2 - apart)
    vertices = vertices + along * _on_circle(1.0, azimuths + apart)
    if fold == 0:
        return vertices
    along = (fan.gusset_height + 2 * fan.pitch * layers) / math.cos(fan.sector_angle / 2 + apart)
    return vertices + along * _on_circle(1.0, _beyond_ring(fan, azimuths))


def _beyond_ring(fan: EarwigFan, azimuths: Array) -> Array:
    """Directions of veins beyond the ring fold, of those whose ring vertices have these polar angles, rad.

    A vein leaves its ring vertex at epsilon from the radius, on the other side than it arrives (the deflection
    2 epsilon satisfies Kawasaki 1989).
    """
    return azimuths - _side(fan) * fan.epsilon


def ring_directions(fan: EarwigFan) -> Array:
    """Along what every vein folds at its ring folds, from its ring vertex to the next one of the pattern continued.

    With two ring folds, of the fan with one: a layer folds about lines of its own that are parallel to those of the
    layers around it, and is a pitch further out than the one before only where that ends.

    Returns:
        Unit vectors, shape (2 n + 1, 3).
    """
    flat = replace(fan, ring_folds=1, pitch=0.0, gusset_height=0.0)
    creases = np.diff(ring_vertices(flat, continued=True), axis=0)
    return np.array([crease / np.linalg.norm(crease) for crease in creases])


def tips(fan: EarwigFan) -> Array:
    """Place the outer ends of the distal veins.

    Returns:
        m, shape (2 n + 1, 3), counterclockwise, z = 0.
    """
    directions = _beyond_ring(fan, _azimuths(fan, fan.vein_count))
    return ring_vertices(fan, fold=fan.ring_folds - 1) + _on_circle(fan.distal_length, directions)


def vein_gaps(fan: EarwigFan, shares: Array) -> Array:
    """Measure how far the axis of a proximal vein is from that of its neighbour.

    Args:
        fan: the fan; of neighbours that are not all alike the first two count.
        shares: where on the vein, 0 at the hub and 1 at the ring fold, shape (M,).

    Returns:
        Distance to the nearest point of the neighbouring proximal vein, m, shape (M,).
    """
    hub, ring = hub_points(fan)[:2], ring_vertices(fan)[:2]
    gaps = []
    for here, there in ((0, 1), (1, 0)):
        points = hub[here] + np.outer(shares, ring[here] - hub[here])
        length = float(np.linalg.norm(ring[there] - hub[there])) if fan.pitch else fan.proximal_length
        along = (ring[there] - hub[there]) / length
        nearest = np.clip((points - hub[there]) @ along, 0, length)
        gaps.append(np.linalg.norm(points - hub[there] - np.outer(nearest, along), axis=1))
    return np.asarray(np.minimum(*gaps))


def _senses(fan: EarwigFan) -> tuple[Indices, Indices]:
    """Senses of the veins (2 n + 1,) and of the ring creases (2 n,), +1 valley and -1 mountain.

    Neighbouring veins fold in opposite senses. The smallest sector of a ring vertex lies between the proximal crease
    and the ring crease on the vein's tangent side, and the two need opposite senses (big-little-big lemma).
    """
    veins = np.where(np.arange(fan.vein_count) % 2 == 1, 1, -1).astype(np.int64)
    ring = veins[:-1] if fan.tangent == "right" else veins[1:]
    return veins, ring.copy()


def vein_roles(ring_folds: int) -> tuple[str, ...]:
    """What the parts of a vein across so many ring folds are called, from the hub outwards."""
    return ("proximal", *["gusset"] * (ring_folds - 1), "distal")


def earwig_pattern(fan: EarwigFan) -> CreasePattern:
    """Draw the crease pattern of a fan.

    Vertices: hub points, ring vertices of every ring fold, tips, each counterclockwise; with hub radius 0 the hub
    points are one vertex. Edges, by role: "proximal", "gusset" between two ring folds, and "distal" for every vein,
    then "ring", "hub" and "outer" for every panel; there are no "hub" edges with hub radius 0. The outermost veins
    are border, their roles stay. Faces: proximal panels, those between two ring folds, then distal ones.

    Inside, veins with odd k are valleys and with even k mountains, all along; ring crease k, from ring vertex k to
    k + 1, has the sense of vein k where the tangent is right and of vein k + 1 where it is left.

    Returns:
        The pattern, flat in z = 0, with the fold angles of the folded fan: 180 deg on valleys, -180 deg on mountains,
        which two ring folds share evenly, nan on borders.
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
    vein_senses[[0, -1]] = 0  # the outermost veins are the rim of the sheet, they fold nothing
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
        + (", two ring folds" if fan.ring_folds > 1 else ""),
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
