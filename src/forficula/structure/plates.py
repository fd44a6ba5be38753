"""Rigid plates on the facets of a sheet, hinged at its creases in a tree, with tendons between places on them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from forficula.design import SheetDesign, tendon_law
from forficula.design.crease_values import creases_by_edge, rest_angle, stops
from forficula.design.sheet_creases import crease_role, crease_sense
from forficula.design.sheet_places import SheetPlace, place_on
from forficula.errors import InputError
from forficula.pattern import CreasePattern, FacetLink, edges_between, facet_tree
from forficula.structure.appearance import Appearance
from forficula.structure.crossing import tendon_crossing
from forficula.structure.mass import mass_of
from forficula.structure.parts import GROUND, Array, Body, Hinge, Plate, Point, Tendon
from forficula.structure.sheet_measures import sheet_measures
from forficula.structure.sheet_protocol import with_protocol
from forficula.structure.structure import Structure


def plate_structure(design: SheetDesign) -> Structure:
    """Build a plate on every facet and a hinge at every crease of a design's sheet, in the units of the design.

    Raises:
        InputError: plates without a mass.
    """
    design, pattern = design.settled(), design.sheet
    links = facet_tree(pattern, design.held_facet)
    number = {link.facet: place for place, link in enumerate(links)}
    origins = [pattern.vertices_coords[_origin(pattern, link)] for link in links]
    bodies = tuple(
        Body(
            name=f"facet{link.facet}",
            role="facet",
            parent=GROUND if link.parent is None else number[link.parent],
            position=origins[place] if link.parent is None else origins[place] - origins[number[link.parent]],
            frame=np.eye(3),
        )
        for place, link in enumerate(links)
    )
    points, plates = _plates(design, pattern, links, origins)
    hinges, edges = _hinges(design, pattern, links)

    def add(name: str, role: str, place: SheetPlace) -> int:
        """A point at a place, by its number."""
        body = number[place.facet]
        points.append(Point(name=name, role=role, body=body, place=place.position - origins[body]))
        return len(points) - 1

    tendons = []
    for place, chosen in enumerate(design.tendon):
        ends = _ends(pattern, chosen)
        crossed = edges_between(links, ends[0].facet, ends[1].facet)
        tendons.append(
            Tendon(
                name=chosen.name,
                role="tendon",
                points=(
                    add(f"tendon_{chosen.name}_from", "attachment", ends[0]),
                    add(f"tendon_{chosen.name}_to", "attachment", ends[1]),
                ),
                law=tendon_law(chosen),
                longest=_longest(pattern, ends, crossed),
                gauge_length=chosen.rest_length,
                material=None if chosen.law is None else chosen.law.material,
                key=f"tendon.{place}",
            )
        )
    measures = sheet_measures(
        design, hinges, edges, lambda name, text, _: add(name, "measured", place_on(pattern, text))
    )
    built = Structure(
        name=design.name,
        bodies=bodies,
        points=tuple(points),
        plates=plates,
        hinges=hinges,
        tendons=tuple(tendons),
        measures=measures,
        span=float(np.ptp(pattern.vertices_coords, axis=0).max()),
        mass=1.0,
        gravity=design.protocol.gravity,
        appearance=Appearance(pattern=pattern),
    )
    crossed_by = [replace(tendon, crossing=tendon_crossing(built, tendon.points)) for tendon in tendons]
    return with_protocol(replace(built, tendons=tuple(crossed_by), mass=_largest_mass(design, built)), design)


def _origin(pattern: CreasePattern, link: FacetLink) -> int:
    """The vertex in which a plate's axes begin: an end of the crease that it hangs on."""
    return pattern.faces_vertices[link.facet][0] if link.parent is None else link.tail


def _plates(
    design: SheetDesign, pattern: CreasePattern, links: Sequence[FacetLink], origins: Sequence[Array]
) -> tuple[list[Point], tuple[Plate, ...]]:
    """The corners of all facets, and a plate between those of each."""
    points: list[Point] = []
    plates: list[Plate] = []
    coords, facet = pattern.vertices_coords, design.facet
    for body, link in enumerate(links):
        first = len(points)
        points += [
            Point(
                name=f"facet{link.facet}_vertex{vertex}", role="corner", body=body, place=coords[vertex] - origins[body]
            )
            for vertex in pattern.faces_vertices[link.facet]
        ]
        corners = tuple(range(first, len(points)))
        plates.append(Plate(body=body, points=corners, thickness=facet.thickness or 0.0, density=facet.density or 0.0))
    return points, tuple(plates)


def _hinges(
    design: SheetDesign, pattern: CreasePattern, links: Sequence[FacetLink]
) -> tuple[tuple[Hinge, ...], dict[int, int]]:
    """The hinges, in the order of their bodies, and their numbers by edge."""
    creases = creases_by_edge(design)
    hinges: list[Hinge] = []
    numbers: dict[int, int] = {}
    for body, link in enumerate(links):
        if link.edge is None or link.edge not in creases:
            continue
        crease = creases[link.edge]
        lower, upper = stops(design, crease)
        # the parent lies to the left of tail -> head: the plate on the right rises, a valley, about head -> tail
        along = pattern.vertices_coords[link.tail] - pattern.vertices_coords[link.head]
        length = float(np.linalg.norm(along))
        numbers[link.edge] = len(hinges)
        hinges.append(
            Hinge(
                name=f"crease{link.edge}",
                role=crease_role(pattern, link.edge),
                body=body,
                axis=along / length,
                sense=crease_sense(pattern, link.edge),
                lower=lower,
                upper=upper,
                stiffness=(crease.stiffness or 0.0) * length,
                rest_angle=rest_angle(crease, 0.0),
                damping=(crease.damping or 0.0) * length,
                start=crease.start,
                assignment=pattern.edges_assignment[link.edge],
                label=f"crease {link.edge}",
            )
        )
    return tuple(hinges), numbers


def _ends(pattern: CreasePattern, chosen: object) -> tuple[SheetPlace, SheetPlace]:
    """The two places of a tendon or a distance."""
    return place_on(pattern, getattr(chosen, "from")), place_on(pattern, getattr(chosen, "to"))  # noqa: B009


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


def _largest_mass(design: SheetDesign, structure: Structure) -> float:
    """Mass of the heaviest plate."""
    mass = max(mass_of(structure, body)[0] for body in range(len(structure.bodies)))
    if not 0 < mass < np.inf:
        raise InputError(
            f"facet.thickness and facet.density: need plates with a mass > 0 and finite, got {mass:g} kg, from"
            f" {design.facet.thickness:g} m and {design.facet.density:g} kg/m^3"
        )
    return mass
