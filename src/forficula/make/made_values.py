"""Properties of made parts, measured on their solids, in groups of design values."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from forficula.errors import InputError
from forficula.make.hinge.free_range import free_range
from forficula.make.hinge.joint_layout import Arm, JointLayout
from forficula.make.hinge.straps import Strap
from forficula.make.part import PartSet
from forficula.make.solid.mass_properties import parts_properties
from forficula.structure import Bar
from forficula.structure.mass import end_inertia


@dataclass(frozen=True, kw_only=True)
class MadeTendon:
    """A tendon as its straps are made.

    Attributes:
        number: number of the tendon.
        attachments: distances of the pegs from the hinge along the bars, proximal first, m.
        offsets: offsets of the pegs out of the plane of the sheet, towards the overbend side, m.
        area: printed cross-section of all straps together, m^2.
        by_area: printed area / area that the design's stiffness requires: the factor of the stiffness.
        mass: mass of all straps including their eyes, kg; None if the density is unknown.
        rest_length: between the pegs, m.
    """

    number: int
    attachments: tuple[float, float]
    offsets: tuple[float, float]
    area: float
    by_area: float
    mass: float | None
    rest_length: float


@dataclass(frozen=True, kw_only=True)
class MadeBars:
    """A uniform bar with a mass at the hinge that is dynamically equivalent to the outer halves of the joints.

    Attributes:
        density: density of the bar, from the inertia of a half about its hinge, kg/m^3; mean of all halves.
        hinge_mass: twice the mass to add at the end of the bar to reach the mass of the half, kg; mean, and 0 if the
            bar alone is heavier.
        spread: difference between the largest and the smallest density of single halves, relative to the mean.
        missing: mass of the half minus that of the bar with its hinge mass, kg; < 0 if the bar alone is heavier.
    """

    density: float
    hinge_mass: float
    spread: float
    missing: float


@dataclass(frozen=True, kw_only=True)
class MadeValues:
    """Values that were measured on parts.

    Attributes:
        stops: for every joint, angles at which its halves begin to overlap, rad, fold and overbend, in the hinge's own
            sense.
        tendons: tendons with straps.
        bars: equivalent of the halves that turn and carry no other halves.
    """

    stops: tuple[tuple[float, float], ...]
    tendons: tuple[MadeTendon, ...]
    bars: MadeBars


def made_values(parts: PartSet) -> MadeValues:
    """Measure stops, pegs, straps, masses and inertias on the solids of parts.

    Raises:
        InputError: parts without joints, a material without a density, or a joint without stops or whose halves always
            overlap.
    """
    if not parts.joints:
        raise InputError(f"{parts.design.name}: has no joints that could be measured")
    return MadeValues(
        stops=tuple(_stops(parts, joint) for joint in parts.joints),
        tendons=tuple(_tendon(parts, number) for number in tendons_of(parts)),
        bars=_bars(parts),
    )


def tendons_of(parts: PartSet) -> tuple[int, ...]:
    """Return the indices of the tendons for which straps are made."""
    return tuple(place.tendon for place in parts.straps)


def printed_width(joint: JointLayout, strap: Strap) -> float:
    """Return the printed width of a strap, m. It is printed standing on its edge, so a filament gives whole layers."""
    layer = joint.make.layer
    return strap.width if joint.make.process == "powder" else layer * max(1, round(strap.width / layer))


def printed_shares(parts: PartSet) -> dict[str, float]:
    """Return the printed width / width of the solid for every kind of strap, by its name."""
    return {
        parts.strap_of(joint.tendon).name: printed_width(joint, joint.strap) / joint.strap.width
        for joint in parts.joints
        if joint.tendon in tendons_of(parts) and joint.strap is not None and joint.tendon is not None
    }


def outer_joints(parts: PartSet) -> tuple[JointLayout, ...]:
    """Return the joints whose distal half carries no other half."""
    carrying = {joint.proximal.body for joint in parts.joints}
    return tuple(joint for joint in parts.joints if joint.distal.body not in carrying)


def _stops(parts: PartSet, joint: JointLayout) -> tuple[float, float]:
    lower, upper = free_range(parts, joint)
    if not (math.isfinite(lower) and math.isfinite(upper) and lower < upper):
        where = "at every angle" if lower == upper else "at no angle up to 12 deg beyond a stop of the design"
        raise InputError(f"{joint.name}: its two halves overlap {where}, so the made joint has no stops")
    return lower, upper


def _tendon(parts: PartSet, number: int) -> MadeTendon:
    """Return a tendon as its straps are made, from the joints that it crosses."""
    pegs: list[tuple[JointLayout, Arm]] = [
        (joint, arm)
        for joint in parts.joints
        if joint.tendon == number
        for arm in (joint.proximal, joint.distal)
        if arm.peg
    ]
    (joint, inner), (_, outer) = pegs[0], pegs[-1]
    strap = joint.strap
    assert strap is not None  # the tendon has straps
    share = printed_width(joint, strap) / strap.width
    part = parts.strap_of(number)
    return MadeTendon(
        number=number,
        attachments=(_rounded(inner.peg), _rounded(outer.peg)),
        offsets=(_rounded(inner.height), _rounded(outer.height)),
        area=_rounded(share * strap.area),
        by_area=_rounded(share),
        mass=None if part.mass is None else _rounded(share * part.count * part.mass),
        rest_length=_rounded(strap.rest_length),
    )


def _bars(parts: PartSet) -> MadeBars:
    """Return the uniform bar that is equivalent to the outer halves."""
    bars = {bar.body: bar for bar in parts.structure.bars}
    densities, at_hinge = [], []
    for joint in outer_joints(parts):
        bar = bars[joint.distal.body]
        solid = parts_properties(parts.of_body(bar.body))
        density = solid.about(joint.frame[:, 1], joint.origin) / unit_inertia(joint, bar)
        densities.append(density)
        at_hinge.append(solid.mass - density * _volume(bar))
    density, missing = _mean(densities), _mean(at_hinge)
    return MadeBars(
        density=density,
        hinge_mass=2 * max(0.0, missing),
        spread=(max(densities) - min(densities)) / density,
        missing=min(0.0, missing),
    )


def unit_inertia(joint: JointLayout, bar: Bar) -> float:
    """Return the inertia of a joint's uniform outer bar about its hinge / its density, m^5."""
    along = float(joint.distal.along @ joint.frame[:, 1])
    return end_inertia(
        diameter=bar.diameter,
        density=1.0,
        length=joint.distal.length,
        along=along,
        across=math.sqrt(1 - along**2),
    )


def _volume(bar: Bar) -> float:
    return math.pi / 4 * bar.diameter**2 * float(sum(bar.end**2) ** 0.5)


def _rounded(value: float) -> float:
    """Remove rounding errors that depend on the position of bars in space, so that equal joints give equal values."""
    return float(f"{value:.9g}") + 0.0


def _mean(values: Sequence[float]) -> float:
    return sum(values) / len(values)
