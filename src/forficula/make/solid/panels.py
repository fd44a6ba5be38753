"""Thick panels of a sheet as parts, and their poses along the fold path."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from forficula.arrays import Array
from forficula.design import Design, MakeSection, SheetDesign
from forficula.design.sheets.sheet_creases import crease_sense
from forficula.design.sheets.thick_panels import closing_path, panel_path, thick_panels
from forficula.make.part import Part
from forficula.make.solid.solids import Cut, Hull, Solid, joined
from forficula.make.stock import stock_of
from forficula.pattern.geometry import polygon_normal
from forficula.pattern.rotation import rotation_to_z
from forficula.pattern.thick.convex import ConvexSolid
from forficula.structure import Plate, Structure, built_points

# poses of a drawn fold path, between which fold angles are interpolated linearly
_POSES = 120
# growth of a solid from its middle, 0.1 um in 10 cm
_GROWN = 1e-6


def panel_parts(design: Design, structure: Structure) -> list[Part]:
    """Return the thick panels of a structure; empty if its plates are prisms over the facets of a sheet.

    Args:
        design: design of the structure.
        structure: structure with the panels.
    """
    stock = stock_of((design.make or MakeSection()).bar_material)
    points, plates = built_points(structure), [plate for plate in structure.plates if plate.solids]
    thick = thick_panels(design.settled()) if isinstance(design, SheetDesign) else None
    return [
        Part(
            name=structure.bodies[plate.body].name.replace("facet", "panel"),
            kind="panel",
            stock=stock,
            solid=_united(plate, points, () if thick is None else thick.notches[_facet(structure, plate)]),
            body=plate.body,
            bed=_flat(plate, points),
        )
        for plate in plates
    ]


def _facet(structure: Structure, plate: Plate) -> int:
    """Return the number of the facet of a plate."""
    return int(structure.bodies[plate.body].name.removeprefix("facet"))


def _normal(plate: Plate, points: Array) -> Array:
    normal = polygon_normal(points[list(plate.points)])
    return np.asarray(normal / np.linalg.norm(normal))


def _solids(plate: Plate, points: Array) -> tuple[list[Array], list[Array]]:
    """Return the corners of the pieces of a panel, and those of its brackets, which are beside its mid-plane."""
    normal, middle = _normal(plate, points), points[plate.points[0]]
    pieces, brackets = list[Array](), list[Array]()
    for solid in plate.solids:
        heights = (points[list(solid)] - middle) @ normal
        (brackets if heights.min() * heights.max() > 0 else pieces).append(points[list(solid)])
    return pieces, brackets


def _united(plate: Plate, points: Array, notches: Sequence[ConvexSolid]) -> Solid:
    """Return a panel with its brackets and notches.

    Brackets grow slightly along the normal of the panel, so that they overlap and unite with it. Notches grow in all
    directions. The union of the convex pieces of the panel would have slivers where the pieces meet.
    """
    pieces, brackets = _solids(plate, points)
    normal = _normal(plate, points)
    grown = [corners + _GROWN * np.outer((corners - corners.mean(axis=0)) @ normal, normal) for corners in brackets]
    panel: Solid = joined(*(Hull(corners=piece) for piece in pieces))
    if len(pieces) > 1 and notches:
        cut = [notch.corners for notch in notches]
        taken = tuple(Hull(corners=corners + _GROWN * (corners - corners.mean(axis=0))) for corners in cut)
        panel = Cut(solid=Hull(corners=np.concatenate(pieces)), taken=taken)
    return joined(panel, *(Hull(corners=corners) for corners in grown))


def _flat(plate: Plate, points: Array) -> Array:
    """Return the rotation that lays a panel on the side that is nearer to its mid-plane, without brackets, (3, 3)."""
    normal = _normal(plate, points)
    corners = points[[point for solid in plate.solids for point in solid]]
    heights = (corners - points[plate.points[0]]) @ normal
    return rotation_to_z(normal if heights.max() >= -heights.min() else -normal)


def panel_fold(design: Design, structure: Structure) -> Array | None:
    """Compute the angles of all hinges of thick panels along their fold path, in the hinges' own senses, rad.

    Returns:
        (pose, hinge), from flat, in equal steps of the largest fold angle; None without thick panels, or if the path
        has no closed form.
    """
    if not isinstance(design, SheetDesign) or not any(plate.solids for plate in structure.plates):
        return None
    path = panel_path(design, _POSES)
    return None if path is None or len(path) < _POSES else _hinge_angles(design, structure, path)


def closing_fold(design: Design, structure: Structure, poses: int) -> Array | None:
    """Compute the angles of all hinges of thick panels whose creases close one after another, as `panel_fold`.

    Args:
        design: design of the structure.
        structure: structure with the panels.
        poses: number of poses for each crease.

    Returns:
        None if creases do not move independently.
    """
    if not isinstance(design, SheetDesign):
        return None
    path = closing_path(design, poses)
    return None if path is None else _hinge_angles(design, structure, path)


def _hinge_angles(design: SheetDesign, structure: Structure, path: Array) -> Array:
    """Return the angles of hinges, from flat, for fold angles, rad, (pose, edge)."""
    edges = [hinge.edge for hinge in structure.hinges]
    senses = np.array([crease_sense(design.sheet, edge) for edge in edges])
    return np.concatenate([np.zeros((1, len(edges))), senses * path[:, edges]])
