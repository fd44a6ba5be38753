"""Whole records of a study's runs, kept so that they can be played: selection and folders."""

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
from forficula.lock import hold_lock
from forficula.quantities import as_written, is_whole
from forficula.structure import Structure, drawn_points, structure_of, transition_of
from forficula.study.running.evaluate import outcome_row, row_key
from forficula.study.running.journal import Row
from forficula.study.running.law_timestep import with_timestep_for_law
from forficula.study.running.runs import run_each
from forficula.study.search_steps import SearchStep
from forficula.study.study import Study
from forficula.study.study_designs import first_design, point_design, release_design, second_design

if TYPE_CHECKING:
    from xarray import Dataset

Progress = Callable[[int, int, Row], None]

# Default number of points whose runs are kept.
MOST_POINTS = 100
# Number of runs side by side: each whole record is in memory until it is written.
_BATCH = 48
_FOLDER = "runs"
# names of folders of kept runs, and of folders that earlier versions named so while they wrote them
_NAME = re.compile(r"\d+(-[a-z]+)?")
_UNFINISHED = re.compile(r"\.\d+(-[a-z]+)?-\w+")
# A row is kept for every motion by this fraction of the size of the structure, and for every interval of this length,
# s.
_SHARE_OF_SIZE = 0.005
_LONGEST_GAP = 5e-3


@dataclass(frozen=True, kw_only=True)
class RunToKeep:
    """A run of a study whose record is to be kept.

    Attributes:
        point: index of the study's point, from 0.
        part: for a search, the process of its transition, such as "folding" or "opening"; "run" for a plain study.
        name: name of its folder: the row of `table.csv`, from 1, and the part.
        design: design to run.
        transition: index of the transition for which a search did this run; None if it is for all of them.
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
        point: index of the study's point, from 0.
        part: see `RunToKeep`.
        folder: path within the study's folder.
        record: record with the rows that `thin_record` keeps.
        outcome: bitwise the same as in the study's table.
        transition: see `RunToKeep`.
    """

    point: int
    part: str
    folder: str
    record: Record
    outcome: Outcome
    transition: int | None = None


def runs_to_keep(study: Study, table: Dataset, most: int = MOST_POINTS) -> list[RunToKeep]:
    """Choose the runs from which the numbers of a table come.

    For a plain study, this is the run of each point. For a search, these are the release after the first transition
    with its least successful value, and the second transition with its own least successful value, starting from the
    state that the search's reference value leads to. If no value succeeds, it is the last one tried, which shows why.

    Args:
        study: the study.
        table: its result.
        most: largest number of points. If there are more, points whose first transition succeeds are chosen, spread
            evenly over the study.

    Raises:
        InputError: `most` is no whole number, or below 0.
    """
    check_most(most)
    width = len(str(len(study.points)))
    runs, structure = [], structure_of(study.base)
    for point in _points(study, table, most):
        try:
            design = with_timestep_for_law(point_design(study.base, study.points[point], study.search))
        except InputError:  # its row says why
            continue
        for part, transition, run_design in _parts(study, structure, table, point, design):
            name = f"{point + 1:0{width}d}{'' if part == 'run' else f'-{part}'}"
            runs.append(RunToKeep(point=point, part=part, name=name, design=run_design, transition=transition))
    return runs


def check_most(most: int) -> None:
    """Reject an invalid number of points before a study that takes a while.

    Raises:
        InputError: it is no whole number, or below 0.
    """
    if not is_whole(most, 0):
        raise InputError(f"need a whole number of points >= 0, got {as_written(most)}")


def kept_runs(
    runs: Sequence[RunToKeep], out: str | Path, *, threads: int = 0, progress: Progress | None = None
) -> Iterator[KeptRun]:
    """Repeat the runs that `runs_to_keep` chose, write each to a folder of its own, and yield them one by one.

    A run whose folder exists is read, not repeated, so an interrupted call can be continued by the same call. Each
    folder, such as `runs/07-folding`, is the folder of a run without its figures. Kept runs that are not in `runs`, or
    that other versions wrote, are removed. Runs are deterministic: their outcomes equal those of the table.

    Only one process at a time keeps runs in a folder. Another one waits, for minutes at most, and then finds the runs
    of the same study there, so shards may end at the same time.

    Args:
        runs: runs to keep.
        out: folder of the study.
        threads: number of threads; 0 for one per core.
        progress: called after every run with the number of kept runs, the number of all runs, and the run's row.

    Raises:
        InputError: the folder cannot be written.
    """
    folder = Path(out) / _FOLDER
    with _alone(Path(out), needed=bool(runs) or folder.exists()):
        clear_leftovers(folder)
        for run in runs:
            clear_leftovers(folder / run.name)
        existing = [run for run in runs if holds_run(folder / run.name, row_key(run.design))]
        names = {run.name for run in existing}
        _remove_others(folder, names)
        missing = [run for run in runs if run.name not in names]
        for run in existing:
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
    """Lock a study's folder so that this is the only process that keeps runs in it, if there is anything to do."""
    with ExitStack() as stack:
        try:
            if needed:
                out.mkdir(parents=True, exist_ok=True)
                stack.enter_context(hold_lock(out / f".{_FOLDER}.lock"))
        except OSError as error:
            raise InputError(f"{out}: cannot be written: {error.strerror}") from None
        yield


