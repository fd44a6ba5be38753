"""Energy landscape of any structure: the only module that chooses between the solvers for trees and for nets."""

from __future__ import annotations

import math
from dataclasses import dataclass

from forficula.design import AnyDesign, as_design
from forficula.statics.landscape import EnergyLandscape
from forficula.statics.net.net_landscape import Progress, net_landscape, slow_courses
from forficula.statics.net.net_of import is_net
from forficula.statics.tree.potential import ensemble
from forficula.statics.tree.quasi_static import at_goal, least_slow_torque, start_state, state_after, state_beyond
from forficula.statics.tree_landscape import tree_landscape
from forficula.structure import Structure, drive_of, goal_of, structure_of

# largest multiple of its own strength with which a drive is tried
_MORE = 4.0


@dataclass(frozen=True, kw_only=True)
class SlowDrive:
    """Least strength of a slowly growing drive for a transition.

    Attributes:
        least: least sufficient size, in the drive's SI unit; None if none of the tried sizes is sufficient.
        largest_force: largest force of a displacement on its path, N; None for other drives.
    """

    least: float | None
    largest_force: float | None = None


def energy_landscape(design: AnyDesign, points: int = 181, progress: Progress = lambda _: None) -> EnergyLandscape:
    """Compute the energy landscape of a design.

    Results that need a single folding path of rigid panels are left out for a structure without one.

    Args:
        design: the design; its protocol defines which states count as folded and opened, and the largest fold torque.
        points: number of points on every curve.
        progress: called with the name of each step of the computation.

    Raises:
        InputError: the design cannot be built, or a transition does not name its state.
    """
    design = as_design(design)
    structure = structure_of(design)
    if is_net(structure):
        return net_landscape(design, structure, progress)
    return tree_landscape(design, structure, points)


def slow_drives(structure: Structure) -> dict[str, SlowDrive]:
    """Compute the least slowly growing drive of every transition, by name, each from the end of the one before."""
    if is_net(structure):
        courses = {course.name: course for course in slow_courses(structure)}
        return {
            transition.name: SlowDrive(
                least=courses[transition.name].least, largest_force=courses[transition.name].largest_force
            )
            if transition.name in courses
            else SlowDrive(least=None)
            for transition in structure.transitions
        }
    return _joint_drives(structure)


def _joint_drives(structure: Structure) -> dict[str, SlowDrive]:
    """Compute least drives of bodies on joints in a tree, to 1 %."""
    structures, result = ensemble([structure]), dict[str, SlowDrive]()
    before, held = start_state(structures), True
    for transition in structure.transitions:
        least = math.nan
        if held:
            most = _MORE * abs(drive_of(structure, transition.drive).strength) or 1.0
            slow = least_slow_torque(structures, before.position, transition, most)
            least = float(slow.torque[0])
            before = state_after(structures, transition, slow.torque, slow.position)
        else:
            before = state_beyond(structures, transition)
        result[transition.name] = SlowDrive(least=None if math.isnan(least) else least)
        held = bool(at_goal(structures, before.position, goal_of(structure, transition.released))[0])
    return result
