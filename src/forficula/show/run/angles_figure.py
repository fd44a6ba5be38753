"""Angles and distances over time; for a missed goal, also the driving torque."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from forficula.analysis import Outcome
from forficula.arrays import Array
from forficula.design import stage_drives
from forficula.dynamics import Record, StageEnd
from forficula.pattern import ASSIGNMENTS
from forficula.quantities import reading_unit, show_value
from forficula.show.run.missed_goal import stalled_stage
from forficula.show.run.outcome_rows import state_angles
from forficula.show.run.state_names import state_letters
from forficula.show.run.time_axes import (
    MOST_ENTRIES,
    TimeSpan,
    fit_values,
    mark_waits,
    row_legend,
    shade_stages,
    time_in,
    time_rows,
    time_spans,
    unit_of_run,
)
from forficula.show.structure.labels import (
    by_role,
    counted,
    driven_angles,
    measure_labels,
    median,
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
    SKY,
    VERMILION,
    describe,
    figure_style,
)
from forficula.statics.slow_margin import LARGEST_TORQUE_FACTOR
from forficula.structure import Drive, Measure, Structure, drive_of, drive_unit

_COLOURS = (BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY, BLACK)
# least range of an axis, in deg and in spans
_LEAST_DEGREES, _LEAST_SPANS = 0.1, 2e-3
_SHORTEST = 7  # letters of a label; four labels of this length fit into a row of a column
_DEGREE_STEPS = (1, 1.5, 2, 3, 4.5, 5, 9, 10)  # steps of ticks, times a power of ten
_VISIBLE = 0.01  # share of all values' range above which lines of a group are distinct


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
            groups = _groups(structure, measures, lines)
            for axes, span in zip(axes_row, time_spans(record), strict=True):
                if groups:
                    _draw_groups(axes, time_in(record, span), lines, groups)
                else:
                    for line, (name, values) in enumerate(lines.items()):
                        axes.plot(time_in(record, span), values, **_look(line), label=name)
                shade_stages(axes, record, span)
                mark_waits(axes, record, span)
            rows_drawn = slice(None) if stalled is None else record.time >= stalled.start
            fit_values(axes_row, np.array(list(lines.values()))[:, rows_drawn], _least_range(record, measures))
            if measures[0].kind == "angle":
                axes_row[0].yaxis.set_major_locator(MaxNLocator(nbins=6, steps=_DEGREE_STEPS))
            if groups or list(lines) != [title_of(measures[0])]:
                row_legend(axes_row, width, columns=4 if max(map(len, lines), default=0) <= _SHORTEST else 3)
        if torques and stalled is not None:
            for axes, span in zip(rows[-1], time_spans(record), strict=True):
                _draw_torques(axes, record, stalled, torques, least, (span, factor))
            _note_torque(rows[-1][0], torques, least)
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
    title = title_of(measures[0]).replace("_", " ")
    return f"{title if alone else kind} ({unit})"


def _length_unit(record: Record, measures: tuple[Measure, ...]) -> tuple[str, float]:
    largest = [np.abs(record.measured(measure.name)).max(initial=0.0) for measure in measures]
    return reading_unit("m", float(np.nanmax([*largest, 0.0])) or record.structure.span)


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


def _groups(structure: Structure, measures: tuple[Measure, ...], lines: dict[str, Array]) -> dict[str, list[int]]:
    """Return the lines of a row by their names in the legend, if they coincide or are too many for line styles."""
    measure, count = measures[0], len(measures[0].parts)
    if len(measures) > 1 or measure.kind != "angle" or count == 1:
        return {}
    roles, values = _kinds(structure, measure), np.array(list(lines.values())).T
    together = {counted(measure_labels(structure, measure), "hinge"): list(range(count))}
    if _spread(values) <= _VISIBLE * _range(values):
        return together
    if count <= len(LINE_STYLES) or (len(roles) == 1 and count <= MOST_ENTRIES):
        return {}
    return together if len(roles) == 1 else {f"{role} ({len(places)})": places for role, places in roles.items()}


def _kinds(structure: Structure, measure: Measure) -> dict[str, list[int]]:
    """Return the indices of a measure's readings by role of their hinges, or by assignment if all have one role."""
    roles = by_role(structure, measure)
    if len(roles) > 1:
        return roles
    assigned: dict[str, list[int]] = {}
    for place, part in enumerate(measure.parts):
        assigned.setdefault(ASSIGNMENTS.get(structure.hinges[part[0]].assignment, ""), []).append(place)
    return assigned


