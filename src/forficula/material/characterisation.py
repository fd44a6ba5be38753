"""What tensile tests say of a material: its cycles, its moduli, how they drift, and its law."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from importlib import metadata
from typing import Annotated

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.material.fit.fit import LawFit, fit_law
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
_FEWEST_CYCLES = 3  # that tell a drift
_FEWEST_SPECIMENS = 3  # ISO 37
_POOR_FIT = 0.05  # of the largest stress
_SAME_SIZE = 0.01
_ONE_RATE = 1.05  # ratio of fast to slow

# relative ones drift by a factor
DRIFTING: dict[str, tuple[Callable[[Cycle], float], bool]] = {
    "peak_stress": (lambda cycle: cycle.secant_modulus * cycle.largest_strain, True),
    "loss": (lambda cycle: cycle.loss, True),
    "residual_strain": (lambda cycle: cycle.residual_strain, False),
}


@dataclass(frozen=True, kw_only=True, eq=False)
class Specimen:
    """One specimen and its cycles.

    Attributes:
        test: as the machine recorded it.
        cycles: that count.
        left_out: the first cycle, where it does not count.
    """

    test: Annotated[TensileTest, Written.BESIDE]
    cycles: tuple[Cycle, ...]
    left_out: Annotated[tuple[Cycle, ...], Key("left_out_cycles")]

    @property
    def strain_rate(self) -> Annotated[float, Unit("1/s")]:
        """Median over the samples of loading and unloading, 1/s."""
        branches = [branch for cycle in self.cycles for branch in (cycle.loading, cycle.unloading)]
        rates = [abs(np.ptp(branch.strain)) / max(np.ptp(branch.time), 1e-300) for branch in branches]
        return float(np.median(rates))


@dataclass(frozen=True, kw_only=True)
class DriftSummary:
    """How the cycles of a material change.

    Attributes:
        specimens: how many have two cycles or more.
        change: from one cycle to the next.
        drifts: by the quantity that drifts; None where the tests do not determine it.
    """

    specimens: int
    change: CycleDrift
    drifts: Annotated[Mapping[str, Drift | None], Written.BESIDE]


@dataclass(frozen=True, kw_only=True, eq=False)
class Characterisation(Result):
    """What the tensile tests of a material say.

    Attributes:
        name: of the material.
        specimens: in the order given.
        cycles: medians over specimens.
        change: of the cycles, from one to the next.
        drifts: of peak stress, loss and residual strain, by the keys of `DRIFTING`; None where they cannot be told.
        by_cycle: moduli in classes of strain, cycle by cycle.
        pooled: moduli in classes of strain, cycles put together.
        single: the values behind both, those of each cycle of each specimen.
        fit: of the law; None where the data determine none.
        law: that was chosen, with its source and the size of the specimens; None as `fit`.
        remarks: what a person should know, one sentence each.
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
        """What was tested, and the form of its law."""
        specimens = f"{len(self.specimens)} specimen{'s' * (len(self.specimens) != 1)}"
        return f"<Characterisation of {self.name}: {specimens}, {'no law' if self.fit is None else self.fit.form.name}>"

    @property
    def drift(self) -> Annotated[DriftSummary, Written.ALWAYS]:
        """How cycles change."""
        return DriftSummary(specimens=self.change.specimens, change=self.change, drifts=self.drifts)

    @property
    def modulus_by_strain(self) -> Annotated[tuple[ModulusClass, ...], Written.ALWAYS]:
        """Moduli in classes of strain, cycle by cycle and then pooled."""
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
        """The law and its values; None where the data determine none."""
        return None if self.law is None else law_summary(self.law)

    @property
    def versions(self) -> Annotated[dict[str, str], Written.ALWAYS]:
        """Versions of the packages that compute a material."""
        return {name: metadata.version(name) for name in ("forficula", "numpy", "scipy")}

    @property
    def simulated_moduli(self) -> tuple[float, float]:
        """Moduli that tendons of the specimens' size need for 10 to 60 N/cm, E = k L / A, Pa.

        The stiffnesses are those of Binder et al. 2025; the size is the median of the specimens'.
        """
        ratio = float(np.median([each.test.length / each.test.area for each in self.specimens]))
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
        tests: of its specimens.
        name: of the material.
        source: of the tests, for the law.
        drop_first: leave out the first cycle; the law runs through it all the same, since materials remember it.
        band: hysteresis of the turning points, a share of the largest travel.
        forms: of laws to try, all by default; that none of those given can be determined is an error, not a remark.

    Raises:
        InputError: no test, or one without cycles; the message names the specimen.
    """
    if not tests:
        raise InputError("need at least one tensile test, got none")
    specimens = tuple(_specimen(test, drop_first, band) for test in tests)
    cycles = [each.cycles for each in specimens]
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
    """The length of the specimens that a law comes from, m; None where it is not among the law's facts."""
    return next((parse_quantity(fact.value, LENGTH) for fact in law.facts if fact.what == SPECIMEN_LENGTH), None)


