"""What a hinge is like: energy and moment over its angle, its stable states, and the numbers that describe them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.quantities import reading_unit
from forficula.statics.hinge import (
    PeakTorque,
    TendonHinge,
    holding_torque,
    peak_opening_torque,
    slack_angle,
    top_barrier,
)
from forficula.statics.snap import FOLD_START, final_speed, fold_time, growth_rate, time_scale


@dataclass(frozen=True, kw_only=True)
class HingeState:
    """Where a hinge stays.

    Attributes:
        kind: "stop", pressed onto a stop; "minimum", at the least energy without a press; "neutral", a range over which
            the tendon is slack and nothing moves the hinge.
        angle: rad; of a neutral range the end nearer to the top, or the overbend stop where the tendon never pulls.
        far_angle: the other end of a neutral range, rad; otherwise the angle.
        energy: J.
        holding_torque: that presses it onto its stop, N m; 0 unless the kind is "stop".
    """

    kind: Literal["stop", "minimum", "neutral"]
    angle: float
    far_angle: float
    energy: float
    holding_torque: float


@dataclass(frozen=True, kw_only=True)
class HingeSpring:
    """The spring of a hinge itself.

    Attributes:
        stiffness: N m/rad.
        rest_angle: rad.
    """

    stiffness: float
    rest_angle: float


@dataclass(frozen=True, kw_only=True)
class HingeLandscape:
    """A hinge over its whole range. What does not exist is None, and the remarks say why.

    Folding is negative in all angles here; those that the structure has are these times `sense`. With a spring of the
    hinge, see `forficula.statics.sprung_hinge`, the energy and the moment are still those of the tendon, and everything
    else is of both.

    Attributes:
        hinge: whose landscape it is.
        angle: falling from the overbend to the fold limit, rad, (angle,); holds both ends, straight, the top, and where
            the tendon goes slack, or is shortest between the ends.
        energy: J, (angle,).
        moment: positive towards the overbend, N m, (angle,).
        barrier: from the overbend stop to the top, J.
        barrier_angle: where the top is, rad: at straight, but for offsets of the tendon's ends.
        holding_torque: onto the overbend stop, N m.
        peak_opening: the largest moment against opening.
        slack_angle: beyond which the folding hinge is free, rad.
        states: the stable ones, from the overbend to the fold limit.
        time_scale: t*, s.
        growth_rate: at the top, 1/s.
        fold_start: from which the fold is let go, rad past the top.
        final_speed: at the fold limit, rad/s.
        remarks: sentences on what does not exist and what to know of the rest.
        spring: of the hinge; None for none.
    """

    hinge: TendonHinge
    angle: Array
    energy: Array
    moment: Array
    barrier: float | None
    barrier_angle: float | None
    holding_torque: float | None
    peak_opening: PeakTorque | None
    slack_angle: float | None
    states: tuple[HingeState, ...]
    time_scale: float | None
    growth_rate: float | None
    fold_start: float
    final_speed: float | None
    remarks: tuple[str, ...]
    spring: HingeSpring | None = None

    @property
    def sense(self) -> int:
        """+1 or -1, by which angles here are multiplied to be those of the structure's hinge in its own sense."""
        return self.hinge.sense

    @cached_property
    def fold_time(self) -> float | None:
        """From where the fold is let go to the fold limit, s: an integral, for whoever asks. None with a spring."""
        return None if self.spring is not None else fold_time(self.hinge, self.fold_start)

    @property
    def spring_energy(self) -> Array:
        """Of the hinge's spring, J, (angle,)."""
        if self.spring is None:
            return np.zeros_like(self.angle)
        return np.asarray(self.spring.stiffness / 2 * (self.angle - self.spring.rest_angle) ** 2)

    def stored_energy(self, angle: ArrayLike) -> Array:
        """Of the tendon and the hinge's spring, J, in the shape of `angle` (rad, folding negative)."""
        energy = self.hinge.energy(angle)
        if self.spring is None:
            return energy
        turned = np.asarray(angle, dtype=np.float64) - self.spring.rest_angle
        return np.asarray(energy + self.spring.stiffness / 2 * turned**2)

    @property
    def spring_moment(self) -> Array:
        """Of the hinge's spring, positive towards the overbend, N m, (angle,)."""
        if self.spring is None:
            return np.zeros_like(self.angle)
        return np.asarray(self.spring.stiffness * (self.spring.rest_angle - self.angle))


