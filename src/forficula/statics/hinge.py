"""One tendon across one hinge: its energy and its moment at every angle, in closed form.

Angles are those of a distal hinge: 0 where the bars are straight (the flat wing), positive in the overbend, negative
while folding.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.optimize import brentq

from forficula.design import Design, tendon_law
from forficula.errors import InputError
from forficula.material import ElasticLaw
from forficula.pattern import hub_points, ring_vertices, tips

Array = NDArray[np.float64]

_SCAN = 361  # angles among which the largest torque is looked for before it is refined


@dataclass(frozen=True, kw_only=True)
class TendonHinge:
    """A tendon across a hinge between two bars.

    Its ends turn about the hinge axis on two circles, `axial_offset` apart. With arms a and b and the offset c,
    length^2 = a^2 + b^2 + c^2 + 2 a b cos(angle) (law of cosines; with c = 0 theory.md, section 3). Bars that meet the
    axis at angles alpha and beta in the flat sheet, with the ends at distances p and d along them, have a = p sin
    alpha, b = d sin beta and c = p cos alpha + d cos beta.

    The numbers may be arrays, for many hinges at once; see `stacked_hinges`.

    Attributes:
        law: of the tendon.
        proximal_arm: distance of the tendon's end on the proximal bar from the hinge axis, m.
        distal_arm: the same on the distal bar, m.
        axial_offset: distance between the ends along the hinge axis, m; 0 where both bars are square to it.
        overbend: how far the hinge bends past straight, rad.
        fold_limit: how far it folds, rad.
        inertia: of what turns about the hinge axis, kg m^2.

    Raises:
        InputError: a number out of its bounds or not finite.
    """

    law: ElasticLaw
    proximal_arm: float
    distal_arm: float
    axial_offset: float = 0.0
    overbend: float
    fold_limit: float
    inertia: float

    def __post_init__(self) -> None:
        for name, unit in (("proximal_arm", "m"), ("distal_arm", "m"), ("inertia", "kg m^2")):
            value = getattr(self, name)
            if not np.all(np.isfinite(value) & (np.asarray(value) > 0)):
                raise InputError(f"{name}: need > 0, got {np.min(value):g} {unit}")
        if not np.all(np.isfinite(self.axial_offset)):
            raise InputError(f"axial_offset: need a finite number, got {np.min(self.axial_offset):g} m")
        if not 0 <= self.overbend < math.pi / 2:
            raise InputError(f"overbend: need >= 0 deg and < 90 deg, got {math.degrees(self.overbend):g} deg")
        if not 0 < self.fold_limit <= math.pi:
            raise InputError(f"fold_limit: need > 0 deg and <= 180 deg, got {math.degrees(self.fold_limit):g} deg")

    @property
    def pulls(self) -> bool:
        """Whether the tendon pulls at straight, where it is longest; if not, it is slack at every angle."""
        return bool(self.law.force(self.length(0.0)) > 0)

    @property
    def slack_distance(self) -> float | None:
        """How far from straight, either way, the tendon has its resting length, rad; None where it has it nowhere.

        With equal arms and no offset 2 acos(rest length / length at straight) (theory.md, section 3), here through
        half angles, which keep all digits at 0 and at 180 deg.
        """
        offset, longest, rest = float(self.length(math.pi)), float(self.length(0.0)), self.law.rest_length
        if not offset <= rest <= longest:
            return None
        return 2 * math.atan2(math.sqrt(longest - rest) * math.sqrt(longest + rest), math.sqrt(rest**2 - offset**2))

    def length(self, angle: ArrayLike) -> Array:
        """Length of the tendon, m, in the shape of `angle` (rad); law of cosines."""
        _, half_cosine = _half_angle(angle)
        # a sum of squares keeps its digits where the ends meet
        shortest = np.hypot(self.axial_offset, self.proximal_arm - self.distal_arm)  # at 180 deg
        return np.asarray(np.hypot(shortest, 2 * np.sqrt(self.proximal_arm * self.distal_arm) * half_cosine))

    def lever(self, angle: ArrayLike) -> Array:
        """Lever of the tendon about the hinge axis, -d length / d angle, m, in the shape of `angle` (rad).

        a b sin(angle) / length (theory.md, section 3); 0 where the tendon's ends meet.
        """
        half_sine, half_cosine = _half_angle(angle)
        product = 2 * self.proximal_arm * self.distal_arm * half_sine * half_cosine
        return _divide(product, self.length(angle))

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

        With force F, length L and lever q: (F' - F/L) q^2 - (F/L) a b cos(angle), the derivative of the moment above.
        """
        half_sine, half_cosine = _half_angle(angle)
        length = self.length(angle)
        slope = self.law.stiffness(length)
        # where the ends meet, force by length tends to the slope
        by_length = np.where(length > 0, _divide(self.law.force(length), length), slope)
        cosine = half_cosine**2 - half_sine**2
        turned = by_length * self.proximal_arm * self.distal_arm * cosine
        return np.asarray((slope - by_length) * self.lever(angle) ** 2 - turned)


