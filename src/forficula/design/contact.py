"""Contact of panels, facets and bars of any design."""

from __future__ import annotations

from typing import Annotated, ClassVar, Literal

from pydantic import Field

from forficula.design.section import SHORT_TIME, SMALL_LENGTH, Section, quantity

# [chosen] time constant "auto" of the first run, s
FIRST_TIME_CONSTANT = 4e-4
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
    time_constant: float | Literal["auto"] = quantity(
        SHORT_TIME,
        "time constant T of a contact, a spring and a damper: parts that meet at a speed v overlap by up to 0.37 v T;"
        ' "auto": 0.4 ms, or as short as a run needs so that facets, plates and bars overlap by at most a tenth of'
        " their thickness; the timestep is then at most T / 8 where parts touch",
        default="auto",
        above=0,
        words=("auto",),
        examples=["0.4 ms"],
    )
    damping_ratio: Annotated[
        float, Field(strict=True, gt=0, le=1, description="share of critical damping of a contact")
    ] = 1.0


def with_time_constant(contact: ContactSection, time_constant: float) -> ContactSection:
    """Return the section with a time constant, s, instead of "auto"; the same section if the time constant is given."""
    if contact.time_constant != "auto":
        return contact
    return contact.model_copy(update={"time_constant": time_constant})
