"""Design and its parts, and the protocol: what a user may choose, checked."""

from __future__ import annotations

import hashlib
import json
import math
from typing import Annotated, Any, Literal

import numpy as np
from pydantic import Field, field_validator, model_validator

from forficula.design.law import AREA, Law
from forficula.design.part import (
    ACCELERATION,
    ANGLE,
    ANGULAR_SPEED,
    DENSITY,
    HINGE_DAMPING,
    INERTIA,
    LENGTH,
    MODULUS,
    SHORT_TIME,
    SMALL_LENGTH,
    STIFFNESS,
    TENDON_DAMPING,
    TIME,
    TORQUE,
    Part,
    quantity,
)
from forficula.design.start import largest_start, start_stretch
from forficula.errors import InputError
from forficula.names import folder_name, shown_name
from forficula.pattern import EarwigFan, ring_vertices, vein_gaps
from forficula.quantities import as_written, show_quantity

# beyond atoms and worlds, m: within, every power that a unit has of a length is a float
_SMALLEST, _LARGEST = 1e-12, 1e12
_MOST_STEPS = 1e9
# rows of a record times veins: some 5 GB in memory
_MOST_ROWS = 1e7
_MOST_VEINS = 1001


class Pattern(Part):
    """The sheet: where it folds."""

    kind: Annotated[Literal["earwig-fan"], Field(description="the family of crease patterns")]
    proximal_length: float = quantity(LENGTH, "length of a vein from the hub to the ring fold", above=0)
    distal_length: float = quantity(LENGTH, "length of a vein beyond the ring fold", above=0)
    hub_radius: float = quantity(LENGTH, "radius of the circle that the veins are tangent to", at_least=0)
    sector_angle: float = quantity(ANGLE, "angle between neighbouring veins", above=0, below=math.pi)
    units: Annotated[int, Field(strict=True, ge=1, le=10_000, description="fan units, of two panels each")]
    tangent: Annotated[
        Literal["left", "right"], Field(description="side of the hub on which the proximal veins pass, seen outwards")
    ]

    @model_validator(mode="after")
    def _of_a_size(self) -> Pattern:
        for key, length, least in (
            ("proximal_length", self.proximal_length, _SMALLEST),
            ("distal_length", self.distal_length, _SMALLEST),
            ("hub_radius", self.hub_radius, 0.0),
        ):
            if not least <= length <= _LARGEST:
                raise InputError(
                    f"pattern.{key}: need >= {show_quantity(least, LENGTH)} and <= {show_quantity(_LARGEST, LENGTH)},"
                    f" got {show_quantity(length, LENGTH)}"
                )
        return self


class Vein(Part):
    """The bars."""

    diameter: float = quantity(SMALL_LENGTH, "diameter of the bars", above=0)
    density: float = quantity(DENSITY, "mass of the bars by volume", above=0)


Share = Annotated[float, Field(strict=True)]


class Membrane(Part):
    """The sheet between the bars: stretch elasticity only."""

    youngs_modulus: float = quantity(MODULUS, "Young's modulus", above=0)
    thickness: float = quantity(SMALL_LENGTH, "thickness", above=0)
    poisson_ratio: Annotated[float, Field(strict=True, ge=0, lt=0.5, description="Poisson's ratio")]
    damping: float = quantity(SHORT_TIME, "relaxation time of its Kelvin-Voigt damping", at_least=0)
    margin: float = quantity(LENGTH, "width of the strip of each panel that is glued to its vein", above=0)
    margin_limit: Annotated[
        float,
        Field(
            strict=True,
            gt=0,
            lt=1,
            description="largest share of the panel's width that the margin takes, near the hub",
        ),
    ]
    proximal_rows: Annotated[
        tuple[Share, ...],
        Field(min_length=1, description="rows of its mesh, in shares of the proximal length; the first is its edge"),
    ]
    distal_rows: Annotated[
        tuple[Share, ...],
        Field(description="rows of its mesh between ring fold and tip, in shares of the distal length"),
    ]


