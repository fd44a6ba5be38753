"""The hinge of a crease, for sheets of plates and of nodes: its spring, stops and names."""

from __future__ import annotations

import math

from forficula.design import SheetDesign
from forficula.design.sheets.crease_sections import Crease
from forficula.design.sheets.crease_values import rest_angle, stops, yield_angle
from forficula.design.sheets.sheet_creases import crease_role, crease_sense
from forficula.material.law.crease_law import CreaseDamage
from forficula.material.law.maxwell_element import MaxwellElement
from forficula.pattern import CreasePattern
from forficula.structure.parts import Hinge


def sheet_hinge(
    design: SheetDesign, crease: Crease, pattern: CreasePattern, edge: int, *, length: float, folded: float
) -> Hinge:
    """Return the hinge of a crease without a body or flaps, which the caller adds.

    Args:
        design: design with all values settled.
        crease: values of this crease.
        pattern: crease pattern with the edge.
        edge: number of the edge.
        length: length over which the spring and the damper act, in the design's units.
        folded: angle as built in the crease's own sense, rad.
    """
    lower, upper = stops(design, edge, crease)
    lock = crease.lock_angle if crease.law == "locking" else math.inf
    return Hinge(
        name=f"crease{edge}",
        role=crease_role(pattern, edge),
        sense=crease_sense(pattern, edge),
        lower=lower,
        upper=upper,
        stiffness=(crease.stiffness or 0.0) * length,
        rest_angle=rest_angle(crease, folded),
        lock_below=-lock,
        lock_above=lock,
        stop_stiffness=None if crease.stop_stiffness is None else crease.stop_stiffness * length,
        yield_angle=yield_angle(crease),
        hardening=(crease.hardening or 0.0) * length,
        quadratic=(crease.quadratic_stiffness or 0.0) * length,
        cubic=(crease.cubic_stiffness or 0.0) * length,
        branches=tuple(
            MaxwellElement(stiffness=branch.stiffness * length, time=branch.time) for branch in crease.branches
        ),
        damage=None
        if crease.damage is None
        else CreaseDamage(loss=crease.damage.loss, turn=crease.damage.turn, by_set=crease.damage.of == "set"),
        damping=(crease.damping or 0.0) * length,
        friction=(crease.friction or 0.0) * length,
        start=folded,
        assignment=pattern.edges_assignment[edge],
        edge=edge,
        label=f"crease {edge}",
    )
