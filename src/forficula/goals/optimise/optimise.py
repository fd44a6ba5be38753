"""From a goal to the designs that meet it best."""

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

# Of candidates that may be worth it, those whose neighbours are asked side by side, the best first.
_SIDE_BY_SIDE = 8
# Candidates that are verified at most, until one holds, and of a front.
_MOST_VERIFIED, _MOST_OF_FRONT = 8, 12


@dataclass(frozen=True, kw_only=True)
class SoFar:
    """How far a search is.

    Attributes:
        goal: what is asked.
        tried: designs.
        rows: that were worked out now: runs and what statics tells.
        best: the best candidate so far; None before the first batch is done.
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
    """Look for the designs that meet a goal best, or go on where that was stopped.

    The result depends on the goal alone: not on how often the search was stopped, on threads, or on who shares the
    work. Another processor may propose designs that differ in their last digits. A search that is resumed there first
    tries the designs that the journal holds.

    Args:
        goal: what is asked.
        out: folder with the journal of all rows.
        shard: number, from 1 on, and count of the processes that share every batch.
        threads: 0 for one a core.
        cluster: from `dask_cluster`.
        progress: called after every row.

    Raises:
        InputError: the folder holds another design's rows, or cannot be written; a number is not allowed.
    """
    so_far = SoFar(goal=goal, tried=0, rows=0, best=None)

    def tell(done: int, _wanted: int, _row: Row) -> None:
        nonlocal so_far
        so_far = replace(so_far, rows=done)
        if progress is not None:
            progress(so_far)

    with open_assessor(out, goal.base, shard=shard, threads=threads, cluster=cluster, progress=tell) as assess:

        def batch_done(candidates: Sequence[Candidate]) -> None:
            nonlocal so_far
            so_far = replace(so_far, tried=len(candidates), best=_best(goal, candidates))

        candidates = _searched(goal, assess, batch_done)
        candidates, best, discarded, runs = _held(goal, assess, candidates)
    trials = [trial_of(goal, each) for each in candidates]
    return Optimum(
        goal=goal,
        candidates=tuple(candidates),
        best=tuple(best),
        discarded=tuple(discarded),
        effort=_effort(goal, candidates, runs),
        relaxations=() if any(each.feasible for each in trials) else tuple(relaxations(trials)),
        table=optimum_table(goal, candidates, *([each.candidate for each in told] for told in (best, discarded))),
    )


def _searched(goal: Goal, assess: Assessor, done: Callable[[Sequence[Candidate]], None]) -> list[Candidate]:
    """Return all candidates of a search, batch after batch; `done` gets those tried so far after each batch.

    The points that the optimiser asks for go into the journal, under a hash of everything that they depend on. A search
    that is resumed on another machine or shared between machines tries the same points, although the optimiser may
    compute other last bits there.
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
        trials = [trial_of(goal, each) for each in batch]
        optimiser.tell(trials)
        history.update(json.dumps([astuple(trial) for trial in trials]).encode())
        candidates += batch
        done(candidates)
    return candidates


def estimate_optimise(goal: Goal) -> tuple[int, float]:
    """Say how many designs are tried at most, and guess how long they take, s, without their neighbours.

    The guess is the time that the design itself takes, measured now, times the designs.
    """
    with TemporaryDirectory() as folder, open_assessor(folder, goal.base) as assess:
        start = time.perf_counter()
        screened(goal, assess, [goal.base])
        return goal.runs, (time.perf_counter() - start) * goal.runs


def _starts(goal: Goal) -> list[Point]:
    """Where the design itself lies, if it does."""
    try:
        return [tuple(each.share(key_value(goal.base, each.key)) for each in goal.parameters)]
    except (InputError, ValueError):
        return []


def _tried(goal: Goal, assess: Assessor, points: Sequence[Point], before: Sequence[Candidate]) -> list[Candidate]:
    """Candidates at points, and what became of the neighbours of those that are worth it."""
    values = [goal.values(point) for point in points]
    designs = [_design(goal, each) for each in values]
    found = [
        Candidate(point=point, values=value, found=each)
        for point, value, each in zip(points, values, screened(goal, assess, designs, values), strict=True)
    ]
    if wanted_share(goal) is None and not asks_probability(goal):
        return found
    return _with_neighbours(goal, assess, found, before)


def _design(goal: Goal, values: Mapping[str, object]) -> Design | str:
    try:
        return goal.base.with_values(dict(values))
    except InputError as error:
        return str(error)