def cycle_table(cycles: Sequence[Sequence[Cycle]], value: Callable[[Cycle], float]) -> Array:
    """A value of the cycles that every specimen has, shape (specimen, cycle), nan where it is absent."""
    numbers = common_cycles(cycles)
    by_number = [{cycle.number: value(cycle) for cycle in own} for own in cycles]
    return np.array([[own[number] for number in numbers] for own in by_number], dtype=np.float64)


def common_cycles(cycles: Sequence[Sequence[Cycle]]) -> list[int]:
    """Numbers of the cycles that every specimen has."""
    return sorted(set.intersection(*({cycle.number for cycle in own} for own in cycles)))


def _specimen(test: TensileTest, drop_first: bool, band: float) -> Specimen:
    cycles = find_cycles(test, band=band, drop_first=False)
    kept = cycles[1:] if drop_first else cycles
    if not kept:
        raise InputError(f"{test.name}: need two cycles, of which the first is left out, got one: see --keep-first")
    return Specimen(test=test, cycles=kept, left_out=cycles[: len(cycles) - len(kept)])


def _drift(cycles: Sequence[Sequence[Cycle]], value: Callable[[Cycle], float], relative: bool) -> Drift | None:
    numbers, table = common_cycles(cycles), cycle_table(cycles, value)
    if len(numbers) < _FEWEST_CYCLES or not np.all(np.isfinite(table)) or (relative and np.any(table <= 0)):
        return None
    return fit_drift(numbers, table, relative=relative)


def _with_drifts(law: MaterialLaw, cycles: Sequence[Sequence[Cycle]]) -> MaterialLaw:
    """A law and how it drifts, where that can be told."""
    longer = _drift(cycles, lambda cycle: cycle.residual_strain, False)
    stiffness = _drift(cycles, _stiffness if longer else lambda cycle: cycle.secant_modulus, True)
    return replace(law, stiffness_drift=stiffness, residual_strain_drift=longer)


def _stiffness(cycle: Cycle) -> float:
    """Peak stress over the strain beyond the residual one, so that a longer set does not count twice."""
    return cycle.secant_modulus * cycle.largest_strain / max(cycle.largest_strain - cycle.residual_strain, 1e-12)


def _single(cycles: Sequence[Sequence[Cycle]]) -> Iterator[ModulusClass]:
    """The moduli of each cycle of each specimen alone; cycles that pass half of no class give none."""
    for cycle in (cycle for own in cycles for cycle in own):
        try:
            yield from moduli_by_strain([[cycle]])
        except InputError:
            continue


