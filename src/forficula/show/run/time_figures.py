"""Distal angles and energies over time: the whole run, and folding and unfolding close up."""

from __future__ import annotations

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from forficula.analysis import Outcome
from forficula.dynamics import Record, StageEnd
from forficula.quantities import reading_unit, show_value
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
    describe,
    figure_style,
    is_narrow,
)

Array = NDArray[np.float64]

_VEIN_COLOURS = (BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY, BLACK)
# before and after a driven stage, as a share of it
_LEAD = 0.15


def draw_angles(record: Record, outcome: Outcome, width: float = PAGE_WIDTH) -> Figure:
    """Draw the distal angles over time with the three states marked, in a figure of a width in inch."""
    with figure_style():
        figure, rows = _layout(record, ["distal angle (deg)"], width, height=2.5)
        for axes, (start, scale) in zip(rows[0], _spans(record), strict=True):
            time = _time(record, start, scale)
            for vein, angle in enumerate(np.degrees(record.data["distal_angle"].values.T)):
                axes.plot(time, angle, _line(vein), color=_colour(vein), label=f"vein {vein}")
            axes.axhline(0, color="0.6", lw=0.5, zorder=0)
            axes.set_ylim(-200, max(25, 1.2 * np.degrees(record.design.hinge.overbend)))
            axes.set_yticks(np.arange(-180, 1, 45))
            _shade_stages(axes, record, start, scale)
        _mark_states(rows[0][0], outcome, _run_unit(record)[1])
        _legend(rows[0], width, columns=4)
        return describe(figure, _tell_angles(record, outcome))


def draw_energies(record: Record, width: float = PAGE_WIDTH) -> Figure:
    """Draw stored energies over time, and under them the work done and where it went; the width is in inch."""
    tables = {"stored energy": _stored(record), "work since the start": _accounts(record)}
    with figure_style():
        figure, rows = _layout(record, list(tables), width, height=4.4)
        for axes_row, (label, series) in zip(rows, tables.items(), strict=True):
            unit, factor = reading_unit("J", max(float(np.abs(values).max()) for values, _ in series.values()))
            axes_row[0].set_ylabel(f"{label} ({unit})")
            for axes, (start, scale) in zip(axes_row, _spans(record), strict=True):
                for index, (name, (values, colour)) in enumerate(series.items()):
                    style = LINE_STYLES[index % len(LINE_STYLES)]
                    axes.plot(_time(record, start, scale), values * factor, style, color=colour, label=name)
                _shade_stages(axes, record, start, scale)
            _legend(axes_row, width, columns=3 if len(series) == 3 else 2)
        return describe(figure, _tell_energies(record))


def _stored(record: Record) -> dict[str, tuple[Array, str]]:
    """Energies by what stores them, J, (time,), and their colours."""
    series = record.series
    stored = {
        "tendons": (series["tendon_energy"].sum(axis=1), BLUE),
        "membrane": (series["membrane_energy"], ORANGE),
        "kinetic": (series["kinetic_energy"], VERMILION),
    }
    if "branch_energy" in series:
        stored["Maxwell branches"] = (series["branch_energy"].sum(axis=1), GREEN)
    if record.design.protocol.gravity:
        stored["gravitational"] = (series["gravitational_energy"], PURPLE)
    return stored


def _accounts(record: Record) -> dict[str, tuple[Array, str]]:
    """The work done and where it went, J, (time,), and their colours."""
    series = record.series
    accounts = {
        "done by torques": (series["proximal_work"] + series["distal_work"], BLACK),
        "taken by hinge damping": (-series["hinge_damping_work"], GREEN),
        "taken by stops": (-series["stop_work"], VERMILION),
        "taken by other damping": (-series["elastic_damping_work"], SKY),
    }
    for name, words, colour in (
        ("branch_damping_work", "taken by Maxwell branches", ORANGE),
        ("letting_go_work", "branches that gave way", PURPLE),
        ("yield_work", "taken by yielding", PURPLE),
    ):
        if name in series:
            accounts[words] = (-series[name], colour)
    return accounts


def _tell_angles(record: Record, outcome: Outcome) -> str:
    """What the angles do, in words."""
    states = {
        outcome.flat_name: outcome.flat,
        outcome.folded_name: outcome.folded_state,
        outcome.opened_name: outcome.opened_state,
    }
    told = [
        f"{name} {np.degrees(state.distal_angle.mean()):.1f} deg at {show_value(state.time, 's')}"
        for name, state in states.items()
        if state is not None
    ]
    veins = record.series["distal_angle"].shape[1]
    means = f" Means over the veins: {', '.join(told)}." if told else ""
    return f"Distal angles of {veins} veins over the time of a run of {record.design.name}: {outcome.status}.{means}"


def _tell_energies(record: Record) -> str:
    """What the energies come to, in words."""
    largest = ", ".join(
        f"{name} {show_value(float(values.max()), 'J')}" for name, (values, _) in _stored(record).items()
    )
    work = show_value(float(_accounts(record)["done by torques"][0][-1]), "J")
    name = record.design.name
    return (
        f"Stored energies and work over the time of a run of {name}. Largest: {largest}; work of the torques: {work}."
    )


def _driven(record: Record) -> list[StageEnd]:
    return [end for end in record.stages if end.stage.drive != "none"]


def _spans(record: Record) -> list[tuple[float, float]]:
    """Zero and scale of every column's time axis: the whole run, then each driven stage in ms."""
    return [(0.0, _run_unit(record)[1])] + [(end.start, 1e3) for end in _driven(record)]


def _run_unit(record: Record) -> tuple[str, float]:
    """The unit of the whole run's time axis, and its factor from s."""
    return reading_unit("s", float(record.time[-1]))


def _layout(record: Record, labels: list[str], width: float, height: float) -> tuple[Figure, list[list[Axes]]]:
    """For every label the axes of the whole run and of each driven stage: beside it, or beneath where it is narrow."""
    driven, narrow = _driven(record), is_narrow(width)
    run_unit, run_scale = _run_unit(record)
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
            # the stage holds its goal for a while, in which little happens
            duration = 1e3 * min(end.end - end.start, 1.6 * ((end.goal_time or end.end) - end.start))
            axes.set_xlim(-_LEAD * duration, (1 + _LEAD) * duration)
        if narrow or row is rows[-1]:
            row[0].set_xlabel(f"time ({run_unit})")
            for axes in row[1:]:
                axes.set_xlabel("since its start (ms)" if narrow else "time since its start (ms)")
    return figure, rows


def stacked_axes(figure: Figure, count: int, stages: int) -> list[list[Axes]]:
    """The whole run across the figure and its stages beneath, `count` times."""
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


def _legend(row: list[Axes], width: float, columns: int) -> None:
    """What the lines are, beside the axes, or above them where these are narrow."""
    if is_narrow(width):
        row[0].legend(loc="lower left", bbox_to_anchor=(0, 1.14), ncols=columns, borderaxespad=0, columnspacing=1.2)
    else:
        row[-1].legend(loc="upper left", bbox_to_anchor=(1.04, 1), borderaxespad=0)


def _time(record: Record, start: float, scale: float) -> np.ndarray:
    return np.asarray((record.time - start) * scale)


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
