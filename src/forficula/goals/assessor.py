"""Rows of designs in batches: known rows are read from the journal, missing ones are computed and appended."""

from __future__ import annotations

import time
from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path

from forficula.analysis import Ending, Verdict
from forficula.design import Design, key_value
from forficula.errors import InputError
from forficula.goals.outcome_quantity import SOURCES, STATIC, OutcomeQuantity, Source, quantities_of
from forficula.goals.static_values import static_values
from forficula.names import check_whole
from forficula.serial import unit_suffix
from forficula.study.running.evaluate import ending_row, evaluate, row_key
from forficula.study.running.journal import Journal, Row, open_journal, read_rows
from forficula.study.running.run_study import Evaluate, Progress
from forficula.study.search import search_designs, search_result
from forficula.study.search_steps import Search

# Runs side by side: enough that a few slow ones do not leave a core idle for long. Whole records need more memory.
_BATCH, _WHOLE_BATCH = 512, 48
# How long a shard waits for rows of others before it computes them itself, and how often it checks.
_PATIENCE_SECONDS, _LOOK_SECONDS = 60.0, 0.5

Values = Mapping[str, object]


@dataclass(frozen=True, kw_only=True)
class _Task:
    """A row to compute: of a design, from a source."""

    key: str
    design: Design
    source: Source


@dataclass(kw_only=True)
class Assessor:
    """Computes rows of designs, each only once.

    A row depends on its design alone, not on the order, the other designs or the process that computes it. Therefore a
    method that requests batches and decides by their rows gives the same result if it is interrupted and continued, or
    if several machines share the work.

    Attributes:
        folder: folder with the journals.
        base: design from which all others are derived.
        journal: journal to append to.
        rows: known rows, by key.
        shard: number, from 1, and count of the processes that share the work.
        threads: number of threads; 0 for one per core.
        cluster: computes rows of runs; None for this machine. Whole records are always evaluated on this machine.
        progress: called after every row with the number of completed rows, the number of requested ones, and the row.
        done: number of rows that were computed or received from other shards.
        wanted: number of rows that were requested and unknown.
    """

    folder: Path
    base: Design
    journal: Journal
    rows: dict[str, Row]
    shard: tuple[int, int]
    threads: int
    cluster: Evaluate | None
    progress: Progress | None
    done: int = field(default=0)
    wanted: int = field(default=0)

    def __call__(
        self,
        designs: Sequence[Design | str],
        sources: Collection[Source],
        *,
        points: Sequence[Values] = (),
        search: Search | None = None,
    ) -> list[Row]:
        """Return the rows of designs, in their order.

        Args:
            designs: designs, or why there is none, which also gives a row.
            sources: sources of the requested quantities.
            points: values of each design that differ from the base, for people who read the journal.
            search: search for least values, needed if "search" is among the sources.

        Returns:
            For each design one row with all sources, including the least values of a search, see `search_result`.
        """
        values = dict(zip((_name(design) for design in designs), points, strict=False))
        designs_by_name = {_name(design): design for design in designs if isinstance(design, Design)}
        # a whole record contains what an ordinary run contains
        plain = "record" if "record" in sources else "run"
        kinds = [source for source in SOURCES if source in sources and source in (*STATIC, plain)]
        self._work_out(
            [
                _Task(key=_key(design, kind), design=design, source=kind)
                for design in designs_by_name.values()
                for kind in kinds
            ],
            values,
        )
        if search is not None and "search" in sources:
            self._search(list(designs_by_name.values()), search, values)
        return [self._row(design, kinds, search if "search" in sources else None) for design in designs]

    def _row(self, design: Design | str, kinds: Sequence[Source], search: Search | None) -> Row:
        if isinstance(design, str):
            return ending_row(Ending(verdict=Verdict.NOT_BUILT, why=design))
        row: Row = {}
        for kind in kinds:
            row |= self.rows[_key(design, kind)]
        if search is not None:
            result = search_result(design, search, self.rows)
            row |= {f"{step.result_name}{unit_suffix(step.unit.si)}": result[step.result_name] for step in search.steps}
        return row

    def _search(self, designs: Sequence[Design], search: Search, values: Mapping[str, Values]) -> None:
        """Do the runs that a search for least values needs for every design, one value after another."""
        while True:
            designs_by_key = {
                key: searched
                for design in designs
                for key, searched in search_designs(design, search, self.rows).items()
            }
            tasks = [_Task(key=key, design=searched, source="search") for key, searched in designs_by_key.items()]
            if all(task.key in self.rows for task in tasks):
                return
            self._work_out(tasks, values)

    def agreed(self, row: Row) -> Row:
        """Return the row of the journal with the key of a row. If there is none, append the given row.

        With several shards, the first appends and the others wait for its row, so that all continue with the same row.
        """
        key = row["key"]
        if key not in self.rows and self.shard[0] > 1:
            self._awaited([key])
        if key not in self.rows:
            self.journal.append(row)
            self.rows[key] = row
        return self.rows[key]

    def _work_out(self, tasks: Sequence[_Task], values: Mapping[str, Values]) -> None:
        """Compute the missing rows of this shard, then wait for those of the other shards."""
        tasks_by_key = {task.key: task for task in tasks}
        if self.shard[1] > 1 and any(key not in self.rows for key in tasks_by_key):
            self.rows |= read_rows(self.folder, self.base)
        missing = [task for task in tasks_by_key.values() if task.key not in self.rows]
        self.wanted += len(missing)
        positions = {key: position for position, key in enumerate(tasks_by_key)}
        own_tasks = [task for task in missing if positions[task.key] % self.shard[1] == self.shard[0] - 1]
        self._make(own_tasks, values)
        others = [task for task in missing if task.key not in self.rows]
        late = self._awaited([task.key for task in others])
        self.done += len(others) - len(late)
        self._make([task for task in others if task.key in late], values)

    def _awaited(self, keys: Collection[str]) -> set[str]:
        """Wait for rows of other shards, and return the keys of those that did not arrive in time."""
        late = set(keys)
        last_arrival = time.monotonic()
        while late:
            time.sleep(_LOOK_SECONDS)
            self.rows |= read_rows(self.folder, self.base)
            arrived = {key for key in late if key in self.rows}
            late -= arrived
            if arrived:
                last_arrival = time.monotonic()
            elif time.monotonic() - last_arrival > _PATIENCE_SECONDS:
                break
        return late

    def _make(self, tasks: Sequence[_Task], values: Mapping[str, Values]) -> None:
        """Compute rows on this machine or on the cluster, and append them as they arrive."""
        static = [task for task in tasks if task.source in STATIC]
        known = quantities_of(self.base) if static else {}
        for task in static:
            self._keep(_static_row(task, known), values.get(task.design.hash))
        names = {task.key: task.design.hash for task in tasks}
        runs = [task.design for task in tasks if task.source in ("run", "search")]
        until_last = any(task.source == "search" for task in tasks)
        for row in self._run(runs, until_last):
            self._keep(row, values.get(names.get(row["key"], "")))
        whole = [task.design for task in tasks if task.source == "record"]
        for first in range(0, len(whole), _WHOLE_BATCH):
            for row in evaluate(whole[first : first + _WHOLE_BATCH], self.threads, whole=True):
                self._keep(row, values.get(names.get(row["key"], "")))

    def _run(self, designs: Sequence[Design], until_last: bool) -> Iterator[Row]:
        if self.cluster is not None and designs:
            yield from self.cluster(designs, until_last)
            return
        for first in range(0, len(designs), _BATCH):
            yield from evaluate(designs[first : first + _BATCH], self.threads, until_last=until_last)

    def _keep(self, row: Row, values: Values | None) -> None:
        row = row if values is None else {**row, "values": dict(values)}
        self.journal.append(row)
        self.rows[row["key"]] = row
        self.done += 1
        if self.progress is not None:
            self.progress(self.done, self.wanted, row)


