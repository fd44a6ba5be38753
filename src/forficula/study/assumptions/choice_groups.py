"""Choices in a study's table, grouped by factor, and the number of grid points that succeed at each choice."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from forficula.analysis import Verdict
from forficula.study.assumptions.choices import CHOICE
from forficula.study.tables.outcome_kinds import reached_all, studied_transitions

if TYPE_CHECKING:
    from xarray import DataArray, Dataset


@dataclass(frozen=True, kw_only=True)
class ChoiceGroup:
    """Choices of one factor.

    Attributes:
        factor: name of the factor in the table.
        places: indices of its choices along "choice", including 0, the base. Sorted by value if the values are numbers.
    """

    factor: str
    places: tuple[int, ...]


def choice_groups(table: Dataset) -> list[ChoiceGroup]:
    """Return the choices grouped by factor, in the study's order."""
    groups = []
    for name, values in table.coords.items():
        if values.dims != (CHOICE,) or name == CHOICE:
            continue
        base_value = values.values[0]
        places = [0, *(index for index in range(1, values.size) if not _same(values.values[index], base_value))]
        if values.dtype.kind in "iuf":
            places.sort(key=lambda index: np.nan_to_num(values.values[index], nan=-np.inf))
        groups.append(ChoiceGroup(factor=str(name), places=tuple(places)))
    return groups


def reached_first(table: Dataset) -> DataArray:
    """Return whether the first transition succeeds at each point, with any value if values were searched.

    Without a transition: whether the run reached its end.
    """
    if not (transitions := studied_transitions(table)):
        return table["verdict"] == str(Verdict.REACHED)
    first = transitions[0]
    # without a least value because a smaller value gave an unreliable run, the transition may still have succeeded
    for kind in ("torque", "value"):
        if (name := f"{first.state}_by_{kind}") in table:
            return table[name].any(str(table[name].dims[-1]))
    return table[first.state].astype(bool)


def count_first(table: Dataset) -> NDArray[np.int_]:
    """Return the number of grid points at which the first transition succeeds, for each choice, shape (choices,)."""
    return _count(reached_first(table))


def count_all(table: Dataset) -> NDArray[np.int_] | None:
    """Return the number of grid points at which all transitions succeed, shape (choices,); None if not studied."""
    transitions = studied_transitions(table)
    if len(transitions) < 2:
        return None
    last = transitions[-1]
    if last.least and last.least not in table:
        return None
    return _count(table[last.least].notnull() if last.least else reached_all(table, transitions))


def _count(done: DataArray) -> NDArray[np.int_]:
    """Return the number of true grid points for each choice."""
    return np.asarray(done.sum([name for name in done.dims if name != CHOICE]).values)


def _same(value: object, other: object) -> bool:
    """Return whether two values are equal, or both not a number."""
    return bool(value == other) or (value != value and other != other)


def count_unknown(table: Dataset) -> dict[str, NDArray[np.int_]]:
    """Return the number of grid points with an unknown outcome of the first transition, (choice,), by outcome."""
    shape = (table.sizes[CHOICE], -1)
    verdicts, words = (table[name].values.astype(str).reshape(shape) for name in ("verdict", "outcome"))
    known = [verdict for verdict in Verdict if verdict.conclusive]
    unknown = ~reached_first(table).values.reshape(shape) & ~np.isin(verdicts, known)
    return {str(word): np.sum(unknown & (words == word), axis=1) for word in sorted(set(words[unknown]))}
