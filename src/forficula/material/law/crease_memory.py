"""Memory of creases: their sets, their wear and the moments of their Maxwell branches.

The memory is an array (2 + branch, ...) of the sets, rad, the wear, rad, and the moments of the branches, N m. Where no
crease has branches or damage, it has only the sets, (1, ...). See `CreaseLaw` for the law.
"""

from __future__ import annotations

import numpy as np

from forficula.arrays import Array, Flags
from forficula.material.law.crease_law import CreaseLaw
from forficula.material.law.relaxation import followed_share, square_integrals, working_share

_AT_LIMIT = 1e-9  # share of the limit of a branch that counts as rounding


def start_memory(law: CreaseLaw, angle: Array) -> Array:
    """Return the memory of creases that start at these angles (rad, (...)): new, relaxed, some with a set."""
    memory = np.zeros((law.slots, *angle.shape))
    memory[0] = law.next_set(angle, 0.0, memory[0])
    return memory


def next_memory(
    law: CreaseLaw,
    angle: Array,
    further: Array | float,
    before: Array,
    turned: Array | float = 0.0,
    time: Array | float = 0.0,
) -> Array:
    """Return the memory of creases after they have turned to these angles at a constant rate.

    Args:
        law: law of the creases.
        angle: rad, (...).
        further: change of the rest angles, rad.
        before: memory before, (slot, ...).
        turned: change of the angles, rad, (...).
        time: duration of this turn, s, of a shape that broadcasts with the angles.
    """
    after = turned_memory(law, before, turned, time)
    if not law.yields:
        return after
    sets = law.next_set(angle, further, before[0])
    if len(before) == 1:
        return sets[None]
    after[0] = sets
    after[1] += np.where(law.damage_by_set, np.abs(sets - before[0]), 0.0)
    return after


def turned_memory(law: CreaseLaw, before: Array, turned: Array | float, time: Array | float) -> Array:
    """Return the memory of creases after a turn without yield, with the arguments of `next_memory`."""
    if len(before) == 1:
        return before
    after = np.empty_like(before)
    after[0] = before[0]
    after[1] = before[1] + np.where(law.damage_by_set, 0.0, np.abs(turned))
    if len(before) > 2:
        times, stiffness = branch_numbers(law, before)
        after[2:] = np.exp(-time / times) * before[2:] + stiffness * followed_share(times, time) * turned
        if law.rubs:
            limit = _of_branches(law.branch_limit, before)
            after[2:] = np.clip(after[2:], -limit, limit)
    return after


def remaining_share(law: CreaseLaw, memory: Array) -> Array | float:
    """Return the share of the moment of creases that wear has left, (...)."""
    if len(memory) == 1 or not law.wears:
        return 1.0
    return np.asarray(1 + law.damage_loss * np.expm1(-memory[1] / law.damage_turn))


def stored_energy(law: CreaseLaw, angle: Array, further: Array | float, memory: Array) -> Array:
    """Compute the stored energy of creases with a memory, J, (...), with the arguments of `next_memory`."""
    energy = law.energy(angle, *_rests(law, further, memory))
    if law.yields:
        energy = energy + law.set_energy(memory[0])
    if len(memory) == 1:
        return energy
    _, stiffness = branch_numbers(law, memory)
    squares = np.divide(memory[2:] ** 2, stiffness, out=np.zeros_like(memory[2:]), where=stiffness > 0)
    energy = energy + np.sum(squares, axis=0) / 2
    of_stops = np.asarray(law.stop_stiffness) / 2 * law.beyond_stops(angle) ** 2
    return np.asarray(of_stops + remaining_share(law, memory) * (energy - of_stops))


def acting_moment(
    law: CreaseLaw, angle: Array, further: Array | float, memory: Array, time: Array | float = 0.0
) -> tuple[Array, Array]:
    """Compute the moment and its slope for creases with a memory, with the arguments of `next_memory`.

    The slope is that of a turn without yield, see `yielding_slope`. The moment of branches is its mean over the time if
    the crease does not turn, and their slope does the work of a ramp over this time.
    """
    moment, slope = law.moment_and_slope(angle, *_rests(law, further, memory))
    if len(memory) == 1:
        return moment, slope
    times, stiffness = branch_numbers(law, memory)
    moment = moment + np.sum(followed_share(times, time) * memory[2:], axis=0)
    slope = slope + np.sum(working_share(times, time) * stiffness, axis=0)
    if not law.wears:
        return moment, slope
    stopped, left = law.beyond_stops(angle), remaining_share(law, memory)
    of_stops = np.asarray(law.stop_stiffness) * stopped, np.where(stopped != 0, law.stop_stiffness, 0.0)
    return of_stops[0] + left * (moment - of_stops[0]), of_stops[1] + left * (slope - of_stops[1])


