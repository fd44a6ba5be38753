"""How a structure with tips resists a small load there: locked in the flat state, and unlocked."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.serial import Metres, Newtons, NewtonsPerMetre
from forficula.statics.tree.fold_path import rigid_fold
from forficula.statics.tree.pose import span
from forficula.statics.tree.potential import Ensemble, potential

DEFLECTION = 0.01  # of the length beyond the folds: what counts as small


@dataclass(frozen=True, kw_only=True)
class TipStiffness:
    """Force on every tip by its deflection, with all that does not fold held; square to the bars beyond the folds.

    Bars and stops are rigid. Against folding, the flat state rests on its overbend stops and does not give at all;
    along folding it does not give up to the holding force. So its stiffness along folding is the secant to a stated
    small deflection. Unlocked, with its hinges straight, there is no stop on either side.

    Attributes:
        deflection: of the secant, m.
        holding_force: on every tip along folding, up to which no hinge of the flat state gives, N.
        flat_along: stiffness of the flat state along folding, N/m.
        flat_against: of the flat state against folding: None, rigid; with no overbend, that of the unlocked one.
        unlocked_along: of the unlocked state along folding, N/m; negative where it runs on by itself.
        unlocked_against: against folding, N/m; the same, as the energy is smooth there.
    """

    deflection: Metres
    holding_force: Newtons
    flat_along: NewtonsPerMetre
    flat_against: NewtonsPerMetre | None
    unlocked_along: NewtonsPerMetre
    unlocked_against: NewtonsPerMetre


def tip_stiffness(structures: Ensemble, flat: Array) -> TipStiffness:
    """Load the tips of a structure, all alike, each in the direction in which its own hinge folds or the other.

    Args:
        structures: of which the first case is taken.
        flat: angles at rest without torques, rad, (1, hinge).

    Raises:
        InputError: it has no one way to fold, by which its tips are known.
    """
    built, one = structures.structure, structures.repeated(1)
    fold = rigid_fold(built)
    folds, count = span(fold.folds), len(fold.folds)
    axes = np.array([built.hinges[number].axis for number in fold.folds])
    levers = np.linalg.norm(np.cross(axes, np.array([built.points[number].place for number in fold.tips])), axis=1)
    deflection = DEFLECTION * fold.tip_length

    def loaded(angles: Array) -> tuple[float, float]:
        """Force on every tip towards folding that holds the structure there, N, and its slope by deflection, N/m."""
        _, slope, curvature = potential(one, angles)
        turned = 1 / levers  # of the hinges by deflection of the tips
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