def _points(study: Study, table: Dataset, most: int) -> list[int]:
    """Return the indices of the points whose runs are kept."""
    if len(study.points) <= most:
        return list(range(len(study.points)))
    successful = np.flatnonzero(_worked(study, table).ravel())
    chosen = np.unique(np.linspace(0, len(successful) - 1, min(len(successful), most)).round().astype(int))
    return [int(index) for index in successful[chosen]]


def _worked(study: Study, table: Dataset) -> Flags:
    """Return whether each point reached the first state of the study."""
    if study.search is not None:
        return np.asarray(np.isfinite(table[study.search.first.result_name].values))
    transitions = structure_of(study.base).transitions
    if not transitions:
        return np.ones(table["verdict"].shape, dtype=bool)
    return np.asarray(table[transitions[0].state].values, dtype=bool)


def _parts(
    study: Study, structure: Structure, table: Dataset, point: int, design: Design
) -> Iterator[tuple[str, int | None, Design]]:
    """Yield the runs of one point from which a row of the table comes, with names and indices of their transitions."""
    search = study.search
    if search is None:
        yield "run", None, design
        return
    first, second = search.first, search.second
    least = float(table[first.result_name].values.ravel()[point])
    # an inconclusive run shows nothing
    verdict = Verdict(str(table["verdict"].values.ravel()[point]))
    conclusive = verdict.conclusive or verdict is Verdict.UNDECIDED
    part = _part_name(structure, first)
    if math.isnan(least):
        if conclusive:
            yield *part, first_design(design, search, first.values[-1])
        return
    released = search.next_drive is not None
    yield *part, (release_design if released else first_design)(design, search, least)
    if second is None:
        return
    least = float(table[second.result_name].values.ravel()[point])
    if conclusive or not math.isnan(least):
        value = second.values[-1] if math.isnan(least) else least
        yield *_part_name(structure, second), second_design(design, search, value)


def _part_name(structure: Structure, step: SearchStep) -> tuple[str, int | None]:
    """Return the name of a search's run in its folder, such as "folding", and the index of its transition."""
    transition = transition_of(structure, step.drive)
    if transition is None:
        return step.transition, None
    return transition.wording.doing.replace(" ", "-"), structure.transitions.index(transition)


def _run(runs: Sequence[RunToKeep], threads: int) -> Iterator[tuple[RunToKeep, Record]]:
    """Run designs side by side. Designs that cannot be built are omitted; their rows say why."""
    for number, record in run_each([run.design for run in runs], threads):
        if not isinstance(record, InputError):
            yield runs[number], record


def _keep(folder: Path, run: RunToKeep, record: Record) -> KeptRun:
    """Write a run's folder completely or not at all."""
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
    """Remove kept runs that are not wanted. Files of other origin stay."""
    try:
        for entry in folder.iterdir() if folder.is_dir() else ():
            if _UNFINISHED.fullmatch(entry.name):  # left by a process that was killed while it wrote
                shutil.rmtree(entry, ignore_errors=True)
            elif _NAME.fullmatch(entry.name) and entry.is_dir() and entry.name not in wanted:
                clear_leftovers(entry)
                remove_run(entry)
                if not any(entry.iterdir()):
                    entry.rmdir()
        if not wanted and folder.is_dir() and not any(folder.iterdir()):
            folder.rmdir()
    except OSError as error:
        raise InputError(f"{folder}: cannot be written: {error.strerror}") from None


def thin_record(record: Record) -> Record:
    """Remove rows in which little moves.

    Rows that `measure` evaluates are kept, so that the outcome is bitwise the same: both ends of every stage and the
    protocol's window before its end. Otherwise a row is kept whenever some point has moved by 0.5 % of the size of the
    structure along its path since the last kept row, and every 5 ms.

    Args:
        record: sampled at an interval.

    Returns:
        The same run with fewer rows.
    """
    drawn, nodes = drawn_points(record.structure), record.series["membrane_position"]
    points = np.concatenate([record.series["point_position"][:, drawn], nodes], axis=1)
    size = float(np.ptp(points[0], axis=0).max())
    kept = _needed(record)
    with np.errstate(over="ignore", invalid="ignore"):  # of a run that diverged
        moved = np.linalg.norm(np.diff(points, axis=0), axis=2).max(axis=1)
        progress = np.stack(
            [np.cumsum(moved) / (_SHARE_OF_SIZE * size), (record.time[1:] - record.time[0]) / _LONGEST_GAP]
        )
        kept[1:] |= (np.diff(np.floor(progress), prepend=0.0) > 0).any(axis=0)
    kept[[0, -1]] = True
    return replace(record, time=record.time[kept], series={name: rows[kept] for name, rows in record.series.items()})


def _needed(record: Record) -> Flags:
    """Return the rows from which states and transitions are computed, (time,)."""
    protocol = record.design.protocol
    half = float(protocol.timestep) / 2  # times are multiples of the timestep up to rounding
    needed = np.zeros(len(record.time), dtype=bool)
    for end in record.stages:
        window = record.time >= max(end.start, end.end - protocol.window) - half
        needed |= window & (record.time <= end.end + half)
        needed[[int(np.argmin(np.abs(record.time - moment))) for moment in (end.start, end.end)]] = True
    return needed
