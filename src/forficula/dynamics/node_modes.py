"""The fastest mode of nodes that slide, in closed form and sparse."""

from __future__ import annotations

import math
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array, diags_array
from scipy.sparse.linalg import eigsh

from forficula.dynamics.folds import flap_turns
from forficula.structure import Membrane, Structure, built_points, crease_flaps, crease_law, crease_numbers

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

# coordinates from which a shortened iteration is faster than all eigenvalues
_FEW = 60
# of the largest eigenvalue; a thousandth of the step
_CLOSE = 1e-3
# of the longest step that creases allow, by that which all allow
_FOLLOWED = 0.2
# all divide the steps between two looks at goals
_BLOCKS = (1, 2, 5, 10, 20, 50, 100)


class _Elements(NamedTuple):
    """Energies k (g x)^2 / 2 and dampers: points, (element, point), g, (element, point, 3), k and c, (element,)."""

    points: Indices
    gradients: Array
    stiffness: Array
    damping: Array


def followed_steps(structure: Structure) -> int:
    """Steps over which the engine's rows of creases stay as they are: the more, the stiffer bars are beside creases.

    While a row stays, strains of its flaps change its moment by about their share, and what it does to them by as much:
    when it is set anew, that energy is lost. So many steps of free bars lost 1e-2 of the energy in ten swings, as their
    timestep does; with fewer or shorter ones it falls.
    """
    creases = node_timestep(replace(structure, springs=(), tendons=(), membranes=()))
    allowed = _FOLLOWED * creases / node_timestep(structure)
    return max(steps for steps in _BLOCKS if steps <= max(allowed, 1))


def node_timestep(structure: Structure) -> float:
    """The longest timestep at which no mode of nodes as built flips and grows, in the structure's units.

    One step of semi-implicit Euler on a mode of angular frequency w, with a damper that takes c from its speed: the
    condition of Jury is h^2 w^2 + 2 h c < 4, for c = 0 the textbook limit 2 / w. The fastest mode and the strongest
    damping count, of any modes. Tendons count with the stiffest spring of their law.
    """
    groups = [_lines(structure), _creases(structure), *(_strains(structure, each) for each in structure.membranes)]
    free = np.array([[axis in body.slides for axis in range(3)] for body in structure.bodies]).ravel()
    masses = np.repeat([body.mass for body in structure.bodies], 3)[free]
    if not free.any():
        return math.inf
    carriers = np.array([point.body for point in structure.points], dtype=np.int64)
    square = rate = 0.0
    matrices = []
    for points, gradients, stiffness, damping in groups:
        if not len(points):
            continue
        columns = (3 * carriers[points][:, :, None] + np.arange(3)).reshape(len(points), -1)
        rows = np.broadcast_to(np.arange(len(points))[:, None], columns.shape)
        shape = (len(points), 3 * len(structure.bodies))
        gradient = csr_array((gradients.ravel(), (rows.ravel(), columns.ravel())), shape=shape)
        matrices.append((csr_array(gradient[:, free] @ diags_array(1 / np.sqrt(masses))), stiffness, damping))
    square, rate = (
        _largest(
            sum((csr_array(each[0].T @ diags_array(each[kind]) @ each[0]) for each in matrices), start=_none(masses))
        )
        for kind in (1, 2)
    )
    if not square:
        return 2 / rate if rate else math.inf
    return 4 / (rate + math.sqrt(rate**2 + 4 * square))


def _none(masses: Array) -> csr_array:
    return csr_array((len(masses), len(masses)))


def _largest(matrix: csr_array) -> float:
    """The largest eigenvalue of a symmetric matrix without negative ones."""
    if matrix.shape[0] <= _FEW or not matrix.nnz:
        return float(np.linalg.eigvalsh(matrix.toarray()).max()) if matrix.nnz else 0.0
    start = np.random.default_rng(0).normal(size=matrix.shape[0])
    found = eigsh(matrix, k=1, which="LM", return_eigenvectors=False, v0=start, tol=_CLOSE)
    return float(found[0]) * (1 + _CLOSE)


