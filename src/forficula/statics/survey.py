"""Energy landscape of any structure: the only module that chooses between the solvers for trees and for nets."""

from __future__ import annotations

import math
from collections.abc import Callable, Collection, Mapping
from dataclasses import dataclass, replace

from forficula.design import AnyDesign, Protocol, as_design, stage_drives
from forficula.errors import InputError
from forficula.names import one_of
from forficula.quantities import as_written
from forficula.statics.drag import DraggedPoint
from forficula.statics.landscape import EnergyLandscape
from forficula.statics.net.driven.net_drag import net_drag
from forficula.statics.net.driven.net_path import net_path
from forficula.statics.net.driven.net_rest import net_rest_path
from forficula.statics.net.net_landscape import Progress, net_landscape, slow_courses
from forficula.statics.net.net_of import is_net
from forficula.statics.path_dependence import (
    path_dependence,
    refuse_path_dependence,
    rest_angle_of_nonlinear,
)
from forficula.statics.planes import table_friction_remarks
from forficula.statics.quasi_static_path import QuasiStaticPath, QuasiStaticPoint
from forficula.statics.tree.ensemble import ensemble
from forficula.statics.tree.quasi_static import at_goal, least_slow_torque, start_state, state_after, state_beyond
from forficula.statics.tree.tree_drag import tree_drag
from forficula.statics.tree.tree_path import tree_path
from forficula.statics.tree.tree_rest import tree_rest_path
from forficula.statics.tree_landscape import tree_landscape
from forficula.statics.tree_remarks import ignored_contact_remarks
from forficula.structure import (
    Drive,
    GrowingLoad,
    RestPath,
    RestShape,
    Structure,
    Transition,
    drive_of,
    goal_of,
    structure_of,
)

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
    refuse_path_dependence(structure, "energy landscape")
    if is_net(structure):
        return net_landscape(design, structure, progress)
    return tree_landscape(design, structure, points)


def quasi_static_path(
    design: AnyDesign | Structure,
    transition: str | None = None,
    *,
    near: QuasiStaticPoint | None = None,
    error: float = 2e-3,
    follow: Callable[[QuasiStaticPath], bool] | None = None,
) -> QuasiStaticPath:
    """Compute the quasi-static path of a structure from rest to the goal of a transition.

    Args:
        design: the design, or its structure.
        transition: name of the transition; by default the first one, or the first drive of a structure without
            transitions.
        near: shape on the path of the design before its values changed, from `QuasiStaticPath.point`; the path is then
            computed from the equilibrium nearest to this shape at the same strength of the drive, first onwards to its
            end and then back to its start. A shape of a structure with other parts is ignored.
        error: largest distance between a point of the structure and its linear interpolation between points of the
            path, as a share of the structure's span.
        follow: called with the growing path, first as soon as two points are known, and then whenever the path has
            grown or has been refined noticeably; returns whether to go on. If it returns False, the path is returned as
            far as it is computed.

    Raises:
        InputError: the design cannot be built, it has no such transition, it has no drive, or the error is not above 0.
    """
    if not 0 < error <= 1:
        raise InputError(f"error: need a number above 0 and up to 1, got {error}")
    structure = design if isinstance(design, Structure) else structure_of(as_design(design))
    drive, made = _driven_transition(structure, transition)
    _check_rest_angles(structure, drive, "quasi-static path")
    if is_net(structure):
        path = net_path(structure, drive, made, error=error, near=near, follow=follow)
    else:
        path = tree_path(structure, drive, made, error=error, near=near, follow=follow)
    return replace(
        path,
        remarks=(
            *path.remarks,
            *_relaxed_remarks(structure),
            *_contact_remarks(structure),
            *table_friction_remarks(structure),
        ),
    )


def _relaxed_remarks(structure: Structure) -> tuple[str, ...]:
    """Return a remark on Maxwell branches of creases, which a path without time relaxes; none without branches."""
    relaxing = next((hinge for hinge in structure.hinges if hinge.branches), None)
    if relaxing is None:
        return ()
    name = relaxing.label or relaxing.name
    return (
        f"the path is infinitely slow, so the Maxwell branches of {name} are relaxed; a quasi-static stage has a time",
    )


def _contact_remarks(structure: Structure) -> tuple[str, ...]:
    """Return a remark on what a path ignores of the contact of a structure; none if it ignores nothing."""
    if structure.contact is None:
        return ()
    if not is_net(structure):
        return ignored_contact_remarks(structure)
    friction = structure.contact.friction
    return (f"statics ignores the friction of contact (contact.friction = {friction:g})",) if friction else ()


def stage_rest_path(structure: Structure, start: RestShape, load: GrowingLoad) -> RestPath:
    """Follow the equilibria of a structure in a quasi-static stage of a run.

    Args:
        structure: that `check_quasi_static` does not refuse.
        start: shape near an equilibrium.
        load: that grows evenly.
    """
    return (net_rest_path if is_net(structure) else tree_rest_path)(structure, start, load)


