"""Identification: samples of the unknown values are run and compared with every fact."""

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
# Called with the number of completed samples, the number of all samples, and the samples so far.
Progress = Callable[[int, int, "Sequence[Sample]"], None]

# Samples that run side by side. Batches of placed samples are smaller, because each batch uses results of the last.
_BATCH, _PLACED_BATCH = 32, 16
# relative to a bound: smaller differences are rounding errors
_ROUNDING = 1e-9
Target = tuple[int, ...]
# per target: number of start points, and of points whose differences are the steps (Storn and Price 1997)
_STARTS, _NEAREST = 3, 10
# range of the step factor, and fraction of a sample's coordinates that change at once
_STEPS, _CHANGED = (0.1, 0.9), 0.6
# noise of every step, so that coordinates in which the nearest samples are equal can also change
_NOISE = 0.02


@dataclass(frozen=True, kw_only=True)
class Sample:
    """A sample and its results for every fact.

    Attributes:
        number: number from 0, in the order in which samples were drawn or placed.
        shares: position in the unit cube, (unknowns,).
        values: values of the unknowns by key, as in a design file.
        findings: for every fact; empty if the design does not exist.
        why: why the design does not exist, else "".
        target: indices of the facts that it was placed to meet together; empty if it was drawn from the priors.
    """

    number: int
    shares: Array
    values: Mapping[str, object]
    findings: tuple[Finding, ...]
    why: str = ""
    target: Target = ()

    @property
    def directed(self) -> bool:
        """Whether the sample was placed, not drawn from the priors."""
        return bool(self.target)


