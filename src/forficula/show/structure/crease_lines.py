"""Lines of a crease pattern, and axes for drawings of sheets."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from forficula.arrays import Array
from forficula.pattern import CreasePattern
from forficula.show.style import BLACK, BLUE, VERMILION

_STYLES = {
    "M": (VERMILION, "-.", "mountain"),
    "V": (BLUE, "--", "valley"),
    "B": (BLACK, "-", "border"),
    "C": (BLACK, ":", "cut"),
    "F": ("0.6", "-", "flat"),
    "U": ("0.6", "-.", "unassigned"),
}
_WIDEST = 4.6  # inch: a single drawing gains nothing from a larger size
_LOW = 0.5  # height by width below which the legend needs more space
_LOWEST = 0.1  # least height by width, or width by height; more slender drawings are stretched across
_MOST_LINES = 200  # number of creases and edges above which lines are thinner


def sheet_axes(places: Array, span: float, unit: str, width: float) -> tuple[Figure, Axes]:
    """Return a figure and axes for a sheet seen from above, with space for a legend above.

    Args:
        places: points to show, in the unit, (point, axis).
        span: size of the sheet, in the unit.
        unit: unit of the axes.
        width: largest width of the figure, inch.
    """
    extent = np.maximum(np.ptp(places[:, :2], axis=0), 1e-9 * span)
    width = min(width, _WIDEST)
    ratio = extent[1] / extent[0]
    stretch = float(np.clip(1.0, _LOWEST / ratio, 1 / _LOWEST / ratio))
    tall = min(2.0, max(0.3 if ratio > 0.15 else _LOWEST, ratio))
    # a low figure needs space for a second row of the legend
    room = 0.9 if tall > _LOW else 1.1
    figure = Figure(figsize=(width, (width - 0.5) * tall + room), layout="constrained")
    axes = figure.subplots()
    axes.set_aspect(stretch)
    axes.set_xlabel(f"x ({unit}){_stretched(stretch)}")
    axes.set_ylabel(f"y ({unit})")
    axes.margins(0.06)
    return figure, axes


def _stretched(stretch: float) -> str:
    """Return a note on the axis that is stretched, if any."""
    times, axis = max(stretch, 1 / stretch), "y" if stretch > 1 else "x"
    return f"; {axis} is stretched {times:.2g} times" if times > 1 else ""


def draw_creases(axes: Axes, pattern: CreasePattern, points: Array) -> list[Line2D]:
    """Draw the edges of a pattern between its vertices, (vertex, 2); return the legend's entries."""
    lw = 1.1 if len(pattern.edges_vertices) <= _MOST_LINES else 0.5
    for (start, end), assignment in zip(pattern.edges_vertices, pattern.edges_assignment, strict=True):
        colour, style, _ = _STYLES[assignment]
        axes.plot(*points[[start, end]].T, style, color=colour, lw=lw)
    return [
        Line2D([], [], color=colour, ls=style, label=name)
        for letter, (colour, style, name) in _STYLES.items()
        if letter in pattern.edges_assignment
    ]
