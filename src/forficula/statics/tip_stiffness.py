"""How a wing resists a small load at its tips: locked in the flat state, and unlocked."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from forficula.design import Design
from forficula.statics.potential import FOLD, potential, section
from forficula.statics.quasi_static import flat_state

Array = NDArray[np.float64]

DEFLECTION = 0.01  # of the distal length: what counts as small


@dataclass(frozen=True, kw_only=True)
class TipStiffness:
    """Force on every tip by its deflection, with the veins held at the base; square to the distal bars.

    Bars and stops are rigid. Against folding, the flat wing rests on its overbend stops and does not give at all; along
    folding it does not give up to the holding force. So its stiffness along folding is the secant to a stated small
    deflection. Unlocked, with its hinges straight, the wing has no stop on either side.

    Attributes:
        deflection: of the secant, m.
        holding_force: on every tip along folding, up to which no hinge of the flat wing gives, N.
        flat_along: stiffness of the flat wing along folding, N/m.
        flat_against: of the flat wing against folding: None, rigid; with no overbend, that of the unlocked wing.
        unlocked_along: of the unlocked wing along folding, N/m; negative where it runs on by itself.
        unlocked_against: against folding, N/m; the same, as the energy is smooth there.
    """

    deflection: float
    holding_force: float
    flat_along: float
    flat_against: float | None
    unlocked_along: float
    unlocked_against: float


def tip_stiffness(design: Design) -> TipStiffness:
    """Load the tips of a wing, all alike, each in the direction in which its own hinge folds or the other."""
    wings = section([design])
    wing = wings.sheet.wing
    tips = wing.points[wing.tips]
    levers = np.linalg.norm(np.cross(wing.joints[:, FOLD], tips), axis=1)
    deflection = DEFLECTION * design.pattern.distal_length
    flat = flat_state(wings)

    def loaded(angles: Array) -> tuple[float, float]:
        """Force on every tip towards folding that holds the wing there, N, and its slope by the deflection, N/m."""
        none = np.zeros(1)
        _, slope, curvature = potential(wings, angles, none, none)
        turned = 1 / levers  # of the hinges by deflection of the tips
        force = -float(slope[0, FOLD::4] @ turned) / wings.veins
        return force, float(turned @ curvature[0, FOLD::4, FOLD::4] @ turned) / wings.veins

    _, pressed, _ = potential(wings, flat, np.zeros(1), np.zeros(1))
    bent, straight = flat.copy(), flat.copy()
    bent[:, FOLD::4] -= deflection / levers
    straight[:, FOLD::4] = 0
    # the work of equal forces on all tips is their number times force times deflection
    unlocked = loaded(straight)[1]
    return TipStiffness(
        deflection=deflection,
        holding_force=max(0.0, float(np.min(-pressed[0, FOLD::4] / levers))),
        flat_along=loaded(bent)[0] / deflection,
        flat_against=None if design.hinge.overbend > 0 else unlocked,
        unlocked_along=unlocked,
        unlocked_against=unlocked,
    )
