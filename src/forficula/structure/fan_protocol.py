"""What a fan's protocol does: its drives, and where they act."""

from __future__ import annotations

import math
from dataclasses import replace

from forficula.design import FanDesign
from forficula.names import listed
from forficula.structure.course import Drive, Motor
from forficula.structure.fold_course import with_course, with_distal_angle
from forficula.structure.goals import hinges_of
from forficula.structure.structure import Structure

# keys that matter to where a fan rests beside those of its tendons
_STATIC_KEYS = (
    "pattern",
    "membrane",
    "hinge",
    "coupling",
    "guard",
    "protocol.initial_overbend",
    "protocol.folded_angle",
    "protocol.opened_angle",
    "protocol.gravity",
    "protocol.driven_veins",
)


def with_protocol(structure: Structure, design: FanDesign) -> Structure:
    """A fan with the drives, goals, states and transitions of a design's protocol."""
    protocol = design.protocol
    turns, folds = (hinges_of(structure, role) for role in ("turn", "ring"))
    # bodies of every vein are one more than its ring folds, whose angles add up to the distal one
    shared = design.pattern.ring_folds
    driven = tuple(number for number in turns if structure.hinges[number].body // (shared + 1) in design.driven_veins)
    speed = protocol.no_load_speed or math.inf
    structure = replace(
        with_distal_angle(structure, shared),
        motors=(
            Motor(name="proximal", hinges=driven, no_load_speed=speed),
            Motor(name="distal", hinges=folds, no_load_speed=speed),
        ),
        drives=(
            Drive(
                name="fold",
                shares=(1.0, 0.0),
                rise=protocol.rise,
                key="protocol.fold_torque",
                strength=protocol.fold_torque,
                tries="0..50 N cm step 10",
                where=_on_proximal(design, "on every proximal joint"),
                part="proximal turn axis" if len(driven) == len(turns) else "driven proximal turn axis",
            ),
            Drive(
                name="unfold",
                shares=(-1.0, 1.0),
                rise=protocol.rise,
                key="protocol.unfold_torque",
                strength=protocol.unfold_torque,
                tries="10..100 N cm step 10",
                where=_on_proximal(design, "on every joint", "on every distal joint and "),
            ),
        ),
    )
    return with_course(structure, design)


def _on_proximal(design: FanDesign, every: str, others: str = "") -> str:
    """What torques act on: every joint, or, where not every vein has a motor, the others and those that have."""
    veins = design.driven_veins
    if len(veins) == design.fan.vein_count:
        return every
    joints, of = ("the proximal joint", "vein") if len(veins) == 1 else ("the proximal joints", "veins")
    on = f"{joints} of {of} {listed(map(str, veins))}"
    return f"{others}{on}" if others else f"on {on}"


def drive_keys(design: FanDesign) -> tuple[str, ...]:  # noqa: ARG001
    """Keys of the values that say how strong the drives are."""
    return ("protocol.fold_torque", "protocol.unfold_torque")


def static_keys(design: FanDesign) -> tuple[str, ...]:
    """Keys of what matters to where the fan rests, but for its tendons: those of one layout have it in common."""
    # without gravity it rests where it rests, however heavy it is
    return (*_STATIC_KEYS, "vein") if design.protocol.gravity else _STATIC_KEYS
