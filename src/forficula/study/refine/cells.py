"""Locate boundaries between regions: cells whose boundaries are known, and the points that are needed next.

Everything is a function of the labels that are known. The same labels always need the same points, so an interrupted
refinement continues with the same points.
"""

from __future__ import annotations

import itertools
import math
from bisect import bisect_left, bisect_right, insort
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.study.refine.boundary_plan import BoundaryPlan, Position
from forficula.study.refine.planes import (
    BoundaryCrossing,
    BoundaryPlane,
    fitted_plane,
    labels_between,
    separating_planes,
)

# [chosen] a margin at one end of an edge is close to 0 below this share of the margin at the other end
_NEAR_ZERO = 0.25


@dataclass(frozen=True, kw_only=True)
class RegionCell:
    """A box between two positions.

    Attributes:
        low: its corner with the lowest places.
        high: its corner with the highest places.
        corners: labels of its corners, in the order of `itertools.product` over the axes. A corner without a point has
            the label of its neighbours on the edge that contains the corner.
        labels: all labels in the cell.
        surfaces: approximations of the boundaries, from low to high along their axis; none if the cell has one label,
            or if its sides are single steps.
        crossings: boundaries on its edges.
        located: whether its boundaries are known.
    """

    low: Position
    high: Position
    corners: tuple[str, ...]
    labels: tuple[str, ...]
    surfaces: tuple[BoundaryPlane, ...] = ()
    crossings: tuple[BoundaryCrossing, ...] = ()
    located: bool = True


@dataclass(frozen=True, kw_only=True)
class LocatedBoundaries:
    """Result of one round.

    Attributes:
        wanted: positions of the points that are needed next; none if all boundaries are known.
        cells: cells that together fill the ranges of all factors.
    """

    wanted: tuple[Position, ...]
    cells: tuple[RegionCell, ...]


def locate(
    plan: BoundaryPlan, labels: Mapping[Position, str], margins: Mapping[Position, Sequence[float]] | None = None
) -> LocatedBoundaries:
    """Find the points that are needed to locate all boundaries, as far as the known labels show.

    1. Every edge of a cell whose ends differ is halved until the boundary on the edge lies between two neighbouring
       positions. Where both ends have margins of opposite signs, the first halving is a secant step.
    2. A cell with two labels and at most one boundary on each edge is approximated by a plane through these boundaries.
       A cell that bands cross, with the same labels on all edges along one axis, is approximated by several planes.
       Each plane is tested at the mean of its boundaries, by two neighbouring points. It fails if the boundary is not
       between two points next to the plane, or if any point in the cell is more than a step from the plane and on its
       wrong side.
    3. A cell whose plane fails, a cell with more labels, and a cell with a point of another label inside are split.
    4. Every cell of the initial grid has points inside, whose labels reveal islands.

    Args:
        plan: axes of the study.
        labels: known labels by position.
        margins: signed margins by position, in the same order at every position; nan if unknown.
    """
    return _Locator(plan, labels, margins or {}).result()


