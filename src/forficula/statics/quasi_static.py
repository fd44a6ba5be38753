"""How wings give way to slowly growing torques: the least ones that fold and open, without any help by inertia."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from forficula.statics.potential import DRIVES, FOLD, TURN, Drive, Section, rest, straight_start

Array = NDArray[np.float64]

_LEAD_IN = 4  # halvings of the first torque that folds
_ACCURACY = 0.01  # of a least torque
_FIRST_STEP = 1e-4  # of the largest torque tried, which no step is shorter than
_NEAR = 0.3  # rad, by which the joints of a wing turn at most without a snap from step to step


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

    Goals are the protocol's: folded_angle where the torque folds, opened_angle where it opens. A torque that comes at
    once may lead elsewhere than one that grows: it chooses which veins of a flat wing turn, as hardly anything holds
    them. So where it folds, smaller ones come before the first.

    Args:
        wings: side by side.
        start: joint angles at rest without torques, rad, (case, angle).
        drive: "fold", on every proximal turn axis; "distal", on every distal hinge; "unfold", on both.
        torques: rising, N m, (step,).
    """
    position, least = start.copy(), np.full(len(start), np.nan)
    steps = np.asarray(torques, dtype=np.float64)
    before = steps[0] / 2.0 ** np.arange(_LEAD_IN, 0, -1) if drive == "fold" else []
    for torque in [*before, *steps]:
        left = np.flatnonzero(np.isnan(least))
        if not len(left):
            break
        position[left] = _pushed(wings, left, position[left], drive, np.full(len(left), torque))
        least[left[_at_goal(wings, position[left], drive)]] = max(torque, steps[0])
    return SlowTransition(torque=least, position=position)


def least_slow_torque(wings: Section, start: Array, drive: Drive, most: ArrayLike) -> SlowTransition:
    """Find the least slowly growing torque that brings each wing to its goal, to 1 % of it.

    A step of the torque under which the wing would leave its surroundings is halved. Where it does so after a step of
    1 % of the torque, too, it snaps: it is let go to where it rests, and the torque grows on from there. The first
    step is 1e-4 of the largest torque, and no shorter ones are tried.

    Args:
        wings: side by side.
        start: joint angles at rest without torques, rad, (case, angle).
        drive: as in `slow_transition`.
        most: largest torque tried, N m, one or by case.
    """
    most = np.broadcast_to(np.asarray(most, dtype=np.float64), (len(start),))
    position, torque, step = start.copy(), np.zeros(len(start)), _FIRST_STEP * most
    least = np.where(_at_goal(wings, start, drive), 0.0, np.nan)
    while True:
        left = np.flatnonzero(np.isnan(least) & (torque < most))
        if not len(left):
            return SlowTransition(torque=least, position=position)
        tried = np.minimum(torque[left] + step[left], most[left])
        found = _pushed(wings, left, position[left], drive, tried, within=_NEAR)
        leaves = np.abs(found - position[left]).max(axis=1) > 0.99 * _NEAR
        snaps = leaves & (step[left] <= np.maximum(_ACCURACY * tried, _FIRST_STEP * most[left]))
        if snaps.any():
            found[snaps] = _pushed(wings, left[snaps], found[snaps], drive, tried[snaps])
        kept = ~leaves | snaps
        torque[left[kept]], position[left[kept]] = tried[kept], found[kept]
        arrived = kept & _at_goal(wings, found, drive)
        least[left[arrived]] = tried[arrived]
        step[left] *= np.where(snaps, 1.0, np.where(leaves, 0.5, 2.0))


def _at_goal(wings: Section, position: Array, drive: Drive) -> NDArray[np.bool_]:
    protocol = wings.sheet.wing.design.protocol
    if drive == "fold":
        return folds_beyond(position, protocol.folded_angle)
    return opened_to(position, protocol.opened_angle)


def _pushed(
    wings: Section, cases: NDArray[np.int64], start: Array, drive: Drive, torque: Array, within: float = np.inf
) -> Array:
    """Joint angles at which some wings rest under a torque, no farther away than that."""
    on_proximal, on_distal = DRIVES[drive]
    return rest(wings.only(cases), start, on_proximal * torque, on_distal * torque, within=within).position
