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

# target fold angle by the letter of the edge, rad
FOLDED = {"M": -math.pi, "V": math.pi, "F": 0.0}

Whole = Annotated[int, Field(strict=True)]


class FoldFile(Section):
    """The sheet: a crease pattern from a FOLD, SVG or DXF file."""

    about: ClassVar[str] = "The sheet: a crease pattern from a FOLD, SVG or DXF file"
    later: ClassVar[tuple[str, ...]] = ("folds",)

    kind: Annotated[Literal["fold-file"], Field(description="source of the pattern: a file")]
    path: Annotated[
        str | None,
        Field(
            description="path of a .fold, .svg or .dxf file, relative to this file; its content is copied into the"
            " design",
            examples=["sheet.fold"],
        ),
    ] = None
    unit: float | None = quantity(
        LENGTH,
        "unit of length of a file that states none; if not given, its largest dimension is 20 cm",
        default=None,
        above=0,
        examples=["1 cm"],
    )
    tolerance: float | None = quantity(
        LENGTH,
        "largest gap between lines of a drawing that are joined",
        default=None,
        above=0,
        examples=["0.1 mm"],
    )
    frame: Annotated[
        Whole | str | None,
        Field(description="number, title or class of a frame of a FOLD file", examples=[0]),
    ] = None
    title: Annotated[str, Field(description="title of the sheet")] = ""
    vertices_x: tuple[float, ...] = quantity(LENGTH, "x of every vertex as built", default=())
    vertices_y: tuple[float, ...] = quantity(LENGTH, "y of every vertex as built", default=())
    vertices_z: tuple[float, ...] = quantity(LENGTH, "z of every vertex as built; 0 if not given", default=())
    edges: Annotated[tuple[tuple[Whole, Whole], ...], Field(description="the two vertices of every edge")] = ()
    assignment: Annotated[str, Field(description="letter of every edge: B, M, V, F or C")] = ""
    roles: Annotated[
        tuple[str, ...], Field(description="role of every edge, by which groups of creases are named")
    ] = ()
    facets: Annotated[tuple[tuple[Whole, ...], ...], Field(description="the vertices of every facet")] = ()
    fold_angles: tuple[float | str, ...] = quantity(
        ANGLE,
        'target fold angle of every edge, valley positive, or "none"; if not given, V 180 deg and M -180 deg',
        default=(),
        words=("none",),
        at_least=-math.pi,
        at_most=math.pi,
    )

    folds: Annotated[
        tuple[Whole, ...],
        Field(
            description="number of the fold of every edge in a sheet with split folds: both edges of a split fold"
            " have one number, and each of them has half the angle of the fold; if not given, every edge is a fold"
        ),
    ] = ()

    @model_validator(mode="after")
    def _is_a_sheet(self) -> FoldFile:
        if not self.vertices_x:
            raise InputError('pattern.path: is missing; name a FOLD file, as in path = "sheet.fold"')
        # of a design whose file was read, the content is known, and these keys are removed
        for key, value in (("unit", self.unit), ("tolerance", self.tolerance), ("frame", self.frame)):
            if value is not None:
                raise InputError(f"pattern.{key}: needs pattern.path beside it, because it applies to reading the file")
        for key, values, reference in (
            ("vertices_y", self.vertices_y, self.vertices_x),
            ("vertices_z", self.vertices_z, self.vertices_x),
            ("fold_angles", self.fold_angles, self.assignment),
        ):
            if len(values) != len(reference) and (values or key == "vertices_y"):
                other = "assignment" if key == "fold_angles" else "vertices_x"
                raise InputError(
                    f"pattern.{key}: need {len(reference)} entries, as pattern.{other} has, got {len(values)}"
                )
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
            edges_fold=np.array(self.folds, dtype=np.int64),
            faces_vertices=self.facets,
        )


class FoldFileDesign(SheetDesign):
    """A sheet whose pattern is read from a file, with its protocol."""

    example: ClassVar[Mapping[str, object]] = {"path": "sheet.fold"}

    pattern: FoldFile
