"""Work of dampers, dry friction, stops, contacts and yielding joints in steps of structures, in the models' units."""

from __future__ import annotations

from collections.abc import Sequence

import mujoco
import numpy as np

from forficula.arrays import Array, Flags, Indices
from forficula.dynamics.energies.crease_work import spring_works
from forficula.dynamics.energies.energy import energy_of
from forficula.dynamics.energies.stop_forces import friction_torques, stop_forces
from forficula.dynamics.engine.contact import has_engine_contact
from forficula.dynamics.engine.model import Model, joint_ranges
from forficula.dynamics.stepping.steps import StepContacts, Steps

# steps during which a stop's force still changes fast: four of its time constants
_JUMP = 8


def travel_of(model: Model, steps: Steps, timestep: Array) -> Array:
    """Return how far each degree of freedom moves in each step, (row, step, dof), in the models' units.

    In steps of Runge and Kutta it is the change of a joint's position. The position of a body that turns freely is no
    coordinate of its velocity; its travel is the mean velocity times the timestep, as in all other steps.

    Args:
        model: of one of the structures, which have one topology.
        steps: of the structures.
        timestep: (row,).
    """
    velocity = np.concatenate([steps.velocity_before[:, None], steps.velocity], axis=1)
    travel = (velocity[:, :-1] + velocity[:, 1:]) / 2 * timestep[:, None, None]
    if model.explicit:
        joints = np.array(model.engine.jnt_type) != mujoco.mjtJoint.mjJNT_FREE
        moved = np.diff(np.concatenate([steps.position_before[:, None], steps.position], axis=1), axis=1)
        travel[:, :, model.engine.jnt_dofadr[joints]] = moved[:, :, model.engine.jnt_qposadr[joints]]
    return np.asarray(travel)


def add_implicit_losses(
    work: dict[str, Array], models: Sequence[Model], steps: Steps, travel: Array, damping: Array, of_creases: Array
) -> None:
    """Add the work of dampers, stops and contacts in steps that the engine takes implicitly.

    Args:
        work: of the steps by name, (row, step), to which works are added.
        models: of the structures, (row,).
        steps: of the structures.
        travel: of the joints in each step, (row, step, dof).
        damping: of the joints, (row, dof).
        of_creases: work of the dampers of creases, (row, step).
    """
    velocity = np.concatenate([steps.velocity_before[:, None], steps.velocity], axis=1)
    damping = damping[:, None]
    # the engine takes hinge damping implicitly, at the velocity after the step
    work["hinge_damping_work"] = np.sum(-damping * velocity[:, 1:] * travel, axis=2) + of_creases
    work["elastic_damping_work"] = np.sum((steps.derived["qfrc_damper"] + damping * velocity[:, :-1]) * travel, axis=2)
    constraints = steps.derived["qfrc_constraint"]
    if "qacc" in steps.derived:
        friction = np.array(
            [
                friction_torques(model, velocity[place, :-1], item, constraints[place])
                for place, (model, item) in enumerate(zip(models, steps.derived["qacc"], strict=True))
            ]
        )
        # creases between flaps may have friction, too
        work["friction_work"] = work.get("friction_work", 0.0) + np.sum(friction * travel, axis=2)
        constraints = constraints - friction
    work["stop_work"] = np.sum(constraints * travel, axis=2)
    if has_engine_contact(models[0].structure):
        _divide_contacts(work, models, steps, travel)


def explicit_works(steps: Steps, travel: Array, damping: Array, timestep: Array) -> dict[str, Array]:
    """Compute the work of dampers, and of stops and closures, in each step, (row, step), in the models' units.

    The work of hinge dampers is the integral of the squared speed, by Simpson's rule of fourth order. The speed at the
    middle is that of the cubic through both positions with both speeds. Powers of other forces are known at both ends
    of a step, so the trapezoidal rule of second order is used.

    Args:
        steps: of structures for which `Model.explicit` is true.
        travel: of the joints in each step, (row, step, dof).
        damping: of the joints, (row, dof).
        timestep: (row,).
    """
    before = np.concatenate([steps.velocity_before[:, None], steps.velocity[:, :-1]], axis=1)
    after, step, damping = steps.velocity, timestep[:, None, None], damping[:, None]
    middle = 1.5 * travel / step - (before + after) / 4
    assert steps.late is not None
    at_start, at_end = steps.derived, steps.late
    works = {"hinge_damping_work": -step / 6 * damping * (before**2 + 4 * middle**2 + after**2)}
    for name, field in (("elastic_damping_work", "qfrc_damper"), ("stop_work", "qfrc_constraint")):
        implicit = damping if field == "qfrc_damper" else 0.0
        powers = (at_start[field] + implicit * before) * before + (at_end[field] + implicit * after) * after
        works[name] = step / 2 * powers
    return {name: np.sum(work, axis=2) for name, work in works.items()}


def divide_friction(work: dict[str, Array], models: Sequence[Model], steps: Steps, timestep: Array) -> None:
    """Divide the work of constraints in steps of Runge and Kutta into that of dry friction and that of others."""
    if "qacc" not in steps.derived:
        return
    assert steps.late is not None
    before = np.concatenate([steps.velocity_before[:, None], steps.velocity[:, :-1]], axis=1)
    powers = np.zeros(before.shape[:2])
    for velocity, fields in ((before, steps.derived), (steps.velocity, steps.late)):
        for place, model in enumerate(models):
            torques = friction_torques(model, velocity[place], fields["qacc"][place], fields["qfrc_constraint"][place])
            powers[place] += np.sum(torques * velocity[place], axis=1)
    work["friction_work"] = timestep[:, None] / 2 * powers
    work["stop_work"] = work["stop_work"] - work["friction_work"]


