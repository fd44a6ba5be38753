"""Axes over the time of a run: the whole run, and its driven stages enlarged."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from forficula.arrays import Array
from forficula.design import stage_drives
from forficula.dynamics import Record, StageEnd
from forficula.quantities import reading_unit, show_duration
from forficula.show.run.missed_goal import still_time
from forficula.show.structure.labels import by_number
from forficula.show.style import fit_legend, is_narrow, letter_panels

# time shown before and after a driven stage, as a share of it
LEAD = 0.15
# entries of a legend; more lines are grouped
MOST_ENTRIES = 8
_AFTER = 1.6  # time shown, as a multiple of the time until a stage reached its goal or came to rest
_ROOMY = 0.25  # share of a time axis above which words fit
_EDGE = 0.02  # share of a time axis at its left end from which names extend to the right
_LABELS = 0.6  # inch, width of a vertical axis
_MOST_CLOSE = 5  # largest number of driven stages that are drawn enlarged
_LABELLED = 2  # largest number of enlarged stages that have a label each
_BETWEEN = 1.06  # middle between two axes side by side, in widths of the left one
_LETTER, _SPACE = 3.9, 4.0  # pt, mean width of a letter, and least distance of words
_WHOLE = 1.5  # width of the axes of the whole run, in widths of those of a stage
_BESIDE = 1.7  # inch, width of a legend beside the axes
_EXTRA = 0.06  # range of a vertical axis beyond its values, as a share of their range


@dataclass(frozen=True, kw_only=True)
class TimeSpan:
    """Time axis of a column.

    Attributes:
        start: its zero, s in the run.
        scale: factor from s.
        stage: driven stage that is enlarged; None for the whole run.
    """

    start: float
    scale: float
    stage: StageEnd | None = None


def _driven(record: Record) -> list[StageEnd]:
    return [end for end in record.stages if stage_drives(end.stage)]


def _enlarged(record: Record) -> list[StageEnd]:
    """Return the driven stages that have axes of their own: all, or none of very many."""
    driven = _driven(record)
    return driven if len(driven) <= _MOST_CLOSE else []


def time_spans(record: Record) -> list[TimeSpan]:
    """Return the time axes of the columns: the whole run, then each driven stage."""
    whole = TimeSpan(start=0.0, scale=unit_of_run(record)[1])
    return [whole, *(TimeSpan(start=end.start, scale=_unit_of(end)[1], stage=end) for end in _enlarged(record))]


def _unit_of(end: StageEnd) -> tuple[str, float]:
    """Return the unit of the time axis of an enlarged stage, and its factor from s."""
    return ("s", 1.0) if end.stage.quasi_static else ("ms", 1e3)


def unit_of_run(record: Record) -> tuple[str, float]:
    """Return the unit of the whole run's time axis, and its factor from s."""
    return reading_unit("s", float(record.time[-1]))


def time_rows(record: Record, labels: list[str], width: float, height: float) -> tuple[Figure, list[list[Axes]]]:
    """Return for every label the axes of the whole run and of each stage; below each other if narrow."""
    driven, narrow = _enlarged(record), is_narrow(width)
    run_unit, run_scale = unit_of_run(record)
    figure = Figure(figsize=(width, 3.3 * len(labels) if narrow else height), layout="constrained")
    if narrow:
        rows = stacked_axes(figure, len(labels), len(driven))
    else:
        ratios = [_WHOLE] + [1.0] * len(driven)
        grid = figure.subplots(len(labels), len(ratios), sharey="row", squeeze=False, width_ratios=ratios)
        rows = [list(row) for row in grid]
    for row, label in zip(rows, labels, strict=True):
        row[0].set_ylabel(label)
        row[0].set_xlim(0, run_scale * max(float(record.time[-1]), float(record.design.protocol.timestep)))
        for axes, end in zip(row[1:], driven, strict=True):
            # then the stage holds its goal, or rests short of it, which takes long without motion
            moved = end.goal_time or still_time(record, end.start, end.end)
            scale = _unit_of(end)[1]
            duration = scale * min(end.end - end.start, _AFTER * (moved - end.start) or end.end - end.start)
            last = min((1 + LEAD) * duration, scale * (float(record.time[-1]) - end.start))
            axes.set_xlim(-LEAD * duration, last)
        if narrow or row is rows[-1]:
            row[0].set_xlabel(f"time ({run_unit})")
            _label_stages(row[1:], [_unit_of(end)[0] for end in driven])
    # a quantity is one panel: the whole run, and its stages enlarged
    letter_panels([row[0] for row in rows])
    return figure, rows


def _label_stages(row: list[Axes], units: list[str]) -> None:
    """Name the time axes of enlarged stages; of several narrow ones with the same unit together."""
    if len(row) <= _LABELLED:
        for axes, unit in zip(row, units, strict=True):
            axes.set_xlabel(f"time since its start ({unit})")
    elif len(set(units)) > 1:
        for axes, unit in zip(row, units, strict=True):
            axes.set_xlabel(f"since its start ({unit})")
    else:
        middle = (len(row) - 1) // 2
        row[middle].set_xlabel(f"time since the start of the stage ({units[0]})", x=0.5 if len(row) % 2 else _BETWEEN)


