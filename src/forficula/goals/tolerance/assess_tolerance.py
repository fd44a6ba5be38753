"""How likely a design works as it is built: which designs are run, one batch after another, and what they say."""

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
from forficula.goals.deviation import off_values
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
# what the others are called, as a group
REST = "the others"
# how far the map goes, in widths: a little beyond a uniform tolerance, and as far as most of a normal one
_MAP_REACH = {"uniform": 1.5, "normal": 3.0}
# rows that must be new for their time to say how long one takes
_TIMED = 8
# how many standard errors of a correlation are more than chance
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
    """Find how likely it is that a design works as it is built, and what decides it.

    How many designs are run is settled once, by how long the first of them take, and kept in the folder; from then on
    the result depends on nothing but the question and the seed, however often it is killed and taken up again.

    Args:
        question: which design, how far off, and when it works.
        out: folder with the rows and the plan; goes on there.
        minutes: how long it may take.
        runs: how many there may be, whatever time they take; by the time if not given.
        seed: of the points.
        shard: number, from 1 on, and count of the processes that share every batch.
        threads: 0 for one a core.
        cluster: from `dask_cluster`.
        progress: called after every run with the runs done now, the most that there are, and the row.

    Raises:
        InputError: no deviations, a number that is not allowed, or the folder holds another design's rows.
    """
    if not question.deviations:
        raise InputError(f"tolerances: need at least one, {question.design.name} has none")
    _check(minutes, seed, runs)
    trials = _Trials(question=question, progress=progress)
    with open_assessor(
        out, question.design, shard=shard, threads=threads, cluster=cluster, progress=trials.tell
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
    """Say which plan a tolerance takes, how many runs that is at most, and how long these take, s.

    Where the folder has no plan, a few designs within the tolerances are run now, and not kept.

    Args:
        question: which design, how far off, and when it works.
        out: folder with the rows, if there are any.
        minutes: how long it may take.
        seed: of the points.
        runs: as of `assess_tolerance`.

    Raises:
        InputError: a number is not allowed.
    """
    _check(minutes, seed, runs)
    factors = len(question.deviations)
    few = question.offsets(two_samples(factors, _TIMED, seed)[0]).tolist()
    designs = [built_design(question.design, off_values(question.design, question.deviations, each)) for each in few]
    start = time.monotonic()
    count = sum(1 for _ in evaluate([design for design in designs if isinstance(design, Design)]))
    seconds = (time.monotonic() - start) / max(count, 1)
    if runs is not None:
        plan = plan_within(factors, 1.0, runs)
    else:
        plan = kept_plan(Path(out), question, minutes, seed) or plan_within(factors, seconds, 60 * minutes)
    most = plan.most_runs(factors)
    return plan, most, most * seconds


def _check(minutes: object, seed: object, runs: object) -> None:
    if runs is not None:
        check_whole("runs", runs, 1)
    if isinstance(minutes, bool) or not isinstance(minutes, int | float) or not 0 < minutes < np.inf:
        raise InputError(f"minutes: need a number > 0, got {as_written(minutes)}")
    check_whole("seed", seed, 0)


@dataclass(kw_only=True)
class _Trials:
    """Runs designs that are off, and counts them.

    Attributes:
        question: which design.
        progress: of the caller.
        assessor: what makes rows.
        most: runs that there are at most.
        count: designs that were tried.
    """

    question: Question
    progress: Progress | None
    assessor: Assessor | None = None
    most: int = 0
    count: int = 0

    def __call__(self, offsets: Array) -> Samples:
        """What becomes of designs that are off by so many widths, (samples, factors)."""
        assert self.assessor is not None
        self.count += len(offsets)
        return assess_samples(self.question, self.assessor, offsets)

    def tell(self, done: int, wanted: int, row: Row) -> None:
        """Pass on how far it is."""
        if self.progress is not None:
            self.progress(done, max(wanted, self.most), row)


def _plan(trials: _Trials, folder: Path, minutes: float, seed: int) -> Plan:
    """The plan that the folder has, or one for which the first runs say that there is time."""
    question = trials.question
    if (kept := kept_plan(folder, question, minutes, seed)) is not None:
        return kept
    factors = len(question.deviations)
    # of a folder that has the first sample from before, the second one
    points = np.concatenate(two_samples(factors, PLANS[0].points, seed))
    trials(np.zeros((1, factors)))
    few, seconds = PLANS[-1].points, 0.0
    for begin in range(0, len(points), few):
        assert trials.assessor is not None
        before, start = trials.assessor.wanted, time.monotonic()
        trials(question.offsets(points[begin : begin + few]))
        if (new := trials.assessor.wanted - before) >= _TIMED:
            seconds = (time.monotonic() - start) / new
            break
    trials.count = 0
    return saved_plan(folder, question, minutes, seed, plan_within(factors, seconds, 60 * minutes))


@dataclass(frozen=True, kw_only=True)
class _Decided:
    """What decides the margins, and the samples that say so: as of `Tolerance`.

    Attributes:
        samples: independent ones.
        every: these and those that were exchanged between them.
        indices: of groups of factors.
        effects: of every factor.
        kept: factors with indices of their own.
        screened: what the screening says; None where there is none.
    """

    samples: Samples
    every: Samples
    indices: Indices
    effects: Values
    kept: tuple[int, ...]
    screened: Screening | None = None


def _decided(trials: _Trials, plan: Plan, seed: int) -> _Decided:
    """Run the samples of a plan, and find what decides their margins."""
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
    called = [question.keys[factor] for factor in kept]
    if screened is not None:
        groups.append([factor for factor in range(factors) if factor not in kept])
        called.append(REST)
    mixed = [exchanged(first[: plan.rows], second[: plan.rows], group) for group in groups]
    at_mixed = trials(question.offsets(np.concatenate(mixed)))
    margins = at_mixed.margins.reshape(len(names), len(groups), plan.rows).swapaxes(0, 1)
    at_rows = at_first.margins[:, : plan.rows]
    indices = sobol_indices(names, called, at_rows, at_second.margins, margins, seed, compared=len(kept) or None)
    return _Decided(
        samples=samples,
        every=joined([samples, at_mixed]),
        indices=indices,
        effects=indices.total[0] if screened is None else effects,
        kept=kept,
        screened=screened,
    )


def _assessed(trials: _Trials, plan: Plan, seed: int) -> Tolerance:
    """Run what a plan says, and draw from it what it tells."""
    question = trials.question
    nominal = trials(np.zeros((1, len(question.deviations))))
    decided = _decided(trials, plan, seed)
    samples = decided.samples
    works = samples.answers == Answer.WORKS
    tells = works | (samples.answers == Answer.FAILS)
    found = Tolerance(
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
            narrowed(samples.offsets[tells, factor], works[tells], deviation.distribution)
            for factor, deviation in enumerate(question.deviations)
        ),
        reaches=(),
        nearest=None,
        map=None,
    )
    if found.nominal_works:
        found = replace(found, reaches=_alone(trials, plan), nearest=_nearest(trials, plan, decided.every))
    found = replace(found, map=_map(trials, plan, found.order[:2]))
    return replace(found, runs=trials.count)


