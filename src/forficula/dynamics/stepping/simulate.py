"""Simulation of any number of structures through their protocols on all cores: the only place where time advances."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Protocol

import mujoco
import numpy as np

from forficula.arrays import Array, Flags, Indices
from forficula.dynamics.energies.energy import state_series
from forficula.dynamics.energies.work_balance import WorkBalance
from forficula.dynamics.engine.model import Model
from forficula.dynamics.engine.sharing import followers
from forficula.dynamics.engine.trials import TrialChains, design_trial
from forficula.dynamics.record import Record
from forficula.dynamics.recorder import Chunk, Recorder, keep_rows
from forficula.dynamics.stepping.quasi_static_stages import QuasiStaticStages
from forficula.dynamics.stepping.stages import StageTracker
from forficula.dynamics.stepping.stepper import Pending, Stepper
from forficula.dynamics.stepping.steps import Steps
from forficula.dynamics.stepping.waiting import Waits
from forficula.errors import InputError
from forficula.structure import RestSolver

Progress = Callable[[str, float, float], None]

# Steps between two checks of the goals. Every step is checked and the overshoot is undone, so that no number depends on
# this length. It is shorter if checks take a small share of the time, as for many structures and for structures whose
# steps need Python; for sparse records, which keep the rows at the ends of stages; and for steps of Runge and Kutta,
# for which dampers are evaluated at the start of a chunk, so that the last digits of their work do depend on it.
_CHUNK = 400
_MANY = 8
# number of structures per thread below which all are stepped at once
_FEW = 2
# factor by which the time in a stage grows between two checks whether an outcome is certain, because a check takes as
# much time as some ten steps; and the number of steps after which the second check takes place
_LATER, _FIRST_CHECK = 1.3, 50


class CertainOutcome(Protocol):
    """A condition on the motion in a stage that makes the outcome of a structure certain."""

    @property
    def stage(self) -> int:
        """Number of the stage."""

    def is_certain(self, passed: float, angles: Array, energy: float) -> bool:
        """Return whether the outcome is certain.

        Args:
            passed: time in the stage, s.
            angles: angles of the hinges in their own senses, rad, (hinge,).
            energy: energy of motion and of all elements, J.
        """


def simulate(models: Sequence[Model], threads: int = 0, sparse: bool = False) -> list[Record]:
    """Simulate structures of one topology through their protocols, side by side.

    Args:
        models: compiled, with the same numbers of hinges, tendons and membrane nodes.
        threads: number of threads; 0 for one per core. The results do not depend on it.
        sparse: keep only what states, transitions and the energy balance need: rows at the ends of stages only, no
            positions, and energies except the tendons' at the start and at the end only. The kept values have the same
            bits, and many structures take half the time.

    Returns:
        A record for every structure, in their order.
    """
    records = dict(simulate_each(models, threads, sparse))
    return [records[row] for row in range(len(models))]


def simulate_each(
    models: Sequence[Model],
    threads: int = 0,
    sparse: bool = False,
    progress: Progress | None = None,
    reached: Callable[[Record], bool | None] | None = None,
    solver: RestSolver | None = None,
    certain: Mapping[int, CertainOutcome] | None = None,
) -> Iterator[tuple[int, Record]]:
    """Simulate structures as `simulate` does, and yield every structure's number and record as soon as it is done.

    Structures with the same engine model and the same first stages share these stages: only one of them is simulated
    until their torques differ.

    Args:
        models: as in `simulate`.
        threads: as in `simulate`.
        sparse: as in `simulate`.
        progress: called repeatedly with a stage's name, the time so far and the longest possible time, s.
        reached: if given, structures that differ only in the strength of a drive run one after another, see
            `TrialChains`. It returns whether a record reached the state of its trial; None if it neither reached the
            state nor stayed short of its goal. Structures that a record makes needless never run.
        solver: returns the equilibria of structures in quasi-static stages; not needed without such stages.
        certain: conditions by the numbers of structures. A structure that meets its condition stops, as if the time
            limit of its stage were over.

    Raises:
        InputError: there is not enough memory, or no solver for a quasi-static stage.
    """
    if not models:
        return
    try:
        slow = models[0].followed > 1 or models[0].creases is not None
        short = slow or sparse or models[0].explicit or len(models) > _MANY
        chunk = max(1, _CHUNK // 4) if short else _CHUNK
        stepper = Stepper(models, threads, sparse, chunk)
        try:
            yield from _records(models, stepper, chunk, sparse, progress, reached, solver, certain or {})
        finally:
            stepper.close()
    except (MemoryError, mujoco.FatalError) as error:
        # the engine raises this error for lack of memory, and for nothing else that a structure can cause
        named = models[0].design.name if len(models) == 1 else f"{len(models)} structures side by side"
        raise InputError(f"{named}: no memory left to simulate: {' '.join(str(error).split())}") from None


def _records(
    models: Sequence[Model],
    stepper: Stepper,
    chunk: int,
    sparse: bool,
    progress: Progress | None,
    reached: Callable[[Record], bool | None] | None,
    solver: RestSolver | None,
    certain: Mapping[int, CertainOutcome],
) -> Iterator[tuple[int, Record]]:
    """Yield the numbers and records of `simulate_each`."""
    tracker, account, waits = StageTracker(models), WorkBalance(models), Waits(models)
    quasi_static = QuasiStaticStages(models, solver)
    recorders = [Recorder(model, sparse) for model in models]
    starts = [stepper.state(row) for row in range(len(models))]
    trials = _HeldTrials(models if reached is not None else ())
    checks = _CertaintyChecks(models, certain)
    held = trials.held
    waiting = followers(models, held)
    moving = np.array([row not in waiting and row not in held for row in range(len(models))])
    under_way: deque[tuple[Indices, Array, Pending]] = deque()
    few = _FEW * stepper.threads * stepper.together
    while moving.any():
        # a structure that ends a stage in this pass rests until the next one, so that its followers can copy its state
        resting = np.flatnonzero(moving & tracker.at_rest).tolist()
        while len(
            rows := _next_rows(moving & ~tracker.ended & ~tracker.at_rest, [rows for rows, *_ in under_way], few)
        ):
            torques = tracker.torques(rows, chunk)
            under_way.append((rows, torques, stepper.start(rows, tracker.controls(rows, torques), torques)))
        if under_way:
            rows, torques, steps = under_way.popleft()
            _advance(stepper, tracker, account, recorders, rows, torques, steps.result())
            if certain:
                leaders = {leader for leader, _ in waiting.values()}
                checks.stop([row for row in rows.tolist() if row not in leaders], tracker, stepper)
            while tracker.waiting:
                waits.go_on(tracker.waiting.pop(), tracker, stepper, account)
        for row in resting[:1]:
            quasi_static.go_on(row, tracker, stepper, account, recorders[row])
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
            if tracker.diverged_at[row] is None:
                account.deepen(row, stepper.overlap(row))
            totals = account.total(row) | account.power(row, tracker.last_torques(row), end)
            record = recorders[row].record(
                tracker.steps[row], starts[row], end, totals, tuple(tracker.ends[row]), tracker.diverged_at[row]
            )
            yield row, record
            following = None if reached is None else trials.next_after(row, record, reached)
            if following is not None:
                held.remove(following)
                moving[following] = following not in waiting


class _HeldTrials:
    """Structures that run one after another because the result of one can make others needless.

    Attributes:
        held: numbers of the structures that wait for the result of another one.
    """

    def __init__(self, models: Sequence[Model]) -> None:
        self._trials = TrialChains([design_trial(model.design, model.structure) for model in models])
        # trials of each chain that are left, in their order, by the number of the trial that runs
        self._left = {chain[0]: chain[1:] for chain in self._trials.chains}
        self.held = {row for chain in self._left.values() for row in chain}

    def next_after(self, row: int, record: Record, reached: Callable[[Record], bool | None]) -> int | None:
        """Return the structure that runs after another one of its chain; None if there is none."""
        left = self._left.pop(row, None)
        if not left:
            return None
        needless = self._trials.needless(row, reached=reached(record))
        remaining = [number for number in left if number not in needless]
        if not remaining:
            return None
        self._left[remaining[0]] = remaining[1:]
        return remaining[0]


class _CertaintyChecks:
    """Checks whether the outcomes of structures are certain, at the start of a stage and at ever longer intervals."""

    def __init__(self, models: Sequence[Model], certain: Mapping[int, CertainOutcome]) -> None:
        self._models, self._certain = models, certain
        # number of steps in the stage at which the next check of each structure takes place
        self._next = np.zeros(len(models))

    def stop(self, rows: Sequence[int], tracker: StageTracker, stepper: Stepper) -> None:
        """Stop the structures whose outcomes are certain."""
        for row in rows:
            condition = self._certain.get(row)
            if condition is None or tracker.ended[row] or tracker.stage[row] != condition.stage:
                continue
            passed = int(tracker.steps[row] - tracker.stage_start[row])
            if passed < self._next[row]:
                continue
            self._next[row] = max(_LATER * passed, _FIRST_CHECK)
            model, state = self._models[row], stepper.state(row)
            derived = {name: values[None] for name, values in state.derived.items()}
            series = state_series(model, state.angle[None], derived)
            energy = float(sum(values.sum() for name, values in series.items() if name.endswith("_energy")))
            if condition.is_certain(passed * float(model.design.protocol.timestep), state.angle, energy):
                tracker.stop(row)


def _next_rows(moving: Flags, under_way: Sequence[Indices], few: int) -> Indices:
    """Return the moving structures to step next: half of them, so that Python can process the others meanwhile.

    Fewer than `few` structures are all stepped together, so that every thread has some.
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
    account: WorkBalance,
    recorders: Sequence[Recorder],
    rows: Indices,
    torques: Array,
    steps: Steps,
) -> None:
    """Process a chunk of steps of some structures, for each up to the end of its stage."""
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
    keep_rows([recorders[row] for row in rows], chunk)
