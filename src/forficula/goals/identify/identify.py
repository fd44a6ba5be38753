"""The whole of an identification: samples of what is unknown are run, and held against every fact."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array, Flags
from forficula.errors import InputError
from forficula.goals.identify.fact import Fact, Term
from forficula.goals.identify.observations import Observations
from forficula.goals.identify.observe import Observed, observe
from forficula.goals.identify.prior import prior_shares, values_at
from forficula.goals.identify.sample_runs import ConditionRun, Rows, SampleRuns, Wanted
from forficula.study.running.journal import Row

# Rows of runs, in their order.
Assess = Callable[[Sequence[ConditionRun]], Sequence[Row]]
# Called with the samples that are done, all samples, and those so far.
Progress = Callable[[int, int, "Sequence[Sample]"], None]

# Samples side by side, whose runs go out together; of those that are placed fewer, for each batch learns from the last.
_BATCH, _PLACED_BATCH = 32, 16
# of a bound: what differs by less differs by rounding
_ROUNDING = 1e-9
Target = tuple[int, ...]
# of a target: those from which steps are taken, and those whose differences are the steps (Storn and Price 1997)
_STARTS, _NEAREST = 3, 10
# by how much of a difference at least and at most, and how many of a sample's shares change at once
_STEPS, _CHANGED = (0.1, 0.9), 0.6
# added to every step, so that what the nearest have in common can still change
_NOISE = 0.02


@dataclass(frozen=True, kw_only=True)
class Sample:
    """A sample and what it says of every fact.

    Attributes:
        number: from 0 on, as they were drawn or placed.
        shares: where it lies in the unit cube, (unknowns,).
        values: of the unknowns by key, as a design file has them.
        findings: of every fact; none where there is no such design.
        why: there is no such design; "" where there is.
        target: numbers of the facts that it was placed to meet together; none where it was drawn from the priors.
    """

    number: int
    shares: Array
    values: Mapping[str, object]
    findings: tuple[Finding, ...]
    why: str = ""
    target: Target = ()

    @property
    def directed(self) -> bool:
        """Whether it was placed, and not drawn from the priors."""
        return bool(self.target)


def identify_samples(observations: Observations, assess: Assess, progress: Progress | None = None) -> list[Sample]:
    """Run the samples of observations: first those drawn from the priors, then those that try to refute exclusions.

    Args:
        observations: what was seen.
        assess: makes rows of runs.
        progress: is told of every batch.
    """
    shares = prior_shares(observations.priors, observations.samples, observations.seed)
    total = observations.samples + observations.directed
    samples: list[Sample] = []

    def run(points: Array, targets: Sequence[Target]) -> None:
        samples.extend(_run_batch(observations, points, len(samples), assess, targets))
        if progress is not None:
            progress(len(samples), total, samples)

    for first in range(0, len(shares), _BATCH):
        batch = shares[first : first + _BATCH]
        run(batch, [()] * len(batch))
    scales = fact_scales(observations.facts, samples)
    while len(samples) < total:
        targets = _turned(open_targets(met_of(samples, len(observations.facts))), len(samples))
        ran = [sample for sample in samples if not sample.why]
        if not targets or not ran:
            break
        count = min(_PLACED_BATCH, total - len(samples))
        excess = excess_of(observations.facts, ran, scales)
        seed = (observations.seed, len(samples))
        known = np.array([sample.shares for sample in ran])
        placed = directed_shares(known, excess, targets, count, seed)
        run(placed, [targets[number % len(targets)] for number in range(count)])
    return samples


def _turned(targets: Sequence[Target], done: int) -> list[Target]:
    """Targets from another one on each time, so that all have their turn where there are more than a batch has."""
    first = done % max(len(targets), 1)
    return [*targets[first:], *targets[:first]]


def met_of(samples: Sequence[Sample], facts: int) -> Flags:
    """Whether each sample met each fact, (samples, facts)."""
    return np.array([[each.met for each in sample.findings] or [False] * facts for sample in samples], dtype=bool)


def tells_of(samples: Sequence[Sample], facts: int) -> Flags:
    """Whether each sample tells for certain of each fact, (samples, facts)."""
    return np.array([[each.tells for each in sample.findings] or [False] * facts for sample in samples], dtype=bool)


def excess_of(facts: Sequence[Fact], samples: Sequence[Sample], scales: Array) -> Array:
    """By how much each sample misses each fact beyond its tolerance, in units of the fact's scale, (samples, facts).

    Not a number of samples that could not run.
    """
    nothing = [float("nan")] * len(facts)
    distances = np.array([[each.distance for each in sample.findings] or nothing for sample in samples])
    met = met_of(samples, len(facts))
    beyond = np.maximum(distances - np.array([fact.tolerance for fact in facts]), 0.0) / scales
    return np.asarray(np.where(met, 0.0, beyond))


def fact_scales(facts: Sequence[Fact], samples: Sequence[Sample]) -> Array:
    """The scale of each fact's distance, SI, (facts,): its own, or the middle distance of samples that miss it."""
    scales = []
    for number, fact in enumerate(facts):
        missed = [each.findings[number].distance for each in samples if each.findings and not each.findings[number].met]
        middle = float(np.median(missed)) if missed else 1.0
        scales.append(fact.scale or (middle if middle > 0 else 1.0))
    return np.array(scales)


