"""A fan: its sections, its protocol, and what must fit together."""

from __future__ import annotations

import math
from typing import Annotated, Literal

import numpy as np
from pydantic import Field, model_validator

from forficula.design.design import Design, check_duration
from forficula.design.law import AREA, Law
from forficula.design.part import (
    ANGLE,
    DENSITY,
    HINGE_DAMPING,
    INERTIA,
    LENGTH,
    MODULUS,
    SHORT_TIME,
    SMALL_LENGTH,
    STIFFNESS,
    TENDON_DAMPING,
    TORQUE,
    Part,
    quantity,
)
from forficula.design.protocol import Protocol, check_stages, check_states, stage_drives
from forficula.design.start import largest_start, start_stretch
from forficula.errors import InputError
from forficula.pattern import EarwigFan, ring_vertices, vein_gaps
from forficula.quantities import as_written, show_quantity

# beyond atoms and worlds, m: within, every power that a unit has of a length is a float
_SMALLEST, _LARGEST = 1e-12, 1e12
_MOST_VEINS = 1001
DRIVES, GOALS, STATES = ("fold", "unfold"), ("folded", "opened"), ("flat", "folded", "opened")


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


class FanProtocol(Protocol):
    """What is done to the wing, and what counts as done."""

    fold_torque: float = quantity(TORQUE, "torque on every proximal turn axis while folding", at_least=0)
    unfold_torque: float = quantity(TORQUE, "torque on every distal and proximal axis while unfolding", at_least=0)
    initial_overbend: float = quantity(ANGLE, "where every distal hinge starts, past straight")
    folded_angle: float = quantity(ANGLE, "folded means that every distal hinge is beyond it", above=0, at_most=math.pi)
    opened_angle: float = quantity(ANGLE, "opened means that every distal hinge is at or past it, on the overbend side")

    @model_validator(mode="after")
    def _stages_in_order(self) -> FanProtocol:
        check_stages(self, DRIVES, GOALS, dict.fromkeys(("ring", "turn", "lift", "sweep", "distal_angle"), ANGLE))
        check_states(self, STATES)
        drives = [stage_drives(stage) for stage in self.stages]
        fold, unfold = ([number for number, each in enumerate(drives) if drive in each] for drive in DRIVES)
        for drive, driven in zip(DRIVES, (fold, unfold), strict=True):
            if len(driven) > 1:
                raise InputError(f'protocol.stages: need at most one stage with drive = "{drive}", got {len(driven)}')
        written = [stage.drive for stage in self.stages]
        if unfold and not (fold and fold[0] < unfold[0]):
            raise InputError(
                'protocol.stages: need a stage with drive = "fold" before the one with drive = "unfold",'
                f" got {as_written(written)}"
            )
        if drives[0]:
            raise InputError(
                'protocol.stages: need a first stage with drive = "none", whose end is the flat state,'
                f" got {as_written(written[0])}"
            )
        return self


class FanDesign(Design):
    """A fan of bars with membranes between them, and what is done to it."""

    pattern: Pattern
    vein: Vein
    membrane: Membrane
    hinge: Hinge
    tendon: Tendon
    guard: Guard
    protocol: FanProtocol

    @model_validator(mode="after")
    def _fits_together(self) -> FanDesign:
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
        # wings of more are drawn, but not run
        check_duration(self, min(self.fan.vein_count, _MOST_VEINS), "veins")
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


def _ring_chord(fan: EarwigFan) -> float:
    first, second = ring_vertices(fan)[:2]
    return math.dist(first, second)
