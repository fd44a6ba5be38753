"""What steps of structures leave: states before and after each, and what the engine derives of them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics.engine.crease_rows import without_jump
from forficula.dynamics.stepping.folds import Folds


@dataclass(frozen=True, kw_only=True)
class Steps:
    """Steps of some structures, in their models' units; the stepper's next ones overwrite them.

    Attributes:
        positions: how many numbers a position has.
        dof: how many a velocity has: one less for every body that turns freely.
        inner: where in what a step changes the forces of Maxwell branches ("act") and the resting lengths of tendons
            that yield ("plastic") are, if there are any, by MuJoCo's names.
        before: what a step changes, before the first step, (structure, number): time, positions, velocities, and more.
        after: likewise, after each step, (structure, step, number).
        derived: MuJoCo's fields of the state before each step, (structure, step, ...).
        kept: names of those that the states of a record are read from.
        late: the same of the state after each step, but for its third power of the timestep, where steps are those of
            Runge and Kutta; None where they are not.
        angles: of the creases at the start of every block of steps in which their rows stay, in own senses and without
            jumps, rad, (structure, block, crease); None where there are none.
        followed: steps of a block.
    """

    positions: int
    dof: int
    inner: Mapping[str, slice]
    before: Array
    after: Array
    derived: Mapping[str, Array]
    kept: Sequence[str]
    late: Mapping[str, Array] | None = None
    angles: Array | None = None
    followed: int = 1

    @property
    def time(self) -> Array:
        """After each step, (structure, step)."""
        return self.after[:, :, 0]

    @property
    def position(self) -> Array:
        """After each step, (structure, step, position)."""
        return self.after[:, :, 1 : 1 + self.positions]

    @property
    def velocity(self) -> Array:
        """After each step, (structure, step, dof)."""
        return self.after[:, :, 1 + self.positions : 1 + self.positions + self.dof]

    @property
    def velocity_before(self) -> Array:
        """Before the first step, (structure, dof)."""
        return self.before[:, 1 + self.positions : 1 + self.positions + self.dof]

    @property
    def position_before(self) -> Array:
        """Before the first step, (structure, position)."""
        return self.before[:, 1 : 1 + self.positions]

    def angles_of(self, folds: Folds, structure: int, positions: Array, step: Indices, hinges: Indices) -> Array:
        """Angles of some hinges of a structure in own senses, without jumps, rad, (state, hinge).

        Args:
            folds: of the structure.
            structure: its place among those stepped.
            positions: (state, dof).
            step: how many of the steps came before each state, (state,).
            hinges: their numbers.
        """
        some = folds.some(hinges)
        angles = some.angles(positions)
        if self.angles is not None:
            near = self.angles[structure, np.minimum(step // self.followed, self.angles.shape[1] - 1)]
            near = near[:, np.searchsorted(folds.creases, hinges[some.creases])]
            angles[:, some.creases] = without_jump(angles[:, some.creases], near)
        return angles

    def activation(self, structure: int, taken: int) -> Array:
        """Of a structure before the first of so many steps and after each, (step + 1, activation)."""
        place = self.inner.get("act", slice(0, 0))
        return np.concatenate([self.before[structure, None, place], self.after[structure, :taken, place]])

    def states(self, structure: Indices, taken: Indices, part: slice = slice(None)) -> Array:
        """What structures are in after so many steps, or a part of it, (state, number), for pairs of the two."""
        states = self.after[:, :, part][structure, taken - 1]
        states[taken == 0] = self.before[structure[taken == 0], part]
        return states


@dataclass(frozen=True, kw_only=True)
class EngineState:
    """What a structure is in, in its model's units.

    Attributes:
        position: of its joints, (dof,).
        velocity: likewise.
        angle: of its hinges in their own senses, rad, (hinge,).
        derived: all fields of MuJoCo that states are read from, by their names.
    """

    position: Array
    velocity: Array
    angle: Array
    derived: Mapping[str, Array]
