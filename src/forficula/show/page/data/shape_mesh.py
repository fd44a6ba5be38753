"""A structure as a 3-D mesh: few points that move, and the surfaces and lines between them."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics import Record
from forficula.show.structure.shape import Shape, ShapeLine, shape_of
from forficula.structure import GROUND, Structure, built_frames, built_points

# as shares of the diameter of the thickest bar: radius of a crease's line, of a rim, of the edge of a plate, of a
# tendon, of a joint; length of a dash
# length of a dash
_CREASE, _RIM, _EDGE, _TENDON, _JOINT, _DASH = 0.16, 0.06, 0.1, 0.32, 0.68, 0.9
_THINNEST = 0.004  # least width of a line, as a share of the span
_FINEST = 20  # largest number of dash lengths along a crease
# dashes of a crease and the gaps after them, in lengths of a dash: dash-dotted mountains, dashed valleys
_STROKES = {"M": ((2.4, 0.6), (0.5, 0.6)), "V": ((1.2, 0.9),), "B": ((1e9, 0.0),)}
_DIGITS = 6  # decimals of a share
_BASE = 0.8  # radius of a rod along fixed parts, as a share of the diameter of the thickest bar
_SAME = 1e-6  # points closer than this share of the span count as one
_STUB = 0.04  # length of a rod at a single point, as a share of the span


@dataclass(frozen=True, kw_only=True)
class Tube:
    """Straight round bar between two vertices.

    Attributes:
        kind: "bar", "crease", "rim", "edge" or "tendon".
        crease: "M" mountain, "V" valley or "B" border; "B" for a tendon.
        ends: two vertices.
        radius: m.
        region: region whose hue a bar has, which is a group of bodies; None for others.
    """

    kind: str
    crease: str
    ends: tuple[int, int]
    radius: float
    region: int | None = None


@dataclass(frozen=True, kw_only=True)
class ShapeMesh:
    """Mesh of a structure; each vertex lies between two moving points.

    Attributes:
        anchors: indices of the moving points: points of the structure and then nodes of its membranes.
        between: the two points of each vertex, indices into `anchors`, (vertex, 2).
        share: position between the first (0) and the second point (1), (vertex,).
        triangles: three vertices each, counterclockwise seen from above the built shape, (triangle, 3).
        regions: region of each triangle, (triangle,).
        names: names of the regions, such as "distal panel".
        solid: whether the region consists of plates and not of a sheet, (region,).
        tubes: bars, creases, rims of sheets, edges of plates, and last the tendons in the structure's order.
        joints: vertices of hinges at the ends of bars, and of fixed points, (joint,).
        held: whether there are fixed points.
        joint_radius: radius of a joint, m.
        built: positions of `anchors` in the built shape, m, (point, 3).
        faces: face of each triangle, (triangle,).
        base: ends of rods along fixed parts, m, (rod, end, axis).
        base_radius: radius of these rods, m.
    """

    anchors: Indices
    between: Indices
    share: Array
    triangles: Indices
    regions: Indices
    names: tuple[str, ...]
    solid: tuple[bool, ...]
    tubes: tuple[Tube, ...]
    joints: Indices
    held: bool
    joint_radius: float
    built: Array
    faces: Indices
    base: Array
    base_radius: float


def shape_mesh(structure: Structure) -> ShapeMesh:
    """Return the mesh of a structure."""
    shape = shape_of(structure)
    between, share = shape.between.tolist(), shape.share.tolist()
    pieces = [
        ((face[0], one, other), region, number)
        for number, (face, region) in enumerate(zip(shape.faces, shape.face_region.tolist(), strict=True))
        for one, other in pairwise(face[1:])
    ]
    tubes = [
        Tube(kind="bar", crease=bar.crease, ends=bar.ends, radius=bar.radius, region=bar.region) for bar in shape.bars
    ]
    for line in shape.lines:
        if line.kind == "crease":
            ends = _dashes(shape, line, between, share)
            tubes += (Tube(kind="crease", crease=line.crease, ends=dash, radius=_thin(shape, _CREASE)) for dash in ends)
        else:
            radius = _thin(shape, _RIM if line.kind == "rim" else _EDGE)
            tubes += (Tube(kind=line.kind, crease="B", ends=ends, radius=radius) for ends in pairwise(line.path))
    tubes += (Tube(kind="tendon", crease="B", ends=ends, radius=_thin(shape, _TENDON)) for ends in shape.tendons)
    return ShapeMesh(
        anchors=shape.anchors,
        between=np.array(between, dtype=np.int64).reshape(-1, 2),
        share=np.array(share),
        triangles=np.array([piece for piece, _, _ in pieces], dtype=np.int64).reshape(-1, 3),
        regions=np.array([region for _, region, _ in pieces], dtype=np.int64),
        names=shape.regions,
        solid=shape.solid,
        tubes=tuple(tubes),
        joints=np.concatenate([shape.joints, shape.held]),
        held=len(shape.held) > 0,
        joint_radius=_JOINT * shape.thickness,
        built=_built(structure)[shape.anchors],
        faces=np.array([number for _, _, number in pieces], dtype=np.int64),
        base=fixed_rods(structure),
        base_radius=max(_BASE * shape.thickness, _THINNEST * shape.span),
    )


def _built(structure: Structure) -> Array:
    """Return the points, then the nodes of membranes, in the built shape, m, (point, 3)."""
    return np.concatenate([built_points(structure), *(membrane.built for membrane in structure.membranes)])


def moving_points(record: Record, mesh: ShapeMesh) -> Array:
    """Return the positions of a mesh's points, m, (time, point, 3)."""
    points, nodes = record.series["point_position"], record.series["membrane_position"]
    count = points.shape[1]
    of_points, of_nodes = mesh.anchors[mesh.anchors < count], mesh.anchors[mesh.anchors >= count] - count
    return np.concatenate([points[:, of_points], nodes[:, of_nodes]], axis=1)


