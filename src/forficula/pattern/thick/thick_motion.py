"""Motions of thick panels from fold angles, the fold path of a sheet, and how far panels overlap along it."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.pattern.crease_pattern import CreasePattern, is_unfolded
from forficula.pattern.facet_tree import facet_tree
from forficula.pattern.facts.rigid_folding import folded_as_assigned, senses
from forficula.pattern.facts.vertex_creases import vertex_creases
from forficula.pattern.fold_angles import built_fold_angles
from forficula.pattern.geometry import polygon_normal
from forficula.pattern.kinematics import folded_coordinates
from forficula.pattern.rotation import RigidMotion, rotations_about
from forficula.pattern.shared_edges import shared_edges
from forficula.pattern.thick.convex import ConvexSolid, packed_solids, pair_overlaps

_FLAT_FOLDABLE = 1e-6  # rad, largest alternating sum of sectors that counts as rounding
# [chosen] number of poses at which the overlap of panels is computed
POSES = 48


def facet_motions(pattern: CreasePattern, ends: Array, turns: Array) -> list[list[RigidMotion]]:
    """Compute the motions of facets from the position as built, (pose, facet); facet 0 stays.

    Args:
        pattern: flat or folded as built.
        ends: positions of the two vertices of every edge on its axis, as built, m, (edge, 2, 3).
        turns: changes of the fold angles, valley positive, rad, (pose, edge).
    """
    poses, facets = len(turns), len(pattern.faces_vertices)
    rotations, shifts = np.empty((facets, poses, 3, 3)), np.empty((facets, poses, 3))
    for link in facet_tree(pattern):
        if link.closes:
            continue
        if link.parent is None or link.edge is None:
            rotations[link.facet], shifts[link.facet] = np.eye(3), 0.0
            continue
        one, other = ends[link.edge] if pattern.edges_vertices[link.edge][0] == link.tail else ends[link.edge][::-1]
        along = (other - one) / np.linalg.norm(other - one)
        turn = rotations_about(along, -turns[:, link.edge])
        rotations[link.facet] = rotations[link.parent] @ turn
        shifts[link.facet] = rotations[link.parent] @ one - rotations[link.facet] @ one + shifts[link.parent]
    return [
        [RigidMotion(rotations[facet, pose], shifts[facet, pose]) for facet in range(facets)] for pose in range(poses)
    ]


def built_angles(pattern: CreasePattern) -> Array:
    """Compute the fold angle of every edge as built, rad, (edge,); 0 on borders and flat edges."""
    if is_unfolded(pattern):
        return np.zeros(len(pattern.edges_vertices))
    return np.where(senses(pattern) != 0, np.nan_to_num(built_fold_angles(pattern)), 0.0)


def flat_folded(pattern: CreasePattern) -> Array:
    """Fold a sheet without thickness flat, in the plane of its first facet, whose first corner is the origin.

    Returns:
        Positions of the vertices, m, (vertex, 3).

    Raises:
        InputError: an unassigned crease, or a sheet that does not fold flat.
    """
    for edge in shared_edges(pattern):
        if pattern.edges_assignment[edge.edge] == "U":
            raise InputError(f"need mountains and valleys, got crease {edge.edge}, which is unassigned")
    try:
        folded = folded_coordinates(pattern, np.pi * senses(pattern) - built_angles(pattern))
    except InputError:
        raise InputError("need a sheet that folds flat without thickness, got one that tears") from None
    corners = pattern.vertices_coords[list(pattern.faces_vertices[0])]
    normal, along = polygon_normal(corners), corners[1] - corners[0]
    frame = np.array([along, np.cross(normal, along), normal])
    frame /= np.linalg.norm(frame, axis=1)[:, None]
    return np.asarray((folded - corners[0]) @ frame.T)


def largest_angles(pattern: CreasePattern, limits: Sequence[tuple[float, float]]) -> Array:
    """Return the fold angles of edges that have reached their limits in the senses of the pattern, rad, (edge,)."""
    signs = senses(pattern)
    most = np.array([high if sign > 0 else -low for (low, high), sign in zip(limits, signs, strict=True)])
    return np.asarray(signs * np.maximum(most, 0.0), dtype=np.float64)


def fold_path(
    pattern: CreasePattern, limits: Sequence[tuple[float, float]], poses: int = POSES, *, slowing: bool = False
) -> Array | None:
    """Compute fold angles from the flat sheet until the first crease reaches its limit, rad, (pose, edge).

    Around vertices of four creases that fold flat, the tangents of half the fold angles have constant ratios (Huffman
    1976; Tachi 2009). Without interior vertices, creases fold in any order; the path of a sheet that folds flat then
    consists of its flat-folded state alone.

    Args:
        pattern: flat or folded as built, with mountains, valleys and flat edges.
        limits: least and largest fold angle of every edge, valley positive, rad.
        poses: number of poses; the flat one is left out.
        slowing: whether the steps of the largest fold angle decrease linearly to the last pose, where panels that lie
            on one another slide; otherwise they are equal.

    Returns:
        None if the path has no such closed form.
    """
    around = [vertex for vertex in vertex_creases(pattern) if len(vertex.edges)]
    signs, most = senses(pattern), np.abs(largest_angles(pattern, limits))
    if not around:
        return np.asarray(signs * most, dtype=np.float64)[None] if (most[signs != 0] == math.pi).all() else None
    for vertex in around:
        alternating = float(vertex.sectors[::2].sum() - vertex.sectors[1::2].sum())
        if len(vertex.edges) != 4 or abs(alternating) > _FLAT_FOLDABLE:
            return None
    angles = folded_as_assigned(pattern) if is_unfolded(pattern) else built_angles(pattern)
    if angles is None or np.abs(angles).max() > math.pi - 1e-6:
        return None
    ratios = np.tan(angles / 2)
    moving = ratios != 0
    # 1 at the crease that folds most; the first limit that is reached ends the path
    ratios /= np.abs(ratios).max()
    with np.errstate(divide="ignore"):
        last = float((np.tan(most[moving] / 2) / np.abs(ratios[moving])).min())
    largest = 2 * math.atan(last) if last < 1e12 else math.pi
    shares = np.linspace(0.0, 1.0, poses + 1)[1:, None]
    shares = largest * (1 - (1 - shares) ** 2 if slowing else shares)
    return np.asarray(2 * np.arctan2(ratios * np.sin(shares / 2), np.cos(shares / 2)))


def panel_overlaps(
    panels: Sequence[Sequence[ConvexSolid]], turns: Array, shifts: Array
) -> Iterator[tuple[int, int, Array]]:
    """Compute to what depth panels overlap in several poses.

    Args:
        panels: convex solids of each panel as built.
        turns: rotations of the panels from the position as built, (pose, panel, 3, 3).
        shifts: shifts after the rotations, m, (pose, panel, 3).

    Yields:
        The numbers of two panels whose surroundings overlap, and the depth in each pose, m, (pose,); 0 where the panels
        do not overlap.
    """
    solids = [solid for panel in panels for solid in panel]
    if not solids:
        return
    owners = np.repeat(np.arange(len(panels)), [len(panel) for panel in panels])
    packed = packed_solids(solids)
    centres = np.array([solid.corners.mean(axis=0) for solid in solids])
    reaches = np.array(
        [np.linalg.norm(solid.corners - centre, axis=1).max() for solid, centre in zip(solids, centres, strict=True)]
    )
    moved = np.einsum("psij,sj->psi", turns[:, owners], centres) + shifts[:, owners]
    for one in range(len(panels) - 1):
        first, second = np.flatnonzero(owners == one), np.flatnonzero(owners > one)
        apart = np.linalg.norm(moved[:, first, None] - moved[:, None, second], axis=3)
        poses, left, right = np.nonzero(apart < reaches[first, None] + reaches[second])
        left, right = first[left], second[right]
        motions = [(turns[poses, owners[side]], shifts[poses, owners[side]]) for side in (left, right)]
        depths = pair_overlaps(packed, left, right, motions[0], motions[1])
        deepest = np.zeros((len(panels), len(turns)))
        np.maximum.at(deepest, (owners[right], poses), depths)
        for other in np.flatnonzero(deepest.any(axis=1)).tolist():
            yield one, other, deepest[other]


def deepest_overlap(
    panels: Sequence[Sequence[ConvexSolid]], motions: Sequence[Sequence[RigidMotion]]
) -> tuple[float, tuple[int, int], int]:
    """Compute the largest depth to which two panels overlap.

    Args:
        panels: convex solids of each panel as built.
        motions: motions of the panels in every pose, (pose, panel).

    Returns:
        Depth, m, 0 if none overlap; numbers of the two panels; number of the pose.
    """
    turns = np.array([[motion.rotation for motion in pose] for pose in motions])
    shifts = np.array([[motion.shift for motion in pose] for pose in motions])
    deepest, pair, pose = 0.0, (0, 0), 0
    for one, other, depths in panel_overlaps(panels, turns, shifts):
        if depths.max() > deepest:
            deepest, pair, pose = float(depths.max()), (one, other), int(np.argmax(depths))
    return deepest, pair, pose
