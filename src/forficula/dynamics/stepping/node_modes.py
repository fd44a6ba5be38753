"""Fastest mode of sliding nodes, from sparse closed forms, and of plates that turn."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from scipy.linalg import eigh
from scipy.sparse import csr_array, diags_array
from scipy.sparse.linalg import eigsh

from forficula.arrays import Array, Indices
from forficula.dynamics.engine.drag import CONSTANT_STEPS
from forficula.dynamics.engine.placement import Placement, placement_of
from forficula.dynamics.stepping.folds import flap_turns
from forficula.pattern.geometry import triangle_areas
from forficula.structure import (
    Hinge,
    Membrane,
    Structure,
    built_points,
    crease_flaps,
    crease_law,
    crease_numbers,
    mass_of,
)

# number of coordinates above which an iteration is faster than all eigenvalues
_FEW = 60
# relative accuracy of the largest eigenvalue, about a thousandth of the step
_CLOSE = 1e-3
# [chosen] length of a short edge, as a share of the median length of edges
_SHORT = 0.1
# length that counts as zero, as a share of the span
_NO_LENGTH = 1e-9
# factor on the ratio of the longest step for creases to that for all parts
_FOLLOWED = 0.2
# for four plates that snap, the missing energy is as with 1 step; with 10 steps it is ten times as large
_BETWEEN_PLATES = 5
# for a clasp that hits its stops, the missing energy is as with 1 step
_AT_STOPS = 2
# for joints with linear springs: the missing energy of a strip that relaxes is 3e-4 of the exchanged one
AT_JOINTS = 5
# all values divide the number of steps between two checks of goals
_BLOCKS = (1, 2, 5, 10, 20, 50, 100)


class _Elements(NamedTuple):
    """Energies k (g x)^2 / 2 and dampers: points, (element, point), g, (element, point, 3), k and c, (element,)."""

    points: Indices
    gradients: Array
    stiffness: Array
    damping: Array


def followed_steps(structure: Structure) -> int:
    """Return the number of steps over which the engine's rows of creases are constant.

    The number grows with the stiffness of bars relative to creases. While a row is constant, strains of its flaps
    change its moment by about the same share, and this energy is lost when the row is updated. With this number of
    steps, free bars lost 1e-2 of their energy in ten swings, as they do because of the timestep; the loss decreases
    with fewer or shorter steps. Rows between plates do not depend on strains.
    """
    if structure.plates:
        stops = any(hinge.flaps and (hinge.upper < math.pi or hinge.lower > -math.pi) for hinge in structure.hinges)
        return _AT_STOPS if stops else _BETWEEN_PLATES
    creases = node_timestep(replace(structure, springs=(), tendons=(), membranes=(), motors=()))
    allowed = _FOLLOWED * creases / node_timestep(structure)
    return max(steps for steps in _BLOCKS if steps <= max(allowed, 1))


def node_timestep(structure: Structure) -> float:
    """Compute the longest timestep at which no mode of the built shape flips and grows, in the structure's units.

    For one step of semi-implicit Euler on a mode of angular frequency w and damping rate c, Jury's condition is
    h^2 w^2 + 2 h c < 4; for c = 0 it is the textbook limit 2 / w. The highest frequency and the strongest damping of
    all modes are combined. Tendons count with the largest stiffness of their law.
    """
    if structure.plates:
        return _step(*_plate_modes(structure))
    free = np.array([[axis in body.slides for axis in range(3)] for body in structure.bodies]).ravel()
    masses = np.repeat([body.mass for body in structure.bodies], 3)[free]
    if not free.any():
        return math.inf
    carriers = np.array([point.body for point in structure.points], dtype=np.int64)
    square = rate = 0.0
    matrices = []
    for points, gradients, stiffness, damping in _groups(structure):
        columns = (3 * carriers[points][:, :, None] + np.arange(3)).reshape(len(points), -1)
        rows = np.broadcast_to(np.arange(len(points))[:, None], columns.shape)
        shape = (len(points), 3 * len(structure.bodies))
        gradient = csr_array((gradients.ravel(), (rows.ravel(), columns.ravel())), shape=shape)
        matrices.append((csr_array(gradient[:, free] @ diags_array(1 / np.sqrt(masses))), stiffness, damping))
    square, rate = (
        _largest(
            sum(
                (csr_array(matrix[0].T @ diags_array(matrix[kind]) @ matrix[0]) for matrix in matrices),
                start=_zero_matrix(masses),
            )
        )
        for kind in (1, 2)
    )
    return _step(square, rate + _viscous_rate(structure))


def short_edge(structure: Structure) -> tuple[str, str, float] | None:
    """Return the points and the length of a short edge that limits the timestep of nodes; None if none is short.

    The edge is the shortest one at the bar, the crease or the triangle of a membrane whose own limit is the shortest:
    the limit of one element alone is an upper bound of that of all elements.
    """
    if structure.plates or not structure.facets:
        return None
    carriers = np.array([point.body for point in structure.points], dtype=np.int64)
    masses, places = np.array([body.mass for body in structure.bodies]), built_points(structure)
    least, limiting = math.inf, np.zeros(0, dtype=np.int64)
    for points, gradients, stiffness, damping in _groups(structure):
        mobility = (np.square(gradients).sum(axis=2) / masses[carriers[points]]).sum(axis=1)
        limits = [_step(*both) for both in zip(stiffness * mobility, damping * mobility, strict=True)]
        if min(limits) < least:
            least, limiting = min(limits), np.unique(points[int(np.argmin(limits))])
    sides = {tuple(sorted(ends)) for facet in structure.facets for ends in pairwise([*facet.points, facet.points[0]])}
    lengths = {side: float(np.linalg.norm(places[side[1]] - places[side[0]])) for side in sides}
    near = [side for side in lengths if np.isin(side, limiting).all()]
    shortest = min(near, key=lambda side: lengths[side], default=None)
    if shortest is None or lengths[shortest] > _SHORT * np.median([*lengths.values()]):
        return None
    one, other = (structure.points[point].name for point in shortest)
    return one, other, lengths[shortest]


def _groups(structure: Structure) -> list[_Elements]:
    """Return the elements of nodes, by kind."""
    groups = [
        _lines(structure),
        _servos(structure),
        _creases(structure),
        *(_strains(structure, membrane) for membrane in structure.membranes),
    ]
    return [group for group in groups if len(group.points)]


def _viscous_rate(structure: Structure) -> float:
    """Return the largest damping rate of a node by the medium's viscosity, times the number of steps of constant drag.

    The drag of a triangle is at most that of a third of its area at each corner.
    """
    medium = structure.medium
    if medium is None:
        return 0.0
    corners = np.array([body.position for body in structure.bodies])[medium.carriers]
    per_corner = 32 / math.pi * medium.viscosity * triangle_areas(corners) / medium.widths / 3
    on_nodes = np.bincount(medium.carriers.ravel(), np.repeat(per_corner, 3), len(structure.bodies))
    return CONSTANT_STEPS * float(max(on_nodes / [body.mass for body in structure.bodies]))


def _step(square: float, rate: float) -> float:
    """Return the longest timestep for the square of the largest angular frequency and the largest damping rate."""
    if not square:
        return 2 / rate if rate else math.inf
    return 4 / (rate + math.hypot(rate, 2 * math.sqrt(square)))


def _plate_modes(structure: Structure) -> tuple[float, float]:
    """Compute the square of the largest angular frequency, and the largest damping rate, of plates as built."""
    placement = placement_of(structure)
    pose = placement.poses(_built_position(structure, placement))
    moves, turns = placement.rates(pose, np.eye(placement.velocity_count))
    inertia = np.zeros((placement.velocity_count, placement.velocity_count))
    for number in range(len(structure.bodies)):
        mass, centre, tensor = mass_of(structure, number)
        tensor = pose.frames[number] @ tensor @ pose.frames[number].T
        moved = moves[:, number] + np.cross(turns[:, number], pose.frames[number] @ centre)
        inertia += mass * moved @ moved.T + turns[:, number] @ tensor @ turns[:, number].T
    matrices = [np.zeros_like(inertia), np.zeros_like(inertia)]
    places, braking = placement.velocities[placement.hinges].tolist(), _braking(structure)
    for (number, hinge), place in zip(_joints(structure), places, strict=True):
        inertia[place, place] += hinge.armature
        matrices[0][place, place] += hinge.stiffness
        # the engine's integrator is implicit in the damping of joints, but not in that of motors
        matrices[1][place, place] += braking[number]
    carriers = np.array([point.body for point in structure.points], dtype=np.int64)
    arms = np.array([pose.frames[point.body] @ point.place for point in structure.points])
    for points, gradients, *strengths in (_lines(structure), _creases(structure)):
        if len(points):
            shifts = moves[:, carriers[points]] + np.cross(turns[:, carriers[points]], arms[points])
            along = np.einsum("depx,epx->ed", shifts, gradients)
            for number, strength in enumerate(strengths):
                matrices[number] += along.T @ (strength[:, None] * along)
    square, rate = (float(eigh(matrix, inertia, eigvals_only=True)[-1]) for matrix in matrices)
    return max(square, 0.0), max(rate, 0.0)


def _joints(structure: Structure) -> list[tuple[int, Hinge]]:
    """Return the hinges that turn bodies, with their numbers, in their order."""
    return [(number, hinge) for number, hinge in enumerate(structure.hinges) if not hinge.flaps]


def _built_position(structure: Structure, placement: Placement) -> Array:
    """Return the engine's positions in the built shape."""
    position = np.zeros(placement.position_count)
    for number in placement.free.tolist():
        position[placement.slides[number]] = structure.bodies[number].position
    position[placement.quaternions] = 1.0
    position[placement.hinges] = placement.built
    return position


