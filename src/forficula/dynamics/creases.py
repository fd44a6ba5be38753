"""Creases in the engine: rows of a bending flex, which follow any law, torque and damping.

MuJoCo's bending of a flex is by edge and exact: a moment k sin(angle - r), without a jump anywhere. A row can be
changed between steps, so that it has at any angle the moment and the slope that the crease has there.
"""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np
from numpy.typing import NDArray

from forficula.dynamics.folds import Folds
from forficula.errors import InputError
from forficula.material import CreaseLaw
from forficula.structure import Structure, crease_flaps

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

# steps over which a row stays as it is; each crease is of second order between
FOLLOWED = 10
_ROW = 17
# of a crease's stiffness, or of the stiffest if it has none: its stops
_STOP = 100.0


@dataclass(frozen=True, kw_only=True)
class Creases:
    """The creases of a structure in the engine's model.

    Attributes:
        rows: of each in the engine's flex_bending, (crease,).
        order: where tail, head and corners of the engine's edge are among the corners of its flaps, (crease, 4).
        sides: -1 where the first flap of the engine's edge is on its left, 1 where it is on its right, (crease,).
        senses: +1 or -1, (crease,).
        law: of the springs and stops, arrays (crease,), in own senses and the model's units.
        damping: (crease,), in the model's units.
    """

    rows: Indices
    order: Indices
    sides: Array
    senses: Indices
    law: CreaseLaw
    damping: Array

    def follow(self, corners: Array, angles: Array, speeds: Array, rests: Array, torques: Array) -> Array:
        """The rows that have the moments and the slopes that the creases have where they are, (crease, 17).

        They are made of the flaps as they are and not as built: where these are strained by 1e-2, moments of built ones
        lost some per cent of the energy that was exchanged.

        Args:
            corners: of the flaps, in the model's units, (crease, 6, 3).
            angles: in own senses, rad, (crease,).
            speeds: alike, in the model's units.
            rests: by how much the springs rest further on, rad, (crease,).
            torques: in the model's units, (crease,).
        """
        moment = self.law.moment(angles, rests) + self.damping * speeds - torques
        slope = self.law.slope(angles)
        size, ahead = np.hypot(moment, slope), np.arctan2(moment, slope)
        # of the angle between the flaps, whose sense the row has
        rest = self.senses * (angles - ahead)
        nodes = corners[np.arange(len(corners))[:, None], self.order]
        return bending_rows(nodes, size * np.cos(rest), size * np.sin(rest), self.senses * moment, self.sides)


def add_creases(spec: mujoco.MjSpec, structure: Structure) -> None:
    """Add the flex whose edges are the creases of a structure in a model's units; its rows are set later."""
    flaps = crease_flaps(structure)
    if not len(flaps):
        return
    points, corners = np.unique(flaps, return_inverse=True)
    corners = corners.reshape(-1, 6)
    triangles = {tuple(sorted(each)): each for each in corners[:, [1, 0, 2]][:, [1, 0, 2]].tolist()}
    # counterclockwise, as the left one is; the right one runs the other way along the crease
    for each in corners[:, [4, 3, 5]].tolist():
        triangles.setdefault(tuple(sorted(each)), each)
    flex = spec.add_flex(
        name="creases", dim=2, radius=1e-3, young=1, thickness=1, elastic2d=1, contype=0, conaffinity=0, selfcollide=0
    )
    flex.vertbody = [structure.bodies[structure.points[point].body].name for point in points.tolist()]
    flex.vert = np.zeros(3 * len(points))
    flex.elem = np.ravel(list(triangles.values()))


def creases_of(engine: mujoco.MjModel, structure: Structure, folds: Folds) -> Creases | None:
    """Find the creases in the compiled model, of a structure in its units; None where there are none.

    Raises:
        InputError: an edge between two triangles that are not the flaps of its crease.
    """
    hinges = [structure.hinges[number] for number in folds.creases]
    if not hinges:
        return None
    flex = mujoco.mj_name2id(engine, mujoco.mjtObj.mjOBJ_FLEX, "creases")
    first, count = int(engine.flex_edgeadr[flex]), int(engine.flex_edgenum[flex])
    edges = np.column_stack([engine.flex_edge, engine.flex_edgeflap])[first : first + count]
    known = {(frozenset(edge[:2]), frozenset(edge[2:])): number for number, edge in enumerate(edges.tolist())}
    found = []
    for hinge, (tail, head, left, _, _, right) in zip(hinges, folds.flaps.tolist(), strict=True):
        number = known.get((frozenset((tail, head)), frozenset((left, right))))
        if number is None:
            raise InputError(f"{hinge.name}: need two facets that no others meet at their edge, got more")
        found.append(number)
    mine = edges[found]
    ahead, on_left = mine[:, 0] == folds.flaps[:, 0], mine[:, 2] == folds.flaps[:, 2]
    return Creases(
        rows=np.array(found, dtype=np.int64) + _first_row(engine, flex),
        order=np.column_stack(
            [
                np.where(ahead, 0, 1),
                np.where(ahead, 1, 0),
                np.where(on_left, 2, 5),
                np.where(on_left, 5, 2),
            ]
        ),
        sides=np.where(ahead == on_left, -1.0, 1.0),
        senses=np.array([hinge.sense for hinge in hinges], dtype=np.int64),
        law=crease_law(structure, folds.creases),
        damping=np.array([hinge.damping for hinge in hinges]),
    )


