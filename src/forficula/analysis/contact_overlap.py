"""How far parts that touch overlap, computed from positions in the record and not from the contact forces.

The overlap of two parts is the touching distance of their middle surfaces minus the distance of these surfaces. The
distance of a segment from a triangle is a convex function of the position on the segment, so a search by the golden
section finds its minimum. The contact forces use closed forms instead.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated
from weakref import WeakKeyDictionary

import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics import ContactRun, Record
from forficula.pattern.geometry import polygon_normal
from forficula.quantities import show_value
from forficula.serial import Key, Metres, Seconds
from forficula.structure.contact.touching_parts import TouchingParts, touching_parts

# number of rows of a record that are examined: evenly spaced ones
_ROWS = 200
# number of steps of the golden section, which reduces an interval to 1e-6 of its length
_STEPS = 29
_GOLDEN = (math.sqrt(5) - 1) / 2
# overlaps of records in use: warnings and summary of a run need them
_KNOWN = WeakKeyDictionary["Record", "ContactOverlap | None"]()


@dataclass(frozen=True, kw_only=True)
class ContactOverlap:
    """Deepest overlap of two parts that touch in a run.

    Attributes:
        depth: overlap in the examined rows of the record, from positions, m; 0 if no parts overlap.
        share: the same as a share of the thickness.
        share_in_steps: largest overlap in any step of the run, as the contact forces compute it, as a share of the
            thickness.
        parts: names of the two parts; empty if no parts overlap.
        time: time of the row, s.
        time_constant: of contact, s.
        derived: whether the time constant was derived from overlaps in earlier runs, or left at that of the first run
            because parts overlap little; false if the design sets it.
        runs: runs by which the time constant was derived, in order; the last one is this run.
    """

    depth: Metres
    share: float
    share_in_steps: float
    parts: Annotated[tuple[str, ...], Key("parts")] = ()
    time: Seconds
    time_constant: Seconds
    derived: bool
    runs: tuple[ContactRun, ...]

    @property
    def largest(self) -> float:
        """Return the larger of both shares."""
        return max(self.share, self.share_in_steps)


def contact_overlap(record: Record) -> ContactOverlap | None:
    """Find the deepest overlap of facets, plates and bars that touch.

    Returns:
        None for a structure without such parts or without contact, a record without positions of points, and a run that
        diverged.
    """
    if record not in _KNOWN:
        _KNOWN[record] = _deepest(record)
    return _KNOWN[record]


def _deepest(record: Record) -> ContactOverlap | None:
    places, contact = record.series.get("point_position"), record.structure.contact
    if places is None or contact is None or record.diverged_at is not None:
        return None
    parts = touching_parts(record.structure, contact)
    if parts is None:
        return None
    result: tuple[float, tuple[int, ...], int] = (0.0, (), 0)
    for row in np.unique(np.linspace(0, len(places) - 1, _ROWS).astype(np.int64)).tolist():
        depth, owners = overlap_of(parts, places[row][parts.points])
        if depth > result[0]:
            result = (depth, owners, row)
    depth, owners, row = result
    return ContactOverlap(
        depth=depth,
        share=depth / float(parts.half[list(owners)].sum()) if owners else 0.0,
        share_in_steps=float(record.series["contact_overlap"][-1]),
        parts=tuple(parts.names[owner] for owner in owners),
        time=float(record.time[row]),
        time_constant=contact.stops.time_constant,
        derived=bool(record.contact_runs),
        runs=record.contact_runs,
    )


def contact_text(record: Record) -> str:
    """Return how the time constant of contact was derived; empty if the design sets it, or if no parts overlapped."""
    if all(run.overlap == 0 for run in record.contact_runs):
        return ""
    *earlier, this = record.contact_runs
    now, step = show_value(this.time_constant, "s"), show_value(this.timestep, "s")
    if this.overlap is None:
        return (
            f"contact.time_constant is {now}, the first value that a run tries, with a timestep of {step}. The engine"
            " does not report how far these parts overlap."
        )
    text = (
        f"The run derived contact.time_constant = {now} and a timestep of {step}. With these values, parts that touch"
        f" overlap by {100 * this.overlap:.3g} % of their thickness"
    )
    shares = [f"{100 * (run.overlap or 0.0):.3g} % with {show_value(run.time_constant, 's')}" for run in earlier]
    return f"{text}, and in earlier runs by {' and '.join(shares)}." if shares else f"{text}."


def overlap_of(parts: TouchingParts, places: Array) -> tuple[float, tuple[int, ...]]:
    """Return the deepest overlap of parts, m, and the numbers of the two parts; 0 and no numbers without an overlap.

    Args:
        parts: of a structure.
        places: positions of the nodes, m, (node, 3).
    """
    side, triangle = _candidates(parts, places)
    if not len(side):
        return 0.0, ()
    owners = np.column_stack([parts.side_parts[side, 0], parts.triangle_parts[triangle]])
    ends, corners = places[parts.sides[side]], places[parts.triangles[triangle]]
    # parts that meet at a vertex touch only away from this vertex
    shared = (parts.vertices[parts.sides[side]][:, :, None] == parts.vertices[parts.triangles[triangle]][:, None]).any(
        axis=2
    )
    for_nodes = [
        (parts.sides[side][:, end], parts.node_apart[parts.sides[side][:, end], owners[:, 1]]) for end in (0, 1)
    ]
    whole = ~shared.any(axis=1) & for_nodes[0][1] & for_nodes[1][1]
    thickness = parts.half[owners].sum(axis=1)
    depths = np.full(len(side), -np.inf)
    distance, through = _segment_distances(ends[whole], corners[whole])
    depths[whole] = np.where(through > 0, thickness[whole] + through, thickness[whole] - distance)
    for end, (_, apart) in enumerate(for_nodes):
        alone = apart & ~whole
        depths[alone] = np.maximum(depths[alone], thickness[alone] - _distances(ends[alone, end], corners[alone]))
    worst = int(np.argmax(depths))
    if depths[worst] <= 0:
        return 0.0, ()
    return float(depths[worst]), tuple(owners[worst].tolist())


def _candidates(parts: TouchingParts, places: Array) -> tuple[Indices, Indices]:
    """Return sides and triangles of different parts whose bounding boxes are within the touching distance."""
    ends, corners = places[parts.sides], places[parts.triangles]
    reach = 2 * float(parts.half.max(initial=0.0))
    near = np.ones((len(ends), len(corners)), dtype=bool)
    for axis in range(3):
        low, high = ends[:, :, axis].min(axis=1), ends[:, :, axis].max(axis=1)
        least, most = corners[:, :, axis].min(axis=1), corners[:, :, axis].max(axis=1)
        near &= (low[:, None] <= most[None] + reach) & (high[:, None] >= least[None] - reach)
    side, triangle = np.nonzero(near)
    apart = parts.side_apart[parts.side_parts[side], parts.triangle_parts[triangle][:, None]].all(axis=1)
    return side[apart], triangle[apart]


def _segment_distances(ends: Array, corners: Array) -> tuple[Array, Array]:
    """Return distances of segments from triangles, m, and how far those that pass through extend beyond, m, else 0."""
    low, high = np.zeros(len(ends)), np.ones(len(ends))

    def at(share: Array) -> Array:
        return _distances(ends[:, 0] + share[:, None] * (ends[:, 1] - ends[:, 0]), corners)

    one, other = high - _GOLDEN * (high - low), low + _GOLDEN * (high - low)
    at_one, at_other = at(one), at(other)
    for _ in range(_STEPS):
        before = at_one < at_other
        low, high = np.where(before, low, one), np.where(before, other, high)
        one, other = high - _GOLDEN * (high - low), low + _GOLDEN * (high - low)
        at_one, at_other = at(one), at(other)
    nearest = (low + high) / 2
    normal = polygon_normal(corners)
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), np.finfo(float).tiny)
    heights = np.einsum("sex,sx->se", ends - corners[:, :1], normal)
    least = np.minimum(at(nearest), np.minimum(at(np.zeros(len(ends))), at(np.ones(len(ends)))))
    length = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    crosses = (heights[:, 0] * heights[:, 1] < 0) & (least < 1e-5 * length)
    return least, np.where(crosses, np.abs(heights).min(axis=1), 0.0)


def _distances(points: Array, corners: Array) -> Array:
    """Return distances of points from triangles, m, by areas of the triangles between a point and the sides."""
    normal = polygon_normal(corners)
    size = np.maximum(np.linalg.norm(normal, axis=1), np.finfo(float).tiny)
    after = np.roll(corners, -1, axis=1)
    away, along = points[:, None] - corners, after - corners
    areas = np.einsum("tkx,tx->tk", np.cross(along, away), normal)
    height = np.abs(np.einsum("tx,tx->t", away[:, 0], normal)) / size
    share = np.clip(
        np.einsum("tkx,tkx->tk", away, along) / np.maximum((along**2).sum(axis=2), np.finfo(float).tiny), 0, 1
    )
    beside = np.linalg.norm(away - share[:, :, None] * along, axis=2).min(axis=1)
    return np.asarray(np.where((areas >= 0).all(axis=1), height, beside))
