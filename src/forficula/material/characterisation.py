"""Characterisation of a material by tensile tests: its cycles, moduli, their drift, and its law."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from importlib import metadata
from typing import Annotated

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.material.fit.fit import LawFit, fit_law
from forficula.material.fit.fit_form import DAMPER_OR_BRANCH, ONE_RATE_ONLY, UNDISTINGUISHED
from forficula.material.law.drift import Drift, fit_drift
from forficula.material.law.law_form import LawForm
from forficula.material.law.law_summary import LawSummary, law_summary
from forficula.material.law.material_law import LawFact, MaterialLaw, scaled
from forficula.material.tensile.cycle_drift import CycleDrift, CycleMedians, cycle_drift, cycle_medians
from forficula.material.tensile.cycles import BAND, Cycle, find_cycles
from forficula.material.tensile.modulus import ModulusClass, moduli_by_strain
from forficula.material.tensile.strain_history import StrainHistory
from forficula.material.tensile.tensile_test import TensileTest
from forficula.quantities import Unit, parse_quantity
from forficula.results import Result
from forficula.serial import Key, WithUnit, Written

SPECIMEN_LENGTH, SPECIMEN_AREA = "length of the specimens", "area of the specimens"
AMPLITUDE_SCATTER = "standard deviation of the specimens' amplitudes"
LENGTH = Unit(display="mm", si="m", example="60 mm")
AREA = Unit(display="mm^2", si="m^2", example="5 mm^2")
BAND_SHARE = Unit(display="%", si="dimensionless", example="5 %")
SIMULATED_STIFFNESSES = (1000.0, 6000.0)  # N/m: 10 to 60 N/cm, Binder et al. 2025
_FEWEST_CYCLES = 3  # least number of cycles that determine a drift
_FEWEST_SPECIMENS = 3  # ISO 37
_POOR_FIT = 0.05  # share of the largest stress
_SAME_SIZE = 0.01  # largest relative difference between sizes that count as equal
_ONE_RATE = 1.05  # largest ratio of two strain rates that count as one

# functions of a cycle, and whether the drift is relative, that is, a factor
DRIFTING: dict[str, tuple[Callable[[Cycle], float], bool]] = {
    "peak_stress": (lambda cycle: cycle.secant_modulus * cycle.largest_strain, True),
    "loss": (lambda cycle: cycle.loss, True),
    "residual_strain": (lambda cycle: cycle.residual_strain, False),
}


@dataclass(frozen=True, kw_only=True, eq=False)
class Specimen:
    """One specimen and its cycles.

    Attributes:
        test: test as the machine recorded it.
        cycles: cycles that are evaluated.
        left_out: the first cycle, if it is not evaluated.
    """

    test: Annotated[TensileTest, Written.BESIDE]
    cycles: tuple[Cycle, ...]
    left_out: Annotated[tuple[Cycle, ...], Key("left_out_cycles")]

    @property
    def strain_rate(self) -> Annotated[float, Unit("1/s")]:
        """Median of the mean strain rates of loading and unloading, 1/s."""
        branches = [branch for cycle in self.cycles for branch in (cycle.loading, cycle.unloading)]
        rates = [abs(np.ptp(branch.strain)) / max(np.ptp(branch.time), 1e-300) for branch in branches]
        return float(np.median(rates))


@dataclass(frozen=True, kw_only=True)
class DriftSummary:
    """Changes over the cycles of a material.

    Attributes:
        specimens: number of specimens with two cycles or more.
        change: change from one cycle to the next.
        drifts: drift of each quantity; None if the tests do not determine it.
    """

    specimens: int
    change: CycleDrift
    drifts: Annotated[Mapping[str, Drift | None], Written.BESIDE]


@dataclass(frozen=True, kw_only=True, eq=False)
class Characterisation(Result):
    """Results of the tensile tests of a material.

    Attributes:
        name: name of the material.
        specimens: specimens in the given order.
        cycles: medians over the specimens, cycle by cycle.
        change: change from one cycle to the next.
        drifts: drifts of peak stress, loss and residual strain, by the keys of `DRIFTING`; None if the tests do not
            determine them.
        by_cycle: moduli in classes of strain, cycle by cycle.
        pooled: moduli in classes of strain, with all cycles pooled.
        single: moduli in classes of strain for each cycle of each specimen.
        fit: fit of the law; None if the data determine no law.
        law: chosen law, with its source and the size of the specimens; None if the data determine no law.
        remarks: remarks for the user, as sentences.
    """

    name: Annotated[str, Key("material")]
    specimens: tuple[Specimen, ...]
    cycles: tuple[CycleMedians, ...]
    change: Annotated[CycleDrift, Written.NEVER]
    drifts: Annotated[Mapping[str, Drift | None], Written.NEVER]
    by_cycle: Annotated[tuple[ModulusClass, ...], Written.NEVER]
    pooled: Annotated[tuple[ModulusClass, ...], Written.NEVER]
    single: Annotated[tuple[ModulusClass, ...], Written.NEVER]
    fit: LawFit | None
    law: Annotated[MaterialLaw | None, Written.NEVER]
    remarks: tuple[str, ...] = field(default=())

    def __repr__(self) -> str:
        """Return the material, the number of specimens, and the form of the law."""
        specimens = f"{len(self.specimens)} specimen{'s' * (len(self.specimens) != 1)}"
        return f"<Characterisation of {self.name}: {specimens}, {'no law' if self.fit is None else self.fit.form.name}>"

    @property
    def drift(self) -> Annotated[DriftSummary, Written.ALWAYS]:
        """Changes over the cycles."""
        return DriftSummary(specimens=self.change.specimens, change=self.change, drifts=self.drifts)

    @property
    def modulus_by_strain(self) -> Annotated[tuple[ModulusClass, ...], Written.ALWAYS]:
        """Moduli in classes of strain, cycle by cycle, then pooled."""
        return (*self.by_cycle, *self.pooled)

    @property
    def simulated_stiffnesses(self) -> Annotated[Mapping[str, WithUnit], Written.ALWAYS]:
        """Stiffnesses of Binder et al. 2025 and the moduli that tendons of the specimens' size need for them."""
        return {
            "stiffness": WithUnit(SIMULATED_STIFFNESSES, "N/m"),
            "modulus_at_the_specimens_size": WithUnit(self.simulated_moduli, "Pa"),
        }

    @property
    def law_values(self) -> Annotated[LawSummary | None, Key("law")]:
        """The law and its values; None if the data determine no law."""
        return None if self.law is None else law_summary(self.law)

    @property
    def versions(self) -> Annotated[dict[str, str], Written.ALWAYS]:
        """Versions of the packages that compute a material."""
        return {name: metadata.version(name) for name in ("forficula", "numpy", "scipy")}

    @property
    def simulated_moduli(self) -> tuple[float, float]:
        """Moduli E = k L / A, Pa, with which tendons of the specimens' median size have stiffnesses of 10 and 60 N/cm.

        The stiffnesses are those of Binder et al. 2025.
        """
        ratio = float(np.median([specimen.test.length / specimen.test.area for specimen in self.specimens]))
        low, high = SIMULATED_STIFFNESSES
        return low * ratio, high * ratio


