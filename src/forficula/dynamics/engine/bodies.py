"""Bodies in the engine: bars, plates and nodes, their hinges, slides and motors, and their points."""

from __future__ import annotations

import math
from collections.abc import Sequence

import mujoco
import numpy as np

from forficula.dynamics.energies.creases import is_followed_joint
from forficula.dynamics.engine.contact import BARS, set_contact
from forficula.dynamics.engine.stops import FRICTION_IMPEDANCE, STOP_IMPEDANCE, stop_reference
from forficula.dynamics.stepping.folds import slide_name
from forficula.pattern.geometry import polygon_normal
from forficula.structure import GROUND, Bar, Body, Hinge, Motor, Plate, Structure, mass_of

# share of a bar that counts as the whole bar, to allow for rounding
_WHOLE = 1 - 1e-6
# site whose axes define the directions of forces on plates
GROUND_SITE = "ground"


def add_bodies(spec: mujoco.MjSpec, structure: Structure) -> None:
    """Add the bodies of a structure in a model's units, with hinges and motors.

    Args:
        spec: specification of the engine's model.
        structure: in the model's units.
    """
    bodies: list[mujoco.MjsBody] = []
    for body in structure.bodies:
        frame = np.zeros(4)
        mujoco.mju_mat2Quat(frame, body.frame.ravel())
        parent = spec.worldbody if body.parent == GROUND else bodies[body.parent]
        bodies.append(parent.add_body(name=body.name, pos=body.position, quat=frame))
        if body.turns:
            bodies[-1].add_joint(name=body.name, type=mujoco.mjtJoint.mjJNT_FREE)
        elif body.slides:
            _add_node(bodies[-1], body)
    for closure in structure.closures:
        _add_mass(bodies[closure.bodies[1]], closure.bodies[1], structure)
    for number in sorted({mass.body for mass in structure.masses}):
        # carried masses are not part of the shape
        _add_mass(bodies[number], number, structure)
    for bar in structure.bars:
        _add_bar(bodies[bar.body], bar, structure)
    for plate in structure.plates:
        _add_plate(spec, bodies[plate.body], plate, structure)
    for number in engine_sites(structure):
        point = structure.points[number]
        body = spec.worldbody if point.body == GROUND else bodies[point.body]
        body.add_site(name=point.name, pos=point.place)
    driven = {number: motor for motor in structure.motors for number in motor.hinges}
    for number, hinge in enumerate(structure.hinges):
        if hinge.flaps:
            continue
        _add_hinge(bodies[hinge.body], hinge, structure)
        if number in driven:
            _add_motor(spec, hinge, driven[number].no_load_speed)
    if has_turning_bodies(structure) and any(motor.points for motor in structure.motors):
        spec.worldbody.add_site(name=GROUND_SITE)
    for motor in structure.motors:
        if motor.points:
            _add_force(spec, motor, structure)


def has_turning_bodies(structure: Structure) -> bool:
    """Return whether bodies turn, so that a force on a point of a body needs a site there; nodes only slide."""
    return bool(structure.plates or structure.bars)


def engine_sites(structure: Structure) -> list[int]:
    """Return the numbers of points that need a site: those away from body origins, and ends of tendons."""
    pairs = [spring.points for spring in structure.springs]
    pairs += [*(tendon.points for tendon in structure.tendons), *(limit.points for limit in structure.limits)]
    pairs += [measure.points for measure in structure.measures if measure.points is not None]
    pairs += [pair for closure in structure.closures for pair in closure.points]
    ends = {number for pair in pairs for number in pair}
    ends |= {hold.point for hold in structure.holds}
    if has_turning_bodies(structure):
        ends |= {number for motor in structure.motors for number in motor.points}
    return [number for number, point in enumerate(structure.points) if point.place.any() or number in ends]


def _add_node(added: mujoco.MjsBody, body: Body) -> None:
    """Let a body without a shape slide; its inertia is arbitrary, because it never turns."""
    added.explicitinertial = True
    added.mass, added.inertia = body.mass, [body.mass] * 3
    for axis in body.slides:
        added.add_joint(name=slide_name(body.name, axis), type=mujoco.mjtJoint.mjJNT_SLIDE, axis=np.eye(3)[axis])


