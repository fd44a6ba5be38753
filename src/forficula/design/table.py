"""The table on which a structure may lie: a plane that its parts cannot pass through."""

from __future__ import annotations

from typing import Annotated, ClassVar

from pydantic import Field

from forficula.design.section import LENGTH, SHORT_TIME, Section, quantity

# [chosen] as for stops: with eight steps per time constant, impacts converge with the timestep
_TIME_CONSTANT = 1e-3  # s


class TableSection(Section):
    """A table normal to gravity, on which the structure may fall, lie and slide."""

    heading: ClassVar[str] = "Table"
    about: ClassVar[str] = "A table normal to gravity, on which the structure may fall, lie and slide"

    height: float = quantity(
        LENGTH,
        "height of the table above the origin of the structure's axes, against protocol.gravity_direction",
        examples=["-20 cm"],
    )
    friction: Annotated[
        float,
        Field(
            strict=True,
            ge=0,
            le=10,
            description="Coulomb's friction coefficient between the structure and the table; 0: no friction",
        ),
    ] = 0.0
    time_constant: float = quantity(
        SHORT_TIME,
        "time constant T of contact with the table, a spring and a damper: a part that meets it at a speed v sinks in"
        " by up to 0.37 v T",
        default=_TIME_CONSTANT,
        above=0,
        examples=["1 ms"],
    )
    damping_ratio: Annotated[
        float, Field(strict=True, gt=0, le=1, description="share of critical damping of contact with the table")
    ] = 1.0
