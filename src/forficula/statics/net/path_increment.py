"""Increments of the path of a net under a growing load: from one equilibrium to the next along the tangent."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.statics.net.contact.contact_energy import passes_through
from forficula.statics.net.energy import Expansion, expand, expand_at, load_slope, moved_shape, remembered
from forficula.statics.net.factor import Factorisation, factored
from forficula.statics.net.load import Load
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.rigid_forces import (
    Solve,
    between_forces,
    closed,
    constrained_index,
    is_exact,
    rigid_tangent,
    with_changed_forces,
    with_rigid_forces,
)
from forficula.statics.net.supports import supported

_CORRECTIONS = 12
_HOME = 1e-7  # last correction, as a share of the increment
_ASTRAY = 0.5  # longest deviation from the tangent, as a share of the increment
_ALIGNED = 0.9  # cosine of the tangents before and after a corner
HALVINGS = 16  # of an increment, to locate a point in it


@dataclass(frozen=True, kw_only=True, eq=False)
class PathPoint:
    """An equilibrium on a path.

    Attributes:
        shape: shape of the net.
        factor: load factor.
        energy: stored, J.
        index: number of directions in which the energy falls at a constant factor; 0 for a stable equilibrium.
        rising: whether the factor rises along the path.
        corrections: number of corrections of Newton's method.
    """

    shape: NetShape
    factor: float
    energy: float
    index: int
    rising: bool
    corrections: int


@dataclass(frozen=True, kw_only=True, eq=False)
class PathStation:
    """A point with the data for the next increment: factorisation, and unit tangent of the path, (node, 3)."""

    point: PathPoint
    parts: Factorisation
    direction: Array
    pace: float  # change of the factor per length along the path
    rates: Array  # change of the forces of rigid parts with the factor, N, see `rigid_tangent`


def settled(net: Net, load: Load, start: NetShape, factor: float) -> Expansion | None:
    """Find the equilibrium near a shape at a constant factor; None if there is none."""
    current = expand(net, start, load, factor)
    for _ in range(30):
        step = np.zeros_like(net.nodes)
        step[net.free] = factored(current.free).solve(-current.slope[net.free])
        moved = np.abs(step).max(initial=0.0)
        if not moved <= 0.1 * net.size:
            break
        current = _moved(net, current.shape, step, load, factor)
        if moved <= _HOME * net.size / 100:
            return closed(net, current, load, factor)
    return None


def _moved(net: Net, shape: NetShape, step: Array, load: Load, factor: float) -> Expansion:
    return expand_at(net, shape.positions + step, shape, load, factor)


def _tangent(net: Net, load: Load, current: Expansion, parts: Factorisation) -> Array:
    """Return the derivative of displacements by the load factor, m, (node, 3)."""
    push = load_slope(net, current.shape, load, current.turning)
    if np.any(load.displacements):
        push = push - (current.curvature @ load.displacements.ravel()).reshape(-1, 3)
    tangent = load.displacements.copy()
    tangent[net.free] += parts.solve(push[net.free])
    return tangent


def station_of(
    net: Net, load: Load, current: Expansion, factor: float, before: Array | None, rising: bool, corrections: int
) -> PathStation:
    """Return an equilibrium with its tangent, oriented like the tangent before it."""
    parts = factored(current.free)
    tangent, rates = rigid_tangent(net, current, _tangent(net, load, current, parts), parts)
    length = float(np.linalg.norm(tangent))
    if not (np.isfinite(length) and length):
        raise InputError("load: need one that moves the net, got one that does not")
    forwards = rising if before is None else float(np.sum(before * tangent)) > 0
    pace = (1.0 if forwards else -1.0) / length
    point = PathPoint(
        shape=remembered(net, current.shape),
        factor=factor,
        energy=current.stored,
        index=constrained_index(net, current, parts),
        rising=forwards,
        corrections=corrections,
    )
    return PathStation(point=point, parts=parts, direction=pace * tangent, pace=pace, rates=rates)


def increment(net: Net, load: Load, current: PathStation, length: float) -> PathStation | None:
    """Find the next point of the path at about the given length; None if Newton's method does not converge."""
    factor = current.point.factor + length * current.pace
    shape = with_changed_forces(current.point.shape, length * current.pace * current.rates)
    guess = _moved(net, shape, length * current.direction, load, factor)
    corrected = _corrected(net, load, guess, factor, current.direction, length)
    if corrected is None:
        return None
    following, factor, corrections = corrected
    if passes_through(net, current.point.shape.positions, following.shape.positions):
        return None
    return station_of(net, load, following, factor, current.direction, True, corrections)


