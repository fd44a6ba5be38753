"""Search for the designs that meet a goal best."""

from __future__ import annotations

import hashlib
import json
import time
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import astuple, dataclass, replace
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from forficula.design import Design, key_value
from forficula.errors import InputError
from forficula.goals.assessor import Assessor, open_assessor
from forficula.goals.goal import Goal
from forficula.goals.optimise.candidate import (
    Candidate,
    Verification,
    asks_probability,
    axes_of,
    costs,
    neighbour_offsets,
    neighbours_of,
    trial_of,
    verified,
    wanted_share,
)
from forficula.goals.optimise.optimum import Effort, Optimum
from forficula.goals.optimise.optimum_table import optimum_table
from forficula.goals.optimise.parabola_search import Optimiser, ParabolaSearch
from forficula.goals.optimise.screening import screened
from forficula.goals.optimise.trials import Point, best_ranked, pareto_front, relaxations
from forficula.study.running.journal import Row
from forficula.study.running.run_study import Evaluate

# Number of candidates whose neighbours are evaluated side by side, best first.
_SIDE_BY_SIDE = 8
# Largest number of candidates to verify until one passes, and of candidates from a front.
_MOST_VERIFIED, _MOST_OF_FRONT = 8, 12


@dataclass(frozen=True, kw_only=True)
class SoFar:
    """State of a search.

    Attributes:
        goal: the goal.
        tried: number of designs.
        rows: number of rows computed in this call: runs and static values.
        best: best candidate so far; None before the first batch is done.
    """

    goal: Goal
    tried: int
    rows: int
    best: Candidate | None


Progress = Callable[[SoFar], None]


def optimise_goal(
    goal: Goal,
    out: str | Path,
    *,
    shard: tuple[int, int] = (1, 1),
    threads: int = 0,
    cluster: Evaluate | None = None,
    progress: Progress | None = None,
) -> Optimum:
    """Search for the designs that meet a goal best, or continue an interrupted search.

    The result depends on the goal alone, not on interruptions, threads, or processes that share the work. Another
    processor may propose designs that differ in their last digits. Therefore a search that is continued there first
    tries the designs in the journal.

    Args:
        goal: the goal.
        out: folder with the journal of all rows.
        shard: number, from 1, and count of the processes that share every batch.
        threads: number of threads; 0 for one per core.
        cluster: cluster from `dask_cluster`.
        progress: called after every row.

    Raises:
        InputError: the folder has another design's rows, or cannot be written; a number is not allowed.
    """
    so_far = SoFar(goal=goal, tried=0, rows=0, best=None)

    def report(done: int, _wanted: int, _row: Row) -> None:
        nonlocal so_far
        so_far = replace(so_far, rows=done)
        if progress is not None:
            progress(so_far)

    with open_assessor(out, goal.base, shard=shard, threads=threads, cluster=cluster, progress=report) as assess:

        def batch_done(candidates: Sequence[Candidate]) -> None:
            nonlocal so_far
            so_far = replace(so_far, tried=len(candidates), best=_best(goal, candidates))

        candidates = _searched(goal, assess, batch_done)
        candidates, best, discarded, runs = _verified_best(goal, assess, candidates)
    trials = [trial_of(goal, candidate) for candidate in candidates]
    return Optimum(
        goal=goal,
        candidates=tuple(candidates),
        best=tuple(best),
        discarded=tuple(discarded),
        effort=_effort(goal, candidates, runs),
        relaxations=() if any(trial.feasible for trial in trials) else tuple(relaxations(trials)),
        table=optimum_table(goal, candidates, *([trial.candidate for trial in group] for group in (best, discarded))),
    )


