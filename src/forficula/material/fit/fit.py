"""Fitting of material laws with their uncertainty to measured histories of strain and stress."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.material.fit.fit_form import DAMPER_OR_BRANCH, FLOOR, ONE_RATE_ONLY, FittedForm, fit_form, one_rate
from forficula.material.fit.fit_problem import FitProblem, LawModel, problem_of
from forficula.material.fit.fit_start import Starter, pulling_solution
from forficula.material.fit.uncertainty import effective_points
from forficula.material.law.law_form import LawForm, all_forms
from forficula.material.law.material_law import MaterialLaw
from forficula.material.tensile.strain_history import StrainHistory
from forficula.quantities import Unit
from forficula.serial import Key, WithUnit, Written

_SAME_FIT = 6.0  # difference of BIC that is "strong" evidence (Raftery 1995, doi 10.2307/271063)
# the keys and the reason of a refusal, and the numbers in it, by which refusals with the same reason differ
_NAMED = re.compile(r"(?P<keys>[a-z_]+[\w.]*(?:, [a-z_]+[\w.]*)*): (?P<reason>.*)", re.DOTALL)
_NUMBERS = re.compile(r"(?<![\w.])[-+]?\d[\d.e+-]*|\b[kMG]?Pa\b")
_TIMES = 16  # relaxation times tried in place of a damper
_Criterion = Annotated[float, Key("bayesian_information_criterion")]
_Rms = Annotated[float, Key("residual_rms"), Unit("Pa")]


@dataclass(frozen=True, kw_only=True)
class FitCandidate:
    """A form of a law that was tried.

    Attributes:
        form: the form.
        bic: Bayesian information criterion, lower is better; nan if the form was refused.
        above_chosen: criterion minus that of the chosen form; nan if the form was refused.
        misfit: root mean square of the residual, Pa; nan if the form was refused.
        refused: reason why the form was refused; empty if it was not.
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
        """Number of values of the form."""
        return len(self.form.keys)


@dataclass(frozen=True, kw_only=True, eq=False)
class Residual:
    """Measured and fitted stress of one specimen, averaged over blocks of neighbouring rows.

    Attributes:
        name: name of the specimen.
        amplitude: stress of the specimen divided by that of the law.
        time: s, shape (points,).
        strain: shape (points,).
        stress: measured stress, Pa, shape (points,).
        fitted: fitted stress, Pa, shape (points,), with amplitude, offset and drift.
        offset: zero of the force at the middle of the test, Pa, measured or fitted; otherwise 0.
        drift: drift of the zero of the force, Pa/s, measured or fitted; otherwise 0.
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
    """A fitted law with its uncertainty, and the other forms that were tried.

    Attributes:
        law: law with the 95 % confidence intervals of its values.
        form: terms of the law.
        points: number of points that were compared.
        effective_points: effective number of independent points.
        bic: Bayesian information criterion.
        misfit: root mean square of the residual, Pa.
        relative_misfit: misfit divided by the largest stress.
        scatter: standard deviation of the logarithms of the specimens' amplitudes; None for one specimen.
        residuals: residual of each specimen.
        candidates: all forms that were tried, the chosen one first, refused ones last.
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
        """Stress of every specimen divided by that of the law."""
        return [{"specimen": residual.name, "amplitude": residual.amplitude} for residual in self.residuals]

    @property
    def force_zero(self) -> Annotated[list[Mapping[str, str | WithUnit]], Written.ALWAYS]:
        """Reading of the load cell without force, and its drift, for every specimen."""
        return [
            {
                "specimen": specimen.name,
                "offset": WithUnit(specimen.offset, "Pa"),
                "drift": WithUnit(specimen.drift, "Pa/s"),
            }
            for specimen in self.residuals
        ]


