"""Tolerance analysis: probability that a design works within manufacturing tolerances, from batches of runs."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from forficula.arrays import Array
from forficula.design import Design
from forficula.errors import InputError
from forficula.goals.assessor import Assessor, open_assessor
from forficula.goals.deviation import deviating_values
from forficula.goals.tolerance.indices import Indices, Values, line_indices, sobol_indices, total_effects
from forficula.goals.tolerance.narrowing import narrowed
from forficula.goals.tolerance.nearest_failure import Answer, Ask, Reach, reaches
from forficula.goals.tolerance.plan import PLANS, Plan, exchanged, plan_within, two_samples
from forficula.goals.tolerance.question import Question
from forficula.goals.tolerance.samples import Samples, assess_samples, built_design, joined, margin_names
from forficula.goals.tolerance.saved_plan import kept_plan, saved_plan
from forficula.goals.tolerance.screening import Screening, screening
from forficula.goals.tolerance.tolerance import NearestFailure, Tolerance, VerdictMap
from forficula.names import check_whole
from forficula.quantities import as_written
from forficula.study.running.evaluate import evaluate
from forficula.study.running.journal import Row
from forficula.study.running.run_study import Evaluate, Progress

MINUTES = 5.0
# name of the group of remaining factors
REST = "the others"
# range of the map in widths: slightly more than a uniform tolerance, and most of a normal distribution
_MAP_REACH = {"uniform": 1.5, "normal": 3.0}
# number of new rows needed to measure the time per row
_TIMED = 8
# a correlation is significant above this number of standard errors
_CHANCE = 2.0


def assess_tolerance(
    question: Question,
    out: str | Path,
    *,
    minutes: float = MINUTES,
    runs: int | None = None,
    seed: int = 0,
    shard: tuple[int, int] = (1, 1),
    threads: int = 0,
    cluster: Evaluate | None = None,
    progress: Progress | None = None,
) -> Tolerance:
    """Estimate the probability that a design works within its tolerances, and which tolerances matter most.

    The number of runs is determined once, from the time of the first ones, and stored in the folder. From then on, the
    result depends only on the question and the seed, even if the call is interrupted and continued.

    Args:
        question: the design, its tolerances, and the conditions for working.
        out: folder with the rows and the plan; an interrupted analysis continues there.
        minutes: available time.
        runs: largest number of runs, whatever time they take; by default determined from the time.
        seed: seed of the points.
        shard: number, from 1, and count of the processes that share every batch.
        threads: number of threads; 0 for one per core.
        cluster: cluster from `dask_cluster`.
        progress: called after every run with the number of completed runs, the largest number of runs, and the row.

    Raises:
        InputError: no deviations, a number that is not allowed, or a folder with another design's rows.
    """
    if not question.deviations:
        raise InputError(f"tolerances: need at least one, {question.design.name} has none")
    check_numbers(minutes, seed, runs)
    trials = _Trials(question=question, progress=progress)
    with open_assessor(
        out, question.design, shard=shard, threads=threads, cluster=cluster, progress=trials.report
    ) as trials.assessor:
        if runs is None:
            plan = _plan(trials, Path(out), minutes, seed)
        else:
            plan = plan_within(len(question.deviations), 1.0, runs)
        trials.most = plan.most_runs(len(question.deviations))
        return _assessed(trials, plan, seed)


def estimate_tolerance(
    question: Question, out: str | Path, minutes: float = MINUTES, seed: int = 0, runs: int | None = None
) -> tuple[Plan, int, float]:
    """Return the plan of a tolerance analysis, its largest number of runs, and their time, s.

    If the folder has no plan, a few designs within the tolerances are run, and their rows are discarded.

    Args:
        question: the design, its tolerances, and the conditions for working.
        out: folder with rows, if there are any.
        minutes: available time.
        seed: seed of the points.
        runs: see `assess_tolerance`.

    Raises:
        InputError: a number is not allowed.
    """
    check_numbers(minutes, seed, runs)
    factors = len(question.deviations)
    offsets = question.offsets(two_samples(factors, _TIMED, seed)[0]).tolist()
    designs = [
        built_design(question.design, deviating_values(question.design, question.deviations, offset))
        for offset in offsets
    ]
    start = time.monotonic()
    count = sum(1 for _ in evaluate([design for design in designs if isinstance(design, Design)]))
    seconds = (time.monotonic() - start) / max(count, 1)
    if runs is not None:
        plan = plan_within(factors, 1.0, runs)
    else:
        plan = kept_plan(Path(out), question, minutes, seed) or plan_within(factors, seconds, 60 * minutes)
    most = plan.most_runs(factors)
    return plan, most, most * seconds


def check_numbers(minutes: object, seed: object, runs: object) -> None:
    """Refuse numbers that `assess_tolerance` does not allow.

    Raises:
        InputError: a number is not allowed.
    """
    if runs is not None:
        check_whole("runs", runs, 1)
    if isinstance(minutes, bool) or not isinstance(minutes, int | float) or not 0 < minutes < np.inf:
        raise InputError(f"minutes: need a number > 0, got {as_written(minutes)}")
    check_whole("seed", seed, 0)


@dataclass(kw_only=True)
class _Trials:
    """Runs and counts designs with deviations.

    Attributes:
        question: the tolerance question.
        progress: callback of the caller.
        assessor: computes rows.
        most: largest number of runs.
        count: number of designs that were tried.
    """

    question: Question
    progress: Progress | None
    assessor: Assessor | None = None
    most: int = 0
    count: int = 0

    def __call__(self, offsets: Array) -> Samples:
        """Return the results of designs with deviations in widths, (samples, factors)."""
        assert self.assessor is not None
        self.count += len(offsets)
        return assess_samples(self.question, self.assessor, offsets)

    def report(self, done: int, wanted: int, row: Row) -> None:
        """Pass on the progress."""
        if self.progress is not None:
            self.progress(done, max(wanted, self.most), row)


def _plan(trials: _Trials, folder: Path, minutes: float, seed: int) -> Plan:
    """Return the plan in the folder, or the one for which there is time according to the first runs."""
    question = trials.question
    if (kept := kept_plan(folder, question, minutes, seed)) is not None:
        return kept
    factors = len(question.deviations)
    # if the folder already has rows of the first sample, the second sample is timed
    points = np.concatenate(two_samples(factors, PLANS[0].points, seed))
    trials(np.zeros((1, factors)))
    batch, seconds = PLANS[-1].points, 0.0
    for begin in range(0, len(points), batch):
        assert trials.assessor is not None
        before, start = trials.assessor.wanted, time.monotonic()
        trials(question.offsets(points[begin : begin + batch]))
        if (added := trials.assessor.wanted - before) >= _TIMED:
            seconds = (time.monotonic() - start) / added
            break
    trials.count = 0
    return saved_plan(folder, question, minutes, seed, plan_within(factors, seconds, 60 * minutes))


@dataclass(frozen=True, kw_only=True)
class _Decided:
    """Sensitivity of the margins, and the samples from which it was computed; see `Tolerance`.

    Attributes:
        samples: independent samples.
        every: these samples and those with exchanged columns.
        indices: indices of groups of factors.
        effects: effects of every factor.
        kept: factors with indices of their own.
        screened: result of the screening; None without screening.
    """

    samples: Samples
    every: Samples
    indices: Indices
    effects: Values
    kept: tuple[int, ...]
    screened: Screening | None = None


def _decided(trials: _Trials, plan: Plan, seed: int) -> _Decided:
    """Run the samples of a plan, and compute the sensitivity of their margins."""
    question = trials.question
    factors, names = len(question.deviations), margin_names(question)
    first, second = two_samples(factors, plan.points, seed)
    at_first = trials(question.offsets(first))
    kept, effects = tuple(range(factors)), np.full(factors, np.nan)
    if not plan.rows:
        indices = line_indices(names, question.keys, at_first.offsets, at_first.margins, seed)
        return _Decided(samples=at_first, every=at_first, indices=indices, effects=effects, kept=kept)
    at_second = trials(question.offsets(second[: plan.rows]))
    samples = joined([at_first, at_second])
    screened: Screening | None = None
    if plan.screens(factors):
        effects = _effects(trials, plan, first, second, at_first, samples)
        points = np.concatenate([first, second[: plan.rows]])
        screened = screening(points, samples.margins[0], effects, plan.kept, seed)
        kept = screened.kept
    groups = [[factor] for factor in kept]
    group_names = [question.keys[factor] for factor in kept]
    if screened is not None:
        groups.append([factor for factor in range(factors) if factor not in kept])
        group_names.append(REST)
    mixed = [exchanged(first[: plan.rows], second[: plan.rows], group) for group in groups]
    at_mixed = trials(question.offsets(np.concatenate(mixed)))
    margins = at_mixed.margins.reshape(len(names), len(groups), plan.rows).swapaxes(0, 1)
    at_rows = at_first.margins[:, : plan.rows]
    indices = sobol_indices(names, group_names, at_rows, at_second.margins, margins, seed, compared=len(kept) or None)
    return _Decided(
        samples=samples,
        every=joined([samples, at_mixed]),
        indices=indices,
        effects=indices.total[0] if screened is None else effects,
        kept=kept,
        screened=screened,
    )


def _assessed(trials: _Trials, plan: Plan, seed: int) -> Tolerance:
    """Do the runs of a plan, and evaluate them."""
    question = trials.question
    nominal = trials(np.zeros((1, len(question.deviations))))
    decided = _decided(trials, plan, seed)
    samples = decided.samples
    working = samples.answers == Answer.WORKS
    conclusive = working | (samples.answers == Answer.FAILS)
    result = Tolerance(
        question=question,
        plan=plan,
        seed=seed,
        runs=trials.count,
        nominal=nominal,
        samples=samples,
        indices=decided.indices,
        effects=decided.effects,
        kept=decided.kept,
        screened=decided.screened,
        narrowed=tuple(
            narrowed(samples.offsets[conclusive, factor], working[conclusive], deviation.distribution)
            for factor, deviation in enumerate(question.deviations)
        ),
        reaches=(),
        nearest=None,
        map=None,
    )
    if result.nominal_works:
        result = replace(result, reaches=_alone(trials, plan), nearest=_nearest(trials, plan, decided.every))
    result = replace(result, map=_map(trials, plan, result.order[:2]))
    return replace(result, runs=trials.count)


def _effects(trials: _Trials, plan: Plan, first: Array, second: Array, at_first: Samples, samples: Samples) -> Values:
    """Estimate the fraction of the margin's variance that involves each factor, (factors,), from few rows."""
    rows, factors = plan.screened, first.shape[1]
    before, after = first[:rows], second[:rows]
    mixed = trials(
        trials.question.offsets(np.concatenate([exchanged(before, after, [factor]) for factor in range(factors)]))
    )
    effects = total_effects(at_first.margins[0, :rows], mixed.margins[0].reshape(factors, rows), (after - before).T)
    variance = float(np.var(samples.margins[0]))
    return np.asarray(effects / variance if variance else effects)


