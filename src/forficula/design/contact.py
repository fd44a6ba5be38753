"""Contact of panels, facets and bars of any design."""

from __future__ import annotations

from typing import Annotated, ClassVar

from pydantic import Field

from forficula.design.section import SHORT_TIME, SMALL_LENGTH, Section, quantity

# sentence about the section in a design without contact
WITHOUT_CONTACT = "contact.thickness and contact.friction have no effect without contact: need protocol.contact = true"


class ContactSection(Section):
    """Contact of panels, facets and bars, if protocol.contact is true."""

    about: ClassVar[str] = "Contact of panels, facets and bars, if protocol.contact is true"

    heading: ClassVar[str] = "Contact"

    thickness: float | None = quantity(
        SMALL_LENGTH,
        "distance between the mid-planes of touching panels or facets; if not given, membrane.thickness or"
        " facet.thickness",
        default=None,
        above=0,
    )
    friction: Annotated[
        float,
        Field(
            strict=True,
            ge=0,
            le=10,
            description="Coulomb's friction coefficient of panels, facets and bars; 0: no friction",
        ),
    ] = 0.0
    time_constant: float = quantity(
        SHORT_TIME,
        "time constant T of a contact, a spring and a damper: parts that meet at a speed v overlap by up to 0.37 v T",
        default=4e-4,
        above=0,
        examples=["0.4 ms"],
    )
    damping_ratio: Annotated[
        float, Field(strict=True, gt=0, le=1, description="share of critical damping of a contact")
    ] = 1.0
