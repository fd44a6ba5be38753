"""Fit of one form of a law: the best values, and a check that the data determine them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.material.fit.fit_problem import FitProblem, LawModel
from forficula.material.fit.fit_start import Starter
from forficula.material.fit.uncertainty import half_widths, mean_half_width, undetermined
from forficula.material.law.law_form import LawForm
from forficula.material.law.law_keys import TERMS, show_range, show_value
from forficula.material.law.material_law import Bounds, MaterialLaw, MaxwellBranch
from forficula.material.law.softening import OgdenRoxburgh, Triple

# largest condition of the scaled sensitivity: beyond it, noise of 0.1 % is as large as a value
_LIMIT = 1e3
_LIMIT_UNSETTLED = 100.0  # the same for a fit that did not converge
_POINTS_BY_VALUE = 5
_EVALUATIONS = 100
_TOLERANCE = 1e-7  # relative, of the sum of squares and of the values: far below their intervals
FLOOR = 1e-9  # share of the peak stress: smaller misfits are rounding
# words of refusals by which the remarks of a material find the refusals that another test would settle
ONE_RATE_ONLY = "one rate only"
UNDISTINGUISHED = "cannot distinguish them"
DAMPER_OR_BRANCH = "cannot distinguish viscosity.linear from"
_ONE_RATE = 1.5  # largest ratio of two strain rates that count as one
_HOLD = 0.05  # largest share of samples below a twentieth of the fastest rate, for a test without holds


@dataclass(frozen=True, kw_only=True, eq=False)
class FittedForm:
    """The best values of a form.

    Attributes:
        model: the form and the histories.
        values: values in the order of the model.
        residual: fitted minus measured stress, Pa, shape (blocks,).
        law: law with intervals.
    """

    model: LawModel
    values: Array
    residual: Array
    law: MaterialLaw

    @property
    def misfit(self) -> float:
        """Root mean square of the residual, Pa."""
        return float(np.sqrt(np.mean(self.residual**2)))

    def bic(self, effective: float) -> float:
        """Compute n ln(mean square / peak^2) + k ln n with the effective number of points n (Schwarz 1978)."""
        relative = max(self.misfit / self.model.problem.peak, FLOOR)
        return 2 * effective * float(np.log(relative)) + len(self.values) * float(np.log(effective))


def fit_form(problem: FitProblem, starter: Starter, form: LawForm) -> FittedForm:
    """Fit one form by least squares, with as many terms of a baseline as the data can distinguish from the law.

    Raises:
        InputError: the data do not determine a value, or its best value is out of bounds; the message names the value.
    """
    if form.damper > 1 and one_rate(problem) is not None:
        raise InputError(_left_open([f"viscosity.{term}" for term in TERMS[: form.damper]], problem))
    needed = _POINTS_BY_VALUE * len(form.keys)
    if len(problem.stress) < needed:
        raise InputError(f"{', '.join(form.keys)}: need at least {needed} rows, got {len(problem.stress)}")
    for terms in (2, 1, 0) if problem.unknown_zeros.size else (0,):
        model = LawModel(form=form, problem=problem, baseline=terms)
        start = starter.start(model)
        open_keys = undetermined(model.sensitivity(start), form.keys, _LIMIT)
        if not open_keys:
            break
    else:
        raise InputError(_left_open(open_keys, problem))
    peak = problem.peak
    solution = scipy.optimize.least_squares(
        lambda values: (model.fitted(values) - problem.stress) / peak,
        start,
        jac=lambda values: model.sensitivity(values) / peak,
        method="lm",
        x_scale="jac",
        max_nfev=_EVALUATIONS,
        ftol=_TOLERANCE,
        xtol=_TOLERANCE,
    )
    if solution.status <= 0:
        open_keys = undetermined(model.sensitivity(solution.x), form.keys, _LIMIT_UNSETTLED)
        raise InputError(
            _left_open(open_keys, problem) if open_keys else f"{', '.join(form.keys)}: the fit did not converge"
        )
    return _accepted(model, np.asarray(solution.x))


def _left_open(keys: Sequence[str], problem: FitProblem) -> str:
    """Return the message for values that the data do not determine, with the tests that would."""
    rates = one_rate(problem)
    kinds = {key.partition(".")[0] for key in keys}
    listed = ", ".join(keys)
    if kinds == {"viscosity"} and rates is not None:
        return f"{listed}: {ONE_RATE_ONLY}, {rates:.3g} 1/s, {UNDISTINGUISHED}; test at another rate"
    if any("softening" in key for key in keys):
        return f"{listed}: the data do not determine them; unload and stretch further, to several strains"
    return f"{listed}: the data do not determine them; add unloading, holds or other rates"


def _accepted(model: LawModel, values: Array) -> FittedForm:
    """Refuse values that are out of bounds or that the data do not determine; add the intervals to the law."""
    form, problem = model.form, model.problem
    values = _in_order(form, values)
    by_key = _natural(form, values)
    shortest, longest = problem.times
    for key in form.keys:
        if key.endswith(".time") and not shortest <= by_key[key] <= longest:
            sampled = show_range(key, shortest, longest)
            raise InputError(
                f"{key}: lies outside the times that the data sample, {sampled}: {show_value(key, by_key[key])}"
            )
    sensitivity = model.sensitivity(values)
    if open_keys := undetermined(sensitivity, form.keys, _LIMIT):
        raise InputError(_left_open(open_keys, problem))
    law = _law(form, by_key, problem)
    residual = model.fitted(values) - problem.stress
    half = half_widths(sensitivity, residual, problem.specimen)[: len(form.keys)]
    # without the scatter of specimens, which does not show whether a value differs from 0
    for interval in _intervals(form, values, half, 0.0):
        _check_interval(interval, problem.largest_strain)
    bounds = _intervals(form, values, half, mean_half_width(model.parts(values)[1]))
    return FittedForm(model=model, values=values, residual=residual, law=replace(law, intervals=bounds))


def _in_order(form: LawForm, values: Array) -> Array:
    """Sort the Maxwell branches in the values by relaxation time."""
    first = len(form.linear_keys)
    order = np.arange(len(values))
    rising = np.argsort(values[first : first + form.branches])
    order[first : first + form.branches] = first + rising
    order[first - form.branches : first] = first - form.branches + rising
    return np.asarray(values[order])


def _intervals(form: LawForm, values: Array, half: Array, amplitude: float) -> tuple[Bounds, ...]:
    """Compute the 95 % intervals of the values of a law.

    Args:
        form: form of the law.
        values: values in the order of a model.
        half: half-widths that follow from the misfit, in the order of a model, shape (keys,).
        amplitude: half-width of the logarithm of the mean amplitude. Both contributions are independent and are added
            in quadrature.
    """
    law_values = values[: len(half)]
    down, up = half.copy(), half.copy()
    for index, key in enumerate(form.keys):
        if key in form.linear_keys:
            signs = (-amplitude, amplitude) if law_values[index] > 0 else (amplitude, -amplitude)
            fall, rise = (float(law_values[index] * np.expm1(sign)) for sign in signs)
        elif key == "softening.m":
            fall, rise = -amplitude, amplitude
        else:
            continue
        down[index], up[index] = np.hypot(half[index], fall), np.hypot(half[index], rise)
    low, high = _natural(form, law_values - down), _natural(form, law_values + up)
    return tuple(Bounds(key=key, low=min(low[key], high[key]), high=max(low[key], high[key])) for key in form.keys)


def _check_interval(bounds: Bounds, largest_strain: float) -> None:
    """Refuse a value that the data cannot distinguish from its absence."""
    shown = show_range(bounds.key, bounds.low, bounds.high)
    if bounds.key.endswith(".time"):
        if bounds.high > 100 * bounds.low:
            raise InputError(f"{bounds.key}: the data do not determine it: {shown}")
    elif not bounds.key.startswith(("modulus", "softening.r", "softening.beta")) and bounds.low <= 0:
        raise InputError(f"{bounds.key}: the data cannot distinguish it from 0: {shown}")
    if bounds.key == "softening.r" and bounds.low <= 0:
        raise InputError(f"{bounds.key}: the data cannot distinguish the softening from none")
    if bounds.key == "yield_strain" and bounds.high >= largest_strain:
        raise InputError(f"{bounds.key}: the data cannot distinguish it from none: {shown}")


def _natural(form: LawForm, values: Array) -> dict[str, float]:
    """Convert the values of a model to values by key, as in a law."""
    by_key: dict[str, float] = {}
    for key, value in zip(form.keys, values, strict=False):
        if key.endswith(".time") or key == "softening.m":
            by_key[key] = float(np.exp(min(value, 700.0)))
        else:
            by_key[key] = float(1 / value) if key == "softening.r" and value else float(value)
    return by_key


def _law(form: LawForm, values: dict[str, float], problem: FitProblem) -> MaterialLaw:
    """Build a law from values by key; raise InputError if a value is out of bounds."""

    def terms(section: str) -> Triple:
        first, second, third = (values.get(f"{section}.{term}", 0.0) for term in TERMS)
        return first, second, third

    soft = {name: values[f"softening.{name}"] for name in ("r", "m", "beta") if f"softening.{name}" in values}
    lossy = form.damper > 0 or form.branches > 0
    branches = [
        MaxwellBranch(modulus=values[f"branches.{index}.modulus"], time=values[f"branches.{index}.time"])
        for index in range(form.branches)
    ]
    return MaterialLaw(
        name="fitted",
        moduli=terms("modulus"),
        viscosity=terms("viscosity") if lossy else None,
        branches=tuple(branches),
        yield_strain=values.get("yield_strain"),
        residual_strain=values.get("residual_strain", 0.0),
        softening=OgdenRoxburgh(**soft) if soft else None,
        largest_strain=problem.largest_strain,
        lowest_strain_rate=problem.rates[0],
        highest_strain_rate=problem.rates[1],
    )


def one_rate(problem: FitProblem) -> float | None:
    """Return the single strain rate of the data, 1/s; None if there are several rates, or holds."""
    speeds = np.abs(problem.rate)
    moving = speeds > 0.05 * np.percentile(speeds, 99)
    slow, fast = np.percentile(speeds[moving], [10, 90])
    if fast > _ONE_RATE * slow or np.mean(~moving) > _HOLD:
        return None
    return float(np.median(speeds[moving]))
