"""Sentences on missing values of a hinge under a tendon, and on the range in which the tendon is slack."""

from __future__ import annotations

import math

from forficula.quantities import reading_unit
from forficula.statics.tree.equilibrium import PathState
from forficula.statics.tree.hinge import TendonHinge
from forficula.statics.tree.snap import FOLD_START


def hinge_remarks(hinge: TendonHinge, fold_start: float = FOLD_START, overbend: str = "overbend") -> tuple[str, ...]:
    """Return sentences on missing values of a hinge, and on the range in which its tendon is slack.

    Args:
        hinge: the hinge.
        fold_start: angle past the top from which the fold of `fold_time` starts, rad.
        overbend: name of the overbend in sentences.
    """
    if not hinge.pulls:
        return (_slack_remark(hinge, "nothing moves the hinge, and there is no barrier"),)
    remarks = []
    # sentences show angles in the hinge's own sense
    sense, offset, limit = hinge.sense, hinge.offset_angle, hinge.fold_limit
    slack, past = hinge.slack_distance, "straight"
    if offset:
        past = _degrees(sense * hinge.top)
    if hinge.top_to_overbend <= 0:
        remarks.append(
            f"the ends of the tendon are offset: it is longest at {past}, and the {overbend} of"
            f" {_degrees(hinge.overbend)} is not beyond it, so there is no barrier and no holding torque; a larger"
            f" {overbend} gives both"
            if offset
            else f"the {overbend} is 0 deg: straight is no stable state, so there is no barrier and no holding torque;"
            f" {'an' if overbend[0] in 'aeiou' else 'a'} {overbend} > 0 deg gives both"
        )
    elif offset:
        remarks.append(f"the ends of the tendon are offset: it is longest at {past}, not at straight")
    if hinge.top_to_overbend > 0 and slack is not None and slack < hinge.top_to_overbend:
        remarks.append(
            f"the tendon is slack beyond {_degrees(slack - offset)} of {overbend}: nothing holds the hinge at its stop"
            f" of {_degrees(hinge.overbend)}; a shorter resting length or a smaller {overbend} does"
        )
    if slack is None or slack > hinge.top_to_fold:
        remarks.append(f"the tendon pulls up to the fold limit of {_degrees(limit)} and never goes slack")
    elif slack < hinge.top_to_fold:
        far = max(-limit, slack - 2 * math.pi - offset)
        remarks.append(
            f"the tendon is slack from {_degrees(sense * (-slack - offset))} to {_degrees(sense * far)}: nothing moves"
            " the folded hinge there"
        )
    if fold_start >= hinge.top_to_fold:
        remarks.append(
            f"the fold limit of {_degrees(limit)} is not beyond {_degrees(fold_start)} past {past},"
            " where the fold starts, so there is no fold time and no final speed"
        )
    elif slack is not None and slack <= fold_start:
        remarks.append(
            f"the tendon is slack {_degrees(fold_start)} past {past}, where the fold starts, so there is no fold time"
            " and no final speed; a shorter resting length gives both"
        )
    if not hinge.law.linear:
        remarks.append("the law has no linear term, so there is no time scale")
    return tuple(remarks)


def spring_remarks(hinge: TendonHinge, stable: list[PathState], slack: float | None) -> tuple[str, ...]:
    """Return sentences on missing values of a hinge with a spring, and on the range in which its tendon is slack.

    Args:
        hinge: the hinge.
        stable: its stable states.
        slack: angle beyond which the tendon is slack, rad; None if it is never slack.
    """
    if not hinge.pulls:
        return (_slack_remark(hinge, "only the spring of the hinge moves it, and there is no barrier"),)
    remarks = []
    if len(stable) == 1:
        remarks.append(
            "with the tendon and its own spring the hinge rests only at"
            f" {_degrees(-hinge.sense * stable[0].coordinate)}, so there is no barrier; a stiffer or shorter tendon, or"
            " a softer spring, gives one"
        )
    if slack is not None:
        remarks.append(
            f"the tendon is slack beyond {_degrees(hinge.sense * slack)} of the fold: only the spring of the hinge"
            " moves it there"
        )
    return tuple(remarks)


def _slack_remark(hinge: TendonHinge, then: str) -> str:
    """Return a sentence on why a tendon is slack at every angle, and its consequence."""
    law, longest = hinge.law, float(hinge.length_from_top(hinge.nearest))
    if law.rest_length < longest:
        return f"the tendon has no stiffness: {then}"
    unit, factor = reading_unit("m", law.rest_length)
    return (
        f"the tendon is slack at every angle: {then}; take a resting length below {factor * longest:.6g} {unit},"
        f" its {'longest' if hinge.offset_angle else 'length at straight'}, not {factor * law.rest_length:.6g} {unit}"
    )


def _degrees(angle: float) -> str:
    """Return an angle (rad) in degrees for sentences."""
    return f"{math.degrees(angle):.4g} deg"
