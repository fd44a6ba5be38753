"""Equilibria of bodies on joints in a tree under a load that grows evenly, for a quasi-static stage of a run."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import scipy

from forficula.arrays import Array, Flags
from forficula.statics.rest_path import CreaseLosses, Creep, crease_losses, rest_path
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
    return rest_path(system, system.state(start), load)


class _TreeState(NamedTuple):
    """Angles of a tree, and the beginning of the motion to them.

    The motion to an equilibrium has ended, so that the share, the memory and the angles are those of the equilibrium.

    Attributes:
        angles: of the joints, rad, (joint,).
        share: share of the load at which the motion began.
        memory: of all hinges at its beginning, (slot, hinge); None if no hinge remembers anything.
        begin: angles of the joints at its beginning, rad, (joint,).
    """

    angles: Array
    share: float
    memory: Array | None
    begin: Array


class _LoadedTree:
    """A tree under a load."""

    def __init__(self, structure: Structure, load: GrowingLoad) -> None:
        self._structure, self._load = structure, load
        self._structures: Ensemble = ensemble([structure], timed=True)
        self._tree = tree_of(structure)
        self._lower, self._upper = self._structures.lower[None], self._structures.upper[None]
        self._damping = np.array([hinge.damping for hinge in structure.hinges[: self._structures.size]])
        self._spread, self._quiet = np.eye(self._structures.size), _QUIET * torque_scale(self._structures)
        if (ties := self._structures.ties) is not None:
            self._spread = ties.spread
            self._lower, self._upper = ties.bounds(self._lower, self._upper)

    def state(self, start: RestShape) -> _TreeState:
        """Return the state of a shape."""
        angles = start.angles[: self._structures.size]
        return _TreeState(angles, self._load.begin, start.memory, angles)

    @property
    def relaxes(self) -> bool:
        memory = self._structures.memory
        return memory is not None and any(law.relaxes for law in memory.laws)

    @property
    def prescribes(self) -> Flags:
        return np.zeros(len(self._structure.motors), dtype=np.bool_)

    def _moving(self, state: _TreeState, share: float) -> Ensemble:
        """Return the tree in the motion from the beginning of a state to a share of the load."""
        if state.memory is None:
            return self._structures
        time = (share - state.share) * self._load.duration
        return self._structures.beginning(state.memory[:, None], state.begin[None], time)

    @staticmethod
    def _reached(structures: Ensemble, angles: Array, share: float) -> _TreeState:
        """Return the state after a motion of the tree to some angles, rad, (joint,)."""
        memory = structures.turned(angles[None]).memory
        return _TreeState(angles, share, None if memory is None else memory.values[:, 0], angles)

    def rest(self, share: float, near: _TreeState) -> _TreeState | None:
        torques, structures, start = self._load.settings(share), self._moving(near, share), near.angles
        descended = rest(structures, start[None], torques, within=2 * _NEAR)
        if not descended.rests[0] or np.abs(descended.position[0] - start).max(initial=0.0) > _NEAR:
            return None
        angles = self._corrected(structures, descended.position[0], torques)
        if angles is None or np.abs(angles - start).max(initial=0.0) > _NEAR:
            return None
        return self._reached(structures, angles, share)

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

    def creep(self, share: float, start: _TreeState) -> Creep[_TreeState] | None:
        """Return the motion to an equilibrium under the dampers of the joints, without inertia.

        Every step is one of Euler's implicit method: it minimises the potential plus the dissipation of the step. Steps
        grow, so that the dissipation vanishes and the potential alone decides where the structure rests. Other dampers
        are left out. They slow the motion down, so the speed is not underestimated. The time of the stage does not
        advance, so Maxwell branches follow like springs.
        """
        torques, first = self._load.settings(share), start
        shortest = step = _NEAR / self._load.rest_speed
        for _ in range(_MOST_CREEPS):
            structures, angles = self._moving(start, share), start.angles
            descended = rest(structures, angles[None], torques, pull=_drag(self._damping / step, angles))
            turned = float(np.abs(descended.position[0] - angles).max(initial=0.0))
            if not descended.rests[0] or turned > _FURTHEST:
                step /= 2
                if step < shortest:
                    return None
                continue
            if turned > self._load.rest_speed * step:
                return None
            start, step = self._reached(structures, descended.position[0], share), 2 * step
            end = self.rest(share, start) if turned <= _NEAR else None
            if end is not None:
                # both energies with their own memory, without what the hinges dissipate
                energies = [
                    float(potential(self._moving(at, at.share), at.angles[None], torques)[0][0]) for at in (first, end)
                ]
                return Creep(end, energies[0] - energies[1] - sum(self.crease_losses(first, end).values()))
        return None

    def crease_losses(self, before: _TreeState, after: _TreeState) -> CreaseLosses:
        if (memory := self._moving(before, after.share).memory) is None:
            return {}
        return crease_losses(memory.laws, memory.losses(after.angles[None]))

    def middle(self, one: _TreeState, other: _TreeState) -> _TreeState:
        # the motion begins with the memory of the first state
        return one._replace(angles=(one.angles + other.angles) / 2)

    def conjugates(self, _share: float, state: _TreeState) -> Array:
        # the potential is linear in the torques and forces
        count = len(self._structure.motors)
        torques = np.concatenate([np.zeros((1, count)), np.eye(count)])
        structures, angles = self._moving(state, state.share), state.angles
        energy = potential(structures.repeated(count + 1), np.tile(angles, (count + 1, 1)), torques)[0]
        return np.asarray(energy[0] - energy[1:])

    def short_of_goal(self, state: _TreeState) -> float:
        goal = self._load.goal
        if goal.kind != "bounds":
            return np.inf
        distances = point_distances(self._structure, self.shape(state).points)
        return distance_to_goal(goal_coordinates(self._structure, self._hinge_angles(state), distances), goal)

    def _hinge_angles(self, state: _TreeState) -> Array:
        return np.asarray(hinge_angles(self._structures, state.angles[None])[0])

    def shape(self, state: _TreeState) -> RestShape:
        structure, angles = self._structure, state.angles[None]
        at = pose(self._tree, angles)
        count = len(structure.bodies)
        return RestShape(
            angles=self._hinge_angles(state),
            points=place_positions(structure, angles)[0][: len(structure.points)],
            origins=at.origins[0, :count],
            frames=at.frames[0, :count],
            memory=state.memory,
        )


def _drag(damping: Array, start: Array) -> Callable[[Array], Expansion]:
    """Return half the dissipation of a step from some angles as an energy; damping is divided by the step, N m/rad."""

    def energy(angles: Array) -> Expansion:
        turned = angles - start
        curvature = np.tile(np.diag(damping), (len(angles), 1, 1))
        return np.sum(damping * turned**2, axis=1) / 2, damping * turned, curvature

    return energy
