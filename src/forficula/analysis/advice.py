"""Advice for a design whose run missed its goal: changes of values, each kind tested on failing designs.

A kind of advice is given only if it helps at least 90 % of random failing designs (`benchmarks/advice.py`). It helps if
the run then reaches its goals, if its margin grows, or if a run without a conclusive verdict gets one.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from forficula.analysis.verdict import UNSETTLED, Ending, Verdict
from forficula.design import Design, FanDesign, JointDesign, SheetDesign, stage_drives, with_values
from forficula.dynamics import Record
from forficula.quantities import show_value
from forficula.statics.net.net_of import is_net
from forficula.statics.path_dependence import path_dependence
from forficula.statics.slow_margin import LARGEST_TORQUE_FACTOR, least_slow_torques
from forficula.structure import (
    Structure,
    Transition,
    distance_to_goal,
    drive_of,
    drive_unit,
    goal_coordinates,
    goal_of,
    structure_of,
)

# [chosen] a residual above this many times the allowed one does not predict a sufficient timestep
_FAR_OFF = 20
AUTO = 'protocol.timestep = "auto" chooses one'
_FLAT = "closed loops that start flat lose this energy, and a sheet with a fold of 1 deg as built loses little of it"
# power of the residual to which the timestep of closed loops that start flat is proportional
_FLAT_ORDER = 1.5
SHORTER_STEP = f"Take a shorter timestep: {AUTO}."
# [chosen] factors by which a time limit, and a hold before a release, are raised
_LONGER, _HELD = 4.0, 10.0
# [chosen] advised torque divided by the least slowly growing torque
_SURELY = 1.2
# [chosen] factors on the tendons' stiffness that are tried where no torque is sufficient
_SOFTER = (0.5, 0.25, 0.125)
# [chosen] share of the structure's size: a distance that changes by less over a window has not moved
_MOVED_SHARE = 1e-3


@dataclass(frozen=True, kw_only=True)
class Advice:
    """What to change in a design after a failed run, or a remark on a failure for which no tested advice exists.

    Attributes:
        kind: kind of the advice, as listed in the table of `benchmarks/advice.py`; empty for a remark.
        text: one or two sentences.
        values: new values, SI, by the key that `--set` and a design file use; empty for a remark.
        least_torque: least slowly growing torque that moves the stuck structure, N m; nan where no torque does; None
            where statics did not compute it.
    """

    text: str
    kind: str = ""
    values: Mapping[str, object] = field(default_factory=dict)
    least_torque: float | None = None


NOTHING = Advice(text="")
_EDGE = Advice(text="The design is at a boundary, where the smallest change decides the outcome.")


def edge_advice() -> Advice:
    """Return the remark on a design whose outcome depends on details of the computation."""
    return _EDGE


def run_advice(record: Record, ending: Ending) -> Advice:
    """Return what to change in the design of a run; its text is empty if the goals were reached or nothing helps.

    Where a torque did not move the structure, a static computation of up to a few seconds finds the least torque.
    """
    design, transition = record.design, ending.transition
    match ending.verdict:
        case Verdict.DIVERGED:
            return _shorter_step(ending, record)
        case Verdict.UNTRUSTED if ending.why == UNSETTLED:
            return _EDGE
        case Verdict.UNTRUSTED:
            return _shorter_step(ending, record)
        case Verdict.MOVING if transition is not None and transition.stage is not None:
            return _more_time(record, ending, transition)
        case Verdict.NOT_HELD if ending.why:
            return Advice(text="Choose a goal that is not met before its drive acts.")
        case Verdict.NOT_HELD if transition is not None and isinstance(design, FanDesign | JointDesign):
            return _longer_hold(record, transition)
        case Verdict.STUCK if transition is not None:
            return _stronger(record, transition)
        case _:
            return NOTHING


def _more_time(record: Record, ending: Ending, transition: Transition) -> Advice:
    """Return a longer time limit for a stage that ended while the structure still approached its goal."""
    assert transition.stage is not None
    if transition.stage >= len(record.stages):
        return NOTHING
    end = record.stages[transition.stage]
    if end.goal_time is not None:  # the run missed the rest of a later stage
        return NOTHING
    stage, key = end.stage, _stage_key(record.design, transition.stage, "time_limit")
    if not (end.at_goal or ending.why or _approaches_goal(record, transition)):
        last = show_value(min(record.design.protocol.window, end.end - end.start), "s")
        return Advice(
            text=f'In the last {last} of the stage "{stage.name}" it approached its goal no faster than a structure'
            " at rest."
        )
    rises = [drive.rise for drive in record.structure.drives if drive.name in (transition.drive, *stage_drives(stage))]
    limit = _rounded(max(_LONGER * stage.time_limit, *(rise + stage.time_limit for rise in rises)))
    old, new = show_value(stage.time_limit, "s"), show_value(limit, "s")
    text = f"It is still approaching its goal: raise {key} from {old} to {new}."
    return Advice(kind="more time", text=text, values={key: limit})


def _approaches_goal(record: Record, transition: Transition) -> bool:
    """Return whether the coordinate furthest from a transition's goal approached it at the end of the driven stage.

    Its mean speed over the last window must exceed the speed that counts as rest, because more time does not help a
    structure that only creeps.
    """
    assert transition.stage is not None
    end = record.stages[transition.stage]
    start = max(end.start, end.end - record.design.protocol.window)
    half = float(record.design.protocol.timestep) / 2
    rows = np.flatnonzero((record.time >= start - half) & (record.time <= end.end + half))[[0, -1]]
    distances, goal = record.series.get("distance"), goal_of(record.structure, transition.goal)
    before, after = goal_coordinates(
        record.structure, record.series["hinge_angle"][rows], None if distances is None else distances[rows]
    )
    resting = record.design.protocol.rest_speed * (end.end - start)
    least = resting if transition.kind == "angle" else _MOVED_SHARE * record.structure.span
    return distance_to_goal(before, goal) - distance_to_goal(after, goal) > least


def _longer_hold(record: Record, transition: Transition) -> Advice:
    """Return a longer hold under torque for a state that was lost when released.

    It is not advised for sheets, because it helped only 4 of 9 designs with plates.
    """
    number = transition.stage
    if number is None or number >= len(record.stages) or record.stages[number].goal_time is None:
        return NOTHING
    end = record.stages[number]
    assert end.goal_time is not None
    hold = _rounded(_HELD * max(end.stage.hold, end.goal_time - end.start))
    keys = {name: _stage_key(record.design, number, name) for name in ("hold", "time_limit")}
    limit = _rounded(max(end.stage.time_limit, 2 * hold + end.goal_time - end.start))
    text = (
        f"Hold it longer before the release: {keys['hold']} = {show_value(hold, 's')} instead of"
        f" {show_value(end.stage.hold, 's')}, with {keys['time_limit']} = {show_value(limit, 's')}."
    )
    return Advice(kind="longer hold", text=text, values={keys["hold"]: hold, keys["time_limit"]: limit})


def _stronger(record: Record, transition: Transition) -> Advice:
    """Return a stronger drive, or softer tendons, with which a stuck structure moves according to statics."""
    structure, design = record.structure, record.design
    drive, verb = drive_of(structure, transition.drive), transition.wording.verb
    unit, strength = drive_unit(structure, drive), drive.strength
    if not _turned_slowly(structure, transition):
        sheet = isinstance(design, SheetDesign)
        return Advice(text="`forficula pattern` reports whether the sheet can fold at all.") if sheet else NOTHING
    (least,) = _least_torques([design], transition)
    if math.isnan(least):
        softer = _softer(design)
        with_softer = _least_torques([with_values(design, values) for values in softer], transition) if softer else []
        most = show_value(LARGEST_TORQUE_FACTOR * abs(strength), unit)
        none = f"No slowly growing torque up to {most} makes it {verb}."
        for values, torque in zip(softer, with_softer, strict=True):
            if _SURELY * torque <= abs(strength):
                stiffness = show_value(values["tendon.stiffness"], "N/m")
                text = f"{none} With tendon.stiffness = {stiffness} the torque of its drive is enough."
                return Advice(kind="softer tendons", text=text, values=values, least_torque=least)
        return Advice(text=none, least_torque=least)
    if least <= abs(strength):
        return Advice(text="", least_torque=least)
    value = math.copysign(_rounded(_SURELY * least), strength)
    text = (
        f"Raise {drive.key} from {show_value(strength, unit)} to {show_value(value, unit)}:"
        f" a slowly growing torque of {show_value(least, unit, 3)} makes it {verb}."
    )
    return Advice(kind="more torque", text=text, values={drive.key: value}, least_torque=least)


def _softer(design: Design) -> list[dict[str, float]]:
    """Return values of softer tendons; empty unless all tendons have the same stiffness and no material law."""
    tendons = design.tendons if isinstance(design, FanDesign | JointDesign) else ()
    values = {tendon.stiffness for tendon in tendons if tendon is not None and tendon.stiffness is not None}
    if len(values) != 1 or any(tendon is None or tendon.law is not None for tendon in tendons):
        return []
    (stiffness,) = values
    return [{"tendon.stiffness": float(f"{share * stiffness:.3g}")} for share in _SOFTER]


def least_torque(design: Design, structure: Structure, transition: Transition) -> float | None:
    """Compute by statics the least slowly growing torque that makes a transition, N m.

    Torques of up to ten times the protocol's are tried.

    Returns:
        nan if no such torque makes it; None if the drive is not a torque, if the hinges do not form a tree, or if
        hinges have dry friction or fold permanently, or if there is a table.
    """
    return _least_torques([design], transition)[0] if _turned_slowly(structure, transition) else None


def _turned_slowly(structure: Structure, transition: Transition) -> bool:
    """Return whether statics can compute the least torque of a transition.

    It can for torques on a tree without dry friction, permanent folds and a table.
    """
    drive = drive_of(structure, transition.drive)
    if any(hinge.friction for hinge in structure.hinges) or path_dependence(structure) or structure.table is not None:
        return False
    return not is_net(structure) and drive_unit(structure, drive) == "N m" and bool(drive.strength)


def _least_torques(designs: Sequence[Design], transition: Transition) -> list[float]:
    """Compute the least slowly growing torques of designs that differ only in their tendons, N m; nan if none works."""
    names = [entry.name for entry in structure_of(designs[0]).transitions]
    return [float(torque) for torque in least_slow_torques(designs, [transition.name])[names.index(transition.name)]]


def _shorter_step(ending: Ending, record: Record) -> Advice:
    """Return a sufficient timestep, assuming that the missing energy is at least proportional to the timestep.

    Closed loops that start flat lose energy in proportion to the timestep to the power 2/3.
    """
    limit, timestep = record.design.protocol.residual_limit, record.design.protocol.timestep
    flat = bool(record.structure.closures) and not any(hinge.start for hinge in record.structure.hinges)
    auto = Advice(kind="timestep auto", text=SHORTER_STEP, values={"protocol.timestep": "auto"})
    if ending.verdict is Verdict.DIVERGED or ending.why:
        return auto
    allowed = f"a residual of {100 * limit:.3g} % is allowed (protocol.residual_limit)"
    if ending.residual is None or not ending.residual <= _FAR_OFF * limit or not isinstance(timestep, float):
        return Advice(kind=auto.kind, text=f"Take a shorter timestep: {allowed}; {AUTO}.", values=auto.values)
    needed = timestep * (limit / ending.residual) ** (_FLAT_ORDER if flat else 1)
    digit = 10.0 ** math.floor(math.log10(needed))
    needed = math.floor(needed / digit * (1 + 1e-9)) * digit
    instead = f"{show_value(needed, 's')} instead of {show_value(timestep, 's')}"
    text = f"Take a timestep of about {instead}: {allowed}; {_FLAT if flat else AUTO}."
    return Advice(kind="timestep by residual", text=text, values={"protocol.timestep": needed})


def _stage_key(design: Design, number: int, name: str) -> str:
    """Return the key of a stage's value: with the stage's name if it is unique and easy to type, else its number."""
    names = [stage.name for stage in design.protocol.stages]
    stage = names[number]
    plain = stage.replace("_", "").replace("-", "").isalnum() and not stage.isdigit() and names.count(stage) == 1
    return f"protocol.stages.{stage if plain else number}.{name}"


def _rounded(value: float) -> float:
    """Return a value rounded up to two digits."""
    digit = 10.0 ** (math.floor(math.log10(value)) - 1)
    return float(f"{math.ceil(value / digit * (1 - 1e-9)) * digit:.2g}")
