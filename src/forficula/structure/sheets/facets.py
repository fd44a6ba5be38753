"""Facets between points of any bodies: the triangles that they are split into, and which hinges lie in them."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from forficula.arrays import Indices
from forficula.structure.parts import GROUND
from forficula.structure.structure import Structure

BEND = "facet bend"  # role of what bends between two triangles that no crease is between


def facet_triangles(structure: Structure) -> tuple[Indices, Indices]:
    """The triangles of all facets, as flaps of hinges split them.

    Returns:
        Points of the triangles, counterclockwise seen from the side to which valleys rise, (triangle, 3), facet by
        facet; and the number of each one's facet, (triangle,). A facet at which nothing folds goes round its first
        corner.
    """
    flaps = [hinge.flaps for hinge in structure.hinges if hinge.flaps]
    known = {frozenset(each): each for tail, head, left, *_ in flaps for each in [(tail, head, left)]}
    known |= {frozenset(each): each for *_, tail, head, right in flaps for each in [(head, tail, right)]}
    at: dict[int, list[frozenset[int]]] = {}
    for corners in known:
        for corner in corners:
            at.setdefault(corner, []).append(corners)
    triangles, numbers = [], []
    for number, facet in enumerate(structure.facets):
        points = {*facet.points, *facet.inside}
        near = {corners: known[corners] for point in points for corners in at.get(point, ())}
        own = [each for corners, each in near.items() if corners <= points]
        if len(own) != len(facet.points) + 2 * len(facet.inside) - 2:
            first, *rest = facet.points
            own = [(first, *pair) for pair in pairwise(rest)]
        triangles += own
        numbers += [number] * len(own)
    return np.array(triangles, dtype=np.int64).reshape(-1, 3), np.array(numbers, dtype=np.int64)


def hinge_groups(structure: Structure) -> dict[str, tuple[int, ...]]:
    """Numbers of the hinges by what they are: "hinges" of bodies, "creases", and "facet bends" that are no creases."""
    kinds = [
        "hinges" if hinge.flaps is None else "facet bends" if hinge.role == BEND else "creases"
        for hinge in structure.hinges
    ]
    groups = {kind: tuple(np.flatnonzero(np.array(kinds) == kind).tolist()) for kind in dict.fromkeys(kinds)}
    return {kind: groups[kind] for kind in ("hinges", "creases", "facet bends") if kind in groups}


def springs_name(structure: Structure) -> str:
    """What springs between points are: "bars" of points that slide, "openings" of creases between plates."""
    return "openings" if structure.plates else "bars"


def held_corners(structure: Structure) -> tuple[int, ...]:
    """Numbers of the corners of facets that cannot go every way: those on the ground, or whose bodies do not slide."""
    corners = sorted({point for facet in structure.facets for point in facet.points})
    hinged = {hinge.body for hinge in structure.hinges}

    def held(body: int) -> bool:
        if body == GROUND:
            return True
        carrier = structure.bodies[body]
        return carrier.parent == GROUND and body not in hinged and len(carrier.slides) < 3

    return tuple(point for point in corners if held(structure.points[point].body))
