"""What must fit together in the design of a sheet of rigid facets, hinged at its creases or opening there."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np

from forficula.design.section import ANGLE
from forficula.design.sheets.crease_values import crease_key, creases_by_edge, stops
from forficula.design.sheets.sheet_creases import crease_sense, creases_between
from forficula.design.sheets.sheet_places import keeps_distance, place_on
from forficula.errors import InputError
from forficula.pattern import (
    CreasePattern,
    begins_as_assigned,
    facet_tree,
    folded_coordinates,
    rigidity,
    vertex_creases,
    vertex_folds,
)
from forficula.pattern.crease_pattern import is_unfolded
from forficula.pattern.fold_angles import built_fold_angles
from forficula.quantities import as_written, show_quantity

if TYPE_CHECKING:
    from forficula.design.sheets.sheet import SheetDesign

_INSTEAD = 'or take facet.kind = "bars", of which facets bend'
# share of a facet's size by which its corners may be off its plane: rounding of files with seven digits
_OFF_PLANE = 1e-6


def check_rigid(design: SheetDesign) -> None:
    """Refuse a sheet whose facets cannot be rigid, wherever it is held.

    Raises:
        InputError: facets that are not flat, or that do not move, and some creases that open beside others that do not.
    """
    sheet = design.sheet
    facet = _uneven_facet(sheet)
    if facet is not None:
        raise InputError(f"facet.kind: need flat facets to be rigid, got facet {facet}, which is not; {_INSTEAD}")
    creases = creases_by_edge(design)
    opening = _opening(design)
    try:
        links = facet_tree(sheet, apart=opening)
    except InputError as error:
        raise InputError(f"pattern: {error}; {_INSTEAD}") from None
    closing = [link.edge for link in links if link.closes]
    if closing and opening:
        raise InputError(
            "crease.extension: need a crease that opens in every loop, or in none, got none in that of crease"
            f" {closing[0]}"
        )
    if not closing:
        return
    # what may bend either way has no sense to be folded in
    letters = tuple(
        "U" if edge in creases and stops(design, edge, creases[edge])[0] < 0 else letter
        for edge, letter in enumerate(sheet.edges_assignment)
    )
    why = _stuck(sheet.vertices_coords.tobytes(), sheet.edges_vertices.tobytes(), letters, sheet.faces_vertices)
    if why:
        raise InputError(f"facet.kind: need a sheet that folds with rigid facets: {why}; {_INSTEAD}")


@lru_cache(maxsize=64)
def _uneven_facet(sheet: CreasePattern) -> int | None:
    """The first facet whose corners lie in no plane; None where all do."""
    for facet, corners in enumerate(sheet.faces_vertices):
        places = sheet.vertices_coords[list(corners)]
        off = np.linalg.svd(places - places.mean(axis=0), compute_uv=False)
        if off[2] > _OFF_PLANE * off[0]:
            return facet
    return None


def check_rigid_supports(design: SheetDesign) -> None:
    """Refuse supports on which some of the facets do not hang.

    Raises:
        InputError: which facets.
    """
    try:
        facet_tree(design.sheet, design.held_facets, _opening(design))
    except InputError as error:
        raise InputError(f"support: {error}") from None


def _opening(design: SheetDesign) -> list[int]:
    """The edges of creases that open."""
    return [edge for edge, crease in creases_by_edge(design).items() if crease.extension is not None]


@lru_cache(maxsize=64)
def _stuck(coords: bytes, edges: bytes, letters: tuple[str, ...], faces: tuple[tuple[int, ...], ...]) -> str:
    """Why a sheet of rigid facets does not fold; empty where nothing says so. Remembered, for it takes up to a second.

    A flat sheet is let go only where it provably has no fold as assigned; one that is folded, where rank says so.
    """
    sheet = CreasePattern(
        vertices_coords=np.frombuffer(coords).reshape(-1, 3),
        edges_vertices=np.frombuffer(edges, dtype=np.int64).reshape(-1, 2),
        edges_assignment=letters,
        edges_fold_angle=np.full(len(letters), np.nan),
        faces_vertices=faces,
    )
    if not is_unfolded(sheet):
        freedoms = rigidity(sheet)
        if freedoms.mechanisms > 0:
            return ""
        return f"as built it has 0 degrees of freedom and {freedoms.self_stress} states of self-stress"
    fixed = [each.vertex for each in vertex_creases(sheet) if vertex_folds(sheet, each) is False]
    if fixed:
        return f"around vertex {fixed[0]} it has 0 degrees of freedom in which every crease folds as assigned"
    if not begins_as_assigned(sheet):
        count = rigidity(sheet).mechanisms
        return f"none of its {count} degrees of freedom, flat and first order, folds every crease as assigned"
    return ""


def check_rigid_creases(design: SheetDesign) -> None:
    """Refuse creases that start beyond their stops, or where the facets do not meet.

    Raises:
        InputError: which key, and its bounds.
    """
    sheet, creases = design.sheet, creases_by_edge(design)
    unfolded = is_unfolded(sheet)
    built = np.zeros(len(sheet.edges_vertices)) if unfolded else built_fold_angles(sheet)
    starts = np.zeros(len(built))
    for edge, crease in creases.items():
        low, high = stops(design, edge, crease)
        folded = crease_sense(sheet, edge) * float(built[edge])
        start, back, fold = (crease_key(design, edge, key) for key in ("start", "back_limit", "fold_limit"))
        if crease.start and (design.opens or not unfolded):
            raise InputError(f"{start}: need 0 deg where a sheet starts as it is built, got {_shown(crease.start)}")
        starts[edge] = crease_sense(sheet, edge) * crease.start
        if not low <= (crease.start or folded) <= high:
            key = start if unfolded else "pattern"
            raise InputError(
                f"{key}: need >= {_shown(low)} (-{back}) and <= {_shown(high)} ({fold}) at crease {edge},"
                f" got {_shown(crease.start or folded)}"
            )
    if starts.any():
        why = _torn(sheet, starts.tobytes())
        if why:
            raise InputError(f"crease.start: need angles at which the facets meet: {why}")


@lru_cache(maxsize=64)
def _torn(sheet: CreasePattern, angles: bytes) -> str:
    """Why facets do not meet at fold angles; empty where they do."""
    try:
        folded_coordinates(sheet, np.frombuffer(angles))
    except InputError as error:
        return str(error)
    return ""


def _shown(value: float) -> str:
    """An angle as messages show it."""
    return show_quantity(value, ANGLE)


def check_rigid_tendon(design: SheetDesign, number: int, ends: Sequence[str]) -> None:
    """Refuse a tendon whose length no crease changes.

    Raises:
        InputError: why.
    """
    sheet = design.sheet
    one, other = (place_on(sheet, end) for end in ends)
    if one.facet == other.facet:
        raise InputError(
            f"tendon.{number}.to: need a place on another facet than tendon.{number}.from, or its length never"
            f" changes, got facet {one.facet} for both"
        )
    if not design.opens and keeps_distance(sheet, one, other):
        between = creases_between(sheet, one.facet, other.facet)
        why = "it lies on the axis of every crease between them" if between else "no crease lies between them"
        raise InputError(
            f"tendon.{number}.to: need a place that creases move against tendon.{number}.from, or its length"
            f" never changes, got {as_written(ends[1])}: {why}"
        )
