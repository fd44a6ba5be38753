"""Values between samples that agree with facts: ranges of the unknowns, and whether there were enough samples."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.goals.identify.agreement import Agreement, AgreementWindow, agreement, least_apart, snapped
from forficula.goals.identify.emulator import Emulator, fit_emulator, least_samples
from forficula.goals.identify.fact import COUNTS, PLACES, Fact
from forficula.goals.identify.identify import Sample
from forficula.goals.identify.observations import Observations

# probability content of the central ranges; we chose it so that planted values lie within them in at least 90 of 100
# cases (benchmarks/identify.py)
LEVEL = 0.95
# the samples are enough to exclude facts if these are missed everywhere by this number of standard errors of emulators
APART = 3.0
# number of samples, nearest to the facts, that emulators use, because their cost grows with the cube
_MOST_SAMPLES = 160
# half-width of the window of an exact fact, in the fact's scale
_EXACT = 1e-3


@dataclass(frozen=True, kw_only=True)
class Inference:
    """Predictions of the facts' emulators between the samples.

    Attributes:
        windows: windows of the facts; empty if there are too few samples for an emulator of one of them.
        choices: number of choices of each unknown, 0 for continuous ones, (unknowns,).
        agreement: points that meet all facts; None without windows.
        needed: minimum number of samples for emulators.
        seed: seed of the random numbers.
    """

    windows: tuple[AgreementWindow, ...]
    choices: tuple[int, ...]
    agreement: Agreement | None
    needed: int
    seed: int

    @property
    def possible(self) -> bool:
        """Whether all facts may be met together within the emulators' errors."""
        return self.agreement is None or self.agreement.apart <= APART

    def apart(self, facts: Sequence[int]) -> float:
        """Return the smallest deviation from some facts, in standard errors; 0 without emulators."""
        if not self.windows:
            return 0.0
        return least_apart([self.windows[fact] for fact in facts], self.choices, self.seed)

    def range_of(self, unknown: int) -> tuple[float, float]:
        """Return the ends of an unknown's range, as fractions of the prior; the whole prior without emulators."""
        if self.agreement is None:
            return 0.0, 1.0
        low, high = np.quantile(self.agreement.points[:, unknown], [(1 - LEVEL) / 2, (1 + LEVEL) / 2])
        return float(low), float(high)

    def choices_of(self, unknown: int) -> list[int]:
        """Return the indices of the most likely choices of an unknown, which contain `LEVEL` of the agreeing points."""
        count = self.choices[unknown]
        if self.agreement is None:
            return list(range(count))
        indices = np.minimum((self.agreement.points[:, unknown] * count).astype(int), count - 1)
        shares = np.bincount(indices, minlength=count) / len(indices)
        order = np.argsort(-shares, kind="stable")
        kept = int(np.searchsorted(np.cumsum(shares[order]), LEVEL)) + 1
        return sorted(order[:kept].tolist())


def infer(observations: Observations, samples: Sequence[Sample], missing: Array) -> Inference:
    """Fit an emulator of every fact to the samples, and draw points that meet all facts.

    Args:
        observations: design, unknowns and facts.
        samples: those that ran.
        missing: distance of each sample from meeting all facts together, (samples,). Emulators use the nearest.
    """
    choices = tuple(0 if prior.distribution is not None else len(prior.values) for prior in observations.priors)
    nearest = [samples[index] for index in np.argsort(missing, kind="stable")[:_MOST_SAMPLES]]
    windows = [_window(fact, number, nearest, choices) for number, fact in enumerate(observations.facts)]
    fitted = tuple(window for window in windows if window is not None)
    complete = len(fitted) == len(windows)
    return Inference(
        windows=fitted if complete else (),
        choices=choices,
        agreement=agreement(fitted, choices, observations.seed) if complete else None,
        needed=least_samples(len(choices)),
        seed=observations.seed,
    )


def _window(fact: Fact, number: int, samples: Sequence[Sample], choices: Sequence[int]) -> AgreementWindow | None:
    """Return the window of a fact's deviation, on a scale that compresses large ones; None with too few samples."""
    conclusive = [sample for sample in samples if not sample.findings[number].untold]
    if len(conclusive) < least_samples(len(choices)):
        return None
    misses = np.array([sample.findings[number].miss for sample in conclusive])
    half = fact.tolerance + _grain(fact)
    # deviations are linear up to their median and logarithmic beyond, because conditions without a number have one that
    # is far from all others
    scale = max(float(np.median(np.abs(misses))), half) or 1.0
    half = max(half, _EXACT * scale)
    emulator: Emulator | None = fit_emulator(
        snapped(np.array([sample.shares for sample in conclusive]), choices), np.arcsinh(misses / scale)
    )
    if emulator is None:
        return None
    end = float(np.arcsinh(half / scale))
    # the deviation of a position is the difference to the least number, which has only one side
    low = -np.inf if fact.order == "at most" or fact.term.statistic in PLACES else -end
    high = np.inf if fact.order == "at least" else end
    return AgreementWindow(emulator=emulator, low=low, high=high)


def _grain(fact: Fact) -> float:
    """Return half the distance between neighbouring values of a stepped quantity: counts, and least values."""
    if fact.term.statistic in COUNTS:
        return 0.5
    if fact.term.least is not None and not fact.term.quantity and len(fact.term.least.numbers) > 1:
        return float(np.min(np.diff(fact.term.least.numbers))) / 2
    return 0.0
