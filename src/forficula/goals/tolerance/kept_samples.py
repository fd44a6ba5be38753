"""Samples of a tolerance whose runs are kept whole, to be played: some that work, and some of every way to fail."""

from __future__ import annotations

import numpy as np

from forficula.design import Design
from forficula.goals.deviation import off_values
from forficula.goals.kept_designs import runs_to_keep
from forficula.goals.tolerance.nearest_failure import Answer
from forficula.goals.tolerance.samples import built_design
from forficula.goals.tolerance.tolerance import Tolerance
from forficula.study.running.kept_runs import RunToKeep

MOST_KEPT = 12


def samples_to_keep(found: Tolerance, most: int = MOST_KEPT) -> list[RunToKeep]:
    """Choose samples by turns of what they came to, of each those that are off the least.

    Args:
        found: what the runs say.
        most: how many at most.
    """
    samples, question = found.samples, found.question
    near = np.argsort(np.sum(samples.offsets**2, axis=1), kind="stable").tolist()
    told = [place for place in near if samples.answers[place] in (Answer.WORKS, Answer.FAILS)]
    turns = [[place for place in told if samples.outcomes[place] == outcome] for outcome in found.outcomes]
    wanted = [turn[number] for number in range(len(told)) for turn in turns if number < len(turn)]

    def design_of(number: int) -> Design | str:
        values = off_values(question.design, question.deviations, samples.offsets[number].tolist())
        return built_design(question.design, values)

    return runs_to_keep(len(samples.offsets), design_of, wanted, most)
