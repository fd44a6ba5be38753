"""Stops of a joint: the angles at which its two halves begin to overlap, measured on the solids."""

from __future__ import annotations

import math
from collections.abc import Callable

from manifold3d import Manifold, OpType

from forficula.make.hinge.joint import turned
from forficula.make.hinge.joint_layout import JointLayout
from forficula.make.part import PartSet
from forficula.make.solid.mesh import placed

# mm^3, above the rounding error where faces meet; for a stop 5 mm high and 10 mm wide this is 5e-5 deg
_TOUCHES = 1e-4
# step of the search and accuracy of the result, rad
_STEP = math.radians(10.0)
_FINE = math.radians(1e-5)
# the search ends at this angle beyond the designed range, rad
_BEYOND = math.radians(12.0)


def free_range(parts: PartSet, joint: JointLayout) -> tuple[float, float]:
    """Return the angles between which the halves of a joint do not overlap, rad; see `range_between`.

    Pegs are part of the halves; straps and other parts that bend are not.
    """
    return range_between(joint, *(half(parts, arm.body) for arm in (joint.proximal, joint.distal)))


def range_between(joint: JointLayout, proximal: Manifold, distal: Manifold) -> tuple[float, float]:
    """Return the angles between which two solids on a hinge do not overlap, rad: of the fold and of the overbend.

    The search goes from the middle of the designed range outwards, to 1e-5 deg. An overlap that ends again within 10
    deg may be missed.

    Args:
        joint: joint with the hinge.
        proximal: fixed solid, as built, mm.
        distal: turning solid, as built, mm.

    Returns:
        In the hinge's own sense. -inf or inf if nothing stops it up to 12 deg beyond the designed stop; twice the
        middle of the designed range if the two overlap even there.
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
    """Return the first angle at which halves overlap, from a free one towards an end, by steps and then bisection."""
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
    """Return the union of all solids that move with a body, mm."""
    solid = Manifold.batch_boolean([part.shape for part in parts.of_body(body)], OpType.Add)
    # the kernel evaluates lazily, and would repeat the evaluation for every solid that is derived from this one
    solid.num_tri()
    return solid
