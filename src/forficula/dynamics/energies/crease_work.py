"""Work of motors and dampers on creases and nodes, step by step."""

from __future__ import annotations

import math

import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics.engine.model import Model
from forficula.dynamics.engine.placement import Placement
from forficula.dynamics.stepping.steps import Steps
from forficula.material import CreaseLaw
from forficula.structure import Motor, Structure


def crease_works(
    model: Model, steps: Steps, place: int, travel: Array, efforts: Array, before: Array
) -> tuple[Array, Array, Array]:
    """Compute the works on a structure with creases in some steps, in the model's units.

    The work of a moving rest angle is the change of the energy of the spring. Because this energy is quadratic in the
    rest angle, it equals the mean moment of the spring, without locking and stops, times the change of the rest angle.

    Args:
        model: of the structure.
        steps: of several structures.
        place: index of the structure in the steps.
        travel: of its coordinates in each step, (step, dof).
        efforts: settings of its motors in each step, (step, motor).
        before: settings before each step, (step, motor).

    Returns:
        Work of every motor, (motor, step), of the creases' damping, (step,), and of their yielding, (step,).
    """
    assert model.creases is not None
    assert steps.angles is not None
    folds, creases = model.folds, model.creases
    position = np.concatenate([steps.position_before[place, None], steps.position[place, :-1]])
    block = np.arange(len(travel)) // steps.followed
    along = motor_travel(model, position, travel)
    damped = np.zeros(len(travel))
    speeds = turned = np.zeros((1, 1))
    if creases.damping.any() or any(math.isfinite(motor.no_load_speed) for motor in model.structure.motors):
        first = slice(0, None, steps.followed)
        velocity = np.concatenate([steps.velocity_before[place, None], steps.velocity[place, :-1]])
        speeds = folds.travel(position[first], velocity[first])[:, folds.creases]
        turned = folds.travel(position, travel)[:, folds.creases]
        damped = -np.sum((creases.damping * speeds)[block] * turned, axis=1)
    angles = steps.angles[place][block]
    rests, mean = model.settings(before)[0], model.settings((before + efforts) / 2)[0]
    sets, lost = _sets_and_loss(creases.law, steps, place, len(travel))
    moved = np.any(mean) or np.any(rests)
    moments = creases.law.rest_moment(angles, mean + sets[block]) if moved else np.zeros_like(angles)
    works = []
    for number, motor in enumerate(model.structure.motors):
        if motor.kind == "displacement":
            works.append(engine_work(model, number, steps, place, travel))
            continue
        if motor.kind != "rest-angle":
            works.append(efforts[:, number] * along[number])
            if math.isfinite(motor.no_load_speed):
                sizes = np.zeros_like(efforts)
                sizes[:, number] = np.abs(efforts[:, number])
                works[-1] -= np.sum(model.braking(sizes) * speeds[block] * turned, axis=1)
                works[-1] += engine_work(model, number, steps, place, travel)
            continue
        changes = np.zeros_like(efforts)
        changes[:, number] = efforts[:, number] - before[:, number]
        works.append(-np.sum(moments * model.settings(changes)[0], axis=1))
    return np.array(works).reshape(-1, len(travel)), damped, lost


def _sets_and_loss(law: CreaseLaw, steps: Steps, place: int, count: int) -> tuple[Array, Array]:
    """Return shifts of rest angles by sets, (block, crease) or zeros, and the work of yielding, <= 0, (step,).

    A set changes where a block of steps begins, so the work is that of the first step of the block.
    """
    lost = np.zeros(count)
    if not law.yields:
        return np.zeros((-(-count // steps.followed), 1)), lost
    assert steps.sets is not None
    assert steps.sets_before is not None
    sets = steps.sets[place]
    changes = np.diff(np.concatenate([steps.sets_before[place, None], sets]), axis=0)
    lost[:: steps.followed] = -np.sum(law.yield_loss(changes), axis=1)[: -(-count // steps.followed)]
    return law.rest_shift(sets), lost


def engine_work(model: Model, motor: int, steps: Steps, place: int, travel: Array) -> Array:
    """Compute the work of a motor's servos and brakes, whose forces the engine computes, (step,)."""
    holds = np.flatnonzero(model.holds == motor)
    parts = np.concatenate([holds, holds - 1, np.flatnonzero(model.brakes == motor)])
    if not len(parts):
        return np.zeros(len(travel))
    return np.asarray(np.sum(_engine_forces(steps, place, parts) * (travel @ model.jacobian[parts].T), axis=1))


def displacement_force(model: Model, motor: int, steps: Steps, place: int) -> Array:
    """Return the total force of a motor on the points that it displaces, in its direction, (step,)."""
    holds = np.flatnonzero(model.holds == motor)
    return np.asarray(_engine_forces(steps, place, np.concatenate([holds, holds - 1])).sum(axis=1))


def _engine_forces(steps: Steps, place: int, parts: Indices) -> Array:
    """Return the forces of some of the engine's actuators in each step, (step, part)."""
    forces = steps.derived["actuator_force"][place][:, parts]
    if steps.late is None:
        return np.asarray(forces)
    return np.asarray((forces + steps.late["actuator_force"][place][:, parts]) / 2)


def motor_travel(model: Model, position: Array, travel: Array) -> Array:
    """Compute the travel along each motor for small shifts of a structure's coordinates, (motor, ...).

    Args:
        model: of the structure; all values are in its units.
        position: start of the shifts, (..., dof).
        travel: shifts of the coordinates, (..., dof).

    Returns:
        Turn of the hinges of a torque, rad, weighted by their gains; displacement of a force's points along the force;
        0 for a rest angle or a displacement.
    """
    along = np.zeros((len(model.structure.motors), *travel.shape[:-1]))
    for number, motor in enumerate(model.structure.motors):
        if motor.kind == "torque":
            hinges = np.array(motor.hinges, dtype=np.int64)
            gains = np.array(motor.gains or (1.0,) * len(hinges))
            order = np.argsort(hinges)
            turned = model.folds.some(hinges[order]).travel(position, travel)
            along[number] = np.sum(gains[order] * turned, axis=-1)
        elif motor.kind == "force":
            along[number] = np.sum(model.pushed[number] * travel, axis=-1)
            if model.pushed_bodies is not None:
                along[number] = _body_displacements(model.in_units, model.pushed_bodies, motor, position, travel)
    return along


def _body_displacements(
    structure: Structure, placement: Placement, motor: Motor, position: Array, travel: Array
) -> Array:
    """Compute the displacement of points of bodies along a force for small shifts, (...)."""
    pose = placement.poses(position)
    moves, turns = placement.rates(pose, travel)
    bodies = [structure.points[point].body for point in motor.points]
    places = np.array([structure.points[point].place for point in motor.points])
    arms = (pose.frames[..., bodies, :, :] @ places[..., None])[..., 0]
    assert motor.direction is not None
    return np.asarray(
        np.sum((moves[..., bodies, :] + np.cross(turns[..., bodies, :], arms)) @ motor.direction, axis=-1)
    )