def crease_law(structure: Structure, creases: Indices) -> CreaseLaw:
    """The law of the springs of creases, by the numbers of their hinges, in own senses, arrays (crease,)."""
    hinges = [structure.hinges[number] for number in creases]
    stiffness = np.array([hinge.stiffness for hinge in hinges])
    return CreaseLaw(
        stiffness=stiffness,
        rest_angle=np.array([hinge.rest_angle for hinge in hinges]),
        lock_below=np.array([hinge.lock_below for hinge in hinges]),
        lock_above=np.array([hinge.lock_above for hinge in hinges]),
        lower=np.array([hinge.lower for hinge in hinges]),
        upper=np.array([hinge.upper for hinge in hinges]),
        stop_stiffness=_STOP * np.where(stiffness > 0, stiffness, stiffness.max(initial=0.0)),
    )


def clear_rows(engine: mujoco.MjModel) -> None:
    """Take the bending of all edges out of a model; what creases there are sets its own."""
    if mujoco.mj_name2id(engine, mujoco.mjtObj.mjOBJ_FLEX, "creases") >= 0:
        engine.flex_bending[:] = 0


def engine_rows(engine: mujoco.MjModel) -> Array:
    """The rows of a model's flexes, (row, 17), to be written to."""
    return np.asarray(engine.flex_bending).reshape(-1, _ROW)


def _first_row(engine: mujoco.MjModel, flex: int) -> int:
    return int(engine.flex_bendingadr[flex]) // _ROW


def bending_rows(nodes: Array, cosine: Array, sine: Array, moment: Array, sides: Array) -> Array:
    """Rows of a bending flex that have the moment k sin(angle - r) of edges where they are, (edge, 17).

    With e along the edge and u, v to the flaps, and c the cotangent weights of the four nodes over |e|, which give
    |c x|^2 = 2 (1 - cos angle) (Wardetzky et al. 2007), the first sixteen numbers are k cos r c c' and the last one is
    k sin r |e| / (|e x u| |e x v|), whose sign is that of the side. Such a row pulls within the flaps, too, as soon as
    they are not in one plane: force densities along their sides take that back, so that the force is that of the moment.

    Args:
        nodes: tail, head and the corners of both flaps, (edge, 4, 3).
        cosine: k cos r, (edge,).
        sine: k sin r, (edge,).
        moment: that the row is to have, of the angle between the flaps, (edge,).
        sides: -1 where the first flap is on the left of the edge, 1 where it is on the right, (edge,).
    """
    edge, one, other = (nodes[:, place] - nodes[:, 0] for place in (1, 2, 3))
    first, second = np.cross(edge, one), np.cross(edge, other)
    square, areas, other_areas = (np.sum(each**2, axis=1) for each in (edge, first, second))
    length = np.sqrt(square)
    # heights of the corners over the edge, and where their feet divide it
    high, other_high = np.sqrt(areas) / length, np.sqrt(other_areas) / length
    share, other_share = np.sum(one * edge, axis=1) / square, np.sum(other * edge, axis=1) / square
    weights = np.stack(
        [
            (1 - share) / high + (1 - other_share) / other_high,
            share / high + other_share / other_high,
            -1 / high,
            -1 / other_high,
        ],
        axis=1,
    )
    rows = np.zeros((len(nodes), _ROW))
    stiffness = cosine[:, None, None] * weights[:, :, None] * weights[:, None]
    volume = sine * sides * length / np.sqrt(areas * other_areas)
    # what the row does to the corners, and what the moment is to do
    pull = np.einsum("ei,eix->ex", weights, nodes) * cosine[:, None]
    lever, other_lever = -sides * moment * length / areas, sides * moment * length / other_areas
    wrong = weights[:, 2, None] * pull + volume[:, None] * np.cross(other, edge) - lever[:, None] * first
    other_wrong = weights[:, 3, None] * pull + volume[:, None] * first - other_lever[:, None] * second
    densities = np.zeros((len(nodes), 4, 4))
    for corner, too_much, foot in ((2, wrong, one), (3, other_wrong, other)):
        # within a flap, along its sides to the tail and to the head
        across = np.sum(edge * foot, axis=1)
        normal = square * np.sum(foot**2, axis=1) - across**2
        to_head = np.sum(too_much * edge, axis=1) * np.sum(foot**2, axis=1) - np.sum(too_much * foot, axis=1) * across
        to_head = to_head / normal
        both = (np.sum(too_much * edge, axis=1) * across - np.sum(too_much * foot, axis=1) * square) / normal
        densities[:, corner, 1], densities[:, corner, 0] = to_head, both - to_head
    at_tail = -volume[:, None] * (np.cross(one, other) + np.cross(other, edge) + first) + weights[:, 0, None] * pull
    at_tail += ((1 - share) * lever)[:, None] * first + ((1 - other_share) * other_lever)[:, None] * second
    at_tail -= densities[:, 2, 0, None] * one + densities[:, 3, 0, None] * other
    densities[:, 1, 0] = np.sum(at_tail * edge, axis=1) / square
    densities = densities + np.swapaxes(densities, 1, 2)
    stiffness = stiffness - densities
    stiffness[:, range(4), range(4)] += densities.sum(axis=2)
    rows[:, :16], rows[:, 16] = stiffness.reshape(-1, 16), volume
    return rows
