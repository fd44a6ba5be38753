"""Poses of a structure along the curves of a landscape: of its rigid fold, or of one hinge that turns alone."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from forficula.arrays import Array
from forficula.show.page.data.fold_view import balled_plots, energies_plot, pose_view, posed_clip, reading_plot
from forficula.show.page.data.landscape_curves import Travel, posed_travel
from forficula.show.page.data.shape_mesh import shape_mesh
from forficula.statics import CrossedHinge, EnergyLandscape
from forficula.statics.quasi_static_path import spring_moments
from forficula.statics.tree.ensemble import ensemble
from forficula.statics.tree.potential import stored_energy
from forficula.statics.tree.tree_path import place_positions
from forficula.structure import Structure

_TURNS = 91  # number of poses of a hinge that turns alone


@dataclass(frozen=True, kw_only=True)
class LandscapePoses:
    """Poses of a structure.

    Attributes:
        structure: the structure.
        name: name of these poses, also of the slider that moves through them.
        title: phrase on how the structure moves.
        angles: angles of all hinges in their own senses, rad, (pose, hinge).
        energy: stored energy by part, J, (pose,) each.
        why: a sentence on how the poses were computed.
    """

    structure: Structure
    name: str
    title: str
    angles: Array
    energy: Mapping[str, Array]
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
        angles, name, title = path.angles, "rigid fold", "along the fold of its rigid panels"
        why = "Panels are rigid and fold together in the only possible way."
    elif shown is None or _is_tied(structure):
        return None
    else:
        angles = np.tile([hinge.start for hinge in structure.hinges], (_TURNS, 1))
        turned = shown.actual.sense * shown.actual.angle
        angles[:, shown.hinge] = np.linspace(turned.min(), turned.max(), _TURNS)
        name, title = "one hinge", "by turning one hinge"
        why = "This hinge turns alone; all others keep their starting angles."
    energy = stored_energy(ensemble([structure]).repeated(len(angles)), angles)
    return LandscapePoses(structure=structure, name=name, title=title, angles=angles, energy=energy, why=why)


def poses_view(poses: LandscapePoses, *, beside_run: bool) -> dict[str, Any]:
    """Return poses as data for JSON, as `fold_view` returns a path."""
    structure, positions = poses.structure, place_positions(poses.structure, poses.angles)
    share = np.linspace(0.0, 1.0, len(positions))
    clip = posed_clip(structure, shape_mesh(structure), share, positions, poses.angles, poses.energy)
    return pose_view(
        clip,
        poses.angles,
        spring_moments(structure, poses.angles),
        [("energy", total_energy(poses), "J")],
        name=poses.name,
        title=poses.title,
        notes=[poses.why],
        plots=balled_plots(energies_plot(clip), [reading_plot(readings) for readings in clip.readings]),
        beside_run=beside_run,
    )


def poses_travel(poses: LandscapePoses) -> Travel:
    """Return poses as positions on the curves of their landscape."""
    positions = place_positions(poses.structure, poses.angles)
    return posed_travel(poses.structure, poses.angles, positions, total_energy(poses))


def total_energy(poses: LandscapePoses) -> Array:
    """Return the stored energy of all parts, J, (pose,)."""
    return np.asarray(np.sum([np.zeros(len(poses.angles)), *poses.energy.values()], axis=0))


def _is_tied(structure: Structure) -> bool:
    """Return whether turning one hinge moves others, or its angle does not determine the positions of its bodies."""
    ties = (
        structure.membranes,
        structure.facets,
        structure.closures,
        structure.couplings,
        structure.springs,
        structure.limits,
    )
    crease = any(hinge.flaps is not None for hinge in structure.hinges)
    return any(ties) or crease or any(body.slides for body in structure.bodies)
