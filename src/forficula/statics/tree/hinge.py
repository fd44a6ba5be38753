"""One tendon across one hinge: its energy and its moment at every angle, in closed form.

Angles are 0 when the hinge is straight, as built, positive in the overbend, and negative when folded, which is the
direction of the larger range. The tendon is longest at its top angle: at straight if its ends lie in one plane with the
hinge's axis, and at another angle if they are offset from that plane.
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
    angle delta of the arms as built, length^2 = a^2 + b^2 + c^2 + 2 a b cos(angle + delta) (law of cosines;
    docs/model/theory.md, sections Tendon across a hinge and Tendon off the hinge axis); see
    `forficula.structure.Crossing`. The numbers may be arrays, for many hinges at once; see `stacked_hinges`.

    Attributes:
        law: of the tendon.
        proximal_arm: distance of the tendon's end on the proximal side from the hinge axis, m.
        distal_arm: the same on the side that turns, m.
        axial_offset: distance between the ends along the hinge axis, m; 0 if both bars are perpendicular to it.
        offset_angle: delta, rad; 0 if the ends lie in one plane with the axis.
        overbend: largest angle past straight, rad.
        fold_limit: largest fold angle, rad.
        inertia: of the part that turns about the hinge axis, kg m^2.
        sense: +1 or -1, the factor that converts these angles to those of the structure's hinge in its own sense.

    Raises:
        InputError: a number is out of its bounds or not finite.
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
    def _arm_terms(self) -> tuple[Any, Any, Any]:
        """Return the product of the arms, m^2, and two lengths for the tendon's length from half the angle, m."""
        product = self.proximal_arm * self.distal_arm
        return product, np.hypot(self.axial_offset, self.proximal_arm - self.distal_arm), 2 * np.sqrt(product)

    @property
    def top(self) -> float:
        """Return the angle at which the tendon is longest, rad; it may lie beyond a stop."""
        return 0.0 - self.offset_angle

    @property
    def top_to_overbend(self) -> float:
        """Return the angle from the top to the overbend stop, rad; negative if the top lies beyond the stop."""
        return self.overbend + self.offset_angle

    @property
    def top_to_fold(self) -> float:
        """Return the angle from the top to the fold limit, rad; negative if the top lies beyond the limit."""
        return self.fold_limit - self.offset_angle

    @property
    def nearest(self) -> float:
        """Return the least angle from the top that the hinge reaches, rad; 0 if the top lies between its stops."""
        return max(0.0, -self.top_to_overbend, -self.top_to_fold)

    @property
    def pulls(self) -> bool:
        """Return whether the tendon pulls at the angle nearest to the top; otherwise it is slack at every angle."""
        return bool(self.law.force(self.length_from_top(self.nearest)) > 0)

    @property
    def slack_distance(self) -> float | None:
        """Return the angle from the top at which the tendon has its resting length, rad; None if it never has.

        With equal arms and no offset it is 2 acos(rest length / length at straight) (docs/model/theory.md, section
        Tendon across a hinge). Half angles keep all digits at 0 and at 180 deg.
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
        """Return the length of the tendon, m, in the shape of `angle` (rad), by the law of cosines."""
        return self.length_from_top(np.asarray(angle, dtype=np.float64) + self.offset_angle)

    def length_from_top(self, apart: ArrayLike) -> Array:
        """Return the length of the tendon at an angle from the top, m, in the shape of `apart` (rad)."""
        _, half_cosine = _half_angle(apart)
        # a sum of squares keeps its digits when the ends meet
        shortest = np.hypot(self.axial_offset, self.proximal_arm - self.distal_arm)  # at 180 deg
        return np.asarray(np.hypot(shortest, 2 * np.sqrt(self.proximal_arm * self.distal_arm) * half_cosine))

    def lever(self, angle: ArrayLike) -> Array:
        """Return the lever of the tendon about the hinge axis, -d length / d angle, m, in the shape of `angle` (rad).

        It is a b sin(angle + delta) / length (docs/model/theory.md, section Tendon across a hinge), and 0 when the
        tendon's ends meet.
        """
        apart = np.asarray(angle, dtype=np.float64) + self.offset_angle
        half_sine, half_cosine = _half_angle(apart)
        product = 2 * self.proximal_arm * self.distal_arm * half_sine * half_cosine
        return _divide(product, self.length_from_top(apart))

    def energy(self, angle: ArrayLike) -> Array:
        """Return the energy of the tendon, J, in the shape of `angle` (rad)."""
        return self.law.energy(self.length(angle))

    def moment(self, angle: ArrayLike) -> Array:
        """Return the moment of the tendon about the hinge, -d energy / d angle, N m, in the shape of `angle` (rad).

        It is force times lever, positive towards the overbend (docs/model/theory.md, section Tendon across a hinge),
        and does not include the stops.
        """
        return np.asarray(self.law.force(self.length(angle)) * self.lever(angle))

    def stiffness(self, angle: ArrayLike) -> Array:
        """Return the second derivative of the energy by the angle, N m/rad, in the shape of `angle` (rad).

        With force F, length L and lever q it is (F' - F/L) q^2 - (F/L) a b cos(angle + delta), minus the derivative of
        the moment.
        """
        return self.expansion(angle)[2]

    def expansion(self, angle: ArrayLike) -> tuple[Array, Array, Array]:
        """Return energy, moment and stiffness at once, in the shape of `angle` (rad)."""
        half_sine, half_cosine = _half_angle(np.asarray(angle, dtype=np.float64) + self.offset_angle)
        product, shortest, longest = self._arm_terms
        length = np.asarray(np.hypot(shortest, longest * half_cosine))
        lever = _divide(2 * product * half_sine * half_cosine, length)
        energy, force, slope = self.law.expansion(length)
        # when the ends meet, force divided by length tends to the slope
        by_length = np.divide(force, length, out=np.array(slope), where=length > 0)
        turned = by_length * self.proximal_arm * self.distal_arm * (half_cosine**2 - half_sine**2)
        stiffness = np.asarray((slope - by_length) * lever**2 - turned)
        return np.asarray(energy), np.asarray(force * lever), stiffness


def ideal_hinges(structure: Structure) -> tuple[TendonHinge, ...]:
    """Return the ideal hinge of every tendon that has one, with both bars perpendicular to the hinge axis.

    See docs/model/theory.md, section Tendon across a hinge. Only the springs of the tendons' laws are used, as in slow
    motions: Maxwell branches are relaxed, and nothing yields.
    """
    tendons = structure.tendons
    return tuple(tendon_hinge(structure, tendon, tendon.ideal) for tendon in tendons if tendon.ideal is not None)


def tendon_hinges(structure: Structure) -> tuple[TendonHinge, ...]:
    """Return the hinges that one tendon lies across, each about its own axis, with all others fixed.

    Only the springs of the tendons' laws are used, as in slow motions: Maxwell branches are relaxed, nothing yields.

    Returns:
        One for each tendon whose length depends on one hinge, in the order of the tendons.
    """
    crossed = ((tendon, tendon.crossing) for tendon in structure.tendons)
    return tuple(tendon_hinge(structure, tendon, crossing) for tendon, crossing in crossed if crossing is not None)


def hinges_in_own_senses(structure: Structure) -> tuple[TendonHinge, ...]:
    """Return the hinges of `tendon_hinges` with angles in the hinges' own senses, not in those of folding."""
    return tuple(hinge if hinge.sense > 0 else _reversed(hinge) for hinge in tendon_hinges(structure))


def folding_sense(hinge: Hinge) -> int:
    """Return +1 if negative angles fold a hinge, because its range on that side is larger; else -1."""
    return 1 if hinge.upper <= -hinge.lower else -1


def tendon_hinge(structure: Structure, tendon: Tendon, crossing: Crossing) -> TendonHinge:
    """Return the hinge that a tendon lies across, for its true or its ideal crossing."""
    stops = structure.hinges[crossing.hinge]
    hinge = TendonHinge(
        law=tendon.law.elastic,
        proximal_arm=crossing.proximal_arm,
        distal_arm=crossing.distal_arm,
        axial_offset=crossing.axial_offset,
        offset_angle=crossing.offset_angle,
        overbend=min(stops.upper, math.pi),
        fold_limit=min(-stops.lower, math.pi),
        inertia=crossing.inertia,
    )
    return hinge if folding_sense(stops) > 0 else _reversed(hinge)


def _reversed(hinge: TendonHinge) -> TendonHinge:
    """Return the hinge with the opposite sign of its angles."""
    return replace(
        hinge,
        offset_angle=0.0 - hinge.offset_angle,
        overbend=hinge.fold_limit,
        fold_limit=hinge.overbend,
        sense=-hinge.sense,
    )


def stacked_hinges(hinges: Sequence[Sequence[TendonHinge]]) -> TendonHinge:
    """Return hinges as one object whose length, energy, moment and stiffness take angles of all hinges, (row, hinge).

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
    """Return the angle beyond which the folding hinge is free, rad.

    It is None if there is no such angle up to the fold limit, or if the tendon is slack at every angle.
    """
    distance = hinge.slack_distance
    if not hinge.pulls or distance is None or distance > hinge.top_to_fold:
        return None
    return -distance - hinge.offset_angle


def released_energy(hinge: TendonHinge, start: float, further: ArrayLike) -> Array:
    """Compute the energy that the tendon releases as the hinge moves away from the top.

    The shortening is computed as a product, which keeps its digits for a small motion:
    L0^2 - L1^2 = 4 a b sin(further / 2) sin(start + further / 2).

    Args:
        hinge: the hinge.
        start: angle from the top, on either side, >= 0, rad.
        further: increase of that angle, at most 360 deg minus `start`, rad, any shape.

    Returns:
        Energy, J, in the shape of `further`.
    """
    half = np.asarray(further, dtype=np.float64) / 2
    longer, shorter = hinge.length_from_top(start), hinge.length_from_top(start + 2 * half)
    product = 4 * hinge.proximal_arm * hinge.distal_arm * np.sin(half) * np.sin(start + half)
    return hinge.law.released(longer, _divide(product, longer + shorter))


def _half_angle(angle: ArrayLike) -> tuple[Array, Array]:
    """Return sine and cosine of half an angle; the cosine is 0 at the float pi, which is slightly below 180 deg."""
    angle = np.asarray(angle, dtype=np.float64)
    half = angle / 2
    return np.sin(half), np.where(np.abs(angle) == math.pi, 0.0, np.cos(half))


def _divide(numerator: Array, denominator: Array) -> Array:
    """Return a quotient; 0 where the denominator is 0."""
    return np.asarray(np.divide(numerator, denominator, out=np.zeros(np.shape(denominator)), where=denominator > 0))
