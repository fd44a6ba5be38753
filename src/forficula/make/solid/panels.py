"""Thick panels of a sheet as parts, and their poses along the fold path."""

from __future__ import annotations

import numpy as np

from forficula.arrays import Array
from forficula.design import Design, MakeSection, SheetDesign
from forficula.design.sheets.sheet_creases import crease_sense
from forficula.design.sheets.thick_panels import thick_limits
from forficula.make.part import Part
from forficula.make.solid.solids import Hull, joined
from forficula.make.stock import stock_of
from forficula.pattern.geometry import polygon_normal
from forficula.pattern.rotation import rotation_to_z
from forficula.pattern.thick.thick_motion import fold_path
from forficula.structure import Plate, Structure, built_points

# poses of a drawn fold path, between which fold angles are interpolated linearly
_POSES = 120
# growth of a solid from its middle, 10 nm in 10 cm
_GROWN = 1e-7


def panel_parts(design: Design, structure: Structure) -> list[Part]:
    """Return the thick panels of a structure; empty if its plates are prisms over the facets of a sheet."""
    stock = stock_of((design.make or MakeSection()).bar_material)
    points = built_points(structure)
    return [
        Part(
            name=structure.bodies[plate.body].name.replace("facet", "panel"),
            kind="panel",
            stock=stock,
            solid=joined(*(Hull(corners=_grown(points[list(solid)], len(plate.solids))) for solid in plate.solids)),
            body=plate.body,
            bed=_flat(plate, points),
        )
        for plate in structure.plates
        if plate.solids
    ]


def _grown(corners: Array, count: int) -> Array:
    """Return the corners of one of several solids of a panel, slightly larger, so that the solids overlap and unite."""
    return np.asarray(corners + (_GROWN if count > 1 else 0.0) * (corners - corners.mean(axis=0)))


def _flat(plate: Plate, points: Array) -> Array:
    """Return the rotation that lays a panel on the side that is nearer to its mid-plane, without brackets, (3, 3)."""
    corners = points[list(plate.points)]
    normal = polygon_normal(corners)
    normal = normal / np.linalg.norm(normal)
    heights = (points[[point for solid in plate.solids for point in solid]] - corners[0]) @ normal
    return rotation_to_z(normal if heights.max() >= -heights.min() else -normal)


def panel_fold(design: Design, structure: Structure) -> Array | None:
    """Compute the angles of all hinges of thick panels along their fold path, in the hinges' own senses, rad.

    Returns:
        (pose, hinge), from flat, in equal steps of the largest fold angle; None without thick panels, or if the path
        has no closed form.
    """
    if not isinstance(design, SheetDesign) or not any(plate.solids for plate in structure.plates):
        return None
    path = fold_path(design.sheet, thick_limits(design), _POSES)
    if path is None or len(path) < _POSES:
        return None
    edges = [hinge.edge for hinge in structure.hinges]
    senses = np.array([crease_sense(design.sheet, edge) for edge in edges])
    return np.concatenate([np.zeros((1, len(edges))), senses * path[:, edges]])