def identify_samples(observations: Observations, assess: Assess, progress: Progress | None = None) -> list[Sample]:
    """Run the samples of observations: first those drawn from the priors, then those placed to refute exclusions.

    Args:
        observations: design, unknowns and facts.
        assess: computes rows of runs.
        progress: called after every batch.
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
    """Rotate the targets, so that all have their turn if a batch has fewer."""
    first = done % max(len(targets), 1)
    return [*targets[first:], *targets[:first]]


def met_of(samples: Sequence[Sample], facts: int) -> Flags:
    """Return whether each sample met each fact, (samples, facts)."""
    return np.array([[finding.met for finding in sample.findings] or [False] * facts for sample in samples], dtype=bool)


def conclusive_of(samples: Sequence[Sample], facts: int) -> Flags:
    """Return whether each sample is conclusive for each fact, (samples, facts)."""
    return np.array(
        [[finding.conclusive for finding in sample.findings] or [False] * facts for sample in samples], dtype=bool
    )


def excess_of(facts: Sequence[Fact], samples: Sequence[Sample], scales: Array) -> Array:
    """Return the deviation of each sample beyond each fact's tolerance, in units of the fact's scale, (samples, facts).

    It is nan for samples that could not run.
    """
    missing = [float("nan")] * len(facts)
    distances = np.array([[finding.distance for finding in sample.findings] or missing for sample in samples])
    met = met_of(samples, len(facts))
    beyond = np.maximum(distances - np.array([fact.tolerance for fact in facts]), 0.0) / scales
    return np.asarray(np.where(met, 0.0, beyond))


def fact_scales(facts: Sequence[Fact], samples: Sequence[Sample]) -> Array:
    """Return the scale of each fact, SI, (facts,): its own, or the median deviation of samples that miss it."""
    scales = []
    for number, fact in enumerate(facts):
        missed = [
            sample.findings[number].distance
            for sample in samples
            if sample.findings and not sample.findings[number].met
        ]
        middle = float(np.median(missed)) if missed else 1.0
        scales.append(fact.scale or (middle if middle > 0 else 1.0))
    return np.array(scales)


def _run_batch(
    observations: Observations, points: Array, first: int, assess: Assess, targets: Sequence[Target]
) -> list[Sample]:
    """Return samples at points, with their runs done side by side."""
    built = [(point, values_at(observations.priors, point)) for point in points]
    runs: dict[int, SampleRuns] = {}
    whys: dict[int, str] = {}
    for number, (_, values) in enumerate(built):
        try:
            runs[number] = SampleRuns(observations.base, values)
        except InputError as error:
            whys[number] = str(error)
    findings = _find_all(observations.facts, runs, assess)
    return [
        Sample(
            number=first + number,
            shares=point,
            values=values,
            findings=findings.get(number, ()),
            why=whys.get(number, ""),
            target=targets[number],
        )
        for number, (point, values) in enumerate(built)
    ]


def _find_all(facts: Sequence[Fact], runs: Mapping[int, SampleRuns], assess: Assess) -> dict[int, tuple[Finding, ...]]:
    """Return the results of all samples for every fact: missing runs are done until none is missing."""
    rows: dict[str, Row] = {}
    findings: dict[tuple[int, int], Finding] = {}
    while True:
        wanted: Wanted = {}
        for number, sample_runs in runs.items():
            for fact, observed_fact in enumerate(facts):
                if (number, fact) in findings:
                    continue
                result = find(observed_fact, sample_runs, rows)
                if isinstance(result, Finding):
                    findings[number, fact] = result
                else:
                    wanted |= result
        if not wanted:
            break
        rows |= dict(zip(wanted, assess(list(wanted.values())), strict=True))
    return {number: tuple(findings[number, fact] for fact in range(len(facts))) for number in runs}


@dataclass(frozen=True, kw_only=True)
class Finding:
    """Result of a sample for a fact.

    Attributes:
        value: value of the observed quantity, SI.
        miss: value minus bound, SI, signed.
        distance: deviation from the fact, SI, at least 0. If inconclusive runs allow a range, it is the larger end; if
            they allow any value, they are treated as having no number.
        met: whether the deviation is within the fact's tolerance for every possible outcome of inconclusive runs.
        conclusive: whether the fact is certainly met or certainly missed.
        untold: number of inconclusive runs.
    """

    value: float
    miss: float
    distance: float
    met: bool
    conclusive: bool
    untold: int


def find(fact: Fact, runs: SampleRuns, rows: Rows) -> Finding | Wanted:
    """Return the result of a sample for a fact, or the designs that must run before it is known."""
    observed = [observe(term, fact.places, runs, rows) for term in fact.terms]
    wanted = {
        key: run for runs_or_value in observed if isinstance(runs_or_value, dict) for key, run in runs_or_value.items()
    }
    if wanted:
        return wanted
    values = [value for value in observed if isinstance(value, Observed)]
    first, bound = values[0], values[1] if len(values) > 1 else _fixed(fact)
    near, far = _distances(fact, first, bound)
    within = fact.tolerance + _ROUNDING * max(1.0, abs(first.value))
    return Finding(
        value=first.value,
        miss=first.value - bound.value,
        distance=far if math.isfinite(far) else _distance(fact, first.value, bound.value),
        met=far <= within,
        conclusive=far <= within or near > within,
        untold=sum(value.untold for value in values),
    )


def _fixed(fact: Fact) -> Observed:
    """Return a bound that is a number in the form of an observation."""
    assert not isinstance(fact.bound, Term)
    return Observed(value=fact.bound, low=fact.bound, high=fact.bound, untold=0)


def _distances(fact: Fact, seen: Observed, bound: Observed) -> tuple[float, float]:
    """Return the smallest and the largest deviation over all possible outcomes of inconclusive runs."""
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
    """Return the sets of facts that no sample has met so far.

    The sets are all facts, single facts, and pairs of facts that are both met, by the same or by different samples. If
    every fact and every such pair is met, the sets include triples whose pairs are all met.

    Args:
        met: whether each sample met each fact, (samples, facts).

    Returns:
        Indices of the facts of each set.
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
    """Return the distance of each sample from meeting the facts of a target together, (samples,); 0 if it does.

    Args:
        excess: deviation of each sample beyond each fact's tolerance, in units of the fact's scale, (samples, facts);
            nan for a sample that could not run.
        target: indices of facts.

    Returns:
        The sum over the facts of x / (1 + x), so that one large deviation does not hide the others; infinite if a
        sample could not run.
    """
    selected = excess[:, target]
    return np.where(np.isnan(selected).any(axis=1), np.inf, (selected / (1 + selected)).sum(axis=1))


def directed_shares(shares: Array, excess: Array, targets: Sequence[Target], count: int, seed: Sequence[int]) -> Array:
    """Place samples by differential evolution among those nearest to each target in turn.

    Args:
        shares: positions of the samples so far in the unit cube, (samples, unknowns).
        excess: see `misses`.
        targets: used in turn, from the first.
        count: number of samples to place.
        seed: seed of the random numbers.

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
    """Reflect a point at the sides of the cube."""
    folded = np.abs(np.mod(point + 1.0, 2.0) - 1.0)
    return np.clip(folded, 0.0, np.nextafter(1.0, 0.0))
