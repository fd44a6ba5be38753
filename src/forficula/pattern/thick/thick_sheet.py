"""Sheets of thick panels: heights of panels and axes, solids of the panels, and whether they fold without overlap."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import Literal, NamedTuple

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.pattern.crease_pattern import CreasePattern
from forficula.pattern.facet_tree import facet_tree
from forficula.pattern.facts.rigid_folding import senses
from forficula.pattern.facts.vertex_creases import vertex_creases
from forficula.pattern.geometry import polygon_normal
from forficula.pattern.rotation import RigidMotion
from forficula.pattern.shared_edges import shared_edges
from forficula.pattern.thick.convex import ConvexSolid
from forficula.pattern.thick.panel_heights import BRACKETS, bracket_slots, panel_heights, unique_first
from forficula.pattern.thick.panel_solids import Layer, panel_cores, panel_solids, strip_cuts
from forficula.pattern.thick.split_sheet import check_unsplit, split_sheet
from forficula.pattern.thick.thick_motion import (
    POSES,
    built_angles,
    deepest_overlap,
    facet_motions,
    flat_folded,
    fold_path,
)
from forficula.quantities import show_value

ThickMethod = Literal["offset", "tapered", "hinge-shift", "split"]
Limits = tuple[tuple[float, float], ...]

_ROUNDING = 1e-9
_DIGITS = 12  # of lengths, as shares of the size of a sheet
_FLAT_FOLDABLE = 1e-6  # rad, sums of sectors that differ by less are equal
_TOUCHING = 1e-6  # of the thickness; panels that overlap by less touch
# search for the largest thickness: least one that is tried, as a share of the given one, and halvings of the range
_THIN, _HALVINGS = 1e-3, 12


@dataclass(frozen=True, kw_only=True, eq=False)
class ThickSheet:
    """Thick panels on the facets of a sheet, in the position as built.

    The panels turn like the facets of the sheet without thickness.

    Attributes:
        pattern: of the sheet without thickness; with strips at split folds.
        thickness: of the panels, m; strips may be thinner.
        layers: panels over the facets, without trimmed sides, brackets and notches.
        axes: heights of the axes of creases over the sheet without thickness, m, (edge,); 0 on other edges.
        axis_ends: positions of the two vertices of every edge on its axis, m, (edge, 2, 3).
        panels: convex solids of each panel, which touch but do not overlap: the panel, which may consist of pieces,
            then brackets that carry axes outside it.
        notches: convex solids that were cut out of each panel.
        divided: facets of panels that notches divide.
        cores: corners of a polygon in the mid-plane of each panel, m, (corner, 3), for contact; see `panel_cores`.
        path: fold angles, rad, (pose, edge), at which the panels do not overlap; see `fold_path`. None if they were not
            checked.
    """

    pattern: CreasePattern
    thickness: float
    layers: tuple[Layer, ...]
    axes: Array
    axis_ends: Array
    panels: tuple[tuple[ConvexSolid, ...], ...]
    notches: tuple[tuple[ConvexSolid, ...], ...]
    divided: tuple[int, ...]
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
    - "split": two parallel folds with a strip between them replace folds that go around other panels, see
      `split_sheet` (Ku and Demaine 2015, DETC2015-48039).

    Args:
        pattern: flat or folded as built, without strips.
        thickness: m.
        method: see above.
        limits: least and largest fold angle of every edge of the pattern, valley positive, rad.

    Raises:
        InputError: the method cannot give the sheet this thickness.
    """
    made = _made(pattern, thickness, method, limits)
    if isinstance(made, str):
        raise InputError(made)
    return made


