"""What plates on facets have however they hang together: corners, masses, tendons between places on them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

import numpy as np

from forficula.arrays import Array
from forficula.design import SheetDesign, tendon_law
from forficula.design.sheets.sheet_places import SheetPlace, place_on
from forficula.errors import InputError
from forficula.pattern import CreasePattern, FacetLink, edges_between
from forficula.structure.mass import mass_of
from forficula.structure.parts import Plate, Point, Tendon
from forficula.structure.structure import Structure

# what gives a place on a plate a point, by a name and a role, and says its number
AddPoint = Callable[[str, str, SheetPlace], int]


def facet_plates(
    design: SheetDesign, pattern: CreasePattern, facets: Iterable[tuple[int, int]], origins: Sequence[Array]
) -> tuple[list[Point], tuple[Plate, ...]]:
    """The corners of facets, and a plate between those of each.

    Args:
        design: with thickness and density.
        pattern: of the sheet, as built.
        facets: the number of the body of each, and its own.
        origins: of all bodies, m, whose axes are parallel to those of the pattern as built.
    """
    points: list[Point] = []
    plates: list[Plate] = []
    coords, facet = pattern.vertices_coords, design.facet
    for body, number in facets:
        first = len(points)
        points += [
            Point(name=corner_name(number, vertex), role="corner", body=body, place=coords[vertex] - origins[body])
            for vertex in pattern.faces_vertices[number]
        ]
        corners = tuple(range(first, len(points)))
        plates.append(Plate(body=body, points=corners, thickness=facet.thickness or 0.0, density=facet.density or 0.0))
    return points, tuple(plates)


def corner_name(facet: int, vertex: int) -> str:
    """What the point at a corner of a facet is called."""
    return f"facet{facet}_vertex{vertex}"


def plate_tendons(
    design: SheetDesign, pattern: CreasePattern, links: Sequence[FacetLink], add: AddPoint
) -> list[Tendon]:
    """The tendons of a design, between places on its plates.

    Args:
        design: with its tendons.
        pattern: of the sheet, as built.
        links: its facets as a tree.
        add: gives a place a point.
    """
    tendons = []
    for place, chosen in enumerate(design.tendon):
        ends = tuple(place_on(pattern, getattr(chosen, key)) for key in ("from", "to"))
        crossed = edges_between(links, ends[0].facet, ends[1].facet)
        # creases that open let them go any way
        longest = np.inf if design.opens else _longest(pattern, (ends[0], ends[1]), crossed)
        tendons.append(
            Tendon(
                name=chosen.name,
                role="tendon",
                points=(
                    add(f"tendon_{chosen.name}_from", "attachment", ends[0]),
                    add(f"tendon_{chosen.name}_to", "attachment", ends[1]),
                ),
                law=tendon_law(chosen),
                longest=longest,
                gauge_length=chosen.rest_length,
                material=None if chosen.law is None else chosen.law.material,
                key=f"tendon.{place}",
            )
        )
    return tendons


def _longest(pattern: CreasePattern, ends: tuple[SheetPlace, SheetPlace], crossed: Sequence[int]) -> float:
    """A length that the distance of two places cannot exceed, however the sheet folds.

    A way over the sheet from one to the other, straight from crease to crease, is as long in every folded state: here
    it goes where the straight line meets the creases, and is that line where it meets them all.
    """
    start, end = ends[0].position, ends[1].position
    way = [start]
    for edge in crossed:
        tail, head = pattern.vertices_coords[pattern.edges_vertices[edge]]
        along, line = head - tail, end - start
        turn = line[0] * along[1] - line[1] * along[0]
        share = (line[0] * (start - tail)[1] - line[1] * (start - tail)[0]) / turn if turn else 0.5
        way.append(tail + min(max(share, 0.0), 1.0) * along)
    return float(np.linalg.norm(np.diff([*way, end], axis=0), axis=1).sum())


def largest_mass(design: SheetDesign, structure: Structure) -> float:
    """Mass of the heaviest plate.

    Raises:
        InputError: plates without a mass.
    """
    mass = max(mass_of(structure, body)[0] for body in range(len(structure.bodies)))
    if not 0 < mass < np.inf:
        raise InputError(
            f"facet.thickness and facet.density: need plates with a mass > 0 and finite, got {mass:g} kg, from"
            f" {design.facet.thickness:g} m and {design.facet.density:g} kg/m^3"
        )
    return mass