def _add_bar(body: mujoco.MjsBody, bar: Bar, structure: Structure) -> None:
    """Add a cylinder for the mass and, for contact, a capsule without mass, whose contacts have closed forms."""
    size = [bar.diameter / 2, 0, 0]
    body.add_geom(
        type=mujoco.mjtGeom.mjGEOM_CYLINDER,
        density=bar.density,
        contype=0,
        conaffinity=0,
        size=size,
        fromto=[0, 0, 0, *bar.end],
    )
    share = bar.overlaps / float(np.linalg.norm(bar.end))
    # without a capsule if only the end of the bar would touch
    if structure.contact is not None and share < _WHOLE:
        place = [*share * bar.end, *bar.end]
        capsule = body.add_geom(type=mujoco.mjtGeom.mjGEOM_CAPSULE, density=0, size=size, fromto=place)
        capsule.contype = capsule.conaffinity = BARS
        set_contact(capsule, bar.diameter, structure.contact)


def _add_plate(spec: mujoco.MjSpec, body: mujoco.MjsBody, plate: Plate, structure: Structure) -> None:
    """Give a body the mass of a plate, and a shape for viewers without mass and contact."""
    _add_mass(body, plate.body, structure)
    corners = np.array([structure.points[point].place for point in plate.points])
    normal = polygon_normal(corners)
    half = plate.thickness / 2 * normal / np.linalg.norm(normal)
    solids = [np.array([structure.points[point].place for point in solid]) for solid in plate.solids]
    for number, solid in enumerate(solids or [np.concatenate([corners + half, corners - half])]):
        # the engine takes the convex hull
        name = f"{body.name}_{number}" if number else body.name
        shape = spec.add_mesh(name=name, uservert=solid.ravel())
        # as a shell, because a thin plate has almost no volume
        shape.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL
        body.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname=name, mass=0, contype=0, conaffinity=0)


def _add_mass(body: mujoco.MjsBody, number: int, structure: Structure) -> None:
    """Give a body its mass and inertia."""
    mass, centre, inertia = mass_of(structure, number)
    body.explicitinertial = True
    body.mass, body.ipos = mass, centre
    body.fullinertia = [inertia[row, column] for row, column in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]


def _add_hinge(body: mujoco.MjsBody, hinge: Hinge, structure: Structure) -> None:
    stops = structure.stops
    limited = math.isfinite(hinge.lower) or math.isfinite(hinge.upper)
    low, high = hinge.lower, hinge.upper
    joint = body.add_joint(
        name=hinge.name,
        type=mujoco.mjtJoint.mjJNT_HINGE,
        axis=hinge.axis,
        damping=[hinge.damping, 0, 0],
        armature=hinge.armature,
        frictionloss=hinge.friction,
        solref_friction=[stops.time_constant, 1],
        solimp_friction=FRICTION_IMPEDANCE,
        limited=limited,
        ref=hinge.sense * hinge.built,
        range=[0, 0] if not limited else [low, high] if hinge.sense > 0 else [-high, -low],
        solref_limit=stop_reference(stops),
        solimp_limit=STOP_IMPEDANCE,
    )
    if is_followed_joint(hinge, structure):
        # the stiffness of fast turns, for the choice of the timestep; see `JointSprings`
        joint.stiffness = [hinge.stiffness + sum(branch.stiffness for branch in hinge.branches), 0, 0]
        joint.springref = hinge.sense * hinge.rest_angle
    elif hinge.stiffness:
        # of the two springs in parallel of a joint that yields, this is the one that yields; see `add_hardening`
        yields = math.isfinite(hinge.yield_angle)
        nonlinear = [0.0, 0.0] if yields else [hinge.sense * hinge.quadratic, hinge.cubic]
        joint.stiffness = [hinge.stiffness - hinge.hardening, *nonlinear]
        joint.springref = hinge.sense * hinge.rest_angle
        if yields:
            joint.springyield = hinge.yield_angle


