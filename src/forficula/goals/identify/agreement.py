"""Values that meet facts between the samples: Monte Carlo on emulators of the facts' quantities, with their errors."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.goals.identify.emulator import Emulator

_PARTICLES = 600
# effective share of the particles that a step of the tempering leaves, and moves of each particle after it
_EFFECTIVE, _MOVES, _MOST_STEPS = 0.5, 4, 60
# of differences between particles that are steps (ter Braak 2006, doi:10.1007/s11222-006-8769-1), and their scatter
_STRETCH, _SCATTER = (0.2, 1.0), 1e-3
_LEAST = 1e-300
# points of the search for the least miss, and its generations
_SEARCHERS, _GENERATIONS = 100, 30


@dataclass(frozen=True, kw_only=True)
class AgreementWindow:
    """Where a fact's quantity must lie, as its emulator has it.

    Attributes:
        emulator: of the quantity.
        low: end of the window, the emulator's unit; minus infinity where there is none.
        high: the other end; infinity where there is none.
    """

    emulator: Emulator
    low: float
    high: float


@dataclass(frozen=True, kw_only=True)
class Agreement:
    """Points of the unit cube that meet facts according to emulators.

    Attributes:
        points: drawn from the priors, given that all facts are met, (particles, unknowns).
        share: of the priors that meets all facts.
        apart: by how many standard errors of its emulator the worst fact is missed, at the point where that is least.
        errors: standard error of each fact's emulator at the points, the median, (facts,), in half-widths of its
            window; 0 where the window has one end.
    """

    points: Array
    share: float
    apart: float
    errors: Array


def agreement(windows: Sequence[AgreementWindow], choices: Sequence[int], seed: int) -> Agreement:
    """Draw points from the priors that meet all facts, by tempering from the priors on.

    Sequential Monte Carlo (Del Moral, Doucet and Jasra 2006, doi:10.1111/j.1467-9868.2006.00553.x). The probability
    that a point meets a fact is that of the emulator's error, taken as Student's t. The errors of the facts are taken
    as independent.

    Args:
        windows: of the facts.
        choices: of each side of the cube, how many equal parts it has within which nothing varies; 0 where it has none.
        seed: of the random numbers.
    """
    generator = np.random.default_rng([seed, len(choices), len(windows)])
    points = generator.random((_PARTICLES, len(choices)))
    found, apart = _log_chances(windows, snapped(points, choices))
    least, log_share, power = float(apart.min()), 0.0, 0.0
    for _ in range(_MOST_STEPS):
        if power >= 1:
            break
        step = _step(found, 1 - power)
        weights = np.exp(step * (found - found.max()))
        log_share += float(np.log(np.mean(weights)) + step * found.max())
        power = 1.0 if step >= 1 - power else power + step
        kept = generator.choice(_PARTICLES, size=_PARTICLES, p=weights / weights.sum())
        points, found = points[kept], found[kept]
        for _ in range(_MOVES):
            one, other = (generator.integers(_PARTICLES, size=_PARTICLES) for _ in range(2))
            stretch = generator.uniform(*_STRETCH, size=(_PARTICLES, 1))
            scatter = _SCATTER * generator.standard_normal(points.shape)
            tried = _reflected(points + stretch * (points[one] - points[other]) + scatter)
            at_tried, apart = _log_chances(windows, snapped(tried, choices))
            least = min(least, float(apart.min()))
            taken = np.log(generator.random(_PARTICLES)) < power * (at_tried - found)
            points, found = np.where(taken[:, np.newaxis], tried, points), np.where(taken, at_tried, found)
    return Agreement(
        points=points,
        share=float(np.exp(min(log_share, 0.0))),
        apart=least,
        errors=_errors(windows, snapped(points, choices)),
    )


def least_apart(windows: Sequence[AgreementWindow], choices: Sequence[int], seed: int) -> float:
    """By how many standard errors the worst fact is missed where that is least, by differential evolution.

    Args:
        windows: of the facts.
        choices: as of `agreement`.
        seed: of the random numbers.
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
        taken = at_tried <= apart
        points, apart = np.where(taken[:, np.newaxis], tried, points), np.where(taken, at_tried, apart)
    return float(apart.min())


def snapped(points: Array, choices: Sequence[int]) -> Array:
    """Points of the unit cube, on sides with choices in the middle of their part, (points, unknowns)."""
    moved = points.copy()
    for side, count in enumerate(choices):
        if count:
            moved[:, side] = (np.minimum(np.floor(points[:, side] * count), count - 1) + 0.5) / count
    return moved


def _step(found: Array, most: float) -> float:
    """The largest step of the tempering, up to `most`, that leaves an effective share of the particles."""

    def effective(step: float) -> float:
        weights = np.exp(step * (found - found.max()))
        return float(weights.sum() ** 2 / np.sum(weights**2) / len(found))

    if effective(most) >= _EFFECTIVE:
        return most
    low, high = 0.0, most
    for _ in range(30):
        middle = (low + high) / 2
        low, high = (middle, high) if effective(middle) >= _EFFECTIVE else (low, middle)
    return max(low, 1e-6 * most)


def _log_chances(windows: Sequence[AgreementWindow], points: Array) -> tuple[Array, Array]:
    """Logarithm of each point's chance to meet all facts, and by how many errors it misses the worst one, (points,)."""
    chances, apart = np.zeros(len(points)), np.zeros(len(points))
    for window in windows:
        mean, error = window.emulator.predict(points)
        low, high = (window.low - mean) / error, (window.high - mean) / error
        apart = np.maximum(apart, np.maximum(low, -high))
        # of both tails the one that is small, so that nothing is lost where the window is far off
        turned = low > 0
        low, high = np.where(turned, -high, low), np.where(turned, -low, high)
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