def characterise(
    tests: Sequence[TensileTest],
    *,
    name: str = "material",
    source: str = "",
    drop_first: bool = True,
    band: float = BAND,
    forms: Sequence[LawForm] | None = None,
) -> Characterisation:
    """Find cycles, moduli, drift and the law of a material.

    Args:
        tests: tensile tests of the specimens.
        name: name of the material.
        source: source of the tests, for the law.
        drop_first: leave out the first cycle; the law is still computed through it, because materials remember it.
        band: hysteresis of the turning points, as a share of the largest travel.
        forms: forms of laws to try; all by default. If none of the given forms can be determined, this is an error
            instead of a remark.

    Raises:
        InputError: no test, or a test without cycles; the message names the specimen.
    """
    if not tests:
        raise InputError("need at least one tensile test, got none")
    specimens = tuple(_specimen(test, drop_first, band) for test in tests)
    cycles = [specimen.cycles for specimen in specimens]
    drifts = {key: _drift(cycles, value, relative) for key, (value, relative) in DRIFTING.items()}
    fit, refusal = _fit(specimens, name, source, forms)
    return Characterisation(
        name=name,
        specimens=specimens,
        cycles=cycle_medians(cycles),
        change=cycle_drift(cycles),
        drifts=drifts,
        by_cycle=moduli_by_strain(cycles),
        pooled=moduli_by_strain(cycles, pool_cycles=True),
        single=tuple(_single(cycles)),
        fit=fit,
        law=None if fit is None else replace(_with_drifts(fit.law, cycles), facts=tuple(_facts(specimens, fit))),
        remarks=tuple(_remarks(specimens, drifts, fit, refusal)),
    )