def _run_batch(
    observations: Observations, points: Array, first: int, assess: Assess, targets: Sequence[Target]
) -> list[Sample]:
    """Samples at points, their runs side by side."""
    built = [(point, values_at(observations.priors, point)) for point in points]
    runs: dict[int, SampleRuns] = {}
    whys: dict[int, str] = {}
    for number, (_, values) in enumerate(built):
        try:
            runs[number] = SampleRuns(observations.base, values)
        except InputError as error:
            whys[number] = str(error)
    found = _find_all(observations.facts, runs, assess)
    return [
        Sample(
            number=first + number,
            shares=point,
            values=values,
            findings=found.get(number, ()),
            why=whys.get(number, ""),
            target=targets[number],
        )
        for number, (point, values) in enumerate(built)
    ]


def _find_all(facts: Sequence[Fact], runs: Mapping[int, SampleRuns], assess: Assess) -> dict[int, tuple[Finding, ...]]:
    """What every sample says of every fact: what is missing is run until nothing is."""
    rows: dict[str, Row] = {}
    found: dict[tuple[int, int], Finding] = {}
    while True:
        wanted: Wanted = {}
        for number, each in runs.items():
            for fact, asked in enumerate(facts):
                if (number, fact) in found:
                    continue
                result = find(asked, each, rows)
                if isinstance(result, Finding):
                    found[number, fact] = result
                else:
                    wanted |= result
        if not wanted:
            break
        rows |= dict(zip(wanted, assess(list(wanted.values())), strict=True))
    return {number: tuple(found[number, fact] for fact in range(len(facts))) for number in runs}


@dataclass(frozen=True, kw_only=True)
class Finding:
    """What a sample says of a fact.

    Attributes:
        value: of what is observed, SI.
        miss: the value less its bound, SI, signed.
        distance: by how much the fact is missed, SI, at least 0; where runs that do not tell leave it open between two
            numbers, the larger one, and where they leave it open altogether, as if these had no number.
        met: whether it is within the fact's tolerance, whatever runs that do not tell would have come to.
        tells: whether it is met, or missed, for certain.
        untold: how many runs do not tell.
    """

    value: float
    miss: float
    distance: float
    met: bool
    tells: bool
    untold: int


def find(fact: Fact, runs: SampleRuns, rows: Rows) -> Finding | Wanted:
    """Say how far a sample is from a fact, or which of its designs must run before that is known."""
    observed = [observe(term, fact.places, runs, rows) for term in fact.terms]
    wanted = {key: run for each in observed if isinstance(each, dict) for key, run in each.items()}
    if wanted:
        return wanted
    seen = [each for each in observed if isinstance(each, Observed)]
    first, bound = seen[0], seen[1] if len(seen) > 1 else _fixed(fact)
    near, far = _distances(fact, first, bound)
    within = fact.tolerance + _ROUNDING * max(1.0, abs(first.value))
    return Finding(
        value=first.value,
        miss=first.value - bound.value,
        distance=far if math.isfinite(far) else _distance(fact, first.value, bound.value),
        met=far <= within,
        tells=far <= within or near > within,
        untold=sum(each.untold for each in seen),
    )


