"""A part of an assembly: the numbers of its components in the assembly, and its position."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array, Indices
from forficula.pattern.rotation import RigidMotion
from forficula.structure.parts import GROUND
from forficula.structure.structure import Structure


@dataclass(frozen=True, kw_only=True)
class JoinedPart:
    """A part of an assembly, the numbers of its components in the assembly, and its position.

    Attributes:
        name: name of the part.
        structure: structure of the part alone, with its protocol.
        first_body: number in the assembly of its first body.
        first_point: number in the assembly of its first point.
        hinges: number in the assembly of each of its hinges, (hinge,); empty until all parts are laid out.
        base: number in the assembly of the body that carries what the part fixes to the ground, or GROUND.
        motion: from the axes of the part to those of the assembly, as built.
        carried: from the axes of the part to those of `base`.
    """

    name: str
    structure: Structure
    first_body: int
    first_point: int
    hinges: tuple[int, ...] = ()
    base: int
    motion: RigidMotion
    carried: RigidMotion

    def body(self, number: int) -> int:
        """Return the number in the assembly of a body of the part, or of its ground."""
        return self.base if number == GROUND else self.first_body + number

    def place(self, body: int, place: Array) -> Array:
        """Transform a position on a body of the part, or on its ground, to the axes of `self.body(body)`, m."""
        return self.carried.of(place) if body == GROUND and self._moves else place

    def places(self, bodies: Indices, places: Array) -> Array:
        """Transform positions as `place` does, m, (..., 3)."""
        grounded = (bodies == GROUND)[..., None]
        return np.where(grounded, self.carried.of(places), places) if grounded.any() and self._moves else places

    def numbers(self, bodies: Indices) -> Indices:
        """Return numbers of bodies as `body` does."""
        return np.where(bodies == GROUND, self.base, bodies + self.first_body)

    def point_numbers(self, points: Sequence[int]) -> tuple[int, ...]:
        """Return the numbers in the assembly of points of the part."""
        return tuple(self.first_point + point for point in points)

    @property
    def _moves(self) -> bool:
        motion = self.carried
        return self.base != GROUND or bool(motion.shift.any()) or not np.array_equal(motion.rotation, np.eye(3))

    def full_name(self, name: str) -> str:
        """Return the name in the assembly of a component: the name of the part comes first."""
        return f"{self.name}.{name}"
