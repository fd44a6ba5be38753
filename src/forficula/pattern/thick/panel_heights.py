"""Heights of thick panels and of the axes of their creases, so that the panels fold flat onto one another."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations, pairwise

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.errors import InputError
from forficula.pattern.crease_pattern import CreasePattern
from forficula.pattern.facet_tree import facet_tree
from forficula.pattern.facts.vertex_creases import VertexCreases, vertex_creases
from forficula.pattern.shared_edges import shared_edges
from forficula.pattern.thick.convex import convex_overlap

_ROUNDING = 1e-9
# [chosen] most pairs of facets that are put in order one after another
_MOST_PAIRS = 400


def panel_heights(pattern: CreasePattern, folded: Array, *, shifted: bool) -> tuple[Array, Array] | None:
    """Compute the heights of panels and axes over the sheet without thickness, in the unfolded state.

    At a valley between panels with mid-planes at the heights m and n, the axis at the height h is above them, so that
    they lie on each other when folded: 2 h - m - n >= t; at a mountain m + n - 2 h >= t. Panels that lie on one another
    in the flat-folded state, without a common crease, are at least t apart there. Of all solutions, the result has the
    least sum of squares of the distances between panels and the axes at their sides. This is a least distance programme
    (Lawson and Hanson 1974, chapter 23).

    With shifted axes, the four axes at a vertex form a Bennett linkage, whose fold angles are those of the sheet
    without thickness (Chen, Peng and You 2015, doi 10.1126/science.aab2870): the heights of neighbouring axes differ by
    k sin(sector), and fall from the crease whose sense is unique, if it is a valley, to the opposite one.

    Args:
        pattern: flat or folded, with mountains, valleys and flat edges.
        folded: vertices of the flat-folded sheet without thickness, in a plane of constant z, m, (vertex, 3).
        shifted: whether axes may leave the plane of the sheet without thickness.

    Returns:
        Heights of the mid-planes of panels, (facet,), and of axes, (edge,), in thicknesses; None if no heights satisfy
        the conditions.
    """
    facets, edges = len(pattern.faces_vertices), len(pattern.edges_vertices)
    corners = [folded[list(face), :2] for face in pattern.faces_vertices]
    size = float(np.ptp(folded, axis=0).max())
    over = [
        (one, other)
        for one, other in combinations(range(facets), 2)
        if convex_overlap(corners[one], corners[other]) > 1e-6 * size
    ]
    # with shifted axes, panels that are level with each other when unfolded are tried first
    for level in (True, False) if shifted else (False,):
        heights = _ordered_heights(_HeightRows(pattern, shifted=shifted, level=level), over)
        if heights is not None:
            return heights[:facets], heights[facets : facets + edges]
    return None


def _ordered_heights(rows: _HeightRows, over: Sequence[tuple[int, int]]) -> Array | None:
    """Return the variables of rows, with pairs of panels that overlap when folded put in order one after another."""
    folds = list(rows.creases)
    for _ in range(min(len(over), _MOST_PAIRS) + 1):
        heights = _least_distances(rows, np.array(folds))
        if heights is None:
            return None
        levels = rows.levels @ heights
        # of the pairs that overlap, the one that overlaps most gets an order, that of the present heights
        gaps = [abs(float(levels[one] - levels[other])) for one, other in over]
        worst = int(np.argmin(gaps)) if gaps else -1
        if worst < 0 or gaps[worst] >= 1 - 1e-7:
            return heights
        one, other = over[worst]
        if levels[one] < levels[other]:
            one, other = other, one
        folds.append(rows.levels[one] - rows.levels[other])
    return None


class _HeightRows:
    """Linear conditions on the heights of panels and axes and on the factors of vertices, in thicknesses.

    Attributes:
        equal: rows that are 0, (row, variable).
        creases: rows that are at least 1.
        distances: rows whose squares are minimised.
        levels: heights of the mid-planes of panels in the flat-folded state, (facet, variable).
        positive: rows that are at least 0: the factors of vertices.
    """

    def __init__(self, pattern: CreasePattern, *, shifted: bool, level: bool) -> None:
        facets, edges = len(pattern.faces_vertices), len(pattern.edges_vertices)
        around = [vertex for vertex in vertex_creases(pattern) if len(vertex.edges)] if shifted else []
        variables = np.eye(facets + edges + len(around))
        panels, axes, factors = np.split(variables, [facets, facets + edges])
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
            self.creases.append(sense * (2 * axes[edge.edge] - panels[edge.left] - panels[edge.right]))
            self.distances += [axes[edge.edge] - panels[side] for side in (edge.left, edge.right)]
        if shifted:
            # the sheet without thickness lies in the first panel
            self.equal += list(panels if level else panels[:1])
        for vertex, factor in zip(around, factors, strict=True):
            self.equal += _bennett_rows(pattern, vertex, axes, factor)
        self.positive = list(factors)
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
                    moved = moved + 2 * sides[link.parent] * axes[link.edge]
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
