"""Designs with deviations and their results: whether each works, its margins, and how it fails."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from forficula.analysis import Verdict
from forficula.analysis.margin import NOT_TRIED, combined_row_margin, margin_column
from forficula.arrays import Array, Flags
from forficula.design import Design
from forficula.errors import InputError
from forficula.goals.assessor import Assessor, value_of
from forficula.goals.deviation import deviating_values
from forficula.goals.tolerance.nearest_failure import Answer
from forficula.goals.tolerance.question import MARGIN, Question
from forficula.structure import Transition, structure_of
from forficula.study.running.journal import Row


@dataclass(frozen=True, kw_only=True)
class Samples:
    """Designs with deviations and their results.

    Attributes:
        offsets: deviation of each factor in widths, (samples, factors).
        answers: whether each sample works, (samples,).
        outcomes: outcome in words, (samples,).
        statuses: outcome in full, (samples,).
        verdicts: verdicts of the runs, (samples,).
        margins: margins by `margin_names`, (results, samples); always finite.
        facts: by `fact_names`, whether each holds, (facts, samples).
    """

    offsets: Array
    answers: NDArray[np.object_]
    outcomes: NDArray[np.object_]
    statuses: NDArray[np.object_]
    verdicts: NDArray[np.object_]
    margins: Array
    facts: Flags

    def __len__(self) -> int:
        return len(self.answers)


def joined(parts: Sequence[Samples]) -> Samples:
    """Concatenate samples."""
    return Samples(
        offsets=np.concatenate([part.offsets for part in parts]),
        answers=np.concatenate([part.answers for part in parts]),
        outcomes=np.concatenate([part.outcomes for part in parts]),
        statuses=np.concatenate([part.statuses for part in parts]),
        verdicts=np.concatenate([part.verdicts for part in parts]),
        margins=np.concatenate([part.margins for part in parts], axis=1),
        facts=np.concatenate([part.facts for part in parts], axis=1),
    )


def margin_names(question: Question) -> tuple[str, ...]:
    """Return the names of the margins of a sample: the smallest one, that of each transition, and of each limit."""
    return (
        MARGIN,
        *(transition.name for transition in structure_of(question.design).transitions),
        *(str(limit) for limit in question.limits),
    )


def fact_names(question: Question) -> tuple[str, ...]:
    """Return the properties of a sample: works, makes each transition, keeps each state, meets each limit."""
    facts = ["works"]
    for transition in structure_of(question.design).transitions:
        facts += [transition.wording.does, f"stays {transition.wording.stays}"]
    return (*facts, *(str(limit) for limit in question.limits))


def assess_samples(question: Question, assess: Assessor, offsets: Array) -> Samples:
    """Run designs with deviations.

    Args:
        question: the design and the conditions for working.
        assess: computes rows of designs.
        offsets: in widths, (samples, factors); values are limited to what their keys allow.
    """
    values = [deviating_values(question.design, question.deviations, offset) for offset in offsets.tolist()]
    designs = [built_design(question.design, changed) for changed in values]
    rows = assess(designs, question.sources, points=values)
    transitions = structure_of(question.design).transitions
    margins = [_margins(question, row, design, transitions) for row, design in zip(rows, designs, strict=True)]
    answers = [_answer(row, row_margins) for row, row_margins in zip(rows, margins, strict=True)]
    facts = [
        [
            answer is Answer.WORKS,
            *_made(row, transitions),
            *(margin >= 0 for margin in row_margins[1 + len(transitions) :]),
        ]
        for row, answer, row_margins in zip(rows, answers, margins, strict=True)
    ]
    outcomes = [
        "misses a limit" if answer is Answer.FAILS and row["verdict"] == Verdict.REACHED else row["outcome"]
        for row, answer in zip(rows, answers, strict=True)
    ]
    return Samples(
        offsets=offsets,
        answers=np.array(answers, dtype=object),
        outcomes=np.array(outcomes, dtype=object),
        statuses=np.array([row["status"] for row in rows], dtype=object),
        verdicts=np.array([row["verdict"] for row in rows], dtype=object),
        margins=np.array(margins, dtype=float).reshape(len(rows), -1).T,
        facts=np.array(facts, dtype=bool).reshape(len(rows), -1).T,
    )


def built_design(design: Design, values: dict[str, object]) -> Design | str:
    """Return the design with values, or why there is none."""
    try:
        return design.with_values(values)
    except InputError as error:
        return str(error)


def _margins(question: Question, row: Row, design: Design | str, transitions: Sequence[Transition]) -> list[float]:
    """Return the margins in the order of `margin_names`."""
    of_transitions = [float(row.get(margin_column(transition.name), NOT_TRIED)) for transition in transitions]
    limits = [limit.margin(value_of(row, limit.quantity, design)) for limit in question.limits]
    return [min([combined_row_margin(row, transitions), *limits]), *of_transitions, *limits]


def _answer(row: Row, margins: Sequence[float]) -> Answer:
    verdict = Verdict(row["verdict"])
    if verdict is Verdict.NOT_BUILT:
        return Answer.OUTSIDE
    # a diverged or unreliable run is a property of the computation, not of the structure
    if not verdict.conclusive:
        return Answer.UNKNOWN
    return Answer.WORKS if verdict is Verdict.REACHED and all(margin >= 0 for margin in margins) else Answer.FAILS


def _made(row: Row, transitions: Sequence[Transition]) -> list[bool]:
    """Return for every transition whether it was made, and whether its state was held after release."""
    facts = []
    for transition in transitions:
        kept = bool(row.get(transition.state))
        lost = row["verdict"] == Verdict.NOT_HELD and row["goal"] == transition.name
        facts += [kept or lost, kept]
    return facts