def _fixed(fact: Fact) -> Observed:
    """A bound that is a number, as if it were observed."""
    assert not isinstance(fact.bound, Term)
    return Observed(value=fact.bound, low=fact.bound, high=fact.bound, untold=0)


def _distances(fact: Fact, seen: Observed, bound: Observed) -> tuple[float, float]:
    """The least and the largest distance, whatever runs that do not tell would have come to."""
    far = max(_distance(fact, one, other) for one in (seen.low, seen.high) for other in (bound.low, bound.high))
    match fact.order:
        case "at least":
            near = bound.low - seen.high
        case "at most":
            near = seen.low - bound.high
        case _:
            near = max(bound.low - seen.high, seen.low - bound.high)
    return max(0.0, near), far


def _distance(fact: Fact, value: float, bound: float) -> float:
    if value == bound:
        return 0.0
    match fact.order:
        case "at least":
            return max(0.0, bound - value)
        case "at most":
            return max(0.0, value - bound)
        case _:
            return abs(value - bound)


def open_targets(met: Flags) -> list[Target]:
    """What no sample has met so far: all facts together, every fact, and every pair of facts that are met apart.

    Where every fact and every pair that is met apart is met, every three of which any two are.

    Args:
        met: whether each sample met each fact, (samples, facts).

    Returns:
        Numbers of the facts, those of the most facts first.
    """
    count = met.shape[1]
    single = [(fact,) for fact in range(count) if not met[:, fact].any()]
    pairs = [
        (one, other)
        for one, other in itertools.combinations(range(count), 2)
        if met[:, one].any() and met[:, other].any() and not (met[:, one] & met[:, other]).any()
    ]
    triples = [
        three
        for three in itertools.combinations(range(count), 3)
        if not (single or pairs)
        and all(met[:, two].all(axis=1).any() for two in itertools.combinations(three, 2))
        and not met[:, three].all(axis=1).any()
    ]
    everything = [] if met.all(axis=1).any() else [tuple(range(count))]
    return list(dict.fromkeys([*everything, *single, *pairs, *triples]))


def misses(excess: Array, target: Target) -> Array:
    """How far each sample is from meeting the facts of a target together, (samples,), 0 where it does.

    Args:
        excess: by how much each sample misses each fact beyond its tolerance, in units of the fact's scale,
            (samples, facts); not a number of a sample that could not run.
        target: numbers of facts.

    Returns:
        The sum over the facts of x / (1 + x), so that one that is missed by far does not hide the others; infinite
        where a sample could not run.
    """
    each = excess[:, target]
    return np.where(np.isnan(each).any(axis=1), np.inf, (each / (1 + each)).sum(axis=1))


def directed_shares(shares: Array, excess: Array, targets: Sequence[Target], count: int, seed: Sequence[int]) -> Array:
    """Place samples, each by differential evolution among those nearest to one of the targets in turn.

    Args:
        shares: of the samples so far, in the unit cube, (samples, unknowns).
        excess: as of `misses`.
        targets: in turn, from the first on.
        count: how many to place.
        seed: of the random numbers.

    Returns:
        Points of the unit cube, (count, unknowns).
    """
    generator = np.random.default_rng(list(seed))
    placed = []
    for number in range(count):
        order = np.argsort(misses(excess, targets[number % len(targets)]), kind="stable")
        start = shares[order[generator.integers(min(_STARTS, len(order)))]]
        one, other = shares[generator.permutation(order[:_NEAREST])[[0, -1]]]
        step = generator.uniform(*_STEPS) * (one - other) + _NOISE * generator.standard_normal(shares.shape[1])
        changed = np.asarray(generator.random(shares.shape[1]) < _CHANGED)
        changed[generator.integers(shares.shape[1])] = True
        placed.append(_reflected(start + np.where(changed, step, 0.0)))
    return np.array(placed)


def _reflected(point: Array) -> Array:
    """A point of the cube: what is beyond a side comes back from it."""
    folded = np.abs(np.mod(point + 1.0, 2.0) - 1.0)
    return np.clip(folded, 0.0, np.nextafter(1.0, 0.0))
