"""Structures that wait at rest: their tendons age in a few leaps, between which they are stepped to rest again.

Projective integration (Gear and Kevrekidis 2003, doi 10.1137/S1064827501388157): what is fast is stepped for a short
while, what is slow is taken a leap further meanwhile. In a leap nothing moves; what that sets in motion, a snap
included, is ordinary steps. Branches fade in a leap as if lengths went evenly to where the last leap lets expect them,
so that the error is of second order in its length; by how much they go elsewhere says how long the next one may be.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.dynamics.energies.account import Account
from forficula.dynamics.energies.energy import branch_forces, branch_numbers
from forficula.dynamics.engine.model import Model
from forficula.dynamics.stepping.stages import StageTracker
from forficula.dynamics.stepping.stepper import Stepper
from forficula.material.law.ageing import aged

# by the largest pull: how far the pull of branches may be off after a leap
_ALLOWED = 1e-4
_GROWTH, _SHRINKING = 2.0, 0.2
# of what a tendon gives way where branches fade, by what they would lose if they followed at once: beyond, it snaps
_SOFTEST = 0.9


@dataclass(frozen=True, kw_only=True)
class _Leap:
    """A leap that was taken, in the model's units but for its time; of every tendon, (tendon,).

    Attributes:
        time: s.
        lengths: before it.
        drifts: by how much they were expected to grow.
        lags: stiffness of the branches, less where they fade while they follow.
        drops: by how much the branches pulled less after it.
        pull: the largest of all tendons so far.
    """

    time: float
    lengths: Array
    drifts: Array
    lags: Array
    drops: Array
    pull: float


class Waits:
    """How far each of many structures of one topology has come with its wait."""

    def __init__(self, models: Sequence[Model], allowed: float = _ALLOWED) -> None:
        """Start with nothing waited for; `allowed` is by how much a leap may be off, by the largest pull."""
        self._models, self._allowed = models, allowed
        self._leaps: list[_Leap | None] = [None] * len(models)

    def go_on(self, row: int, tracker: StageTracker, stepper: Stepper, account: Account) -> None:
        """Take a structure that rests one leap further, or end its wait."""
        left, stepped = tracker.left_to_wait(row)
        if left <= 0:
            self._leaps[row] = None
            tracker.end_wait(row)
            return
        # steps to the next rest take a part of what is left
        most, lost, spared = max(left - stepped, 0.0), 0.0, 0.0
        time = most
        if self._models[row].branches.size and most:
            time, lost, spared = self._leap(row, most, stepped, stepper)
        account.wait(row, time, lost, spared)
        tracker.waited[row] += time

    def _leap(self, row: int, most: float, first: float, stepper: Stepper) -> tuple[float, float, float]:
        """Let the tendons of a structure age; how long, s, what branches lost and are spared, in the model's units.

        Args:
            row: which.
            most: that the leap may take, s.
            first: that the first one takes, s.
            stepper: with the structure at rest.
        """
        model, before = self._models[row], self._leaps[row]
        lengths, act = stepper.lengths(row)[model.tendons], stepper.activation(row)
        # the engine counts what pushes
        forces = -branch_forces(model, act[None])[0]
        pulls = np.maximum(model.elastic.force(lengths) + forces.sum(axis=1), 0.0)
        pull = max(float(pulls.max()), 0.0 if before is None else before.pull)
        time, gives = first, np.zeros(len(lengths))
        if before is not None:
            moved = lengths - before.lengths
            off = float(np.max(before.lags * np.abs(moved - before.drifts) * (pulls > 0))) / (pull or 1.0)
            growth = 0.9 * (self._allowed / max(off, 1e-15)) ** (1 / 3)
            time = before.time * float(np.clip(growth, _SHRINKING, _GROWTH))
            gives = np.divide(moved, before.drops, out=gives, where=(pulls > 0) & (before.drops != 0))
        # no crumb is left
        time = most if time > most - first else time
        times, stiffness = branch_numbers(model)
        share = time / model.units.time / times
        follows = stiffness * (-np.expm1(-share) / share)
        there = model.branches >= 0
        lags = np.sum((stiffness - follows) * there, axis=1)
        fades = np.sum(-forces * np.expm1(-share), axis=1)
        gives = np.where(np.abs(gives * lags) < _SOFTEST, gives, 0.0)
        drifts = gives * fades / (1 - gives * lags)
        lost, spared = 0.0, 0.0
        for number, tendon in enumerate(model.in_units.tendons):
            places = model.branches[number, there[number]]
            if len(places):
                after = aged(
                    tendon.law,
                    float(lengths[number]),
                    -act[places],
                    time / model.units.time,
                    drift=float(drifts[number]),
                )
                act[places] = -after.forces
                lost, spared = lost + after.lost, spared + after.spared
        drops = forces.sum(axis=1) + branch_forces(model, act[None])[0].sum(axis=1)
        stepper.set_activation(row, act)
        self._leaps[row] = _Leap(time=time, lengths=lengths, drifts=drifts, lags=lags, drops=drops, pull=pull)
        return time, lost, spared
