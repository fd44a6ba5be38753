"""Dimensionless groups of a structure, relative to its strongest tendon or its stiffest crease.

Two structures with equal groups move identically in t / t* (similarity: Buckingham 1914, doi 10.1103/PhysRev.4.345).
Every moment is divided by that of the tendon, k a b, and every time by t* = sqrt(I / (k a b)), the time in which the
tendon moves the part that turns about its hinge.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Annotated, Literal

import numpy as np

from forficula.analysis.scales import Scale, scale_of
from forficula.names import listed
from forficula.pattern.geometry import polygon_normal, triangle_areas
from forficula.serial import Key, Written
from forficula.structure import Structure, built_frames, built_points, hinge_groups, springs_name

# m/s^2, for the group of gravity if the run has none
_GRAVITY = 9.81
# air at 20 deg C, kg/m^3 and Pa s, for the groups of the medium if the run has none
_AIR = (1.2, 1.8e-5)
_SAME = 1e-9  # share of a group; smaller differences are rounding errors


@dataclass(frozen=True, kw_only=True)
class Group:
    """A dimensionless group.

    Attributes:
        name: key in `summary.json`.
        label: name in tables and sentences.
        value: dimensionless value.
        meaning: the two quantities whose ratio it is.
        kind: "drive" for a driving moment; "resist" for a resisting moment at the tendon's own speed; "stretch" for
            the stiffness of a sheet or of bars; "time"; "shape"; "left out" for an effect that the run leaves out.
    """

    name: str
    label: str
    value: float
    meaning: str
    kind: Literal["drive", "resist", "stretch", "time", "shape", "left out"]


@dataclass(frozen=True, kw_only=True)
class Groups:
    """All dimensionless groups of a structure.

    Attributes:
        scale: moment and time by which the groups are divided.
        every: the groups, in the order of tables.
    """

    scale: Annotated[Scale, Key("measured_by")]
    every: Annotated[tuple[Group, ...], Written.NEVER]

    @property
    def values(self) -> Annotated[Mapping[str, float], Written.BESIDE]:
        """Return the values of the groups by name."""
        return {group.name: group.value for group in self.every}

    @property
    def in_words(self) -> Annotated[str, Written.ALWAYS]:
        """Return a sentence about the dominant groups."""
        return dominance(self)


def groups_of(structure: Structure, timestep: float | Literal["auto"] = "auto") -> Groups | None:
    """Compute the dimensionless groups of a structure, without those of parts that it does not have.

    Args:
        structure: SI.
        timestep: s; "auto" if it is not known yet.

    Returns:
        None if neither a tendon nor an elastic hinge could serve as the scale.
    """
    scale = scale_of(structure)
    if scale is None:
        return None
    widths = _widths(structure)
    every = (
        *_drives(structure, scale),
        *_inertia(structure, scale),
        *_damping(structure, scale),
        *_weight(structure, scale),
        *_medium(structure, scale, widths),
        *_stretch(structure, scale, widths),
        *_bending(structure, scale),
        *_times(structure, scale, timestep),
        *_shape(structure, scale, widths),
    )
    # a value that overflows has no meaning
    return Groups(scale=scale, every=tuple(group for group in every if math.isfinite(group.value)))


def changed(before: Groups | None, after: Groups | None) -> list[tuple[Group, Group]]:
    """Return pairs of groups of two structures that have the same name and differ by more than rounding."""
    if before is None or after is None:
        return []
    others = {group.name: group for group in after.every}
    pairs = [(group, others[group.name]) for group in before.every if group.name in others]
    return [pair for pair in pairs if not math.isclose(pair[0].value, pair[1].value, rel_tol=_SAME)]


def measured_by(scale: Scale) -> str:
    """Return the moment by which moments are divided, in words."""
    return f"{'the stiffness' if scale.tendon is None else 'k a b'} of {scale.name}"


def _drives(structure: Structure, scale: Scale) -> Iterator[Group]:
    """Yield the groups of drives.

    They are the largest torque, or force times the size of the structure, divided by the moment of the scale; for
    displacements, the largest displacement divided by the size.
    """
    for drive in structure.drives:
        largest: dict[str, float] = {}
        for motor, strength in zip(structure.motors, drive.strengths, strict=True):
            most = abs(strength) * max(map(abs, motor.gains), default=1.0)
            largest[motor.kind] = max(largest.get(motor.kind, 0.0), most)
        by = {
            "torque": (1 / scale.moment, f"its torque, divided by {measured_by(scale)}"),
            "force": (
                structure.span / scale.moment,
                f"its force times the size of the structure, divided by {measured_by(scale)}",
            ),
            "displacement": (1 / structure.span, "its displacement, divided by the size of the structure"),
        }
        for kind, (factor, meaning) in by.items():
            if largest.get(kind):
                yield Group(
                    name=f"{kind}_{'_'.join(drive.name.split())}",
                    label=f'the drive "{drive.name}"',
                    value=factor * largest[kind],
                    meaning=meaning,
                    kind="shape" if kind == "displacement" else "drive",
                )


def _inertia(structure: Structure, scale: Scale) -> Iterator[Group]:
    """Yield the inertia of a motor on the hinge, divided by the inertia of the part that turns there."""
    armature = structure.hinges[scale.hinge].armature
    if armature and scale.inertia:
        yield Group(
            name="armature",
            label="the armature",
            value=armature / scale.inertia,
            meaning="inertia of a motor on the hinge, divided by that of the part that turns",
            kind="resist",
        )


def _damping(structure: Structure, scale: Scale) -> Iterator[Group]:
    """Yield moments of dampers at the speed 1 / t*: c / (k a b t*) for the hinge, c sqrt(a b / (k I)) for a tendon.

    For a tendon with a material law, c is its linear viscosity; Maxwell branches are among the times.
    """
    if not scale.time:
        return
    damping = structure.hinges[scale.hinge].damping
    if damping:
        yield Group(
            name="hinge_damping",
            label="the hinge's damping",
            value=damping / (scale.moment * scale.time),
            meaning=f"moment of the hinge's damper at a speed of 1 / t*, divided by {measured_by(scale)}",
            kind="resist",
        )
    friction = structure.hinges[scale.hinge].friction
    if friction:
        yield Group(
            name="hinge_friction",
            label="the hinge's dry friction",
            value=friction / scale.moment,
            meaning=f"torque of the hinge's dry friction, divided by {measured_by(scale)}",
            kind="resist",
        )
    if scale.tendon is None:
        return
    linear = (structure.tendons[scale.tendon].law.damping or (0.0,))[0]
    if linear:
        yield Group(
            name="tendon_damping",
            label="the tendon's damping",
            value=linear * math.prod(scale.arms) / (scale.moment * scale.time),
            meaning=f"moment of the tendon's own damper at a speed of 1 / t*, divided by {measured_by(scale)}",
            kind="resist",
        )


def _weight(structure: Structure, scale: Scale) -> Iterator[Group]:
    """Yield the weight moment m g r of the turning part in a level position; with 9.81 m/s^2 if gravity is off."""
    if not scale.weight_arm:
        return
    on = structure.gravity != 0
    gravity = abs(structure.gravity) if on else _GRAVITY
    yield Group(
        name="gravity" if on else "gravity_left_out",
        label="gravity" if on else "gravity, left out",
        value=gravity * scale.weight_arm / scale.moment,
        meaning=f"moment of the weight of the part that turns, divided by {measured_by(scale)}"
        + ("" if on else ", if gravity were 9.81 m/s^2"),
        kind="resist" if on else "left out",
    )


def _medium(structure: Structure, scale: Scale, widths: Sequence[float]) -> Iterator[Group]:
    """Yield groups of the medium around a strip of width w and length l; those of air if the run has no medium.

    w is the width of the narrowest panel and l the length of the part that turns. With m = 3 I / l^3, the mass per
    length of a bar of that length and inertia, the groups are: the added mass pi rho w^2 / (4 m); the drag rho w l / m
    at a tip speed U = l / t*; the viscous drag 32 mu l / (pi U m); and the Reynolds number rho w U / mu.
    """
    widths, (density, viscosity) = widths or _facet_widths(structure), _AIR
    medium, reach = structure.medium, scale.reach
    if medium is not None:
        density, viscosity = medium.density, medium.viscosity
    if not (widths and scale.time and reach):
        return
    width, by_length, speed = min(widths), 3 * scale.inertia / reach**3, reach / scale.time
    viscous = 32 / math.pi * viscosity * reach / (speed * by_length) if medium is not None else 0.0
    reynolds = density * width * speed / viscosity if viscosity else 0.0
    groups: tuple[tuple[str, str, float, str, Literal["resist", "shape"]], ...] = (
        (
            "medium_mass",
            "the medium's mass",
            math.pi / 4 * density * width**2 / by_length,
            "mass of the medium that moves with the part that turns, divided by the mass of that part",
            "resist",
        ),
        (
            "drag",
            "drag",
            density * width * reach / by_length,
            "drag at a speed of 1 / t*, divided by the inertia of the part that turns",
            "resist",
        ),
        ("viscous_drag", "viscous drag", viscous, "contribution of viscosity to the drag", "resist"),
        (
            "reynolds",
            "Reynolds number",
            reynolds,
            "with the width of the part that turns, at a tip speed of l / t*",
            "shape",
        ),
    )
    for name, label, value, meaning, kind in groups:
        group = Group(name=name, label=label, value=value, meaning=meaning, kind=kind)
        if value and medium is not None:
            yield group
        elif value:
            named = replace(group, name=f"{name}_left_out", label=f"{label}, left out")
            yield replace(named, meaning=f"{meaning}, if it were in air", kind="left out")


def _facet_widths(structure: Structure) -> list[float]:
    """Return the widths of facets as built, m: their areas divided by their longest sides."""
    points, widths = built_points(structure), []
    for numbers in [plate.points for plate in structure.plates] + [facet.points for facet in structure.facets]:
        corners = points[list(numbers)]
        following = np.roll(corners, -1, axis=0)
        area = np.linalg.norm(polygon_normal(corners)) / 2
        widths.append(float(area / np.linalg.norm(following - corners, axis=1).max()))
    return widths


def _stretch(structure: Structure, scale: Scale, widths: Sequence[float]) -> Iterator[Group]:
    """Yield the moment of a sheet's tension at a strain of 1, E t w, divided by k a b, and the same for bars.

    The lever arm is the tendon's distal arm, so the group is E t w / (k a). Without a tendon it is the sheet's width.
    """
    moments = [
        membrane.law.youngs_modulus * membrane.law.thickness * width * (scale.arms[1] or width)
        for membrane, width in zip(structure.membranes, widths, strict=True)
    ]
    if moments:
        yield Group(
            name="membrane",
            label="stretch of the membrane",
            value=max(moments) / scale.moment,
            meaning=f"moment of its tension at a strain of 1, divided by {measured_by(scale)}",
            kind="stretch",
        )
    if structure.springs:
        softest = min(spring.stiffness * (spring.rest_length or structure.span) ** 2 for spring in structure.springs)
        name = springs_name(structure)
        yield Group(
            name=name,
            label=f"stretch of {name}",
            value=softest / scale.moment,
            meaning=f"stiffness of the softest of them times its length squared, divided by {measured_by(scale)}",
            kind="stretch",
        )


def _widths(structure: Structure) -> list[float]:
    """Return the width of each sheet as built, m: between its hinges with tendons, or the square root of its area."""
    turned = {tendon.crossing.hinge for tendon in structure.tendons if tendon.crossing is not None}
    bodies = {structure.hinges[hinge].body for hinge in turned}
    origins, _ = built_frames(structure)
    widths = []
    for membrane in structure.membranes:
        joined = sorted(bodies & set(membrane.bodies.tolist()))
        if len(joined) > 1:
            offsets = (origins[one] - origins[other] for one, other in combinations(joined, 2))
            widths.append(min(float(np.linalg.norm(offset)) for offset in offsets))
            continue
        corners = membrane.built[membrane.triangles]
        widths.append(math.sqrt(float(triangle_areas(corners).sum())))
    return widths


def _bending(structure: Structure, scale: Scale) -> Iterator[Group]:
    """Yield the stiffness of hinge springs divided by the moment: of bending facets, and of creases beside a tendon."""
    groups = hinge_groups(structure)
    bends = [structure.hinges[number].stiffness for number in groups.get("facet bends", ())]
    if any(bends):
        yield Group(
            name="facet_bends",
            label="bending of facets",
            value=min(bends) / scale.moment,
            meaning=f"stiffness of the softest bend of a facet, divided by {measured_by(scale)}",
            kind="stretch",
        )
    folds = [structure.hinges[number].stiffness for kind in ("hinges", "creases") for number in groups.get(kind, ())]
    if scale.tendon is not None and any(folds):
        yield Group(
            name="crease_springs",
            label="springs in hinges",
            value=max(folds) / scale.moment,
            meaning=f"stiffness of the stiffest spring in a hinge, divided by {measured_by(scale)}",
            kind="resist",
        )


def _times(structure: Structure, scale: Scale, timestep: float | Literal["auto"]) -> Iterator[Group]:
    """Yield times divided by t*: relaxation times of the membrane, the tendon's branches and springs; the timestep."""
    if not scale.time:
        return
    branches = () if scale.tendon is None else structure.tendons[scale.tendon].law.branches
    times = (
        (
            "membrane_relaxation",
            "relaxation of the membrane",
            max((membrane.law.damping for membrane in structure.membranes), default=0.0),
            "relaxation time of the membrane's damping, divided by t*",
        ),
        (
            "tendon_relaxation",
            "relaxation of the tendon",
            max((branch.time for branch in branches), default=0.0),
            "longest relaxation time of a branch of the tendon's law, divided by t*",
        ),
        (
            "springs_relaxation",
            f"relaxation of {springs_name(structure)}",
            max((spring.damping / spring.stiffness for spring in structure.springs if spring.stiffness), default=0.0),
            "longest relaxation time of one of them, divided by t*",
        ),
        ("timestep", "the timestep", 0.0 if timestep == "auto" else timestep, "step of the integrator, divided by t*"),
    )
    for name, label, time, meaning in times:
        if time:
            yield Group(name=name, label=label, value=time / scale.time, meaning=meaning, kind="time")


