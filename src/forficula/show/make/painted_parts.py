"""Parts as shaded triangles with their edges, at an angle of their joints, assembled or as an exploded view."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from matplotlib.colors import to_rgb

from forficula.arrays import Array
from forficula.make.hinge.strap_shape import StrapPlace, strap_line
from forficula.make.part import Part, PartSet
from forficula.make.solid.mesh import MILLIMETRES, mesh_of, solid_of
from forficula.make.solid.solids import Cut, Rod
from forficula.pattern.geometry import triangle_normals
from forficula.pattern.rotation import IDENTITY_MOTION, RigidMotion
from forficula.show.make.part_looks import STOP_COLOUR, part_looks
from forficula.show.make.part_mesh import PartMesh, part_mesh, sharp_edges
from forficula.show.make.part_poses import apart, poses_at
from forficula.show.structure.painted_shape import PaintedShape, ribbons
from forficula.show.structure.viewpoint import Viewpoint

_EDGE = "#2A2F35"
# m, half the width of an edge, and the distance by which edges are moved towards the eye
_THIN, _NEARER = 1.1e-4, 2e-4
_DARK, _LIGHT = 0.5, 0.55  # brightness of a face away from the light; increase towards it
_LAMP = np.array([-0.35, 0.55, 0.75])  # direction of the light: right, up and towards the eye


@dataclass(frozen=True, kw_only=True)
class PlacedPart:
    """Part at its position.

    Attributes:
        part: the part.
        look: index of its look.
        mesh: mesh with moved points.
    """

    part: Part
    look: int
    mesh: PartMesh


def placed_parts(parts: PartSet, angle: float, away: float = 0.0) -> list[PlacedPart]:
    """Return every part with all joints at an angle in their own senses, rad, moved apart by a share.

    Straps are taut or bow away from their hinge. Rods at the ground are straight, because nothing turns there.
    """
    poses, shifts = poses_at(parts, angle), apart(parts)
    _, looks = part_looks(parts)
    straps = iter(parts.straps)
    placed = []
    for part, look, shift in zip(parts.parts, looks, shifts, strict=True):
        if part.kind == "strap":
            mesh = _strap_mesh(parts, next(straps), poses, away * shift)
        else:
            mesh, pose = part_mesh(part, parts.joints), IDENTITY_MOTION if part.body is None else poses[part.body]
            mesh = _moved(mesh, pose.of(mesh.points + away * shift))
        placed.append(PlacedPart(part=part, look=look, mesh=mesh))
    return placed


def paint_parts(placed: list[PlacedPart], colours: list[str], view: Viewpoint) -> PaintedShape:
    """Shade parts in the colours of their looks, with dark edges, and the faces of stops in the colour of stops."""
    triangles, shades = [], []
    lamp = _LAMP / np.linalg.norm(_LAMP)
    for item in placed:
        corners = item.mesh.points[item.mesh.triangles]
        normals = triangle_normals(corners)
        normals /= np.maximum(np.linalg.norm(normals, axis=1), 1e-300)[:, None]
        colour = np.tile(to_rgb(colours[item.look]), (len(corners), 1))
        colour[: item.mesh.stops] = to_rgb(STOP_COLOUR)
        axes = np.column_stack([view.right, view.up, view.towards])
        facing = np.maximum(normals @ axes @ lamp, 0.0)
        visible = normals @ view.towards > 0
        triangles.append(_on_picture(corners[visible], view))
        shades.append(np.clip(colour * (_DARK + _LIGHT * facing)[:, None], 0, 1)[visible])
        quads, dark = ribbons(item.mesh.points[item.mesh.edges], view, _EDGE, _THIN, _NEARER)
        triangles.append(_on_picture(quads[:, [[0, 1, 2], [0, 2, 3]]].reshape(-1, 3, 3), view))
        shades.append(np.repeat(dark, 2, axis=0))
    return PaintedShape(triangles=np.concatenate(triangles), colours=np.concatenate(shades))


def _on_picture(corners: Array, view: Viewpoint) -> Array:
    return np.concatenate([view.project(corners), (corners @ view.towards)[..., np.newaxis]], axis=-1)


def _moved(mesh: PartMesh, points: Array) -> PartMesh:
    return PartMesh(points=points, triangles=mesh.triangles, stops=mesh.stops, edges=mesh.edges)


def _strap_mesh(parts: PartSet, place: StrapPlace, poses: Mapping[int, RigidMotion], shift: Array) -> PartMesh:
    """Return all straps of a tendon, bent, with their eyes; slack straps bow away from the hinge."""
    joint = next(joint for joint in parts.joints if joint.tendon == place.tendon)
    axis = poses[joint.proximal.body].rotation @ joint.frame[:, 1]
    meshes = []
    for ends in place.ends:
        start, end = (poses[body].of(end) for body, end in zip(place.bodies, ends, strict=True))
        meshes.append(_band(place, strap_line(place, start, end, axis, 1), axis))
        for body, across, middle in zip(place.bodies, place.across, (start, end), strict=True):
            meshes.append(_eye(place, middle, poses[body].rotation @ across))
    first = np.cumsum([0, *(len(mesh.points) for mesh in meshes)])[:-1].tolist()
    return PartMesh(
        points=np.concatenate([mesh.points for mesh in meshes]) + shift,
        triangles=np.concatenate([mesh.triangles + at for mesh, at in zip(meshes, first, strict=True)]),
        stops=0,
        edges=np.concatenate([mesh.edges + at for mesh, at in zip(meshes, first, strict=True)]),
    )


def _band(place: StrapPlace, line: Array, axis: Array) -> PartMesh:
    """Return the sides of a strap along its centre line, with its width along an axis; its ends lie in eyes."""
    ahead = np.gradient(line, axis=0)
    ahead -= (ahead @ axis)[:, None] * axis
    up = np.cross(axis, ahead)
    up *= place.strap.thickness / 2 / np.linalg.norm(up, axis=1)[:, None]
    wide = place.strap.width / 2 * axis
    points = np.stack([line - wide - up, line + wide - up, line + wide + up, line - wide + up], axis=1).reshape(-1, 3)
    corner = 4 * np.arange(len(line) - 1)[:, None] + np.arange(4)
    beside = 4 * np.arange(len(line) - 1)[:, None] + (np.arange(4) + 1) % 4
    sides = [np.stack([corner, corner + 4, beside + 4], axis=-1), np.stack([corner, beside + 4, beside], axis=-1)]
    edges = np.stack([corner, corner + 4], axis=-1).reshape(-1, 2)
    return PartMesh(points=points, triangles=np.concatenate(sides).reshape(-1, 3), stops=0, edges=edges)


def _eye(place: StrapPlace, middle: Array, across: Array) -> PartMesh:
    """Return the ring of a strap around a peg."""
    half = place.strap.width / 2 * across
    hole = Rod(start=middle - 2 * half, end=middle + 2 * half, diameter=place.peg_diameter)
    ring = Cut(solid=Rod(start=middle - half, end=middle + half, diameter=place.eye_diameter), taken=(hole,))
    mesh = mesh_of(solid_of(ring))
    return PartMesh(points=mesh.points / MILLIMETRES, triangles=mesh.triangles, stops=0, edges=sharp_edges(mesh))
