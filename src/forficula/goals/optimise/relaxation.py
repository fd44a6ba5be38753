"""Where nothing meets every limit: which of them would have to give, and by how much."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated

from forficula.goals.optimise.ranking import standing
from forficula.goals.optimise.trial import Trial
from forficula.serial import Key, Written


@dataclass(frozen=True, kw_only=True)
class Relaxation:
    """What one limit costs.

    Attributes:
        limit: its number.
        best: the greatest margin that any trial has; nan where none was looked at.
        alone: the greatest margin of trials that meet all others, so that nothing else would have to give; nan where
            there are none.
        unseen: the greatest margin of trials that are known to fail no other but were not asked all others, for this
            one failed before; nan where there are none.
        trial: that has `alone`, or None.
    """

    limit: Annotated[int, Written.NEVER]
    best: Annotated[float, Key("best_margin")]
    alone: Annotated[float, Key("best_where_others_hold")]
    unseen: Annotated[float, Written.NEVER]
    trial: Annotated[Trial | None, Written.NEVER]


def relaxations(trials: Sequence[Trial]) -> list[Relaxation]:
    """What each limit costs, in their order."""
    count = len(trials[0].margins) if trials else 0
    return [_relaxation(trials, number) for number in range(count)]


def nearest_trial(trials: Sequence[Trial]) -> Trial | None:
    """The trial that comes nearest to meeting every limit; None of none."""
    return min(trials, key=standing, default=None)


def _relaxation(trials: Sequence[Trial], number: int) -> Relaxation:
    known = [trial for trial in trials if not math.isnan(trial.margins[number])]
    alone = [trial for trial in known if all(margin >= 0 for margin in _others(trial, number))]
    unseen = [
        trial.margins[number]
        for trial in known
        if trial not in alone and not any(margin < 0 for margin in _others(trial, number))
    ]
    best = max(alone, key=lambda trial: trial.margins[number], default=None)
    return Relaxation(
        limit=number,
        best=max((trial.margins[number] for trial in known), default=math.nan),
        alone=math.nan if best is None else best.margins[number],
        unseen=max(unseen, default=math.nan),
        trial=best,
    )


def _others(trial: Trial, number: int) -> list[float]:
    """The margins of all limits but one."""
    return [margin for other, margin in enumerate(trial.margins) if other != number]
