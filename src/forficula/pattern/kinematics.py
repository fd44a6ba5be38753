"""Rigid folding of a pattern: closed-form fold angles of a vertex and of the fan, and the folded shape.

A fold angle is 0 if the sheet is flat and +180 deg or -180 deg if it is folded onto itself. A valley, whose two panels
rise towards the viewer on +z, is positive.
"""

from __future__ import annotations

import math
from typing import Literal, get_args

import numpy as np
from numpy.typing import ArrayLike

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.pattern.crease_pattern import CreasePattern
from forficula.pattern.families.earwig import EarwigFan, earwig_pattern, ring_ratios, ring_sectors
from forficula.pattern.rotation import IDENTITY_MOTION, RigidMotion, turn_about
from forficula.pattern.shared_edges import shared_edges

Mode = Literal["earwig", "miura"]
_CLOSES = 1e-9  # largest gap of a vertex that is reached on two paths, as a share of the pattern's size


def degree4_fold_angles(alpha: float, beta: float, proximal_fold_angle: ArrayLike, mode: Mode = "earwig") -> Array:
    """Solve a flat-foldable vertex of four creases for its fold angles.

    Around the vertex lie the proximal, the next ring, the distal and the previous ring crease, with the sectors alpha,
    180 deg - beta, 180 deg - alpha and beta between them (Kawasaki 1989): alpha and beta are the two sectors at the
    proximal crease. With t the tangent of half a fold angle the relations are linear (Huffman 1976; Tachi 2009):

    - "earwig": distal = proximal, previous ring = - next ring,
      t_ring_next = sin((alpha - beta) / 2) / sin((alpha + beta) / 2) t_proximal
    - "miura": distal = - proximal, previous ring = next ring,
      t_ring_next = - cos((alpha - beta) / 2) / cos((alpha + beta) / 2) t_proximal

    With these signs, the product of Rx(fold angle) Rz(sector) around the vertex is the identity, in either direction.

    Args:
        alpha: sector between the proximal and the next ring crease, rad.
        beta: sector between the proximal and the previous ring crease, rad.
        proximal_fold_angle: from -pi to pi, rad, any shape.
        mode: one of the two modes of folding.

    Returns:
        Fold angles, rad, shape (4, ...): proximal, next ring, distal, previous ring. At -pi and pi the limits; in mode
        "earwig" with alpha = beta the ring creases stay flat.

    Raises:
        InputError: a sector outside 0 to 180 deg, a fold angle outside -180 to 180 deg, an unknown mode.
    """
    for key, sector in (("alpha", alpha), ("beta", beta)):
        if not 0 < sector < math.pi:
            raise InputError(f"{key}: need > 0 deg and < 180 deg, got {math.degrees(sector):.6g} deg")
    if mode not in get_args(Mode):
        raise InputError(f"mode: need earwig or miura, got {mode!r}")
    proximal = np.asarray(proximal_fold_angle, dtype=np.float64)
    inside = np.abs(proximal) <= math.pi
    if not inside.all():
        worst = float(proximal[~inside].flat[0])
        raise InputError(f"proximal_fold_angle: need -180 to 180 deg, got {math.degrees(worst):.6g} deg")
    if mode == "earwig":
        numerator, denominator = math.sin((alpha - beta) / 2), math.sin((alpha + beta) / 2)
    else:
        numerator, denominator = -math.cos((alpha - beta) / 2), math.cos((alpha + beta) / 2)
    if denominator < 0:  # so that arctan2 gets the cosine of the fold angle with its sign
        numerator, denominator = -numerator, -denominator
    # the float pi is slightly less than 180 deg, so the cosine would open a closed ring with a small ratio
    half_cosine = np.where(np.abs(proximal) == math.pi, 0.0, np.cos(proximal / 2))
    ring = 2 * np.arctan2(numerator * np.sin(proximal / 2), denominator * half_cosine)
    if mode == "earwig":
        return np.stack([proximal, ring, proximal, -ring])
    return np.stack([proximal, ring, -proximal, ring])


def fan_fold_angles(fan: EarwigFan, pleat_angle: float) -> Array:
    """Compute the fold angles of a fan in mode "earwig" at every ring vertex.

    All ring creases have the same fold angle, with the senses of `earwig_pattern`, and so have all veins of a fan
    without different veins: tan(ring / 2) = sin(epsilon) / cos(sector_angle / 2) tan(pleat / 2). With different veins,
    every vein has its own ratio, see `ring_ratios`.

    Args:
        fan: the fan.
        pleat_angle: magnitude of the fold angle of the middle vein, 0 (flat) to pi (folded flat), rad.

    Returns:
        Fold angles, rad, shape (E,), in the order of the edges of `earwig_pattern`, nan on borders. With hub radius 0
        the ring creases stay at 0, because they can fold only after the pleats are closed.

    Raises:
        InputError: a pleat angle outside 0 to 180 deg, or two ring folds, with which rigid panels do not fold.
    """
    if fan.ring_folds != 1:
        raise InputError("pattern.ring_folds: rigid panels fold about one ring fold only, got 2")
    if not 0 <= pleat_angle <= math.pi:
        raise InputError(f"pleat_angle: need 0 to 180 deg, got {math.degrees(pleat_angle):.6g} deg")
    before, after = ring_sectors(fan)
    ratios, middle = ring_ratios(fan), fan.units
    ring = abs(degree4_fold_angles(float(after[middle]), float(before[middle]), pleat_angle, "earwig")[1])
    half_cosine = 0.0 if pleat_angle == math.pi else math.cos(pleat_angle / 2)
    pleats = 2 * np.arctan2(ratios[middle] * math.sin(pleat_angle / 2), ratios * half_cosine)
    # exactly, also where the ratio is 0
    pleats = np.where(ratios == ratios[middle], pleat_angle, pleats)
    pattern = earwig_pattern(fan)
    roles = np.array(pattern.edges_role)
    sizes = np.full(len(roles), ring)
    for role in ("proximal", "distal"):
        sizes[roles == role] = pleats
    signed: Array = np.sign(pattern.edges_fold_angle) * sizes
    return signed


