"""Tables of a page with the outcome of a run."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from forficula.analysis import Outcome, State, Verdict
from forficula.analysis.groups import dominance, groups_of, measured_by
from forficula.dynamics import Record
from forficula.quantities import reading_unit, uncertain_number
from forficula.show.page.parts.html import Cell, abreast, paragraph, table
from forficula.show.page.parts.run_sentences import readable
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

_BALANCE_WIDTH = 24  # letters
_NUMBERS = {1: "one", 2: "two", 3: "three"}


def outcome_tables(outcome: Outcome) -> list[str]:
    """Return the HTML tables of states by hinge and tendon, transitions, and the energy balance."""
    structure = outcome.structure
    return [
        _states(outcome, structure),
        abreast([_transitions(outcome, structure), _balance(outcome, structure)], _BALANCE_WIDTH),
    ]


def strength_table(record: Record) -> str:
    """Return the HTML table of the largest strains, stresses and folds of a run; empty without such values."""
    rows = strength_rows(record)
    return table("Largest strains and folds", STRENGTH_HEADINGS, _signed(rows)) if rows else ""


def groups_table(record: Record) -> str:
    """Return the HTML of the dimensionless groups of a run and what dominates; empty without groups."""
    groups = groups_of(record.structure, record.design.protocol.timestep)
    if groups is None or not groups.every:
        return ""
    scale = groups.scale
    by = f"Moments are divided by {readable(scale.moment, 'N m')}, {measured_by(scale)}"
    time = (
        f"; times are divided by t* = {readable(scale.time, 's')}, in which this moment turns the parts that it moves"
        if scale.time
        else ""
    )
    rows: list[tuple[str | Cell, ...]] = [
        (Cell(text=item.label, note=item.name), f"{item.value:.3g}", item.meaning) for item in groups.every
    ]
    words = paragraph(f"{dominance(groups)} {by}{time}.")
    return words + table("Dimensionless groups", ("", "value", "compares"), rows, numbers=False)


def _states(outcome: Outcome, structure: Structure) -> str:
    """Return a table for each state: measures and tendons, one row for each hinge and tendon."""
    reached = states_reached(structure, outcome)
    if not reached:
        count = len(structure.states)
        return paragraph(f"None of the {_NUMBERS.get(count, count)} states was reached.") if count else ""
    rows = state_rows(structure, reached, outcome.confirmation)
    width = len(rows.columns)
    if not width:
        return paragraph(f"States: {'; '.join(_state_heading(name, state) for name, state in reached.items())}.")
    headings = [rows.heading, *(f"{column.title} ({column.unit})" for column in rows.columns)]
    body = _signed(rows.parts)
    if rows.sums:
        body.append([f"all {rows.summed}", *rows.sums])
    tables = []
    for number, (name, state) in enumerate(reached.items()):
        first = 1 + number * width
        cells = [[row[0], *row[first : first + width]] for row in body]
        if structure.membranes:
            cells.append(["membrane", *[""] * (width - 1), _membrane(outcome, state)])
        tables.append(table(f"State {_state_heading(name, state)}", headings, cells))
    return abreast(tables, 6 + 5 * width)


def _signed(rows: Iterable[Sequence[str]]) -> list[list[str]]:
    """Replace the hyphens of negative numbers by minus signs; the first cell, a name, keeps its hyphens."""
    return [[of, *(cell.replace("-", "−") for cell in cells)] for of, *cells in rows]


def _state_heading(name: str, state: State) -> str:
    return f"{name}, at {readable(state.time, 's')}"


def _membrane(outcome: Outcome, state: State) -> str:
    """Return a membrane's energy in a unit of its own: at most a thousandth of the tendons' energy."""
    if math.isnan(state.membrane_energy):
        return ""
    confirmation = outcome.confirmation
    half = (
        None if confirmation is None else confirmation.of_state(state.name, lambda values: values["membrane.energy"][0])
    )
    unit, factor = reading_unit("J", abs(state.membrane_energy))
    number = uncertain_number(factor * state.membrane_energy, 0.0 if half is None else factor * float(half))
    return f"{number} {unit}".replace("-", "−")


def _transitions(outcome: Outcome, structure: Structure) -> str:
    if not structure.transitions:
        return ""
    caption = " and ".join(transition.wording.noun for transition in structure.transitions)
    columns = _signed([transition_headings(structure), *transition_rows(structure, outcome)])
    # one column for each transition, so that the table is narrow enough for a phone
    headings, *rows = zip(*columns, strict=True)
    return table(f"{caption[:1].upper()}{caption[1:]}", headings, rows)


def _balance(outcome: Outcome, structure: Structure) -> str:
    balance = outcome.energy_balance
    if outcome.verdict is Verdict.DIVERGED or not balance.residual <= 1:
        return paragraph("The energy balance does not close, so the numbers of this run are meaningless.")
    rows = [_term(label, value.replace("-", "−")) for label, value in balance_rows(structure, balance)]
    remark = balance_remark(balance)
    return table("Energy balance", ("", ""), rows) + (paragraph(remark) if remark else "")


def _term(label: str, value: str) -> tuple[str, str | Cell]:
    """Return a row of the balance, with the meaning of a share below its value."""
    share, _, whole = value.partition(" of ")
    return label, Cell(text=share, note=f"of {whole}") if whole else value
