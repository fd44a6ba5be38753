"""Layout of figures of one hinge: energy over moment, and beside them the barrier enlarged and the legend."""

from __future__ import annotations

import textwrap
from collections.abc import Sequence
from typing import Any

from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from forficula.show.style import fit_legend, is_narrow, letter_panels

_HEIGHTS = (1.3, 1.0)  # energy and moment
_WIDTHS = (2.5, 1.0)  # both of them, and the enlarged barrier
_PAGE, _COLUMN, _ENLARGED, _SENTENCE = 4.6, 5.0, 1.0, 0.25  # inch, heights of figures, and what a column has below
_LETTERS = 32  # letters per line of a sentence


def hinge_panels(width: float, *, enlarged: bool) -> tuple[Figure, Axes, Axes, Axes]:
    """Return a figure with axes for energy, moment and the enlarged barrier, side by side.

    The first two have the same horizontal axis. The third is on their right, or below in a column.

    Args:
        width: width of the figure, inch.
        enlarged: whether a barrier is drawn in the third axes; otherwise they are reserved for a sentence.
    """
    if is_narrow(width):
        below = _ENLARGED if enlarged else _SENTENCE
        figure = Figure(figsize=(width, _COLUMN + below), layout="constrained")
        grid = figure.add_gridspec(3, 1, height_ratios=[*_HEIGHTS, below])
        places = grid[0], grid[1], grid[2]
    else:
        figure = Figure(figsize=(width, _PAGE), layout="constrained")
        grid = figure.add_gridspec(2, 2, height_ratios=_HEIGHTS, width_ratios=_WIDTHS)
        places = grid[0, 0], grid[1, 0], grid[0, 1]
    top = figure.add_subplot(places[0])
    bottom = figure.add_subplot(places[1], sharex=top)
    near = figure.add_subplot(places[2])
    top.tick_params(labelbottom=False)
    if not enlarged:
        near.set_axis_off()
    letter_panels([top, bottom, *[near] * enlarged])
    return figure, top, bottom, near


def write_sentence(near: Axes, text: str) -> None:
    """Write a sentence in the place of an enlarged barrier."""
    look: dict[str, Any] = {"ha": "center", "va": "center", "fontsize": 7, "color": "0.25"}
    near.text(0.5, 0.5, textwrap.fill(text, _LETTERS), transform=near.transAxes, **look)


def add_legend(figure: Figure, handles: Sequence[Artist]) -> None:
    """Add the legend below the enlarged barrier, or above the panels of a column."""
    width = figure.get_figwidth()
    if is_narrow(width):
        fit_legend(figure, handles, 2, loc="outside upper center")
        return
    grid = figure.axes[0].get_gridspec()
    assert grid is not None
    axes = figure.add_subplot(grid[1, 1])
    axes.set_axis_off()
    room = width * _WIDTHS[1] / sum(_WIDTHS)
    fit_legend(axes, handles, 1, room=room, loc="center", borderaxespad=0)