def fit_values(row: list[Axes], values: Array, least: float) -> None:
    """Set the common range of vertical axes to that of finite values, but at least a range; mark 0 if it is inside."""
    finite = values[np.isfinite(values)]
    low, high = (float(finite.min()), float(finite.max())) if finite.size else (0.0, 0.0)
    half = max((0.5 + _EXTRA) * (high - low), least / 2)
    row[0].set_ylim((low + high) / 2 - half, (low + high) / 2 + half)
    if abs(low + high) / 2 < half:
        for axes in row:
            axes.axhline(0, color="0.6", lw=0.5, zorder=0)


def stacked_axes(figure: Figure, count: int, stages: int) -> list[list[Axes]]:
    """Return axes for the whole run across the figure with its stages below, `count` times."""
    rows: list[list[Axes]] = []
    deep = 2 if stages else 1
    grid = figure.add_gridspec(deep * count, max(stages, 1))
    for place in range(count):
        whole = figure.add_subplot(grid[deep * place, :])
        close = [figure.add_subplot(grid[deep * place + 1, stage], sharey=whole) for stage in range(stages)]
        for axes in close[1:]:
            axes.tick_params(labelleft=False)
        rows.append([whole, *close])
    return rows


def row_legend(row: list[Axes], width: float, columns: int) -> None:
    """Draw the legend of the lines beside the axes, or above narrow axes; lines with numbers in their order."""
    handles, labels = row[0].get_legend_handles_labels()
    handles = [handles[place] for place in by_number(labels)]
    if is_narrow(width):
        above = {"bbox_to_anchor": (0, 1.14), "columnspacing": 1.2}
        fit_legend(row[0], handles, columns, room=width - _LABELS, loc="lower left", borderaxespad=0, **above)
    else:
        row[-1].legend(handles=handles, loc="upper left", bbox_to_anchor=(1.04, 1), borderaxespad=0)


def time_in(record: Record, span: TimeSpan) -> Array:
    """Return the times of a record on a time axis, (time,)."""
    return np.asarray((record.time - span.start) * span.scale)


def shade_stages(axes: Axes, record: Record, span: TimeSpan) -> None:
    """Draw grey bands where drives act, with the stages' names above.

    Where the names do not fit above the whole run, they are numbered, there and above the enlarged stages.
    """
    driven, (low, high) = _driven(record), axes.get_xlim()
    names = _stage_names(axes, record)
    numbered = any(name.isdigit() for name in names)
    for number, (end, name) in enumerate(zip(driven, names, strict=True), start=1):
        left, right = ((moment - span.start) * span.scale for moment in (end.start, end.end))
        # a white edge separates stages that follow one another
        axes.axvspan(left, right, facecolor="0.92", edgecolor="white", zorder=-1, lw=0.8)
        alone = (f"{number} " * numbered + end.stage.name + ", quasi-static" * end.stage.quasi_static) * (
            end is span.stage
        )
        words = name if span.stage is None else alone
        if words and max(left, low) < min(right, high):
            middle = (max(left, low) + min(right, high)) / 2
            place = axes.get_xaxis_transform()
            # a name at the left end would cover the letter of the panel
            side = "left" if middle - low < _EDGE * (high - low) else "center"
            axes.text(middle, 1.01, words, transform=place, ha=side, va="bottom", fontsize=7)


def _stage_names(axes: Axes, record: Record) -> list[str]:
    """Return the names of driven stages above the whole run; their numbers if the names do not fit, or some of them."""
    driven, figure = _driven(record), axes.get_figure(root=True)
    assert figure is not None
    width = figure.get_size_inches()[0]
    room = width - _LABELS - (0.0 if is_narrow(width) else _BESIDE)
    share = 1.0 if is_narrow(width) else _WHOLE / (_WHOLE + len(_enlarged(record)))
    scale = 72 * share * room / max(float(record.time[-1]), 1e-300)
    middles = [scale * (end.start + end.end) / 2 for end in driven]
    names = [end.stage.name for end in driven]
    if _apart(middles, names) == names:
        return names
    return _apart(middles, [str(number) for number in range(1, len(driven) + 1)])


def _apart(middles: list[float], words: list[str]) -> list[str]:
    """Return words with the middles of their places (pt); words that would overlap the one before become empty."""
    end, output = -np.inf, []
    for middle, word in zip(middles, words, strict=True):
        half = _LETTER * len(word) / 2
        fits = middle - half >= end + _SPACE
        output.append(word if fits else "")
        end = middle + half if fits else end
    return output


def mark_waits(axes: Axes, record: Record, span: TimeSpan) -> None:
    """Draw hatched bands with durations over waits; the axis shows only the simulated part of a wait."""
    for end in record.stages:
        left, right = ((moment - span.start) * span.scale for moment in (end.start, end.end))
        low, high = axes.get_xlim()
        if end.waited and max(left, low) < min(right, high):
            axes.axvspan(left, right, fc="none", ec="0.85", hatch="///", zorder=-1, lw=0)
            # above long waits there is space beside the names of stages
            if min(right, high) - max(left, low) > _ROOMY * (high - low):
                middle, text = (max(left, low) + min(right, high)) / 2, show_duration(end.waited)
                axes.text(
                    middle, 1.01, text, transform=axes.get_xaxis_transform(), ha="center", va="bottom", fontsize=7
                )
