"""Which runs of a study are repeated at half the timestep."""

from __future__ import annotations

from collections.abc import Mapping

from forficula.analysis import Outcome
from forficula.analysis.margin import NOT_TRIED
from forficula.dynamics import Record

# [chosen] of a margin, in [-1, 1]. Calibrated on 200 builds of the reference wing within 10 %
# (benchmarks/confirmation.py): the rule finds 14 of the 14 verdicts that change between 0.2 and 0.1 ms, with 156
# repetitions.
_SMALL = 0.05


def needs_confirmation(record: Record, outcome: Outcome, margins: Mapping[str, float]) -> bool:
    """Return whether the verdict of a run may depend on the timestep.

    Verdicts change where a structure slams into its stops and is then released: whether the rest of the motion carries
    it back over the barrier depends on small differences. They may also change where a transition was made or missed by
    a small margin.

    Args:
        record: of the run. A record with checks is confirmed already.
        outcome: of the run.
        margins: of the run, by transition.
    """
    if not outcome.verdict.tells or record.checks:
        return False
    released = any(
        each.stage is not None
        and each.stage + 1 < len(record.stages)
        and record.stages[each.stage].goal_time is not None
        for each in record.structure.transitions
    )
    return released or any(margin > NOT_TRIED and abs(margin) < _SMALL for margin in margins.values())
