"""Values between samples that agree with facts: Monte Carlo on emulators of the facts, with their errors."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.goals.identify.emulator import Emulator

_PARTICLES = 600
# effective fraction of the particles after a step of the tempering, and number of moves of each particle after it
_EFFECTIVE, _MOVES, _MOST_STEPS = 0.5, 4, 60
# steps are differences between particles (ter Braak 2006, doi:10.1007/s11222-006-8769-1) with this stretch and scatter
_STRETCH, _SCATTER = (0.2, 1.0), 1e-3
_LEAST = 1e-300
# number of points of the search for the smallest deviation, and of its generations
_SEARCHERS, _GENERATIONS = 100, 30


@dataclass(frozen=True, kw_only=True)
class AgreementWindow:
    """Interval in which a fact's quantity must lie, in the units of its emulator.

    Attributes:
        emulator: emulator of the quantity.
        low: lower end; minus infinity if there is none.
        high: upper end; infinity if there is none.
    """

    emulator: Emulator
    low: float
    high: float


@dataclass(frozen=True, kw_only=True)
class Agreement:
    """Points of the unit cube that agree with facts according to emulators.

    Attributes:
        points: drawn from the priors under the condition that all facts are met, (particles, unknowns).
        share: fraction of the priors that meets all facts.
        apart: smallest deviation of the worst fact anywhere, in standard errors of its emulator.
        errors: median standard error of each fact's emulator at the points, (facts,), in half-widths of its window; 0
            if the window has only one end.
    """

    points: Array
    share: float
    apart: float
    errors: Array


def agreement(windows: Sequence[AgreementWindow], choices: Sequence[int], seed: int) -> Agreement:
    """Draw points from the priors that meet all facts, by tempering from the priors.

    The method is sequential Monte Carlo (Del Moral, Doucet and Jasra 2006, doi:10.1111/j.1467-9868.2006.00553.x). The
    probability that a point meets a fact is that of the emulator's error, with Student's t distribution. The errors of
    the facts are assumed to be independent.

    Args:
        windows: windows of the facts.
        choices: for each side of the cube, its number of equal parts within which nothing varies; 0 if it is
            continuous.
        seed: seed of the random numbers.
    """
    generator = np.random.default_rng([seed, len(choices), len(windows)])
    points = generator.random((_PARTICLES, len(choices)))
    log_chances, apart = _log_chances(windows, snapped(points, choices))
    least, log_share, power = float(apart.min()), 0.0, 0.0
    for _ in range(_MOST_STEPS):
        if power >= 1:
            break
        step = _step(log_chances, 1 - power)
        weights = np.exp(step * (log_chances - log_chances.max()))
        log_share += float(np.log(np.mean(weights)) + step * log_chances.max())
        power = 1.0 if step >= 1 - power else power + step
        resampled = generator.choice(_PARTICLES, size=_PARTICLES, p=weights / weights.sum())
        points, log_chances = points[resampled], log_chances[resampled]
        for _ in range(_MOVES):
            one, other = (generator.integers(_PARTICLES, size=_PARTICLES) for _ in range(2))
            stretch = generator.uniform(*_STRETCH, size=(_PARTICLES, 1))
            scatter = _SCATTER * generator.standard_normal(points.shape)
            tried = _reflected(points + stretch * (points[one] - points[other]) + scatter)
            at_tried, apart = _log_chances(windows, snapped(tried, choices))
            least = min(least, float(apart.min()))
            accepted = np.log(generator.random(_PARTICLES)) < power * (at_tried - log_chances)
            points, log_chances = (
                np.where(accepted[:, np.newaxis], tried, points),
                np.where(accepted, at_tried, log_chances),
            )
    return Agreement(
        points=points,
        share=float(np.exp(min(log_share, 0.0))),
        apart=least,
        errors=_errors(windows, snapped(points, choices)),
    )


def least_apart(windows: Sequence[AgreementWindow], choices: Sequence[int], seed: int) -> float:
    """Return the smallest deviation of the worst fact anywhere, in standard errors, by differential evolution.

    Args:
        windows: windows of the facts.
        choices: see `agreement`.
        seed: seed of the random numbers.
    """
    generator = np.random.default_rng([seed, len(choices), len(windows)])
    points = generator.random((_SEARCHERS, len(choices)))
    _, apart = _log_chances(windows, snapped(points, choices))
    for _ in range(_GENERATIONS):
        best = points[np.argmin(apart)]
        one, other = (generator.integers(_SEARCHERS, size=_SEARCHERS) for _ in range(2))
        stretch = generator.uniform(*_STRETCH, size=(_SEARCHERS, 1))
        tried = _reflected(points + stretch * (points[one] - points[other]) + stretch * (best - points))
        _, at_tried = _log_chances(windows, snapped(tried, choices))
        accepted = at_tried <= apart
        points, apart = np.where(accepted[:, np.newaxis], tried, points), np.where(accepted, at_tried, apart)
    return float(apart.min())


def snapped(points: Array, choices: Sequence[int]) -> Array:
    """Move points of the unit cube to the middle of their part on sides with choices, (points, unknowns)."""
    moved = points.copy()
    for side, count in enumerate(choices):
        if count:
            moved[:, side] = (np.minimum(np.floor(points[:, side] * count), count - 1) + 0.5) / count
    return moved


def _step(log_chances: Array, most: float) -> float:
    """Return the largest step of the tempering, up to `most`, that leaves enough effective particles."""

    def effective(step: float) -> float:
        weights = np.exp(step * (log_chances - log_chances.max()))
        return float(weights.sum() ** 2 / np.sum(weights**2) / len(log_chances))

    if effective(most) >= _EFFECTIVE:
        return most
    low, high = 0.0, most
    for _ in range(30):
        middle = (low + high) / 2
        low, high = (middle, high) if effective(middle) >= _EFFECTIVE else (low, middle)
    return max(low, 1e-6 * most)


def _log_chances(windows: Sequence[AgreementWindow], points: Array) -> tuple[Array, Array]:
    """Return each point's log probability of meeting all facts, and its largest deviation in standard errors."""
    chances, apart = np.zeros(len(points)), np.zeros(len(points))
    for window in windows:
        mean, error = window.emulator.predict(points)
        low, high = (window.low - mean) / error, (window.high - mean) / error
        apart = np.maximum(apart, np.maximum(low, -high))
        # the smaller of both tails is used, so that no digits are lost if the window is far away
        is_above = low > 0
        low, high = np.where(is_above, -high, low), np.where(is_above, -low, high)
        freedom = window.emulator.freedom
        chance = scipy.special.stdtr(freedom, high) - scipy.special.stdtr(freedom, low)
        chances += np.log(np.maximum(chance, _LEAST))
    return chances, apart


def _errors(windows: Sequence[AgreementWindow], points: Array) -> Array:
    widths = [(window.high - window.low) / 2 for window in windows]
    errors = [float(np.median(window.emulator.predict(points)[1])) for window in windows]
    return np.array([error / width if np.isfinite(width) else 0.0 for error, width in zip(errors, widths, strict=True)])


def _reflected(points: Array) -> Array:
    return np.abs(np.mod(points + 1.0, 2.0) - 1.0)