def _corrected(
    net: Net, load: Load, guess: Expansion, factor: float, direction: Array, length: float
) -> tuple[Expansion, float, int] | None:
    """Find the equilibrium in the plane through a guess that is normal to a direction.

    Returns:
        The equilibrium, its load factor and the number of corrections; None if Newton's method does not converge, or
        leaves the neighbourhood of the guess.
    """
    following = guess
    aside, corrections, updates = np.zeros_like(net.nodes), 0, 0
    while corrections < _CORRECTIONS * (1 + updates):
        if not np.all(np.isfinite(following.slope)):
            return None
        parts = factored(following.free)
        step = np.zeros_like(net.nodes)
        step[net.free] = parts.solve(-following.slope[net.free])
        tangent = _tangent(net, load, following, parts)
        change = -float(np.sum(direction * step)) / (float(np.sum(direction * tangent)) or np.nan)
        step = step + change * tangent
        aside, moved = aside + step, float(np.linalg.norm(step))
        if not np.linalg.norm(aside) <= _ASTRAY * length:
            return None
        factor += change
        following = _moved(net, following.shape, step, load, factor)
        if moved <= _HOME * length:
            shape, ended = with_rigid_forces(net, following, _in_plane(net, load, following, direction))
            if ended and not is_exact(net, shape):
                return None
            if ended:
                following = replace(following, shape=shape)
                # the energy is infinite beyond the contact of locking panels, where no path leads
                return (following, factor, corrections - updates) if np.isfinite(following.stored) else None
            following, updates = expand(net, shape, load, factor), updates + 1
        corrections += 1
    return None


def _in_plane(net: Net, load: Load, current: Expansion, direction: Array) -> Solve | None:
    """Return the displacements under forces in the plane normal to a direction; None if the net has no rigid parts."""
    if not any(net.springs.rigid):
        return None
    parts = factored(current.free)
    tangent = _tangent(net, load, current, parts)[net.free]
    across = direction[net.free]

    def solve(forces: Array) -> Array:
        moved = parts.solve(forces)
        return np.asarray(moved - tangent * (float(across @ moved) / (float(across @ tangent) or np.nan)))

    return solve


def intermediate_point(
    net: Net, load: Load, before: PathPoint, after: PathPoint, positions: Array, factor: float
) -> PathPoint | None:
    """Find the equilibrium between two points of a path near a guess; None if Newton's method does not converge.

    Args:
        net: as for `load_path`.
        load: at a factor of 1.
        before: point of a path.
        after: next point of the path.
        positions: guess, between both points, m, (node, 3).
        factor: guess of the load factor.
    """
    net, _ = supported(net, load)
    chord = after.shape.positions - before.shape.positions
    length = float(np.linalg.norm(chord))
    share = float(np.linalg.norm(positions - before.shape.positions)) / length
    guess = expand_at(net, positions, between_forces(before.shape, after.shape, share), load, factor)
    corrected = _corrected(net, load, guess, factor, chord / length, length)
    if corrected is None:
        return None
    expansion, factor, corrections = corrected
    return PathPoint(
        shape=remembered(net, expansion.shape),
        factor=factor,
        energy=expansion.stored,
        index=before.index,
        rising=before.rising,
        corrections=corrections,
    )


def pass_kink(net: Net, load: Load, current: PathStation, length: float) -> tuple[PathStation, PathStation | None]:
    """Pass a kink of a law, such as a tendon that goes slack, at which the tangent turns abruptly."""
    factor = current.point.factor + length * current.pace
    over = _moved(net, current.point.shape, length * current.direction, load, factor)
    tangent = _tangent(net, load, over, factored(over.free))
    for pace in (1 / np.linalg.norm(tangent), -1 / np.linalg.norm(tangent)):
        turned = replace(current, direction=pace * tangent, pace=float(pace))
        following = increment(net, load, turned, length)
        # the opposite orientation would lead back, or to no equilibrium
        if following is not None and np.sum(following.direction * turned.direction) > _ALIGNED:
            return turned, following
    return current, None


def station_at_factor(
    net: Net, load: Load, current: PathStation, following: PathStation, length: float, factor: float
) -> PathStation:
    """Find the point between two others at a given factor."""
    low, high, begin = 0.0, length, current
    for _ in range(HALVINGS):
        share = (factor - begin.point.factor) / (following.point.factor - begin.point.factor)
        positions = begin.point.shape.positions * (1 - share) + following.point.shape.positions * share
        last = settled(net, load, moved_shape(net, begin.point.shape, positions), factor)
        if last is not None and np.linalg.norm(last.shape.positions - positions) <= high - low:
            return station_of(net, load, last, factor, current.direction, True, 0)
        middle = increment(net, load, current, (low + high) / 2)
        if middle is None or (middle.point.factor - factor) * (current.point.factor - factor) <= 0:
            high, following = (low + high) / 2, middle or following
        else:
            low, begin = (low + high) / 2, middle
    return following
