"""Membranes in the engine: membranes of one law are one 2-D flex whose nodes are carried by the bodies."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import mujoco
import numpy as np

from forficula.arrays import Array, Indices
from forficula.structure import Membrane, MembraneLaw, Structure

_FLEX = "membrane"  # the engine's name of the flex of all membranes


@dataclass(frozen=True, kw_only=True)
class MembraneMesh:
    """The membranes of a structure as one mesh.

    Attributes:
        bodies: number of the body that carries each node, (node,).
        places: nodes in the axes of their bodies, (node, 3).
        built: nodes in the built shape, (node, 3).
        triangles: three nodes each, (triangle, 3); empty without a membrane.
        law: of the whole mesh; None without a membrane.
    """

    bodies: Indices
    places: Array
    built: Array
    triangles: Indices
    law: MembraneLaw | None


def joined_mesh(membranes: Sequence[Membrane]) -> MembraneMesh:
    """Join membranes of one law into one mesh, with their nodes one after another."""
    first = np.cumsum([0, *(len(membrane.built) for membrane in membranes)])
    return MembraneMesh(
        bodies=np.concatenate([np.zeros(0, dtype=np.int64), *(membrane.bodies for membrane in membranes)]),
        places=np.concatenate([np.zeros((0, 3)), *(membrane.places for membrane in membranes)]),
        built=np.concatenate([np.zeros((0, 3)), *(membrane.built for membrane in membranes)]),
        triangles=np.concatenate(
            [
                np.zeros((0, 3), dtype=np.int64),
                *(membrane.triangles + start for membrane, start in zip(membranes, first[:-1], strict=True)),
            ]
        ),
        law=membranes[0].law if membranes else None,
    )


def add_membranes(spec: mujoco.MjSpec, mesh: MembraneMesh, structure: Structure) -> None:
    """Add the membranes to a model, in the model's units."""
    law = mesh.law
    if law is None:
        return
    flex = spec.add_flex(
        name=_FLEX,
        dim=2,
        radius=law.thickness / 2,
        young=law.youngs_modulus,
        poisson=law.poisson_ratio,
        damping=law.damping,
        thickness=law.thickness,
        elastic2d=2,  # stretch
        contype=0,
        conaffinity=0,
        selfcollide=0,
    )
    flex.vertbody = [structure.bodies[body].name for body in mesh.bodies]
    flex.vert = mesh.places.ravel()
    flex.elem = mesh.triangles.ravel()


def first_node(engine: mujoco.MjModel) -> int:
    """Return the index of the first node of the membranes among the vertices of all flexes; 0 without a membrane."""
    flex = mujoco.mj_name2id(engine, mujoco.mjtObj.mjOBJ_FLEX, _FLEX)
    return int(engine.flex_vertadr[flex]) if flex >= 0 else 0


def stretch_energy(nodes: Array, mesh: MembraneMesh) -> Array:
    """Compute the stretch energy of membranes with nodes anywhere in space.

    The law is that of Saint Venant-Kirchhoff in plane stress, for triangles of constant strain. The energy per area is
    thickness times mu tr(e^2) + lambda / 2 tr(e)^2, with the Green strain e, mu = E / (2 (1 + nu)) and
    lambda = E nu / (1 - nu^2) (Timoshenko and Woinowsky-Krieger, Theory of Plates and Shells, for plane stress).

    Args:
        nodes: positions, (..., node, 3), in the units of the mesh.
        mesh: with its built shape and its law.

    Returns:
        Energy in the units of the mesh, (...).
    """
    law = mesh.law
    if law is None:
        return np.zeros(nodes.shape[:-2])
    shear = law.youngs_modulus / (2 * (1 + law.poisson_ratio))
    lame = law.youngs_modulus * law.poisson_ratio / (1 - law.poisson_ratio**2)
    rest = _in_plane(_edges(mesh.built, mesh.triangles))
    to_rest = np.linalg.inv(rest)
    gradient = _edges(nodes, mesh.triangles) @ to_rest
    strain = (np.swapaxes(gradient, -1, -2) @ gradient - np.eye(2)) / 2
    trace = np.trace(strain, axis1=-2, axis2=-1)
    density = shear * np.sum(strain**2, axis=(-2, -1)) + lame / 2 * trace**2
    area = np.abs(np.linalg.det(rest)) / 2
    # contiguous, so that the sum of a state has the same bits with others and alone
    return np.asarray(law.thickness * np.sum(np.ascontiguousarray(area * density), axis=-1))


def _in_plane(edges: Array) -> Array:
    """Return edges of triangles, (triangle, 3, 2), in axes of their planes, (triangle, 2, 2)."""
    if not edges[:, 2].any():
        return edges[:, :2]
    upper = np.zeros((len(edges), 2, 2))
    first, second = edges[..., 0], edges[..., 1]
    upper[:, 0, 0] = np.linalg.norm(first, axis=1)
    upper[:, 0, 1] = np.sum(first * second, axis=1) / upper[:, 0, 0]
    upper[:, 1, 1] = np.linalg.norm(np.cross(first, second), axis=1) / upper[:, 0, 0]
    return upper


def _edges(nodes: Array, triangles: Indices) -> Array:
    """Return two edge vectors of each triangle as columns, (..., triangle, 3, 2)."""
    corners = nodes[..., triangles, :]
    return np.stack([corners[..., 1, :] - corners[..., 0, :], corners[..., 2, :] - corners[..., 0, :]], axis=-1)
