"""Planes that approximate the boundaries between regions in a cell."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
import scipy

from forficula.study.refine.boundary_plan import Position


@dataclass(frozen=True, kw_only=True)
class BoundaryCrossing:
    """A boundary between two neighbouring positions.

    Attributes:
        low: the position with the lower place on the axis.
        axis: index of the axis along which the positions are neighbours.
        labels: labels at both positions.
    """

    low: Position
    axis: int
    labels: tuple[str, str]

    @property
    def middle(self) -> tuple[float, ...]:
        """Middle between both positions."""
        return tuple(place + 0.5 * (index == self.axis) for index, place in enumerate(self.low))


@dataclass(frozen=True, kw_only=True)
class BoundaryPlane:
    """Plane that approximates a boundary in a cell.

    Attributes:
        axis: axis along which distances from the plane are measured.
        centre: a position on the plane.
        slopes: change of the place on the axis with the places on all axes; 0 for the axis itself.
        labels: labels below and above the plane.
    """

    axis: int
    centre: tuple[float, ...]
    slopes: tuple[float, ...]
    labels: tuple[str, str]

    def height(self, position: Sequence[float]) -> float:
        """Return the place of the plane on the axis at a position."""
        offsets = (slope * (at - mid) for slope, at, mid in zip(self.slopes, position, self.centre, strict=True))
        return self.centre[self.axis] + sum(offsets)

    def distance(self, position: Sequence[float]) -> float:
        """Return the distance from the plane along the axis."""
        return position[self.axis] - self.height(position)

    @property
    def accuracy(self) -> float:
        """Distance from the plane beyond which a label is predicted; boundaries on edges are known to half a step."""
        return max(1.0, *map(abs, self.slopes))


def labels_between(surfaces: Sequence[BoundaryPlane]) -> list[str]:
    """Return the labels between surfaces, from low to high."""
    return [surfaces[0].labels[0], *(surface.labels[1] for surface in surfaces)]


def fitted_plane(crossings: Sequence[BoundaryCrossing]) -> BoundaryPlane | None:
    """Return the plane through boundaries with the same labels; None if their order of labels differs."""
    middles = np.array([crossing.middle for crossing in crossings])
    counts = np.bincount([crossing.axis for crossing in crossings], minlength=middles.shape[1])
    candidates = np.flatnonzero(counts == counts.max())
    axis = int(candidates[np.argmin(np.ptp(middles[:, candidates], axis=0))])
    labels = {crossing.labels for crossing in crossings if crossing.axis == axis}
    if len(labels) > 1:
        return None
    centre = middles.mean(axis=0)
    offsets = middles - centre
    slopes = np.linalg.lstsq(np.delete(offsets, axis, axis=1), offsets[:, axis], rcond=None)[0]
    return BoundaryPlane(
        axis=axis,
        centre=tuple(centre.tolist()),
        slopes=tuple(np.insert(slopes, axis, 0.0).tolist()),
        labels=labels.pop(),
    )


def separating_planes(surfaces: tuple[BoundaryPlane, ...], known: Mapping[Position, str]) -> tuple[BoundaryPlane, ...]:
    """Return planes with all known labels on their right sides, if there are any close to some tested planes.

    Tested planes may have known labels on the wrong side, because boundaries on edges are known to half a step.
    """
    labels = labels_between(surfaces)
    if len(set(labels)) < len(labels) or not set(known.values()) <= set(labels):
        return surfaces
    moved = []
    for number, surface in enumerate(surfaces):
        sides = {position: 1 if labels.index(label) > number else -1 for position, label in known.items()}
        if all(side * surface.distance(position) >= 0 for position, side in sides.items()):
            moved.append(surface)
            continue
        places, signs = np.array(list(sides), dtype=float), np.array(list(sides.values()), dtype=float)
        offsets = places - surface.centre
        across = np.delete(offsets, surface.axis, axis=1)
        # unknowns: shift and slopes of the plane, and its least distance from a label
        unknowns = np.column_stack([signs, signs[:, None] * across, np.ones(len(signs))])
        count = unknowns.shape[1]
        solution = scipy.optimize.linprog(
            [0.0] * (count - 1) + [-1.0],
            A_ub=unknowns,
            b_ub=signs * offsets[:, surface.axis],
            bounds=[(None, None)] * (count - 1) + [(0.0, 0.5)],
        )
        if not solution.success:
            return surfaces
        shift, *slopes = solution.x[:-1].tolist()
        centre = tuple(at + shift * (axis == surface.axis) for axis, at in enumerate(surface.centre))
        slopes.insert(surface.axis, 0.0)
        moved.append(replace(surface, centre=centre, slopes=tuple(slopes)))
    return tuple(moved)
