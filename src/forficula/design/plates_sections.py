"""Sections of a design of plates, but for its protocol."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING, Annotated, Any, Literal

import numpy as np
from pydantic import Field, create_model, field_validator, model_validator

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
from forficula.errors import InputError
from forficula.pattern import CreasePattern, pleat_pattern
from forficula.quantities import Unit, as_written

CREASE_STIFFNESS = Unit(display="N m/rad/m", si="N m/rad/m", example="1e-2 N m/rad/m")
CREASE_DAMPING = Unit(display="N m s/rad/m", si="N m s/rad/m", example="1e-3 N m s/rad/m")

_MOST_PANELS = 1000
# what dotted keys and bounds in a protocol can hold
_NAME = re.compile(r"[A-Za-z][\w -]{0,59}")
_RESERVED = ("none", "time", "rest", "creases", "mountains", "valleys")


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
