"""Figures of an identification: agreement with each fact, facts met together, and values that agree."""

from __future__ import annotations

import textwrap
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from forficula.goals.identify.exclusion import Together
from forficula.goals.identify.marginal import marginals, unknowns_of
from forficula.show.study.factor_text import display_values, number_text, plain_name
from forficula.show.style import (
    BLACK,
    BLUE,
    COLUMN_WIDTH,
    ORANGE,
    PAGE_WIDTH,
    QUANTITY_COLOURS,
    VERMILION,
    Drawing,
    describe,
    figure_style,
    fit_legend,
    is_narrow,
    letter_panels,
)

if TYPE_CHECKING:
    from xarray import DataArray, Dataset

_GREY, _PALE = "0.62", "0.85"
_BINS = 8
_PANEL = 1.15  # height of a small panel, inch
_PAIRS, _PAIRS_NARROW = 5, 3
# inch: the names of facts or unknowns, a cell of a table of facts, the widest panel of an unknown and of a pair
_NAMES_WIDTH, _CELL, _WIDEST, _PAIR = 2.4, 0.55, 1.75, 3.2
# scaled distance at which the axis ends: larger distances are drawn there
_FAR = 10.0


def identify_drawings(result: Dataset) -> dict[str, Drawing]:
    """Return the drawings of an identification by the stems of their files."""
    return {
        "facts": lambda width: draw_facts(result, width=width),
        "together": lambda width: draw_together(result, width=width),
        "unknowns": lambda width: draw_unknowns(result, width=width),
        "pairs": lambda width: draw_pairs(result, width=width),
    }


def draw_facts(result: Dataset, *, width: float = PAGE_WIDTH) -> Figure:
    """Draw for each fact the share of samples that meets it, and the distances of the other samples.

    Args:
        result: table of an identification.
        width: width of the figure, inch.
    """
    names = [str(name) for name in result["fact"].values]
    places = np.arange(len(names))
    with figure_style():
        narrow = is_narrow(width)
        figure = Figure(
            figsize=(width, (0.3 if narrow else 0.26) * len(names) + (1.2 if narrow else 0.9)), layout="constrained"
        )
        left, right = figure.subplots(1, 2, sharey=True)
        between = "\n" if narrow else " "
        share, low, high = (100 * result[name].values for name in ("met_share", "met_share_low", "met_share_high"))
        left.barh(places, share, 0.62, color=BLUE)
        errors = np.vstack([np.maximum(share - low, 0), np.maximum(high - share, 0)])
        left.errorbar(share, places, xerr=errors, fmt="none", ecolor=BLACK, elinewidth=0.8, capsize=2)
        left.set(
            xlim=(0, min(100.0, 1.1 * max(float(np.nanmax(high)), 5.0))),
            xlabel=f"samples that meet{between}the fact (%)",
        )
        left.set_yticks(places, [textwrap.fill(name, 17 if narrow else 30) for name in names])
        left.set_ylim(len(names) - 0.4, -0.6)
        _draw_distances(right, result, places)
        right.set_xlabel(f"distance to the fact{between}(its scale)")
        letter_panels([left, right])
        handles = [
            Patch(color=BLUE, label="share"),
            Line2D([], [], color=BLACK, marker="|", ms=4, lw=0.8, label="its 95 % interval"),
            Line2D([], [], color=_GREY, marker="|", ls="", label="sample that misses the fact"),
            Line2D([], [], color=VERMILION, marker="D", ms=4, ls="", label="nearest of these"),
        ]
        fit_legend(figure, handles, 4, loc="outside lower center")
        shares = "; ".join(f"{name}: {item:.3g} %" for name, item in zip(names, share, strict=True))
        return describe(figure, f"Share of samples that meet each fact, and distances of the others to it. {shares}.")


