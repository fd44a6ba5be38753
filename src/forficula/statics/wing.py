"""The bars of a wing in space: a flat layout, and where any angles of its joints take it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from forficula.design import Design
from forficula.design.places import mesh_rows
from forficula.pattern import hub_points, ring_vertices, tips

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

# the joints of a vein, in this order: the first two aim it, the third turns it about its own axis
SWEEP, LIFT, TURN, FOLD = range(4)


@dataclass(frozen=True, kw_only=True)
class Wing:
    """The bars of a flat wing and the points that they carry, m: the nodes of the membrane, then the tips.

    Attributes:
        design: the design.
        hub: proximal joint of each vein, (vein, 3).
        ring: its ring vertex from there, in the bar's axes (x along the proximal bar, z across the wing), (vein, 3).
        joints: axes of its four joints in the same axes, the last two in the vein's own sense: unit vectors,
            (vein, 4, 3).
        frames: from the bar's axes to the wing's, (vein, 3, 3).
        flat: the points in the flat wing, (point, 3).
        points: in the axes of the bar that carries each, from the hub or from the ring vertex, (point, 3).
        carriers: vein that carries each point, (point,).
        beyond: whether a point is on the distal bar, (point,).
        triangles: of the membrane, three points each, (triangle, 3).
    """

    design: Design
    hub: Array
    ring: Array
    joints: Array
    frames: Array
    flat: Array
    points: Array
    carriers: Indices
    beyond: NDArray[np.bool_]
    triangles: Indices

    @property
    def size(self) -> int:
        """Number of joint angles, four for each vein."""
        return 4 * len(self.hub)

    @property
    def tips(self) -> Indices:
        """Which points are the tips, (vein,)."""
        return np.arange(len(self.points) - len(self.hub), len(self.points))


@dataclass(frozen=True, kw_only=True)
class Pose:
    """A wing in space, for some cases side by side.

    Attributes:
        points: m, (case, point, 3).
        axes: unit vectors of the four joints, in the vein's own senses, (case, vein, 4, 3).
        moves: velocity of each point by the speed of each joint of its vein, m, (case, point, 4, 3).
    """

    points: Array
    axes: Array
    moves: Array


def flat_wing(design: Design) -> Wing:
    """Lay out the wing of a design."""
    hub, ring, tip = hub_points(design.fan), ring_vertices(design.fan, continued=True), tips(design.fan)
    creases = np.diff(ring, axis=0)
    ring = ring[:-1]
    along = (ring - hub) / np.linalg.norm(ring - hub, axis=1, keepdims=True)
    across = np.broadcast_to([0.0, 0.0, 1.0], along.shape)
    frames = np.stack([along, np.cross(across, along), across], axis=2)
    veins = np.arange(len(hub))
    turn, lift, sweep = (np.broadcast_to(axis, along.shape) for axis in np.eye(3))
    fold = _in_bar(frames, creases / np.linalg.norm(creases, axis=1, keepdims=True))
    senses = np.where(veins % 2 == 1, 1.0, -1.0)[:, None]  # sign of the turn that folds a vein
    nodes, carriers, beyond, triangles = _mesh(hub, ring, tip, design)
    flat = np.concatenate([nodes, tip])
    carriers, beyond = np.concatenate([carriers, veins]), np.concatenate([beyond, veins >= 0])
    start = np.where(beyond[:, None], ring[carriers], hub[carriers])
    return Wing(
        design=design,
        hub=hub,
        ring=_in_bar(frames, ring - hub),
        joints=np.stack([sweep, lift, senses * turn, senses * fold], axis=1),
        frames=frames,
        flat=flat,
        points=_in_bar(frames[carriers], flat - start),
        carriers=carriers,
        beyond=beyond,
        triangles=triangles,
    )


def pose(wing: Wing, angles: Array) -> Pose:
    """Place the bars.

    Args:
        wing: the flat wing.
        angles: sweep, lift, turn and fold of each vein, the last two in its own sense, rad, (case, vein, 4).
    """
    turns = _turned(wing.joints, angles)
    swept = wing.frames @ turns[:, :, SWEEP]
    lifted = swept @ turns[:, :, LIFT]
    proximal = lifted @ turns[:, :, TURN]
    distal = proximal @ turns[:, :, FOLD]
    bars = np.stack([swept, lifted, proximal, distal], axis=2)
    axes = _times(bars, wing.joints)
    ring = wing.hub + _times(proximal, wing.ring)

    place, beyond = wing.carriers, wing.beyond[:, None]
    start = np.where(beyond, ring[:, place], wing.hub[place])
    points = start + _times(bars[:, place, np.where(wing.beyond, FOLD, TURN)], wing.points)
    # by joint: from where its axis passes to the point, nothing where the point does not move with it
    arms = np.empty((*points.shape[:2], 4, 3))
    arms[:, :, :FOLD] = (points - wing.hub[place])[:, :, None]
    arms[:, :, FOLD] = beyond * (points - start)
    return Pose(points=points, axes=axes, moves=cross(axes[:, place], arms))


def cross(one: Array, other: Array) -> Array:
    """Cross products along the last axis, (..., 3); np.cross takes twice as long."""
    x, y, z = one[..., 0], one[..., 1], one[..., 2]
    u, v, w = other[..., 0], other[..., 1], other[..., 2]
    product = np.empty(np.broadcast_shapes(one.shape, other.shape))
    product[..., 0], product[..., 1], product[..., 2] = y * w - z * v, z * u - x * w, x * v - y * u
    return product


def _times(matrices: Array, vectors: Array) -> Array:
    return np.asarray((matrices @ vectors[..., None])[..., 0])


def _in_bar(frames: Array, vectors: Array) -> Array:
    return np.asarray(np.einsum("nji,nj->ni", frames, vectors))


def _turned(axis: Array, angle: Array) -> Array:
    """Rotations about unit vectors (Rodrigues' formula): axis (..., 3), angle (case, ...)."""
    spin = cross(np.eye(3), axis[..., None, :])
    sine, half = np.sin(angle)[..., None, None], np.sin(angle / 2)[..., None, None]
    return np.asarray(np.eye(3) + sine * spin + 2 * half**2 * (spin @ spin))


def _mesh(hub: Array, ring: Array, tip: Array, design: Design) -> tuple[Array, Indices, NDArray[np.bool_], Indices]:
    """Nodes of the flat mesh (m), the vein that carries each, whether on its distal bar, and the triangles.

    Panel k hangs on vein k by its margin and on the axis of vein k + 1.
    """
    law = design.membrane
    rows = np.array([mesh_rows(*ends, design) for ends in zip(hub, ring, tip, strict=True)])
    count = rows.shape[1]
    nodes, carriers, triangles = [], [], []
    for panel in range(len(hub) - 1):
        near, far = rows[panel], rows[panel + 1]
        width = np.linalg.norm(far - near, axis=1, keepdims=True)
        edge = near + np.minimum(law.margin, law.margin_limit * width) / width * (far - near)
        nodes.append(np.stack([edge, far], axis=1).reshape(-1, 3))
        carriers += [panel, panel + 1] * count
        for left in range(2 * panel * count, 2 * (panel + 1) * count - 2, 2):
            triangles += [[left, left + 2, left + 3], [left, left + 3, left + 1]]
    beyond = np.tile(np.repeat(np.arange(count) > len(law.proximal_rows), 2), len(hub) - 1)
    return np.concatenate(nodes), np.array(carriers), beyond, np.array(triangles)