class Hinge(Part):
    """Joints of the veins at the base and at the ring fold."""

    overbend: float = quantity(
        ANGLE, "how far a distal hinge bends past straight, away from folding", at_least=0, below=math.pi / 2
    )
    fold_limit: float = quantity(ANGLE, "how far a distal hinge folds", above=0, at_most=math.pi)
    turn_limit: float = quantity(ANGLE, "how far a vein turns about its axis while folding", above=0, at_most=math.pi)
    turn_back: float = quantity(ANGLE, "how far a vein turns the other way", at_least=0, at_most=math.pi)
    damping: float = quantity(HINGE_DAMPING, "viscous damping of every hinge", at_least=0)
    armature: float = quantity(INERTIA, "inertia added to every hinge", at_least=0)


class Tendon(Part):
    """The elastic patch across each distal hinge."""

    stiffness: float = quantity(STIFFNESS, "force by extension beyond the resting length", at_least=0)
    rest_length: float = quantity(LENGTH, "length below which it does not pull", at_least=0)
    damping: float = quantity(TENDON_DAMPING, "viscous damping, which works at any length, slack or taut", at_least=0)
    proximal_attachment: float = quantity(LENGTH, "distance of its end on the proximal bar from the ring fold", above=0)
    distal_attachment: float = quantity(LENGTH, "distance of its end on the distal bar from the ring fold", above=0)
    area: float | None = quantity(AREA, "cross-section; only with a law", default=None, above=0)
    law: Annotated[
        Law | None,
        Field(description="a material, or a law file, from which stiffness and damping follow", examples=["tpu-82a"]),
    ] = None

    @model_validator(mode="after")
    def _fits_its_law(self) -> Tendon:
        if self.law is None and self.area is not None:
            raise InputError(
                "tendon.area: needs tendon.law, which gives force by area; give a law, too, or tendon.stiffness instead"
            )
        if self.law is not None and self.area is None:
            raise InputError(
                f'tendon.area: is missing; tendon.law gives force by area, so give one such as "{AREA.example}"'
            )
        if self.law is not None and self.rest_length == 0:
            raise InputError(
                "tendon.rest_length: need > 0 with tendon.law, for strain is extension by resting length, got 0 cm"
            )
        return self


class Guard(Part):
    """The unstressed length limits between neighbouring tips."""

    stretch: Annotated[
        float, Field(strict=True, ge=1, description="largest distance between neighbouring tips, by the flat one")
    ]


class Stage(Part):
    """A part of the protocol: what drives the wing, and when it ends."""

    name: Annotated[str, Field(min_length=1, description="what figures and tables call it")]
    drive: Annotated[Literal["none", "fold", "unfold"], Field(description="which torque acts")]
    until: Annotated[Literal["time", "rest", "folded", "opened"], Field(description="goal that ends it")]
    hold: float = quantity(TIME, "how long the goal must hold before the stage ends", at_least=0)
    time_limit: float = quantity(TIME, "longest duration", above=0)

    @field_validator("name")
    @classmethod
    def _on_one_line(cls, name: str) -> str:
        return shown_name(name)


