"""Poses of a structure along the curves of a landscape, which a page shows while the reader moves along them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.show.page.data.shape_mesh import shape_mesh
from forficula.show.page.playback import Clip
from forficula.statics import CrossedHinge, EnergyLandscape
from forficula.statics.tree.tree_path import place_positions
from forficula.structure import Structure

_TURNS = 91  # number of poses of a hinge that turns alone
NO_POSE = (
    "There is no picture here: the angle of this hinge alone does not determine the other angles, and the panels have"
    " more than one way to fold."
)


@dataclass(frozen=True, kw_only=True)
class LandscapePoses:
    """Poses of a structure.

    Attributes:
        structure: the structure.
        angles: angles of all hinges in their own senses, rad, (pose, hinge).
        why: a sentence on how the poses were computed.
    """

    structure: Structure
    angles: Array
    why: str


def poses_of(landscape: EnergyLandscape, shown: CrossedHinge | None) -> LandscapePoses | None:
    """Compute poses along a landscape's curves: of the rigid fold, or of one hinge that turns alone.

    Args:
        landscape: the landscape.
        shown: the hinge of the curve of one tendon; it turns if nothing ties it to other hinges.

    Returns:
        The poses; None if the angle of one hinge does not determine the pose.
    """
    structure, path = landscape.structure, landscape.fold_path
    if path is not None:
        return LandscapePoses(
            structure=structure,
            angles=path.angles,
            why="Panels are rigid and fold together in the only possible way.",
        )
    if shown is None or _is_tied(structure):
        return None
    angles = np.tile([hinge.start for hinge in structure.hinges], (_TURNS, 1))
    turned = shown.actual.sense * shown.actual.angle
    angles[:, shown.hinge] = np.linspace(turned.min(), turned.max(), _TURNS)
    return LandscapePoses(
        structure=structure, angles=angles, why="This hinge turns alone; all others keep their starting angles."
    )


def pose_clip(poses: LandscapePoses, name: str) -> Clip:
    """Return poses as a clip whose times are the indices of the poses."""
    structure = poses.structure
    mesh, points = shape_mesh(structure), place_positions(structure, poses.angles)
    energies = [
        tendon.law.elastic.energy(np.linalg.norm(points[:, tendon.points[1]] - points[:, tendon.points[0]], axis=1))
        for tendon in structure.tendons
    ]
    return Clip(
        name=name,
        structure=structure,
        time=np.arange(len(points), dtype=np.float64),
        points=points[:, mesh.anchors],
        mesh=mesh,
        marks=(),
        stages=(),
        readings=(),
        tendon_energy=np.array(energies).reshape(len(energies), -1).T.reshape(len(points), -1),
        stored_energy={},
        largest_energy={},
        rest_length=np.array([[tendon.law.rest_length for tendon in structure.tendons]]),
    )


def _is_tied(structure: Structure) -> bool:
    """Return whether turning one hinge moves others, or its angle does not determine the positions of its bodies."""
    ties = (structure.membranes, structure.facets, structure.closures, structure.couplings, structure.limits)
    crease = any(hinge.flaps is not None for hinge in structure.hinges)
    return any(ties) or crease or any(body.slides for body in structure.bodies)
