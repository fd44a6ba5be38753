"""One tendon across one hinge: its energy and its moment at every angle, in closed form.

Angles are 0 where the hinge is straight, as built, positive in the overbend, negative while folding, which is the way
in which the hinge goes farther. The tendon is longest at its top: at straight where its ends lie in one plane with the
hinge's axis, and beside it where they are offset from that plane.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.material import ElasticLaw
from forficula.structure import Crossing, Hinge, Structure, Tendon


@dataclass(frozen=True, kw_only=True)
class TendonHinge:
    """A tendon across a hinge.

    Its ends turn about the hinge axis on two circles, `axial_offset` apart. With arms a and b, the offset c and the
    angle delta of the arms as built, length^2 = a^2 + b^2 + c^2 + 2 a b cos(angle + delta) (law of cosines; with c and
    delta 0 theory.md, section 3); see `forficula.structure.Crossing`.

    The numbers may be arrays, for many hinges at once; see `stacked_hinges`.

    Attributes:
        law: of the tendon.
        proximal_arm: distance of the tendon's end on the proximal side from the hinge axis, m.
        distal_arm: the same on the side that turns, m.
        axial_offset: distance between the ends along the hinge axis, m; 0 where both bars are square to it.
        offset_angle: delta, rad; 0 where the ends lie in one plane with the axis.
        overbend: how far the hinge bends past straight, rad.
        fold_limit: how far it folds, rad.
        inertia: of what turns about the hinge axis, kg m^2.
        sense: +1 or -1, by which angles here are multiplied to be those of the structure's hinge in its own sense.

    Raises:
        InputError: a number out of its bounds or not finite.
    """

    law: ElasticLaw
    proximal_arm: float
    distal_arm: float
    axial_offset: float = 0.0
    offset_angle: float = 0.0
    overbend: float
    fold_limit: float
    inertia: float
    sense: int = 1

    def __post_init__(self) -> None:
        for name, unit in (("proximal_arm", "m"), ("distal_arm", "m"), ("inertia", "kg m^2")):
            value = getattr(self, name)
            if not np.all(np.isfinite(value) & (np.asarray(value) > 0)):
                raise InputError(f"{name}: need > 0, got {np.min(value):g} {unit}")
        if not np.all(np.isfinite(self.axial_offset)):
            raise InputError(f"axial_offset: need a finite number, got {np.min(self.axial_offset):g} m")
        for name, limit in (("overbend", math.pi), ("fold_limit", math.pi), ("offset_angle", math.pi)):
            value, least = np.asarray(getattr(self, name)), -math.pi if name == "offset_angle" else 0.0
            if not np.all((least <= value) & (value <= limit)):
                wrong = math.degrees(float(value[~((least <= value) & (value <= limit))].ravel()[0]))
                raise InputError(f"{name}: need >= {math.degrees(least):g} deg and <= 180 deg, got {wrong:g} deg")

    @cached_property
    def _arms(self) -> tuple[Any, Any, Any]:
        """Product of the arms, m^2, and lengths by which the tendon's follows from half the angle, m."""
        product = self.proximal_arm * self.distal_arm
        return product, np.hypot(self.axial_offset, self.proximal_arm - self.distal_arm), 2 * np.sqrt(product)

    @property
    def top(self) -> float:
        """Angle at which the tendon is longest, rad; it may lie beyond a stop."""
        return 0.0 - self.offset_angle

    @property
    def top_to_overbend(self) -> float:
        """How far the overbend stop is from the top, rad; negative where the top lies beyond the stop."""
        return self.overbend + self.offset_angle

    @property
    def top_to_fold(self) -> float:
        """How far the fold limit is from the top, rad; negative where the top lies beyond the limit."""
        return self.fold_limit - self.offset_angle

    @property
    def nearest(self) -> float:
        """How near to the top the hinge comes, rad; 0 where the top lies between its stops."""
        return max(0.0, -self.top_to_overbend, -self.top_to_fold)

    @property
    def pulls(self) -> bool:
        """Whether the tendon pulls where the hinge is nearest to the top; if not, it is slack at every angle."""
        return bool(self.law.force(self.length_from_top(self.nearest)) > 0)

    @property
    def slack_distance(self) -> float | None:
        """How far from the top, either way, the tendon has its resting length, rad; None where it has it nowhere.

        With equal arms and no offset 2 acos(rest length / length at straight) (theory.md, section 3), here through
        half angles, which keep all digits at 0 and at 180 deg.
        """
        offset, longest, rest = (
            float(self.length_from_top(math.pi)),
            float(self.length_from_top(0.0)),
            self.law.rest_length,
        )
        if not offset <= rest <= longest:
            return None
        return 2 * math.atan2(math.sqrt(longest - rest) * math.sqrt(longest + rest), math.sqrt(rest**2 - offset**2))

    def length(self, angle: ArrayLike) -> Array:
        """Length of the tendon, m, in the shape of `angle` (rad); law of cosines."""
        return self.length_from_top(np.asarray(angle, dtype=np.float64) + self.offset_angle)

    def length_from_top(self, apart: ArrayLike) -> Array:
        """Length of the tendon this far from the top, either way, m, in the shape of `apart` (rad)."""
        _, half_cosine = _half_angle(apart)
        # a sum of squares keeps its digits where the ends meet
        shortest = np.hypot(self.axial_offset, self.proximal_arm - self.distal_arm)  # at 180 deg
        return np.asarray(np.hypot(shortest, 2 * np.sqrt(self.proximal_arm * self.distal_arm) * half_cosine))

    def lever(self, angle: ArrayLike) -> Array:
        """Lever of the tendon about the hinge axis, -d length / d angle, m, in the shape of `angle` (rad).

        a b sin(angle + delta) / length (theory.md, section 3); 0 where the tendon's ends meet.
        """
        apart = np.asarray(angle, dtype=np.float64) + self.offset_angle
        half_sine, half_cosine = _half_angle(apart)
        product = 2 * self.proximal_arm * self.distal_arm * half_sine * half_cosine
        return _divide(product, self.length_from_top(apart))

    def energy(self, angle: ArrayLike) -> Array:
        """Energy of the tendon, J, in the shape of `angle` (rad)."""
        return self.law.energy(self.length(angle))

    def moment(self, angle: ArrayLike) -> Array:
        """Moment of the tendon about the hinge, -d energy / d angle, N m, in the shape of `angle` (rad).

        Positive towards the overbend; force times lever (theory.md, section 3). The stops are not in it.
        """
        return np.asarray(self.law.force(self.length(angle)) * self.lever(angle))

    def stiffness(self, angle: ArrayLike) -> Array:
        """Second derivative of the energy by the angle, N m/rad, in the shape of `angle` (rad).

        With force F, length L and lever q: (F' - F/L) q^2 - (F/L) a b cos(angle + delta), the derivative of the moment
        above.
        """
        return self.expansion(angle)[2]

    def expansion(self, angle: ArrayLike) -> tuple[Array, Array, Array]:
        """Energy, moment and stiffness at once, in the shape of `angle` (rad)."""
        half_sine, half_cosine = _half_angle(np.asarray(angle, dtype=np.float64) + self.offset_angle)
        product, shortest, longest = self._arms
        length = np.asarray(np.hypot(shortest, longest * half_cosine))
        lever = _divide(2 * product * half_sine * half_cosine, length)
        energy, force, slope = self.law.expansion(length)
        # where the ends meet, force by length tends to the slope
        by_length = np.divide(force, length, out=np.array(slope), where=length > 0)
        turned = by_length * self.proximal_arm * self.distal_arm * (half_cosine**2 - half_sine**2)
        stiffness = np.asarray((slope - by_length) * lever**2 - turned)
        return np.asarray(energy), np.asarray(force * lever), stiffness