class Protocol(Part):
    """What is done to the wing, and what counts as done."""

    timestep: float | Literal["auto"] = quantity(
        SHORT_TIME,
        'step of the integrator, or "auto": halved until verdict and times stay, and the energy balance closes',
        above=0,
        words=("auto",),
    )
    sample_interval: float = quantity(SHORT_TIME, "time between two rows of the record", above=0)
    fold_torque: float = quantity(TORQUE, "torque on every proximal turn axis while folding", at_least=0)
    unfold_torque: float = quantity(TORQUE, "torque on every distal and proximal axis while unfolding", at_least=0)
    rise: float = quantity(TIME, "time over which torques rise evenly from 0; 0: at once", default=0.0, at_least=0)
    initial_overbend: float = quantity(ANGLE, "where every distal hinge starts, past straight")
    folded_angle: float = quantity(ANGLE, "folded means that every distal hinge is beyond it", above=0, at_most=math.pi)
    opened_angle: float = quantity(ANGLE, "opened means that every distal hinge is at or past it, on the overbend side")
    rest_speed: float = quantity(ANGULAR_SPEED, "at rest means that every hinge is slower", above=0)
    window: float = quantity(
        TIME,
        "over which a state is averaged; a wing that rests so long short of its goal, and three times as long as its"
        " tendons' Maxwell branches take to relax, is stuck",
        above=0,
    )
    least_hold: Annotated[
        float,
        Field(
            strict=True,
            ge=0,
            description="how long folded or opened must hold at least, by the time that it took; less is a bounce",
        ),
    ] = 0.25
    residual_limit: Annotated[
        float,
        Field(
            strict=True,
            gt=0,
            le=1,
            description="largest share of the energy that was exchanged that may be missing in a run to be trusted",
        ),
    ] = 0.005
    gravity: float = quantity(ACCELERATION, "gravity across the wing, downwards where it lies flat; 0 switches it off")
    contact: Annotated[bool, Field(strict=True, description="whether bars touch each other")]
    stages: Annotated[tuple[Stage, ...], Field(min_length=1, description="what happens, in order")]

    @model_validator(mode="after")
    def _stages_in_order(self) -> Protocol:
        drives = [stage.drive for stage in self.stages]
        for drive in ("fold", "unfold"):
            if drives.count(drive) > 1:
                raise InputError(
                    f'protocol.stages: need at most one stage with drive = "{drive}", got {drives.count(drive)}'
                )
        if "unfold" in drives and "fold" not in drives[: drives.index("unfold")]:
            raise InputError(
                'protocol.stages: need a stage with drive = "fold" before the one with drive = "unfold",'
                f" got {as_written(drives)}"
            )
        if drives[0] != "none":
            raise InputError(
                'protocol.stages: need a first stage with drive = "none", whose end is the flat state,'
                f' got "{drives[0]}"'
            )
        return self


