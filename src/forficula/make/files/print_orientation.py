"""Orientation of printed parts on the bed, as meshes that stay closed in files of any precision."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from manifold3d import Manifold, OpType

from forficula.arrays import Array
from forficula.make.part import Part, PartSet
from forficula.make.solid.mesh import MILLIMETRES, Mesh, mesh_of
from forficula.make.solid.solids import Cut, Joined, Rod, Shared, Solid
from forficula.names import is_device_name, listed

# mm: shorter edges are removed, and coordinates are multiples of it, which single precision resolves below 1.6 m
_SHORTEST = 1e-3
_DIGITS = 4
_UPRIGHT = 1e-6  # m


@dataclass(frozen=True, kw_only=True, eq=False)
class OrientedPart:
    """A piece that is printed as one: a part, or parts that are connected by hinges printed in place.

    Attributes:
        parts: in the flat structure, of one material.
        count: number of pieces.
    """

    parts: tuple[Part, ...]
    count: int

    @property
    def name(self) -> str:
        """Names of its parts."""
        return listed([part.name for part in self.parts], "and")

    @property
    def material(self) -> str:
        """Name of its material."""
        return self.parts[0].stock.name


def printed_pieces(parts: PartSet) -> tuple[OrientedPart, ...]:
    """Return the printed pieces, in the order of the parts. Parts that cannot be assembled later are one flat piece."""
    first: dict[int, int] = {}
    for joint in parts.joints:
        if joint.make.hinge == "print-in-place":
            first[joint.distal.body] = first.get(joint.proximal.body, joint.proximal.body)
    together: dict[object, list[Part]] = {}
    for part in parts.parts:
        if part.printed:
            body = part.body if part.kind == "bar" else None
            together.setdefault(part.name if body is None else first.get(body, body), []).append(part)
    return tuple(OrientedPart(parts=tuple(piece), count=piece[0].count) for piece in together.values())


def print_mesh(*parts: Part) -> Mesh:
    """Return parts as one print: on the bed of the first, its longest rod along x, smallest x, y and z 0, mm.

    Coordinates are rounded to 0.1 um and edges shorter than 1 um are removed, so that corners that single precision
    would merge are merged already.
    """
    mesh = mesh_of(_lying(*parts).simplify(_SHORTEST))
    points = np.round(mesh.points - mesh.points.min(axis=0), _DIGITS) + 0.0
    points, indices = np.unique(points, axis=0, return_inverse=True)
    triangles = np.sort(indices.reshape(-1)[mesh.triangles], axis=1)
    kept = (np.diff(triangles, axis=1) > 0).all(axis=1)
    return Mesh(points=points, triangles=indices.reshape(-1)[mesh.triangles[kept]])


def print_size(part: Part) -> Array:
    """Return the sides of the box around a part in its print orientation, m, (3,): length, width, height."""
    low, high = np.split(np.array(_lying(part).bounding_box()), 2)
    return np.asarray(high - low) / MILLIMETRES


def open_edges(mesh: Mesh) -> int:
    """Return the number of sides of triangles without exactly one opposite neighbour; 0 for a closed mesh."""
    sides = np.concatenate([mesh.triangles[:, [0, 1]], mesh.triangles[:, [1, 2]], mesh.triangles[:, [2, 0]]])
    count = len(mesh.points)
    forwards, times = np.unique(sides[:, 0] * count + sides[:, 1], return_counts=True)
    backwards = np.unique(sides[:, 1] * count + sides[:, 0])
    return int((times > 1).sum() + len(np.setdiff1d(forwards, backwards)))


def file_names(names: Sequence[str]) -> list[str]:
    """Return unique file names for parts, with letters that every file system allows."""
    used: list[str] = []
    for name in names:
        plain = "".join(letter if letter.isascii() and (letter.isalnum() or letter in "-_") else "_" for letter in name)
        tried, number = plain or "part", 1
        while is_device_name(tried) or tried.lower() in [name_used.lower() for name_used in used]:
            number += 1
            tried = f"{plain}-{number}"
        used.append(tried)
    return used


def _lying(part: Part, *others: Part) -> Manifold:
    """Return parts in the print orientation of the first, its longest rod along x, mm."""
    shape = (
        Manifold.batch_boolean([part.shape, *(other.shape for other in others)], OpType.Add) if others else part.shape
    )
    bedded = shape.transform(np.column_stack([part.bed, np.zeros(3)]))
    x, y = max((part.bed[:2] @ along for along in _rods(part.solid)), key=np.linalg.norm, default=np.array([1.0, 0.0]))
    # upright rods, such as the eyes of a strap on its side, have no horizontal direction
    return bedded.rotate([0.0, 0.0, -math.degrees(math.atan2(y, x))]) if math.hypot(x, y) > _UPRIGHT else bedded


def _rods(solid: Solid) -> Iterator[Array]:
    """Yield the rods of a solid, from end to end, m, (3,)."""
    match solid:
        case Rod():
            yield solid.end - solid.start
        case Joined() | Shared():
            for child in solid.solids:
                yield from _rods(child)
        case Cut():
            yield from _rods(solid.solid)
