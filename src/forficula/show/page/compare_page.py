"""Page that plays several runs side by side with a common clock."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from forficula.analysis import Outcome, State, measure
from forficula.analysis.run_files import read_run
from forficula.arrays import Array
from forficula.design import Design
from forficula.dynamics import Record
from forficula.errors import InputError, error_prefix
from forficula.files import write_text
from forficula.names import listed
from forficula.quantities import reading_unit
from forficula.show.page.data.fold_distance import FoldMotion, fold_distances, read_motion
from forficula.show.page.data.time_spans import shared_spans, span_data
from forficula.show.page.page import page_html, page_path
from forficula.show.page.parts.design_rows import DIGITS, differing_rows
from forficula.show.page.parts.html import Cell, escaped, paragraph, section, table
from forficula.show.page.parts.plots import Line, Plot, energy_plot, plot_data
from forficula.show.page.parts.run_sentences import angle_range, outcome_sentence, readable, reading_range
from forficula.show.page.playback import (
    BUDGET,
    Clip,
    Readings,
    clip_data,
    energy_scale,
    legend_data,
    make_clip,
    structure_noun,
)
from forficula.show.run.outcome_rows import state_angles
from forficula.show.structure.drive_labels import acting
from forficula.show.structure.labels import shown_angles, shown_distances, title_of
from forficula.structure import Measure, drive_of, drive_unit

_FEWEST, _MOST = 2, 12
_SIMILAR = 5.0  # ratio of largest energies up to which runs share an axis
_ELASTIC = ("tendons", "membrane", "hinges", "creases", "facet bends", "bars", "openings", "Maxwell branches")


@dataclass(frozen=True, kw_only=True)
class ComparedRun:
    """Run on the page.

    Attributes:
        label: name that distinguishes it from the others.
        record: the simulated motion.
        outcome: the outcome of the run.
    """

    label: str
    record: Record
    outcome: Outcome


def compare_runs(folders: Sequence[Path], path: Path) -> None:
    """Write a page that plays runs side by side.

    Args:
        folders: two to twelve folders written by `forficula run`; FOLD files with frames of the same pattern may be
            among them.
        path: path of the page; must end with .html.

    Raises:
        InputError: too few or too many folders, a folder without a run, a FOLD file without frames or of another
            pattern, a path with another ending, or the file cannot be written.
    """
    with error_prefix("--out: "):
        path = page_path(path)
    if not _FEWEST <= len(folders) <= _MOST:
        raise InputError(f"compare: need {_FEWEST} to {_MOST} folders of runs, got {len(folders)}")
    motions = [read_motion(file) for file in folders if is_fold(file)]
    folders = [folder for folder in folders if not is_fold(folder)]
    if not folders:
        raise InputError("compare: need the folder of a run beside FOLD files")
    runs = []
    for folder, label in zip(folders, _labels(folders), strict=True):
        record = read_run(folder)
        runs.append(ComparedRun(label=label, record=record, outcome=measure(record)))
    write_text(path, compare_page(runs, motions))


def is_fold(path: object) -> bool:
    """Return whether a path is that of a FOLD file."""
    return isinstance(path, str | os.PathLike) and Path(path).suffix == ".fold"


def compare_page(runs: Sequence[ComparedRun], motions: Sequence[FoldMotion] = ()) -> str:
    """Return runs as one page: structures side by side, common plots, and a table with one column for each run.

    Args:
        runs: one or more runs.
        motions: motions of another program; a plot shows the distance of every run from each of them.

    Raises:
        InputError: a motion of another pattern than that of a run.
    """
    clips = [make_clip(run.record, run.outcome, name=run.label, budget=BUDGET // len(runs)) for run in runs]
    labels = [run.label for run in runs]
    distances = [_distances(runs, clips, motion) for motion in motions]
    sentences = "".join(f"<li>{escaped(outcome_sentence(run.label, run.outcome))}</li>" for run in runs)
    sentences += "".join(f"<li>{escaped(plot.text)}</li>" for plot in distances)
    title = listed([*labels, *(motion.name for motion in motions)])
    body = "".join(
        (
            f"<header><h1>{escaped(title)}</h1><ol class=outcome>{sentences}</ol></header>\n",
            '<main><div id="player"></div>\n<div id="plots"></div>\n',
            section("Outcomes", table("Side by side", ("", *labels), _outcome_rows(runs)), name="outcome"),
            section("Designs", *_designs(labels, [run.record.design for run in runs]), name="design"),
            "</main>",
        )
    )
    return page_html(f"{title}, compared", body, _data(clips, distances))


def _labels(folders: Sequence[Path]) -> list[str]:
    """Return the names of the folders, with as many parent folders as are needed to distinguish them."""
    resolved = [folder.resolve() for folder in folders]
    if len(set(resolved)) < len(resolved):
        twice = next(folder for folder, path in zip(folders, resolved, strict=True) if resolved.count(path) > 1)
        raise InputError(f"compare: need every run once, got {twice} twice")
    for depth in range(1, max(len(path.parts) for path in resolved) + 1):
        labels = ["/".join(map(_printable, path.parts[-depth:])) for path in resolved]
        if len(set(labels)) == len(labels):
            return labels
    return [f"{number}: {_printable(str(path))}" for number, path in enumerate(resolved, start=1)]


def _printable(name: str) -> str:
    """Return a file name as text: on Linux it may contain bytes that are not text."""
    return os.fsencode(name).decode("utf-8", "replace")


def _data(clips: Sequence[Clip], distances: Sequence[Plot]) -> dict[str, Any]:
    names, whole = " and ".join(clip.name for clip in clips), structure_noun(clips)
    progress = _progress(clips)
    return {
        "kind": "compare",
        "whole": whole,
        "clips": [clip_data(clip) for clip in clips],
        "spans": [span_data(span) for span in shared_spans(clips)],
        "plots": plot_data([*distances, *([] if progress is None else [progress]), *_energies(clips)]),
        "energy": energy_scale(clips),
        "legend": legend_data(clips),
        "text": f"The {whole}s of {names} side by side, with a common clock and camera.",
    }


def _distances(runs: Sequence[ComparedRun], clips: Sequence[Clip], motion: FoldMotion) -> Plot:
    """Return a plot of the distances of all runs from the nearest frame of a motion."""
    lines, worst = [], []
    for run, clip in zip(runs, clips, strict=True):
        lines.append(fold_distances(run.record, np.searchsorted(run.record.time, clip.time), motion))
        place = int(np.argmax(lines[-1]))
        share = readable(100 * float(lines[-1][place]) / clip.structure.span, "%")
        worst.append(f"{clip.name} at most {readable(float(lines[-1][place]), 'm')} ({share} of its span)")
    unit, factor = reading_unit("m", max(float(values.max()) for values in lines))
    return Plot(
        title=f"distance to {motion.name}",
        unit=unit,
        lines=tuple(
            Line(name=clip.name, clip=number, values=factor * values)
            for number, (clip, values) in enumerate(zip(clips, lines, strict=True))
        ),
        text=f"Distance of the vertices from the motion of the {len(motion.frames)} frames of {motion.name}, root mean"
        f" square after the best rotation: {listed(worst)}.",
    )


@dataclass(frozen=True, kw_only=True)
class _ProgressReading:
    """Progress of a run: for a fan, the distal angle of the hinge that has folded least.

    Attributes:
        readings: readings of the measure of the first transition.
        least: reading furthest from the goal, rad or m, (time,).
        best: value of `least` closest to the goal, rad or m.
        done: participle of the transition, such as "folded".
    """

    readings: Readings
    least: Array
    best: float
    done: str

    @property
    def title(self) -> str:
        """Name of the quantity, such as "distal angle of the hinge folded least"."""
        name = title_of(self.readings.measure)
        return f"{name} of the hinge {self.done} least" if len(self.readings.labels) > 1 else name


def _progress_reading(clip: Clip) -> _ProgressReading | None:
    for transition in clip.structure.transitions:
        for readings in clip.readings:
            if readings.measure.name == transition.measure:
                largest = transition.furthest == "largest"
                least = readings.values.max(axis=1) if largest else readings.values.min(axis=1)
                best = float(least.min() if largest else least.max())
                return _ProgressReading(readings=readings, least=least, best=best, done=transition.wording.done)
    return None


def _progress(clips: Sequence[Clip]) -> Plot | None:
    """Return a plot of the progress of every run; None if a run has no measure of it or the units differ."""
    readings = [progress for clip in clips if (progress := _progress_reading(clip)) is not None]
    kinds = {reading.readings.measure.kind for reading in readings}
    if len(readings) < len(clips) or len(kinds) > 1:
        return None
    unit, factor = "deg", float(np.degrees(1.0))
    if "distance" in kinds:
        unit, factor = reading_unit("m", max(float(np.abs(reading.least).max()) for reading in readings))
    titles, dones = {reading.title for reading in readings}, {reading.done for reading in readings}
    title = titles.pop() if len(titles) == 1 else "reading furthest from its goal"
    subject = title if title.startswith("reading") else f"the {title}"
    reached = ", ".join(
        f"{clip.name} {reading_range(np.array([factor * reading.best]), unit)}"
        for clip, reading in zip(clips, readings, strict=True)
    )
    furthest = f"furthest {dones.pop()}" if len(dones) == 1 else "at best"
    return Plot(
        title=title,
        unit=unit,
        lines=tuple(
            Line(name=clip.name, clip=index, values=factor * item.least)
            for index, (clip, item) in enumerate(zip(clips, readings, strict=True))
        ),
        text=f"{subject[0].upper()}{subject[1:]} in every {structure_noun(clips)}; {furthest}: {reached}.",
    )


def _energies(clips: Sequence[Clip]) -> list[Plot]:
    """Return plots of the energy of all tendons, or of all elastic energy if a run has no tendons.

    Runs whose largest energies differ much are in different plots: on one axis the smaller ones would be flat lines.
    """
    tendons = all(clip.structure.tendons for clip in clips)
    what, names = ("energy of all tendons", ("tendons",)) if tendons else ("elastic energy", _ELASTIC)
    lines = [
        (clip.name, index, _sum([clip.stored_energy[name] for name in names if name in clip.stored_energy], clip))
        for index, clip in enumerate(clips)
    ]
    groups = _by_size(lines)
    plots = []
    for group in groups:
        most = ", ".join(f"{name} {readable(float(values.max(initial=0.0)), 'J')}" for name, _, values in group)
        every = len(groups) == 1
        of = f"every {structure_noun(clips)}" if every else listed([name for name, _, _ in group])
        title = what if every else f"{what}, {listed([name for name, _, _ in group])}"
        plot = energy_plot(title, group, f"The {what} of {of}; largest values: {most}.")
        # a run has one colour in all plots
        plots.append(replace(plot, lines=tuple(replace(line, look=line.clip) for line in plot.lines)))
    return plots


def _by_size(lines: Sequence[tuple[str, int, Array]]) -> list[list[tuple[str, int, Array]]]:
    """Group lines (name, clip and values) so that the largest values of a group differ by a small factor."""
    groups: list[list[tuple[str, int, Array]]] = []
    largest = 0.0
    for line in sorted(lines, key=lambda line: -float(line[2].max(initial=0.0))):
        value = float(line[2].max(initial=0.0))
        if not groups or value * _SIMILAR < largest:
            groups.append([])
            largest = value
        groups[-1].append(line)
    # in the order of the runs
    return sorted((sorted(group, key=lambda line: line[1]) for group in groups), key=lambda group: group[0][1])


def _sum(energies: list[Array], clip: Clip) -> Array:
    return np.sum(energies, axis=0) if energies else np.zeros(len(clip.time))


def _outcome_rows(runs: Sequence[ComparedRun]) -> list[list[str]]:
    rows = [["status", *(run.outcome.status for run in runs)]]
    for name in dict.fromkeys(transition.name for run in runs for transition in run.record.structure.transitions):
        kind = listed(dict.fromkeys(acting(run.record.structure).removesuffix("s") for run in runs), "or")
        tried = [f"{name} {kind}, time, work", *("not tried" for _ in runs)]
        for index, run in enumerate(runs, start=1):
            result, built = run.outcome.transitions.get(name), run.record.structure
            transition = next((transition for transition in built.transitions if transition.name == name), None)
            if result is not None and transition is not None:
                time = "—" if result.time is None else readable(result.time, "s")
                strength = readable(result.strength, drive_unit(built, drive_of(built, transition.drive)))
                tried[index] = f"{strength}, {time}, {readable(result.work, 'J')}"
        rows.append(tried)
    measures = [
        {item.name: item for item in (*shown_angles(built), *shown_distances(built))}
        for built in (run.record.structure for run in runs)
    ]
    titles = {name: title_of(those[name]) + "s" * (len(those[name].parts) > 1) for those in measures for name in those}
    tendons = any(run.record.structure.tendons for run in runs)
    for name, called in _states(runs).items():
        states = [run.outcome.states.get(name) for run in runs]
        for readings, title in titles.items():
            cells = [_read(state, those.get(readings)) for state, those in zip(states, measures, strict=True)]
            rows.append([f"{title} {called}", *cells])
        if tendons:
            energies = [
                "—" if state is None or not len(state.tendon_energy) else readable(state.tendon_energy.sum(), "J")
                for state in states
            ]
            rows.append([f"tendon energy {called}", *energies])
    return rows


def _states(runs: Sequence[ComparedRun]) -> dict[str, str]:
    """Return the row names of the states: states that transitions lead to are named before their outcome is known."""
    called: dict[str, str] = {}
    structures = [run.record.structure for run in runs]
    led_to = {transition.state for structure in structures for transition in structure.transitions}
    for structure in structures:
        for state in structure.states:
            called.setdefault(state.name, state.unknown if state.name in led_to else state.name)
    return called


def _read(state: State | None, readings: Measure | None) -> str:
    """Return the value of a measure in a state; the range over its hinges for angles."""
    if state is None or readings is None:
        return "—"
    if readings.kind == "angle":
        return angle_range(np.degrees(state_angles(state, readings)))
    return readable(float(state.readings[readings.name].mean[0]), "m")


def _designs(labels: Sequence[str], designs: Sequence[Design]) -> list[str]:
    rows = differing_rows(designs)
    if not rows:
        digits = "" if len({design.hash for design in designs}) == 1 else f", to {DIGITS} digits"
        return [paragraph(f"The designs are the same in every value{digits}.")]
    cells: list[list[str | Cell]] = [[key, *values] for key, values in rows]
    cells.append(["design hash", *(design.hash for design in designs)])
    return [
        paragraph("Only values that differ are listed."),
        table("Values that differ", ("", *labels), cells),
    ]