class _Locator:
    """Known labels, and the positions that are needed next."""

    def __init__(
        self, plan: BoundaryPlan, labels: Mapping[Position, str], margins: Mapping[Position, Sequence[float]]
    ) -> None:
        self._plan, self._labels, self._margins = plan, labels, margins
        self._wanted: dict[Position, None] = {}
        self._cells: list[RegionCell] = []
        # places of known labels on every line along an axis
        self._lines: dict[tuple[int, Position], list[int]] = {}
        for position in labels:
            for axis, place in enumerate(position):
                insort(self._lines.setdefault((axis, _without(position, axis)), []), place)

    def result(self) -> LocatedBoundaries:
        """Examine all cells of the initial grid."""
        if missing := [position for position in self._plan.initial_grid if position not in self._labels]:
            return LocatedBoundaries(wanted=tuple(missing), cells=())
        known = np.array(list(self._labels))
        shares = _probe_shares(len(self._plan.axes), self._plan.probes)
        intervals = [list(itertools.pairwise(axis.grid_places)) for axis in self._plan.axes]
        for sides in itertools.product(*intervals):
            low, high = (tuple(ends) for ends in zip(*sides, strict=True))
            inside = known[((known >= low) & (known <= high)).all(axis=1)]
            for share in shares:
                probe = tuple(a + math.floor(part * (b - a)) for a, b, part in zip(low, high, share, strict=True))
                self._want(probe)
            corners = {corner: self._labels[corner] for corner in itertools.product(*sides)}
            self._examine(low, high, corners, [tuple(position) for position in inside.tolist()])
        return LocatedBoundaries(wanted=tuple(self._wanted), cells=tuple(self._cells))

    def _want(self, position: Position) -> bool:
        """Note that a point is needed, unless its label is known; return whether the label is known."""
        if position in self._labels:
            return True
        self._wanted[position] = None
        return False

    def _examine(
        self, low: Position, high: Position, corners: Mapping[Position, str], inside: Sequence[Position]
    ) -> None:
        """Add a cell, or its parts, or the points that are needed before this can be decided.

        Args:
            low: lowest corner.
            high: highest corner.
            corners: labels of the corners, in the order of `itertools.product`.
            inside: positions in the cell, corners and faces included, whose labels are known.
        """
        edges = [
            self._edge(corner, axis, high[axis], corners[corner], corners[_moved(corner, axis, high[axis])])
            for axis in range(len(low))
            for corner in corners
            if corner[axis] == low[axis]
        ]
        crossings = tuple(crossing for edge in edges for crossing in edge or ())
        present = {*corners.values(), *(self._labels[position] for position in inside)}
        cell = RegionCell(
            low=low,
            high=high,
            corners=tuple(corners.values()),
            labels=tuple(sorted(present)),
            crossings=crossings,
            located=all(edge is not None for edge in edges),
        )
        surfaces: tuple[BoundaryPlane, ...] = ()
        tested: bool | None = False
        split = cell.located and len(present) > 1 and any(b - a > 1 for a, b in zip(low, high, strict=True))
        if split:
            surfaces = self._fitted([edge for edge in edges if edge], len(edges), cell, corners, inside)
            tested = bool(surfaces) and self._test(surfaces, low, high, corners)
            split = tested is False
        if split:
            if self._split(cell, corners, inside):
                return
            cell = replace(cell, located=False)
        elif cell.located:
            if tested and surfaces:
                known = dict(corners) | {position: self._labels[position] for position in inside}
                surfaces = separating_planes(surfaces, known)
            cell = replace(cell, surfaces=surfaces, located=tested is not None)
        self._cells.append(cell)

    def _edge(
        self, start: Position, axis: int, end: int, start_label: str, end_label: str
    ) -> list[BoundaryCrossing] | None:
        """Return the boundaries on an edge; None as long as more points are needed."""
        line = self._lines.get((axis, _without(start, axis)), [])
        between = line[bisect_right(line, start[axis]) : bisect_left(line, end)]
        places = [start[axis], *between, end]
        labels = [start_label, *(self._labels[_moved(start, axis, place)] for place in between), end_label]
        crossings, complete = [], True
        for index, (first, second) in enumerate(itertools.pairwise(places)):
            if labels[index] == labels[index + 1]:
                continue
            ends = _moved(start, axis, first), _moved(start, axis, second)
            if second - first > 1:
                self._want(_moved(start, axis, self._between(*ends, axis, len(between))))
                complete = False
                continue
            # labels of ends without points are confirmed before they count
            known = [self._want(position) for position in ends]
            if all(known):
                crossings.append(BoundaryCrossing(low=ends[0], axis=axis, labels=(labels[index], labels[index + 1])))
            else:
                complete = False
        return crossings if complete else None

    def _between(self, low: Position, high: Position, axis: int, before: int) -> int:
        """Return the next place to try between two positions with different labels.

        Secant steps follow margins that cross 0. Every second step is a halving, so that margins that jump at the
        boundary cost at most twice the number of halvings.

        Args:
            low: lower position.
            high: higher position.
            axis: axis along which they differ.
            before: number of points that are known between the ends of the edge.
        """
        first, last = low[axis], high[axis]
        for one, other in zip(self._margins.get(low, ()), self._margins.get(high, ()), strict=False):
            if one * other < 0:  # false for nan
                near = min(abs(one), abs(other)) < _NEAR_ZERO * max(abs(one), abs(other))
                if before == 0 or (before % 2 and near):
                    place = first + round((last - first) * one / (one - other))
                    return min(max(place, first + 1), last - 1)
                break
        return (first + last) // 2

    def _fitted(
        self,
        edges: Sequence[Sequence[BoundaryCrossing]],
        count: int,
        cell: RegionCell,
        corners: Mapping[Position, str],
        inside: Sequence[Position],
    ) -> tuple[BoundaryPlane, ...]:
        """Return planes through the boundaries on the edges, from low to high; none if known labels contradict them.

        Args:
            edges: boundaries on every edge that has any.
            count: number of all edges.
            cell: the cell.
            corners: labels of its corners.
            inside: positions in the cell whose labels are known.
        """
        axes = {crossing.axis for edge in edges for crossing in edge}
        if len(cell.labels) == 2 and edges and all(len(edge) == 1 for edge in edges):
            groups = [[edge[0] for edge in edges]]
        elif len(axes) == 1 and len(edges) * len(cell.low) == count:
            # a band crosses all edges along one axis, with the same labels on all of them
            groups = [list(group) for group in zip(*edges, strict=False)]
            if len({len(edge) for edge in edges}) > 1 or any(
                len({item.labels for item in group}) > 1 for group in groups
            ):
                return ()
        else:
            return ()
        fitted = [fitted_plane(group) for group in groups]
        surfaces = tuple(surface for surface in fitted if surface is not None)
        if len(surfaces) < len(groups):
            return ()
        for corner in corners:
            heights = [surface.height(corner) for surface in surfaces]
            if heights != sorted(heights):
                return ()
        labels = labels_between(surfaces)
        for position, label in (*corners.items(), *((position, self._labels[position]) for position in inside)):
            distances = [(surface.distance(position), surface.accuracy) for surface in surfaces]
            above = sum(distance > accuracy for distance, accuracy in distances)
            perhaps = sum(distance >= -accuracy for distance, accuracy in distances)
            if label not in labels[above : perhaps + 1]:
                return ()
        return surfaces

    def _test(
        self, surfaces: Sequence[BoundaryPlane], low: Position, high: Position, corners: Mapping[Position, str]
    ) -> bool | None:
        """Return whether each boundary is next to its plane at its centre; None as long as this is unknown."""
        labels, complete = labels_between(surfaces), True
        for number, surface in enumerate(surfaces):
            axis = surface.axis
            at = tuple(round(place) for place in surface.centre)
            place = min(max(round(surface.height(at)), low[axis]), high[axis])
            nearest = _moved(at, axis, place)
            label = self._labels.get(nearest, corners.get(nearest))
            if label is None:
                self._want(nearest)
                complete = False
                continue
            if label not in labels:
                return False
            is_above = label in labels[number + 1 :] and label not in labels[: number + 1]
            if label in labels[number + 1 :] and not is_above:
                # the label is on both sides of the band, so the neighbours decide
                is_above = surface.distance(nearest) > 0
            neighbour = _moved(at, axis, place - 1 if is_above else place + 1)
            if not low[axis] <= neighbour[axis] <= high[axis]:
                continue
            other = self._labels.get(neighbour, corners.get(neighbour))
            if other is None:
                self._want(neighbour)
                complete = False
            elif other == label or other not in (labels[: number + 1] if is_above else labels[number + 1 :]):
                return False
        return True if complete else None

    def _split(self, cell: RegionCell, corners: Mapping[Position, str], inside: Sequence[Position]) -> bool:
        """Split a cell and examine its parts; return False as long as labels of new corners are missing."""
        # an island is outlined from the point that reveals the island
        strangers = [position for position in inside if self._labels[position] not in cell.corners]
        inner = strangers[0] if strangers and not cell.crossings else None
        sides = []
        for axis, (first, last) in enumerate(zip(cell.low, cell.high, strict=True)):
            cut = (first + last) // 2 if inner is None or not first < inner[axis] < last else inner[axis]
            sides.append((first, cut, last) if last - first > 1 else (first, last))
        labels: dict[Position, str] = {}
        missing = False
        for vertex in itertools.product(*sides):
            cut_axes = [axis for axis in range(len(vertex)) if cell.low[axis] < vertex[axis] < cell.high[axis]]
            if vertex in self._labels:
                labels[vertex] = self._labels[vertex]
            elif not cut_axes:
                labels[vertex] = corners[vertex]
            elif len(cut_axes) == 1:
                labels[vertex] = self._label_on_edge(vertex, cut_axes[0], cell, corners)
            else:
                missing |= not self._want(vertex)
        if missing:
            return False
        for part in itertools.product(*(itertools.pairwise(side) for side in sides)):
            low, high = (tuple(ends) for ends in zip(*part, strict=True))
            within = [
                position
                for position in inside
                if all(a <= place <= b for a, place, b in zip(low, position, high, strict=True))
            ]
            self._examine(low, high, {corner: labels[corner] for corner in itertools.product(*part)}, within)
        return True

    def _label_on_edge(self, vertex: Position, axis: int, cell: RegionCell, corners: Mapping[Position, str]) -> str:
        """Return the label of a position without a point on an edge whose boundaries are known."""
        line = self._lines.get((axis, _without(vertex, axis)), [])
        index = bisect_left(line, vertex[axis])
        if index > 0 and line[index - 1] >= cell.low[axis]:
            return self._labels[_moved(vertex, axis, line[index - 1])]
        return corners[_moved(vertex, axis, cell.low[axis])]


