"""Where anything rests: equilibria of an energy and the barriers between them. It knows no mechanism."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Literal

import numpy as np
import scipy
from numpy.typing import ArrayLike, NDArray

from forficula.arrays import Array, Flags

Cases = NDArray[np.int64]
# Of positions, (row, coordinate), in the cases with these numbers, (row,): the energy, (row,), its slope,
# (row, coordinate), and its curvature, (row, coordinate, coordinate).
Energy = Callable[[Array, Cases], tuple[Array, Array, Array]]
# Of the cases with these numbers, and all positions, (case, coordinate).
Follow = Callable[[Cases, Array], None]

_MOST_STEPS = 5000
# share of a path beyond which a stretch without a slope is no minimum but a neutral range
_WIDE = 0.05
_SMALLEST_STEP = 1e-13
# share of the step within which a coordinate that is pushed onto its bound is laid there
_NEAR = 0.1
# enough for all digits of a step's length
_NEWTON_STEPS = 6
_ROUNDING = 1e-12  # of an energy
# Of a slope by the curvature: a few last digits of a coordinate of the size of 1. Where a tendon is slack at most
# angles, the slope that counts as none can be smaller, and steps would alternate between two neighbouring numbers.
_NOISE = 1e-15


@dataclass(frozen=True, kw_only=True)
class Equilibria:
    """Where some cases came to rest.

    Attributes:
        position: (case, coordinate).
        energy: (case,).
        slope: of the energy, none but where a coordinate presses on its bound, (case, coordinate).
        stiffness: least curvature of the energy along what no bound holds, (case,); inf where bounds hold everything.
        rests: whether it came to rest at all, (case,).
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
) -> Equilibria:
    """Follow an energy downhill to where it rests, in steps so short that they stay in its valley.

    Newton's method with a trust region (More and Sorensen 1983) within a box (Bertsekas 1982). Far from rest its short
    steps go down the steepest slope, as a motion does that equal dampers slow; all cases go side by side.

    Args:
        energy: with slope and curvature; see `Energy`.
        start: (case, coordinate), moved into the box.
        lower: bounds of the coordinates, (coordinate,) or (case, coordinate).
        upper: alike.
        longest_step: in the space of the coordinates.
        force: largest slope that counts as none; slopes of the size of their rounding do so, too.
        follow: called after every step with the numbers of the cases that are not at rest and all positions.
    """
    lower, upper = (np.array(np.broadcast_to(each, start.shape)) for each in (lower, upper))
    position = np.clip(start, lower, upper)
    value, slope, curvature = energy(position, np.arange(len(position)))
    # last bits of sums by row depend on the order in memory
    position, slope = np.ascontiguousarray(position), np.ascontiguousarray(slope)
    radius = np.full(len(position), longest_step)
    stiffness, rests = np.full(len(position), np.nan), np.zeros(len(position), dtype=bool)
    moving = np.arange(len(position))
    rows: slice | Cases = slice(None)  # the same while all move, without copies
    for _ in range(_MOST_STEPS):
        at, down = position[rows], -slope[rows]
        least, most = lower[rows], upper[rows]
        step, held, stiffness[rows] = _step_within((least - at, most - at), down, curvature[rows], radius[rows])
        quiet = np.maximum(force, _NOISE * np.maximum.reduce(np.abs(curvature[rows]), axis=(1, 2)))[:, None]
        rests[rows] = np.logical_and.reduce((np.abs(down) <= quiet) | (held & (step == 0)), axis=1)
        going = ~rests[rows] & (radius[rows] > _SMALLEST_STEP)
        if not going.all():
            moving = rows = moving[going]
            if not len(moving):
                break
            at, down, least, most = at[going], down[going], least[going], most[going]
            step, held = step[going], held[going]
        tried, free = np.clip(at + step, least, most), ~held
        new_value, new_slope, new_curvature = energy(tried, moving)
        better = _better(new_value, new_slope * free, value[rows], down * free)
        wider = np.minimum(2 * radius[rows], longest_step)
        narrower = np.minimum(radius[rows], _lengths(step)) / 4
        radius[rows] = np.where(better, wider, narrower)
        if better.all():
            position[rows], value[rows], slope[rows], curvature[rows] = tried, new_value, new_slope, new_curvature
        else:
            taken = moving[better]
            position[taken], value[taken] = tried[better], new_value[better]
            slope[taken], curvature[taken] = new_slope[better], new_curvature[better]
        if follow is not None:
            follow(moving, position)
    return Equilibria(position=position, energy=value, slope=slope, stiffness=stiffness, rests=rests)


def _better(new_value: Array, new_slope: Array, value: Array, slope: Array) -> Flags:
    """Whether the energy falls, (case,); where it stays to rounding, whether the slope does."""
    flatter = _lengths(new_slope) < _lengths(slope)
    return np.asarray((new_value < value) | ((new_value <= value + _ROUNDING * np.abs(value)) & flatter))


def _lengths(vectors: Array) -> Array:
    """Return the lengths of vectors, (case, coordinate)."""
    return np.asarray(np.sqrt(np.add.reduce(vectors * vectors, axis=1)))


