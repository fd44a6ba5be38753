"""Couplings between the joints of a fan's veins, and their twists as functions of the hinge angles."""

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
    """Couple the turn of every vein to that of the next one, each in its own sense, so that all fold together."""
    if design.coupling is None:
        return ()
    stiffness = math.inf if design.coupling.stiffness == "rigid" else float(design.coupling.stiffness)
    turns = [number for number, hinge in enumerate(hinges) if hinge.role == "turn"]
    return tuple(
        Coupling(name=f"coupling{number}", hinges=pair, stiffness=stiffness)
        for number, pair in enumerate(itertools.pairwise(turns))
    )


def coupling_rows(structure: Structure) -> Array:
    """Compute the twist of each coupling per angle of each hinge, in the hinges' own senses, (coupling, hinge)."""
    rows = np.zeros((len(structure.couplings), len(structure.hinges)))
    for row, coupling in zip(rows, structure.couplings, strict=True):
        first, second = coupling.hinges
        row[first] -= coupling.ratio
        row[second] += 1.0
    return rows