def _zero_matrix(masses: Array) -> csr_array:
    return csr_array((len(masses), len(masses)))


def _largest(matrix: csr_array) -> float:
    """Compute the largest eigenvalue of a positive semidefinite matrix."""
    if matrix.shape[0] <= _FEW or not matrix.nnz:
        return float(np.linalg.eigvalsh(matrix.toarray()).max()) if matrix.nnz else 0.0
    start = np.random.default_rng(0).normal(size=matrix.shape[0])
    result = eigsh(matrix, k=1, which="LM", return_eigenvectors=False, v0=start, tol=_CLOSE)
    return float(result[0]) * (1 + _CLOSE)


def _lines(structure: Structure) -> _Elements:
    """Return the elements of springs and tendons."""
    places = built_points(structure)
    ends = [*(spring.points for spring in structure.springs), *(tendon.points for tendon in structure.tendons)]
    points = np.array(ends, dtype=np.int64).reshape(-1, 2)
    along = places[points[:, 1]] - places[points[:, 0]]
    length = np.linalg.norm(along, axis=1, keepdims=True)
    # an element without a length has stiffness in every direction
    short = length[:, 0] <= _NO_LENGTH * structure.span
    along = np.where(short[:, None], np.array([1.0, 0.0, 0.0]), along / np.where(short[:, None], 1.0, length))
    stiffness, damping = ([getattr(spring, name) for spring in structure.springs] for name in ("stiffness", "damping"))
    built = length[len(structure.springs) :, 0]
    for tendon, built_length in zip(structure.tendons, built.tolist(), strict=True):
        law = tendon.law
        # tendons without a largest length are assumed to reach at most twice their built length
        longest = tendon.longest if np.isfinite(tendon.longest) else 2 * built_length
        # the slope of a cubic law is largest at an end of its range
        both = law.elastic.stiffness([law.rest_length, max(longest, law.rest_length)])
        stiffness.append(float(np.max(both)) + sum(branch.stiffness for branch in law.branches))
        damping.append((law.damping or (0.0,))[0])
    every = np.concatenate([np.arange(len(points)), *[np.flatnonzero(short)] * 2])
    directions = np.concatenate([along, *(np.tile(np.eye(3)[axis], (int(short.sum()), 1)) for axis in (1, 2))])
    return _Elements(
        points[every], np.stack([-directions, directions], axis=1), np.array(stiffness)[every], np.array(damping)[every]
    )


