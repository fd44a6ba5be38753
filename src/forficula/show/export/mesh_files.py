"""A moment of a run as OBJ and as STL, by trimesh; the closed solids of STL are united by manifold3d."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Sequence
from io import BytesIO
from itertools import pairwise
from typing import Any

import manifold3d
import numpy as np
import scipy

from forficula.arrays import Array, Indices
from forficula.errors import InputError
from forficula.optional_module import optional_module
from forficula.show.export.gltf import tubes
from forficula.show.export.scene import BASE, JOINT, Scene, ball
from forficula.structure import Structure, facet_triangles

_SIDES = 24
_MILLIMETRES = 1e3
# distance below which vertices are merged, mm: far below what printers resolve, far above 4-byte rounding
_MERGED = 1e-3
# rods along creases: diameter, as a share of the thickness, sides, and angles, deg, by which no corner of a rod is in
# the plane of a panel
_ROUND, _SEAM_SIDES, _ASKEW = 1.1, 12, (17.0, 29.0, 41.0)
# attempts at a closed surface, each with solids shifted further, mm, until none touch without overlap
_ATTEMPTS, _SHIFT = 12, 1e-3


def trimesh_module() -> Any:
    """Return trimesh.

    Raises:
        InputError: it is not installed.
    """
    return optional_module("trimesh", "obj and stl need trimesh", "forficula[export]")


def obj_files(scene: Scene, stem: str) -> dict[str, bytes]:
    """Return the first frame of a scene as OBJ: m, y up, with the page's colours as materials.

    Args:
        scene: scene with one frame.
        stem: name of the files without ending.

    Returns:
        Contents by name: the .obj file, and the .mtl file of its materials.
    """
    trimesh = trimesh_module()
    places = scene.vertices[0]
    parts: list[tuple[str, str, Array, Indices]] = [
        (region.name, region.colour, places, region.triangles) for region in scene.regions
    ]
    for kind, colour in dict.fromkeys((rod.kind, rod.colour) for rod in scene.rods):
        rods = [rod for rod in scene.rods if (rod.kind, rod.colour) == (kind, colour)]
        ends = places[np.array([rod.ends for rod in rods])]
        drawn, _, triangles = tubes(ends, np.array([rod.radius for rod in rods]))
        parts.append((kind, colour, drawn, triangles))
    if len(scene.balls):
        unit, triangles = ball()
        drawn = places[scene.balls][:, np.newaxis] + scene.ball_radius * unit
        numbers = triangles + len(unit) * np.arange(len(scene.balls))[:, np.newaxis, np.newaxis]
        parts.append(("joints", JOINT, drawn.reshape(-1, 3), numbers.reshape(-1, 3)))
    if len(scene.base):
        drawn, _, triangles = tubes(scene.base, np.full(len(scene.base), scene.base_radius))
        parts.append(("fixed", BASE, drawn, triangles))
    whole = trimesh.Scene()
    for number, (name, colour, drawn, triangles) in enumerate(parts):
        shade = [int(colour[start : start + 2], 16) for start in (1, 3, 5)]
        material = trimesh.visual.material.SimpleMaterial(
            name=f"{name} {colour}".replace(" ", "_").replace("#", ""), diffuse=shade
        )
        used, corners = np.unique(triangles, return_inverse=True)
        mesh = trimesh.Trimesh(
            drawn[used] @ _Y_UP, corners.reshape(-1, 3), process=False, visual=_visual(trimesh, len(used), material)
        )
        whole.add_geometry(mesh, geom_name=f"{number}_{name.replace(' ', '_')}")
    text, materials = trimesh.exchange.obj.export_obj(
        whole, include_normals=False, return_texture=True, mtl_name=f"{stem}.mtl", digits=9, header="forficula, m"
    )
    return {f"{stem}.obj": text.encode(), **{name: bytes(content) for name, content in materials.items()}}


def _visual(trimesh: Any, count: int, material: object) -> object:
    """Return a material without a picture: trimesh writes one only with coordinates of a picture."""
    return trimesh.visual.TextureVisuals(uv=np.zeros((count, 2)), material=material)


# (x, y, z) with z up becomes (x, z, -y) with y up
_Y_UP = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])


def stl_bytes(structure: Structure, points: Array, scene: Scene) -> bytes:
    """Return a moment as STL: one closed surface around bars and panels, mm, z up.

    Sheets have the thickness of their facets, plates and membranes. Tendons, joints and drawn lines are left out,
    because they have no solid in the design. Where parts touch without overlap, they are shifted by up to 11 µm.

    Args:
        structure: structure that moves.
        points: positions of its points, then of the nodes of its membranes, m, (point, 3).
        scene: scene of the moment.

    Raises:
        InputError: the structure has neither bars nor panels with a thickness, or its surface is not closed.
    """
    trimesh = trimesh_module()
    pieces = _panels(structure, _MILLIMETRES * points, scene)
    solids = [*(solid for piece in pieces for solid in _prism(*piece)), *_bars(scene)]
    solids += [
        manifold3d.Manifold.hull_points(_MILLIMETRES * points[list(solid)])
        for plate in structure.plates
        for solid in plate.solids
    ]
    if not solids:
        raise InputError(f"{structure.name}: need bars, or panels with a thickness, for a solid")
    for attempt in range(_ATTEMPTS):
        apart = _shifted([*solids, *_seams(pieces)], attempt * _SHIFT)
        whole = manifold3d.Manifold.batch_boolean(apart, manifold3d.OpType.Add).simplify(_MERGED)
        mesh = whole.to_mesh64()
        united = trimesh.Trimesh(mesh.vert_properties[:, :3], mesh.tri_verts, process=False)
        content = bytes(trimesh.exchange.stl.export_stl(united))
        # surfaces that touch, or vertices that nearly coincide, may be one after rounding to 4-byte floats
        if trimesh.load(BytesIO(content), file_type="stl").is_watertight:
            return content
    raise InputError(
        f"{structure.name}: the solid is not closed, because panels touch; export a slightly different time"
    )


def _shifted(solids: Sequence[manifold3d.Manifold], distance: float) -> list[manifold3d.Manifold]:
    """Return solids that are shifted by up to a distance in various directions, mm."""
    shifts = distance * np.random.default_rng(0).uniform(-1, 1, size=(len(solids), 3))
    return [solid.translate(shift) for solid, shift in zip(solids, shifts, strict=True)]


def _panels(structure: Structure, points: Array, scene: Scene) -> list[tuple[Array, float]]:
    """Return the flat pieces of all panels: corners, (corner, 3), and thickness, mm."""
    pieces = []
    if structure.facets:
        triangles, numbers = facet_triangles(structure)
        for corners, number in zip(triangles.tolist(), numbers.tolist(), strict=True):
            pieces.append((points[corners], _MILLIMETRES * structure.facets[number].thickness))
    elif structure.membranes:
        thickness = _MILLIMETRES * structure.membranes[0].law.thickness
        places = _MILLIMETRES * scene.vertices[0]
        for region in scene.regions:
            pieces += [] if region.solid else [(places[corners], thickness) for corners in region.triangles.tolist()]
    for plate in structure.plates:
        if plate.solids:
            continue
        pieces.append((points[list(plate.points)], _MILLIMETRES * plate.thickness))
    return [(corners, thickness) for corners, thickness in pieces if thickness > 0]


def _seams(pieces: Sequence[tuple[Array, float]]) -> Iterable[manifold3d.Manifold]:
    """Yield rounded rods along the sides that pieces have in common, which would else touch in a line only, mm."""
    if not pieces:
        return
    corners = np.concatenate([piece for piece, _ in pieces])
    near = scipy.spatial.KDTree(corners).query_ball_point(corners, _MERGED)
    first = iter([min(group) for group in near])
    sides: dict[frozenset[int], list[float]] = defaultdict(list)
    for piece, thickness in pieces:
        numbers = [next(first) for _ in piece]
        for pair in pairwise([*numbers, numbers[0]]):
            sides[frozenset(pair)].append(thickness)
    for ends, thicknesses in sides.items():
        if len(ends) == 2 and len(thicknesses) > 1:
            unit = manifold3d.Manifold.sphere(_ROUND * max(thicknesses) / 2, _SEAM_SIDES).rotate(_ASKEW)
            yield manifold3d.Manifold.batch_hull([unit.translate(corners[end]) for end in ends])


def _prism(corners: Array, thickness: float) -> Iterable[manifold3d.Manifold]:
    """Yield the prism of a flat polygon, unless it has no thickness or area; lengths in mm."""
    arms = corners - corners[0]
    normal = np.cross(arms[:-1], arms[1:]).sum(axis=0)
    size = float(np.linalg.norm(normal))
    if thickness <= 0 or size <= _MERGED**2:
        return
    normal /= size
    along = arms[1] / np.linalg.norm(arms[1])
    across = np.cross(normal, along)
    outline = np.stack([arms @ along, arms @ across], axis=1)
    solid = manifold3d.Manifold.extrude(manifold3d.CrossSection([outline]), thickness)
    origin = corners[0] - thickness / 2 * normal
    yield solid.transform(np.column_stack([along, across, normal, origin]))


def _bars(scene: Scene) -> Iterable[manifold3d.Manifold]:
    """Yield the bars as cylinders, mm."""
    for rod in scene.rods:
        if rod.kind != "bar":
            continue
        start, end = _MILLIMETRES * scene.vertices[0, list(rod.ends)]
        length = float(np.linalg.norm(end - start))
        along = (end - start) / length
        across = np.cross(along, np.eye(3)[int(np.argmin(np.abs(along)))])
        across /= np.linalg.norm(across)
        radius = _MILLIMETRES * rod.radius
        solid = manifold3d.Manifold.cylinder(length, radius, radius, _SIDES)
        yield solid.transform(np.column_stack([across, np.cross(along, across), along, start]))
