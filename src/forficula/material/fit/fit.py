"""Measured histories of strain and stress in, a material law with its uncertainty out."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.material.fit.fit_form import FLOOR, FittedForm, fit_form, one_rate
from forficula.material.fit.fit_problem import FitProblem, LawModel, problem_of
from forficula.material.fit.fit_start import Starter, pulling_solution
from forficula.material.fit.uncertainty import effective_points
from forficula.material.law.law_form import LawForm, all_forms
from forficula.material.law.material_law import MaterialLaw
from forficula.material.tensile.strain_history import StrainHistory
from forficula.quantities import Unit
from forficula.serial import Key, WithUnit, Written

_SAME_FIT = 6.0  # of BIC, "strong" evidence (Raftery 1995, doi 10.2307/271063)
# a refusal: the values that it names, and why; and the numbers of one, by which refusals of the same kind differ
_NAMED = re.compile(r"(?P<keys>[a-z_]+[\w.]*(?:, [a-z_]+[\w.]*)*): (?P<reason>.*)", re.DOTALL)
_NUMBERS = re.compile(r"(?<![\w.])[-+]?\d[\d.e+-]*|\b[kMG]?Pa\b")
_TIMES = 16  # relaxation times tried in place of a damper
_Criterion = Annotated[float, Key("bayesian_information_criterion")]
_Rms = Annotated[float, Key("residual_rms"), Unit("Pa")]


@dataclass(frozen=True, kw_only=True)
class FitCandidate:
    """A form that was tried.

    Attributes:
        form: what was tried.
        bic: Bayesian information criterion, less is better; nan where it was refused.
        above_chosen: by how much the criterion exceeds that of the chosen form; nan where it was refused.
        misfit: root mean square of the residual, Pa; nan where it was refused.
        refused: why, or empty.
    """

    form: Annotated[LawForm, Written.NEVER]
    bic: _Criterion = np.nan
    above_chosen: float = np.nan
    misfit: _Rms = np.nan
    refused: Annotated[str, Written.OR_NULL] = ""

    @property
    def law(self) -> Annotated[str, Written.FIRST]:
        """Name of the form."""
        return self.form.name

    @property
    def values(self) -> Annotated[int, Written.FIRST]:
        """Number of the values that the form has."""
        return len(self.form.keys)


@dataclass(frozen=True, kw_only=True, eq=False)
class Residual:
    """What a fit leaves of one specimen, by blocks of neighbouring rows.

    Attributes:
        name: of the specimen.
        amplitude: its stress by that of the law.
        time: s, shape (points,).
        strain: shape (points,).
        stress: measured, Pa, shape (points,).
        fitted: Pa, shape (points,), amplitude, offset and drift included.
        offset: of the force's zero, Pa, at the middle of the test, known or fitted; else 0.
        drift: of the force's zero, Pa/s, known or fitted; else 0.
    """

    name: str
    amplitude: float
    time: Array
    strain: Array
    stress: Array
    fitted: Array
    offset: float
    drift: float


@dataclass(frozen=True, kw_only=True, eq=False)
class LawFit:
    """A law and how well data determine it.

    Attributes:
        law: with the 95 % confidence intervals of its values.
        form: its terms.
        points: that were compared.
        effective_points: that they are worth, neighbours being alike.
        bic: Bayesian information criterion.
        misfit: root mean square of the residual, Pa.
        relative_misfit: that by the largest stress.
        scatter: standard deviation of the logarithms of the specimens' amplitudes; None of one specimen.
        residuals: by specimen.
        candidates: all that were tried, the chosen one first, the refused ones last.
    """

    law: Annotated[MaterialLaw, Written.NEVER]
    form: Annotated[LawForm, Written.NEVER]
    points: int
    effective_points: float
    bic: _Criterion
    misfit: _Rms
    relative_misfit: Annotated[float, Key("residual_rms_by_largest_stress")]
    scatter: Annotated[float | None, Key("amplitude_standard_deviation")]
    residuals: Annotated[tuple[Residual, ...], Written.NEVER]
    candidates: Annotated[tuple[FitCandidate, ...], Key("compared")]

    @property
    def law_name(self) -> Annotated[str, Key("law"), Written.FIRST]:
        """Name of the form."""
        return self.form.name

    @property
    def amplitudes(self) -> Annotated[list[Mapping[str, str | float]], Written.ALWAYS]:
        """Stress of every specimen by that of the law."""
        return [{"specimen": each.name, "amplitude": each.amplitude} for each in self.residuals]

    @property
    def force_zero(self) -> Annotated[list[Mapping[str, str | WithUnit]], Written.ALWAYS]:
        """What the load cell shows of every specimen without force, and the drift of that."""
        return [
            {"specimen": each.name, "offset": WithUnit(each.offset, "Pa"), "drift": WithUnit(each.drift, "Pa/s")}
            for each in self.residuals
        ]


def fit_law(
    histories: Sequence[StrainHistory],
    *,
    name: str = "fitted",
    source: str = "",
    forms: Sequence[LawForm] | None = None,
) -> LawFit:
    """Fit laws to one or several specimens and choose between them.

    Least squares of the stress, where a specimen gives way rather than push. Each of several specimens has an amplitude
    of its own, and the law is that of their geometric mean; the 95 % intervals of what stress is proportional to hold
    that of all specimens of the material, by Student's t of the few that were tested, beside what the misfit leaves
    open. Where a specimen's zero of the force is not known, an offset and a drift linear in time are fitted with the
    law if the data can tell them from it.

    The choice is by the Bayesian information criterion, with the points that the best residual is worth; of laws that
    differ by less than 6 of it, the one with the fewest values is taken. A Prony series, which two Maxwell branches
    stand for, gets another branch as long as one more fits better by as much.

    Where a test at one rate fits a damper and a Maxwell branch alike, and forms of both are tried, both are refused. A
    test of which the first cycle is dropped is best given whole, with its `first` sample: branches, yield and softening
    remember that cycle.

    Args:
        histories: of the specimens, each from a specimen at rest.
        name: of the law.
        source: of the data.
        forms: to try; by default `all_forms`.

    Raises:
        InputError: no data, too few rows, no stretch, or no form whose values the data determine; the message names
            the values.
    """
    problem = _checked(histories)
    starter = Starter(problem)
    tried = all_forms() if forms is None else tuple(forms)
    fitted, refused = _fitted(problem, starter, tried)
    series = [form for form in tried if form.is_prony_series]
    while series and _gains(fitted, series[0].branches):
        series = [replace(form, branches=form.branches + 1) for form in series]
        more, less = _fitted(problem, starter, series)
        fitted, refused = fitted + more, refused + less
    if fitted:
        ambiguous = _ambiguous(fitted, tried, problem)
        refused += [
            FitCandidate(form=each.model.form, refused=ambiguous[id(each)]) for each in fitted if id(each) in ambiguous
        ]
        fitted = [each for each in fitted if id(each) not in ambiguous]
    if not fitted:
        raise InputError(f"no law can be determined: {_reasons(refused)}")
    return _chosen(fitted, refused, name, source)


def _fitted(
    problem: FitProblem, starter: Starter, forms: Sequence[LawForm]
) -> tuple[list[FittedForm], list[FitCandidate]]:
    """Forms that the data determine, and those that are refused."""
    fitted: list[FittedForm] = []
    refused: list[FitCandidate] = []
    for form in forms:
        try:
            fitted.append(fit_form(problem, starter, form))
        except InputError as error:
            refused.append(FitCandidate(form=form, refused=str(error)))
    return fitted, refused


def _gains(fitted: Sequence[FittedForm], branches: int) -> bool:
    """Whether a Prony series of so many branches fits better than everything with fewer, by the criterion."""
    longest = [each for each in fitted if each.model.form.branches == branches]
    others = [each for each in fitted if each.model.form.branches < branches]
    if not longest or not others:
        return bool(longest)
    effective = _effective(fitted)
    least, other = (min(each.bic(effective) for each in group) for group in (longest, others))
    return least < other - _SAME_FIT


def _checked(histories: Sequence[StrainHistory]) -> FitProblem:
    if not histories:
        raise InputError("histories: need at least one, got none")
    for each in histories:
        if np.ptp(each.strain) == 0 or np.max(each.strain) <= 0:
            raise InputError(f"{each.name}: strain: need a stretch, got {np.max(each.strain):g} throughout")
        if not np.any(each.stress):
            raise InputError(f"{each.name}: stress: need a force, got 0 throughout")
    return problem_of(histories)


def _reasons(refused: Sequence[FitCandidate]) -> str:
    """Why laws were refused, each reason once, with all values that it names and the number of laws."""
    alike: dict[str, list[tuple[list[str], str]]] = {}
    for each in refused:
        named = _NAMED.match(each.refused)
        keys, reason = (named["keys"].split(", "), named["reason"]) if named else ([], each.refused)
        alike.setdefault(_NUMBERS.sub("", reason), []).append((keys, reason))
    told = []
    for group in alike.values():
        keys = ", ".join(dict.fromkeys(key for own, _ in group for key in own))
        told.append(f"{keys}: {group[0][1]}" if keys else group[0][1])
        if len(group) > 1:
            told[-1] += f" ({len(group)} laws)"
    return ". ".join(told)


def _ambiguous(fitted: Sequence[FittedForm], tried: Sequence[LawForm], problem: FitProblem) -> dict[int, str]:
    """Forms whose damper a Maxwell branch replaces as well, or the other way round, at the one rate of the data.

    Only where both were asked for.
    """
    if not any(form.branches for form in tried):
        return {}
    rate = one_rate(problem)
    dampers = [each for each in fitted if each.model.form.damper and not each.model.form.branches]
    branched = [each for each in fitted if each.model.form.branches]
    if rate is None or not dampers:
        return {}
    effective = _effective(fitted)
    damper = min(dampers, key=lambda each: each.bic(effective))
    rivals = [2 * effective * _rival_misfit(damper)]
    settled = False
    if branched:
        branch = min(branched, key=lambda each: each.bic(effective))
        rivals.append(2 * effective * _log_ratio(branch.misfit, damper.misfit, problem.peak))
        # a branch that fits far better, with values that the data determine
        settled = rivals[-1] < -_SAME_FIT
    if settled or min(rivals) > _SAME_FIT:
        return {}
    reason = (
        f"one rate only, {rate:.3g} 1/s, cannot tell viscosity.linear from branches.0.modulus;"
        " test at another rate, or hold the strain"
    )
    return {id(each): reason for each in (*dampers, *branched)}


def _rival_misfit(damper: FittedForm) -> float:
    """By how much a Maxwell branch in place of a damper fits worse: ln of the ratio of misfits.

    Of the branches whose time the data sample; those that `fit_form` refuses since their values are open count, too.
    """
    form, problem = damper.model.form, damper.model.problem
    rival = LawModel(form=replace(form, damper=0, branches=1), problem=problem, baseline=damper.model.baseline)
    others = damper.values[len(form.linear_keys) : len(form.keys)]
    baseline, stress = rival.baseline_columns, problem.stress
    members = problem.membership
    own = pulling_solution(problem.block(damper.model.columns(others)), baseline, stress, members)[1]
    least, (shortest, longest) = np.inf, problem.times
    for logarithm in np.log(np.geomspace(shortest, longest, _TIMES)):
        columns = problem.block(rival.columns(np.array([logarithm, *others])))
        least = min(least, pulling_solution(columns, baseline, stress, members)[1])
    points = len(stress)
    return _log_ratio(np.sqrt(least / points), np.sqrt(own / points), problem.peak)


def _log_ratio(misfit: float, other: float, peak: float) -> float:
    return float(np.log(max(misfit / peak, FLOOR) / max(other / peak, FLOOR)))


def _effective(fitted: Sequence[FittedForm]) -> float:
    """What the points are worth to the form with the least residual, so that all forms are judged by one number."""
    best = min(fitted, key=lambda each: each.misfit)
    return max(effective_points(best.residual, best.model.problem.specimen), len(best.values) + 2.0)


def _chosen(fitted: list[FittedForm], refused: list[FitCandidate], name: str, source: str) -> LawFit:
    effective = _effective(fitted)
    ranked = sorted(fitted, key=lambda each: each.bic(effective))
    alike = [each for each in ranked if each.bic(effective) <= ranked[0].bic(effective) + _SAME_FIT]
    best = min(alike, key=lambda each: len(each.values))
    ranked = [best, *(each for each in ranked if each is not best)]
    chosen = best.bic(effective)
    tried = [
        FitCandidate(
            form=each.model.form,
            bic=each.bic(effective),
            above_chosen=each.bic(effective) - chosen,
            misfit=each.misfit,
        )
        for each in ranked
    ]
    problem, logarithms = best.model.problem, best.model.parts(best.values)[1]
    return LawFit(
        law=replace(best.law, name=name, source=source),
        form=best.model.form,
        points=len(problem.stress),
        effective_points=effective_points(best.residual, problem.specimen),
        bic=chosen,
        misfit=best.misfit,
        relative_misfit=best.misfit / problem.peak,
        scatter=float(np.std(logarithms, ddof=1)) if len(logarithms) > 1 else None,
        residuals=_residuals(best),
        candidates=(*tried, *refused),
    )


def _residuals(best: FittedForm) -> tuple[Residual, ...]:
    problem, model = best.model.problem, best.model
    time = problem.block(np.concatenate([each.time for each in problem.histories]))
    strain = problem.block(problem.strain)
    terms = np.zeros((2, len(problem.histories)))
    _, logarithms, zeros = model.parts(best.values)
    terms[: model.baseline, problem.unknown_zeros] = zeros.reshape(model.baseline, -1 if model.baseline else 0)
    residuals = []
    for index, each in enumerate(problem.histories):
        own = problem.specimen == index
        half = (each.time[-1] - each.time[0]) / 2
        stress = problem.stress[own] + each.zero_at(time[own])
        residuals.append(
            Residual(
                name=each.name,
                amplitude=float(np.exp(logarithms[index])),
                time=time[own],
                strain=strain[own],
                stress=stress,
                fitted=stress + best.residual[own],
                offset=float(terms[0, index]) if each.offset is None else each.offset,
                drift=float(terms[1, index] / half) + each.drift,
            )
        )
    return tuple(residuals)
