"""A study's result as a few lines of text."""

from __future__ import annotations

import textwrap
from collections import Counter
from typing import TYPE_CHECKING

from rich.console import Console
from rich.table import Table

from forficula.quantities import show_quantity
from forficula.show.study.choices_figure import choice_rows
from forficula.study import Study
from forficula.study.refine.summary import boundary_sentences
from forficula.study.tables.outcome_kinds import (
    least_values,
    lost_text,
    reliability_sentences,
    studied_transitions,
    undecided_text,
)
from forficula.study.tables.redundancy import change_rows, redundancy_sentences

if TYPE_CHECKING:
    from xarray import Dataset


def print_study(study: Study, table: Dataset) -> None:
    """Print the number of points by outcome, the counts at each choice, and the least values."""
    print(f"{study.name}: {len(study.points)} points")
    lines = Table(box=None, padding=(0, 2, 0, 0))
    lines.add_column("outcome")
    lines.add_column("points", justify="right")
    for outcome, count in Counter(map(str, table["outcome"].values.ravel())).most_common():
        lines.add_row(outcome, str(count))
    Console(width=110, highlight=False).print(lines)
    for sentence in reliability_sentences(table):
        print(textwrap.fill(sentence, 110, break_long_words=False, break_on_hyphens=False))
    headings, rows = change_rows(table) if study.plan else choice_rows(table)
    if rows:
        by_choice = Table(box=None, padding=(0, 2, 0, 0))
        for heading in headings:
            by_choice.add_column(heading, justify="left" if heading in (headings[0], "outcome") else "right")
        for row in rows:
            by_choice.add_row(*row)
        Console(width=110, highlight=False).print(by_choice)
    if study.plan or study.boundaries is not None:
        for sentence in redundancy_sentences(table) if study.plan else boundary_sentences(table):
            print(textwrap.fill(sentence, 110, break_long_words=False, break_on_hyphens=False))
    if study.search is None:
        return
    for place, (step, item) in enumerate(zip(study.search.steps, studied_transitions(table), strict=True)):
        what = f"{item.wording.verb} again" if place else item.wording.verb
        values = least_values(table, item)
        if len(values):
            low, high = (show_quantity(float(end), step.unit) for end in (values.min(), values.max()))
            between = low if low == high else f"{low} to {high}"
            less = "; smaller values were not tried" if step.values[0] in values and step.values[0] != 0 else ""
            first, more = study.search.first, undecided_text(table, item)
            after = f", {first.state} with {show_quantity(study.search.reference, first.unit)}" if place else ""
            result = f"{what}, with {between}{after}{lost_text(table, item)}{less}"
            print(f"{len(values)} of {len(study.points)}{more} {result}")
        else:
            print(f"none of {len(study.points)} {what}{undecided_text(table, item)}")
