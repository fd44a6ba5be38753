"""What a run came to, in tables of a page."""

from __future__ import annotations

import math

from forficula.analysis import Outcome, State
from forficula.quantities import reading_unit
from forficula.show.page.html import paragraph, table
from forficula.show.page.words import readable
from forficula.show.table import TRANSITION_HEADINGS, balance_rows, state_angle, transition_cells


def outcome_tables(outcome: Outcome) -> list[str]:
    """States by vein, folding and unfolding, and the energy balance, as HTML."""
    return [_states(outcome), _transitions(outcome), _balance(outcome)]


def _states(outcome: Outcome) -> str:
    """Angles, tendons and energies of the states, by vein."""
    states = {
        "flat": outcome.flat,
        "folded" if outcome.folded else "after folding": outcome.folded_state,
        "opened" if outcome.opened else "after unfolding": outcome.opened_state,
    }
    there = {name: state for name, state in states.items() if state is not None}
    if not there:
        return paragraph("None of the three states was reached.")
    unit, energy = reading_unit("J", max(float(state.tendon_energy.max()) for state in there.values()))
    length_unit, length = reading_unit("m", max(float(state.tendon_length.max()) for state in there.values()))
    groups, headings = [("", 1)], ["vein"]
    for name, state in there.items():
        groups.append((f"{name}, at {readable(state.time, 's')}", 3))
        headings += ["distal angle (deg)", f"tendon ({length_unit})", f"energy ({unit})"]
    rows: list[list[str]] = []
    for vein in range(len(next(iter(there.values())).distal_angle)):
        row = [str(vein)]
        for state in there.values():
            tendon = (f"{length * state.tendon_length[vein]:.2f}", f"{energy * state.tendon_energy[vein]:.4g}")
            row += [state_angle(state, vein).replace("-", "−"), *tendon]
        rows.append(row)
    totals, membranes = ["all tendons"], ["membrane"]
    for state in there.values():
        totals += ["", "", f"{energy * state.tendon_energy.sum():.4g}"]
        membranes += ["", "", _membrane(state)]
    return table("States", headings, [*rows, totals, membranes], groups=groups)


def _membrane(state: State) -> str:
    """A membrane's energy with its own unit: it is a thousandth of the tendons' or less."""
    return "" if math.isnan(state.membrane_energy) else readable(state.membrane_energy, "J")


def _transitions(outcome: Outcome) -> str:
    rows = [
        [name, *transition_cells(transition)]
        for name, transition in (("folding", outcome.fold), ("unfolding", outcome.unfold))
    ]
    return table("Folding and unfolding", TRANSITION_HEADINGS, rows)


def _balance(outcome: Outcome) -> str:
    balance = outcome.energy_balance
    if balance is None:
        return paragraph("The record does not keep the energy balance.")
    if balance.residual > 1:
        return paragraph("The energy balance does not close; the numbers mean nothing.")
    rows = [(label, value.replace("-", "−")) for label, value in balance_rows(balance)]
    return table("Energy balance", ("", ""), rows)
