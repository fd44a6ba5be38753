"""Work of motors, dampers, stops and contacts on many structures, summed step by step."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from forficula.arrays import Array, Indices
from forficula.dynamics.energies.crease_work import (
    crease_works,
    displacement_force,
    engine_work,
    motor_travel,
)
from forficula.dynamics.energies.dissipated_work import (
    ConstraintWork,
    add_contacts,
    add_implicit_losses,
    add_yielding,
    divide_friction,
    explicit_works,
    travel_of,
)
from forficula.dynamics.energies.tendon_losses import TendonLosses
from forficula.dynamics.engine.model import Model
from forficula.dynamics.stepping.steps import EngineState, Steps
from forficula.structure import RestPath
from forficula.structure.contact.touching_parts import has_touching_facets


class WorkBalance:
    """Work done on each of many structures of one topology since its start."""

    def __init__(self, models: Sequence[Model]) -> None:
        """Start with zero work."""
        self._models = models
        self._timestep = np.array([model.timestep for model in models])
        self._unit = np.array([model.units.energy for model in models])
        self._damping = np.array(
            [np.array(model.engine.dof_damping).reshape(model.engine.nv, -1)[:, 0] for model in models]
        )
        self._tendon_losses = TendonLosses(models)
        self._motors = models[0].structure.motors
        self._senses = np.array([model.folds.senses for model in models])
        # last settings of the motors
        self._set = np.zeros((len(models), len(self._motors)))
        self._done: dict[str, Array] = {}
        # motors whose forces depend on the motion, and their powers in the last step
        self._by_engine = np.array(
            [
                [motor.kind == "displacement" or np.isfinite(motor.no_load_speed) for motor in model.structure.motors]
                for model in models
            ],
            dtype=bool,
        )
        self._powers = np.zeros((len(models), len(self._motors)))
        # forces of motors that displace points in the last step, N
        self._displaces = np.array(
            [[motor.kind == "displacement" for motor in model.structure.motors] for model in models], dtype=bool
        )
        self._forces = np.full((len(models), len(self._motors)), np.nan)
        self._gaps, self._explicit = models[0].gaps, models[0].explicit
        self._gap_lengths = models[0].gap_lengths
        self._constraints = ConstraintWork(models)
        # time that each structure has waited without steps, s, if some stage waits
        self._waits = any(stage.wait for model in models for stage in model.design.protocol.stages)
        self._waited = np.zeros(len(models))
        # energy gained where statics takes over, J, if some stage is quasi-static
        self._rests = any(stage.quasi_static for model in models for stage in model.design.protocol.stages)
        self._jumped = np.zeros(len(models))
        # the widest gap so far, m
        self._widest = np.zeros(len(models))
        # the largest overlap of parts so far as a share of the thickness, if facets or plates touch
        self._touches = has_touching_facets(models[0].structure)
        self._deepest = np.zeros(len(models))

    def add(self, rows: Indices, steps: Steps, torques: Array, taken: Indices) -> dict[str, Array]:
        """Add the work of some steps of some structures, J.

        In a step, the engine changes the kinetic energy by force times timestep times the mean of the velocities before
        and after the step, exactly if the inertia is constant. Every work is therefore a force times that travel. (With
        the later velocity alone, which changes the angles, the balance would have an error of first order in the
        timestep.) Steps of Runge and Kutta follow another rule: the setting of a motor is constant during a step, and
        its work is the setting times the travel, to every order of the integration; for other forces see
        `explicit_works`.

        Args:
            rows: numbers of the structures.
            steps: of these structures, in their models' units.
            torques: settings of every motor during each step, in the models' units, (row, step, motor).
            taken: number of the steps that count, (row,).

        Returns:
            By name, the work since the start before each step, J, the powers of the motors in it, W, and their settings
            before it, in the models' units, (row, step). Names of motors are those of `motor_work_name`,
            `motor_power_name` and `motor_setting_name`; forces of motors that displace points, N, have the names of
            `motor_force_name`.
        """
        models = [self._models[row] for row in rows.tolist()]
        with np.errstate(over="ignore", invalid="ignore"):  # diverging structures, whose later steps do not count
            travel = travel_of(models[0], steps, self._timestep[rows])
            before_step = np.concatenate([self._set[rows, None], torques[:, :-1]], axis=1)
            work, of_creases = self._driven(rows, steps, travel, torques, before_step)
            if "qfrc_applied" in steps.derived:
                drag = steps.derived["qfrc_applied"] - (0.0 if steps.contact is None else steps.contact.forces)
                work["drag_work"] = np.sum(drag * travel, axis=2)
            if self._explicit:
                work |= explicit_works(steps, travel, self._damping[rows], self._timestep[rows])
                work["hinge_damping_work"] = work["hinge_damping_work"] + of_creases
                divide_friction(work, models, steps, self._timestep[rows])
                # a rest angle that moves changes only the energy of its spring
                outside = [
                    motor_work_name(number) for number, motor in enumerate(self._motors) if motor.kind != "rest-angle"
                ]
                done = sum(
                    (work[name] for name in (*outside, "drag_work", "friction_work") if name in work),
                    np.zeros(travel.shape[:2]),
                )
                done = done if steps.contact is None else done + np.sum(steps.contact.forces * travel, axis=2)
                self._constraints.divide(work, done, rows, steps, torques, taken)
            else:
                add_implicit_losses(work, models, steps, travel, self._damping[rows], of_creases)
            if steps.contact is not None:
                add_contacts(work, self._models, steps.contact, travel)
            if (self._models[0].hinge_creep >= 0).any():
                add_yielding(work, models, steps)
            self._tendon_losses.add(work, rows, steps, travel)
            seconds = [float(model.design.protocol.timestep) for model in models]
            before = {
                name: self._added_up(name, rows, self._unit[rows, None] * done, taken) for name, done in work.items()
            }
            for motor in range(len(self._motors)):
                done = work[motor_work_name(motor)]
                power = self._unit[rows, None] * done / np.array(seconds)[:, None]
                before[motor_power_name(motor)] = power
                if self._by_engine[:, motor].any():
                    self._powers[rows, motor] = power[np.arange(len(rows)), np.maximum(taken, 1) - 1]
                before[motor_setting_name(motor)] = before_step[:, :, motor]
                if self._displaces[:, motor].any():
                    before[motor_force_name(motor)] = self._motor_force(rows, motor, steps, taken)
            if len(self._gaps):
                before["closure_gap"] = self._widened(rows, steps, taken)
            if steps.contact is not None:
                before["contact_overlap"] = self._deepened(rows, steps.contact.overlaps, taken)
            if self._waits:
                before["waited"] = np.repeat(self._waited[rows, None], travel.shape[1], axis=1)
            if self._rests:
                before["settling_work"] = np.repeat(self._jumped[rows, None], travel.shape[1], axis=1)
            self._set[rows] = np.where((taken > 0)[:, None], torques[np.arange(len(rows)), taken - 1], self._set[rows])
        return before

    def add_at_rest(
        self, row: int, path: RestPath, places: Indices, settings: Array, *, times: Array, jump: float
    ) -> dict[str, Array]:
        """Add the work of the motors on a structure that passes through equilibria.

        Args:
            row: number of the structure.
            path: the equilibria.
            places: rows of the path to return, (row,).
            settings: of the motors at these rows, in the model's units, (row, motor).
            times: of these rows, s, (row,).
            jump: energy that the structure gains between the state that it reached and the first equilibrium, J, and
                that neither the motors nor the dampers explain.

        Returns:
            As for `add`, at these rows, (row,).
        """
        self._jumped[row] += jump
        if path.lost:
            self._done.setdefault("hinge_damping_work", np.zeros(len(self._models)))[row] -= path.lost
        lost = {f"crease_{name}_work": energies for name, energies in path.creases.items() if energies.any()}
        for name in lost:
            self._done.setdefault(name, np.zeros(len(self._models)))
        values = {name: np.full(len(places), done[row]) for name, done in self._done.items()}
        for name, energies in lost.items():
            values[name] = values[name] - energies[places]
            self._done[name][row] -= energies[-1]
        for motor in range(len(self._motors)):
            work = path.work[places, motor]
            values[motor_work_name(motor)] = values[motor_work_name(motor)] + work
            values[motor_power_name(motor)] = np.gradient(work, times) if len(times) > 1 else np.zeros(len(times))
            values[motor_setting_name(motor)] = settings[:, motor]
            self._done[motor_work_name(motor)][row] += path.work[-1, motor]
            if self._displaces[:, motor].any():
                shown = path.forces[places, motor] if self._displaces[row, motor] else np.full(len(places), np.nan)
                values[motor_force_name(motor)] = shown
                self._forces[row, motor] = shown[-1]
        if len(self._gaps):
            values["closure_gap"] = np.full(len(places), self._widest[row])
        if self._touches:
            values["contact_overlap"] = np.full(len(places), self._deepest[row])
        if self._waits:
            values["waited"] = np.full(len(places), self._waited[row])
        values["settling_work"] = np.full(len(places), self._jumped[row])
        self._set[row], self._powers[row] = settings[-1], 0.0
        return values

    def wait(self, row: int, time: float, lost: float, spared: float, of_creases: float) -> None:
        """Add a skipped interval of a structure at rest, s, with energies lost and saved by branches, model units.

        Args:
            row: number of the structure.
            time: duration, s.
            lost: energy lost by the branches of tendons.
            spared: energy saved by the branches of tendons.
            of_creases: energy lost by the branches of creases.
        """
        self._waited[row] += time
        works = {"branch_damping_work": -lost, "letting_go_work": spared, "crease_branch_work": -of_creases}
        for name, work in works.items():
            if name in self._done:
                self._done[name][row] += self._unit[row] * work

    def deepen(self, row: int, overlap: float) -> None:
        """Include an overlap of parts of a structure in the largest one so far, as a share of the thickness."""
        self._deepest[row] = max(self._deepest[row], overlap)

    def total(self, row: int) -> dict[str, float]:
        """Return the work on a structure since its start, J, and the time it waited, s."""
        others = {"closure_gap": float(self._widest[row])} if len(self._gaps) else {}
        others |= {"contact_overlap": float(self._deepest[row])} if self._touches else {}
        others |= {"waited": float(self._waited[row])} if self._waits else {}
        others |= {"settling_work": float(self._jumped[row])} if self._rests else {}
        return {name: float(done[row]) for name, done in self._done.items()} | others

    def power(self, row: int, torques: Array, end: EngineState) -> dict[str, float]:
        """Return powers of the motors' torques (motor,) on a structure in a state, W; their settings; forces, N."""
        model, settings = self._models[row], self._set[row]
        if model.creases is None:
            along = [
                self._motor_travel(np.array([row]), end.position[None, None], end.velocity[None, None], motor)[0, 0]
                for motor in range(len(self._motors))
            ]
        else:
            along = list(motor_travel(model, end.position, end.velocity))
        return {
            **{
                motor_power_name(motor): float(
                    self._powers[row, motor]
                    if self._by_engine[row, motor]
                    else model.units.power * torques[motor] * speed
                )
                for motor, speed in enumerate(along)
            },
            **{motor_setting_name(motor): float(setting) for motor, setting in enumerate(settings)},
            **{
                motor_force_name(motor): float(self._forces[row, motor])
                for motor in np.flatnonzero(self._displaces.any(axis=0)).tolist()
            },
        }

    def follow_leader(self, row: int, leader: int) -> None:
        """Copy the sums of another structure, which has had the same motion so far."""
        for done in (
            *self._done.values(),
            *self._constraints.met.values(),
            self._set,
            self._powers,
            self._forces,
            self._widest,
            self._deepest,
            self._waited,
            self._jumped,
        ):
            done[row] = done[leader]

    def _driven(
        self, rows: Indices, steps: Steps, travel: Array, torques: Array, before_step: Array
    ) -> tuple[dict[str, Array], Array]:
        """Return the work of motors, and of the damping of creases if there are any, (row, step)."""
        if steps.angles is None:
            position = np.concatenate([steps.position_before[:, None], steps.position[:, :-1]], axis=1)
            work = {
                motor_work_name(number): torques[:, :, number] * self._motor_travel(rows, position, travel, number)
                for number in range(len(self._motors))
            }
            for number in np.flatnonzero(self._by_engine.any(axis=0)).tolist():
                work[motor_work_name(number)] += np.array(
                    [
                        engine_work(self._models[row], number, steps, place, travel[place])
                        for place, row in enumerate(rows.tolist())
                    ]
                )
            of_creases = np.zeros(travel.shape[:2])
        else:
            parts_of_pieces = [
                crease_works(self._models[row], steps, place, travel[place], torques[place], before_step[place])
                for place, row in enumerate(rows.tolist())
            ]
            work = {
                motor_work_name(number): np.array([motors[number] for motors, _, _ in parts_of_pieces])
                for number in range(len(self._motors))
            }
            of_creases = np.array([damped for _, damped, _ in parts_of_pieces])
            of_laws = [lost for _, _, lost in parts_of_pieces]
            for name in {name for lost in of_laws for name in lost}:
                work[name] = np.array([lost.get(name, np.zeros(travel.shape[1])) for lost in of_laws])
        return work, of_creases

    def _motor_travel(self, rows: Indices, position: Array, travel: Array, number: int) -> Array:
        """Return the travel along a motor for small shifts of coordinates, (row, step).

        Args:
            rows: numbers of the structures.
            position: start of the shifts, (row, step, coordinate).
            travel: shifts, (row, step, coordinate).
            number: of the motor.
        """
        if self._motors[number].kind == "force":
            return np.array(
                [
                    motor_travel(self._models[row], position[place], travel[place])[number]
                    for place, row in enumerate(rows.tolist())
                ]
            )
        hinges = list(self._motors[number].hinges)
        turned = travel[:, :, self._models[0].folds.speeds[hinges]]
        return np.asarray(np.sum(self._senses[rows][:, None, hinges] * turned, axis=2))

    def _motor_force(self, rows: Indices, motor: int, steps: Steps, taken: Indices) -> Array:
        """Return the force of a motor on the points that it displaces, N, (row, step); nan if it displaces none."""
        forces = np.full(steps.position.shape[:2], np.nan)
        for place, row in enumerate(rows.tolist()):
            if self._displaces[row, motor]:
                unit = self._models[row].units
                forces[place] = unit.energy / unit.length * displacement_force(self._models[row], motor, steps, place)
        self._forces[rows, motor] = forces[np.arange(len(rows)), np.maximum(taken, 1) - 1]
        return forces

    def _widened(self, rows: Indices, steps: Steps, taken: Indices) -> Array:
        """Return the widest gap of a closure up to the state before each step, m, (row, step)."""
        unit = np.array([self._models[row].units.length for row in rows.tolist()])
        assert steps.late is not None
        lengths = [fields["ten_length"][:, :, self._gaps] for fields in (steps.derived, steps.late)]
        ends = [np.abs(length - self._gap_lengths).max(axis=2) for length in lengths]
        gaps = unit[:, None] * np.concatenate([ends[0][:, :1], ends[1]], axis=1)
        widest = np.maximum.accumulate(np.maximum(gaps, self._widest[rows, None]), axis=1)
        self._widest[rows] = widest[np.arange(len(rows)), taken]
        return np.asarray(widest[:, :-1])

    def _deepened(self, rows: Indices, overlaps: Array, taken: Indices) -> Array:
        """Return the largest overlap of parts before each step as a share of the thickness, (row, step)."""
        overlaps = np.concatenate([self._deepest[rows, None], overlaps], axis=1)
        deepest = np.maximum.accumulate(overlaps, axis=1)
        self._deepest[rows] = deepest[np.arange(len(rows)), taken]
        return np.asarray(deepest[:, :-1])

    def _added_up(self, name: str, rows: Indices, works: Array, taken: Indices) -> Array:
        """Add the work of steps to a sum, and return the sum before each step, (row, step)."""
        done = self._done.setdefault(name, np.zeros(len(self._models)))
        # a single sum from the start, which does not depend on the ends of chunks
        total = np.cumsum(np.concatenate([done[rows, None], works], axis=1), axis=1)
        done[rows] = total[np.arange(len(rows)), taken]
        return np.asarray(total[:, :-1])


def motor_work_name(motor: int) -> str:
    """Return the name of the work of a motor in an account."""
    return f"motor{motor}_work"


def motor_setting_name(motor: int) -> str:
    """Return the name of the setting of a motor in an account."""
    return f"motor{motor}_setting"


def motor_power_name(motor: int) -> str:
    """Return the name of the power of a motor in an account."""
    return f"motor{motor}_power"


def motor_force_name(motor: int) -> str:
    """Return the name of the force of a motor that displaces points in an account."""
    return f"motor{motor}_motor_force"
