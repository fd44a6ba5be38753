"""Motors in the engine: torques on joints, forces on points and servos, and the controls that drive them."""

from __future__ import annotations

import math
from collections.abc import Sequence

import mujoco
import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics.engine.parts import has_turning_bodies, part_indices
from forficula.dynamics.engine.placement import Placement, placement_of
from forficula.dynamics.stepping.folds import slide_name
from forficula.structure import Hinge, Motor, Structure

# site whose axes define the directions of forces on plates
_GROUND_SITE = "ground"


def add_motors(spec: mujoco.MjSpec, structure: Structure) -> None:
    """Add the motors of a structure, whose bodies and hinges the specification has; see `add_bodies`."""
    driven = {number: motor for motor in structure.motors for number in motor.hinges}
    for number, hinge in enumerate(structure.hinges):
        if number in driven and not hinge.flaps:
            _add_motor(spec, hinge, driven[number].no_load_speed)
    if has_turning_bodies(structure) and any(motor.points for motor in structure.motors):
        spec.worldbody.add_site(name=_GROUND_SITE)
    for motor in structure.motors:
        if motor.points:
            _add_force(spec, motor, structure)


def _add_motor(spec: mujoco.MjSpec, hinge: Hinge, no_load_speed: float) -> None:
    motor = spec.add_actuator(
        name=hinge.name, target=hinge.name, trntype=mujoco.mjtTrn.mjTRN_JOINT, gear=[hinge.sense, 0, 0, 0, 0, 0]
    )
    motor.set_to_motor()
    if math.isfinite(no_load_speed):
        # reduction of the torque with speed; its control is the magnitude of the torque
        brake = spec.add_actuator(name=_brake_name(hinge), target=hinge.name, trntype=mujoco.mjtTrn.mjTRN_JOINT)
        brake.gear = [hinge.sense, 0, 0, 0, 0, 0]
        brake.gaintype, brake.biastype = mujoco.mjtGain.mjGAIN_AFFINE, mujoco.mjtBias.mjBIAS_NONE
        brake.gainprm[:3] = [0.0, 0.0, -1 / no_load_speed]


def _brake_name(hinge: Hinge) -> str:
    """Return the engine's name of the actuator that reduces a motor's torque with the speed of a hinge."""
    return f"{hinge.name}_brake"


def _force_name(motor: str) -> str:
    """Return the engine's name of the force of a motor."""
    return f"force_{motor}"


def _add_force(spec: mujoco.MjSpec, motor: Motor, structure: Structure) -> None:
    """Add a force in one direction at points: at sites of bodies that turn, or on a tendon that measures shifts."""
    name, direction = _force_name(motor.name), motor.direction
    if direction is None:
        return
    if has_turning_bodies(structure):
        for point in motor.points:
            force = spec.add_actuator(name=f"{name}_{point}", target=structure.points[point].name)
            force.trntype, force.refsite = mujoco.mjtTrn.mjTRN_SITE, _GROUND_SITE
            force.gear = [*direction, 0, 0, 0]
            force.set_to_motor()
        return
    if motor.kind == "displacement":
        for point, damping in zip(motor.points, motor.damping, strict=True):
            _add_servo(spec, motor, structure, point, damping)
        return
    _add_displacement(spec, name, direction, structure, motor.points)
    force = spec.add_actuator(name=name, target=name, trntype=mujoco.mjtTrn.mjTRN_TENDON)
    force.set_to_motor()


def _add_displacement(
    spec: mujoco.MjSpec, name: str, direction: Array, structure: Structure, points: Sequence[int]
) -> None:
    """Add a tendon whose length is the sum of the shifts of nodes along a direction."""
    tendon = spec.add_tendon(name=name)
    for point in points:
        body = structure.bodies[structure.points[point].body]
        for axis in body.slides:
            if direction[axis]:
                tendon.wrap_joint(slide_name(body.name, axis), direction[axis])


def _servo_names(motor: Motor) -> list[tuple[str, str]]:
    """Return the engine's names of both parts of the servo of each point that a motor displaces."""
    names = [f"{_force_name(motor.name)}_{point}" for point in motor.points]
    return [(name, f"{name}_hold") for name in names if motor.kind == "displacement"]


