"""What a fan's protocol does: its drives, goals, states and transitions, and the words for them."""

from __future__ import annotations

import math
from dataclasses import replace

from forficula.design import FanDesign, FanProtocol, stage_drives
from forficula.names import listed
from forficula.structure.course import Drive, Measure, Motor, RestState, Transition, Wording
from forficula.structure.goals import bounded, hinges_of
from forficula.structure.structure import Structure

# how far past straight, folding, a hinge has left the overbend for good
LEFT_STRAIGHT = math.radians(5.0)
_FOLD = Wording(
    done="folded",
    verb="fold",
    doing="folding",
    stays="folded",
    time="fold time",
    noun="folding",
    did="folded",
    if_stuck=(
        "Raise protocol.fold_torque, or lower the barrier: softer or longer tendons (tendon.stiffness,"
        " tendon.rest_length), less hinge.overbend."
    ),
    if_under_way="Raise protocol.fold_torque, or take stiffer or shorter tendons, which pull further into the fold.",
    if_lost=(
        "It folded under torque and opened again when released: raise tendon.stiffness, shorten tendon.rest_length, or"
        " raise hinge.damping."
    ),
)
_UNFOLD = Wording(
    done="folded and opened",
    verb="open",
    doing="opening",
    stays="open",
    time="opening time",
    noun="unfolding",
    did="opened again",
    if_stuck="Raise protocol.unfold_torque, or take softer or longer tendons (tendon.stiffness, tendon.rest_length).",
    if_lost=(
        "It opened under torque and folded again when released: hold it longer (hold of the unfolding stage), or raise"
        " hinge.overbend or tendon.stiffness so that the open state locks."
    ),
)
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
    fold, unfold = protocol.fold_torque, protocol.unfold_torque

    measure = Measure(
        name="distal_angle", kind="angle", hinges=folds, signs=(1,) * len(folds), together=shared, label="distal angle"
    )
    structure = replace(structure, measures=(measure,))
    flat = bounded(structure, measure, "flat", least=-LEFT_STRAIGHT)
    folded = bounded(structure, measure, "folded", most=-protocol.folded_angle)
    opened = bounded(structure, measure, "opened", least=protocol.opened_angle)
    return replace(
        structure,
        motors=(Motor(name="proximal", hinges=driven), Motor(name="distal", hinges=folds)),
        drives=(
            Drive(
                name="fold",
                shares=(1.0, 0.0),
                rise=protocol.rise,
                key="protocol.fold_torque",
                strength=fold,
                tries="0..50 N cm step 10",
                large="500 N cm",
                where=_on_proximal(design, "on every proximal joint"),
                part="proximal turn axis" if len(driven) == len(turns) else "driven proximal turn axis",
            ),
            Drive(
                name="unfold",
                shares=(-1.0, 1.0),
                rise=protocol.rise,
                key="protocol.unfold_torque",
                strength=unfold,
                tries="10..100 N cm step 10",
                where=_on_proximal(design, "on every joint", "on every distal joint and "),
            ),
        ),
        goals=(folded, opened),
        states=(
            RestState(name="flat", bounds=flat, missed="not flat", unknown="not flat"),
            RestState(name="folded", bounds=folded, missed="not folded", unknown="after folding"),
            RestState(name="opened", bounds=opened, missed="not opened", unknown="after unfolding"),
        ),
        stage_states=_stage_states(protocol),
        transitions=(
            Transition(
                name="fold",
                drive="fold",
                stage=_first_driven(protocol, "fold"),
                goal="folded",
                state="folded",
                # a slack tendon lets its hinge rest anywhere on the folded side; one beyond half way has opened again
                released=bounded(structure, measure, "still folded", most=-protocol.folded_angle / 2),
                measure="distal_angle",
                furthest="largest",
                begun=-LEFT_STRAIGHT,
                wording=_in_terms_of(design, _FOLD),
            ),
            Transition(
                name="unfold",
                drive="unfold",
                stage=_first_driven(protocol, "unfold"),
                goal="opened",
                state="opened",
                released=opened,
                measure="distal_angle",
                # the distal hinges alone are what has to give
                slow_drive=Drive(
                    name="distal",
                    shares=(0.0, 1.0),
                    rise=protocol.rise,
                    key="protocol.unfold_torque",
                    strength=unfold,
                    part="distal hinge",
                ),
                furthest="largest",
                begun=None,
                wording=_in_terms_of(design, _UNFOLD),
            ),
        ),
    )


def _on_proximal(design: FanDesign, every: str, others: str = "") -> str:
    """What torques act on: every joint, or, where not every vein has a motor, the others and those that have."""
    veins = design.driven_veins
    if len(veins) == design.fan.vein_count:
        return every
    joints, of = ("the proximal joint", "vein") if len(veins) == 1 else ("the proximal joints", "veins")
    on = f"{joints} of {of} {listed(map(str, veins))}"
    return f"{others}{on}" if others else f"on {on}"


def _first_driven(protocol: FanProtocol, drive: str) -> int | None:
    """Number of the first stage with a drive."""
    return next((number for number, stage in enumerate(protocol.stages) if drive in stage_drives(stage)), None)


def _stage_states(protocol: FanProtocol) -> tuple[str, ...]:
    """What the stages say; where none does, the first ends flat, and folding and opening with their releases."""
    stages = protocol.stages
    if any(stage.state for stage in stages):
        return tuple(stage.state or "" for stage in stages)
    states = ["flat", *[""] * (len(stages) - 1)]
    for drive, state in (("fold", "folded"), ("unfold", "opened")):
        driven = _first_driven(protocol, drive)
        if driven is not None:
            released = driven + 1 < len(stages) and not stage_drives(stages[driven + 1])
            states[driven + released] = state
    return tuple(states)


def _in_terms_of(design: FanDesign, wording: Wording) -> Wording:
    """Advice that names what the design has: of a law the stiffness follows."""
    if any(tendon is not None and tendon.law is None for tendon in design.tendons):
        return wording
    advice = {name: getattr(wording, name) for name in ("if_stuck", "if_under_way", "if_lost")}
    return replace(wording, **{key: text.replace("tendon.stiffness", "tendon.area") for key, text in advice.items()})


def drive_keys(design: FanDesign) -> tuple[str, ...]:  # noqa: ARG001
    """Keys of the values that say how strong the drives are."""
    return ("protocol.fold_torque", "protocol.unfold_torque")


def static_keys(design: FanDesign) -> tuple[str, ...]:
    """Keys of what matters to where the fan rests, but for its tendons: those of one layout have it in common."""
    # without gravity it rests where it rests, however heavy it is
    return (*_STATIC_KEYS, "vein") if design.protocol.gravity else _STATIC_KEYS
