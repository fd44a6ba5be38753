"""Rigid plates on the facets of a sheet, hinged at its creases, and what must fit together."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Annotated, Any, TypeVar

from pydantic import Field, model_validator

from forficula.design.design import Design, check_duration
from forficula.design.part import ANGLE, LENGTH, TORQUE
from forficula.design.plates_sections import (
    Crease,
    Facet,
    FoldFile,
    PlateDrive,
    PlateMeasure,
    PlateTendon,
    Pleats,
    Support,
)
from forficula.design.protocol import GoalText, check_bound, check_stages, read_goal, stage_drives
from forficula.design.sheet_creases import crease_groups, crease_role, creases_between, creases_of, fold_edges
from forficula.design.sheet_places import facet_of, keeps_distance, place_on
from forficula.errors import InputError
from forficula.pattern import CreasePattern, facet_tree
from forficula.quantities import Unit, as_written, parse_quantity, show_quantity

Found = TypeVar("Found")

# share of the largest torque that a sum of torques may be off by
_ROUNDING = 1e-12
# what summaries and tables have beside the names of stages and states
_TAKEN = (
    *("design", "design_hash", "status", "verdict", "outcome", "residual", "advice", "goal", "key"),
    *("states", "stages", "energy_balance", "diverged_at_s", "timestep_s", "warnings", "versions"),
)


class PlatesDesign(Design):
    """Rigid plates on the facets of a sheet, hinged at its creases, and what is done to them."""

    pattern: Any
    facet: Facet
    crease: Crease
    tendon: Annotated[tuple[PlateTendon, ...], Field(description="springs between two places, which only pull")] = ()
    support: Annotated[
        tuple[Support, ...], Field(max_length=1, description="which facet is held; without it facet 0 is")
    ] = ()
    drive: Annotated[tuple[PlateDrive, ...], Field(description="what stages of the protocol switch on")] = ()
    measure: Annotated[tuple[PlateMeasure, ...], Field(description="what is watched, for goals and tables")] = ()

    @property
    def sheet(self) -> CreasePattern:
        """The crease pattern."""
        sheet: CreasePattern = self.pattern.sheet
        return sheet

    @property
    def held_facet(self) -> int:
        """Number of the facet that is held."""
        return facet_of(self.sheet, self.support[0].of) if self.support else 0

    @model_validator(mode="after")
    def _fits_together(self) -> PlatesDesign:
        sheet = self.sheet
        try:
            facet_tree(sheet)
        except InputError as error:
            raise InputError(f"pattern: {error}") from None
        if not fold_edges(sheet):
            raise InputError("pattern: need a mountain or a valley between two facets, got none")
        if self.support:
            _keyed("support.0.of", facet_of, sheet, self.support[0].of)
        _check_creases(self, sheet)
        _check_names(self, sheet)
        for number, tendon in enumerate(self.tendon):
            one, other = (
                _keyed(f"tendon.{number}.{end}", place_on, sheet, getattr(tendon, end)) for end in ("from", "to")
            )
            if one.facet == other.facet:
                raise InputError(
                    f"tendon.{number}.to: need a place on another facet than tendon.{number}.from, or its length never"
                    f" changes, got facet {one.facet} for both"
                )
            if keeps_distance(sheet, one, other):
                between = creases_between(sheet, one.facet, other.facet)
                why = "it lies on the axis of every crease between them" if between else "no crease lies between them"
                raise InputError(
                    f"tendon.{number}.to: need a place that creases move against tendon.{number}.from, or its length"
                    f" never changes, got {as_written(getattr(tendon, 'to'))}: {why}"  # noqa: B009
                )
        for number, drive in enumerate(self.drive):
            _keyed(f"drive.{number}.of", creases_of, sheet, drive.of)
        for number, measure in enumerate(self.measure):
            if measure.of is not None:
                _keyed(f"measure.{number}.of", creases_of, sheet, measure.of)
                continue
            for end in ("from", "to"):
                _keyed(f"measure.{number}.{end}", place_on, sheet, getattr(measure, end))
        if self.protocol.contact:
            raise InputError("protocol.contact: need false, for plates do not touch each other, got true")
        _check_protocol(self, sheet)
        check_duration(self, len(sheet.faces_vertices), "facets")
        return self


class PleatsDesign(PlatesDesign):
    """A strip of pleats, and what is done to it."""

    pattern: Pleats


class FoldFileDesign(PlatesDesign):
    """Plates on the facets of a sheet that a FOLD file describes, and what is done to them."""

    pattern: FoldFile


def creases_by_edge(design: PlatesDesign) -> dict[int, Crease]:
    """The properties of every crease, those of its last group where that gives them, by the number of its edge."""
    sheet = design.sheet
    creases = dict.fromkeys(fold_edges(sheet), design.crease)
    for group in design.crease.group:
        given = {key: value for key, value in group if key != "of" and value is not None}
        for edge in creases_of(sheet, group.of):
            creases[edge] = creases[edge].model_copy(update=given)
    return creases


def _check_creases(design: PlatesDesign, sheet: CreasePattern) -> None:
    """Refuse groups of no creases, and creases that start beyond their stops."""
    for number, group in enumerate(design.crease.group):
        _keyed(f"crease.group.{number}.of", creases_of, sheet, group.of)
    for edge, crease in creases_by_edge(design).items():
        if not -crease.back_limit <= crease.start <= crease.fold_limit:
            start, low, high = (_crease_key(design, edge, key) for key in ("start", "back_limit", "fold_limit"))
            raise InputError(
                f"{start}: need >= {show_quantity(-crease.back_limit, ANGLE)} (-{low}) and"
                f" <= {show_quantity(crease.fold_limit, ANGLE)} ({high}) at crease {edge},"
                f" got {show_quantity(crease.start, ANGLE)}"
            )


def _crease_key(design: PlatesDesign, edge: int, key: str) -> str:
    """Where a crease has a value from: the last group that gives it, or the section."""
    given = (
        f"crease.group.{number}.{key}"
        for number, group in reversed(list(enumerate(design.crease.group)))
        if getattr(group, key) is not None and edge in creases_of(design.sheet, group.of)
    )
    return next(given, f"crease.{key}")


def _check_names(design: PlatesDesign, sheet: CreasePattern) -> None:
    """Refuse two things of one name, and a measure that is called like a group of creases."""
    groups = crease_groups(sheet)
    for section in ("tendon", "drive", "measure"):
        names: list[str] = []
        for number, entry in enumerate(getattr(design, section)):
            if entry.name in names or (section == "measure" and entry.name in groups):
                raise InputError(f"{section}.{number}.name: need a name of its own, got {as_written(entry.name)} again")
            names.append(entry.name)


def _check_protocol(design: PlatesDesign, sheet: CreasePattern) -> None:
    """Refuse stages that name nothing there is, states twice, and goals that stops keep the creases from."""
    roles = (crease_role(sheet, edge) for edge in fold_edges(sheet))
    measured: dict[str, Unit] = dict.fromkeys(("creases", *roles), ANGLE)
    for measure in design.measure:
        measured[measure.name] = LENGTH if measure.of is None else ANGLE
    check_stages(design.protocol, [drive.name for drive in design.drive], [], measured)
    _check_torques(design, sheet)
    # what becomes of stages and of states stands side by side in a summary, and in the rows of a table
    names: list[str] = []
    for number, stage in enumerate(design.protocol.stages):
        for key, name in (("name", stage.name), ("state", stage.state)):
            if name is not None:
                _check_name(f"protocol.stages.{number}.{key}", name, names)
                names.append(name)
        written = read_goal(stage.until)
        if written is not None and measured[written.name] is ANGLE:
            _check_goal(design, sheet, f"protocol.stages.{number}.until", written)
        elif written is not None and parse_quantity(written.value, LENGTH) <= 0:
            raise InputError(f"protocol.stages.{number}.until: need a distance > 0 m, got {as_written(stage.until)}")


def _check_torques(design: PlatesDesign, sheet: CreasePattern) -> None:
    """Refuse a stage whose drives, at any time, cancel on every crease."""
    for number, stage in enumerate(design.protocol.stages):
        drives = [drive for drive in design.drive if drive.name in stage_drives(stage)]
        if len(drives) < 2:
            continue
        torques = dict.fromkeys(fold_edges(sheet), 0.0)
        for drive in drives:
            for edge in creases_of(sheet, drive.of):
                torques[edge] += drive.value
        largest = max(abs(drive.value) for drive in drives)
        alike = len({drive.rise for drive in drives}) == 1
        if largest and alike and max(map(abs, torques.values())) <= _ROUNDING * largest:
            raise InputError(
                f"protocol.stages.{number}.drive: need drives that do not cancel on every crease, got"
                f" {as_written(stage.drive)}, {' and '.join(show_quantity(drive.value, TORQUE) for drive in drives)}"
            )


def _check_name(key: str, name: str, names: Sequence[str]) -> None:
    """Refuse a name of a stage or of a state that is empty, or that something else has."""
    if not name.strip():
        raise InputError(f"{key}: need a name, got {as_written(name)}")
    if name in _TAKEN:
        raise InputError(f"{key}: need a name that tables have for nothing else, got {as_written(name)}")
    if name in names:
        raise InputError(f"{key}: need a name that no stage and no other state has, got {as_written(name)} again")


def _check_goal(design: PlatesDesign, sheet: CreasePattern, key: str, written: GoalText) -> None:
    """Refuse a bound on fold angles that a stop keeps a crease from."""
    measure = next((each for each in design.measure if each.name == written.name), None)
    creases = creases_by_edge(design)
    for edge in creases_of(sheet, written.name if measure is None else str(measure.of)):
        low, high = -creases[edge].back_limit, creases[edge].fold_limit
        if measure is not None and sheet.edges_assignment[edge] == "M":
            # measures are valley positive
            low, high = -high, -low
        check_bound(key, written, low, high, whose=f"crease {edge}")


def _keyed(key: str, find: Callable[[CreasePattern, str], Found], sheet: CreasePattern, text: str) -> Found:
    """What a text names on a sheet; an error begins with its key."""
    try:
        return find(sheet, text)
    except InputError as error:
        raise InputError(f"{key}: {error}") from None
