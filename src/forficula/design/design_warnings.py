"""What a person should know of a design that is valid all the same."""

from __future__ import annotations

import numpy as np

from forficula.design.design import Design
from forficula.design.places import tendon_ends
from forficula.pattern import hub_points, ring_vertices, tips, vein_gaps
from forficula.quantities import reading_unit


def design_warnings(design: Design) -> list[str]:
    """What a person should know of a design that is valid all the same, one sentence each."""
    return [*_overlapping_veins(design), *_unmeasured_strain(design)]


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
    before, beyond = tendon_ends(hub_points(design.fan), ring_vertices(design.fan), tips(design.fan), design)
    flat_length = float(np.linalg.norm(beyond - before, axis=-1).max())
    strain = flat_length / design.tendon.rest_length - 1
    if strain <= law.largest_strain:
        return []
    return [
        f"the flat wing stretches its tendons by {100 * strain:.3g} %, beyond the {100 * law.largest_strain:.3g} % up"
        f" to which {law.name or 'their law'} was measured: a longer tendon.rest_length stays within it"
    ]


def _readable(length: float) -> str:
    unit, factor = reading_unit("m", length)
    return f"{factor * length:.4g} {unit}"