def _alone(trials: _Trials, plan: Plan) -> tuple[tuple[Reach, Reach], ...]:
    """Return the deviation range of every factor alone, downwards and upwards."""
    if not plan.steps:
        return ()
    factors = len(trials.question.deviations)
    directions = [sign * row for row in np.eye(factors) for sign in (-1.0, 1.0)]
    ends = reaches(_asking(trials, directions), len(directions), plan.steps, plan.halvings)
    return tuple(zip(ends[::2], ends[1::2], strict=True))


def _nearest(trials: _Trials, plan: Plan, every: Samples) -> NearestFailure | None:
    """Return the failure whose largest deviation is smallest, searched in the directions of failing samples.

    The directions are those of the failing samples with the smallest deviations, and the corner in which every factor
    deviates to the side on which the margin decreases, if this correlation is significant.
    """
    failing = every.offsets[every.answers == Answer.FAILS]
    if not plan.nearest:
        return None
    slopes = _correlations(every)
    slopes[np.abs(slopes) < _CHANCE / np.sqrt(len(every))] = 0.0
    central = failing[np.argsort(np.sum(failing**2, axis=1), kind="stable")[: plan.nearest - 1]]
    # 0.0 - avoids negative zeros
    directions: list[Array] = [*([0.0 - np.sign(slopes)] if slopes.any() else []), *central]
    failures = [
        NearestFailure(offsets=reach.fails * direction, works=reach.works / reach.fails)
        for reach, direction in zip(
            reaches(_asking(trials, directions), len(directions), (1.0,), plan.halvings), directions, strict=True
        )
        if reach.fails is not None
    ]
    return min(failures, key=lambda failure: failure.largest, default=None)


