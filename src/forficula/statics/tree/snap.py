"""How fast one hinge snaps shut, from its energy alone.

The distal bar turns about a fixed axis, inertia times angular acceleration = moment of the tendon, and its energy is
conserved. The damping of the tendon and of the joint is not in it, nor is the rest of the structure: its membrane,
length limits and other hinges, or a torque. So a structure is slower than this, or does not get there, unless a torque
drives it.
"""

from __future__ import annotations

import math
from itertools import pairwise

import scipy

from forficula.errors import InputError
from forficula.statics.tree.hinge import TendonHinge, released_energy

FOLD_START = math.radians(1)  # past the top, where the hinge is let go
_ACCURACY = 1e-10  # of the quadrature, relative


def time_scale(hinge: TendonHinge) -> float | None:
    """Time scale t* = sqrt(I / (k a b)), s (theory.md, section 3).

    With the linear stiffness k of the law and arms a, b square to the hinge axis. None where the law has no linear
    term.
    """
    stiffness = hinge.law.linear * hinge.proximal_arm * hinge.distal_arm
    return math.sqrt(hinge.inertia / stiffness) if stiffness else None


def fold_time(hinge: TendonHinge, start: float = FOLD_START) -> float | None:
    """Time from rest past the top to the fold limit, s.

    The integral of d angle / sqrt(2 (released energy) / I) (conservation of energy). With an angle of start cosh(y)
    from the top the integrand is finite at the start, where the speed is zero, and near the top it is constant. Once
    the tendon is slack the hinge coasts. For equal arms, no offset, no resting length, a linear law and a fold limit of
    180 deg it is t* K(m), m = cos^2(start / 2), K the complete elliptic integral of the first kind (theory.md,
    section 3).

    Args:
        hinge: the hinge.
        start: how far past the top it is let go, rad; at the overbend stop where that is farther.

    Returns:
        None where nothing folds it from there: the tendon is slack, or the fold limit is not beyond the start.

    Raises:
        InputError: the start is not > 0; from the top itself nothing moves.
    """
    if final_speed(hinge, start) is None:
        return None
    start, end, slack = _let_go(hinge, start), hinge.top_to_fold, hinge.slack_distance

    def slowness(y: float) -> float:
        turned = 2 * start * math.sinh(y / 2) ** 2
        return start * math.sinh(y) / math.sqrt(2 * float(released_energy(hinge, start, turned)) / hinge.inertia)

    # between these the tendon is slack, and the hinge coasts
    kinks = [] if slack is None else [each for each in (slack, 2 * math.pi - slack) if each < end]
    ends = [0.0, *(math.acosh(max(each / start, 1.0)) for each in (*kinks, end))]
    parts = (scipy.integrate.quad(slowness, *part, epsabs=0, epsrel=_ACCURACY, limit=200) for part in pairwise(ends))
    return float(sum(part[0] for part in parts))


def final_speed(hinge: TendonHinge, start: float = FOLD_START) -> float | None:
    """Angular speed at the fold limit after a fold from rest past the top, rad/s.

    sqrt(2 (released energy) / I); times t* it is 2 cos(start / 2) - rest length / a for equal arms a, no offset, a
    linear law and a fold limit at which the tendon is slack (theory.md, section 3).

    Args:
        hinge: the hinge.
        start: how far past the top it is let go, rad; at the overbend stop where that is farther.

    Returns:
        None where nothing folds it from there.

    Raises:
        InputError: the start is not > 0.
    """
    if not start > 0:
        raise InputError(f"start: need > 0 deg, past straight, got {math.degrees(start):g} deg")
    start = _let_go(hinge, start)
    if not start < hinge.top_to_fold or not hinge.law.force(hinge.length_from_top(start)) > 0:
        return None
    released = float(released_energy(hinge, start, hinge.top_to_fold - start))
    return math.sqrt(2 * released / hinge.inertia) if released > 0 else None


def _let_go(hinge: TendonHinge, start: float) -> float:
    """How far past the top the hinge is let go, rad: no nearer than its overbend stop."""
    return max(start, -hinge.top_to_overbend)