def _effects(trials: _Trials, plan: Plan, first: Array, second: Array, at_first: Samples, samples: Samples) -> Values:
    """The share of the margin's variance that has to do with each factor, (factors,), from few rows."""
    rows, factors = plan.screened, first.shape[1]
    one, other = first[:rows], second[:rows]
    mixed = trials(
        trials.question.offsets(np.concatenate([exchanged(one, other, [factor]) for factor in range(factors)]))
    )
    effects = total_effects(at_first.margins[0, :rows], mixed.margins[0].reshape(factors, rows), (other - one).T)
    variance = float(np.var(samples.margins[0]))
    return np.asarray(effects / variance if variance else effects)


def _alone(trials: _Trials, plan: Plan) -> tuple[tuple[Reach, Reach], ...]:
    """How far every factor alone may go down and up."""
    if not plan.steps:
        return ()
    factors = len(trials.question.deviations)
    ways = [sign * row for row in np.eye(factors) for sign in (-1.0, 1.0)]
    found = reaches(_asking(trials, ways), len(ways), plan.steps, plan.halvings)
    return tuple(zip(found[::2], found[1::2], strict=True))


def _nearest(trials: _Trials, plan: Plan, every: Samples) -> NearestFailure | None:
    """The failure with the least largest deviation on the ways to samples that fail.

    Those whose deviations are least as a whole, and the corner in which every factor is off to the side on which the
    margin falls, where it does so beyond chance.
    """
    failing = every.offsets[every.answers == Answer.FAILS]
    if not plan.nearest:
        return None
    slopes = _correlations(every)
    slopes[np.abs(slopes) < _CHANCE / np.sqrt(len(every))] = 0.0
    central = failing[np.argsort(np.sum(failing**2, axis=1), kind="stable")[: plan.nearest - 1]]
    # no minus zeros
    ways: list[Array] = [*([0.0 - np.sign(slopes)] if slopes.any() else []), *central]
    found = [
        NearestFailure(offsets=reach.fails * way, works=reach.works / reach.fails)
        for reach, way in zip(reaches(_asking(trials, ways), len(ways), (1.0,), plan.halvings), ways, strict=True)
        if reach.fails is not None
    ]
    return min(found, key=lambda each: each.largest, default=None)


def _correlations(samples: Samples) -> Values:
    """Of the margin with every factor, (factors,); 0 where it does not vary."""
    margins, offsets = samples.margins[0] - np.mean(samples.margins[0]), samples.offsets - np.mean(samples.offsets, 0)
    scale = np.sqrt(np.sum(margins**2) * np.sum(offsets**2, axis=0))
    return np.asarray(np.divide(offsets.T @ margins, scale, out=np.zeros(len(scale)), where=scale > 0))


def _asking(trials: _Trials, ways: Sequence[Array]) -> Ask:
    """What answers to deviations along ways, each (factors,) in widths; what no key allows is not run."""

    def ask(moves: Sequence[tuple[int, float]]) -> Sequence[Answer]:
        offsets = [ways[way] * distance for way, distance in moves]
        allowed = [trials.question.allows(each) for each in offsets]
        inside = [each for each, may in zip(offsets, allowed, strict=True) if may]
        answers = iter(trials(np.array(inside)).answers if inside else ())
        return [next(answers) if may else Answer.OUTSIDE for may in allowed]

    return ask


def _map(trials: _Trials, plan: Plan, factors: Sequence[int]) -> VerdictMap | None:
    """What becomes of designs of which two factors are off, and nothing else."""
    if not plan.cells or len(factors) < 2:
        return None
    deviations = trials.question.deviations
    steps = np.stack([np.linspace(*_map_ends(trials.question, each), plan.cells) for each in factors])
    offsets = np.zeros((plan.cells**2, len(deviations)))
    offsets[:, factors[0]], offsets[:, factors[1]] = np.repeat(steps[0], plan.cells), np.tile(steps[1], plan.cells)
    return VerdictMap(first=factors[0], second=factors[1], steps=steps, samples=trials(offsets))


def _map_ends(question: Question, factor: int) -> tuple[float, float]:
    """How far the map goes down and up, in widths: no farther than the key allows."""
    far, (down, up) = _MAP_REACH[question.deviations[factor].distribution], question.reach(factor)
    return max(-far, down), min(far, up)
