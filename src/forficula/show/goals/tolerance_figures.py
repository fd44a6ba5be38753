"""What a tolerance shows: whose the variance is, the cloud of what is built over the map, how near failure is."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch, Rectangle

from forficula.goals.tolerance import Tolerance
from forficula.goals.tolerance.advice import percent
from forficula.goals.tolerance.nearest_failure import Answer
from forficula.goals.tolerance.tolerance import VerdictMap
from forficula.show.study.factor_text import display_values, factor_label, key_text
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

# inch, of a row of bars
_ROW = 0.27
_INK = "0.35"
# how designs with everything off are drawn
_POINTS: dict[Answer, tuple[str, dict[str, Any]]] = {
    Answer.WORKS: ("built: works", {"marker": "o", "mfc": "white", "mec": BLACK, "mew": 0.6, "ms": 3.2}),
    Answer.FAILS: ("built: fails", {"marker": "x", "color": VERMILION, "mew": 1.0, "ms": 3.6}),
    Answer.UNKNOWN: ("built: not to be trusted", {"marker": "d", "color": ORANGE, "ms": 3.2}),
}
# seen on cells of any colour
_DESIGN: dict[str, Any] = {"marker": "P", "mfc": "white", "mec": BLACK, "mew": 1.0, "ms": 8}
_END: dict[str, Any] = {"marker": "|", "color": _INK, "ms": 7, "mew": 1.6}


def draw_indices(found: Tolerance, width: float = PAGE_WIDTH) -> Figure:
    """Draw first-order and total indices of the margin with their 95 % intervals, one factor a row; width in inch."""
    indices, places = found.indices, list(found.shown)
    has_total = bool(np.isfinite(indices.total[0]).any())
    names = [_group_name(found, place) for place in places]
    with figure_style():
        figure = Figure(figsize=(width, _ROW * len(places) + 0.95), layout="constrained")
        axes = figure.subplots()
        rows = np.arange(len(places), dtype=float)
        bars = [("alone", BLUE, indices.first[0], indices.first_low[0], indices.first_high[0], 0.2 * has_total)]
        if has_total:
            total = (indices.total[0], indices.total_low[0], indices.total_high[0])
            bars.append(("alone and with others", SKY, *total, -0.2))
        for label, colour, values, low, high, shift in bars:
            height, at = 0.38 if has_total else 0.7, rows + shift
            shown = np.nan_to_num(values[places])
            axes.barh(at, np.maximum(shown, 0), height, color=colour, label=label)
            axes.hlines(at, low[places], high[places], color=BLACK, lw=0.9)
            for end in (low, high):
                axes.plot(end[places], at, "|", color=BLACK, ms=4, mew=0.9)
        axes.axvline(0, color=BLACK, lw=0.6)
        axes.set_yticks(rows, names)
        axes.invert_yaxis()
        axes.set_xlabel("share of the variance of the margin")
        axes.set_xlim(min(0.0, float(np.nanmin(indices.first_low[0], initial=0.0))) - 0.02, None)
        handles: list[Artist] = [Patch(fc=colour, label=label) for label, colour, *_ in bars]
        handles.append(Line2D([], [], color=BLACK, lw=0.9, marker="|", ms=4, label="95 % interval"))
        fit_legend(figure, handles, 3, loc="outside upper center")
        most = names[0] if names else "nothing"
        return describe(
            figure,
            f"Which tolerances decide whether {found.question.design.name} works. Most of the margin's variance has to"
            f" do with {most}; it works in {percent(found.probability)} of cases.",
        )


def draw_cloud(found: Tolerance, table: Dataset, width: float = PAGE_WIDTH) -> Figure:
    """Draw what is built within the tolerances over what becomes of designs of which two factors are off alone.

    Args:
        found: with a map.
        table: of it.
        width: of the figure, inch.
    """
    drawn = found.map
    assert drawn is not None
    width = width if is_narrow(width) else 0.75 * width
    with map_style():
        figure = Figure(figsize=(width, 0.8 * width + 0.4), layout="constrained")
        axes = figure.subplots()
        handles = _draw_map(axes, drawn, found, table)
        samples, centres, scales = found.samples, *_places(drawn, found, table)
        across, upwards = (
            centre + samples.offsets[:, factor] * scale
            for factor, centre, scale in zip((drawn.first, drawn.second), centres, scales, strict=True)
        )
        for answer, (label, look) in _POINTS.items():
            which = samples.answers == answer
            if which.any():
                axes.plot(across[which], upwards[which], ls="", **look)
                handles.append(Line2D([], [], ls="", label=label, **look))
        _mark_design(axes, found, drawn, centres, scales)
        handles.append(Line2D([], [], ls="", label="as designed", **_DESIGN))
        axes.set_xlabel(_label(found, drawn.first, table))
        axes.set_ylabel(_label(found, drawn.second, table))
        fit_legend(figure, handles, 3, loc="outside upper center")
        names = [key_text(found.question.keys[each]) for each in (drawn.first, drawn.second)]
        return describe(
            figure,
            f"What is built of {found.question.design.name}, over {names[0]} and {names[1]}. Cells say what becomes of"
            f" it where these two alone are off, points are designs with everything off: {percent(found.probability)}"
            " of these work.",
        )


def draw_reaches(found: Tolerance, width: float = PAGE_WIDTH) -> Figure:
    """Draw how far each value alone may go down and up before it fails, in tolerances; width in inch."""
    nearest = [
        min((reach.fails for reach in ways if reach.fails is not None), default=np.inf) for ways in found.reaches
    ]
    order = np.argsort(nearest, kind="stable").tolist()
    with figure_style():
        figure = Figure(figsize=(width, 0.6 * _ROW * len(order) + 0.95), layout="constrained")
        axes = figure.subplots()
        for row, factor in enumerate(order):
            for sign, reach in zip((-1, 1), found.reaches[factor], strict=True):
                axes.barh(row, sign * reach.works, 0.6, color=SKY)
                if reach.fails is not None:
                    axes.plot(sign * reach.fails, row, "x", color=VERMILION, ms=4.5, mew=1.3)
                elif reach.why is not Answer.WORKS:
                    axes.plot(sign * reach.works, row, ls="", **_END)
        axes.axvline(0, color=BLACK, lw=0.6)
        for edge in (-1, 1):
            axes.axvline(edge, color=BLACK, lw=0.8, ls="--")
        axes.set_yticks(range(len(order)), [key_text(found.question.keys[factor]) for factor in order])
        axes.invert_yaxis()
        axes.margins(y=0.01)
        axes.set_xlabel("deviation of this value alone (tolerances)")
        handles: list[Artist] = [
            Patch(fc=SKY, label="works"),
            Line2D([], [], ls="", marker="x", color=VERMILION, ms=4.5, mew=1.3, label="fails"),
            Line2D([], [], ls="", label="no such design beyond, or not to be trusted", **_END),
            Line2D([], [], color=BLACK, lw=0.8, ls="--", label="the tolerance"),
        ]
        fit_legend(figure, handles, 3, loc="outside upper center")
        told = "none fails alone"
        if np.isfinite(nearest[order[0]]):
            told = f"{key_text(found.question.keys[order[0]])} fails first, {nearest[order[0]]:.2g} tolerances off"
        return describe(figure, f"How far each value of {found.question.design.name} alone may be off. Of all, {told}.")


def _group_name(found: Tolerance, place: int) -> str:
    if place < len(found.kept):
        return key_text(found.question.keys[found.kept[place]])
    return f"the {len(found.question.keys) - len(found.kept)} others"


def _label(found: Tolerance, factor: int, table: Dataset) -> str:
    return factor_label(table[found.question.keys[factor].replace(".", "_")])


def _places(drawn: VerdictMap, found: Tolerance, table: Dataset) -> tuple[list[float], list[float]]:
    """Of both factors of a map the design's own value and one width, in the unit that is shown."""
    centres, scales = [], []
    for factor in (drawn.first, drawn.second):
        values, _ = display_values(table[found.question.keys[factor].replace(".", "_")])
        offsets = found.samples.offsets[:, factor]
        # the table has values, and so their unit, of every sample: two of them tell how one width reads
        low, high = int(np.argmin(offsets)), int(np.argmax(offsets))
        scale = float((values[high] - values[low]) / (offsets[high] - offsets[low]))
        scales.append(scale)
        centres.append(float(values[low] - scale * offsets[low]))
    return centres, scales


