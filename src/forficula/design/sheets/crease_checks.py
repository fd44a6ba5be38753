"""Checks of the values of creases that are nonlinear or wear out, for facets of every kind."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

import numpy as np

from forficula.design.section import ANGLE, Section
from forficula.design.sheets.crease_values import crease_key, creases_by_edge, rest_angle
from forficula.design.sheets.sheet_creases import crease_sense
from forficula.design.sheets.sheet_sections import CREASE_MOMENT
from forficula.errors import InputError
from forficula.pattern import built_fold_angles
from forficula.quantities import show_quantity

if TYPE_CHECKING:
    from forficula.design.sheets.sheet import SheetDesign

# number of angles at which the moment of a nonlinear spring is checked
_TURNS = 181


def check_memory(design: SheetDesign) -> None:
    """Refuse creases whose spring pushes away from rest at some angle, and wear by permanent folds without a yield.

    Raises:
        InputError: the key, the rule and the value.
    """
    groups = design.crease.group
    bent = [
        *(design.crease.quadratic_stiffness, *(group.quadratic_stiffness for group in groups)),
        *(design.crease.cubic_stiffness, *(group.cubic_stiffness for group in groups)),
    ]
    worn = [design.crease.damage, *(group.damage for group in groups)]
    if all(value is None for value in (*bent, *worn)):
        return
    settled = design.settled()
    angles = built_fold_angles(settled.sheet)
    for edge, crease in creases_by_edge(settled).items():
        if crease.damage is not None and crease.damage.of == "set" and crease.yield_moment is None:
            raise InputError(
                f'{crease_key(design, edge, "damage")}.of: need "turns" for a crease that does not fold permanently,'
                f' because it has no {crease_key(design, edge, "yield_moment")}, got "set"'
            )
        linear, quadratic, cubic = (
            value or 0.0 for value in (crease.stiffness, crease.quadratic_stiffness, crease.cubic_stiffness)
        )
        if not quadratic and not cubic:
            continue
        rest = rest_angle(crease, crease_sense(settled.sheet, edge) * float(angles[edge]))
        turns = np.linspace(-math.pi, math.pi, _TURNS) - rest
        secant = linear + turns * (quadratic + turns * cubic)
        if not secant.min() > 0:
            key = "cubic_stiffness" if crease.quadratic_stiffness is None else "quadratic_stiffness"
            angle = float(rest + turns[secant.argmin()])
            raise InputError(
                f"{crease_key(design, edge, key)}: need a spring that turns crease {edge} to its rest angle from every"
                f" angle between -180 deg and 180 deg, got one that does not at {show_quantity(angle, ANGLE)}"
            )


def check_friction(design: SheetDesign) -> None:
    """Refuse dry friction of creases that wear out, unless they are hinges, whose friction does not wear.

    Raises:
        InputError: the key, the rule and the value.
    """
    values = [design.crease.friction, *(group.friction for group in design.crease.group)]
    if not any(values) or (design.facet.kind == "rigid" and not design.opens):
        return
    for edge, crease in creases_by_edge(design).items():
        if crease.friction and isinstance(crease.damage, Section):
            raise InputError(
                f"{crease_key(design, edge, 'friction')}: need 0 for a crease that wears out (damage), because the wear"
                f" of friction is not modelled, got {show_quantity(crease.friction, CREASE_MOMENT)}"
            )
