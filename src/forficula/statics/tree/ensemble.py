"""Structures of bodies on joints in a tree, laid out side by side for the static solver.

Coordinates are the angles of the structure's joints, in its order, each in its own sense. Creases between flaps follow
the joints in the structure. Their angles depend on those of the joints, see
`forficula.statics.tree.potential.hinge_angles`.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from forficula.arrays import Array, Indices
from forficula.design import Design, key_value
from forficula.errors import InputError
from forficula.material import ElasticLaw
from forficula.statics.path_dependence import refuse_rest_angles
from forficula.statics.tree.couplings import Ties, Twists, ties_of, twists_of
from forficula.statics.tree.flaps import Flaps, flaps_of
from forficula.statics.tree.forces import PointForces, point_forces_of
from forficula.statics.tree.hinge import TendonHinge, hinges_in_own_senses, stacked_hinges
from forficula.statics.tree.hinge_memory import HingeMemory, hinge_memory_of
from forficula.statics.tree.lines import Lines, largest_pull, lines_of
from forficula.statics.tree.planes import TreePlanes, tree_planes
from forficula.statics.tree.pose import Span, span, tree_of
from forficula.statics.tree.sheet import Sheet, sheet_of
from forficula.statics.tree.springs import Springs, pins_of, springs_of
from forficula.statics.tree.weight import Weight, weight_of
from forficula.structure import Motor, Structure, joint_count, static_keys, structure_of

# torque that counts as zero, as a share of the largest torque of the stiffest part, also where springs couple joints
_QUIET, _QUIET_COUPLED = 1e-6, 1e-9


@dataclass(frozen=True, kw_only=True)
class Ensemble:
    """Structures that differ only in their tendons, side by side, as the static solver uses them.

    Attributes:
        structure: of the first case; its tendons are those of the first case only.
        sheet: membranes and length limits.
        lines: tendons across several hinges; None if there are none.
        springs: springs between points; None if there are none.
        flaps: creases between flaps; None if there are none.
        pins: of closures; None if there are none.
        weight: of the bodies; None without gravity.
        planes: of a table and of supports of points; None if there are none.
        forces: of motors at points; None if there are none.
        twists: elastic couplings between joints; None if there are none.
        ties: groups of joints that rigid couplings tie together; None if there are none.
        crossed: numbers of the hinges that single tendons lie across, by tendon.
        crossings: incidence of these tendons and hinges, (tendon, hinge).
        tendons: the hinges of these tendons as one object whose functions take angles (case, tendon); its numbers are
            (case, tendon), or (1, tendon) if all cases have the same tendons.
        stiffness: of the hinges' springs, N m/rad, (hinge,).
        rest_angles: of the hinges' springs, rad, (hinge,).
        quadratic: quadratic terms of their moments over the angle from rest, N m/rad^2, (hinge,).
        cubic: cubic terms, N m/rad^3, (hinge,).
        motors: numbers of the joints of every motor.
        gains: torque on each of these joints per setting of every motor, (joint,); None if all are 1.
        drives: weights with which settings of motors add up to torques on joints, (motor, hinge).
        crease_drives: weights with which settings of motors add up to torques on creases, (motor, crease).
        lower: least angles, rad, (hinge,).
        upper: largest angles, rad, (hinge,).
        cases: number of cases.
        memory: of the hinges at the beginning of a motion; None if no hinge remembers anything.
    """

    structure: Structure
    sheet: Sheet
    lines: Lines | None
    springs: Springs | None
    flaps: Flaps | None
    pins: Springs | None
    weight: Weight | None
    planes: TreePlanes | None
    forces: PointForces | None
    twists: Twists | None
    ties: Ties | None
    crossed: Span
    crossings: Array
    tendons: TendonHinge
    stiffness: Array
    rest_angles: Array
    quadratic: Array
    cubic: Array
    motors: tuple[Span, ...]
    gains: tuple[Array | None, ...]
    drives: Array
    crease_drives: Array
    lower: Array
    upper: Array
    cases: int
    memory: HingeMemory | None = None

    @property
    def size(self) -> int:
        """Return the number of joints."""
        return len(self.lower)

    @property
    def coupled(self) -> bool:
        """Return whether springs between points, creases between flaps, closures or supports couple the joints."""
        return self.supported or any(part is not None for part in (self.springs, self.flaps, self.pins))

    @property
    def supported(self) -> bool:
        """Return whether supports hold points of the bodies."""
        return self.planes is not None and bool(self.planes.planes.fixed.any())

    def only(self, cases: Indices) -> Ensemble:
        """Select cases by index; repeats are allowed."""
        memory = None if self.memory is None else self.memory.only(cases)
        if len(np.asarray(self.tendons.proximal_arm)) == 1:
            return replace(self, cases=len(cases), memory=memory)
        lines = None if self.lines is None else self.lines.only(cases)
        return replace(self, tendons=_rows(self.tendons, cases), lines=lines, cases=len(cases), memory=memory)

    def repeated(self, count: int) -> Ensemble:
        """Return copies of the first case."""
        return replace(self.only(np.zeros(1 if self.memory is None else count, dtype=np.int64)), cases=count)

    def beginning(self, memory: Array | None, angles: Array, time: float = 0.0) -> Ensemble:
        """Return the structures when a motion begins with a memory of the hinges, (slot, case, hinge).

        Args:
            memory: at the beginning; None for that of the structures.
            angles: of the joints at the beginning, rad, (case, joint).
            time: duration of the motion, s.
        """
        if memory is None or self.memory is None:
            return self
        return replace(self, memory=self.memory.beginning(memory, angles, time))

    def new(self, angles: Array) -> Ensemble:
        """Return the structures with new hinges that start at the angles of the joints, rad, (case, joint)."""
        return self if self.memory is None else replace(self, memory=self.memory.new(angles))

    def turned(self, angles: Array) -> Ensemble:
        """Return the structures after a motion in which each hinge turned in one sense: with the memory at its end.

        Args:
            angles: of the joints at the end, rad, (case, joint).
        """
        return self if self.memory is None else replace(self, memory=self.memory.turned(angles))


def ensemble_of(designs: Sequence[Design]) -> Ensemble:
    """Lay out designs that differ only in their tendons.

    Raises:
        InputError: the designs have other differences.
    """
    first = designs[0]
    for design in designs[1:]:
        differs = [key for key in static_keys(first) if key_value(design, key) != key_value(first, key)]
        if differs:
            whole = structure_of(first).appearance.whole
            raise InputError(
                f"{design.name}: need {whole}s that differ in their tendons only, got another {differs[0]}"
            )
    return ensemble([structure_of(design) for design in designs])


def ensemble(structures: Sequence[Structure], *, timed: bool = False) -> Ensemble:
    """Lay out structures that differ only in their tendons; all other values are taken from the first one.

    Args:
        structures: with the same hinges.
        timed: whether motions have durations, which Maxwell branches of hinges follow; otherwise they are relaxed.

    Raises:
        InputError: the tendons of another structure lie across other hinges, or bodies move without joints.
    """
    first, size = structures[0], joint_count(structures[0])
    _check_bodies(first)
    joints, crossed = first.hinges[:size], _crossed(first)
    for other in structures[1:]:
        if len(other.hinges) != len(first.hinges) or _crossed(other) != crossed:
            raise InputError(f"{other.name}: need structures that differ in their tendons' laws and places only")
    tree = tree_of(first)
    drives, flaps = _drive_weights(first), flaps_of(first, tree)
    return Ensemble(
        structure=first,
        sheet=sheet_of(first, tree),
        lines=lines_of(structures, tree),
        springs=springs_of(first, tree),
        flaps=flaps,
        pins=pins_of(first, tree, _stiffest(first)),
        weight=weight_of(first, tree),
        planes=tree_planes(first, tree),
        forces=point_forces_of(first, tree),
        twists=twists_of(first),
        ties=ties_of(first),
        crossed=span(crossed),
        crossings=np.eye(size)[crossed],
        tendons=stacked_hinges([hinges_in_own_senses(structure) for structure in structures]),
        stiffness=np.array([hinge.stiffness for hinge in joints]),
        rest_angles=np.array([hinge.rest_angle for hinge in joints]),
        quadratic=np.array([hinge.quadratic for hinge in joints]),
        cubic=np.array([hinge.cubic for hinge in joints]),
        motors=tuple(span([hinge for hinge in motor.hinges if hinge < size]) for motor in first.motors),
        gains=tuple(_gains(motor, weights, size) for motor, weights in zip(first.motors, drives, strict=True)),
        drives=drives[:, :size],
        crease_drives=drives[:, size:],
        lower=np.array([hinge.lower for hinge in joints]),
        upper=np.array([hinge.upper for hinge in joints]),
        cases=len(structures),
        memory=hinge_memory_of(first, size, flaps, len(structures), timed=timed),
    )


def _check_bodies(structure: Structure) -> None:
    """Check that joints make all moves of the bodies.

    Raises:
        InputError: a body slides or turns freely.
    """
    loose = [body.name for body in structure.bodies if body.slides or body.turns]
    if loose:
        raise InputError(
            f"{structure.name}: need bodies that only joints move, because the structure has joints in a tree, got"
            f" {', '.join(loose[:3])}{' and others' * (len(loose) > 3)}, which slide or turn freely; hold them by a"
            " support or join them to other bodies"
        )


def _drive_weights(structure: Structure) -> Array:
    """Return weights with which settings of motors add up to torques on hinges, (motor, hinge).

    A change of a linear spring's rest angle is equivalent to the torque stiffness x angle. A force at points has the
    weight 0, because its torques depend on the shape: see `forficula.statics.tree.forces`. A displacement of points has
    the weight 0, too: `forficula.statics.tree.quasi_static.check_drive` refuses it.
    """
    weights = np.zeros((len(structure.motors), len(structure.hinges)))
    stiffness = np.array([hinge.stiffness for hinge in structure.hinges])
    refuse_rest_angles(structure)
    for row, motor in zip(weights, structure.motors, strict=True):
        hinges = list(motor.hinges)
        per_setting = stiffness[hinges] if motor.kind == "rest-angle" else np.ones(len(hinges))
        np.add.at(row, hinges, per_setting * (np.array(motor.gains) if motor.gains else 1.0))
    return weights


def _gains(motor: Motor, weights: Array, size: int) -> Array | None:
    gains = weights[[hinge for hinge in motor.hinges if hinge < size]]
    return None if np.all(gains == 1) else gains


def _stiffest(structure: Structure) -> float:
    """Return the largest torque of a joint, a crease, a spring, a tendon or a membrane per angle, N m/rad."""
    stretching = [spring.stiffness for spring in structure.springs]
    stretching += [float(tendon.law.elastic.stiffness(tendon.longest)) for tendon in structure.tendons]
    turning = [hinge.stiffness for hinge in structure.hinges]
    torques = [*turning, *(stiffness * structure.span**2 for stiffness in stretching), sheet_torque(structure)]
    return max(torques) or 1.0


def _crossed(structure: Structure) -> list[int]:
    return [tendon.crossing.hinge for tendon in structure.tendons if tendon.crossing is not None]


def _rows(tendons: TendonHinge, cases: Indices) -> TendonHinge:
    """Select rows of stacked hinges."""
    law: Any = {name: getattr(tendons.law, name)[cases] for name in ("rest_length", "linear", "quadratic", "cubic")}
    names = ("proximal_arm", "distal_arm", "axial_offset", "offset_angle", "overbend", "fold_limit", "inertia")
    numbers: Any = {name: getattr(tendons, name)[cases] for name in names}
    return TendonHinge(law=ElasticLaw(**law), **numbers)


def torque_scale(structures: Ensemble) -> float:
    """Return the order of magnitude of the torques of tendons, membranes, joints, creases, or weight, N m.

    Springs between points count only without these parts, because those of creases that open are much stiffer.
    """
    tendons = structures.tendons
    quarter = -np.pi / 2 - np.asarray(tendons.offset_angle)
    scales = [float(np.abs(tendons.moment(quarter)).max(initial=0.0)), sheet_torque(structures.structure)]
    if structures.lines is not None:
        scales.append(largest_pull(structures.lines, structures.structure))
    scales.append(float(structures.stiffness.max(initial=0.0)))
    if structures.weight is not None:
        scales.append(float(structures.weight.forces.sum()) * structures.structure.span)
    if structures.flaps is not None:
        scales.append(float(np.max(structures.flaps.law.stiffness)))
    if structures.springs is not None and not any(scales):
        return float(structures.springs.stiffness.max()) * structures.structure.span**2
    return max(scales)


def quiet_torque(structures: Ensemble) -> float:
    """Return the torque that counts as zero in the search for an equilibrium, N m.

    Where springs couple joints, parts of different mechanisms may be softer by orders of magnitude than the stiffest.
    """
    return (_QUIET_COUPLED if structures.coupled else _QUIET) * torque_scale(structures)


def slight_energy(structures: Ensemble) -> float:
    """Return the energy that counts as rounding, J: of the stiffest part under the torque that counts as zero."""
    return _QUIET**2 * torque_scale(structures)


def sheet_torque(structure: Structure) -> float:
    """Return the largest torque of a membrane's margin at a strain of 1, N m; 0 without a membrane."""
    return max(
        (membrane.law.youngs_modulus * membrane.law.thickness * membrane.margin**2 for membrane in structure.membranes),
        default=0.0,
    )


def start_angles(structures: Ensemble) -> Array:
    """Return the angles at which the protocol starts the hinges, rad, (case, hinge)."""
    joints = structures.structure.hinges[: structures.size]
    return np.tile([joint.start for joint in joints], (structures.cases, 1))