def memory_losses(
    law: CreaseLaw, angle: Array, further: Array | float, before: Array, after: Array, time: float
) -> tuple[Array, Array, Array]:
    """Return the energies that yield, branches and wear dissipate between two memories, J, (...) each.

    Args:
        law: law of the creases.
        angle: after, rad, (...).
        further: change of the rest angles, rad.
        before: memory before, (slot, ...).
        after: memory after, (slot, ...).
        time: duration between both, s.
    """
    yielded = law.yield_loss(after[0] - before[0]) if law.yields else np.zeros_like(angle)
    if len(before) == 1:
        return yielded, np.zeros_like(angle), np.zeros_like(angle)
    left, relaxed, worn = remaining_share(law, before), np.zeros_like(angle), np.zeros_like(angle)
    if law.relaxes and time:
        times, stiffness = branch_numbers(law, before)
        squares, last, first = square_integrals(times, time), after[2:], before[2:]
        total = squares[0] * first**2 + squares[1] * first * last + squares[2] * last**2
        scale = stiffness * times
        relaxed = np.sum(np.divide(total, scale, out=np.zeros_like(total), where=scale > 0), axis=0)
    if law.wears:
        # the energy at the angle after, with the share of the moment before and after
        new = np.array(after)
        new[1] = before[1]
        worn = stored_energy(law, angle, further, new) - stored_energy(law, angle, further, after)
    return left * yielded, left * relaxed, worn


def yielding_slope(law: CreaseLaw, before: Array, after: Array) -> Array:
    """Return the part of the slope that creases lack while they yield or slide, N m/rad, from their memories, (...)."""
    lacking = np.where(after[0] != before[0], np.asarray(law.stiffness) - law.hardening, 0.0)
    if law.rubs:
        lacking = lacking + np.sum(np.where(_sliding(law, after), branch_numbers(law, after)[1], 0.0), axis=0)
    return np.asarray(remaining_share(law, after) * lacking)


def friction_loss(law: CreaseLaw, turned: Array, before: Array, after: Array) -> Array:
    """Return the energy that dry friction dissipates in a turn with the moments and slopes at its start, J, (...).

    Args:
        law: law of the creases.
        turned: change of the angles, rad, (...).
        before: memory at the start, (slot, ...).
        after: memory at the end, (slot, ...).
    """
    stiffness = np.where(np.isfinite(_of_branches(law.branch_limit, before)), branch_numbers(law, before)[1], 0.0)
    sticking = np.where(_sliding(law, before), 0.0, stiffness)
    work = np.where(stiffness > 0, before[2:], 0.0) * turned + sticking / 2 * turned**2
    gained = np.divide(after[2:] ** 2 - before[2:] ** 2, 2 * stiffness, out=np.zeros_like(work), where=stiffness > 0)
    return np.asarray(np.sum(work - gained, axis=0))


def _sliding(law: CreaseLaw, memory: Array) -> Flags:
    """Return which branches of a memory are at the limit of dry friction, (branch, ...)."""
    return np.asarray(np.abs(memory[2:]) >= (1 - _AT_LIMIT) * _of_branches(law.branch_limit, memory))


def _rests(law: CreaseLaw, further: Array | float, memory: Array) -> tuple[Array | float, Array | float]:
    """Return the changes of the rest angles of the whole spring and of its linear part, rad."""
    if not law.yields:
        return further, 0.0
    shift = law.rest_shift(memory[0])
    return (further, shift) if law.bends else (further + shift, 0.0)


def branch_numbers(law: CreaseLaw, memory: Array) -> tuple[Array, Array]:
    """Return the relaxation times and the stiffnesses of the branches, which broadcast with those of a memory."""
    return _of_branches(law.branch_time, memory), _of_branches(law.branch_stiffness, memory)


def _of_branches(numbers: Array, memory: Array) -> Array:
    """Return numbers of the branches, (..., branch), in a shape that broadcasts with those of a memory."""
    part = np.moveaxis(numbers, -1, 0)
    return part.reshape(len(part), *(1,) * (memory.ndim - part.ndim), *part.shape[1:])
