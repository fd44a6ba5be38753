"""How stops, length limits and contacts give way: springs and dampers whose parameters no timestep changes."""

from __future__ import annotations

from typing import Annotated, ClassVar

from pydantic import Field

from forficula.design.section import SHORT_TIME, Section, quantity

# [chosen] with this one the openings of the reference wing converge in the timestep; with 0.4 ms one of five does not
_TIME_CONSTANT = 1e-3  # s


class StopSection(Section):
    """Compliance of the stops of hinges and of the guard tendons."""

    heading: ClassVar[str] = "Stops"
    about: ClassVar[str] = "Compliance of the stops of hinges and of the guard tendons"

    time_constant: float = quantity(
        SHORT_TIME,
        "time constant T of a stop or a guard tendon: it pushes back like a spring and a damper that decay in T;"
        " a stop that is met at a speed v yields by about 0.37 v T",
        default=_TIME_CONSTANT,
        above=0,
        examples=["2 ms"],
    )
    damping_ratio: Annotated[
        float,
        Field(
            strict=True,
            gt=0,
            le=1,
            description="share of critical damping; 1: the rebound has 0.14 of the speed of the impact",
        ),
    ] = 1.0
