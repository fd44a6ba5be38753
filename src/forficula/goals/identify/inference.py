"""What agrees with facts between the samples: ranges of the unknowns, and whether the samples were enough."""

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

# ranges are central ones of this share, chosen by us: planted values lie within at least 90 times in 100
# (benchmarks/identify.py)
LEVEL = 0.95
# by how many standard errors of the emulators the facts must be missed everywhere for the samples to be enough
APART = 3.0
# samples that emulators take, those nearest to the facts: their cost grows with the cube
_MOST_SAMPLES = 160
# half-width, in the scale of a fact, of what is to be met exactly
_EXACT = 1e-3


@dataclass(frozen=True, kw_only=True)
class Inference:
    """What emulators of the facts say of the values between the samples.

    Attributes:
        windows: of the facts; none where samples are too few for an emulator of one of them.
        choices: of the unknowns, 0 of those that vary without steps, (unknowns,).
        agreement: points that meet all facts; None where there are no windows.
        needed: samples that emulators take at least.
        seed: of the random numbers.
    """

    windows: tuple[AgreementWindow, ...]
    choices: tuple[int, ...]
    agreement: Agreement | None
    needed: int
    seed: int

    @property
    def possible(self) -> bool:
        """Whether all facts may be met together, as far as the emulators' errors allow to say."""
        return self.agreement is None or self.agreement.apart <= APART

    def apart(self, facts: Sequence[int]) -> float:
        """By how many standard errors some facts are missed where that is least; 0 without emulators."""
        if not self.windows:
            return 0.0
        return least_apart([self.windows[fact] for fact in facts], self.choices, self.seed)

    def range_of(self, unknown: int) -> tuple[float, float]:
        """Ends of an unknown's range, as shares of the prior; the whole prior without emulators."""
        if self.agreement is None:
            return 0.0, 1.0
        low, high = np.quantile(self.agreement.points[:, unknown], [(1 - LEVEL) / 2, (1 + LEVEL) / 2])
        return float(low), float(high)

    def choices_of(self, unknown: int) -> list[int]:
        """Numbers of the choices of an unknown that hold `LEVEL` of what agrees, the least likely ones left out."""
        count = self.choices[unknown]
        if self.agreement is None:
            return list(range(count))
        places = np.minimum((self.agreement.points[:, unknown] * count).astype(int), count - 1)
        shares = np.bincount(places, minlength=count) / len(places)
        order = np.argsort(-shares, kind="stable")
        kept = int(np.searchsorted(np.cumsum(shares[order]), LEVEL)) + 1
        return sorted(order[:kept].tolist())


def infer(observations: Observations, samples: Sequence[Sample], missing: Array) -> Inference:
    """Fit an emulator of every fact to the samples, and draw what meets all facts between them.

    Args:
        observations: what was seen.
        samples: those that ran.
        missing: of each how far it is from all facts together, (samples,); emulators take the nearest.
    """
    choices = tuple(0 if prior.distribution is not None else len(prior.values) for prior in observations.priors)
    nearest = [samples[place] for place in np.argsort(missing, kind="stable")[:_MOST_SAMPLES]]
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
    """Where a fact's miss must lie, on a scale on which far misses count little; None with too few samples."""
    told = [sample for sample in samples if not sample.findings[number].untold]
    if len(told) < least_samples(len(choices)):
        return None
    misses = np.array([sample.findings[number].miss for sample in told])
    half = fact.tolerance + _grain(fact)
    # misses are kept as they are up to their middle size and beyond by their logarithm: conditions without a number
    # have one that is far from all others
    scale = max(float(np.median(np.abs(misses))), half) or 1.0
    half = max(half, _EXACT * scale)
    emulator: Emulator | None = fit_emulator(
        snapped(np.array([sample.shares for sample in told]), choices), np.arcsinh(misses / scale)
    )
    if emulator is None:
        return None
    end = float(np.arcsinh(half / scale))
    # a place's miss is how far it is above the least: it has no other side
    low = -np.inf if fact.order == "at most" or fact.term.statistic in PLACES else -end
    high = np.inf if fact.order == "at least" else end
    return AgreementWindow(emulator=emulator, low=low, high=high)


def _grain(fact: Fact) -> float:
    """Half the distance between neighbouring values of what has steps: counts, and least values that are tried."""
    if fact.term.statistic in COUNTS:
        return 0.5
    if fact.term.least is not None and not fact.term.quantity and len(fact.term.least.numbers) > 1:
        return float(np.min(np.diff(fact.term.least.numbers))) / 2
    return 0.0
