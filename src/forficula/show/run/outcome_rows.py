"""An outcome as rows of text with units, for every table that shows the outcome."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import ArrayLike

from forficula.analysis import Outcome, State, Verdict
from forficula.analysis.confirmation import Confirmation, StateValues
from forficula.arrays import Array
from forficula.dynamics import EnergyBalance
from forficula.names import listed
from forficula.quantities import reading_unit, show_uncertain, show_value, uncertain_number
from forficula.show.structure.drive_labels import acting, drive_text
from forficula.show.structure.labels import (
    MOST_TOLD,
    aligned,
    condensed,
    label_of,
    parts_of,
    reading_labels,
    shown_angles,
    shown_distances,
    title_of,
)
from forficula.structure import Measure, Structure, Transition, drive_of, hinge_groups, read_angles, springs_name

_ROUNDING = 1e-12  # share of the largest energy up to which an energy is rounding error
_LARGE = 0.05  # share of the work or of the stored energy from which energies without work are explained


@dataclass(frozen=True, kw_only=True)
class StateColumn:
    """Column of a table of states.

    Attributes:
        title: title, such as "distal angle".
        unit: unit of the numbers.
    """

    title: str
    unit: str


@dataclass(frozen=True, kw_only=True)
class _Store:
    """Part that stores energy: its kind, the name of its row, and its energy in a state, J."""

    kind: str
    label: str
    energy: Callable[[StateValues], float]


@dataclass(frozen=True, kw_only=True)
class _Column:
    """Contents of a column of a table of states.

    Attributes:
        shown: title and unit.
        labels: names of its cells.
        cells: returns the texts of the cells in a state.
    """

    shown: StateColumn
    labels: list[str]
    cells: Callable[[State], list[str]]


@dataclass(frozen=True, kw_only=True)
class StateRows:
    """Table of states: measures, lengths of tendons, energies of tendons and springs, by hinge and tendon.

    Attributes:
        heading: heading of the first column, such as "vein".
        columns: columns for each state.
        parts: one row for each part: its name, then the cells of all states; empty if the part lacks the number.
        summed: noun for the summed parts, such as "tendons"; empty if no part stores energy.
        sums: cells of all states with the sums over these parts.
    """

    heading: str
    columns: tuple[StateColumn, ...]
    parts: list[list[str]]
    summed: str
    sums: list[str]


def state_rows(
    structure: Structure, states: Mapping[str, State], confirmation: Confirmation | None = None
) -> StateRows:
    """Lay out at least one state, with the same units for all states.

    Every number has its numerical uncertainty after ±. A measure has half the range in which it still moves,
    if that is larger.
    """
    columns = [
        _measured(structure, measure, states, confirmation)
        for measure in (*shown_angles(structure), *shown_distances(structure))
    ]
    sums: list[str] = []
    if structure.tendons:
        columns.append(_tendons(structure, states, confirmation))
    if stores := _stores(structure):
        stored, totals = _stored(stores, states, confirmation)
        before = [""] * len(columns)
        columns.append(stored)
        sums = [cell for total in totals for cell in (*before, total)]
    names, rows_of = aligned([column.labels for column in columns])
    heading, places = parts_of(names), [{row: entry for entry, row in enumerate(item)} for item in rows_of]
    cells = [[column.cells(state) for column in columns] for state in states.values()]
    rows = []
    for row, name in enumerate(heading.names):
        shown = [
            texts[place[row]] if row in place else ""
            for of_state in cells
            for texts, place in zip(of_state, places, strict=True)
        ]
        rows.append([name, *shown])
    summed = listed(dict.fromkeys(part.kind for part in stores))
    return StateRows(
        heading=heading.heading,
        columns=tuple(column.shown for column in columns),
        parts=rows,
        summed=summed,
        sums=sums,
    )


def _measured(
    structure: Structure, measure: Measure, states: Mapping[str, State], confirmation: Confirmation | None
) -> _Column:
    """Return the column of a measure: the mean, and the larger of its half range and its uncertainty."""
    unit, factor = "deg", float(np.degrees(1.0))
    if measure.kind == "distance":
        unit, factor = reading_unit("m", max(float(state.readings[measure.name].mean[0]) for state in states.values()))
    digits = 1 if measure.kind == "angle" else 2

    def readings_of(values: StateValues) -> Array:
        # the angle of a role without a measure has no reading
        readings = values[measure.name] if measure.name in values else read_angles(measure, values["goal.coordinates"])
        return condensed(structure, measure, readings)

    def cells(state: State) -> list[str]:
        means, halves = readings_of(state.values), _halves(confirmation, state, readings_of)
        if (reading := state.readings.get(measure.name)) is not None:
            high, low = (condensed(structure, measure, values) for values in (reading.high, reading.low))
            halves = np.fmax(halves, (high - low) / 2)
        return [
            _with_half(factor * float(mean), factor * float(half), digits)
            for mean, half in zip(means, halves, strict=True)
        ]

    return _Column(
        shown=StateColumn(title=title_of(measure), unit=unit), labels=reading_labels(structure, measure), cells=cells
    )


def _tendons(structure: Structure, states: Mapping[str, State], confirmation: Confirmation | None) -> _Column:
    """Return the column of tendon lengths."""
    unit, factor = reading_unit("m", max(float(state.tendon_length.max()) for state in states.values()))

    def cells(state: State) -> list[str]:
        halves = _halves(confirmation, state, lambda values: values["tendon.length"])
        return [
            _with_half(factor * float(length), factor * float(half), 2)
            for length, half in zip(state.tendon_length, halves, strict=True)
        ]

    labels = [label_of(tendon) for tendon in structure.tendons]
    return _Column(shown=StateColumn(title="tendon", unit=unit), labels=labels, cells=cells)


def _stored(
    stores: Sequence[_Store], states: Mapping[str, State], confirmation: Confirmation | None
) -> tuple[_Column, list[str]]:
    """Return the column of stored energies, and the sum of every state."""

    def energies(values: StateValues) -> list[float]:
        return [part.energy(values) for part in stores]

    def total(values: StateValues) -> float:
        return sum(energies(values))

    largest = max(max(energies(state.values)) for state in states.values())
    unit, factor = reading_unit("J", largest)

    def text(energy: float, half: float) -> str:
        return uncertain_number(factor * energy, factor * _sizeable(half, largest))

    def sizeable(state: State) -> list[float]:
        return [_sizeable(energy, largest) for energy in energies(state.values)]

    def cells(state: State) -> list[str]:
        halves = _halves(confirmation, state, energies).tolist()
        return [text(energy, half) for energy, half in zip(sizeable(state), halves, strict=True)]

    sums = [text(sum(sizeable(state)), float(_halves(confirmation, state, total))) for state in states.values()]
    labels = [part.label for part in stores]
    return _Column(shown=StateColumn(title="energy", unit=unit), labels=labels, cells=cells), sums


def _halves(confirmation: Confirmation | None, state: State, numbers: Callable[[StateValues], ArrayLike]) -> Array:
    """Return the numerical uncertainties of numbers of a state; zeros without a second run."""
    halves = None if confirmation is None else confirmation.of_state(state.name, numbers)
    return np.zeros(np.shape(numbers(state.values))) if halves is None else halves


def _with_half(mean: float, half: float, digits: int) -> str:
    """Return a mean with some decimal places, with its uncertainty if these decimals show it."""
    return f"{_number(mean, digits)} ± {half:.{digits}f}" if half > 0.5 * 10.0**-digits else _number(mean, digits)


def _stores(structure: Structure) -> list[_Store]:
    """Return the parts that store energy: tendons, springs of hinges (grouped if there are many), couplings, bars."""
    stores = [
        _Store(kind="tendons", label=label_of(tendon), energy=partial(_of_tendon, number))
        for number, tendon in enumerate(structure.tendons)
    ]
    springs = [number for number, hinge in enumerate(structure.hinges) if hinge.stiffness]
    groups = {kind: [item for item in group if item in springs] for kind, group in hinge_groups(structure).items()}
    if len(springs) > MOST_TOLD and "creases" in groups:
        stores += [
            _Store(kind=kind, label=kind, energy=partial(_of_hinges, group)) for kind, group in groups.items() if group
        ]
    else:
        stores += [
            _Store(kind="springs", label=label_of(structure.hinges[hinge]), energy=partial(_of_hinges, [hinge]))
            for hinge in springs
        ]
    if any(not coupling.rigid for coupling in structure.couplings):
        stores.append(_Store(kind="couplings", label="couplings", energy=partial(_of_all, "coupling")))
    if structure.springs:
        stores.append(
            _Store(kind=springs_name(structure), label=springs_name(structure), energy=partial(_of_all, "spring"))
        )
    return stores


def _sizeable(energy: float, largest: float) -> float:
    """Return an energy, J; 0 if it is rounding error of the largest one."""
    return energy if abs(energy) > _ROUNDING * largest else 0.0


def _of_tendon(number: int, values: StateValues) -> float:
    return float(values["tendon.energy"][number])


def _of_hinges(hinges: Sequence[int], values: StateValues) -> float:
    return float(values["hinge.energy"][list(hinges)].sum()) if "hinge.energy" in values else 0.0


def _of_all(kind: str, values: StateValues) -> float:
    return float(values[f"{kind}.energy"].sum()) if f"{kind}.energy" in values else 0.0


def transition_headings(structure: Structure) -> tuple[str, ...]:
    """Return the headings of `transition_rows`."""
    kind = acting(structure)
    return ("", kind.removesuffix("s"), "succeeded", "time", f"work of the {kind}")


def transition_rows(structure: Structure, outcome: Outcome) -> list[list[str]]:
    """Return the transitions of a structure as rows, with the columns of `transition_headings`."""
    return [
        [transition.wording.noun, *_transition_cells(structure, transition, outcome)]
        for transition in structure.transitions
    ]


def balance_remark(balance: EnergyBalance) -> str:
    """Explain two large numbers of a balance for which no work was done; empty if there are none."""
    taken, unpaid = balance.branch_damping, balance.letting_go
    if taken is None or unpaid is None or abs(unpaid) <= _LARGE * max(abs(balance.work), abs(balance.stored)):
        return ""
    return (
        "A Maxwell branch that would push goes slack and exerts no force, but the energy balance treats it as held. Of"
        f" the {show_value(taken, 'J', 3)} dissipated by branches, {show_value(-unpaid, 'J', 3)} belong to slack"
        " branches; no work was done for them, so the row of branches that gave way subtracts them. The sum is"
        f" {show_value(taken + unpaid, 'J', 3)}."
    )


def quasi_static_text(structure: Structure, outcome: Outcome) -> str:
    """Return which stages of a run were quasi-static, and where they lost their equilibrium; empty if none was."""
    parts = []
    for number, stage in enumerate(outcome.stages):
        if stage.share is None:
            continue
        text = f'"{stage.name}" ended at {_grown_text(structure, outcome, number, stage.share)}'
        if stage.lost:
            lost = listed(_grown_text(structure, outcome, number, share) for share in stage.lost)
            text = f"{text} and lost its equilibrium at {lost}, followed by motion to rest"
        parts.append(text)
    return f"Quasi-static stages, computed by statics: {'; '.join(parts)}." if parts else ""


def _grown_text(structure: Structure, outcome: Outcome, number: int, share: float) -> str:
    """Return how far the drive of a quasi-static stage has grown at a share of the stage."""
    stage, before = outcome.stages[number], outcome.stages[:number][-1:]
    # a stage that continues another one does not grow from 0
    if len(stage.drive) != 1 or any(earlier.share is not None for earlier in before):
        return f"{show_value(100 * share, '%', 4)} of the change of its drives"
    drive = drive_of(structure, stage.drive[0])
    return drive_text(structure, drive, share * drive.strength)


def balance_rows(structure: Structure, balance: EnergyBalance) -> list[tuple[str, str]]:
    """Return an energy balance, term by term in one unit, and the residual as a share."""
    tendons, sheets = bool(structure.tendons), bool(structure.membranes)
    spring = springs_name(structure).removesuffix("s")
    stretched = (("tendon", tendons), ("membrane", sheets), (spring, bool(structure.springs)))
    damped = listed(name for name, exists in stretched if exists)
    folds = listed(name.removesuffix("s") for name in hinge_groups(structure)) or "hinge"
    ties = any(coupling.rigid for coupling in structure.couplings)
    stops, contacts = ["stops", *["guard tendons"] * bool(structure.limits)], ["contacts"]
    # the engine separates only stops and limits from other constraints
    (contacts if structure.has_contacts else stops).extend(["rigid couplings"] * ties)
    terms = (
        (f"work of the {acting(structure)}", balance.work, True),
        ("= change of tendon energy", balance.tendon, tendons),
        ("+ change of membrane energy", balance.membrane, sheets),
        (f"+ change of {folds} energy", balance.hinges, True),
        (f"+ change of {spring} energy", balance.springs, True),
        ("+ change of coupling energy", balance.couplings, True),
        ("+ change of energy of friction springs", balance.friction_springs, True),
        ("+ change of kinetic energy", balance.kinetic, True),
        ("+ change of gravitational energy", balance.gravitational, True),
        (f"+ dissipated by {folds} damping", balance.hinge_damping, True),
        (f"+ dissipated by dry friction of {folds}s", balance.friction, True),
        (f"+ dissipated by {damped} damping", balance.elastic_damping, bool(damped)),
        (f"+ dissipated by {listed(stops)}", balance.stops, True),
        (f"+ dissipated by {listed(contacts)}", balance.contacts, True),
        ("+ dissipated by drag of the medium", balance.drag, True),
        ("+ change of energy of the Maxwell branches", balance.branches, True),
        ("+ dissipated by the Maxwell branches", balance.branch_damping, True),
        ("+ dissipated by yielding", balance.yielding, True),
        ("+ dissipated by yielding creases", balance.crease_yielding, True),
        ("+ dissipated by the Maxwell branches of creases", balance.crease_branches, True),
        ("+ dissipated by wear of creases", balance.crease_damage, True),
        ("+ stored by branches that gave way, without work", balance.letting_go, True),
        ("+ missing", balance.missing, True),
    )
    present = [(label, value) for label, value, exists in terms if exists and value is not None]
    unit, factor = reading_unit("J", max(1e-12, *(abs(value) for _, value in present)))
    # the first term of the sum begins with "="
    present[1] = (f"={present[1][0][1:]}", present[1][1])
    # adding 0 turns -0 into 0
    rows = [(label, f"{round(factor * value, 4) + 0.0:.4f} {unit}") for label, value in present]
    return [*rows, ("residual", f"{100 * balance.residual:.3f} % of the energy exchanged")]


def state_angles(state: State, measure: Measure) -> Array:
    """Return the mean readings of a measure of angles in a state, rad, (reading,)."""
    return read_angles(measure, state.coordinates)


def _number(value: float, digits: int) -> str:
    return f"{round(value, digits) + 0.0:.{digits}f}"  # adding 0 turns -0 into 0


def _transition_cells(structure: Structure, transition: Transition, outcome: Outcome) -> list[str]:
    """Return the cells of a transition, with numerical uncertainties if there are second runs."""
    result, name = outcome.transitions[transition.name], transition.name
    if result is None:
        return ["not tried", "", "", ""]
    time = "" if result.time is None else _sure(outcome.confirmation, f"{name}.time", result.time, "s")
    strength = drive_text(structure, drive_of(structure, transition.drive), result.strength)
    if result.largest_force is not None:
        strength += f", requires {show_value(result.largest_force, 'N')}"
    number = transition.stage
    if number is not None and (share := outcome.stages[number].share) is not None:
        strength += f", ended at {_grown_text(structure, outcome, number, share)}"
    undecided = outcome.verdict is Verdict.UNDECIDED and outcome.holds[transition.state] is None
    succeeded = "undecided" if undecided else "yes" if result.succeeded else "no"
    return [strength, succeeded, time, _sure(outcome.confirmation, f"{name}.work", result.work, "J")]


def _sure(confirmation: Confirmation | None, name: str, value: float, unit: str) -> str:
    """Return a value of an outcome with its uncertainty, marked if that is large."""
    if confirmation is None:
        return show_value(value, unit)
    mark = " (not converged)" * (name in confirmation.unsettled)
    return f"{show_uncertain(value, confirmation.of(name), unit)}{mark}"
