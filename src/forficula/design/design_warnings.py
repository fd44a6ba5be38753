"""What a person should know of a design that is valid all the same."""

from __future__ import annotations

import numpy as np

from forficula.design.design import Design
from forficula.design.tendon import flat_strain, tendon_law
from forficula.pattern import vein_gaps
from forficula.quantities import reading_unit


def design_warnings(design: Design) -> list[str]:
    """What a person should know of a design that is valid all the same, one sentence each."""
    return [*_overlapping_veins(design), *_unmeasured_strain(design), *_pushing_branches(design)]


def _overlapping_veins(design: Design) -> list[str]:
    shares = np.linspace(0, 1, 1001)
    overlapping = shares[vein_gaps(design.fan, shares) < design.vein.diameter]
    if not len(overlapping):
        return []
    distance = float(overlapping[-1]) * design.pattern.proximal_length
    return [
        f"neighbouring veins of {_readable(design.vein.diameter)} overlap within {_readable(distance)} of the hub,"
        " which the simulation allows: a part to print needs thinner veins or a larger hub"
    ]


def _unmeasured_strain(design: Design) -> list[str]:
    law = design.tendon.law
    if law is None or law.largest_strain is None:
        return []
    strain = flat_strain(design)
    if strain <= law.largest_strain:
        return []
    return [
        f"the flat wing stretches its tendons by {100 * strain:.3g} %, beyond the {100 * law.largest_strain:.3g} % up"
        f" to which {law.name or 'their law'} was measured: a longer tendon.rest_length stays within it"
    ]


def _pushing_branches(design: Design) -> list[str]:
    law = tendon_law(design)
    if not law.branches or law.lets_go:
        return []
    total, linear = sum(branch.stiffness for branch in law.branches), law.stiffness[0]
    share = f", with moduli of {100 * total / linear:.3g} % of the linear modulus," if linear else ""
    return [
        f"Maxwell branches{share} act on slack tendons, too: after fast shortening they push, which a real tendon does"
        " not; only a law without cubic term, nonlinear viscosity or yield_strain lets go in the simulation"
    ]


def _readable(length: float) -> str:
    unit, factor = reading_unit("m", length)
    return f"{factor * length:.4g} {unit}"
