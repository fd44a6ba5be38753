"""Work of torques, dampers and stops on many wings, added up step by step."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from forficula.dynamics.energy import branch_losses, letting_go_work
from forficula.dynamics.model import WingModel
from forficula.dynamics.stepper import Steps

Array = NDArray[np.float64]
Indices = NDArray[np.int64]


class Account:
    """What was done on each of many wings of one topology since its start."""

    def __init__(self, wings: Sequence[WingModel]) -> None:
        """Start with nothing done."""
        self._wings = wings
        self._timestep = np.array([float(wing.in_units.protocol.timestep) for wing in wings])
        self._unit = np.array([wing.units.energy for wing in wings])
        self._damping = np.array(
            [np.array(wing.engine.dof_damping).reshape(wing.engine.nv, -1)[:, 0] for wing in wings]
        )
        self._senses = np.array([wing.senses for wing in wings])
        self._turns, self._folds = wings[0].joints[:, 2], wings[0].joints[:, 3]
        self._done: dict[str, Array] = {}

    def add(self, rows: Indices, steps: Steps, torques: Array, taken: Indices) -> dict[str, Array]:
        """Add what some steps of some wings do, J.

        The engine changes the kinetic energy in a step by force times timestep times the mean of the velocities before
        and after it, exactly where the inertia is constant: every work here is a force times that travel. (With the
        later velocity alone, which is what turns the angles, the account would be out by a term of first order in the
        timestep.)

        Args:
            rows: which wings.
            steps: of these wings, in their models' units.
            torques: on every proximal turn axis and on every distal hinge during each step, in the veins' own senses
                and the models' units, (row, step, 2).
            taken: how many of the steps count, (row,).

        Returns:
            By name the work since the start before each step, J, and the powers of the torques in it, W, (row, step).
        """
        velocity = np.concatenate([steps.velocity_before[:, None], steps.velocity], axis=1)
        with np.errstate(over="ignore", invalid="ignore"):  # of a wing that blows up, whose later steps do not count
            travel = (velocity[:, :-1] + velocity[:, 1:]) / 2 * self._timestep[rows, None, None]
            damping = self._damping[rows, None]
            work = {
                "proximal_work": torques[:, :, 0] * self._along(rows, travel, self._turns),
                "distal_work": torques[:, :, 1] * self._along(rows, travel, self._folds),
                # the engine takes hinge damping implicitly, at the velocity after the step
                "hinge_damping_work": np.sum(-damping * velocity[:, 1:] * travel, axis=2),
                "elastic_damping_work": np.sum(
                    (steps.derived["qfrc_damper"] + damping * velocity[:, :-1]) * travel, axis=2
                ),
                "stop_work": np.sum(steps.derived["qfrc_constraint"] * travel, axis=2),
            }
            for place, row in enumerate(rows.tolist()):
                self._add_branches(work, place, self._wings[row], steps, travel)
            seconds = [float(self._wings[row].design.protocol.timestep) for row in rows]
            before = {
                name: self._added_up(name, rows, self._unit[rows, None] * done, taken) for name, done in work.items()
            }
            for name in ("proximal", "distal"):
                before[f"{name}_power"] = self._unit[rows, None] * work[f"{name}_work"] / np.array(seconds)[:, None]
        return before

    def total(self, row: int) -> dict[str, float]:
        """The work on a wing since its start, J."""
        return {name: float(done[row]) for name, done in self._done.items()}

    def power(self, row: int, torques: Array, velocity: Array) -> dict[str, float]:
        """Powers of torques (2,) on a wing at a velocity (dof,), W."""
        speeds = [
            self._along(np.array([row]), velocity[None, None], joints)[0, 0] for joints in (self._turns, self._folds)
        ]
        unit = self._wings[row].units.power
        names = ("proximal_power", "distal_power")
        return {name: float(unit * torque * speed) for name, torque, speed in zip(names, torques, speeds, strict=True)}

    def follow_leader(self, row: int, leader: int) -> None:
        """Put a wing where another one is, which has gone the same way so far."""
        for done in self._done.values():
            done[row] = done[leader]

    def _along(self, rows: Indices, travel: Array, joints: Indices) -> Array:
        """Sum over veins of a joint's travel in the veins' own senses, (row, step); a fixed base has no joint, -1."""
        there = joints >= 0
        return np.asarray(np.sum(self._senses[rows][:, None, there] * travel[:, :, joints[there]], axis=2))

    def _add_branches(self, work: dict[str, Array], place: int, wing: WingModel, steps: Steps, travel: Array) -> None:
        """Add what the Maxwell branches of a wing's tendons take, and what keeps tendons that let go from pushing."""
        activations = steps.activation(place, travel.shape[1])
        if wing.branches.size:
            lost = work.setdefault("branch_damping_work", np.zeros(travel.shape[:2]))
            lost[place] = -branch_losses(wing, activations).sum(axis=(1, 2))
        if wing.tendon_law.lets_go:
            forces = {name: values[place] for name, values in steps.derived.items()}
            damper, spared = letting_go_work(wing, travel[place], forces, activations)
            work["elastic_damping_work"][place] += damper
            work.setdefault("letting_go_work", np.zeros(travel.shape[:2]))[place] = spared

    def _added_up(self, name: str, rows: Indices, each: Array, taken: Indices) -> Array:
        """Add steps to what was done, and say what that was before each of them, (row, step)."""
        done = self._done.setdefault(name, np.zeros(len(self._wings)))
        # one sum from the start on: it does not depend on where chunks end
        total = np.cumsum(np.concatenate([done[rows, None], each], axis=1), axis=1)
        done[rows] = total[np.arange(len(rows)), taken]
        return np.asarray(total[:, :-1])
