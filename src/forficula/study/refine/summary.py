"""Conclusions of a study that locates boundaries: their width, the number of runs, and the islands it may miss."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.names import counted, listed
from forficula.quantities import Unit, show_quantity
from forficula.study.refine.boundary_plan import BoundaryPlan, LatticeAxis, Position, positions_of, read_plan
from forficula.study.refine.cells import LocatedBoundaries, locate
from forficula.study.refine.rounds import point_labels

if TYPE_CHECKING:
    from xarray import DataArray, Dataset


@dataclass(frozen=True, kw_only=True)
class BoundaryMap:
    """Regions of a table and the boundaries between them.

    Attributes:
        plan: plan of the study.
        labels: label of every point, by position.
        located: cells that fill the ranges of all factors.
    """

    plan: BoundaryPlan
    labels: Mapping[Position, str]
    located: LocatedBoundaries

    @property
    def words(self) -> list[str]:
        """All labels, the most frequent first."""
        return [word for word, _ in Counter(self.labels.values()).most_common()]

    @property
    def open_cells(self) -> int:
        """Number of cells with boundaries that are not located."""
        return sum(not cell.located for cell in self.located.cells)

    @property
    def boundaries(self) -> Counter[tuple[str, str]]:
        """Number of located positions of each boundary, by the labels on both sides."""
        crossings = {crossing for cell in self.located.cells for crossing in cell.crossings}
        return Counter((min(item.labels), max(item.labels)) for item in crossings)


def locates_boundaries(table: Dataset) -> bool:
    """Return whether a table is that of a study that locates boundaries."""
    return "boundaries" in table.attrs


def boundary_map(table: Dataset) -> BoundaryMap:
    """Return the regions of a table of a study that locates boundaries, and the boundaries between them."""
    plan = read_plan(table.attrs["boundaries"])
    positions = positions_of(plan, [table[axis.dimension].values for axis in plan.axes])
    labels = dict(zip(positions, point_labels(table, plan), strict=True))
    return BoundaryMap(plan=plan, labels=labels, located=locate(plan, labels))


def boundary_text(table: Dataset) -> str:
    """Return what the boundaries of a table separate, such as "boundary of the state folded"."""
    states = read_plan(table.attrs["boundaries"]).boundary
    if isinstance(states, str):
        return f"boundary between {states}s"
    return f"boundary of the {'state' if len(states) == 1 else 'states'} {listed(states)}"


def boundary_sentences(table: Dataset) -> list[str]:
    """Return sentences on the number of points, the width of boundaries, and the islands that may be missed."""
    regions = boundary_map(table)
    plan, points = regions.plan, len(regions.labels)
    runs = int(table.attrs.get("point_runs", points))
    share = f"{100 * points / plan.full_grid:.2g} % of the {plan.full_grid} points of the full grid"
    counts = [f"{len(plan.initial_grid)} points are the initial grid"]
    if points > len(plan.initial_grid):
        counts.append(f"refinement placed {points - len(plan.initial_grid)}")
    sentences = [f"{points} points with {runs} runs locate the boundaries: {share}. {' and '.join(counts)}."]
    if not regions.boundaries and len(regions.words) > 1:
        sentences.append(f"No boundary is located between the results of the points ({listed(regions.words)}).")
    elif not regions.boundaries:
        sentences.append(f"No boundary was found: every point has the same result ({regions.words[0]}).")
    else:
        widths = listed([_width_text(axis, table[axis.dimension]) for axis in plan.axes], "or")
        edges = f"a boundary lies between two points that differ by {widths}."
        sentences.append(
            f"{edges[0].upper()}{edges[1:]}"
            if len(plan.axes) == 1
            else f"On every edge of a cell, {edges} In a cell, boundaries are planes through these positions, which two"
            " points at the centre of each plane confirm."
        )
        pairs = [f"{first} | {second} ({count})" for (first, second), count in regions.boundaries.most_common()]
        sentences.append(f"Boundaries, with the number of their positions on edges: {', '.join(pairs)}.")
    if regions.located.wanted:
        consequence = (
            f"Boundaries in {counted(regions.open_cells, 'cell')} are not located to this width."
            if regions.open_cells
            else "Some cells of the initial grid lack the points inside that reveal islands."
        )
        sentences.append(f"Refinement stopped at {points} points (sampling.most_points). {consequence}")
    extents = largest_gap(plan, list(regions.labels))
    sizes = [_extent_text(extent, axis, table[axis.dimension]) for extent, axis in zip(extents, plan.axes, strict=True)]
    shape = {1: "interval", 2: "ellipse", 3: "ellipsoid"}[len(plan.axes)]
    sentences.append(
        f"An island of another result is missed if it contains no point. The largest {shape} without a point extends"
        f" {listed(sizes)}."
    )
    return sentences


def largest_gap(plan: BoundaryPlan, positions: Sequence[Position]) -> list[tuple[float, float]]:
    """Return the ends, along every factor in SI, of the largest ellipse or ellipsoid that contains no point.

    Sizes are compared in intervals of the initial grid. The centre of the ellipse is inside the ranges of the factors.
    """
    axes = plan.axes
    scaled = np.column_stack(
        [
            np.interp(column, axis.grid_places, np.arange(len(axis.grid)))
            for axis, column in zip(axes, np.array(positions, dtype=float).T, strict=True)
        ]
    )
    centre, radius = _largest_ball(scaled, np.array([len(axis.grid) - 1.0 for axis in axes]))
    ends = []
    for axis, middle in zip(axes, centre.tolist(), strict=True):
        scaled_ends = np.clip([middle - radius, middle + radius], 0, len(axis.grid) - 1)
        low, high = axis.at(np.interp(scaled_ends, np.arange(len(axis.grid)), axis.grid_places)).tolist()
        ends.append((low, high))
    return ends


def _largest_ball(points: Array, sides: Array) -> tuple[Array, float]:
    """Return the centre and the radius of the largest ball without points whose centre is in a box.

    Args:
        points: (point, axis), with points at all corners of the box.
        sides: sides of the box, which begins at 0.
    """
    if points.shape[1] == 1:
        column = np.sort(points[:, 0])
        widest = int(np.argmax(np.diff(column)))
        return np.array([column[widest : widest + 2].mean()]), float(np.diff(column)[widest] / 2)
    # mirrored points make candidates of the positions on the sides of the box
    mirrored = [points]
    for axis, side in enumerate(sides.tolist()):
        for face in (0.0, side):
            image = points.copy()
            image[:, axis] = 2 * face - image[:, axis]
            mirrored.append(image)
    everything = np.unique(np.concatenate(mirrored), axis=0)
    centres = scipy.spatial.Voronoi(everything).vertices
    centres = centres[((centres >= -1e-9) & (centres <= sides + 1e-9)).all(axis=1)]
    distances = scipy.spatial.cKDTree(points).query(centres)[0]
    best = int(np.argmax(distances))
    return centres[best], float(distances[best])


def _unit(factor: DataArray) -> Unit | None:
    attributes = factor.attrs
    if not attributes.get("units"):
        return None
    return Unit(si=attributes["units"], display=attributes.get("display", ""))


def _name(factor: DataArray) -> str:
    return str(factor.attrs.get("long_name", factor.name)).removeprefix("protocol ")


def _number_text(value: float, unit: Unit | None) -> str:
    return f"{value:.3g}" if unit is None else show_quantity(value, unit, 3)


def _width_text(axis: LatticeAxis, factor: DataArray) -> str:
    """Return the largest step of an axis in words, such as "1 N/cm in tendon stiffness"."""
    steps = np.array(axis.steps)
    if axis.logarithmic:
        ratio = float(np.max((np.array(axis.grid[1:]) / axis.grid[:-1]) ** (1 / steps)))
        return f"{100 * (ratio - 1):.3g} % in {_name(factor)}"
    return f"{_number_text(float(np.max(np.diff(axis.grid) / steps)), _unit(factor))} in {_name(factor)}"


def _extent_text(extent: tuple[float, float], axis: LatticeAxis, factor: DataArray) -> str:
    """Return the size and the ends of an interval in words, such as "5 N/cm in tendon stiffness (10 to 15 N/cm)"."""
    (low, high), unit = extent, _unit(factor)
    ends = f"{_number_text(low, unit)} to {_number_text(high, unit)}"
    if axis.logarithmic:
        return f"from {ends} in {_name(factor)}"
    return f"{_number_text(high - low, unit)} in {_name(factor)} ({ends})"
