"""What a run came to, in tables of a page."""

from __future__ import annotations

import math

from forficula.analysis import Outcome, State, Verdict
from forficula.show.page.html import paragraph, table
from forficula.show.page.words import readable
from forficula.show.run.outcome_rows import (
    TRANSITION_HEADINGS,
    balance_rows,
    state_rows,
    states_reached,
    transition_rows,
)


def outcome_tables(outcome: Outcome) -> list[str]:
    """States by vein, folding and unfolding, and the energy balance, as HTML."""
    return [_states(outcome), _transitions(outcome), _balance(outcome)]


def _states(outcome: Outcome) -> str:
    """Angles, tendons and energies of the states, by vein."""
    there = states_reached(outcome)
    if not there:
        return paragraph("None of the three states was reached.")
    rows = state_rows(there)
    groups, headings = [("", 1)], ["vein"]
    for name, state in there.items():
        groups.append((f"{name}, at {readable(state.time, 's')}", 3))
        headings += ["distal angle (deg)", f"tendon ({rows.length_unit})", f"energy ({rows.energy_unit})"]
    veins = [[cell.replace("-", "−") for cell in row] for row in rows.veins]
    membranes = [cell for state in there.values() for cell in ("", "", _membrane(state))]
    body = [*veins, ["all tendons", *rows.sums], ["membrane", *membranes]]
    return table("States", headings, body, groups=groups)


def _membrane(state: State) -> str:
    """A membrane's energy with its own unit: it is a thousandth of the tendons' or less."""
    return "" if math.isnan(state.membrane_energy) else readable(state.membrane_energy, "J")


def _transitions(outcome: Outcome) -> str:
    return table("Folding and unfolding", TRANSITION_HEADINGS, transition_rows(outcome))


def _balance(outcome: Outcome) -> str:
    balance = outcome.energy_balance
    if outcome.verdict is Verdict.DIVERGED or not balance.residual <= 1:
        return paragraph("The energy balance does not close; the numbers mean nothing.")
    rows = [(label, value.replace("-", "−")) for label, value in balance_rows(balance)]
    return table("Energy balance", ("", ""), rows)
