"""Saddle between two stable states of a tree, and the highest saddle on a path through further states."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array, Flags
from forficula.statics.tree.elements import Expansion
from forficula.statics.tree.partial_folds import soft_stiffness
from forficula.statics.tree.potential import Ensemble, potential, rest, torque_scale

_STATIONS = 24  # positions between two states
_STIFFER = 10.0  # stiffness that holds a position, relative to the stiffest direction
_STEPS, _LONGEST = 300, 0.05  # steps of the search for a saddle, and the longest step, rad
_QUIET = 1e-7  # torque at a saddle that counts as zero, as a share of the largest torque of the stiffest part
_SHIFT = (
    5e-3  # random shift of the start of a search, which leaves symmetric shapes with several unstable directions, rad
)
_SEED = 31  # of random shifts
_OFF = 0.01  # push off a saddle, rad
_SHORT = 0.02  # longest step downhill from a saddle, rad
_SAME = 0.01  # rad; shapes with smaller differences are equal
_MOST = 6  # saddles on a path
_LEAST = 1e-12  # least stiffness of a direction, as a share of the largest one
_AT = 1e-9  # distance from a stop that counts as zero, rad


@dataclass(frozen=True, kw_only=True)
class TreeSaddle:
    """A stationary point with one unstable direction, or the highest of several on a path between two states.

    Attributes:
        position: angles of the joints, rad, (joint,).
        energy: J.
        between: number of further stable states on the path.
    """

    position: Array
    energy: float
    between: int


def saddle_between(structures: Ensemble, first: Array, second: Array) -> TreeSaddle | None:
    """Find a path over saddles from one stable state to another.

    Positions on the straight line between both states in the space of the joints' angles are prescribed one after
    another, while all other directions minimise the energy. From the shape of highest energy, eigenvector following
    (Cerjan and Miller 1981) leads to a saddle: uphill along the softest direction and downhill along all others. If a
    descent from the saddle ends in another state, the search continues from there.

    Args:
        structures: only the first case is used.
        first: angles of the joints in a stable state, rad, (joint,).
        second: in another one.

    Returns:
        The highest saddle on the path; another path may be lower. None if no path was found.
    """
    at, tops, one = first, list[tuple[float, Array]](), structures.repeated(1)
    for between in range(_MOST):
        step = _step_towards(one, at, second)
        if step is None:
            return None
        top, at = step
        tops.append((float(potential(one, top[None])[0][0]), top))
        if _are_same(at, second):
            energy, position = max(tops, key=lambda entry: entry[0])
            return TreeSaddle(position=position, energy=energy, between=between)
    return None


def _step_towards(structures: Ensemble, start: Array, target: Array) -> tuple[Array, Array] | None:
    """Return a saddle, and the state beyond it, which is the target or nearer to it than the start; None for none."""
    apart = np.linalg.norm(target - start)
    nearer: tuple[Array, Array] | None = None
    for top in _tops(structures, start, target):
        saddle = _saddle_near(structures, top)
        if saddle is None:
            continue
        ends = _ends(structures, *saddle)
        for one, other in (ends, ends[::-1]):
            if _are_same(one, start) and _are_same(other, target):
                return saddle[0], other
            closer = np.linalg.norm(target - other) < apart if nearer is None else False
            if _are_same(one, start) and not _are_same(other, start) and closer:
                nearer = saddle[0], other
    return nearer


def _tops(structures: Ensemble, start: Array, target: Array) -> Iterator[Array]:
    """Return shapes of highest energy on the way from the start to the target, and on the way back."""
    for one, other in ((start, target), (target, start)):
        along = (other - one) / np.linalg.norm(other - one)
        stiffness = _STIFFER * float(np.abs(potential(structures, one[None])[2]).max())
        position, energies, shapes = one, list[float](), list[Array]()
        for station in np.linspace(0.0, float(np.linalg.norm(other - one)), _STATIONS)[1:]:
            aim = float(along @ one) + float(station)

            def hold(angles: Array, aim: float = aim, along: Array = along, stiffness: float = stiffness) -> Expansion:
                off = angles @ along - aim
                curvature = np.broadcast_to(stiffness * np.outer(along, along), (len(angles), len(along), len(along)))
                return stiffness / 2 * off**2, stiffness * off[:, None] * along, curvature

            position = rest(structures, position[None], pull=hold).position[0]
            energies.append(float(potential(structures, position[None])[0][0]))
            shapes.append(position)
        yield shapes[int(np.argmax(energies))]


def _saddle_near(structures: Ensemble, start: Array) -> tuple[Array, Array] | None:
    """Return the saddle to which eigenvector following leads, and its unstable direction, both (joint,)."""
    ties, random = structures.ties, np.random.default_rng(_SEED)
    spread = np.eye(structures.size) if ties is None else ties.spread
    lower, upper = structures.lower, structures.upper
    position = start
    if ties is not None:
        lower, upper = (bound[0] for bound in ties.bounds(lower[None], upper[None]))
        position = ties.start(start[None])[0]
    position = np.clip(position + _SHIFT * random.standard_normal(len(position)), lower, upper)
    quiet, soft = _QUIET * torque_scale(structures), soft_stiffness(structures)
    followed: Array | None = None
    for _ in range(_STEPS):
        angles = position if ties is None else ties.angles(position[None])[0]
        _, slope, curvature = (part[0] for part in potential(structures, angles[None]))
        slope, curvature = slope @ spread, spread.T @ curvature @ spread
        free = np.flatnonzero(~_held(position, slope, lower, upper))
        if not len(free):
            return None
        values, modes = np.linalg.eigh(curvature[np.ix_(free, free)])
        along = slope[free] @ modes
        if np.abs(along).max() <= quiet and values[0] < 0:
            direction = np.zeros(len(position))
            direction[free] = modes[:, 0]
            return (angles, spread @ direction) if np.sum(values < -soft) == 1 else None
        climbed = 0 if followed is None else int(np.argmax(np.abs(followed[free] @ modes)))
        followed = np.zeros(len(position))
        followed[free] = modes[:, climbed]
        # Newton's step downhill along all directions but one, in which it is reversed
        step = -along / np.maximum(np.abs(values), _LEAST * np.abs(values).max())
        step[climbed] *= -1
        step *= min(1.0, _LONGEST / max(float(np.linalg.norm(step)), 1e-300))
        moved = position.copy()
        moved[free] += modes @ step
        position = np.clip(moved, lower, upper)
    return None


def _held(position: Array, slope: Array, lower: Array, upper: Array) -> Flags:
    """Return which coordinates press on a bound."""
    return np.asarray(((position <= lower + _AT) & (slope > 0)) | ((position >= upper - _AT) & (slope < 0)))


def _ends(structures: Ensemble, saddle: Array, direction: Array) -> tuple[Array, Array]:
    """Return the states downhill from both sides of a saddle, (joint,) each."""
    off = _OFF * direction / np.abs(direction).max()
    starts = np.clip([saddle + off, saddle - off], structures.lower, structures.upper)
    one, other = rest(structures.repeated(2), starts, longest_step=_SHORT).position
    return one, other


def _are_same(one: Array, other: Array) -> bool:
    return bool(np.abs(one - other).max() <= _SAME)
