"""The outcome of a run as text that a person understands."""

from __future__ import annotations

from rich.console import Console, Group, RenderableType
from rich.table import Table
from rich.text import Text

from forficula.analysis import Outcome, Verdict
from forficula.quantities import reading_unit
from forficula.show.run.outcome_rows import (
    TRANSITION_HEADINGS,
    balance_rows,
    state_rows,
    states_reached,
    transition_rows,
)


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
    there = states_reached(outcome)
    if not there:
        return Text("States: none was reached.")
    rows = state_rows(there)
    time_unit, time = reading_unit("s", max(state.time for state in there.values()))
    table = Table(box=None, padding=(0, 2, 0, 0), title="States", title_justify="left")
    table.add_column("vein")
    for name in there:
        table.add_column(f"{name}:\nangle (deg)", justify="right")
        table.add_column(f"tendon\n({rows.length_unit})", justify="right")
        table.add_column(f"energy\n({rows.energy_unit})", justify="right")
    for cells in [*rows.veins, ["sum", *rows.sums]]:
        table.add_row(*cells)
    table.add_row(
        "time", *(cell for state in there.values() for cell in (f"{time * state.time:#.4g} {time_unit}", "", ""))
    )
    return table


def _transitions(outcome: Outcome) -> Table:
    table = Table(box=None, padding=(0, 2, 0, 0), title="Transitions", title_justify="left")
    for heading in TRANSITION_HEADINGS:
        table.add_column(heading, justify="left" if not heading else "right")
    for cells in transition_rows(outcome):
        table.add_row(*cells)
    return table


def _balance(outcome: Outcome) -> RenderableType:
    balance = outcome.energy_balance
    if outcome.verdict is Verdict.DIVERGED or not balance.residual <= 1:
        return Text("Energy balance: it does not close; the numbers mean nothing.")
    table = Table(box=None, padding=(0, 2, 0, 0), title="Energy balance", title_justify="left", show_header=False)
    table.add_column("")
    table.add_column("", justify="right")
    for label, value in balance_rows(balance):
        table.add_row(label, value)
    return table