def _without(position: Position, axis: int) -> Position:
    return position[:axis] + position[axis + 1 :]


def _moved(position: Position, axis: int, place: int) -> Position:
    return (*position[:axis], place, *position[axis + 1 :])


def _probe_shares(axes: int, probes: int) -> Array:
    """Return where the points inside a cell are, as shares of its sides: Sobol points without the first, which is 0.

    The next one is the centre.
    """
    power = math.ceil(math.log2(probes + 1))
    return np.asarray(scipy.stats.qmc.Sobol(axes, scramble=False).random_base2(power)[1 : probes + 1])


def region_parts(cell: RegionCell) -> Iterator[tuple[str, list[tuple[float, float]]]]:
    """Yield the parts of a cell by label, each as the ends of its sides on all axes, split at the middle of the cell.

    For cells without a plane.
    """
    middles = [(a + b) / 2 for a, b in zip(cell.low, cell.high, strict=True)]
    if len(cell.labels) == 1:
        yield cell.labels[0], [(float(a), float(b)) for a, b in zip(cell.low, cell.high, strict=True)]
        return
    corners = itertools.product(*zip(cell.low, cell.high, strict=True))
    for corner, label in zip(corners, cell.corners, strict=True):
        yield label, [(min(at, mid), max(at, mid)) for at, mid in zip(corner, middles, strict=True)]
