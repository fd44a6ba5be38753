"""The structure of an assembly: the structures of its parts, one after another, and the joints between them."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from forficula.design.assembly.assembly import AssemblyDesign
from forficula.design.design import Design
from forficula.errors import InputError
from forficula.structure.appearance import Appearance
from forficula.structure.assembly.components import with_components
from forficula.structure.assembly.groups import with_groups
from forficula.structure.assembly.joined_part import JoinedPart
from forficula.structure.assembly.joints import with_inertia, with_joints
from forficula.structure.assembly.layout import Layout, add_part
from forficula.structure.assembly.protocol import with_assembly_protocol
from forficula.structure.mass import mass_of
from forficula.structure.structure import Structure
from forficula.structure.surroundings import Contact, Stops
from forficula.structure.tree import built_points


def assembly_structure(design: AssemblyDesign, build: Callable[[Design], Structure]) -> Structure:
    """Build the structure of an assembly, in the units of its design.

    Bodies, points and elastic elements of the parts follow each other, with the name of the part before their names and
    before the roles of hinges. Joints come first among the hinges, then creases.

    Args:
        design: design of the assembly.
        build: function that builds the structure of a part.

    Raises:
        InputError: a joint that names something that the parts do not have, or parts that cannot be joined so.
    """
    design = design.settled()
    layout = Layout(design)
    for name in design.order:
        add_part(layout, name, build(design.designs[name]))
    parts = layout.numbered_parts()
    alone = parts[0].structure if len(parts) == 1 else None
    structure = Structure(
        name=design.name,
        bodies=tuple(layout.bodies),
        points=tuple(layout.points),
        hinges=layout.hinges,
        contact=_common_contact(design, parts),
        stops=Stops(time_constant=design.stops.time_constant, damping_ratio=design.stops.damping_ratio),
        gravity=design.protocol.gravity,
        down=design.protocol.down,
        span=parts[0].structure.span,
        mass=max(part.structure.mass for part in parts),
        strength=min((part.structure.strength for part in parts if part.structure.strength), default=None),
        imperfection=next((part.structure.imperfection for part in parts if part.structure.imperfection), None),
        rigid_fold=None if alone is None else alone.rigid_fold,
        remarks=tuple(f"{part.name}: {remark}" for part in parts for remark in part.structure.remarks),
        appearance=Appearance(whole="assembly", titles=_titles(parts)),
    )
    structure = with_components(structure, layout.masses, parts)
    if alone is not None:
        structure = replace(structure, remarks=alone.remarks, appearance=alone.appearance)
    else:
        structure = replace(structure, span=float(np.ptp(built_points(structure), axis=0).max()))
    _check_kinds(structure)
    structure = with_joints(structure, design)
    if alone is None:
        structure = with_groups(structure, parts)
    structure = with_inertia(structure, parts)
    _check_masses(structure)
    return with_assembly_protocol(structure, design, parts)


def _common_contact(design: AssemblyDesign, parts: Sequence[JoinedPart]) -> Contact | None:
    """Return the contact of the parts for which contact is modelled; None if bodies pass through each other.

    Raises:
        InputError: contact is modelled for no part, or parts differ in their contact.
    """
    if not design.protocol.contact:
        return None
    touching = [part for part in parts if part.structure.contact is not None]
    if not touching:
        raise InputError(
            f"{design.name}: protocol.contact: need false, because contact is modelled for none of the parts, got true"
        )
    # plates and facets have thicknesses of their own, panels have that of the structure
    fans = [part for part in touching if part.structure.membranes and part.structure.bars]
    first = (fans or touching)[0]
    for one, others in ((first, touching), (first, fans)):
        for part in others:
            if _contact_values(part, others is fans) != _contact_values(one, others is fans):
                raise InputError(
                    f"{design.name}: protocol.contact: need one friction and one compliance of contact in all parts,"
                    f" and one thickness in all fans, got those of {part.name} that differ from those of {one.name}"
                )
    return first.structure.contact


def _contact_values(part: JoinedPart, with_thickness: bool) -> tuple[object, ...]:
    """Return the values of a part's contact that parts must share."""
    contact = part.structure.contact
    assert contact is not None
    return (contact.friction, contact.stops, contact.automatic, contact.thickness if with_thickness else None)


def _titles(parts: Sequence[JoinedPart]) -> dict[str, str]:
    """Return the titles of the angles of all parts, by name in the assembly."""
    return {
        part.full_name(name): f"{part.name}: {title}"
        for part in parts
        for name, title in part.structure.appearance.titles.items()
    }


def _check_kinds(structure: Structure) -> None:
    """Refuse parts that cannot be simulated together."""
    laws = {dataclasses.astuple(membrane.law) for membrane in structure.membranes}
    if len(laws) > 1:
        raise InputError(
            f"{structure.name}: need membranes of one thickness and one material in all parts, got {len(laws)} that"
            " differ"
        )
    for crease in structure.hinges:
        bodies = {structure.points[point].body for point in (crease.flaps or ())}
        if structure.plates and len(bodies) > 2:
            raise InputError(
                f"{structure.name}: need facets that are rigid in all parts, or that bend in all of them, got both:"
                f" {crease.name} is a crease of facets that bend"
            )


def _check_masses(structure: Structure) -> None:
    """Refuse the body of a hinge that carries no mass itself and no body fixed to it."""
    fixed = {body.parent for number, body in enumerate(structure.bodies) if not _turns(structure, number)}
    for number, body in enumerate(structure.bodies):
        if body.role == "base" and not mass_of(structure, number)[0] and number not in fixed:
            name = body.name.removesuffix(" base")
            raise InputError(f"joint.{name}.mass: need > 0 g, because the part fixes no body to this hinge")


def _turns(structure: Structure, body: int) -> bool:
    return bool(structure.bodies[body].slides) or any(hinge.body == body for hinge in structure.hinges)
