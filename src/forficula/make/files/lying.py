"""How a printed part lies on the bed, as a mesh that files of any precision keep closed."""

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

# mm: edges shorter than this are no edges, and coordinates have steps of it, which single precision keeps below 1.6 m
_SHORTEST = 1e-3
_DIGITS = 4
_UPRIGHT = 1e-6  # m


@dataclass(frozen=True, kw_only=True, eq=False)
class OrientedPart:
    """What is printed as one: a part, or parts that hang together by hinges which are printed in place.

    Attributes:
        parts: as built flat, of one material.
        count: how many of it.
    """

    parts: tuple[Part, ...]
    count: int

    @property
    def name(self) -> str:
        """Of it: those of its parts."""
        return listed([part.name for part in self.parts], "and")

    @property
    def material(self) -> str:
        """That it is printed of, by name."""
        return self.parts[0].stock.name


def printed_pieces(parts: PartSet) -> tuple[OrientedPart, ...]:
    """What is printed, in the order of the parts; what cannot be put together afterwards is one piece, built flat."""
    first: dict[int, int] = {}
    for joint in parts.joints:
        if joint.make.hinge == "print-in-place":
            first[joint.distal.body] = first.get(joint.proximal.body, joint.proximal.body)
    together: dict[object, list[Part]] = {}
    for part in parts.parts:
        if part.printed:
            body = part.body if part.kind == "bar" else None
            together.setdefault(part.name if body is None else first.get(body, body), []).append(part)
    return tuple(OrientedPart(parts=tuple(each), count=each[0].count) for each in together.values())


def lying_mesh(*parts: Part) -> Mesh:
    """Parts as they are printed as one: on the bed of the first, its longest rod along x, least x, y and z 0, mm.

    Coordinates are rounded to 0.1 um and what is shorter than 1 um is no edge, so that corners which a file of single
    precision would make one are one already.
    """
    mesh = mesh_of(_lying(*parts).simplify(_SHORTEST))
    points = np.round(mesh.points - mesh.points.min(axis=0), _DIGITS) + 0.0
    points, places = np.unique(points, axis=0, return_inverse=True)
    triangles = np.sort(places.reshape(-1)[mesh.triangles], axis=1)
    kept = (np.diff(triangles, axis=1) > 0).all(axis=1)
    return Mesh(points=points, triangles=places.reshape(-1)[mesh.triangles[kept]])


def lying_size(part: Part) -> Array:
    """The sides of the box around a part as it lies, m, (3,): length, width, height."""
    low, high = np.split(np.array(_lying(part).bounding_box()), 2)
    return np.asarray(high - low) / MILLIMETRES


def open_edges(mesh: Mesh) -> int:
    """How many sides of triangles have not just one neighbour that goes along them the other way: 0 of a closed one."""
    sides = np.concatenate([mesh.triangles[:, [0, 1]], mesh.triangles[:, [1, 2]], mesh.triangles[:, [2, 0]]])
    count = len(mesh.points)
    forwards, times = np.unique(sides[:, 0] * count + sides[:, 1], return_counts=True)
    backwards = np.unique(sides[:, 1] * count + sides[:, 0])
    return int((times > 1).sum() + len(np.setdiff1d(forwards, backwards)))


def file_names(names: Sequence[str]) -> list[str]:
    """Names of files for parts, of letters that every disk takes, no two alike."""
    taken: list[str] = []
    for name in names:
        plain = "".join(letter if letter.isascii() and (letter.isalnum() or letter in "-_") else "_" for letter in name)
        tried, number = plain or "part", 1
        while is_device_name(tried) or tried.lower() in [each.lower() for each in taken]:
            number += 1
            tried = f"{plain}-{number}"
        taken.append(tried)
    return taken


def _lying(part: Part, *others: Part) -> Manifold:
    """Parts turned as the first lies, its longest rod along x, mm."""
    shape = Manifold.batch_boolean([part.shape, *(each.shape for each in others)], OpType.Add) if others else part.shape
    bedded = shape.transform(np.column_stack([part.bed, np.zeros(3)]))
    x, y = max((part.bed[:2] @ along for along in _rods(part.solid)), key=np.linalg.norm, default=np.array([1.0, 0.0]))
    # upright ones, such as the eyes of a strap on its side, have no way to point
    return bedded.rotate([0.0, 0.0, -math.degrees(math.atan2(y, x))]) if math.hypot(x, y) > _UPRIGHT else bedded


def _rods(solid: Solid) -> Iterator[Array]:
    """The rods that a solid is joined of, from end to end, m, (3,)."""
    match solid:
        case Rod():
            yield solid.end - solid.start
        case Joined() | Shared():
            for each in solid.solids:
                yield from _rods(each)
        case Cut():
            yield from _rods(solid.solid)
