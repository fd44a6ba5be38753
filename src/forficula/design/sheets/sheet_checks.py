"""Checks that the values of a sheet's design fit together, for facets of every kind."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, TypeVar

import numpy as np

from forficula.design.design import check_duration
from forficula.design.medium import check_medium
from forficula.design.protocol import GoalText, check_bound, check_stages, read_goal, stage_drives
from forficula.design.section import ANGLE, LENGTH, SHORT_TIME, TORQUE
from forficula.design.sheets.crease_checks import check_friction, check_memory
from forficula.design.sheets.crease_sections import named_laws_of
from forficula.design.sheets.crease_values import crease_key, creases_by_edge, stops
from forficula.design.sheets.rigid_checks import (
    check_rigid,
    check_rigid_creases,
    check_rigid_supports,
    check_rigid_tendon,
)
from forficula.design.sheets.sheet_creases import crease_groups, crease_role, crease_sense, creases_of, fold_edges
from forficula.design.sheets.sheet_drives import DisplacementDrive, RestAngleDrive, TorqueDrive, places_of
from forficula.design.sheets.sheet_places import (
    GROUND_PLACE,
    SheetPlace,
    edge_of,
    facet_of,
    is_vertex,
    place_on,
    vertex_of,
)
from forficula.design.sheets.thick_panels import check_thickness
from forficula.design.stops import StopSection
from forficula.errors import InputError
from forficula.material.law.crease_law_file import CREASE_STIFFNESS
from forficula.pattern import CreasePattern, built_fold_angles
from forficula.pattern.shared_edges import shared_edges
from forficula.quantities import Unit, as_written, parse_quantity, show_quantity

if TYPE_CHECKING:
    from forficula.design.sheets.sheet import SheetDesign
    from forficula.design.sheets.sheet_drives import SheetMeasure, SheetTendon

_Result = TypeVar("_Result")

# rad, largest angle of a crease beyond a stop as built: rounding
_BEYOND_STOP = 1e-6
# largest sum of torques that counts as 0, as a share of the largest torque: rounding
_ROUNDING = 1e-12
# columns of tables of states beside the measures
_COLUMNS = ("energy", "time", "sum")
# keys of summaries and columns of tables beside the names of stages and states
_TAKEN = (
    *("design", "design_hash", "status", "verdict", "outcome", "residual", "advice", "goal", "key"),
    *("states", "stages", "branch", "energy_balance", "diverged_at_s", "timestep_s", "warnings", "versions"),
)


def check_sheet(design: SheetDesign) -> None:
    """Refuse a design whose values do not fit together.

    Raises:
        InputError: the key, the rule and the value.
    """
    sheet, groups = design.sheet, design.crease.group
    _check_edges(sheet)
    if not fold_edges(sheet):
        raise InputError("pattern: need a mountain or a valley between two facets, got none")
    for number, group in enumerate(groups):
        _keyed(f"crease.group.{number}.of", creases_of, sheet, group.of, groups[:number])
    if design.facet.kind != "rigid":
        _check_no_stops(design)
    if design.facet.kind == "rigid":
        if design.imperfection.size:
            raise InputError("imperfection.size: is for facets that bend; rigid ones meet as drawn, or not at all")
        # before the supports, whose rules differ for a sheet that cannot be rigid
        check_rigid(design)
    _check_supports(design, sheet)
    if design.facet.kind == "rigid":
        check_rigid_supports(design)
        check_rigid_creases(design)
    elif design.crease.start or any(group.start for group in groups):
        raise InputError("crease.start: is for rigid facets; others start as the pattern is built")
    else:
        _check_built(design, sheet)
    check_thickness(design)
    for number, extension in enumerate((design.crease.extension, *(group.extension for group in groups))):
        if design.facet.kind != "rigid" and extension is not None:
            key = f"crease.group.{number - 1}" if number else "crease"
            raise InputError(f'{key}.extension: is for facet.kind = "rigid", with which creases can open')
    _check_yielding(design)
    check_memory(design)
    check_friction(design)
    _check_names(design, sheet)
    for number, _ in enumerate(design.tendon):
        _check_tendon(design, sheet, number)
    for number, _ in enumerate(design.drive):
        _check_drive(design, sheet, number)
    for number, measure in enumerate(design.measure):
        if measure.of is not None:
            _keyed(f"measure.{number}.of", creases_of, sheet, measure.of, groups)
            continue
        _check_apart(sheet, f"measure.{number}", measure, _ends(design, sheet, f"measure.{number}", measure))
    if design.medium is not None:
        lightest = design.settled().facet.density or 0.0
        check_medium(design.medium, design.protocol.gravity, lightest, "facet.density")
    _check_protocol(design, sheet)
    check_duration(design, len(sheet.faces_vertices), "facets")


def _check_yielding(design: SheetDesign) -> None:
    """Refuse creases that cannot yield, and a hardening without a yield or above the stiffness."""
    moments = [design.crease.yield_moment, *(group.yield_moment for group in design.crease.group)]
    slopes = [design.crease.hardening, *(group.hardening for group in design.crease.group)]
    if all(value is None for value in (*moments, *slopes)) and not named_laws_of(design.crease):
        return
    settled = design.settled()
    for edge, crease in creases_by_edge(settled).items():
        hardening, stiffness = crease.hardening or 0.0, crease.stiffness or 0.0
        key, of_stiffness = (crease_key(design, edge, name) for name in ("hardening", "stiffness"))
        if crease.yield_moment is None:
            if crease.hardening is not None:
                raise InputError(f"{key}: needs {crease_key(design, edge, 'yield_moment')}, from which on it acts")
        elif not stiffness:
            yielding = crease_key(design, edge, "yield_moment")
            raise InputError(f"{yielding}: needs a stiffness > 0 under {of_stiffness}, got 0")
        elif hardening >= stiffness:
            raise InputError(
                f"{key}: need < {of_stiffness}, {show_quantity(stiffness, CREASE_STIFFNESS)}, got"
                f" {show_quantity(hardening, CREASE_STIFFNESS)}"
            )


def _check_no_stops(design: SheetDesign) -> None:
    """Refuse values of the section `stops`, which does not apply to creases between facets that bend."""
    for key in StopSection.model_fields:
        value = getattr(design.stops, key)
        if value != getattr(StopSection(), key):
            shown = show_quantity(value, SHORT_TIME) if key == "time_constant" else f"{value:g}"
            raise InputError(
                f"stops.{key}: is for stops of rigid bodies; where facets bend, stops of creases are springs with the"
                f" stiffness crease.stop_stiffness; got {shown}"
            )


def _check_built(design: SheetDesign, sheet: CreasePattern) -> None:
    """Refuse stops that creases exceed as built."""
    limited = {edge: stops(design, edge, crease) for edge, crease in creases_by_edge(design).items()}
    if all(math.isinf(stop) for pair in limited.values() for stop in pair):
        return
    angles = built_fold_angles(sheet)
    for edge, (low, high) in limited.items():
        built = crease_sense(sheet, edge) * float(angles[edge])
        if not low - _BEYOND_STOP <= built <= high + _BEYOND_STOP:
            key, size, stop = ("fold_limit", built, high) if built > high else ("back_limit", -built, -low)
            raise InputError(
                f"{crease_key(design, edge, key)}: need >= {show_quantity(size, ANGLE)}, at which crease {edge} is"
                f" built, got {show_quantity(stop, ANGLE)}"
            )


def _check_edges(sheet: CreasePattern) -> None:
    """Refuse a boundary edge between two facets, whose connection it does not define."""
    for edge, _, _, left, right in shared_edges(sheet):
        if sheet.edges_assignment[edge] == "B":
            raise InputError(
                f'pattern: edge {edge} lies between facets {left} and {right}: need "M" (mountain), "V" (valley),'
                ' "F" (flat), "U" (unassigned) or "C" (cut), got "B"'
            )


def _check_supports(design: SheetDesign, sheet: CreasePattern) -> None:
    """Refuse supports that are not on the sheet, and starts away from supported points of rigid facets."""
    rigid = design.facet.kind == "rigid"
    for number, support in enumerate(design.support):
        key = f"support.{number}.of"
        if support.kind == "edge":
            _keyed(key, edge_of, sheet, support.of)
        elif support.kind == "facet":
            _keyed(key, facet_of, sheet, support.of)
            if rigid and not support.whole:
                raise InputError(f"support.{number}.axes: is for edges and vertices; a rigid facet is held as a whole")
        else:
            _keyed(key, vertex_of, sheet, support.of)
    if rigid and design.point_supports and (design.crease.start or any(group.start for group in design.crease.group)):
        raise InputError("crease.start: need 0 deg for rigid facets that several supports, or vertices, hold")
    if not rigid and len(_held_whole(design, sheet)) == len(sheet.vertices_coords):
        raise InputError(
            f"support: need a vertex that can move, got all {len(sheet.vertices_coords)} held; leave out an entry, or"
            " hold vertices along some axes only"
        )


def _held_whole(design: SheetDesign, sheet: CreasePattern) -> set[int]:
    """Return the vertices that supports hold along all axes."""
    held: set[int] = set()
    for support in design.support:
        if set(support.axes or "xyz") < set("xyz"):
            continue
        if support.kind == "facet":
            held.update(sheet.faces_vertices[facet_of(sheet, support.of)])
        elif support.kind == "edge":
            held.update(sheet.edges_vertices[edge_of(sheet, support.of)[0]].tolist())
        else:
            held.add(vertex_of(sheet, support.of)[0])
    return held


def _check_names(design: SheetDesign, sheet: CreasePattern) -> None:
    """Refuse two entries with the same name, and measures and groups with the name of a group of creases."""
    groups = crease_groups(sheet)
    for section in ("crease.group", "tendon", "drive", "measure"):
        names: list[str] = []
        entries = design.crease.group if section == "crease.group" else getattr(design, section)
        for number, entry in enumerate(entries):
            if entry.name is None:
                continue
            taken = section in ("measure", "crease.group") and entry.name in groups
            if entry.name in names or taken:
                raise InputError(
                    f"{section}.{number}.name: need a name that is not used yet, got {as_written(entry.name)} again"
                )
            if section == "measure" and entry.name in _COLUMNS:
                raise InputError(
                    f"{section}.{number}.name: need a name that is not a column of tables, got {as_written(entry.name)}"
                )
            names.append(entry.name)


def _check_tendon(design: SheetDesign, sheet: CreasePattern, number: int) -> None:
    """Refuse a tendon between places that do not exist or whose distance never changes."""
    ends = [_end(design.tendon[number], end) for end in ("from", "to")]
    places = _ends(design, sheet, f"tendon.{number}", design.tendon[number])
    if design.facet.kind == "rigid":
        check_rigid_tendon(design, number, ends)
    else:
        _check_apart(sheet, f"tendon.{number}", design.tendon[number], places)


def _check_apart(sheet: CreasePattern, key: str, joined: SheetTendon | SheetMeasure, places: Sequence[object]) -> None:
    """Refuse two ends at the same place of a sheet that bends."""
    one, other = (_in_sheet(sheet, place) for place in places)
    if one == other:
        raise InputError(f"{key}.to: need another place than {key}.from, got {as_written(_end(joined, 'to'))}")


def _end(joined: SheetTendon | SheetMeasure, end: str) -> str:
    """Return the text of an end, "from" or "to"."""
    return str(getattr(joined, end))


def _in_sheet(sheet: CreasePattern, place: object) -> object:
    """Identify a place by its vertex, or else by its facet and position."""
    if not isinstance(place, SheetPlace):
        return place[0] if isinstance(place, tuple) and place[1] is None else place
    corners = sheet.faces_vertices[place.facet]
    at = [vertex for vertex in corners if np.array_equal(sheet.vertices_coords[vertex], place.position)]
    return at[0] if at else (place.facet, *place.position.tolist())


def _ends(design: SheetDesign, sheet: CreasePattern, key: str, joined: SheetTendon | SheetMeasure) -> list[object]:
    """Return the positions of both ends. One of them may be on the ground."""
    places = [_keyed(f"{key}.{end}", _place, design, sheet, getattr(joined, end)) for end in ("from", "to")]
    if (GROUND_PLACE in places) != bool(joined.ground) or len(joined.ground) not in (0, 3):
        raise InputError(
            f'{key}.ground: need x, y and z if one end is "ground", as in ["0 cm", "0 cm", "-5 cm"], otherwise'
            f" nothing, got {len(joined.ground)} numbers"
        )
    return places


def _place(design: SheetDesign, sheet: CreasePattern, text: str) -> object:
    """Return the place that a text names, in a form that can be compared with others."""
    if design.facet.kind != "rigid" and text.strip() == GROUND_PLACE:
        return GROUND_PLACE
    if design.facet.kind != "rigid" and is_vertex(text):
        return vertex_of(sheet, text)
    return place_on(sheet, text)


def _check_drive(design: SheetDesign, sheet: CreasePattern, number: int) -> None:
    """Refuse a drive on creases or places that do not exist, or of a kind that the facets do not allow."""
    drive, key, rigid = design.drive[number], f"drive.{number}.of", design.facet.kind == "rigid"
    if isinstance(drive, DisplacementDrive) and rigid:
        raise InputError(f'drive.{number}.kind: need "torque" or "force" where facets are rigid, got "displacement"')
    if not isinstance(drive, TorqueDrive) and rigid and not design.opens:
        raise InputError(f'drive.{number}.kind: need "torque" where facets are hinged, got "{drive.kind}"')
    for text in places_of(drive):
        _keyed(key, _place, design, sheet, text)
    if isinstance(drive, TorqueDrive | RestAngleDrive):
        edges = _keyed(key, creases_of, sheet, drive.of, design.crease.group)
    if not isinstance(drive, RestAngleDrive):
        return
    if not any(creases_by_edge(design)[edge].stiffness != 0 for edge in edges):
        raise InputError(
            f"{key}: need creases with springs, whose rest angles the drive changes, got {as_written(drive.of)} with"
            f" {crease_key(design, edges[0], 'stiffness')} = 0"
        )
    if drive.to is not None and not any(sheet.edges_fold_angle[edge] for edge in _targeted(sheet, edges)):
        raise InputError(f"{key}: need creases with a target, a mountain or a valley, got {as_written(drive.of)}")


def _targeted(sheet: CreasePattern, edges: Sequence[int]) -> list[int]:
    """Return those creases that have a target fold angle."""
    return [edge for edge in edges if not math.isnan(sheet.edges_fold_angle[edge])]


def _check_protocol(design: SheetDesign, sheet: CreasePattern) -> None:
    """Refuse stages with unknown names, repeated states, and goals that stops of creases make unreachable."""
    edges = fold_edges(sheet)
    measured = measured_units(design)
    goals = ["target"] if _targeted(sheet, edges) else []
    check_stages(design.protocol, [drive.name for drive in design.drive], goals, measured)
    _check_torques(design, sheet)
    # stages and states are keys of the same summary and columns of the same table
    names: list[str] = []
    for number, stage in enumerate(design.protocol.stages):
        for key, name in (("name", stage.name), ("state", stage.state)):
            if name is not None:
                _check_name(f"protocol.stages.{number}.{key}", name, names)
                names.append(name)
        written = read_goal(stage.until)
        if written is not None and measured[written.name] is ANGLE:
            _check_angle_goal(design, sheet, f"protocol.stages.{number}.until", written)
        elif written is not None and parse_quantity(written.value, LENGTH) <= 0:
            raise InputError(f"protocol.stages.{number}.until: need a distance > 0 m, got {as_written(stage.until)}")


def measured_units(design: SheetDesign) -> dict[str, Unit]:
    """Return the names of measures and of roles of creases that a bound may have, with their units."""
    roles = (crease_role(design.sheet, edge) for edge in fold_edges(design.sheet))
    units: dict[str, Unit] = dict.fromkeys(("creases", *roles), ANGLE)
    return units | {measure.name: LENGTH if measure.of is None else ANGLE for measure in design.measure}


def _check_angle_goal(design: SheetDesign, sheet: CreasePattern, key: str, written: GoalText) -> None:
    """Refuse a bound on fold angles that the stop of a crease makes unreachable."""
    measure = next((measure for measure in design.measure if measure.name == written.name), None)
    creases = creases_by_edge(design)
    name = written.name if measure is None else str(measure.of)
    # of creases with the same stops, one is checked
    first: dict[tuple[float, float], int] = {}
    for edge in creases_of(sheet, name, design.crease.group):
        low, high = stops(design, edge, creases[edge])
        if measure is not None and crease_sense(sheet, edge) < 0:
            # measures count valleys as positive
            low, high = -high, -low
        first.setdefault((low, high), edge)
    for (low, high), edge in first.items():
        check_bound(key, written, low, high, whose=f"crease {edge}")


def _check_torques(design: SheetDesign, sheet: CreasePattern) -> None:
    """Refuse a stage whose torques cancel on every crease at all times."""
    for number, stage in enumerate(design.protocol.stages):
        named = [drive for drive in design.drive if drive.name in stage_drives(stage)]
        drives = [drive for drive in named if isinstance(drive, TorqueDrive)]
        if len(drives) < 2 or drives != named:
            continue
        torques = dict.fromkeys(fold_edges(sheet), 0.0)
        for drive in drives:
            for edge in creases_of(sheet, drive.of, design.crease.group):
                torques[edge] += drive.value
        largest = max(abs(drive.value) for drive in drives)
        same_rise = len({drive.rise for drive in drives}) == 1
        if largest and same_rise and max(map(abs, torques.values())) <= _ROUNDING * largest:
            values = " and ".join(show_quantity(drive.value, TORQUE) for drive in drives)
            raise InputError(
                f"protocol.stages.{number}.drive: need drives that do not cancel on every crease, got"
                f" {as_written(stage.drive)}, {values}"
            )


def _check_name(key: str, name: str, names: Sequence[str]) -> None:
    """Refuse an empty name of a stage or of a state, and a name that is already in use."""
    if not name.strip():
        raise InputError(f"{key}: need a name, got {as_written(name)}")
    if name in _TAKEN:
        raise InputError(f"{key}: need a name that is not a column of tables, got {as_written(name)}")
    if name in names:
        raise InputError(f"{key}: need a name that no stage and no other state has, got {as_written(name)} again")


def _keyed(key: str, find: Callable[..., _Result], *arguments: object) -> _Result:
    """Call a function; the message of an `InputError` begins with a key."""
    try:
        return find(*arguments)
    except InputError as error:
        raise InputError(f"{key}: {error}") from None
