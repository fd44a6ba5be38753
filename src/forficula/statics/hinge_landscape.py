"""What a hinge is like: energy and moment over its angle, its stable states, and the numbers that describe them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from forficula.errors import InputError
from forficula.quantities import reading_unit
from forficula.statics.hinge import (
    PeakTorque,
    TendonHinge,
    holding_torque,
    peak_opening_torque,
    slack_angle,
    straight_barrier,
)
from forficula.statics.snap import FOLD_START, final_speed, fold_time, growth_rate, time_scale

Array = NDArray[np.float64]


@dataclass(frozen=True, kw_only=True)
class HingeState:
    """Where a hinge stays.

    Attributes:
        kind: "stop", pressed onto a stop; "minimum", at the least energy without a press; "neutral", a range over which
            the tendon is slack and nothing moves the hinge.
        angle: rad; of a neutral range the end nearer to straight, or the overbend stop where the tendon never pulls.
        far_angle: the other end of a neutral range, at a stop, rad; otherwise the angle.
        energy: J.
        holding_torque: that presses it onto its stop, N m; 0 unless the kind is "stop".
    """

    kind: Literal["stop", "minimum", "neutral"]
    angle: float
    far_angle: float
    energy: float
    holding_torque: float


@dataclass(frozen=True, kw_only=True)
class HingeLandscape:
    """A hinge over its whole range. What does not exist is None, and the remarks say why.

    Attributes:
        hinge: whose landscape it is.
        angle: falling from the overbend to the fold limit, rad, (angle,); holds both ends, straight, and where the
            tendon goes slack.
        energy: J, (angle,).
        moment: positive towards the overbend, N m, (angle,).
        barrier: from the overbend stop to straight, J.
        holding_torque: onto the overbend stop, N m.
        peak_opening: the largest moment against opening.
        slack_angle: beyond which the folding hinge is free, rad.
        states: the stable ones, from the overbend to the fold limit.
        time_scale: t*, s.
        growth_rate: at straight, 1/s.
        fold_start: from which the fold is let go, rad past straight.
        fold_time: from there to the fold limit, s.
        final_speed: at the fold limit, rad/s.
        remarks: sentences on what does not exist and what to know of the rest.
    """

    hinge: TendonHinge
    angle: Array
    energy: Array
    moment: Array
    barrier: float | None
    holding_torque: float | None
    peak_opening: PeakTorque | None
    slack_angle: float | None
    states: tuple[HingeState, ...]
    time_scale: float | None
    growth_rate: float | None
    fold_start: float
    fold_time: float | None
    final_speed: float | None
    remarks: tuple[str, ...]


def hinge_landscape(hinge: TendonHinge, points: int = 181, fold_start: float = FOLD_START) -> HingeLandscape:
    """Survey a hinge.

    Args:
        hinge: the hinge.
        points: how many angles to aim at; a few more come, as every part between two special angles is divided evenly.
        fold_start: how far past straight the fold of `fold_time` is let go, rad.

    Raises:
        InputError: fewer than 2 points, or a start that is not > 0.
    """
    if points < 2:
        raise InputError(f"points: need >= 2, got {points}")
    angle = _angles(hinge, points)
    return HingeLandscape(
        hinge=hinge,
        angle=angle,
        energy=hinge.energy(angle),
        moment=hinge.moment(angle),
        barrier=straight_barrier(hinge),
        holding_torque=holding_torque(hinge),
        peak_opening=peak_opening_torque(hinge),
        slack_angle=slack_angle(hinge),
        states=hinge_states(hinge),
        time_scale=time_scale(hinge),
        growth_rate=growth_rate(hinge),
        fold_start=fold_start,
        fold_time=fold_time(hinge, fold_start),
        final_speed=final_speed(hinge, fold_start),
        remarks=hinge_remarks(hinge, fold_start),
    )


def hinge_states(hinge: TendonHinge) -> tuple[HingeState, ...]:
    """Find where a hinge stays, from the overbend to the fold limit.

    The energy falls from straight to both sides (the law pulls, and the tendon is longest there), so a state is at a
    stop, or is the range up to it over which the tendon is slack. Straight is none, with or without an overbend.
    """
    if not hinge.pulls:
        return (_neutral(hinge.overbend, -hinge.fold_limit),)
    return tuple(_state(hinge, stop) for stop in (hinge.overbend, -hinge.fold_limit) if stop)


def _state(hinge: TendonHinge, stop: float) -> HingeState:
    slack = hinge.slack_distance
    if slack is not None and slack < abs(stop):
        return _neutral(math.copysign(slack, stop), stop)
    torque = abs(float(hinge.moment(stop)))
    return HingeState(
        kind="stop" if torque else "minimum",
        angle=stop,
        far_angle=stop,
        energy=float(hinge.energy(stop)),
        holding_torque=torque,
    )


def _neutral(angle: float, far_angle: float) -> HingeState:
    return HingeState(kind="neutral", angle=angle, far_angle=far_angle, energy=0.0, holding_torque=0.0)


def hinge_remarks(hinge: TendonHinge, fold_start: float = FOLD_START) -> tuple[str, ...]:
    """Say in a sentence each what a hinge lacks, and where its tendon is slack.

    Args:
        hinge: the hinge.
        fold_start: how far past straight the fold of `fold_time` is let go, rad.
    """
    if not hinge.pulls:
        return (_why_no_pull(hinge),)
    remarks = []
    slack, limit = hinge.slack_distance, hinge.fold_limit
    if hinge.overbend == 0:
        remarks.append(
            "the overbend is 0 deg: straight is no stable state, so there is no barrier and no holding torque;"
            " an overbend > 0 deg gives both"
        )
    elif slack is not None and slack < hinge.overbend:
        remarks.append(
            f"the tendon is slack beyond {_degrees(slack)} of overbend: nothing holds the hinge at its stop of"
            f" {_degrees(hinge.overbend)}; a shorter resting length or a smaller overbend does"
        )
    if slack is None or slack > limit:
        remarks.append(f"the tendon pulls up to the fold limit of {_degrees(limit)} and nowhere goes slack")
    elif slack < limit:
        remarks.append(
            f"the tendon is slack from {_degrees(-slack)} to {_degrees(-limit)}: nothing moves the folded hinge there"
        )
    if fold_start >= limit:
        remarks.append(
            f"the fold limit of {_degrees(limit)} is not beyond {_degrees(fold_start)} past straight,"
            " where the fold starts, so it has no time and no speed"
        )
    elif slack is not None and slack <= fold_start:
        remarks.append(
            f"the tendon is slack {_degrees(fold_start)} past straight, where the fold starts, so it has no time and no"
            " speed; a shorter resting length gives them"
        )
    if not hinge.law.linear:
        remarks.append("the law has no linear term, so there is no time scale")
    return tuple(remarks)


def _why_no_pull(hinge: TendonHinge) -> str:
    law, longest = hinge.law, float(hinge.length(0.0))
    free = "nothing moves the hinge, and there is no barrier"
    if law.rest_length < longest:
        return f"the tendon has no stiffness: {free}"
    unit, factor = reading_unit("m", law.rest_length)
    return (
        f"the tendon is slack at every angle: {free}; take a resting length below {factor * longest:.6g} {unit},"
        f" its length at straight, not {factor * law.rest_length:.6g} {unit}"
    )


def _degrees(angle: float) -> str:
    return f"{math.degrees(angle):.4g} deg"


def _angles(hinge: TendonHinge, points: int) -> Array:
    """Angles from the overbend to the fold limit, (angle,), with the special ones among them."""
    special = {hinge.overbend, 0.0, -hinge.fold_limit}
    slack = hinge.slack_distance
    if slack is not None:
        special |= {angle for angle in (slack, -slack) if -hinge.fold_limit < angle < hinge.overbend}
    ends = sorted(special, reverse=True)
    spacing = (ends[0] - ends[-1]) / (points - 1)
    parts = [np.linspace(high, low, math.ceil((high - low) / spacing), endpoint=False) for high, low in pairwise(ends)]
    return np.concatenate([*parts, [ends[-1]]])
