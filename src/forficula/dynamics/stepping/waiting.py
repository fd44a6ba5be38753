"""Structures that wait at rest: their tendons relax in a few leaps, with steps to rest between the leaps.

The method is projective integration (Gear and Kevrekidis 2003, doi 10.1137/S1064827501388157): fast variables are
stepped for a short time, and slow variables are extrapolated over a leap. Nothing moves during a leap; the resulting
motion, including a snap, is simulated in ordinary steps. During a leap, branches relax as if lengths changed linearly
to the values predicted from the previous leap, so that the error is of second order in the duration of the leap. The
deviation from this prediction determines the duration of the next leap.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.dynamics.energies.energy import branch_forces, branch_numbers
from forficula.dynamics.energies.work_balance import WorkBalance
from forficula.dynamics.engine.model import Model
from forficula.dynamics.stepping.stages import StageTracker
from forficula.dynamics.stepping.stepper import Stepper
from forficula.material.law.ageing import aged

# allowed error of the pull of branches after a leap, as a share of the largest pull
_ALLOWED = 1e-4
_GROWTH, _SHRINKING = 2.0, 0.2
# largest product of a tendon's compliance and the stiffness of its lagging branches; beyond, the structure snaps
_SOFTEST = 0.9


@dataclass(frozen=True, kw_only=True)
class _Leap:
    """A completed leap, in the model's units except its time; arrays are (tendon,).

    Attributes:
        time: s.
        lengths: of tendons before the leap.
        drifts: predicted increases of the lengths.
        lags: stiffness of the branches minus the part that relaxes during the change of length.
        drops: decreases of the branches' pull during the leap.
        pull: the largest pull of all tendons so far.
    """

    time: float
    lengths: Array
    drifts: Array
    lags: Array
    drops: Array
    pull: float


class Waits:
    """Progress of the waits of many structures of one topology."""

    def __init__(self, models: Sequence[Model], allowed: float = _ALLOWED) -> None:
        """Start without any leap; `allowed` is the allowed error of a leap as a share of the largest pull."""
        self._models, self._allowed = models, allowed
        self._leaps: list[_Leap | None] = [None] * len(models)

    def go_on(self, row: int, tracker: StageTracker, stepper: Stepper, account: WorkBalance) -> None:
        """Take one leap of a resting structure, or end its wait."""
        left, stepped = tracker.left_to_wait(row)
        if left <= 0:
            self._leaps[row] = None
            tracker.end_wait(row)
            return
        # the steps to the next rest take part of the remaining time
        most, lost, spared = max(left - stepped, 0.0), 0.0, 0.0
        time = most
        if self._models[row].branches.size and most:
            time, lost, spared = self._leap(row, most, stepped, stepper)
        account.wait(row, time, lost, spared)
        tracker.waited[row] += time

    def _leap(self, row: int, most: float, first: float, stepper: Stepper) -> tuple[float, float, float]:
        """Let the tendons of a structure relax; return the time, s, and the energies lost and saved by branches.

        Energies are in the model's units.

        Args:
            row: number of the structure.
            most: largest duration of the leap, s.
            first: duration of the first leap, s.
            stepper: with the structure at rest.
        """
        model, before = self._models[row], self._leaps[row]
        lengths, act = stepper.lengths(row)[model.tendons], stepper.activation(row)
        # the engine's forces are positive for pushing
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
        # leave no remainder that is shorter than the first leap
        time = most if time > most - first else time
        times, stiffness = branch_numbers(model)
        share = time / model.units.time / times
        follows = stiffness * (-np.expm1(-share) / share)
        present = model.branches >= 0
        lags = np.sum((stiffness - follows) * present, axis=1)
        fades = np.sum(-forces * np.expm1(-share), axis=1)
        gives = np.where(np.abs(gives * lags) < _SOFTEST, gives, 0.0)
        drifts = gives * fades / (1 - gives * lags)
        lost, spared = 0.0, 0.0
        for number, tendon in enumerate(model.in_units.tendons):
            places = model.branches[number, present[number]]
            if len(places):
                after = aged(
                    tendon.law,
                    float(lengths[number]),
                    -act[places],
                    time / model.units.time,
                    drift=float(drifts[number]),
                )
                act[places] = -after.forces
                lost, spared = lost + after.lost, spared + after.stored_excess
        drops = forces.sum(axis=1) + branch_forces(model, act[None])[0].sum(axis=1)
        stepper.set_activation(row, act)
        self._leaps[row] = _Leap(time=time, lengths=lengths, drifts=drifts, lags=lags, drops=drops, pull=pull)
        return time, lost, spared
