"""Creases in the engine: rows of a bending flex that can represent any law, torque and damping.

MuJoCo computes the bending of a flex edge by edge and exactly: a moment k sin(angle - r), continuous at every angle. A
row can be changed between steps, so that at the present angle it has the moment and the slope of the crease.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from typing import Any

import mujoco
import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics.engine.plate_angles import PRODUCTS, plate_directions
from forficula.dynamics.stepping.folds import Folds
from forficula.errors import InputError
from forficula.material import CreaseLaw
from forficula.structure import Hinge, Structure, crease_flaps, crease_law, crease_numbers

_ROW = 17


@dataclass(frozen=True, kw_only=True)
class EngineCreases:
    """The creases of a structure whose numbers in the engine's model are computed every few steps.

    These are creases between flaps, then joints, see `is_followed_joint`.

    Attributes:
        hinges: numbers of the hinges, (crease,).
        joints: index of each joint in the engine's model, (crease,); -1 for a crease between flaps.
        rows: rows of the creases between flaps in the engine's flex_bending, one per crease; several per crease between
            plates that turn.
        order: which of tail, head, left and right corner each of the four nodes of a row is, (row, 4); between plates
            that turn, which of start and end of a direction of the left and of the right plate.
        senses: +1 or -1, (crease,).
        law: of the springs and stops, arrays (crease,), in own senses and the model's units.
        damping: (crease,), in the model's units; 0 for joints, which the engine damps.
    """

    hinges: Indices
    joints: Indices
    rows: Indices
    order: Indices
    senses: Indices
    law: CreaseLaw
    damping: Array


def add_creases(spec: mujoco.MjSpec, structure: Structure) -> None:
    """Add the flex whose edges are the creases of a structure, in the model's units; its rows are set later."""
    flaps = crease_flaps(structure)
    if not len(flaps):
        return
    if structure.plates:
        _add_couples(spec, structure)
        return
    points, corners = np.unique(flaps, return_inverse=True)
    corners = corners.reshape(-1, 6)
    triangles = {tuple(sorted(triangle)): triangle for triangle in corners[:, [1, 0, 2]][:, [1, 0, 2]].tolist()}
    # counterclockwise like the left triangle, so the right one runs in the opposite direction along the crease
    for triangle in corners[:, [4, 3, 5]].tolist():
        triangles.setdefault(tuple(sorted(triangle)), triangle)
    bodies = [structure.bodies[structure.points[point].body].name for point in points.tolist()]
    _add_flex(spec, bodies, np.zeros(3 * len(points)), np.ravel(list(triangles.values())))


def _add_flex(spec: mujoco.MjSpec, bodies: list[str], places: Array, triangles: Array) -> None:
    flex = spec.add_flex(
        name="creases", dim=2, radius=1e-3, young=1, thickness=1, elastic2d=1, contype=0, conaffinity=0, selfcollide=0
    )
    flex.vertbody, flex.vert, flex.elem = bodies, places, triangles


def _add_couples(spec: mujoco.MjSpec, structure: Structure) -> None:
    """Add four nodes for every row of a crease between plates: start and end of a direction of each plate.

    See `PRODUCTS` for the directions. All are as long as the crease.
    """
    bodies: list[str] = []
    places: list[Array] = []
    for flaps in crease_flaps(structure).tolist():
        corners = np.array([structure.points[point].place for point in flaps])
        left, right = (structure.bodies[structure.points[flaps[place]].body].name for place in (0, 3))
        along, other = corners[1] - corners[0], corners[4] - corners[3]
        on_left = plate_directions(along, np.cross(along, corners[2] - corners[0]))
        on_right = plate_directions(other, np.cross(corners[5] - corners[3], other))
        length = float(np.linalg.norm(along))
        for one, two in PRODUCTS:
            bodies += [left, left, right, right]
            places += [corners[0], corners[0] + length * on_left[one], corners[3], corners[3] + length * on_right[two]]
    first = np.arange(0, len(bodies), 4)
    _add_flex(spec, bodies, np.ravel(places), (first[:, None] + [0, 1, 2, 1, 0, 3]).ravel())


def _couples(known: dict[tuple[frozenset[int], frozenset[int]], int], count: int) -> Indices:
    """Return the edges of the rows of `_add_couples`."""
    first = range(0, 4 * len(PRODUCTS) * count, 4)
    return np.array([known[frozenset((node, node + 1)), frozenset((node + 2, node + 3))] for node in first])


