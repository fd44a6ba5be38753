"""Work of motors and dampers on creases and nodes, step by step."""

from __future__ import annotations

import math

import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics.engine.crease_rows import without_jump
from forficula.dynamics.engine.model import Model
from forficula.dynamics.engine.placement import Placement
from forficula.dynamics.stepping.steps import Steps
from forficula.material.law.crease_memory import (
    acting_moment,
    friction_loss,
    memory_losses,
    remaining_share,
    stored_energy,
    turned_memory,
    yielding_slope,
)
from forficula.structure import Motor, Structure


def crease_works(
    model: Model, steps: Steps, place: int, travel: Array, efforts: Array, before: Array
) -> tuple[Array, Array, dict[str, Array]]:
    """Compute the works on a structure with creases in some steps, in the model's units.

    The work of a moving rest angle is the change of the energy of the spring. For a linear spring it equals the moment
    at the mean rest angle, without locking and stops, times the change of the rest angle.

    Args:
        model: of the structure.
        steps: of several structures.
        place: index of the structure in the steps.
        travel: of its coordinates in each step, (step, dof).
        efforts: settings of its motors in each step, (step, motor).
        before: settings before each step, (step, motor).

    Returns:
        Work of every motor, (motor, step), and of the creases' damping, (step,); and by name the works, <= 0, of their
        yielding, branches and damage, (step,), without those that no crease has.
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
        speeds = folds.travel(position[first], velocity[first])[:, creases.hinges]
        turned = folds.travel(position, travel)[:, creases.hinges]
        damped = -np.sum((creases.damping * speeds)[block] * turned, axis=1)
    angles = steps.angles[place][block]
    rests, mean = model.settings(before)[0], model.settings((before + efforts) / 2)[0]
    moved, moments, law = np.any(mean) or np.any(rests), np.zeros_like(angles), creases.law
    if moved:
        assert steps.memory is not None
        memory = steps.memory[:, place, block]
        moments = remaining_share(law, memory) * law.rest_moment(angles, mean, law.rest_shift(memory[0]))
        if law.yields or law.bends:
            moments = _mean_moments(model, steps, place, before, efforts, moments)
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
    return np.array(works).reshape(-1, len(travel)), damped, _losses(model, steps, place, efforts)


def _mean_moments(model: Model, steps: Steps, place: int, before: Array, efforts: Array, linear: Array) -> Array:
    """Return the moments whose product with minus the change of rest angles is the work of this change, (step, crease).

    Rest angles change where a block begins, at constant fold angles. The work is the change of the stored energy plus
    the loss of the yield that the change causes, after the yield that the turn before the block caused.

    Args:
        model: of the structure.
        steps: of several structures.
        place: index of the structure in the steps.
        before: settings of its motors before each step, (step, motor).
        efforts: settings in each step, (step, motor).
        linear: moments where rest angles do not change, (step, crease).
    """
    assert model.creases is not None
    assert steps.memory is not None
    assert steps.memory_before is not None
    assert steps.angles is not None
    law, block = model.creases.law, np.arange(len(efforts)) // steps.followed
    angles, memory = steps.angles[place][block], steps.memory[:, place]
    earlier = np.concatenate([steps.memory_before[:, place, None], memory[:, :-1]], axis=1)[:, block]
    memory, (rests, ends) = memory[:, block], (model.settings(setting)[0] for setting in (before, efforts))
    turned = np.array(memory)
    turned[0] = law.next_set(angles, rests, earlier[0]) if law.yields else memory[0]
    work = stored_energy(law, angles, ends, memory) - stored_energy(law, angles, rests, turned)
    if law.yields:
        work = work + remaining_share(law, memory) * law.yield_loss(memory[0] - turned[0])
    changes = ends - rests
    return np.divide(-work, changes, out=np.array(linear), where=changes != 0)


def _losses(model: Model, steps: Steps, place: int, efforts: Array) -> dict[str, Array]:
    """Return the works of yielding, branches, damage and friction of creases, <= 0, (step,), see `crease_works`.

    A set changes where a block of steps begins, so the work is that of the first step of the block. The work of
    branches and wear in a block is distributed evenly over its steps.
    """
    assert model.creases is not None
    assert steps.memory is not None
    assert steps.memory_before is not None
    assert steps.angles is not None
    law, memory, angles, count = model.creases.law, steps.memory[:, place], steps.angles[place], len(efforts)
    works: dict[str, Array] = {}
    if not (law.yields or law.relaxes or law.wears or law.rubs):
        return works
    block, rests = steps.followed * model.timestep, model.settings(efforts[:: steps.followed])[0]
    after = memory
    if len(memory) > 1:
        # the last block ends at the angles after it
        end = model.folds.angles(steps.position[place, -1])[model.followed_hinges]
        ends = np.concatenate([angles[1:], without_jump(end, angles[-1])[None]])
        after = turned_memory(law, memory, ends - angles, block)
        _, relaxed, worn = memory_losses(law, ends, rests, memory, after, block)
        for name, lost, present in (
            ("crease_branch_work", relaxed, law.relaxes),
            ("crease_damage_work", worn, law.wears),
        ):
            if present:
                works[name] = -np.repeat(np.sum(lost, axis=1), steps.followed)[:count] / steps.followed
        if law.rubs:
            rubbed = friction_loss(law, ends - angles, memory, after)
            works["friction_work"] = -np.repeat(np.sum(rubbed, axis=1), steps.followed)[:count] / steps.followed
    if law.yields:
        # the first block begins where the steps before it ended
        before = np.concatenate([steps.memory_before[:, place, None], after[:, :-1]], axis=1)
        yielded, _, worn = memory_losses(law, angles, rests, before, memory, 0.0)
        works["crease_yield_work"] = np.zeros(count)
        works["crease_yield_work"][:: steps.followed] = -np.sum(yielded, axis=1)
        if law.wears:
            works["crease_damage_work"][:: steps.followed] -= np.sum(worn, axis=1)
    return works


def spring_works(model: Model, steps: Steps, place: int, efforts: Array) -> Array:
    """Return the work of the springs of creases on the structure, (step,), with the arguments of `crease_works`.

    The work of a moving rest angle is not part of it, because such a motor changes only the energy of the spring.
    """
    assert model.creases is not None
    assert steps.memory is not None
    assert steps.memory_before is not None
    assert steps.angles is not None
    law, memory, angles = model.creases.law, steps.memory[:, place], steps.angles[place]
    rests = model.settings(efforts[:: steps.followed])[0]
    moment, slope = acting_moment(law, angles, rests, memory, steps.followed * model.timestep)
    if law.yields or law.rubs:
        before = np.concatenate([steps.memory_before[:, place, None], memory[:, :-1]], axis=1)
        slope = slope - yielding_slope(law, before, memory)
    position = np.concatenate([steps.position_before[place, None], steps.position[place]])
    block = np.arange(len(efforts)) // steps.followed
    turned = model.folds.angles(position)[:, model.creases.hinges]
    start, end = (without_jump(turned[part], angles[block]) - angles[block] for part in (slice(-1), slice(1, None)))
    work = moment[block] * (end - start) + slope[block] / 2 * (end**2 - start**2)
    return np.asarray(-np.sum(work, axis=1))


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