def _thin(shape: Shape, share: float) -> float:
    """Return the radius of a line, as a share of the bars' diameter but wide enough to be visible, m."""
    return max(share * shape.thickness, share * _THINNEST * shape.span)


def _dashes(shape: Shape, line: ShapeLine, between: list[list[int]], share: list[float]) -> list[tuple[int, int]]:
    """Return the ends of the dashes along a crease, in the built shape; ends within a piece become new vertices."""
    lengths = [float(np.linalg.norm(shape.built[end] - shape.built[start])) for start, end in pairwise(line.path)]
    corners = [0.0, *np.cumsum(lengths).tolist()]
    width = corners[-1]
    # limits the number of dashes
    unit = max(_DASH * shape.thickness, width / _FINEST)
    dashes = []
    start, stroke = 0.0, 0
    while start < width:
        dash, gap = (unit * part for part in _STROKES[line.crease][stroke % len(_STROKES[line.crease])])
        end = min(start + dash, width)
        for (one, other), (low, high) in zip(pairwise(line.path), pairwise(corners), strict=True):
            first, last = max(start, low), min(end, high)
            if first < last:
                places = [round((place - low) / (high - low), _DIGITS) for place in (first, last)]
                dashes.append(_dash(between, share, (one, other), places))
        start, stroke = end + gap, stroke + 1
    return dashes


def _dash(between: list[list[int]], share: list[float], piece: tuple[int, int], places: list[float]) -> tuple[int, int]:
    """Return two vertices at given shares along a straight piece; its ends if they are not points of the structure."""
    if any(share[end] for end in piece):
        return piece
    ends = []
    for place in places:
        if place in (0.0, 1.0):
            ends.append(piece[int(place)])
            continue
        between.append([between[piece[0]][0], between[piece[1]][0]])
        share.append(place)
        ends.append(len(share) - 1)
    return ends[0], ends[1]


def fixed_rods(structure: Structure) -> Array:
    """Return rods along the joints at which a structure is fixed to the ground, and around plates that cannot move.

    Joints are connected in the order of their bodies, as veins are arranged around a hub; a single one gets a short
    rod.

    Returns:
        Ends, m, (rod, end, axis). Empty if nothing is fixed by a joint and no plate is fixed, as for a sheet between
        nodes.
    """
    origins, _ = built_frames(structure)
    hinged = {hinge.body for hinge in structure.hinges if hinge.flaps is None}
    grounded = [number for number, body in enumerate(structure.bodies) if body.parent == GROUND and not body.slides]
    points = built_points(structure)
    rods = [
        (points[one], points[other])
        for plate in structure.plates
        if plate.body in grounded and plate.body not in hinged
        for one, other in pairwise([*plate.points, plate.points[0]])
    ]
    pivots: list[Array] = []
    for number in grounded:
        place = origins[number]
        if number in hinged and all(np.linalg.norm(place - other) > _SAME * structure.span for other in pivots):
            pivots.append(place)
    if len(pivots) == 1:
        aside = np.array([0.0, 0.5 * _STUB * structure.span, 0.0])
        pivots = [pivots[0] - aside, pivots[0] + aside]
    return np.array([*rods, *pairwise(pivots)]).reshape(-1, 2, 3)