def _shape(structure: Structure, scale: Scale, widths: Sequence[float]) -> Iterator[Group]:
    """Yield ratios of lengths of the tendon; and bars, margin and thickness divided by the sheet's width."""
    result: list[tuple[str, str, float, str]] = []
    if scale.tendon is not None:
        tendon, (near, far) = structure.tendons[scale.tendon], scale.arms
        result += [
            ("rest_length", "resting length", tendon.law.rest_length / (near + far), "of the tendon, divided by a + b"),
            ("arms", "arms", far / near, "of the tendon, b / a"),
        ]
    if structure.bars:
        slender = max(bar.diameter / float(np.linalg.norm(bar.end)) for bar in structure.bars)
        result.append(("bar_slenderness", "bars", slender, "diameter of the stoutest bar, divided by its length"))
    if widths:
        narrow, sheet = min(widths), structure.membranes[0]
        thick = max((bar.diameter for bar in structure.bars), default=0.0)
        result += [
            ("bar_width", "bars beside the membrane", thick / narrow, "their diameter, divided by its width"),
            ("margin", "margin", sheet.margin / narrow, "of the membrane, divided by its width"),
            ("thickness", "thickness", sheet.law.thickness / narrow, "of the membrane, divided by its width"),
        ]
    for name, label, value, meaning in result:
        if value:
            yield Group(name=name, label=label, value=value, meaning=meaning, kind="shape")


