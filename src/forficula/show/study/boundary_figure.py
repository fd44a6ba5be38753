"""Figure of a study that locates boundaries: regions of cells of different sizes, boundaries, and the points."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection, PolyCollection
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from forficula.arrays import Array
from forficula.show.study.factor_text import display_values, factor_label, number_text, plain_name
from forficula.show.study.outcome_looks import INK, OutcomeLook, known_words, look_of, map_style
from forficula.show.style import (
    BLACK,
    BLUE,
    GREEN,
    ORANGE,
    PAGE_WIDTH,
    PURPLE,
    SKY,
    YELLOW,
    describe,
    fit_legend,
    is_narrow,
    letter_panels,
)
from forficula.study.refine.boundary_plan import LatticeAxis
from forficula.study.refine.cells import RegionCell, region_parts
from forficula.study.refine.planes import BoundaryPlane
from forficula.study.refine.summary import BoundaryMap, boundary_map

if TYPE_CHECKING:
    from xarray import DataArray, Dataset

_MOST_PANELS = 9
_MOST_TICKS = 9
_CELL_LINES = 4000  # number of cells above which their outlines are left out
_HEIGHT, _STRIP_HEIGHT = 2.9, 0.7  # inch, of axes over two factors, and over one
_LEGEND = 0.45  # inch
# looks of labels that are no outcomes, beginning with the most frequent label that is not negative
_FACES = (BLUE, ORANGE, SKY, PURPLE, GREEN, YELLOW)

Corners = list[tuple[float, float]]


@dataclass(frozen=True, kw_only=True)
class _Plane:
    """Two factors and the place of the third one, if there is one.

    Attributes:
        x: index of the factor on the horizontal axis.
        y: index of the factor on the vertical axis; None if one factor varies.
        z: index of the third factor, or None.
        place: place of the third factor.
    """

    x: int
    y: int | None
    z: int | None = None
    place: int = 0

    def contains(self, cell: RegionCell, last: int) -> bool:
        """Return whether the cell has a part in the plane; `last` is the last place of the third factor."""
        if self.z is None:
            return True
        low, high = cell.low[self.z], cell.high[self.z]
        return low <= self.place < high or self.place == high == last

    def position(self, x: float, y: float, axes: int) -> tuple[float, ...]:
        """Return the position of a point of the plane on all axes."""
        at = {self.x: x, self.y: y, self.z: float(self.place)}
        return tuple(at[index] for index in range(axes))

    def rectangle(self, sides: Sequence[tuple[float, float]]) -> Corners:
        """Return the corners of a box in the plane, in turn."""
        (left, right), (low, high) = sides[self.x], (0.0, 1.0) if self.y is None else sides[self.y]
        return [(left, low), (right, low), (right, high), (left, high)]


@dataclass(frozen=True, kw_only=True)
class BoundaryShapes:
    """Regions, cells and boundaries in a plane, as polygons and lines of values in display units.

    Attributes:
        x: index of the factor on the horizontal axis.
        y: index of the factor on the vertical axis; None if one factor varies, whose shapes extend from 0 to 1.
        regions: polygons by label.
        cells: outlines of cells.
        lines: boundaries.
    """

    x: int
    y: int | None
    regions: dict[str, list[Corners]]
    cells: list[Corners]
    lines: list[Corners]


def boundary_shapes(table: Dataset) -> BoundaryShapes | None:
    """Return the shapes between boundaries over one or two factors; None for three factors, which have several planes.

    Args:
        table: table of a study that locates boundaries.
    """
    regions = boundary_map(table)
    if len(regions.plan.axes) > 2:
        return None
    (plane,), _ = _planes(regions)
    return _shapes(table, regions, plane)


def draw_boundary_map(table: Dataset, *, width: float = PAGE_WIDTH) -> Figure:
    """Draw the regions between boundaries over one or two factors; of a third factor, some values have a panel.

    Args:
        table: table of a study that locates boundaries.
        width: largest width of the figure, inch.
    """
    regions = boundary_map(table)
    planes, note = _planes(regions)
    columns = 1 if len(planes) == 1 or is_narrow(width) else 2 if len(planes) in (2, 4) else 3
    rows = math.ceil(len(planes) / columns)
    height = _STRIP_HEIGHT if planes[0].y is None else _HEIGHT if columns == 1 else 2.1
    width = width if columns > 1 else min(width, 0.72 * PAGE_WIDTH)
    with map_style():
        figure = Figure(figsize=(width, rows * (height + 0.45) + 0.75), layout="constrained")
        grid = figure.subplots(rows, columns, squeeze=False).ravel()
        for axes in grid[len(planes) :]:
            axes.remove()
        looks = dict(zip(regions.words, _looks(table, regions.words), strict=True))
        for index, (axes, plane) in enumerate(zip(grid, planes, strict=False)):
            _draw_plane(axes, table, regions, plane, looks)
            if index + columns >= len(planes):
                axes.set_xlabel(factor_label(_factor(table, regions, plane.x)))
            if plane.y is None:
                axes.set_yticks([])
                axes.spines.left.set_visible(False)
            elif index % columns == 0:
                axes.set_ylabel(factor_label(_factor(table, regions, plane.y)))
            if plane.z is not None:
                axes.set_title(_place_text(_factor(table, regions, plane.z), regions.plan.axes[plane.z], plane.place))
        letter_panels(list(grid[: len(planes)]))
        if note:
            figure.suptitle(note, fontsize=8)
        _add_legend(figure, regions, looks)
    return describe(figure, _description(table, regions))


def _planes(regions: BoundaryMap) -> tuple[list[_Plane], str]:
    """Return the planes that have a panel, and a note if not all values of the third factor have one."""
    axes = regions.plan.axes
    if len(axes) == 1:
        return [_Plane(x=0, y=None)], ""
    if len(axes) == 2:
        return [_Plane(x=1, y=0)], ""
    places = axes[2].grid_places
    chosen = np.unique(np.linspace(0, len(places) - 1, min(len(places), _MOST_PANELS)).round().astype(int)).tolist()
    note = f"{len(chosen)} of {len(places)} values of the initial grid" if len(chosen) < len(places) else ""
    return [_Plane(x=1, y=0, z=2, place=places[index]) for index in chosen], note


def _shapes(table: Dataset, regions: BoundaryMap, plane: _Plane) -> BoundaryShapes:
    last = regions.plan.axes[plane.z].size - 1 if plane.z is not None else 0
    cells = [cell for cell in regions.located.cells if plane.contains(cell, last)]
    to_axes = _transform(table, regions, plane)
    polygons: dict[str, list[Corners]] = {}
    lines: list[Corners] = []
    for cell in cells:
        parts = list(_parts(cell, plane))
        for label, corners in parts:
            polygons.setdefault(label, []).append(to_axes(corners))
        lines.extend(to_axes(line) for line in _boundary_lines(parts))
    return BoundaryShapes(
        x=plane.x,
        y=plane.y,
        regions=polygons,
        cells=[to_axes(plane.rectangle(_sides(cell))) for cell in cells],
        lines=lines,
    )


def _draw_plane(axes: Axes, table: Dataset, regions: BoundaryMap, plane: _Plane, looks: dict[str, OutcomeLook]) -> None:
    """Draw regions, outlines of cells, boundaries and points in a plane."""
    drawn = _shapes(table, regions, plane)
    for label, shapes in drawn.regions.items():
        look = looks.get(label) or OutcomeLook(face="0.8", hatch="", marker="o")
        axes.add_collection(PolyCollection(shapes, facecolors=look.face, edgecolors="none", alpha=0.55, lw=0))
        if look.hatch:
            axes.add_collection(
                PolyCollection(shapes, facecolors="none", edgecolors=INK, hatch=look.hatch, lw=0.0, alpha=0.35)
            )
    if len(drawn.cells) <= _CELL_LINES:
        axes.add_collection(PolyCollection(drawn.cells, facecolors="none", edgecolors="0.6", linewidths=0.3))
    axes.add_collection(LineCollection(drawn.lines, colors=BLACK, linewidths=1.0, capstyle="round"))
    _draw_points(axes, table, regions, plane, looks)
    for name, index in (("x", plane.x), ("y", plane.y)):
        if index is None:
            axes.set_ylim(0, 1)
            continue
        axis = regions.plan.axes[index]
        ends = _shown(_factor(table, regions, index), axis, np.array([0.0, axis.size - 1.0])).tolist()
        pad = 0.012 * (ends[1] - ends[0])
        if axis.logarithmic:
            getattr(axes, f"set_{name}scale")("log")
            getattr(axes, f"set_{name}lim")(ends[0], ends[1])
            _number_ticks(axes, name, _shown(_factor(table, regions, index), axis, np.array(axis.grid_places)))
        else:
            getattr(axes, f"set_{name}lim")(ends[0] - pad, ends[1] + pad)


def _number_ticks(axes: Axes, name: str, values: Array) -> None:
    """Set ticks at the values of the initial grid on a logarithmic axis; of many values, at some."""
    step = math.ceil(len(values) / _MOST_TICKS)
    shown = values[::step].tolist()
    axis = axes.xaxis if name == "x" else axes.yaxis
    axis.set_ticks(shown, [number_text(value) for value in shown])
    axis.set_ticks([], minor=True)


def _draw_points(
    axes: Axes, table: Dataset, regions: BoundaryMap, plane: _Plane, looks: dict[str, OutcomeLook]
) -> None:
    """Draw the points in a plane, with the colour of their region."""
    positions = np.array(list(regions.labels), dtype=float)
    labels = np.array(list(regions.labels.values()))
    if plane.z is not None:
        inside = positions[:, plane.z] == plane.place
        positions, labels = positions[inside], labels[inside]
    to_axes = _transform(table, regions, plane)
    size = 10.0 if len(labels) < 250 else 5.0 if len(labels) < 1500 else 1.5
    for word, look in looks.items():
        members = positions[labels == word]
        if len(members):
            upwards = members[:, plane.y] if plane.y is not None else np.full(len(members), 0.5)
            places = np.array(to_axes(list(zip(members[:, plane.x].tolist(), upwards.tolist(), strict=True))))
            axes.scatter(places[:, 0], places[:, 1], s=size, color=look.face, ec=INK, lw=0.35, zorder=3, clip_on=False)


def _parts(cell: RegionCell, plane: _Plane) -> Iterator[tuple[str, Corners]]:
    """Yield the parts of a cell in a plane by label, as polygons of places."""
    if not cell.surfaces:
        for label, sides in region_parts(cell):
            if plane.z is None or sides[plane.z][0] <= plane.place <= sides[plane.z][1]:
                yield label, plane.rectangle(sides)
        return
    rest = plane.rectangle(_sides(cell))
    for surface in cell.surfaces:
        below, rest = (_clipped(rest, surface, plane, sign) for sign in (-1, 1))
        if len(below) > 2:
            yield surface.labels[0], below
    if len(rest) > 2:
        yield cell.surfaces[-1].labels[1], rest


def _clipped(polygon: Corners, surface: BoundaryPlane, plane: _Plane, sign: int) -> Corners:
    """Return the part of a polygon above (sign 1) or below (-1) a surface (Sutherland and Hodgman 1974)."""
    axes = len(surface.centre)
    distances = [sign * surface.distance(plane.position(x, y, axes)) for x, y in polygon]
    kept: Corners = []
    for index, (corner, distance) in enumerate(zip(polygon, distances, strict=True)):
        before, earlier = polygon[index - 1], distances[index - 1]
        if (distance >= 0) != (earlier >= 0):
            share = earlier / (earlier - distance)
            kept.append((before[0] + share * (corner[0] - before[0]), before[1] + share * (corner[1] - before[1])))
        if distance >= 0:
            kept.append(corner)
    return kept


def _boundary_lines(parts: Sequence[tuple[str, Corners]]) -> Iterator[Corners]:
    """Yield the common sides of parts with different labels."""
    sides: dict[tuple[tuple[float, float], ...], set[str]] = {}
    for label, corners in parts:
        for start, end in itertools.pairwise([*corners, corners[0]]):
            key = tuple(sorted((_rounded(start), _rounded(end))))
            sides.setdefault(key, set()).add(label)
    yield from (list(side) for side, labels in sides.items() if len(labels) > 1)


def _rounded(corner: tuple[float, float]) -> tuple[float, float]:
    return round(corner[0], 6), round(corner[1], 6)


def _sides(cell: RegionCell) -> list[tuple[float, float]]:
    return [(float(low), float(high)) for low, high in zip(cell.low, cell.high, strict=True)]


def _transform(table: Dataset, regions: BoundaryMap, plane: _Plane) -> Callable[[Corners], Corners]:
    """Return the function that converts places to values in display units."""

    def to_axes(corners: Corners) -> Corners:
        columns = []
        for index, column in zip((plane.x, plane.y), np.array(corners).T, strict=True):
            shown = (
                column if index is None else _shown(_factor(table, regions, index), regions.plan.axes[index], column)
            )
            columns.append(shown.tolist())
        return list(zip(*columns, strict=True))

    return to_axes


def _factor(table: Dataset, regions: BoundaryMap, index: int) -> DataArray:
    return table[regions.plan.axes[index].dimension]


def _shown(factor: DataArray, axis: LatticeAxis, places: Array) -> Array:
    """Return the values at places in the display unit."""
    from xarray import DataArray

    return np.asarray(display_values(DataArray(axis.at(places), attrs=factor.attrs))[0])


def _place_text(factor: DataArray, axis: LatticeAxis, place: int) -> str:
    values, unit = display_values(factor)
    nearest = int(np.argmin(np.abs(factor.values - axis.values[place])))
    return f"{plain_name(factor)} {number_text(values[nearest].item())} {unit}".rstrip()


def _looks(table: Dataset, words: Sequence[str]) -> Iterator[OutcomeLook]:
    """Yield the look of each label: that of an outcome, or a colour; labels of states that are not reached are grey."""
    known, faces = set(known_words(table)), iter(itertools.cycle(_FACES))
    for word in words:
        if word in known:
            yield look_of(table, word)
        elif all(part.startswith("not ") for part in word.split(", ")):
            yield OutcomeLook(face="0.93", hatch="", marker="x")
        else:
            yield OutcomeLook(face=next(faces), hatch="", marker="o")


def _add_legend(figure: Figure, regions: BoundaryMap, looks: dict[str, OutcomeLook]) -> None:
    """Draw a legend with the regions, the boundary and the points."""
    counts = {word: sum(label == word for label in regions.labels.values()) for word in looks}
    handles: list[Patch | Line2D] = [
        Patch(
            facecolor=look.face,
            hatch=look.hatch,
            edgecolor=INK,
            alpha=0.6,
            lw=0.4,
            label=f"{word} ({counts[word]} points)",
        )
        for word, look in looks.items()
    ]
    if regions.boundaries:
        handles.append(Line2D([], [], color=BLACK, lw=1.0, label="boundary, straight in each cell"))
    handles.append(
        Line2D([], [], ls="", marker="o", ms=3.2, mfc="white", mec=INK, mew=0.5, label=f"{len(regions.labels)} points")
    )
    legend = fit_legend(figure, handles, 4, loc="outside lower center", columnspacing=1.2, fontsize=7)
    more = legend.get_window_extent().height / figure.dpi - _LEGEND
    figure.set_figheight(figure.get_figheight() + max(more, 0.0))


def _description(table: Dataset, regions: BoundaryMap) -> str:
    """Describe the figure."""
    names = [plain_name(table[axis.dimension]) for axis in regions.plan.axes]
    parts = [f"{word}: {sum(label == word for label in regions.labels.values())} points" for word in regions.words]
    between = [f"{first} and {second}" for first, second in regions.boundaries]
    lines = f" Boundaries between {'; '.join(between)}." if between else " No boundary was found."
    return (
        f"Regions of equal results over {' and '.join(names)}, from {len(regions.labels)} points of"
        f" {regions.plan.full_grid} of the full grid. {'; '.join(parts)}.{lines}"
    )