def _searched(goal: Goal, assess: Assessor, done: Callable[[Sequence[Candidate]], None]) -> list[Candidate]:
    """Return all candidates of a search, batch by batch; `done` is called with all candidates after each batch.

    The points that the optimiser proposes are written to the journal, under a hash of everything on which they depend.
    A search that is continued on another machine or shared between machines tries the same points, although the
    optimiser may compute different last bits there.
    """
    candidates: list[Candidate] = []
    start = (axes_of(goal), len(goal.objectives), goal.batch, goal.seed, _starts(goal))
    optimiser: Optimiser = ParabolaSearch(*start)
    history = hashlib.sha256(repr(start).encode())
    while len(candidates) < goal.runs:
        row = assess.agreed({"key": f"asked-{history.hexdigest()}", "points": optimiser.ask()})
        points = [tuple(point) for point in row["points"]]
        if not points:
            break
        batch = _tried(goal, assess, points[: goal.runs - len(candidates)], candidates)
        trials = [trial_of(goal, candidate) for candidate in batch]
        optimiser.tell(trials)
        history.update(json.dumps([astuple(trial) for trial in trials]).encode())
        candidates += batch
        done(candidates)
    return candidates


def estimate_optimise(goal: Goal) -> tuple[int, float]:
    """Return the largest number of designs, and an estimate of their time, s, without neighbours.

    The estimate is the time of the base design, which is measured now, times the number of designs.
    """
    with TemporaryDirectory() as folder, open_assessor(folder, goal.base) as assess:
        start = time.perf_counter()
        screened(goal, assess, [goal.base])
        return goal.runs, (time.perf_counter() - start) * goal.runs


def _starts(goal: Goal) -> list[Point]:
    """Return the point of the base design, if it is allowed by the parameters."""
    try:
        return [tuple(parameter.share(key_value(goal.base, parameter.key)) for parameter in goal.parameters)]
    except (InputError, ValueError):
        return []


def _tried(goal: Goal, assess: Assessor, points: Sequence[Point], before: Sequence[Candidate]) -> list[Candidate]:
    """Return candidates at points, with the results of neighbours for candidates that may become the best."""
    values = [goal.values(point) for point in points]
    designs = [_design(goal, point_values) for point_values in values]
    candidates = [
        Candidate(point=point, values=value, screened=result)
        for point, value, result in zip(points, values, screened(goal, assess, designs, values), strict=True)
    ]
    if wanted_share(goal) is None and not asks_probability(goal):
        return candidates
    return _with_neighbours(goal, assess, candidates, before)


def _design(goal: Goal, values: Mapping[str, object]) -> Design | str:
    try:
        return goal.base.with_values(dict(values))
    except InputError as error:
        return str(error)


def _with_neighbours(
    goal: Goal, assess: Assessor, candidates: Sequence[Candidate], before: Sequence[Candidate]
) -> list[Candidate]:
    """Evaluate the neighbours of candidates, best first, as long as they may be better than known robust ones."""
    offsets = neighbour_offsets(goal, goal.neighbours, goal.seed)
    robust = [costs(goal, candidate) for candidate in before if _is_robust(goal, candidate)]
    done = list(candidates)
    order = sorted(
        (
            number
            for number, candidate in enumerate(candidates)
            if candidate.screened.meets and not np.isnan(costs(goal, candidate)).any()
        ),
        key=lambda number: costs(goal, candidates[number]),
    )
    for first in range(0, len(order), _SIDE_BY_SIDE):
        group = [
            number
            for number in order[first : first + _SIDE_BY_SIDE]
            if asks_probability(goal) or not _beaten(costs(goal, candidates[number]), robust)
        ]
        evaluated = _evaluate_neighbours(goal, assess, [candidates[number] for number in group], offsets)
        for number, candidate in zip(group, evaluated, strict=True):
            done[number] = candidate
        robust += [costs(goal, candidate) for candidate in evaluated if _is_robust(goal, candidate)]
    return done


