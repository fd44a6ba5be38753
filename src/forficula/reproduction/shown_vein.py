"""Which part stands for all where only one is shown: that of the paper which a design reproduces, if it names one."""

from __future__ import annotations

from forficula.analysis.simulated_snap import inner_tendon
from forficula.design import Design
from forficula.reproduction.comparison import named_reproduction
from forficula.statics import folding_hinges
from forficula.structure import crossing_tendons, structure_of


def shown_tendon(design: Design) -> int | None:
    """Number of the tendon that a landscape shows, from 0: an inner one where no paper names a hinge that one crosses.

    Returns:
        None where no tendon lies across one hinge.

    Raises:
        InputError: the design names a paper that there is not, or cannot be built.
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
    """Number of the hinge that a convergence study shows, from 0, among those of the first measure that folds.

    Returns:
        None where the design leaves it open.

    Raises:
        InputError: the design names a paper that there is not.
    """
    paper = named_reproduction(design.reproduces)
    return None if paper is None else paper.hinge
