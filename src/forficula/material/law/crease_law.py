"""The spring of a crease: moment against fold angle, up to where its panels touch, and stops."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True, eq=False)
class CreaseLaw:
    """Springs of creases, linear between two angles and stiffer beyond, with stops; arrays (crease,), or one number.

    Beyond `lock_above` the moment goes on with k 2 w / pi tan(pi x / (2 w)), x from there on and w from there to
    180 deg, where the panels touch: the same slope where it begins, and no end (Liu and Paulino 2017, Proc. R. Soc.
    A 473, 20170348, in fold angles). Below `lock_below` alike. Stops are linear springs on one side.

    Attributes:
        stiffness: k, N m/rad.
        rest_angle: rad.
        lock_below: rad; -inf for none.
        lock_above: rad; inf for none.
        lower: where a stop begins, rad; -inf for none.
        upper: alike; inf for none.
        stop_stiffness: N m/rad.
    """

    stiffness: Array | float
    rest_angle: Array | float = 0.0
    lock_below: Array | float = -math.inf
    lock_above: Array | float = math.inf
    lower: Array | float = -math.inf
    upper: Array | float = math.inf
    stop_stiffness: Array | float = 0.0

    def energy(self, angle: Array, further: Array | float = 0.0) -> Array:
        """Stored energy, J, (..., crease).

<<<<<<< HEAD
        Args:
            angle: fold angle, rad, (..., crease).
            further: by how much the springs rest further on, rad.
        """
        within, beyond, width = self._locked(angle)
        turned = within - self.rest_angle - further
        locked = 4 * width**2 / math.pi**2 * -np.log(np.cos(math.pi * beyond / (2 * width)))
        spring = self.stiffness * (turned**2 / 2 + turned * (angle - within) + locked)
        return np.asarray(spring + self.stop_stiffness / 2 * self._stopped(angle) ** 2)

    def moment(self, angle: Array, further: Array | float = 0.0) -> Array:
        """Slope of the energy, N m: positive where the crease wants back to smaller angles; as `energy`."""
        within, beyond, width = self._locked(angle)
        locked = 2 * width / math.pi * np.tan(math.pi * beyond / (2 * width))
        spring = self.stiffness * (within - self.rest_angle - further + locked)
        return np.asarray(spring + self.stop_stiffness * self._stopped(angle))
=======
    def energy(self, angle: ArrayLike) -> Array:
        """Energy stored, J, in the shape of `angle` (rad); infinite at and beyond contact where it locks."""
        angle = np.asarray(angle, dtype=np.float64)
        linear = np.clip(angle, self.lock_below, self.lock_above)
        bent = linear - self.rest_angle
        energy = self.stiffness * (bent**2 / 2 + bent * (angle - linear))
        for room, share in self._locked(angle):
            locked = -self.stiffness * (2 * room / np.pi) ** 2 * np.log(np.cos(np.pi / 2 * share))
            energy = energy + np.where(share < 1, locked, np.inf)
        below, above = self._stopped(angle)
        return np.asarray(energy + np.asarray(self.stop_stiffness) * (below**2 + above**2) / 2)

    def moment(self, angle: ArrayLike) -> Array:
        """Slope of the energy, N m, in the shape of `angle` (rad); huge, not infinite, at contact and beyond."""
        angle = np.asarray(angle, dtype=np.float64)
        moment = self.stiffness * (np.clip(angle, self.lock_below, self.lock_above) - self.rest_angle)
        for side, (room, share) in zip((-1, 1), self._locked(angle), strict=True):
            moment = moment + side * np.asarray(self.stiffness) * (2 * room / np.pi) * np.tan(np.pi / 2 * share)
        below, above = self._stopped(angle)
        return np.asarray(moment + np.asarray(self.stop_stiffness) * (above - below))
>>>>>>> r3

    def slope(self, angle: Array) -> Array:
        """Slope of the moment, N m/rad, (..., crease)."""
        _, beyond, width = self._locked(angle)
        spring = self.stiffness / np.cos(math.pi * beyond / (2 * width)) ** 2
        return np.asarray(spring + np.where(self._stopped(angle) != 0, self.stop_stiffness, 0.0))

    def _locked(self, angle: Array) -> tuple[Array, Array, Array]:
        """The angle up to where it locks, how far beyond it is, and how far it can be."""
        within = np.clip(angle, self.lock_below, self.lock_above)
        end = np.where(angle < self.lock_below, self.lock_below + math.pi, math.pi - self.lock_above)
        # a spring that does not lock is never beyond
        return within, angle - within, np.where(np.isfinite(end), end, 1.0)

    def _stopped(self, angle: Array) -> Array:
        """How far an angle is beyond a stop, rad, negative below the lower one."""
        return angle - np.clip(angle, self.lower, self.upper)
