"""The one place that turns a design into its tendons' law."""

from __future__ import annotations

from forficula.design.design import Design
from forficula.material.material_law import scaled
from forficula.material.tendon_law import TendonLaw


def tendon_law(design: Design) -> TendonLaw:
    """The law of a design's tendons, in the design's units, whatever they are.

    Linear, with linear damping, where the design names no material.
    """
    tendon = design.tendon
    if tendon.law is not None and tendon.area is not None:
        return scaled(tendon.law.material, length=tendon.rest_length, area=tendon.area)
    return TendonLaw(
        rest_length=tendon.rest_length, stiffness=(tendon.stiffness, 0.0, 0.0), damping=(tendon.damping, 0.0, 0.0)
    )
