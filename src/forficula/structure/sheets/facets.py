"""Facets between points of any bodies: their triangles, and groups of hinges by kind."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from forficula.arrays import Indices
from forficula.structure.parts import GROUND
from forficula.structure.structure import Structure

BEND = "facet bend"  # role of a hinge between two triangles of the same facet
# distance of a point from the axis about which its plate turns below which it is on the axis, as a share of the size
_ON_AXIS = 1e-9


def facet_triangles(structure: Structure) -> tuple[Indices, Indices]:
    """Return the triangles of all facets, as the flaps of hinges define them.

    Returns:
        Points of the triangles, counterclockwise seen from the side to which valleys rise, (triangle, 3), facet by
        facet; and the number of the facet of each triangle, (triangle,). A facet without hinges is split into triangles
        from its first corner.
    """
    flaps = [hinge.flaps for hinge in structure.hinges if hinge.flaps]
    known = {frozenset(flap): flap for tail, head, left, *_ in flaps for flap in [(tail, head, left)]}
    known |= {frozenset(flap): flap for *_, tail, head, right in flaps for flap in [(head, tail, right)]}
    at: dict[int, list[frozenset[int]]] = {}
    for corners in known:
        for corner in corners:
            at.setdefault(corner, []).append(corners)
    triangles, numbers = [], []
    for number, facet in enumerate(structure.facets):
        points = {*facet.points, *facet.inside}
        near = {corners: known[corners] for point in points for corners in at.get(point, ())}
        split = [flap for corners, flap in near.items() if corners <= points]
        if len(split) != len(facet.points) + 2 * len(facet.inside) - 2:
            first, *rest = facet.points
            split = [(first, *pair) for pair in pairwise(rest)]
        triangles += split
        numbers += [number] * len(split)
    return np.array(triangles, dtype=np.int64).reshape(-1, 3), np.array(numbers, dtype=np.int64)


def hinge_groups(structure: Structure) -> dict[str, tuple[int, ...]]:
    """Return the numbers of the hinges by kind: "hinges" of bodies, "creases", and "facet bends" within facets."""
    kinds = [
        "hinges" if hinge.flaps is None else "facet bends" if hinge.role == BEND else "creases"
        for hinge in structure.hinges
    ]
    groups = {kind: tuple(np.flatnonzero(np.array(kinds) == kind).tolist()) for kind in dict.fromkeys(kinds)}
    return {kind: groups[kind] for kind in ("hinges", "creases", "facet bends") if kind in groups}


def springs_name(structure: Structure) -> str:
    """Return the word for springs between points: "bars" of a sheet of nodes, "openings" of creases between plates."""
    return "openings" if structure.plates else "bars"


def held_corners(structure: Structure) -> tuple[int, ...]:
    """Return the numbers of the supported corners of facets and plates.

    Corners of facets are on the ground, or their bodies cannot slide along all axes. Of plates, they are points that
    supports hold. Where there are such points, also corners of clamped plates, and ends of edges on the ground.
    """
    corners = {point for facet in structure.facets for point in facet.points}
    axes = {hinge.body: hinge.axis for hinge in structure.hinges if hinge.flaps is None}
    if structure.holds:
        corners |= {point for plate in structure.plates for point in plate.points}

    def held(number: int) -> bool:
        body = structure.points[number].body
        if body == GROUND:
            return True
        carrier = structure.bodies[body]
        if carrier.parent != GROUND or len(carrier.slides) == 3:
            return False
        if body not in axes:
            return True
        away = float(np.linalg.norm(np.cross(axes[body], structure.points[number].place)))
        return bool(structure.holds) and away < _ON_AXIS * structure.span

    return tuple(sorted({hold.point for hold in structure.holds} | {point for point in corners if held(point)}))
