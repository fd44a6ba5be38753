"""Work that motors and dampers do on creases and nodes, step by step."""

from __future__ import annotations

import math

import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics.engine.model import Model
from forficula.dynamics.engine.placement import Placement
from forficula.dynamics.stepping.steps import Steps
from forficula.structure import Motor, Structure


def crease_works(
    model: Model, steps: Steps, place: int, travel: Array, efforts: Array, before: Array
) -> tuple[Array, Array]:
    """Works on a structure with creases in some steps, in the model's units.

    A rest angle that goes on does the work by which it changes the energy of the spring, which is a square of it: the
    mean moment of the spring, without what locks or stops the crease, times the way.

    Args:
        model: of the structure.
        steps: with its own.
        place: which of them.
        travel: of its coordinates in each step, (step, dof).
        efforts: what its motors are set to in each step, (step, motor).
        before: alike, before each step.

    Returns:
        Of every motor, (motor, step), and of the creases' damping, (step,).
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
    moments = creases.law.rest_moment(angles, mean) if np.any(mean) or np.any(rests) else np.zeros_like(angles)
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
        own = np.zeros_like(efforts)
        own[:, number] = efforts[:, number] - before[:, number]
        works.append(-np.sum(moments * model.settings(own)[0], axis=1))
    return np.array(works).reshape(-1, len(travel)), damped


def engine_work(model: Model, motor: int, steps: Steps, place: int, travel: Array) -> Array:
    """Work in some steps of a motor's servos and brakes, whose forces the engine finds, (step,)."""
    holds = np.flatnonzero(model.holds == motor)
    parts = np.concatenate([holds, holds - 1, np.flatnonzero(model.brakes == motor)])
    if not len(parts):
        return np.zeros(len(travel))
    return np.asarray(np.sum(_engine_forces(steps, place, parts) * (travel @ model.ways[parts].T), axis=1))


def displacement_force(model: Model, motor: int, steps: Steps, place: int) -> Array:
    """Force in some steps of a motor that displaces points, on all of them together and along its way, (step,)."""
    holds = np.flatnonzero(model.holds == motor)
    return np.asarray(_engine_forces(steps, place, np.concatenate([holds, holds - 1])).sum(axis=1))


def _engine_forces(steps: Steps, place: int, parts: Indices) -> Array:
    """Forces of some of the engine's actuators in each step, (step, part)."""
    forces = steps.derived["actuator_force"][place][:, parts]
    if steps.late is None:
        return np.asarray(forces)
    return np.asarray((forces + steps.late["actuator_force"][place][:, parts]) / 2)


def motor_travel(model: Model, position: Array, travel: Array) -> Array:
    """How far small shifts of a structure's coordinates take what each motor acts on, (motor, ...).

    Args:
        model: of the structure, in whose units it is.
        position: from which they go, (..., dof).
        travel: alike.

    Returns:
        The turn of the hinges of a torque, rad, by their gains; the way of a force's points; 0 for a rest angle or
        a displacement.
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
            if model.folds.placement is not None:
                along[number] = _pushed_on(model.in_units, model.folds.placement, motor, position, travel)
    return along


def _pushed_on(structure: Structure, placement: Placement, motor: Motor, position: Array, travel: Array) -> Array:
    """How far small shifts take points of plates along a force, (...)."""
    origins, frames = placement.poses(position)
    moves, turns = placement.rates(origins, frames, travel)
    bodies = [structure.points[point].body for point in motor.points]
    places = np.array([structure.points[point].place for point in motor.points])
    arms = (frames[..., bodies, :, :] @ places[..., None])[..., 0]
    assert motor.direction is not None
    return np.asarray(
        np.sum((moves[..., bodies, :] + np.cross(turns[..., bodies, :], arms)) @ motor.direction, axis=-1)
    )