def creases_of(engine: mujoco.MjModel, structure: Structure, folds: Folds) -> EngineCreases | None:
    """Find the creases of a structure, in the model's units, in the compiled model; None if there are none.

    Raises:
        InputError: an edge is between two triangles that are not the flaps of its crease.
    """
    followed = followed_hinges(structure)
    if not len(followed):
        return None
    hinges = [structure.hinges[number] for number in folds.creases]
    columns, law = [structure.hinges[number] for number in followed], crease_law(structure, followed)
    joints = np.array([_joint(engine, hinge) for hinge in columns], dtype=np.int64)
    # the stops of joints are constraints of the engine
    lower, upper = np.where(joints >= 0, -np.inf, law.lower), np.where(joints >= 0, np.inf, law.upper)
    common: dict[str, Any] = {
        "hinges": followed,
        "joints": joints,
        "senses": np.array([hinge.sense for hinge in columns], dtype=np.int64),
        "law": replace(law, lower=lower, upper=upper),
        "damping": np.array([hinge.damping if hinge.flaps else 0.0 for hinge in columns]),
    }
    if not hinges:
        nothing = np.zeros(0, dtype=np.int64)
        return EngineCreases(rows=nothing, order=nothing.reshape(0, 4), **common)
    flex = mujoco.mj_name2id(engine, mujoco.mjtObj.mjOBJ_FLEX, "creases")
    first, count = int(engine.flex_edgeadr[flex]), int(engine.flex_edgenum[flex])
    edges = np.column_stack([engine.flex_edge, engine.flex_edgeflap])[first : first + count]
    known = {(frozenset(edge[:2]), frozenset(edge[2:])): number for number, edge in enumerate(edges.tolist())}
    result: list[int] = []
    if folds.placement is not None:
        numbers = _couples(known, len(hinges))
        return EngineCreases(
            rows=numbers + _first_row(engine, flex),
            order=np.asarray(edges[numbers] % 4, dtype=np.int64),
            **common,
        )
    for hinge, (tail, head, left, _, _, right) in zip(hinges, folds.flaps.tolist(), strict=True):
        number = known.get((frozenset((tail, head)), frozenset((left, right))))
        if number is None:
            raise InputError(f"{hinge.name}: need two facets that no others meet at their edge, got more")
        result.append(number)
    crease_edges = edges[result]
    ahead, on_left = crease_edges[:, 0] == folds.flaps[:, 0], crease_edges[:, 2] == folds.flaps[:, 2]
    return EngineCreases(
        rows=np.array(result, dtype=np.int64) + _first_row(engine, flex),
        order=np.column_stack([~ahead, ahead, 2 + ~on_left, 2 + on_left]).astype(np.int64),
        **common,
    )


def followed_hinges(structure: Structure) -> Indices:
    """Return the numbers of the hinges that are `EngineCreases`: of creases between flaps, then of joints."""
    joints = [number for number, hinge in enumerate(structure.hinges) if is_followed_joint(hinge, structure)]
    return np.concatenate([crease_numbers(structure), np.array(joints, dtype=np.int64)])


def is_followed_joint(hinge: Hinge, structure: Structure) -> bool:
    """Return whether a hinge is a joint whose spring in the engine is computed every few steps.

    In steps of Runge and Kutta, which closed loops and supported points take, the engine's own yield misses 1 % of the
    energy: measured on a vertex of four plates.
    """
    yields = bool(structure.closures or structure.holds) and math.isfinite(hinge.yield_angle)
    return hinge.flaps is None and (hinge.remembers or yields)


def _joint(engine: mujoco.MjModel, hinge: Hinge) -> int:
    return -1 if hinge.flaps else int(mujoco.mj_name2id(engine, mujoco.mjtObj.mjOBJ_JOINT, hinge.name))


def clear_rows(engine: mujoco.MjModel) -> None:
    """Set the bending of all edges of a model to zero, because rows of creases are set later."""
    if mujoco.mj_name2id(engine, mujoco.mjtObj.mjOBJ_FLEX, "creases") >= 0:
        engine.flex_bending[:] = 0


def engine_rows(engine: mujoco.MjModel) -> Array:
    """Return a writable view of the rows of a model's flexes, (row, 17)."""
    return np.asarray(engine.flex_bending).reshape(-1, _ROW)


def _first_row(engine: mujoco.MjModel, flex: int) -> int:
    return int(engine.flex_bendingadr[flex]) // _ROW