def _draw_distances(axes: Axes, result: Dataset, places: Any) -> None:
    """Draw a stroke for each sample that misses a fact, at its distance in the fact's scale, and mark the nearest."""
    distances = result["scaled_distance"].values
    for place in places:
        missed = distances[:, place]
        missed = missed[np.isfinite(missed) & (missed > 0)]
        if not len(missed):
            continue
        shown = np.minimum(missed, _FAR)
        axes.plot(shown, np.full(len(shown), place), "|", color=_GREY, ms=7, mew=0.5, alpha=0.6)
        axes.plot(shown.min(), place, "D", color=VERMILION, ms=4)
    axes.set_xscale("symlog", linthresh=0.1, linscale=0.4)
    axes.set(xlim=(-0.01, 1.25 * _FAR))
    axes.set_xticks([0, 0.1, 1, _FAR], ["0", "0.1", "1", f"{_FAR:g}+"])
    axes.minorticks_off()


def draw_together(result: Dataset, *, width: float = PAGE_WIDTH) -> Figure:
    """Draw how many samples meet each pair of facts, and mark pairs that no sample meets.

    Args:
        result: table of an identification.
        width: width of the figure, inch.
    """
    names = [str(name) for name in result["fact"].values]
    both, placed = result["met_together"].values, result["met_together_placed"].values
    count, narrow = len(names), is_narrow(width)
    with figure_style():
        height = (0.25 if narrow else 0.34) * count + (0.95 if narrow else 0.7)
        # few facts have no wide cells
        width = max(COLUMN_WIDTH, min(width, _NAMES_WIDTH + _CELL * count))
        figure = Figure(figsize=(width, height), layout="constrained")
        axes = figure.subplots()
        # cells without a sample have a frame and no colour
        lower = np.where((np.tril(np.ones_like(both)) > 0) & (both > 0), both, np.nan).astype(float)
        axes.imshow(lower, cmap=QUANTITY_COLOURS, vmin=0, vmax=max(1, both.max()), aspect="auto")
        for row in range(count):
            for column in range(row + 1):
                _write_cell(axes, result, row, column, both, placed, small=narrow)
        axes.set_yticks(range(count), [f"{textwrap.shorten(name, 26, placeholder='…')}  {number}"
                                       for number, name in enumerate(names, start=1)])  # fmt: skip
        axes.set_xticks(range(count), [str(number) for number in range(1, count + 1)])
        axes.tick_params(axis="both", length=0)
        for spine in axes.spines.values():
            spine.set_visible(False)
        words = set(result["together"].values.ravel().tolist()) - {""}
        looks = {
            Together.EXCLUDED: Patch(fc="white", ec=VERMILION, lw=1.4, label="none: the facts exclude one another"),
            "": Patch(fc="white", ec=_GREY, hatch="///", lw=0.5, label="none, but some values might"),
            Together.PLACED: Patch(fc="none", ec="none", label="+ placed samples"),
        }
        words |= (
            {""} if words & {Together.RARE, Together.UNTRIED, Together.NEARLY, Together.OPEN, Together.NEVER} else set()
        )
        handles = [look for word, look in looks.items() if word in words]
        axes.set_xlabel("drawn samples that meet both facts")
        if handles:
            fit_legend(figure, handles, 3, loc="outside lower center")
        return describe(figure, _together_text(result, names))


def _write_cell(axes: Axes, result: Dataset, row: int, column: int, both: Any, placed: Any, *, small: bool) -> None:
    """Write the number of a cell, with a frame if it is zero."""
    verdict, drawn = str(result["together"].values[row, column]), int(both[row, column])
    text = str(drawn) if drawn or not placed[row, column] or row == column else f"+{int(placed[row, column])}"
    none = drawn == 0
    if none:
        excluded = verdict == Together.EXCLUDED
        axes.add_patch(
            _cell(column, row, ec=VERMILION if excluded else _GREY, hatch=None if excluded else "///",
                  lw=1.4 if excluded else 0.5)
        )  # fmt: skip
    dark = not none and drawn < 0.55 * max(1, both.max())
    box: dict[str, Any] = {"fc": "white", "ec": "none", "pad": 0.8} if none else None  # type: ignore[assignment]
    axes.text(
        column, row, text, ha="center", va="center", fontsize=5.5 if small else 7, bbox=box,
        color="white" if dark else BLACK, fontweight="bold" if row == column else "normal",
    )  # fmt: skip


