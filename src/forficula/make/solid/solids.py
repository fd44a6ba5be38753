"""What parts are shaped of: rods and prisms, and what is joined, cut and shared of them; a tree that kernels evaluate.

Lengths in m. It is told once, so that two kernels can make the same of it and be held to one another.
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
        start: middle of one end, m, (3,).
        end: middle of the other, m, (3,).
        diameter: m.
    """

    start: Array
    end: Array
    diameter: float


@dataclass(frozen=True, kw_only=True, eq=False)
class Prism:
    """A polygon pushed along its normal.

    Attributes:
        outline: corners counterclockwise, seen against the normal, in the axes of the polygon, m, (corner, 2).
        origin: of these axes, m, (3,).
        frame: the two axes and the normal as columns, (3, 3), right-handed.
        height: along the normal, half of it on either side of the polygon, m.
    """

    outline: Array
    origin: Array
    frame: Array
    height: float


@dataclass(frozen=True, kw_only=True, eq=False)
class Joined:
    """All that is in any of them."""

    solids: tuple[Solid, ...]


@dataclass(frozen=True, kw_only=True, eq=False)
class Cut:
    """What is in a solid and in none of those that are taken away."""

    solid: Solid
    taken: tuple[Solid, ...]


@dataclass(frozen=True, kw_only=True, eq=False)
class Shared:
    """What is in all of them."""

    solids: tuple[Solid, ...]


Solid = Rod | Prism | Joined | Cut | Shared


def joined(*solids: Solid) -> Solid:
    """All that is in any of them; of one, itself."""
    return solids[0] if len(solids) == 1 else Joined(solids=solids)


def box(low: Sequence[float], high: Sequence[float], origin: Array, frame: Array) -> Prism:
    """A box with sides along the columns of a frame, between two corners from an origin, m."""
    (left, front, bottom), (right, back, top) = low, high
    return Prism(
        outline=np.array([[left, front], [right, front], [right, back], [left, back]]),
        origin=origin + frame[:, 2] * (bottom + top) / 2,
        frame=frame,
        height=top - bottom,
    )


def band(line: Array, thickness: float) -> Array:
    """The outline of a strip of even thickness along an open line in a plane, m, (2 corners of the line, 2).

    Args:
        line: corners, m, (corner, 2).
        thickness: m.
    """
    steps = np.diff(line, axis=0)
    steps /= np.linalg.norm(steps, axis=1)[:, None]
    normals = np.column_stack([-steps[:, 1], steps[:, 0]])
    # at a corner half way between the two, longer by what keeps the thickness of both
    mitres = np.vstack([normals[:1], normals[:-1] + normals[1:], normals[-1:]])
    mitres /= np.linalg.norm(mitres, axis=1)[:, None]
    along = np.vstack([normals[:1], normals])
    mitres /= np.sum(mitres * along, axis=1)[:, None]
    return np.vstack([line - mitres * thickness / 2, (line + mitres * thickness / 2)[::-1]])


def moved(solid: Solid, frame: Array, origin: Array) -> Solid:
    """A solid turned by a rotation about the origin, (3, 3), and then moved, m, (3,)."""
    match solid:
        case Rod():
            start, end = (frame @ place + origin for place in (solid.start, solid.end))
            return Rod(start=start, end=end, diameter=solid.diameter)
        case Prism():
            return Prism(
                outline=solid.outline,
                origin=frame @ solid.origin + origin,
                frame=frame @ solid.frame,
                height=solid.height,
            )
        case Joined():
            return Joined(solids=tuple(moved(each, frame, origin) for each in solid.solids))
        case Shared():
            return Shared(solids=tuple(moved(each, frame, origin) for each in solid.solids))
        case Cut():
            taken = tuple(moved(each, frame, origin) for each in solid.taken)
            return Cut(solid=moved(solid.solid, frame, origin), taken=taken)
