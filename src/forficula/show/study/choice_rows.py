"""How many make their transitions at each choice of a study, as rows of words."""

from __future__ import annotations

from typing import TYPE_CHECKING

from forficula.show.study.factor_text import value_text
from forficula.study.choice_groups import choice_groups, count_all, count_first, count_unknown
from forficula.study.choices import CHOICE
from forficula.study.outcome_kinds import asked_verbs

if TYPE_CHECKING:
    from xarray import Dataset


def choice_rows(table: Dataset) -> tuple[list[str], list[list[str]]]:
    """Count the structures of the grid that do the first transition, and all of them, at each choice, factor by factor.

    Args:
        table: of a study.

    Returns:
        Headings, and a row a choice; no rows where nothing is repeated at choices.
    """
    if CHOICE not in table.dims or table["status"].ndim == 1:
        return [], []
    first, every, unknown = count_first(table), count_all(table), count_unknown(table)
    rows = []
    for group in choice_groups(table):
        for place in group.places:
            own = "" if place else f", as in {table.attrs['design']}"
            counts = [str(each[place]) for each in (first, every) if each is not None]
            if unsure := sum(int(numbers[place]) for numbers in unknown.values()):
                counts[0] += f" to {first[place] + unsure}"
            rows.append([value_text(table[group.factor], place) + own, *counts])
    count = table["status"].size // table.sizes[CHOICE]
    verbs = asked_verbs(table)
    return ["choice", f"{verbs[0]}, of {count}", *([f"{verbs[-1]} again"] if every is not None else [])], rows
