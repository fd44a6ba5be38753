"""An outcome as rows of text with units, for every table that shows it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from forficula.analysis import Outcome, State, Transition
from forficula.dynamics import EnergyBalance
from forficula.quantities import reading_unit

TRANSITION_HEADINGS = ("", "torque", "succeeded", "time", "work of the torques")


@dataclass(frozen=True, kw_only=True)
class StateRows:
    """What states are, three cells each: distal angle, deg, length and energy of the tendon.

    Attributes:
        length_unit: of the tendons.
        energy_unit: of the tendons.
        veins: the cells of all states by vein, the vein's number before them.
        sums: the cells of all states for all tendons together.
    """

    length_unit: str
    energy_unit: str
    veins: list[list[str]]
    sums: list[str]


def states_reached(outcome: Outcome) -> dict[str, State]:
    """The states that there are, by what they are called."""
    states = {
        outcome.flat_name: outcome.flat,
        "folded" if outcome.folded else "after folding": outcome.folded_state,
        "opened" if outcome.opened else "after unfolding": outcome.opened_state,
    }
    return {name: state for name, state in states.items() if state is not None}


def state_rows(states: Mapping[str, State]) -> StateRows:
    """Lay out some states, of which there is one at least, in the same units."""
    energy_unit, energy = reading_unit("J", max(float(state.tendon_energy.max()) for state in states.values()))
    length_unit, length = reading_unit("m", max(float(state.tendon_length.max()) for state in states.values()))
    veins: list[list[str]] = []
    for vein in range(len(next(iter(states.values())).distal_angle)):
        row = [str(vein)]
        for state in states.values():
            tendon = (f"{length * state.tendon_length[vein]:.2f}", f"{energy * state.tendon_energy[vein]:.4g}")
            row += [_state_angle(state, vein), *tendon]
        veins.append(row)
    sums = [cell for state in states.values() for cell in ("", "", f"{energy * state.tendon_energy.sum():.4g}")]
    return StateRows(length_unit=length_unit, energy_unit=energy_unit, veins=veins, sums=sums)


def transition_rows(outcome: Outcome) -> list[list[str]]:
    """Folding and unfolding, under `TRANSITION_HEADINGS`."""
    transitions = (("folding", outcome.fold), ("unfolding", outcome.unfold))
    return [[name, *_transition_cells(transition)] for name, transition in transitions]


def balance_rows(balance: EnergyBalance) -> list[tuple[str, str]]:
    """An energy balance, term by term, in one unit, and what is missing as a share."""
    unit, factor = reading_unit("J", max(abs(balance.work), abs(balance.tendon), 1e-12))
    terms = (
        ("work of the torques", balance.work),
        ("= change of tendon energy", balance.tendon),
        ("+ change of membrane energy", balance.membrane),
        ("+ change of kinetic energy", balance.kinetic),
        ("+ change of gravitational energy", balance.gravitational),
        ("+ taken by hinge damping", balance.hinge_damping),
        ("+ taken by tendon and membrane damping", balance.elastic_damping),
        ("+ taken by stops, guard tendons and contacts", balance.stops),
        ("+ change of energy of the Maxwell branches", balance.branches),
        ("+ taken by the Maxwell branches", balance.branch_damping),
        ("+ taken by yielding", balance.yielding),
        ("+ stored by branches that gave way, unpaid", balance.letting_go),
        ("+ missing", balance.missing),
    )
    # adding 0 turns -0 into 0
    rows = [(label, f"{round(factor * value, 4) + 0.0:.4f} {unit}") for label, value in terms if value is not None]
    return [*rows, ("residual", f"{100 * balance.residual:.3f} % of what was exchanged")]


def _state_angle(state: State, vein: int) -> str:
    """Mean distal angle of a vein, deg, and half the envelope where the hinge still swings."""
    mean = round(float(np.degrees(state.distal_angle[vein])), 1) + 0.0  # adding 0 turns -0 into 0
    swing = np.degrees(state.distal_angle_high[vein] - state.distal_angle_low[vein]) / 2
    return f"{mean:.1f} ± {swing:.1f}" if swing > 0.05 else f"{mean:.1f}"


def _transition_cells(transition: Transition | None) -> list[str]:
    """A transition in words and units."""
    if transition is None:
        return ["not tried", "", "", ""]
    time = "" if transition.time is None else _readable(transition.time, "s")
    torque, work = _readable(transition.torque, "N m"), _readable(transition.work, "J")
    return [torque, "yes" if transition.succeeded else "no", time, work]


def _readable(value: float, si: str) -> str:
    unit, factor = reading_unit(si, abs(value))
    return f"{factor * value:.4g} {unit}"