@lru_cache(maxsize=16)  # checks and structures of designs with the same sheet need it
def _made(pattern: CreasePattern, thickness: float, method: ThickMethod, limits: Limits) -> ThickSheet | str:
    """Return a sheet as `thick_sheet`, or the reason why there is none.

    Lengths are rounded shares of the size of the sheet, because a run builds a sheet again in other units. Rounding
    errors would otherwise decide how notches divide a panel into pieces, and both sheets would differ.
    """
    size = float(np.ptp(pattern.vertices_coords, axis=0).max())
    rounded = replace(pattern, vertices_coords=np.round(pattern.vertices_coords / size, _DIGITS))
    try:
        made = _checked(rounded, round(thickness / size, _DIGITS), method, limits, size)
    except InputError as error:
        return str(error)
    whole = pattern
    if made.pattern is not rounded:
        whole = replace(made.pattern, vertices_coords=size * made.pattern.vertices_coords)
    layers = [(size * layer.origin, layer.normal, size * layer.level, size * layer.thickness) for layer in made.layers]
    return replace(
        made,
        pattern=whole,
        thickness=size * made.thickness,
        layers=tuple(Layer(*layer) for layer in layers),
        axes=size * made.axes,
        axis_ends=size * made.axis_ends,
        panels=_enlarged(made.panels, size),
        notches=_enlarged(made.notches, size),
        cores=tuple(None if core is None else size * core for core in made.cores),
    )


def _enlarged(panels: Sequence[Sequence[ConvexSolid]], size: float) -> tuple[tuple[ConvexSolid, ...], ...]:
    return tuple(tuple(replace(solid, corners=size * solid.corners) for solid in panel) for panel in panels)


def _checked(pattern: CreasePattern, thickness: float, method: ThickMethod, limits: Limits, size: float) -> ThickSheet:
    """Return a sheet whose lengths are shares of a size, m; raise InputError if the method cannot make it."""
    check_unsplit(pattern)
    facets = len(pattern.faces_vertices)
    for facet, face in enumerate(pattern.faces_vertices):
        _check_convex(pattern.vertices_coords[list(face)], facet)
    if method == "hinge-shift":
        _check_vertices(pattern)
    normals = np.array([polygon_normal(pattern.vertices_coords[list(face)]) for face in pattern.faces_vertices])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    levels, axes = np.zeros(facets), np.zeros(len(pattern.edges_vertices))
    if method in ("offset", "hinge-shift"):
        levels, axes = _unit_heights(pattern, shifted=method == "hinge-shift")
    trims = limits if method == "tapered" else None
    path = fold_path(pattern, limits, slowing=True)
    # brackets pass through notches and strips end where they meet, so these poses are closer than those of the check,
    # and most of them are others
    finer = None if method == "tapered" else fold_path(pattern, limits, 2 * POSES + 1, slowing=True)
    slots: Sequence[tuple[float, float]] = ()

    def sheet(chosen: float, needed: Collection[int] | None = None) -> ThickSheet:
        """Return the sheet with panels of a thickness, which may overlap: all panels, or some and all brackets."""
        if method == "split":
            split = split_sheet(pattern, chosen)
            # a sheet whose path has no closed form is checked where it is folded flat
            checked = split.path(np.asarray((np.pi * senses(pattern))[None]) if path is None else path)
            swept = checked if finer is None else split.path(finer)
            heights = (split.thickness, split.levels, split.axes)
            return _sheet(split.pattern, *heights, checked, swept=swept, meeting=split.meeting, needed=needed)
        heights = (np.full(facets, chosen), chosen * levels, chosen * axes)
        return _sheet(pattern, *heights, path, swept=finer, trims=trims, slots=slots, needed=needed)

    shared = method in ("offset", "hinge-shift")
    made = sheet(thickness, () if shared else None)
    fault = _fault(made, () if shared else None)
    if shared and fault is None:
        made = sheet(thickness)
        fault = _fault(made)
    if shared and fault is not None:
        # brackets of different creases may meet, but not at different places along the creases
        slots = bracket_slots(pattern, flat_folded(pattern))
        made = sheet(thickness)
        fault = _fault(made)
    if fault is None:
        return made
    largest = _largest_thickness(sheet, thickness, fault, size)
    if largest is None:
        raise InputError(f"{fault.text}, also with thinner panels")
    raise InputError(
        f"need <= {show_value(size * largest, 'm')}, got {show_value(size * thickness, 'm')}: {fault.text}; a sheet"
        f" that is {_rounded_up(thickness / largest)} times as large would also fold flat"
    )