def strain_history(specimen: Specimen) -> StrainHistory:
    """A specimen's whole test as a law is fitted to it, compared from the first cycle that counts.

    Of rows with the same time the first is taken.
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
    """Offset at the middle of the test, Pa, and drift, Pa/s, of the force while the specimen hangs slack.

    The drift from three such cycles on: a straight line through two times cannot tell whether it is one.
    """
    slack = [each for each in (*specimen.left_out, *specimen.cycles) if each.hanging.any()]
    if not slack:
        return None, 0.0
    shown = np.array([each.zero_stress for each in slack])
    if len(slack) < _FEWEST_CYCLES:
        return float(np.mean(shown)), 0.0
    middle = (specimen.test.time[0] + specimen.test.time[-1]) / 2
    times = np.array([np.median(each.unloading.time[each.hanging]) for each in slack]) - middle
    drift, offset = np.polyfit(times, shown, 1)
    return float(offset), float(drift)


def _fit(
    specimens: Sequence[Specimen], name: str, source: str, forms: Sequence[LawForm] | None
) -> tuple[LawFit | None, str]:
    """The law, or why there is none."""
    try:
        return fit_law([strain_history(each) for each in specimens], name=name, source=source, forms=forms), ""
    except InputError as error:
        if forms is not None:
            raise
        return None, str(error)


def _facts(specimens: Sequence[Specimen], fit: LawFit) -> Iterator[LawFact]:
    """What a reader of the law needs to know of the tests."""
    own = "the same tests"
    for what, unit, factor, sizes in (
        (SPECIMEN_LENGTH, "mm", 1e-3, [each.test.length for each in specimens]),
        (SPECIMEN_AREA, "mm^2", 1e-6, [each.test.area for each in specimens]),
    ):
        if max(sizes) <= (1 + _SAME_SIZE) * min(sizes):
            yield LawFact(what=what, value=f"{np.median(sizes) / factor:.6g} {unit}", source=own)
    if fit.scatter is not None:
        yield LawFact(what=AMPLITUDE_SCATTER, value=f"{100 * fit.scatter:.3g} %", source=own)
    yield LawFact(what="number of specimens", value=str(len(specimens)), source=own)


def _remarks(
    specimens: Sequence[Specimen], drifts: Mapping[str, Drift | None], fit: LawFit | None, refusal: str
) -> Iterator[str]:
    count = len(specimens)
    if any(each.left_out for each in specimens):
        yield "the first cycle of every specimen is left out of all values; the law runs through it"
    if count < _FEWEST_SPECIMENS:
        known = "one specimen" if count == 1 else f"{count} specimens"
        yield f"{known}: intervals and quartiles hardly say how specimens differ; ISO 37 asks for three or more"
    ratios = [each.test.length / each.test.area for each in specimens]
    if max(ratios) > (1 + _SAME_SIZE) * min(ratios):
        yield "the specimens differ in size; the band of moduli in modulus.png is for their median"
    untold = [key.replace("_", " ") for key, drift in drifts.items() if drift is None]
    if untold:
        yield (
            f"the drift of {', '.join(untold)} cannot be told: that takes {_FEWEST_CYCLES} cycles in every specimen,"
            " each with a value that stands clear of 0"
        )
    yield from _fit_remarks(fit, refusal)
    rates = [each.strain_rate for each in specimens]
    one_rate = max(rates) <= _ONE_RATE * min(rates)
    if one_rate and fit and fit.form.damper and not any(each.form.branches for each in fit.candidates):
        yield "at one rate a Maxwell branch may fit as well as the damper; none was asked for, so none was tried"


def _fit_remarks(fit: LawFit | None, refusal: str) -> Iterator[str]:
    if fit is None:
        yield f"there is no law: {refusal}"
        return
    if fit.relative_misfit > _POOR_FIT:
        yield f"the law misses the data by {fit.relative_misfit:.0%} of the largest stress; see fit.png"
    if scaled(fit.law, length=1.0, area=1.0).must_push:
        yield (
            "a simulated tendon of this law pushes when it is slack, which a real one does not, and a design must allow"
            " that by tendon.pushes_when_slack; laws without yield and with linear viscosity only pull"
        )
    refused = [each.refused for each in fit.candidates if each.refused]
    # the one that names most values says it for all
    for what in ("apart", "viscosity.linear from"):
        reasons = [reason for reason in refused if "one rate only" in reason and what in reason]
        if reasons:
            yield max(reasons, key=len)
    if refused:
        yield f"{len(refused)} of {len(fit.candidates)} laws are refused; material.json says why for each"