def _add_servo(spec: mujoco.MjSpec, motor: Motor, structure: Structure, point: int, damping: float) -> None:
    """Add a servo that pushes a node with k (target - shift) - c speed: k target, and the rest times a switch."""
    assert motor.direction is not None
    target, hold = _servo_names(motor)[motor.points.index(point)]
    _add_displacement(spec, target, motor.direction, structure, [point])
    for name, gains in ((target, (motor.stiffness,)), (hold, (0.0, -motor.stiffness, -damping))):
        push = spec.add_actuator(name=name, target=target, trntype=mujoco.mjtTrn.mjTRN_TENDON)
        push.gaintype, push.biastype = mujoco.mjtGain.mjGAIN_AFFINE, mujoco.mjtBias.mjBIAS_NONE
        push.gainprm[: len(gains)] = gains


def followed_motors(engine: mujoco.MjModel, structure: Structure) -> Indices:
    """Return the number of the motor that each control of the engine follows, (control,), or -1."""
    follows = np.full(engine.nu, -1, dtype=np.int64)
    for number, motor in enumerate(structure.motors):
        names = [structure.hinges[hinge].name for hinge in motor.hinges if not structure.hinges[hinge].flaps]
        force = _force_name(motor.name)
        on_plates = [f"{force}_{point}" for point in motor.points] if has_turning_bodies(structure) else []
        served = [target for target, _ in _servo_names(motor)]
        names += served or on_plates or ([force] if motor.points else [])
        follows[part_indices(engine, mujoco.mjtObj.mjOBJ_ACTUATOR, names)] = number
    return follows


def pushed_bodies(structure: Structure) -> Placement | None:
    """Return the placement of bodies that turn if forces act at points; None without such forces."""
    pushes = has_turning_bodies(structure) and any(motor.points for motor in structure.motors)
    return placement_of(structure) if pushes else None


def force_displacements(engine: mujoco.MjModel, structure: Structure) -> Array:
    """Return the displacement of every force's points along it per shift of each coordinate, (motor, dof)."""
    pushed = np.zeros((len(structure.motors), engine.nv))
    for number, motor in enumerate(structure.motors):
        if motor.direction is None or has_turning_bodies(structure):
            continue
        for point in motor.points:
            pushed[number] += _displacement_weights(engine, structure, point, motor.direction)
    return pushed


def _displacement_weights(engine: mujoco.MjModel, structure: Structure, point: int, direction: Array) -> Array:
    """Return the displacement of a node along a direction per shift of each coordinate, (dof,)."""
    weights, body = np.zeros(engine.nv), structure.bodies[structure.points[point].body]
    names = [slide_name(body.name, axis) for axis in body.slides]
    weights[engine.jnt_dofadr[part_indices(engine, mujoco.mjtObj.mjOBJ_JOINT, names)]] = direction[list(body.slides)]
    return weights


def servos_of(engine: mujoco.MjModel, structure: Structure) -> tuple[Indices, Array]:
    """Return `Model.holds`, and `Model.jacobian` of servos."""
    holds, jacobian = np.full(engine.nu, -1, dtype=np.int64), np.zeros((engine.nu, engine.nv))
    for number, motor in enumerate(structure.motors):
        for point, names in zip(motor.points, _servo_names(motor), strict=False):
            assert motor.direction is not None
            parts = part_indices(engine, mujoco.mjtObj.mjOBJ_ACTUATOR, list(names))
            jacobian[parts] = _displacement_weights(engine, structure, point, motor.direction)
            holds[parts[1]] = number
    return holds, jacobian


def brakes_of(engine: mujoco.MjModel, structure: Structure) -> tuple[Indices, Array]:
    """Return `Model.brakes`, and `Model.jacobian` of brakes."""
    brakes, jacobian = np.full(engine.nu, -1, dtype=np.int64), np.zeros((engine.nu, engine.nv))
    for number, motor in enumerate(structure.motors):
        hinges = [structure.hinges[hinge] for hinge in motor.hinges if not structure.hinges[hinge].flaps]
        if np.isfinite(motor.no_load_speed) and hinges:
            controls = part_indices(engine, mujoco.mjtObj.mjOBJ_ACTUATOR, [_brake_name(hinge) for hinge in hinges])
            joints = part_indices(engine, mujoco.mjtObj.mjOBJ_JOINT, [hinge.name for hinge in hinges])
            brakes[controls] = number
            jacobian[controls, engine.jnt_dofadr[joints]] = [hinge.sense for hinge in hinges]
    return brakes, jacobian