def _largest_thickness(
    sheet: Callable[[float, Collection[int] | None], ThickSheet], thickness: float, fault: _Fault, size: float
) -> float | None:
    """Compute the largest thickness of panels that fold, as a share of a size, rounded down to three digits in metres.

    Bisection finds the largest thickness for the panels of a fault. If other panels have a fault at this thickness, it
    is repeated for them.

    Args:
        sheet: function that returns the sheet with panels of a thickness, or only the panels on some facets.
        thickness: as a share of the size, at which there is a fault.
        fault: at this thickness.
        size: m.

    Returns:
        None if there is none above a thousandth of the thickness.
    """
    least, largest = _THIN * thickness, thickness
    remaining: _Fault | None = fault
    while remaining is not None:
        low, high, facets = least, largest, remaining.facets
        for _ in range(_HALVINGS):
            middle = (low + high) / 2
            low, high = (low, middle) if _fault(sheet(middle, facets), facets) else (middle, high)
        if low == least and _fault(sheet(low, facets), facets):
            return None
        step = 10.0 ** (math.floor(math.log10(size * low)) - 2)
        largest = step * math.floor(size * low / step) / size
        remaining = _fault(sheet(largest, None))
    return largest


def _rounded_up(factor: float) -> str:
    """Return a factor with three digits, rounded up."""
    step = 10.0 ** (math.floor(math.log10(factor)) - 2)
    return f"{step * math.ceil(factor / step - _ROUNDING):.3g}"


def panel_motions(sheet: ThickSheet, angles: Array) -> list[list[RigidMotion]]:
    """Return the motions of panels from the position as built to fold angles, rad, (pose, edge)."""
    return _motions(sheet.pattern, sheet.axis_ends, angles)


def successive_path(sheet: ThickSheet, folds: Array, poses: int) -> Array:
    """Compute fold angles at which creases close one after another, without overlap of panels if possible.

    The order is found from the folded state: of the closed creases the one that overlaps least while it opens opens.

    Args:
        sheet: without interior vertices and holes, so that creases move independently.
        folds: fold angles of the edges that belong to each crease in the folded state, rad, (crease, edge).
        poses: number of poses for each crease.

    Returns:
        Fold angles, rad, (pose, edge), to the folded state.
    """
    closed, waiting, opening = folds.sum(axis=0), list(range(len(folds))), list[Array]()
    shares = np.linspace(0.0, 1.0, poses + 1)[:, None]
    while waiting:
        depths = dict[int, float]()
        for crease in waiting:
            angles = closed - shares * folds[crease]
            depths[crease] = deepest_overlap(sheet.panels, panel_motions(sheet, angles))[0]
            if depths[crease] <= _TOUCHING * sheet.thickness:
                break
        least = min(depths, key=lambda crease: depths[crease])
        opening.append((closed - shares * folds[least])[:-1])
        closed = closed - folds[least]
        waiting.remove(least)
    return np.concatenate(opening)[::-1]


def _motions(pattern: CreasePattern, axis_ends: Array, angles: Array) -> list[list[RigidMotion]]:
    """Return the motions of facets from the position as built to fold angles, rad, (pose, edge)."""
    built = built_angles(pattern)
    return facet_motions(pattern, axis_ends, angles - built)


