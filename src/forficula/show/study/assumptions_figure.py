"""Changes of times and works under changed assumptions: a dot for each, beside the numerical uncertainty."""

from __future__ import annotations

import math
import textwrap
from collections.abc import Sequence
from typing import Any

from matplotlib.axes import Axes
from matplotlib.colors import to_hex
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from forficula.show.style import (
    BLACK,
    BLUE,
    PAGE_WIDTH,
    VERMILION,
    describe,
    figure_style,
    fit_legend,
    is_narrow,
    letter_panels,
)
from forficula.study.assumptions.assumptions import AssumptionRun, Assumptions, Effect

# inch, height of a row, and of everything above and below the rows
_ROW, _NARROW_ROW, _AROUND = 0.19, 0.23, 1.0
_INK, _BAND = "0.45", "0.85"
# %; smaller changes are on a linear scale, larger ones on a logarithmic scale
_EVEN = 10.0
_NAME_LETTERS = 22  # letters per line of a name in a column-wide figure
_LABEL_LETTERS = 20  # letters per line of the label of an axis
_LOOKS: dict[Effect, tuple[str, dict[str, Any]]] = {
    Effect.VERDICT: ("changes the verdict", {"marker": "D", "color": VERMILION, "ms": 5}),
    Effect.NUMBERS: ("changes numbers", {"marker": "o", "color": BLUE, "ms": 4.5}),
    Effect.NOTHING: ("no effect", {"marker": "o", "mfc": "white", "mec": BLUE, "ms": 4.5}),
    Effect.UNKNOWN: ("no reliable result", {"marker": "x", "color": _INK, "ms": 4.5}),
}
_MISSED: dict[str, Any] = {"marker": ">", "ms": 5}


def draw_assumptions(results: Assumptions, width: float = PAGE_WIDTH) -> Figure:
    """Draw the change of the time and the work of each transition under every changed assumption, in percent.

    Rows are the changed assumptions, panels the times and works. The band is the numerical uncertainty of the
    unchanged design's run. A transition that fails with the change has a triangle at the right edge instead of a dot; a
    run without a reliable result has a cross.

    Args:
        results: results to draw.
        width: width of the figure, inch.
    """
    panels = [
        (transition.time if kind == "time" else f"work of {transition.noun}", transition.name, kind)
        for kind in ("time", "work")
        for transition in results.transitions
        if _value(results.own, transition.name, kind)
    ]
    narrow = is_narrow(width)
    with figure_style():
        across = max(1, min(len(panels), 2 if narrow else 4))
        down = max(1, math.ceil(len(panels) / across))
        height = down * ((_NARROW_ROW if narrow else _ROW) * len(results.runs) + 0.5) + _AROUND
        figure = Figure(figsize=(width, height), layout="constrained")
        every = figure.subplots(down, across, squeeze=False).ravel().tolist()
        for axes in every[max(len(panels), 1) :]:
            axes.set_visible(False)
        for axes, (label, name, kind) in zip(every, panels, strict=False):
            _draw_panel(axes, results, name, kind)
            axes.set_xlabel(f"{textwrap.fill(label, _LABEL_LETTERS)},\nchange (%)", fontsize=7)
        for number, axes in enumerate(every[: max(len(panels), 1)]):
            _name_rows(axes, results if number % across == 0 else None, len(results.runs), narrow=narrow)
        shown = every[: len(panels)]
        letter_panels(shown)
        fit_legend(figure, _handles(results, shown), 3, loc="outside upper center")
        return describe(figure, f"Effects of modelling assumptions on {results.design.name}. {_sentence(results)}")


