"""The structure of a sheet that bends: nodes with bars or a membrane between them, and springs at creases and bends."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from dataclasses import replace

import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.csgraph import dijkstra

from forficula.arrays import Array
from forficula.design import Imperfection, SheetDesign, tendon_law
from forficula.design.sheets.crease_sections import with_law
from forficula.design.sheets.crease_values import creases_by_edge
from forficula.design.sheets.sheet_creases import crease_sense
from forficula.design.sheets.sheet_places import GROUND_PLACE
from forficula.errors import InputError
from forficula.pattern import CreasePattern
from forficula.pattern.geometry import triangle_areas, triangle_normals
from forficula.pattern.shared_edges import shared_edges
from forficula.structure.appearance import Appearance
from forficula.structure.contact.contact_section import contact_of
from forficula.structure.medium import facet_panels, immersed
from forficula.structure.membranes import Membrane, MembraneLaw
from forficula.structure.parts import GROUND, Body, Facet, Hinge, Point, Spring, Tendon
from forficula.structure.protocol import with_protocol
from forficula.structure.sheets.facets import BEND
from forficula.structure.sheets.flaps import flap_angles
from forficula.structure.sheets.sheet_hinge import sheet_hinge
from forficula.structure.sheets.sheet_measures import sheet_measures
from forficula.structure.sheets.sheet_nodes import SheetNodes, held_axes, node_of, sheet_nodes
from forficula.structure.structure import Structure
from forficula.structure.surroundings import Stops

# rad, tolerance within which a crease at -180 deg as built counts as folded to 180 deg in its own sense
_FOLDED_FLAT = 1e-6


def node_structure(design: SheetDesign) -> Structure:
    """Build a sheet with a node at every vertex, in the units of its design.

    Raises:
        InputError: facets that cannot be split into triangles, or nodes without a mass.
    """
    design, sheet = design.settled(), design.sheet
    nodes = sheet_nodes(design)
    nodes = nodes._replace(triangles=imperfect(nodes.triangles, design.imperfection))
    triangles, facet = nodes.triangles, design.facet
    bodies = _bodies(design, sheet, nodes)
    thickness = facet.thickness or 0.0
    springs = _springs(design, nodes) if facet.kind == "bars" else ()
    hinges = _hinges(design, nodes)
    points = [Point(name=name, role="vertex", body=node, place=np.zeros(3)) for node, name in enumerate(nodes.names)]

    def point(name: str, text: str, ground: tuple[float, ...]) -> int:
        """Return the number of the point at a place: that of a node, or a new one on the ground."""
        if text.strip() != GROUND_PLACE:
            return node_of(sheet, nodes, text)
        points.append(Point(name=name, role="ground", body=GROUND, place=np.array(ground)))
        return len(points) - 1

    tendons = _tendons(design, triangles, point)
    measures = sheet_measures(design, hinges, point)
    span = float(np.ptp(triangles.vertices_coords, axis=0).max())
    built = Structure(
        name=design.name,
        stops=Stops(time_constant=design.stops.time_constant, damping_ratio=design.stops.damping_ratio),
        bodies=bodies,
        points=tuple(points),
        facets=tuple(
            Facet(name=f"facet{number}", points=corners, thickness=thickness, inside=inside)
            for number, (corners, inside) in enumerate(zip(nodes.facets, nodes.inside, strict=True))
        ),
        hinges=hinges,
        springs=springs,
        tendons=tendons,
        membranes=(_membrane(design, triangles),) if facet.kind == "membrane" else (),
        measures=measures,
        span=span,
        strength=facet.strength,
        imperfection=design.imperfection if design.imperfection.size else None,
        mass=max(body.mass for body in bodies),
        contact=contact_of(design, thickness),
        gravity=design.protocol.gravity,
        down=design.protocol.down,
        appearance=Appearance(whole="sheet", bodies="one for every vertex", pattern=sheet),
    )
    panels = facet_panels(sheet, triangles, nodes.parts, None)
    return with_protocol(immersed(built, design.medium, panels), design)


def _bodies(design: SheetDesign, sheet: CreasePattern, nodes: SheetNodes) -> tuple[Body, ...]:
    """Return the bodies of the nodes, each with a third of the mass of every triangle that meets there."""
    triangles, facet = nodes.triangles, design.facet
    corners = np.array(triangles.faces_vertices)
    shares = (facet.density or 0.0) * (facet.thickness or 0.0) * _areas(triangles) / 3
    masses = np.zeros(len(nodes.names))
    np.add.at(masses, corners, shares[:, None])
    if not (masses > 0).all() or not np.isfinite(masses).all():
        wrong = int(np.argmin((masses > 0) & np.isfinite(masses)))
        raise InputError(
            f"facet.thickness and facet.density: need vertices with a mass > 0 and finite, got {masses[wrong]:g} kg at"
            f" vertex {nodes.vertices[wrong]}, from {facet.thickness:g} m and {facet.density:g} kg/m^3"
        )
    held: dict[int, set[int]] = {}
    for support in design.support:
        for node, axes in held_axes(sheet, nodes, support.of, support.axes).items():
            held[node] = held.get(node, set()) | axes
    return tuple(
        Body(
            name=name,
            role="vertex",
            parent=GROUND,
            position=triangles.vertices_coords[node],
            frame=np.eye(3),
            slides=tuple(axis for axis in range(3) if axis not in held.get(node, ())),
            mass=float(masses[node]),
        )
        for node, name in enumerate(nodes.names)
    )


def _springs(design: SheetDesign, nodes: SheetNodes) -> tuple[Spring, ...]:
    """Return a bar along every edge and diagonal.

    A triangle of area S and thickness t gives its three bars the cross-section A = 2 S t / ((1 - nu) sum of lengths).
    Under a uniform strain e the bars then store as much energy as the sheet: E S t e^2 / (1 - nu) equals E A e^2 / 2
    times the sum of lengths (Filipov, Liu, Tachi, Schenk and Paulino 2017, doi 10.1016/j.ijsolstr.2017.05.028).
    """
    facet, triangles = design.facet, nodes.triangles
    ends = triangles.vertices_coords[triangles.edges_vertices]
    lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    number = {frozenset(pair): edge for edge, pair in enumerate(triangles.edges_vertices.tolist())}
    sides = np.array(
        [[number[frozenset((face[k - 1], face[k]))] for k in range(3)] for face in triangles.faces_vertices]
    )
    share = 2 * (facet.thickness or 0.0) / (1 - (facet.poisson_ratio or 0.0))
    areas = np.zeros(len(lengths))
    np.add.at(areas, sides, (share * _areas(triangles) / lengths[sides].sum(axis=1))[:, None])
    stiffness = (facet.youngs_modulus or 0.0) * areas / lengths
    edges = len(design.sheet.edges_vertices)
    return tuple(
        Spring(
            name=f"{role}{edge}",
            role=role,
            points=(int(tail), int(head)),
            stiffness=float(stiffness[edge]),
            rest_length=float(lengths[edge]),
            damping=float(stiffness[edge]) * (facet.stretch_damping or 0.0),
            area=float(areas[edge]),
        )
        for edge, (tail, head) in enumerate(triangles.edges_vertices)
        if areas[edge]
        for role in ["edge" if nodes.edges[edge] < edges else "diagonal"]
    )


def _hinges(design: SheetDesign, nodes: SheetNodes) -> tuple[Hinge, ...]:
    """Return the creases in the order of their edges, then the bends along flat edges."""
    triangles, creases = nodes.triangles, creases_by_edge(design)
    sheet = design.sheet  # outside the loop, because the look-up hashes all values of the pattern
    coords = triangles.vertices_coords
    hinges: list[Hinge] = []
    bends: list[Hinge] = []
    for edge, tail, head, left, right in shared_edges(triangles):
        beside = (sum(triangles.faces_vertices[face]) - tail - head for face in (left, right))
        flaps = [vertex for corner in beside for vertex in (tail, head, corner)]
        length = float(np.linalg.norm(coords[head] - coords[tail]))
        angle = float(flap_angles(coords[flaps]))
        points = (flaps[0], flaps[1], flaps[2], flaps[3], flaps[4], flaps[5])
        whole = int(nodes.edges[edge])
        if whole not in creases:
            bends.append(
                Hinge(
                    name=f"bend{edge}",
                    role=BEND,
                    flaps=points,
                    stiffness=(design.facet.bend_stiffness or 0.0) * length,
                    rest_angle=angle,
                    damping=(with_law(design.crease).damping or 0.0) * length,
                    start=angle,
                    label=f"bend {edge}",
                )
            )
            continue
        folded = crease_sense(triangles, edge) * angle
        if folded < _FOLDED_FLAT - np.pi:
            folded += 2 * np.pi
        hinge = sheet_hinge(design, creases[whole], sheet, whole, length=length, folded=folded)
        if edge != whole:
            hinge = replace(hinge, name=f"crease{edge}", label=f"crease {whole}, part {edge}")
        hinges.append(replace(hinge, flaps=points))
    return (*hinges, *bends)


def _membrane(design: SheetDesign, triangles: CreasePattern) -> Membrane:
    """Return an elastic sheet over all triangles."""
    facet, count = design.facet, len(triangles.vertices_coords)
    return Membrane(
        name="sheet",
        bodies=np.arange(count, dtype=np.int64),
        places=np.zeros((count, 3)),
        built=triangles.vertices_coords,
        triangles=np.array(triangles.faces_vertices, dtype=np.int64),
        law=MembraneLaw(
            youngs_modulus=facet.youngs_modulus or 0.0,
            poisson_ratio=facet.poisson_ratio or 0.0,
            thickness=facet.thickness or 0.0,
            damping=facet.stretch_damping or 0.0,
        ),
        margin=0.0,
    )


def _tendons(
    design: SheetDesign, triangles: CreasePattern, point: Callable[[str, str, tuple[float, ...]], int]
) -> tuple[Tendon, ...]:
    """Return the tendons; the length between vertices is limited by the path along edges, to the ground it is not."""
    tails, heads = triangles.edges_vertices.T
    coords = triangles.vertices_coords
    lengths = np.linalg.norm(coords[heads] - coords[tails], axis=1)
    graph = csr_array((lengths, (tails, heads)), shape=(len(coords), len(coords)))
    tendons = []
    for number, section in enumerate(design.tendon):
        start, end = (
            point(f"tendon_{section.name}_{key}", getattr(section, key), section.ground) for key in ("from", "to")
        )
        if start == end:
            raise InputError(f"tendon.{number}.to: need another place than tendon.{number}.from, got the same node")
        on_ground = max(start, end) >= len(coords)
        paths = dijkstra(graph, directed=False, indices=min(start, end))
        tendons.append(
            Tendon(
                name=section.name,
                role="tendon",
                points=(start, end),
                law=tendon_law(section),
                longest=np.inf if on_ground else float(paths[max(start, end)]),
                gauge_length=section.rest_length,
                material=None if section.law is None else section.law.material,
                key=f"tendon.{number}",
            )
        )
    return tuple(tendons)


def _areas(triangles: CreasePattern) -> Array:
    """Compute the areas of triangles, (triangle,)."""
    return triangle_areas(triangles.vertices_coords[np.array(triangles.faces_vertices)])


def imperfect(triangles: CreasePattern, imperfection: Imperfection) -> CreasePattern:
    """Shift every vertex along the normal of the sheet by a normally distributed random distance.

    Args:
        triangles: a sheet of triangles.
        imperfection: standard deviation of the shifts, in the pattern's units, and the seed of the random numbers.
    """
    if not imperfection.size:
        return triangles
    coords, corners = triangles.vertices_coords, np.array(triangles.faces_vertices)
    normals = np.zeros_like(coords)
    np.add.at(normals, corners, triangle_normals(coords[corners])[:, None])
    normals /= np.maximum(np.linalg.norm(normals, axis=1, keepdims=True), np.finfo(float).tiny)
    shifts = imperfection.size * np.random.default_rng(imperfection.seed).normal(size=(len(coords), 1))
    return dataclasses.replace(triangles, vertices_coords=coords + shifts * normals)
