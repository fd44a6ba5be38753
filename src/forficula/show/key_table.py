"""Keys of designs and of study files as text that a person understands."""

from __future__ import annotations

from collections.abc import Sequence

from rich.console import Console
from rich.table import Table

from forficula.design.key_table import KeyFact

_WIDTH = 130


def print_keys(facts: Sequence[KeyFact]) -> None:
    """Print keys table by table, each with what it may hold, what counts without it, and what it means."""
    console = Console(width=_WIDTH, highlight=False, markup=False)
    sections: dict[str, list[KeyFact]] = {}
    for fact in facts:
        sections.setdefault(fact.key.rpartition(".")[0], []).append(fact)
    for number, (section, inside) in enumerate(sections.items()):
        table = Table(box=None, padding=(0, 2, 0, 0), show_header=number == 0)
        for heading, width in (("key", 26), ("may be", 26), ("if left out", 12), ("meaning", None)):
            table.add_column(heading, width=width, overflow="fold")
        for fact in inside:
            table.add_row(fact.key.rpartition(".")[2], fact.allowed, fact.default, fact.meaning)
        if section:
            console.print(*[""] * (number > 0), f"[{section}]", sep="\n", style="bold")
        console.print(table)
