"""A course that folds what bends at distal hinges and opens it again: goals, states, transitions and their words."""

from __future__ import annotations

import math
from dataclasses import replace

from forficula.design import FanDesign, JointDesign, Protocol, stage_drives
from forficula.structure.course import Measure, RestState, Transition, Wording
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
)
_UNFOLD = Wording(
    done="folded and opened",
    verb="open",
    doing="opening",
    stays="open",
    time="opening time",
    noun="unfolding",
    did="opened again",
)


def with_course(structure: Structure, design: FanDesign | JointDesign) -> Structure:
    """A structure with the goals, states and transitions of a design's protocol, whose drives are "fold" and "unfold".

    Args:
        structure: with its motors and drives; its measure "distal_angle" is all that is watched.
        design: with the protocol.
    """
    protocol, measure = design.protocol, structure.measures[0]
    flat = bounded(structure, measure, "flat", least=-LEFT_STRAIGHT)
    folded = bounded(structure, measure, "folded", most=-protocol.folded_angle)
    opened = bounded(structure, measure, "opened", least=protocol.opened_angle)
    return replace(
        structure,
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
                wording=_FOLD,
            ),
            Transition(
                name="unfold",
                drive="unfold",
                stage=_first_driven(protocol, "unfold"),
                goal="opened",
                state="opened",
                released=opened,
                measure="distal_angle",
                furthest="largest",
                begun=None,
                wording=_UNFOLD,
            ),
        ),
    )


def with_distal_angle(structure: Structure, together: int = 1) -> Structure:
    """A structure that watches the angles of its distal hinges, as one for so many neighbours together."""
    folds = hinges_of(structure, "ring")
    measure = Measure(
        name="distal_angle",
        kind="angle",
        hinges=folds,
        signs=(1,) * len(folds),
        together=together,
        label="distal angle",
    )
    return replace(structure, measures=(measure,))


def _first_driven(protocol: Protocol, drive: str) -> int | None:
    """Number of the first stage with a drive."""
    return next((number for number, stage in enumerate(protocol.stages) if drive in stage_drives(stage)), None)


def _stage_states(protocol: Protocol) -> tuple[str, ...]:
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