def fit_law(
    histories: Sequence[StrainHistory],
    *,
    name: str = "fitted",
    source: str = "",
    forms: Sequence[LawForm] | None = None,
) -> LawFit:
    """Fit laws to one or several specimens and choose one of them.

    The fit is by least squares of the stress; where the law would push, the specimen counts as slack. Each of several
    specimens has its own amplitude, and the law is that of their geometric mean. The 95 % intervals of values that are
    proportional to the stress are those of the material's mean: they include the scatter of the few tested specimens,
    by Student's t, in addition to the misfit. If the zero of a specimen's force is not known, an offset and a drift
    linear in time are fitted with the law, provided that the data can distinguish them from the law.

    The law is chosen by the Bayesian information criterion, with the effective number of points of the best residual.
    Of laws whose criterion differs by less than 6, the one with the fewest values is chosen. A Prony series, which
    starts with two Maxwell branches, gets another branch as long as the criterion improves by more than 6.

    If a test at a single rate is fitted equally well by a damper and by a Maxwell branch, and forms with both are
    tried, both are refused. If the first cycle of a test is to be left out, pass the whole test with its `first`
    sample, because branches, yield and softening remember that cycle.

    Args:
        histories: histories of the specimens, each starting at rest.
        name: name of the law.
        source: source of the data.
        forms: forms to try; by default `all_forms`.

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
            FitCandidate(form=fit.model.form, refused=ambiguous[id(fit)]) for fit in fitted if id(fit) in ambiguous
        ]
        fitted = [fit for fit in fitted if id(fit) not in ambiguous]
    if not fitted:
        raise InputError(f"no law can be determined: {_reasons(refused)}")
    return _chosen(fitted, refused, name, source)


def _fitted(
    problem: FitProblem, starter: Starter, forms: Sequence[LawForm]
) -> tuple[list[FittedForm], list[FitCandidate]]:
    """Return the forms that the data determine, and those that are refused."""
    fitted: list[FittedForm] = []
    refused: list[FitCandidate] = []
    for form in forms:
        try:
            fitted.append(fit_form(problem, starter, form))
        except InputError as error:
            refused.append(FitCandidate(form=form, refused=str(error)))
    return fitted, refused


def _gains(fitted: Sequence[FittedForm], branches: int) -> bool:
    """Return whether a Prony series with a number of branches has a better criterion than all forms with fewer."""
    longest = [fit for fit in fitted if fit.model.form.branches == branches]
    others = [fit for fit in fitted if fit.model.form.branches < branches]
    if not longest or not others:
        return bool(longest)
    effective = _effective(fitted)
    least, other = (min(fit.bic(effective) for fit in group) for group in (longest, others))
    return least < other - _SAME_FIT


def _checked(histories: Sequence[StrainHistory]) -> FitProblem:
    if not histories:
        raise InputError("histories: need at least one, got none")
    for history in histories:
        if np.ptp(history.strain) == 0 or np.max(history.strain) <= 0:
            raise InputError(f"{history.name}: strain: need a stretch, got {np.max(history.strain):g} throughout")
        if not np.any(history.stress):
            raise InputError(f"{history.name}: stress: need a force, got 0 throughout")
    return problem_of(histories)


def _reasons(refused: Sequence[FitCandidate]) -> str:
    """Return the reasons why laws were refused, each once, with all values that it names and the number of laws."""
    groups: dict[str, list[tuple[list[str], str]]] = {}
    for candidate in refused:
        match = _NAMED.match(candidate.refused)
        keys, reason = (match["keys"].split(", "), match["reason"]) if match else ([], candidate.refused)
        groups.setdefault(_NUMBERS.sub("", reason), []).append((keys, reason))
    sentences = []
    for group in groups.values():
        named = ", ".join(dict.fromkeys(key for keys, _ in group for key in keys))
        sentences.append(f"{named}: {group[0][1]}" if named else group[0][1])
        if len(group) > 1:
            sentences[-1] += f" ({len(group)} laws)"
    return ". ".join(sentences)


def _ambiguous(fitted: Sequence[FittedForm], tried: Sequence[LawForm], problem: FitProblem) -> dict[int, str]:
    """Return the reasons to refuse forms, by `id`, if a damper and a Maxwell branch fit equally well at a single rate.

    Forms are refused only if both kinds were tried.
    """
    if not any(form.branches for form in tried):
        return {}
    rate = one_rate(problem)
    dampers = [fit for fit in fitted if fit.model.form.damper and not fit.model.form.branches]
    branched = [fit for fit in fitted if fit.model.form.branches]
    if rate is None or not dampers:
        return {}
    effective = _effective(fitted)
    damper = min(dampers, key=lambda fit: fit.bic(effective))
    rivals = [2 * effective * _rival_misfit(damper)]
    settled = False
    if branched:
        branch = min(branched, key=lambda fit: fit.bic(effective))
        rivals.append(2 * effective * _log_ratio(branch.misfit, damper.misfit, problem.peak))
        # the branch fits far better, with values that the data determine
        settled = rivals[-1] < -_SAME_FIT
    if settled or min(rivals) > _SAME_FIT:
        return {}
    reason = (
        f"{ONE_RATE_ONLY}, {rate:.3g} 1/s, {DAMPER_OR_BRANCH} branches.0.modulus;"
        " test at another rate, or hold the strain"
    )
    return {id(fit): reason for fit in (*dampers, *branched)}


def _rival_misfit(damper: FittedForm) -> float:
    """Compute ln of the ratio of misfits of the best Maxwell branch and of the damper that it replaces.

    All branches with a relaxation time that the data sample count, also those whose values the data do not determine.
    """
    form, problem = damper.model.form, damper.model.problem
    rival = LawModel(form=replace(form, damper=0, branches=1), problem=problem, baseline=damper.model.baseline)
    others = damper.values[len(form.linear_keys) : len(form.keys)]
    baseline, stress = rival.baseline_columns, problem.stress
    members = problem.membership
    with_damper = pulling_solution(problem.block(damper.model.columns(others)), baseline, stress, members)[1]
    least, (shortest, longest) = np.inf, problem.times
    for logarithm in np.log(np.geomspace(shortest, longest, _TIMES)):
        columns = problem.block(rival.columns(np.array([logarithm, *others])))
        least = min(least, pulling_solution(columns, baseline, stress, members)[1])
    points = len(stress)
    return _log_ratio(np.sqrt(least / points), np.sqrt(with_damper / points), problem.peak)


def _log_ratio(misfit: float, other: float, peak: float) -> float:
    return float(np.log(max(misfit / peak, FLOOR) / max(other / peak, FLOOR)))


def _effective(fitted: Sequence[FittedForm]) -> float:
    """Return the effective number of points of the form with the smallest residual, with which all are compared."""
    best = min(fitted, key=lambda fit: fit.misfit)
    return max(effective_points(best.residual, best.model.problem.specimen), len(best.values) + 2.0)


def _chosen(fitted: list[FittedForm], refused: list[FitCandidate], name: str, source: str) -> LawFit:
    effective = _effective(fitted)
    ranked = sorted(fitted, key=lambda fit: fit.bic(effective))
    equivalent = [fit for fit in ranked if fit.bic(effective) <= ranked[0].bic(effective) + _SAME_FIT]
    best = min(equivalent, key=lambda fit: len(fit.values))
    ranked = [best, *(fit for fit in ranked if fit is not best)]
    chosen = best.bic(effective)
    tried = [
        FitCandidate(
            form=fit.model.form,
            bic=fit.bic(effective),
            above_chosen=fit.bic(effective) - chosen,
            misfit=fit.misfit,
        )
        for fit in ranked
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
    time = problem.block(np.concatenate([history.time for history in problem.histories]))
    strain = problem.block(problem.strain)
    terms = np.zeros((2, len(problem.histories)))
    _, logarithms, zeros = model.parts(best.values)
    terms[: model.baseline, problem.unknown_zeros] = zeros.reshape(model.baseline, -1 if model.baseline else 0)
    residuals = []
    for index, history in enumerate(problem.histories):
        blocks = problem.specimen == index
        half = (history.time[-1] - history.time[0]) / 2
        stress = problem.stress[blocks] + history.zero_at(time[blocks])
        residuals.append(
            Residual(
                name=history.name,
                amplitude=float(np.exp(logarithms[index])),
                time=time[blocks],
                strain=strain[blocks],
                stress=stress,
                fitted=stress + best.residual[blocks],
                offset=float(terms[0, index]) if history.offset is None else history.offset,
                drift=float(terms[1, index] / half) + history.drift,
            )
        )
    return tuple(residuals)
