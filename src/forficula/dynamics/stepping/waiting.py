"""Structures that wait at rest: tendons and creases relax in a few leaps, with steps to rest between the leaps.

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
from forficula.material.law.crease_memory import acting_moment, remaining_share

# allowed error of the pull of branches after a leap, as a share of the largest pull
_ALLOWED = 1e-4
_GROWTH, _SHRINKING = 2.0, 0.2
# largest product of a tendon's compliance and the stiffness of its lagging branches; beyond, the structure snaps
_SOFTEST = 0.9
# moment of a crease that counts as acting, in the model's units; creases always act
_ACTS = 1e-300


@dataclass(frozen=True, kw_only=True)
class _Leap:
    """A completed leap, in the model's units except its time; arrays are (element,), for tendons and then creases.

    Attributes:
        time: s.
        lengths: of tendons, and angles of creases, before the leap.
        drifts: predicted increases of the lengths.
        lags: stiffness of the branches minus the part that relaxes during the change of length.
        drops: decreases of the branches' pull during the leap.
        pull: the largest pull of all tendons so far, and the largest moment of all creases, for each element.
    """

    time: float
    lengths: Array
    drifts: Array
    lags: Array
    drops: Array
    pull: Array


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
        most, lost, spared, of_creases = max(left - stepped, 0.0), 0.0, 0.0, 0.0
        time, model = most, self._models[row]
        relaxes = model.creases is not None and model.creases.law.relaxes
        if (model.branches.size or relaxes) and most:
            time, lost, spared, of_creases = self._leap(row, most, stepped, stepper)
        account.wait(row, time, lost, spared, of_creases)
        tracker.waited[row] += time

    def _leap(self, row: int, most: float, first: float, stepper: Stepper) -> tuple[float, float, float, float]:
        """Let the tendons and creases of a structure relax; return the time, s, and energies, in the model's units.

        These are the energies that the branches of tendons lose and save, and that those of creases lose.

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
        times, stiffness = branch_numbers(model)
        present, pull = model.branches >= 0, np.full(len(pulls), pulls.max(initial=0.0))
        angles, memory = stepper.creases(row)
        law = None if model.creases is None or not model.creases.law.relaxes else model.creases.law
        if law is not None:
            moments = np.abs(acting_moment(law, angles, 0.0, memory)[0])
            lengths, pulls = np.concatenate([lengths, angles]), np.concatenate([pulls, np.maximum(moments, _ACTS)])
            pull = np.concatenate([pull, np.full(len(angles), moments.max())])
            numbers = ((forces, memory[2:].T), (times, law.branch_time), (stiffness, law.branch_stiffness))
            forces, times, stiffness = (
                _below(upper, lower, absent) for (upper, lower), absent in zip(numbers, (0.0, 1.0, 1.0), strict=True)
            )
            present = _below(present.astype(np.float64), (law.branch_stiffness > 0).astype(np.float64), 0.0) > 0
            stiffness = np.where(present, stiffness, 1.0)
        pull = pull if before is None else np.maximum(pull, before.pull)
        time, gives = first, np.zeros(len(lengths))
        if before is not None:
            moved = lengths - before.lengths
            missed = before.lags * np.abs(moved - before.drifts) * (pulls > 0)
            off = float(np.max(missed / np.where(pull > 0, pull, 1.0)))
            growth = 0.9 * (self._allowed / max(off, 1e-15)) ** (1 / 3)
            time = before.time * float(np.clip(growth, _SHRINKING, _GROWTH))
            gives = np.divide(moved, before.drops, out=gives, where=(pulls > 0) & (before.drops != 0))
        # leave no remainder that is shorter than the first leap
        time = most if time > most - first else time
        share = time / model.units.time / times
        follows = stiffness * (-np.expm1(-share) / share)
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
        tendons = len(model.in_units.tendons)
        drops, of_creases = forces.sum(axis=1), 0.0
        drops[:tendons] += branch_forces(model, act[None])[0].sum(axis=1)
        stepper.set_activation(row, act)
        if law is not None:
            # as in `aged` for a taut tendon
            faded = (np.exp(-share) * forces + (follows - stiffness) * drifts[:, None])[tendons:] * present[tendons:]
            faded = faded[:, : len(memory) - 2]
            drops[tendons:] -= faded.sum(axis=1)
            squares = np.sum((memory[2:].T ** 2 - faded**2) / (2 * stiffness[tendons:, : len(memory) - 2]), axis=1)
            of_creases = float(np.sum(remaining_share(law, memory) * squares))
            stepper.set_branch_moments(row, faded.T)
        self._leaps[row] = _Leap(time=time, lengths=lengths, drifts=drifts, lags=lags, drops=drops, pull=pull)
        return time, lost, spared, of_creases


def _below(upper: Array, lower: Array, absent: float) -> Array:
    """Return the rows of two arrays one below the other, filled to the same width."""
    width = max(upper.shape[1], lower.shape[1])
    rows = [np.pad(part, ((0, 0), (0, width - part.shape[1])), constant_values=absent) for part in (upper, lower)]
    return np.concatenate(rows)
