"""Stiffness of a structure against small loads on its tips: locked in the flat state, and unlocked."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.serial import Metres, Newtons, NewtonsPerMetre
from forficula.statics.tree.ensemble import Ensemble
from forficula.statics.tree.fold_path import rigid_fold
from forficula.statics.tree.pose import span
from forficula.statics.tree.potential import potential

DEFLECTION = 0.01  # small deflection, as a share of the length beyond the folds


@dataclass(frozen=True, kw_only=True)
class TipStiffness:
    """Force on every tip per deflection, perpendicular to the bars beyond the folds; only folding hinges move.

    Bars and stops are rigid. Against folding, the flat state rests on its overbend stops and does not move. Along
    folding, it does not move up to the holding force, so its stiffness is the secant to a given small deflection. The
    unlocked state has straight hinges and no stop on either side.

    Attributes:
        deflection: of the secant, m.
        holding_force: force on every tip along folding up to which no hinge of the flat state moves, N.
        flat_along: stiffness of the flat state along folding, N/m.
        flat_against: stiffness of the flat state against folding, N/m: None if it is rigid; without an overbend, that
            of the unlocked state.
        unlocked_along: stiffness of the unlocked state along folding, N/m; negative if the state is unstable.
        unlocked_against: stiffness against folding, N/m; the same, because the energy is smooth.
    """

    deflection: Metres
    holding_force: Newtons
    flat_along: NewtonsPerMetre
    flat_against: NewtonsPerMetre | None
    unlocked_along: NewtonsPerMetre
    unlocked_against: NewtonsPerMetre


def tip_stiffness(structures: Ensemble, flat: Array) -> TipStiffness:
    """Compute the stiffness under equal loads on all tips, along and against the folding of their hinges.

    Args:
        structures: only the first case is used.
        flat: angles at rest without torques, rad, (1, hinge).

    Raises:
        InputError: the structure has no single folding path, which defines its tips.
    """
    built, one = structures.structure, structures.repeated(1)
    fold = rigid_fold(built)
    folds, count = span(fold.folds), len(fold.folds)
    axes = np.array([built.hinges[number].axis for number in fold.folds])
    levers = np.linalg.norm(np.cross(axes, np.array([built.points[number].place for number in fold.tips])), axis=1)
    deflection = DEFLECTION * fold.tip_length

    def loaded(angles: Array) -> tuple[float, float]:
        """Return the folding force on every tip in equilibrium at these angles, N, and its slope by deflection, N/m."""
        _, slope, curvature = potential(one, angles)
        turned = 1 / levers  # turn of the hinges per deflection of the tips
        force = -float(slope[0, folds] @ turned) / count
        return force, float(turned @ curvature[0][folds][:, folds] @ turned) / count

    _, pressed, _ = potential(one, flat)
    bent, straight = flat.copy(), flat.copy()
    bent[:, folds] -= deflection / levers
    straight[:, folds] = 0
    # the work of equal forces on all tips is their number times force times deflection
    unlocked = loaded(straight)[1]
    overbends = [built.hinges[number].upper for number in fold.folds]
    return TipStiffness(
        deflection=deflection,
        holding_force=max(0.0, float(np.min(-pressed[0, folds] / levers))),
        flat_along=loaded(bent)[0] / deflection,
        flat_against=None if min(overbends) > 0 else unlocked,
        unlocked_along=unlocked,
        unlocked_against=unlocked,
    )
