"""Potential of a tree structure: all stored energies minus the work of acting torques and forces."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from forficula.arrays import Array, Flags
from forficula.statics.tree.couplings import twist_energy
from forficula.statics.tree.elements import Expansion
from forficula.statics.tree.ensemble import Ensemble, quiet_torque
from forficula.statics.tree.equilibrium import Cases, Enough, Equilibria, Follow, descend
from forficula.statics.tree.flaps import crease_angles, crease_energy, folded_energy
from forficula.statics.tree.forces import force_energy
from forficula.statics.tree.hinge_memory import HingeMemory
from forficula.statics.tree.lines import line_energy
from forficula.statics.tree.planes import plane_energy
from forficula.statics.tree.pose import Pose, pose
from forficula.statics.tree.sheet import sheet_energy
from forficula.statics.tree.springs import closure_gap, spring_energy
from forficula.statics.tree.weight import weight_energy
from forficula.structure import springs_name

# Steps in which a structure is followed: shorter ones end in the same equilibria.
_LONGEST_STEP = 0.1  # rad
_AT_STOP = 1e-9  # rad, distance from a stop


def potential(structures: Ensemble, angles: Array, torques: ArrayLike = 0.0) -> Expansion:
    """Compute the stored energy minus the work of the torques and forces.

    Args:
        structures: side by side.
        angles: rad, (case, hinge).
        torques: of every motor, N m, or N for a force, (motor,), or by case, (case, motor).

    Returns:
        Energy, J, (case,); gradient, N m, (case, hinge); Hessian, N m/rad, (case, hinge, hinge).
    """
    torques = np.asarray(torques)
    if torques.shape != (len(angles), len(structures.motors)):
        torques = np.broadcast_to(torques, (len(angles), len(structures.motors)))
    posed = structures.lines, structures.planes, structures.weight
    shares = structures.coupled or any(part is not None for part in posed)
    at = pose(structures.sheet.laid.tree, angles) if shares else None
    energy, slope, curvature = sheet_energy(structures.sheet, angles, at)
    for part in _optional_parts(structures, angles, torques, at):
        energy, slope, curvature = energy + part[0], slope + part[1], curvature + part[2]
    stored, diagonal = np.zeros(len(angles)), np.einsum("...ii->...i", curvature)  # a view of the diagonals
    pressing = -(torques @ structures.drives)
    if len(structures.crossings):
        stored, moment, stiffness = structures.tendons.expansion(angles[:, structures.crossed])
        stored = stored.sum(axis=1)
        pressing -= moment @ structures.crossings
        diagonal += stiffness @ structures.crossings
    for motor, (joints, gains) in enumerate(zip(structures.motors, structures.gains, strict=True)):
        turned = angles[:, joints] if gains is None else gains * angles[:, joints]
        stored -= torques[:, motor] * np.add.reduce(turned, axis=1)
    energy += stored
    slope += pressing
    if structures.memory is not None:
        folded, moment, stiffness = structures.memory.joint_expansion(angles)
        energy += folded.sum(axis=1)
        slope += moment
        diagonal += stiffness
    elif structures.stiffness.any():
        turned = structures.stiffness * (angles - structures.rest_angles)
        energy += np.sum(turned * (angles - structures.rest_angles), axis=1) / 2
        slope += turned
        diagonal += structures.stiffness
    if structures.memory is None and (structures.quadratic.any() or structures.cubic.any()):
        x, quadratic, cubic = angles - structures.rest_angles, structures.quadratic, structures.cubic
        energy += np.sum(x**3 * (quadratic / 3 + x * cubic / 4), axis=1)
        slope += x**2 * (quadratic + x * cubic)
        diagonal += x * (2 * quadratic + 3 * x * cubic)
    return energy, slope, curvature


def stored_energy(
    structures: Ensemble, angles: Array, further: ArrayLike = 0.0, memory: HingeMemory | None = None
) -> dict[str, Array]:
    """Compute the energy by the part that stores it, without parts that a structure does not have.

    Args:
        structures: side by side.
        angles: of the joints, rad, (case, joint); angles of creases may follow and are ignored.
        further: changes of the rest angles of all hinges of the structure, rad, (case, hinge).
        memory: of the hinges at these angles; None for none.

    Returns:
        Energies, J, (case,), of "tendons", "springs" of joints, "creases" between flaps, springs between points by the
        name of `springs_name`, elastic "couplings", "closures", which are stretched slightly, "membranes" with length
        limits, and "weight", which is 0 if all centres are at the height of the origin.
    """
    parts: dict[str, Array] = {}
    angles = angles[:, : structures.size]
    changes = np.broadcast_to(further, (len(angles), len(structures.structure.hinges)))
    of_memory = None if memory is None else memory.stored(angles, changes)
    if structures.structure.tendons:
        parts["tendons"] = structures.tendons.energy(angles[:, structures.crossed]).sum(axis=1)
        if structures.lines is not None:
            parts["tendons"] = parts["tendons"] + line_energy(structures.lines, angles)[0]
    if structures.stiffness.any() and of_memory is not None:
        parts["springs"] = of_memory[0]
    elif structures.stiffness.any():
        turned = angles - structures.rest_angles - changes[:, : structures.size]
        parts["springs"] = np.sum(structures.stiffness * turned**2, axis=1) / 2
        if structures.quadratic.any() or structures.cubic.any():
            x = angles - structures.rest_angles
            terms = x**3 * (structures.quadratic / 3 + x * structures.cubic / 4)
            parts["springs"] = parts["springs"] + np.sum(terms, axis=1)
    if structures.flaps is not None and structures.flaps.sprung:
        of_creases = None if of_memory is None else of_memory[1]
        further = changes[:, structures.size :]
        parts["creases"] = folded_energy(structures.flaps, angles, further) if of_creases is None else of_creases
    if structures.springs is not None:
        parts[springs_name(structures.structure)] = spring_energy(structures.springs, angles)[0]
    if structures.twists is not None:
        parts["couplings"] = twist_energy(structures.twists, angles)[0]
    if structures.pins is not None:
        parts["closures"] = spring_energy(structures.pins, angles)[0]
    if structures.structure.membranes or structures.structure.limits:
        parts["membranes"] = sheet_energy(structures.sheet, angles)[0]
    if structures.weight is not None:
        parts["weight"] = weight_energy(structures.weight, angles)[0]
    return parts


def _optional_parts(structures: Ensemble, angles: Array, torques: Array, at: Pose | None) -> list[Expansion]:
    """Compute the optional parts of the potential: tendons across several hinges, springs, creases and so on.

    The part of the creases includes the work of the torques of motors, (case, motor), on creases. The forces of motors
    at points are a part of their own.
    """
    parts = [] if structures.lines is None else [line_energy(structures.lines, angles, at)]
    parts += [
        spring_energy(springs, angles, at) for springs in (structures.springs, structures.pins) if springs is not None
    ]
    if structures.flaps is not None:
        turn = None if structures.memory is None else structures.memory.of_creases
        parts.append(crease_energy(structures.flaps, angles, torques @ structures.crease_drives, at, turn))
    if structures.twists is not None:
        parts.append(twist_energy(structures.twists, angles))
    if structures.forces is not None and torques.any():
        parts.append(force_energy(structures.forces, angles, torques))
    if structures.planes is not None:
        parts.append(plane_energy(structures.planes, angles, at))
    return parts if structures.weight is None else [*parts, weight_energy(structures.weight, angles, at)]


def rest(
    structures: Ensemble,
    start: Array,
    torques: ArrayLike = 0.0,
    *,
    fixed: Sequence[int] = (),
    held: ArrayLike = False,
    within: float = np.inf,
    longest_step: float | None = None,
    follow: Follow | None = None,
    enough: Enough | None = None,
    pull: Callable[[Array], Expansion] | None = None,
) -> Equilibria:
    """Let structures move slowly from given angles to where they rest under torques.

    Joints that rigid couplings tie together share one coordinate; if their start angles contradict each other, the mean
    is used. The returned gradient is by every hinge, as if the hinges were not tied.

    On a table or on supports of points, structures first move with springs that are a thousand times as soft, because
    the length of a step down the slope along the table is limited by its stiffness, and then with the stiff ones.

    Args:
        structures: side by side.
        start: angles, rad, (case, hinge).
        torques: of every motor, N m, or N for a force, (motor,), or by case, (case, motor).
        fixed: numbers of hinges that are held at their start angles in all cases.
        held: which hinges are held at their start angles, (case, hinge).
        within: largest turn of each hinge, rad.
        longest_step: rad; shorter steps follow the steepest descent more closely.
        follow: called after every step with the numbers of the cases that are not at rest and all angles.
        enough: returns which structures are not followed further, from angles, (row, hinge), and the numbers of their
            cases, (row,).
        pull: returns a further energy that acts on the structures, with gradient and Hessian by the angles; None for
            none.
    """
    count = len(start)
    torques = np.broadcast_to(torques, (count, len(structures.motors)))
    lower, upper = np.maximum(structures.lower, start - within), np.minimum(structures.upper, start + within)
    fixed = list(fixed)
    lower[:, fixed] = upper[:, fixed] = start[:, fixed]
    bounds = np.where(held, start, lower), np.where(held, start, upper)
    steps: Any = {"longest_step": longest_step or _LONGEST_STEP, "force": quiet_torque(structures)}
    steps |= {"follow": follow, "enough": enough}
    if structures.planes is not None:
        softened = replace(structures, planes=structures.planes.softened)
        start = _descended(softened, start, torques, bounds, pull, **steps).position
    return _descended(structures, start, torques, bounds, pull, **steps)


def _descended(
    structures: Ensemble,
    start: Array,
    torques: Array,
    bounds: tuple[Array, Array],
    pull: Callable[[Array], Expansion] | None,
    *,
    longest_step: float,
    force: float,
    follow: Follow | None,
    enough: Enough | None,
) -> Equilibria:
    """Follow the potential downhill to rest within bounds of the angles, both rad, (case, hinge); see `rest`."""
    some, ties = structures, structures.ties

    def energy(angles: Array, cases: Cases) -> Expansion:
        nonlocal some
        # cases come to rest one after another, so that as many cases are the same cases
        if len(cases) != some.cases:
            some = structures.only(cases)
        expansion = potential(some, angles, torques[cases])
        if pull is None:
            return expansion
        (value, slope, curvature), (more, steeper, stiffer) = expansion, pull(angles)
        return value + more, slope + steeper, curvature + stiffer

    if ties is None:
        return descend(energy, start, *bounds, longest_step=longest_step, force=force, follow=follow, enough=enough)
    spread = ties.spread

    def tied_energy(coordinates: Array, cases: Cases) -> Expansion:
        value, slope, curvature = energy(ties.angles(coordinates), cases)
        return value, slope @ spread, spread.T @ curvature @ spread

    def follow_tied(cases: Cases, coordinates: Array) -> None:
        if follow is not None:
            follow(cases, ties.angles(coordinates))

    def tied_enough(coordinates: Array, cases: Cases) -> Flags:
        assert enough is not None
        return enough(ties.angles(coordinates), cases)

    ended = None if enough is None else tied_enough
    result = descend(
        tied_energy,
        ties.start(start),
        *ties.bounds(*bounds),
        longest_step=longest_step,
        force=force,
        follow=follow_tied,
        enough=ended,
    )
    position = ties.angles(result.position)
    return replace(result, position=position, slope=energy(position, np.arange(len(start)))[1])


def hinge_angles(structures: Ensemble, angles: Array) -> Array:
    """Return the angles of all hinges of the structure, in their own senses, rad, (case, hinge).

    Args:
        structures: side by side.
        angles: of the joints, rad, (case, joint).
    """
    if structures.flaps is None:
        return angles
    return np.concatenate([angles, crease_angles(structures.flaps, angles)], axis=1)


def largest_yield(structures: Ensemble, angles: Array, torques: ArrayLike = 0.0) -> float:
    """Return the largest turn of a joint by which stiff pins of closures yield at equilibria, rad; 0 without closures.

    It is estimated by the step of Newton's method to the equilibrium at which the pins exert the same forces without
    being stretched. Joints at stops do not turn.

    Args:
        structures: the tree as the only case.
        angles: of the joints at equilibria, rad, (shape, joint).
        torques: of every motor, N m, or N for a force, (motor,), or by shape, (shape, motor).
    """
    if structures.pins is None or not len(angles):
        return 0.0
    repeated = structures.repeated(len(angles))
    slope, curvature = spring_energy(structures.pins, angles)[1], potential(repeated, angles, torques)[2]
    stopped = (angles <= structures.lower + _AT_STOP) | (angles >= structures.upper - _AT_STOP)
    largest = 0.0
    for row, free in enumerate(~stopped):
        spread = np.eye(structures.size)[:, free] if structures.ties is None else structures.ties.spread
        stiffness = spread.T @ curvature[row] @ spread
        turned = spread @ np.linalg.lstsq(stiffness, spread.T @ slope[row], rcond=None)[0]
        largest = max(largest, float(np.abs(turned).max(initial=0.0)))
    return largest


def largest_gap(structures: Ensemble, angles: Array) -> float:
    """Return the largest gap of closures in any case, m; 0 without closures."""
    tree = structures.sheet.laid.tree
    return float(closure_gap(structures.structure, tree, angles).max(initial=0.0))
