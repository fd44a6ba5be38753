"""An outcome as rows of text with units, for every table that shows it."""

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
from forficula.show.structure.drive_words import acting, drive_text
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

_ROUNDING = 1e-12  # of energies, by the largest
_LARGE = 0.05  # of the work or of what is stored: energies that hang in the books only are told from there on


@dataclass(frozen=True, kw_only=True)
class StateColumn:
    """What a table of states shows of every state.

    Attributes:
        title: such as "distal angle".
        unit: of the numbers.
    """

    title: str
    unit: str


@dataclass(frozen=True, kw_only=True)
class _Store:
    """What stores energy and has a row: its kind, the name of the row, and its energy in a state, J."""

    kind: str
    label: str
    energy: Callable[[StateValues], float]


@dataclass(frozen=True, kw_only=True)
class _Column:
    """A column of a table of states.

    Attributes:
        shown: its title and unit.
        labels: of its cells.
        cells: their texts in a state.
    """

    shown: StateColumn
    labels: list[str]
    cells: Callable[[State], list[str]]


@dataclass(frozen=True, kw_only=True)
class StateRows:
    """What states are: what is measured, tendons' lengths, energies of tendons and springs, by hinge and tendon.

    Attributes:
        heading: of the first column, such as "vein".
        columns: of each state.
        parts: the cells of all states by part, what it is called before them; empty where a part has no such number.
        summed: what the sums are of, such as "tendons"; empty where nothing stores energy.
        sums: the cells of all states for all of these together.
    """

    heading: str
    columns: tuple[StateColumn, ...]
    parts: list[list[str]]
    summed: str
    sums: list[str]