def known_length(law: MaterialLaw) -> float | None:
    """Return the length of the specimens from which a law was fitted, m; None if it is not among the law's facts."""
    return next((parse_quantity(fact.value, LENGTH) for fact in law.facts if fact.what == SPECIMEN_LENGTH), None)


def cycle_table(cycles: Sequence[Sequence[Cycle]], value: Callable[[Cycle], float]) -> Array:
    """Return a value of the cycles that all specimens have, shape (specimen, cycle), nan where it is absent."""
    numbers = common_cycles(cycles)
    by_number = [{cycle.number: value(cycle) for cycle in specimen} for specimen in cycles]
    return np.array([[values[number] for number in numbers] for values in by_number], dtype=np.float64)


def common_cycles(cycles: Sequence[Sequence[Cycle]]) -> list[int]:
    """Return the numbers of the cycles that all specimens have."""
    return sorted(set.intersection(*({cycle.number for cycle in specimen} for specimen in cycles)))


def _specimen(test: TensileTest, drop_first: bool, band: float) -> Specimen:
    cycles = find_cycles(test, band=band, drop_first=False)
    kept = cycles[1:] if drop_first else cycles
    if not kept:
        raise InputError(f"{test.name}: need two cycles, because the first is left out, got one: see --keep-first")
    return Specimen(test=test, cycles=kept, left_out=cycles[: len(cycles) - len(kept)])


def _drift(cycles: Sequence[Sequence[Cycle]], value: Callable[[Cycle], float], relative: bool) -> Drift | None:
    numbers, table = common_cycles(cycles), cycle_table(cycles, value)
    if len(numbers) < _FEWEST_CYCLES or not np.all(np.isfinite(table)) or (relative and np.any(table <= 0)):
        return None
    return fit_drift(numbers, table, relative=relative)


def _with_drifts(law: MaterialLaw, cycles: Sequence[Sequence[Cycle]]) -> MaterialLaw:
    """Add to a law the drifts that the cycles determine."""
    longer = _drift(cycles, lambda cycle: cycle.residual_strain, False)
    stiffness = _drift(cycles, _stiffness if longer else lambda cycle: cycle.secant_modulus, True)
    return replace(law, stiffness_drift=stiffness, residual_strain_drift=longer)


def _stiffness(cycle: Cycle) -> float:
    """Return the peak stress divided by the strain beyond the residual strain, so that the set does not count twice."""
    return cycle.secant_modulus * cycle.largest_strain / max(cycle.largest_strain - cycle.residual_strain, 1e-12)


def _single(cycles: Sequence[Sequence[Cycle]]) -> Iterator[ModulusClass]:
    """Yield the moduli of each cycle of each specimen; a cycle that covers less than half of every class gives none."""
    for cycle in (cycle for specimen in cycles for cycle in specimen):
        try:
            yield from moduli_by_strain([[cycle]])
        except InputError:
            continue


def strain_history(specimen: Specimen) -> StrainHistory:
    """Return a specimen's whole test for the fit of a law, which is compared from the first evaluated cycle on.

    Of several rows with the same time, the first is used.
    """
    test = specimen.test
    rows = np.concatenate([[True], np.diff(test.time) > 0])
    start = specimen.cycles[0].loading.time[0] if specimen.left_out else test.time[0]
    offset, drift = _zero(specimen)
    return StrainHistory(
        time=test.time[rows],
        strain=test.strain[rows],
        stress=test.stress[rows],
        name=test.name,
        first=int(np.searchsorted(test.time[rows], start)),
        offset=offset,
        drift=drift,
    )


def _zero(specimen: Specimen) -> tuple[float | None, float]:
    """Compute the zero of the force from cycles in which the specimen hangs slack.

    Returns:
        Offset at the middle of the test, Pa, None if the specimen never hangs slack; and drift, Pa/s. The drift is 0
        for fewer than three such cycles, because two points do not show whether it is linear.
    """
    slack = [cycle for cycle in (*specimen.left_out, *specimen.cycles) if cycle.hanging.any()]
    if not slack:
        return None, 0.0
    zeros = np.array([cycle.zero_stress for cycle in slack])
    if len(slack) < _FEWEST_CYCLES:
        return float(np.mean(zeros)), 0.0
    middle = (specimen.test.time[0] + specimen.test.time[-1]) / 2
    times = np.array([np.median(cycle.unloading.time[cycle.hanging]) for cycle in slack]) - middle
    drift, offset = np.polyfit(times, zeros, 1)
    return float(offset), float(drift)


