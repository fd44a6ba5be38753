"""What a run came to, in tables of a page."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from forficula.analysis import Outcome, State, Verdict
from forficula.analysis.groups import dominance, groups_of, measured_by
from forficula.dynamics import Record
from forficula.quantities import reading_unit, uncertain_number
from forficula.show.page.parts.html import Cell, paragraph, table
from forficula.show.page.parts.words import readable
from forficula.show.run.outcome_rows import (
    balance_remark,
    balance_rows,
    state_rows,
    transition_headings,
    transition_rows,
)
from forficula.show.run.state_names import states_reached
from forficula.show.run.strength_rows import STRENGTH_HEADINGS, strength_rows
from forficula.structure import Structure

_NUMBERS = {1: "one", 2: "two", 3: "three"}


def outcome_tables(outcome: Outcome) -> list[str]:
    """States by hinge and tendon, transitions, and the energy balance, as HTML."""
    structure = outcome.structure
    return [_states(outcome, structure), _transitions(outcome, structure), _balance(outcome, structure)]


def strength_table(record: Record) -> str:
    """The largest strains, stresses and folds of a run, as HTML; nothing of what has none."""
    rows = strength_rows(record)
    return table("Largest strains and folds", STRENGTH_HEADINGS, _signed(rows)) if rows else ""


def groups_table(record: Record) -> str:
    """The dimensionless groups of a run and what dominates, as HTML; nothing of what has none."""
    groups = groups_of(record.structure, record.design.protocol.timestep)
    if groups is None or not groups.every:
        return ""
    scale = groups.scale
    by = f"Moments are by {readable(scale.moment, 'N m')}, {measured_by(scale)}"
    time = f"; times by t* = {readable(scale.time, 's')}, in which it moves what turns there" if scale.time else ""
    rows: list[tuple[str | Cell, ...]] = [
        (Cell(text=each.label, note=each.name), f"{each.value:.3g}", each.meaning) for each in groups.every
    ]
    words = paragraph(f"{dominance(groups)} {by}{time}.")
    return words + table("Dimensionless groups", ("", "value", "compares"), rows, numbers=False)


def _states(outcome: Outcome, structure: Structure) -> str:
    """What is measured in the states, and their tendons, by hinge and tendon."""
    there = states_reached(structure, outcome)
    if not there:
        count = len(structure.states)
        return paragraph(f"None of the {_NUMBERS.get(count, count)} states was reached.") if count else ""
    rows = state_rows(structure, there, outcome.confirmation)
    groups = [("", 1), *((_at(name, state), len(rows.columns)) for name, state in there.items())]
    if not rows.columns:
        return paragraph(f"States: {'; '.join(name for name, _ in groups[1:])}.")
    headings = [rows.heading, *(f"{each.title} ({each.unit})" for _ in there for each in rows.columns)]
    body = _signed(rows.parts)
    before = [""] * (len(rows.columns) - 1)
    if rows.sums:
        body.append([f"all {rows.summed}", *rows.sums])
    if structure.membranes:
        energies = (_membrane(outcome, state) for state in there.values())
        body.append(["membrane", *(cell for energy in energies for cell in (*before, energy))])
    return table("States", headings, body, groups=groups)


def _signed(rows: Iterable[Sequence[str]]) -> list[list[str]]:
    """Rows whose numbers have the sign that is set before numbers; what a row is of keeps its hyphens."""
    return [[of, *(cell.replace("-", "−") for cell in cells)] for of, *cells in rows]


def _at(name: str, state: State) -> str:
    return f"{name}, at {readable(state.time, 's')}"


def _membrane(outcome: Outcome, state: State) -> str:
    """Write a membrane's energy with its own unit: it is a thousandth of the tendons' or less."""
    if math.isnan(state.membrane_energy):
        return ""
    found = outcome.confirmation
    half = None if found is None else found.of_state(state.name, lambda values: values["membrane.energy"][0])
    unit, factor = reading_unit("J", abs(state.membrane_energy))
    number = uncertain_number(factor * state.membrane_energy, 0.0 if half is None else factor * float(half))
    return f"{number} {unit}".replace("-", "−")


def _transitions(outcome: Outcome, structure: Structure) -> str:
    if not structure.transitions:
        return ""
    caption = " and ".join(transition.wording.noun for transition in structure.transitions)
    rows = _signed(transition_rows(structure, outcome))
    return table(f"{caption[:1].upper()}{caption[1:]}", transition_headings(structure), rows)


def _balance(outcome: Outcome, structure: Structure) -> str:
    balance = outcome.energy_balance
    if outcome.verdict is Verdict.DIVERGED or not balance.residual <= 1:
        return paragraph("The energy balance does not close; the numbers mean nothing.")
    rows = [(label, value.replace("-", "−")) for label, value in balance_rows(structure, balance)]
    remark = balance_remark(balance)
    return table("Energy balance", ("", ""), rows) + (paragraph(remark) if remark else "")
