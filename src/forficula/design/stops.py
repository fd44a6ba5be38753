"""Compliance of stops, length limits and contacts: springs and dampers that do not depend on the timestep."""

from __future__ import annotations

from typing import Annotated, ClassVar

from pydantic import Field

from forficula.design.section import SHORT_TIME, Section, quantity

# [chosen] at 1 ms, opening of the reference wing converges with the timestep; at 0.4 ms one case of five does not
_TIME_CONSTANT = 1e-3  # s


class StopSection(Section):
    """Compliance of the stops of hinges and of the guard tendons."""

    heading: ClassVar[str] = "Stops"
    about: ClassVar[str] = "Compliance of the stops of hinges and of the guard tendons"

    time_constant: float = quantity(
        SHORT_TIME,
        "time constant T of a stop or a guard tendon, a critically damped spring: at an impact speed v it deflects by"
        " about 0.37 v T",
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
            description="share of critical damping; at 1 the rebound has 0.14 of the impact speed",
        ),
    ] = 1.0