def hinge_landscape(
    hinge: TendonHinge, points: int = 181, fold_start: float = FOLD_START, overbend: str = "overbend"
) -> HingeLandscape:
    """Survey a hinge.

    Args:
        hinge: the hinge.
        points: how many angles to aim at; a few more come, as every part between two special angles is divided evenly.
        fold_start: how far past the top the fold of `fold_time` is let go, rad.
        overbend: what sentences call the overbend.

    Raises:
        InputError: fewer than 2 points, or a start that is not > 0.
    """
    angle, barrier = special_angles(hinge, points), top_barrier(hinge)
    return HingeLandscape(
        hinge=hinge,
        angle=angle,
        energy=hinge.energy(angle),
        moment=hinge.moment(angle),
        barrier=barrier,
        barrier_angle=None if barrier is None else hinge.top,
        holding_torque=holding_torque(hinge),
        peak_opening=peak_opening_torque(hinge),
        slack_angle=slack_angle(hinge),
        states=hinge_states(hinge),
        time_scale=time_scale(hinge),
        growth_rate=growth_rate(hinge),
        fold_start=fold_start,
        final_speed=final_speed(hinge, fold_start),
        remarks=hinge_remarks(hinge, fold_start, overbend),
    )


def hinge_states(hinge: TendonHinge) -> tuple[HingeState, ...]:
    """Find where a hinge stays, from the overbend to the fold limit.

    The energy falls from the top to both sides for half a turn (the law pulls, and the tendon is longest there), so a
    state is at a stop, or is the range up to it over which the tendon is slack; or, where an offset lets the hinge go
    farther than that, half a turn from the top. The top is none, whether a stop is there or not.
    """
    if not hinge.pulls:
        return (_neutral(hinge.overbend, -hinge.fold_limit),)
    sides = ((hinge.top_to_overbend, hinge.overbend, 1), (hinge.top_to_fold, -hinge.fold_limit, -1))
    return tuple(_state(hinge, end, stop, side) for end, stop, side in sides if end > 0)


def _state(hinge: TendonHinge, end: float, stop: float, side: int) -> HingeState:
    """The state on one side of the top, whose stop is this far from there."""
    slack = hinge.slack_distance
    if slack is not None and slack < end:
        taut_again = 2 * math.pi - slack
        far = stop if end <= taut_again else side * taut_again - hinge.offset_angle
        return _neutral(side * slack - hinge.offset_angle, far)
    angle = stop if end <= math.pi else side * math.pi - hinge.offset_angle
    torque = abs(float(hinge.moment(angle))) if angle == stop else 0.0
    return HingeState(
        kind="stop" if torque else "minimum",
        angle=angle,
        far_angle=angle,
        energy=float(hinge.energy(angle)),
        holding_torque=torque,
    )


def _neutral(angle: float, far_angle: float) -> HingeState:
    return HingeState(kind="neutral", angle=angle, far_angle=far_angle, energy=0.0, holding_torque=0.0)


