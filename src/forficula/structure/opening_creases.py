"""Creases that open: springs between the two plates along them, and the fold between these."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from forficula.arrays import Array
from forficula.design import SheetDesign
from forficula.design.crease_values import creases_by_edge
from forficula.design.sheet_creases import crease_sense
from forficula.design.sheet_places import SheetPlace
from forficula.pattern import CreasePattern
from forficula.pattern.shared_edges import SharedEdge, shared_edges
from forficula.structure.facet_plates import AddPoint, corner_name
from forficula.structure.parts import Hinge, Point, Spring
from forficula.structure.sheet_hinge import sheet_hinge

# of a spring along a crease: gaps grow evenly along it, so that Simpson's rule is exact for their squares
_WEIGHTS = (1 / 6, 4 / 6, 1 / 6)
OPENING = "opening"  # role of these springs


def opening_creases(design: SheetDesign) -> frozenset[int]:
    """Numbers of the edges at which rigid facets come apart."""
    return frozenset(edge for edge, crease in creases_by_edge(design).items() if crease.extension is not None)


def opening_parts(
    design: SheetDesign, pattern: CreasePattern, points: Sequence[Point], add: AddPoint, built: Array
) -> tuple[tuple[Spring, ...], tuple[Hinge, ...]]:
    """The springs and the folds of creases that open.

    Args:
        design: of the sheet.
        pattern: alike.
        points: of the corners of its plates, and others.
        add: gives a place a point.
        built: by how much every edge is folded as built, rad, (edge,).

    Returns:
        Three springs a crease, each of no length; and the hinges.
    """
    creases, opening = creases_by_edge(design), opening_creases(design)
    named = {point.name: number for number, point in enumerate(points)}
    springs: list[Spring] = []
    hinges: list[Hinge] = []
    for shared in shared_edges(pattern):
        edge = shared.edge
        if edge not in opening:
            continue
        crease = creases[edge]
        ends = pattern.vertices_coords[[shared.tail, shared.head]]
        length = float(np.linalg.norm(ends[1] - ends[0]))
        middle = [
            add(f"crease{edge}_on_facet{facet}", "crease", SheetPlace(facet=facet, position=ends.mean(axis=0)))
            for facet in (shared.left, shared.right)
        ]
        pairs = [
            tuple(named[corner_name(facet, vertex)] for facet in (shared.left, shared.right))
            for vertex in (shared.tail, shared.head)
        ]
        for place, (pair, weight) in enumerate(zip((pairs[0], middle, pairs[1]), _WEIGHTS, strict=True)):
            springs.append(
                Spring(
                    name=f"crease{edge}_opening{place}",
                    role=OPENING,
                    points=(pair[0], pair[1]),
                    stiffness=weight * length * (crease.extension or 0.0),
                    rest_length=0.0,
                    damping=weight * length * (crease.extension_damping or 0.0),
                )
            )
        folded = crease_sense(pattern, edge) * float(built[edge]) + 0.0
        hinge = sheet_hinge(design, crease, pattern, edge, length=length, folded=folded)
        hinges.append(replace(hinge, flaps=_flaps(pattern, shared, named)))
    return tuple(springs), tuple(hinges)


def _flaps(pattern: CreasePattern, shared: SharedEdge, named: dict[str, int]) -> tuple[int, int, int, int, int, int]:
    """Tail, head and the furthest corner of the facet on the left, and of that on the right."""
    tail, head = pattern.vertices_coords[[shared.tail, shared.head]]
    flaps = []
    for facet in (shared.left, shared.right):
        corners = pattern.faces_vertices[facet]
        heights = np.linalg.norm(np.cross(pattern.vertices_coords[list(corners)] - tail, head - tail), axis=1)
        vertices = (shared.tail, shared.head, corners[int(np.argmax(heights))])
        flaps += [named[corner_name(facet, vertex)] for vertex in vertices]
    one, two, three, four, five, six = flaps
    return one, two, three, four, five, six
