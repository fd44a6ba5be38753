"""The only place where time advances: any number of structures through their protocols, in the engine, on all cores."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator, Sequence

import mujoco
import numpy as np

from forficula.arrays import Array, Flags, Indices
from forficula.dynamics.energies.account import Account
from forficula.dynamics.engine.model import Model
from forficula.dynamics.engine.sharing import followers, successors
from forficula.dynamics.record import Record
from forficula.dynamics.recorder import Chunk, Recorder, keep
from forficula.dynamics.stepping.stages import StageTracker
from forficula.dynamics.stepping.stepper import Pending, Stepper
from forficula.dynamics.stepping.steps import Steps
from forficula.dynamics.stepping.waiting import Waits
from forficula.errors import InputError

Progress = Callable[[str, float, float], None]

# Steps between two looks at the goals. Every step is looked at and the overshoot is taken back, so that no number
# depends on it. There are fewer where looking takes a small share of the time, of many structures and of those whose
# steps take Python; for sparse records, which keep what comes with the end of a stage; and for steps of Runge and
# Kutta, whose dampers are looked at anew where these begin, so that last digits of their work do depend on it.
_CHUNK = 400
_MANY = 8
# Structures a thread below which all are stepped at once.
_FEW = 2


def simulate(models: Sequence[Model], threads: int = 0, sparse: bool = False) -> list[Record]:
    """Take structures of one topology through their protocols, side by side.

    Args:
        models: compiled, with the same numbers of hinges, tendons and membrane nodes.
        threads: 0 for one a core; the numbers do not depend on it.
        sparse: keep only what states, transitions and the energy balance need: no rows but those at the ends of
            stages, no places, and energies but the tendons' at the start and at the end only. What is kept has the same
            bits, and many structures take half the time.

    Returns:
        A record for every one, in their order.
    """
    records = dict(simulate_each(models, threads, sparse))
    return [records[row] for row in range(len(models))]


def simulate_each(
    models: Sequence[Model],
    threads: int = 0,
    sparse: bool = False,
    progress: Progress | None = None,
    enough: Callable[[Record], bool] | None = None,
) -> Iterator[tuple[int, Record]]:
    """Do as `simulate` does, and hand on every structure's number and record as soon as it is done.

    Structures with the same engine model and the same first stages go through those together: that is one of them,
    until their torques part.

    Args:
        models: as in `simulate`.
        threads: as in `simulate`.
        sparse: as in `simulate`.
        progress: called now and then with a stage's name, the time so far and the longest it can take, s.
        enough: structures that only the strength of their last transition's drive tells apart then run one after
            another, in their order, until this is true of a record; the rest of them never run. All run if not given.

    Raises:
        InputError: memory does not hold them.
    """
    if not models:
        return
    try:
        slow = models[0].creases is not None or models[0].drag is not None
        short = slow or sparse or models[0].explicit or len(models) > _MANY
        chunk = max(1, _CHUNK // 4) if short else _CHUNK
        stepper = Stepper(models, threads, sparse, chunk)
        try:
            yield from _records(models, stepper, chunk, sparse, progress, enough)
        finally:
            stepper.close()
    except (MemoryError, mujoco.FatalError) as error:
        # the engine says so of its memory, and of nothing else that a structure can bring about
        named = models[0].design.name if len(models) == 1 else f"{len(models)} structures side by side"
        raise InputError(f"{named}: no memory left to simulate: {' '.join(str(error).split())}") from None


def _records(
    models: Sequence[Model],
    stepper: Stepper,
    chunk: int,
    sparse: bool,
    progress: Progress | None,
    enough: Callable[[Record], bool] | None,
) -> Iterator[tuple[int, Record]]:
    """Do as `simulate_each` does."""
    tracker, account, waits = StageTracker(models), Account(models), Waits(models)
    recorders = [Recorder(model, sparse) for model in models]
    starts = [stepper.state(row) for row in range(len(models))]
    following = {} if enough is None else successors(models)
    held = set(following.values())
    waiting = followers(models, held)
    moving = np.array([row not in waiting and row not in held for row in range(len(models))])
    under_way: deque[tuple[Indices, Array, Pending]] = deque()
    few = _FEW * stepper.threads * stepper.together
    while moving.any():
        while len(rows := _next_rows(moving & ~tracker.ended, [rows for rows, *_ in under_way], few)):
            torques = tracker.torques(rows, chunk)
            under_way.append((rows, torques, stepper.start(rows, tracker.controls(rows, torques), torques)))
        if under_way:
            rows, torques, steps = under_way.popleft()
            _advance(stepper, tracker, account, recorders, rows, torques, steps.result())
            while tracker.waiting:
                waits.go_on(tracker.waiting.pop(), tracker, stepper, account)
        for row, (leader, stages) in list(waiting.items()):
            if moving[leader] and (tracker.stage[leader] >= stages or tracker.ended[leader]):
                stepper.follow_leader(row, leader)
                tracker.follow_leader(row, leader)
                account.follow_leader(row, leader)
                recorders[row] = recorders[leader].fork(models[row])
                moving[row] = row not in held
                del waiting[row]
        if progress is not None and len(rows) and not tracker.ended[rows[0]]:
            progress(*tracker.progress(rows[0]))
        done = np.flatnonzero(moving & tracker.ended)
        moving[done] = False
        for row in done.tolist():
            end = stepper.state(row)
            totals = account.total(row) | account.power(row, tracker.last_torques(row), end)
            record = recorders[row].record(
                tracker.steps[row], starts[row], end, totals, tuple(tracker.ends[row]), tracker.diverged_at[row]
            )
            yield row, record
            if enough is not None and row in following and not enough(record):
                held.remove(following[row])
                moving[following[row]] = following[row] not in waiting


def _next_rows(moving: Flags, under_way: Sequence[Indices], few: int) -> Indices:
    """Which of the moving structures to step next: half of them, so that Python can look at the others meanwhile.

    Fewer than `few` go all together, or some threads would have none.
    """
    free = moving.copy()
    for rows in under_way:
        free[rows] = False
    count = int(moving.sum())
    if count < few:
        return np.flatnonzero(free & (not under_way))
    return np.flatnonzero(free)[: (count + 1) // 2 * (len(under_way) < 2)]


def _advance(
    stepper: Stepper,
    tracker: StageTracker,
    account: Account,
    recorders: Sequence[Recorder],
    rows: Indices,
    torques: Array,
    steps: Steps,
) -> None:
    """Take note of a chunk of steps of some structures, of none beyond the end of its stage."""
    first = tracker.steps[rows]
    begins = first == tracker.stage_start[rows]
    taken = tracker.follow(rows, steps)
    stepper.take_back(rows, steps, taken)
    chunk = Chunk(
        steps=steps,
        first=first,
        begins=begins,
        taken=taken,
        account=account.add(rows, steps, torques, taken),
    )
    keep([recorders[row] for row in rows], chunk)
