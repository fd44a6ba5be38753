"""The protocol of a sheet by names: drives and their targets, states and transitions."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

from forficula.design.named_protocol import Action, Drive, NamedProtocol
from forficula.design.sheets.sheet_creases import creases_of, fold_edges
from forficula.design.sheets.sheet_drives import RestAngleDrive, SheetDrive, TorqueDrive, places_of
from forficula.design.stage_protocol import is_bound, rest_states, stage_transitions
from forficula.names import listed

if TYPE_CHECKING:
    from forficula.design.sheets.sheet import SheetDesign


def sheet_protocol(design: SheetDesign) -> NamedProtocol:
    """Return the protocol of a sheet as data."""
    stages, angles = design.protocol.stages, design.sheet.edges_fold_angle
    distances = [measure.name for measure in design.measure if measure.of is None]
    goals = [stage.until for stage in stages if is_bound(stage)]
    return NamedProtocol(
        drives=tuple(_drive(design, drive) for drive in design.drive),
        goals={goal: goal for goal in goals},
        states=rest_states(stages),
        stage_states=tuple(stage.state or "" for stage in stages),
        transitions=stage_transitions(stages, distances),
        targets={edge: float(angles[edge]) for edge in fold_edges(design.sheet) if not math.isnan(angles[edge])},
        arrival=design.protocol.arrival,
    )


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
