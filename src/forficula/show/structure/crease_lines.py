"""Lines of a crease pattern, and axes for drawings of sheets."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.ticker import MaxNLocator

from forficula.arrays import Array
from forficula.show.structure.flat_net import FlatNet
from forficula.show.style import BLACK, BLUE, PURPLE, VERMILION, fit_legend

_STYLES = {
    "M": (VERMILION, "-.", "mountain"),
    "V": (BLUE, "--", "valley"),
    "B": (BLACK, "-", "border"),
    "C": (BLACK, ":", "cut"),
    "F": ("0.6", "-", "flat"),
    "U": ("0.6", "-.", "unassigned"),
}
_SEAM = (PURPLE, (0, (1, 1)), "seam, joined")
_WIDEST = 4.6  # inch: a single drawing gains nothing from a larger size
_LOWEST = 0.1  # least height by width, or width by height; more slender drawings are stretched across
_MARGIN = 0.06  # of the drawing's size
# inch beside and below axes for words
_BESIDE, _BELOW = 0.6, 0.56
_LEGEND_GAP = 0.08  # inch
_MOST_LINES = 200  # number of creases and edges above which lines are thinner


def sheet_axes(places: Array, span: float, unit: str, width: float) -> tuple[Figure, Axes]:
    """Return a figure and axes for a sheet in the plane; `add_sheet_legend` adds the space for a legend above.

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
    tall = min(2.0, max(_LOWEST, ratio))
    figure = Figure(figsize=(width, (width - _BESIDE) * tall + _BELOW), layout="constrained")
    axes = figure.subplots()
    axes.set_aspect(stretch)
    axes.set_xlabel(f"x ({unit}){_stretched(stretch)}")
    axes.set_ylabel(f"y ({unit})")
    axes.margins(_MARGIN)
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator(nbins="auto", steps=[1, 2, 2.5, 5, 10], min_n_ticks=2))
    return figure, axes


def add_sheet_legend(figure: Figure, handles: Sequence[Artist], columns: int) -> None:
    """Add a legend above a sheet, and as much height as the legend needs."""
    legend = fit_legend(figure, handles, columns, loc="outside upper center")
    height = legend.get_window_extent().height / figure.dpi
    figure.set_figheight(figure.get_figheight() + height + _LEGEND_GAP)


def _stretched(stretch: float) -> str:
    """Return a note on the axis that is stretched, if any."""
    times, axis = max(stretch, 1 / stretch), "y" if stretch > 1 else "x"
    return f"; {axis} is stretched {times:.2g} times" if times > 1 else ""


def draw_creases(axes: Axes, net: FlatNet, factor: float) -> list[Artist]:
    """Draw the edges of a flat pattern, times a factor; return the legend's entries."""
    pattern, points = net.pattern, factor * net.pattern.vertices_coords[:, :2]
    lw = 1.1 if len(pattern.edges_vertices) <= _MOST_LINES else 0.5
    styles = [_SEAM if edge in net.seams else _STYLES[letter] for edge, letter in enumerate(pattern.edges_assignment)]
    for (start, end), (colour, style, _) in zip(pattern.edges_vertices, styles, strict=True):
        axes.plot(*points[[start, end]].T, ls=style, color=colour, lw=lw)
    return [
        Line2D([], [], color=colour, ls=style, label=name)
        for colour, style, name in (*_STYLES.values(), _SEAM)
        if (colour, style, name) in styles
    ]
