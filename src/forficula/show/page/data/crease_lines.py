"""Lines of single hinges in the picture of a structure, with their angles and moments."""

from __future__ import annotations

from typing import Any

import numpy as np

from forficula.arrays import Array
from forficula.names import listed
from forficula.quantities import reading_unit
from forficula.show.page.data.packing import packed_steps
from forficula.show.page.data.shape_mesh import ShapeMesh
from forficula.show.structure.labels import label_of, shown_angles
from forficula.structure import Structure, built_frames, built_points, hinge_groups

_SAME = 1e-6  # points closer than this share of the span count as one


def crease_data(structure: Structure, mesh: ShapeMesh, angles: Array, moments: Array) -> dict[str, Any] | None:
    """Return the lines of hinges in the picture, with their angles and moments; None if no line shows a hinge."""
    signs, sprung = reading_signs(structure), set(sprung_hinges(structure, moments))
    hinges_at = _hinges_by_line(structure, mesh)
    if not hinges_at:
        return None
    unit, factor = reading_unit("N m", float(np.abs(moments).max(initial=0.0)))
    labels = [label_of(structure.hinges[hinges[0]]) for hinges in hinges_at.values()]
    lines, columns, values = [], list[dict[str, str]](), list[Array]()
    for (ends, hinges), label in zip(hinges_at.items(), labels, strict=True):
        first = len(columns)
        roles = [structure.hinges[hinge].role for hinge in hinges]
        for hinge, role in zip(hinges, roles, strict=True):
            columns.append({"name": role if len(hinges) > 1 else "angle", "unit": "°"})
            values.append(np.degrees(signs[hinge] * angles[:, hinge]))
            if hinge in sprung:
                columns.append({"name": "moment" if len(hinges) == 1 else f"moment of {role}", "unit": unit})
                values.append(factor * signs[hinge] * moments[:, hinge])
        name = label if labels.count(label) == 1 else f"{label}, {listed(roles)}"
        lines.append({"name": name, "ends": list(ends), "columns": list(range(first, len(columns)))})
    kind = "crease" if all(hinge.flaps is not None for hinge in structure.hinges) else "hinge"
    return {"kind": kind, "lines": lines, "columns": columns, "values": packed_steps(np.stack(values, axis=1))}


def _hinges_by_line(structure: Structure, mesh: ShapeMesh) -> dict[tuple[int, int], list[int]]:
    """Return the hinges whose angle a line in the picture shows, by the line's two vertices.

    The line of a crease is the crease, that of a joint is the bar of its body or the side of its body's plate that lies
    on its axis. Bends of facets are not drawn.
    """
    at_point = {
        int(mesh.anchors[first]): vertex
        for vertex, ((first, _), share) in enumerate(zip(mesh.between.tolist(), mesh.share.tolist(), strict=True))
        if share == 0
    }
    bends = hinge_groups(structure).get("facet bends", ())
    result: dict[tuple[int, int], list[int]] = {}
    for hinge in range(len(structure.hinges)):
        points = None if hinge in bends else _line_points(structure, hinge)
        if points is not None and all(point in at_point for point in points):
            result.setdefault((at_point[points[0]], at_point[points[1]]), []).append(hinge)
    return result


def _line_points(structure: Structure, number: int) -> tuple[int, int] | None:
    """Return the two points of a hinge's line; None if it has none."""
    hinge = structure.hinges[number]
    if hinge.flaps is not None:
        return hinge.flaps[0], hinge.flaps[1]
    for bar in structure.bars:
        if bar.body == hinge.body:
            return bar.points
    origins, frames = built_frames(structure)
    axis = frames[hinge.body] @ hinge.axis
    for plate in structure.plates:
        if plate.body == hinge.body:
            # an axis beside the mid-plane is at an edge of a solid
            points = [*plate.points, *(point for solid in plate.solids for point in solid)]
            away = built_points(structure)[points] - origins[hinge.body]
            along = away @ axis
            on_axis = np.linalg.norm(away - along[:, None] * axis, axis=1) <= _SAME * structure.span
            if on_axis.sum() >= 2:
                corners = np.flatnonzero(on_axis)
                ends = corners[[np.argmin(along[corners]), np.argmax(along[corners])]]
                return points[ends[0]], points[ends[1]]
    return None


def reading_signs(structure: Structure) -> Array:
    """Return the factors from the angles of hinges in their own senses to those that tables show, (hinge,)."""
    signs = np.ones(len(structure.hinges))
    for measure in shown_angles(structure):
        signs[list(measure.hinges)] = measure.signs
    return signs


def sprung_hinges(structure: Structure, moments: Array) -> list[int]:
    """Return the hinges with a moment, N m, (pose, hinge), without the bends of facets."""
    bends = hinge_groups(structure).get("facet bends", ())
    return [hinge for hinge in np.flatnonzero(np.any(moments != 0, axis=0)).tolist() if hinge not in bends]