def _with_neighbours(
    goal: Goal, assess: Assessor, found: Sequence[Candidate], before: Sequence[Candidate]
) -> list[Candidate]:
    """Ask the neighbours of candidates, the best first, as long as they may be better than what is known to be good."""
    offsets = neighbour_offsets(goal, goal.neighbours, goal.seed)
    robust = [costs(goal, each) for each in before if _is_robust(goal, each)]
    done = list(found)
    order = sorted(
        (number for number, each in enumerate(found) if each.found.meets and not np.isnan(costs(goal, each)).any()),
        key=lambda number: costs(goal, found[number]),
    )
    for first in range(0, len(order), _SIDE_BY_SIDE):
        group = [
            number
            for number in order[first : first + _SIDE_BY_SIDE]
            if asks_probability(goal) or not _beaten(costs(goal, found[number]), robust)
        ]
        asked = _ask(goal, assess, [found[number] for number in group], offsets)
        for number, each in zip(group, asked, strict=True):
            done[number] = each
        robust += [costs(goal, each) for each in asked if _is_robust(goal, each)]
    return done


def _ask(goal: Goal, assess: Assessor, candidates: Sequence[Candidate], offsets: np.ndarray) -> list[Candidate]:
    """Candidates with what became of their neighbours."""
    wanted = wanted_share(goal)
    least = None if wanted is None or asks_probability(goal) else wanted.bound
    designs = [each.found.design for each in candidates if isinstance(each.found.design, Design)]
    told = neighbours_of(goal, assess, designs, offsets, least)
    return [replace(each, neighbours=neighbours) for each, neighbours in zip(candidates, told, strict=True)]


def _is_robust(goal: Goal, candidate: Candidate) -> bool:
    """Whether a candidate meets everything, its neighbours among it, which were asked."""
    return candidate.neighbours is not None and trial_of(goal, candidate).feasible


def _beaten(own: Sequence[float], others: Sequence[Sequence[float]]) -> bool:
    """Whether some other is as small everywhere."""
    return any(all(other <= mine for other, mine in zip(each, own, strict=True)) for each in others)


def _best(goal: Goal, candidates: Sequence[Candidate]) -> Candidate | None:
    by_point = {each.point: each for each in candidates}
    ranked = best_ranked([trial_of(goal, each) for each in candidates], 1)
    return by_point[ranked[0].point] if ranked else None


def _held(
    goal: Goal, assess: Assessor, candidates: Sequence[Candidate]
) -> tuple[list[Candidate], list[Verification], list[Verification], int]:
    """All candidates, the best that hold where the search did not look, better ones that do not, and the runs it took.

    Of the candidates some have been asked for their neighbours meanwhile.
    """
    told = {each.point: each for each in candidates}
    pool = {each.point: each for each in candidates}
    best: list[Verification] = []
    discarded: list[Verification] = []
    runs = 0
    while not best and len(discarded) < _MOST_VERIFIED:
        front = pareto_front([trial_of(goal, each) for each in pool.values()])
        if not front:
            break
        chosen = [pool[front[number].point] for number in _spread(len(front), _MOST_OF_FRONT)]
        unasked = [each for each in chosen if each.neighbours is None]
        if wanted_share(goal) is not None and unasked:
            # they were worse than what then did not hold
            for each in _ask(goal, assess, unasked, neighbour_offsets(goal, goal.neighbours, goal.seed)):
                told[each.point] = pool[each.point] = each
            continue
        for found in verified(goal, assess, chosen, len(discarded)):
            (best if found.holds else discarded).append(found)
            runs += (found.finer is not None) + (found.fresh.runs if found.fresh is not None else 0)
            del pool[found.candidate.point]
    return list(told.values()), best, discarded, runs


def _spread(count: int, most: int) -> list[int]:
    """Numbers spread evenly over a front, its ends among them."""
    if count <= most:
        return list(range(count))
    return sorted({round(number) for number in np.linspace(0, count - 1, most)})


def _effort(goal: Goal, candidates: Sequence[Candidate], verification_runs: int) -> Effort:
    asked = [each.neighbours for each in candidates if each.neighbours is not None]
    worth = wanted_share(goal) is not None or asks_probability(goal)
    meeting = sum(each.found.meets for each in candidates) if worth else 0
    return Effort(
        tried=len(candidates),
        runs=sum(goal.simulate and not each.found.ruled_out for each in candidates),
        ruled_out=dict(sorted(Counter(each.found.ruled_out for each in candidates if each.found.ruled_out).items())),
        neighbour_runs=sum(each.runs for each in asked),
        spared_neighbours=meeting * goal.neighbours - sum(each.tried for each in asked),
        verification_runs=verification_runs,
        simulated=goal.simulate,
    )
