"""What must fit together in the design of a sheet of rigid facets, which are hinged in a tree."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from forficula.design.crease_values import creases_by_edge, stops
from forficula.design.part import ANGLE, SMALL_LENGTH
from forficula.design.sheet_creases import creases_between, creases_of
from forficula.design.sheet_places import keeps_distance, place_on
from forficula.errors import InputError
from forficula.pattern import CreasePattern, facet_tree
from forficula.pattern.rigidity import rigidity
from forficula.quantities import as_written, show_quantity

if TYPE_CHECKING:
    from forficula.design.sheet import SheetDesign

Array = NDArray[np.float64]

# share of a sheet's size by which a facet's corners may lie off its plane: rounding
_FLAT = 1e-9
_INSTEAD = 'or take facet.kind = "bars", of which facets bend'


def check_rigid(sheet: CreasePattern) -> None:
    """Refuse a sheet whose facets cannot be rigid.

    Raises:
        InputError: facets that are not flat, a sheet that is not flat as built, or creases that close a loop.
    """
    coords = sheet.vertices_coords
    for facet, corners in enumerate(sheet.faces_vertices):
        away = _out_of_plane(coords[list(corners)])
        if away > _FLAT * float(np.ptp(coords, axis=0).max()):
            raise InputError(
                f"facet.kind: need flat facets where they are rigid, got facet {facet}, whose corners lie up to"
                f" {show_quantity(away, SMALL_LENGTH)} off its plane; {_INSTEAD}"
            )
    if np.ptp(coords[:, 2]) > 0:
        low, high = coords[:, 2].min(), coords[:, 2].max()
        raise InputError(
            "facet.kind: rigid facets are built of a flat sheet: need one z for all vertices of pattern, got"
            f" {low:.6g} to {high:.6g} m; {_INSTEAD}"
        )
    try:
        facet_tree(sheet)
    except InputError as error:
        raise InputError(f"pattern: {error}; {_INSTEAD}{_freedoms(sheet)}") from None


def _freedoms(sheet: CreasePattern) -> str:
    """In how many ways a sheet moves, as the end of a sentence; "" of one whose facets cannot be counted on."""
    try:
        rigid, bending = (rigidity(sheet, bending=bends).mechanisms for bends in (False, True))
    except InputError:
        return ""
    return f"; as built it can begin to move in {rigid} ways with rigid facets and in {bending} where they bend"


def _out_of_plane(corners: Array) -> float:
    """How far the corners of a polygon lie off the plane that fits them best, m."""
    away = corners - corners.mean(axis=0)
    normal = np.linalg.svd(away)[2][2]
    return float(np.abs(away @ normal).max())


def check_rigid_creases(design: SheetDesign) -> None:
    """Refuse creases that start beyond their stops.

    Raises:
        InputError: which key, and its bounds.
    """
    for edge, crease in creases_by_edge(design).items():
        low, high = stops(design, crease)
        if not low <= crease.start <= high:
            start, back, fold = (_crease_key(design, edge, key) for key in ("start", "back_limit", "fold_limit"))
            raise InputError(
                f"{start}: need >= {show_quantity(low, ANGLE)} (-{back}) and"
                f" <= {show_quantity(high, ANGLE)} ({fold}) at crease {edge},"
                f" got {show_quantity(crease.start, ANGLE)}"
            )


def check_rigid_tendon(sheet: CreasePattern, number: int, ends: Sequence[str]) -> None:
    """Refuse a tendon whose length no crease changes.

    Raises:
        InputError: why.
    """
    one, other = (place_on(sheet, end) for end in ends)
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
            f" never changes, got {as_written(ends[1])}: {why}"
        )


def _crease_key(design: SheetDesign, edge: int, key: str) -> str:
    """Where a crease has a value from: the last group that gives it, or the section."""
    groups = design.crease.group
    given = (
        f"crease.group.{number}.{key}"
        for number, group in reversed(list(enumerate(groups)))
        if getattr(group, key) is not None and edge in creases_of(design.sheet, group.of, groups[:number])
    )
    return next(given, f"crease.{key}")
