"""Panels that pass through one another in a shape, because contact is off."""

from __future__ import annotations

import numpy as np

from forficula.arrays import Array, Flags, Indices
from forficula.pattern.drawings.flat_faces import parts_of
from forficula.statics.net.net import Net, NetShape

_TURNED = 1e-3  # rad beyond 180 deg
_WITHIN = 1e-6  # least share of a side or a panel by which it is pierced


def panels_cross(net: Net, shape: NetShape, triangles: Indices) -> bool:
    """Return whether a crease is folded beyond 180 deg, or a side of one triangle pierces another.

    Triangles that share a corner are compared only at their crease.

    Args:
        net: the net.
        shape: of the net.
        triangles: points at the corners, (triangle, 3).
    """
    if np.abs(shape.angles).max(initial=0.0) > np.pi + _TURNED:
        return True
    corners = (net.points @ shape.positions)[triangles]
    return len(triangles) > 1 and bool(_pierced(corners, _joined(net)[triangles]).any())


def _joined(net: Net) -> Indices:
    """Number the points, (point,), so that both sides of a crease between plates have the same numbers."""
    sides = [(flaps[end], flaps[end + 3]) for flaps in net.creases.points for end in (0, 1)]
    if net.contact is not None:
        parts = net.contact.parts
        _, firsts = np.unique(parts.vertices, return_index=True)
        sides += zip(parts.points[firsts[parts.vertices]], parts.points, strict=True)
    return parts_of(net.points.shape[0], sides)


def _pierced(corners: Array, triangles: Indices) -> Flags:
    """Return whether sides of a triangle pierce another one, for all pairs whose boxes overlap, (pair, side).

    The test is that of Moller and Trumbore (1997, doi 10.1080/10867651.1997.10487468).
    """
    low, high = corners.min(axis=1), corners.max(axis=1)
    near = np.all((low[:, None] <= high[None]) & (high[:, None] >= low[None]), axis=2)
    near &= ~(triangles[:, None, :, None] == triangles[None, :, None, :]).any(axis=(2, 3))
    one, other = np.nonzero(near)
    begin = corners[one]
    edge = np.roll(begin, -1, axis=1) - begin
    first, second, third = (corners[other, corner][:, None] for corner in range(3))
    along, beside = second - first, third - first
    across = np.cross(edge, beside)
    size = np.sum(along * across, axis=2)
    with np.errstate(divide="ignore", invalid="ignore"):
        away = begin - first
        u = np.sum(away * across, axis=2) / size
        turned = np.cross(away, along)
        v = np.sum(edge * turned, axis=2) / size
        share = np.sum(beside * turned, axis=2) / size
        inside = (u > _WITHIN) & (v > _WITHIN) & (u + v < 1 - _WITHIN)
        return np.asarray(inside & (share > _WITHIN) & (share < 1 - _WITHIN))
