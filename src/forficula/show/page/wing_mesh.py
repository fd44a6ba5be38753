"""How a wing is drawn in 3-D: few points that move, and everything drawn between them."""

from __future__ import annotations

from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from forficula.design import Design
from forficula.dynamics import Record
from forficula.pattern import earwig_pattern

Array = NDArray[np.float64]

PROXIMAL, DISTAL = 0, 1

# by diameter of the veins: radius of a crease's line, of the sheet's rim, of a tendon, of a joint, length of a dash
_CREASE, _RIM, _TENDON, _JOINT, _DASH = 0.16, 0.06, 0.32, 0.68, 0.9
_THINNEST = 0.004  # by length of the wing: a line that can still be seen
# dashes of a crease and the gaps after them, in lengths of a dash: dash-dotted mountains, dashed valleys
_STROKES = {"M": ((2.4, 0.6), (0.5, 0.6)), "V": ((1.2, 0.9),), "B": ((1e9, 0.0),)}


@dataclass(frozen=True, kw_only=True)
class Tube:
    """A straight round bar between two vertices.

    Attributes:
        kind: "vein", "ring", "rim" or "tendon".
        crease: "M" mountain, "V" valley or "B" border; of a tendon, that of its vein.
        vein: whose it is; of a ring crease, the vein that its panel is glued to.
        ends: two vertices.
        radius: m.
    """

    kind: str
    crease: str
    vein: int
    ends: tuple[int, int]
    radius: float


@dataclass(frozen=True, kw_only=True)
class WingMesh:
    """What is drawn, by vertices that each lie between two moving points.

    Attributes:
        points: how many points move: hub end, ring vertex and tip of every vein, then the edge of every panel's margin.
        between: the two points of each vertex, (vertex, 2).
        share: how far it is from the first to the second, 0 to 1, (vertex,).
        triangles: three vertices each, counterclockwise seen from above the flat wing, (triangle, 3).
        regions: `PROXIMAL` or `DISTAL`, (triangle,).
        tubes: veins, creases, the rim of the sheet, tendons.
        joints: vertices of the proximal joints, then of the distal hinges, (joint,).
        joint_radius: m.
    """

    points: int
    between: NDArray[np.int64]
    share: Array
    triangles: NDArray[np.int64]
    regions: NDArray[np.int64]
    tubes: tuple[Tube, ...]
    joints: NDArray[np.int64]
    joint_radius: float


@dataclass
class _Vertices:
    """Vertices collected so far, each once."""

    numbers: dict[tuple[int, int, float], int] = field(default_factory=dict)

    def at(self, first: int, second: int, share: float) -> int:
        place = (first, first, 0.0) if share == 0 else (second, second, 0.0) if share == 1 else (first, second, share)
        return self.numbers.setdefault(place, len(self.numbers))


def wing_mesh(design: Design) -> WingMesh:
    """Lay out what is drawn of a design's wing."""
    vertices = _Vertices()
    count, rows = design.fan.vein_count, _rows(design)
    quads: list[tuple[int, int, int, int]] = []
    regions: list[int] = []
    for panel in range(count - 1):
        near, edge, far = _columns(vertices, design, panel)
        for row, (below, above) in enumerate(pairwise(range(rows))):
            # the strip between vein and margin is wing, too
            for left, right in ((near, edge), (edge, far)):
                quads.append((left[below], left[above], right[above], right[below]))
                regions.append(PROXIMAL if row < len(design.membrane.proximal_rows) else DISTAL)
    tubes = (*_veins(vertices, design), *_sheet_lines(vertices, design), *_tendons(vertices, design))
    joints = [vertices.at(3 * vein + point, 3 * vein + point, 0.0) for point in (0, 1) for vein in range(count)]
    places = list(vertices.numbers)
    return WingMesh(
        points=3 * count + (count - 1) * rows,
        between=np.array([place[:2] for place in places], dtype=np.int64),
        share=np.array([place[2] for place in places]),
        triangles=np.array([[a, b, c] for a, b, c, d in quads for b, c in ((b, c), (c, d))], dtype=np.int64),
        regions=np.repeat(regions, 2),
        tubes=tubes,
        joints=np.array(joints, dtype=np.int64),
        joint_radius=_JOINT * design.vein.diameter,
    )


def moving_points(record: Record) -> Array:
    """Where the points of a wing's mesh are, m, (time, point, 3)."""
    veins, nodes = record.series["vein_position"], record.series["membrane_position"]
    frames, count = veins.shape[:2]
    # of two nodes a row the second one lies on the next vein
    edges = nodes.reshape(frames, count - 1, _rows(record.design), 2, 3)[..., 0, :]
    return np.concatenate([veins.reshape(frames, -1, 3), edges.reshape(frames, -1, 3)], axis=1)


