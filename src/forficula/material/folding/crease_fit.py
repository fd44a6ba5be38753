"""Fitting of laws of creases with their uncertainty to folding tests."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Annotated

import numpy as np
import scipy

from forficula.arrays import Array, Flags, Indices
from forficula.errors import InputError
from forficula.material.fit.uncertainty import effective_points, half_widths, undetermined
from forficula.material.folding.folding_test import FoldingTest
from forficula.material.law.law_summary import LawValue
from forficula.material.tensile.turning_points import turning_points
from forficula.quantities import Unit, show_quantity
from forficula.serial import Key, Written

_BAND = 0.05  # [chosen] of the range of angles: smaller reversals do not count as unloading
_ONE_RATE = 1.5  # [chosen] largest ratio of two turning speeds that count as one
_SAME_FIT = 6.0  # difference of BIC that is "strong" evidence (Raftery 1995, doi 10.2307/271063)
_LIMIT = 1e4  # largest ratio of singular values of the sensitivity of determined values
_FLOOR = 1e-9  # share of the largest moment: smaller misfits are rounding
_STARTS = 40  # yield angles tried for the start of a fit
_POINTS_BY_VALUE = 5
_SPEEDS = 100  # parts of a test over which a turning speed is averaged
_STEP = 1e-6  # relative step of a numerical derivative
_SPEED = Unit(display="deg/s", si="rad/s", example="1 deg/s")

_UNITS = {
    "stiffness": "N m/rad/m",
    "rest_angle": "rad",
    "yield_moment": "N m/m",
    "hardening": "N m/rad/m",
    "damping": "N m s/rad/m",
}
_ELASTIC = ("stiffness", "rest_angle")
# values by the name of a law; with `damping`, each is tried at two or more rates
FORMS: dict[str, tuple[str, ...]] = {
    "elastic": _ELASTIC,
    "elastic and plastic without hardening": (*_ELASTIC, "yield_moment"),
    "elastic and plastic": (*_ELASTIC, "yield_moment", "hardening"),
}

_Rms = Annotated[float, Key("residual_rms"), Unit("N m/m")]


@dataclass(frozen=True, kw_only=True)
class CreaseCandidate:
    """A law of a crease that was tried.

    Attributes:
        law: name of the law.
        keys: keys of its values.
        bic: Bayesian information criterion, lower is better; nan if the law was refused.
        misfit: root mean square of the residual, N m/m; nan if the law was refused.
        refused: reason why the law was refused; empty if it was not.
    """

    law: str
    keys: tuple[str, ...]
    bic: Annotated[float, Key("bayesian_information_criterion")] = np.nan
    misfit: _Rms = np.nan
    refused: Annotated[str, Written.OR_NULL] = ""


@dataclass(frozen=True, kw_only=True, eq=False)
class CreaseFit:
    """A fitted law of a crease with its uncertainty, and the other laws that were tried.

    Attributes:
        law: name of the law.
        values: values with their 95 % confidence intervals, per length of the crease.
        points: number of points that were compared.
        effective_points: effective number of independent points.
        misfit: root mean square of the residual, N m/m.
        relative_misfit: misfit divided by the largest moment.
        fitted: moment of the law in each row of each test, N m/m, (row,) each.
        candidates: all laws that were tried, the chosen one first, refused ones last.
    """

    law: str
    values: tuple[LawValue, ...]
    points: int
    effective_points: float
    misfit: _Rms
    relative_misfit: Annotated[float, Key("residual_rms_by_largest_moment")]
    fitted: Annotated[tuple[Array, ...], Written.NEVER]
    candidates: Annotated[tuple[CreaseCandidate, ...], Key("compared")]


@dataclass(frozen=True, kw_only=True, eq=False)
class _Fitted:
    """The best values of a law, (value,), its residual, N m/m, (row,), and its sensitivity, (row, value)."""

    name: str
    keys: tuple[str, ...]
    values: Array
    residual: Array
    sensitivity: Array

    def misfit(self) -> float:
        return float(np.sqrt(np.mean(self.residual**2)))

    def bic(self, effective: float, peak: float) -> float:
        """Compute n ln(mean square / peak^2) + k ln n with the effective number of points n (Schwarz 1978)."""
        relative = max(self.misfit() / peak, _FLOOR)
        return 2 * effective * float(np.log(relative)) + len(self.keys) * float(np.log(effective))


class _Problem:
    """The rows of all tests, one test after another."""

    def __init__(self, tests: Sequence[FoldingTest]) -> None:
        self.tests = tests
        self.moment = np.concatenate([test.moment_by_width for test in tests])
        self.angle = np.concatenate([test.angle for test in tests])
        self.specimen: Indices = np.repeat(np.arange(len(tests)), [len(test.angle) for test in tests])
        self.speed = np.concatenate([_speed(test) for test in tests])
        self.peak = float(np.abs(self.moment).max())
        # rows that are compared: near turning points the speed is not known
        self.kept = np.concatenate([_away_from_turns(test) for test in tests])
        self.kept_specimen: Indices = self.specimen[self.kept]

    def play(self, rest_angle: float, yield_angle: float) -> Array:
        """Return the permanent folds, rad, (row,)."""
        return np.concatenate([permanent_folds(test.angle - rest_angle, yield_angle) for test in self.tests])

    def fitted(self, keys: Sequence[str], values: Array) -> Array:
        """Return the moment of a law, N m/m, (row,)."""
        value = dict(zip(keys, values.tolist(), strict=True))
        stiffness, rest = value["stiffness"], value["rest_angle"]
        moment = stiffness * (self.angle - rest)
        if "yield_moment" in value:
            hardening = min(value.get("hardening", 0.0), stiffness)
            moment = moment - (stiffness - hardening) * self.play(rest, value["yield_moment"] / stiffness)
        return np.asarray(moment + value.get("damping", 0.0) * self.speed)

    def residual(self, keys: Sequence[str], values: Array) -> Array:
        """Return the moment of a law minus the measured one in the rows that are compared, N m/m, (point,)."""
        return np.asarray((self.fitted(keys, values) - self.moment)[self.kept])

    def sensitivity(self, keys: Sequence[str], values: Array) -> Array:
        """Return the derivatives of the residual by the values, (point, value), by central differences."""
        scale = np.where(values != 0, np.abs(values), 1.0)
        columns = []
        for number in range(len(values)):
            step = np.zeros(len(values))
            step[number] = _STEP * scale[number]
            change = self.residual(keys, values + step) - self.residual(keys, values - step)
            columns.append(change / (2 * step[number]))
        return np.stack(columns, axis=1)


def fit_crease_law(tests: Sequence[FoldingTest]) -> CreaseFit:
    """Fit the law of a crease to folding tests; the Bayesian information criterion selects among the laws of `FORMS`.

    The moment per length is K (a - r) - (K - H) p + c da/dt with the fold angle a, the rest angle r and the permanent
    fold p, which follows the angle as in play of the half width M_y / K (see `CreaseLaw`). p is 0 at the start of each
    test. Laws with a yield moment need unloading, and laws with damping need two rates. The rest angle is that of a
    moment of 0, so the zero of the moment must be that of the machine without a strip.

    Raises:
        InputError: no test, too few rows, no moment, no turn, or no law whose values the data determine.
    """
    if not tests:
        raise InputError("need at least one folding test, got none")
    problem = _Problem(tests)
    for test in tests:
        if np.ptp(test.angle) == 0:
            raise InputError(
                f"{test.name}: angle: need a crease that turns, got {np.rad2deg(test.angle[0]):g} deg throughout"
            )
        if not np.any(test.moment):
            raise InputError(f"{test.name}: moment: need a moment, got 0 throughout")
    fitted, refused = list[_Fitted](), list[CreaseCandidate]()
    for name, keys in _laws():
        try:
            fitted.append(_fit(problem, name, keys))
        except InputError as error:
            refused.append(CreaseCandidate(law=name, keys=keys, refused=str(error)))
    if not fitted:
        raise InputError(f"no law can be determined: {'; '.join(dict.fromkeys(item.refused for item in refused))}")
    return _chosen(problem, fitted, refused)


def permanent_folds(turned: Array, yield_angle: float) -> Array:
    """Return the permanent folds of a crease that turns by these angles from rest, rad, (row,); 0 before the first row.

    The new fold is the old one, clipped to the angles within the yield angle. A sequence of clips is one clip, so the
    folds of all rows follow by doubling spans (Hillis and Steele 1986).
    """
    low, high, span = turned - yield_angle, turned + yield_angle, 1
    while span < len(turned):
        lower = np.clip(low[:-span], low[span:], high[span:])
        upper = np.clip(high[:-span], low[span:], high[span:])
        low, high = np.concatenate([low[:span], lower]), np.concatenate([high[:span], upper])
        span *= 2
    return np.asarray(np.clip(0.0, low, high))


def turns_back(test: FoldingTest) -> bool:
    """Return whether a test unloads: whether the angle turns back by more than 5 % of its range."""
    return bool(_turns(test))


def turning_speeds(tests: Sequence[FoldingTest]) -> list[float]:
    """Return the mean turning speeds between turning points of tests with a time, rad/s, without stops."""
    speeds = list[float]()
    for test in tests:
        if test.time is None:
            continue
        turns = turning_points(test.angle, _BAND * float(np.ptp(test.angle)))
        for first, last in pairwise(turns):
            speed = np.abs(_speed(test)[first : last + 1])
            moving = speed > _BAND * speed.max(initial=0.0)
            if moving.any():
                speeds.append(float(np.median(speed[moving])))
    return speeds


def _speed(test: FoldingTest) -> Array:
    """Return the turning speed, rad/s, (row,), averaged over neighbouring rows of a motion; 0 without a time."""
    if test.time is None:
        return np.zeros(len(test.angle))
    half, rows, turns = _averaged(test), np.arange(len(test.angle)), _turns(test)
    ends = np.array([0, *turns, len(rows) - 1])
    motion = np.searchsorted(ends[1:-1], rows)
    first, last = np.maximum(rows - half, ends[motion]), np.minimum(rows + half, ends[motion + 1])
    span = test.time[last] - test.time[first]
    turned = test.angle[last] - test.angle[first]
    return np.asarray(np.divide(turned, span, out=np.zeros(len(rows)), where=span > 0))


def _averaged(test: FoldingTest) -> int:
    """Return half the number of rows over which a turning speed is averaged."""
    return max(1, len(test.angle) // (2 * _SPEEDS))


def _turns(test: FoldingTest) -> list[int]:
    """Return the rows in which a test turns back."""
    return turning_points(test.angle, _BAND * float(np.ptp(test.angle)))[1:-1]


def _away_from_turns(test: FoldingTest) -> Flags:
    """Return which rows are so far from turning points that their speed is known, (row,); all without a time."""
    kept, half = np.ones(len(test.angle), dtype=np.bool_), _averaged(test)
    for turn in _turns(test) if test.time is not None else ():
        kept[max(turn - half, 0) : turn + half + 1] = False
    return kept


def one_speed(tests: Sequence[FoldingTest]) -> bool:
    """Return whether all motions of tests have one turning speed, or none is known."""
    speeds = turning_speeds(tests)
    return not speeds or max(speeds) <= _ONE_RATE * min(speeds)


def _laws() -> Iterator[tuple[str, tuple[str, ...]]]:
    for name, keys in FORMS.items():
        yield name, keys
    for name, keys in FORMS.items():
        yield f"{name}, viscous", (*keys, "damping")


def _fit(problem: _Problem, name: str, keys: tuple[str, ...]) -> _Fitted:
    """Fit one law by least squares.

    Raises:
        InputError: the data do not determine a value, or its best value is out of bounds; the message names the value.
    """
    if "yield_moment" in keys and not any(turns_back(test) for test in problem.tests):
        raise InputError("yield_moment: cannot be determined, because no test unloads; fold back after folding")
    if "damping" in keys and one_speed(problem.tests):
        speeds = turning_speeds(problem.tests)
        known = (
            f"all motions have one rate, {show_quantity(float(np.median(speeds)), _SPEED)}"
            if speeds
            else "the tests have no time"
        )
        raise InputError(f"damping: cannot be determined, because {known}; fold at two rates")
    needed = _POINTS_BY_VALUE * len(keys)
    if (points := int(problem.kept.sum())) < needed:
        raise InputError(f"{', '.join(keys)}: need at least {needed} rows, got {points}")
    start = _start(problem, keys)
    solution = scipy.optimize.least_squares(
        lambda values: problem.residual(keys, values) / problem.peak,
        start,
        jac=lambda values: problem.sensitivity(keys, values) / problem.peak,
        x_scale=np.where(start != 0, np.abs(start), 1.0),
        bounds=([0.0 if key != "rest_angle" else -np.inf for key in keys], np.inf),
        xtol=1e-12,
        ftol=1e-12,
    )
    values = np.asarray(solution.x)
    value = dict(zip(keys, values.tolist(), strict=True))
    if value.get("hardening", 0.0) >= value["stiffness"]:
        raise InputError("hardening: the best value is not below the stiffness")
    sensitivity = problem.sensitivity(keys, values)
    if open_keys := undetermined(sensitivity, keys, _LIMIT):
        raise InputError(f"{', '.join(open_keys)}: the tests do not determine them")
    at_zero = [key for key in keys if key != "rest_angle" and value[key] <= _FLOOR * abs(start[keys.index(key)])]
    if at_zero:
        raise InputError(f"{', '.join(at_zero)}: the best value is 0")
    residual = problem.residual(keys, values)
    return _Fitted(name=name, keys=keys, values=values, residual=residual, sensitivity=sensitivity)


def _start(problem: _Problem, keys: Sequence[str]) -> Array:
    """Return start values of a law, (value,): the moment is linear in all of them at a given yield angle."""
    ones = np.ones_like(problem.angle)
    # the tests begin at rest, where the moment is smallest
    first = np.searchsorted(problem.specimen, np.arange(len(problem.tests)))
    begin = float(np.mean(problem.angle[first]))
    speed = [problem.speed] if "damping" in keys else []
    best: tuple[float, dict[str, float]] = (np.inf, {})
    angles = (
        np.abs(problem.angle - begin).max() * np.geomspace(0.02, 0.98, _STARTS) if "yield_moment" in keys else [np.inf]
    )
    for yield_angle in angles:
        folds = [] if np.isinf(yield_angle) else [problem.play(begin, float(yield_angle))]
        columns = np.stack([problem.angle, ones, *folds, *speed], axis=1)
        if folds and "hardening" not in keys:
            columns = np.stack([problem.angle - folds[0], ones, *speed], axis=1)
        solved, _, rank, _ = np.linalg.lstsq(columns, problem.moment, rcond=None)
        misfit = float(np.sum((columns @ solved - problem.moment) ** 2))
        stiffness = float(solved[0])
        if stiffness <= 0 or misfit >= best[0] or rank < columns.shape[1]:
            continue
        value = {
            "stiffness": stiffness,
            "rest_angle": -float(solved[1]) / stiffness,
            "yield_moment": stiffness * yield_angle,
        }
        if folds and "hardening" in keys:
            value["hardening"] = float(np.clip(stiffness + solved[2], 1e-3 * stiffness, 0.95 * stiffness))
        value["damping"] = max(float(solved[-1]), 1e-6 * problem.peak) if speed else 0.0
        best = misfit, value
    if not best[1]:
        raise InputError("stiffness: need a moment that grows with the angle, or the sign of one of them is wrong")
    return np.array([best[1][key] for key in keys])


def _chosen(problem: _Problem, fitted: list[_Fitted], refused: list[CreaseCandidate]) -> CreaseFit:
    least = min(fitted, key=lambda fit: fit.misfit())
    effective = max(effective_points(least.residual, problem.kept_specimen), len(least.keys) + 2.0)
    ranked = sorted(fitted, key=lambda fit: fit.bic(effective, problem.peak))
    equivalent = [
        fit for fit in ranked if fit.bic(effective, problem.peak) <= ranked[0].bic(effective, problem.peak) + _SAME_FIT
    ]
    best = min(equivalent, key=lambda fit: len(fit.keys))
    halves = half_widths(best.sensitivity, best.residual, problem.kept_specimen)
    values = [
        LawValue(key=key, value=float(value), interval=(float(value - half), float(value + half)), unit=_UNITS[key])
        for key, value, half in zip(best.keys, best.values, halves, strict=True)
    ]
    tried = [
        CreaseCandidate(law=fit.name, keys=fit.keys, bic=fit.bic(effective, problem.peak), misfit=fit.misfit())
        for fit in [best, *(fit for fit in ranked if fit is not best)]
    ]
    moments = problem.fitted(best.keys, best.values)
    return CreaseFit(
        law=best.name,
        values=tuple(values),
        points=int(problem.kept.sum()),
        effective_points=effective_points(best.residual, problem.kept_specimen),
        misfit=best.misfit(),
        relative_misfit=best.misfit() / problem.peak,
        fitted=tuple(moments[problem.specimen == number] for number in range(len(problem.tests))),
        candidates=(*tried, *refused),
    )