def _correlations(samples: Samples) -> Values:
    """Return the correlation of the margin with every factor, (factors,); 0 for a factor that does not vary."""
    margins, offsets = samples.margins[0] - np.mean(samples.margins[0]), samples.offsets - np.mean(samples.offsets, 0)
    scale = np.sqrt(np.sum(margins**2) * np.sum(offsets**2, axis=0))
    return np.asarray(np.divide(offsets.T @ margins, scale, out=np.zeros(len(scale)), where=scale > 0))


def _asking(trials: _Trials, directions: Sequence[Array]) -> Ask:
    """Return a function that runs designs with deviations along directions, (factors,) each, in widths.

    A design that its keys do not allow is not run.
    """

    def ask(moves: Sequence[tuple[int, float]]) -> Sequence[Answer]:
        offsets = [directions[direction] * distance for direction, distance in moves]
        allowed = [trials.question.allows(offset) for offset in offsets]
        inside = [offset for offset, is_allowed in zip(offsets, allowed, strict=True) if is_allowed]
        answers = iter(trials(np.array(inside)).answers if inside else ())
        return [next(answers) if is_allowed else Answer.OUTSIDE for is_allowed in allowed]

    return ask


def _map(trials: _Trials, plan: Plan, factors: Sequence[int]) -> VerdictMap | None:
    """Return the results of designs in which only two factors deviate."""
    if not plan.cells or len(factors) < 2:
        return None
    deviations = trials.question.deviations
    steps = np.stack([np.linspace(*_map_ends(trials.question, factor), plan.cells) for factor in factors])
    offsets = np.zeros((plan.cells**2, len(deviations)))
    offsets[:, factors[0]], offsets[:, factors[1]] = np.repeat(steps[0], plan.cells), np.tile(steps[1], plan.cells)
    return VerdictMap(first=factors[0], second=factors[1], steps=steps, samples=trials(offsets))


def _map_ends(question: Question, factor: int) -> tuple[float, float]:
    """Return the lower and upper end of the map, in widths, within what the key allows."""
    far, (down, up) = _MAP_REACH[question.deviations[factor].distribution], question.reach(factor)
    return max(-far, down), min(far, up)
