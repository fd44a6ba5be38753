"""Turns of creases with memory in one sense: moment and losses as functions of the angle at the end of a turn.

Statics advances in increments. In an increment, every crease turns in one sense at a constant rate from a known memory.
Its moment then depends on the angle at the end alone, so that a potential exists: the stored energy plus what the
crease has dissipated since the beginning (deformation theory of plasticity). This is exact for such turns.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from forficula.arrays import Array, Flags
from forficula.material.law.crease_law import CreaseLaw
from forficula.material.law.crease_memory import (
    branch_numbers,
    next_memory,
    remaining_share,
    stored_energy,
    turned_memory,
)
from forficula.material.law.relaxation import followed_share, working_share

# nodes and weights of the quadrature between two kinks of the moment, from 0 to 1
_NODES, _WEIGHTS = (values / 2 for values in np.polynomial.legendre.leggauss(6))
_NODES = _NODES + 0.5
_TINY = 1e-300


@dataclass(frozen=True, kw_only=True, eq=False)
class CreaseTurn:
    """Turn of creases in one sense at a constant rate, by its beginning and its duration.

    Attributes:
        memory: at the beginning, see `crease_memory`, (slot, ...).
        angle: at the beginning, rad, (...).
        time: duration, s; it matters for Maxwell branches only.
    """

    memory: Array
    angle: Array
    time: float = 0.0


class TurnLosses(NamedTuple):
    """Energies that creases dissipate in a turn, J, (...) each.

    Attributes:
        yielding: by permanent folds.
        branches: by the dampers of Maxwell branches.
        damage: by wear.
    """

    yielding: Array
    branches: Array
    damage: Array


def relaxed(law: CreaseLaw) -> CreaseLaw:
    """Return the law of creases in infinitely slow motions: without Maxwell branches and without dry friction."""
    count = np.shape(law.branch_stiffness)
    if not (count and count[-1]):
        return law
    none = np.zeros((*count[:-1], 0))
    return replace(law, branch_stiffness=none, branch_time=none + 1.0, branch_limit=none)


def remembers(law: CreaseLaw) -> bool:
    """Return whether the moment of any crease depends on what happened before."""
    return law.yields or law.slots > 1


def memory_after(law: CreaseLaw, angle: Array, turn: CreaseTurn) -> Array:
    """Return the memory of creases at the end of a turn, (slot, ...), for their angles there, rad, (...)."""
    return next_memory(law, angle, 0.0, turn.memory, angle - turn.angle, turn.time)


def turn_expansion(law: CreaseLaw, angle: Array, turn: CreaseTurn | None) -> tuple[Array, Array, Array]:
    """Compute the potential, the moment and its slope at the end of a turn, (...) each.

    The potential is the stored energy and what was dissipated on the way, J. Its derivative by the angle at the end is
    the moment. Where a crease has not turned, the slope is the mean of those of both senses.

    Args:
        law: law of the creases.
        angle: at the end, rad, (...).
        turn: the turn; None for new creases.
    """
    if turn is None:
        turn = CreaseTurn(memory=np.zeros((law.slots, *np.shape(angle))), angle=angle)
    energy, moment, slope = _undamaged(law, angle, turn)
    if not law.wears:
        return energy, moment, slope
    stopped = law.beyond_stops(angle)
    of_stops = np.asarray(law.stop_stiffness) * stopped
    after, turned = memory_after(law, angle, turn), angle - turn.angle
    left = remaining_share(law, after)
    kept = _kept(law, after[1])
    # the wear grows where the crease turns, or where its set changes
    senses = np.sign(np.where(law.damage_by_set, after[0] - turn.memory[0], turned))
    falling = -kept / law.damage_turn * senses
    steep = np.where(stopped != 0, law.stop_stiffness, 0.0)
    potential = of_stops * stopped / 2 + left * (energy - of_stops * stopped / 2)
    potential = potential + _worn(law, angle, turn, lambda at: _undamaged(law, at, turn)[0])
    return (
        potential,
        of_stops + left * (moment - of_stops),
        steep + left * (slope - steep) + falling * (moment - of_stops),
    )


def turn_losses(law: CreaseLaw, angle: Array, turn: CreaseTurn) -> TurnLosses:
    """Return the energies that creases dissipate in a turn to some angles, rad, (...)."""
    after, zero = memory_after(law, angle, turn), np.zeros_like(angle)
    yielded = law.yield_loss(after[0] - turn.memory[0]) if law.yields else zero
    relaxing = zero
    if len(after) > 2:
        times, stiffness = branch_numbers(law, after)
        turned = angle - turn.angle
        work = followed_share(times, turn.time) * turn.memory[2:] * turned
        work = work + working_share(times, turn.time) * stiffness / 2 * turned**2
        gained = np.divide(
            after[2:] ** 2 - turn.memory[2:] ** 2, 2 * stiffness, out=np.zeros_like(work), where=stiffness > 0
        )
        relaxing = np.sum(work - gained, axis=0)
    if not law.wears:
        return TurnLosses(yielded, relaxing, zero)
    parts = _segments(law, angle, turn)
    mean = (remaining_share(law, turn.memory) + remaining_share(law, after)) / 2
    if law.yields:
        # the crease yields in some parts of the turn, in which its wear grows
        span = np.where(parts.yields, parts.length, 0.0)
        shares = (1 - np.asarray(law.damage_loss)) * span - _kept(law, turn.memory[1]) * parts.start * np.expm1(
            -span / law.damage_turn
        ) * np.asarray(law.damage_turn)
        yielded = np.sum(law.yield_loss(shares), axis=0)

    def stored(at: Array) -> Array:
        part = np.divide(at - turn.angle, angle - turn.angle, out=np.zeros_like(at), where=angle != turn.angle)
        memory = np.zeros((len(turn.memory), *at.shape))
        memory[0] = law.next_set(at, 0.0, turn.memory[0]) if law.yields else turn.memory[0]
        if len(turn.memory) > 2:
            # the branches follow the turn at its constant rate
            new = (1,) * (at.ndim - angle.ndim)
            begin = turn.memory.reshape(len(turn.memory), *new, *angle.shape)
            begin = np.broadcast_to(begin, memory.shape)
            memory[2:] = turned_memory(law, begin, part * (angle - turn.angle), part * turn.time)[2:]
        # the memory has no wear, so that the energy is that of creases that do not wear
        return stored_energy(law, at, 0.0, memory)

    return TurnLosses(yielded, mean * relaxing, _worn(law, angle, turn, stored, parts))


def _undamaged(law: CreaseLaw, angle: Array, turn: CreaseTurn) -> tuple[Array, Array, Array]:
    """Compute the results of `turn_expansion` for creases that do not wear, at angles, (..., crease)."""
    if not law.yields:
        energy, moment, slope = law.expansion(angle)
    else:
        before = turn.memory[0]
        sets = law.next_set(angle, 0.0, before)
        shift = law.rest_shift(sets)
        moment, slope = law.moment_and_slope(angle, 0.0, shift)
        energy = law.energy(angle, 0.0, shift) + law.set_energy(sets) + law.yield_loss(sets - before)
        slope = slope - np.where(sets != before, law.yielding_stiffness, 0.0)
    if len(turn.memory) > 2:
        times, stiffness = branch_numbers(law, turn.memory)
        first, turned = turn.memory[2:], angle - turn.angle
        faded, steep = np.exp(-turn.time / times) * first, stiffness * followed_share(times, turn.time)
        stored = np.divide(first**2, 2 * stiffness, out=np.zeros_like(first), where=stiffness > 0)
        constant, linear, quadratic = (np.sum(part, axis=0) for part in (stored, faded, steep + 0 * first))
        energy = energy + constant + turned * (linear + quadratic / 2 * turned)
        moment, slope = moment + linear + quadratic * turned, slope + quadratic
    return energy, moment, slope


class _Segments(NamedTuple):
    """Parts of a turn between the kinks of its moment, (part, ...).

    Attributes:
        begin: angle at which a part begins, as a turn from the beginning, rad, >= 0.
        length: rad, >= 0.
        yields: whether the crease yields in the part.
        worn: turn by which the wear grows in the part, rad.
        start: factor by which the wear of earlier parts has reduced the share that damage can still remove.
    """

    begin: Array
    length: Array
    yields: Flags
    worn: Array
    start: Array


def _segments(law: CreaseLaw, angle: Array, turn: CreaseTurn) -> _Segments:
    """Return the parts of a turn to some angles, rad, (...)."""
    turned = angle - turn.angle
    sense, whole = np.where(turned < 0, -1.0, 1.0), np.abs(turned)
    middle = np.asarray(law.rest_angle) + turn.memory[0]
    kinks = (middle - law.yield_angle, middle + law.yield_angle, law.lock_below, law.lock_above)
    ends = [np.clip(sense * (np.asarray(kink) - turn.angle), 0.0, whole) for kink in kinks]
    bounds = np.sort(np.stack([np.zeros_like(whole), *ends, whole]), axis=0)
    begin, length = bounds[:-1], np.diff(bounds, axis=0)
    middles = turn.angle + sense * (begin + length / 2)
    yields = (np.abs(middles - middle) > law.yield_angle) & (length > 0)
    worn = np.where(law.damage_by_set & ~yields, 0.0, length)
    earlier = np.cumsum(worn, axis=0) - worn
    return _Segments(begin, length, yields, worn, np.exp(-earlier / law.damage_turn))


def _worn(
    law: CreaseLaw,
    angle: Array,
    turn: CreaseTurn,
    energy: Callable[[Array], Array],
    parts: _Segments | None = None,
) -> Array:
    """Integrate an energy of creases that do not wear, without that of stops, over the lost share of the moment.

    The share that is left, not the angle, is the variable of the quadrature, so that it is accurate for creases that
    wear out in short turns.
    """
    parts = _segments(law, angle, turn) if parts is None else parts
    sense, whole = np.where(angle < turn.angle, -1.0, 1.0), np.asarray(law.damage_turn)
    lost = -np.expm1(-parts.worn / whole)
    nodes = _NODES.reshape(-1, *(1,) * lost.ndim)
    further = -whole * np.log(np.maximum(1 - nodes * lost, _TINY))
    at = turn.angle + sense * (parts.begin + np.minimum(further, parts.length))
    values = energy(at) - np.asarray(law.stop_stiffness) / 2 * law.beyond_stops(at) ** 2
    shares = parts.start * lost
    # an energy may be infinite beyond the contact of panels
    means = np.tensordot(_WEIGHTS, np.where(shares > 0, values, 0.0), axes=1)
    return np.asarray(_kept(law, turn.memory[1]) * np.sum(shares * means, axis=0))


def _kept(law: CreaseLaw, wear: Array) -> Array:
    """Return the share of the moment that damage can still remove, (...)."""
    return np.asarray(np.asarray(law.damage_loss) * np.exp(-wear / law.damage_turn))
