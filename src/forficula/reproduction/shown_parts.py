"""Choice of the tendon and the hinge that figures show as an example: those of the reproduced paper, if any."""

from __future__ import annotations

from forficula.analysis.simulated_snap import inner_tendon
from forficula.design import Design
from forficula.reproduction.comparison import named_reproduction
from forficula.statics import folding_hinges
from forficula.structure import crossing_tendons, structure_of


def shown_tendon(design: Design) -> int | None:
    """Return the number of the tendon that a landscape shows, from 0: the paper's, or an inner one.

    Returns:
        None if no tendon lies across one hinge.

    Raises:
        InputError: the design names an unknown paper, or it cannot be built.
    """
    paper, structure = named_reproduction(design.reproduces), structure_of(design)
    tendons = {
        crossing.hinge: number
        for number in crossing_tendons(structure)
        if (crossing := structure.tendons[number].crossing) is not None
    }
    hinges = folding_hinges(structure)
    wanted = None if paper is None or paper.tendon >= len(hinges) else hinges[paper.tendon]
    return inner_tendon(structure) if wanted not in tendons else tendons[wanted]


def shown_hinge(design: Design) -> int | None:
    """Return the number of the hinge that a convergence study shows, from 0, among those of the first folding measure.

    Returns:
        None if the design names no paper.

    Raises:
        InputError: the design names an unknown paper.
    """
    paper = named_reproduction(design.reproduces)
    return None if paper is None else paper.hinge
