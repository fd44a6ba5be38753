"""The outcome of a run as text that a person understands."""

from __future__ import annotations

import numpy as np
from rich.console import Console, Group, RenderableType
from rich.table import Table
from rich.text import Text

from forficula.analysis import EnergyBalance, Outcome, State, Transition
from forficula.quantities import reading_unit

TRANSITION_HEADINGS = ("", "torque", "succeeded", "time", "work of the torques")


def outcome_table(name: str, outcome: Outcome) -> RenderableType:
    """Lay out states by vein, transitions, and the energy balance."""
    verdict = Text(f"{name}: {outcome.status}", style="bold")
    parts: list[RenderableType] = [verdict]
    if outcome.advice:
        parts.append(Text(outcome.advice))
    parts += [Text(), _states(outcome), Text(), _transitions(outcome), Text(), _balance(outcome)]
    return Group(*parts)


def print_outcome(name: str, outcome: Outcome) -> None:
    """Print the outcome, as wide as it is."""
    Console(width=110, highlight=False).print(outcome_table(name, outcome))


def _states(outcome: Outcome) -> RenderableType:
    states = {
        "flat": outcome.flat,
        "folded" if outcome.folded else "after folding": outcome.folded_state,
        "opened" if outcome.opened else "after unfolding": outcome.opened_state,
    }
    there = {name: state for name, state in states.items() if state is not None}
    if not there:
        return Text("States: none was reached.")
    energy_unit, energy = reading_unit("J", max(float(state.tendon_energy.max()) for state in there.values()))
    length_unit, length = reading_unit("m", max(float(state.tendon_length.max()) for state in there.values()))
    time_unit, time = reading_unit("s", max(state.time for state in there.values()))
    table = Table(box=None, padding=(0, 2, 0, 0), title="States", title_justify="left")
    table.add_column("vein")
    for name in there:
        table.add_column(f"{name}:\nangle (deg)", justify="right")
        table.add_column(f"tendon\n({length_unit})", justify="right")
        table.add_column(f"energy\n({energy_unit})", justify="right")
    for vein in range(len(next(iter(there.values())).distal_angle)):
        cells = [str(vein)]
        for state in there.values():
            cells += [
                state_angle(state, vein),
                f"{length * state.tendon_length[vein]:.2f}",
                f"{energy * state.tendon_energy[vein]:.4g}",
            ]
        table.add_row(*cells)
    totals = ["sum"]
    for state in there.values():
        totals += ["", "", f"{energy * state.tendon_energy.sum():.4g}"]
    table.add_row(*totals)
    table.add_row(
        "time", *(cell for state in there.values() for cell in (f"{time * state.time:#.4g} {time_unit}", "", ""))
    )
    return table


def state_angle(state: State, vein: int) -> str:
    """Mean distal angle of a vein, deg, and half the envelope where the hinge still swings."""
    mean = round(float(np.degrees(state.distal_angle[vein])), 1) + 0.0  # adding 0 turns -0 into 0
    swing = np.degrees(state.distal_angle_high[vein] - state.distal_angle_low[vein]) / 2
    return f"{mean:.1f} ± {swing:.1f}" if swing > 0.05 else f"{mean:.1f}"


def _transitions(outcome: Outcome) -> Table:
    table = Table(box=None, padding=(0, 2, 0, 0), title="Transitions", title_justify="left")
    for heading in TRANSITION_HEADINGS:
        table.add_column(heading, justify="left" if not heading else "right")
    for name, transition in (("folding", outcome.fold), ("unfolding", outcome.unfold)):
        table.add_row(name, *transition_cells(transition))
    return table


def transition_cells(transition: Transition | None) -> list[str]:
    """A transition in words and units, under `TRANSITION_HEADINGS` but the first."""
    if transition is None:
        return ["not tried", "", "", ""]
    time = "" if transition.time is None else _readable(transition.time, "s")
    torque, work = _readable(transition.torque, "N m"), _readable(transition.work, "J")
    return [torque, "yes" if transition.succeeded else "no", time, work]


def _balance(outcome: Outcome) -> RenderableType:
    balance = outcome.energy_balance
    if balance is None:
        return Text("Energy balance: not kept.")
    if balance.residual > 1:
        return Text("Energy balance: it does not close; the numbers mean nothing.")
    table = Table(box=None, padding=(0, 2, 0, 0), title="Energy balance", title_justify="left", show_header=False)
    table.add_column("")
    table.add_column("", justify="right")
    for label, value in balance_rows(balance):
        table.add_row(label, value)
    return table


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
    return [*rows, ("residual", f"{100 * balance.residual:.3f} % of {balance.residual_of}")]


def _readable(value: float, si: str) -> str:
    unit, factor = reading_unit(si, abs(value))
    return f"{factor * value:.4g} {unit}"
