"""Rigid plates on the facets of a sheet, hinged at its creases: their sections, and what must fit together."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeVar

import numpy as np
from pydantic import Field, create_model, field_validator, model_validator

from forficula.design.design import Design, check_duration
from forficula.design.part import (
    ANGLE,
    DENSITY,
    LENGTH,
    SMALL_LENGTH,
    STIFFNESS,
    TENDON_DAMPING,
    TIME,
    TORQUE,
    Part,
    quantity,
)
from forficula.design.protocol import GoalText, check_bound, check_stages, read_goal, stage_drives
from forficula.design.sheet_places import (
    crease_groups,
    crease_role,
    creases_between,
    creases_of,
    facet_of,
    fold_edges,
    keeps_distance,
    place_on,
)
from forficula.errors import InputError
from forficula.pattern import CreasePattern, facet_tree, pleat_pattern
from forficula.quantities import Unit, as_written, parse_quantity, show_quantity

CREASE_STIFFNESS = Unit(display="N m/rad/m", si="N m/rad/m", example="1e-2 N m/rad/m")
CREASE_DAMPING = Unit(display="N m s/rad/m", si="N m s/rad/m", example="1e-3 N m s/rad/m")
Found = TypeVar("Found")

_MOST_PANELS = 1000
# share of the largest torque that a sum of torques may be off by
_ROUNDING = 1e-12
# what dotted keys and bounds in a protocol can hold
_NAME = re.compile(r"[A-Za-z][\w -]{0,59}")
_RESERVED = ("none", "time", "rest", "creases", "mountains", "valleys")
# what summaries and tables have beside the names of stages and states
_TAKEN = (
    *("design", "design_hash", "status", "verdict", "outcome", "residual", "advice", "goal", "key"),
    *("states", "stages", "energy_balance", "diverged_at_s", "timestep_s", "warnings", "versions"),
)


class Pleats(Part):
    """The sheet: a strip of panels one after another, with a crease between every two."""

    kind: Annotated[Literal["pleats"], Field(description="the family of crease patterns")]
    panels: Annotated[int, Field(strict=True, ge=2, le=_MOST_PANELS, description="how many panels the strip has")]
    panel_lengths: tuple[float, ...] = quantity(
        LENGTH, "lengths of the panels along the strip, repeated where there are more panels", above=0
    )
    width: float = quantity(LENGTH, "width of the strip, along the creases", above=0)
    assignment: Annotated[
        str, Field(description="M (mountain) or V (valley) for every crease, repeated where there are more creases")
    ]

    @model_validator(mode="after")
    def _can_be_drawn(self) -> Pleats:
        for key, given, most, what in (
            ("panel_lengths", len(self.panel_lengths), self.panels, "lengths, one for each panel"),
            ("assignment", len(self.assignment), self.panels - 1, "letters, one for each crease"),
        ):
            if not 1 <= given <= most:
                raise InputError(f"pattern.{key}: need 1 to {most} {what}, got {given}")
        if set(self.assignment) - {"M", "V"}:
            raise InputError(
                f"pattern.assignment: need letters M (mountain) and V (valley), got {as_written(self.assignment)}"
            )
        _ = self.sheet
        return self

    @property
    def sheet(self) -> CreasePattern:
        """The crease pattern."""
        lengths, letters = self.panel_lengths, self.assignment
        return pleat_pattern(
            [lengths[panel % len(lengths)] for panel in range(self.panels)],
            self.width,
            "".join(letters[crease % len(letters)] for crease in range(self.panels - 1)),
        )


Whole = Annotated[int, Field(strict=True)]


class FoldFile(Part):
    """The sheet: as a FOLD file has it."""

    kind: Annotated[Literal["fold-file"], Field(description="where the pattern comes from")]
    path: Annotated[
        str | None,
        Field(description="of the FOLD file, from the design file on; what it holds is kept", examples=["sheet.fold"]),
    ] = None
    title: Annotated[str, Field(description="what the sheet is")] = ""
    vertices_x: tuple[float, ...] = quantity(LENGTH, "x of every vertex of the flat sheet", default=())
    vertices_y: tuple[float, ...] = quantity(LENGTH, "y of every vertex", default=())
    edges: Annotated[tuple[tuple[Whole, Whole], ...], Field(description="the two vertices of every edge")] = ()
    assignment: Annotated[str, Field(description="letter of every edge: B, M, V, F or C")] = ""
    roles: Annotated[tuple[str, ...], Field(description="what every edge is called with others of its kind")] = ()
    facets: Annotated[tuple[tuple[Whole, ...], ...], Field(description="the vertices of every facet")] = ()

    @model_validator(mode="after")
    def _is_a_sheet(self) -> FoldFile:
        if not self.vertices_x:
            raise InputError('pattern.path: is missing; name a FOLD file, as in path = "sheet.fold"')
        if len(self.vertices_x) != len(self.vertices_y):
            raise InputError(
                f"pattern.vertices_y: need {len(self.vertices_x)} entries, as pattern.vertices_x has,"
                f" got {len(self.vertices_y)}"
            )
        try:
            _ = self.sheet
        except InputError as error:
            raise InputError(f"pattern: {error}") from None
        return self

    @property
    def sheet(self) -> CreasePattern:
        """The crease pattern."""
        angles = {"M": -math.pi, "V": math.pi, "F": 0.0}
        return CreasePattern(
            title=self.title,
            vertices_coords=np.column_stack([self.vertices_x, self.vertices_y, np.zeros(len(self.vertices_x))]),
            edges_vertices=np.array(self.edges, dtype=np.int64).reshape(-1, 2),
            edges_assignment=tuple(self.assignment),
            edges_fold_angle=np.array([angles.get(letter, math.nan) for letter in self.assignment]),
            edges_role=self.roles,
            faces_vertices=self.facets,
        )


class Facet(Part):
    """The plates, one on every facet."""

    thickness: float = quantity(SMALL_LENGTH, "thickness", above=0)
    density: float = quantity(DENSITY, "mass by volume", above=0)


class CreaseGroup(Part):
    """Creases that differ from the others; what is left out is as in [crease]."""

    of: Annotated[str, Field(description="which: mountains, valleys, a role, or crease 2", examples=["crease 0"])]
    stiffness: float | None = quantity(CREASE_STIFFNESS, "of their springs by length", default=None, at_least=0)
    rest_angle: float | None = quantity(ANGLE, "where their springs rest", default=None, examples=["0 deg"])
    damping: float | None = quantity(CREASE_DAMPING, "viscous damping by length", default=None, at_least=0)
    fold_limit: float | None = quantity(
        ANGLE, "how far they fold", default=None, above=0, at_most=math.pi, examples=["175 deg"]
    )
    back_limit: float | None = quantity(
        ANGLE, "how far the other way", default=None, at_least=0, at_most=math.pi, examples=["3 deg"]
    )
    start: float | None = quantity(ANGLE, "how far folded they start", default=None, examples=["-1 deg"])


class Crease(Part):
    """The hinges at the creases; angles count in a crease's own sense, folding as assigned positive, 0 flat."""

    stiffness: float = quantity(CREASE_STIFFNESS, "of the spring in a crease by its length", at_least=0)
    rest_angle: float = quantity(ANGLE, "where that spring rests", default=0.0, at_least=-math.pi, at_most=math.pi)
    damping: float = quantity(CREASE_DAMPING, "viscous damping by length of crease", default=0.0, at_least=0)
    fold_limit: float = quantity(ANGLE, "how far a crease folds", default=math.pi, above=0, at_most=math.pi)
    back_limit: float = quantity(ANGLE, "how far it bends the other way", default=0.0, at_least=0, at_most=math.pi)
    start: float = quantity(ANGLE, "how far folded it starts", default=0.0)
    group: Annotated[
        tuple[CreaseGroup, ...], Field(description="creases that differ, of several that say so the last one counts")
    ] = ()