def _spread(values: Array) -> float:
    """Return the largest distance of lines, (time, line)."""
    return float(np.nanmax(np.ptp(values, axis=1), initial=0.0))


def _range(values: Array) -> float:
    """Return the range of all finite values."""
    finite = values[np.isfinite(values)]
    return float(np.ptp(finite)) if finite.size else 0.0


def _draw_groups(axes: Axes, time: Array, lines: dict[str, Array], groups: dict[str, list[int]]) -> None:
    """Draw many angles by role: every angle thin, and their median."""
    values = np.array(list(lines.values())).T
    visible = _VISIBLE * _range(values)
    for number, (name, indices) in enumerate(groups.items()):
        look, group = _look(number), values[:, indices]
        # one line with gaps draws faster than many lines
        single = np.vstack([group, np.full(len(indices), np.nan)]).T.ravel()
        axes.plot(np.tile([*time, np.nan], len(indices)), single, color=look["color"], lw=0.5, alpha=0.35)
        label = f"{name}, median" if _spread(group) > visible else name
        axes.plot(time, median(group), **look, lw=1.6, label=label)


def _draw_torques(
    axes: Axes,
    record: Record,
    stalled: StageEnd,
    drives: Sequence[Drive],
    least: float | None,
    scales: tuple[TimeSpan, float],
) -> None:
    """Draw the torques of a driven stage, and the least torque that would have reached its goal."""
    span, factor = scales
    first = np.nextafter(stalled.start, stalled.end)
    time = np.sort([*record.time, stalled.start, first, stalled.end])
    acts = (time >= first) & (time <= stalled.end)
    highest = max(abs(drive.strength) for drive in drives)
    for drive in drives:
        risen = np.clip((time - stalled.start) / drive.rise, 0, 1) if drive.rise > 0 else 1.0
        torque = np.where(acts, factor * abs(drive.strength) * risen, 0.0)
        axes.plot((time - span.start) * span.scale, torque, color=BLACK, label=f"acting {drive.where}".rstrip())
    if least is not None and np.isfinite(least):
        axes.axhline(factor * least, color=VERMILION, ls="--", label="least slow torque")
        highest = max(highest, least)
    axes.set_ylim(0, 1.2 * factor * highest or 1.0)
    shade_stages(axes, record, span)


def _note_torque(axes: Axes, drives: Sequence[Drive], least: float | None) -> None:
    """Write that no torque suffices."""
    if least is None or np.isfinite(least):
        return
    tried = show_value(LARGEST_TORQUE_FACTOR * abs(drives[0].strength), "N m", 3)
    words = f"no slow torque up to\n{tried} suffices"
    axes.text(0.03, 0.97, words, transform=axes.transAxes, va="top", fontsize=7, color=VERMILION)


def _least_range(record: Record, measures: tuple[Measure, ...]) -> float:
    """Return the least range of an axis in its unit: smaller changes are rounding errors."""
    if measures[0].kind == "angle":
        return _LEAST_DEGREES
    return _LEAST_SPANS * record.structure.span * _length_unit(record, measures)[1]


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
            groups = _groups(record.structure, measures, _lines(record, measures))
            # a mark is on a line
            first = median(angles[next(iter(groups.values()))]) if groups else angles.mean()
            value = float(angles[np.argmin(np.abs(angles - first))])
        else:
            value = _length_unit(record, measures)[1] * float(state.readings[measure.name].mean[0])
        time = scale * state.time
        axes.plot(time, value, "o", color="white", mec="black", mew=0.8, ms=9, zorder=5, clip_on=False)
        axes.text(time, value, letter, ha="center", va="center_baseline", fontsize=7, zorder=6)


def _look(line: int) -> dict[str, Any]:
    """Return the colour and style of a line."""
    return {"color": _COLOURS[line % len(_COLOURS)], "ls": LINE_STYLES[line % len(LINE_STYLES)]}
