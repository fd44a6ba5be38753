"""A design's tendons: their law, and how far the flat wing stretches them."""

from __future__ import annotations

import numpy as np

from forficula.design.fan import FanDesign
from forficula.design.places import tendon_ends
from forficula.material.law.material_law import scaled
from forficula.material.law.tendon_law import TendonLaw
from forficula.pattern import hub_points, ring_vertices, tips


def tendon_law(design: FanDesign) -> TendonLaw:
    """The law of a design's tendons, in the design's units, whatever they are.

    Linear, with linear damping, where the design names no material.
    """
    tendon = design.tendon
    if tendon.law is not None and tendon.area is not None:
        return scaled(tendon.law.material, length=tendon.rest_length, area=tendon.area)
    return TendonLaw(
        rest_length=tendon.rest_length, stiffness=(tendon.stiffness, 0.0, 0.0), damping=(tendon.damping, 0.0, 0.0)
    )


def flat_strain(design: FanDesign) -> float:
    """The strain of the tendon that the flat wing stretches most; infinite without a resting length."""
    before, beyond = tendon_ends(hub_points(design.fan), ring_vertices(design.fan), tips(design.fan), design)
    longest = float(np.linalg.norm(beyond - before, axis=-1).max())
    return longest / design.tendon.rest_length - 1 if design.tendon.rest_length else float("inf")
