"""Meaning of the words in a study's table: how far a structure came, whatever its transitions are called."""

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
from forficula.analysis.precision import precisions_text
from forficula.arrays import Array
from forficula.errors import InputError
from forficula.structure import Appearance, Structure, Wording
from forficula.study.search_steps import Search

if TYPE_CHECKING:
    from xarray import DataArray, Dataset

_ATTRIBUTE = "transitions"


class OutcomeKind(Enum):
    """How far a structure came through the transitions of a protocol."""

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
        """Whether the first transition succeeded, so that the next one could be tried."""
        return self in (
            OutcomeKind.DID_ALL,
            OutcomeKind.DID_FIRST,
            OutcomeKind.STUCK_LATER,
            OutcomeKind.MOVING_LATER,
            OutcomeKind.LOST_LATER,
        )


@dataclass(frozen=True, kw_only=True)
class TableTransition:
    """A transition in a table.

    Attributes:
        name: such as "fold".
        state: state that it leads to, such as "folded".
        least: name of the variable with its least value; "" if none is searched.
        wording: for sentences.
    """

    name: str
    state: str
    least: str
    wording: Wording


def transitions_text(structure: Structure, search: Search | None) -> str:
    """Return the transitions of a structure as text for an attribute of a table."""
    least = {step.transition: step.result_name for step in search.steps} if search is not None else {}
    return json.dumps(
        [
            {
                "name": transition.name,
                "state": transition.state,
                "least": least.get(transition.name, ""),
                "wording": {key: word for key, word in asdict(transition.wording).items() if not key.startswith("if_")},
            }
            for transition in structure.transitions
        ]
    )


def table_transitions(table: Dataset) -> tuple[TableTransition, ...]:
    """Return the transitions of a table's structure, in their order."""
    return tuple(
        TableTransition(**{**entry, "wording": Wording(**entry["wording"])})
        for entry in json.loads(table.attrs.get(_ATTRIBUTE, "[]"))
    )


def check_table(table: Dataset, path: Path, again: str) -> None:
    """Reject a table that lacks its transitions.

    Args:
        table: table that was read.
        path: path of its file.
        again: command that writes the table again.

    Raises:
        InputError: the table lacks its transitions.
    """
    if _ATTRIBUTE not in table.attrs:
        raise InputError(f"{path}: written by an earlier forficula; run `{again}` again")


def studied_transitions(table: Dataset) -> tuple[TableTransition, ...]:
    """Return the transitions whose least values were searched; all transitions if none was searched."""
    transitions = table_transitions(table)
    return tuple(transition for transition in transitions if transition.least) or transitions


def reached_all(table: Dataset, transitions: Sequence[TableTransition]) -> DataArray:
    """Return whether all given transitions succeeded in a plain run, over the points' dimensions."""
    # all are checked: a structure that never leaves its first state is also in this state after the way back
    return reduce(and_, (table[transition.state].astype(bool) for transition in transitions))


def least_values(table: Dataset, transition: TableTransition) -> Array:
    """Return the least successful values of a transition, SI, (structure,), for structures that kept earlier states."""
    values = table[transition.least]
    for before in table_transitions(table):
        if before == transition:
            break
        values = values.where(~_lost(table, before))
    return np.asarray(values.values[np.isfinite(values.values)], dtype=np.float64)


def lost_text(table: Dataset, transition: TableTransition) -> str:
    """Return the number of structures that lost a state when released, as " (2 did not stay folded)".

    Empty if none did.
    """
    count = int((table[transition.least].notnull() & _lost(table, transition)).sum())
    return f" ({count} {verdict_word(Verdict.NOT_HELD, transition.wording)})" if count else ""


def undecided_text(table: Dataset, transition: TableTransition) -> str:
    """Return the number of structures that succeed if all undecided ones do, as " (15 with the undecided ones)".

    Empty if none is undecided.
    """
    open_ones, names = table[transition.least].isnull(), (f"{transition.name}_outcome", "outcome")
    outcomes = next(table[name] for name in names if name in table)
    undecided = int((open_ones & (outcomes == verdict_word(Verdict.UNDECIDED, None))).sum())
    return f" ({int((~open_ones).sum()) + undecided} with the undecided ones)" if undecided else ""


def reliability_sentences(table: Dataset) -> list[str]:
    """Return how many runs were repeated and changed their verdicts, and how many are in single precision, if any."""
    precisions = table["precision"].values if "precision" in table else np.zeros(0)
    sentences = [confirmation_sentence(table), precisions_text(int(np.sum(precisions == "single")), precisions.size)]
    return [f"{sentence}." for sentence in sentences if sentence]


def confirmation_sentence(table: Dataset) -> str:
    """Return how many runs were repeated at half the timestep, and how many verdicts changed; empty if none was."""
    runs, repeated, changed = (int(table.attrs.get(f"runs{suffix}", 0)) for suffix in ("", "_repeated", "_undecided"))
    if not repeated:
        return ""
    verdicts = "no verdict changed" if not changed else f"{changed} changed their verdict and count as undecided"
    return f"{repeated} of {runs} runs were repeated at half the timestep: {verdicts}"


def _lost(table: Dataset, transition: TableTransition) -> DataArray:
    """Return where a transition succeeded but its state was lost when released."""
    outcomes = table.get(f"{transition.name}_outcome", table["outcome"])
    return outcomes == verdict_word(Verdict.NOT_HELD, transition.wording)


def studied_verbs(table: Dataset) -> list[str]:
    """Return the verbs of the studied transitions, such as "fold"; "settle" if the protocol drives nothing."""
    return [transition.wording.verb for transition in studied_transitions(table)] or ["settle"]


def whole_of(table: Dataset) -> str:
    """Return the noun for the structure of a table in sentences."""
    return str(table.attrs.get("whole", Appearance().whole))


def not_tried_word(transitions: Sequence[TableTransition]) -> str:
    """Return the word for a later transition that was not tried because the first failed."""
    return f"not tried: did not {transitions[0].wording.verb}" if transitions else "not tried"


def word_of(table: Dataset, kind: OutcomeKind) -> str:
    """Return the word for a kind in a table; "" if it has none."""
    return next((word for word, meaning in outcome_kinds(table).items() if meaning is kind), "")


def outcome_kinds(table: Dataset) -> Mapping[str, OutcomeKind]:
    """Return the meaning of each word that a table may have, beginning with the furthest."""
    transitions = table_transitions(table)
    kinds: dict[str, OutcomeKind] = {}
    if not transitions:
        kinds[verdict_word(Verdict.REACHED, None)] = OutcomeKind.DID_ALL
    first, later = (
        [transition.wording for transition in transitions[:1]],
        [transition.wording for transition in transitions[1:]],
    )
    reached = [verdict_word(Verdict.REACHED, wording) for wording in reversed([*first, *later])]
    kinds |= {word: OutcomeKind.DID_FIRST if index else OutcomeKind.DID_ALL for index, word in enumerate(reached)}
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