@dataclass(frozen=True, kw_only=True)
class PeakTorque:
    """The largest moment that keeps a hinge from opening.

    Attributes:
        torque: N m, positive.
        angle: where, rad, negative.
    """

    torque: float
    angle: float


def ideal_hinge(design: Design) -> TendonHinge:
    """The hinge of a design with both bars square to its axis (theory.md, section 3).

    Of the tendon's law it takes the spring, as slow motions do: Maxwell branches are relaxed, and nothing yields.

    The distal bar, a solid cylinder, turns about a diameter of its end: m (r^2 / 4 + l^2 / 3), and the armature.
    """
    along, across = np.array([1.0, 0.0, 0.0]), np.array([0.0, 1.0, 0.0])
    return _hinge(design, across, along, along)


def wing_hinges(design: Design) -> tuple[TendonHinge, ...]:
    """The distal hinges of a wing, each about its ring crease, with the proximal bar held still.

    Of the tendons' law they take the spring, as slow motions do: Maxwell branches are relaxed, and nothing yields.

    The distal bar meets the crease at the angle beta: its inertia is m r^2 / 2 cos^2(beta) + m (r^2 / 4 + l^2 / 3)
    sin^2(beta) (a solid cylinder's tensor at its end), and the armature.

    Returns:
        One for each vein, counterclockwise; the last vein turns about the next crease of the pattern continued.
    """
    fan = design.fan
    ring = ring_vertices(fan, continued=True)
    places = zip(hub_points(fan), ring[:-1], tips(fan), np.diff(ring, axis=0), strict=True)
    return tuple(
        _hinge(design, _unit(crease), _unit(vertex - hub), _unit(tip - vertex)) for hub, vertex, tip, crease in places
    )


