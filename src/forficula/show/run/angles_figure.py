"""Angles and distances over time; for a missed goal, also the driving torque."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from forficula.analysis import Outcome
from forficula.arrays import Array
from forficula.design import stage_drives
from forficula.dynamics import Record, StageEnd
from forficula.quantities import reading_unit, show_value
from forficula.show.run.missed_goal import stalled_stage
from forficula.show.run.outcome_rows import state_angles
from forficula.show.run.state_names import state_letters
from forficula.show.run.time_axes import (
    LEAD,
    MOST_ENTRIES,
    mark_waits,
    row_legend,
    shade_stages,
    time_in,
    time_rows,
    time_spans,
    unit_of_run,
)
from forficula.show.structure.labels import (
    counted,
    driven_angles,
    measure_labels,
    median,
    role_groups,
    shown_angles,
    shown_distances,
    title_of,
)
from forficula.show.style import (
    BLACK,
    BLUE,
    GREEN,
    LINE_STYLES,
    ORANGE,
    PAGE_WIDTH,
    PURPLE,
    QUANTITY_COLOURS,
    SKY,
    VERMILION,
    describe,
    figure_style,
)
from forficula.statics.slow_margin import LARGEST_TORQUE_FACTOR
from forficula.structure import Drive, Measure, Structure, drive_of, drive_unit, measure_stops

_COLOURS = (BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY, BLACK)
_LEAST_SEEN = 0.05  # deg, least half range of an axis: smaller changes are rounding errors
# range of an axis of angles to one side, deg, if hinges exceed a right angle; its least; its ratio to the stops
_HALF_TURN, _LEAST_ROOM, _ROOM = 200.0, 25.0, 1.2
_SHORTEST = 7  # letters of a label; four labels of this length fit into a row of a column
_STEPS, _MOST_STEPS = (5, 10, 15, 30, 45, 90), 6


def draw_angles(
    record: Record, outcome: Outcome, width: float = PAGE_WIDTH, needed: Callable[[], float | None] = lambda: None
) -> Figure:
    """Draw angles and distances over time with the states marked.

    For a run that missed a goal, also the angles on which motors act, enlarged, and the driving torque beside the least
    sufficient one.

    Args:
        record: the simulated motion.
        outcome: the outcome of the run.
        width: width of the figure, inch.
        needed: returns that least torque, N m: nan if no torque suffices, None if it is not known.
    """
    stalled, structure = stalled_stage(record), record.structure
    rows_of = _readings(structure)
    if stalled is not None:
        present = [measure for measures in rows_of for measure in measures]
        rows_of = [(measure,) for measure in driven_angles(structure, present) if measure not in present] + rows_of
    with figure_style():
        labels = [_row_label(record, measures) for measures in rows_of]
        drives = [] if stalled is None else [drive_of(structure, name) for name in stage_drives(stalled.stage)]
        torques = drives if all(drive_unit(structure, drive) == "N m" for drive in drives) else []
        if torques:
            least = needed()
            unit, factor = reading_unit("N m", max(abs(drive.strength) for drive in torques))
            labels.append(f"torque ({unit})")
        figure, rows = time_rows(
            record, labels, width, height=2.5 if len(labels) == 1 else (2.2 if stalled is None else 1.7) * len(labels)
        )
        for axes_row, measures in zip(rows, rows_of, strict=False):
            lines = _lines(record, measures)
            for axes, (start, scale) in zip(axes_row, time_spans(record), strict=True):
                time = time_in(record, start, scale)
                if role_groups(record.structure, measures[0]):
                    _draw_many(axes, time, record, measures[0])
                else:
                    for line, (name, values) in enumerate(lines.items()):
                        axes.plot(time, values, **_look(line, len(lines)), label=name)
                if measures[0].kind == "angle":
                    _scale_degrees(axes, record, measures, stalled)
                axes.axhline(0, color="0.6", lw=0.5, zorder=0)
                shade_stages(axes, record, start, scale)
                mark_waits(axes, record, start, scale)
            if list(lines) != [title_of(measures[0])]:
                row_legend(axes_row, width, columns=4 if max(map(len, lines), default=0) <= _SHORTEST else 3)
        if torques and stalled is not None:
            for axes, (start, scale) in zip(rows[-1], time_spans(record), strict=True):
                _draw_torques(axes, record, stalled, torques, least, (start, scale, factor))
            row_legend(rows[-1], width, columns=2)
        if rows_of:
            _mark_states(rows[0][0], record, outcome, rows_of[0], unit_of_run(record)[1])
        return describe(figure, _angles_text(record, outcome))


def _readings(structure: Structure) -> list[tuple[Measure, ...]]:
    """Return the measures of each row: those of several hinges alone, those of single hinges together, distances."""
    angles, distances = shown_angles(structure), shown_distances(structure)
    rows = [(measure,) for measure in angles if len(measure.parts) > 1]
    single = tuple(measure for measure in angles if len(measure.parts) == 1)
    return [*rows, *(group for group in (single, distances) if group)]


def _row_label(record: Record, measures: tuple[Measure, ...]) -> str:
    kind, alone = measures[0].kind, len(measures) == 1
    unit = "deg" if kind == "angle" else _length_unit(record, measures)[0]
    return f"{title_of(measures[0]) if alone else kind} ({unit})"


def _length_unit(record: Record, measures: tuple[Measure, ...]) -> tuple[str, float]:
    every = [np.abs(record.measured(measure.name)).max(initial=0.0) for measure in measures]
    return reading_unit("m", float(np.nanmax([*every, 0.0])) or record.structure.span)


def _lines(record: Record, measures: tuple[Measure, ...]) -> dict[str, Array]:
    """Return the lines of a row in its unit, (time,), by name."""
    factor = _length_unit(record, measures)[1]
    lines: dict[str, Array] = {}
    for measure in measures:
        values = record.measured(measure.name).T
        scaled = np.degrees(values) if measure.kind == "angle" else factor * values
        alone = len(scaled) == 1 and len(measures) > 1
        names = [title_of(measure)] if alone else measure_labels(record.structure, measure)
        lines |= dict(zip(names, scaled, strict=True))
    return lines


def _draw_many(axes: Axes, time: Array, record: Record, measure: Measure) -> None:
    """Draw many angles by role: every angle thin, and their median."""
    values, groups = np.degrees(record.measured(measure.name)), role_groups(record.structure, measure)
    for number, (role, indices) in enumerate(groups.items()):
        look, role_values = _look(number, len(groups)), values[:, indices]
        # one line with gaps draws faster than many lines
        lines = np.vstack([role_values, np.full(len(indices), np.nan)]).T.ravel()
        axes.plot(np.tile([*time, np.nan], len(indices)), lines, color=look["color"], lw=0.5, alpha=0.35)
        axes.plot(time, median(role_values), **look, lw=1.6, label=f"{role} ({len(indices)}), median")


def _draw_torques(
    axes: Axes,
    record: Record,
    stalled: StageEnd,
    drives: Sequence[Drive],
    least: float | None,
    scales: tuple[float, float, float],
) -> None:
    """Draw the torques of a driven stage, and the least torque that would have reached its goal."""
    start, scale, factor = scales
    first = np.nextafter(stalled.start, stalled.end)
    time = np.sort([*record.time, stalled.start, first, stalled.end])
    acts = (time >= first) & (time <= stalled.end)
    highest = max(abs(drive.strength) for drive in drives)
    for drive in drives:
        risen = np.clip((time - stalled.start) / drive.rise, 0, 1) if drive.rise > 0 else 1.0
        torque = np.where(acts, factor * abs(drive.strength) * risen, 0.0)
        axes.plot((time - start) * scale, torque, color=BLACK, label=f"acting {drive.where}".rstrip())
    if least is not None and np.isfinite(least):
        axes.axhline(factor * least, color=VERMILION, ls="--", label="least slow torque")
        highest = max(highest, least)
    elif least is not None:
        tried = show_value(LARGEST_TORQUE_FACTOR * abs(drives[0].strength), "N m", 3)
        axes.plot([], [], ls="none", label=f"no slow torque up to {tried} suffices")
    axes.set_ylim(0, 1.2 * factor * highest or 1.0)
    shade_stages(axes, record, start, scale)


def _scale_degrees(axes: Axes, record: Record, measures: tuple[Measure, ...], stalled: StageEnd | None) -> None:
    """Set the range of angles from stop to stop, limited to what half a turn needs.

    If a stage missed its goal, only the range of its motion.
    """
    low, high = (_room(record, measures, side) for side in (-1, 1))
    if stalled is not None:
        rows = record.time >= stalled.start
        seen = np.degrees(np.concatenate([record.measured(measure.name)[rows].ravel() for measure in measures]))
        middle, half = (seen.max() + seen.min()) / 2, max(_LEAST_SEEN, (0.5 + LEAD) * np.ptp(seen))
        if 2 * half < low + high:
            axes.set_ylim(middle - half, middle + half)
            return
    axes.set_ylim(-low, high)
    step = next(step for step in _STEPS if low + high <= _MOST_STEPS * step)
    axes.set_yticks(np.arange(-step * (low // step), high, step))


def _room(record: Record, measures: tuple[Measure, ...], side: int) -> float:
    """Return the range of an axis of angles to one side, deg: beyond all stops, or beyond all angles without stops."""
    reach = 0.0
    for measure in measures:
        angles = side * record.measured(measure.name)
        seen = angles.max(axis=0, initial=0.0, where=np.isfinite(angles))
        for (low, high), most in zip(measure_stops(record.structure, measure), seen, strict=True):
            stop = high if side > 0 else -low
            reach = max(reach, float(np.degrees(min(stop, np.pi) if np.isfinite(stop) else min(most, np.pi))))
    return _HALF_TURN if reach > _HALF_TURN / 2 else max(_LEAST_ROOM, _ROOM * reach)


def _angles_text(record: Record, outcome: Outcome) -> str:
    """Describe the angles."""
    structure, means = record.structure, []
    first = next(iter(shown_angles(structure)), None)
    for name, state in outcome.states.items():
        if state is not None and first is not None:
            mean = np.degrees(state_angles(state, first).mean())
            means.append(f"{outcome.state_names[name]} {mean:.1f} deg at {show_value(state.time, 's')}")
    hinges = [] if first is None else measure_labels(structure, first)
    over_hinges = f" Means over the {counted(hinges, 'hinge').partition(' ')[2]}: {', '.join(means)}." if means else ""
    what = "Angles" if first is None else f"{title_of(first)[:1].upper()}{title_of(first)[1:]}s"
    run = f"time in a run of {record.design.name}: {outcome.status}."
    return f"{what} of {counted(hinges, 'hinge')} over {run}{over_hinges}"


def _mark_states(axes: Axes, record: Record, outcome: Outcome, measures: tuple[Measure, ...], scale: float) -> None:
    """Mark the states with letters, at the mean reading of the first measure; missed states have no mark."""
    measure = measures[0]
    for name, letter in state_letters(record.structure).items():
        state = outcome.states[name]
        if state is None or outcome.holds.get(name, True) is not True:
            continue
        if measure.kind == "angle":
            angles = np.degrees(state_angles(state, measure))
            value = float(median(angles) if role_groups(record.structure, measure) else angles.mean())
        else:
            value = _length_unit(record, measures)[1] * float(state.readings[measure.name].mean[0])
        time = scale * state.time
        axes.plot(time, value, "o", color="white", mec="black", mew=0.8, ms=9, zorder=5, clip_on=False)
        axes.text(time, value, letter, ha="center", va="center_baseline", fontsize=7, zorder=6)


def _look(line: int, count: int) -> dict[str, Any]:
    """Return the colour and style of a line."""
    if count > MOST_ENTRIES:
        return {"color": QUANTITY_COLOURS(0.9 * line / (count - 1)), "lw": 0.8}
    return {"color": _COLOURS[line % len(_COLOURS)], "ls": LINE_STYLES[line % len(LINE_STYLES)]}
