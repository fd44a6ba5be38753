"""Designs of fans: sections, protocol, and checks that the values fit together."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import lru_cache
from itertools import pairwise
from typing import Annotated, Any, ClassVar, Self

import numpy as np
import scipy
from pydantic import Discriminator, Field, Tag, field_validator, model_validator

from forficula.design.contact import WITHOUT_CONTACT, ContactSection, with_time_constant
from forficula.design.design import Design, check_duration
from forficula.design.fans.fan_sections import (
    CouplingSection,
    FanPatternSection,
    GuardSection,
    HingeSection,
    MembraneSection,
    VeinSection,
)
from forficula.design.fans.folding import (
    REST_KEYS,
    check_angles,
    check_folding_stages,
    folding_protocol,
    other_start,
    torque_drive,
)
from forficula.design.files.tendon_tables import is_by_vein
from forficula.design.medium import check_medium
from forficula.design.named_protocol import Action, NamedProtocol
from forficula.design.protocol import Protocol, check_bounds
from forficula.design.section import ANGLE, ANGULAR_SPEED, LENGTH, SMALL_LENGTH, TORQUE, quantity
from forficula.design.tendon import TendonSection, check_on_bars
from forficula.errors import InputError
from forficula.names import listed
from forficula.pattern import EarwigFan, ring_directions, ring_vertices, tips, vein_gaps
from forficula.quantities import Unit, format_quantity, show_quantity

_MOST_VEINS = 1001


_MEASURES: dict[str, Unit] = dict.fromkeys(("ring", "turn", "lift", "sweep", "distal_angle"), ANGLE)


class FanProtocol(Protocol):
    """The stages in which the wing is driven, and the criteria by which a run is judged."""

    about: ClassVar[str] = "The stages in which the wing is driven, and the criteria by which a run is judged"

    fold_torque: float = quantity(TORQUE, "torque on every driven proximal turn axis while folding", at_least=0)
    unfold_torque: float = quantity(
        TORQUE, "torque on every distal hinge and every driven proximal turn axis while unfolding", at_least=0
    )
    driven_veins: Annotated[
        tuple[Annotated[int, Field(strict=True, ge=0)], ...] | None,
        Field(
            min_length=1,
            description="numbers of the veins with a motor on their proximal turn axes; all if not given",
            examples=[[0]],
        ),
    ] = None
    no_load_speed: float | None = quantity(
        ANGULAR_SPEED,
        "speed of a driven hinge at which its torque has fallen to 0, as in a servo; fold_torque and unfold_torque are"
        " the stall torques; if not given, torques are constant",
        default=None,
        above=0,
        examples=["300 deg/s"],
    )
    initial_overbend: float = quantity(ANGLE, "initial angle of every distal hinge, past straight")
    folded_angle: float = quantity(
        ANGLE,
        "fold angle that every distal hinge must exceed for the wing to count as folded",
        above=0,
        at_most=math.pi,
    )
    opened_angle: float = quantity(
        ANGLE,
        "least angle of every distal hinge, positive towards the overbend, with which the wing counts as opened",
    )

    @model_validator(mode="after")
    def _stages_in_order(self) -> FanProtocol:
        check_folding_stages(self, _MEASURES, whole="a wing")
        return self


class FanDesign(Design):
    """A fan of bars with membranes between them, and its protocol."""

    varied_key: ClassVar[str] = "tendon.stiffness"
    papers: ClassVar[Mapping[str, str]] = {
        "binder2025": "fan, tendons and protocol",
        "saito2020": "the crease pattern that the fan simplifies",
    }
    reference: ClassVar[str | None] = "binder2025"
    weight_sections: ClassVar[tuple[str, ...]] = ("vein",)
    rest_keys: ClassVar[tuple[str, ...]] = (
        "pattern",
        "membrane",
        "hinge",
        "coupling",
        "guard",
        *REST_KEYS,
        "protocol.driven_veins",
    )

    pattern: FanPatternSection
    vein: VeinSection
    membrane: MembraneSection
    hinge: HingeSection
    coupling: Annotated[
        CouplingSection | None, Field(description="coupling of neighbouring veins at the base; none if not given")
    ] = None
    tendon: Annotated[
        Annotated[TendonSection, Tag("<one for all>")] | Annotated[tuple[TendonSection | None, ...], Tag("<by vein>")],
        Discriminator(lambda value: "<by vein>" if isinstance(value, tuple) else "<one for all>"),
        Field(description="one tendon for all veins, or tendons by the number of the vein, None for a vein without"),
    ]
    guard: GuardSection
    contact: Annotated[
        ContactSection | None, Field(description="contact of panels and bars, if protocol.contact is true")
    ] = None
    protocol: FanProtocol

    @field_validator("tendon", mode="before")
    @classmethod
    def _by_vein(cls, tendons: object) -> object:
        """Convert tables by the numbers of their veins to a tuple in the order of the veins."""
        if not is_by_vein(tendons):
            return tendons
        return tuple(tendons.get(str(vein)) for vein in range(max(map(int, tendons), default=-1) + 1))

    @model_validator(mode="after")
    def _fits_together(self) -> FanDesign:
        self._layers_have_room()
        gap, width = _gaps_at_ring(self.fan)
        thickness = None if self.contact is None else self.contact.thickness
        for key, value, bound, unit, fault in (
            ("vein.diameter", self.vein.diameter, gap, SMALL_LENGTH, "the veins overlap at the ring fold"),
            (
                "membrane.margin",
                self.membrane.margin,
                width,
                LENGTH,
                "the margin is wider than the panel at the ring fold",
            ),
            (
                "contact.thickness",
                thickness,
                width,
                LENGTH,
                "panels would be thicker than they are wide at the ring fold",
            ),
        ):
            if value is not None and not value < bound:
                raise InputError(
                    f"{key}: {fault}: need < {show_quantity(bound, unit)}, from vein to vein,"
                    f" got {show_quantity(value, unit)}"
                )
        check_medium(self.medium, self.protocol.gravity, self.vein.density, "vein.density")
        self._tendons_on_bars()
        self._driven_veins_exist()
        for key, rows in (("proximal_rows", self.membrane.proximal_rows), ("distal_rows", self.membrane.distal_rows)):
            if list(rows) != sorted({row for row in rows if 0 < row < 1}):
                raise InputError(f"membrane.{key}: need rising shares between 0 and 1, got {list(rows)}")
        self._goals_within_stops()
        self._start_within_guards()
        # larger wings can be drawn, but not run
        check_duration(self, min(self.fan.vein_count, _MOST_VEINS), "veins")
        return self

    def _layers_have_room(self) -> None:
        """Refuse folded layers whose distance is smaller than the thickness of their veins and membranes."""
        pitch, least = self.pattern.pitch, self._least_pitch
        if pitch is not None and pitch < least:
            raise InputError(
                f"pattern.pitch: folded layers overlap: need >= {show_quantity(least, SMALL_LENGTH)}, the larger of"
                f" vein.diameter and twice {self._layer[0]}, got {show_quantity(pitch, SMALL_LENGTH)}"
            )

    @property
    def _least_pitch(self) -> float:
        """Least distance between two folded layers, m: the larger of a vein's diameter and two membranes."""
        return max(self.vein.diameter, 2 * self._layer[1])

    @property
    def _layer(self) -> tuple[str, float]:
        """Key and value of the distance between the mid-planes of touching panels, m."""
        if self.contact is not None and self.contact.thickness is not None:
            return "contact.thickness", self.contact.thickness
        return "membrane.thickness", self.membrane.thickness

    def _tendons_on_bars(self) -> None:
        """Refuse tendons on veins that do not exist, and tendons that do not end on their bars."""
        last, lengths = self.fan.vein_count - 1, self.bar_lengths
        if isinstance(self.tendon, TendonSection):
            check_on_bars("tendon", self.tendon, *map(min, zip(*lengths, strict=True)))
            return
        for vein, tendon in enumerate(self.tendon):
            if tendon is not None and vein > last:
                raise InputError(
                    f"tendon.{vein}: there is no vein {vein}: need 0 to {last} with pattern.units ="
                    f" {self.pattern.units}"
                )
            if tendon is not None:
                check_on_bars(f"tendon.{vein}", tendon, *lengths[vein])

    def _driven_veins_exist(self) -> None:
        """Refuse motors on veins that do not exist, and two motors on one vein."""
        driven, last = self.protocol.driven_veins or (), self.fan.vein_count - 1
        if len(set(driven)) < len(driven) or max(driven, default=0) > last:
            raise InputError(
                f"protocol.driven_veins: need different numbers of veins, 0 to {last} with pattern.units ="
                f" {self.pattern.units}, got {list(driven)}"
            )

    def with_other_start(self) -> Self | None:
        """Return the design with a start that differs by 1 %; see `Design.with_other_start`."""
        return self.model_copy(update={"protocol": other_start(self.protocol, self.protocol.initial_overbend)})

    @property
    def measure_units(self) -> dict[str, Unit]:
        """Names of measures and of roles of hinges that a bound may have, with their units."""
        return _MEASURES

    @property
    def named_protocol(self) -> NamedProtocol:
        """Torques about the axes of the driven veins, and about all ring folds."""
        protocol, veins = self.protocol, self.driven_veins
        every = len(veins) == self.fan.vein_count
        joints, of = ("the proximal joint", "vein") if len(veins) == 1 else ("the proximal joints", "veins")
        driven = f"{joints} of {of} {listed(map(str, veins))}"
        speed = protocol.no_load_speed or math.inf
        proximal = Action(motor="proximal", hinges=tuple(f"turn{vein}" for vein in veins), no_load_speed=speed)
        distal = Action(motor="distal", hinges=("ring",), no_load_speed=speed)
        where = "on every proximal joint" if every else f"on {driven}"
        part = "proximal turn axis" if every else "driven proximal turn axis"
        fold = torque_drive(protocol, "fold", (proximal,), tries="0..50 N cm step 10", where=where, part=part)
        where = "on every joint" if every else f"on every distal joint and {driven}"
        both = (replace(proximal, share=-1.0), distal)
        unfold = torque_drive(protocol, "unfold", both, tries="10..100 N cm step 10", where=where)
        return folding_protocol(protocol, (fold, unfold))

    def _goals_within_stops(self) -> None:
        """Refuse a start or a goal that the stops of the distal hinges make unreachable."""
        folds, bends, protocol = self.hinge.fold_limit, self.hinge.overbend, self.protocol
        check_angles(protocol, fold_limit=folds, overbend=bends)
        shared = self.pattern.ring_folds
        stops = {"ring": (-folds / shared, bends / shared), "distal_angle": (-folds, bends)}
        stops["turn"] = (-self.hinge.turn_back, self.hinge.turn_limit)
        check_bounds(protocol, stops)

    def _start_within_guards(self) -> None:
        """Refuse a start that stretches the guard tendons, which would throw the wing, harder at a shorter timestep."""
        start, allowed = self.protocol.initial_overbend, self.guard.stretch
        stretch = start_stretch(self.fan, start)
        if stretch > allowed:
            most = f"{'<=' if start > 0 else '>='} {show_quantity(largest_start(self.fan, allowed, start), ANGLE)}"
            raise InputError(
                f"protocol.initial_overbend: neighbouring tips would start {stretch:.4g} times as far apart as in the"
                f" flat wing, and guard.stretch allows {allowed:.4g}: need {most} or a larger guard.stretch,"
                f" got {show_quantity(start, ANGLE)}"
            )

    def as_tables(self, write: Callable[[float, Unit], object] = format_quantity) -> dict[str, Any]:
        """Return the design as tables; tendons that differ are tables by the numbers of their veins."""
        tables = super().as_tables(write)
        if isinstance(self.tendon, tuple):
            tables["tendon"] = {str(vein): entry for vein, entry in enumerate(tables["tendon"]) if entry is not None}
        return tables

    def settled(self) -> Self:
        """Return the design with the section of contact filled in where it acts, so that other units apply to it."""
        return self.model_copy(update={"contact": ContactSection()}) if self._default_contact else self

    def with_contact_time(self, time_constant: float) -> Self:
        """Return the design with a time constant of contact, s, where it is "auto"; the same design where it is not."""
        section = self.settled().contact if self.protocol.contact else None
        if section is None or (changed := with_time_constant(section, time_constant)) is section:
            return self
        return self.model_copy(update={"contact": changed})

    @property
    def _default_contact(self) -> bool:
        return self.protocol.contact and self.contact is None

    def hash_values(self) -> dict[str, Any]:
        """Return the values that enter the hash; a list of identical tendons counts as one table."""
        values = super(FanDesign, self.settled()).hash_values()
        if isinstance(self.tendon, tuple):
            by_vein = [None if tendon is None else tendon.hash_values() for tendon in self.tendons]
            identical = by_vein[0] is not None and all(tendon == by_vein[0] for tendon in by_vein)
            values["tendon"] = by_vein[0] if identical else by_vein
        return values

    @property
    def idle(self) -> tuple[str, ...]:
        """Sentences about given values that have no effect."""
        without = self.contact is not None and not self.protocol.contact
        return (*super().idle, *[WITHOUT_CONTACT] * without)

    @property
    def driven_veins(self) -> tuple[int, ...]:
        """Numbers of the veins with a motor at the base, in ascending order."""
        driven = self.protocol.driven_veins
        return tuple(range(self.fan.vein_count) if driven is None else sorted(driven))

    @property
    def tendons(self) -> tuple[TendonSection | None, ...]:
        """The tendon of every vein, (vein,); None for a vein without a tendon."""
        count = self.fan.vein_count
        if isinstance(self.tendon, TendonSection):
            return (self.tendon,) * count
        return (*self.tendon, *[None] * (count - len(self.tendon)))

    @property
    def bar_lengths(self) -> tuple[tuple[float, float], ...]:
        """Lengths of every vein up to the ring fold and beyond it, m, (vein, 2)."""
        return tuple(zip(self.fan.proximal_lengths, self.fan.distal_lengths, strict=True))

    @property
    def fan(self) -> EarwigFan:
        """The construction of the crease pattern."""
        two = self.pattern.ring_folds == 2
        # a vein and a panel lie between the innermost layers
        gusset_height = self.vein.diameter + self._layer[1] if two else 0.0
        return _drawn_fan(self.pattern, (self.pattern.pitch or self._least_pitch) if two else 0.0, gusset_height)


