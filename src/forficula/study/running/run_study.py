"""A whole study: what is missing is run, what is there is kept, and the table is built at the end."""

from __future__ import annotations

import time
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from forficula.design import Design
from forficula.errors import InputError
from forficula.names import check_whole
from forficula.study.running.evaluate import evaluate, row_key
from forficula.study.running.journal import Row, open_journal, read_rows
from forficula.study.search import most_runs, point_design, search_designs
from forficula.study.study import Study
from forficula.study.tables.table import build_table

if TYPE_CHECKING:
    import xarray

Progress = Callable[[int, int, Row], None]
# rows of designs, as `evaluate` makes them on this machine; the second argument is its `until_last`
Evaluate = Callable[[Sequence[Design], bool], Iterator[Row]]

Building = Callable[[int, int], None]

# Points whose designs are built before the first of them runs: a few seconds.
_WINDOW = 1024
# Runs side by side in one batch: enough that a few slow ones do not leave a core idle for long.
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
    """Run what a study lacks and build its table.

    Args:
        study: what to run.
        out: folder with the rows; a study that was stopped goes on there.
        shard: number, from 1 on, and count: only every count-th point runs, so that machines can share a study.
        threads: 0 for one a core.
        batch: runs side by side.
        cluster: what makes rows of designs, from `dask_cluster`; the cores of this machine do, if not given.
        progress: called after every run with the runs done, the runs known to be needed, and the row; a run that a
            search turns out to do without counts as done, and what is needed never shrinks.
        building: called now and then while designs are built that do not run here, with how many are and of how many.

    Returns:
        The table, or None where points of other shards are missing.

    Raises:
        InputError: the folder holds another study's rows, or cannot be written; a number is not allowed.
    """
    if not 1 <= shard[0] <= shard[1]:
        raise InputError(f"shard: need a number from 1 to the count, got {shard[0]} of {shard[1]}")
    for name, value, least in (("threads", threads, 0), ("batch", batch, 1)):
        check_whole(name, value, least)
    folder = Path(out)
    rows = read_rows(folder, study.base)
    mine = range(shard[0] - 1, len(study.points), shard[1])
    designs: dict[int, Design | str] = {}
    second = study.search.second if study.search is not None else None
    count = RunCount(0, len(mine), "" if second is None else second.state)
    with open_journal(folder, study.base, shard) as journal:
        # the first of many points run before the last of them are built
        for first in range(0, len(mine), _WINDOW):
            window = {number: _design(study, number) for number in mine[first : first + _WINDOW]}
            designs |= window
            count.reach(len(window), len(_known(study, window, rows)))
            while points := _missing_by_point(study, window, rows):
                count.plan([list(point) for point in points])
                todo = list(_joined(points).values())
                searches = study.search is not None
                for row in _in_batches(todo, threads, batch, searches) if cluster is None else cluster(todo, searches):
                    journal.append(row)
                    rows[row["key"]] = row
                    count.count(row)
                    if progress is not None:
                        progress(count.done, count.needed, row)
    designs = _designs(study, building, designs)
    if _missing_by_point(study, designs, rows):
        return None
    return build_table(study, designs, rows)


def _in_batches(designs: Sequence[Design], threads: int, batch: int, until_last: bool) -> Iterator[Row]:
    for first in range(0, len(designs), batch):
        yield from evaluate(designs[first : first + batch], threads, until_last=until_last)


def collect(study: Study, out: str | Path, building: Building | None = None) -> xarray.Dataset:
    """Build the table from the rows of all shards.

    Args:
        study: what was run.
        out: folder with the rows.
        building: as of `run_study`.

    Raises:
        InputError: rows are missing, and how many; or the folder holds another study's rows.
    """
    folder = Path(out)
    rows, designs = read_rows(folder, study.base), _designs(study, building)
    if points := _missing_by_point(study, designs, rows):
        raise InputError(
            f"{folder}: {len(_joined(points))} runs are missing; run the shards that are not done, then collect"
        )
    return build_table(study, designs, rows)


