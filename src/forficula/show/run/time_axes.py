"""Axes over the time of a run: the whole run, and its driven stages enlarged."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from forficula.arrays import Array
from forficula.design import stage_drives
from forficula.dynamics import Record, StageEnd
from forficula.quantities import reading_unit, show_duration
from forficula.show.run.missed_goal import still_time
from forficula.show.style import fit_legend, is_narrow

# time shown before and after a driven stage, as a share of it
LEAD = 0.15
# entries of a legend; more lines take the colours of a scale, in their order
MOST_ENTRIES = 8
_AFTER = 1.6  # time shown, as a multiple of the time until a stage reached its goal or came to rest
_ROOMY = 0.25  # share of a time axis above which words fit
_LABELS = 0.6  # inch, width of a vertical axis


def _driven(record: Record) -> list[StageEnd]:
    return [end for end in record.stages if stage_drives(end.stage)]


def time_spans(record: Record) -> list[tuple[float, float]]:
    """Return zero and scale of every column's time axis: the whole run, then each driven stage in ms."""
    return [(0.0, unit_of_run(record)[1])] + [(end.start, 1e3) for end in _driven(record)]


def unit_of_run(record: Record) -> tuple[str, float]:
    """Return the unit of the whole run's time axis, and its factor from s."""
    return reading_unit("s", float(record.time[-1]))


def time_rows(record: Record, labels: list[str], width: float, height: float) -> tuple[Figure, list[list[Axes]]]:
    """Return for every label the axes of the whole run and of each stage; below each other if narrow."""
    driven, narrow = _driven(record), is_narrow(width)
    run_unit, run_scale = unit_of_run(record)
    figure = Figure(figsize=(width, 3.3 * len(labels) if narrow else height), layout="constrained")
    if narrow:
        rows = stacked_axes(figure, len(labels), len(driven))
    else:
        ratios = [1.5] + [1.0] * len(driven)
        grid = figure.subplots(len(labels), len(ratios), sharey="row", squeeze=False, width_ratios=ratios)
        rows = [list(row) for row in grid]
    for row, label in zip(rows, labels, strict=True):
        row[0].set_ylabel(label)
        row[0].set_xlim(0, run_scale * max(float(record.time[-1]), float(record.design.protocol.timestep)))
        for axes, end in zip(row[1:], driven, strict=True):
            # then the stage holds its goal, or rests short of it, which takes long without motion
            moved = end.goal_time or still_time(record, end.start, end.end)
            duration = 1e3 * min(end.end - end.start, _AFTER * (moved - end.start) or end.end - end.start)
            axes.set_xlim(-LEAD * duration, (1 + LEAD) * duration)
        if narrow or row is rows[-1]:
            row[0].set_xlabel(f"time ({run_unit})")
            for axes in row[1:]:
                axes.set_xlabel("since its start (ms)" if narrow else "time since its start (ms)")
    return figure, rows


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
    """Draw the legend of some or all lines beside the axes, or above narrow axes."""
    handles = row[0].get_legend_handles_labels()[0]
    if len(handles) > MOST_ENTRIES:
        places = np.linspace(0, len(handles) - 1, MOST_ENTRIES - 1).round().astype(int)
        others = Line2D([], [], ls="none", label=f"and {len(handles) - len(places)} others")
        handles, columns = [*(handles[place] for place in places), others], min(columns, 3)
    if is_narrow(width):
        above = {"bbox_to_anchor": (0, 1.14), "columnspacing": 1.2}
        fit_legend(row[0], handles, columns, room=width - _LABELS, loc="lower left", borderaxespad=0, **above)
    else:
        row[-1].legend(handles=handles, loc="upper left", bbox_to_anchor=(1.04, 1), borderaxespad=0)


def time_in(record: Record, start: float, scale: float) -> Array:
    """Return the times of a record since a start, s, in the scale of an axis, (time,)."""
    return np.asarray((record.time - start) * scale)


def shade_stages(axes: Axes, record: Record, start: float, scale: float) -> None:
    """Draw grey bands where torques act, with the stage's name above."""
    for end in _driven(record):
        left, right = ((moment - start) * scale for moment in (end.start, end.end))
        axes.axvspan(left, right, color="0.92", zorder=-1, lw=0)
        low, high = axes.get_xlim()
        seen = (max(left, low) + min(right, high)) / 2
        if max(left, low) < min(right, high):
            place = axes.get_xaxis_transform()
            axes.text(seen, 1.01, end.stage.name, transform=place, ha="center", va="bottom", fontsize=7)


def mark_waits(axes: Axes, record: Record, start: float, scale: float) -> None:
    """Draw hatched bands with durations over waits; the axis shows only the simulated part of a wait."""
    for end in record.stages:
        left, right = ((moment - start) * scale for moment in (end.start, end.end))
        low, high = axes.get_xlim()
        if end.waited and max(left, low) < min(right, high):
            axes.axvspan(left, right, fc="none", ec="0.85", hatch="///", zorder=-1, lw=0)
            # above long waits there is space beside the names of stages
            if min(right, high) - max(left, low) > _ROOMY * (high - low):
                middle, text = (max(left, low) + min(right, high)) / 2, show_duration(end.waited)
                axes.text(
                    middle, 1.01, text, transform=axes.get_xaxis_transform(), ha="center", va="bottom", fontsize=7
                )