class ConstraintWork:
    """Division of the work of constraints in steps of Runge and Kutta, for many structures of one topology.

    Attributes:
        met: in which of the last steps hinges met or left their stops, and contacts began or ended, (structure, step).
    """

    def __init__(self, models: Sequence[Model]) -> None:
        """Start without contacts."""
        self._models = models
        # positions of the stops of joints
        self._stops = [np.array(ends) for ends in zip(*(joint_ranges(model) for model in models), strict=True)]
        self.met: dict[str, Flags] = {}

    def divide(
        self, work: dict[str, Array], driven: Array, rows: Indices, steps: Steps, torques: Array, taken: Indices
    ) -> None:
        """Divide the work of constraints into that of stops, that of the engine's contacts and that of closures.

        The force of a stop jumps within the step in which a hinge meets or leaves it, and that of a contact where it
        begins or ends, so no rule for smooth forces applies. In that step and a few more, the change of energy that no
        other work explains is the work of stops or contacts. While parts touch, the work of all constraints counts as
        that of contacts.
        """
        low, high = (self._stops[end][rows, None] for end in (0, 1))
        position = np.concatenate([steps.position_before[:, None], steps.position], axis=1)
        at_stop = (position <= low) | (position >= high)
        stopped, jumps = self._meeting("stops", at_stop, rows, taken)
        landed, touched = np.zeros_like(stopped), np.zeros_like(jumps)
        if "ncon" in steps.derived:
            assert steps.late is not None
            numbers = np.concatenate([steps.derived["ncon"][:, :1], steps.late["ncon"]], axis=1)
            landed, touched = self._meeting("contacts", numbers[:, :, None], rows, taken)
        jumps = jumps | touched
        others = driven + work["hinge_damping_work"] + work["elastic_damping_work"]
        for place, row in enumerate(rows.tolist()):
            if self._models[row].creases is not None:
                others[place] += spring_works(self._models[row], steps, place, torques[place])
        for place, step in zip(*np.nonzero(jumps & (np.arange(jumps.shape[1]) < taken[:, None])), strict=True):
            ends = (steps.before[place] if step == 0 else steps.after[place, step - 1], steps.after[place, step])
            before, after = (energy_of(self._models[rows[place]], state) for state in ends)
            work["stop_work"][place, step] = after - before - others[place, step]
        constraints = work["stop_work"]
        work["stop_work"] = np.where(stopped & ~landed, constraints, 0.0)
        if "ncon" in steps.derived:
            work["contact_work"] = np.where(landed, constraints, 0.0)
        if len(self._models[0].gaps):
            work["closure_work"] = np.where(stopped | landed, 0.0, constraints)

    def _meeting(self, kind: str, touching: Flags | Indices, rows: Indices, taken: Indices) -> tuple[Flags, Flags]:
        """Return in which steps parts touch or have just touched, and in which their forces jump, (row, step) each.

        Args:
            kind: of touching, `"stops"` or `"contacts"`.
            touching: whether parts touch before the first step and after each step, or the number of contacts, (row,
                1 + step, part).
            rows: numbers of the structures.
            taken: number of the steps that count, (row,).
        """
        met = self.met.setdefault(kind, np.zeros((len(self._models), _JUMP), dtype=np.bool_))
        changes = np.concatenate([met[rows], (touching[:, 1:] != touching[:, :-1]).any(axis=2)], axis=1)
        jumps = np.lib.stride_tricks.sliding_window_view(changes, _JUMP + 1, axis=1).any(axis=2)
        met[rows] = [flags[end : end + _JUMP] for flags, end in zip(changes, taken.tolist(), strict=True)]
        touches = touching[:, :-1].any(axis=2) | touching[:, 1:].any(axis=2)
        return np.asarray(jumps | touches), np.asarray(jumps)


def add_contacts(work: dict[str, Array], models: Sequence[Model], contacts: StepContacts, travel: Array) -> None:
    """Add the work of contacts of facets and plates, without that which friction springs store, and their energy."""
    work["contact_work"] = work.get("contact_work", 0.0) + np.sum(contacts.forces * travel, axis=2)
    if any(model.structure.contact is not None and model.structure.contact.friction for model in models):
        energies = np.array([[springs.energy for springs in row] for row in contacts.friction_springs])
        work["friction_spring_energy"] = np.diff(energies, axis=1)
        work["contact_work"] = work["contact_work"] + work["friction_spring_energy"]


def add_yielding(work: dict[str, Array], models: Sequence[Model], steps: Steps) -> None:
    """Add the work of joints that yield: moment of the yielding spring times the change of its rest angle."""
    lost = work.setdefault("crease_yield_work", np.zeros(steps.position.shape[:2]))
    rests = np.concatenate(
        [steps.before[:, None, steps.inner["plastic"]], steps.after[:, :, steps.inner["plastic"]]], axis=1
    )
    for place, model in enumerate(models):
        for number in np.flatnonzero(model.hinge_creep >= 0).tolist():
            hinge = model.in_units.hinges[number]
            moment = (hinge.stiffness - hinge.hardening) * hinge.yield_angle
            lost[place] -= moment * np.abs(np.diff(rests[place, :, model.hinge_creep[number]]))


def _divide_contacts(work: dict[str, Array], models: Sequence[Model], steps: Steps, travel: Array) -> None:
    """Divide the work of constraints into that of stops and that of contacts."""
    position = np.concatenate([steps.position_before[:, None], steps.position[:, :-1]], axis=1)
    stops = np.zeros(travel.shape[:2])
    for place, model in enumerate(models):
        before = {name: values[place] for name, values in steps.derived.items()}
        stops[place] = np.sum(stop_forces(model, position[place], before) * travel[place], axis=1)
    work["contact_work"], work["stop_work"] = work["stop_work"] - stops, stops
