"""What a person should know of a design that is valid all the same."""

from __future__ import annotations

import numpy as np

from forficula.design.crease_pattern import design_pattern
from forficula.design.design import Design
from forficula.design.fan import FanDesign
from forficula.design.tendon import flat_strain, tendon_law
from forficula.pattern import flat_folding_faults, vein_gaps
from forficula.quantities import reading_unit


def design_warnings(design: Design) -> list[str]:
    """What a person should know of a design that is valid all the same, one sentence each."""
    faults = flat_folding_faults(design_pattern(design))
    warnings = [f"the sheet does not fold flat: {fault.removesuffix('.')}" for fault in faults]
    return [*warnings, *_of_fan(design)] if isinstance(design, FanDesign) else warnings


def _of_fan(design: FanDesign) -> list[str]:
    branches = [*_pushing_branches(design), *_relaxing_branches(design)]
    return [*_overlapping_veins(design), *_unmeasured_strain(design), *branches, *_softening(design)]


def _overlapping_veins(design: FanDesign) -> list[str]:
    shares = np.linspace(0, 1, 1001)
    overlapping = shares[vein_gaps(design.fan, shares) < design.vein.diameter]
    if not len(overlapping):
        return []
    distance = float(overlapping[-1]) * design.pattern.proximal_length
    return [
        f"neighbouring veins of {_readable(design.vein.diameter)} overlap within {_readable(distance)} of the hub,"
        " which the simulation allows: a part to print needs thinner veins or a larger hub"
    ]


def _unmeasured_strain(design: FanDesign) -> list[str]:
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


def _pushing_branches(design: FanDesign) -> list[str]:
    law = tendon_law(design)
    if not law.branches or law.lets_go:
        return []
    total, linear = sum(branch.stiffness for branch in law.branches), law.stiffness[0]
    share = f", with moduli of {100 * total / linear:.3g} % of the linear modulus," if linear else ""
    return [
        f"Maxwell branches{share} act on slack tendons, too: after fast shortening they push, which a real tendon does"
        " not; only a law without nonlinear viscosity and yield_strain lets go in the simulation"
    ]


def _relaxing_branches(design: FanDesign) -> list[str]:
    """Of branches that relax while the wing is folded: in a run their length is the distance of the tendon's ends."""
    drives = [stage.drive for stage in design.protocol.stages]
    if "fold" not in drives or "unfold" not in drives:
        return []
    between = design.protocol.stages[drives.index("fold") + 1 : drives.index("unfold")]
    folded = sum(stage.time_limit for stage in between)
    times = [branch.time for branch in tendon_law(design).branches if branch.time < folded]
    if not times:
        return []
    shown = ", ".join(f"{factor * time:.3g} {unit}" for time in times for unit, factor in [reading_unit("s", time)])
    return [
        f"Maxwell branches of {shown} relax while the wing is folded, to the distance of the tendon's ends and not to"
        " the length of a slack tendon: when it opens they pull too much"
    ]


def _softening(design: FanDesign) -> list[str]:
    law = design.tendon.law
    if law is None or law.softening is None or flat_strain(design) <= law.residual_strain:
        return []
    return [
        "tendons do not soften within a run: they have the spring of a first pull; with --cycles, those from the second"
        " on have the spring that the stretch of the flat wing leaves"
    ]


def _readable(length: float) -> str:
    unit, factor = reading_unit("m", length)
    return f"{factor * length:.4g} {unit}"
