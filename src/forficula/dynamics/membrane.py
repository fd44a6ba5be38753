"""The membrane: one 2-D flex over all panels, its nodes carried by the bars."""

from __future__ import annotations

from dataclasses import dataclass

import mujoco
import numpy as np
from numpy.typing import NDArray

from forficula.design import Design
from forficula.design.places import mesh_rows
from forficula.dynamics.veins import Point, Vein


@dataclass(frozen=True, kw_only=True)
class Membrane:
    """The mesh of a membrane in the flat wing, in model units.

    Attributes:
        nodes: positions, (node, 3).
        bodies: name of the body that carries each node.
        carriers: index of the vein that carries each node, (node,).
        triangles: three nodes each, (triangle, 3); empty where a wing has no panels.
    """

    nodes: NDArray[np.float64]
    bodies: tuple[str, ...]
    carriers: NDArray[np.int64]
    triangles: NDArray[np.int64]


def panel_membrane(veins: tuple[Vein, ...], design: Design) -> Membrane:
    """Lay the mesh: panel k from the edge of its margin on vein k to the axis of vein k + 1.

    The margin is glued to vein k and turns with it; about vein k + 1 the panel may turn. A row of nodes lies at every
    share of the proximal length, at the ring fold, at every share of the distal length and at the tip.
    """
    nodes: list[Point] = []
    bodies: list[str] = []
    carriers: list[int] = []
    triangles: list[list[int]] = []
    for panel in range(len(veins) - 1):
        first = len(nodes)
        near, far = (mesh_rows(vein.hub_point, vein.ring_vertex, vein.tip, design) for vein in veins[panel : panel + 2])
        for bar, here, there in zip(_row_bars(design), near, far, strict=True):
            width = float(np.linalg.norm(there - here))
            margin = min(design.membrane.margin, design.membrane.margin_limit * width)
            nodes += [here + margin / width * (there - here), there]
            bodies += [f"{bar}{panel}", f"{bar}{panel + 1}"]
            carriers += [panel, panel + 1]
        for left in range(first, len(nodes) - 2, 2):
            triangles += [[left, left + 2, left + 3], [left, left + 3, left + 1]]
    return Membrane(
        nodes=np.array(nodes).reshape(-1, 3),
        bodies=tuple(bodies),
        carriers=np.array(carriers, dtype=np.int64),
        triangles=np.array(triangles, dtype=np.int64).reshape(-1, 3),
    )


def add_membrane(spec: mujoco.MjSpec, membrane: Membrane, veins: tuple[Vein, ...], design: Design) -> None:
    """Add the membrane to a model in the design's units."""
    if not len(membrane.triangles):
        return
    law = design.membrane
    places = [
        veins[vein].on_proximal_bar(node) if body.startswith("proximal") else veins[vein].on_distal_bar(node)
        for node, body, vein in zip(membrane.nodes, membrane.bodies, membrane.carriers, strict=True)
    ]
    flex = spec.add_flex(
        name="membrane",
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
    flex.vertbody = list(membrane.bodies)
    flex.vert = np.concatenate(places)
    flex.elem = membrane.triangles.ravel()


def membrane_energy(nodes: NDArray[np.float64], membrane: Membrane, design: Design) -> NDArray[np.float64]:
    """Stretch energy of the membrane with nodes anywhere in space.

    Saint Venant-Kirchhoff in plane stress, triangles of constant strain: per area, thickness times
    mu tr(e^2) + lambda / 2 tr(e)^2, with e the Green strain, mu = E / (2 (1 + nu)), lambda = E nu / (1 - nu^2)
    (Timoshenko and Woinowsky-Krieger, Theory of Plates and Shells, for plane stress).

    Args:
        nodes: positions, (..., node, 3), in the units of `design`.
        membrane: the mesh and its flat shape.
        design: the law.

    Returns:
        Energy in the units of `design`, (...).
    """
    law = design.membrane
    shear = law.youngs_modulus / (2 * (1 + law.poisson_ratio))
    lame = law.youngs_modulus * law.poisson_ratio / (1 - law.poisson_ratio**2)
    rest = _edges(membrane.nodes, membrane.triangles)[..., :2, :]
    to_rest = np.linalg.inv(rest)
    gradient = _edges(nodes, membrane.triangles) @ to_rest
    strain = (np.swapaxes(gradient, -1, -2) @ gradient - np.eye(2)) / 2
    trace = np.trace(strain, axis1=-2, axis2=-1)
    density = shear * np.sum(strain**2, axis=(-2, -1)) + lame / 2 * trace**2
    area = np.abs(np.linalg.det(rest)) / 2
    # in rows, so that a state's sum has the same bits beside others and alone
    return np.asarray(law.thickness * np.sum(np.ascontiguousarray(area * density), axis=-1))


def _edges(nodes: NDArray[np.float64], triangles: NDArray[np.int64]) -> NDArray[np.float64]:
    """Two edge vectors of each triangle as columns, (..., triangle, 3, 2)."""
    corners = nodes[..., triangles, :]
    return np.stack([corners[..., 1, :] - corners[..., 0, :], corners[..., 2, :] - corners[..., 0, :]], axis=-1)


def _row_bars(design: Design) -> list[str]:
    """The bar that carries each row; the ring fold's row is on the proximal bar."""
    law = design.membrane
    return ["proximal"] * (len(law.proximal_rows) + 1) + ["distal"] * (len(law.distal_rows) + 1)
