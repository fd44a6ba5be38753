"""Remarks on the energy landscape of bodies on joints: its limits, and the reasons for its least drives."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from forficula.arrays import Array
from forficula.design import TORQUE, Design, stage_drives
from forficula.names import listed
from forficula.quantities import Unit, show_quantity, show_value
from forficula.statics.landscape import Rest
from forficula.statics.planes import table_friction_remarks
from forficula.statics.tree.ensemble import Ensemble
from forficula.statics.tree.hinge_landscape import CrossedHinge
from forficula.statics.tree.inertial_help import InertialHelp
from forficula.statics.tree.partial_folds import folding_hinges
from forficula.statics.tree.potential import largest_gap, largest_yield
from forficula.statics.tree.quasi_static import FIRST_STEP, SlowTransition, TorquePath
from forficula.structure import Structure, Transition, drive_of, drive_unit

_FORCE = Unit(display="N", si="N", example="5 N")
_STRAIGHT = math.radians(1)  # tolerance of straight
_YIELDS = math.radians(0.1)  # turn of a joint by yielding pins beyond which results are unreliable [chosen]
_ALIKE = 0.03  # relative difference below which torques count as equal


def tendon_remarks(structure: Structure, hinges: Sequence[CrossedHinge]) -> tuple[str, ...]:
    """Return remarks on the hinges of tendons: ideal ones, and true ones if only one of both is always slack.

    Remarks that apply only to some tendons begin with their names.
    """
    of: dict[str, list[str]] = {}
    for hinge in hinges:
        tendon, actual, ideal = structure.tendons[hinge.tendon], hinge.actual, hinge.ideal
        remarks = actual.remarks if ideal is None else ideal.remarks
        # the same remark on both would differ slightly in its angles
        if ideal is not None and ideal.hinge.pulls != actual.hinge.pulls:
            whose = structure.appearance.whole
            remarks = (*remarks, *(f"about the {whose}'s own hinge axes {remark}" for remark in actual.remarks))
        for remark in remarks:
            of.setdefault(remark, []).append(tendon.label or tendon.name)
    return tuple(
        remark if len(names) == len(hinges) else f"{', '.join(names)}: {remark}" for remark, names in of.items()
    )


def ignored_contact_remarks(structure: Structure) -> tuple[str, ...]:
    """Return the remark that statics of bodies on joints ignores contact; none without contact."""
    if structure.contact is None:
        return ()
    whole = structure.appearance.whole
    return (
        f"statics ignores contact of the bars and panels of this {whole}: they pass through each other; only runs"
        " include their contact",
    )


def table_remarks(structure: Structure) -> tuple[str, ...]:
    """Return remarks on the landscape of bodies on joints on a table; none without a table."""
    if structure.table is None:
        return ()
    left_out = "" if structure.rigid_fold is None else "energies along the rigid fold, "
    return (
        f"{left_out}partial folds and barriers of single hinges are not computed on a table, because their shapes may"
        ' be below the table; for a design with table = "none" they are computed',
        *table_friction_remarks(structure),
    )


def shared_remarks(structure: Structure) -> tuple[str, ...]:
    """Return remarks on tendons that the landscapes of single hinges leave out."""
    of: dict[int, list[str]] = {}
    for tendon in structure.tendons:
        if tendon.crossing is not None:
            of.setdefault(tendon.crossing.hinge, []).append(tendon.label or tendon.name)
    remarks = [
        f"{', '.join(names)} lie across one hinge, {structure.hinges[hinge].label or structure.hinges[hinge].name}:"
        " each landscape of this hinge includes one of them; all other results include all of them"
        for hinge, names in of.items()
        if len(names) > 1
    ]
    across = [tendon.label or tendon.name for tendon in structure.tendons if tendon.crossing is None]
    if across and of:
        remarks.append(f"the landscapes of single hinges leave out tendons across several hinges: {', '.join(across)}")
    return tuple(remarks)


def coupling_remarks(structures: Ensemble, hinges: Sequence[CrossedHinge], rests: Sequence[Rest]) -> tuple[str, ...]:
    """Return remarks on springs between points, creases between flaps, closures and supports of points."""
    remarks = list[str]()
    if structures.coupled and hinges:
        remarks.append(
            "the landscapes of single hinges leave out springs between points, creases between flaps, closures and"
            " supports of points"
        )
    if structures.pins is not None:
        angles = np.array([rest.angles[: structures.size] for rest in rests])
        gap, yields = largest_gap(structures, angles), largest_yield(structures, angles)
        remarks.append(
            "stiff pins close the loops of bodies; in the states where the structure rests they open by up to"
            f" {show_value(gap, 'm')}"
        )
        if yields > _YIELDS:
            remarks.append(
                "in states where the structure rests these pins yield by about"
                f" {math.degrees(yields):.2g} deg: angles and energies of these states are unreliable"
            )
    return tuple(remarks)


def yield_remarks(structures: Ensemble, name: str, path: TorquePath, torques: Array) -> tuple[str, ...]:
    """Return a remark if the pins of closures yield too far on a path; none without closures.

    Args:
        structures: the tree as the only case, at the start of the path.
        name: of the transition or drive.
        path: of the tree.
        torques: of all motors per size of the drive, (motor,).
    """
    if structures.pins is None:
        return ()
    resting = np.ones(len(path.torque), dtype=np.bool_)
    for first, last in path.snaps:
        resting[first + 1 : last] = False
    yields = largest_yield(structures, path.position[resting], path.torque[resting, None] * torques)
    if yields <= _YIELDS:
        return ()
    return (
        f'on the path under "{name}" the stiff pins that close the loops of bodies yield by about'
        f" {math.degrees(yields):.2g} deg: angles, torques and snaps of this path are unreliable",
    )


def stage_remarks(design: Design, structure: Structure) -> tuple[str, ...]:
    """Return a remark on driven stages between transitions that lead to no named state."""
    made = [transition.stage for transition in structure.transitions if transition.stage is not None]
    names = [
        f'"{stage.name}"'
        for number, stage in enumerate(design.protocol.stages)
        if made and number < max(made) and number not in made and stage_drives(stage)
    ]
    if not names:
        return ()
    return (
        f"statics leaves out the stages {listed(names)}, because they lead to no named state: later transitions start"
        " from the state before these stages",
    )


def start_remarks(structure: Structure, angles: Array) -> tuple[str, ...]:
    """Return a remark if a structure that is released flat does not stay flat.

    Args:
        structure: the structure.
        angles: of all hinges after the release, rad, (hinge,).
    """
    if structure.rigid_fold is None:
        return ()
    least = float(angles[list(structure.rigid_fold.folds)].min())
    if least >= -_STRAIGHT:
        return ()
    return (
        f"released flat, the compliant {structure.appearance.whole} does not stay flat: a hinge moves to"
        f" {math.degrees(least):.4g} deg; results for its flat state are for that shape",
    )


def slow_remarks(
    structure: Structure,
    transition: Transition,
    most: float,
    slow: SlowTransition | None,
    span: tuple[float, float] | None,
    helped: InertialHelp | None,
) -> tuple[str, ...]:
    """Return remarks if no slowly growing torque makes a transition, or if inertia may make it with less torque.

    Args:
        structure: the structure.
        transition: the transition.
        most: largest drive tried, in its SI unit.
        slow: result for the structure; None if it does not rest in the state that the transition starts from.
        span: least and largest torque of structures shifted slightly at their snaps, N m; None if none makes it.
        helped: a snap after which inertia may make it with less torque; None without such a snap.
    """
    unit = drive_unit(structure, drive_of(structure, transition.drive))
    noun, display = ("force", _FORCE) if unit == "N" else ("torque", TORQUE)
    verb, does = transition.wording.verb, transition.wording.does
    makes = f"makes it {verb}" if " " in verb else f"{does} it"
    if slow is None:
        before = _start_state(structure, transition)
        return (f'no slowly growing {noun} {makes} from the state "{before}", because it does not rest in this state',)
    if slow.torque[0] == 0:
        return (
            f'no {noun} is needed to {verb}: the goal of "{transition.name}" is already met in the state before it',
        )
    spread: tuple[str, ...] = ()
    if span is not None and span[1] > (1 + _ALIKE) * span[0]:
        low, high = (show_quantity(torque, display) for torque in span)
        whole, least = structure.appearance.whole, ""
        if math.isfinite(slow.torque[0]):
            least = f", {show_quantity(float(slow.torque[0]), display)},"
        further = f"to {high}" if math.isfinite(span[1]) else f"to more than {show_quantity(most, display)}"
        spread = (
            f"the least slow {noun} to {verb}{least} depends on small differences: with hinges shifted by 0.3 deg"
            f" where the {whole} begins to snap, it is {low} {further}, so inertia and imperfections decide",
        )
    if helped is not None:
        least, snap = (show_quantity(torque, display) for torque in (float(slow.torque[0]), helped.torque))
        whole, released, climb = structure.appearance.whole, helped.released, helped.barrier
        return (
            *spread,
            f"the least slow {noun} to {verb}, {least}, is an upper bound, because inertia may decide: at {snap} the"
            f" {whole} snaps and releases {show_value(released, 'J')}, and from there the slow path climbs"
            f" {show_value(climb, 'J')}; a run with protocol.rise computes whether less is enough",
        )
    if is_smallest(slow, most):
        return (
            *spread,
            f"the least slow {noun} to {verb} is at most {show_quantity(float(slow.torque[0]), display)}, the smallest"
            " one tried",
        )
    if not math.isnan(slow.torque[0]):
        return spread
    started = "" if transition is structure.transitions[0] else f" from {_start_state(structure, transition)}"
    folding = list(folding_hinges(structure))
    stopped = (
        f", the last hinge stops at {math.degrees(float(slow.position[0, folding].max())):.4g} deg" if folding else ""
    )
    if spread:
        return spread
    # a run may still make it
    inertia = f"{stopped}: it may still {verb} by inertia, which a run computes"
    return (f"no slowly growing {noun} up to {show_quantity(most, display)} {makes}{started}{inertia}",)


def is_smallest(slow: SlowTransition | None, most: float) -> bool:
    """Return whether a least drive is the smallest one tried."""
    return slow is not None and bool(0 < slow.torque[0] <= FIRST_STEP * most)


def withstood_remark(structure: Structure, transition: Transition, withstood: Array, most: float) -> str:
    """Return a remark on a drive that acts on a structure at its goal.

    Args:
        structure: the structure.
        transition: whose goal is met before it.
        withstood: sizes of the drive at which structures shifted slightly at their snaps leave the goal; inf for none.
        most: largest drive tried, in its SI unit.
    """
    drive, whole = drive_of(structure, transition.drive), structure.appearance.whole
    unit = drive_unit(structure, drive)
    low, high = float(withstood.min()), float(withstood.max())
    beyond = f"the largest one tried, {show_value(most, unit)}"
    if math.isinf(low):
        return f'the {whole} keeps the goal of "{transition.name}" under a slowly growing "{drive.name}" up to {beyond}'
    leaves = (
        f'under a slowly growing "{drive.name}" the {whole} leaves the goal of "{transition.name}" at'
        f" {show_value(low, unit)}"
    )
    if high <= (1 + _ALIKE) * low:
        return leaves
    end = f"to {show_value(high, unit)}" if math.isfinite(high) else f"to more than {beyond}"
    return (
        f"{leaves}; this depends on small differences: with hinges shifted by 0.3 deg where the {whole} begins to snap,"
        f" and with other steps of the drive, the range is from there {end}"
    )


def _start_state(structure: Structure, transition: Transition) -> str:
    """Return the name of the state from which a transition after the first one starts."""
    return structure.transitions[structure.transitions.index(transition) - 1].state
