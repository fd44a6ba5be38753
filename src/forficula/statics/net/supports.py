"""Rigid-body motions that the supports of a net allow, and strain-free pins that remove them."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

import numpy as np
from scipy.linalg import null_space, qr

from forficula.arrays import Array, Indices
from forficula.errors import InputError
from forficula.statics.net.energy import built_shape, load_slope
from forficula.statics.net.load import Load
from forficula.statics.net.net import Net

_NONE = 1e-9  # share of the largest singular value that counts as zero


def rigid_motions(positions: Array) -> Array:
    """Return the six orthonormal motions of a rigid body, (node, 3, 6); fewer for nodes on one line."""
    centred = positions - positions.mean(axis=0)
    shifts = np.broadcast_to(np.eye(3), (len(positions), 3, 3))
    turns = np.cross(np.eye(3)[None, :, :], centred[:, None, :]).transpose(0, 2, 1)
    scale = np.abs(centred).max() or 1.0
    motions = np.concatenate((shifts, turns / scale), axis=2).reshape(-1, 6)
    axes, sizes, _ = np.linalg.svd(motions, full_matrices=False)
    return np.asarray(axes[:, sizes > _NONE * sizes[0]].reshape(len(positions), 3, -1))


def loose_motions(net: Net, positions: Array | None = None) -> Array:
    """Return the motions of a rigid body that the supports leave to a net, (node, 3, motion).

    Args:
        net: supported or not.
        positions: of its nodes, m, (node, 3); by default as built.
    """
    motions = rigid_motions(net.nodes if positions is None else positions)
    held = motions[~net.free]
    return np.asarray(motions @ null_space(held, rcond=_NONE)) if len(held) else motions


def supported(net: Net, load: Load | None = None) -> tuple[Net, tuple[tuple[int, int], ...]]:
    """Hold one further coordinate for each free rigid-body motion, which strains nothing.

    The coordinates belong to the corners of a large panel near the middle, so that they hold however the net folds. If
    there is no crease, or if these corners are not sufficient, they are chosen from all nodes. Under gravity nothing is
    held, because the orientation of the net matters.

    Args:
        net: supported or not.
        load: load that will act; None for none.

    Returns:
        The net, and the newly held pairs of node and axis.

    Raises:
        InputError: the load would move the net as a rigid body.
    """
    loose = loose_motions(net)
    if load is not None and loose.shape[2]:
        pushed = load_slope(net, built_shape(net), load)
        if np.abs(np.einsum("nim,ni->m", loose, pushed)).max() > 1e-6 * np.linalg.norm(pushed):
            raise InputError(
                f"support: need some that hold the whole against the load, got {loose.shape[2]} motions that are free"
            )
    return (net, ()) if net.gravity else _pinned(net)


@lru_cache(maxsize=8)
def _pinned(net: Net) -> tuple[Net, tuple[tuple[int, int], ...]]:
    loose = loose_motions(net)
    count = loose.shape[2]
    if not count:
        return net, ()
    for nodes in (_panel(net), np.arange(len(net.nodes))):
        coordinates = np.array([(node, axis) for node in nodes for axis in range(3) if net.free[node, axis]])
        if len(coordinates) < count:
            continue
        _, remains, order = qr(loose[coordinates[:, 0], coordinates[:, 1]].T, mode="economic", pivoting=True)
        if abs(remains[count - 1, count - 1]) > 1e-3 * abs(remains[0, 0]):
            break
    pins = coordinates[order[:count]]
    free = net.free.copy()
    free[pins[:, 0], pins[:, 1]] = False
    return replace(net, free=free), tuple((int(node), int(axis)) for node, axis in pins)


def _panel(net: Net) -> Indices:
    """Return the nodes at the corners of a large panel near the middle; empty without a crease."""
    if not len(net.creases.points):
        return np.zeros(0, dtype=np.int64)
    corners = net.points @ net.nodes
    panels = net.creases.points[:, :3]
    tail, head, left = (corners[panels[:, corner]] for corner in range(3))
    area = np.linalg.norm(np.cross(head - tail, left - tail), axis=1)
    away = np.linalg.norm((tail + head + left) / 3 - net.nodes.mean(axis=0), axis=1)
    chosen = panels[np.argmax(area / (away + 0.1 * net.size) ** 2)]
    rows = net.points[chosen]
    return np.unique(rows.indices[rows.data != 0])
