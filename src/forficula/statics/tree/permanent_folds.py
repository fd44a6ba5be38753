"""Permanent folds of the hinges of trees of joints, side by side, with the laws by which they yield."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from forficula.arrays import Array, Indices
from forficula.material.law.crease_law import CreaseLaw
from forficula.statics.path_dependence import path_dependence
from forficula.statics.tree.flaps import Flaps, crease_angles
from forficula.structure import Structure, crease_law


@dataclass(frozen=True, kw_only=True)
class PermanentFolds:
    """Permanent folds of all hinges of structures at the beginning of a motion: of the joints, then of the creases.

    In the motion each hinge turns in one sense. Its moment then depends on its angle alone, and the energy of its
    spring includes what yielding dissipates.

    Attributes:
        joints: law of the joints' springs, (joint,); their stops are bounds of angles.
        flaps: creases between flaps; None if there are none.
        sets: rad, (case, hinge).
    """

    joints: CreaseLaw
    flaps: Flaps | None
    sets: Array

    @property
    def size(self) -> int:
        """Return the number of joints."""
        return len(np.asarray(self.joints.stiffness))

    @property
    def of_creases(self) -> Array:
        """Return the permanent folds of the creases, rad, (case, crease)."""
        return self.sets[:, self.size :]

    def only(self, cases: Indices) -> PermanentFolds:
        """Select cases by index; repeats are allowed."""
        return replace(self, sets=self.sets[cases])

    def turned(self, angles: Array) -> PermanentFolds:
        """Return the folds at the end of the motion, for the angles of the joints, rad, (case, joint)."""
        sets = [self.joints.next_set(angles[:, : self.size], 0.0, self.sets[:, : self.size])]
        if self.flaps is not None:
            turned = crease_angles(self.flaps, angles[:, : self.size])
            sets.append(self.flaps.law.next_set(turned, 0.0, self.of_creases))
        return replace(self, sets=np.concatenate(sets, axis=1))

    def along(self, angles: Array) -> Array:
        """Return the folds along a path of the only case, rad, (step, hinge), for its joints, rad, (step, joint)."""
        sets, folds = list[Array](), self
        for at in angles:
            folds = folds.turned(at[None])
            sets.append(folds.sets[0])
        return np.array(sets)

    def joint_expansion(self, angles: Array) -> tuple[Array, Array, Array]:
        """Compute energy, moment and slope of the joints' springs, (case, joint), with what yielding dissipates."""
        return self.joints.expansion(angles, self.sets[:, : self.size])

    def rest_shifts(self) -> Array:
        """Return the changes of rest angles that have the effect of the folds on moments, rad, (case, hinge)."""
        shifts = [law.rest_shift(sets) for law, sets in self._parts(self.sets)]
        return np.concatenate(shifts, axis=1)

    def energies(self) -> tuple[Array, Array]:
        """Return the energies of the folds of joints and of creases, J, (case,), in addition to shifted springs."""
        of_joints, *of_creases = (law.set_energy(sets).sum(axis=1) for law, sets in self._parts(self.sets))
        return of_joints, of_creases[0] if of_creases else np.zeros(len(self.sets))

    def loss(self, after: Array) -> float:
        """Return the energy that the only case dissipates until it has other folds, rad, (hinge,), J."""
        changes = self._parts(after[None] - self.sets)
        return float(sum(law.yield_loss(change).sum() for law, change in changes))

    def _parts(self, sets: Array) -> list[tuple[CreaseLaw, Array]]:
        """Return the laws of joints and creases with their part of values, (case, hinge)."""
        creases = [] if self.flaps is None else [(self.flaps.law, sets[:, self.size :])]
        return [(self.joints, sets[:, : self.size]), *creases]


def permanent_folds_of(structure: Structure, size: int, flaps: Flaps | None, cases: int) -> PermanentFolds | None:
    """Return the permanent folds of structures that have not folded yet; None if no hinge folds permanently.

    Args:
        structure: of the first case.
        size: number of joints.
        flaps: creases between flaps.
        cases: number of structures.
    """
    if not path_dependence(structure):
        return None
    # stops are bounds of angles
    free = {"lower": -np.inf, "upper": np.inf, "lock_below": -np.inf, "lock_above": np.inf, "stop_stiffness": 0.0}
    return PermanentFolds(
        joints=replace(
            crease_law(structure, np.arange(size)), **{key: np.full(size, end) for key, end in free.items()}
        ),
        flaps=flaps,
        sets=np.zeros((cases, len(structure.hinges))),
    )
