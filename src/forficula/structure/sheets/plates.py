"""The structure of a sheet of rigid plates: a tree of hinges, closures for loops, and springs at creases that open."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from forficula.arrays import Array
from forficula.design import SheetDesign
from forficula.design.sheets.crease_values import creases_by_edge
from forficula.design.sheets.sheet_creases import crease_sense
from forficula.design.sheets.sheet_drives import places_of
from forficula.design.sheets.sheet_places import SheetPlace, edge_of, facet_of, place_on, vertex_of
from forficula.design.sheets.thick_panels import thick_panels
from forficula.pattern import CreasePattern, FacetLink, central_facet, facet_tree, triangulated
from forficula.pattern.crease_pattern import is_unfolded
from forficula.pattern.fold_angles import built_fold_angles
from forficula.pattern.shared_edges import SharedEdge, shared_edges
from forficula.pattern.thick.thick_sheet import ThickSheet
from forficula.structure.appearance import Appearance
from forficula.structure.contact.contact_section import contact_of
from forficula.structure.fans.crossing import tendon_crossing
from forficula.structure.medium import facet_panels, immersed
from forficula.structure.parts import GROUND, Body, Closure, Hinge, Point, Spring
from forficula.structure.protocol import force_point_name, with_protocol
from forficula.structure.sheets.facet_plates import (
    AddPoint,
    corner_name,
    facet_plates,
    largest_mass,
    on_panel,
    plate_tendons,
)
from forficula.structure.sheets.sheet_hinge import sheet_hinge
from forficula.structure.sheets.sheet_measures import sheet_measures
from forficula.structure.structure import Structure
from forficula.structure.surroundings import Hold, Panel, Stops

# weights of the three springs along a crease: the gap varies linearly, so Simpson's rule is exact for its square
_WEIGHTS = (1 / 6, 4 / 6, 1 / 6)
OPENING = "opening"  # role of these springs


def plate_structure(design: SheetDesign) -> Structure:
    """Build a plate on every facet and a hinge at every crease of a design's sheet, in the units of the design.

    A crease that closes a loop turns a copy of the facet on its right. Creases that do not open connect the plates. A
    group of plates that is not connected to a held plate moves freely.

    Raises:
        InputError: plates without a mass.
    """
    design, pattern = design.settled(), design.sheet
    opening, held = opening_creases(design), design.held_facets
    # plates that only points hold begin at a free plate
    links = facet_tree(pattern, held if held or opening else (central_facet(pattern),), opening)
    number = {link.facet: body for body, link in enumerate(links) if not link.closes}
    built = _built(pattern)
    thick = thick_panels(design)
    origins = [_origin(pattern, thick, link, free=link.parent is None and link.facet not in held) for link in links]
    for facet, edge in design.turning_facets.items():
        origins[number[facet]] = pattern.vertices_coords[pattern.edges_vertices[edge, 0]]
    points, plates = facet_plates(design, pattern, [(number[facet], facet) for facet in number], origins, thick)
    hinges = _hinges(design, pattern, links, built)
    turning = [_ground_hinge(pattern, number[facet], edge) for facet, edge in design.turning_facets.items()]
    hinges = tuple(sorted((*turning, *hinges), key=lambda hinge: hinge.body))

    def add(name: str, role: str, place: SheetPlace) -> int:
        """Add a point at a place and return its number."""
        body = number[place.facet]
        position = on_panel(thick, place.facet, place.position)
        points.append(Point(name=name, role=role, body=body, place=position - origins[body]))
        return len(points) - 1

    springs, opened = opening_parts(design, pattern, points, add, built)
    hinges = (*hinges, *opened)
    tendons = plate_tendons(design, pattern, links, add)
    measures = sheet_measures(design, hinges, lambda name, text, _: add(name, "measured", place_on(pattern, text)))
    for drive in design.drive:
        for place, text in enumerate(places_of(drive)):
            add(force_point_name(drive.name, place), "pushed", place_on(pattern, text))
    closures = _closures(pattern, thick, links, number, origins, points)
    holds = _holds(design, pattern, points)
    structure = Structure(
        name=design.name,
        stops=Stops(time_constant=design.stops.time_constant, damping_ratio=design.stops.damping_ratio),
        bodies=_bodies(links, number, origins, held),
        points=tuple(points),
        plates=plates,
        hinges=hinges,
        closures=closures,
        holds=holds,
        springs=springs,
        tendons=tuple(tendons),
        measures=measures,
        span=float(np.ptp(pattern.vertices_coords, axis=0).max()),
        mass=1.0,
        contact=contact_of(design, design.facet.thickness or 0.0),
        gravity=design.protocol.gravity,
        down=design.protocol.down,
        appearance=Appearance(pattern=pattern),
    )
    if not structure.closures and not structure.holds and not opening:
        # a crossing needs a hinge that moves independently, which there is not in a loop
        tendons = [replace(tendon, crossing=tendon_crossing(structure, tendon.points)) for tendon in tendons]
    structure = replace(structure, tendons=tuple(tendons), mass=largest_mass(design, structure))
    return with_protocol(immersed(structure, design.medium, _panels(pattern, thick, number)), design)


def _panels(pattern: CreasePattern, thick: ThickSheet | None, number: Mapping[int, int]) -> list[Panel]:
    """Return the triangles of the facets, in the mid-planes of the panels."""
    split, parts = triangulated(pattern)
    panels = facet_panels(pattern, split, parts, [number[facet] for facet in range(len(pattern.faces_vertices))])
    return [
        replace(panel, corners=on_panel(thick, facet, panel.corners))
        for panel, facet in zip(panels, parts.tolist(), strict=True)
    ]


def _built(pattern: CreasePattern) -> Array:
    """Compute the fold angle of every edge as built, rad, (edge,); 0 for flat edges, whose facets form one plate."""
    if is_unfolded(pattern):
        return np.zeros(len(pattern.edges_vertices))
    return np.where(np.array(pattern.edges_assignment) == "F", 0.0, built_fold_angles(pattern))


def _origin(pattern: CreasePattern, thick: ThickSheet | None, link: FacetLink, *, free: bool) -> Array:
    """Return the origin of a plate: an end of the axis to its parent, or the mean of the corners of a free plate."""
    corners = list(pattern.faces_vertices[link.facet])
    if thick is not None and link.edge is not None:
        return _axis_end(pattern, thick, link.edge, link.tail)
    if free:
        return np.asarray(pattern.vertices_coords[corners].mean(axis=0))
    return np.asarray(pattern.vertices_coords[corners[0] if link.parent is None else link.tail])


def _axis_end(pattern: CreasePattern, thick: ThickSheet, edge: int, vertex: int) -> Array:
    """Return the position of an end of a crease on its axis, m, (3,)."""
    return np.asarray(thick.axis_ends[edge][pattern.edges_vertices[edge].tolist().index(vertex)])


def _axis(pattern: CreasePattern, link: FacetLink) -> Array:
    """Return the vector along a crease, m, about which a positive turn raises the plate on the right, as a valley."""
    return np.asarray(pattern.vertices_coords[link.tail] - pattern.vertices_coords[link.head])


def _bodies(
    links: Sequence[FacetLink], number: Mapping[int, int], origins: Sequence[Array], held: Sequence[int]
) -> tuple[Body, ...]:
    """Return the bodies of plates and copies, all with axes parallel to those of the pattern as built."""
    bodies = []
    for place, link in enumerate(links):
        parent = GROUND if link.parent is None else number[link.parent]
        free = link.parent is None and link.facet not in held
        bodies.append(
            Body(
                name=f"facet{link.facet}_at_crease{link.edge}" if link.closes else f"facet{link.facet}",
                role="copy" if link.closes else "facet",
                parent=parent,
                position=origins[place] if parent == GROUND else origins[place] - origins[parent],
                frame=np.eye(3),
                slides=(0, 1, 2) if free else (),
                turns=free,
            )
        )
    return tuple(bodies)


def _holds(design: SheetDesign, pattern: CreasePattern, points: Sequence[Point]) -> tuple[Hold, ...]:
    """Return the supports of points: corners of facets, ends of edges and vertices, along their axes.

    A vertex at which hinged facets meet is a corner of the first of them.
    """
    named = {point.name: number for number, point in enumerate(points)}
    holds = []
    for number, support in design.point_supports:
        if support.kind == "facet":
            facet = facet_of(pattern, support.of)
            corners = [(facet, vertex) for vertex in pattern.faces_vertices[facet]]
        elif support.kind == "edge":
            edge, facet = edge_of(pattern, support.of)
            corners = [(facet, vertex) for vertex in pattern.edges_vertices[edge].tolist()]
        else:
            vertex, chosen = vertex_of(pattern, support.of)
            around = [facet for facet, corners in enumerate(pattern.faces_vertices) if vertex in corners]
            corners = [(around[0] if chosen is None else chosen, vertex)]
        holds += [
            Hold(name=f"support{number}_{name}_{axis}", point=named[name], axis=np.eye(3)["xyz".index(axis)])
            for name in (corner_name(facet, vertex) for facet, vertex in corners)
            for axis in sorted(set(support.axes or "xyz"))
        ]
    return tuple(holds)


def _closures(
    pattern: CreasePattern,
    thick: ThickSheet | None,
    links: Sequence[FacetLink],
    number: Mapping[int, int],
    origins: Sequence[Array],
    points: list[Point],
) -> tuple[Closure, ...]:
    """Return the closures of loops: each copy of a plate moves with the original.

    The ends of their creases are corners of plates; on thick panels they are points that this function adds.
    """
    named = {point.name: number for number, point in enumerate(points)}

    def end(facet: int, edge: int | None, vertex: int) -> int:
        """Return the number of the point of a plate at an end of a crease."""
        if thick is None or edge is None:
            return named[corner_name(facet, vertex)]
        body, name = number[facet], f"crease{edge}_on_{corner_name(facet, vertex)}"
        place = _axis_end(pattern, thick, edge, vertex) - origins[body]
        points.append(Point(name=name, role="axis", body=body, place=place))
        return len(points) - 1

    return tuple(
        Closure(
            name=f"closure{link.edge}",
            bodies=(number[link.facet], place),
            position=origins[place] - origins[number[link.facet]],
            frame=np.eye(3),
            points=tuple(
                (end(link.parent, link.edge, vertex), end(link.facet, link.edge, vertex))
                for vertex in (link.tail, link.head)
            ),
        )
        for place, link in enumerate(links)
        if link.closes and link.parent is not None
    )


def _hinges(design: SheetDesign, pattern: CreasePattern, links: Sequence[FacetLink], built: Array) -> tuple[Hinge, ...]:
    """Return the hinges in the order of their bodies."""
    creases = creases_by_edge(design)
    hinges: list[Hinge] = []
    for body, link in enumerate(links):
        if link.edge is None or link.edge not in creases:
            continue
        crease, along = creases[link.edge], _axis(pattern, link)
        length = float(np.linalg.norm(along))
        folded = crease_sense(pattern, link.edge) * float(built[link.edge]) + 0.0
        hinge = sheet_hinge(design, crease, pattern, link.edge, length=length, folded=folded)
        hinges.append(replace(hinge, body=body, axis=along / length, built=folded, start=crease.start or folded))
    return tuple(hinges)


def _ground_hinge(pattern: CreasePattern, body: int, edge: int) -> Hinge:
    """Return the hinge on the ground of a plate that turns about one of its edges, as built at the angle 0."""
    tail, head = pattern.vertices_coords[pattern.edges_vertices[edge]]
    axis = (head - tail) / np.linalg.norm(head - tail)
    return Hinge(name=f"support{edge}", role="support", body=body, axis=axis, label=f"support at edge {edge}")


def opening_creases(design: SheetDesign) -> frozenset[int]:
    """Return the numbers of the edges whose creases open between rigid facets."""
    return frozenset(edge for edge, crease in creases_by_edge(design).items() if crease.extension is not None)


def opening_parts(
    design: SheetDesign, pattern: CreasePattern, points: Sequence[Point], add: AddPoint, built: Array
) -> tuple[tuple[Spring, ...], tuple[Hinge, ...]]:
    """Return the springs and the hinges of creases that open.

    Args:
        design: design of the sheet.
        pattern: crease pattern of the sheet.
        points: points of the structure, among them the corners of the plates.
        add: function that adds a point at a place.
        built: fold angle of every edge as built, rad, (edge,).

    Returns:
        Three springs for each crease, with a rest length of 0; and the hinges.
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
    """Return tail, head and furthest corner of the facet on the left, then of the facet on the right."""
    tail, head = pattern.vertices_coords[[shared.tail, shared.head]]
    flaps = []
    for facet in (shared.left, shared.right):
        corners = pattern.faces_vertices[facet]
        heights = np.linalg.norm(np.cross(pattern.vertices_coords[list(corners)] - tail, head - tail), axis=1)
        vertices = (shared.tail, shared.head, corners[int(np.argmax(heights))])
        flaps += [named[corner_name(facet, vertex)] for vertex in vertices]
    one, two, three, four, five, six = flaps
    return one, two, three, four, five, six
