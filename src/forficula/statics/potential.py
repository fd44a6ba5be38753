"""The potential of a wing at rest: tendons, membrane, guards, and the torques that act, over all its joint angles."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from forficula.design import Design, key_value
from forficula.errors import InputError
from forficula.statics.equilibrium import Cases, Equilibria, descend
from forficula.statics.hinge import TendonHinge, stacked_hinges, wing_hinges
from forficula.statics.sheet import Expansion, Sheet, sheet_energy, wing_sheet
from forficula.statics.wing import FOLD, LIFT, SWEEP, TURN, flat_wing

Array = NDArray[np.float64]
Drive = Literal["fold", "unfold", "distal"]

# torque on every proximal turn axis and on every distal hinge, both towards folding, by unit of torque
DRIVES: dict[Drive, tuple[float, float]] = {"fold": (1.0, 0.0), "unfold": (-1.0, -1.0), "distal": (0.0, -1.0)}

# keys of a design that statics looks at beside the tendons
SHARED = (
    "pattern",
    "membrane",
    "hinge",
    "guard",
    "protocol.initial_overbend",
    "protocol.folded_angle",
    "protocol.opened_angle",
)

# Steps over which a wing is followed: shorter ones end in the same places.
_LONGEST_STEP = 0.1  # rad
_QUIET = 1e-6  # torque that counts as none, of what the stiffest tendon can exert


@dataclass(frozen=True, kw_only=True)
class Section:
    """Wings that differ in their tendons at most, side by side.

    Attributes:
        sheet: what joins the veins.
        hinges: of the veins, by case.
        lower: least joint angles, rad, (angle,); sweep, lift, turn and fold, vein by vein.
        upper: largest ones, (angle,).
    """

    sheet: Sheet
    hinges: tuple[tuple[TendonHinge, ...], ...]
    lower: Array
    upper: Array

    @property
    def veins(self) -> int:
        """How many veins."""
        return len(self.sheet.wing.hub)

    @cached_property
    def tendons(self) -> TendonHinge:
        """The hinges of all wings as one, whose functions take angles (case, vein)."""
        return stacked_hinges(self.hinges)

    def only(self, cases: NDArray[np.int64]) -> Section:
        """Some of the wings, by number, any of them once or more."""
        return replace(self, hinges=tuple(self.hinges[case] for case in cases.tolist()))


def section(designs: Sequence[Design]) -> Section:
    """Lay out wings that differ in their tendons at most.

    Raises:
        InputError: they differ in more.
    """
    first = designs[0]
    for design in designs[1:]:
        differs = [key for key in SHARED if key_value(design, key) != key_value(first, key)]
        if differs:
            raise InputError(f"{design.name}: need wings that differ in their tendons only, got another {differs[0]}")
    hinge = first.hinge
    veins = first.fan.vein_count
    return Section(
        sheet=wing_sheet(flat_wing(first)),
        hinges=tuple(wing_hinges(design) for design in designs),
        lower=np.tile([-np.inf, -np.inf, -hinge.turn_back, -hinge.fold_limit], veins),
        upper=np.tile([np.inf, np.inf, hinge.turn_limit, hinge.overbend], veins),
    )


def potential(wings: Section, angles: Array, proximal: Array, distal: Array) -> Expansion:
    """Energy stored, less the work of the torques.

    Args:
        wings: side by side.
        angles: rad, (case, angle).
        proximal: torque on every proximal turn axis towards folding, N m, (case,).
        distal: torque on every distal hinge towards folding, alike.

    Returns:
        J, (case,); its slope, N m, (case, angle); its curvature, N m/rad, (case, angle, angle).
    """
    by_vein = angles.reshape(len(angles), wings.veins, 4)
    energy, slope, curvature = sheet_energy(wings.sheet, by_vein)
    turn, fold, places = by_vein[:, :, TURN], by_vein[:, :, FOLD], np.arange(FOLD, angles.shape[1], 4)
    tendons = wings.tendons
    energy += tendons.energy(fold).sum(axis=1) - proximal * turn.sum(axis=1) + distal * fold.sum(axis=1)
    slope[:, TURN::4] -= proximal[:, None]
    slope[:, FOLD::4] += distal[:, None] - tendons.moment(fold)
    curvature[:, places, places] += tendons.stiffness(fold)
    return energy, slope, curvature


def rest(
    wings: Section,
    start: Array,
    proximal: ArrayLike = 0.0,
    distal: ArrayLike = 0.0,
    *,
    fixed: Sequence[int] = (),
    held: ArrayLike = False,
    within: float = np.inf,
) -> Equilibria:
    """Let wings go from where they are, slowly, to where they rest under torques.

    Args:
        wings: side by side.
        start: joint angles, rad, (case, angle).
        proximal: torque on every proximal turn axis towards folding, N m, one or by case.
        distal: torque on every distal hinge towards folding, alike.
        fixed: which of a vein's four joints are held where they start: SWEEP, LIFT, TURN, FOLD.
        held: which single joints are held where they start, (case, angle).
        within: how far each joint may turn, rad.
    """
    count = len(start)
    torques = np.stack([np.broadcast_to(torque, (count,)) for torque in (proximal, distal)])
    lower, upper = np.maximum(wings.lower, start - within), np.minimum(wings.upper, start + within)
    for joint in fixed:
        lower[:, joint::4] = upper[:, joint::4] = start[:, joint::4]
    lower, upper = np.where(held, start, lower), np.where(held, start, upper)
    law = wings.sheet.wing.design.membrane
    strongest = float(np.abs(wings.tendons.moment(np.full((count, wings.veins), -np.pi / 2))).max())
    scale = max(strongest, law.youngs_modulus * law.thickness * law.margin**2)
    some, which = wings, np.arange(count)

    def energy(angles: Array, cases: Cases) -> Expansion:
        nonlocal some, which
        if not np.array_equal(cases, which):
            some, which = wings.only(cases), cases
        return potential(some, angles, *torques[:, cases])

    return descend(energy, start, lower, upper, longest_step=_LONGEST_STEP, force=_QUIET * scale)


def straight_start(wings: Section) -> Array:
    """Joint angles of the flat wings with their hinges where the protocol starts them, rad, (case, angle)."""
    angles = np.zeros((len(wings.hinges), 4 * wings.veins))
    angles[:, FOLD::4] = wings.sheet.wing.design.protocol.initial_overbend
    return angles


__all__ = [
    "DRIVES",
    "FOLD",
    "LIFT",
    "SWEEP",
    "TURN",
    "Drive",
    "Section",
    "potential",
    "rest",
    "section",
    "straight_start",
]
