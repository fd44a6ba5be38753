"""Moment of a crease as a function of its fold angle."""

from __future__ import annotations

import copy
import dataclasses
import math
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike

from forficula.arrays import Array, Flags, Indices
from forficula.errors import InputError
from forficula.material.law.relaxation import followed_share, square_integrals, working_share


_AT_LIMIT = 1e-9  # share of the limit of a branch that counts as rounding


@dataclass(frozen=True, kw_only=True)
class CreaseBranch:
    """A Maxwell branch of a crease: a spring and a damper in series, parallel to the crease's spring.

    Its moment follows dM/dt = stiffness d(angle)/dt - M / time (Maxwell 1867).

    Attributes:
        stiffness: N m/rad, > 0.
        time: relaxation time, s, > 0.

    Raises:
        InputError: a number that is not > 0 and finite.
    """

    stiffness: float
    time: float

    def __post_init__(self) -> None:
        for name, unit in (("stiffness", "N m/rad"), ("time", "s")):
            value = getattr(self, name)
            if not (np.isfinite(value) and value > 0):
                raise InputError(f"branch.{name}: need a finite number > 0, got {value:g} {unit}")


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

    A crease may have Maxwell branches, see `CreaseBranch`, and wear out: all moments except those of stops are
    multiplied by 1 - damage_loss (1 - exp(-wear / damage_turn)), the saturating softening of Chaboche (Lemaitre and
    Chaboche 1990, Mechanics of Solid Materials) as a factor on the whole moment (Kachanov 1958). The wear is the sum of
    all turns of the crease, or of all changes of its set.

    Dry friction is a branch that does not relax and whose moment is limited: the crease turns elastically by up to the
    limit over the stiffness, and then slides against the limit (Prandtl 1928, Z. angew. Math. Mech. 8, 85).

    The memory of creases is an array (2 + branch, ...): their sets, rad, their wear, rad, and the moments of their
    branches, N m. Where no crease has branches or damage, it is only that of the sets, (1, ...).

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

    @property
    def yields(self) -> bool:
        """Return whether any crease yields."""
        return bool(np.isfinite(self.yield_angle).any())

    @property
    def relaxes(self) -> bool:
        """Return whether any crease has a Maxwell branch."""
        return bool(np.any(np.where(np.isinf(self.branch_limit), self.branch_stiffness, 0.0)))

    @property
    def rubs(self) -> bool:
        """Return whether any crease has dry friction."""
        return bool(np.isfinite(self.branch_limit).any())

    @property
    def wears(self) -> bool:
        """Return whether any crease loses its moment while it turns."""
        return bool(np.any(self.damage_loss))

    @property
    def bends(self) -> bool:
        """Return whether the moment of any crease is a nonlinear function of its angle within its linear range."""
        return bool(np.any(self.quadratic) or np.any(self.cubic))

    @property
    def slots(self) -> int:
        """Return the number of values that a crease remembers, see the class."""
        count = np.shape(self.branch_stiffness)[-1]
        return 2 + count if count or self.wears else 1

    @property
    def _yielding_stiffness(self) -> Array:
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
        return np.asarray(sets * _share(self._yielding_stiffness, self.stiffness))

    def set_energy(self, sets: Array) -> Array:
        """Return the energy of these sets, J, (...), in addition to that of springs with shifted rest angles."""
        both = self._yielding_stiffness
        return np.asarray(both * _share(np.where(both > 0, self.hardening, 0.0), self.stiffness) / 2 * sets**2)

    def yield_loss(self, change: Array) -> Array:
        """Return the energy that creases dissipate while their sets change monotonically, J, (...).

        Args:
            change: of the sets, rad.
        """
        stiffness = self._yielding_stiffness
        return np.asarray(stiffness * np.where(stiffness > 0, self.yield_angle, 0.0) * np.abs(change))

    def start_memory(self, angle: Array) -> Array:
        """Return the memory of creases that start at these angles (rad, (...)): new, relaxed, some with a set."""
        memory = np.zeros((self.slots, *angle.shape))
        memory[0] = self.next_set(angle, 0.0, memory[0])
        return memory

    def next_memory(
        self,
        angle: Array,
        further: Array | float,
        before: Array,
        turned: Array | float = 0.0,
        time: Array | float = 0.0,
    ) -> Array:
        """Return the memory of creases after they have turned to these angles at a constant rate.

        Args:
            angle: rad, (...).
            further: change of the rest angles, rad.
            before: memory before, (slot, ...).
            turned: change of the angles, rad, (...).
            time: duration of this turn, s, of a shape that broadcasts with the angles.
        """
        after = self.turned_memory(before, turned, time)
        if not self.yields:
            return after
        sets = self.next_set(angle, further, before[0])
        if len(before) == 1:
            return sets[None]
        after[0] = sets
        after[1] += np.where(self.damage_by_set, np.abs(sets - before[0]), 0.0)
        return after

    def turned_memory(self, before: Array, turned: Array | float, time: Array | float) -> Array:
        """Return the memory of creases after a turn without yield, with the arguments of `next_memory`."""
        if len(before) == 1:
            return before
        times, stiffness = self._branches(before)
        after = np.empty_like(before)
        after[0] = before[0]
        after[1] = before[1] + np.where(self.damage_by_set, 0.0, np.abs(turned))
        if len(before) > 2:
            after[2:] = np.exp(-time / times) * before[2:] + stiffness * followed_share(times, time) * turned
            if self.rubs:
                limit = self._of_branches(self.branch_limit, before)
                after[2:] = np.clip(after[2:], -limit, limit)
        return after

    def remaining(self, memory: Array) -> Array | float:
        """Return the share of the moment of creases that wear has left, (...)."""
        if len(memory) == 1 or not self.wears:
            return 1.0
        return np.asarray(1 + self.damage_loss * np.expm1(-memory[1] / self.damage_turn))

    def stored(self, angle: Array, further: Array | float, memory: Array) -> Array:
        """Compute the stored energy of creases with a memory, J, (...), with the arguments of `next_memory`."""
        energy = self.energy(angle, *self._rests(further, memory))
        if self.yields:
            energy = energy + self.set_energy(memory[0])
        if len(memory) == 1:
            return energy
        _, stiffness = self._branches(memory)
        squares = np.divide(memory[2:] ** 2, stiffness, out=np.zeros_like(memory[2:]), where=stiffness > 0)
        energy = energy + np.sum(squares, axis=0) / 2
        of_stops = np.asarray(self.stop_stiffness) / 2 * self._stopped(angle) ** 2
        return np.asarray(of_stops + self.remaining(memory) * (energy - of_stops))

    def acting(
        self, angle: Array, further: Array | float, memory: Array, time: Array | float = 0.0
    ) -> tuple[Array, Array]:
        """Compute the moment and its slope for creases with a memory, with the arguments of `next_memory`.

        The slope is that of a turn without yield, see `yielding_slope`. The moment of branches is its mean over the given time if the crease
        does not turn, s, and their slope does the work of a ramp over this time.
        """
        moment, slope = self.moment_and_slope(angle, *self._rests(further, memory))
        if len(memory) == 1:
            return moment, slope
        times, stiffness = self._branches(memory)
        moment = moment + np.sum(followed_share(times, time) * memory[2:], axis=0)
        slope = slope + np.sum(working_share(times, time) * stiffness, axis=0)
        if not self.wears:
            return moment, slope
        stopped, left = self._stopped(angle), self.remaining(memory)
        of_stops = np.asarray(self.stop_stiffness) * stopped, np.where(stopped != 0, self.stop_stiffness, 0.0)
        return of_stops[0] + left * (moment - of_stops[0]), of_stops[1] + left * (slope - of_stops[1])

    def losses(
        self, angle: Array, further: Array | float, before: Array, after: Array, time: float
    ) -> tuple[Array, Array, Array]:
        """Return the energies that yield, branches and wear dissipate between two memories, J, (...) each.

        Args:
            angle: after, rad, (...).
            further: change of the rest angles, rad.
            before: memory before, (slot, ...).
            after: memory after, (slot, ...).
            time: duration between both, s.
        """
        yielded = self.yield_loss(after[0] - before[0]) if self.yields else np.zeros_like(angle)
        if len(before) == 1:
            return yielded, np.zeros_like(angle), np.zeros_like(angle)
        left, relaxed, worn = self.remaining(before), np.zeros_like(angle), np.zeros_like(angle)
        if self.relaxes and time:
            times, stiffness = self._branches(before)
            squares, last, first = square_integrals(times, time), after[2:], before[2:]
            total = squares[0] * first**2 + squares[1] * first * last + squares[2] * last**2
            scale = stiffness * times
            relaxed = np.sum(np.divide(total, scale, out=np.zeros_like(total), where=scale > 0), axis=0)
        if self.wears:
            # the energy at the angle after, with the share of the moment before and after
            new = np.array(after)
            new[1] = before[1]
            worn = self.stored(angle, further, new) - self.stored(angle, further, after)
        return left * yielded, left * relaxed, worn

    def yielding_slope(self, before: Array, after: Array) -> Array:
        """Return the part of the slope that creases lack while they yield, N m/rad, from their memories, (...)."""
        lacking = np.where(after[0] != before[0], np.asarray(self.stiffness) - self.hardening, 0.0)
        if self.rubs:
            lacking = lacking + np.sum(np.where(self._sliding(after), self._branches(after)[1], 0.0), axis=0)
        return np.asarray(self.remaining(after) * lacking)

    def friction_loss(self, turned: Array, before: Array, after: Array) -> Array:
        """Return the energy that dry friction dissipates in a turn with the moments and slopes at its start, J, (...).

        Args:
            turned: change of the angles, rad, (...).
            before: memory at the start, (slot, ...).
            after: memory at the end, (slot, ...).
        """
        stiffness = np.where(np.isfinite(self._of_branches(self.branch_limit, before)), self._branches(before)[1], 0.0)
        sticking = np.where(self._sliding(before), 0.0, stiffness)
        work = np.where(stiffness > 0, before[2:], 0.0) * turned + sticking / 2 * turned**2
        gained = np.divide(
            after[2:] ** 2 - before[2:] ** 2, 2 * stiffness, out=np.zeros_like(work), where=stiffness > 0
        )
        return np.asarray(np.sum(work - gained, axis=0))

    def _sliding(self, memory: Array) -> Flags:
        """Return which branches of a memory are at the limit of dry friction, (branch, ...)."""
        limit = self._of_branches(self.branch_limit, memory)
        return np.asarray(np.abs(memory[2:]) >= (1 - _AT_LIMIT) * limit)

    def largest_slope(self, angle: Array) -> Array:
        """Return the slope of fast turns at these angles, with the largest one that nonlinear terms add, N m/rad."""
        slope = self.slope(angle) + np.sum(self.branch_stiffness, axis=-1)
        if not self.bends:
            return np.asarray(slope)
        ends = (np.clip(limit, -math.pi, math.pi) - self.rest_angle for limit in (self.lower, self.upper))
        steepest = [x * (2 * np.asarray(self.quadratic) + 3 * x * np.asarray(self.cubic)) for x in ends]
        return np.asarray(slope + np.maximum(np.maximum(*steepest), 0.0))

    def _rests(self, further: Array | float, memory: Array) -> tuple[Array | float, Array | float]:
        """Return the changes of the rest angles of the whole spring and of its linear part, rad."""
        if not self.yields:
            return further, 0.0
        shift = self.rest_shift(memory[0])
        return (further, shift) if self.bends else (further + shift, 0.0)

    def _branches(self, memory: Array) -> tuple[Array, Array]:
        """Return the relaxation times and the stiffnesses of the branches, which broadcast with those of a memory."""
        return self._of_branches(self.branch_time, memory), self._of_branches(self.branch_stiffness, memory)

    def _of_branches(self, numbers: Array, memory: Array) -> Array:
        """Return numbers of the branches, which broadcast with those of a memory."""
        part = np.moveaxis(numbers, -1, 0)
        return part.reshape(len(part), *(1,) * (memory.ndim - part.ndim), *part.shape[1:])

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
        return np.asarray(spring + np.asarray(self.stop_stiffness) / 2 * self._stopped(angle) ** 2)

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
        stopped = self._stopped(angle)
        if stopped.any():
            spring = spring + np.asarray(self.stop_stiffness) * stopped
            slope = slope + np.where(stopped != 0, self.stop_stiffness, 0.0)
        return np.asarray(spring), np.asarray(slope)

    def expansion(self, angle: Array, sets: Array | None = None) -> tuple[Array, Array, Array]:
        """Compute the results of `energy`, `moment` and `slope` together, in the shape of `angle` (rad).

        For creases that yield, they are those of a turn in one sense from a state with these sets, rad (None for 0),
        and the energy contains what is dissipated on the way.
        """
        if self.yields:
            return self._yielding_expansion(angle, np.zeros_like(angle) if sets is None else sets)
        within = (np.maximum(self.lock_below, self.lower) <= angle) & (angle <= np.minimum(self.lock_above, self.upper))
        if self.bends or not within.all():
            return (self.energy(angle), *self.moment_and_slope(angle))
        turned = angle - self.rest_angle
        moment = np.asarray(self.stiffness * turned)
        slope = np.asarray(self.stiffness, dtype=np.float64)
        return moment * turned / 2, moment, slope if slope.shape == angle.shape else np.broadcast_to(slope, angle.shape)

    def _yielding_expansion(self, angle: Array, before: Array) -> tuple[Array, Array, Array]:
        sets = self.next_set(angle, 0.0, before)
        shift = self.rest_shift(sets)
        moment, slope = self.moment_and_slope(angle, 0.0, shift)
        energy = self.energy(angle, 0.0, shift) + self.set_energy(sets) + self.yield_loss(sets - before)
        return energy, moment, slope - np.where(sets != before, self._yielding_stiffness, 0.0)

    def _locked(self, angle: Array) -> tuple[Array, Array, Array]:
        """Return the angle clipped to the linear range, the share of the locking range that is used, and this range.

        The locking range extends from the linear range to contact, rad. The share is negative below `lock_below`, and
        between -1 and 1.
        """
        within = np.clip(angle, self.lock_below, self.lock_above)
        room = np.where(angle < self.lock_below, math.pi + np.asarray(self.lock_below), math.pi - self.lock_above)
        room = np.where(np.isfinite(room), room, 1.0)
        return within, np.clip((angle - within) / room, -1.0, 1.0), room

    def _stopped(self, angle: Array) -> Array:
        """Compute the angle beyond a stop, rad, negative below the lower stop."""
        return angle - np.clip(angle, self.lower, self.upper)


def _share(part: Array, whole: ArrayLike) -> Array:
    """Return a part of a whole as a share; 0 where the whole is 0."""
    return np.divide(part, whole, out=np.zeros(np.broadcast(part, whole).shape), where=np.asarray(whole) > 0)


def _worst(value: ArrayLike) -> float:
    value = np.asarray(value, dtype=np.float64)
    return float(value.flat[np.argmin(np.where(np.isfinite(value), value, -np.inf))])