def _fit(
    specimens: Sequence[Specimen], name: str, source: str, forms: Sequence[LawForm] | None
) -> tuple[LawFit | None, str]:
    """Return the fitted law and "", or None and the reason why there is no law."""
    try:
        histories = [strain_history(specimen) for specimen in specimens]
        return fit_law(histories, name=name, source=source, forms=forms), ""
    except InputError as error:
        if forms is not None:
            raise
        return None, str(error)


def _facts(specimens: Sequence[Specimen], fit: LawFit) -> Iterator[LawFact]:
    """Yield facts about the tests, for readers of the law."""
    source = "the same tests"
    for what, unit, factor, sizes in (
        (SPECIMEN_LENGTH, "mm", 1e-3, [specimen.test.length for specimen in specimens]),
        (SPECIMEN_AREA, "mm^2", 1e-6, [specimen.test.area for specimen in specimens]),
    ):
        if max(sizes) <= (1 + _SAME_SIZE) * min(sizes):
            yield LawFact(what=what, value=f"{np.median(sizes) / factor:.6g} {unit}", source=source)
    if fit.scatter is not None:
        yield LawFact(what=AMPLITUDE_SCATTER, value=f"{100 * fit.scatter:.3g} %", source=source)
    yield LawFact(what="number of specimens", value=str(len(specimens)), source=source)


def _remarks(
    specimens: Sequence[Specimen], drifts: Mapping[str, Drift | None], fit: LawFit | None, refusal: str
) -> Iterator[str]:
    count = len(specimens)
    if any(specimen.left_out for specimen in specimens):
        yield "the first cycle of every specimen is left out of all values; only the fit of the law includes it"
    if count < _FEWEST_SPECIMENS:
        known = "one specimen" if count == 1 else f"{count} specimens"
        yield f"{known}: intervals and quartiles hardly show the scatter of specimens; ISO 37 requires three or more"
    ratios = [specimen.test.length / specimen.test.area for specimen in specimens]
    if max(ratios) > (1 + _SAME_SIZE) * min(ratios):
        yield "the specimens differ in size; the band of moduli in modulus.png is for their median size"
    undetermined = [key.replace("_", " ") for key, drift in drifts.items() if drift is None]
    if undetermined:
        yield (
            f"the drift of {', '.join(undetermined)} cannot be determined: it needs {_FEWEST_CYCLES} cycles in every"
            " specimen, each with a value that differs clearly from 0"
        )
    yield from _fit_remarks(fit, refusal)
    rates = [specimen.strain_rate for specimen in specimens]
    one_rate = max(rates) <= _ONE_RATE * min(rates)
    if one_rate and fit and fit.form.damper and not any(candidate.form.branches for candidate in fit.candidates):
        yield "at a single rate a Maxwell branch may fit as well as the damper; no law with a branch was tried"


def _fit_remarks(fit: LawFit | None, refusal: str) -> Iterator[str]:
    if fit is None:
        yield f"there is no law: {refusal}"
        return
    if fit.relative_misfit > _POOR_FIT:
        yield f"the law deviates from the data by {fit.relative_misfit:.0%} of the largest stress; see fit.png"
    if scaled(fit.law, length=1.0, area=1.0).must_push:
        yield (
            "a simulated tendon with this law pushes when it is slack, which a real one does not; a design must allow"
            " this by tendon.pushes_when_slack. Laws without yield and with linear viscosity only pull"
        )
    refused = [candidate.refused for candidate in fit.candidates if candidate.refused]
    # the longest reason names all values
    for what in (UNDISTINGUISHED, DAMPER_OR_BRANCH):
        reasons = [reason for reason in refused if ONE_RATE_ONLY in reason and what in reason]
        if reasons:
            yield max(reasons, key=len)
    if refused:
        yield f"{len(refused)} of {len(fit.candidates)} laws are refused; material.json gives the reason for each"
