"""Energy of springs between points of bodies in a tree, and of the pins that close its loops."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from forficula.arrays import Array
from forficula.statics.tree.elements import Elements, Expansion, LinePiece, elements, stretched
from forficula.statics.tree.pose import Pose, Tree, carried_points, places_of, pose
from forficula.structure import Structure

_SHORTEST = 1e-12  # share of the structure's span; a shorter spring has no direction
# stiffness of a pin, divided by that of the stiffest joint, crease, spring or tendon
_STIFF = 1e6
_SIDE = np.array([[-1.0, 1.0]])  # from the first end to the second


@dataclass(frozen=True, kw_only=True)
class Springs:
    """Springs that pull and push: the energy is stiffness (length - rest_length)^2 / 2.

    Attributes:
        laid: a piece for each spring.
        stiffness: N/m, (spring,).
        rest_length: m, (spring,); 0 is allowed.
        shortest: length below which a spring with a rest length has no direction, m.
    """

    laid: Elements
    stiffness: Array
    rest_length: Array
    shortest: float


def springs_of(structure: Structure, tree: Tree) -> Springs | None:
    """Return the springs of a structure; None if there are none."""
    ends = [structure.points[point] for spring in structure.springs for point in spring.points]
    return _springs(
        structure,
        tree,
        [end.body for end in ends],
        [end.place for end in ends],
        np.array([spring.stiffness for spring in structure.springs]),
        np.array([spring.rest_length for spring in structure.springs]),
    )


def pins_of(structure: Structure, tree: Tree, stiffest: float) -> Springs | None:
    """Return the pins of closures as springs with a rest length of 0; None without closures.

    Four pins hold every copy at its body: at the origin of the copy and at three points along its axes.

    Args:
        structure: with the closures.
        tree: of its bodies.
        stiffest: torque of the stiffest other part per angle, N m/rad.
    """
    arm = structure.span / 4
    bodies, places = list[int](), list[Array]()
    for closure in structure.closures:
        for place in (np.zeros(3), *(arm * np.eye(3))):
            bodies += closure.bodies
            places += [closure.position + closure.frame @ place, place]
    count = len(bodies) // 2
    return _springs(structure, tree, bodies, places, np.full(count, _STIFF * stiffest / arm**2), np.zeros(count))


def _springs(
    structure: Structure, tree: Tree, bodies: Sequence[int], places: Sequence[Array], stiffness: Array, rest: Array
) -> Springs | None:
    """Lay out springs between every two of some places in the axes of bodies."""
    if not len(bodies):
        return None
    pieces = [LinePiece(points=(2 * number, 2 * number + 1), sides=_SIDE) for number in range(len(stiffness))]
    return Springs(
        laid=elements(tree, bodies, np.array(places), pieces),
        stiffness=stiffness,
        rest_length=rest,
        shortest=_SHORTEST * structure.span,
    )


def spring_energy(springs: Springs, angles: Array, at: Pose | None = None) -> Expansion:
    """Compute the energy of springs.

    Args:
        springs: of the structure.
        angles: of all joints, in their own senses, rad, (case, joint).
        at: pose of the tree at these angles; computed by default.

    Returns:
        Energy, J, (case,); gradient, N m, (case, joint), and Hessian, N m/rad, (case, joint, joint), by the angles.
    """
    laws = [
        partial(_stretch, springs.stiffness[group.pieces], springs.rest_length[group.pieces], springs.shortest)
        for group in springs.laid.groups
    ]
    return stretched(springs.laid, angles, laws, at)


def _stretch(stiffness: Array, rest: Array, shortest: float, sides: Array) -> Expansion:
    """Compute the energy of springs from the vectors between their ends, (case, spring, 1, 3).

    The Hessian by this vector, for a pull F at a length L along a unit vector n, is F' n n^T + F / L (1 - n n^T). A
    spring with a rest length of 0 has F / L = F' at every length, also at 0.
    """
    apart = sides[:, :, 0]
    length = np.linalg.norm(apart, axis=2)
    known, rise = np.maximum(length, shortest), length - rest
    per_length = np.where(rest > 0, stiffness * rise / known, stiffness)
    along = apart / known[..., None]
    outer = along[..., :, None] * along[..., None, :]
    curvature = (stiffness - per_length)[..., None, None] * outer + per_length[..., None, None] * np.eye(3)
    energy = (stiffness * rise**2).sum(axis=1) / 2
    return energy, (per_length[..., None] * apart)[:, :, None], curvature[:, :, None]


def closure_gap(structure: Structure, tree: Tree, angles: Array) -> Array:
    """Compute the largest distance of a pair of points of closures, m, (case,); 0 without closures.

    Args:
        structure: with the closures.
        tree: of its bodies.
        angles: of all joints, in their own senses, rad, (case, joint).
    """
    ends = [structure.points[point] for closure in structure.closures for pair in closure.points for point in pair]
    if not ends:
        return np.zeros(len(angles))
    carried = carried_points(tree, [end.body for end in ends], np.array([end.place for end in ends]))
    places = places_of(carried, pose(tree, angles))
    return np.asarray(np.linalg.norm(places[:, :, 1::2] - places[:, :, ::2], axis=0).max(axis=1))
