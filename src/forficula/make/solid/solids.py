"""Shapes of parts: rods, prisms and convex hulls, and their unions, differences and intersections.

They form a tree that kernels evaluate. Lengths in m. Each shape is defined only once, so that two
kernels can evaluate the same tree and be compared.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array


@dataclass(frozen=True, kw_only=True, eq=False)
class Rod:
    """A round bar with flat ends.

    Attributes:
        start: centre of one end, m, (3,).
        end: centre of the other, m, (3,).
        diameter: m.
    """

    start: Array
    end: Array
    diameter: float


@dataclass(frozen=True, kw_only=True, eq=False)
class Prism:
    """A polygon extruded along its normal.

    Attributes:
        outline: corners counterclockwise, seen against the normal, in the axes of the polygon, m, (corner, 2).
        origin: origin of these axes, m, (3,).
        frame: the two axes and the normal as columns, (3, 3), right-handed.
        height: along the normal, half of it on either side of the polygon, m.
    """

    outline: Array
    origin: Array
    frame: Array
    height: float


@dataclass(frozen=True, kw_only=True, eq=False)
class Hull:
    """The convex hull of corners.

    Attributes:
        corners: m, (corner, 3).
    """

    corners: Array


@dataclass(frozen=True, kw_only=True, eq=False)
class Joined:
    """Union of solids."""

    solids: tuple[Solid, ...]


@dataclass(frozen=True, kw_only=True, eq=False)
class Cut:
    """A solid minus others."""

    solid: Solid
    taken: tuple[Solid, ...]


@dataclass(frozen=True, kw_only=True, eq=False)
class Shared:
    """Intersection of solids."""

    solids: tuple[Solid, ...]


Solid = Rod | Prism | Hull | Joined | Cut | Shared


def joined(*solids: Solid) -> Solid:
    """Return the union of solids; of one, the solid itself."""
    return solids[0] if len(solids) == 1 else Joined(solids=solids)


def box(low: Sequence[float], high: Sequence[float], origin: Array, frame: Array) -> Prism:
    """Return a box with sides along the columns of a frame, between two corners relative to an origin, m."""
    (left, front, bottom), (right, back, top) = low, high
    return Prism(
        outline=np.array([[left, front], [right, front], [right, back], [left, back]]),
        origin=origin + frame[:, 2] * (bottom + top) / 2,
        frame=frame,
        height=top - bottom,
    )


def band(line: Array, thickness: float) -> Array:
    """Return the outline of a strip of constant thickness along an open line in a plane, m, (2 corners of the line, 2).

    Args:
        line: corners, m, (corner, 2).
        thickness: m.
    """
    steps = np.diff(line, axis=0)
    steps /= np.linalg.norm(steps, axis=1)[:, None]
    normals = np.column_stack([-steps[:, 1], steps[:, 0]])
    # at a corner along the bisector of the two normals, longer so that both sides keep their thickness
    mitres = np.vstack([normals[:1], normals[:-1] + normals[1:], normals[-1:]])
    mitres /= np.linalg.norm(mitres, axis=1)[:, None]
    along = np.vstack([normals[:1], normals])
    mitres /= np.sum(mitres * along, axis=1)[:, None]
    return np.vstack([line - mitres * thickness / 2, (line + mitres * thickness / 2)[::-1]])


def moved(solid: Solid, frame: Array, origin: Array) -> Solid:
    """Return a solid rotated about the origin, (3, 3), and then moved, m, (3,)."""
    match solid:
        case Rod():
            start, end = (frame @ point + origin for point in (solid.start, solid.end))
            return Rod(start=start, end=end, diameter=solid.diameter)
        case Prism():
            return Prism(
                outline=solid.outline,
                origin=frame @ solid.origin + origin,
                frame=frame @ solid.frame,
                height=solid.height,
            )
        case Hull():
            return Hull(corners=solid.corners @ frame.T + origin)
        case Joined():
            return Joined(solids=tuple(moved(child, frame, origin) for child in solid.solids))
        case Shared():
            return Shared(solids=tuple(moved(child, frame, origin) for child in solid.solids))
        case Cut():
            taken = tuple(moved(child, frame, origin) for child in solid.taken)
            return Cut(solid=moved(solid.solid, frame, origin), taken=taken)
