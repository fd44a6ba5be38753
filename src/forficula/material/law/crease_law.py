"""Moment of a crease against its fold angle."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from forficula.errors import InputError

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class CreaseLaw:
    """Springs of creases: linear, stiffening towards contact of the panels, with stops.

    The moment is the slope of the energy by the fold angle (0 flat, valley positive, contact at +-pi): positive where
    the spring pulls the angle down. Between `lock_below` and `lock_above` it is stiffness (angle - rest_angle). Beyond
    them the slope rises as 1 / cos^2 and the moment diverges at contact (Liu and Paulino 2017, Proc. R. Soc. A 473:
    20170348, there by the angle from contact). Stops are linear springs on one side, beside that. The numbers
    may be arrays, for many creases at once, that go with the angles.

    Attributes:
        stiffness: N m/rad.
        rest_angle: rad.
        lock_below: angle below which it stiffens, rad, > -pi; -inf where it does not.
        lock_above: angle above which it stiffens, rad, < pi; inf where it does not.
        lower: angle of the lower stop, rad; -inf for none.
        upper: angle of the upper stop, rad; inf for none.
        stop_stiffness: of both stops, N m/rad.

    Raises:
        InputError: a number out of these bounds, or bounds that cross.
    """

    stiffness: Array | float
    rest_angle: Array | float = 0.0
    lock_below: Array | float = -np.inf
    lock_above: Array | float = np.inf
    lower: Array | float = -np.inf
    upper: Array | float = np.inf
    stop_stiffness: Array | float = 0.0

    def __post_init__(self) -> None:
        for name in ("stiffness", "stop_stiffness"):
            value = np.asarray(getattr(self, name))
            if not np.all(np.isfinite(value) & (value >= 0)):
                raise InputError(f"{name}: need a finite number >= 0, got {_worst(value):g} N m/rad")
        if not np.all(np.isfinite(self.rest_angle)):
            raise InputError(f"rest_angle: need a finite angle, got {_worst(self.rest_angle):g} rad")
        for name in ("lock_below", "lock_above"):
            value = np.asarray(getattr(self, name))
            if not np.all(np.isinf(value) | (np.abs(value) < np.pi)):
                raise InputError(f"{name}: need an angle between -180 deg and 180 deg, got {np.rad2deg(value)} deg")
        for low, high in (("lock_below", "lock_above"), ("lower", "upper")):
            if not np.all(np.asarray(getattr(self, low)) < np.asarray(getattr(self, high))):
                raise InputError(f"{low}: need an angle below {high}, got one that is not")

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

    def slope(self, angle: ArrayLike) -> Array:
        """Slope of the moment, N m/rad, in the shape of `angle` (rad)."""
        angle = np.asarray(angle, dtype=np.float64)
        slope = np.broadcast_to(np.asarray(self.stiffness, dtype=np.float64), angle.shape)
        for _, share in self._locked(angle):
            slope = slope / np.cos(np.pi / 2 * share) ** 2
        below, above = self._stopped(angle)
        return np.asarray(slope + np.asarray(self.stop_stiffness) * ((below > 0) | (above > 0)))

    def _locked(self, angle: Array) -> tuple[tuple[Array, Array], tuple[Array, Array]]:
        """Below and above: the angle from where it stiffens to contact, and the share of it that is used up."""
        sides = []
        for sign, lock in ((-1, self.lock_below), (1, self.lock_above)):
            room = np.pi - sign * np.where(np.isinf(lock), 0.0, lock)
            past = np.where(np.isinf(lock), 0.0, np.maximum(sign * (angle - np.where(np.isinf(lock), 0.0, lock)), 0.0))
            sides.append((room, np.minimum(past / room, 1.0)))
        return sides[0], sides[1]

    def _stopped(self, angle: Array) -> tuple[Array, Array]:
        return np.maximum(self.lower - angle, 0.0), np.maximum(angle - self.upper, 0.0)


def _worst(value: ArrayLike) -> float:
    value = np.asarray(value, dtype=np.float64)
    return float(value.flat[np.argmin(np.where(np.isfinite(value), value, -np.inf))])
