"""What parts really have that their design has no key for: told as numbers, so that nothing is lost silently."""

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

# angles of a hinge at which two straps are set beside one tendon
_ANGLES = 181


@dataclass(frozen=True, kw_only=True)
class Unkept:
    """A real value that the design as made has otherwise, or not at all.

    Attributes:
        name: of what it is.
        part: whose.
        real: of the parts, SI.
        modelled: of the design as made; nan where it has nothing of the kind.
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
    """What a design as made does not have of the parts.

    Args:
        parts: with joints.
        made: their design as made.

    Raises:
        InputError: a material without a density.
    """
    structure = structure_of(made)
    bodies = [body for joint in parts.joints for body in (joint.proximal.body, joint.distal.body)]
    found = [each for body in dict.fromkeys(bodies) for each in _mass(parts, structure, body)]
    places = {place.tendon: place for place in parts.straps}
    found += [
        _two_straps(structure, joint, places[joint.tendon])
        for joint in parts.joints
        if joint.tendon in places and joint.aside and structure.tendons[joint.tendon].crossing is not None
    ]
    joint = parts.joints[0]
    standoff, play = joint.standoff, joint.play
    found += [
        Unkept(
            name="standoff of the bars",
            part="all bars",
            real=standoff,
            modelled=0.0,
            unit="m",
            text=f"The bars lie {show_value(standoff, 'm')} off the plane of the hinges and the sheet, in which the"
            " design has them; the inertia about the hinges counts that, nothing else does.",
        ),
        Unkept(
            name="play of the hinges",
            part="all hinges",
            real=play,
            modelled=0.0,
            unit="m",
            text=f"A pin has {show_value(play, 'm')} of room in its hole, all around; the design's hinges have none.",
        ),
    ]
    return (*found, *_roots(parts))


def _mass(parts: PartSet, structure: Structure, body: int) -> list[Unkept]:
    """Mass, first moment and inertias of a bar beside those of the model, which has it as a uniform one."""
    origins, frames = built_frames(structure)
    origin, name = origins[body], structure.bodies[body].name
    own = parts_properties(parts.of_body(body))
    carried = [each for each in structure.masses if each.body == body and each.role != "hinge"]
    mass, centre, inertia = mass_of(structure, body)
    model = MassProperties(
        mass=mass, centre=origin + frames[body] @ centre, inertia=frames[body] @ inertia @ frames[body].T
    )
    if carried:
        model = _without(model, *_placed(gathered_mass(carried), origin, frames[body]))
    bar = next(each for each in structure.bars if each.body == body)
    along = frames[body] @ bar.end / np.linalg.norm(bar.end)
    hinge = next((joint for joint in parts.joints if joint.distal.body == body), None)
    axis, about = (np.array([0.0, 0.0, 1.0]), "across the sheet at its inner end")
    if hinge is not None:
        axis, about = hinge.frame[:, 1], "about its hinge"
    rows: tuple[tuple[str, str, Callable[[MassProperties], float]], ...] = (
        ("mass", "kg", lambda it: it.mass),
        ("first moment along the bar", "kg m", lambda it: it.mass * float((it.centre - origin) @ along)),
        (f"inertia {about}", "kg m^2", lambda it: it.about(axis, origin)),
        ("inertia about its own axis", "kg m^2", lambda it: it.about(along, origin)),
    )
    found = []
    for what, unit, read in rows:
        real, modelled = read(own), read(model)
        found.append(
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
    return found


def _placed(of: tuple[float, Array, Array], origin: Array, frame: Array) -> tuple[float, Array, Array]:
    mass, centre, inertia = of
    return mass, origin + frame @ centre, frame @ inertia @ frame.T


def _without(whole: MassProperties, mass: float, centre: Array, inertia: Array) -> MassProperties:
    """What is left of a body where some of it is taken away."""
    left = whole.mass - mass
    middle = (whole.mass * whole.centre - mass * centre) / left

    def steiner(weight: float, away: Array) -> Array:
        return np.asarray(weight * (away @ away * np.eye(3) - np.outer(away, away)))

    rest = whole.inertia + steiner(whole.mass, whole.centre - middle) - inertia - steiner(mass, centre - middle)
    return MassProperties(mass=left, centre=middle, inertia=rest)


def strap_energy(joint: JointLayout, place: StrapPlace, structure: Structure, angle: float) -> float:
    """Energy of all straps of a tendon across one joint at an angle of its hinge, each between its own pegs, J."""
    law = structure.tendons[place.tendon].law.elastic
    lengths = [np.linalg.norm(turned(joint, angle).of(ends[1]) - ends[0]) for ends in place.ends]
    return float(np.mean([law.energy(length) for length in lengths]))


def _two_straps(structure: Structure, joint: JointLayout, place: StrapPlace) -> Unkept:
    """The barrier of two straps beside the bars, and that of one tendon in their middle."""
    angles = np.linspace(joint.upper, joint.lower, _ANGLES)
    middle = _in_the_middle(place)
    barriers = []
    for each in (place, middle):
        energies = np.array([strap_energy(joint, each, structure, float(angle)) for angle in angles])
        barriers.append(float(energies.max() - energies[0]))
    real, modelled = barriers
    return Unkept(
        name="barrier of two straps",
        part=structure.tendons[place.tendon].name,
        real=real,
        modelled=modelled,
        unit="J",
        text=f"{structure.tendons[place.tendon].name} is two straps, {show_value(joint.aside, 'm')} beside the bars:"
        f" from the overbend stop they climb {show_value(real, 'J')}, one tendon in their middle"
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
    """Where rods bend at the ground, beside where the design has joints."""
    return [
        Unkept(
            name="shift of the root",
            part=parts.structure.bodies[root.body].name,
            real=root.bends,
            modelled=0.0,
            unit="m",
            text=f"{parts.structure.bodies[root.body].name} bends {show_value(root.bends, 'm')} further out than the"
            " joint that the design has at its root, over a length, and against a stiffness; the design's joint is a"
            " point, and free.",
        )
        for root in parts.roots
        if math.isfinite(root.bends)
    ]
