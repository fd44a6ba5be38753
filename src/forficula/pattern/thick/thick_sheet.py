"""Sheets of thick panels: heights of panels and axes, solids of the panels, and whether they fold without overlap."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import Literal

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.pattern.crease_pattern import CreasePattern
from forficula.pattern.facet_tree import facet_tree
from forficula.pattern.facts.rigid_folding import senses
from forficula.pattern.facts.vertex_creases import vertex_creases
from forficula.pattern.geometry import polygon_normal
from forficula.pattern.kinematics import folded_coordinates
from forficula.pattern.rotation import RigidMotion
from forficula.pattern.shared_edges import shared_edges
from forficula.pattern.thick.convex import ConvexSolid
from forficula.pattern.thick.panel_heights import panel_heights, unique_first
from forficula.pattern.thick.panel_solids import Layer, panel_cores, panel_solids
from forficula.pattern.thick.thick_motion import built_angles, deepest_overlap, facet_motions, fold_path
from forficula.quantities import show_value

ThickMethod = Literal["offset", "tapered", "hinge-shift"]
Limits = tuple[tuple[float, float], ...]

_ROUNDING = 1e-9
_FLAT_FOLDABLE = 1e-6  # rad, sums of sectors that differ by less are equal
_TOUCHING = 1e-6  # of the thickness; panels that overlap by less touch
# search for the largest thickness: least one that is tried, as a share of the given one, and halvings of the range
_THIN, _HALVINGS = 1e-3, 12


@dataclass(frozen=True, kw_only=True, eq=False)
class ThickSheet:
    """Thick panels on the facets of a sheet, in the position as built.

    The panels turn like the facets of the sheet without thickness.

    Attributes:
        thickness: of all panels, m.
        layers: panels over the facets, without trimmed sides, brackets and cut-outs.
        axes: heights of the axes of creases over the sheet without thickness, m, (edge,); 0 on other edges.
        axis_ends: positions of the two vertices of every edge on its axis, m, (edge, 2, 3).
        panels: convex solids of each panel, which touch but do not overlap: the panel, which may consist of pieces,
            then brackets that carry axes outside it.
        cores: corners of a polygon in the mid-plane of each panel, m, (corner, 3), for contact; see `panel_cores`.
        path: fold angles, rad, (pose, edge), at which the panels do not overlap; see `fold_path`. None if they were not
            checked.
    """

    thickness: float
    layers: tuple[Layer, ...]
    axes: Array
    axis_ends: Array
    panels: tuple[tuple[ConvexSolid, ...], ...]
    cores: tuple[Array | None, ...]
    path: Array | None


def thick_sheet(pattern: CreasePattern, thickness: float, method: ThickMethod, limits: Limits) -> ThickSheet:
    """Give the facets of a sheet a thickness so that the panels do not overlap while they fold.

    - "offset": panels are shifted along their normals from the plane of the axes, which stay as in the sheet without
      thickness (Edmondson, Lang, Magleby and Howell 2014, ASME IDETC, V05BT08A054).
    - "tapered": panels lie on both sides of the sheet without thickness and are trimmed at the planes that bisect the
      angles of creases at their largest fold angle (Tachi 2011, Rigid-foldable thick origami, Origami 5).
    - "hinge-shift": axes are shifted along the normals of the panels. Those at a vertex form a Bennett linkage, whose
      fold angles are those of the sheet without thickness (Chen, Peng and You 2015, doi 10.1126/science.aab2870).

    Args:
        pattern: flat or folded as built.
        thickness: m.
        method: see above.
        limits: least and largest fold angle of every edge, valley positive, rad.

    Raises:
        InputError: the method cannot give the sheet this thickness.
    """
    made = _made(pattern, thickness, method, limits)
    if isinstance(made, str):
        raise InputError(made)
    return made


@lru_cache(maxsize=16)  # checks and structures of designs with the same sheet need it
def _made(pattern: CreasePattern, thickness: float, method: ThickMethod, limits: Limits) -> ThickSheet | str:
    """Return a sheet as `thick_sheet`, or the reason why there is none."""
    try:
        return _checked(pattern, thickness, method, limits)
    except InputError as error:
        return str(error)


def _checked(pattern: CreasePattern, thickness: float, method: ThickMethod, limits: Limits) -> ThickSheet:
    """Return a sheet as `thick_sheet`; raise InputError if the method cannot give it this thickness."""
    facets = len(pattern.faces_vertices)
    for facet, face in enumerate(pattern.faces_vertices):
        _check_convex(pattern.vertices_coords[list(face)], facet)
    if method == "hinge-shift":
        _check_vertices(pattern)
    normals = np.array([polygon_normal(pattern.vertices_coords[list(face)]) for face in pattern.faces_vertices])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    levels, axes = np.zeros(facets), np.zeros(len(pattern.edges_vertices))
    if method != "tapered":
        levels, axes = _unit_heights(pattern, shifted=method == "hinge-shift")
    trims = limits if method == "tapered" else None
    path = fold_path(pattern, limits)

    def sheet(chosen: float) -> ThickSheet:
        """Return the sheet with panels of a thickness, which may overlap."""
        return _sheet(pattern, normals, chosen, chosen * levels, chosen * axes, trims, path)

    made = sheet(thickness)
    why = _fault(pattern, made)
    if not why:
        return made
    low, high = _THIN * thickness, thickness
    if _fault(pattern, sheet(low)):
        raise InputError(f"{why}, also with thinner panels")
    for _ in range(_HALVINGS):
        middle = (low + high) / 2
        low, high = (low, middle) if _fault(pattern, sheet(middle)) else (middle, high)
    # rounded down to three digits
    step = 10.0 ** (math.floor(math.log10(low)) - 2)
    largest = step * math.floor(low / step)
    raise InputError(f"need <= {show_value(largest, 'm')}, got {show_value(thickness, 'm')}: {why}")


def panel_motions(pattern: CreasePattern, sheet: ThickSheet, angles: Array) -> list[list[RigidMotion]]:
    """Return the motions of panels from the position as built to fold angles, rad, (pose, edge)."""
    built = built_angles(pattern)
    return [facet_motions(pattern, sheet.axis_ends, pose - built) for pose in angles]


def _sheet(
    pattern: CreasePattern,
    normals: Array,
    thickness: float,
    levels: Array,
    axes: Array,
    trims: Limits | None,
    path: Array | None,
) -> ThickSheet:
    """Return a sheet with panels and axes at given heights, m."""
    shifts = np.zeros((len(levels), 3))
    for link in facet_tree(pattern):
        if link.parent is not None and link.edge is not None and not link.closes:
            turned = normals[link.parent] - normals[link.facet]
            shifts[link.facet] = shifts[link.parent] + axes[link.edge] * turned
    layers = tuple(
        Layer(origin=shift, normal=normal, level=float(level), thickness=thickness)
        for shift, normal, level in zip(shifts, normals, levels, strict=True)
    )
    ends = pattern.vertices_coords[pattern.edges_vertices]
    for edge in shared_edges(pattern):
        ends[edge.edge] = [layers[edge.left].at(end, float(axes[edge.edge])) for end in ends[edge.edge]]
    closed = facet_motions(pattern, ends, np.pi * senses(pattern) - built_angles(pattern))
    return ThickSheet(
        thickness=thickness,
        layers=layers,
        axes=axes,
        axis_ends=ends,
        panels=tuple(panel_solids(pattern, layers, axes, closed, trims)),
        cores=panel_cores(pattern, layers, trims),
        path=path,
    )


def _fault(pattern: CreasePattern, sheet: ThickSheet) -> str:
    """Return why panels of a thickness cannot fold; empty if they can."""
    for facet, (layer, solids) in enumerate(zip(sheet.layers, sheet.panels, strict=True)):
        heights = np.concatenate([np.zeros(1), *(solid.corners @ layer.normal for solid in solids)])[1:]
        if not solids or np.ptp(heights) < (1 - _TOUCHING) * sheet.thickness:
            return f"nothing is left of the faces of the panel on facet {facet}"
    if sheet.path is None:
        return ""
    depth, (one, other), pose = deepest_overlap(sheet.panels, panel_motions(pattern, sheet, sheet.path))
    if depth <= _TOUCHING * sheet.thickness:
        return ""
    largest, share = math.degrees(float(np.abs(sheet.path[pose]).max())), 100 * depth / sheet.thickness
    return (
        f"the panels on facets {one} and {other} overlap by {share:.2g} % of the thickness where the largest fold angle"
        f" is {largest:.4g} deg"
    )


def _check_convex(corners: Array, facet: int) -> None:
    """Refuse a facet with a corner that points inwards."""
    sides = np.roll(corners, -1, axis=0) - corners
    turns = np.cross(sides, np.roll(sides, -1, axis=0)) @ polygon_normal(corners)
    if turns.min() < -_ROUNDING * np.abs(turns).max():
        raise InputError(f"need convex facets, got facet {facet}, which is not convex")


def _check_vertices(pattern: CreasePattern) -> None:
    """Refuse vertices whose axes cannot form a Bennett linkage."""
    for vertex in vertex_creases(pattern):
        if not len(vertex.edges):
            continue
        _, sectors, _ = unique_first(pattern, vertex)
        alternating = sectors[0] - sectors[1] + sectors[2] - sectors[3]
        if abs(alternating) > _FLAT_FOLDABLE or abs(vertex.total - 2 * math.pi) > _FLAT_FOLDABLE:
            raise InputError(
                f"vertex {vertex.vertex}: need opposite sectors that add up to 180 deg, as in a vertex that folds flat,"
                f" got {math.degrees(sectors[0] + sectors[2]):.6g} deg and"
                f" {math.degrees(sectors[1] + sectors[3]):.6g} deg"
            )


def _unit_heights(pattern: CreasePattern, *, shifted: bool) -> tuple[Array, Array]:
    """Return the heights of panels and of axes of a sheet that folds flat, in thicknesses."""
    for edge in shared_edges(pattern):
        if pattern.edges_assignment[edge.edge] == "U":
            raise InputError(f"need mountains and valleys, got crease {edge.edge}, which is unassigned")
    try:
        folded = folded_coordinates(pattern, np.pi * senses(pattern) - built_angles(pattern))
    except InputError:
        raise InputError("need a sheet that folds flat without thickness, got one that tears") from None
    # in the plane of the first facet
    corners = pattern.vertices_coords[list(pattern.faces_vertices[0])]
    normal, along = polygon_normal(corners), corners[1] - corners[0]
    frame = np.array([along, np.cross(normal, along), normal])
    frame /= np.linalg.norm(frame, axis=1)[:, None]
    heights = panel_heights(pattern, (folded - corners[0]) @ frame.T, shifted=shifted)
    if heights is None:
        raise InputError("found no heights of panels and axes at which the panels fold onto one another")
    return heights
