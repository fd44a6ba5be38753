"""Where a structure is along the curves of a landscape: what a page shows while a reader goes along them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.show.page.data.shape_mesh import shape_mesh
from forficula.show.page.playback import Clip
from forficula.statics import CrossedHinge, EnergyLandscape
from forficula.statics.tree.pose import carried_points, places_of, pose, tree_of
from forficula.structure import Structure

_TURNS = 91  # poses of a hinge that turns alone
NO_POSE = (
    "What it looks like there is not drawn: the angle of this one hinge does not tell where the others are, and its"
    " panels have no one way to fold."
)


@dataclass(frozen=True, kw_only=True)
class LandscapePoses:
    """A structure at some angles of its hinges.

    Attributes:
        structure: that is posed.
        angles: of all hinges in their own senses, rad, (pose, hinge).
        why: how they were found, in a sentence.
    """

    structure: Structure
    angles: Array
    why: str


def poses_of(landscape: EnergyLandscape, shown: CrossedHinge | None) -> LandscapePoses | None:
    """Find what a structure looks like along its landscape's curves: as it folds rigidly, or as one hinge turns.

    Args:
        landscape: whose structure.
        shown: the hinge that its curve of one tendon is of, in which the structure turns if nothing ties it to others.

    Returns:
        The poses; None where statics knows none, for one hinge alone does not tell where the others are.
    """
    structure, path = landscape.structure, landscape.fold_path
    if path is not None:
        return LandscapePoses(
            structure=structure,
            angles=path.angles,
            why="Panels are rigid and fold together in the one way they have.",
        )
    if shown is None or _is_tied(structure):
        return None
    angles = np.tile([hinge.start for hinge in structure.hinges], (_TURNS, 1))
    turned = shown.own.sense * shown.own.angle
    angles[:, shown.hinge] = np.linspace(turned.min(), turned.max(), _TURNS)
    return LandscapePoses(
        structure=structure, angles=angles, why="This hinge turns alone; the others are as at the start."
    )


def pose_clip(poses: LandscapePoses, name: str) -> Clip:
    """Poses as a clip, with the number of the pose in place of a time."""
    structure = poses.structure
    mesh, tree = shape_mesh(structure), tree_of(structure)
    at = pose(tree, poses.angles)
    bodies = [np.array([point.body for point in structure.points], dtype=np.int64)]
    places = [np.array([point.place for point in structure.points]).reshape(-1, 3)]
    for membrane in structure.membranes:
        bodies.append(membrane.bodies)
        places.append(membrane.places)
    carried = carried_points(tree, np.concatenate(bodies), np.concatenate(places))
    points = np.moveaxis(places_of(carried, at), 0, -1)
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
    """Whether one hinge that turns takes others along, or its angle alone does not tell where its bodies are."""
    ties = (structure.membranes, structure.facets, structure.closures, structure.couplings, structure.limits)
    crease = any(hinge.flaps is not None for hinge in structure.hinges)
    return any(ties) or crease or any(body.slides for body in structure.bodies)