def _handles(results: Assumptions, panels: Sequence[Axes]) -> list[Line2D | Patch]:
    """Return the legend's entries of what the panels show."""
    drawn = {(line.get_marker(), to_hex(line.get_markerfacecolor())) for axes in panels for line in axes.lines}
    looks = [*_LOOKS.values(), ("fails with the change", {"color": VERMILION, **_MISSED})]
    entries = [Line2D([], [], ls="", label=label, **look) for label, look in looks]
    handles: list[Line2D | Patch] = [
        entry for entry in entries if (entry.get_marker(), to_hex(entry.get_markerfacecolor())) in drawn
    ]
    if any(results.uncertainty.values()):
        handles.append(Patch(fc=_BAND, label="numerical uncertainty"))
    return handles


def _value(run: AssumptionRun, name: str, kind: str) -> float | None:
    return (run.times if kind == "time" else run.works)[name]


def _draw_panel(axes: Axes, results: Assumptions, name: str, kind: str) -> None:
    """Draw a dot for every run that has the value, and a triangle if the transition fails."""
    as_designed = _value(results.own, name, kind)
    assert as_designed
    axes.set_xscale("symlog", linthresh=_EVEN)
    half = 100 * results.uncertainty.get(f"{name}.{kind}", 0.0) / abs(as_designed)
    axes.axvspan(-half, half, color=_BAND, lw=0)
    axes.axvline(0, color=BLACK, lw=0.6)
    changes: list[float] = []
    for row, run in enumerate(results.runs):
        axes.axhline(row, color="0.92", lw=0.5, zorder=0)
        value, (_, look) = _value(run, name, kind), _LOOKS[run.effect]
        # the work of a stage that missed its goal belongs to another motion
        if value is None or run.times[name] is None:
            at_edge = {"color": VERMILION, **_MISSED} if run.verdict.conclusive else _LOOKS[Effect.UNKNOWN][1]
            axes.plot([0.98], [row], transform=axes.get_yaxis_transform(), ls="", clip_on=False, **at_edge)
            continue
        changes.append(100 * (value - as_designed) / abs(as_designed))
        axes.plot([0, changes[-1]], [row, row], color=look.get("color", BLUE), lw=0.9)
        axes.plot([changes[-1]], [row], ls="", **look)
    least, most = min(changes, default=0.0), max(changes, default=0.0)
    axes.set_xlim(min(2 * least, -1.2 * _EVEN), max(4 * most, 1.2 * _EVEN))
    axes.set_xticks(_ticks(*axes.get_xlim()), minor=False)
    axes.xaxis.set_minor_locator(_none())
    axes.xaxis.set_major_formatter(lambda tick, _: f"{tick:+.0f}".replace("-", "−") if tick else "0")


def _ticks(low: float, high: float) -> list[float]:
    """Return powers of ten of both signs between two bounds, %, and 0; only some of them if there are many."""
    powers = [10.0**power for power in range(1, 9)]
    within = [tick for tick in powers if tick <= max(-low, high)]
    kept = within[:: 1 + len(within) // 2]
    return [tick for tick in (*(-item for item in reversed(kept)), 0.0, *kept) if low <= tick <= high]


def _none() -> Any:
    from matplotlib.ticker import NullLocator

    return NullLocator()


def _name_rows(axes: Axes, results: Assumptions | None, count: int, *, narrow: bool) -> None:
    """Label the rows, those that change the verdict in its colour; without assumptions, hide the labels."""
    axes.set_ylim(count - 0.5, -0.5)
    axes.set_yticks([])
    axes.spines["left"].set_visible(False)
    for row, run in enumerate(() if results is None else results.runs):
        axes.annotate(
            textwrap.fill(run.label, _NAME_LETTERS) if narrow else run.label,
            (0, row),
            (-4, 0),
            xycoords=axes.get_yaxis_transform(),
            textcoords="offset points",
            ha="right",
            va="center",
            fontsize=6 if narrow else 7,
            color=VERMILION if run.effect is Effect.VERDICT else BLACK,
        )


def _sentence(results: Assumptions) -> str:
    return f"{results.verdict[:1].upper()}{results.verdict[1:]}."