def ideal_hinges(structure: Structure) -> tuple[TendonHinge, ...]:
    """Every tendon's hinge with both bars square to its axis (theory.md, section 3), of those that have such bars.

    Of the tendons' laws they take the spring, as slow motions do: Maxwell branches are relaxed, and nothing yields.
    """
    return tuple(tendon_hinge(structure, each, each.ideal) for each in structure.tendons if each.ideal is not None)


def tendon_hinges(structure: Structure) -> tuple[TendonHinge, ...]:
    """The hinges that one tendon lies across, each about its own axis, with all others held still.

    Of the tendons' laws they take the spring, as slow motions do: Maxwell branches are relaxed, and nothing yields.

    Returns:
        One for each tendon whose length depends on one hinge, in the order of the tendons.
    """
    crossed = ((each, each.crossing) for each in structure.tendons)
    return tuple(tendon_hinge(structure, each, crossing) for each, crossing in crossed if crossing is not None)


def hinges_in_own_senses(structure: Structure) -> tuple[TendonHinge, ...]:
    """As `tendon_hinges`, with angles in the hinges' own senses, whichever way they fold."""
    return tuple(each if each.sense > 0 else _turned_round(each) for each in tendon_hinges(structure))


def folding_sense(hinge: Hinge) -> int:
    """+1 where a hinge goes farther to negative angles, so that these fold it; -1 where it goes farther to positive."""
    return 1 if hinge.upper <= -hinge.lower else -1


