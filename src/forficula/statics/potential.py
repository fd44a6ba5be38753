"""The potential of a wing at rest: tendons, membrane, guards, and the torques that act, over all its joint angles."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from forficula.design import Design
from forficula.errors import InputError
from forficula.statics.equilibrium import Equilibria, descend
from forficula.statics.hinge import TendonHinge, stacked_hinges, wing_hinges
from forficula.statics.sheet import Expansion, Sheet, sheet_energy, wing_sheet
from forficula.statics.wing import FOLD, LIFT, SWEEP, TURN, flat_wing

Array = NDArray[np.float64]
Drive = Literal["fold", "unfold", "distal"]

# torque on every proximal turn axis and on every distal hinge, both towards folding, by unit of torque
DRIVES: dict[Drive, tuple[float, float]] = {"fold": (1.0, 0.0), "unfold": (-1.0, -1.0), "distal": (0.0, -1.0)}

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

    def only(self, cases: NDArray[np.int64]) -> Section:
        """Some of the wings, by number."""
        return replace(self, hinges=tuple(self.hinges[case] for case in cases.tolist()))


def section(designs: Sequence[Design]) -> Section:
    """Lay out wings that differ in their tendons at most.

    Raises:
        InputError: they differ in more.
    """
    first = designs[0]
    for design in designs[1:]:
        parts = ("pattern", "membrane", "hinge", "guard")
        differs = [part for part in parts if getattr(design, part) != getattr(first, part)]
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


def potential(wings: Section, angles: Array, cases: NDArray[np.int64], proximal: Array, distal: Array) -> Expansion:
    """Energy stored, less the work of the torques.

    Args:
        wings: side by side.
        angles: rad, (row, angle).
        cases: which wing each row is, (row,).
        proximal: torque on every proximal turn axis towards folding, N m, by wing, (case,).
        distal: torque on every distal hinge towards folding, alike.

    Returns:
        J, (row,); its slope, N m, (row, angle); its curvature, N m/rad, (row, angle, angle).
    """
    by_vein = angles.reshape(len(angles), wings.veins, 4)
    energy, slope, curvature = sheet_energy(wings.sheet, by_vein)
    fold, places = by_vein[:, :, FOLD], np.arange(FOLD, angles.shape[1], 4)
    hinges = stacked_hinges([wings.hinges[case] for case in cases.tolist()])
    energy += hinges.energy(fold).sum(axis=1)
    slope[:, places] -= hinges.moment(fold)
    curvature[:, places, places] += hinges.stiffness(fold)
    energy -= proximal[cases] * by_vein[:, :, TURN].sum(axis=1) - distal[cases] * by_vein[:, :, FOLD].sum(axis=1)
    slope[:, TURN::4] -= proximal[cases, None]
    slope[:, FOLD::4] += distal[cases, None]
    return energy, slope, curvature


def rest(
    wings: Section,
    start: Array,
    proximal: ArrayLike = 0.0,
    distal: ArrayLike = 0.0,
    *,
    fixed: Sequence[int] = (),
) -> Equilibria:
    """Let wings go from where they are, slowly, to where they rest under torques.

    Args:
        wings: side by side.
        start: joint angles, rad, (case, angle).
        proximal: torque on every proximal turn axis towards folding, N m, one or by case.
        distal: torque on every distal hinge towards folding, alike.
        fixed: which of a vein's four joints are held where they start: SWEEP, LIFT, TURN, FOLD.
    """
    count = len(start)
    torques = [np.broadcast_to(np.asarray(torque, dtype=np.float64), (count,)) for torque in (proximal, distal)]
    lower, upper = np.tile(wings.lower, (count, 1)), np.tile(wings.upper, (count, 1))
    for joint in fixed:
        lower[:, joint::4] = upper[:, joint::4] = start[:, joint::4]
    scale = max(float(np.abs(hinge.moment(-np.pi / 2))) for case in wings.hinges for hinge in case)
    law = wings.sheet.wing.design.membrane
    scale = max(scale, law.youngs_modulus * law.thickness * law.margin**2)
    return descend(
        lambda angles, cases: potential(wings, angles, cases, *torques),
        start,
        lower,
        upper,
        longest_step=_LONGEST_STEP,
        force=_QUIET * scale,
    )


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
