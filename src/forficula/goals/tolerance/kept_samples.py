"""Selection of a tolerance analysis's samples whose records are kept: some that work, some of every kind of failure."""

from __future__ import annotations

import numpy as np

from forficula.design import Design
from forficula.goals.deviation import deviating_values
from forficula.goals.kept_designs import runs_to_keep
from forficula.goals.tolerance.nearest_failure import Answer
from forficula.goals.tolerance.samples import built_design
from forficula.goals.tolerance.tolerance import Tolerance
from forficula.study.running.kept_runs import RunToKeep

MOST_KEPT = 12


def samples_to_keep(result: Tolerance, most: int = MOST_KEPT) -> list[RunToKeep]:
    """Choose samples from all outcomes in turn, those with the smallest deviations first.

    Args:
        result: result of the analysis.
        most: largest number of samples.
    """
    samples, question = result.samples, result.question
    near = np.argsort(np.sum(samples.offsets**2, axis=1), kind="stable").tolist()
    conclusive = [index for index in near if samples.answers[index] in (Answer.WORKS, Answer.FAILS)]
    turns = [[index for index in conclusive if samples.outcomes[index] == outcome] for outcome in result.outcomes]
    wanted = [turn[rank] for rank in range(len(conclusive)) for turn in turns if rank < len(turn)]

    def design_of(number: int) -> Design | str:
        values = deviating_values(question.design, question.deviations, samples.offsets[number].tolist())
        return built_design(question.design, values)

    return runs_to_keep(len(samples.offsets), design_of, wanted, most)