@lru_cache(maxsize=64)  # called repeatedly while a wing is checked and built, and while other values change
def _drawn_fan(section: FanPatternSection, pitch: float, gusset_height: float) -> EarwigFan:
    return EarwigFan(
        proximal_length=section.proximal_length,
        distal_length=section.distal_length,
        hub_radius=section.hub_radius,
        sector_angle=section.sector_angle,
        units=section.units,
        tangent=section.tangent,
        ring_folds=section.ring_folds,
        pitch=pitch,
        gusset_height=gusset_height,
        proximal_shares=section.proximal_shares or (),
        distal_shares=section.distal_shares or (),
        hub_shares=section.hub_shares or (),
        sector_shares=section.sector_shares or (),
    )


@lru_cache(maxsize=64)
def _gaps_at_ring(fan: EarwigFan) -> tuple[float, float]:
    """Return the least distances from vein to vein at the ring fold, m: between their axes, and along the ring."""
    ring = ring_vertices(fan)
    pairs = list(pairwise(ring))[: None if fan.varied else 1]
    return float(vein_gaps(fan, np.ones(1))[0]), min(math.dist(first, second) for first, second in pairs)


@lru_cache(maxsize=64)  # most designs derived from one design have the same start
def start_stretch(fan: EarwigFan, overbend: float) -> float:
    """Compute the distance between neighbouring tips, with all distal hinges bent past straight, over that when flat.

    Neighbouring veins bend to opposite sides of the sheet, equally at each of their ring folds.

    Args:
        fan: the crease pattern.
        overbend: angle of every distal hinge past straight, rad.

    Returns:
        The largest ratio of all pairs.
    """
    flat = bent = tips(fan)
    # odd veins are valleys, as `earwig_pattern` has them
    senses = (-1.0) ** (np.arange(len(flat)) + 1)
    for fold in reversed(range(fan.ring_folds)):
        turned = scipy.spatial.transform.Rotation.from_rotvec(
            overbend / fan.ring_folds * senses[:, None] * ring_directions(fan)
        )
        ring = ring_vertices(fan, fold=fold)
        bent = ring + turned.apply(bent - ring)
    distances = (np.linalg.norm(np.diff(points, axis=0), axis=1) for points in (bent, flat))
    return float(np.max(next(distances) / next(distances)))


def largest_start(fan: EarwigFan, stretch: float, bend: float) -> float:
    """Compute the largest initial bend, rad, at which no tips are further apart than `stretch` times as when flat.

    Args:
        fan: the crease pattern.
        stretch: allowed distance between neighbouring tips, divided by the flat one.
        bend: an angle of the distal hinges at which the distance is larger, rad.
    """
    share = scipy.optimize.brentq(lambda share: start_stretch(fan, share * bend) - stretch, 0.0, 1.0, xtol=1e-6)
    return float(share * bend)