@contextmanager
def open_assessor(
    folder: str | Path,
    base: Design,
    *,
    shard: tuple[int, int] = (1, 1),
    threads: int = 0,
    cluster: Evaluate | None = None,
    progress: Progress | None = None,
) -> Iterator[Assessor]:
    """Open a folder whose journal has the rows of designs derived from one design, and continue it.

    Args:
        folder: created if missing.
        base: design from which all others are derived.
        shard: number, from 1, and count of processes. They share every batch, wait for each other's rows, and get the
            same result. A process that has been gone for a minute is ignored.
        threads: number of threads; 0 for one per core.
        cluster: cluster from `dask_cluster`.
        progress: called after every row.

    Raises:
        InputError: a number is not allowed, or the folder has another design's rows or cannot be written.
    """
    if not 1 <= shard[0] <= shard[1]:
        raise InputError(f"shard: need a number from 1 to the count, got {shard[0]} of {shard[1]}")
    check_whole("threads", threads, 0)
    folder = Path(folder)
    rows = read_rows(folder, base)
    with open_journal(folder, base, shard) as journal:
        yield Assessor(
            folder=folder,
            base=base,
            journal=journal,
            rows=rows,
            shard=shard,
            threads=threads,
            cluster=cluster,
            progress=progress,
        )


def value_of(row: Row, quantity: OutcomeQuantity, design: Design | str) -> float | None:
    """Return a quantity of a design, SI, from its row; None if missing."""
    if quantity.source == "design":
        value = None if isinstance(design, str) else key_value(design, quantity.name)
    else:
        value = row.get(quantity.column)
    return float(value) if isinstance(value, int | float) and not isinstance(value, bool) else None


def _static_row(task: _Task, known: Mapping[str, OutcomeQuantity]) -> Row:
    """Return the row of static values of a design; if they cannot be computed, a row with the reason."""
    try:
        statics = static_values(task.design, [task.source])
    except InputError as error:
        return {"key": task.key, "refused": str(error)}
    columns = {known[name].column: value for name, value in statics.items() if name in known}
    return {"key": task.key, **{name: None if value is None else float(value) for name, value in columns.items()}}


def _name(design: Design | str) -> str:
    return design if isinstance(design, str) else design.hash


def _key(design: Design, source: Source) -> str:
    match source:
        case "record":
            return row_key(design, whole=True)
        case "run":
            return row_key(design)
        case _:
            return f"{row_key(design)}-{source}"
