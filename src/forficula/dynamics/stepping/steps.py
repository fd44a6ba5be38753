"""Results of steps of structures: states before and after each step, and derived fields of the engine."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import mujoco
import numpy as np
from numpy.typing import NDArray

from forficula.arrays import Array, Indices
from forficula.dynamics.engine.crease_rows import without_jump
from forficula.dynamics.engine.model import Model
from forficula.dynamics.stepping.folds import Folds
from forficula.dynamics.stepping.passage import Conditions, Passage, passage_of
from forficula.material.law.crease_memory import turned_memory

# the full state that a step depends on, and the part that a step changes: time, positions and velocities first
STATE = mujoco.mjtState.mjSTATE_INTEGRATION.value
MOVING = STATE & ~mujoco.mjtState.mjSTATE_USER.value
# name of the memory of creases among the fields of a state
MEMORY = "crease_memory"


class StepContacts(NamedTuple):
    """Contacts of facets and plates in steps of structures, in their models' units.

    Attributes:
        forces: generalised forces in each step, (structure, step, dof).
        overlaps: largest overlap in each step as a share of the thickness, (structure, step).
        friction_springs: `FrictionSprings` before the first step and after each step, (structure, step + 1).
    """

    forces: Array
    overlaps: Array
    friction_springs: NDArray[np.object_]

    @classmethod
    def allocated(cls, structures: int, steps: int, dof: int) -> StepContacts:
        """Allocate memory for steps of some structures."""
        shape = (structures, steps)
        return cls(np.zeros((*shape, dof)), np.zeros(shape), np.empty((structures, steps + 1), dtype=object))

    def some(self, rows: slice) -> StepContacts:
        """Select structures."""
        return StepContacts(self.forces[rows], self.overlaps[rows], self.friction_springs[rows])


@dataclass(frozen=True, kw_only=True)
class Steps:
    """Steps of some structures, in their models' units; later steps of the stepper overwrite them.

    Attributes:
        positions: length of a position.
        dof: length of a velocity: one less for every body that turns freely.
        inner: slices of the changing state with the forces of Maxwell branches ("act") and the resting lengths of
            yielding tendons ("plastic"), if there are any, by MuJoCo's names.
        before: changing state before the first step, (structure, number): time, positions, velocities, and more.
        after: changing state after each step, (structure, step, number).
        derived: MuJoCo's fields of the state before each step, (structure, step, ...).
        kept: names of the fields from which the states of a record are computed.
        late: the same fields of the state after each step, up to the third power of the timestep, for steps of Runge
            and Kutta; None for other steps.
        angles: of the creases at the start of every block of steps with constant rows, in own senses and without jumps,
            rad, (structure, block, crease); None without creases.
        memory: of the creases in every block, see `CreaseLaw`, (slot, structure, block, crease); None without creases.
        memory_before: that before the first block, (slot, structure, crease).
        followed: number of steps of a block.
        contact: contacts of facets and plates; None without such contacts.
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
    memory: Array | None = None
    memory_before: Array | None = None
    followed: int = 1
    contact: StepContacts | None = None

    @property
    def count(self) -> int:
        """Return the number of steps."""
        return int(self.after.shape[1])

    @property
    def time(self) -> Array:
        """Return the time after each step, (structure, step)."""
        return self.after[:, :, 0]

    @property
    def position(self) -> Array:
        """Return the positions after each step, (structure, step, position)."""
        return self.after[:, :, 1 : 1 + self.positions]

    @property
    def velocity(self) -> Array:
        """Return the velocities after each step, (structure, step, dof)."""
        return self.after[:, :, 1 + self.positions : 1 + self.positions + self.dof]

    @property
    def velocity_before(self) -> Array:
        """Return the velocities before the first step, (structure, dof)."""
        return self.before[:, 1 + self.positions : 1 + self.positions + self.dof]

    @property
    def position_before(self) -> Array:
        """Return the positions before the first step, (structure, position)."""
        return self.before[:, 1 : 1 + self.positions]

    def passage(self, conditions: Conditions) -> Passage:
        """Return the passage of the structures through the steps."""
        return passage_of(self, conditions)

    def angles_of(self, folds: Folds, structure: int, positions: Array, step: Indices, hinges: Indices) -> Array:
        """Return angles of some hinges of a structure in own senses, without jumps, rad, (state, hinge).

        Args:
            folds: of the structure.
            structure: its index among the stepped structures.
            positions: (state, dof).
            step: number of steps before each state, (state,).
            hinges: their numbers.
        """
        some = folds.some(hinges)
        angles = some.angles(positions)
        if self.angles is not None:
            near = self.angles[structure, np.minimum(step // self.followed, self.angles.shape[1] - 1)]
            near = near[:, np.searchsorted(folds.creases, hinges[some.creases])]
            angles[:, some.creases] = without_jump(angles[:, some.creases], near)
        return angles

    def memory_at(self, model: Model, structure: int, step: Indices, angles: Array) -> Array:
        """Return the memory of creases in some states, (slot, state, crease); sets are those of the block.

        Args:
            model: of the structure.
            structure: its index among the stepped structures.
            step: number of steps before each state, (state,).
            angles: of the creases in these states, rad, (state, crease).
        """
        assert self.angles is not None
        assert self.memory is not None
        assert model.creases is not None
        block = np.minimum(step // self.followed, self.angles.shape[1] - 1)
        memory = self.memory[:, structure, block]
        if len(memory) == 1:
            return memory
        late, turned = step - block * self.followed, angles - self.angles[structure, block]
        for steps in np.unique(late).tolist():
            which = late == steps
            memory[:, which] = turned_memory(model.creases.law, memory[:, which], turned[which], steps * model.timestep)
        return memory

    def activations(self) -> Array:
        """Return the activations before the first step and after each step, (structure, step + 1, activation)."""
        place = self.inner.get("act", slice(0, 0))
        return np.concatenate([self.before[:, None, place], self.after[:, :, place]], axis=1)

    def states(self, structure: Indices, taken: Indices, part: slice = slice(None)) -> Array:
        """Return the states, or parts of them, (state, number), for pairs of structures and numbers of steps."""
        states = self.after[:, :, part][structure, taken - 1]
        states[taken == 0] = self.before[structure[taken == 0], part]
        return states


@dataclass(frozen=True, kw_only=True)
class EngineState:
    """State of a structure, in its model's units.

    Attributes:
        position: of its joints, (dof,).
        velocity: of its joints, (dof,).
        angle: of its hinges in their own senses, rad, (hinge,).
        derived: MuJoCo's fields from which the states of a record are computed, by name.
    """

    position: Array
    velocity: Array
    angle: Array
    derived: Mapping[str, Array]
