"""Angles over time that were measured in a film: figure and text."""

from __future__ import annotations

import math

from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from rich.console import Console, Group, RenderableType
from rich.table import Table
from rich.text import Text

from forficula.goals.clicks.motion import ObservedMotion
from forficula.quantities import reading_unit, show_value
from forficula.show.structure.crease_lines import add_sheet_legend
from forficula.show.style import BLACK, BLUE, GREEN, PAGE_WIDTH, PURPLE, VERMILION, describe, figure_style

_COLOURS = (BLUE, VERMILION, GREEN, PURPLE)
_WIDEST = 5.2  # inch


def draw_motion(motion: ObservedMotion, width: float = PAGE_WIDTH) -> Figure:
    """Draw every angle over time with its standard uncertainty, and the passages that are facts.

    Args:
        motion: angles over time.
        width: largest width of the figure, inch.
    """
    unit, factor = reading_unit("s", max(abs(time) for angle in motion.angles for time in angle.times))
    with figure_style():
        wide = min(width, _WIDEST)
        figure = Figure(figsize=(wide, 0.62 * wide), layout="constrained")
        axes = figure.subplots()
        handles = []
        for number, angle in enumerate(motion.angles):
            look = {"color": _COLOURS[number % len(_COLOURS)], "marker": "o", "ms": 2.0, "lw": 0.8}
            axes.errorbar(
                [factor * time for time in angle.times],
                [math.degrees(value) for value in angle.angles],
                yerr=[math.degrees(value) for value in angle.deviations],
                capsize=2,
                **look,  # type: ignore[arg-type]
            )
            handles.append(Line2D([], [], label=f"{angle.name}, by {angle.method}", **look))  # type: ignore[arg-type]
        if motion.passages:
            axes.errorbar(
                [factor * passage.time for passage in motion.passages],
                [math.degrees(passage.angle) for passage in motion.passages],
                xerr=[factor * passage.tolerance for passage in motion.passages],
                fmt="o",
                ms=7,
                mfc="none",
                color=BLACK,
                capsize=3,
                lw=1.2,
                zorder=4,
            )
            look = {"marker": "o", "ms": 7, "mfc": "none", "color": BLACK, "lw": 1.2}
            handles.append(Line2D([], [], label="fact, with its tolerance", **look))  # type: ignore[arg-type]
        axes.set(xlabel=f"time from the start of the drive ({unit})", ylabel="angle (deg)")
        add_sheet_legend(figure, handles, 3)
        return describe(
            figure,
            f"Angles over time in {motion.name or 'a film'}. {len(motion.passages)} passages are facts about the"
            f" transition {motion.transition} of {motion.design}.",
        )


def print_motion(motion: ObservedMotion) -> None:
    """Print angles over time."""
    Console(width=110, highlight=False).print(motion_table(motion))


def motion_table(motion: ObservedMotion) -> RenderableType:
    """Return the angles over time, the facts, and the remarks on the view."""
    count = len(motion.angles[0].times)
    heading = (
        f"{motion.name or 'film'}: {count} pictures of {motion.design}, transition {motion.transition};"
        f" {len(motion.passages)} facts"
    )
    table = Table(box=None, padding=(0, 2, 0, 0))
    table.add_column("time")
    for angle in motion.angles:
        table.add_column(f"{angle.name}, by {angle.method}")
    for frame in range(count):
        cells = [
            f"{math.degrees(angle.angles[frame]):.2f} ± {math.degrees(angle.deviations[frame]):.2f} deg"
            for angle in motion.angles
        ]
        table.add_row(show_value(motion.angles[0].times[frame], "s"), *cells)
    facts = Table(box=None, padding=(0, 2, 0, 0))
    for column in ("fact", "passes", "time", "tolerance"):
        facts.add_column(column)
    for passage in motion.passages:
        facts.add_row(
            passage.name,
            show_value(passage.angle, "rad"),
            show_value(passage.time, "s"),
            show_value(passage.tolerance, "s", 2),
        )
    parts: list[RenderableType] = [Text(heading, style="bold"), Text(), table]
    if motion.passages:
        parts += [Text(), facts]
    return Group(*parts, Text(), *map(Text, motion.remarks))