def stacked_hinges(hinges: Sequence[Sequence[TendonHinge]]) -> TendonHinge:
    """Hinges with the same stops as one, whose length, energy, moment and stiffness take angles of all, (row, hinge).

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
        overbend=hinges[0][0].overbend,
        fold_limit=hinges[0][0].fold_limit,
        inertia=stacked(lambda hinge: hinge.inertia),
    )


def straight_barrier(hinge: TendonHinge) -> float | None:
    """Energy to climb from the overbend stop to straight, J; None where there is no overbend or no pull.

    With equal arms, no offset and no resting length it is energy(0) sin^2(overbend / 2) (theory.md, section 3).
    """
    if not hinge.pulls or hinge.overbend == 0:
        return None
    return float(released_energy(hinge, 0.0, hinge.overbend))


def holding_torque(hinge: TendonHinge) -> float | None:
    """Torque that presses the hinge onto its overbend stop, N m; None where there is no overbend or no pull.

    0 where the tendon is slack at the stop.
    """
    if not hinge.pulls or hinge.overbend == 0:
        return None
    return float(hinge.moment(hinge.overbend))


def slack_angle(hinge: TendonHinge) -> float | None:
    """Angle beyond which the folding hinge is free, rad, negative; None where it has none up to the fold limit.

    Where the tendon is slack at every angle there is none either.
    """
    distance = hinge.slack_distance
    return -distance if hinge.pulls and distance is not None and distance <= hinge.fold_limit else None


def peak_opening_torque(hinge: TendonHinge) -> PeakTorque | None:
    """The largest moment towards folding between straight and the fold limit; None where there is no pull.

    At the zero of the energy's second derivative (Brent 1973), or at the fold limit where the moment still grows
    there. With equal arms, no offset and a linear law that is cos(angle / 2) = (lambda + sqrt(lambda^2 + 8)) / 4,
    lambda being the resting length by the length at straight (set the derivative of theory.md's moment to 0).
    """
    if not hinge.pulls:
        return None
    last = slack_angle(hinge)
    folds = np.linspace(0, hinge.fold_limit if last is None else -last, _SCAN)
    largest = int(np.argmax(-hinge.moment(-folds)))
    before, after = folds[max(largest - 1, 0)], folds[min(largest + 1, _SCAN - 1)]
    fold = float(folds[largest])
    if hinge.stiffness(-before) < 0 < hinge.stiffness(-after):
        fold = float(brentq(lambda x: float(hinge.stiffness(-x)), before, after, xtol=1e-15))
    return PeakTorque(torque=float(-hinge.moment(-fold)), angle=-fold)


def released_energy(hinge: TendonHinge, start: float, further: ArrayLike) -> Array:
    """Energy that the tendon gives back as the hinge moves away from straight.

    The shortening as a product, which keeps its digits where the way is short:
    L0^2 - L1^2 = 4 a b sin(further / 2) sin(start + further / 2).

    Args:
        hinge: the hinge.
        start: distance from straight, either way, >= 0, rad.
        further: by how much the distance grows, up to 180 deg in all, rad, any shape.

    Returns:
        J, in the shape of `further`.
    """
    half = np.asarray(further, dtype=np.float64) / 2
    longer, shorter = hinge.length(start), hinge.length(start + 2 * half)
    product = 4 * hinge.proximal_arm * hinge.distal_arm * np.sin(half) * np.sin(start + half)
    return hinge.law.released(longer, _divide(product, longer + shorter))


def _half_angle(angle: ArrayLike) -> tuple[Array, Array]:
    """Sine and cosine of half an angle; the float pi is short of 180 deg, where the cosine is 0."""
    angle = np.asarray(angle, dtype=np.float64)
    return np.sin(angle / 2), np.where(np.abs(angle) == math.pi, 0.0, np.cos(angle / 2))


def _divide(numerator: Array, denominator: Array) -> Array:
    """Divide; 0 where the denominator is 0."""
    return np.asarray(np.divide(numerator, denominator, out=np.zeros_like(denominator), where=denominator > 0))


def _unit(vector: Array) -> Array:
    return np.asarray(vector / np.linalg.norm(vector))


def _hinge(design: Design, axis: Array, proximal: Array, distal: Array) -> TendonHinge:
    """A hinge about an axis, between bars that point outwards: unit vectors in the flat sheet."""
    tendon, vein, length = design.tendon, design.vein, design.pattern.distal_length
    along = float(distal @ axis)
    across = float(np.linalg.norm(np.cross(distal, axis)))
    radius = vein.diameter / 2
    mass = vein.density * math.pi * radius**2 * length
    bar = mass * (radius**2 / 2 * along**2 + (radius**2 / 4 + length**2 / 3) * across**2)
    return TendonHinge(
        law=tendon_law(design).elastic,
        proximal_arm=tendon.proximal_attachment * float(np.linalg.norm(np.cross(proximal, axis))),
        distal_arm=tendon.distal_attachment * across,
        axial_offset=tendon.proximal_attachment * float(proximal @ axis) + tendon.distal_attachment * along,
        overbend=design.hinge.overbend,
        fold_limit=design.hinge.fold_limit,
        inertia=bar + design.hinge.armature,
    )
