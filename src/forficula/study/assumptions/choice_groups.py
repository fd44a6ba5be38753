"""The choices of a study's table factor by factor, and how many of the grid make their transitions at each."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from forficula.analysis import Verdict
from forficula.study.assumptions.choices import CHOICE
from forficula.study.tables.outcome_kinds import asked_transitions, did_all

if TYPE_CHECKING:
    from xarray import DataArray, Dataset


@dataclass(frozen=True, kw_only=True)
class ChoiceGroup:
    """The choices of one factor.

    Attributes:
        factor: its name in the table.
        places: numbers of its choices along "choice", the base's, 0, among them; by rising value where these are
            numbers.
    """

    factor: str
    places: tuple[int, ...]


def choice_groups(table: Dataset) -> list[ChoiceGroup]:
    """The choices factor by factor, in the study's order."""
    groups = []
    for name, values in table.coords.items():
        if values.dims != (CHOICE,) or name == CHOICE:
            continue
        own = values.values[0]
        places = [0, *(place for place in range(1, values.size) if not _same(values.values[place], own))]
        if values.dtype.kind in "iuf":
            places.sort(key=lambda place: np.nan_to_num(values.values[place], nan=-np.inf))
        groups.append(ChoiceGroup(factor=str(name), places=tuple(places)))
    return groups


def did_first(table: Dataset) -> DataArray:
    """Whether the first transition is done, with some value where these were searched, over the points' dimensions.

    Where there is no transition, whether a run came to its end.
    """
    if not (asked := asked_transitions(table)):
        return table["verdict"] == str(Verdict.REACHED)
    first = asked[0]
    # there is no least value where a lesser one was tried and is not to be trusted, and it is done all the same
    for by in ("torque", "value"):
        if (name := f"{first.state}_by_{by}") in table:
            return table[name].any(str(table[name].dims[-1]))
    return table[first.state].astype(bool)


def count_first(table: Dataset) -> NDArray[np.int_]:
    """How many of the grid do the first transition at each choice, shape (choices,)."""
    return _count(did_first(table))


def count_all(table: Dataset) -> NDArray[np.int_] | None:
    """How many of the grid do all transitions at each choice, shape (choices,); None where that is not asked."""
    transitions = asked_transitions(table)
    if len(transitions) < 2:
        return None
    last = transitions[-1]
    if last.least and last.least not in table:
        return None
    return _count(table[last.least].notnull() if last.least else did_all(table, transitions))


def _count(done: DataArray) -> NDArray[np.int_]:
    """How many of the grid did something at each choice."""
    return np.asarray(done.sum([name for name in done.dims if name != CHOICE]).values)


def _same(value: object, other: object) -> bool:
    """Whether two values are one, or neither is a number."""
    return bool(value == other) or (value != value and other != other)


def count_unknown(table: Dataset) -> dict[str, NDArray[np.int_]]:
    """Of how many it is not known whether they do the first transition, (choice,), by what became of them."""
    shape = (table.sizes[CHOICE], -1)
    verdicts, words = (table[name].values.astype(str).reshape(shape) for name in ("verdict", "outcome"))
    known = [verdict for verdict in Verdict if verdict.tells]
    unknown = ~did_first(table).values.reshape(shape) & ~np.isin(verdicts, known)
    return {str(word): np.sum(unknown & (words == word), axis=1) for word in sorted(set(words[unknown]))}
