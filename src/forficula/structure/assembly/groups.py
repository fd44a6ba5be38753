"""Mechanisms of an assembly, and the groups of bodies that drawings show in one colour."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from forficula.structure.appearance import BodyGroup
from forficula.structure.assembly.joined_part import JoinedPart
from forficula.structure.mechanisms import ELEMENT_KINDS, mechanisms_of, storing_elements
from forficula.structure.parts import GROUND, Mechanism
from forficula.structure.structure import Structure


def with_groups(structure: Structure, parts: Sequence[JoinedPart]) -> Structure:
    """Return a structure with the mechanisms of its parts, one for each joint that stores energy, and parts in colours.

    The body of a hinge between parts has the colour of the part that it carries.
    """
    first = dict.fromkeys(ELEMENT_KINDS, 0)
    mechanisms: list[Mechanism] = []
    for part in parts:
        for mechanism in mechanisms_of(part.structure):
            elements = {
                kind: tuple(first[kind] + number for number in getattr(mechanism, kind))
                for kind in ELEMENT_KINDS
                if kind != "hinges"
            }
            hinges = tuple(part.hinges[number] for number in mechanism.hinges)
            mechanisms.append(Mechanism(name=f"{part.name}: {mechanism.name}", hinges=hinges, **elements))
        for kind in ELEMENT_KINDS:
            first[kind] += len(getattr(part.structure, kind))
    of_parts = {hinge for part in parts for hinge in part.hinges}
    for kind, numbers in storing_elements(structure).items():
        for number in numbers:
            if number not in of_parts if kind == "hinges" else number >= first[kind]:
                name = getattr(structure, kind)[number].name
                mechanisms.append(Mechanism(name=name, **{kind: (number,)}))
    groups = tuple(
        BodyGroup(
            name=part.name,
            bodies=(
                *((part.base,) if part.base != GROUND and structure.bodies[part.base].role == "base" else ()),
                *range(part.first_body, part.first_body + len(part.structure.bodies)),
            ),
        )
        for part in parts
    )
    return replace(structure, mechanisms=tuple(mechanisms), groups=groups)
