"""Couplings between joints: those of the veins of a fan, and what twists them."""

from __future__ import annotations

import itertools
import math
from collections.abc import Sequence

import numpy as np

from forficula.arrays import Array
from forficula.design import FanDesign
from forficula.structure.parts import Coupling, Hinge
from forficula.structure.structure import Structure


def vein_couplings(design: FanDesign, hinges: Sequence[Hinge]) -> tuple[Coupling, ...]:
    """Tie the turn of every vein to that of the next, each in its own sense: folding, all turn towards the fold."""
    if design.coupling is None:
        return ()
    stiffness = math.inf if design.coupling.stiffness == "rigid" else float(design.coupling.stiffness)
    turns = [number for number, hinge in enumerate(hinges) if hinge.role == "turn"]
    return tuple(
        Coupling(name=f"coupling{place}", hinges=pair, stiffness=stiffness)
        for place, pair in enumerate(itertools.pairwise(turns))
    )


def coupling_rows(structure: Structure) -> Array:
    """By what an angle of each hinge twists each coupling, in the hinges' own senses, (coupling, hinge)."""
    rows = np.zeros((len(structure.couplings), len(structure.hinges)))
    for row, coupling in zip(rows, structure.couplings, strict=True):
        first, second = coupling.hinges
        row[first] -= coupling.ratio
        row[second] += 1.0
    return rows