def estimate(study: Study, out: str | Path, building: Building | None = None) -> tuple[int, int, float]:
    """Say how many runs a study takes at most, how many points are not done, and guess how long these take, s.

    How many runs a search takes depends on what they find. The guess is the time that the middle point takes, measured
    now, times the points that are left.

    Args:
        study: to run.
        out: folder with the rows, if there are any.
        building: as of `run_study`.
    """
    rows, designs = read_rows(Path(out), study.base), _designs(study, building)
    most = len(study.points) * (1 if study.search is None else most_runs(study.search))
    left = len(_missing_by_point(study, designs, rows))
    if not left:
        return most, 0, 0.0
    middle = {0: list(designs.values())[len(designs) // 2]}
    measured: dict[str, Row] = {}
    start = time.perf_counter()
    while points := _missing_by_point(study, middle, measured):
        measured |= {row["key"]: row for row in evaluate(list(_joined(points).values()), until_last=True)}
    return most, left, (time.perf_counter() - start) * left


def _designs(
    study: Study, building: Building | None = None, built: Mapping[int, Design | str] | None = None
) -> dict[int, Design | str]:
    """The design at every point in their order, or why there is none; some are built already."""
    designs: dict[int, Design | str] = {}
    for number in range(len(study.points)):
        designs[number] = (built or {}).get(number) or _design(study, number)
        if building is not None and number not in (built or {}):
            building(number + 1, len(study.points))
    return designs


def _design(study: Study, number: int) -> Design | str:
    """The design at a point, or why there is none."""
    try:
        return point_design(study.base, study.points[number], study.search)
    except InputError as error:
        return str(error)


def _wanted(study: Study, design: Design, rows: Mapping[str, Row]) -> dict[str, Design]:
    """The runs of a point as far as the rows tell, by key, in the order in which they are tried."""
    return {row_key(design): design} if study.search is None else search_designs(design, study.search, rows)


def _known(study: Study, designs: Mapping[int, Design | str], rows: Mapping[str, Row]) -> set[str]:
    """Keys of the runs that are wanted and are in the rows."""
    return {
        key
        for design in designs.values()
        if isinstance(design, Design)
        for key in _wanted(study, design, rows)
        if key in rows
    }


def _missing_by_point(
    study: Study, designs: Mapping[int, Design | str], rows: Mapping[str, Row]
) -> list[dict[str, Design]]:
    """Runs that are not in the rows, by key, for every point that lacks some, in the order in which they are tried."""
    points = [
        {key: each for key, each in _wanted(study, design, rows).items() if key not in rows}
        for design in designs.values()
        if isinstance(design, Design)
    ]
    return [point for point in points if point]


def _joined(points: Iterable[Mapping[str, Design]]) -> dict[str, Design]:
    """The runs of all points, one that several share once."""
    return {key: design for point in points for key, design in point.items()}


class RunCount:
    """Runs done and needed, as far as results tell.

    What a search turns out to do without counts as done, so that what is needed never shrinks; it grows where results
    ask for more.

    Attributes:
        needed: runs, those done among them.
    """

    def __init__(self, done: int, later: int = 0, last_state: str = "") -> None:
        """Start with runs that are done, and points that come later, of which each counts as a run for now.

        Args:
            done: runs that are.
            later: points that come later.
            last_state: that a search ends with; of a run that reaches it, none with a larger value is tried.
        """
        self._last_state = last_state
        self.needed = done + later
        self._later, self._spare = later, 0
        self._open: set[str] = set()
        self._points: dict[str, Sequence[str]] = {}

    @property
    def done(self) -> int:
        """Runs done, or not needed any more."""
        return self.needed - len(self._open) - self._later

    def reach(self, points: int, done: int) -> None:
        """Take note of points that came later until now, and of their runs that are done already."""
        self._later -= points
        self._spare = max(points - done, 0)
        self.needed += max(done - points, 0)

    def plan(self, points: Collection[Sequence[str]]) -> None:
        """Take note of the keys of missing runs, by point and in the order in which they are tried."""
        self._points = {key: keys for keys in points for key in keys}
        self.needed += max(len(self._points.keys() - self._open) - self._spare, 0)
        self._spare = 0
        self._open = set(self._points)

    def count(self, row: Row) -> None:
        """Take note of a run that is done; after the one that reaches the last state, no larger value is tried."""
        self._open.discard(row["key"])
        if self._last_state and row.get(self._last_state):
            keys = self._points[row["key"]]
            self._open.difference_update(keys[keys.index(row["key"]) :])
