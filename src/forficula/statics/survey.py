"""What statics says of any structure: the one module that chooses the solver, of trees or of nets."""

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

# up to how many times its own strength a drive is tried
_MORE = 4.0


@dataclass(frozen=True, kw_only=True)
class SlowDrive:
    """What a slowly growing drive must be for a transition.

    Attributes:
        least: size of the least that makes it, in the drive's SI unit; None where none of those tried does.
        largest_force: of a displacement on the way, N; None of other drives.
    """

    least: float | None
    largest_force: float | None = None


def energy_landscape(design: AnyDesign, points: int = 181, progress: Progress = lambda _: None) -> EnergyLandscape:
    """Survey the statics of a design.

    What depends on the one way in which rigid panels fold is left out where there is none.

    Args:
        design: what to build; its protocol says what counts as folded and as opened, and the largest fold torque.
        points: places on every curve.
        progress: is told what is worked out.

    Raises:
        InputError: it cannot be built, or a transition does not say where it leads.
    """
    design = as_design(design)
    structure = structure_of(design)
    if is_net(structure):
        return net_landscape(design, structure, progress)
    return tree_landscape(design, structure, points)


def slow_drives(structure: Structure) -> dict[str, SlowDrive]:
    """The least slowly growing drive of every transition, by name, each from where the one before leads."""
    if is_net(structure):
        courses = {each.name: each for each in slow_courses(structure)}
        return {
            each.name: SlowDrive(least=courses[each.name].least, largest_force=courses[each.name].largest_force)
            if each.name in courses
            else SlowDrive(least=None)
            for each in structure.transitions
        }
    return _of_joints(structure)


def _of_joints(structure: Structure) -> dict[str, SlowDrive]:
    """Of bodies on joints in a tree, to 1 %."""
    structures, found = ensemble([structure]), dict[str, SlowDrive]()
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
        found[transition.name] = SlowDrive(least=None if math.isnan(least) else least)
        held = bool(at_goal(structures, before.position, goal_of(structure, transition.released))[0])
    return found