def _cell(column: int, row: int, **look: Any) -> Any:
    from matplotlib.patches import Rectangle

    return Rectangle((column - 0.44, row - 0.44), 0.88, 0.88, fc="white", **look)


def _together_text(result: Dataset, names: list[str]) -> str:
    words = result["together"].values
    excluded = [
        f"{names[column]} and {names[row]}"
        for row in range(len(names))
        for column in range(row)
        if words[row, column] == Together.EXCLUDED
    ]
    sentence = f"Pairs that exclude one another: {'; '.join(excluded)}." if excluded else ""
    return f"Number of samples that meet each pair of facts. {sentence}".strip()


def draw_unknowns(result: Dataset, *, width: float = PAGE_WIDTH) -> Figure:
    """Draw the distribution of each unknown: the samples that agree before the prior.

    The horizontal axis gives equal lengths to equal prior probabilities, so the prior is level.

    Args:
        result: table of an identification.
        width: width of the figure, inch.
    """
    marked = marginals(result)
    rows = -(-len(marked) // (3 if is_narrow(width) else 5))
    columns = -(-len(marked) // max(rows, 1)) or 1
    # few unknowns have no wide panels
    width = max(COLUMN_WIDTH, min(width, _WIDEST * columns))
    agrees = result["agrees"].values
    with figure_style():
        figure = Figure(figsize=(width, _PANEL * rows + 0.35), layout="constrained")
        grid = figure.subplots(rows, columns, squeeze=False).ravel()
        for axes, item in zip(grid, marked, strict=False):
            shares = result[f"{item.name}_share"].values
            bins = _bins(result[item.name])
            weights = np.full(int(agrees.sum()), (len(bins) - 1) / max(int(agrees.sum()), 1))
            axes.axhspan(0, 1, color=_PALE, lw=0)
            axes.hist(shares[agrees], bins=bins, weights=weights, color=BLUE, alpha=1.0 if item.significant else 0.45)
            axes.set_title(_label(result[item.name], 18 if is_narrow(width) else 22), fontsize=6.5, loc="left", pad=2)
            _share_axis(axes.xaxis, result, item.name)
            axes.set_xlim(0, 1)
            axes.set_yticks([])
            axes.spines["left"].set_visible(False)
        top = max(axes.get_ylim()[1] for axes in grid[: len(marked)])
        for axes in grid[: len(marked)]:
            axes.set_ylim(0, top)
        for axes in grid[len(marked) :]:
            axes.set_visible(False)
        handles = [Patch(color=_PALE, label="prior")]
        if any(item.significant for item in marked):
            handles.append(Patch(color=BLUE, label="samples that agree"))
        if not all(item.significant for item in marked):
            handles.append(
                Patch(color=BLUE, alpha=0.45, label="samples that agree; difference from prior may be chance")
            )
        fit_legend(figure, handles, 3, loc="outside lower center")
        narrowed = [item.key for item in marked if item.significant]
        what = f"The facts narrow {', '.join(narrowed)}." if narrowed else "The facts narrow none of them."
        return describe(figure, f"Distribution of each unknown: samples that agree before the prior. {what}")


def draw_pairs(result: Dataset, *, width: float = PAGE_WIDTH) -> Figure:
    """Draw pairs of the unknowns that the facts narrow most: samples that agree before those that do not.

    Args:
        result: table of an identification.
        width: width of the figure, inch.
    """
    most = _PAIRS_NARROW if is_narrow(width) else _PAIRS
    names = [marginal.name for marginal in marginals(result)[:most]] if len(unknowns_of(result)) > 1 else []
    agrees, drawn = result["agrees"].values, ~result["directed"].values
    ran = result["status"].values == "ran"
    counts = result["met"].values.sum(axis=1)
    best = ran & (counts == counts.max(initial=0))
    size = max(len(names) - 1, 1)
    with figure_style():
        width = max(COLUMN_WIDTH, min(width, _NAMES_WIDTH / 2 + _PAIR * size))
        figure = Figure(figsize=(width, 0.92 * width * size / (size + 0.25)), layout="constrained")
        grid = figure.subplots(size, size, squeeze=False)
        larger = 1.5 if size == 1 else 1.0
        for row in range(size):
            for column in range(size):
                axes = grid[row, column]
                if column > row or not names:
                    axes.set_visible(False)
                    continue
                across, upwards = names[column], names[row + 1]
                x, y = result[f"{across}_share"].values, result[f"{upwards}_share"].values
                rest = drawn & ran & ~agrees
                axes.plot(x[rest], y[rest], "o", ms=2 * larger, color=_PALE, mec=_GREY, mew=0.3)
                axes.plot(x[agrees], y[agrees], "o", ms=3 * larger, color=BLUE, mew=0)
                axes.plot(x[best], y[best], "o", ms=5.5 * larger, mfc="none", mec=ORANGE, mew=1.0, clip_on=False)
                axes.set(xlim=(-0.02, 1.02), ylim=(-0.02, 1.02))
                _share_axis(axes.xaxis, result, across, labelled=row == size - 1)
                _share_axis(axes.yaxis, result, upwards, labelled=column == 0)
                if row == size - 1:
                    axes.set_xlabel(_label(result[across]), fontsize=7)
                if column == 0:
                    axes.set_ylabel(_label(result[upwards], wrap=14), fontsize=7)
        most_met = int(result.attrs["most_met"])
        handles = [
            Line2D([], [], ls="", marker="o", ms=3, color=_PALE, mec=_GREY, mew=0.3, label="drawn"),
            Line2D([], [], ls="", marker="o", ms=4, color=BLUE, mew=0, label="agrees"),
            Line2D([], [], ls="", marker="o", ms=6, mfc="none", mec=ORANGE,
                   label=f"meets most facts, {most_met} of {result.sizes['fact']}"),
        ]  # fmt: skip
        fit_legend(figure, handles, 3, loc="outside lower center")
        keys = ", ".join(str(result[name].attrs["key"]) for name in names) or "none"
        return describe(figure, f"Unknowns in pairs, samples that agree before those that do not. Unknowns: {keys}.")


def _label(coordinate: DataArray, wrap: int = 22) -> str:
    unit = display_values(coordinate)[1]
    name = plain_name(coordinate)
    lines = [textwrap.fill(name, wrap), *([f"({unit})"] if unit else [])]
    # a unit is never broken
    return (" " if sum(map(len, lines)) < wrap else "\n").join(lines)


def _bins(coordinate: DataArray) -> Any:
    """Return bins of equal prior probability; one for each choice."""
    words = coordinate.attrs.get("prior") == "values"
    count = len(set(map(str, coordinate.values))) if words else _BINS
    return np.linspace(0, 1, max(count, 1) + 1)


def _share_axis(axis: Any, result: Dataset, name: str, *, labelled: bool = True) -> None:
    """Label an axis of prior shares with values: near the ends and the middle, or at each choice."""
    coordinate, shares = result[name], result[f"{name}_share"].values
    axis.set_tick_params(labelsize=6, length=2)
    if coordinate.attrs.get("prior") == "values":
        middles = {str(value): [] for value in coordinate.values}  # type: dict[str, list[float]]
        for value, share in zip(coordinate.values, shares, strict=True):
            middles[str(value)].append(float(share))
        ordered = sorted(middles, key=lambda value: float(np.mean(middles[value])))
        axis.set_ticks([(index + 0.5) / len(ordered) for index in range(len(ordered))], ordered if labelled else [])
        return
    values, _ = display_values(coordinate)
    order = np.argsort(shares)
    at = np.interp([0.1, 0.5, 0.9], shares[order], values[order].astype(float))
    axis.set_ticks([0.1, 0.5, 0.9], [number_text(float(f"{item:.2g}")) for item in at] if labelled else [])
