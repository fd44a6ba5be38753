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
        crease: unit vector of its distal hinge in the same axes, (vein, 3).
        frames: from the bar's axes to the wing's, (vein, 3, 3).
        senses: +1 or -1 by vein: the sign of the turn that folds it, (vein,).
        flat: the points in the flat wing, (point, 3).
        points: in the axes of the bar that carries each, from the hub or from the ring vertex, (point, 3).
        carriers: vein that carries each point, (point,).
        beyond: whether a point is on the distal bar, (point,).
        triangles: of the membrane, three points each, (triangle, 3).
    """

    design: Design
    hub: Array
    ring: Array
    crease: Array
    frames: Array
    senses: Array
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
    nodes, carriers, beyond, triangles = _mesh(hub, ring, tip, design)
    veins = np.arange(len(hub))
    flat = np.concatenate([nodes, tip])
    carriers, beyond = np.concatenate([carriers, veins]), np.concatenate([beyond, veins >= 0])
    start = np.where(beyond[:, None], ring[carriers], hub[carriers])
    return Wing(
        design=design,
        hub=hub,
        ring=_in_bar(frames, ring - hub),
        crease=_in_bar(frames, creases / np.linalg.norm(creases, axis=1, keepdims=True)),
        frames=frames,
        senses=np.where(veins % 2 == 1, 1.0, -1.0),
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
    swept = wing.frames @ _turned(np.array([0.0, 0.0, 1.0]), angles[..., SWEEP])
    lifted = swept @ _turned(np.array([0.0, 1.0, 0.0]), angles[..., LIFT])
    proximal = lifted @ _turned(np.array([1.0, 0.0, 0.0]), wing.senses * angles[..., TURN])
    distal = proximal @ _turned(wing.crease, wing.senses * angles[..., FOLD])
    ring = wing.hub + np.einsum("cvij,vj->cvi", proximal, wing.ring)
    folds = np.einsum("cvij,vj->cvi", proximal, wing.crease)
    sense, sweeps = wing.senses[:, None], np.broadcast_to(wing.frames[:, :, 2], folds.shape)
    axes = np.stack([sweeps, swept[..., 1], sense * lifted[..., 0], sense * folds], axis=2)

    place, beyond = wing.carriers, wing.beyond[:, None]
    bars = np.where(beyond[:, None], distal[:, place], proximal[:, place])
    start = np.where(beyond, ring[:, place], wing.hub[place])
    points = start + np.einsum("cpij,pj->cpi", bars, wing.points)
    from_hub, from_ring = points - wing.hub[place], beyond * (points - ring[:, place])
    moves = np.cross(axes[:, place], np.stack([from_hub, from_hub, from_hub, from_ring], axis=2))
    return Pose(points=points, axes=axes, moves=np.asarray(moves))


def _in_bar(frames: Array, vectors: Array) -> Array:
    return np.asarray(np.einsum("nji,nj->ni", frames, vectors))


def _turned(axis: Array, angle: Array) -> Array:
    """Rotations about unit vectors (Rodrigues' formula): axis (3,) or (vein, 3), angle (..., vein)."""
    x, y, z = np.moveaxis(np.broadcast_to(axis, (*angle.shape[-1:], 3)), -1, 0)
    zero = np.zeros_like(x)
    cross = np.stack([zero, -z, y, z, zero, -x, -y, x, zero], axis=-1).reshape(-1, 3, 3)
    sine, half = np.sin(angle)[..., None, None], np.sin(angle / 2)[..., None, None]
    return np.asarray(np.eye(3) + sine * cross + 2 * half**2 * (cross @ cross))


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