def _step_within(room: tuple[Array, Array], down: Array, curvature: Array, radius: Array) -> tuple[Array, Flags, Array]:
    """A step downhill within a ball and a box, (case, coordinate).

    Args:
        room: ways to the bounds, <= 0 and >= 0, (case, coordinate).
        down: the slope turned round, alike.
        curvature: (case, coordinate, coordinate).
        radius: of the ball, (case,).

    Returns:
        The step; which coordinates their bounds hold, alike; the least curvature of the others, (case,).
    """
    loose = np.flatnonzero((room[0] < room[1]).any(axis=0))
    if len(loose) == down.shape[1] and len(down):
        return _free_step(room, down, curvature, radius)
    step, held, least = np.zeros_like(down), np.ones(down.shape, dtype=bool), np.full(len(down), np.inf)
    if len(loose) and len(down):
        room, down, curvature = (room[0][:, loose], room[1][:, loose]), down[:, loose], curvature[:, loose][:, :, loose]
        step[:, loose], held[:, loose], least = _free_step(room, down, curvature, radius)
    return step, held, least


def _free_step(room: tuple[Array, Array], down: Array, curvature: Array, radius: Array) -> tuple[Array, Flags, Array]:
    """As `_step_within`, where every coordinate has room in some case."""
    to_bound = np.where(down < 0, *room)
    held = (down != 0) & (np.abs(to_bound) <= _NEAR * radius[:, None])
    values, axes = np.linalg.eigh(_without(curvature, held))
    # last bits depend on the order in memory
    free = _trusted_step(np.asfortranarray(np.where(held, 0.0, down)), values, axes, radius)
    step = np.minimum(np.maximum(np.where(held, to_bound, free), room[0]), room[1])
    return step, held, np.where(held.all(axis=1), np.inf, values[:, 0])


def _without(curvature: Array, held: Flags) -> Array:
    """Curvatures of the free coordinates; the held ones get the largest of all, on their own."""
    if not held.any():
        return curvature
    free = ~held
    kept = curvature * (free[:, :, None] & free[:, None, :])
    largest = np.maximum.reduce(np.abs(curvature), axis=(1, 2))[:, None]
    diagonal = np.einsum("...ii->...i", kept)
    diagonal += np.where(held, np.maximum(largest, 1e-300), 0.0)
    return np.asarray(kept)


def _trusted_step(down: Array, values: Array, axes: Array, radius: Array) -> Array:
    """To the lowest point of a quadratic model within a ball, (case, coordinate).

    Where the step is longer than the ball, Newton's method on 1 / length looks for the damping that shortens it; from
    below it rises to it (Conn, Gould and Toint 2000, section 7.3).
    """
    # ufuncs by name are several times as fast as the same by functions and methods, and most calls have few cases
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
        if not np.logical_or.reduce(beyond):  # further ones would change nothing
            break
        rise = np.divide(square, add(squares / shifted, axis=1), out=np.zeros(len(square)), where=beyond)
        damping = damping + rise * (longer - 1)
    else:
        step = along / (values + damping[:, None])
    return np.asarray((axes @ step[..., None])[..., 0])


@dataclass(frozen=True, kw_only=True)
class PathState:
    """Where something on a path rests.

    Attributes:
        kind: "stop", pressed onto the end of the path; "minimum"; "maximum", which any push leaves; "neutral", a range
            over which the energy does not change.
        coordinate: along the path; of a neutral range the nearer end.
        far_coordinate: the other end of a neutral range; otherwise the coordinate.
        energy: there.
        press: slope of the energy that presses onto the end of the path, >= 0; 0 unless the kind is "stop".
    """

    kind: Literal["stop", "minimum", "maximum", "neutral"]
    coordinate: float
    far_coordinate: float
    energy: float
    press: float

    @property
    def stable(self) -> bool:
        """Whether it stays there after a small push."""
        return self.kind != "maximum"


# energy and slope at places on a path
PathEnergy = Callable[[Array], tuple[Array, Array]]


def states_along(path: PathEnergy, places: Array, *, force: ArrayLike, wide: float = _WIDE) -> tuple[PathState, ...]:
    """Find where something on a path rests, from its start to its end.

    Stationary points are zeros of the slope (Brent 1973), one at most looked for between two neighbouring places.

    Args:
        path: energy, and its slope by the coordinate.
        places: rising coordinates from one end of the path to the other, (place,).
        force: largest slope that counts as none, one or by place.
        wide: share of the path beyond which a stretch without a slope is no minimum but a neutral range.
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
    """What a stretch without a slope to speak of is, between slopes of these signs, 0 at the end of the path."""
    kind: Literal["minimum", "maximum"] = "maximum" if before > 0 or after < 0 else "minimum"
    passes = before == after != 0
    if (kind == "minimum" or passes) and places[-1] - places[0] > wide:
        return [_state("neutral", places[0], path(places[:1])[0][0], far=places[-1])]
    return [] if passes else [_stationary(path, places[0], places[-1], kind)]


def _stationary(path: PathEnergy, low: float, high: float, kind: Literal["minimum", "maximum"]) -> PathState:
    """The zero of the slope between two places, or the flatter of them where it keeps its sign."""

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
    """Energy to climb from one state to another: to the highest state on the way; 0 where it is downhill all along."""
    low, high = sorted((start.coordinate, end.coordinate))
    return max(state.energy for state in states if low <= state.coordinate <= high) - start.energy
