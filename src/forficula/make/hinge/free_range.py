"""Where the stops of a joint are: the angles at which its two halves begin to overlap, measured on the solids."""

from __future__ import annotations

import math
from collections.abc import Callable

from manifold3d import Manifold, OpType

from forficula.make.hinge.joint import turned
from forficula.make.hinge.joint_layout import JointLayout
from forficula.make.part import PartSet
from forficula.make.solid.mesh import placed

# more than what rounding leaves where faces meet, mm^3; of a stop 5 mm high and 10 mm wide, 5e-5 deg
_TOUCHES = 1e-4
# from angle to angle where it is looked for, and how finely it is then found, rad
_STEP = math.radians(10.0)
_FINE = math.radians(1e-5)
# beyond what a joint turns through it is not looked for, rad
_BEYOND = math.radians(12.0)


def free_range(parts: PartSet, joint: JointLayout) -> tuple[float, float]:
    """The angles between which nothing of one half of a joint is in the other, rad, as `range_between` finds them.

    Pegs are part of the halves; straps and what bends are not.
    """
    return range_between(joint, *(half(parts, arm.body) for arm in (joint.proximal, joint.distal)))


def range_between(joint: JointLayout, proximal: Manifold, distal: Manifold) -> tuple[float, float]:
    """The angles between which two solids that a joint hinges do not overlap, rad: of the fold and of the overbend.

    From the middle of the designed range outwards, to 1e-5 deg; what touches and parts again within 10 deg may be
    missed.

    Args:
        joint: with the hinge.
        proximal: what does not turn, as built, mm.
        distal: what turns, as built, mm.

    Returns:
        In the hinge's own sense. -inf or inf where nothing stops it up to 12 deg beyond the designed stop; twice the
        middle of the designed range where the two overlap even there.
    """

    def overlaps(angle: float) -> bool:
        return float((proximal ^ placed(distal, *turned(joint, angle))).volume()) > _TOUCHES

    middle = (joint.lower + joint.upper) / 2
    if overlaps(middle):
        return middle, middle
    return (
        _first(overlaps, middle, joint.lower - _BEYOND),
        _first(overlaps, middle, joint.upper + _BEYOND),
    )


def _first(overlaps: Callable[[float], bool], free: float, end: float) -> float:
    """The first angle from a free one towards an end at which halves overlap, by steps and then by halves."""
    steps = math.ceil(abs(end - free) / _STEP)
    for step in range(1, steps + 1):
        angle = free + step * (end - free) / steps
        if overlaps(angle):
            last = free + (step - 1) * (end - free) / steps
            while abs(angle - last) > _FINE:
                between = (angle + last) / 2
                last, angle = (last, between) if overlaps(between) else (between, angle)
            return (angle + last) / 2
    return math.copysign(math.inf, end - free)


def half(parts: PartSet, body: int) -> Manifold:
    """All solids that move with a body as one, mm."""
    solid = Manifold.batch_boolean([part.shape for part in parts.of_body(body)], OpType.Add)
    # the kernel puts off what it is not asked for, and would do it again for everything that is made of it
    solid.num_tri()
    return solid