def _servos(structure: Structure) -> _Elements:
    """Return the elements of servos that displace points."""
    served = [motor for motor in structure.motors if motor.kind == "displacement"]
    directions = [motor.direction for motor in served for _ in motor.points]
    return _Elements(
        np.array([point for motor in served for point in motor.points], dtype=np.int64).reshape(-1, 1),
        np.array(directions, dtype=np.float64).reshape(-1, 1, 3),
        np.array([motor.stiffness for motor in served for _ in motor.points]),
        np.array([damping for motor in served for damping in motor.damping]),
    )


def _creases(structure: Structure) -> _Elements:
    """Return the elements of creases, with the stiffness of their springs at the start and of their stops."""
    hinges = [hinge for hinge in structure.hinges if hinge.flaps]
    flaps = crease_flaps(structure)
    corners = built_points(structure)[flaps]
    unit = np.eye(18).reshape(18, 1, 6, 3)
    turns = flap_turns(np.broadcast_to(corners, (18, *corners.shape)), np.broadcast_to(unit, (18, *corners.shape)))
    law = crease_law(structure, crease_numbers(structure))
    stopped = np.isfinite(law.lower) | np.isfinite(law.upper)
    return _Elements(
        flaps,
        turns.T.reshape(-1, 6, 3),
        law.largest_slope(np.array([hinge.start for hinge in hinges])) + np.where(stopped, law.stop_stiffness, 0.0),
        np.array([hinge.damping for hinge in hinges]) + _braking(structure)[crease_numbers(structure)],
    )


def _braking(structure: Structure) -> Array:
    """Return the largest damping of each hinge by motors, (hinge,)."""
    most = np.zeros(len(structure.hinges))
    for number, motor in enumerate(structure.motors):
        size = max((abs(drive.strengths[number]) for drive in structure.drives), default=0.0)
        gains = np.array(motor.gains or (1.0,) * len(motor.hinges))
        most[list(motor.hinges)] += size * gains / motor.no_load_speed
    return most


def _strains(structure: Structure, membrane: Membrane) -> _Elements:
    """Return the elements of a membrane's strains; their gradients include the square root of the stiffness.

    For plane stress and triangles of constant strain (Zienkiewicz and Taylor, The Finite Element Method), the energy is
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
    x, y = (np.einsum("tcx,tx->tc", corners - corners[:, :1], axis) for axis in (along, across))
    by_x, by_y = (
        np.stack([ends[:, 1] - ends[:, 2], ends[:, 2] - ends[:, 0], ends[:, 0] - ends[:, 1]], axis=1) / twice[:, None]
        for ends in (y, -x)
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
