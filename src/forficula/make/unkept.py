"""Properties of made parts for which a design has no key, reported so that they are not lost silently."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.design import Design
from forficula.make.hinge.joint import turned
from forficula.make.hinge.joint_layout import JointLayout
from forficula.make.hinge.strap_shape import StrapPlace
from forficula.make.part import PartSet
from forficula.make.solid.mass_properties import MassProperties, parts_properties
from forficula.quantities import show_value
from forficula.structure import Structure, built_frames, gathered_mass, mass_of, structure_of

# number of hinge angles at which two straps are compared with one tendon
_ANGLES = 181


@dataclass(frozen=True, kw_only=True)
class Unkept:
    """A real value that the design as made does not reproduce.

    Attributes:
        name: name of the value.
        part: to which it belongs.
        real: value of the parts, SI.
        modelled: value in the design as made; nan if it has no such property.
        unit: SI.
        text: a sentence.
    """

    name: str
    part: str
    real: float
    modelled: float
    unit: str
    text: str


def unkept(parts: PartSet, made: Design) -> tuple[Unkept, ...]:
    """Return the properties of parts that the design as made does not reproduce.

    Args:
        parts: parts with joints.
        made: design as made.

    Raises:
        InputError: a material without a density.
    """
    structure = structure_of(made)
    bodies = [body for joint in parts.joints for body in (joint.proximal.body, joint.distal.body)]
    gaps = [mass_row for body in dict.fromkeys(bodies) for mass_row in _mass(parts, structure, body)]
    places = {place.tendon: place for place in parts.straps}
    gaps += [
        _two_straps(structure, joint, places[joint.tendon])
        for joint in parts.joints
        if joint.tendon in places and joint.aside and structure.tendons[joint.tendon].crossing is not None
    ]
    joint = parts.joints[0]
    standoff, play = joint.standoff, joint.play
    gaps += [
        Unkept(
            name="standoff of the bars",
            part="all bars",
            real=standoff,
            modelled=0.0,
            unit="m",
            text=f"The bars are {show_value(standoff, 'm')} away from the plane of the hinges and the sheet, in which"
            " they lie in the design; only the inertia about the hinges includes this distance.",
        ),
        Unkept(
            name="play of the hinges",
            part="all hinges",
            real=play,
            modelled=0.0,
            unit="m",
            text=f"A pin has a radial clearance of {show_value(play, 'm')} in its hole; the design's hinges have none.",
        ),
    ]
    return (*gaps, *_roots(parts))


def _mass(parts: PartSet, structure: Structure, body: int) -> list[Unkept]:
    """Return mass, first moment and inertias of a bar, compared with those of the uniform bar of the model."""
    origins, frames = built_frames(structure)
    origin, name = origins[body], structure.bodies[body].name
    made = parts_properties(parts.of_body(body))
    carried = [mass for mass in structure.masses if mass.body == body and mass.role != "hinge"]
    mass, centre, inertia = mass_of(structure, body)
    model = MassProperties(
        mass=mass, centre=origin + frames[body] @ centre, inertia=frames[body] @ inertia @ frames[body].T
    )
    if carried:
        model = _without(model, *_placed(gathered_mass(carried), origin, frames[body]))
    bar = next(bar for bar in structure.bars if bar.body == body)
    along = frames[body] @ bar.end / np.linalg.norm(bar.end)
    hinge = next((joint for joint in parts.joints if joint.distal.body == body), None)
    axis, about = (np.array([0.0, 0.0, 1.0]), "across the sheet at its inner end")
    if hinge is not None:
        axis, about = hinge.frame[:, 1], "about its hinge"
    rows: tuple[tuple[str, str, Callable[[MassProperties], float]], ...] = (
        ("mass", "kg", lambda properties: properties.mass),
        (
            "first moment along the bar",
            "kg m",
            lambda properties: properties.mass * float((properties.centre - origin) @ along),
        ),
        (f"inertia {about}", "kg m^2", lambda properties: properties.about(axis, origin)),
        ("inertia about its own axis", "kg m^2", lambda properties: properties.about(along, origin)),
    )
    gaps = []
    for what, unit, read in rows:
        real, modelled = read(made), read(model)
        gaps.append(
            Unkept(
                name=what,
                part=name,
                real=real,
                modelled=modelled,
                unit=unit,
                text=f"{what[0].upper()}{what[1:]} of {name}: {show_value(real, unit)} as made,"
                f" {show_value(modelled, unit)} in the design as made.",
            )
        )
    return gaps


def _placed(gathered: tuple[float, Array, Array], origin: Array, frame: Array) -> tuple[float, Array, Array]:
    mass, centre, inertia = gathered
    return mass, origin + frame @ centre, frame @ inertia @ frame.T


def _without(whole: MassProperties, mass: float, centre: Array, inertia: Array) -> MassProperties:
    """Return the mass properties of a body after the removal of a part."""
    left = whole.mass - mass
    middle = (whole.mass * whole.centre - mass * centre) / left

    def steiner(weight: float, away: Array) -> Array:
        return np.asarray(weight * (away @ away * np.eye(3) - np.outer(away, away)))

    rest = whole.inertia + steiner(whole.mass, whole.centre - middle) - inertia - steiner(mass, centre - middle)
    return MassProperties(mass=left, centre=middle, inertia=rest)


def strap_energy(joint: JointLayout, place: StrapPlace, structure: Structure, angle: float) -> float:
    """Return the energy of all straps of a tendon across one joint at a hinge angle, each between its own pegs, J."""
    law = structure.tendons[place.tendon].law.elastic
    lengths = [np.linalg.norm(turned(joint, angle).of(ends[1]) - ends[0]) for ends in place.ends]
    return float(np.mean([law.energy(length) for length in lengths]))


def _two_straps(structure: Structure, joint: JointLayout, place: StrapPlace) -> Unkept:
    """Return the barrier of two straps beside the bars, and that of one tendon in their middle."""
    angles = np.linspace(joint.upper, joint.lower, _ANGLES)
    middle = _in_the_middle(place)
    barriers = []
    for layout in (place, middle):
        energies = np.array([strap_energy(joint, layout, structure, float(angle)) for angle in angles])
        barriers.append(float(energies.max() - energies[0]))
    real, modelled = barriers
    return Unkept(
        name="barrier of two straps",
        part=structure.tendons[place.tendon].name,
        real=real,
        modelled=modelled,
        unit="J",
        text=f"{structure.tendons[place.tendon].name} consists of two straps, {show_value(joint.aside, 'm')} beside the"
        f" bars: their barrier from the overbend stop is {show_value(real, 'J')}; that of one tendon in their middle is"
        f" {show_value(modelled, 'J')}.",
    )


def _in_the_middle(place: StrapPlace) -> StrapPlace:
    return StrapPlace(
        tendon=place.tendon,
        strap=place.strap,
        bodies=place.bodies,
        ends=place.ends.mean(axis=0, keepdims=True),
        across=place.across,
        up=place.up,
        peg_diameter=place.peg_diameter,
    )


def _roots(parts: PartSet) -> list[Unkept]:
    """Return the shift between the bending rods at the ground and the joints of the design."""
    return [
        Unkept(
            name="shift of the root",
            part=parts.structure.bodies[root.body].name,
            real=root.bends,
            modelled=0.0,
            unit="m",
            text=f"{parts.structure.bodies[root.body].name} bends {show_value(root.bends, 'm')} further out than the"
            " joint at its root in the design. It bends over a length and with a stiffness; the joint of the design is"
            " a point without stiffness.",
        )
        for root in parts.roots
        if math.isfinite(root.bends)
    ]
