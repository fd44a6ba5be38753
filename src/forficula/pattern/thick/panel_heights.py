"""Heights of thick panels and of the axes of their creases, so that the panels fold flat onto one another."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations, pairwise
from typing import NamedTuple

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.pattern.crease_pattern import CreasePattern
from forficula.pattern.facet_tree import facet_tree
from forficula.pattern.facts.rigid_folding import senses
from forficula.pattern.facts.vertex_creases import VertexCreases, vertex_creases
from forficula.pattern.shared_edges import shared_edges
from forficula.pattern.thick.convex import convex_overlap

_ROUNDING = 1e-9
# [chosen] part of a crease on which brackets lie, and largest part for the brackets of several creases on one line
BRACKETS, _BRACKETED = (0.35, 0.65), 0.8
# [chosen] part of a slot that its brackets leave free if the slots of other creases are beside it
_GAP = 0.1
# [chosen] most orders of panels that are tried
_MOST_TRIES = 600
# [chosen] share of the width of strips in the sum that is minimised, small beside that of brackets
_NARROW = 1e-3


def panel_heights(
    pattern: CreasePattern, folded: Array, *, shifted: bool, lines: Sequence[Sequence[int]] | None = None
) -> tuple[Array, Array, Array] | None:
    """Compute the heights of panels and axes over the sheet without thickness, in the unfolded state.

    At a valley between panels with mid-planes at the heights m and n, the axis at the height h is above them, so that
    they lie on each other when folded: 2 h - m - n >= t; at a mountain m + n - 2 h >= t. Panels that lie on one another
    in the flat-folded state, without a common crease, are at least t apart there. Of all solutions, the result has the
    least sum of squares of the distances between panels and the axes at their sides. This is a least distance programme
    (Lawson and Hanson 1974, chapter 23).

    With shifted axes, the four axes at a vertex form a Bennett linkage, whose fold angles are those of the sheet
    without thickness (Chen, Peng and You 2015, doi 10.1126/science.aab2870): the heights of neighbouring axes differ by
    k sin(sector), and fall from the crease whose sense is unique, if it is a valley, to the opposite one.

    With strips in split folds, a strip of the width w adds w to the gap of a fold: 2 h + w - m - n >= t at a valley.
    Panels are level. Of all solutions, the result has the least sum of distances of axes beyond the faces of panels
    and, among these, narrow strips (a linear programme).

    Args:
        pattern: flat or folded, with mountains, valleys and flat edges.
        folded: vertices of the flat-folded sheet without thickness, in a plane of constant z, m, (vertex, 3).
        shifted: whether axes may leave the plane of the sheet without thickness.
        lines: groups of creases that are split with one width; None without split folds.

    Returns:
        Heights of the mid-planes of panels, (facet,), heights of axes, (edge,), and widths of strips, (edge,), in
        thicknesses; None if no heights satisfy the conditions.
    """
    facets, edges = len(pattern.faces_vertices), len(pattern.edges_vertices)
    layers = _layers(pattern, folded)
    # with shifted axes, panels that are level with each other when unfolded are tried first
    for level in (True, False) if shifted and lines is None else (lines is not None,):
        rows = _HeightRows(pattern, shifted=shifted, level=level, lines=lines)
        heights = _ordered_heights(rows, layers)
        if heights is not None:
            return heights[:facets], heights[facets : facets + edges], rows.widths @ heights
    return None


class _Layers(NamedTuple):
    """Panels that lie on one another in the flat-folded state.

    Attributes:
        pairs: panels that overlap, the one with the smaller number first.
        beside: a panel, and two panels at a crease over or under the inside of the first one. The first panel therefore
            lies above both or below both.
        nested: two panels at a crease and two at another crease on the same line. None, or both, of the second two lie
            between the first two.
    """

    pairs: list[tuple[int, int]]
    beside: list[tuple[int, int, int]]
    nested: list[tuple[int, int, int, int]]


def _layers(pattern: CreasePattern, folded: Array) -> _Layers:
    """Return the panels that lie on one another."""
    corners = [folded[list(face), :2] for face in pattern.faces_vertices]
    least = 1e-6 * float(np.ptp(folded, axis=0).max())
    creases = [edge for edge in shared_edges(pattern) if pattern.edges_assignment[edge.edge] in "MV"]
    lines = [folded[[edge.tail, edge.head], :2] for edge in creases]
    pairs = [
        (one, other)
        for one, other in combinations(range(len(corners)), 2)
        if convex_overlap(corners[one], corners[other]) > least
    ]
    beside = [
        (facet, edge.left, edge.right)
        for edge, line in zip(creases, lines, strict=True)
        for facet, polygon in enumerate(corners)
        if facet not in (edge.left, edge.right) and convex_overlap(line, polygon) > least
    ]
    nested = [
        (creases[one].left, creases[one].right, creases[other].left, creases[other].right)
        for one, other in combinations(range(len(creases)), 2)
        if _on_one_line(lines[one], lines[other], least)
        and (min(creases[one].left, creases[other].left), max(creases[one].left, creases[other].left)) in pairs
    ]
    return _Layers(pairs, beside, nested)


def bracket_slots(pattern: CreasePattern, folded: Array) -> list[tuple[float, float]]:
    """Return the parts of creases on which brackets lie, so that brackets of creases on one line do not meet.

    Creases that lie on one line in the flat-folded state get different parts, as shares of their length. Gaps between
    these parts leave room for brackets that slide past each other while the sheet closes.

    Args:
        pattern: flat or folded, with mountains, valleys and flat edges.
        folded: vertices of the flat-folded sheet without thickness, in a plane of constant z, m, (vertex, 3).

    Returns:
        Start and end of the part of every edge, from its first to its second vertex.
    """
    least = 1e-6 * float(np.ptp(folded, axis=0).max())
    creases = [edge.edge for edge in shared_edges(pattern) if pattern.edges_assignment[edge.edge] in "MV"]
    lines = {edge: folded[pattern.edges_vertices[edge], :2] for edge in creases}
    places: dict[int, int] = {}
    groups: list[list[int]] = []
    for edge in creases:
        group = next(
            (group for group in groups if any(_on_one_line(lines[edge], lines[other], least) for other in group)), None
        )
        if group is None:
            groups.append(group := [])
        places[edge] = len(group)
        group.append(edge)
    slots = [BRACKETS] * len(pattern.edges_vertices)
    for group in groups:
        width = min(BRACKETS[1] - BRACKETS[0], _BRACKETED / len(group))
        start = (1 - width * len(group)) / 2
        gap = 0.0 if len(group) == 1 else _GAP * width / 2
        along = lines[group[0]][1] - lines[group[0]][0]
        for edge in group:
            slot = (start + width * places[edge] + gap, start + width * (places[edge] + 1) - gap)
            opposite = float((lines[edge][1] - lines[edge][0]) @ along) < 0
            slots[edge] = (1 - slot[1], 1 - slot[0]) if opposite else slot
    return slots


def _on_one_line(one: Array, other: Array, least: float) -> bool:
    """Return whether two segments, (2, 2), have a part of a length in common."""
    along = (one[1] - one[0]) / np.linalg.norm(one[1] - one[0])
    shares = (other - one[0]) @ along
    apart = np.abs((other - one[0]) @ np.array([-along[1], along[0]])).max()
    common = min(shares.max(), float(np.linalg.norm(one[1] - one[0]))) - max(shares.min(), 0.0)
    return bool(apart <= least and common > least)


def _ordered_heights(rows: _HeightRows, layers: _Layers) -> Array | None:
    """Return the best variables with which panels are in an order, and none of them passes through a fold.

    Pairs get an order one after another: that of the present heights first, then the opposite one.
    """
    waiting: list[dict[tuple[int, int], int]] = [{}]
    for _ in range(_MOST_TRIES):
        if not waiting:
            break
        orders = waiting.pop()
        signed = (sign * (rows.levels[one] - rows.levels[other]) for (one, other), sign in orders.items())
        heights = rows.solved(rows, np.array([*rows.creases, *signed]))
        if heights is None:
            continue
        levels = rows.levels @ heights
        gaps = {(one, other): float(levels[one] - levels[other]) for one, other in layers.pairs}
        # of the pairs without an order, the one that overlaps most gets one, that of the present heights first
        free = [pair for pair in layers.pairs if pair not in orders]
        next_pair = min(free, key=lambda pair: abs(gaps[pair]), default=None)
        if next_pair is None or abs(gaps[next_pair]) >= 1 - 1e-7:
            crossing = _crossing(layers, levels)
            if not crossing:
                return heights
            next_pair = next((pair for pair in crossing if pair in free), None)
        if next_pair is not None:
            first = -1 if gaps[next_pair] < 0 else 1
            waiting += [orders | {next_pair: -first}, orders | {next_pair: first}]
    return None


def _crossing(layers: _Layers, levels: Array) -> list[tuple[int, int]]:
    """Return pairs of panels that may need another order because a panel passes through a fold; empty if none does."""
    for facet, one, other in layers.beside:
        if (levels[facet] > levels[one]) != (levels[facet] > levels[other]):
            return [(min(facet, side), max(facet, side)) for side in (one, other)]
    for one, other, *sides in layers.nested:
        low, high = sorted((levels[one], levels[other]))
        inside = [low < levels[side] < high for side in sides if side not in (one, other)]
        if any(inside) and not all(inside):
            return [(min(first, side), max(first, side)) for first in (one, other) for side in sides if first != side]
    return []


class _HeightRows:
    """Linear conditions on the heights of panels and axes and on the factors of vertices, in thicknesses.

    Attributes:
        equal: rows that are 0, (row, variable).
        creases: rows that are at least 1.
        distances: rows whose squares are minimised.
        levels: heights of the mid-planes of panels in the flat-folded state, (facet, variable).
        positive: rows that are at least 0: the factors of vertices and the widths of strips.
        axes: heights of the axes of creases, (crease, variable).
        widths: widths of strips, (edge, variable).
        solved: function that returns the best variables.
    """

    def __init__(
        self, pattern: CreasePattern, *, shifted: bool, level: bool, lines: Sequence[Sequence[int]] | None
    ) -> None:
        facets, edges = len(pattern.faces_vertices), len(pattern.edges_vertices)
        around = [vertex for vertex in vertex_creases(pattern) if len(vertex.edges)] if shifted else []
        split = () if lines is None else lines
        variables = np.eye(facets + edges + len(around) + len(split))
        panels, axes, factors, strips = np.split(variables, np.cumsum([facets, edges, len(around)]))
        self.widths = np.zeros((edges, len(variables)))
        for line, strip in zip(split, strips, strict=True):
            self.widths[list(line)] = strip
        self.solved = _least_distances if lines is None else _least_brackets
        shared = [edge for edge in shared_edges(pattern) if pattern.edges_assignment[edge.edge] in "MVF"]
        inner = {edge.edge for edge in shared if pattern.edges_assignment[edge.edge] != "F"}
        self.equal = [axes[edge] for edge in range(edges) if edge not in inner or not shifted]
        self.creases: list[Array] = []
        self.distances: list[Array] = []
        for edge in shared:
            if edge.edge not in inner:
                self.equal.append(panels[edge.left] - panels[edge.right])
                continue
            sense = 1 if pattern.edges_assignment[edge.edge] == "V" else -1
            gap = sense * (2 * axes[edge.edge] - panels[edge.left] - panels[edge.right])
            self.creases.append(gap + self.widths[edge.edge])
            self.distances += [axes[edge.edge] - panels[side] for side in (edge.left, edge.right)]
        if shifted:
            # the sheet without thickness lies in the first panel
            self.equal += list(panels if level else panels[:1])
        for vertex, factor in zip(around, factors, strict=True):
            self.equal += _bennett_rows(pattern, vertex, axes, factor)
        self.positive = [*factors, *strips]
        self.axes = axes[sorted(inner)]
        signs = senses(pattern)
        self.levels = np.zeros((facets, len(variables)))
        sides = np.ones(facets)
        for link in facet_tree(pattern):
            if link.closes:
                continue
            if link.parent is not None and link.edge is not None:
                turned = link.edge in inner
                sides[link.facet] = -sides[link.parent] if turned else sides[link.parent]
                moved = self.levels[link.parent] - sides[link.parent] * panels[link.parent]
                if turned:
                    moved = moved + sides[link.parent] * (
                        2 * axes[link.edge] + signs[link.edge] * self.widths[link.edge]
                    )
                self.levels[link.facet] = moved
            self.levels[link.facet] = self.levels[link.facet] + sides[link.facet] * panels[link.facet]


def _bennett_rows(pattern: CreasePattern, vertex: VertexCreases, axes: Array, factor: Array) -> list[Array]:
    """Return the differences of the heights of neighbouring axes minus those of a Bennett linkage."""
    ordered, sectors, sense = unique_first(pattern, vertex)
    falls = (sense, sense, -sense)
    return [
        axes[edge] - axes[following] - fall * np.sin(sector) * factor
        for (edge, following), sector, fall in zip(pairwise(ordered), sectors, falls, strict=False)
    ]


def unique_first(pattern: CreasePattern, vertex: VertexCreases) -> tuple[list[int], list[float], int]:
    """Return creases and sectors of a vertex from the crease whose sense is unique on, and its sense, 1 for a valley.

    Raises:
        InputError: the vertex does not have four creases, one with another sense than the others.
    """
    letters = [pattern.edges_assignment[edge] for edge in vertex.edges.tolist()]
    single = [number for number, letter in enumerate(letters) if letters.count(letter) == 1]
    if len(letters) != 4 or len(single) != 1:
        raise InputError(
            f"vertex {vertex.vertex}: need four creases, one of another sense than the others, got {''.join(letters)}"
        )
    first = single[0]
    return (
        np.roll(vertex.edges, -first).tolist(),
        np.roll(vertex.sectors, -first).tolist(),
        1 if letters[first] == "V" else -1,
    )


def _least_distances(rows: _HeightRows, folds: Array) -> Array | None:
    """Return the variables with the least sum of squares of distances; None if no variables satisfy the conditions."""
    equal, distances = np.array(rows.equal), np.array(rows.distances)
    free = scipy.linalg.null_space(equal)
    conditions = np.concatenate([folds, *([np.array(rows.positive)] if rows.positive else [])]) @ free
    least = np.concatenate([np.ones(len(folds)), np.zeros(len(rows.positive))])
    _, sizes, turn = np.linalg.svd(distances @ free, full_matrices=False)
    if not len(sizes) or sizes[-1] <= _ROUNDING * sizes[0]:
        return None
    # with y as unknowns, free variables are turn^T (y / sizes), and the sum of squares is that of y
    scaled = conditions @ turn.T / sizes
    system = np.vstack([scaled.T, least])
    target = np.append(np.zeros(len(sizes)), 1.0)
    multipliers, residual = scipy.optimize.nnls(system, target, maxiter=50 * system.shape[1])
    if residual <= 1e-7:
        return None
    # exact on the active conditions
    active = multipliers > 0
    y = np.linalg.lstsq(scaled[active], least[active], rcond=None)[0] if active.any() else np.zeros(len(sizes))
    if (scaled @ y - least).min(initial=0.0) < -1e-7:
        return None
    return np.asarray(free @ (turn.T @ (y / sizes)))


def _least_brackets(rows: _HeightRows, folds: Array) -> Array | None:
    """Return the variables with the least distances of axes beyond faces, then with narrow strips; None without any."""
    count, axes = len(rows.levels[0]), rows.axes
    beyond = np.eye(len(axes))
    none = np.zeros((len(folds), len(axes)))
    result = scipy.optimize.linprog(
        np.concatenate([_NARROW * rows.widths.sum(axis=0), np.ones(len(axes))]),
        A_ub=np.block([[-folds, none], [axes, -beyond], [-axes, -beyond]]),
        b_ub=np.concatenate([-np.ones(len(folds)), np.full(2 * len(axes), 0.5)]),
        A_eq=np.column_stack([np.array(rows.equal), np.zeros((len(rows.equal), len(axes)))]),
        b_eq=np.zeros(len(rows.equal)),
        bounds=[
            *((0.0, None) if any(row[number] for row in rows.positive) else (None, None) for number in range(count)),
            *[(0.0, None)] * len(axes),
        ],
    )
    return np.asarray(result.x[:count]) if result.status == 0 else None
