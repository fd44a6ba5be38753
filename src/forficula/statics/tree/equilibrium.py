"""Equilibria of any energy function and the barriers between them, independent of the mechanism."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
import scipy
from numpy.typing import ArrayLike, NDArray

from forficula.arrays import Array, Flags

Cases = NDArray[np.int64]
# Takes positions, (row, coordinate), and the numbers of their cases, (row,). Returns energy, (row,), gradient
# ("slope"), (row, coordinate), and Hessian ("curvature"), (row, coordinate, coordinate).
Energy = Callable[[Array, Cases], tuple[Array, Array, Array]]
# Takes the numbers of the moving cases, and the positions of all cases, (case, coordinate).
Follow = Callable[[Cases, Array], None]
# Takes positions, (row, coordinate), and the numbers of their cases, (row,). Returns which rows need no further steps.
Enough = Callable[[Array, Cases], Flags]

_MOST_STEPS = 5000
# share of a path beyond which a stretch without slope is a neutral range instead of a minimum
_WIDE = 0.05
_SMALLEST_STEP = 1e-13
# share of the step within which a coordinate that is pushed onto its bound is set to the bound
_NEAR = 0.1
# sufficient for all digits of a step's length
_NEWTON_STEPS = 6
_ROUNDING = 1e-12  # of an energy
# Slope divided by curvature: a few last digits of a coordinate of the size of 1. If a tendon is slack at most angles,
# the tolerance of the slope can be smaller than this, and steps would alternate between two neighbouring numbers.
_NOISE = 1e-15


@dataclass(frozen=True, kw_only=True)
class Equilibria:
    """Equilibria of some cases.

    Attributes:
        position: (case, coordinate).
        energy: (case,).
        slope: gradient of the energy, (case, coordinate); about 0 unless a coordinate presses on its bound.
        stiffness: least curvature of the energy along coordinates that no bound holds, (case,); inf if bounds hold all.
        rests: whether the case came to rest, (case,).
    """

    position: Array
    energy: Array
    slope: Array
    stiffness: Array
    rests: Flags


def descend(
    energy: Energy,
    start: Array,
    lower: ArrayLike,
    upper: ArrayLike,
    *,
    longest_step: float,
    force: float,
    follow: Follow | None = None,
    enough: Enough | None = None,
) -> Equilibria:
    """Follow an energy downhill to an equilibrium, in steps short enough to stay in its valley.

    The method is Newton's method with a trust region (More and Sorensen 1983) within a box (Bertsekas 1982). Far from
    rest, its short steps follow the steepest descent, like a motion with equal dampers on all coordinates. All cases
    are computed side by side.

    Args:
        energy: with gradient and Hessian; see `Energy`.
        start: (case, coordinate), moved into the box.
        lower: lower bounds of the coordinates, (coordinate,) or (case, coordinate).
        upper: upper bounds, with the same shape.
        longest_step: in the space of the coordinates.
        force: largest slope that counts as zero; slopes of the size of their rounding count as zero as well.
        follow: called after every step with the numbers of the cases that are not at rest and all positions.
        enough: returns which cases are not followed further after a step, although they are not at rest; their results
            are those of this step.
    """
    lower, upper = (np.array(np.broadcast_to(bound, start.shape)) for bound in (lower, upper))
    position = np.clip(start, lower, upper)
    moving = np.arange(len(position))
    value, slope, curvature = energy(position, moving)
    # contiguous, because the last bits of sums by row depend on the order in memory
    position, slope = np.ascontiguousarray(position), np.ascontiguousarray(slope)
    radius = np.full(len(position), longest_step)
    stiffness, rests = np.full(len(position), np.nan), np.zeros(len(position), dtype=bool)
    rows: slice | Cases = slice(None)  # all cases, without copies, while all of them move
    for _ in range(_MOST_STEPS):
        at, down = position[rows], -slope[rows]
        least, most, bent, within = lower[rows], upper[rows], curvature[rows], radius[rows]
        step, held, stiffness[rows] = _step_within((least - at, most - at), down, bent, within)
        quiet = np.maximum(force, _NOISE * np.maximum.reduce(np.abs(bent), axis=(1, 2)))[:, None]
        quieted = np.logical_and.reduce((np.abs(down) <= quiet) | (held & (step == 0)), axis=1)
        rests[rows] = quieted
        going = ~quieted & (within > _SMALLEST_STEP)
        if not going.all():
            moving = rows = moving[going]
            if not len(moving):
                break
            at, down, least, most = at[going], down[going], least[going], most[going]
            step, held, within = step[going], held[going], within[going]
        tried = np.minimum(np.maximum(at + step, least), most)
        new_value, new_slope, new_curvature = energy(tried, moving)
        better = new_value < value[rows]
        if not better.all():
            free = ~held
            better = _improves(new_value, new_slope * free, value[rows], down * free)
        wider = np.minimum(2 * within, longest_step)
        if better.all():
            position[rows], value[rows], slope[rows], curvature[rows] = tried, new_value, new_slope, new_curvature
            radius[rows] = wider
        else:
            radius[rows] = np.where(better, wider, np.minimum(within, _lengths(step)) / 4)
            taken = moving[better]
            position[taken], value[taken] = tried[better], new_value[better]
            slope[taken], curvature[taken] = new_slope[better], new_curvature[better]
        if follow is not None:
            follow(moving, position)
        if enough is not None and (ended := enough(position[rows], moving)).any():
            moving = rows = moving[~ended]
            if not len(moving):
                break
    return Equilibria(position=position, energy=value, slope=slope, stiffness=stiffness, rests=rests)


def _improves(new_value: Array, new_slope: Array, value: Array, slope: Array) -> Flags:
    """Return whether the energy falls, (case,); if it is equal within rounding, whether the slope falls."""
    flatter = _lengths(new_slope) < _lengths(slope)
    return np.asarray((new_value < value) | ((new_value <= value + _ROUNDING * np.abs(value)) & flatter))


def _lengths(vectors: Array) -> Array:
    """Return the lengths of vectors, (case, coordinate)."""
    return np.asarray(np.sqrt(np.add.reduce(vectors * vectors, axis=1)))


def _step_within(room: tuple[Array, Array], down: Array, curvature: Array, radius: Array) -> tuple[Array, Flags, Array]:
    """Compute a step downhill within a ball and a box.

    Args:
        room: distances to the bounds, <= 0 and >= 0, (case, coordinate).
        down: negative gradient, (case, coordinate).
        curvature: (case, coordinate, coordinate).
        radius: of the ball, (case,).

    Returns:
        The step, and which coordinates their bounds hold, both (case, coordinate); the least curvature of the other
        coordinates, (case,).
    """
    wide = np.logical_or.reduce(room[0] < room[1], axis=0)
    if wide.all() and len(down):
        return _free_step(room, down, curvature, radius)
    loose = np.flatnonzero(wide)
    step, held, least = np.zeros_like(down), np.ones(down.shape, dtype=bool), np.full(len(down), np.inf)
    if len(loose) and len(down):
        room, down, curvature = (room[0][:, loose], room[1][:, loose]), down[:, loose], curvature[:, loose][:, :, loose]
        step[:, loose], held[:, loose], least = _free_step(room, down, curvature, radius)
    return step, held, least


def _free_step(room: tuple[Array, Array], down: Array, curvature: Array, radius: Array) -> tuple[Array, Flags, Array]:
    """Compute the step of `_step_within` if every coordinate can move in some case."""
    to_bound = np.where(down < 0, *room)
    held = (down != 0) & (np.abs(to_bound) <= _NEAR * radius[:, None])
    values, axes = np.linalg.eigh(_free_hessian(curvature, held))
    # in Fortran order, because the last bits depend on the order in memory
    free = _trusted_step(np.asfortranarray(np.where(held, 0.0, down)), values, axes, radius)
    step = np.minimum(np.maximum(np.where(held, to_bound, free), room[0]), room[1])
    return step, held, np.where(np.logical_and.reduce(held, axis=1), np.inf, values[:, 0])


def _free_hessian(curvature: Array, held: Flags) -> Array:
    """Return the Hessian of the free coordinates; held ones are decoupled and get the largest stiffness of all."""
    if not held.any():
        return curvature
    free = ~held
    kept = curvature * (free[:, :, None] & free[:, None, :])
    largest = np.maximum.reduce(np.abs(curvature), axis=(1, 2))[:, None]
    diagonal = np.einsum("...ii->...i", kept)
    diagonal += np.where(held, np.maximum(largest, 1e-300), 0.0)
    return np.asarray(kept)


def _trusted_step(down: Array, values: Array, axes: Array, radius: Array) -> Array:
    """Compute the step to the lowest point of a quadratic model within a ball, (case, coordinate).

    If the step is longer than the radius, Newton's method on 1 / length finds the damping that shortens it. The damping
    converges from below (Conn, Gould and Toint 2000, section 7.3).
    """
    # direct ufuncs are several times as fast as functions and methods for the few cases of most calls
    add, largest = np.add.reduce, np.maximum.reduce
    along = (down[:, None] @ axes)[:, 0]
    least = np.maximum(0.0, -values[:, 0]) + 1e-12 * largest(np.abs(values), axis=1) + 1e-300
    # no component may be longer than the ball
    damping = np.maximum(least, largest(np.abs(along) / radius[:, None] - values, axis=1))
    for _ in range(_NEWTON_STEPS):
        shifted = values + damping[:, None]
        step = along / shifted
        squares = step * step
        square = add(squares, axis=1)
        longer = np.sqrt(square) / radius
        beyond = longer > 1
        if not np.logical_or.reduce(beyond):  # further steps would change nothing
            break
        rise = np.divide(square, add(squares / shifted, axis=1), out=np.zeros(len(square)), where=beyond)
        damping = damping + rise * (longer - 1)
    else:
        step = along / (values + damping[:, None])
    return np.asarray((axes @ step[..., None])[..., 0])


@dataclass(frozen=True, kw_only=True)
class PathState:
    """An equilibrium on a path.

    Attributes:
        kind: "stop", pressed onto the end of the path; "minimum"; "maximum", which is unstable; "neutral", a range of
            constant energy.
        coordinate: along the path; for a neutral range, its nearer end.
        far_coordinate: the other end of a neutral range; otherwise the coordinate.
        energy: at the coordinate.
        press: slope of the energy that presses onto the end of the path, >= 0; 0 unless the kind is "stop".
    """

    kind: Literal["stop", "minimum", "maximum", "neutral"]
    coordinate: float
    far_coordinate: float
    energy: float
    press: float

    @property
    def stable(self) -> bool:
        """Return whether the state persists after a small push."""
        return self.kind != "maximum"


# energy and slope at positions on a path
PathEnergy = Callable[[Array], tuple[Array, Array]]


def states_along(path: PathEnergy, places: Array, *, force: ArrayLike, wide: float = _WIDE) -> tuple[PathState, ...]:
    """Find the equilibria on a path, from its start to its end.

    Stationary points are zeros of the slope (Brent 1973). At most one is searched for between two neighbouring places.

    Args:
        path: energy, and its slope by the coordinate.
        places: rising coordinates from one end of the path to the other, (place,).
        force: largest slope that counts as zero, one or by place.
        wide: share of the path beyond which a stretch without slope is a neutral range instead of a minimum.
    """
    energy, slope = path(places)
    sign = np.where(np.abs(slope) <= force, 0, np.sign(slope))
    states = []
    if sign[0] > 0:
        states.append(_state("stop", places[0], energy[0], press=slope[0]))
    place = 0
    while place < len(places):
        last = place
        while last + 1 < len(places) and sign[last + 1] == sign[place]:
            last += 1
        if sign[place] == 0:
            before = sign[place - 1] if place else 0
            after = sign[last + 1] if last + 1 < len(places) else 0
            shortest = wide * (places[-1] - places[0])
            states += _flat_state(path, places[place : last + 1], before, after, shortest)
        elif last + 1 < len(places) and sign[last + 1] == -sign[place]:
            states.append(
                _stationary(path, places[last], places[last + 1], "maximum" if sign[place] > 0 else "minimum")
            )
        place = last + 1
    if sign[-1] < 0:
        states.append(_state("stop", places[-1], energy[-1], press=-slope[-1]))
    return tuple(states)


def _flat_state(path: PathEnergy, places: Array, before: float, after: float, wide: float) -> list[PathState]:
    """Return the state of a stretch without slope between slopes of the given signs, which are 0 at path ends."""
    kind: Literal["minimum", "maximum"] = "maximum" if before > 0 or after < 0 else "minimum"
    passes = before == after != 0
    if (kind == "minimum" or passes) and places[-1] - places[0] > wide:
        return [_state("neutral", places[0], path(places[:1])[0][0], far=places[-1])]
    return [] if passes else [_stationary(path, places[0], places[-1], kind)]


def _stationary(path: PathEnergy, low: float, high: float, kind: Literal["minimum", "maximum"]) -> PathState:
    """Return the state at the zero of the slope between two places, or at the flatter one if the sign is the same."""

    def slope(x: float) -> float:
        return float(path(np.array([x]))[1][0])

    ends = (slope(low), slope(high))
    if ends[0] * ends[1] < 0:
        zero = float(scipy.optimize.brentq(slope, low, high, xtol=1e-14))
    else:
        zero = low if abs(ends[0]) <= abs(ends[1]) else high
    return _state(kind, zero, path(np.array([zero]))[0][0])


def _state(
    kind: Literal["stop", "minimum", "maximum", "neutral"],
    coordinate: float,
    energy: float,
    press: float = 0.0,
    far: float | None = None,
) -> PathState:
    far = coordinate if far is None else far
    return PathState(
        kind=kind, coordinate=float(coordinate), far_coordinate=float(far), energy=float(energy), press=float(press)
    )


def barrier_between(states: Sequence[PathState], start: PathState, end: PathState) -> float:
    """Return the energy to climb from one state to the highest state before another; 0 if it is downhill all along."""
    low, high = sorted((start.coordinate, end.coordinate))
    return max(state.energy for state in states if low <= state.coordinate <= high) - start.energy
