"""Memory of the hinges of trees of joints, side by side: permanent folds, wear and Maxwell branches."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from forficula.arrays import Array, Indices
from forficula.material.law.crease_law import CreaseLaw
from forficula.material.law.crease_memory import start_memory, stored_energy
from forficula.material.law.crease_turn import (
    CreaseTurn,
    TurnLosses,
    memory_after,
    relaxed,
    remembers,
    turn_expansion,
    turn_losses,
)
from forficula.statics.tree.flaps import Flaps, crease_angles
from forficula.structure import Structure, crease_law


@dataclass(frozen=True, kw_only=True)
class HingeMemory:
    """Memory of all hinges of structures at the beginning of a motion: of the joints, then of the creases.

    In the motion each hinge turns in one sense. Its moment then depends on its angle alone, and the energy of its
    spring includes what it dissipates (see `crease_turn`).

    Attributes:
        joints: law of the joints' springs, (joint,); their stops are bounds of angles.
        flaps: creases between flaps; None if there are none.
        turn: memory and angles of all hinges at the beginning, (slot, case, hinge) and rad, (case, hinge).
    """

    joints: CreaseLaw
    flaps: Flaps | None
    turn: CreaseTurn

    @property
    def laws(self) -> list[CreaseLaw]:
        """Return the laws of joints and of creases."""
        return [law for law, _ in self._parts()]

    @property
    def values(self) -> Array:
        """Return the memory at the beginning of the motion, (slot, case, hinge)."""
        return self.turn.memory

    def only(self, cases: Indices) -> HingeMemory:
        """Select cases by index; repeats are allowed."""
        turn = replace(self.turn, memory=self.turn.memory[:, cases], angle=self.turn.angle[cases])
        return replace(self, turn=turn)

    def new(self, angles: Array) -> HingeMemory:
        """Return the memory of new structures that start at the angles of the joints, rad, (case, joint)."""
        every = self._hinge_angles(angles)
        parts = [start_memory(law, every[:, which]) for law, which in self._parts()]
        return replace(self, turn=CreaseTurn(memory=self._joined(parts), angle=every))

    def turned(self, angles: Array) -> HingeMemory:
        """Return the memory after a motion to the angles of the joints, rad, (case, joint)."""
        every = self._hinge_angles(angles)
        parts = [memory_after(law, every[:, which], self._part(law, which)) for law, which in self._parts()]
        return replace(self, turn=CreaseTurn(memory=self._joined(parts), angle=every))

    def beginning(self, memory: Array, angles: Array, time: float = 0.0) -> HingeMemory:
        """Return the memory of structures whose motion begins with a memory, (slot, case, hinge).

        Args:
            memory: at the beginning.
            angles: of the joints at the beginning, rad, (case, joint).
            time: duration of the motion, s.
        """
        return replace(self, turn=CreaseTurn(memory=memory, angle=self._hinge_angles(angles), time=time))

    def joint_expansion(self, angles: Array) -> tuple[Array, Array, Array]:
        """Compute energy, moment and slope of the joints' springs, (case, joint). The energy includes losses."""
        law, which = self._parts()[0]
        return turn_expansion(law, angles, self._part(law, which))

    @property
    def of_creases(self) -> CreaseTurn | None:
        """Return the turn of the creases, (case, crease); None if there are none."""
        return None if self.flaps is None else self._part(*self._parts()[1])

    def stored(self, angles: Array, further: Array) -> tuple[Array, Array]:
        """Return the energies of joints and of creases with the memory at the end of a motion, J, (case,) each.

        Args:
            angles: of the joints, rad, (case, joint), at which the memory is that of `turn`.
            further: changes of the rest angles, rad, (case, hinge).
        """
        every = self._hinge_angles(angles)
        of_joints, *of_creases = (
            stored_energy(law, every[:, which], further[:, which], self.turn.memory[: law.slots, :, which]).sum(axis=1)
            for law, which in self._parts()
        )
        return of_joints, of_creases[0] if of_creases else np.zeros(len(angles))

    def losses(self, angles: Array) -> TurnLosses:
        """Return what hinges dissipate until the joints have some angles, rad, (case, joint), J, (case,) each."""
        every = self._hinge_angles(angles)
        parts = [turn_losses(law, every[:, which], self._part(law, which)) for law, which in self._parts()]
        return TurnLosses(*(sum(np.sum(lost, axis=1) for lost in part) for part in zip(*parts, strict=True)))

    def _hinge_angles(self, angles: Array) -> Array:
        # a copy, because callers change angles in place
        angles = np.array(angles[:, : self._size])
        return angles if self.flaps is None else np.concatenate([angles, crease_angles(self.flaps, angles)], axis=1)

    @property
    def _size(self) -> int:
        """Return the number of joints."""
        return len(np.asarray(self.joints.stiffness))

    def _parts(self) -> list[tuple[CreaseLaw, slice]]:
        """Return the laws of joints and creases with the numbers of their hinges."""
        creases = [] if self.flaps is None else [(self.flaps.law, slice(self._size, None))]
        return [(self.joints, slice(self._size)), *creases]

    def _part(self, law: CreaseLaw, which: slice) -> CreaseTurn:
        """Return the turn of some hinges with a law, which may have fewer branches than others."""
        turn = self.turn
        return CreaseTurn(memory=turn.memory[: law.slots, :, which], angle=turn.angle[:, which], time=turn.time)

    def _joined(self, parts: list[Array]) -> Array:
        """Return the memory of all hinges, (slot, case, hinge), from those of joints and of creases."""
        memory = np.zeros((len(self.turn.memory), parts[0].shape[1], sum(part.shape[2] for part in parts)))
        for (_, which), part in zip(self._parts(), parts, strict=True):
            memory[: len(part), :, which] = part
        return memory


def hinge_memory_of(
    structure: Structure, size: int, flaps: Flaps | None, cases: int, *, timed: bool = False
) -> HingeMemory | None:
    """Return the memory of structures that have not folded yet; None if no hinge remembers anything.

    Args:
        structure: of the first case.
        size: number of joints.
        flaps: creases between flaps.
        cases: number of structures.
        timed: whether motions have durations, which Maxwell branches follow; otherwise the branches are relaxed.
    """
    # stops are bounds of angles
    free = {"lower": -np.inf, "upper": np.inf, "lock_below": -np.inf, "lock_above": np.inf, "stop_stiffness": 0.0}
    joints = replace(crease_law(structure, np.arange(size)), **{key: np.full(size, end) for key, end in free.items()})
    if not timed:
        joints = relaxed(joints)
        flaps = None if flaps is None else replace(flaps, law=relaxed(flaps.law))
    laws = [joints, *([] if flaps is None else [flaps.law])]
    if not any(remembers(law) for law in laws):
        return None
    count = len(structure.hinges)
    turn = CreaseTurn(memory=np.zeros((max(law.slots for law in laws), cases, count)), angle=np.zeros((cases, count)))
    return HingeMemory(joints=joints, flaps=flaps, turn=turn)
