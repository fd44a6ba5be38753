"""Run a study: missing runs are done, existing rows are kept, and the table is built at the end."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from forficula.cores import usable_cores
from forficula.design import Design
from forficula.dynamics import tried_transition
from forficula.errors import InputError
from forficula.names import check_whole
from forficula.structure import Structure, structure_of
from forficula.study.refine.rounds import refined_study
from forficula.study.running.attempt_writer import attempt
from forficula.study.running.evaluate import evaluate, row_key
from forficula.study.running.journal import Row, are_others_complete, open_journal, stored_rows
from forficula.study.running.plan import StudyPlan
from forficula.study.running.runs import trial_chains
from forficula.study.running.stored_rows import StoredRows
from forficula.study.search import most_runs, reached_state, search_designs
from forficula.study.study import Study
from forficula.study.tables.table import build_table

if TYPE_CHECKING:
    import xarray

Progress = Callable[[int, int, Row], None]
# computes rows of designs; the second argument is `until_last` of `run_each`
Evaluate = Callable[[Sequence[Design], bool], Iterator[Row]]

Building = Callable[[int, int], None]

# Number of points whose designs are built before the first of them runs, which takes a few seconds.
_WINDOW = 1024
# Number of missing runs that are counted; there may be more.
_MOST_COUNTED = 10_000
# Runs side by side in one batch: large enough that a few slow runs do not leave a core idle for long.
_BATCH = 1024


def run_study(
    study: Study,
    out: str | Path,
    *,
    shard: tuple[int, int] = (1, 1),
    threads: int = 0,
    batch: int = _BATCH,
    cluster: Evaluate | None = None,
    progress: Progress | None = None,
    building: Building | None = None,
) -> xarray.Dataset | None:
    """Do the missing runs of a study and build its table.

    Args:
        study: study to run.
        out: folder with the rows. An interrupted study continues there.
        shard: number, from 1, and count. Only every count-th point runs, so that several machines can share a study.
        threads: number of threads; 0 for one per core.
        batch: number of runs side by side.
        cluster: function that computes rows of designs, from `dask_cluster`; by default this machine computes them.
        progress: called after every run with the number of completed runs, the number of runs known to be needed, and
            the row. A run that a search no longer needs counts as completed, so the number of needed runs never
            shrinks.
        building: called now and then, while points are checked that do not run in this call, with the number of
            checked points and the number of all of them.

    Returns:
        The table, or None if points of other shards are missing.

    Raises:
        InputError: the folder has another study's rows or cannot be written, or a number is not allowed.
    """
    if not 1 <= shard[0] <= shard[1]:
        raise InputError(f"shard: need a number from 1 to the count, got {shard[0]} of {shard[1]}")
    for name, value, least in (("threads", threads, 0), ("batch", batch, 1)):
        check_whole(name, value, least)
    if study.boundaries is not None:
        if shard[1] > 1:
            raise InputError(f"shard: {REFINE_ALONE}")
        counted = _CountOfRounds(progress)

        def run_round(part: Study) -> xarray.Dataset:
            table = _run_points(part, out, shard, threads, batch, cluster, counted.report, building)
            counted.end_round()
            assert table is not None
            return table

        return collect_points(refined_study(study, run_round), out, building)
    return _run_points(study, out, shard, threads, batch, cluster, progress, building)


# a study that locates boundaries cannot be divided in advance
REFINE_ALONE = (
    'the points of a study with method = "refine" depend on the results of earlier points, so they cannot be'
    " divided in advance; run the study on one machine or on a Dask cluster. The initial grid can be divided: run the"
    " same study without [sampling] in shards, and then this study in the same folder, which reuses the rows"
)


class _CountOfRounds:
    """Numbers of completed and needed runs over several rounds."""

    def __init__(self, progress: Progress | None) -> None:
        self._progress, self._before, self._needed = progress, 0, 0

    def report(self, done: int, needed: int, row: Row) -> None:
        """Report a completed run of the present round."""
        self._needed = needed
        if self._progress is not None:
            self._progress(self._before + done, self._before + needed, row)

    def end_round(self) -> None:
        """Add the runs of the present round to those of earlier rounds."""
        self._before, self._needed = self._before + self._needed, 0


def _run_points(
    study: Study,
    out: str | Path,
    shard: tuple[int, int],
    threads: int,
    batch: int,
    cluster: Evaluate | None,
    progress: Progress | None,
    building: Building | None,
) -> xarray.Dataset | None:
    """Do the missing runs of fixed points; see `run_study`."""
    folder = Path(out)
    rows, plan = stored_rows(folder, study.base, shard), StudyPlan(study)
    points_of_shard = range(shard[0] - 1, len(plan), shard[1])
    count, searches = RunCount(0, len(points_of_shard)), study.search is not None
    with open_journal(folder, study.base, shard) as journal, attempt(journal, study) as writer:
        # the first points run before the designs of the last ones are built
        for first in range(0, len(points_of_shard), _WINDOW):
            window = points_of_shard[first : first + _WINDOW]
            done, designs = _split(plan, window, rows)
            count.reach(len(window), len(done | _known(study, designs, rows)))
            while missing := _missing_by_point(study, designs, rows):
                count.plan(missing)
                planned = _joined(missing)
                todo, complete = list(planned.values()), first + len(window) - len(missing)
                trials = Trials(structure_of(study.base), planned) if searches else None
                for row in _in_batches(todo, threads, batch, searches) if cluster is None else cluster(todo, searches):
                    rows.add(row, journal.path, writer.append(row))
                    count.count(row["key"], () if trials is None else trials.needless(row))
                    writer.report(complete if searches else count.done, count.needed - count.done)
                    if progress is not None:
                        progress(count.done, count.needed, row)
            writer.report(first + len(window), count.needed - count.done)
    if shard[1] > 1:
        if not are_others_complete(folder, shard):
            return None
        rows = stored_rows(folder, study.base)
    if shard[1] > 1 and next(_missing(plan, rows, building), None) is not None:
        return None
    return build_table(study, plan, rows)


def _in_batches(designs: Sequence[Design], threads: int, batch: int, until_last: bool) -> Iterator[Row]:
    for first in range(0, len(designs), batch):
        yield from evaluate(designs[first : first + batch], threads, until_last=until_last)


def collect(study: Study, out: str | Path, building: Building | None = None) -> xarray.Dataset:
    """Build the table from the rows of all shards.

    Args:
        study: the study.
        out: folder with the rows.
        building: see `run_study`.

    Raises:
        InputError: rows are missing (the message has their number), or the folder has another study's rows.
    """
    if study.boundaries is not None:
        study = refined_study(study, lambda part: collect_points(part, out))
    return collect_points(study, out, building)


def collect_points(study: Study, out: str | Path, building: Building | None = None) -> xarray.Dataset:
    """Build the table of fixed points from the rows in a folder; see `collect`."""
    folder = Path(out)
    rows, plan = stored_rows(folder, study.base), StudyPlan(study)
    keys: set[str] = set()
    for point in _missing(plan, rows, building):
        keys |= point.keys()
        if len(keys) > _MOST_COUNTED:
            break
    if keys:
        number = f"more than {_MOST_COUNTED}" if len(keys) > _MOST_COUNTED else len(keys)
        remedy = "run the remaining shards" if study.boundaries is None else "run the study without --collect"
        raise InputError(f"{folder}: {number} runs are missing; {remedy}, then collect")
    table = build_table(study, plan, rows)
    if study.boundaries is not None:
        table.attrs["point_runs"] = len(_known(study, plan, rows))
    return table


def estimate(
    study: Study, out: str | Path, building: Building | None = None, *, shard: tuple[int, int] = (1, 1)
) -> tuple[int, int, float]:
    """Estimate a study or a shard of it: largest number of runs, number of unfinished points, and time for these, s.

    The number of runs of a search depends on their results. For the time, one point for each core of this machine is
    run now, side by side, as the study does. These points are spread evenly over the study.

    Args:
        study: study to run.
        out: folder with rows, if there are any.
        building: see `run_study`.
        shard: see `run_study`.
    """
    rows, plan = stored_rows(Path(out), study.base, shard), StudyPlan(study)
    points_of_shard = range(shard[0] - 1, len(plan), shard[1])
    most = len(points_of_shard) * (1 if study.search is None else most_runs(study.search))
    left = _number_left(plan, points_of_shard, rows, building)
    if not left:
        return most, 0, 0.0
    count = min(usable_cores(), len(points_of_shard))
    spread = [points_of_shard[(2 * place + 1) * len(points_of_shard) // (2 * count)] for place in range(count)]
    designs = {number: plan[number] for number in spread}
    measured: dict[str, Row] = {}
    start = time.perf_counter()
    while points := _missing_by_point(study, designs, measured):
        measured |= {row["key"]: row for row in evaluate(list(_joined(points).values()), until_last=True)}
    return most, left, (time.perf_counter() - start) * left / count


def _split(plan: StudyPlan, numbers: range, rows: Mapping[str, Row]) -> tuple[set[str], dict[int, Design | str]]:
    """Return the keys of rows that some points need and have, and the designs of all other points."""
    keys = dict(zip(numbers, plan.keys_without_designs(numbers), strict=True))
    done = {number: key for number, key in keys.items() if key is not None and key in rows}
    return set(done.values()), {number: plan[number] for number in numbers if number not in done}


def _missing(
    plan: StudyPlan, rows: Mapping[str, Row], building: Building | None, numbers: range | None = None
) -> Iterator[dict[str, Design]]:
    """Yield the missing runs of every incomplete point, by default of all points; see `_missing_by_point`."""
    numbers = range(len(plan)) if numbers is None else numbers
    for first in range(0, len(numbers), _WINDOW):
        window = numbers[first : first + _WINDOW]
        _, designs = _split(plan, window, rows)
        yield from _missing_by_point(plan.study, designs, rows)
        if building is not None:
            building(first + len(window), len(numbers))


def _number_left(plan: StudyPlan, numbers: range, rows: StoredRows, building: Building | None) -> int:
    """Return the number of incomplete points among those with these numbers.

    Of more than 10 000 points, those without a valid design count too, because their designs are not built.
    """
    if len(numbers) <= _MOST_COUNTED:
        return sum(1 for _ in _missing(plan, rows, building, numbers))
    if not rows:
        return len(numbers)
    left = 0
    for first in range(0, len(numbers), _WINDOW):
        window = numbers[first : first + _WINDOW]
        keys = dict(zip(window, plan.keys_without_designs(window), strict=True))
        left += sum(key not in rows for key in keys.values() if key is not None)
        unknown = {number: plan[number] for number, key in keys.items() if key is None}
        left += len(_missing_by_point(plan.study, unknown, rows))
        if building is not None:
            building(first + len(window), len(numbers))
    return left


def _needed_runs(study: Study, design: Design, rows: Mapping[str, Row]) -> dict[str, Design]:
    """Return the runs that a point needs as far as the rows show, by key, in the order in which they are tried."""
    return {row_key(design): design} if study.search is None else search_designs(design, study.search, rows)


def _known(study: Study, designs: Mapping[int, Design | str], rows: Mapping[str, Row]) -> set[str]:
    """Return the keys of needed runs that are in the rows."""
    return {
        key
        for design in designs.values()
        if isinstance(design, Design)
        for key in _needed_runs(study, design, rows)
        if key in rows
    }


def _missing_by_point(
    study: Study, designs: Mapping[int, Design | str], rows: Mapping[str, Row]
) -> list[dict[str, Design]]:
    """Return the missing runs of every incomplete point, by key, in the order in which they are tried."""
    points = [
        {key: run for key, run in _needed_runs(study, design, rows).items() if key not in rows}
        for design in designs.values()
        if isinstance(design, Design)
    ]
    return [point for point in points if point]


def _joined(points: Iterable[Mapping[str, Design]]) -> dict[str, Design]:
    """Return the runs of all points; shared runs occur once."""
    return {key: design for point in points for key, design in point.items()}


class Trials:
    """Planned runs of a search. The row of a run can make others needless, see `TrialChains`."""

    def __init__(self, structure: Structure, planned: Mapping[str, Design]) -> None:
        """Start with planned runs by the keys of their rows, and with a structure that has their drives."""
        self._keys, self._numbers = list(planned), {key: number for number, key in enumerate(planned)}
        self._chains = trial_chains(list(planned.values()), structure)
        tried = [tried_transition(design, structure) for design in planned.values()]
        self._states = ["" if transition is None else transition.state for transition in tried]

    def needless(self, row: Row) -> list[str]:
        """Return the keys of the runs that a row makes needless."""
        number = self._numbers[row["key"]]
        needless = self._chains.needless(number, reached=reached_state(row, self._states[number]))
        return [self._keys[other] for other in needless]


class RunCount:
    """Number of completed and needed runs, as far as results show.

    Runs that a search no longer needs count as completed, so the number of needed runs never shrinks. It grows if
    results require further runs.

    Attributes:
        needed: number of runs, including completed ones.
    """

    def __init__(self, done: int, later: int = 0) -> None:
        """Start with completed runs and with later points; a later point counts as one run for now."""
        self.needed = done + later
        self._later, self._spare = later, 0
        self._open: set[str] = set()

    @property
    def done(self) -> int:
        """Number of runs that are completed or no longer needed."""
        return self.needed - len(self._open) - self._later

    def reach(self, points: int, done: int) -> None:
        """Start a number of later points, some of whose runs are completed already."""
        self._later -= points
        self._spare = max(points - done, 0)
        self.needed += max(done - points, 0)

    def plan(self, points: Iterable[Iterable[str]]) -> None:
        """Set the missing runs: their keys by point."""
        keys = {key for point in points for key in point}
        self.needed += max(len(keys - self._open) - self._spare, 0)
        self._spare = 0
        self._open = keys

    def count(self, key: str, needless: Iterable[str] = ()) -> None:
        """Count a completed run, and the runs that its result makes needless."""
        self._open.discard(key)
        self._open.difference_update(needless)
