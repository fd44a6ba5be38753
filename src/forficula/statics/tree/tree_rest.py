"""Equilibria of bodies on joints in a tree under a load that grows evenly, for a quasi-static stage of a run."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import scipy

from forficula.arrays import Array, Flags
from forficula.statics.rest_path import Creep, rest_path
from forficula.statics.tree.elements import Expansion
from forficula.statics.tree.ensemble import Ensemble, ensemble, torque_scale
from forficula.statics.tree.pose import pose, tree_of
from forficula.statics.tree.potential import hinge_angles, potential, rest
from forficula.statics.tree.tree_path import place_positions
from forficula.structure import (
    GrowingLoad,
    RestPath,
    RestShape,
    Structure,
    distance_to_goal,
    goal_coordinates,
    point_distances,
)

_NEAR = 0.05  # rad, largest turn of a hinge between two neighbouring equilibria
_CORRECTIONS = 20
_FURTHEST = 0.1  # rad, largest turn of a hinge in a step of a creep
_MOST_CREEPS = 500  # steps of a creep
_EXACT = 1e-13  # rad, step of Newton's method that ends it
_AT_BOUND = 1e-12  # rad
_QUIET = 1e-9  # torque that counts as 0, as a share of the largest torque of the stiffest part
_SOFT = 1e-12  # share of the largest stiffness below which a stiffness counts as 0


def tree_rest_path(structure: Structure, start: RestShape, load: GrowingLoad) -> RestPath:
    """Follow the equilibria of a tree under a growing load; see `forficula.statics.rest_path.rest_path`."""
    system = _LoadedTree(structure, load)
    sets = np.zeros(0) if start.sets is None else start.sets
    return rest_path(system, np.concatenate([start.angles[: system.size], sets]), load)


class _LoadedTree:
    """A tree under a load.

    Its states are the angles of the joints, rad, (joint,), and then, if a hinge folds permanently, the permanent folds
    of all hinges, rad, (hinge,).
    """

    def __init__(self, structure: Structure, load: GrowingLoad) -> None:
        self._structure, self._load = structure, load
        self._structures: Ensemble = ensemble([structure])
        self._tree = tree_of(structure)
        self._lower, self._upper = self._structures.lower[None], self._structures.upper[None]
        self._damping = np.array([hinge.damping for hinge in structure.hinges[: self._structures.size]])
        self._spread, self._quiet = np.eye(self._structures.size), _QUIET * torque_scale(self._structures)
        if (ties := self._structures.ties) is not None:
            self._spread = ties.spread
            self._lower, self._upper = ties.bounds(self._lower, self._upper)

    @property
    def size(self) -> int:
        """Return the number of joints."""
        return self._structures.size

    @property
    def prescribes(self) -> Flags:
        return np.zeros(len(self._structure.motors), dtype=np.bool_)

    def _at(self, state: Array) -> tuple[Ensemble, Array]:
        """Return the tree with the permanent folds of a state, and the angles of the joints, rad, (joint,)."""
        angles, sets = state[: self.size], state[self.size :]
        structures = self._structures
        return structures.with_sets(sets[None]), angles

    @staticmethod
    def _state(structures: Ensemble, angles: Array) -> Array:
        """Return the state after a motion of the tree to some angles, rad, (joint,)."""
        sets = structures.turned(angles[None]).sets
        return angles if sets is None else np.concatenate([angles, sets[0]])

    def rest(self, share: float, near: Array) -> Array | None:
        torques, (structures, start) = self._load.settings(share), self._at(near)
        descended = rest(structures, start[None], torques, within=2 * _NEAR)
        if not descended.rests[0] or np.abs(descended.position[0] - start).max(initial=0.0) > _NEAR:
            return None
        angles = self._corrected(structures, descended.position[0], torques)
        if angles is None or np.abs(angles - start).max(initial=0.0) > _NEAR:
            return None
        return self._state(structures, angles)

    def _corrected(self, structures: Ensemble, angles: Array, torques: Array) -> Array | None:
        """Return the stable equilibrium near angles by Newton's method, to the last digits; None if there is none.

        Directions without stiffness, such as that of a hinge with a slack tendon, are at rest if no torque acts.
        """
        ties = self._structures.ties
        for _ in range(_CORRECTIONS):
            _, slope, curvature = potential(structures, angles[None], torques)
            at = angles if ties is None else ties.start(angles[None])[0]
            push = slope[0] @ self._spread
            held = ((at <= self._lower[0] + _AT_BOUND) & (push > 0)) | ((at >= self._upper[0] - _AT_BOUND) & (push < 0))
            free = self._spread[:, ~held]
            if not free.shape[1]:
                return angles
            values, axes = scipy.linalg.eigh(free.T @ curvature[0] @ free)
            least = _SOFT * max(float(np.abs(curvature[0]).max()), 1e-300)
            soft, along = values <= least, axes.T @ (free.T @ slope[0])
            if np.any(values < -least) or np.any(np.abs(along[soft]) > self._quiet):
                return None
            # no correction along directions without stiffness
            step = -free @ (axes @ np.divide(along, values, out=np.zeros_like(along), where=~soft))
            angles = angles + step
            if np.abs(step).max(initial=0.0) <= _EXACT:
                return np.asarray(np.clip(angles, self._structures.lower, self._structures.upper))
        return None

    def creep(self, share: float, start: Array) -> Creep[Array] | None:
        """Return the motion to an equilibrium under the dampers of the joints, without inertia.

        Every step is one of Euler's implicit method: it minimises the potential plus the dissipation of the step. Steps
        grow, so that the dissipation vanishes and the potential alone decides where the structure rests. Other dampers
        are left out. They slow the motion down, so the speed is not underestimated.
        """
        torques, first = self._load.settings(share), start
        shortest = step = _NEAR / self._load.rest_speed
        for _ in range(_MOST_CREEPS):
            structures, angles = self._at(start)
            descended = rest(structures, angles[None], torques, pull=_drag(self._damping / step, angles))
            turned = float(np.abs(descended.position[0] - angles).max(initial=0.0))
            if not descended.rests[0] or turned > _FURTHEST:
                step /= 2
                if step < shortest:
                    return None
                continue
            if turned > self._load.rest_speed * step:
                return None
            start, step = self._state(structures, descended.position[0]), 2 * step
            end = self.rest(share, start) if turned <= _NEAR else None
            if end is not None:
                # both energies with their own permanent folds, without what these dissipate
                energies = [float(potential(*self._single(at), torques)[0][0]) for at in (first, end)]
                return Creep(end, energies[0] - energies[1] - self.yield_loss(first, end))
        return None

    def _single(self, state: Array) -> tuple[Ensemble, Array]:
        structures, angles = self._at(state)
        return structures, angles[None]

    def yield_loss(self, before: Array, after: Array) -> float:
        folds = self._at(before)[0].folds
        return 0.0 if folds is None else folds.loss(after[self.size :])

    def middle(self, one: Array, other: Array) -> Array:
        # the motion begins with the permanent folds of the first state
        return np.concatenate([(one + other)[: self.size] / 2, one[self.size :]])

    def conjugates(self, _share: float, state: Array) -> Array:
        # the potential is linear in the torques and forces
        count = len(self._structure.motors)
        torques = np.concatenate([np.zeros((1, count)), np.eye(count)])
        structures, angles = self._at(state)
        energy = potential(structures.repeated(count + 1), np.tile(angles, (count + 1, 1)), torques)[0]
        return np.asarray(energy[0] - energy[1:])

    def short_of_goal(self, state: Array) -> float:
        goal = self._load.goal
        if goal.kind != "bounds":
            return np.inf
        distances = point_distances(self._structure, self.shape(state).points)
        return distance_to_goal(goal_coordinates(self._structure, self._hinge_angles(state), distances), goal)

    def _hinge_angles(self, state: Array) -> Array:
        return np.asarray(hinge_angles(self._structures, state[None, : self.size])[0])

    def shape(self, state: Array) -> RestShape:
        structure, angles = self._structure, state[None, : self.size]
        at = pose(self._tree, angles)
        count = len(structure.bodies)
        return RestShape(
            angles=self._hinge_angles(state),
            points=place_positions(structure, angles)[0][: len(structure.points)],
            origins=at.origins[0, :count],
            frames=at.frames[0, :count],
            sets=None if self._structures.sets is None else state[self.size :],
        )


def _drag(damping: Array, start: Array) -> Callable[[Array], Expansion]:
    """Return half the dissipation of a step from some angles as an energy; damping is divided by the step, N m/rad."""

    def energy(angles: Array) -> Expansion:
        turned = angles - start
        curvature = np.tile(np.diag(damping), (len(angles), 1, 1))
        return np.sum(damping * turned**2, axis=1) / 2, damping * turned, curvature

    return energy
