"""Quasi-static drag: the equilibrium of a structure while one of its points is pulled to a position."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Generic, NamedTuple, TypeVar

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.quantities import show_value
from forficula.statics.quasi_static_path import QuasiStaticPoint
from forficula.structure import Structure

Shape = TypeVar("Shape")

# distance within which a target counts as reached, as a share of the structure's span
_NEAR = 1e-4
_UPDATES = 4  # of the pull, until the target is reached
_LESS = 0.5  # ratio of the distances before and after an update above which a target is out of reach
# stiffness of the pull, relative to the stiffness of the structure at the dragged point
STIFF = 1e3
# [chosen] longest move in one increment, as a share of the span, where creases fold permanently; and most increments
_INCREMENT, _MOST_INCREMENTS = 0.05, 100
_RIGID = 5e-3  # compliance that counts as none, relative to the largest one at the dragged point


@dataclass(frozen=True, kw_only=True, eq=False)
class DraggedShape:
    """Equilibrium of a structure while a point of it is pulled to a target.

    Attributes:
        point: the equilibrium, at an unchanged strength of the drive; start of the next move.
        target: m, (3,).
        position: position of the dragged point, m, (3,).
        force: force on the dragged point that holds the structure in this shape, N, (3,); if the target is not reached,
            the least such force, without components along which the structure hardly yields.
        reached: whether the dragged point is at the target; otherwise the shape is the nearest equilibrium.
        stable: whether the structure comes to rest in this shape while the point is held.
        text: a sentence on the force or on the distance that is missing.
    """

    point: QuasiStaticPoint
    target: Array
    position: Array
    force: Array
    reached: bool
    stable: bool
    text: str


@dataclass(frozen=True, kw_only=True, eq=False)
class DraggedPoint:
    """A structure with a point that can be dragged.

    Attributes:
        structure: the structure.
        places: weights of the places, as in `QuasiStaticPoint.positions`, whose mean is the dragged point.
        start: shape from which the drag starts.
        pull: solver: takes a shape near the equilibrium and a target, m, (3,).
    """

    structure: Structure
    places: Mapping[int, float]
    start: QuasiStaticPoint
    pull: Callable[[QuasiStaticPoint, Array], DraggedShape]

    def to(self, target: Array, near: QuasiStaticPoint | None = None) -> DraggedShape:
        """Pull the point to a target.

        Where creases fold permanently or wear out, the point moves straight to the target in short increments. In each
        increment every crease turns in one sense.

        Args:
            target: m, (3,).
            near: shape of the previous move; by default that from which the drag starts.
        """
        target = np.asarray(target, dtype=np.float64)
        if target.shape != (3,) or not np.isfinite(target).all():
            raise InputError(f"target: need three finite coordinates in m, got {target}")
        near = self.start if near is None else near
        if near.memory is None:
            return self.pull(near, target)
        begin = np.sum([weight * near.positions[place] for place, weight in self.places.items()], axis=0)
        away = float(np.linalg.norm(target - begin)) / (_INCREMENT * self.structure.span)
        count = min(max(math.ceil(away), 1), _MOST_INCREMENTS)
        for number in range(1, count):
            near = self.pull(near, begin + number / count * (target - begin)).point
        return self.pull(near, target)


class Held(NamedTuple, Generic[Shape]):
    """Equilibrium while a spring pulls a point to an aim.

    Attributes:
        shape: in the solver's coordinates.
        position: position of the dragged point, m, (3,).
        force: force of the spring on the dragged point, N, (3,).
        stable: whether the structure comes to rest.
    """

    shape: Shape
    position: Array
    force: Array
    stable: bool


def approach(
    hold: Callable[[Shape, Array], Held[Shape]],
    start: Shape,
    target: Array,
    span: float,
    torn: Callable[[Shape], bool] = lambda _: False,
) -> tuple[Held[Shape], bool]:
    """Pull a point to a target by a spring, whose end moves beyond the target by the distance that is missing.

    This is the method of multipliers (Hestenes 1969, J. Optim. Theory Appl. 4, 303-320). If the distance does not
    decrease, or if parts tear, the target is out of reach, and the spring ends at the target.

    Args:
        hold: finds the equilibrium near a shape while the spring ends at an aim, m, (3,).
        start: shape near the equilibrium.
        target: m, (3,).
        span: of the structure, m.
        torn: whether the strains of a shape tear parts of it.

    Returns:
        The equilibrium, and whether the point is at the target.
    """
    held = first = hold(start, target)
    before, aim = math.inf, target
    for _ in range(_UPDATES):
        away, tears = float(np.linalg.norm(target - held.position)), torn(held.shape)
        if away <= _NEAR * span and not tears:
            return held, True
        if tears or away > _LESS * before:
            break
        aim, before = aim + target - held.position, away
        held = hold(held.shape, aim)
    return first, False


def checked_places(structure: Structure, places: int | Mapping[int, float]) -> dict[int, float]:
    """Return the weights of places, which add up to 1.

    Raises:
        InputError: there is no such place, or the weights add up to another number.
    """
    weights = {places: 1.0} if isinstance(places, int) else dict(places)
    count = len(structure.points) + sum(len(membrane.bodies) for membrane in structure.membranes)
    unknown = [place for place in weights if not 0 <= place < count]
    if unknown:
        raise InputError(f"places: need numbers from 0 to {count - 1}, got {unknown[0]}")
    if not abs(sum(weights.values()) - 1) <= 1e-6:
        raise InputError(f"places: need weights that add up to 1, got {sum(weights.values()):g}")
    return weights


def dragged_shape(
    structure: Structure, point: QuasiStaticPoint, target: Array, held: Held[Shape], *, reached: bool
) -> DraggedShape:
    """Return an equilibrium with a sentence on its force, or on the distance from a target out of reach."""
    force = show_value(float(np.linalg.norm(held.force)), "N", 3)
    text = f"A force of {force} holds the point here."
    if not reached:
        away = show_value(float(np.linalg.norm(target - held.position)), "m", 3)
        text = (
            f"The {structure.appearance.whole} cannot reach this position; the nearest equilibrium is {away} away, and"
            f" a force of {force} holds it there."
        )
    return DraggedShape(
        point=point,
        target=target,
        position=held.position,
        force=held.force,
        reached=reached,
        stable=held.stable,
        text=text,
    )


def least_force(force: Array, compliance: Array) -> Array:
    """Return the components of a force along which a structure yields, N, (3,).

    Args:
        force: N, (3,).
        compliance: of the structure at the point of the force, m/N, (3, 3).
    """
    values, axes = np.linalg.eigh(compliance)
    soft = axes[:, (values > _RIGID * values.max()) & (values > 0)]
    return np.asarray(soft @ (soft.T @ force))