def _lines(structure: Structure) -> _Elements:
    """Springs and tendons."""
    places = built_points(structure)
    ends = [*(spring.points for spring in structure.springs), *(tendon.points for tendon in structure.tendons)]
    points = np.array(ends, dtype=np.int64).reshape(-1, 2)
    along = places[points[:, 1]] - places[points[:, 0]]
    # one without a length pulls any way
    length = np.linalg.norm(along, axis=1, keepdims=True)
    along = np.where(length > 0, along / np.where(length > 0, length, 1.0), np.array([1.0, 0.0, 0.0]))
    stiffness, damping = ([getattr(spring, name) for spring in structure.springs] for name in ("stiffness", "damping"))
    for tendon in structure.tendons:
        law = tendon.law
        # a cubic's slope is largest at an end of its range
        both = law.elastic.stiffness([law.rest_length, max(tendon.longest, law.rest_length)])
        stiffness.append(float(np.max(both)) + sum(branch.stiffness for branch in law.branches))
        damping.append((law.damping or (0.0,))[0])
    return _Elements(points, np.stack([-along, along], axis=1), np.array(stiffness), np.array(damping))


def _creases(structure: Structure) -> _Elements:
    """Creases, with the stiffness of their springs where they are."""
    hinges = [hinge for hinge in structure.hinges if hinge.flaps]
    flaps = crease_flaps(structure)
    corners = built_points(structure)[flaps]
    unit = np.eye(18).reshape(18, 1, 6, 3)
    turns = flap_turns(np.broadcast_to(corners, (18, *corners.shape)), np.broadcast_to(unit, (18, *corners.shape)))
    law = crease_law(structure, crease_numbers(structure))
    return _Elements(
        flaps,
        turns.T.reshape(-1, 6, 3),
        law.slope(np.array([hinge.start for hinge in hinges])),
        np.array([hinge.damping for hinge in hinges]),
    )


def _strains(structure: Structure, membrane: Membrane) -> _Elements:
    """Strains of a membrane's triangles, which have a stiffness of 1 with the square root of theirs in them.

    Plane stress, triangles of constant strain (Zienkiewicz and Taylor, The Finite Element Method): the energy is
    |L' B x|^2 area t / 2 with D = L L'.
    """
    law, nu = membrane.law, membrane.law.poisson_ratio
    plane = law.youngs_modulus / (1 - nu**2) * np.array([[1, nu, 0], [nu, 1, 0], [0, 0, (1 - nu) / 2]])
    corners = membrane.built[membrane.triangles]
    edge, other = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    normal = np.cross(edge, other)
    twice = np.linalg.norm(normal, axis=1)
    along = edge / np.linalg.norm(edge, axis=1, keepdims=True)
    across = np.cross(normal / twice[:, None], along)
    x, y = (np.einsum("tcx,tx->tc", corners - corners[:, :1], each) for each in (along, across))
    by_x, by_y = (
        np.stack([each[:, 1] - each[:, 2], each[:, 2] - each[:, 0], each[:, 0] - each[:, 1]], axis=1) / twice[:, None]
        for each in (y, -x)
    )
    strain = np.stack(
        [
            by_x[:, :, None] * along[:, None],
            by_y[:, :, None] * across[:, None],
            by_y[:, :, None] * along[:, None] + by_x[:, :, None] * across[:, None],
        ],
        axis=1,
    )
    rows = np.einsum("ij,tjcx->ticx", np.linalg.cholesky(plane).T, strain)
    rows *= np.sqrt(twice / 2 * law.thickness)[:, None, None, None]
    number = np.full(len(structure.bodies), -1, dtype=np.int64)
    for place, point in enumerate(structure.points):
        number[point.body] = place
    points = np.repeat(number[membrane.bodies[membrane.triangles]], 3, axis=0)
    unit = np.ones(len(points))
    return _Elements(points, rows.reshape(-1, 3, 3), unit, law.damping * unit)
