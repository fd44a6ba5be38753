"""The contact of a structure, from the section of its design."""

from __future__ import annotations

from forficula.design import FanDesign, SheetDesign
from forficula.design.contact import FIRST_TIME_CONSTANT
from forficula.structure.surroundings import Contact, Stops


def contact_of(design: FanDesign | SheetDesign, thickness: float) -> Contact | None:
    """Return the contact of the parts of a design; None without contact.

    Args:
        design: of a fan or a sheet.
        thickness: of its panels or facets, m, which is that of the contact if the section gives none.
    """
    section = design.settled().contact
    if not design.protocol.contact or section is None:
        return None
    automatic = section.time_constant == "auto"
    time_constant = FIRST_TIME_CONSTANT if section.time_constant == "auto" else section.time_constant
    return Contact(
        thickness=thickness if section.thickness is None else section.thickness,
        friction=section.friction,
        stops=Stops(time_constant=time_constant, damping_ratio=section.damping_ratio),
        automatic=automatic,
    )
