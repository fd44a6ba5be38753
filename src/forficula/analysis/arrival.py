"""Creases that did not go where they were to go."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from forficula.dynamics import Record
from forficula.structure import goal_of, hinge_bounds

TARGET = "target"
# that a sentence names
_NAMED = 4


@dataclass(frozen=True, kw_only=True)
class Missed:
    """A crease that is not at its target.

    Attributes:
        label: what it is called.
        angle: where it is, in its own sense, rad.
        target: where it was to go, rad.
        within: how near would have done, rad.
    """

    label: str
    angle: float
    target: float
    within: float


def missed_targets(record: Record) -> list[Missed]:
    """Creases that were not at their targets when a stage that was to bring them there ended, the furthest first.

    Returns:
        None of a run without such a stage, or in which it reached its goal.
    """
    ends = [end for end in record.stages if end.stage.until == TARGET]
    if not ends or ends[-1].goal_time is not None or record.diverged_at is not None:
        return []
    (lower, upper), hinges = hinge_bounds(record.structure, goal_of(record.structure, TARGET)), record.structure.hinges
    row = max(int(np.searchsorted(record.time, ends[-1].end, side="right")) - 1, 0)
    found = []
    for hinge, angle, least, most in zip(hinges, record.series["hinge_angle"][row], lower, upper, strict=True):
        if not least <= angle <= most:
            target, within = (least + most) / 2, (most - least) / 2
            found.append(Missed(label=hinge.label or hinge.name, angle=float(angle), target=target, within=within))
    return sorted(found, key=lambda each: -abs(each.angle - each.target))


def missed_text(missed: list[Missed], creases: int) -> str:
    """Which creases did not arrive, as a sentence without an end.

    Args:
        missed: one or more.
        creases: how many were to arrive.
    """
    told = [
        f"{each.label} at {np.degrees(each.angle):.4g} deg of {np.degrees(each.target):.4g} deg"
        for each in missed[:_NAMED]
    ]
    more = [f"{len(missed) - _NAMED} more"] if len(missed) > _NAMED else []
    return (
        f"{len(missed)} of {creases} creases did not arrive within {np.degrees(missed[0].within):.3g} deg:"
        f" {', '.join([*told, *more])}; there springs of creases, bending and stretching of facets balance"
    )
