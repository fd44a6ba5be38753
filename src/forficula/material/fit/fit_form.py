"""One form of a law: the best values and whether the data determine them."""

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

_LIMIT = 1e3  # of the condition of the scaled sensitivity: beyond, noise of 0.1 % is as large as a value
_LIMIT_UNSETTLED = 100.0
_POINTS_BY_VALUE = 5
_EVALUATIONS = 100
_TOLERANCE = 1e-7  # of the sum of squares and of the values, far below their intervals
FLOOR = 1e-9  # of the peak stress: smaller misfits are rounding
_ONE_RATE = 1.5  # ratio of fast to slow
_HOLD = 0.05  # of the time at less than a twentieth of the fastest rate


@dataclass(frozen=True, kw_only=True, eq=False)
class FittedForm:
    """The best values of a form.

    Attributes:
        model: the form and the histories.
        values: as the model has them.
        residual: fitted less measured, Pa, shape (blocks,).
        law: with intervals.
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
        """N ln(mean square / peak^2) + k ln n with the effective number of points n (Schwarz 1978)."""
        relative = max(self.misfit / self.model.problem.peak, FLOOR)
        return 2 * effective * float(np.log(relative)) + len(self.values) * float(np.log(effective))


def fit_form(problem: FitProblem, starter: Starter, form: LawForm) -> FittedForm:
    """Least squares of one form, with as much of a baseline as the data can tell from it.

    Raises:
        InputError: the data do not determine a value, or the best one is none; the message names it.
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
    found = scipy.optimize.least_squares(
        lambda values: (model.fitted(values) - problem.stress) / peak,
        start,
        jac=lambda values: model.sensitivity(values) / peak,
        method="lm",
        x_scale="jac",
        max_nfev=_EVALUATIONS,
        ftol=_TOLERANCE,
        xtol=_TOLERANCE,
    )
    if found.status <= 0:
        open_keys = undetermined(model.sensitivity(found.x), form.keys, _LIMIT_UNSETTLED)
        raise InputError(
            _left_open(open_keys, problem) if open_keys else f"{', '.join(form.keys)}: the fit did not settle"
        )
    return _accepted(model, np.asarray(found.x))


def _left_open(keys: Sequence[str], problem: FitProblem) -> str:
    """What the data cannot tell, and what would."""
    rates = one_rate(problem)
    kinds = {key.partition(".")[0] for key in keys}
    listed = ", ".join(keys)
    if kinds == {"viscosity"} and rates is not None:
        return f"{listed}: one rate only, {rates:.3g} 1/s, cannot tell them apart; test at another rate"
    if any("softening" in key for key in keys):
        return f"{listed}: the data do not determine them; unload and stretch further, to several strains"
    return f"{listed}: the data do not determine them; add unloading, holds or other rates"


def _accepted(model: LawModel, values: Array) -> FittedForm:
    """Refuse values that are out of bounds or that the data leave open; attach the intervals to the law."""
    form, problem = model.form, model.problem
    values = _in_order(form, values)
    own = _natural(form, values)
    shortest, longest = problem.times
    for key in form.keys:
        if key.endswith(".time") and not shortest <= own[key] <= longest:
            seen = show_range(key, shortest, longest)
            raise InputError(
                f"{key}: lies outside of the times that the data sample, {seen}: {show_value(key, own[key])}"
            )
    sensitivity = model.sensitivity(values)
    if open_keys := undetermined(sensitivity, form.keys, _LIMIT):
        raise InputError(_left_open(open_keys, problem))
    law = _law(form, own, problem)
    residual = model.fitted(values) - problem.stress
    half = half_widths(sensitivity, residual, problem.specimen)[: len(form.keys)]
    # how specimens differ says nothing of whether a value is there
    for each in _intervals(form, values, half, 0.0):
        _check_interval(each, problem.largest_strain)
    bounds = _intervals(form, values, half, mean_half_width(model.parts(values)[1]))
    return FittedForm(model=model, values=values, residual=residual, law=replace(law, intervals=bounds))


