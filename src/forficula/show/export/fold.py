"""Frames of a run as a FOLD 1.2 file, with the fold angles of every moment."""

from __future__ import annotations

from collections import defaultdict
from itertools import pairwise

import numpy as np

from forficula.arrays import Array
from forficula.dynamics import Record
from forficula.errors import InputError
from forficula.pattern import CreasePattern
from forficula.pattern.files.fold_writer import Frame
from forficula.show.export.scene import sampled, sampled_points
from forficula.show.structure.pattern_points import pattern_points
from forficula.show.structure.shape import shape_of, vertex_places
from forficula.structure import Structure


def fold_frames(record: Record, times: Array) -> tuple[CreasePattern, list[Frame]]:
    """Return the crease pattern of a run and its folded states at several times (s), as `write_fold` takes them.

    Fold angles of creases that are hinges are those of the record; the others are computed from positions. Where the
    structure has no pattern, or has lost vertices of its pattern, the pattern is that of the drawn sheet.

    Raises:
        InputError: the structure has neither a pattern nor faces.
    """
    structure = record.structure
    points = sampled_points(record, times)
    carriers = pattern_points(structure)
    if carriers is None:
        pattern, places, hinges = _drawn_pattern(structure, points)
    else:
        known = structure.appearance.pattern
        assert known is not None
        pattern, places = known, points[:, carriers]
        hinges = {hinge.edge: number for number, hinge in enumerate(structure.hinges) if hinge.edge >= 0}
    angles = _edge_angles(pattern, places)
    senses = np.array([hinge.sense for hinge in structure.hinges])
    turned = senses * sampled(record, "hinge_angle", times)
    for edge, hinge in hinges.items():
        angles[:, edge] = turned[:, hinge]
    titles = [f"{float(time):.9g} s" for time in times]
    return pattern, list(zip(titles, places, angles, strict=True))


def _drawn_pattern(structure: Structure, points: Array) -> tuple[CreasePattern, Array, dict[int, int]]:
    """Return a pattern of the drawn faces, its vertices over time, and the hinges of its edges."""
    shape = shape_of(structure)
    if not shape.faces:
        raise InputError(f"{structure.name}: need a crease pattern or a sheet for a FOLD file")
    used = np.unique([corner for face in shape.faces for corner in face])
    number = {vertex: place for place, vertex in enumerate(used.tolist())}
    faces = tuple(tuple(number[corner] for corner in face) for face in shape.faces)
    sides = _sides(faces)
    lines = {
        frozenset(number[end] for end in ends): line
        for line in shape.lines
        for ends in pairwise(line.path)
        if all(end in number for end in ends)
    }
    letters, hinges = [], {}
    for edge, (ends, owners) in enumerate(sides.items()):
        line = lines.get(ends)
        crease = line is not None and line.kind == "crease"
        letter = line.crease if line is not None and crease and line.crease in ("M", "V") else "U" if crease else "F"
        letters.append(letter if len(owners) == 2 else "B")
        if line is not None and line.hinge is not None:
            hinges[edge] = line.hinge
    flat = np.array([np.nan if letter == "B" else 0.0 for letter in letters])
    pattern = CreasePattern(
        vertices_coords=shape.built[used],
        edges_vertices=np.array([sorted(ends) for ends in sides], dtype=np.int64),
        edges_assignment=tuple(letters),
        edges_fold_angle=flat,
        faces_vertices=faces,
        title=structure.name,
    )
    return pattern, vertex_places(shape, points[:, shape.anchors])[:, used], hinges


def _sides(faces: tuple[tuple[int, ...], ...]) -> dict[frozenset[int], list[int]]:
    """Return the faces at each side."""
    sides: dict[frozenset[int], list[int]] = defaultdict(list)
    for number, face in enumerate(faces):
        for ends in pairwise([*face, face[0]]):
            sides[frozenset(ends)].append(number)
    return sides


def _edge_angles(pattern: CreasePattern, places: Array) -> Array:
    """Return fold angles from positions, valleys positive, rad, (frame, edge); nan beside fewer than two faces."""
    angles = np.full((len(places), len(pattern.edges_vertices)), np.nan)
    normals = np.stack([_normals(places[:, list(face)]) for face in pattern.faces_vertices], axis=1)
    left = {ends: number for number, face in enumerate(pattern.faces_vertices) for ends in pairwise([*face, face[0]])}
    for edge, (tail, head) in enumerate(pattern.edges_vertices.tolist()):
        if (tail, head) not in left or (head, tail) not in left:
            continue
        along = places[:, head] - places[:, tail]
        along /= np.linalg.norm(along, axis=1, keepdims=True)
        one, other = normals[:, left[tail, head]], normals[:, left[head, tail]]
        sine = np.sum(along * np.cross(other, one), axis=1)
        angles[:, edge] = np.arctan2(sine, np.sum(one * other, axis=1))
    return angles


def _normals(corners: Array) -> Array:
    """Return unit normals of polygons, (frame, 3): those of their vector areas (Newell)."""
    area = np.cross(corners, np.roll(corners, -1, axis=1)).sum(axis=1)
    return np.asarray(area / np.maximum(np.linalg.norm(area, axis=1, keepdims=True), 1e-300))
