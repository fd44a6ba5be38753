"""Runs of a study that are kept whole, so that they can be played: which, and where they lie."""

from __future__ import annotations

import math
import re
import shutil
from collections.abc import Callable, Collection, Iterator, Sequence
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from forficula.analysis import Outcome, Verdict, measure
from forficula.analysis.run_files import holds_run, read_run, remove_run, write_run_files
from forficula.arrays import Flags
from forficula.design import Design
from forficula.dynamics import Record
from forficula.errors import InputError
from forficula.files import clear_leftovers, replacing_all
from forficula.lock import held
from forficula.quantities import as_written, is_whole
from forficula.structure import Structure, drawn_points, structure_of, transition_of
from forficula.study.running.evaluate import outcome_row, row_key
from forficula.study.running.journal import Row
from forficula.study.running.runs import run_each
from forficula.study.search import first_design, point_design, release_design, second_design
from forficula.study.search_steps import SearchStep
from forficula.study.study import Study

if TYPE_CHECKING:
    from xarray import Dataset

Progress = Callable[[int, int, Row], None]

# Points whose runs are kept where nothing else is said.
MOST_POINTS = 100
# Runs side by side: a whole record of each is in memory until it is written.
_BATCH = 48
_FOLDER = "runs"
# as a folder of ours is named, and as earlier versions named one that they were writing
_NAME = re.compile(r"\d+(-[a-z]+)?")
_UNFINISHED = re.compile(r"\.\d+(-[a-z]+)?-\w+")
# A row for every motion by this share of the size of the whole, and for every so many seconds.
_SHARE_OF_SIZE = 0.005
_LONGEST_GAP = 5e-3


@dataclass(frozen=True, kw_only=True)
class RunToKeep:
    """A run of a study that is worth a record.

    Attributes:
        point: number of the study's point, from 0 on.
        part: what its transition does, such as "folding" or "opening", of a search; "run" of a plain study.
        name: of its folder: the row of `table.csv`, from 1 on, and the part.
        design: what to run.
        transition: number of the transition that a search made it for; None where it is for all of them.
    """

    point: int
    part: str
    name: str
    design: Design
    transition: int | None = None


@dataclass(frozen=True, kw_only=True)
class KeptRun:
    """A run with its record.

    Attributes:
        point: number of the study's point, from 0 on.
        part: as of `RunToKeep`.
        folder: where it lies, within the study's folder.
        record: with the rows that `thin_record` leaves.
        outcome: with the same bits as in the study's table.
        transition: as of `RunToKeep`.
    """

    point: int
    part: str
    folder: str
    record: Record
    outcome: Outcome
    transition: int | None = None


def runs_to_keep(study: Study, table: Dataset, most: int = MOST_POINTS) -> list[RunToKeep]:
    """Choose the runs that the numbers of a table come from.

    Of a plain study that is the run of each point. Of a search it is the first transition with
    the least value that does it, and the release, and the second with the least value that does that, from where the
    search's reference value left the first; where no value worked, the last that was tried, which shows why.

    Args:
        study: what was asked.
        table: what came out.
        most: points at most. Where there are more, only those count that did the first transition, spread evenly
            over the study.

    Raises:
        InputError: `most` is no whole number, or below 0.
    """
    check_most(most)
    width = len(str(len(study.points)))
    runs, structure = [], structure_of(study.base)
    for point in _points(study, table, most):
        try:
            design = point_design(study.base, study.points[point], study.search)
        except InputError:  # its row says why
            continue
        for part, transition, each in _parts(study, structure, table, point, design):
            name = f"{point + 1:0{width}d}{'' if part == 'run' else f'-{part}'}"
            runs.append(RunToKeep(point=point, part=part, name=name, design=each, transition=transition))
    return runs


def check_most(most: int) -> None:
    """Refuse a number of points that is none, before a study that takes a while.

    Raises:
        InputError: it is no whole number, or below 0.
    """
    if not is_whole(most, 0):
        raise InputError(f"need a whole number of points >= 0, got {as_written(most)}")


