"""The whole of an identification: samples of what is unknown are run, and held against every fact."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array, Flags
from forficula.errors import InputError
from forficula.goals.identify.directed import Target, directed_shares, open_targets
from forficula.goals.identify.fact import Fact
from forficula.goals.identify.finding import Finding, find
from forficula.goals.identify.observations import Observations
from forficula.goals.identify.prior import prior_shares, values_at
from forficula.goals.identify.sample_runs import ConditionRun, SampleRuns, Wanted
from forficula.study.journal import Row

# Rows of runs, in their order.
Assess = Callable[[Sequence[ConditionRun]], Sequence[Row]]
# Called with the samples that are done, all samples, and those so far.
Progress = Callable[[int, int, "Sequence[Sample]"], None]

# Samples side by side, whose runs go out together; of those that are placed fewer, for each batch learns from the last.
_BATCH, _PLACED_BATCH = 32, 16


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