def tendon_hinge(structure: Structure, tendon: Tendon, crossing: Crossing) -> TendonHinge:
    """The hinge that a tendon lies across, as one of its crossings has it: its own, or its ideal one."""
    stops = structure.hinges[crossing.hinge]
    own = TendonHinge(
        law=tendon.law.elastic,
        proximal_arm=crossing.proximal_arm,
        distal_arm=crossing.distal_arm,
        axial_offset=crossing.axial_offset,
        offset_angle=crossing.offset_angle,
        overbend=min(stops.upper, math.pi),
        fold_limit=min(-stops.lower, math.pi),
        inertia=crossing.inertia,
    )
    return own if folding_sense(stops) > 0 else _turned_round(own)


def _turned_round(hinge: TendonHinge) -> TendonHinge:
    """The hinge with its angles counted the other way."""
    return replace(
        hinge,
        offset_angle=0.0 - hinge.offset_angle,
        overbend=hinge.fold_limit,
        fold_limit=hinge.overbend,
        sense=-hinge.sense,
    )


def stacked_hinges(hinges: Sequence[Sequence[TendonHinge]]) -> TendonHinge:
    """Hinges as one, whose length, energy, moment and stiffness take angles of all, (row, hinge).

    Args:
        hinges: by row.
    """

    def stacked(part: Callable[[TendonHinge], float]) -> Any:
        return np.array([[part(hinge) for hinge in row] for row in hinges])

    return TendonHinge(
        law=ElasticLaw(
            rest_length=stacked(lambda hinge: hinge.law.rest_length),
            linear=stacked(lambda hinge: hinge.law.linear),
            quadratic=stacked(lambda hinge: hinge.law.quadratic),
            cubic=stacked(lambda hinge: hinge.law.cubic),
        ),
        proximal_arm=stacked(lambda hinge: hinge.proximal_arm),
        distal_arm=stacked(lambda hinge: hinge.distal_arm),
        axial_offset=stacked(lambda hinge: hinge.axial_offset),
        offset_angle=stacked(lambda hinge: hinge.offset_angle),
        overbend=stacked(lambda hinge: hinge.overbend),
        fold_limit=stacked(lambda hinge: hinge.fold_limit),
        inertia=stacked(lambda hinge: hinge.inertia),
    )


def slack_angle(hinge: TendonHinge) -> float | None:
    """Angle beyond which the folding hinge is free, rad; None where it has none up to the fold limit.

    Where the tendon is slack at every angle there is none either.
    """
    distance = hinge.slack_distance
    if not hinge.pulls or distance is None or distance > hinge.top_to_fold:
        return None
    return -distance - hinge.offset_angle


def released_energy(hinge: TendonHinge, start: float, further: ArrayLike) -> Array:
    """Energy that the tendon gives back as the hinge moves away from the top.

    The shortening as a product, which keeps its digits where the way is short:
    L0^2 - L1^2 = 4 a b sin(further / 2) sin(start + further / 2).

    Args:
        hinge: the hinge.
        start: distance from the top, either way, >= 0, rad.
        further: by how much the distance grows, up to 360 deg less `start` in all, rad, any shape.

    Returns:
        J, in the shape of `further`.
    """
    half = np.asarray(further, dtype=np.float64) / 2
    longer, shorter = hinge.length_from_top(start), hinge.length_from_top(start + 2 * half)
    product = 4 * hinge.proximal_arm * hinge.distal_arm * np.sin(half) * np.sin(start + half)
    return hinge.law.released(longer, _divide(product, longer + shorter))


def _half_angle(angle: ArrayLike) -> tuple[Array, Array]:
    """Sine and cosine of half an angle; the float pi is short of 180 deg, where the cosine is 0."""
    angle = np.asarray(angle, dtype=np.float64)
    half = angle / 2
    return np.sin(half), np.where(np.abs(angle) == math.pi, 0.0, np.cos(half))


def _divide(numerator: Array, denominator: Array) -> Array:
    """Divide; 0 where the denominator is 0."""
    return np.asarray(np.divide(numerator, denominator, out=np.zeros(np.shape(denominator)), where=denominator > 0))