def _in_order(form: LawForm, values: Array) -> Array:
    """Values with the Maxwell branches by their relaxation times."""
    first = len(form.linear_keys)
    order = np.arange(len(values))
    rising = np.argsort(values[first : first + form.branches])
    order[first : first + form.branches] = first + rising
    order[first - form.branches : first] = first - form.branches + rising
    return np.asarray(values[order])


def _intervals(form: LawForm, values: Array, half: Array, amplitude: float) -> tuple[Bounds, ...]:
    """The 95 % intervals of the values of a law.

    Args:
        form: of the law.
        values: as a model has them.
        half: half-widths that the misfit leaves, as a model has the values, shape (keys,).
        amplitude: half-width of the logarithm of the mean amplitude. Both are independent and add by squares.
    """
    own = values[: len(half)]
    down, up = half.copy(), half.copy()
    for index, key in enumerate(form.keys):
        if key in form.linear_keys:
            signs = (-amplitude, amplitude) if own[index] > 0 else (amplitude, -amplitude)
            fall, rise = (float(own[index] * np.expm1(sign)) for sign in signs)
        elif key == "softening.m":
            fall, rise = -amplitude, amplitude
        else:
            continue
        down[index], up[index] = np.hypot(half[index], fall), np.hypot(half[index], rise)
    low, high = _natural(form, own - down), _natural(form, own + up)
    return tuple(Bounds(key=key, low=min(low[key], high[key]), high=max(low[key], high[key])) for key in form.keys)


def _check_interval(bounds: Bounds, largest_strain: float) -> None:
    """Refuse a value that the data cannot tell from none."""
    shown = show_range(bounds.key, bounds.low, bounds.high)
    if bounds.key.endswith(".time"):
        if bounds.high > 100 * bounds.low:
            raise InputError(f"{bounds.key}: the data do not determine it: {shown}")
    elif not bounds.key.startswith(("modulus", "softening.r", "softening.beta")) and bounds.low <= 0:
        raise InputError(f"{bounds.key}: the data cannot tell it from 0: {shown}")
    if bounds.key == "softening.r" and bounds.low <= 0:
        raise InputError(f"{bounds.key}: the data cannot tell the softening from none")
    if bounds.key == "yield_strain" and bounds.high >= largest_strain:
        raise InputError(f"{bounds.key}: the data cannot tell it from none: {shown}")


def _natural(form: LawForm, values: Array) -> dict[str, float]:
    """Values by key as in a law, from those of a model."""
    own: dict[str, float] = {}
    for key, value in zip(form.keys, values, strict=False):
        if key.endswith(".time") or key == "softening.m":
            own[key] = float(np.exp(min(value, 700.0)))
        else:
            own[key] = float(1 / value) if key == "softening.r" and value else float(value)
    return own


def _law(form: LawForm, own: dict[str, float], problem: FitProblem) -> MaterialLaw:
    """A law from values by key; raise InputError where it is none."""

    def terms(section: str) -> Triple:
        first, second, third = (own.get(f"{section}.{term}", 0.0) for term in TERMS)
        return first, second, third

    soft = {name: own[f"softening.{name}"] for name in ("r", "m", "beta") if f"softening.{name}" in own}
    lossy = form.damper > 0 or form.branches > 0
    branches = [
        MaxwellBranch(modulus=own[f"branches.{index}.modulus"], time=own[f"branches.{index}.time"])
        for index in range(form.branches)
    ]
    return MaterialLaw(
        name="fitted",
        moduli=terms("modulus"),
        viscosity=terms("viscosity") if lossy else None,
        branches=tuple(branches),
        yield_strain=own.get("yield_strain"),
        residual_strain=own.get("residual_strain", 0.0),
        softening=OgdenRoxburgh(**soft) if soft else None,
        largest_strain=problem.largest_strain,
        lowest_strain_rate=problem.rates[0],
        highest_strain_rate=problem.rates[1],
    )


def one_rate(problem: FitProblem) -> float | None:
    """The one rate of the data, 1/s; None where there are several, or holds."""
    speeds = np.abs(problem.rate)
    moving = speeds > 0.05 * np.percentile(speeds, 99)
    slow, fast = np.percentile(speeds[moving], [10, 90])
    if fast > _ONE_RATE * slow or np.mean(~moving) > _HOLD:
        return None
    return float(np.median(speeds[moving]))