def check_quasi_static(structure: Structure, protocol: Protocol) -> None:
    """Refuse quasi-static stages of a structure that statics cannot compute.

    Raises:
        InputError: the protocol has such a stage; the message says why.
    """
    stages = [number for number, stage in enumerate(protocol.stages) if stage.quasi_static]
    names = {name for number in stages for name in stage_drives(protocol.stages[number])}
    reason = _why_not_quasi_static(structure, names) if stages else ""
    if reason:
        raise InputError(
            f'protocol.stages.{stages[0]}.motion: need "dynamic" for the stage "{protocol.stages[stages[0]].name}" of'
            f' {structure.name}, because {reason}; got "quasi-static"'
        )


def _why_not_quasi_static(structure: Structure, names: Collection[str]) -> str:
    """Return why statics cannot compute quasi-static stages with some drives, as a clause; empty if it can."""
    drives = [drive_of(structure, name) for name in names]
    motors = [
        motor for number, motor in enumerate(structure.motors) if any(drive.strengths[number] for drive in drives)
    ]
    laws = [tendon.law for tendon in structure.tendons]
    if any(law.branches for law in laws):
        return "the law of a tendon has Maxwell branches, whose force depends on time"
    if reason := rest_angle_of_nonlinear(structure):
        return reason
    if any(law.yield_extension is not None for law in laws):
        return "a tendon yields, and statics ignores permanent extensions"
    if (reason := path_dependence(structure)) and any(motor.kind == "rest-angle" for motor in motors):
        return f"a drive changes rest angles, and {reason}"
    if structure.contact is not None and not is_net(structure):
        return "statics ignores contact of its bars and panels"
    if structure.contact is not None and structure.contact.friction:
        return "statics ignores the friction of contact (contact.friction)"
    if structure.table is not None and structure.table.friction:
        return "statics ignores friction on the table (table.friction)"
    if any(hinge.friction for hinge in structure.hinges):
        return "hinges have dry friction, with which they rest anywhere in a range"
    if is_net(structure):
        displaced = structure.plates and any(motor.kind == "displacement" for motor in motors)
        return "a drive displaces points of plates" if displaced else ""
    if any(body.slides for body in structure.bodies) or structure.closures:
        return "its bodies slide or form loops"
    if any(motor.kind not in ("torque", "force") for motor in motors):
        return "a drive of its bodies on joints is neither a torque nor a force"
    return ""


def start_drag(
    design: AnyDesign | Structure,
    places: int | Mapping[int, float],
    near: QuasiStaticPoint | None = None,
    transition: str | None = None,
) -> DraggedPoint:
    """Prepare to drag a point of a structure quasi-statically: the structure is at rest at every position of the point.

    Args:
        design: the design, or its structure.
        places: number of a place in `QuasiStaticPath.positions`, or numbers with weights that add up to 1, such as
            those of a point on a panel.
        near: shape from which the drag starts, and strength of the drive; by default where the structure rests when
            released from the start of the protocol.
        transition: name of the transition whose drive acts; as for `quasi_static_path`.

    Raises:
        InputError: the design cannot be built, there is no such transition or place, the point cannot move, or the
            drive changes rest angles of creases that fold permanently or wear out.
    """
    structure = design if isinstance(design, Structure) else structure_of(as_design(design))
    if transition is None and not any(any(drive.strengths) for drive in structure.drives):
        shares = tuple(0.0 for _ in structure.motors)
        drive, made = Drive(name="none", shares=shares, rise=0.0, key="", strength=0.0), None
    else:
        drive, made = _driven_transition(structure, transition)
    _check_rest_angles(structure, drive, "point that can be dragged")
    if is_net(structure):
        return net_drag(structure, drive, made, places, near)
    return tree_drag(structure, drive, places, near)


def _check_rest_angles(structure: Structure, drive: Drive, results: str) -> None:
    """Refuse a drive that changes rest angles of a structure whose creases fold permanently or wear out.

    Raises:
        InputError: the drive changes rest angles, and a crease folds permanently or wears out.
    """
    if (reason := path_dependence(structure)) and any(
        setting and motor.kind == "rest-angle" for setting, motor in zip(drive.strengths, structure.motors, strict=True)
    ):
        raise InputError(
            f'{structure.name}: has no {results} under "{drive.name}", which changes rest angles, because {reason}; a'
            " run follows both"
        )


def _driven_transition(structure: Structure, name: str | None) -> tuple[Drive, Transition | None]:
    """Return a drive and the transition that it makes; None for a structure without transitions."""
    names = [transition.name for transition in structure.transitions]
    if name is not None and not names:
        raise InputError(
            f"transition: {structure.name} has none, because no driven stage ends at a goal and leads to a named state;"
            f" leave it out, got {as_written(name)}"
        )
    if name is not None and name not in names:
        raise InputError(f"transition: need {one_of(names, name)}")
    for transition in structure.transitions:
        if name is None or transition.name == name:
            return drive_of(structure, transition.drive), transition
    drives = [drive for drive in structure.drives if any(drive.strengths)]
    if not drives:
        raise InputError(f"{structure.name}: need a drive that folds it, because the path follows a growing drive")
    return drives[0], None


def slow_drives(structure: Structure) -> dict[str, SlowDrive]:
    """Compute the least slowly growing drive of every transition, by name, each from the end of the one before.

    Raises:
        InputError: a crease folds permanently or wears out.
    """
    refuse_path_dependence(structure, "least slow drives")
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
