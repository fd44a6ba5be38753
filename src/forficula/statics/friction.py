"""Dry friction of hinges in statics: the angles at which hinges are stuck, and the additional strength of a drive."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from forficula.arrays import Array, Flags
from forficula.design import TORQUE
from forficula.quantities import Unit, show_quantity
from forficula.statics.tree.ensemble import Ensemble
from forficula.statics.tree.potential import potential
from forficula.structure import Drive, Structure

_STEP = np.radians(1.0)  # between two angles that are tried, rad
_NARROW = 0.01  # deg, width of a band that counts as one angle
_HALVINGS = 30  # of the step in which a hinge begins to slide


@dataclass(frozen=True, kw_only=True)
class FrictionBand:
    """Angles at which dry friction holds a hinge in a state, while all other hinges keep their angles.

    Attributes:
        state: name of the state.
        hinge: name of the hinge.
        lower: smallest angle, in the hinge's own sense, rad.
        upper: largest angle, rad.
    """

    state: str
    hinge: str
    lower: Annotated[float, Unit("rad")]
    upper: Annotated[float, Unit("rad")]


def friction_bands(structures: Ensemble, states: Sequence[tuple[str, Array]]) -> tuple[FrictionBand, ...]:
    """Compute the angles around resting states at which dry friction holds single hinges.

    A hinge is stuck where the moment of all elastic parts and weights is at most its friction. The band ends at the
    nearest angle at which the moment is larger, or at a stop. Hinges that rigid couplings, closed loops or supports of
    points tie together have no band, because they cannot turn alone.

    Args:
        structures: a tree as the only case.
        states: names, and angles of all joints at rest, rad, (joint,).
    """
    structure = structures.structure
    if structures.ties is not None or structures.pins is not None or structures.supported:
        return ()
    return tuple(
        FrictionBand(
            state=name,
            hinge=hinge.name,
            lower=_end(structures, angles, number, -1.0),
            upper=_end(structures, angles, number, 1.0),
        )
        for name, angles in states
        for number, hinge in enumerate(structure.hinges[: structures.size])
        if hinge.friction
    )


def _end(structures: Ensemble, angles: Array, number: int, sense: float) -> float:
    """Return the end of the band of a hinge on one side of its angle at rest, rad."""
    start, friction = float(angles[number]), structures.structure.hinges[number].friction
    bound = float((structures.upper if sense > 0 else structures.lower)[number])
    reach = min(abs(bound - start), 2 * np.pi)

    def slides(turns: Array) -> Array:
        """Return whether the hinge slides after turns from its angle at rest, rad, (turn,)."""
        positions = np.tile(angles, (len(turns), 1))
        positions[:, number] = start + sense * turns
        moments = potential(structures.repeated(len(turns)), positions, np.zeros((len(turns), len(structures.motors))))
        return np.asarray(np.abs(moments[1][:, number]) > friction)

    turns = np.append(np.arange(1, int(reach / _STEP) + 1) * _STEP, reach)
    sliding = slides(turns)
    if not sliding.any():
        return start + sense * reach
    first = int(np.argmax(sliding))
    stuck, free = (float(turns[first - 1]) if first else 0.0), float(turns[first])
    for _ in range(_HALVINGS):
        middle = (stuck + free) / 2
        stuck, free = (stuck, middle) if slides(np.array([middle]))[0] else (middle, free)
    return start + sense * stuck


def friction_range(structure: Structure, drive: Drive, angles: Array, positions: Array, resting: Flags) -> Array:
    """Compute by how much dry friction increases or reduces the strength of a slow drive, in its SI unit, (point,).

    By virtual work it is the sum of friction times turn of all hinges, divided by the displacement of the drive. The
    shapes of the path are those without friction. This is exact if one drive moves one coordinate, and an estimate if
    friction holds some hinges longer than others.

    Args:
        structure: the structure.
        drive: the drive of torques or forces.
        angles: of all hinges along the path, in their own senses, rad, (point, hinge).
        positions: of the points along the path, m, (point, place, 3).
        resting: whether the structure is at rest, (point,).

    Returns:
        The half width of the range; nan if the drive never moves, 0 without friction.
    """
    friction = np.array([hinge.friction for hinge in structure.hinges])
    if not friction.any():
        return np.zeros(len(angles))
    along = sum(_displacements(structure, drive, angles, positions), np.zeros(len(angles)))
    lost, moved = np.abs(np.diff(angles, axis=0)) @ friction, np.abs(np.diff(along))
    known = np.flatnonzero(resting[:-1] & (moved > 0))
    if not len(known):
        return np.full(len(angles), np.nan)
    # of motions that begin at rest; other points, within snaps or before anything moves, have the range of the nearest
    return np.asarray(np.interp(np.arange(len(angles)), known + 0.5, lost[known] / moved[known]))


def _displacements(structure: Structure, drive: Drive, angles: Array, positions: Array) -> Iterator[Array]:
    """Yield the displacement of the drive at each of its motors, rad or m, (point,)."""
    for motor, share in zip(structure.motors, drive.shares, strict=True):
        if motor.kind == "torque":
            gains = np.array(motor.gains or (1.0,) * len(motor.hinges))
            yield share * angles[:, list(motor.hinges)] @ gains
        elif motor.direction is not None:
            yield share * positions[:, list(motor.points)].sum(axis=1) @ motor.direction


def friction_remarks(structure: Structure, bands: Sequence[FrictionBand] = ()) -> tuple[str, ...]:
    """Return remarks on dry friction: what ignores it, and the widest band of angles in which it holds each state."""
    largest = max((hinge.friction for hinge in structure.hinges), default=0.0)
    if not largest:
        return ()
    return (
        f"the landscape ignores the dry friction of hinges of up to {show_quantity(largest, TORQUE)}: friction holds"
        " states more firmly and increases the torques that move them",
        *_band_remarks(structure, bands),
    )


def _band_remarks(structure: Structure, bands: Sequence[FrictionBand]) -> Iterator[str]:
    labels = {hinge.name: hinge.label or hinge.name for hinge in structure.hinges}
    for state in dict.fromkeys(band.state for band in bands):
        of_state = [band for band in bands if band.state == state]
        widest = max(of_state, key=lambda band: band.upper - band.lower)
        low, high = (math.degrees(angle) for angle in (widest.lower, widest.upper))
        if high - low < _NARROW:
            yield f'in "{state}" dry friction does not hold any hinge at another angle'
            continue
        yield (
            f'in "{state}" dry friction holds the hinge "{labels[widest.hinge]}" at any angle from {low:.4g} to'
            f" {high:.4g} deg while all other hinges keep their angles"
            + (", the widest range of all hinges" if len(of_state) > 1 else "")
        )