def kept_runs(
    runs: Sequence[RunToKeep], out: str | Path, *, threads: int = 0, progress: Progress | None = None
) -> Iterator[KeptRun]:
    """Run again what `runs_to_keep` chose, leave each in a folder of its own, and hand them on one after another.

    A run that is there is read, not run; stopped or killed, the same call goes on. Each folder, such as
    `runs/07-folding`, is that of a run, without its figures. Kept runs that are not among these, or that other versions
    made, are removed. Runs are deterministic: their outcomes are those of the table.

    One process at a time keeps runs in a folder. Another one waits, which takes minutes at most, and of the same study
    finds all of them there: shards that end together need no care.

    Args:
        runs: to keep.
        out: folder of the study.
        threads: 0 for one a core.
        progress: called after every run with the runs that are there, all of them, and the run's row.

    Raises:
        InputError: the folder cannot be written.
    """
    folder = Path(out) / _FOLDER
    with _alone(Path(out), needed=bool(runs) or folder.exists()):
        clear_leftovers(folder)
        for run in runs:
            clear_leftovers(folder / run.name)
        there = [run for run in runs if holds_run(folder / run.name, row_key(run.design))]
        names = {run.name for run in there}
        _remove_others(folder, names)
        missing = [run for run in runs if run.name not in names]
        for run in there:
            try:
                record = read_run(folder / run.name)
            except InputError:
                missing.append(run)
            else:
                yield _kept(run, record, measure(record))
        done = len(runs) - len(missing)
        for first in range(0, len(missing), _BATCH):
            for run, record in _run(missing[first : first + _BATCH], threads):
                kept = _keep(folder, run, record)
                done += 1
                if progress is not None:
                    progress(done, len(runs), {"key": row_key(run.design), **outcome_row(kept.outcome)})
                yield kept


@contextmanager
def _alone(out: Path, needed: bool) -> Iterator[None]:
    """Be the only process that keeps runs in a study's folder, where there is anything to do."""
    with ExitStack() as stack:
        try:
            if needed:
                out.mkdir(parents=True, exist_ok=True)
                stack.enter_context(held(out / f".{_FOLDER}.lock"))
        except OSError as error:
            raise InputError(f"{out}: cannot be written: {error.strerror}") from None
        yield


def _points(study: Study, table: Dataset, most: int) -> list[int]:
    """Numbers of the points whose runs are kept."""
    if len(study.points) <= most:
        return list(range(len(study.points)))
    numbers = np.flatnonzero(_worked(study, table).ravel())
    chosen = np.unique(np.linspace(0, len(numbers) - 1, min(len(numbers), most)).round().astype(int))
    return [int(number) for number in numbers[chosen]]


def _worked(study: Study, table: Dataset) -> Flags:
    """Whether each point reached the first state that the study is about."""
    if study.search is not None:
        return np.asarray(np.isfinite(table[study.search.first.least_name].values))
    transitions = structure_of(study.base).transitions
    if not transitions:
        return np.ones(table["verdict"].shape, dtype=bool)
    return np.asarray(table[transitions[0].state].values, dtype=bool)


def _parts(
    study: Study, structure: Structure, table: Dataset, point: int, design: Design
) -> Iterator[tuple[str, int | None, Design]]:
    """The runs of one point that a row of the table comes from, with their names and numbers of their transitions."""
    search = study.search
    if search is None:
        yield "run", None, design
        return
    first, second = search.first, search.second
    least = float(table[first.least_name].values.ravel()[point])
    # of a run that says nothing there is nothing to see
    verdict = Verdict(str(table["verdict"].values.ravel()[point]))
    tells = verdict.tells or verdict is Verdict.UNDECIDED
    part = _part_name(structure, first)
    if math.isnan(least):
        if tells:
            yield *part, first_design(design, search, first.values[-1])
        return
    released = search.next_drive is not None
    yield *part, (release_design if released else first_design)(design, search, least)
    if second is None:
        return
    least = float(table[second.least_name].values.ravel()[point])
    if tells or not math.isnan(least):
        value = second.values[-1] if math.isnan(least) else least
        yield *_part_name(structure, second), second_design(design, search, value)