def hinge_remarks(hinge: TendonHinge, fold_start: float = FOLD_START, overbend: str = "overbend") -> tuple[str, ...]:
    """Say in a sentence each what a hinge lacks, and where its tendon is slack.

    Args:
        hinge: the hinge.
        fold_start: how far past the top the fold of `fold_time` is let go, rad.
        overbend: what they call the overbend.
    """
    if not hinge.pulls:
        return (why_no_pull(hinge, "nothing moves the hinge, and there is no barrier"),)
    remarks = []
    # sentences have angles in the hinge's own sense
    sense, offset, limit = hinge.sense, hinge.offset_angle, hinge.fold_limit
    slack, past = hinge.slack_distance, "straight"
    if offset:
        past = degrees(sense * hinge.top)
    if hinge.top_to_overbend <= 0:
        remarks.append(
            f"the ends of the tendon are offset: it is longest at {past}, and the {overbend} of"
            f" {degrees(hinge.overbend)} is not beyond it, so there is no barrier and no holding torque; a larger"
            f" {overbend} gives both"
            if offset
            else f"the {overbend} is 0 deg: straight is no stable state, so there is no barrier and no holding torque;"
            f" {'an' if overbend[0] in 'aeiou' else 'a'} {overbend} > 0 deg gives both"
        )
    elif offset:
        remarks.append(f"the ends of the tendon are offset: it is longest at {past}, not at straight")
    if hinge.top_to_overbend > 0 and slack is not None and slack < hinge.top_to_overbend:
        remarks.append(
            f"the tendon is slack beyond {degrees(slack - offset)} of {overbend}: nothing holds the hinge at its stop"
            f" of {degrees(hinge.overbend)}; a shorter resting length or a smaller {overbend} does"
        )
    if slack is None or slack > hinge.top_to_fold:
        remarks.append(f"the tendon pulls up to the fold limit of {degrees(limit)} and nowhere goes slack")
    elif slack < hinge.top_to_fold:
        far = max(-limit, slack - 2 * math.pi - offset)
        remarks.append(
            f"the tendon is slack from {degrees(sense * (-slack - offset))} to {degrees(sense * far)}: nothing moves"
            " the folded hinge there"
        )
    if fold_start >= hinge.top_to_fold:
        remarks.append(
            f"the fold limit of {degrees(limit)} is not beyond {degrees(fold_start)} past {past},"
            " where the fold starts, so it has no time and no speed"
        )
    elif slack is not None and slack <= fold_start:
        remarks.append(
            f"the tendon is slack {degrees(fold_start)} past {past}, where the fold starts, so it has no time and no"
            " speed; a shorter resting length gives them"
        )
    if not hinge.law.linear:
        remarks.append("the law has no linear term, so there is no time scale")
    return tuple(remarks)


def why_no_pull(hinge: TendonHinge, then: str) -> str:
    """Say why a tendon is slack at every angle, and what comes of that."""
    law, longest = hinge.law, float(hinge.length_from_top(hinge.nearest))
    if law.rest_length < longest:
        return f"the tendon has no stiffness: {then}"
    unit, factor = reading_unit("m", law.rest_length)
    return (
        f"the tendon is slack at every angle: {then}; take a resting length below {factor * longest:.6g} {unit},"
        f" its {'longest' if hinge.offset_angle else 'length at straight'}, not {factor * law.rest_length:.6g} {unit}"
    )


def degrees(angle: float) -> str:
    """An angle (rad) as sentences have it."""
    return f"{math.degrees(angle):.4g} deg"


def special_angles(hinge: TendonHinge, points: int) -> Array:
    """Angles from the overbend to the fold limit, (angle,), even between those that are special: see `HingeLandscape`.

    Raises:
        InputError: fewer than 2 points.
    """
    if points < 2:
        raise InputError(f"points: need >= 2, got {points}")
    special = {hinge.overbend, 0.0, -hinge.fold_limit}
    slack, turn = hinge.slack_distance, 2 * math.pi
    apart = {0.0, math.pi, -math.pi}
    if slack is not None:
        apart |= {slack, -slack, turn - slack, slack - turn}
    special |= {angle for each in apart if -hinge.fold_limit < (angle := each - hinge.offset_angle) < hinge.overbend}
    ends = sorted(special, reverse=True)
    spacing = (ends[0] - ends[-1]) / (points - 1)
    parts = [np.linspace(high, low, math.ceil((high - low) / spacing), endpoint=False) for high, low in pairwise(ends)]
    return np.concatenate([*parts, [ends[-1]]])
