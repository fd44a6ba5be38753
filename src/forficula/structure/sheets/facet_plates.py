"""Plates on facets, for hinged and for opening creases: corners, masses, and tendons between places on them."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

import numpy as np

from forficula.arrays import Array
from forficula.design import SheetDesign, tendon_law
from forficula.design.sheets.sheet_places import SheetPlace, place_on
from forficula.errors import InputError
from forficula.pattern import CreasePattern, FacetLink, edges_between
from forficula.pattern.thick.thick_sheet import ThickSheet
from forficula.structure.mass import mass_of
from forficula.structure.parts import Plate, Point, Tendon
from forficula.structure.structure import Structure

# function that adds a point with a name and a role at a place on a plate, and returns its number
AddPoint = Callable[[str, str, SheetPlace], int]


def facet_plates(
    design: SheetDesign,
    pattern: CreasePattern,
    facets: Iterable[tuple[int, int]],
    origins: Sequence[Array],
    thick: ThickSheet | None,
) -> tuple[list[Point], tuple[Plate, ...]]:
    """Return the corners of facets, and a plate between the corners of each facet.

    Args:
        design: design with thickness and density.
        pattern: crease pattern of the sheet, as built.
        facets: pairs of the numbers of a body and its facet.
        origins: origins of all bodies, m; their axes are parallel to those of the pattern as built.
        thick: thick panels of the sheet; None for plates whose mid-planes are the facets.
    """
    points: list[Point] = []
    plates: list[Plate] = []
    coords, facet = pattern.vertices_coords, design.facet
    for body, number in facets:

        def add(name: str, role: str, place: Array, body: int = body) -> int:
            points.append(Point(name=name, role=role, body=body, place=place - origins[body]))
            return len(points) - 1

        corners = [
            add(corner_name(number, vertex), "corner", on_panel(thick, number, coords[vertex]))
            for vertex in pattern.faces_vertices[number]
        ]
        solids = [
            [
                add(f"facet{number}_solid{solid}_corner{corner}", "solid", place)
                for corner, place in enumerate(convex.corners)
            ]
            for solid, convex in enumerate(() if thick is None else thick.panels[number])
        ]
        thickness = (facet.thickness or 0.0) if thick is None else thick.layers[number].thickness
        core = None if thick is None else thick.cores[number]
        within = [
            add(f"facet{number}_core{corner}", "core", place)
            for corner, place in enumerate(() if core is None else core)
        ]
        plates.append(
            Plate(
                body=body,
                points=tuple(corners),
                thickness=thickness,
                density=facet.density or 0.0,
                solids=tuple(map(tuple, solids)),
                core=tuple(within),
                # the touching distance of the structure is that of panels, and strips of split folds may be thinner
                touching_distance=thickness if thick is not None and thickness < thick.thickness else None,
            )
        )
    return points, tuple(plates)


def on_panel(thick: ThickSheet | None, facet: int, position: Array) -> Array:
    """Return the position in the mid-plane of a panel over a position on its facet, m, (3,)."""
    return position if thick is None else thick.layers[facet].at(position, thick.layers[facet].level)


def corner_name(facet: int, vertex: int) -> str:
    """Return the name of the point at a corner of a facet."""
    return f"facet{facet}_vertex{vertex}"


def plate_tendons(
    design: SheetDesign, pattern: CreasePattern, links: Sequence[FacetLink], add: AddPoint
) -> list[Tendon]:
    """Return the tendons of a design, between places on its plates.

    Args:
        design: design with the tendons.
        pattern: crease pattern of the sheet, as built.
        links: facets of the sheet as a tree.
        add: function that adds a point at a place.
    """
    tendons = []
    for number, section in enumerate(design.tendon):
        ends = tuple(place_on(pattern, getattr(section, key)) for key in ("from", "to"))
        crossed = edges_between(links, ends[0].facet, ends[1].facet)
        # without a limit if creases open, or if axes and panels are not in one plane
        free = design.opens or design.facet.thickness_method is not None
        longest = np.inf if free else _longest(pattern, (ends[0], ends[1]), crossed)
        tendons.append(
            Tendon(
                name=section.name,
                role="tendon",
                points=(
                    add(f"tendon_{section.name}_from", "attachment", ends[0]),
                    add(f"tendon_{section.name}_to", "attachment", ends[1]),
                ),
                law=tendon_law(section),
                longest=longest,
                gauge_length=section.rest_length,
                material=None if section.law is None else section.law.material,
                key=f"tendon.{number}",
            )
        )
    return tendons


def _longest(pattern: CreasePattern, ends: tuple[SheetPlace, SheetPlace], crossed: Sequence[int]) -> float:
    """Compute an upper bound of the distance of two places in all folded states of a sheet.

    The bound is the length of a path over the sheet that is straight between creases, because folding does not change
    this length. The path crosses each crease at its intersection with the straight line between the places, or at the
    nearest end of the crease.
    """
    start, end = ends[0].position, ends[1].position
    path = [start]
    for edge in crossed:
        tail, head = pattern.vertices_coords[pattern.edges_vertices[edge]]
        along, line = head - tail, end - start
        turn = line[0] * along[1] - line[1] * along[0]
        share = (line[0] * (start - tail)[1] - line[1] * (start - tail)[0]) / turn if turn else 0.5
        path.append(tail + min(max(share, 0.0), 1.0) * along)
    return float(np.linalg.norm(np.diff([*path, end], axis=0), axis=1).sum())


def largest_mass(design: SheetDesign, structure: Structure) -> float:
    """Compute the mass of the heaviest plate.

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