def _sheet(
    pattern: CreasePattern,
    thickness: Array,
    levels: Array,
    axes: Array,
    path: Array | None,
    *,
    swept: Array | None = None,
    trims: Limits | None = None,
    meeting: Sequence[tuple[int, int]] = (),
    slots: Sequence[tuple[float, float]] = (),
    needed: Collection[int] | None = None,
) -> ThickSheet:
    """Return a sheet with panels of given thicknesses, and with panels and axes at given heights, m.

    Args:
        pattern: flat or folded as built, with strips.
        thickness: of panels and strips, (facet,).
        levels: heights of their mid-planes, (facet,).
        axes: heights of the axes of creases, (edge,).
        path: fold angles, rad, (pose, edge), for checks of overlap.
        swept: fold angles, rad, (pose, edge), at which brackets and ends of strips have room.
        trims: see `panel_solids`.
        meeting: pairs of strips that meet.
        slots: see `panel_solids`.
        needed: facets whose panels are needed, besides all brackets; None for all.
    """
    normals = np.array([polygon_normal(pattern.vertices_coords[list(face)]) for face in pattern.faces_vertices])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    shifts = np.zeros((len(levels), 3))
    for link in facet_tree(pattern):
        if link.parent is not None and link.edge is not None and not link.closes:
            turned = normals[link.parent] - normals[link.facet]
            shifts[link.facet] = shifts[link.parent] + axes[link.edge] * turned
    layers = tuple(
        Layer(origin=shift, normal=normal, level=float(level), thickness=float(depth))
        for shift, normal, level, depth in zip(shifts, normals, levels, thickness, strict=True)
    )
    axis_ends = pattern.vertices_coords[pattern.edges_vertices]
    for edge in shared_edges(pattern):
        axis_ends[edge.edge] = [layers[edge.left].at(end, float(axes[edge.edge])) for end in axis_ends[edge.edge]]
    poses = [] if swept is None else _motions(pattern, axis_ends, swept)
    cuts = strip_cuts(pattern, layers, axes, poses, meeting)
    closed = _motions(pattern, axis_ends, np.pi * (senses(pattern) * pattern.edges_share)[None])
    solids = panel_solids(
        pattern,
        layers,
        axes,
        [*poses, *closed],
        trims,
        cuts,
        slots or [BRACKETS] * len(axes),
        range(len(levels)) if needed is None else needed,
    )
    return ThickSheet(
        pattern=pattern,
        thickness=float(thickness.max()),
        layers=layers,
        axes=axes,
        axis_ends=axis_ends,
        panels=tuple((*panel.pieces, *panel.brackets) for panel in solids),
        notches=tuple(panel.notches for panel in solids),
        divided=tuple(facet for facet, panel in enumerate(solids) if panel.divided),
        cores=panel_cores(pattern, layers, trims, cuts) if needed is None else (),
        path=path,
    )


class _Fault(NamedTuple):
    """Why panels of a thickness cannot fold, and the facets of these panels."""

    text: str
    facets: tuple[int, ...]


def _fault(sheet: ThickSheet, facets: Collection[int] | None = None) -> _Fault | None:
    """Return why panels of a thickness, or those on some facets, cannot fold; None if they can."""
    for facet in range(len(sheet.panels)) if facets is None else facets:
        layer, solids = sheet.layers[facet], sheet.panels[facet]
        heights = np.concatenate([np.zeros(1), *(solid.corners @ layer.normal for solid in solids)])[1:]
        if not solids or np.ptp(heights) < (1 - _TOUCHING) * layer.thickness:
            return _Fault(f"nothing is left of the faces of the panel on facet {facet}", (facet,))
        if facet in sheet.divided:
            return _Fault(f"notches for brackets of other panels divide the panel on facet {facet}", (facet,))
    if sheet.path is None:
        return None
    depth, pair, pose = deepest_overlap(sheet.panels, panel_motions(sheet, sheet.path))
    if depth <= _TOUCHING * sheet.thickness:
        return None
    largest, share = math.degrees(float(np.abs(sheet.path[pose]).max())), 100 * depth / sheet.thickness
    return _Fault(
        f"the panels on facets {pair[0]} and {pair[1]}{_common(sheet.pattern, pair)} overlap by {share:.2g} % of the"
        f" thickness where the largest fold angle is {largest:.4g} deg",
        pair,
    )


def _common(pattern: CreasePattern, pair: tuple[int, int]) -> str:
    """Return a text with the crease or the vertex that two facets have in common; empty if they have none."""
    crease = next((edge.edge for edge in shared_edges(pattern) if {edge.left, edge.right} == set(pair)), None)
    if crease is not None:
        return f" at crease {crease}"
    one, other = (set(pattern.faces_vertices[facet]) for facet in pair)
    return f" at vertex {min(one & other)}" if one & other else ""


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
    heights = panel_heights(pattern, flat_folded(pattern), shifted=shifted)
    if heights is None:
        raise InputError("found no heights of panels and axes at which the panels fold onto one another")
    return heights[:2]
