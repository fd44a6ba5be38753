"""The medium around a structure, as triangles that it acts on and as added masses that move with its panels."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np

from forficula.arrays import Array, Indices
from forficula.design import MediumSection
from forficula.pattern import CreasePattern
from forficula.pattern.geometry import triangle_areas
from forficula.structure.fans.fan_masses import triangle_masses
from forficula.structure.parts import PointMass
from forficula.structure.structure import Structure
from forficula.structure.surroundings import Medium, Panel
from forficula.structure.tree import built_frames


def immersed(structure: Structure, chosen: MediumSection | None, panels: Iterable[Panel]) -> Structure:
    """Return a structure in a medium; the structure itself without a medium.

    Args:
        structure: structure without a medium.
        chosen: the medium, in the structure's units.
        panels: triangles of the panels as built, each once.
    """
    panels = [] if chosen is None else list(panels)
    if chosen is None or not panels:
        return structure
    origins, frames = built_frames(structure)
    carriers = np.array([panel.carriers for panel in panels], dtype=np.int64)
    corners = np.array([panel.corners for panel in panels])

    def local(body: int | Indices, place: Array) -> Array:
        return np.asarray((np.swapaxes(frames[body], -1, -2) @ (place - origins[body])[..., None])[..., 0])

    masses = [
        PointMass(
            body=body,
            place=local(body, place),
            mass=math.pi / 4 * chosen.density * panel.width * area,
            role="medium",
        )
        for panel in (panels if chosen.density else [])
        for body, place, area in triangle_masses(panel.corners, panel.carriers)
    ]
    return replace(
        structure,
        medium=Medium(
            density=chosen.density,
            viscosity=chosen.viscosity,
            carriers=carriers,
            places=local(carriers, corners),
            widths=np.array([panel.width for panel in panels]),
            masses=tuple(masses),
        ),
    )


def facet_panels(
    sheet: CreasePattern, triangles: CreasePattern, parts: Indices, carriers: Sequence[int] | None
) -> list[Panel]:
    """Return the triangles of facets; the width of each is the area of its facet divided by the facet's longest side.

    Args:
        sheet: pattern with the facets.
        triangles: the facets split into triangles, with the vertices as built.
        parts: number of the facet of each triangle, (triangle,).
        carriers: number of the body of each facet; None if every vertex of the triangles is a body.
    """
    faces = np.array(triangles.faces_vertices, dtype=np.int64)
    corners = triangles.vertices_coords[faces]
    areas = triangle_areas(corners)
    total = np.bincount(parts, areas, len(sheet.faces_vertices))
    longest = [
        float(np.linalg.norm(np.diff(sheet.vertices_coords[[*face, face[0]]], axis=0), axis=1).max())
        for face in sheet.faces_vertices
    ]
    return [
        Panel(
            corners=place,
            carriers=face.tolist() if carriers is None else [carriers[part]] * 3,
            width=float(total[part]) / longest[part],
        )
        for place, face, part in zip(corners, faces, parts.tolist(), strict=True)
    ]