class Design(Part):
    """The thing to build and what is done to it; every number in SI and radians."""

    name: Annotated[str, Field(min_length=1, description="what outputs call it")]
    source: Annotated[str, Field(description="where its values come from")]
    reproduces: Annotated[str | None, Field(description="the paper that its figures are set beside")] = None
    pattern: Pattern
    vein: Vein
    membrane: Membrane
    hinge: Hinge
    tendon: Tendon
    guard: Guard
    protocol: Protocol

    @field_validator("name")
    @classmethod
    def _names_a_folder(cls, name: str) -> str:
        return folder_name(name)

    @model_validator(mode="after")
    def _fits_together(self) -> Design:
        apart, width = float(vein_gaps(self.fan, np.ones(1))[0]), _ring_chord(self.fan)
        margin = self.membrane.margin
        for key, value, bound, unit, fault in (
            ("vein.diameter", self.vein.diameter, apart, SMALL_LENGTH, "the veins overlap at the ring fold"),
            ("membrane.margin", margin, width, LENGTH, "the margin is wider than the panel at the ring fold"),
        ):
            if not value < bound:
                raise InputError(
                    f"{key}: {fault}: need < {show_quantity(bound, unit)}, from vein to vein,"
                    f" got {show_quantity(value, unit)}"
                )
        for end, length in (("proximal", self.pattern.proximal_length), ("distal", self.pattern.distal_length)):
            attachment = getattr(self.tendon, f"{end}_attachment")
            if attachment > length:
                raise InputError(
                    f"tendon.{end}_attachment: lies beyond the bar: need <= pattern.{end}_length,"
                    f" {show_quantity(length, LENGTH)}, got {show_quantity(attachment, LENGTH)}"
                )
        for key, rows in (("proximal_rows", self.membrane.proximal_rows), ("distal_rows", self.membrane.distal_rows)):
            if list(rows) != sorted({row for row in rows if 0 < row < 1}):
                raise InputError(f"membrane.{key}: need rising shares between 0 and 1, got {list(rows)}")
        self._goals_within_stops()
        self._start_within_guards()
        self._not_too_long()
        return self

    def _goals_within_stops(self) -> None:
        """Refuse a start or a goal that the stops of the distal hinges keep a wing from."""
        folds, bends, protocol = self.hinge.fold_limit, self.hinge.overbend, self.protocol
        for key, angle, least, most, stop in (
            ("initial_overbend", protocol.initial_overbend, -folds, bends, "overbend"),
            ("folded_angle", protocol.folded_angle, 0.0, folds, "fold_limit"),
            ("opened_angle", protocol.opened_angle, -folds, bends, "overbend"),
        ):
            if not least <= angle <= most:
                above = f">= {show_quantity(least, ANGLE)} (-hinge.fold_limit) and " if least else ""
                raise InputError(
                    f"protocol.{key}: need {above}<= {show_quantity(most, ANGLE)} (hinge.{stop}),"
                    f" got {show_quantity(angle, ANGLE)}"
                )

    def _start_within_guards(self) -> None:
        """Refuse a start that guard tendons are too short for: they would throw the wing, harder at a shorter step."""
        start, allowed = self.protocol.initial_overbend, self.guard.stretch
        stretch = start_stretch(self.fan, start)
        if stretch > allowed:
            most = f"{'<=' if start > 0 else '>='} {show_quantity(largest_start(self.fan, allowed, start), ANGLE)}"
            raise InputError(
                f"protocol.initial_overbend: neighbouring tips would start {stretch:.4g} times as far apart as in the"
                f" flat wing, and guard.stretch allows {allowed:.4g}: need {most} or a larger guard.stretch,"
                f" got {show_quantity(start, ANGLE)}"
            )

    def _not_too_long(self) -> None:
        """Refuse a run of more steps than anyone waits for, and a record of more rows than memory holds."""
        protocol, longest = self.protocol, sum(stage.time_limit for stage in self.protocol.stages)
        timestep = 0.0 if protocol.timestep == "auto" else protocol.timestep
        least = longest / _MOST_STEPS
        if timestep and not least <= timestep <= longest:
            raise InputError(
                f"protocol.timestep: need >= {show_quantity(least, SHORT_TIME)} and <= {show_quantity(longest, TIME)},"
                f" so that all stages together, {show_quantity(longest, TIME)} at most, take 1 to {_MOST_STEPS:g}"
                f" steps, got {show_quantity(timestep, SHORT_TIME)}"
            )
        shortest = self.shortest_sample_interval
        if max(timestep, protocol.sample_interval) < shortest:
            raise InputError(
                f"protocol.sample_interval: need >= {show_quantity(shortest, SHORT_TIME)}, so that the record of"
                f" {self.fan.vein_count} veins over {show_quantity(longest, TIME)} at most fits into memory,"
                f" got {show_quantity(protocol.sample_interval, SHORT_TIME)}"
            )

    @property
    def shortest_sample_interval(self) -> float:
        """The least time between two rows, s, at which the longest record that there can be fits into memory."""
        # wings of more are drawn, but not run
        veins = min(self.fan.vein_count, _MOST_VEINS)
        return sum(stage.time_limit for stage in self.protocol.stages) * veins / _MOST_ROWS

    @property
    def fan(self) -> EarwigFan:
        """The crease pattern's construction."""
        chosen = self.pattern
        return EarwigFan(
            proximal_length=chosen.proximal_length,
            distal_length=chosen.distal_length,
            hub_radius=chosen.hub_radius,
            sector_angle=chosen.sector_angle,
            units=chosen.units,
            tangent=chosen.tangent,
        )

    @property
    def hash(self) -> str:
        """Sixteen hexadecimal digits that name the values, whatever the design or its material is called."""
        nameless: Any = {"name": True, "source": True, "reproduces": True, "tendon": {"law": {"name"}}}
        values = self.model_dump(mode="json", exclude=nameless, exclude_none=True)
        return hashlib.sha256(json.dumps(values, sort_keys=True).encode()).hexdigest()[:16]


def _ring_chord(fan: EarwigFan) -> float:
    first, second = ring_vertices(fan)[:2]
    return math.dist(first, second)