def _part_name(structure: Structure, step: SearchStep) -> tuple[str, int | None]:
    """What the folder of a search's run says of it, such as "folding", and the number of its transition."""
    transition = transition_of(structure, step.drive)
    if transition is None:
        return step.transition, None
    return transition.wording.doing.replace(" ", "-"), structure.transitions.index(transition)


def _run(runs: Sequence[RunToKeep], threads: int) -> Iterator[tuple[RunToKeep, Record]]:
    """Take designs through their protocols side by side; those that cannot be built are left out, as their rows say."""
    for number, record in run_each([run.design for run in runs], threads):
        if not isinstance(record, InputError):
            yield runs[number], record


def _keep(folder: Path, run: RunToKeep, record: Record) -> KeptRun:
    """Write a run's folder, all of it or nothing."""
    outcome, thinned = measure(record), thin_record(record)
    with replacing_all(folder / run.name) as unfinished:
        write_run_files(record, outcome, unfinished, kept=thinned, key=row_key(run.design))
    return _kept(run, thinned, outcome)


def _kept(run: RunToKeep, record: Record, outcome: Outcome) -> KeptRun:
    return KeptRun(
        point=run.point,
        part=run.part,
        folder=f"{_FOLDER}/{run.name}",
        record=record,
        outcome=outcome,
        transition=run.transition,
    )


def _remove_others(folder: Path, wanted: Collection[str]) -> None:
    """Remove what we left there and do not want now; files that are not ours stay."""
    try:
        for place in folder.iterdir() if folder.is_dir() else ():
            if _UNFINISHED.fullmatch(place.name):  # of a process that was killed while it wrote
                shutil.rmtree(place, ignore_errors=True)
            elif _NAME.fullmatch(place.name) and place.is_dir() and place.name not in wanted:
                clear_leftovers(place)
                remove_run(place)
                if not any(place.iterdir()):
                    place.rmdir()
        if not wanted and folder.is_dir() and not any(folder.iterdir()):
            folder.rmdir()
    except OSError as error:
        raise InputError(f"{folder}: cannot be written: {error.strerror}") from None


def thin_record(record: Record) -> Record:
    """Leave out rows where little moves.

    What `measure` looks at stays, so that the outcome has the same bits: both ends of every stage and the protocol's
    window before its end. Elsewhere a row stays for every 0.5 % of the size of the whole that some point of it has
    moved, as measured along its path, and for every 5 ms.

    Args:
        record: sampled at an interval.

    Returns:
        The same run with some of its rows.
    """
    drawn, nodes = drawn_points(record.structure), record.series["membrane_position"]
    points = np.concatenate([record.series["point_position"][:, drawn], nodes], axis=1)
    size = float(np.ptp(points[0], axis=0).max())
    kept = _needed(record)
    with np.errstate(over="ignore", invalid="ignore"):  # of what diverged
        moved = np.linalg.norm(np.diff(points, axis=0), axis=2).max(axis=1)
        ways = np.stack([np.cumsum(moved) / (_SHARE_OF_SIZE * size), (record.time[1:] - record.time[0]) / _LONGEST_GAP])
        kept[1:] |= (np.diff(np.floor(ways), prepend=0.0) > 0).any(axis=0)
    kept[[0, -1]] = True
    return replace(record, time=record.time[kept], series={name: rows[kept] for name, rows in record.series.items()})


def _needed(record: Record) -> Flags:
    """The rows that states and transitions are read from, (time,)."""
    protocol = record.design.protocol
    half = float(protocol.timestep) / 2  # times are multiples of the timestep up to rounding
    needed = np.zeros(len(record.time), dtype=bool)
    for end in record.stages:
        window = record.time >= max(end.start, end.end - protocol.window) - half
        needed |= window & (record.time <= end.end + half)
        needed[[int(np.argmin(np.abs(record.time - moment))) for moment in (end.start, end.end)]] = True
    return needed
