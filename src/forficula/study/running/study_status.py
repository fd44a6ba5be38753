"""Status of a study: which of its shards are complete, run, or must run again, from the journals in its folder."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from enum import StrEnum
from itertools import groupby
from pathlib import Path
from statistics import median
from typing import TYPE_CHECKING, Annotated

from forficula.errors import InputError
from forficula.quantities import Unit, show_duration
from forficula.serial import Seconds, Written
from forficula.study.factors import MOST_VALUES
from forficula.study.refine.rounds import refined_study
from forficula.study.running.attempt_writer import study_mark
from forficula.study.running.attempts import STALE, Attempt, attempts_in, file_clock
from forficula.study.running.journal import journals, read_journal, shard_of
from forficula.study.running.run_study import collect_points
from forficula.study.study import Study

if TYPE_CHECKING:
    from xarray import Dataset

PerSecond = Annotated[float, Unit("1/s")]

# [chosen] a shard is slow if its runs take this number of times as long as those of the median shard
_SLOW = 2.0
# [chosen] number of runs of a shard from which its rate is compared
_FEWEST_RUNS = 3


class ShardState(StrEnum):
    """State of a shard.

    DONE: all its points are complete, and all rows are intact. RUNNING: a process runs it. STALE: its process has
    written nothing for five minutes and has probably been killed. FAILED: its process ended with an error, or rows are
    damaged or were written by another version. MISSING: there is no journal of this study.
    """

    DONE = "done"
    RUNNING = "running"
    STALE = "stale"
    FAILED = "failed"
    MISSING = "missing"


_TO_RUN = (ShardState.STALE, ShardState.FAILED, ShardState.MISSING)


@dataclass(frozen=True, kw_only=True)
class ShardStatus:
    """Status of one shard.

    Attributes:
        number: number of the shard, from 1.
        state: its state.
        points: number of its points.
        points_done: number of its points that are complete, as its process reported at most half a minute before.
        rate: runs per second of the last process; None before it reports a run.
        time_left: time until the shard is complete at this rate; None unless it runs and has a rate.
        age: time since the last change of its journal; None without a journal.
        host: machine of the last process; empty if unknown.
        job: job of the last process in its engine; empty if unknown.
        why: reason why the shard must run again; empty if it need not.
        slow: whether its runs take more than twice as long as those of the median shard.
    """

    number: int
    state: ShardState
    points: int
    points_done: int = 0
    rate: PerSecond | None = None
    time_left: Seconds | None = None
    age: Seconds | None = None
    host: str = ""
    job: str = ""
    why: str = ""
    slow: bool = False


@dataclass(frozen=True, kw_only=True)
class StudyStatus:
    """Status of a study.

    Attributes:
        name: name of the study.
        points: number of its points.
        shards: status of every shard; empty if no process has started.
    """

    name: str
    points: int
    shards: tuple[ShardStatus, ...]

    @property
    def points_done(self) -> Annotated[int, Written.ALWAYS]:
        """Number of points that are complete."""
        return sum(shard.points_done for shard in self.shards)

    @property
    def complete(self) -> Annotated[bool, Written.FIRST]:
        """Whether all shards are done."""
        return bool(self.shards) and all(shard.state is ShardState.DONE for shard in self.shards)

    @property
    def rate(self) -> PerSecond | None:
        """Runs per second of all running shards; None if no shard runs."""
        rates = [shard.rate for shard in self.shards if shard.state is ShardState.RUNNING and shard.rate is not None]
        return sum(rates) if rates else None

    @property
    def time_left(self) -> Seconds | None:
        """Time until the last running shard is complete; None if unknown."""
        return max((shard.time_left for shard in self.shards if shard.time_left is not None), default=None)

    @property
    def run_again(self) -> Annotated[str, Written.ALWAYS]:
        """Numbers of the stale, failed and missing shards as in the option --array of SLURM, such as "3,17,40-44"."""
        return array_expression([shard.number for shard in self.shards if shard.state in _TO_RUN])

    def shards_in(self, state: ShardState) -> list[ShardStatus]:
        """Return the shards in a state."""
        return [shard for shard in self.shards if shard.state is state]


def study_status(study: Study, out: str | Path) -> StudyStatus:
    """Return the status of a study from the journals in a folder. The folder is not changed.

    If the study was divided in several ways, the status is that of the division whose journals changed last. That of a
    study that locates boundaries counts the points whose positions follow from the stored rows.

    Args:
        study: the study.
        out: its folder.

    Raises:
        InputError: the folder cannot be read.
    """
    folder = Path(out)
    if study.boundaries is None:
        return _status(study, folder)
    done, study = _last_round(study, folder)
    status = _status(study, folder)
    shards = status.shards
    if done and not shards:
        points = len(study.points)
        why = "no process has started the points that follow from those that are complete"
        shards = (ShardStatus(number=1, state=ShardState.MISSING, points=points, why=why),)
    if shards:
        shards = (_undivided(shards, done),)
    return replace(status, points=done + len(study.points), shards=shards)


def _undivided(shards: Sequence[ShardStatus], done: int) -> ShardStatus:
    """Return the status of a round as that of one shard, although its points may have been those of several shards.

    Args:
        shards: status of every shard.
        done: number of points of earlier rounds.
    """
    unfinished = [shard for shard in shards if shard.state is not ShardState.DONE]
    running = [shard for shard in unfinished if shard.state is ShardState.RUNNING]
    return replace(
        (running or unfinished or shards)[0],
        number=1,
        points=done + sum(shard.points for shard in shards),
        points_done=done + sum(shard.points_done for shard in shards),
    )


def _last_round(study: Study, folder: Path) -> tuple[int, Study]:
    """Return the number of points of the complete rounds of a study that locates boundaries, and the round after them.

    If all rounds are complete, the last one is returned.
    """
    rounds: list[Study] = []

    def collected(part: Study) -> Dataset:
        rounds.append(part)
        return collect_points(part, folder)

    with suppress(InputError):  # of the rows that are missing
        refined_study(study, collected)
    return sum(len(part.points) for part in rounds[:-1]), rounds[-1]


def _status(study: Study, folder: Path) -> StudyStatus:
    """Return the status of a study of fixed points; see `study_status`."""
    mark = study_mark(study)
    paths: dict[tuple[int, int], list[_JournalFacts]] = {}
    for path in journals(folder):
        shard = shard_of(path)
        if shard is not None and 1 <= shard[0] <= shard[1] <= MOST_VALUES:
            paths.setdefault(shard, []).append(_facts(study, path, mark))
    latest = max(
        ((facts.changed, shard[1]) for shard, files in paths.items() for facts in files if facts.is_of_study),
        default=None,
    )
    if latest is None:
        return StudyStatus(name=study.name, points=len(study.points), shards=())
    count, now = latest[1], file_clock(folder)
    shards = [_shard(study, (number, count), paths.get((number, count), []), now) for number in range(1, count + 1)]
    return StudyStatus(name=study.name, points=len(study.points), shards=tuple(_with_slow(shards)))


def array_expression(numbers: Sequence[int]) -> str:
    """Return numbers in rising order as in the option --array of SLURM.

    >>> array_expression([3, 17, 40, 41, 42])
    '3,17,40-42'
    """
    parts = []
    for _, group in groupby(enumerate(numbers), lambda item: item[1] - item[0]):
        first, *others = [number for _, number in group]
        parts.append(f"{first}-{others[-1]}" if others else f"{first}")
    return ",".join(parts)


@dataclass(frozen=True, kw_only=True)
class _JournalFacts:
    """Facts of one journal.

    Attributes:
        changed: time of its last change, s, by the clock of the file system.
        error: why it cannot be used; empty if it can.
        keys: keys of its intact rows.
        damaged: number of its damaged rows.
        attempts: processes that ran this study, in the order of their starts.
        later_rows: number of intact rows after the last entry of a process.
    """

    changed: float
    error: str = ""
    keys: frozenset[str] = frozenset()
    damaged: int = 0
    attempts: tuple[Attempt, ...] = ()
    later_rows: int = 0

    @property
    def is_of_study(self) -> bool:
        """Whether a process ran this study, or the journal cannot be read to find out."""
        return bool(self.attempts or self.error)


def _facts(study: Study, path: Path, mark: str) -> _JournalFacts:
    """Read a journal."""
    try:
        changed = path.stat().st_mtime
    except OSError as error:
        return _JournalFacts(changed=0.0, error=f"{path.name}: cannot be read: {error.strerror}")
    keys: set[str] = set()
    entries = []
    damaged = later = 0
    try:
        for _, key, entry in read_journal(path, study.base):
            if key is not None:
                keys.add(key)
                later += 1
            elif entry is None:
                damaged += 1
            else:
                entries.append(entry)
                later = 0
    except InputError as error:
        return _JournalFacts(changed=changed, error=str(error))
    return _JournalFacts(
        changed=changed,
        keys=frozenset(keys),
        damaged=damaged,
        attempts=tuple(attempt for attempt in attempts_in(entries) if attempt.study == mark),
        later_rows=later,
    )


def _shard(study: Study, shard: tuple[int, int], files: Sequence[_JournalFacts], now: float) -> ShardStatus:
    """Return the status of a shard from its journals."""
    number, count = shard
    points = len(range(number - 1, len(study.points), count))
    used = sorted((facts for facts in files if facts.is_of_study), key=lambda facts: facts.changed)
    if not used:
        return ShardStatus(number=number, state=ShardState.MISSING, points=points, why="no process has started")
    last = used[-1]
    age = max(0.0, now - last.changed)
    if errors := [facts.error for facts in used if facts.error]:
        return ShardStatus(number=number, state=ShardState.FAILED, points=points, age=age, why=errors[0])
    attempts = [attempt for facts in used for attempt in facts.attempts]
    rows = len(frozenset().union(*(facts.keys for facts in used)))
    state, why = _state(attempts, rows, points, age)
    if state is ShardState.FAILED and (damaged := sum(facts.damaged for facts in used)):
        why += f" ({damaged} damaged)"
    attempt = next((item for item in reversed(attempts) if not item.ended), attempts[-1])
    # a run is a point of a study without a search
    done = max(item.points for item in attempts)
    if state is ShardState.DONE:
        done = points
    elif study.search is None and not last.attempts[-1].ended:
        done = min(points, max(done, last.attempts[-1].points + last.later_rows))
    rate = attempt.rows / attempt.seconds if attempt.rows and attempt.seconds else None
    left = attempt.runs_left / rate if state is ShardState.RUNNING and rate else None
    return ShardStatus(
        number=number,
        state=state,
        points=points,
        points_done=done,
        rate=rate,
        time_left=left,
        age=age,
        host=attempt.host,
        job=attempt.job,
        why=why,
    )


def _state(attempts: Sequence[Attempt], rows: int, points: int, age: float) -> tuple[ShardState, str]:
    """Return the state of a shard, and why it must run again."""
    complete = [attempt for attempt in attempts if attempt.ended and not attempt.why and attempt.points == points]
    stored = max((attempt.stored for attempt in complete), default=0)
    if complete and rows >= stored:
        return ShardState.DONE, ""
    if any(not attempt.ended for attempt in attempts):
        if age <= STALE:
            return ShardState.RUNNING, ""
        if not attempts[-1].ended:
            return ShardState.STALE, f"its process has written nothing for {show_duration(round(age))}"
    if complete:
        return ShardState.FAILED, f"{stored - rows} of {stored} rows are missing"
    return ShardState.FAILED, next(attempt.why for attempt in reversed(attempts) if attempt.ended) or "ended early"


def _with_slow(shards: Sequence[ShardStatus]) -> Iterator[ShardStatus]:
    """Mark the shards whose runs take much longer than those of the median shard."""
    times = [1 / shard.rate for shard in shards if shard.rate]
    limit = _SLOW * median(times) if len(times) > _FEWEST_RUNS else math.inf
    for shard in shards:
        yield replace(shard, slow=bool(shard.rate and 1 / shard.rate > limit))
