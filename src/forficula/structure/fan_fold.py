"""The one way in which a fan of rigid panels folds (theory.md, section 2, mode I), and what keeps it from that."""

from __future__ import annotations

import math

from forficula.design import FanDesign
from forficula.pattern import EarwigFan
from forficula.structure.course import RigidFold
from forficula.structure.structure import Structure


def fan_fold(design: FanDesign, structure: Structure) -> RigidFold:
    """How a fan folds along its pleats.

    The pleat angle is the fold angle of the veins; it is negative where the overbend bends them backwards. Veins turn
    by half of it and the distal hinges fold with the ring creases. Sweep and lift of the veins, which the panels' way
    leaves open because the hub points stay where they are, go to where the membrane is stretched least.
    """
    camber, ratio = camber_angle(design), ring_ratio(design.fan)
    roles = [hinge.role for hinge in structure.hinges]
    return RigidFold(
        turns=tuple(number for number, role in enumerate(roles) if role == "turn"),
        folds=tuple(number for number, role in enumerate(roles) if role == "ring"),
        ratio=ratio,
        first=camber,
        last=_last_pleat(design, ratio),
        base_length=design.pattern.proximal_length,
        tip_length=design.pattern.distal_length,
        tips=tuple(number for number, point in enumerate(structure.points) if point.role == "tip"),
        start="flat",
        end="folded",
        remarks=_remarks(design, camber),
    )


def ring_ratio(fan: EarwigFan) -> float:
    """Ratio m of the tangents of half the ring's and half the veins' fold angle (theory.md, section 2)."""
    return math.sin(fan.epsilon) / math.cos(fan.sector_angle / 2)


def camber_angle(design: FanDesign) -> float | None:
    """Pleat angle at which the ring creases reach the overbend, rad, negative; None where they never do."""
    ratio = ring_ratio(design.fan)
    return -2 * math.atan2(math.tan(design.hinge.overbend / 2), ratio) if ratio > 0 else None


def _last_pleat(design: FanDesign, ratio: float) -> float:
    """Pleat angle at which the ring creases reach the fold limit, or the veins theirs, rad."""
    limit = design.hinge.fold_limit
    closed = math.pi if ratio == 0 or limit == math.pi else 2 * math.atan2(math.tan(limit / 2), ratio)
    return min(closed, 2 * design.hinge.turn_limit)


def _remarks(design: FanDesign, camber: float | None) -> tuple[str, ...]:
    if camber is None:
        return (
            "pattern.hub_radius is 0, so the ring fold stays straight until the pleats are closed: rigid panels never"
            " reach the overbend, and their energy is the same all along; a hub radius > 0 couples the two",
        )
    remarks = []
    if 2 * design.hinge.turn_limit < math.pi:
        remarks.append(
            f"hinge.turn_limit stops the veins at {math.degrees(design.hinge.turn_limit):.4g} deg, so rigid panels"
            f" pleat to {math.degrees(2 * design.hinge.turn_limit):.4g} deg and no further"
        )
    back, stop = -camber / 2, design.hinge.turn_back
    if back > stop:
        remarks.append(
            f"rigid panels reach the overbend of {math.degrees(design.hinge.overbend):.4g} deg only with veins turned"
            f" back by {math.degrees(back):.4g} deg, and hinge.turn_back stops them at {math.degrees(stop):.4g} deg:"
            " in the compliant wing the membrane gives way instead"
        )
    return tuple(remarks)
