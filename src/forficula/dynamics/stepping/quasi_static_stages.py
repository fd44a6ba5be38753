"""Quasi-static stages of many structures: statics computes the equilibria, and lost equilibria continue as motion.

A stage begins with steps under constant settings of the motors until the structure rests. Statics then takes over from
the equilibrium nearest to that state and follows the growing drive. If the equilibrium is lost, the structure moves in
ordinary steps under a constant drive until it rests again, and statics continues.
"""

from __future__ import annotations

from collections.abc import Sequence

import mujoco
import numpy as np

from forficula.arrays import Array
from forficula.dynamics.energies.energy import state_series
from forficula.dynamics.energies.work_balance import WorkBalance
from forficula.dynamics.engine.model import Model
from forficula.dynamics.recorder import Recorder
from forficula.dynamics.stepping.folds import joint_address, slide_name
from forficula.dynamics.stepping.stages import StageTracker
from forficula.dynamics.stepping.start_states import start_position
from forficula.dynamics.stepping.stepper import Stepper
from forficula.dynamics.stepping.steps import MEMORY, EngineState
from forficula.errors import InputError
from forficula.structure import GrowingLoad, RestPath, RestShape, RestSolver, goal_of

# share of the stage by which the drive exceeds the value at which an equilibrium is lost
_BEYOND = 1e-4


class QuasiStaticStages:
    """Progress of the quasi-static stages of many structures of one topology."""

    def __init__(self, models: Sequence[Model], solver: RestSolver | None) -> None:
        """Start without any path.

        Args:
            models: compiled.
            solver: returns the equilibria of a structure under a growing load.

        Raises:
            InputError: a model has a quasi-static stage, but there is no solver.
        """
        self._models, self._solver = models, solver
        # positions of the points at the beginning of the stage with a number, m, by structure
        self._begun: dict[int, tuple[int, Array]] = {}
        for model in models:
            stages = [stage.name for stage in model.design.protocol.stages if stage.quasi_static]
            if stages and solver is None:
                raise InputError(f'{model.design.name}: the stage "{stages[0]}" is quasi-static: need a static solver')

    def go_on(
        self, row: int, tracker: StageTracker, stepper: Stepper, account: WorkBalance, recorder: Recorder
    ) -> None:
        """Follow the equilibria of a resting structure to the end of its stage, or until one is lost."""
        model, stage = self._models[row], int(tracker.stage[row])
        assert self._solver is not None
        reached, unit = stepper.state(row), _setting_units(model)
        shape = _shape(model, reached)
        number, begun = self._begun.get(row, (-1, shape.points))
        self._begun[row] = stage, begun if number == stage else shape.points
        before, after, share = tracker.growing_load(row)
        load = GrowingLoad(
            before=before * unit,
            after=after * unit,
            begin=share,
            goal=goal_of(model.structure, model.design.protocol.stages[stage].until),
            built_on=self._begun[row][1],
            rest_speed=model.design.protocol.rest_speed,
            duration=tracker.longest_stage(row) * float(model.design.protocol.timestep),
        )
        path = self._solver(model.structure, shape, load)
        if path.ended == "away":
            tracker.rest_again(row)
            return
        steps, rows = _numbers(path, tracker.longest_stage(row))
        states = [_placed(model, stepper, row, path.shapes[place]) for place in rows.values()]
        settings = np.array([load.settings(path.share[place]) for place in rows.values()])
        jump = _energy(model, _placed(model, stepper, row, path.shapes[0]), settings[0] / unit)
        jump -= _energy(model, reached, settings[0] / unit)
        jump -= float(path.work[0].sum()) - path.lost - sum(float(lost[0]) for lost in path.creases.values())
        final = _placed(model, stepper, row, path.shapes[-1])
        first = int(tracker.steps[row])
        recorder.add_at_rest(
            first + np.array(list(rows)),
            states,
            account.add_at_rest(
                row,
                path,
                np.array(list(rows.values())),
                settings / unit,
                times=np.array(list(rows)) * float(model.design.protocol.timestep),
                jump=jump,
            ),
            begins=first == tracker.stage_start[row],
        )
        last = float(path.share[-1])
        if path.ended == "lost":
            tracker.lose(row, last, min(last + _BEYOND, 1.0), steps)
        else:
            tracker.end_at_rest(row, last, steps, final.position, at_goal=path.ended == "goal")


