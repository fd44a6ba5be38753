"""The outcome of a run as text."""

from __future__ import annotations

import sys
from collections.abc import Mapping, Sequence

from rich.console import Console, Group, RenderableType
from rich.table import Table
from rich.text import Text

from forficula.analysis import Outcome, State, Verdict
from forficula.analysis.branch import branch_taken, branch_text
from forficula.analysis.confirmation import confirmation_text
from forficula.analysis.contact_overlap import contact_text
from forficula.analysis.order_of_events import event_texts
from forficula.analysis.package import smallest_package
from forficula.analysis.storage import storage_texts
from forficula.dynamics import Record
from forficula.quantities import reading_unit, show_value
from forficula.show.run.outcome_rows import (
    StateRows,
    balance_remark,
    balance_rows,
    quasi_static_text,
    state_rows,
    transition_headings,
    transition_rows,
)
from forficula.show.run.package_figure import package_text
from forficula.show.run.release import release_sentences
from forficula.show.run.state_names import states_reached
from forficula.show.run.strength_rows import STRENGTH_HEADINGS, strength_rows
from forficula.structure import Structure

_WIDTH = 100  # letters, largest width of the table of states


def outcome_table(name: str, outcome: Outcome, *, verdict: bool = True) -> RenderableType:
    """Return the verdict if wanted, and tables of states by hinge and tendon, transitions, and the energy balance."""
    structure = outcome.structure
    parts: list[RenderableType] = [_verdict_line(name, outcome)] if verdict else []
    if outcome.confirmation is not None and outcome.confirmation.agree:
        words = confirmation_text(outcome.ending, outcome.confirmation)
        parts.append(Text(f"{words[:1].upper()}{words[1:]}; ± is the numerical uncertainty."))
    if outcome.advice:
        parts.append(Text(outcome.advice))
    if structure.states:
        parts += [Text(), *_states(outcome, structure)]
    if structure.transitions:
        parts += [Text(), _transitions(outcome, structure), *map(Text, release_sentences(outcome))]
    if text := quasi_static_text(structure, outcome):
        parts += [Text(), Text(text)]
    parts += [Text(), _balance(outcome, structure)]
    return Group(*parts)


def _verdict_line(name: str, outcome: Outcome) -> Text:
    return Text(f"{name}: {outcome.status}", style="bold")


def print_verdict(name: str, outcome: Outcome) -> None:
    """Print the verdict on one line and flush it."""
    Console(width=110, highlight=False).print(_verdict_line(name, outcome), soft_wrap=True)
    sys.stdout.flush()


def print_outcome(name: str, outcome: Outcome, *, verdict: bool = True) -> None:
    """Print the outcome of a run, with the verdict if wanted."""
    Console(width=110, highlight=False).print(outcome_table(name, outcome, verdict=verdict))


def print_events(record: Record) -> None:
    """Print the order in which groups of hinges move."""
    if texts := event_texts(record):
        Console(width=110, highlight=False).print(Text(), *map(Text, texts), sep="\n")


def print_storage(record: Record, outcome: Outcome) -> None:
    """Print how waits changed a structure."""
    for text in storage_texts(record, outcome):
        Console(width=110, highlight=False).print(Text(), Text(text), sep="\n")


def print_strength(record: Record) -> None:
    """Print how contact was derived, the branch, the smallest package, and the largest strains, stresses and folds."""
    if text := contact_text(record):
        Console(width=110, highlight=False).print(Text(), Text(text), sep="\n")
    if (branch := branch_taken(record)) is not None:
        Console(width=110, highlight=False).print(Text(), Text(_sentence(branch_text(branch))), sep="\n")
    if (smallest := smallest_package(record)) is not None:
        Console(width=110, highlight=False).print(Text(), Text(package_text(*smallest)), sep="\n")
    rows = strength_rows(record)
    if not rows:
        return
    table = Table(box=None, padding=(0, 2, 0, 0), title="Largest strains and folds", title_justify="left")
    for heading in STRENGTH_HEADINGS:
        table.add_column(heading, justify="right" if heading else "left")
    for cells in rows:
        table.add_row(*cells)
    Console(width=110, highlight=False).print(Text(), table, sep="\n")


def _sentence(text: str) -> str:
    return f"{text[0].upper()}{text[1:]}."


def _states(outcome: Outcome, structure: Structure) -> Sequence[RenderableType]:
    """Return a table of the states, or several tables one below the other if one would be too wide."""
    reached = states_reached(structure, outcome)
    if not reached:
        return [Text("States: none was reached.")]
    rows = state_rows(structure, reached, outcome.confirmation)
    if not rows.columns:
        times = ", ".join(f"{name} at {show_value(state.time, 's')}" for name, state in reached.items())
        return [Text(f"States: {times}.")]
    for count in range(len(reached), 0, -1):
        tables = [_state_table(rows, reached, first, first + count) for first in range(0, len(reached), count)]
        if all(Console(width=1000).measure(table).maximum <= _WIDTH for table in tables):
            break
    return [part for table in tables for part in (table, Text())][:-1]


def _state_table(rows: StateRows, reached: Mapping[str, State], first: int, last: int) -> Table:
    """Return a table of the states from a first to a last index."""
    time_unit, time = reading_unit("s", max(state.time for state in reached.values()))
    table = Table(box=None, padding=(0, 2, 0, 0), title=None if first else "States", title_justify="left")
    table.add_column(rows.heading, no_wrap=True)
    angles = [column for column in rows.columns if column.unit == "deg"]
    for name in list(reached)[first:last]:
        for place, column in enumerate(rows.columns):
            # a single angle needs no name
            title = "angle" if [column] == angles else column.title
            gap = " " if title == "angle" else "\n"
            heading = f"{name}:\n{title}{gap}({column.unit})" if place == 0 else f"{title}\n({column.unit})"
            table.add_column(heading, justify="right")
    empty = [""] * (len(rows.columns) - 1)
    times = [cell for state in reached.values() for cell in (f"{time * state.time:#.4g} {time_unit}", *empty)]
    for name, *cells in [*rows.parts, *[["sum", *rows.sums]] * bool(rows.sums), ["time", *times]]:
        table.add_row(name, *cells[first * len(rows.columns) : last * len(rows.columns)])
    return table


def _transitions(outcome: Outcome, structure: Structure) -> Table:
    table = Table(box=None, padding=(0, 2, 0, 0), title="Transitions", title_justify="left")
    for heading in transition_headings(structure):
        table.add_column(heading, justify="left" if not heading else "right")
    for cells in transition_rows(structure, outcome):
        table.add_row(*cells)
    return table


def _balance(outcome: Outcome, structure: Structure) -> RenderableType:
    balance = outcome.energy_balance
    if outcome.verdict is Verdict.DIVERGED or not balance.residual <= 1:
        return Text("Energy balance: it does not close, so the numbers of this run are meaningless.")
    table = Table(box=None, padding=(0, 2, 0, 0), title="Energy balance", title_justify="left", show_header=False)
    table.add_column("")
    table.add_column("", justify="right")
    for label, value in balance_rows(structure, balance):
        table.add_row(label, value)
    remark = balance_remark(balance)
    return Group(table, Text(remark)) if remark else table
