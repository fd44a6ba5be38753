"""Couplings, springs and tendons between the parts of an assembly."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from forficula.design import tendon_law
from forficula.design.assembly.assembly import AssemblyDesign
from forficula.design.assembly.joints import GROUND_BODY, CouplingJoint, SpringJoint, TendonJoint
from forficula.errors import InputError
from forficula.structure.assembly.joined_part import JoinedPart
from forficula.structure.assembly.layout import number_of
from forficula.structure.fans.crossing import tendon_crossing
from forficula.structure.mass import inertia_about
from forficula.structure.parts import GROUND, Coupling, Point, Spring, Tendon
from forficula.structure.structure import Structure
from forficula.structure.tree import ancestry, moving_body


def with_joints(structure: Structure, design: AssemblyDesign) -> Structure:
    """Return a structure with the couplings, springs and tendons between the parts."""
    points = list(structure.points)

    def end(joint: SpringJoint | TendonJoint, key: str) -> int:
        text = getattr(joint, key)
        if text.strip() != GROUND_BODY:
            return number_of(f"joint.{joint.name}.{key}", points, text)
        if len(joint.ground) != 3:
            raise InputError(f"joint.{joint.name}.ground: need x, y and z of the point on the ground")
        points.append(Point(name=f"{joint.name} {key}", role="ground", body=GROUND, place=np.array(joint.ground)))
        return len(points) - 1

    def ends(joint: SpringJoint | TendonJoint) -> tuple[int, int]:
        one, other = end(joint, "from"), end(joint, "to")
        if moving_body(structure, points[one].body) == moving_body(structure, points[other].body):
            names = f"{points[one].name} and {points[other].name}"
            raise InputError(f"joint.{joint.name}.to: need points that move relative to each other, got {names}")
        if joint.ground and not {points[one].role, points[other].role} & {GROUND_BODY}:
            raise InputError(f'joint.{joint.name}.ground: needs "ground" as one end, and both ends are points of parts')
        return one, other

    couplings, springs, tendons = list(structure.couplings), list(structure.springs), list(structure.tendons)
    for number, joint in enumerate(design.joint):
        if isinstance(joint, CouplingJoint):
            one, other = (_joint_number(structure, f"joint.{joint.name}.hinges", name) for name in joint.hinges)
            stiffness = math.inf if joint.stiffness == "rigid" else float(joint.stiffness)
            couplings.append(Coupling(name=joint.name, hinges=(one, other), stiffness=stiffness, ratio=joint.ratio))
        elif isinstance(joint, SpringJoint):
            springs.append(
                Spring(
                    name=joint.name,
                    role="spring",
                    points=ends(joint),
                    stiffness=joint.stiffness,
                    rest_length=joint.rest_length,
                    damping=joint.damping,
                )
            )
        elif isinstance(joint, TendonJoint):
            tendons.append(
                Tendon(
                    name=joint.name,
                    role="tendon",
                    points=ends(joint),
                    law=tendon_law(joint),
                    longest=math.inf,
                    gauge_length=joint.rest_length,
                    material=None if joint.law is None else joint.law.material,
                    key=f"joint.{number}",
                )
            )
    made = replace(structure, points=tuple(points), couplings=tuple(couplings), springs=tuple(springs))
    first = len(structure.tendons)
    if any(body.slides for body in made.bodies) or made.closures or made.holds:
        return replace(made, tendons=tuple(tendons))
    crossed = [replace(tendon, crossing=tendon_crossing(made, tendon.points)) for tendon in tendons[first:]]
    return replace(made, tendons=(*tendons[:first], *crossed))


def _joint_number(structure: Structure, key: str, name: str) -> int:
    """Return the number of a joint that turns a body; a crease that opens has none."""
    number = number_of(key, structure.hinges, name)
    if structure.hinges[number].flaps is not None:
        raise InputError(f"{key}: need hinges that turn a body, and {name} is a crease that opens or between nodes")
    return number


def with_inertia(structure: Structure, parts: Sequence[JoinedPart]) -> Structure:
    """Return a structure whose tendons have the inertia of everything that turns, other parts included."""
    carrying = {body for part in parts if part.base != GROUND for body in ancestry(structure, part.base)}

    def complete(tendon: Tendon) -> Tendon:
        crossing = tendon.crossing
        if crossing is None or structure.hinges[crossing.hinge].body not in carrying:
            return tendon
        return replace(tendon, crossing=replace(crossing, inertia=inertia_about(structure, crossing.hinge)))

    return replace(structure, tendons=tuple(map(complete, structure.tendons)))