def _between(description: str, **default: Any) -> Any:
    """A named part with the keys "from" and "to", which are no names in Python."""
    end: Any = Annotated[str | None if default else str, Field(description=description, **default)]
    return create_model("_Between", __base__=Part, **{"name": str, "from": end, "to": end})


if TYPE_CHECKING:

    class _Joined(Part):
        """What `_between` makes."""

    class _MaybeJoined(Part):
        """What `_between` makes."""

else:
    _Joined = _between("where it ends: vertex 4, edge 12 at 0.5, facet 3 at centre, facet 3 at 0.5, 1")
    _MaybeJoined = _between("of a distance: where it begins and ends", default=None)


def _checked_name(name: str) -> str:
    if not _NAME.fullmatch(name):
        raise InputError(
            f"need a name of letters, digits, spaces, - and _ that begins with a letter, got {as_written(name)}"
        )
    if name in _RESERVED:
        raise InputError(f"need a name that means nothing yet, got {as_written(name)}")
    return name


class PlateTendon(_Joined):
    """A spring between two places that pulls and never pushes."""

    name: Annotated[str, Field(description="what tables and figures call it")]
    stiffness: float = quantity(STIFFNESS, "force by extension beyond the resting length", at_least=0)
    rest_length: float = quantity(LENGTH, "length below which it does not pull", at_least=0)
    damping: float = quantity(TENDON_DAMPING, "viscous damping, at any length", default=0.0, at_least=0)

    _checked = field_validator("name")(_checked_name)


class Support(Part):
    """What is held."""

    of: Annotated[str, Field(description="the facet that is held, such as facet 0")]


class PlateDrive(Part):
    """What a stage of the protocol switches on."""

    name: Annotated[str, Field(description="as stages call it")]
    kind: Annotated[Literal["torque"], Field(description="what it is")]
    of: Annotated[str, Field(description="where it acts: creases, mountains, valleys, a role, or crease 2")]
    value: float = quantity(TORQUE, "torque on each of these creases, folding where > 0")
    rise: float | None = quantity(
        TIME, "time over which it rises evenly from 0; without it protocol.rise", default=None, at_least=0
    )

    _checked = field_validator("name")(_checked_name)


class PlateMeasure(_MaybeJoined):
    """What is watched by name, for goals and tables."""

    name: Annotated[str, Field(description="as goals and tables call it")]
    kind: Annotated[
        Literal["fold-angle", "distance"],
        Field(description="fold-angle: of creases, valley positive; distance: of two places"),
    ]
    of: Annotated[
        str | None, Field(description="of a fold angle: creases, mountains, valleys, a role, or crease 2")
    ] = None

    _checked = field_validator("name")(_checked_name)

    @model_validator(mode="after")
    def _has_what_its_kind_needs(self) -> PlateMeasure:
        given = [key for key in ("of", "from", "to") if getattr(self, key) is not None]
        needed = ["of"] if self.kind == "fold-angle" else ["from", "to"]
        if given != needed:
            got = " and ".join(given) or "neither of them"
            raise InputError(f'kind = "{self.kind}" needs {" and ".join(needed)}, and nothing else; got {got}')
        return self


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
