"""The only place where time advances: any number of wings through their protocols, in the engine, on all cores."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator, Sequence

import mujoco
import numpy as np
from numpy.typing import NDArray

from forficula.dynamics.account import Account
from forficula.dynamics.fleet import Fleet
from forficula.dynamics.model import WingModel
from forficula.dynamics.record import Record
from forficula.dynamics.recorder import Chunk, Recorder, keep
from forficula.dynamics.sharing import followers, successors
from forficula.dynamics.stepper import Pending, Stepper, Steps
from forficula.errors import InputError

Array = NDArray[np.float64]
Progress = Callable[[str, float, float], None]

# Steps between two looks at the goals. Every step is looked at and the overshoot is taken back, so that no number
# depends on it.
_CHUNK = 100
# Wings a thread below which all are stepped at once.
_FEW = 2


def simulate(wings: Sequence[WingModel], threads: int = 0, sparse: bool = False) -> list[Record]:
    """Take wings of one topology through their protocols, side by side.

    Args:
        wings: compiled models with the same numbers of veins and membrane nodes.
        threads: 0 for one a core; the numbers do not depend on it.
        sparse: keep only what states, transitions and the energy balance need: no rows but those at the ends of
            stages, no places, and energies but the tendons' at the start and at the end only. What is kept has the same
            bits, and many wings take half the time.

    Returns:
        A record for every wing, in their order.
    """
    records = dict(simulate_each(wings, threads, sparse))
    return [records[row] for row in range(len(wings))]


def simulate_each(
    wings: Sequence[WingModel],
    threads: int = 0,
    sparse: bool = False,
    progress: Progress | None = None,
    enough: Callable[[Record], bool] | None = None,
) -> Iterator[tuple[int, Record]]:
    """Do as `simulate` does, and hand on every wing's number and record as soon as it is done.

    Wings with the same engine model and the same first stages go through those together: that is one wing, until their
    torques part.

    Args:
        wings: as in `simulate`.
        threads: as in `simulate`.
        sparse: as in `simulate`.
        progress: called now and then with a stage's name, the time so far and the longest it can take, s.
        enough: wings that only their unfold torques tell apart then run one after another, in their order, until this
            is true of a record; the rest of them never run. All run if not given.

    Raises:
        InputError: memory does not hold them.
    """
    if not wings:
        return
    try:
        stepper = Stepper(wings, threads, sparse, _CHUNK)
        try:
            yield from _records(wings, stepper, sparse, progress, enough)
        finally:
            stepper.close()
    except (MemoryError, mujoco.FatalError) as error:
        # the engine says so of its memory, and of nothing else that a wing can bring about
        named = wings[0].design.name if len(wings) == 1 else f"{len(wings)} wings side by side"
        raise InputError(f"{named}: no memory left to simulate: {' '.join(str(error).split())}") from None


def _records(
    wings: Sequence[WingModel],
    stepper: Stepper,
    sparse: bool,
    progress: Progress | None,
    enough: Callable[[Record], bool] | None,
) -> Iterator[tuple[int, Record]]:
    """Do as `simulate_each` does."""
    fleet, account, recorders = Fleet(wings), Account(wings), [Recorder(wing, sparse) for wing in wings]
    starts = [stepper.state(row) for row in range(len(wings))]
    following = {} if enough is None else successors(wings)
    held = set(following.values())
    waiting = followers(wings, held)
    moving = np.array([row not in waiting and row not in held for row in range(len(wings))])
    under_way: deque[tuple[NDArray[np.int64], Array, Pending]] = deque()
    while moving.any():
        while len(rows := _next_rows(moving & ~fleet.ended, [rows for rows, *_ in under_way], stepper.threads)):
            torques = fleet.torques(rows, _CHUNK)
            under_way.append((rows, torques, stepper.start(rows, fleet.controls(rows, torques))))
        if under_way:
            rows, torques, steps = under_way.popleft()
            _advance(stepper, fleet, account, recorders, rows, torques, steps.result())
        for row, (leader, stages) in list(waiting.items()):
            if moving[leader] and (fleet.stage[leader] >= stages or fleet.ended[leader]):
                stepper.follow_leader(row, leader)
                fleet.follow_leader(row, leader)
                account.follow_leader(row, leader)
                recorders[row] = recorders[leader].fork(wings[row])
                moving[row] = row not in held
                del waiting[row]
        if progress is not None and len(rows) and not fleet.ended[rows[0]]:
            progress(*fleet.progress(rows[0]))
        done = np.flatnonzero(moving & fleet.ended)
        moving[done] = False
        for row in done.tolist():
            end = stepper.state(row)
            totals = account.total(row) | account.power(row, fleet.last_torques(row), end.velocity)
            record = recorders[row].record(
                fleet.steps[row], starts[row], end, totals, tuple(fleet.ends[row]), fleet.diverged_at[row]
            )
            yield row, record
            if enough is not None and row in following and not enough(record):
                held.remove(following[row])
                moving[following[row]] = following[row] not in waiting


def _next_rows(moving: NDArray[np.bool_], under_way: Sequence[NDArray[np.int64]], threads: int) -> NDArray[np.int64]:
    """Which of the moving wings to step next: half of them, so that Python can look at the others meanwhile.

    Few wings go all together, or some threads would have none.
    """
    free = moving.copy()
    for rows in under_way:
        free[rows] = False
    count = int(moving.sum())
    if count < _FEW * threads:
        return np.flatnonzero(free & (not under_way))
    return np.flatnonzero(free)[: (count + 1) // 2 * (len(under_way) < 2)]


def _advance(
    stepper: Stepper,
    fleet: Fleet,
    account: Account,
    recorders: Sequence[Recorder],
    rows: NDArray[np.int64],
    torques: Array,
    steps: Steps,
) -> None:
    """Take note of a chunk of steps of some wings, of none beyond the end of its stage."""
    first = fleet.steps[rows]
    begins = first == fleet.stage_start[rows]
    taken = fleet.follow(rows, steps.before[:, 0], steps.time, steps.position, steps.velocity)
    stepper.take_back(rows, steps, taken)
    chunk = Chunk(
        steps=steps,
        first=first,
        begins=begins,
        taken=taken,
        account=account.add(rows, steps, torques, taken),
    )
    keep([recorders[row] for row in rows], chunk)
