"""How wings give way to slowly growing torques: the least ones that fold and open, without any help by inertia."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from forficula.statics.potential import DRIVES, FOLD, TURN, Drive, Section, rest, straight_start

Array = NDArray[np.float64]

_ACCURACY = 0.01  # of a least torque


@dataclass(frozen=True, kw_only=True)
class SlowTransition:
    """What a slowly growing torque does to wings.

    Attributes:
        torque: the least that brings each to its goal, N m, nan where none of those tried does, (case,).
        position: joint angles under the least torque, or under the largest one tried, rad, (case, angle).
    """

    torque: Array
    position: Array


def flat_state(wings: Section) -> Array:
    """Joint angles of the wings at rest without torques, from flat, rad, (case, angle)."""
    return rest(wings, straight_start(wings)).position


def folded_state(wings: Section) -> Array:
    """Joint angles of the wings at rest without torques, from folded as far as the stops allow, rad, (case, angle)."""
    start = straight_start(wings)
    start[:, FOLD::4], start[:, TURN::4] = wings.lower[FOLD], wings.upper[TURN]
    closed = rest(wings, start, fixed=(TURN, FOLD))
    return rest(wings, closed.position).position


def folds_beyond(position: Array, angle: float) -> NDArray[np.bool_]:
    """Whether every distal hinge is folded by an angle (rad) or more, (case,)."""
    return np.asarray(np.all(position[:, FOLD::4] <= -angle, axis=1))


def opened_to(position: Array, angle: float) -> NDArray[np.bool_]:
    """Whether every distal hinge is at an angle (rad) or past it, on the overbend side, (case,)."""
    return np.asarray(np.all(position[:, FOLD::4] >= angle, axis=1))


def slow_transition(wings: Section, start: Array, drive: Drive, torques: ArrayLike) -> SlowTransition:
    """Let the torque grow from step to step, wait for the wing to rest at each, and see when it gets to its goal.

    Goals are the protocol's: folded_angle where the torque folds, opened_angle where it opens.

    Args:
        wings: side by side.
        start: joint angles at rest without torques, rad, (case, angle).
        drive: "fold", on every proximal turn axis; "distal", on every distal hinge; "unfold", on both.
        torques: rising, N m, (step,).
    """
    position, least = start.copy(), np.full(len(start), np.nan)
    for torque in np.asarray(torques, dtype=np.float64).tolist():
        left = np.flatnonzero(np.isnan(least))
        if not len(left):
            break
        position[left], there = _pushed(wings, left, position[left], drive, np.full(len(left), torque))
        least[left[there]] = torque
    return SlowTransition(torque=least, position=position)


def least_slow_torque(wings: Section, start: Array, drive: Drive, most: ArrayLike) -> SlowTransition:
    """Find the least slowly growing torque that brings each wing to its goal, to 1 % of it.

    Halves the range between a torque that does not and one that does; the wing is led on from where the first left it.

    Args:
        wings: side by side.
        start: joint angles at rest without torques, rad, (case, angle).
        drive: as in `slow_transition`.
        most: largest torque tried, N m, one or by case.
    """
    count = len(start)
    low, high = np.zeros(count), np.broadcast_to(np.asarray(most, dtype=np.float64), (count,)).copy()
    before = start.copy()
    reached, there = _pushed(wings, np.arange(count), before, drive, high)
    least = np.where(there, high, np.nan)
    while True:
        open_cases = np.flatnonzero(there & (high - low > _ACCURACY * high))
        if not len(open_cases):
            return SlowTransition(torque=least, position=reached)
        middle = (low[open_cases] + high[open_cases]) / 2
        position, arrived = _pushed(wings, open_cases, before[open_cases], drive, middle)
        won, lost = open_cases[arrived], open_cases[~arrived]
        high[won] = least[won] = middle[arrived]
        reached[won] = position[arrived]
        low[lost], before[lost] = middle[~arrived], position[~arrived]


def _pushed(
    wings: Section, cases: NDArray[np.int64], start: Array, drive: Drive, torque: Array
) -> tuple[Array, NDArray[np.bool_]]:
    """Where some wings rest under a torque, and whether that is their goal."""
    some = wings.only(cases)
    on_proximal, on_distal = DRIVES[drive]
    position = rest(some, start, on_proximal * torque, on_distal * torque).position
    protocol = wings.sheet.wing.design.protocol
    if drive == "fold":
        return position, folds_beyond(position, protocol.folded_angle)
    return position, opened_to(position, protocol.opened_angle)
