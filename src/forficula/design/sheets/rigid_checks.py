"""Checks of the design of a sheet of rigid facets, whose creases are hinges or open."""

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

_INSTEAD = 'or take facet.kind = "bars", whose facets bend'
# largest distance of a facet's corners from its plane, as a share of its size: rounding of files with seven digits
_OFF_PLANE = 1e-6


def check_rigid(design: SheetDesign) -> None:
    """Refuse a sheet whose facets cannot be rigid, regardless of its supports.

    Raises:
        InputError: facets are not flat or cannot move, or some loops have a crease that opens and others have none.
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
    # a crease that may bend in both senses counts as unassigned
    letters = tuple(
        "U" if edge in creases and stops(design, edge, creases[edge])[0] < 0 else letter
        for edge, letter in enumerate(sheet.edges_assignment)
    )
    why = _stuck(sheet.vertices_coords.tobytes(), sheet.edges_vertices.tobytes(), letters, sheet.faces_vertices)
    if why:
        raise InputError(f"facet.kind: need a sheet that folds with rigid facets: {why}; {_INSTEAD}")


@lru_cache(maxsize=64)
def _uneven_facet(sheet: CreasePattern) -> int | None:
    """Return the first facet whose corners do not lie in a plane; None if all facets are flat."""
    for facet, corners in enumerate(sheet.faces_vertices):
        positions = sheet.vertices_coords[list(corners)]
        extents = np.linalg.svd(positions - positions.mean(axis=0), compute_uv=False)
        if extents[2] > _OFF_PLANE * extents[0]:
            return facet
    return None


def check_rigid_supports(design: SheetDesign) -> None:
    """Refuse supports to which some of the facets are not connected.

    Raises:
        InputError: facets that are not connected.
    """
    try:
        facet_tree(design.sheet, design.held_facets, _opening(design))
    except InputError as error:
        raise InputError(f"support: {error}") from None


def _opening(design: SheetDesign) -> list[int]:
    """Return the numbers of the edges whose creases open."""
    return [edge for edge, crease in creases_by_edge(design).items() if crease.extension is not None]


@lru_cache(maxsize=64)
def _stuck(coords: bytes, edges: bytes, letters: tuple[str, ...], faces: tuple[tuple[int, ...], ...]) -> str:
    """Return the reason why a sheet of rigid facets does not fold; empty if none is known. Takes up to a second.

    A flat sheet is refused only if it provably has no fold as assigned, a folded sheet if its rank shows that it cannot
    move.
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
    fixed = [creases.vertex for creases in vertex_creases(sheet) if vertex_folds(sheet, creases) is False]
    if fixed:
        return f"around vertex {fixed[0]} it has 0 degrees of freedom in which every crease folds as assigned"
    if not begins_as_assigned(sheet):
        count = rigidity(sheet).mechanisms
        return f"none of its {count} degrees of freedom, flat and first order, folds every crease as assigned"
    return ""


def check_rigid_creases(design: SheetDesign) -> None:
    """Refuse creases that start beyond their stops, and starts at which the facets do not meet.

    Raises:
        InputError: a key beyond its bounds.
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
            raise InputError(f"{start}: need 0 deg for a sheet that starts as built, got {_shown(crease.start)}")
        starts[edge] = crease_sense(sheet, edge) * crease.start
        if not low <= (crease.start or folded) <= high:
            key = start if unfolded else "pattern"
            raise InputError(
                f"{key}: need >= {_shown(low + 0.0)} (-{back}) and <= {_shown(high)} ({fold}) at crease {edge},"
                f" got {_shown(crease.start or folded)}"
            )
    if starts.any():
        why = _torn(sheet, starts.tobytes())
        if why:
            raise InputError(f"crease.start: need angles at which the facets meet: {why}")


@lru_cache(maxsize=64)
def _torn(sheet: CreasePattern, angles: bytes) -> str:
    """Return the reason why facets do not meet at given fold angles; empty if they meet."""
    try:
        folded_coordinates(sheet, np.frombuffer(angles))
    except InputError as error:
        return str(error)
    return ""


def _shown(value: float) -> str:
    """Return an angle as text for messages."""
    return show_quantity(value, ANGLE)


def check_rigid_tendon(design: SheetDesign, number: int, ends: Sequence[str]) -> None:
    """Refuse a tendon whose length does not depend on any fold angle.

    Raises:
        InputError: the length never changes.
    """
    sheet = design.sheet
    one, other = (place_on(sheet, end) for end in ends)
    if one.facet == other.facet:
        raise InputError(
            f"tendon.{number}.to: need a place on another facet than tendon.{number}.from, or the length never"
            f" changes, got facet {one.facet} for both"
        )
    if not design.opens and keeps_distance(sheet, one, other):
        between = creases_between(sheet, one.facet, other.facet)
        why = "it lies on the axis of every crease between them" if between else "no crease lies between them"
        raise InputError(
            f"tendon.{number}.to: need a place that moves relative to tendon.{number}.from, or the length never"
            f" changes, got {as_written(ends[1])}: {why}"
        )
