"""What the words of a study's table mean: how far a structure came, whatever its transitions are called."""

from __future__ import annotations

import json
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass
from enum import Enum
from functools import reduce
from operator import and_
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from forficula.analysis import FORMER_WORDS, Verdict, verdict_word
from forficula.arrays import Array
from forficula.errors import InputError
from forficula.structure import Appearance, Structure, Wording
from forficula.study.search_steps import Search

if TYPE_CHECKING:
    from xarray import DataArray, Dataset

_ATTRIBUTE = "transitions"


class OutcomeKind(Enum):
    """How far a structure came on its way through the transitions of a protocol."""

    DID_ALL = "all transitions"
    DID_FIRST = "the first, but not the last"
    STUCK_LATER = "stuck short of a later one"
    STUCK = "stuck short of the first"
    UNDER_WAY = "stuck on the way"
    LOST = "did not keep the first"
    MOVING = "still at the first"
    MOVING_LATER = "still at a later one"
    LOST_LATER = "did not keep a later one"
    UNDECIDED = "undecided"
    DIVERGED = "diverged"
    UNTRUSTED = "untrusted"
    NOT_BUILT = "not built"
    NOT_TRIED = "the later one was not tried"

    @property
    def did_first(self) -> bool:
        """Whether the first transition was done, so that the next one could be tried."""
        return self in (
            OutcomeKind.DID_ALL,
            OutcomeKind.DID_FIRST,
            OutcomeKind.STUCK_LATER,
            OutcomeKind.MOVING_LATER,
            OutcomeKind.LOST_LATER,
        )


@dataclass(frozen=True, kw_only=True)
class TableTransition:
    """A transition as a table knows it.

    Attributes:
        name: such as "fold".
        state: that it leads to, such as "folded".
        least: name of the variable with its least value; "" where none is looked for.
        wording: for sentences.
    """

    name: str
    state: str
    least: str
    wording: Wording


def transitions_text(structure: Structure, search: Search | None) -> str:
    """The transitions of a structure as an attribute of a table."""
    least = {step.transition: step.least_name for step in search.steps} if search is not None else {}
    return json.dumps(
        [
            {
                "name": each.name,
                "state": each.state,
                "least": least.get(each.name, ""),
                "wording": {key: word for key, word in asdict(each.wording).items() if not key.startswith("if_")},
            }
            for each in structure.transitions
        ]
    )


def table_transitions(table: Dataset) -> tuple[TableTransition, ...]:
    """The transitions of the structure that a table is of, in their order."""
    return tuple(
        TableTransition(**{**each, "wording": Wording(**each["wording"])})
        for each in json.loads(table.attrs.get(_ATTRIBUTE, "[]"))
    )


def check_table(table: Dataset, path: Path, again: str) -> None:
    """Refuse a table that does not say of which transitions it is.

    Args:
        table: that was read.
        path: of its file.
        again: the command that writes it again.

    Raises:
        InputError: it is such a one.
    """
    if _ATTRIBUTE not in table.attrs:
        raise InputError(f"{path}: of an earlier forficula; run `{again}` again")


def asked_transitions(table: Dataset) -> tuple[TableTransition, ...]:
    """The transitions whose least values were searched for, or all of them where none was."""
    transitions = table_transitions(table)
    return tuple(each for each in transitions if each.least) or transitions


def did_all(table: Dataset, transitions: Sequence[TableTransition]) -> DataArray:
    """Whether every one of some transitions was done in a plain run, over the points' dimensions."""
    # what never left its first state may well be found in it after the way back
    return reduce(and_, (table[each.state].astype(bool) for each in transitions))


def least_values(table: Dataset, transition: TableTransition) -> Array:
    """The least values that made a transition, SI, (structure,): of a later one, where the one before it was kept."""
    values = table[transition.least]
    for before in table_transitions(table):
        if before == transition:
            break
        values = values.where(~_lost(table, before))
    return np.asarray(values.values[np.isfinite(values.values)], dtype=np.float64)


def lost_text(table: Dataset, transition: TableTransition) -> str:
    """How many made a transition under its least value and lost it when released, as " (2 did not stay folded)".

    Empty where all kept it.
    """
    count = int((table[transition.least].notnull() & _lost(table, transition)).sum())
    return f" ({count} {verdict_word(Verdict.NOT_HELD, transition.wording)})" if count else ""


