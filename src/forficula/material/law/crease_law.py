"""Moment of a crease as a function of its fold angle."""

from __future__ import annotations

import copy
import dataclasses
import math
from dataclasses import dataclass, field
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from forficula.arrays import Array, Flags, Indices
from forficula.errors import InputError


@dataclass(frozen=True, kw_only=True)
class CreaseDamage:
    """Loss of the moment of a crease with its wear; see `CreaseLaw`.

    Attributes:
        loss: share of the moment that is lost after infinitely many turns, > 0 and <= 1.
        turn: wear after which 63 % of this share is lost, rad, > 0.
        by_set: whether the wear is the sum of the changes of the set instead of that of all turns.
    """

    loss: float
    turn: float
    by_set: bool = False


@dataclass(frozen=True, kw_only=True, eq=False)
class CreaseLaw:
    """Springs of creases: nonlinear, stiffening towards contact of the panels, with stops, and with memory.

    The moment is the derivative of the energy by the fold angle (0 flat, contact at +-pi), positive if the spring
    reduces the angle. Between `lock_below` and `lock_above` it is stiffness (angle - rest_angle). Beyond these angles
    its slope increases as 1 / cos^2, and it tends to infinity at contact (Liu and Paulino 2017, Proc. R. Soc. A 473,
    20170348, who use the angle from contact). With x = angle - rest_angle, the spring adds the moment quadratic x^2 +
    cubic x^3. Stops are additional one-sided linear springs. The numbers may be arrays for many creases, which
    broadcast with the angles.

    A crease may yield: two springs in parallel have the given stiffness together. One is elastic, with the stiffness
    `hardening`. The rest angle of the other one creeps so that it is never turned by more than `yield_angle` (its
    change is the permanent fold, the "set"). Without stops and locking the moment over a cycle is a parallelogram with
    the slopes `stiffness` and `hardening`: linear kinematic hardening (Prager 1956), as one Jenkin element beside a
    spring (Iwan 1966, J. Appl. Mech. 33, 893).

    A crease may have Maxwell branches, see `MaxwellElement`, and wear out: all moments except those of stops are
    multiplied by 1 - damage_loss (1 - exp(-wear / damage_turn)), the saturating softening of Chaboche (Lemaitre and
    Chaboche 1990, Mechanics of Solid Materials) as a factor on the whole moment (Kachanov 1958). The wear is the sum of
    all turns of the crease, or of all changes of its set.

    Dry friction is a branch that does not relax and whose moment is limited: the crease turns elastically by up to the
    limit over the stiffness, and then slides against the limit (Prandtl 1928, Z. angew. Math. Mech. 8, 85).

    What creases remember is in `crease_memory`.

    Attributes:
        stiffness: N m/rad.
        rest_angle: rad.
        lock_below: angle below which the spring stiffens, rad, > -pi; -inf for a linear spring.
        lock_above: angle above which the spring stiffens, rad, < pi; inf for a linear spring.
        lower: angle of the lower stop, rad; -inf without a stop.
        upper: angle of the upper stop, rad; inf without a stop.
        stop_stiffness: stiffness of both stops, N m/rad.
        yield_angle: angle from rest at which the crease begins to yield, rad, > 0; inf for a crease that never yields.
        hardening: slope of the moment while the crease yields, N m/rad, < stiffness.
        quadratic: N m/rad^2.
        cubic: N m/rad^3.
        branch_stiffness: of the Maxwell branches, N m/rad, (..., branch); 0 for absent ones.
        branch_time: their relaxation times, s, (..., branch).
        branch_limit: their largest moments, N m, (..., branch); inf for Maxwell branches.
        damage_loss: share of the moment that is lost after infinitely many turns, from 0 to 1.
        damage_turn: wear after which 63 % of this share is lost, rad.
        damage_by_set: whether the wear is the sum of the changes of the set instead of that of all turns.

    Raises:
        InputError: a number out of these bounds, or bounds in the wrong order.
    """

    stiffness: Array | float
    rest_angle: Array | float = 0.0
    lock_below: Array | float = -math.inf
    lock_above: Array | float = math.inf
    lower: Array | float = -math.inf
    upper: Array | float = math.inf
    stop_stiffness: Array | float = 0.0
    yield_angle: Array | float = math.inf
    hardening: Array | float = 0.0
    quadratic: Array | float = 0.0
    cubic: Array | float = 0.0
    branch_stiffness: Array = field(default_factory=lambda: np.zeros(0))
    branch_time: Array = field(default_factory=lambda: np.ones(0))
    branch_limit: Array = field(default_factory=lambda: np.full(0, np.inf))
    damage_loss: Array | float = 0.0
    damage_turn: Array | float = 1.0
    damage_by_set: Flags | bool = False

    def __post_init__(self) -> None:
        if not np.size(self.branch_limit):
            object.__setattr__(self, "branch_limit", np.full(np.shape(self.branch_stiffness), np.inf))
        for name in ("stiffness", "stop_stiffness", "hardening", "branch_stiffness"):
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

        for name in ("quadratic", "cubic"):
            if not np.all(np.isfinite(getattr(self, name))):
                raise InputError(f"{name}: need a finite number, got {_worst(getattr(self, name)):g}")
        if not np.all(np.asarray(self.branch_time) > 0):
            raise InputError(f"branch_time: need > 0, got {np.min(self.branch_time):g} s")
        if not np.all((np.asarray(self.damage_loss) >= 0) & (np.asarray(self.damage_loss) <= 1)):
            raise InputError(f"damage_loss: need a share from 0 to 1, got {_worst(self.damage_loss):g}")
        if not np.all(np.asarray(self.damage_turn) > 0):
            raise InputError(f"damage_turn: need > 0, got {np.min(self.damage_turn):g} rad")
        if not np.all(np.asarray(self.yield_angle) > 0):
            raise InputError(f"yield_angle: need > 0, got {np.min(self.yield_angle):g} rad")
        if not np.all(np.isinf(self.yield_angle) | (np.asarray(self.hardening) < np.asarray(self.stiffness))):
            raise InputError("hardening: need a slope below the stiffness, got one that is not")

    @cached_property
    def yields(self) -> bool:
        """Return whether any crease yields."""
        return bool(np.isfinite(self.yield_angle).any())

    @cached_property
    def relaxes(self) -> bool:
        """Return whether any crease has a Maxwell branch."""
        return bool(np.any(np.where(np.isinf(self.branch_limit), self.branch_stiffness, 0.0)))

    @property
    def rubs(self) -> bool:
        """Return whether any crease has dry friction."""
        return bool(np.isfinite(self.branch_limit).any())

    @cached_property
    def wears(self) -> bool:
        """Return whether any crease loses its moment while it turns."""
        return bool(np.any(self.damage_loss))

    @cached_property
    def bends(self) -> bool:
        """Return whether the moment of any crease is a nonlinear function of its angle within its linear range."""
        return bool(np.any(self.quadratic) or np.any(self.cubic))

    @property
    def slots(self) -> int:
        """Return the number of values that a crease remembers, see `crease_memory`."""
        count = np.shape(self.branch_stiffness)[-1]
        return 2 + count if count or self.wears else 1

    @property
    def yielding_stiffness(self) -> Array:
        """Return the stiffness of the springs that yield, N m/rad; 0 for creases that never yield."""
        return np.where(np.isfinite(self.yield_angle), np.asarray(self.stiffness) - self.hardening, 0.0)

    def next_set(self, angle: Array, further: Array | float, before: Array) -> Array:
        """Return the sets after creases have turned from an earlier state to these angles, rad.

        A set follows the angle as in play of the half width `yield_angle`, exactly for a monotone turn.

        Args:
            angle: rad, (...).
            further: change of the rest angles, rad.
            before: sets before, rad, (...).
        """
        turned = angle - self.rest_angle - further - before
        # exactly the sets before if no crease yields
        return np.asarray(before + (turned - np.clip(turned, -np.asarray(self.yield_angle), self.yield_angle)))

    def rest_shift(self, sets: Array) -> Array:
        """Return the change of the rest angles that has the effect of these sets on moments, rad, (...)."""
        return np.asarray(sets * _share(self.yielding_stiffness, self.stiffness))

    def set_energy(self, sets: Array) -> Array:
        """Return the energy of these sets, J, (...), in addition to that of springs with shifted rest angles."""
        both = self.yielding_stiffness
        return np.asarray(both * _share(np.where(both > 0, self.hardening, 0.0), self.stiffness) / 2 * sets**2)

    def yield_loss(self, change: Array) -> Array:
        """Return the energy that creases dissipate while their sets change monotonically, J, (...).

        Args:
            change: of the sets, rad.
        """
        stiffness = self.yielding_stiffness
        return np.asarray(stiffness * np.where(stiffness > 0, self.yield_angle, 0.0) * np.abs(change))

    def largest_slope(self, angle: Array) -> Array:
        """Return the slope of fast turns at these angles, with the largest one that nonlinear terms add, N m/rad."""
        slope = self.slope(angle) + np.sum(self.branch_stiffness, axis=-1)
        if not self.bends:
            return np.asarray(slope)
        ends = (np.clip(limit, -math.pi, math.pi) - self.rest_angle for limit in (self.lower, self.upper))
        steepest = [x * (2 * np.asarray(self.quadratic) + 3 * x * np.asarray(self.cubic)) for x in ends]
        return np.asarray(slope + np.maximum(np.maximum(*steepest), 0.0))

    def some(self, which: Indices) -> CreaseLaw:
        """Return the law of some creases, by their indices in the arrays."""
        # a copy skips the checks, which the numbers have passed
        law = copy.copy(self)
        for item in dataclasses.fields(self):
            object.__setattr__(law, item.name, np.asarray(getattr(self, item.name))[which])
        return law

    def energy(self, angle: ArrayLike, further: Array | float = 0.0, shift: Array | float = 0.0) -> Array:
        """Compute the stored energy of new creases, J, (...); infinite at and beyond contact for a locking spring.

        Args:
            angle: rad, (...).
            further: change of the rest angles, rad.
            shift: change of the rest angles by sets, see `rest_shift`, rad; without effect on the nonlinear terms.
        """
        angle = np.asarray(angle, dtype=np.float64)
        within, share, room = self._locked(angle)
        turned = within - self.rest_angle - further - shift
        locked = -((2 * room / math.pi) ** 2) * np.log(np.cos(math.pi / 2 * share))
        # the cosine of the nearest float to a right angle is not 0, so the energy at contact would be finite
        locked = np.where(np.abs(share) < 1, locked, math.inf)
        spring = self.stiffness * (turned**2 / 2 + turned * (angle - within))
        # without a stiffness the spring does not lock
        spring = spring + np.where(share == 0, 0.0, self.stiffness) * np.where(share == 0, 0.0, locked)
        if self.bends:
            x = angle - self.rest_angle - further
            spring = spring + x**3 * (np.asarray(self.quadratic) / 3 + x * np.asarray(self.cubic) / 4)
        return np.asarray(spring + np.asarray(self.stop_stiffness) / 2 * self.beyond_stops(angle) ** 2)

    def moment(self, angle: ArrayLike, further: Array | float = 0.0) -> Array:
        """Compute the moment, N m, with the arguments of `energy`; very large but finite at and beyond contact."""
        return self.moment_and_slope(np.asarray(angle, dtype=np.float64), further)[0]

    def rest_moment(self, angle: ArrayLike, further: Array | float = 0.0, shift: Array | float = 0.0) -> Array:
        """Compute the negative derivative of the energy by `further`, N m, with the arguments of `energy`.

        It is the moment without stops and locking, which do not depend on the rest angle.
        """
        x = np.asarray(angle, dtype=np.float64) - self.rest_angle - further
        moment = self.stiffness * (x - shift)
        return np.asarray(moment + x**2 * (self.quadratic + x * np.asarray(self.cubic)) if self.bends else moment)

    def slope(self, angle: ArrayLike) -> Array:
        """Compute the derivative of the moment, N m/rad, in the shape of `angle` (rad)."""
        return self.moment_and_slope(np.asarray(angle, dtype=np.float64))[1]

    def moment_and_slope(
        self, angle: Array, further: Array | float = 0.0, shift: Array | float = 0.0
    ) -> tuple[Array, Array]:
        """Compute the results of `moment` and `slope` together, in half the time, with the arguments of `energy`."""
        within = np.clip(angle, self.lock_below, self.lock_above)
        spring = self.stiffness * (within - self.rest_angle - further - shift)
        slope = np.asarray(self.stiffness, dtype=np.float64)
        if slope.shape != angle.shape:
            slope = np.broadcast_to(slope, angle.shape)
        if (within != angle).any():
            _, share, room = self._locked(angle)
            spring = spring + self.stiffness * (2 * room / math.pi * np.tan(math.pi / 2 * share))
            slope = slope / np.cos(math.pi / 2 * share) ** 2
        if self.bends:
            x = angle - self.rest_angle - further
            spring = spring + x**2 * (self.quadratic + x * np.asarray(self.cubic))
            slope = slope + x * (2 * np.asarray(self.quadratic) + 3 * x * np.asarray(self.cubic))
        stopped = self.beyond_stops(angle)
        if stopped.any():
            spring = spring + np.asarray(self.stop_stiffness) * stopped
            slope = slope + np.where(stopped != 0, self.stop_stiffness, 0.0)
        return np.asarray(spring), np.asarray(slope)

    def expansion(self, angle: Array) -> tuple[Array, Array, Array]:
        """Compute the results of `energy`, `moment` and `slope` of new creases together, in the shape of `angle` (rad).

        For creases with memory see `crease_turn`.
        """
        within = (np.maximum(self.lock_below, self.lower) <= angle) & (angle <= np.minimum(self.lock_above, self.upper))
        if self.bends or not within.all():
            return (self.energy(angle), *self.moment_and_slope(angle))
        turned = angle - self.rest_angle
        moment = np.asarray(self.stiffness * turned)
        slope = np.asarray(self.stiffness, dtype=np.float64)
        return moment * turned / 2, moment, slope if slope.shape == angle.shape else np.broadcast_to(slope, angle.shape)

    def _locked(self, angle: Array) -> tuple[Array, Array, Array]:
        """Return the angle clipped to the linear range, the share of the locking range that is used, and this range.

        The locking range extends from the linear range to contact, rad. The share is negative below `lock_below`, and
        between -1 and 1.
        """
        within = np.clip(angle, self.lock_below, self.lock_above)
        room = np.where(angle < self.lock_below, math.pi + np.asarray(self.lock_below), math.pi - self.lock_above)
        room = np.where(np.isfinite(room), room, 1.0)
        return within, np.clip((angle - within) / room, -1.0, 1.0), room

    def beyond_stops(self, angle: Array) -> Array:
        """Compute the angle beyond a stop, rad, negative below the lower stop."""
        return angle - np.clip(angle, self.lower, self.upper)


def _share(part: Array, whole: ArrayLike) -> Array:
    """Return a part of a whole as a share; 0 where the whole is 0."""
    return np.divide(part, whole, out=np.zeros(np.broadcast(part, whole).shape), where=np.asarray(whole) > 0)


def _worst(value: ArrayLike) -> float:
    value = np.asarray(value, dtype=np.float64)
    return float(value.flat[np.argmin(np.where(np.isfinite(value), value, -np.inf))])
