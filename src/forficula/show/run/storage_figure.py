"""Pull of tendons while a structure waits, over hours and days."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import FixedLocator, NullLocator

from forficula.analysis.storage import storages
from forficula.dynamics import Record
from forficula.quantities import reading_unit, show_duration
from forficula.show.structure.labels import label_of
from forficula.show.style import (
    BLUE,
    GREEN,
    LINE_STYLES,
    ORANGE,
    PAGE_WIDTH,
    VERMILION,
    describe,
    figure_style,
    is_narrow,
    letter_panels,
)

_COLOURS = (BLUE, VERMILION, GREEN, ORANGE)
# s, marks of a scale from seconds to years
_MARKS = (1.0, 60.0, 3600.0, 86400.0, 30 * 86400.0, 365 * 86400.0, 3650 * 86400.0)
_SHORTEST = 0.1  # s, start of the scale
_MOST_LINES = 8


def draw_storage(record: Record, width: float = PAGE_WIDTH) -> Figure:
    """Draw the pull of the tendons over every wait on a scale from seconds to years; the width is in inches."""
    waits = [storage for storage in storages(record) if storage.pulls is not None]
    with figure_style():
        narrow = is_narrow(width)
        shape = (len(waits), 1) if narrow else (1, len(waits))
        figure = Figure(figsize=(width, 2.2 * shape[0] + 0.2), layout="constrained")
        grid = np.ravel(figure.subplots(*shape, sharey=True, squeeze=False))
        pulls = [wait.pulls for wait in waits if wait.pulls is not None]
        unit, factor = reading_unit("N", max(float(pull.max()) for pull in pulls))
        for axes, wait, pull in zip(grid, waits, pulls, strict=True):
            clock = np.maximum(wait.clock, _SHORTEST)
            tendons = record.structure.tendons[:_MOST_LINES]
            for number, tendon in enumerate(tendons):
                style, colour = LINE_STYLES[number % 4], _COLOURS[number % 4]
                axes.plot(clock, factor * pull[:, number], style, color=colour, label=label_of(tendon))
            axes.set_xscale("log")
            axes.set_xlim(_SHORTEST, clock[-1])
            marks = [mark for mark in _MARKS if _SHORTEST <= mark <= clock[-1]]
            axes.xaxis.set_major_locator(FixedLocator(marks))
            axes.xaxis.set_minor_locator(NullLocator())
            axes.set_xticklabels([show_duration(mark) for mark in marks])
            if wait.slack:
                axes.text(0.5, 0.5, "slack", transform=axes.transAxes, ha="center", va="center", color="0.35")
            axes.set_title(f"{wait.name}: {show_duration(wait.time)}", pad=3)
            if not narrow or axes is grid[-1]:
                axes.set_xlabel("time at rest")
        for axes in grid if narrow else grid[:1]:
            axes.set_ylabel(f"pull ({unit})")
        grid[0].set_ylim(bottom=0)
        letter_panels(grid.tolist())
        grid[-1].legend(loc="best")
        sums = [[f"{factor * float(row.sum()):.4g}" for row in pull[[0, -1]]] for pull in pulls]
        changes = "; ".join(
            f"{wait.name}, {show_duration(wait.time)}: {first} to {last} {unit}"
            for wait, (first, last) in zip(waits, sums, strict=True)
        )
        return describe(
            figure, f"Pull of the tendons while {record.design.name} waits; sums over all tendons: {changes}."
        )