def _evaluate_neighbours(
    goal: Goal, assess: Assessor, candidates: Sequence[Candidate], offsets: np.ndarray
) -> list[Candidate]:
    """Return candidates with the results of their neighbours."""
    required = wanted_share(goal)
    least = None if required is None or asks_probability(goal) else required.bound
    designs = [candidate.screened.design for candidate in candidates if isinstance(candidate.screened.design, Design)]
    results = neighbours_of(goal, assess, designs, offsets, least)
    return [
        replace(candidate, neighbours=neighbours) for candidate, neighbours in zip(candidates, results, strict=True)
    ]


def _is_robust(goal: Goal, candidate: Candidate) -> bool:
    """Return whether a candidate meets all limits, including the probability, with its neighbours evaluated."""
    return candidate.neighbours is not None and trial_of(goal, candidate).feasible


def _beaten(costs: Sequence[float], others: Sequence[Sequence[float]]) -> bool:
    """Return whether some other candidate is at least as good in every objective."""
    return any(
        all(cost <= own_cost for cost, own_cost in zip(other_costs, costs, strict=True)) for other_costs in others
    )


def _best(goal: Goal, candidates: Sequence[Candidate]) -> Candidate | None:
    by_point = {candidate.point: candidate for candidate in candidates}
    ranked = best_ranked([trial_of(goal, candidate) for candidate in candidates], 1)
    return by_point[ranked[0].point] if ranked else None


def _verified_best(
    goal: Goal, assess: Assessor, candidates: Sequence[Candidate]
) -> tuple[list[Candidate], list[Verification], list[Verification], int]:
    """Return all candidates, the best that pass verification, better ones that fail it, and the number of runs for it.

    Some of the candidates get results of their neighbours in the process.
    """
    all_candidates = {candidate.point: candidate for candidate in candidates}
    pool = {candidate.point: candidate for candidate in candidates}
    best: list[Verification] = []
    discarded: list[Verification] = []
    runs = 0
    while not best and len(discarded) < _MOST_VERIFIED:
        front = pareto_front([trial_of(goal, candidate) for candidate in pool.values()])
        if not front:
            break
        chosen = [pool[front[number].point] for number in _spread(len(front), _MOST_OF_FRONT)]
        unevaluated = [candidate for candidate in chosen if candidate.neighbours is None]
        if wanted_share(goal) is not None and unevaluated:
            # they were worse than a candidate that then failed verification
            for candidate in _evaluate_neighbours(
                goal, assess, unevaluated, neighbour_offsets(goal, goal.neighbours, goal.seed)
            ):
                all_candidates[candidate.point] = pool[candidate.point] = candidate
            continue
        for verification in verified(goal, assess, chosen, len(discarded)):
            (best if verification.holds else discarded).append(verification)
            runs += verification.finer is not None
            runs += verification.fresh.runs if verification.fresh is not None else 0
            del pool[verification.candidate.point]
    return list(all_candidates.values()), best, discarded, runs


def _spread(count: int, most: int) -> list[int]:
    """Return indices spread evenly over a front, including its ends."""
    if count <= most:
        return list(range(count))
    return sorted({round(number) for number in np.linspace(0, count - 1, most)})


def _effort(goal: Goal, candidates: Sequence[Candidate], verification_runs: int) -> Effort:
    evaluated = [candidate.neighbours for candidate in candidates if candidate.neighbours is not None]
    has_probability = wanted_share(goal) is not None or asks_probability(goal)
    meeting = sum(candidate.screened.meets for candidate in candidates) if has_probability else 0
    return Effort(
        tried=len(candidates),
        runs=sum(goal.simulate and not candidate.screened.ruled_out for candidate in candidates),
        ruled_out=dict(
            sorted(
                Counter(
                    candidate.screened.ruled_out for candidate in candidates if candidate.screened.ruled_out
                ).items()
            )
        ),
        neighbour_runs=sum(neighbours.runs for neighbours in evaluated),
        spared_neighbours=meeting * goal.neighbours - sum(neighbours.tried for neighbours in evaluated),
        verification_runs=verification_runs,
        simulated=goal.simulate,
    )