def _placed(model: Model, stepper: Stepper, row: int, shape: RestShape) -> EngineState:
    """Put a structure at rest into a shape; return its state."""
    return stepper.place(row, _position(model, shape), shape.memory)


def _position(model: Model, shape: RestShape) -> Array:
    """Return the positions of a structure's joints and of bodies that slide or turn freely, (position,)."""
    position, engine, joints = start_position(model), model.engine, model.folds.joints >= 0
    position[model.folds.joints[joints]] = (model.folds.senses * shape.angles)[joints]
    for number, body in enumerate(model.in_units.bodies):
        origin = shape.origins[number] / model.units.length
        if body.turns:
            first = joint_address(engine, body.name)
            position[first : first + 3] = origin
            mujoco.mju_mat2Quat(position[first + 3 : first + 7], shape.frames[number].ravel())
            continue
        for axis in body.slides:
            # bodies that only slide are on the ground
            position[joint_address(engine, slide_name(body.name, axis))] = origin[axis] - body.position[axis]
    return position


def _shape(model: Model, state: EngineState) -> RestShape:
    """Return the shape of a structure in a state, SI."""
    series = state_series(model, state.angle[None], _rows(state))
    bodies = [model.engine.body(body.name).id for body in model.in_units.bodies]
    return RestShape(
        angles=state.angle,
        points=series["point_position"][0],
        origins=model.units.length * state.derived["xpos"][bodies],
        frames=state.derived["xmat"][bodies].reshape(-1, 3, 3),
        memory=_hinge_memory(model, state.derived[MEMORY], series.get("hinge_set")),
    )


def _hinge_memory(model: Model, memory: Array, sets: Array | None) -> Array | None:
    """Return the memory of all hinges of a structure, SI, (slot, hinge); None if no hinge remembers anything.

    Args:
        model: of the structure.
        memory: of followed hinges, in the model's units, (slot, hinge).
        sets: permanent folds of all hinges, rad, (state, hinge); None if no hinge folds permanently.
    """
    if sets is None and len(memory) == 1:
        return None
    result = np.zeros((len(memory), len(model.structure.hinges)))
    result[:, model.followed_hinges] = memory
    result[2:] *= model.units.energy
    result[0] = 0.0 if sets is None else sets[0]
    return result


def _setting_units(model: Model) -> Array:
    """Return the units of the settings of all motors, SI, (motor,)."""
    units = {
        "torque": model.units.energy,
        "force": model.units.energy / model.units.length,
        "displacement": model.units.length,
        "rest-angle": 1.0,
    }
    return np.array([units[motor.kind] for motor in model.structure.motors])


def _energy(model: Model, state: EngineState, settings: Array) -> float:
    """Return the stored and kinetic energy of a structure in a state, J, for settings in the model's units."""
    series = state_series(model, state.angle[None], _rows(state), settings[None])
    return sum(float(values.sum()) for name, values in series.items() if name.endswith("_energy"))


def _rows(state: EngineState) -> dict[str, Array]:
    return {name: values[None] for name, values in state.derived.items()}


def _numbers(path: RestPath, longest: int) -> tuple[int, dict[int, int]]:
    """Return the number of steps that a path takes, and the row of the path for some of these steps, by number.

    If several rows of a path belong to one step, only the last of them is kept. The last row of the path is kept in any
    case.
    """
    numbers = np.rint((path.share - path.share[0]) * longest).astype(int)
    steps = max(int(numbers[-1]), 1)
    rows = {min(number, steps - 1): place for place, number in enumerate(numbers.tolist())}
    return steps, {0: 0} | rows if steps > 1 else rows
