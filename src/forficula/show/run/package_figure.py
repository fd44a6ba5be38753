"""The package of a structure: from above as it starts and at its smallest, and from the side, enlarged."""

from __future__ import annotations

from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.transforms import offset_copy

from forficula.analysis.package import Package, open_package, smallest_package
from forficula.arrays import Array
from forficula.dynamics import Record
from forficula.quantities import reading_unit, show_value
from forficula.show.structure.painted_shape import paint_shape, show_painted
from forficula.show.structure.shape import shape_of
from forficula.show.structure.surface import surface_at
from forficula.show.structure.viewpoint import Viewpoint
from forficula.show.style import ORANGE, PAGE_WIDTH, describe, figure_style, is_narrow, letter_panels

_ROOM = 1.25  # size of a picture, as a multiple of its larger side
_BESIDE, _WORDS = 8.0, 3.0  # pt, distance of a dimension from its picture, and of words from the dimension


def draw_package(record: Record, width: float = PAGE_WIDTH) -> Figure:
    """Draw a structure from above at its start and at its smallest area, and its stack from the side.

    Args:
        record: run with a state that its protocol names.
        width: width of the figure, inch.
    """
    smallest, opened = smallest_package(record), open_package(record)
    assert smallest is not None
    name, time, package = smallest
    whole = record.structure.appearance.whole
    pictures = [
        (f"at the start, {_area(opened)}", 0.0, _from_above(opened)),
        (f"{name}, {_area(package)}", time, _from_above(package)),
        (f"{name}, from the side, enlarged", time, _from_the_side(package)),
    ]
    with figure_style():
        narrow = is_narrow(width)
        rows, columns = (3, 1) if narrow else (1, 3)
        figure = Figure(figsize=(width, 2.2 * rows), layout="constrained")
        panels = np.ravel(figure.subplots(rows, columns, squeeze=False))
        shape = shape_of(record.structure)
        painted = [paint_shape(surface_at(record, shape, at), view, ORANGE) for _, at, view in pictures]
        sizes = [item.corners for item in painted]
        largest = max(float(np.ptp(size, axis=0).max()) for size in sizes[:2])
        for axes, (title, _, _), item, enlarged in zip(panels, pictures, painted, (False, False, True), strict=True):
            side = float(np.ptp(item.corners, axis=0).max()) if enlarged else largest
            window = item.corners.mean(axis=0) + _ROOM * side * np.array([[-0.5], [0.5]])
            show_painted(axes, item, window, width / columns)
            axes.set_title(title, pad=3)
        spans = (opened.width, opened.length), (package.width, package.length), (package.length, package.height)
        for axes, size, (across, upwards) in zip(panels, sizes, spans, strict=True):
            _dimension(axes, size, across, upwards)
        letter_panels(panels.tolist())
        return describe(figure, f"The {whole} {record.design.name}. {package_text(name, time, package)}")


def package_text(name: str, time: float, package: Package) -> str:
    """Return a sentence about the package of a state at a time, s."""
    return (
        f"Package when {name} (at {show_value(time, 's')}): {_size(package.height)} high, {_size(package.width)} by"
        f" {_size(package.length)}, {100 * package.area_ratio:.3g} % of the area at the start."
    )


def _area(package: Package) -> str:
    return f"{1e4 * package.area:.3g} cm²"


def _size(length: float) -> str:
    unit, factor = reading_unit("m", length)
    return f"{factor * length:.3g} {unit}"


def _from_above(package: Package) -> Viewpoint:
    return Viewpoint(right=package.across, up=np.cross(package.upwards, package.across), towards=package.upwards)


def _from_the_side(package: Package) -> Viewpoint:
    along = np.cross(package.upwards, package.across)
    return Viewpoint(right=along, up=package.upwards, towards=np.cross(along, package.upwards))


def _dimension(axes: Axes, corners: Array, across: float, upwards: float) -> None:
    """Write the size of a picture below and beside it, at lines with ticks at their ends."""
    (left, low), (right, high) = corners.tolist()
    line: dict[str, Any] = {"color": "black", "lw": 0.7, "ms": 5, "mew": 0.7, "clip_on": False}
    figure = axes.get_figure(root=True)
    below = offset_copy(axes.transData, figure, y=-_BESIDE, units="points")
    axes.plot([left, right], [low, low], marker="|", transform=below, **line)
    beside = offset_copy(axes.transData, figure, x=_BESIDE, units="points")
    axes.plot([right, right], [low, high], marker="_", transform=beside, **line)
    words: dict[str, Any] = {"textcoords": "offset points", "annotation_clip": False}
    middle = (left + right) / 2, (low + high) / 2
    axes.annotate(_size(across), (middle[0], low), (0, -_BESIDE - _WORDS), ha="center", va="top", **words)
    axes.annotate(_size(upwards), (right, middle[1]), (_BESIDE + _WORDS, 0), ha="left", va="center", **words)
