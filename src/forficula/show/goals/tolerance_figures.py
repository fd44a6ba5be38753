"""Figures of a tolerance analysis: sensitivity indices, samples over the map, and nearest failures."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.colors import to_rgb
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Rectangle
from matplotlib.patheffects import withStroke

from forficula.goals.tolerance.nearest_failure import Answer
from forficula.show.study.factor_text import display_values, factor_label, key_text, plain_name
from forficula.show.study.outcome_looks import look_of, map_style
from forficula.show.style import (
    BLACK,
    BLUE,
    ORANGE,
    PAGE_WIDTH,
    SKY,
    VERMILION,
    describe,
    figure_style,
    fit_legend,
    is_narrow,
)

if TYPE_CHECKING:
    from xarray import Dataset

# height of a row of bars, inch
_ROW = 0.27
# largest number of groups of one factor
_MOST_ROWS = 10
_INK = "0.35"
_CASED = [withStroke(linewidth=2.6, foreground="white")]
# looks of designs in which all values deviate
_POINTS: dict[Answer, tuple[str, dict[str, Any]]] = {
    Answer.WORKS: ("sample: works", {"marker": "o", "mfc": "white", "mec": BLACK, "mew": 0.6, "ms": 3.2}),
    Answer.FAILS: (
        "sample: fails",
        {
            "marker": "x",
            "color": BLACK,
            "mew": 1.3,
            "ms": 4.4,
            "path_effects": [withStroke(linewidth=2.6, foreground="w")],
        },
    ),
    Answer.UNKNOWN: ("sample: unreliable", {"marker": "d", "mfc": ORANGE, "mec": BLACK, "mew": 0.5, "ms": 4.0}),
}
# share of white in the colours of cells, so that points in front of them are visible
_PALE = 0.6
# visible on cells of any colour
_DESIGN: dict[str, Any] = {"marker": "P", "mfc": "white", "mec": BLACK, "mew": 1.0, "ms": 8}
_EDGE: dict[str, Any] = {"color": BLACK, "lw": 0.9, "ls": "--"}
_END: dict[str, Any] = {"marker": "|", "color": _INK, "ms": 7, "mew": 1.6}
_FAILURE: dict[str, Any] = {"marker": "x", "color": VERMILION, "ms": 4.5, "mew": 1.3}


def draw_indices(table: Dataset, width: float = PAGE_WIDTH) -> Figure:
    """Draw first-order and total indices of the margin with their 95 % intervals, one row for each factor.

    Args:
        table: table from `tolerance_table`.
        width: width of the figure, inch.
    """
    first, total = (table[f"{name}_index"].values[0] for name in ("first", "total"))
    has_total = bool(np.isfinite(total).any())
    places = _ranked(table, total if has_total else first)
    names = [_group_name(table, index) for index in places]
    with figure_style():
        figure = Figure(figsize=(width, _ROW * len(places) + 0.95), layout="constrained")
        axes = figure.subplots()
        rows = np.arange(len(places), dtype=float)
        bars = [("deviations of this value alone", BLUE, "first", 0.2 * has_total)]
        if has_total:
            bars.append(("with its interactions", SKY, "total", -0.2))
        for label, colour, name, shift in bars:
            share, low, high = (table[f"{name}_index{end}"].values[0][places] for end in ("", "_low", "_high"))
            at = rows + shift
            axes.barh(at, np.maximum(np.nan_to_num(share), 0), 0.38 if has_total else 0.7, color=colour, label=label)
            axes.hlines(at, low, high, color=BLACK, lw=0.9)
            for ends in (low, high):
                axes.plot(ends, at, "|", color=BLACK, ms=4, mew=0.9)
        axes.axvline(0, color=BLACK, lw=0.6)
        axes.set_yticks(rows, names)
        axes.invert_yaxis()
        axes.set_xlabel("share of the variance of the margin")
        least = np.nanmin(np.nan_to_num(table["first_index_low"].values[0]), initial=0.0)
        axes.set_xlim(float(least) - 0.02, None)
        handles: list[Artist] = [Patch(fc=colour, label=label) for label, colour, *_ in bars]
        handles.append(Line2D([], [], color=BLACK, lw=0.9, marker="|", ms=4, label="95 % interval"))
        fit_legend(figure, handles, 3, loc="outside upper center")
        return describe(
            figure,
            f"Tolerances that decide whether {table.attrs['design']} works. Most of the margin's variance is due to"
            f" {names[0]}; {_likely(table)}.",
        )


def draw_cloud(table: Dataset, width: float = PAGE_WIDTH) -> Figure:
    """Draw samples within the tolerances over a map of designs in which only two factors deviate.

    Args:
        table: table from `tolerance_table`, with a map.
        width: width of the figure, inch.
    """
    width = width if is_narrow(width) else 0.75 * width
    with map_style():
        figure = Figure(figsize=(width, 0.8 * width + 0.4), layout="constrained")
        axes = figure.subplots()
        handles = _draw_cells(axes, table)
        keys = [str(table[name].attrs["key"]) for name in ("map_x", "map_y")]
        across, upwards = (display_values(table[key.replace(".", "_")])[0] for key in keys)
        for answer, (label, look) in _POINTS.items():
            which = table["answer"].values == answer.value
            if which.any():
                axes.plot(across[which], upwards[which], ls="", **look)
                handles.append(Line2D([], [], ls="", label=label, **look))
        _draw_tolerance(axes, table, keys)
        handles.append(Line2D([], [], ls="", label="as designed", **_DESIGN))
        if len(axes.patches) > table["map_outcome"].size:
            handles.append(Line2D([], [], label="the tolerances", **_EDGE))
        axes.set_xlabel(factor_label(table["map_x"]))
        axes.set_ylabel(factor_label(table["map_y"]))
        fit_legend(figure, handles, 3, loc="outside upper center")
        names = " and ".join(plain_name(table[name]) for name in ("map_x", "map_y"))
        return describe(
            figure,
            f"Samples of {table.attrs['design']} over {names}. Cells show the outcome if only these two"
            f" values deviate, points are designs in which all values deviate: {_likely(table)}.",
        )


def draw_reaches(table: Dataset, width: float = PAGE_WIDTH) -> Figure:
    """Draw the deviations of each value alone, down and up, at which a design fails, in units of its tolerance.

    Args:
        table: table from `tolerance_table`, for a design that works.
        width: width of the figure, inch.
    """
    nearest = np.fmin(table["fails_down"].values, table["fails_up"].values)
    order = np.argsort(np.where(np.isnan(nearest), np.inf, nearest), kind="stable").tolist()
    keys = [key_text(str(key)) for key in table["factor"].values]
    with figure_style():
        figure = Figure(figsize=(width, 0.6 * _ROW * len(order) + 0.95), layout="constrained")
        axes = figure.subplots()
        for row, factor in enumerate(order):
            for sign, direction in ((-1, "down"), (1, "up")):
                works, fails, ends = (
                    table[f"{name}_{direction}"].values[factor] for name in ("works", "fails", "ends")
                )
                axes.barh(row, sign * works, 0.6, color=SKY)
                if np.isfinite(fails):
                    axes.plot(sign * fails, row, ls="", **_FAILURE)
                elif ends != Answer.WORKS.value:
                    axes.plot(sign * works, row, ls="", **_END)
        axes.axvline(0, color=BLACK, lw=0.6)
        for edge in (-1, 1):
            axes.axvline(edge, **_EDGE)
        axes.set_yticks(range(len(order)), [keys[factor] for factor in order])
        axes.invert_yaxis()
        axes.margins(y=0.01)
        axes.set_xlabel("deviation of this value alone (tolerances)")
        marks = {line.get_marker() for line in axes.lines}
        handles: list[Artist] = [Patch(fc=SKY, label="works")]
        for look, words in ((_FAILURE, "fails"), (_END, "undecided beyond")):
            if look["marker"] in marks:
                handles.append(Line2D([], [], ls="", label=words, **look))
        handles.append(Line2D([], [], label="the tolerance", **_EDGE))
        fit_legend(figure, handles, 4, loc="outside upper center")
        first = "None fails alone"
        if np.isfinite(nearest[order[0]]):
            first = f"{keys[order[0]]} fails first, at {nearest[order[0]]:.2g} tolerances".capitalize()
        return describe(figure, f"Largest deviation of each value of {table.attrs['design']} alone. {first}.")


def _ranked(table: Dataset, shares: Any) -> list[int]:
    """Return the indices of the groups by falling share of the variance; the group of remaining factors is last."""
    keys = {str(key) for key in table["factor"].values}
    groups = [str(group) for group in table["group"].values]
    single = [index for index, group in enumerate(groups) if group in keys]
    ranked = sorted(single, key=lambda index: -np.nan_to_num(shares[index]))[:_MOST_ROWS]
    return [*ranked, *(index for index in range(len(groups)) if index not in single)]


def _group_name(table: Dataset, index: int) -> str:
    group, keys = str(table["group"].values[index]), [str(key) for key in table["factor"].values]
    return key_text(group) if group in keys else f"{len(keys) - table.sizes['group'] + 1} others"


def _likely(table: Dataset) -> str:
    share, low, high = (float(table[f"probability{end}"].values[0]) for end in ("", "_low", "_high"))
    known = "an unknown share" if math.isnan(share) else f"{100 * share:.0f} %"
    return f"{known} of designs within tolerances work ({100 * low:.0f} to {100 * high:.0f} %)"


def _draw_cells(axes: Axes, table: Dataset) -> list[Artist]:
    """Draw cells in the colours of their outcomes, and return the legend's entries."""
    across, upwards = (display_values(table[name])[0] for name in ("map_x", "map_y"))
    width, height = across[1] - across[0], upwards[1] - upwards[0]
    words = table["map_outcome"].values
    looks = {word: look_of(table, str(word)) for word in dict.fromkeys(words.ravel().tolist())}
    for (column, row), word in np.ndenumerate(words):
        corner = (across[column] - width / 2, upwards[row] - height / 2)
        look = looks[word]
        axes.add_patch(Rectangle(corner, width, height, fc=_pale(look.face), hatch=look.hatch, ec="0.75", lw=0.0))
    axes.set_xlim(across[0] - width / 2, across[-1] + width / 2)
    axes.set_ylim(upwards[0] - height / 2, upwards[-1] + height / 2)
    return [Patch(fc=_pale(look.face), hatch=look.hatch, ec=_INK, lw=0.4, label=word) for word, look in looks.items()]


def _pale(colour: str) -> tuple[float, float, float]:
    """Mix a colour with white."""
    red, green, blue = (_PALE + (1 - _PALE) * part for part in to_rgb(colour))
    return red, green, blue


def _draw_tolerance(axes: Axes, table: Dataset, keys: list[str]) -> None:
    """Draw the nominal design, and the bounds of uniform tolerances."""
    centres, widths = [], []
    for key in keys:
        single, column = table.sel(factor=key), table[key.replace(".", "_")]
        value, width = float(single["value"]), float(single["width"])
        shown, _ = display_values(column.copy(data=np.full(column.shape, value)))
        beyond, _ = display_values(column.copy(data=np.full(column.shape, value + width)))
        centres.append(float(shown[0]))
        widths.append(float(beyond[0] - shown[0]))
    axes.plot([centres[0]], [centres[1]], ls="", **_DESIGN)
    if all(str(table.sel(factor=key)["distribution"].values) == "uniform" for key in keys):
        corner = (centres[0] - widths[0], centres[1] - widths[1])
        edge = {"ec": _EDGE["color"], "lw": _EDGE["lw"], "ls": _EDGE["ls"]}
        axes.add_patch(Rectangle(corner, 2 * widths[0], 2 * widths[1], fc="none", **edge))
