"""Energy of membranes and length limits in any pose, with gradient and Hessian by the hinges' angles."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np

from forficula.arrays import Array
from forficula.pattern.geometry import triangle_normals
from forficula.statics.tree.elements import Elements, Expansion, LinePiece, elements, stretched
from forficula.statics.tree.pose import Pose, Tree
from forficula.structure import Membrane, MembraneLaw, Structure

# A length limit is modelled as a spring that is this many times stiffer than the membrane, E t, so that it hardly
# stretches.
_LIMIT_STIFFNESS = 100.0
# index of the stress (along, across, shear) for two columns of a deformation gradient
_BY_COLUMNS = np.array([[0, 2], [2, 1]])
_UNIT = np.eye(3)


@dataclass(frozen=True, kw_only=True)
class Patch:
    """Membranes of a group: triangles of constant strain.

    Attributes:
        volumes: of the triangles, m^3, (membrane, triangle, 1).
        law: stresses along, across and in shear per strain along, across and twice the shear, Pa, (membrane, 3, 3).
    """

    volumes: Array
    law: Array


@dataclass(frozen=True, kw_only=True)
class Sheet:
    """Membranes and length limits between the bodies of a structure.

    Attributes:
        laid: membranes, then limits.
        patches: of the first groups, which are membranes.
        lengths: largest lengths of the limits of every other group, m, (limit,).
        spring: stiffness of a limit beyond its length, N/m.
    """

    laid: Elements
    patches: tuple[Patch, ...]
    lengths: tuple[Array, ...]
    spring: float


def sheet_of(structure: Structure, tree: Tree) -> Sheet:
    """Lay out the membranes and limits of a structure."""
    bodies: list[int] = []
    places: list[Array] = []
    pieces: list[LinePiece] = []
    volumes: list[Array] = []
    for membrane in structure.membranes:
        nodes = tuple(range(len(bodies), len(bodies) + len(membrane.bodies)))
        sides, volume = _triangles(membrane)
        pieces.append(LinePiece(points=nodes, sides=sides))
        volumes.append(volume)
        bodies += membrane.bodies.tolist()
        places += list(membrane.places)
    ends: dict[int, int] = {}
    for limit in structure.limits:
        for end in limit.points:
            if end not in ends:
                ends[end] = len(bodies)
                bodies.append(structure.points[end].body)
                places.append(structure.points[end].place)
        first, second = limit.points
        pieces.append(LinePiece(points=(ends[first], ends[second]), sides=np.array([[-1.0, 1.0]])))
    laid = elements(tree, bodies, np.array(places).reshape(-1, 3), pieces)
    laws = [membrane.law for membrane in structure.membranes]
    numbers = [np.arange(len(pieces))[group.pieces] for group in laid.groups]
    of_membranes = [group for group in numbers if group[0] < len(laws)]
    most = np.array([limit.most for limit in structure.limits])
    return Sheet(
        laid=laid,
        patches=tuple(
            Patch(
                volumes=np.array([volumes[number] for number in group])[..., None],
                law=np.array([_stiffness(laws[number]) for number in group]),
            )
            for group in of_membranes
        ),
        lengths=tuple(most[group - len(laws)] for group in numbers[len(of_membranes) :]),
        spring=_LIMIT_STIFFNESS * _stiffest(structure),
    )


def _stiffest(structure: Structure) -> float:
    """Return the stiffness of the stiffest membrane, N/m, or of the stiffest tendon without a membrane."""
    membranes = [membrane.law.youngs_modulus * membrane.law.thickness for membrane in structure.membranes]
    return max(
        membranes or [tendon.law.elastic.stiffness(tendon.longest).item() for tendon in structure.tendons] or [1.0]
    )


def _triangles(membrane: Membrane) -> tuple[Array, Array]:
    """Return weights of nodes for columns of deformation gradients, 1/m, (column, node), and volumes, (triangle,)."""
    corners = _in_plane(membrane.built[membrane.triangles])
    edges = np.stack([corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]], axis=2)
    of_corners = np.array([[-1.0, -1.0], [1.0, 0.0], [0.0, 1.0]]) @ np.linalg.inv(edges)
    count = len(edges)
    sides = np.zeros((2 * count, len(membrane.bodies)))
    sides[np.arange(2 * count).reshape(-1, 1, 2), membrane.triangles[:, :, None]] = of_corners
    return sides, membrane.law.thickness * np.abs(np.linalg.det(edges)) / 2


def _in_plane(corners: Array) -> Array:
    """Return corners of triangles in axes of their planes, (triangle, 3, 2); x and y for a horizontal plane."""
    normals = triangle_normals(corners)
    normals = normals / np.linalg.norm(normals, axis=1, keepdims=True)
    normals = np.where(normals[:, 2:] < 0, -normals, normals)
    x, y, z = normals.T
    # x and y, rotated by the shortest rotation from z to the normal
    mixed = -x * y / (1 + z)
    axes = np.stack(
        [np.stack([1 - x**2 / (1 + z), mixed, -x], axis=1), np.stack([mixed, 1 - y**2 / (1 + z), -y], axis=1)], axis=2
    )
    return np.asarray((corners - corners[:, :1]) @ axes)


def _stiffness(law: MembraneLaw) -> Array:
    """Return stresses along, across and in shear per strain along, across and twice the shear, Pa, (3, 3)."""
    shear = law.youngs_modulus / (2 * (1 + law.poisson_ratio))
    lame = law.youngs_modulus * law.poisson_ratio / (1 - law.poisson_ratio**2)
    return np.array([[2 * shear + lame, lame, 0.0], [lame, 2 * shear + lame, 0.0], [0.0, 0.0, shear]])


def sheet_energy(sheet: Sheet, angles: Array, at: Pose | None = None) -> Expansion:
    """Compute the energy of membranes and limits.

    Args:
        sheet: membranes and limits.
        angles: of all hinges, in their own senses, rad, (case, hinge).
        at: pose of the tree at these angles; computed by default.

    Returns:
        Energy, J, (case,); gradient, N m, (case, hinge), and Hessian, N m/rad, (case, hinge, hinge), by the angles.
    """
    laws: list[Callable[[Array], Expansion | None]] = [
        *(partial(strain_energy, patch) for patch in sheet.patches),
        *(partial(_limit_energy, sheet.spring, length) for length in sheet.lengths),
    ]
    return stretched(sheet.laid, angles, laws, at)


def strain_energy(patch: Patch, gradient: Array) -> Expansion:
    """Compute the stretch energy of membranes from the deformation gradients of their triangles.

    The law is that of Saint Venant-Kirchhoff in plane stress, for triangles of constant strain. With the Green strain
    e, the energy per volume is mu tr(e^2) + lambda / 2 tr(e)^2, where mu = E / (2 (1 + nu)) and
    lambda = E nu / (1 - nu^2) (Timoshenko and Woinowsky-Krieger, Theory of Plates and Shells, for plane stress).

    Args:
        patch: the membranes.
        gradient: columns of the deformation gradients, two per triangle, (case, membrane, column, 3).

    Returns:
        Energy, J, (case,); gradient, J, (case, membrane, column, 3); Hessian, J, (case, membrane, triangle, 6, 6).
    """
    cases, count, volumes = len(gradient), gradient.shape[1], patch.volumes
    columns = gradient.reshape(cases, count, -1, 2, 3)
    # strains along, across, and twice the shear, and their derivatives
    squares = (columns @ columns.swapaxes(3, 4)).reshape(*columns.shape[:3], 4)
    strain = np.empty((*columns.shape[:3], 3))
    np.subtract(squares[..., ::3], 1, out=strain[..., :2])
    strain[..., :2] /= 2
    strain[..., 2] = squares[..., 1]
    by_column = np.zeros((*columns.shape[:3], 3, 6))
    halves = by_column.reshape(*columns.shape[:3], 6, 3)
    # the first column changes the strain along, the second the strain across, and both together the shear
    halves[..., :4:3, :], halves[..., 4:, :] = columns, columns[..., ::-1, :]
    stress = volumes * (strain @ patch.law)
    pull = stress[..., None, :] @ by_column
    curvature = by_column.swapaxes(3, 4) @ (volumes[..., None] * (patch.law[:, None] @ by_column))
    # stress part of the Hessian, column by column and coordinate by coordinate
    blocks = np.einsum("...aibi->...abi", curvature.reshape(*columns.shape[:3], 2, 3, 2, 3))
    blocks += stress.take(_BY_COLUMNS, axis=3)[..., None]
    energy = np.add.reduce((stress * strain).reshape(cases, -1, 3), axis=(1, 2)) / 2
    return energy, pull.reshape(cases, count, -1, 3), curvature


def _limit_energy(spring: float, lengths: Array, apart: Array) -> Expansion | None:
    """Compute the energy of limits, which pull only beyond their lengths, from the vectors (case, limit, 1, 3).

    It is None if no limit pulls.
    """
    distance = np.sqrt(np.einsum("...i,...i", apart, apart))
    beyond = np.maximum(distance - lengths[:, None], 0.0)
    if not beyond.any():
        return None
    along = apart / distance[..., None]
    ratio = (beyond / distance)[..., None, None]
    outer = along[..., :, None] * along[..., None, :]
    curvature = spring * ((beyond > 0)[..., None, None] * outer + ratio * (_UNIT - outer))
    return spring / 2 * np.add.reduce(beyond**2, axis=(1, 2)), spring * beyond[..., None] * along, curvature
