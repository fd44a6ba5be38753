"""The protocol of a sheet by names: drives and their targets, states and transitions."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from typing import TYPE_CHECKING

from forficula.design.named_protocol import Action, Drive, NamedProtocol, RestState, Transition, Wording
from forficula.design.protocol import StageSection, read_goal, stage_drives
from forficula.design.sheets.sheet_creases import creases_of, fold_edges
from forficula.design.sheets.sheet_drives import RestAngleDrive, SheetDrive, TorqueDrive, places_of
from forficula.names import listed

if TYPE_CHECKING:
    from forficula.design.sheets.sheet import SheetDesign


def sheet_protocol(design: SheetDesign) -> NamedProtocol:
    """Return the protocol of a sheet as data."""
    stages, angles = design.protocol.stages, design.sheet.edges_fold_angle
    goals = [stage.until for stage in stages if _is_bound(stage)]
    return NamedProtocol(
        drives=tuple(_drive(design, drive) for drive in design.drive),
        goals={goal: goal for goal in goals},
        states=_states(stages),
        stage_states=tuple(stage.state or "" for stage in stages),
        transitions=_transitions(design),
        targets={edge: float(angles[edge]) for edge in fold_edges(design.sheet) if not math.isnan(angles[edge])},
        arrival=design.protocol.arrival,
    )


def _is_bound(stage: StageSection) -> bool:
    """Return whether a stage ends at a goal on measures, not at a time or at rest."""
    return stage.until not in ("time", "rest")


def _drive(design: SheetDesign, drive: SheetDrive) -> Drive:
    """Return a drive of the design with its one action."""
    places = places_of(drive)
    action = Action(
        motor=str(drive.of) if isinstance(drive, TorqueDrive) else drive.name,
        kind=drive.kind,
        edges=() if places else creases_of(design.sheet, str(drive.of), design.crease.group),
        places=places,
        to_targets=isinstance(drive, RestAngleDrive) and drive.to is not None,
        direction=None if isinstance(drive, TorqueDrive | RestAngleDrive) else drive.direction,
        no_load_speed=(isinstance(drive, TorqueDrive) and drive.no_load_speed) or math.inf,
    )
    return Drive(
        name=drive.name,
        actions=(action,),
        rise=design.protocol.rise if drive.rise is None else drive.rise,
        key=f"drive.{drive.name}.{drive.strength_key}",
        strength=getattr(drive, drive.strength_key) or 0.0,
        where=_where(drive),
    )


def _where(drive: SheetDrive) -> str:
    """Return the phrase for what a drive acts on."""
    if not isinstance(drive.of, str):
        return f"on {listed(drive.of)}"
    return f"on {drive.of}" if re.match(r"(crease|vertex) \d", drive.of) else f"on the {drive.of}"


def _transitions(design: SheetDesign) -> tuple[Transition, ...]:
    """Return a transition for every driven stage that ends at bounds and leads to a state."""
    transitions: list[Transition] = []
    distances = [measure.name for measure in design.measure if measure.of is None]
    stages = design.protocol.stages
    for number, stage in enumerate(stages):
        written, state = read_goal(stage.until), _state_after(stages, number)
        if not stage_drives(stage) or not _is_bound(stage) or state is None:
            continue
        measure = "creases" if written is None else written.name
        transitions.append(
            Transition(
                name=stage.name,
                drive=" and ".join(stage_drives(stage)),
                stage=number,
                goal=stage.until,
                state=state,
                released=stage.until,
                measure=measure,
                kind="distance" if measure in distances else "angle",
                furthest="smallest" if written is None or written.relation == ">" else "largest",
                begun=None,
                wording=_wording(state, " and ".join([*(transition.state for transition in transitions), state])),
            )
        )
    return tuple(transitions)


def _states(stages: Sequence[StageSection]) -> tuple[RestState, ...]:
    """Return the states at the ends of stages; the goal of each is that of the last driven stage, or "time"."""
    states: list[RestState] = []
    goal, last = "time", ""
    for stage in stages:
        if stage_drives(stage):
            goal, last = stage.until, stage.name
        if stage.state is not None:
            states.append(
                RestState(
                    name=stage.state,
                    goal=goal,
                    missed=f"not {stage.state}",
                    unknown=f'after stage "{last or stage.name}"',
                )
            )
    return tuple(states)


def _state_after(stages: Sequence[StageSection], number: int) -> str | None:
    """Return the state that a driven stage leads to: its own state, or that of a release that follows."""
    stage = stages[number]
    if stage.state is not None or number + 1 == len(stages) or stage_drives(stages[number + 1]):
        return stage.state
    return stages[number + 1].state


def _wording(state: str, done: str) -> Wording:
    """Return the words for the transition to a state."""
    return Wording(
        done=done,
        verb=f"get {state}",
        doing=f"getting {state}",
        stays=state,
        time=f"time to get {state}",
        noun=f"getting {state}",
        did=f"got {state}",
    )
