"""Which vein stands for all where only one is shown: that of the paper which a design reproduces, if it names one."""

from __future__ import annotations

from forficula.analysis.simulated_snap import INNER_VEIN
from forficula.design import Design
from forficula.reproduction.named_reproduction import named_reproduction


def shown_tendon(design: Design) -> int:
    """Number of the vein, from 0, whose tendon a landscape shows.

    Raises:
        InputError: the design names a paper that there is not.
    """
    paper = named_reproduction(design.reproduces)
    return INNER_VEIN if paper is None else paper.tendon


def shown_hinge(design: Design) -> int | None:
    """Number of the vein, from 0, whose distal hinge a convergence study shows; None where the design leaves it open.

    Raises:
        InputError: the design names a paper that there is not.
    """
    paper = named_reproduction(design.reproduces)
    return None if paper is None else paper.hinge
