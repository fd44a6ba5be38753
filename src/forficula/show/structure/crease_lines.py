"""The lines of a crease pattern, and the axes that a sheet is drawn in."""

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
_WIDEST = 4.6  # inch: it has one part, which a page would only blow up
_LOW = 0.5  # height by width
_LOWEST = 0.1  # height by width, or width by height, of what is drawn: what is longer is stretched across
_MOST_LINES = 200  # of creases and edges, before they are drawn thinner


def sheet_axes(places: Array, span: float, unit: str, width: float) -> tuple[Figure, Axes]:
    """A figure for a sheet seen from above, with room for a legend over it.

    Args:
        places: what is to be seen, in the unit, (point, axis).
        span: the size of it all, in the unit.
        unit: of the axes.
        width: of the figure at most, inch.
    """
    extent = np.maximum(np.ptp(places[:, :2], axis=0), 1e-9 * span)
    width = min(width, _WIDEST)
    ratio = extent[1] / extent[0]
    stretch = float(np.clip(1.0, _LOWEST / ratio, 1 / _LOWEST / ratio))
    tall = min(2.0, max(0.3 if ratio > 0.15 else _LOWEST, ratio))
    # a low one has no room to spare for a second row of the legend
    room = 0.9 if tall > _LOW else 1.1
    figure = Figure(figsize=(width, (width - 0.5) * tall + room), layout="constrained")
    axes = figure.subplots()
    axes.set_aspect(stretch)
    axes.set_xlabel(f"x ({unit}){_stretched(stretch)}")
    axes.set_ylabel(f"y ({unit})")
    axes.margins(0.06)
    return figure, axes


def _stretched(stretch: float) -> str:
    """Says which axis is drawn larger than the other one, where one is."""
    times, axis = max(stretch, 1 / stretch), "y" if stretch > 1 else "x"
    return f"; {axis} is drawn {times:.2g} times as large" if times > 1 else ""


def draw_creases(axes: Axes, pattern: CreasePattern, points: Array) -> list[Line2D]:
    """The edges of a pattern between its vertices as they are drawn, (vertex, 2); returns what they mean."""
    lw = 1.1 if len(pattern.edges_vertices) <= _MOST_LINES else 0.5
    for (start, end), assignment in zip(pattern.edges_vertices, pattern.edges_assignment, strict=True):
        colour, style, _ = _STYLES[assignment]
        axes.plot(*points[[start, end]].T, style, color=colour, lw=lw)
    return [
        Line2D([], [], color=colour, ls=style, label=name)
        for letter, (colour, style, name) in _STYLES.items()
        if letter in pattern.edges_assignment
    ]
