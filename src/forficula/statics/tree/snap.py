"""Time and speed of the snap of one hinge, from conservation of its energy.

The distal bar turns about a fixed axis: inertia times angular acceleration equals the moment of the tendon. The damping
of tendon and joint is ignored, and so is the rest of the structure: its membrane, length limits, other hinges, and
torques. A structure is therefore slower, or does not snap, unless a torque drives it.
"""

from __future__ import annotations

import math
from itertools import pairwise

import scipy

from forficula.errors import InputError
from forficula.statics.tree.hinge import TendonHinge, released_energy

FOLD_START = math.radians(1)  # angle past the top at which the hinge is released
_ACCURACY = 1e-10  # relative accuracy of the quadrature


def time_scale(hinge: TendonHinge) -> float | None:
    """Compute the time scale t* = sqrt(I / (k a b)), s (docs/model/theory.md, section Snap of a hinge).

    k is the linear stiffness of the law; the arms a and b are perpendicular to the hinge axis. It is None if the law
    has no linear term.
    """
    stiffness = hinge.law.linear * hinge.proximal_arm * hinge.distal_arm
    return math.sqrt(hinge.inertia / stiffness) if stiffness else None


def fold_time(hinge: TendonHinge, start: float = FOLD_START) -> float | None:
    """Compute the time from rest past the top to the fold limit, s.

    It is the integral of d angle / sqrt(2 (released energy) / I) (conservation of energy). With an angle of
    start cosh(y) from the top, the integrand is finite at the start, where the speed is zero, and constant near the
    top. Once the tendon is slack, the speed is constant. For equal arms, no offset, no resting length, a linear law and
    a fold limit of 180 deg the time is t* K(m), where m = cos^2(start / 2) and K is the complete elliptic integral of
    the first kind (docs/model/theory.md, section Snap of a hinge).

    Args:
        hinge: the hinge.
        start: angle past the top at which the hinge is released, rad; the overbend stop if that is further.

    Returns:
        None if nothing folds the hinge from the start: the tendon is slack, or the fold limit is not beyond the start.

    Raises:
        InputError: the start is not > 0, because nothing moves from the top itself.
    """
    if final_speed(hinge, start) is None:
        return None
    start, end, slack = _release_angle(hinge, start), hinge.top_to_fold, hinge.slack_distance

    def slowness(y: float) -> float:
        turned = 2 * start * math.sinh(y / 2) ** 2
        return start * math.sinh(y) / math.sqrt(2 * float(released_energy(hinge, start, turned)) / hinge.inertia)

    # between these angles the tendon is slack, and the speed is constant
    kinks = [] if slack is None else [angle for angle in (slack, 2 * math.pi - slack) if angle < end]
    ends = [0.0, *(math.acosh(max(angle / start, 1.0)) for angle in (*kinks, end))]
    parts = (scipy.integrate.quad(slowness, *part, epsabs=0, epsrel=_ACCURACY, limit=200) for part in pairwise(ends))
    return float(sum(part[0] for part in parts))


def final_speed(hinge: TendonHinge, start: float = FOLD_START) -> float | None:
    """Compute the angular speed at the fold limit after a fold from rest past the top, rad/s.

    It is sqrt(2 (released energy) / I). Multiplied by t* it is 2 cos(start / 2) - rest length / a for equal arms a, no
    offset, a linear law and a fold limit at which the tendon is slack (docs/model/theory.md, section Snap of a hinge).

    Args:
        hinge: the hinge.
        start: angle past the top at which the hinge is released, rad; the overbend stop if that is further.

    Returns:
        None if nothing folds the hinge from the start.


    Raises:
        InputError: the start is not > 0.
    """
    if not start > 0:
        raise InputError(f"start: need > 0 deg, past straight, got {math.degrees(start):g} deg")
    start = _release_angle(hinge, start)
    if not start < hinge.top_to_fold or not hinge.law.force(hinge.length_from_top(start)) > 0:
        return None
    released = float(released_energy(hinge, start, hinge.top_to_fold - start))
    return math.sqrt(2 * released / hinge.inertia) if released > 0 else None


def _release_angle(hinge: TendonHinge, start: float) -> float:
    """Return the angle past the top at which the hinge is released, rad: no nearer than its overbend stop."""
    return max(start, -hinge.top_to_overbend)