def state_rows(
    structure: Structure, states: Mapping[str, State], confirmation: Confirmation | None = None
) -> StateRows:
    """Lay out some states, of which there is one at least, in the same units.

    Every number has its numerical uncertainty behind ±. What is measured has half the range in which it still swings
    there, if that is larger.
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
    heading, places = parts_of(names), [{row: entry for entry, row in enumerate(each)} for each in rows_of]
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
    """Return the column of a measure: the mean, and how far it swings or is uncertain."""
    unit, factor = "deg", float(np.degrees(1.0))
    if measure.kind == "distance":
        unit, factor = reading_unit("m", max(float(state.readings[measure.name].mean[0]) for state in states.values()))
    digits = 1 if measure.kind == "angle" else 2

    def told(values: StateValues) -> Array:
        # an angle of a role that no measure watches has no reading
        own = values[measure.name] if measure.name in values else read_angles(measure, values["goal.coordinates"])
        return condensed(structure, measure, own)

    def cells(state: State) -> list[str]:
        own, halves = told(state.values), _halves(confirmation, state, told)
        if (reading := state.readings.get(measure.name)) is not None:
            high, low = (condensed(structure, measure, values) for values in (reading.high, reading.low))
            halves = np.fmax(halves, (high - low) / 2)
        return [
            _with_half(factor * float(mean), factor * float(half), digits)
            for mean, half in zip(own, halves, strict=True)
        ]

    return _Column(
        shown=StateColumn(title=title_of(measure), unit=unit), labels=reading_labels(structure, measure), cells=cells
    )


def _tendons(structure: Structure, states: Mapping[str, State], confirmation: Confirmation | None) -> _Column:
    """Return the column of the lengths of tendons."""
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
    """Return the column of what parts store, and the sum of every state."""

    def told(values: StateValues) -> list[float]:
        return [part.energy(values) for part in stores]

    def total(values: StateValues) -> float:
        return sum(told(values))

    largest = max(max(told(state.values)) for state in states.values())
    unit, factor = reading_unit("J", largest)

    def text(energy: float, half: float) -> str:
        return uncertain_number(factor * energy, factor * _sizeable(half, largest))

    def sizeable(state: State) -> list[float]:
        return [_sizeable(energy, largest) for energy in told(state.values)]

    def cells(state: State) -> list[str]:
        halves = _halves(confirmation, state, told).tolist()
        return [text(energy, half) for energy, half in zip(sizeable(state), halves, strict=True)]

    sums = [text(sum(sizeable(state)), float(_halves(confirmation, state, total))) for state in states.values()]
    labels = [part.label for part in stores]
    return _Column(shown=StateColumn(title="energy", unit=unit), labels=labels, cells=cells), sums


def _halves(confirmation: Confirmation | None, state: State, numbers: Callable[[StateValues], ArrayLike]) -> Array:
    """Return the numerical uncertainties of numbers of a state; zeros where no second run has them."""
    halves = None if confirmation is None else confirmation.of_state(state.name, numbers)
    return np.zeros(np.shape(numbers(state.values))) if halves is None else halves


def _with_half(mean: float, half: float, digits: int) -> str:
    """Write a mean to some decimal places, with its uncertainty where these decimal places show it."""
    return f"{_number(mean, digits)} ± {half:.{digits}f}" if half > 0.5 * 10.0**-digits else _number(mean, digits)


def _stores(structure: Structure) -> list[_Store]:
    """What stores energy: tendons, springs of hinges, of many all creases and all bends, couplings, and bars."""
    stores = [
        _Store(kind="tendons", label=label_of(tendon), energy=partial(_of_tendon, number))
        for number, tendon in enumerate(structure.tendons)
    ]
    springs = [number for number, hinge in enumerate(structure.hinges) if hinge.stiffness]
    groups = {kind: [each for each in group if each in springs] for kind, group in hinge_groups(structure).items()}
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
    """An energy, J; 0 where it is the rounding of the largest one."""
    return energy if abs(energy) > _ROUNDING * largest else 0.0


def _of_tendon(number: int, values: StateValues) -> float:
    return float(values["tendon.energy"][number])


def _of_hinges(hinges: Sequence[int], values: StateValues) -> float:
    return float(values["hinge.energy"][list(hinges)].sum()) if "hinge.energy" in values else 0.0


def _of_all(kind: str, values: StateValues) -> float:
    return float(values[f"{kind}.energy"].sum()) if f"{kind}.energy" in values else 0.0


def transition_headings(structure: Structure) -> tuple[str, ...]:
    """Of the columns of `transition_rows`."""
    kind = acting(structure)
    return ("", kind.removesuffix("s"), "succeeded", "time", f"work of the {kind}")


def transition_rows(structure: Structure, outcome: Outcome) -> list[list[str]]:
    """The transitions of a structure, under `transition_headings`."""
    return [
        [transition.wording.noun, *_transition_cells(structure, transition, outcome)]
        for transition in structure.transitions
    ]


def balance_remark(balance: EnergyBalance) -> str:
    """What two large numbers of a balance mean that no work was done for; empty where there are none."""
    taken, unpaid = balance.branch_damping, balance.letting_go
    if taken is None or unpaid is None or abs(unpaid) <= _LARGE * max(abs(balance.work), abs(balance.stored)):
        return ""
    return (
        "A Maxwell branch that would push lets go and acts on nothing, but is reckoned on as if it were held: of the"
        f" {show_value(taken, 'J', 3)} that branches take, {show_value(-unpaid, 'J', 3)} are such, which nobody paid"
        f" and the row of what gave way takes off again. Together they are {show_value(taken + unpaid, 'J', 3)}."
    )


def balance_rows(structure: Structure, balance: EnergyBalance) -> list[tuple[str, str]]:
    """An energy balance, term by term, in one unit, and what is missing as a share."""
    stored = (balance.tendon, balance.hinges or 0.0, balance.springs or 0.0, balance.couplings or 0.0)
    largest = max(abs(balance.work), *map(abs, stored), 1e-12)
    unit, factor = reading_unit("J", largest)
    tendons, sheets = bool(structure.tendons), bool(structure.membranes)
    spring = springs_name(structure).removesuffix("s")
    stretched = (("tendon", tendons), ("membrane", sheets), (spring, bool(structure.springs)))
    damped = listed(name for name, there in stretched if there)
    folds = listed(name.removesuffix("s") for name in hinge_groups(structure)) or "hinge"
    ties = any(coupling.rigid for coupling in structure.couplings)
    stops, contacts = ["stops", *["guard tendons"] * bool(structure.limits)], ["contacts"]
    # the engine tells only stops and limits apart from the rest
    (stops if structure.contact is None else contacts).extend(["rigid couplings"] * ties)
    terms = (
        (f"work of the {acting(structure)}", balance.work, True),
        ("= change of tendon energy", balance.tendon, tendons),
        ("+ change of membrane energy", balance.membrane, sheets),
        (f"+ change of {folds} energy", balance.hinges, True),
        (f"+ change of {spring} energy", balance.springs, True),
        ("+ change of coupling energy", balance.couplings, True),
        ("+ change of kinetic energy", balance.kinetic, True),
        ("+ change of gravitational energy", balance.gravitational, True),
        (f"+ taken by {folds} damping", balance.hinge_damping, True),
        (f"+ taken by dry friction of {folds}s", balance.friction, True),
        (f"+ taken by {damped} damping", balance.elastic_damping, bool(damped)),
        (f"+ taken by {listed(stops)}", balance.stops, True),
        (f"+ taken by {listed(contacts)}", balance.contacts, True),
        ("+ taken by drag of the medium", balance.drag, True),
        ("+ change of energy of the Maxwell branches", balance.branches, True),
        ("+ taken by the Maxwell branches", balance.branch_damping, True),
        ("+ taken by yielding", balance.yielding, True),
        ("+ stored by branches that gave way, unpaid", balance.letting_go, True),
        ("+ missing", balance.missing, True),
    )
    told = [(label, value) for label, value, there in terms if there and value is not None]
    # what the work is the sum of begins with "=", whatever comes first
    told[1] = (f"={told[1][0][1:]}", told[1][1])
    # adding 0 turns -0 into 0
    rows = [(label, f"{round(factor * value, 4) + 0.0:.4f} {unit}") for label, value in told]
    return [*rows, ("residual", f"{100 * balance.residual:.3f} % of what was exchanged")]


def state_angles(state: State, measure: Measure) -> Array:
    """Mean readings of a measure of angles in a state, rad, (reading,)."""
    return read_angles(measure, state.coordinates)


def _number(value: float, digits: int) -> str:
    return f"{round(value, digits) + 0.0:.{digits}f}"  # adding 0 turns -0 into 0


def _transition_cells(structure: Structure, transition: Transition, outcome: Outcome) -> list[str]:
    """A transition in words and units, its numbers with their uncertainties where second runs tell these."""
    found, name = outcome.transitions[transition.name], transition.name
    if found is None:
        return ["not tried", "", "", ""]
    time = "" if found.time is None else _sure(outcome.confirmation, f"{name}.time", found.time, "s")
    strength = drive_text(structure, drive_of(structure, transition.drive), found.strength)
    if found.largest_force is not None:
        strength += f", takes {show_value(found.largest_force, 'N')}"
    undecided = outcome.verdict is Verdict.UNDECIDED and outcome.holds[transition.state] is None
    succeeded = "undecided" if undecided else "yes" if found.succeeded else "no"
    return [strength, succeeded, time, _sure(outcome.confirmation, f"{name}.work", found.work, "J")]


def _sure(confirmation: Confirmation | None, name: str, value: float, unit: str) -> str:
    """A value of an outcome with its uncertainty, marked where that is large."""
    if confirmation is None:
        return show_value(value, unit)
    mark = " (not settled)" * (name in confirmation.unsettled)
    return f"{show_uncertain(value, confirmation.of(name), unit)}{mark}"