def add_hardening(spec: mujoco.MjSpec, structure: Structure) -> None:
    """Add the elastic springs that act beside the springs of joints that yield; see `CreaseLaw`."""
    for hinge in structure.hinges:
        elastic = [hinge.hardening, hinge.sense * hinge.quadratic, hinge.cubic]
        yields = math.isfinite(hinge.yield_angle) and not is_followed_joint(hinge, structure)
        if hinge.flaps is None and yields and any(elastic):
            spring = spec.add_tendon(name=f"{hinge.name}_hardening", stiffness=elastic)
            rest = hinge.sense * hinge.rest_angle
            spring.springlength = [rest, rest]
            spring.wrap_joint(hinge.name, 1.0)


def _add_motor(spec: mujoco.MjSpec, hinge: Hinge, no_load_speed: float) -> None:
    motor = spec.add_actuator(
        name=hinge.name, target=hinge.name, trntype=mujoco.mjtTrn.mjTRN_JOINT, gear=[hinge.sense, 0, 0, 0, 0, 0]
    )
    motor.set_to_motor()
    if math.isfinite(no_load_speed):
        # reduction of the torque with speed; its control is the magnitude of the torque
        brake = spec.add_actuator(name=brake_name(hinge), target=hinge.name, trntype=mujoco.mjtTrn.mjTRN_JOINT)
        brake.gear = [hinge.sense, 0, 0, 0, 0, 0]
        brake.gaintype, brake.biastype = mujoco.mjtGain.mjGAIN_AFFINE, mujoco.mjtBias.mjBIAS_NONE
        brake.gainprm[:3] = [0.0, 0.0, -1 / no_load_speed]


def brake_name(hinge: Hinge) -> str:
    """Return the engine's name of the actuator that reduces a motor's torque with the speed of a hinge."""
    return f"{hinge.name}_brake"


def force_name(motor: str) -> str:
    """Return the engine's name of the force of a motor."""
    return f"force_{motor}"


def _add_force(spec: mujoco.MjSpec, motor: Motor, structure: Structure) -> None:
    """Add a force in one direction at points: at sites of bodies that turn, or on a tendon that measures shifts."""
    name, direction = force_name(motor.name), motor.direction
    if direction is None:
        return
    if has_turning_bodies(structure):
        for point in motor.points:
            force = spec.add_actuator(name=f"{name}_{point}", target=structure.points[point].name)
            force.trntype, force.refsite = mujoco.mjtTrn.mjTRN_SITE, GROUND_SITE
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
    spec: mujoco.MjSpec, name: str, direction: np.ndarray, structure: Structure, points: Sequence[int]
) -> None:
    """Add a tendon whose length is the sum of the shifts of nodes along a direction."""
    tendon = spec.add_tendon(name=name)
    for point in points:
        body = structure.bodies[structure.points[point].body]
        for axis in body.slides:
            if direction[axis]:
                tendon.wrap_joint(slide_name(body.name, axis), direction[axis])


def servo_names(motor: Motor) -> list[tuple[str, str]]:
    """Return the engine's names of both parts of the servo of each point that a motor displaces."""
    names = [f"{force_name(motor.name)}_{point}" for point in motor.points]
    return [(name, f"{name}_hold") for name in names if motor.kind == "displacement"]


def _add_servo(spec: mujoco.MjSpec, motor: Motor, structure: Structure, point: int, damping: float) -> None:
    """Add a servo that pushes a node with k (target - shift) - c speed: k target, and the rest times a switch."""
    assert motor.direction is not None
    target, hold = servo_names(motor)[motor.points.index(point)]
    _add_displacement(spec, target, motor.direction, structure, [point])
    for name, gains in ((target, (motor.stiffness,)), (hold, (0.0, -motor.stiffness, -damping))):
        push = spec.add_actuator(name=name, target=target, trntype=mujoco.mjtTrn.mjTRN_TENDON)
        push.gaintype, push.biastype = mujoco.mjtGain.mjGAIN_AFFINE, mujoco.mjtBias.mjBIAS_NONE
        push.gainprm[: len(gains)] = gains
