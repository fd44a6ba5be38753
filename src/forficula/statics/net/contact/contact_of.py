"""Contact of a structure's facets and plates, as that of a net."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.sparse import csr_array

from forficula.errors import InputError
from forficula.quantities import show_value
from forficula.statics.net.contact.net_contact import NetContact
from forficula.statics.net.energy import expand, shape_at
from forficula.statics.net.net import Net
from forficula.structure import Structure
from forficula.structure.contact.touching_parts import touching_parts

# stiffness of the augmented Lagrangian, of the largest one as built, of facets and of plates, whose pins and bars are
# far stiffer than other parts: with less, contact forces converge slowly; with more, descents take many steps [chosen:
# within the range in which test structures converge]
_STIFFER, _RIGID = 0.3, 0.01
# of the thickness: overlap under the whole weight that the stiffness allows at most before contact forces are known, so
# that loose layers, which nothing but contact holds up, do not reach each other's middle surfaces [chosen]
_SUNK = 0.1
# of the thickness: distance by which a part of the size of the net counts as larger on each side [chosen]
_LARGER = 1e-3
_WITHIN = 1e-6  # of the thickness, by which parts may be too close as built


def with_contact(structure: Structure, net: Net) -> Net:
    """Return the net of a structure with its contact; the same net for a structure without contact.

    Raises:
        InputError: parts are closer as built than they may be.
    """
    parts = None if structure.contact is None else touching_parts(structure, structure.contact)
    if parts is None:
        return net
    stiffest = float(expand(net, shape_at(net, net.nodes)).free.diagonal().max(initial=0.0)) or 1.0
    weight = abs(structure.gravity) * sum(body.mass for body in structure.bodies)
    contact = NetContact(
        parts=parts,
        points=csr_array(csr_array(net.points)[parts.points]),
        stiffness=max(
            (_RIGID if structure.plates else _STIFFER) * stiffest, weight / (_SUNK * 2 * float(parts.half.max()))
        ),
        larger=_LARGER * 2 * float(parts.half.max()) / net.size,
        size=net.size,
    )
    _check_apart(structure, net, contact)
    return replace(net, contact=contact)


def contact_remarks(structure: Structure) -> tuple[str, ...]:
    """Return remarks on the contact of a landscape; none without contact."""
    if structure.contact is None:
        return ()
    return (
        f"statics keeps the parts of the {structure.appearance.whole} apart by the thickness of contact, and ignores"
        " friction",
        "frequencies are those of small vibrations in which touching parts stay in contact",
    )


def _check_apart(structure: Structure, net: Net, contact: NetContact) -> None:
    """Refuse parts that are too close as built."""
    places = contact.points @ net.nodes
    pairs, _ = contact.near(places)
    # without the share by which parts count as larger, so that panels that touch as built are allowed
    surfaces = pairs.nearest(places).distances / pairs.thickness
    if surfaces.min(initial=np.inf) >= 1 - _WITHIN:
        return
    row = int(np.argmin(surfaces))
    one, other = (
        contact.parts.names[part] for part in contact.parts_of(pairs.some(np.arange(len(surfaces)) == row))[0]
    )
    thickness = float(pairs.thickness[row])
    most, got = show_value(float(surfaces[row]) * thickness, "m"), show_value(thickness, "m")
    need = "parts that are apart as built" if surfaces[row] <= _WITHIN else f"at most {most}"
    raise InputError(
        f"{structure.name}: contact.thickness: need {need}, because {one} and {other} are {most} apart as built, got"
        f" {got}"
    )