def undecided_text(table: Dataset, transition: TableTransition) -> str:
    """How many more make a transition if all do of which that is undecided, as " (15 with the undecided ones)".

    Empty where all are decided.
    """
    open_ones, names = table[transition.least].isnull(), (f"{transition.name}_outcome", "outcome")
    outcomes = next(table[name] for name in names if name in table)
    undecided = int((open_ones & (outcomes == verdict_word(Verdict.UNDECIDED, None))).sum())
    return f" ({int((~open_ones).sum()) + undecided} with the undecided ones)" if undecided else ""


def confirmation_sentence(table: Dataset) -> str:
    """Return how many runs were repeated at half the timestep and what that changed; empty where none was."""
    runs, repeated, changed = (int(table.attrs.get(f"runs{of}", 0)) for of in ("", "_repeated", "_undecided"))
    if not repeated:
        return ""
    verdicts = "no verdict changed" if not changed else f"{changed} changed their verdict and count as undecided"
    return f"{repeated} of {runs} runs were repeated at half the timestep: {verdicts}"


def _lost(table: Dataset, transition: TableTransition) -> DataArray:
    """Where a transition was made and lost when released."""
    outcomes = table.get(f"{transition.name}_outcome", table["outcome"])
    return outcomes == verdict_word(Verdict.NOT_HELD, transition.wording)


def asked_verbs(table: Dataset) -> list[str]:
    """What is asked whether a structure does it, such as "fold"; "settle" where its protocol drives nothing."""
    return [each.wording.verb for each in asked_transitions(table)] or ["settle"]


def whole_of(table: Dataset) -> str:
    """What sentences call the structure that a table is of."""
    return str(table.attrs.get("whole", Appearance().whole))


def not_tried_word(transitions: Sequence[TableTransition]) -> str:
    """What a table says of a later transition where the first was not done."""
    return f"not tried: did not {transitions[0].wording.verb}" if transitions else "not tried"


def word_of(table: Dataset, kind: OutcomeKind) -> str:
    """The word by which a table tells a kind; "" where it has none."""
    return next((word for word, its in outcome_kinds(table).items() if its is kind), "")


def outcome_kinds(table: Dataset) -> Mapping[str, OutcomeKind]:
    """What each word that a table may have means; those that came furthest first."""
    transitions = table_transitions(table)
    kinds: dict[str, OutcomeKind] = {}
    if not transitions:
        kinds[verdict_word(Verdict.REACHED, None)] = OutcomeKind.DID_ALL
    first, later = [each.wording for each in transitions[:1]], [each.wording for each in transitions[1:]]
    reached = [verdict_word(Verdict.REACHED, wording) for wording in reversed([*first, *later])]
    kinds |= {word: OutcomeKind.DID_FIRST if place else OutcomeKind.DID_ALL for place, word in enumerate(reached)}
    for verdict, wordings, kind in (
        (Verdict.STUCK, later, OutcomeKind.STUCK_LATER),
        (Verdict.STUCK, first, OutcomeKind.STUCK),
    ):
        kinds |= {verdict_word(verdict, wording): kind for wording in wordings}
    kinds |= {verdict_word(Verdict.STUCK, wording, under_way=True): OutcomeKind.UNDER_WAY for wording in first}
    for verdict, wordings, kind in (
        (Verdict.NOT_HELD, first, OutcomeKind.LOST),
        (Verdict.MOVING, first, OutcomeKind.MOVING),
        (Verdict.MOVING, later, OutcomeKind.MOVING_LATER),
        (Verdict.NOT_HELD, later, OutcomeKind.LOST_LATER),
    ):
        kinds |= {verdict_word(verdict, wording): kind for wording in wordings}
    for verdict, kind in (
        (Verdict.UNDECIDED, OutcomeKind.UNDECIDED),
        (Verdict.DIVERGED, OutcomeKind.DIVERGED),
        (Verdict.UNTRUSTED, OutcomeKind.UNTRUSTED),
        (Verdict.NOT_BUILT, OutcomeKind.NOT_BUILT),
    ):
        kinds[verdict_word(verdict, None)] = kind
    kinds |= dict.fromkeys(FORMER_WORDS, OutcomeKind.UNTRUSTED)
    return kinds | {not_tried_word(transitions): OutcomeKind.NOT_TRIED}
