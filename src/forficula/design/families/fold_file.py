"""Designs of sheets whose pattern is read from a file."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Annotated, ClassVar, Literal

import numpy as np
from pydantic import Field, model_validator

from forficula.design.section import ANGLE, LENGTH, Section, quantity
from forficula.design.sheets.sheet import SheetDesign
from forficula.errors import InputError
from forficula.pattern import CreasePattern

# where an edge folds to by its letter, rad
FOLDED = {"M": -math.pi, "V": math.pi, "F": 0.0}

Whole = Annotated[int, Field(strict=True)]


class FoldFile(Section):
    """The sheet: as a file has it, FOLD, SVG or DXF."""

    about: ClassVar[str] = "The sheet: as a file has it, FOLD, SVG or DXF"

    kind: Annotated[Literal["fold-file"], Field(description="where the pattern comes from")]
    path: Annotated[
        str | None,
        Field(
            description="of a .fold, .svg or .dxf file, from here on; what it holds is kept",
            examples=["sheet.fold"],
        ),
    ] = None
    unit: float | None = quantity(
        LENGTH, "length of the file's unit where it names none", default=None, above=0, examples=["1 cm"]
    )
    tolerance: float | None = quantity(
        LENGTH, "of a drawing: how near lines must be to meet", default=None, above=0, examples=["0.1 mm"]
    )
    frame: Annotated[
        Whole | str | None,
        Field(description="number, title or class of its frame", examples=[0]),
    ] = None
    title: Annotated[str, Field(description="what the sheet is")] = ""
    vertices_x: tuple[float, ...] = quantity(LENGTH, "x of every vertex as built", default=())
    vertices_y: tuple[float, ...] = quantity(LENGTH, "y of every vertex", default=())
    vertices_z: tuple[float, ...] = quantity(LENGTH, "z of every vertex; 0 if not given", default=())
    edges: Annotated[tuple[tuple[Whole, Whole], ...], Field(description="the two vertices of every edge")] = ()
    assignment: Annotated[str, Field(description="letter of every edge: B, M, V, F or C")] = ""
    roles: Annotated[tuple[str, ...], Field(description="what every edge is called with others of its kind")] = ()
    facets: Annotated[tuple[tuple[Whole, ...], ...], Field(description="the vertices of every facet")] = ()
    fold_angles: tuple[float | str, ...] = quantity(
        ANGLE,
        'where every edge folds to, valley positive, or "none"; without it V to 180 deg, M to -180 deg',
        default=(),
        words=("none",),
        at_least=-math.pi,
        at_most=math.pi,
    )

    @model_validator(mode="after")
    def _is_a_sheet(self) -> FoldFile:
        if not self.vertices_x:
            raise InputError('pattern.path: is missing; name a FOLD file, as in path = "sheet.fold"')
        for key, given, rule in (
            ("vertices_y", self.vertices_y, self.vertices_x),
            ("vertices_z", self.vertices_z, self.vertices_x),
            ("fold_angles", self.fold_angles, self.assignment),
        ):
            if len(given) != len(rule) and (given or key == "vertices_y"):
                other = "assignment" if key == "fold_angles" else "vertices_x"
                raise InputError(f"pattern.{key}: need {len(rule)} entries, as pattern.{other} has, got {len(given)}")
        try:
            _ = self.sheet
        except InputError as error:
            raise InputError(f"pattern: {error}") from None
        return self

    @property
    def sheet(self) -> CreasePattern:
        """The crease pattern."""
        return CreasePattern(
            title=self.title,
            vertices_coords=np.column_stack(
                [self.vertices_x, self.vertices_y, self.vertices_z or np.zeros(len(self.vertices_x))]
            ),
            edges_vertices=np.array(self.edges, dtype=np.int64).reshape(-1, 2),
            edges_assignment=tuple(self.assignment),
            edges_fold_angle=np.array(
                [math.nan if isinstance(angle, str) else angle for angle in self.fold_angles]
                or [FOLDED.get(letter, math.nan) for letter in self.assignment]
            ),
            edges_role=self.roles,
            faces_vertices=self.facets,
        )


class FoldFileDesign(SheetDesign):
    """A sheet that a file holds, and what is done to it."""

    example: ClassVar[Mapping[str, object]] = {"path": "sheet.fold"}

    pattern: FoldFile
