"""The protocol that folds and opens distal hinges: names, transitions, and checks of stages and angles."""

from __future__ import annotations

import math
from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Literal, TypeVar

from forficula.design.named_protocol import Action, Drive, NamedProtocol, RestState, Transition, Wording
from forficula.design.protocol import Protocol, check_stages, check_states, stage_drives
from forficula.design.section import ANGLE
from forficula.errors import InputError
from forficula.quantities import Unit, as_written, format_quantity, show_quantity

if TYPE_CHECKING:
    from forficula.design.fans.fan import FanProtocol
    from forficula.design.fans.joint import JointProtocol

DRIVES, GOALS, STATES = ("fold", "unfold"), ("folded", "opened"), ("flat", "folded", "opened")

# keys of a protocol on which the rest states of a structure depend
REST_KEYS = (
    "protocol.initial_overbend",
    "protocol.folded_angle",
    "protocol.opened_angle",
    "protocol.gravity",
    "protocol.gravity_direction",
)
# rad, fold angle beyond which a hinge has left the overbend for good
_LEFT_STRAIGHT = math.radians(5.0)
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

_ProtocolOf = TypeVar("_ProtocolOf", bound=Protocol)


def torque_drive(
    protocol: FanProtocol | JointProtocol,
    name: Literal["fold", "unfold"],
    actions: tuple[Action, ...],
    *,
    tries: str,
    where: str,
    part: str = "",
) -> Drive:
    """Return the drive that folds or unfolds with the torque of the protocol, as data; see `Drive`."""
    strength = protocol.fold_torque if name == "fold" else protocol.unfold_torque
    key = f"protocol.{name}_torque"
    return Drive(
        name=name, actions=actions, rise=protocol.rise, key=key, strength=strength, tries=tries, where=where, part=part
    )


def folding_protocol(protocol: FanProtocol | JointProtocol, drives: Sequence[Drive]) -> NamedProtocol:
    """Return a protocol that folds and opens distal hinges as data.

    Args:
        protocol: protocol whose stages have been checked by `check_folding_stages`.
        drives: the drives "fold" and "unfold".
    """
    # with a slack tendon a hinge may rest at any angle on the folded side; beyond half way it has opened again
    still_folded = _distal("<", -protocol.folded_angle / 2)
    return NamedProtocol(
        drives=tuple(drives),
        goals={"folded": _distal("<", -protocol.folded_angle), "opened": _distal(">", protocol.opened_angle)},
        states=(
            RestState(name="flat", goal=_distal(">", -_LEFT_STRAIGHT), missed="not flat", unknown="not flat"),
            RestState(name="folded", goal="folded", missed="not folded", unknown="after folding"),
            RestState(name="opened", goal="opened", missed="not opened", unknown="after unfolding"),
        ),
        stage_states=_stage_states(protocol),
        transitions=(
            Transition(
                name="fold",
                drive="fold",
                stage=_first_driven(protocol, "fold"),
                goal="folded",
                state="folded",
                released=still_folded,
                measure="distal_angle",
                furthest="largest",
                begun=-_LEFT_STRAIGHT,
                wording=_FOLD,
            ),
            Transition(
                name="unfold",
                drive="unfold",
                stage=_first_driven(protocol, "unfold"),
                goal="opened",
                state="opened",
                released="opened",
                measure="distal_angle",
                furthest="largest",
                begun=None,
                wording=_UNFOLD,
            ),
        ),
    )


@lru_cache(maxsize=256)  # consecutive designs have few different bounds
def _distal(relation: str, angle: float) -> str:
    """Return a bound on the angles of the distal hinges, rad, as text that reads back exactly."""
    return f"distal_angle {relation} {format_quantity(angle, ANGLE)}"


def _first_driven(protocol: Protocol, drive: str) -> int | None:
    """Return the number of the first stage with a drive."""
    return next((number for number, stage in enumerate(protocol.stages) if drive in stage_drives(stage)), None)


