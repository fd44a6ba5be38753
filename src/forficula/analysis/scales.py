"""Scale of the moments and times of a structure: its strongest tendon, or its stiffest crease."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np

from forficula.arrays import Array
from forficula.quantities import Unit
from forficula.serial import Key, Metres, NewtonMetres, Seconds, Written
from forficula.structure import GROUND, Structure, ancestry, built_frames, built_points, hinge_groups, mass_of

# N m and kg m^2: range in which ratios neither overflow nor underflow
_LEAST, _MOST = 1e-150, 1e150
# moments within this share count as equal and the first is taken, so that rounding does not decide
_SAME = 1e-9


@dataclass(frozen=True, kw_only=True)
class Scale:
    """The part that turns about one hinge, and the elastic part that moves it.

    Attributes:
        name: of the elastic part: of a tendon, or of the hinge that has the spring.
        hinge: number of the hinge.
        moment: k a b of a tendon, stiffness times both arms, or the stiffness of a hinge's spring, N m.
        inertia: about the hinge, without its armature, kg m^2; 0 if no part with mass is free to turn.
        weight_arm: mass of the turning part times the distance of its centre from the hinge's axis, kg m.
        reach: largest distance of the turning part from the hinge, m.
        tendon: number of the tendon; None if the scale is a hinge's spring.
        arms: a and b of the tendon, m; zeros without a tendon.
    """

    name: Annotated[str, Key("part")]
    hinge: Annotated[int, Written.NEVER]
    moment: NewtonMetres
    inertia: Annotated[float, Unit("kg m^2")]
    weight_arm: Annotated[float, Written.NEVER]
    reach: Annotated[Metres, Written.NEVER]
    tendon: Annotated[int | None, Written.NEVER] = None
    arms: Annotated[tuple[float, float], Written.NEVER] = (0.0, 0.0)

    @property
    def time(self) -> Seconds:
        """Return the time t* = sqrt(inertia / moment) of the elastic and the turning part, s; 0 without inertia."""
        return math.sqrt(self.inertia / self.moment)


def scale_of(structure: Structure) -> Scale | None:
    """Find the scale of a structure: its strongest tendon, or its stiffest crease if no tendon qualifies.

    A tendon qualifies if it lies across one hinge and pulls as soon as it is stretched. If the structure has bars, arms
    and inertia are those of bars perpendicular to the hinge, as in the closed forms of one tendon across one hinge,
    where the moment is k a b sin(angle) for a resting length of 0.

    Args:
        structure: SI.

    Returns:
        None if neither a tendon nor a hinge's spring moves a part.
    """
    crossings = [tendon.ideal or tendon.crossing for tendon in structure.tendons]
    number, moment = _largest(
        [
            0.0 if crossing is None else tendon.law.stiffness[0] * crossing.proximal_arm * crossing.distal_arm
            for tendon, crossing in zip(structure.tendons, crossings, strict=True)
        ]
    )
    crossing = crossings[number] if moment else None
    if crossing is None:
        return _crease_scale(structure)
    _, weight_arm, reach = _turning(structure, crossing.hinge)
    if structure.tendons[number].ideal is not None:
        body = structure.hinges[crossing.hinge].body
        reach = max(float(np.linalg.norm(bar.end)) for bar in structure.bars if bar.body == body)
    return Scale(
        name=structure.tendons[number].name,
        hinge=crossing.hinge,
        moment=moment,
        inertia=_usable_inertia(crossing.inertia - structure.hinges[crossing.hinge].armature),
        weight_arm=weight_arm,
        reach=reach,
        tendon=number,
        arms=(crossing.proximal_arm, crossing.distal_arm),
    )


def _largest(moments: Sequence[float]) -> tuple[int, float]:
    """Return the index and the value of the first of the largest moments within the usable range; 0 if none is."""
    most = max((moment for moment in moments if _LEAST < moment < _MOST), default=0.0)
    number = next((place for place, moment in enumerate(moments) if (1 - _SAME) * most <= moment < _MOST), 0)
    return number, moments[number] if most else 0.0


def _usable_inertia(inertia: float) -> float:
    """Return an inertia, or 0 if it is outside the usable range."""
    return inertia if _LEAST < inertia < _MOST else 0.0


def _crease_scale(structure: Structure) -> Scale | None:
    """Return the scale of the stiffest spring in a hinge or a crease; bends of facets do not count."""
    groups = hinge_groups(structure)
    folds = [number for kind in ("hinges", "creases") for number in groups.get(kind, ())]
    place, moment = _largest([structure.hinges[number].stiffness for number in folds])
    if not moment:
        return None
    inertia, weight_arm, reach = _turning(structure, folds[place])
    return Scale(
        name=structure.hinges[folds[place]].name,
        hinge=folds[place],
        moment=moment,
        inertia=_usable_inertia(inertia),
        weight_arm=weight_arm,
        reach=reach,
    )


def _turning(structure: Structure, number: int) -> tuple[float, float, float]:
    """Compute inertia, kg m^2, weight arm, kg m, and reach, m, of the part that turns about a hinge as built.

    The weight arm is the mass times the distance of its centre from the axis. About a joint, its body and all bodies
    that depend on it turn. About a crease, the two corners of its flaps turn against each other like two bodies on one
    axle, with the inertia 1 / (1 / I1 + 1 / I2), where a held corner has infinite inertia. The weight arm is the
    smaller one of both corners.
    """
    hinge, points = structure.hinges[number], built_points(structure)
    if hinge.flaps is None:
        origins, frames = built_frames(structure)
        turned = [body for body in range(len(structure.bodies)) if hinge.body in ancestry(structure, body)]
        origin, axis = origins[hinge.body], frames[hinge.body] @ hinge.axis
        ends = [place for place, point in zip(points, structure.points, strict=True) if point.body in turned]
        reach = max((float(np.linalg.norm(np.cross(axis, end - origin))) for end in ends), default=0.0)
        return *_inertia_about(structure, turned, origin, axis), reach
    tail, head, left, _, _, right = hinge.flaps
    along = (points[head] - points[tail]) / np.linalg.norm(points[head] - points[tail])
    bodies = [structure.points[corner].body for corner in (left, right)]
    free = [body for body in bodies if body != GROUND and structure.bodies[body].slides]
    sides = [_inertia_about(structure, [body], points[tail], along) for body in free]
    heavy = [side for side in sides if side[0] > 0]
    reach = max(float(np.linalg.norm(np.cross(along, points[corner] - points[tail]))) for corner in (left, right))
    if not heavy:
        return 0.0, 0.0, reach
    return 1 / sum(1 / inertia for inertia, _ in heavy), min(arm for _, arm in heavy), reach


def _inertia_about(structure: Structure, bodies: list[int], origin: Array, axis: Array) -> tuple[float, float]:
    """Compute inertia of bodies about an axis as built, kg m^2, and mass times distance of their centre, kg m."""
    origins, frames = built_frames(structure)
    inertia, first = 0.0, np.zeros(3)
    for body in bodies:
        mass, centre, tensor = mass_of(structure, body)
        inertia += float(axis @ frames[body] @ tensor @ frames[body].T @ axis)
        for weight, place in ((mass, centre), (structure.bodies[body].mass, np.zeros(3))):
            away = np.cross(axis, origins[body] + frames[body] @ place - origin)
            inertia, first = inertia + weight * float(away @ away), first + weight * away
    return inertia, float(np.linalg.norm(first))