def _rows(design: Design) -> int:
    return len(design.membrane.proximal_rows) + len(design.membrane.distal_rows) + 2


def _on_vein(vertices: _Vertices, design: Design, vein: int) -> list[int]:
    """Vertices on a vein at the rows of the membrane."""
    hub, ring, tip = (3 * vein + point for point in range(3))
    return [
        *(vertices.at(hub, ring, share) for share in (*design.membrane.proximal_rows, 1.0)),
        *(vertices.at(ring, tip, share) for share in (*design.membrane.distal_rows, 1.0)),
    ]


def _columns(vertices: _Vertices, design: Design, panel: int) -> tuple[list[int], list[int], list[int]]:
    """Vertices of a panel by row: on its own vein, on the edge of its margin, on the next vein."""
    first = 3 * design.fan.vein_count + panel * _rows(design)
    edge = [vertices.at(first + row, first + row, 0.0) for row in range(_rows(design))]
    return _on_vein(vertices, design, panel), edge, _on_vein(vertices, design, panel + 1)


def _creases(design: Design, role: str) -> list[str]:
    pattern = earwig_pattern(design.fan)
    return [letter for letter, known in zip(pattern.edges_assignment, pattern.edges_role, strict=True) if known == role]


def _thin(design: Design, share: float) -> float:
    """Radius of a line by diameter of the veins, m, but one that can be seen."""
    length = design.pattern.proximal_length + design.pattern.distal_length
    return max(share * design.vein.diameter, share * _THINNEST * length)


def _veins(vertices: _Vertices, design: Design) -> list[Tube]:
    tubes: list[Tube] = []
    radius = design.vein.diameter / 2
    for vein, crease in enumerate(_creases(design, "proximal")):
        points = [vertices.at(3 * vein + point, 3 * vein + point, 0.0) for point in range(3)]
        tubes += (Tube(kind="vein", crease=crease, vein=vein, ends=ends, radius=radius) for ends in pairwise(points))
    return tubes


def _sheet_lines(vertices: _Vertices, design: Design) -> list[Tube]:
    """The ring fold in dashes, and the inner and the outer rim of the sheet."""
    tubes: list[Tube] = []
    rows = _rows(design)
    for panel, crease in enumerate(_creases(design, "ring")):
        columns = _columns(vertices, design, panel)
        rims = [ends for row in (0, rows - 1) for ends in pairwise(column[row] for column in columns)]
        tubes += (Tube(kind="rim", crease="B", vein=panel, ends=ends, radius=_thin(design, _RIM)) for ends in rims)
        edge = 3 * design.fan.vein_count + panel * rows + len(design.membrane.proximal_rows)
        dashes = _dashes(vertices, design, (3 * panel + 1, edge, 3 * panel + 4), crease)
        radius = _thin(design, _CREASE)
        tubes += (Tube(kind="ring", crease=crease, vein=panel, ends=ends, radius=radius) for ends in dashes)
    return tubes


def _dashes(vertices: _Vertices, design: Design, points: tuple[int, int, int], crease: str) -> list[tuple[int, int]]:
    """Ends of the dashes along two straight pieces, as long as in the flat wing."""
    width = 2 * design.fan.ring_radius * np.sin(design.fan.sector_angle / 2)
    margin = min(design.membrane.margin, design.membrane.margin_limit * width)
    # not so fine that there are very many
    unit = max(_DASH * design.vein.diameter, width / 20)
    corners = [0.0, margin, width]
    dashes = []
    start, stroke = 0.0, 0
    while start < width:
        dash, gap = (unit * part for part in _STROKES[crease][stroke % len(_STROKES[crease])])
        end = min(start + dash, width)
        for piece, (low, high) in enumerate(pairwise(corners)):
            if max(start, low) < min(end, high):
                shares = ((max(start, low) - low) / (high - low), (min(end, high) - low) / (high - low))
                first, second = (vertices.at(points[piece], points[piece + 1], round(share, 6)) for share in shares)
                dashes.append((first, second))
        start, stroke = end + gap, stroke + 1
    return dashes


def _tendons(vertices: _Vertices, design: Design) -> list[Tube]:
    tendon, pattern = design.tendon, design.pattern
    tubes = []
    for vein, crease in enumerate(_creases(design, "proximal")):
        hub, ring, tip = (3 * vein + point for point in range(3))
        before = vertices.at(ring, hub, tendon.proximal_attachment / pattern.proximal_length)
        beyond = vertices.at(ring, tip, tendon.distal_attachment / pattern.distal_length)
        radius = _thin(design, _TENDON)
        tubes.append(Tube(kind="tendon", crease=crease, vein=vein, ends=(before, beyond), radius=radius))
    return tubes
