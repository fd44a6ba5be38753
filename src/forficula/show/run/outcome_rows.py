"""An outcome as rows of text with units, for every table that shows it."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from forficula.analysis import Outcome, State, TransitionOutcome
from forficula.dynamics import EnergyBalance
from forficula.names import listed
from forficula.quantities import reading_unit, show_value
from forficula.show.structure.labels import (
    aligned,
    label_of,
    measure_labels,
    parts_of,
    shown_angles,
    shown_distances,
    title_of,
)
from forficula.structure import Measure, Structure

TRANSITION_HEADINGS = ("", "torque", "succeeded", "time", "work of the torques")


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


def state_rows(structure: Structure, states: Mapping[str, State]) -> StateRows:
    """Lay out some states, of which there is one at least, in the same units."""
    columns: list[StateColumn] = []
    cells: list[tuple[list[str], Callable[[State, int], str]]] = []
    for measure in (*shown_angles(structure), *shown_distances(structure)):
        unit, factor = "deg", float(np.degrees(1.0))
        if measure.kind == "distance":
            largest = max(float(state.readings[measure.name].mean[0]) for state in states.values())
            unit, factor = reading_unit("m", largest)
        columns.append(StateColumn(title=title_of(measure), unit=unit))
        cells.append((measure_labels(structure, measure), _reading_cell(measure, factor)))
    tendons, sums = [label_of(tendon) for tendon in structure.tendons], []
    if tendons:
        length_unit, length = reading_unit("m", max(float(state.tendon_length.max()) for state in states.values()))
        columns.append(StateColumn(title="tendon", unit=length_unit))
        cells.append((tendons, lambda state, tendon: f"{length * state.tendon_length[tendon]:.2f}"))
    springs = [number for number, hinge in enumerate(structure.hinges) if hinge.stiffness]
    if tendons or springs:
        stored = {state.name: _stored(state, springs) for state in states.values()}
        energy_unit, energy = reading_unit("J", max(float(each.max()) for each in stored.values()))
        columns.append(StateColumn(title="energy", unit=energy_unit))
        labels = [*tendons, *(label_of(structure.hinges[hinge]) for hinge in springs)]
        cells.append((labels, lambda state, part: f"{energy * stored[state.name][part]:.4g}"))
        before = [""] * (len(columns) - 1)
        sums = [cell for each in stored.values() for cell in (*before, f"{energy * each.sum():.4g}")]
    names, rows_of = aligned([entries for entries, _ in cells])
    heading, places = parts_of(names), [{row: entry for entry, row in enumerate(each)} for each in rows_of]
    rows = []
    for row, name in enumerate(heading.names):
        shown = [
            cell(state, place[row]) if row in place else ""
            for state in states.values()
            for (_, cell), place in zip(cells, places, strict=True)
        ]
        rows.append([name, *shown])
    summed = " and ".join(name for name, there in (("tendons", tendons), ("springs", springs)) if there)
    return StateRows(heading=heading.heading, columns=tuple(columns), parts=rows, summed=summed, sums=sums)


def _stored(state: State, springs: Sequence[int]) -> NDArray[np.float64]:
    """Energy of the tendons, and of the springs of some hinges, J, (part,)."""
    if state.hinge_energy is None:
        return state.tendon_energy
    return np.concatenate([state.tendon_energy, state.hinge_energy[list(springs)]])


def transition_rows(structure: Structure, outcome: Outcome) -> list[list[str]]:
    """The transitions of a structure, under `TRANSITION_HEADINGS`."""
    return [
        [transition.wording.noun, *_transition_cells(outcome.transitions[transition.name])]
        for transition in structure.transitions
    ]


def balance_rows(structure: Structure, balance: EnergyBalance) -> list[tuple[str, str]]:
    """An energy balance, term by term, in one unit, and what is missing as a share."""
    largest = max(abs(balance.work), abs(balance.tendon), abs(balance.hinges or 0.0), 1e-12)
    unit, factor = reading_unit("J", largest)
    tendons, sheets, bars = (bool(each) for each in (structure.tendons, structure.membranes, structure.bars))
    damped = " and ".join(name for name, there in (("tendon", tendons), ("membrane", sheets)) if there)
    stops = ["stops", *["guard tendons"] * bool(structure.limits), *["contacts"] * bars]
    terms = (
        ("work of the torques", balance.work, True),
        ("= change of tendon energy", balance.tendon, tendons),
        ("+ change of membrane energy", balance.membrane, sheets),
        ("+ change of hinge energy", balance.hinges, True),
        ("+ change of kinetic energy", balance.kinetic, True),
        ("+ change of gravitational energy", balance.gravitational, True),
        ("+ taken by hinge damping", balance.hinge_damping, True),
        (f"+ taken by {damped} damping", balance.elastic_damping, bool(damped)),
        (f"+ taken by {listed(stops)}", balance.stops, True),
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


def _reading_cell(measure: Measure, factor: float) -> Callable[[State, int], str]:
    """Writes what a measure reads in a state: the mean, and half the envelope where it still swings."""
    digits, least = (1, 0.05) if measure.kind == "angle" else (2, 0.005)

    def cell(state: State, entry: int) -> str:
        reading = state.readings.get(measure.name)
        if reading is None:  # of a role that no measure watches
            return _number(factor * float(state_angles(state, measure)[entry]), digits)
        mean = _number(factor * float(reading.mean[entry]), digits)
        swing = factor * float(reading.high[entry] - reading.low[entry]) / 2
        return f"{mean} ± {swing:.{digits}f}" if swing > least else mean

    return cell


def state_angles(state: State, measure: Measure) -> NDArray[np.float64]:
    """Mean angles of a measure's hinges in a state, rad, (hinge,)."""
    return np.asarray(np.array(measure.signs) * state.coordinates[list(measure.hinges)])


def _number(value: float, digits: int) -> str:
    return f"{round(value, digits) + 0.0:.{digits}f}"  # adding 0 turns -0 into 0


def _transition_cells(transition: TransitionOutcome | None) -> list[str]:
    """A transition in words and units."""
    if transition is None:
        return ["not tried", "", "", ""]
    time = "" if transition.time is None else show_value(transition.time, "s")
    torque, work = show_value(transition.torque, "N m"), show_value(transition.work, "J")
    return [torque, "yes" if transition.succeeded else "no", time, work]
