"""Designs of single joints: two bars with a hinge and a tendon across it; the proximal bar is held."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from typing import ClassVar, Self

from pydantic import model_validator

from forficula.design.design import Design, check_duration
from forficula.design.fans.fan_sections import VeinSection
from forficula.design.fans.folding import (
    REST_KEYS,
    check_angles,
    check_folding_stages,
    folding_protocol,
    other_start,
    torque_drive,
)
from forficula.design.fans.joint_sections import JointHinge, JointPattern, JointTendon
from forficula.design.named_protocol import Action, NamedProtocol
from forficula.design.protocol import Protocol, check_bounds
from forficula.design.section import ANGLE, ANGULAR_SPEED, SMALL_LENGTH, TORQUE, quantity
from forficula.design.tendon import TendonSection, check_on_bars
from forficula.errors import InputError
from forficula.quantities import Unit, show_quantity

_MEASURES: dict[str, Unit] = dict.fromkeys(("ring", "distal_angle"), ANGLE)


class JointProtocol(Protocol):
    """The stages in which the joint is driven, and the criteria by which a run is judged."""

    about: ClassVar[str] = "The stages in which the joint is driven, and the criteria by which a run is judged"

    fold_torque: float = quantity(TORQUE, "torque on the hinge while folding", at_least=0)
    unfold_torque: float = quantity(TORQUE, "torque on the hinge while unfolding", at_least=0)
    no_load_speed: float | None = quantity(
        ANGULAR_SPEED,
        "speed of the hinge at which its torque has fallen to 0, as in a servo; fold_torque and unfold_torque are the"
        " stall torques; if not given, torques are constant",
        default=None,
        above=0,
        examples=["300 deg/s"],
    )
    initial_overbend: float = quantity(ANGLE, "initial angle of the hinge, past straight")
    folded_angle: float = quantity(
        ANGLE, "angle beyond which the hinge must be for the joint to count as folded", above=0, at_most=math.pi
    )
    opened_angle: float = quantity(
        ANGLE, "least angle of the hinge, positive towards the overbend, with which the joint counts as opened"
    )

    @model_validator(mode="after")
    def _stages_in_order(self) -> JointProtocol:
        check_folding_stages(self, _MEASURES, whole="a joint")
        return self


class JointDesign(Design):
    """Two bars with a hinge and a tendon between them, and their protocol."""

    varied_key: ClassVar[str] = "tendon.rest_length"
    papers: ClassVar[Mapping[str, str]] = {"binder2025": "the joint and its tendon"}
    reference: ClassVar[str | None] = "binder2025-joint"
    weight_sections: ClassVar[tuple[str, ...]] = ("vein",)
    rest_keys: ClassVar[tuple[str, ...]] = ("pattern", "hinge", *REST_KEYS)

    pattern: JointPattern
    vein: VeinSection
    hinge: JointHinge
    tendon: JointTendon
    protocol: JointProtocol

    @model_validator(mode="after")
    def _fits_together(self) -> JointDesign:
        shorter = min(self.pattern.proximal_length, self.pattern.distal_length)
        if not self.vein.diameter < shorter:
            raise InputError(
                f"vein.diameter: need < {show_quantity(shorter, SMALL_LENGTH)}, the length of the shorter bar,"
                f" got {show_quantity(self.vein.diameter, SMALL_LENGTH)}"
            )
        check_on_bars("tendon", self.tendon, self.pattern.proximal_length, self.pattern.distal_length)
        if self.protocol.contact:
            raise InputError(
                "protocol.contact: need false, because only the stops of its hinge keep a joint's bars apart, got true"
            )
        self._goals_within_stops()
        check_duration(self, 1, "joint")
        return self

    def with_other_start(self) -> Self | None:
        """Return the design with a start that differs by 1 %; see `Design.with_other_start`."""
        return self.model_copy(update={"protocol": other_start(self.protocol, self.protocol.initial_overbend)})

    @property
    def measure_units(self) -> dict[str, Unit]:
        """Names of measures and of roles of hinges that a bound may have, with their units."""
        return _MEASURES

    @property
    def named_protocol(self) -> NamedProtocol:
        """Torques on the hinge."""
        protocol = self.protocol
        unfolding = Action(motor="distal", hinges=("ring",), no_load_speed=protocol.no_load_speed or math.inf)
        folding, where = replace(unfolding, share=-1.0), "on the hinge"
        fold = torque_drive(protocol, "fold", (folding,), tries="0..20 N cm step 2", where=where)
        unfold = torque_drive(protocol, "unfold", (unfolding,), tries="10..100 N cm step 10", where=where)
        return folding_protocol(protocol, (fold, unfold))

    def _goals_within_stops(self) -> None:
        """Refuse a start or a goal that the stops of the hinge make unreachable."""
        folds, bends, protocol = self.hinge.fold_limit, self.hinge.overbend, self.protocol
        check_angles(protocol, fold_limit=folds, overbend=bends)
        check_bounds(protocol, dict.fromkeys(("ring", "distal_angle"), (-folds, bends)))

    @property
    def idle(self) -> tuple[str, ...]:
        """Sentences about given values that have no effect."""
        without_panels = "medium.density and medium.viscosity have no effect, because a joint has no panels"
        return (*super().idle, *[without_panels] * (self.medium is not None))

    @property
    def bar_lengths(self) -> tuple[tuple[float, float], ...]:
        """Lengths of the bars before and beyond the hinge, m, (1, 2)."""
        return ((self.pattern.proximal_length, self.pattern.distal_length),)

    @property
    def tendons(self) -> tuple[TendonSection, ...]:
        """The tendons of all hinges; a joint has one hinge."""
        return (self.tendon,)