def _stage_states(protocol: Protocol) -> tuple[str, ...]:
    """Return the state at the end of each stage, as the stages name it.

    Without names, the first stage ends in "flat", and the releases after folding and unfolding end in "folded" and
    "opened".
    """
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


def check_folding_stages(protocol: Protocol, measures: dict[str, Unit], *, whole: str) -> None:
    """Refuse stages in the wrong order: first a stage without drives, then at most one that folds and one that unfolds.

    Args:
        protocol: protocol with the stages.
        measures: names that a bound may have, with their units.
        whole: name of the structure in sentences, such as "a wing".

    Raises:
        InputError: a stage that is not allowed.
    """
    check_stages(protocol, DRIVES, GOALS, measures)
    check_states(protocol, STATES)
    drives = [stage_drives(stage) for stage in protocol.stages]
    fold, unfold = ([number for number, names in enumerate(drives) if drive in names] for drive in DRIVES)
    for number, names in enumerate(drives):
        if len(names) > 1:
            raise InputError(
                f"protocol.stages.{number}.drive: need one drive, because {whole} is not folded and unfolded in one"
                f" stage, got {as_written(protocol.stages[number].drive)}"
            )
    for drive, driven in zip(DRIVES, (fold, unfold), strict=True):
        if len(driven) > 1:
            raise InputError(f'protocol.stages: need at most one stage with drive = "{drive}", got {len(driven)}')
    written = [stage.drive for stage in protocol.stages]
    if unfold and not (fold and fold[0] < unfold[0]):
        raise InputError(
            'protocol.stages: need a stage with drive = "fold" before the one with drive = "unfold",'
            f" got {as_written(written)}"
        )
    if drives[0]:
        raise InputError(
            'protocol.stages: need a first stage with drive = "none", which ends in the flat state,'
            f" got {as_written(written[0])}"
        )
    _check_states_in_order(protocol, [*fold, len(drives)][0], [*unfold, len(drives)][0])


def _check_states_in_order(protocol: Protocol, fold: int, unfold: int) -> None:
    """Refuse names of states that do not follow the order of folding and unfolding.

    Args:
        protocol: protocol with the stages.
        fold: number of the stage that folds.
        unfold: number of the stage that unfolds.
    """
    places = (
        'before the stage with drive = "fold"',
        'from the stage with drive = "fold" to the one with drive = "unfold"',
        'from the stage with drive = "unfold" on',
    )
    for number, stage in enumerate(protocol.stages):
        reached = (number >= fold) + (number >= unfold)
        state, where = STATES[reached], places[reached]
        if stage.state not in (None, state):
            raise InputError(f'protocol.stages.{number}.state: need "{state}" {where}, got {as_written(stage.state)}')


def other_start(protocol: _ProtocolOf, start: float) -> _ProtocolOf:
    """Return a protocol whose distal hinges start at 99 % of the angle `start`, rad, or at -0.02 deg if that is 0."""
    return protocol.model_copy(update={"initial_overbend": 0.99 * start if start else -math.radians(0.02)})


def check_angles(protocol: Protocol, *, fold_limit: float, overbend: float) -> None:
    """Refuse an initial angle or a goal that the stops of the distal hinges make unreachable; angles in rad.

    Raises:
        InputError: a key of the protocol beyond its bounds.
    """
    for key, least, most, stop in (
        ("initial_overbend", -fold_limit, overbend, "overbend"),
        ("folded_angle", 0.0, fold_limit, "fold_limit"),
        ("opened_angle", -fold_limit, overbend, "overbend"),
    ):
        angle = getattr(protocol, key)
        if not least <= angle <= most:
            above = f">= {show_quantity(least, ANGLE)} (-hinge.fold_limit) and " if least else ""
            raise InputError(
                f"protocol.{key}: need {above}<= {show_quantity(most, ANGLE)} (hinge.{stop}),"
                f" got {show_quantity(angle, ANGLE)}"
            )