def folded_frames(fan: EarwigFan) -> list[tuple[str, Array, Array]]:
    """Fold a fan in four steps, from half closed pleats to flat-folded.

    Returns:
        For each step: title, positions of the vertices of `earwig_pattern` (m, shape (N, 3)), and fold angles (rad,
        shape (E,)).
    """
    pattern = earwig_pattern(fan)
    frames = []
    for degrees in (90, 135, 170, 180):
        angles = fan_fold_angles(fan, math.radians(degrees))
        frames.append((f"pleats at {degrees} deg", folded_coordinates(pattern, angles), angles))
    return frames


def folded_coordinates(pattern: CreasePattern, fold_angles: ArrayLike, fixed_face: int = 0) -> Array:
    """Fold a pattern rigidly and compute the positions of its vertices.

    Starting from the fixed face, every neighbour is turned about the shared edge by its fold angle; cuts do not connect
    faces. Edges that the walk does not use are also checked: faces that meet again must fit.

    Args:
        pattern: pattern with faces counterclockwise.
        fold_angles: rad, shape (E,), valley positive; nan only on edges of a single face, on cuts, and on flat edges.
        fixed_face: number of the face that does not move.

    Returns:
        Folded positions, m, shape (N, 3), in the order of the vertices.

    Raises:
        InputError: missing fold angles or another shape, faces that are not counterclockwise or not connected, or fold
            angles for which the sheet would tear by more than 1e-9 of its size.
    """
    coords, faces = pattern.vertices_coords, pattern.faces_vertices
    around = _neighbours(pattern, np.asarray(fold_angles, dtype=np.float64))
    if not 0 <= fixed_face < len(faces):
        raise InputError(f"fixed_face: need a face from 0 to {len(faces) - 1}, got {fixed_face}")
    placed, reached = {fixed_face: IDENTITY_MOTION}, [fixed_face]
    for face in reached:
        for _, neighbour, turn in around[face]:
            if neighbour not in placed:
                placed[neighbour] = placed[face].after(turn)
                reached.append(neighbour)
    if len(placed) < len(faces):
        missing = next(face for face in range(len(faces)) if face not in placed)
        raise InputError(
            f"faces_vertices[{missing}]: need a face that is connected to face {fixed_face}, got one that is not"
        )
    folded = np.full_like(coords, np.nan)
    for face in reached:
        folded[list(faces[face])] = placed[face].of(coords[list(faces[face])])
    if np.isnan(folded).any():
        missing = int(np.argmax(np.isnan(folded).any(axis=1)))
        raise InputError(f"vertices_coords[{missing}]: need a vertex of a face, got one without a face")
    size = float(np.linalg.norm(np.ptp(coords, axis=0)))
    for face, beyond in enumerate(around):
        for edge, neighbour, turn in beyond:
            corners = list(faces[neighbour])
            gap = float(np.abs(placed[face].after(turn).of(coords[corners]) - folded[corners]).max())
            if not gap <= _CLOSES * size:
                raise InputError(
                    f"fold_angles[{edge}]: need angles for which the sheet closes, to {_CLOSES:g} of its size"
                    f" {100 * size:.4g} cm, got a gap of {100 * gap:.4g} cm between faces {face} and {neighbour}"
                )
    return folded


def _neighbours(pattern: CreasePattern, fold_angles: Array) -> list[list[tuple[int, int, RigidMotion]]]:
    """Return, for each face, the edges to its neighbours, the neighbours, and their turns about these edges."""
    if fold_angles.shape != (len(pattern.edges_vertices),):
        raise InputError(f"fold_angles: need shape ({len(pattern.edges_vertices)},), got {fold_angles.shape}")
    around: list[list[tuple[int, int, RigidMotion]]] = [[] for _ in pattern.faces_vertices]
    for edge, tail, head, left, right in shared_edges(pattern):
        flat = pattern.edges_assignment[edge] == "F" and np.isnan(fold_angles[edge])
        fold = 0.0 if flat else float(fold_angles[edge])
        if not math.isfinite(fold):
            raise InputError(f"fold_angles[{edge}]: need a finite angle between two faces, got {fold:g}")
        for face, neighbour, ends in ((left, right, [tail, head]), (right, left, [head, tail])):
            start, end = pattern.vertices_coords[ends]
            # the neighbour is on the right of the side, so turning it up, towards +z, is a negative turn about the side
            turn = turn_about(start, (end - start) / np.linalg.norm(end - start), -fold)
            around[face].append((edge, neighbour, turn))
    return around
