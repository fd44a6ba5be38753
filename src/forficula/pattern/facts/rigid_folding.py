"""Check whether a flat sheet of rigid facets can fold as its creases are assigned, and search for a folded state."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
import scipy
from scipy.sparse import coo_array, csr_array, eye_array
from scipy.sparse.linalg import splu

from forficula.arrays import Array, Indices
from forficula.errors import InputError
from forficula.pattern.crease_pattern import CreasePattern, is_unfolded
from forficula.pattern.facts.vertex_closure import vertex_walk
from forficula.pattern.facts.vertex_creases import VertexCreases, vertex_creases
from forficula.pattern.kinematics import folded_coordinates
from forficula.pattern.shared_edges import shared_edges

_IN_LINE = 1e-6  # rad; error of a straight angle in files with seven digits
_START = math.radians(60)  # start of the fold angles; the first start is the same for all creases
_TRIES, _SPREAD = 6, (0.3, 1.5)  # number of starts, and range of the factors on the start after the first
_STEPS = 30
_CLOSED = 1e-13  # largest entry of the walks around the vertices
_LEAST_FOLD = math.radians(1)  # least fold of every mountain and valley in a state that counts as folded


def senses(pattern: CreasePattern) -> Indices:
    """Return the assigned sense of every edge: 1 for a valley, -1 for a mountain, 0 for others, shape (E,)."""
    return np.array([{"V": 1, "M": -1}.get(letter, 0) for letter in pattern.edges_assignment], dtype=np.int64)


def vertex_folds(pattern: CreasePattern, around: VertexCreases) -> bool | None:
    """Return whether a flat vertex by itself can start to fold rigidly with every crease in its sense.

    The result is exact, not first order. The vertex folds if the creases of one sense do not all lie in one half plane
    and at least one crease has the other sense; a single straight crease folds, too (Abel, Cantarella, Demaine,
    Eppstein, Hull, Ku, Lang and Tachi 2016, J. Comput. Geom. 7, 171-184: bird's foot).

    Returns:
        None where creases are unassigned and their senses decide.
    """
    letters = np.array([pattern.edges_assignment[edge] for edge in around.edges])
    if len(letters) == 0:
        return True
    directions = np.concatenate([[0.0], np.cumsum(around.sectors[:-1])])
    if len(letters) < 4:
        straight = len(letters) == 2 and abs(around.sectors[0] - math.pi) < _IN_LINE
        return None if straight and "U" in letters else bool(straight and letters[0] == letters[1])
    if "U" in letters:
        return None if _span(directions) else False
    return any(
        _span(directions[letters == one]) and bool((letters == other).any()) for one, other in (("M", "V"), ("V", "M"))
    )


def _span(directions: Array) -> bool:
    """Return whether no half plane contains all directions; directions are in rad and ascending."""
    if len(directions) < 3:
        return False
    gaps = np.diff([*directions, directions[0] + 2 * math.pi])
    return bool(gaps.max() < math.pi - _IN_LINE)


def begins_as_assigned(pattern: CreasePattern) -> bool:
    """Return whether a flat sheet has a first-order motion in which every mountain and valley folds in its sense.

    Around every interior vertex the fold rates, as vectors along the creases, add up to 0 (Belcastro and Hull 2002);
    flat edges do not fold, unassigned ones are free. The condition is necessary for rigid folding but not sufficient,
    because the second order may prevent it. A linear programme computes the rates.

    Raises:
        InputError: the sheet is not flat and unfolded.
    """
    _check_unfolded(pattern)
    signs = senses(pattern)
    rows: list[tuple[Array, Indices]] = []
    for crease in vertex_creases(pattern):
        along = np.concatenate([[0.0], np.cumsum(crease.sectors[:-1])]) if len(crease.edges) else np.zeros(0)
        rows += [(np.cos(along), crease.edges), (np.sin(along), crease.edges)]
    lower = np.where(signs > 0, 1.0, -np.inf)
    upper = np.where(signs < 0, -1.0, np.inf)
    equations = _sparse(rows, len(signs))
    result = scipy.optimize.linprog(
        np.zeros(len(signs)), A_eq=equations, b_eq=np.zeros(len(rows)), bounds=np.stack([lower, upper], 1)
    )
    return bool(result.status == 0)


def folded_as_assigned(pattern: CreasePattern) -> Array | None:
    """Search for a state of a flat sheet of rigid facets in which every mountain and valley is folded in its sense.

    The search starts with one fold angle for all creases and changes the angles by damped least squares until the
    panels around every interior vertex meet (Tachi 2009). Further starts draw the fold angles from a fixed random
    seed. If the search finds no state, one may still exist.

    Returns:
        Fold angles, rad, shape (E,), 0 on flat edges and borders, at least 1 deg in size on mountains and valleys; None
        where no state was found or no crease is a mountain or valley.

    Raises:
        InputError: the sheet is not flat and unfolded.
    """
    _check_unfolded(pattern)
    moving = np.zeros(len(pattern.edges_vertices), dtype=bool)
    moving[[edge.edge for edge in shared_edges(pattern) if pattern.edges_assignment[edge.edge] != "F"]] = True
    signs = np.where(moving, senses(pattern), 0)
    if not signs.any():
        return None
    around = [crease for crease in vertex_creases(pattern) if len(crease.edges)]
    draw = np.random.default_rng(0)
    for attempt in range(_TRIES if around else 1):
        share = draw.uniform(*_SPREAD, len(signs)) if attempt else np.ones(len(signs))
        angles = _closed(around, _START * share * signs)
        if angles is None or (angles * signs)[signs != 0].min() < _LEAST_FOLD or np.abs(angles).max() >= math.pi:
            continue
        try:
            folded_coordinates(pattern, angles)
        except InputError:  # closed around vertices, torn around a hole
            continue
        return angles
    return None


def _check_unfolded(pattern: CreasePattern) -> None:
    """Raise InputError for a sheet that is not flat and unfolded."""
    if not is_unfolded(pattern):
        raise InputError("vertices_coords: need a sheet that lies flat and unfolded, got one that does not")


def _closed(around: Sequence[VertexCreases], angles: Array) -> Array | None:
    """Change fold angles until all vertices close; return None if they do not."""
    angles = angles.astype(np.float64)
    for _ in range(_STEPS if around else 1):
        gaps, slope = _gaps(around, angles)
        size = float(gaps @ gaps)
        if np.abs(gaps).max(initial=0.0) < _CLOSED:
            return angles
        normal = slope.T @ slope + max(min(size, 1.0), 1e-14) * eye_array(len(angles))
        step = splu(normal.tocsc(), permc_spec="MMD_AT_PLUS_A").solve(slope.T @ gaps)
        angles = angles - step * min(1.0, 0.5 / float(np.abs(step).max()))
    return None


def _gaps(around: Sequence[VertexCreases], angles: Array) -> tuple[Array, csr_array]:
    """Compute the closure errors of the vertices, three numbers per vertex, and their derivatives by fold angle."""
    gaps: list[Array] = []
    rows: list[tuple[Array, Indices]] = []
    for degree in sorted({len(item.edges) for item in around}):
        alike = [item for item in around if len(item.edges) == degree]
        edges = np.array([item.edges for item in alike])
        product, creases = vertex_walk(np.array([item.sectors for item in alike]), angles[edges])
        skew = product - np.swapaxes(product, 1, 2)
        gaps.append(np.stack([skew[:, 2, 1], skew[:, 0, 2], skew[:, 1, 0]], axis=1).ravel() / 2)
        rows += [(creases[place, :, axis], edges[place]) for place in range(len(alike)) for axis in range(3)]
    return np.concatenate(gaps) if gaps else np.zeros(0), _sparse(rows, len(angles))


def _sparse(rows: Sequence[tuple[Array, Indices]], columns: int) -> csr_array:
    """Assemble a matrix from the values and column numbers of its rows."""
    numbers = np.repeat(np.arange(len(rows)), [len(values) for values, _ in rows]) if rows else np.zeros(0, dtype=int)
    values = np.concatenate([values for values, _ in rows]) if rows else np.zeros(0)
    across = np.concatenate([places for _, places in rows]) if rows else np.zeros(0, dtype=int)
    return coo_array((values, (numbers, across)), shape=(len(rows), columns)).tocsr()
