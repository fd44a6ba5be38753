"""Angles, distances and energies over time: the whole run, and its driven stages close up."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from numpy.typing import NDArray

from forficula.analysis import Outcome
from forficula.design import stage_drives
from forficula.dynamics import Record, StageEnd
from forficula.quantities import reading_unit, show_duration, show_value
from forficula.show.run.outcome_rows import state_angles
from forficula.show.run.stalled import stalled_stage, still_time
from forficula.show.run.state_names import state_letters
from forficula.show.structure.drive_words import acting
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
    fit_legend,
    is_narrow,
)
from forficula.structure import (
    Drive,
    Measure,
    Structure,
    drive_of,
    drive_unit,
    hinge_groups,
    measure_stops,
    springs_name,
)
from forficula.study.slow_margin import MORE

Array = NDArray[np.float64]

_COLOURS = (BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY, BLACK)
# before and after a driven stage, as a share of it
_LEAD = 0.15
_AFTER = 1.6  # of the time until it reached its goal or came to rest, that is drawn
_LEAST_SEEN = 0.05  # deg, to either side: less is rounding
# of an axis of angles, deg: to one side where hinges go beyond a right angle, at least, and by where they stop
_HALF_TURN, _LEAST_ROOM, _ROOM = 200.0, 25.0, 1.2
_ROOMY = 0.25  # of an axis over time, over which words stand
# of a legend; more lines than that have the colours of a scale, in their order
_MOST_ENTRIES = 8
_LABELS = 0.6  # inch, of an axis upwards
_SHORT, _SHORTEST = 12, 7  # letters of a label, of which three or four fit beside one another in a column
_STEPS, _MOST_STEPS = (5, 10, 15, 30, 45, 90), 6


def draw_angles(
    record: Record, outcome: Outcome, width: float = PAGE_WIDTH, needed: Callable[[], float | None] = lambda: None
) -> Figure:
    """Draw angles and distances over time with the states marked.

    Of a run that missed a goal also the angles that motors act on, close up, and the torque that acts beside the least
    one that would have done.

    Args:
        record: what happened.
        outcome: what it means.
        width: of the figure, inch.
        needed: finds that least torque, N m: nan where none does, None where it is not known.
    """
    stalled, structure = stalled_stage(record), record.structure
    rows_of = _readings(structure)
    if stalled is not None:
        had = [measure for measures in rows_of for measure in measures]
        rows_of = [(measure,) for measure in driven_angles(structure, had) if measure not in had] + rows_of
    with figure_style():
        labels = [_row_label(record, measures) for measures in rows_of]
        drives = [] if stalled is None else [drive_of(structure, name) for name in stage_drives(stalled.stage)]
        torques = drives if all(drive_unit(structure, drive) == "N m" for drive in drives) else []
        if torques:
            least = needed()
            unit, factor = reading_unit("N m", max(abs(drive.strength) for drive in torques))
            labels.append(f"torque ({unit})")
        figure, rows = _layout(
            record, labels, width, height=2.5 if len(labels) == 1 else (2.2 if stalled is None else 1.7) * len(labels)
        )
        for axes_row, measures in zip(rows, rows_of, strict=False):
            lines = _lines(record, measures)
            for axes, (start, scale) in zip(axes_row, _spans(record), strict=True):
                time = _time(record, start, scale)
                if role_groups(record.structure, measures[0]):
                    _draw_many(axes, time, record, measures[0])
                else:
                    for line, (name, values) in enumerate(lines.items()):
                        axes.plot(time, values, **_look(line, len(lines)), label=name)
                if measures[0].kind == "angle":
                    _scale_degrees(axes, record, measures, stalled)
                axes.axhline(0, color="0.6", lw=0.5, zorder=0)
                _shade_stages(axes, record, start, scale)
                _mark_waits(axes, record, start, scale)
            if list(lines) != [title_of(measures[0])]:
                _legend(axes_row, width, columns=4 if max(map(len, lines), default=0) <= _SHORTEST else 3)
        if torques and stalled is not None:
            for axes, (start, scale) in zip(rows[-1], _spans(record), strict=True):
                _draw_torques(axes, record, stalled, torques, least, (start, scale, factor))
            _legend(rows[-1], width, columns=2)
        if rows_of:
            _mark_states(rows[0][0], record, outcome, rows_of[0], _run_unit(record)[1])
        return describe(figure, _tell_angles(record, outcome))


def draw_energies(record: Record, width: float = PAGE_WIDTH) -> Figure:
    """Draw energies over time, and under them the work done and where it went; the width is in inch.

    Of a run that missed a goal their changes since the stage that was to reach it.
    """
    stored, name = stored_energies(record), "energy"
    if (stalled := stalled_stage(record)) is not None:
        # what changes little would lie on what is large and stays
        first, name = int(np.argmax(record.time >= stalled.start)), "change of energy"
        stored = {part: (values - values[first], colour) for part, (values, colour) in stored.items()}
    tables = {name: stored, "work since the start": _accounts(record)}
    with figure_style():
        figure, rows = _layout(record, list(tables), width, height=4.4)
        for axes_row, (label, series) in zip(rows, tables.items(), strict=True):
            unit, factor = reading_unit("J", max(float(np.abs(values).max()) for values, _ in series.values()))
            axes_row[0].set_ylabel(f"{label} ({unit})")
            for axes, (start, scale) in zip(axes_row, _spans(record), strict=True):
                for index, (name, (values, colour)) in enumerate(series.items()):
                    style, time, drawn = LINE_STYLES[index % len(LINE_STYLES)], record.time, values
                    if name == "kinetic":
                        time, drawn = _with_peak(record, values)
                    axes.plot((time - start) * scale, drawn * factor, style, color=colour, label=name)
                _shade_stages(axes, record, start, scale)
                _mark_waits(axes, record, start, scale)
            short = len(series) == 3 and max(map(len, series)) <= _SHORT
            _legend(axes_row, width, columns=3 if short else 2)
        return describe(figure, _tell_energies(record))


def _with_peak(record: Record, kinetic: Array) -> tuple[Array, Array]:
    """Times, s, and kinetic energies, or their changes, J, with the largest one, which may be between two samples."""
    if record.kinetic_peak is None:
        return record.time, kinetic
    at, most = record.kinetic_peak
    place = int(np.searchsorted(record.time, at))
    change = float(kinetic[0] - record.series["kinetic_energy"][0])
    return np.insert(record.time, place, at), np.insert(kinetic, place, most + change)


def stored_energies(record: Record) -> dict[str, tuple[Array, str]]:
    """Energies by what stores them, of what the structure has, J, (time,), and their colours."""
    series, structure = record.series, record.structure
    stored: dict[str, tuple[Array, str]] = {}
    if structure.tendons:
        stored["tendons"] = (series["tendon_energy"].sum(axis=1), BLUE)
    if structure.membranes:
        stored["membrane"] = (series["membrane_energy"], ORANGE)
    if "hinge_energy" in series:
        for (kind, hinges), colour in zip(hinge_groups(structure).items(), (SKY, GREEN, PURPLE), strict=False):
            stored[kind] = (series["hinge_energy"][:, list(hinges)].sum(axis=1), colour)
    if "spring_energy" in series:
        stored[springs_name(structure)] = (series["spring_energy"].sum(axis=1), BLACK)
    if "coupling_energy" in series:
        stored["couplings"] = (series["coupling_energy"].sum(axis=1), SKY)
    stored["kinetic"] = (series["kinetic_energy"], VERMILION)
    if "branch_energy" in series:
        stored["Maxwell branches"] = (series["branch_energy"].sum(axis=1), GREEN)
    if structure.gravity:
        stored["gravitational"] = (series["gravitational_energy"], PURPLE)
    return stored


def largest_energies(record: Record) -> dict[str, float]:
    """The largest of each of the energies over the rows, J; the kinetic one over every step, for it peaks between."""
    most = {name: float(values.max()) for name, (values, _) in stored_energies(record).items()}
    return most if record.kinetic_peak is None else most | {"kinetic": record.kinetic_peak[1]}


def _accounts(record: Record) -> dict[str, tuple[Array, str]]:
    """The work done and where it went, J, (time,), and their colours."""
    series, structure = record.series, record.structure
    accounts: dict[str, tuple[Array, str]] = {}
    if structure.motors:
        accounts[f"done by {acting(structure)}"] = (record.work, BLACK)
    hinged = hinge_groups(structure).keys() <= {"hinges"}
    accounts[f"taken by {'hinge' if hinged else 'fold'} damping"] = (-series["hinge_damping_work"], GREEN)
    accounts["taken by stops"] = (-series["stop_work"], VERMILION)
    damped = [name for name in ("tendons", "membranes", "springs") if getattr(structure, name)]
    if damped:
        alone = {"tendons": "taken by tendons", "springs": f"taken by {springs_name(structure)}"}
        name = alone.get(damped[0]) if len(damped) == 1 else None
        accounts[name or "taken by other damping"] = (-series["elastic_damping_work"], SKY)
    for name, words, colour in (
        ("contact_work", "taken by contacts", BLUE),
        ("branch_damping_work", "taken by branches", ORANGE),
        ("letting_go_work", "branches that gave way", PURPLE),
        ("yield_work", "taken by yielding", PURPLE),
        ("drag_work", "taken by drag", BLUE),
    ):
        if name in series:
            accounts[words] = (-series[name], colour)
    return accounts


def _readings(structure: Structure) -> list[tuple[Measure, ...]]:
    """What is drawn in each row: a measure of several hinges by itself, those of one hinge together, and distances."""
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
    """The lines of a row in its unit, (time,), by name."""
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
    """Many angles by role: each thin, and the one in the middle of them."""
    values, groups = np.degrees(record.measured(measure.name)), role_groups(record.structure, measure)
    for number, (role, places) in enumerate(groups.items()):
        look, own = _look(number, len(groups)), values[:, places]
        # one line with gaps: as many lines of their own would take long
        each = np.vstack([own, np.full(len(places), np.nan)]).T.ravel()
        axes.plot(np.tile([*time, np.nan], len(places)), each, color=look["color"], lw=0.5, alpha=0.35)
        axes.plot(time, median(own), **look, lw=1.6, label=f"{role} ({len(places)}), median")


def _draw_torques(
    axes: Axes,
    record: Record,
    stalled: StageEnd,
    drives: Sequence[Drive],
    least: float | None,
    scales: tuple[float, float, float],
) -> None:
    """The torques that act while a stage is driven, and the least one that would have brought it to its goal."""
    start, scale, factor = scales
    first = np.nextafter(stalled.start, stalled.end)
    time = np.sort([*record.time, stalled.start, first, stalled.end])
    acts = (time >= first) & (time <= stalled.end)
    highest = max(abs(drive.strength) for drive in drives)
    for drive in drives:
        risen = np.clip((time - stalled.start) / drive.rise, 0, 1) if drive.rise > 0 else 1.0
        torque = np.where(acts, factor * abs(drive.strength) * risen, 0.0)
        axes.plot((time - start) * scale, torque, color=BLACK, label=f"acts {drive.where}".rstrip())
    if least is not None and np.isfinite(least):
        axes.axhline(factor * least, color=VERMILION, ls="--", label="needed at least, slowly")
        highest = max(highest, least)
    elif least is not None:
        tried = show_value(MORE * abs(drives[0].strength), "N m", 3)
        axes.plot([], [], ls="none", label=f"slowly, none up to {tried} does")
    axes.set_ylim(0, 1.2 * factor * highest or 1.0)
    _shade_stages(axes, record, start, scale)


def _scale_degrees(axes: Axes, record: Record, measures: tuple[Measure, ...], stalled: StageEnd | None) -> None:
    """From stop to stop with some room, and no further than a turn of half a circle needs.

    Where a stage missed its goal, only what it moved.
    """
    low, high = (_room(record, measures, side) for side in (-1, 1))
    if stalled is not None:
        rows = record.time >= stalled.start
        seen = np.degrees(np.concatenate([record.measured(measure.name)[rows].ravel() for measure in measures]))
        middle, half = (seen.max() + seen.min()) / 2, max(_LEAST_SEEN, (0.5 + _LEAD) * np.ptp(seen))
        if 2 * half < low + high:
            axes.set_ylim(middle - half, middle + half)
            return
    axes.set_ylim(-low, high)
    step = next(step for step in _STEPS if low + high <= _MOST_STEPS * step)
    axes.set_yticks(np.arange(-step * (low // step), high, step))


def _room(record: Record, measures: tuple[Measure, ...], side: int) -> float:
    """How far an axis of angles goes to one side, deg, beyond all stops there, or where there are none all angles."""
    reach = 0.0
    for measure in measures:
        angles = side * record.measured(measure.name)
        seen = angles.max(axis=0, initial=0.0, where=np.isfinite(angles))
        for (low, high), most in zip(measure_stops(record.structure, measure), seen, strict=True):
            stop = high if side > 0 else -low
            reach = max(reach, float(np.degrees(min(stop, np.pi) if np.isfinite(stop) else min(most, np.pi))))
    return _HALF_TURN if reach > _HALF_TURN / 2 else max(_LEAST_ROOM, _ROOM * reach)


def _tell_angles(record: Record, outcome: Outcome) -> str:
    """What the angles do, in words."""
    structure, told = record.structure, []
    first = next(iter(shown_angles(structure)), None)
    for name, state in outcome.states.items():
        if state is not None and first is not None:
            mean = np.degrees(state_angles(state, first).mean())
            told.append(f"{outcome.state_names[name]} {mean:.1f} deg at {show_value(state.time, 's')}")
    hinges = [] if first is None else measure_labels(structure, first)
    means = f" Means over the {counted(hinges, 'hinge').partition(' ')[2]}: {', '.join(told)}." if told else ""
    what = "Angles" if first is None else f"{title_of(first)[:1].upper()}{title_of(first)[1:]}s"
    run = f"the time of a run of {record.design.name}: {outcome.status}."
    return f"{what} of {counted(hinges, 'hinge')} over {run}{means}"


def _tell_energies(record: Record) -> str:
    """What the energies come to, in words."""
    largest = ", ".join(f"{name} {show_value(value, 'J')}" for name, value in largest_energies(record).items())
    name, structure = record.design.name, record.structure
    work = f"; work of the {acting(structure)}: {show_value(float(record.work[-1]), 'J')}" if structure.motors else ""
    return f"Stored energies and work over the time of a run of {name}. Largest: {largest}{work}."


def _driven(record: Record) -> list[StageEnd]:
    return [end for end in record.stages if stage_drives(end.stage)]


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
            # it holds its goal for a while, or rests short of it, in which little happens
            moved = end.goal_time or still_time(record, end.start, end.end)
            duration = 1e3 * min(end.end - end.start, _AFTER * (moved - end.start) or end.end - end.start)
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
    """What the lines are, of many some, beside the axes, or above them where these are narrow."""
    handles = row[0].get_legend_handles_labels()[0]
    if len(handles) > _MOST_ENTRIES:
        places = np.linspace(0, len(handles) - 1, _MOST_ENTRIES - 1).round().astype(int)
        others = Line2D([], [], ls="none", label=f"and {len(handles) - len(places)} others")
        handles, columns = [*(handles[place] for place in places), others], min(columns, 3)
    if is_narrow(width):
        above = {"bbox_to_anchor": (0, 1.14), "columnspacing": 1.2}
        fit_legend(row[0], handles, columns, room=width - _LABELS, loc="lower left", borderaxespad=0, **above)
    else:
        row[-1].legend(handles=handles, loc="upper left", bbox_to_anchor=(1.04, 1), borderaxespad=0)


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


def _mark_waits(axes: Axes, record: Record, start: float, scale: float) -> None:
    """Hatched bands where it waits, of which the axis shows only what was stepped, and how long."""
    for end in record.stages:
        left, right = ((moment - start) * scale for moment in (end.start, end.end))
        low, high = axes.get_xlim()
        if end.waited and max(left, low) < min(right, high):
            axes.axvspan(left, right, fc="none", ec="0.85", hatch="///", zorder=-1, lw=0)
            # beside the names of stages there is room over what is long
            if min(right, high) - max(left, low) > _ROOMY * (high - low):
                middle, text = (max(left, low) + min(right, high)) / 2, show_duration(end.waited)
                axes.text(
                    middle, 1.01, text, transform=axes.get_xaxis_transform(), ha="center", va="bottom", fontsize=7
                )


def _mark_states(axes: Axes, record: Record, outcome: Outcome, measures: tuple[Measure, ...], scale: float) -> None:
    """Letters where the states are, at the mean of what the first measure reads; none for a state that was missed."""
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
    """Colour and style of one of so many lines."""
    if count > _MOST_ENTRIES:
        return {"color": QUANTITY_COLOURS(0.9 * line / (count - 1)), "lw": 0.8}
    return {"color": _COLOURS[line % len(_COLOURS)], "ls": LINE_STYLES[line % len(LINE_STYLES)]}
