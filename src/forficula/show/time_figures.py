"""Distal angles and energies over time: the whole run, and folding and unfolding close up."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from forficula.analysis import Outcome
from forficula.dynamics import Record, StageEnd
from forficula.quantities import reading_unit
from forficula.show.style import (
    BLACK,
    BLUE,
    GREEN,
    LINE_STYLES,
    ORANGE,
    PAGE_WIDTH,
    PURPLE,
    SKY,
    VERMILION,
    figure_style,
)

_VEIN_COLOURS = (BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY, BLACK)
# before and after a driven stage, as a share of it
_LEAD = 0.15


def draw_angles(record: Record, outcome: Outcome) -> Figure:
    """Draw the distal angles over time with the three states marked."""
    with figure_style():
        figure, rows = _layout(record, ["distal angle (deg)"], height=2.7)
        for axes, (start, scale) in zip(rows[0], _spans(record), strict=True):
            time = _time(record, start, scale)
            for vein, angle in enumerate(np.degrees(record.data["distal_angle"].values.T)):
                axes.plot(time, angle, _line(vein), color=_colour(vein), label=f"vein {vein}")
            axes.axhline(0, color="0.6", lw=0.5, zorder=0)
            axes.set_ylim(-200, max(25, 1.2 * np.degrees(record.design.hinge.overbend)))
            axes.set_yticks(np.arange(-180, 1, 45))
            _shade_stages(axes, record, start, scale)
        _mark_states(rows[0][0], outcome, _run_unit(record)[1])
        figure.legend(*rows[0][0].get_legend_handles_labels(), loc="outside right upper")
        return figure


def draw_energies(record: Record) -> Figure:
    """Draw stored energies over time, and under them the work done and where it went."""
    data = record.data
    stored = {
        "tendons": (data["tendon_energy"].sum("vein"), BLUE),
        "membrane": (data["membrane_energy"], ORANGE),
        "kinetic": (data["kinetic_energy"], VERMILION),
    }
    if "branch_energy" in data:
        stored["tendons, Maxwell branches"] = (data["branch_energy"].sum("vein"), GREEN)
    if record.design.protocol.gravity:
        stored["gravitational"] = (data["gravitational_energy"], PURPLE)
    accounts = {
        "done by torques": (data["proximal_work"] + data["distal_work"], BLACK),
        "taken by hinge damping": (-data["hinge_damping_work"], GREEN),
        "taken by stops": (-data["stop_work"], VERMILION),
        "taken by other damping": (-data["elastic_damping_work"], SKY),
    }
    if "branch_damping_work" in data:
        accounts["taken by Maxwell branches"] = (-data["branch_damping_work"], ORANGE)
    if "letting_go_work" in data:
        accounts["branches that gave way"] = (-data["letting_go_work"], PURPLE)
    if "yield_work" in data:
        accounts["taken by yielding"] = (-data["yield_work"], PURPLE)
    with figure_style():
        figure, rows = _layout(record, ["stored energy", "work since the start"], height=4.4)
        for axes_row, series, label in zip(
            rows, (stored, accounts), ("stored energy", "work since the start"), strict=True
        ):
            unit, factor = reading_unit("J", max(float(np.abs(values).max()) for values, _ in series.values()))
            axes_row[0].set_ylabel(f"{label} ({unit})")
            for axes, (start, scale) in zip(axes_row, _spans(record), strict=True):
                for index, (name, (values, colour)) in enumerate(series.items()):
                    style = LINE_STYLES[index % len(LINE_STYLES)]
                    axes.plot(_time(record, start, scale), values * factor, style, color=colour, label=name)
                _shade_stages(axes, record, start, scale)
            axes_row[min(1, len(axes_row) - 1)].legend(loc="best")
        return figure


def _driven(record: Record) -> list[StageEnd]:
    return [end for end in record.stages if end.stage.drive != "none"]


def _spans(record: Record) -> list[tuple[float, float]]:
    """Zero and scale of every column's time axis: the whole run, then each driven stage in ms."""
    return [(0.0, _run_unit(record)[1])] + [(end.start, 1e3) for end in _driven(record)]


def _run_unit(record: Record) -> tuple[str, float]:
    """The unit of the whole run's time axis, and its factor from s."""
    return reading_unit("s", float(record.data.time[-1]))


def _layout(record: Record, labels: list[str], height: float) -> tuple[Figure, list[list[Axes]]]:
    """Axes by row and column; columns are the whole run and each driven stage."""
    driven = _driven(record)
    run_unit, run_scale = _run_unit(record)
    figure = Figure(figsize=(PAGE_WIDTH, height), layout="constrained")
    grid = figure.subplots(
        len(labels), 1 + len(driven), sharey="row", squeeze=False, width_ratios=[1.5] + [1.0] * len(driven)
    )
    for row, label in zip(grid, labels, strict=True):
        row[0].set_ylabel(label)
    for axes in grid[:, 0]:
        axes.set_xlim(0, run_scale * float(record.data.time[-1]))
    for column, end in enumerate(driven, start=1):
        for axes in grid[:, column]:
            # the stage holds its goal for a while, in which little happens
            duration = 1e3 * min(end.end - end.start, 1.6 * ((end.goal_time or end.end) - end.start))
            axes.set_xlim(-_LEAD * duration, (1 + _LEAD) * duration)
        grid[-1, column].set_xlabel("time since its start (ms)")
    grid[-1, 0].set_xlabel(f"time ({run_unit})")
    return figure, [list(row) for row in grid]


def _time(record: Record, start: float, scale: float) -> np.ndarray:
    return np.asarray((record.data.time.values - start) * scale)


def _shade_stages(axes: Axes, record: Record, start: float, scale: float) -> None:
    """Grey bands where torques act, with the stage's name above."""
    for end in _driven(record):
        left, right = ((moment - start) * scale for moment in (end.start, end.end))
        axes.axvspan(left, right, color="0.92", zorder=-1, lw=0)
        low, high = axes.get_xlim()
        seen = (max(left, low) + min(right, high)) / 2
        if max(left, low) < min(right, high):
            place = axes.get_xaxis_transform()
            axes.text(seen, 1.01, end.stage.name, transform=place, ha="center", va="bottom", fontsize=7)


def _mark_states(axes: Axes, outcome: Outcome, scale: float) -> None:
    reached = {
        "a": outcome.flat,
        "b": outcome.folded_state if outcome.folded else None,
        "c": outcome.opened_state if outcome.opened else None,
    }
    for letter, state in reached.items():
        if state is not None:
            angle = float(np.degrees(state.distal_angle.mean()))
            time = scale * state.time
            axes.plot(time, angle, "o", color="white", mec="black", mew=0.8, ms=9, zorder=5, clip_on=False)
            axes.text(time, angle, letter, ha="center", va="center_baseline", fontsize=7, zorder=6)


def _colour(vein: int) -> str:
    return _VEIN_COLOURS[vein % len(_VEIN_COLOURS)]


def _line(vein: int) -> str:
    return LINE_STYLES[vein % len(LINE_STYLES)]