def _draw_map(axes: Axes, drawn: VerdictMap, found: Tolerance, table: Dataset) -> list[Artist]:
    """Cells in the colours of what became of them, and what the legend says of these."""
    centres, scales = _places(drawn, found, table)
    across, upwards = (
        centre + steps * scale for centre, steps, scale in zip(centres, drawn.steps, scales, strict=True)
    )
    width, height = across[1] - across[0], upwards[1] - upwards[0]
    words = drawn.samples.outcomes.reshape(len(across), len(upwards))
    for (column, row), word in np.ndenumerate(words):
        look = look_of(table, word)
        corner = (across[column] - width / 2, upwards[row] - height / 2)
        axes.add_patch(Rectangle(corner, width, height, fc=look.face, hatch=look.hatch, ec="0.75", lw=0.0))
    axes.set_xlim(across[0] - width / 2, across[-1] + width / 2)
    axes.set_ylim(upwards[0] - height / 2, upwards[-1] + height / 2)
    present = dict.fromkeys(words.ravel().tolist())
    looks = {word: look_of(table, word) for word in present}
    return [Patch(fc=look.face, hatch=look.hatch, ec=_INK, lw=0.4, label=word) for word, look in looks.items()]


def _mark_design(axes: Axes, found: Tolerance, drawn: VerdictMap, centres: list[float], scales: list[float]) -> None:
    """The design's own place, and the edge of uniform tolerances."""
    axes.plot(*([centre] for centre in centres), ls="", **_DESIGN)
    if all(found.question.deviations[each].distribution == "uniform" for each in (drawn.first, drawn.second)):
        corner = (centres[0] - scales[0], centres[1] - scales[1])
        axes.add_patch(Rectangle(corner, 2 * scales[0], 2 * scales[1], fc="none", ec=BLACK, lw=0.9, ls="--"))
