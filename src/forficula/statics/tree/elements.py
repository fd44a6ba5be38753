"""Elastic elements between bodies: their sides from points, and assembly of gradients and Hessians from sides.

A membrane's triangle has two sides, the columns of its deformation gradient. A tendon or a length limit has one side,
the vector from one end to the other. Elements that join the same hinges share a dense block of the Hessian.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array, Indices
from forficula.statics.tree.pose import (
    Carried,
    Pose,
    Span,
    Tree,
    carried_points,
    moves_of,
    places_of,
    pose,
    pulled,
    span,
)

# energy, gradient and Hessian
Expansion = tuple[Array, Array, Array]


@dataclass(frozen=True, kw_only=True)
class LinePiece:
    """An elastic element before it is laid out.

    Attributes:
        points: numbers of the carried points that it is attached to, (point,).
        sides: weights with which these points add up to its sides, (side, point).
    """

    points: tuple[int, ...]
    sides: Array


@dataclass(frozen=True, kw_only=True)
class ElementGroup:
    """Pieces of the same shape side by side.

    Attributes:
        pieces: their numbers.
        points: numbers of the points of each piece, one piece after another; a slice if no point is shared.
        gathers: weights with which forces on the points of pieces add up to forces on points,
            (piece x point, point); None if no point is shared.
        sides: weights with which points add up to sides, (piece, side, point).
        pairs: numbers of the pairs of points and hinges that move the sides, one piece after another.
        turns: weights with which the moves of these pairs add up to moves of the sides by the hinges of the block,
            (piece, pair, side x hinge).
        size: number of hinges of a block.
        blocks: number of the block of each piece among those of this size.
    """

    pieces: Span
    points: Span
    gathers: Array | None
    sides: Array
    pairs: Span
    turns: Array
    size: int
    blocks: Span


@dataclass(frozen=True, kw_only=True)
class Elements:
    """Elastic elements between the bodies of a tree.

    Attributes:
        tree: of bodies.
        carried: the points that elements are attached to.
        groups: of pieces.
        blocks: by number of hinges: the position of each block in the Hessian, as rows and columns, or as indices of
            its entries in a Hessian stored row by row.
    """

    tree: Tree
    carried: Carried
    groups: tuple[ElementGroup, ...]
    blocks: dict[int, tuple[tuple[Span, Span] | Indices, ...]]


def elements(tree: Tree, bodies: Sequence[int], places: Array, pieces: Sequence[LinePiece]) -> Elements:
    """Lay out pieces on points.

    Args:
        tree: of bodies.
        bodies: that carry the points, (point,).
        places: positions of the points in the axes of these bodies, m, (point, 3).
        pieces: elements attached to the points.
    """
    carried = carried_points(tree, bodies, places)
    joined = [_joined(tree, [bodies[point] for point in piece.points]) for piece in pieces]
    known: dict[int, dict[tuple[int, ...], int]] = {}
    shapes: dict[tuple[int, ...], list[int]] = {}
    seen: dict[tuple[tuple[int, ...], tuple[int, ...]], int] = {}
    for number, (piece, hinges) in enumerate(zip(pieces, joined, strict=True)):
        of_size = known.setdefault(len(hinges), {})
        of_size.setdefault(hinges, len(of_size))
        shape = (*piece.sides.shape, len(hinges), len(_pairs(carried, piece.points, hinges)))
        # no two pieces of a group share a block
        again = seen[shape, hinges] = seen.get((shape, hinges), -1) + 1
        shapes.setdefault((*shape, again), []).append(number)
    blocks = {size: tuple(_rows(hinges, tree.size) for hinges in of_size) for size, of_size in known.items()}
    groups = tuple(_group(carried, pieces, joined, numbers, known) for numbers in shapes.values())
    return Elements(tree=tree, carried=carried, groups=groups, blocks=blocks)


def _joined(tree: Tree, bodies: Sequence[int]) -> tuple[int, ...]:
    """Return the hinges that move some of these bodies; sides turn with the hinges that move all of them."""
    return tuple(sorted({hinge for body in bodies for hinge in tree.chain(body)}))


def _rows(hinges: tuple[int, ...], count: int) -> tuple[Span, Span] | Indices:
    rows = span(hinges)
    if isinstance(rows, slice):
        return rows, rows
    return np.asarray(rows[:, None] * count + rows).ravel()


def _group(
    carried: Carried,
    pieces: Sequence[LinePiece],
    joined: Sequence[tuple[int, ...]],
    numbers: list[int],
    known: dict[int, dict[tuple[int, ...], int]],
) -> ElementGroup:
    points = np.array([pieces[number].points for number in numbers])
    sides = np.array([pieces[number].sides for number in numbers])
    size = len(joined[numbers[0]])
    pairs = [_pairs(carried, pieces[number].points, joined[number]) for number in numbers]
    turns = np.zeros((*pairs[0].shape, sides.shape[1], size))[None].repeat(len(numbers), axis=0)
    for turn, selected, side, number in zip(turns, pairs, sides, numbers, strict=True):
        columns = [pieces[number].points.index(point) for point in carried.pairs[0, selected]]
        hinges = [joined[number].index(hinge) for hinge in carried.pairs[1, selected]]
        turn[np.arange(len(selected)), :, hinges] = side[:, columns].T
    flat = points.ravel()
    every = span(flat)
    whole = isinstance(every, slice) and every.step == 1
    return ElementGroup(
        pieces=span(numbers),
        points=every,
        gathers=None if whole else np.asarray(flat[:, None] == np.arange(len(carried.bodies)), dtype=np.float64),
        sides=sides,
        pairs=span(np.concatenate(pairs)),
        turns=turns.reshape(len(numbers), len(pairs[0]), sides.shape[1] * size),
        size=size,
        blocks=span([known[size][joined[number]] for number in numbers]),
    )


def _pairs(carried: Carried, points: Sequence[int], hinges: Sequence[int]) -> Indices:
    """Return the numbers of the pairs of some points with some hinges."""
    return np.flatnonzero(np.isin(carried.pairs[0], points) & np.isin(carried.pairs[1], hinges))


def _sides(group: ElementGroup, places: Array) -> Array:
    """Compute the sides of a group in some poses, m or dimensionless, (case, piece, side, 3).

    Args:
        group: of pieces.
        places: positions of all points, m, (3, case, point).
    """
    cases = places.shape[1]
    count, length, _ = group.sides.shape
    sides = _by_piece(places[:, :, group.points], count) @ group.sides.swapaxes(1, 2)
    return np.asarray(sides.reshape(count, 3, cases, length).transpose(2, 0, 3, 1))


def _moves_of_sides(group: ElementGroup, moves: Array) -> Array:
    """Compute the derivatives of the sides of a group by the angles of the hinges of their block.

    Args:
        group: of pieces.
        moves: of all pairs of points and hinges, m, (3, case, pair).

    Returns:
        Derivatives of the sides, (case, piece, side, 3, hinge).
    """
    cases = moves.shape[1]
    count, length, _ = group.sides.shape
    turned = _by_piece(moves[:, :, group.pairs], count) @ group.turns
    by_case = turned.reshape(count, 3, cases, length, group.size).transpose(2, 0, 3, 1, 4)
    return np.ascontiguousarray(by_case)


def _by_piece(vectors: Array, count: int) -> Array:
    """Return vectors of all pieces, (3, case, piece x part), as (piece, 3 x case, part)."""
    cases, parts = vectors.shape[1], vectors.shape[2] // count
    by_piece = vectors.reshape(3, cases, count, parts).transpose(2, 0, 1, 3)
    return by_piece.reshape(count, 3 * cases, parts)


def _block(moves: Array, stiffness: Array) -> Array:
    """Compute the stiffness of pieces by the hinges of their blocks, (case, piece, hinge, hinge).

    Args:
        moves: of the sides, (case, piece, side, 3, hinge).
        stiffness: (case, piece, element, coordinate, coordinate).
    """
    joints = moves.shape[-1]
    by_element = moves.reshape(*stiffness.shape[:4], joints)
    by_piece = (*stiffness.shape[:2], stiffness.shape[2] * stiffness.shape[3], joints)
    pulls = (stiffness @ by_element).reshape(by_piece)
    return np.asarray(by_element.reshape(by_piece).swapaxes(2, 3) @ pulls)


def stretched(
    laid: Elements, angles: Array, laws: Sequence[Callable[[Array], Expansion | None]], at: Pose | None = None
) -> Expansion:
    """Compute the energy of all groups, with gradient and Hessian by the hinges' angles.

    Args:
        laid: the elements.
        angles: of all hinges, in their own senses, rad, (case, hinge).
        laws: of every group: functions of its sides, m or dimensionless, (case, piece, side, 3), that return energy, J,
            (case,), gradient by the sides, (case, piece, side, 3), and Hessian by the sides of each element,
            (case, piece, element, coordinate, coordinate); or None if all elements are slack in all cases.
        at: pose of the tree at these angles; computed by default.

    Returns:
        Energy, J, (case,); gradient, N m, (case, hinge); Hessian, N m/rad, (case, hinge, hinge).
    """
    cases, size = len(angles), laid.tree.size
    if not laid.groups:
        return _nothing(cases, size)
    at = pose(laid.tree, angles) if at is None else at
    places = places_of(laid.carried, at)
    expansions = [law(_sides(group, places)) for group, law in zip(laid.groups, laws, strict=True)]
    if all(expansion is None for expansion in expansions):
        return _nothing(cases, size)
    moves = moves_of(laid.carried, at, places)
    blocks = {size: np.zeros((cases, len(entries), size, size)) for size, entries in laid.blocks.items()}
    forces, total = np.zeros(places.shape), np.zeros(cases)
    for group, expansion in zip(laid.groups, expansions, strict=True):
        if expansion is None:
            continue
        energy, pull, stiffness = expansion
        total += energy
        blocks[group.size][:, group.blocks] += _block(_moves_of_sides(group, moves), stiffness)
        count, length, points = group.sides.shape
        by_piece = pull.transpose(1, 3, 0, 2).reshape(count, -1, length) @ group.sides
        on_points = by_piece.reshape(count, 3, cases, points).transpose(1, 2, 0, 3).reshape(3, cases, -1)
        if group.gathers is None:
            forces[:, :, group.points] += on_points
        else:
            forces += on_points @ group.gathers
    slope, curvature = pulled(laid.tree, laid.carried, at, places, forces)
    by_number = curvature.reshape(cases, -1)  # a view, because the array is stored row by row
    for size, rows in laid.blocks.items():
        for number, where in enumerate(rows):
            if isinstance(where, tuple):
                curvature[:, where[0], where[1]] += blocks[size][:, number]
            else:
                by_number[:, where] += blocks[size][:, number].reshape(cases, size * size)
    return total, slope, curvature


def _nothing(cases: int, size: int) -> Expansion:
    """Return an energy of 0 of some cases, with gradient and Hessian."""
    return np.zeros(cases), np.zeros((cases, size)), np.zeros((cases, size, size))