def dominance(groups: Groups) -> str:
    """Return a sentence on the resisting moments, largest first, the strongest drive, and the stiffness of sheets.

    Resisting moments are compared at the tendon's own speed, that is at an angle of 1, a speed of 1 / t* and an
    acceleration of 1 / t*^2, where the inertia of the part that turns is 1.
    """
    resisting = [(group.label, group.value) for group in groups.every if group.kind == "resist"]
    if groups.scale.time:
        resisting.append(("the inertia of the part that turns", 1.0))
    resisting.sort(key=lambda entry: -entry[1])
    clauses = []
    if len(resisting) > 1:
        (first, most), *others = resisting
        rest = listed([f"{label} ({value:.2g})" for label, value in others])
        clauses.append(f"the largest resistance is {first} ({most:.2g}), followed by {rest}")
    drives = sorted((group for group in groups.every if group.kind == "drive"), key=lambda group: -group.value)
    part = "crease" if groups.scale.tendon is None else "tendon"
    if drives:
        clauses.append(f"the strongest drive has {drives[0].value:.2g} times the {part}'s moment")
    clauses += [
        f"{group.label} is {_stiff(group.value)} the {part} ({group.value:.2g})"
        for group in groups.every
        if group.kind == "stretch"
    ]
    text = "; ".join(clauses)
    return f"{text[:1].upper()}{text[1:]}." if text else ""


def _stiff(value: float) -> str:
    """Return a comparison of two stiffnesses in words, from their ratio."""
    if value < 1 / 3:
        return "softer than"
    if value < 3:
        return "about as stiff as"
    return "stiffer than" if value < 100 else "far stiffer than"
