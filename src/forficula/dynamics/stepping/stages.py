"""Progress of many structures through their protocols: torques of the present stages, and ends of stages."""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce

import numpy as np

from forficula.arrays import Array
from forficula.dynamics.engine.model import Model
from forficula.dynamics.record import StageEnd
from forficula.dynamics.stepping.passage import Conditions
from forficula.dynamics.stepping.stage_plan import Numbers, stage_plan, stage_torques
from forficula.dynamics.stepping.steps import Steps

_AT_ONCE = 1e-9  # steps


class StageTracker:
    """Progress of structures of one topology through their protocols.

    Attributes:
        ended: whether each structure is done, (structure,).
        steps: number of steps taken by each structure, (structure,).
        stage: number of the present stage of each structure, (structure,).
        stage_start: step at which the present stage began, (structure,).
        ends: completed stages of each structure.
        diverged_at: when each structure diverged, s, or None.
    """

    def __init__(self, models: Sequence[Model]) -> None:
        self._models = models
        self._plan = stage_plan(models)
        self._risen = self._plan.risen
        self._folds = [model.folds for model in models]
        self._senses = np.array([folds.senses for folds in self._folds])
        # torques on creases are constant over a block
        self._block = models[0].followed
        self._distances = models[0].distances
        self._followed, self._holds = models[0].motors, models[0].holds
        self._brakes = np.flatnonzero(models[0].brakes >= 0)
        self._braking = models[0].brakes[self._brakes]
        self._jacobians = np.array([model.jacobian for model in models])
        self._displaces = np.array([motor.kind == "displacement" for motor in models[0].structure.motors], dtype=bool)
        # positions at the beginning of the present stage
        self._begun = np.zeros((len(models), models[0].engine.nq))
        count = len(models)
        self.ended = np.zeros(count, dtype=bool)
        self.steps: Numbers = np.zeros(count, dtype=np.int64)
        self.stage: Numbers = np.zeros(count, dtype=np.int64)
        self.stage_start: Numbers = np.zeros(count, dtype=np.int64)
        self.ends: list[list[StageEnd]] = [[] for _ in models]
        self.diverged_at: list[float | None] = [None] * count
        # the steps since which the stage's goal has held and the structure has rested, or -1
        self._goal_since: Numbers = np.full(count, -1, dtype=np.int64)
        self._rest_since: Numbers = np.full(count, -1, dtype=np.int64)
        # total waiting time, and that before the stage, s; steps from which the limit counts, and of the first rest
        self.waited = np.zeros(count)
        self._waited_before = np.zeros(count)
        self._limit_start: Numbers = np.zeros(count, dtype=np.int64)
        self._rested: Numbers = np.full(count, -1, dtype=np.int64)
        # structures at rest that must wait
        self.waiting: list[int] = []
        # whether the goal of the present stage was met at any moment
        self._met = np.zeros(count, dtype=bool)
        # whether a structure missed a goal or diverged, so that the rest of its protocol is skipped
        self._stopped = np.zeros(count, dtype=bool)
        # structures at rest in a quasi-static stage, for which statics continues
        self.at_rest = np.zeros(count, dtype=bool)
        # whether a structure moves in a quasi-static stage; shares of that stage; settings of the motors before it and
        # at the end of the last one
        self._settling = np.zeros(count, dtype=bool)
        self._share = np.zeros(count)
        self._before = np.zeros((count, len(models[0].structure.motors)))
        self._carried = np.zeros_like(self._before)
        # shares at which each structure has lost its equilibrium in the present stage
        self._lost: list[list[float]] = [[] for _ in models]
        for row in np.flatnonzero(self._plan.quasi_static[:, 0]).tolist():
            self._begin_stage(row)

    def torques(self, rows: Numbers, count: int) -> Array:
        """Return the torques of the motors in the next steps of structures, (row, step, motor), in the models' units.

        Torques are in the hinges' own senses and are evaluated at the middle of each step.
        """
        passed = (self.steps - self.stage_start)[rows, None] + self._block * (np.arange(count) // self._block + 0.5)
        rises, torques = self._plan.rise[rows, self.stage[rows]], self._plan.torques[rows, self.stage[rows]]
        total = []
        for drive in range(rises.shape[1]):
            share = np.minimum(passed / np.maximum(rises[:, drive, None], _AT_ONCE), 1.0)
            total.append(share[:, :, None] * torques[:, drive, None])
        acting = np.asarray(reduce(np.add, total))
        for place in np.flatnonzero(self._settling[rows]).tolist():
            acting[place] = self._settings(int(rows[place]))
        return acting

    def last_torques(self, row: int) -> Array:
        """Return the torques at the end of the last stage of a structure, (motor,), as for `torques`."""
        end, model = self.ends[row][-1], self._models[row]
        if end.stage.quasi_static:
            return np.asarray(self._carried[row])
        total = np.zeros(len(model.structure.motors))
        for torques, rise in stage_torques(model, end.stage):
            total += (min((end.end - end.start) / rise, 1.0) if rise else 1.0) * np.array(torques)
        return total

    def controls(self, rows: Numbers, torques: Array) -> Array:
        """Return the engine's controls in each step of structures for given torques, (row, step, control)."""
        none = np.zeros((*torques.shape[:2], 1))
        # a control that follows no motor has index -1 and reads the 0 at the end
        controls = np.concatenate([torques, none], axis=2)[:, :, self._followed]
        controls[:, :, self._brakes] = np.abs(torques[:, :, self._braking])
        holds = np.flatnonzero(self._holds >= 0)
        if len(holds):
            on = np.any(self._plan.torques[rows, self.stage[rows]][:, :, self._holds[holds]], axis=1)
            begun = np.einsum("rcd,rd->rc", self._jacobians[rows][:, holds], self._begun[rows])
            controls[:, :, holds] = on[:, None]
            controls[:, :, holds - 1] += (on * begun)[:, None]
        return controls

    def follow(self, rows: Numbers, steps: Steps) -> Numbers:
        """Process some steps of structures, for each up to the end of its stage.

        Args:
            rows: numbers of the structures.
            steps: of these structures, in their models' units.

        Returns:
            Number of steps that count, (row,); the others belong to the next stage, with other torques.
        """
        passage, count = steps.passage(self._conditions(rows)), steps.count
        sound, end, settling = passage.sound, passage.end, self._settling[rows]
        taken = np.minimum(np.minimum(end, sound), count)
        self.steps[rows] += taken
        self._met[rows] |= passage.met
        self._goal_since[rows], self._rest_since[rows] = passage.carried_goal, passage.carried_rest
        ending = np.flatnonzero((end <= count) | (sound < count))
        begun = steps.states(ending, taken[ending], slice(1, 1 + steps.positions))
        for position, place in zip(begun, ending.tolist(), strict=True):
            if sound[place] < min(end[place], count):
                row = int(rows[place])
                self.diverged_at[row] = float((self.steps[row] + 1) * self._plan.timestep[row])
                self.stop(row)
            elif end[place] <= count:
                if settling[place] and passage.held[place] and not passage.arrived[place]:
                    self.at_rest[rows[place]] = True
                    self._goal_since[rows[place]] = self._rest_since[rows[place]] = -1
                    continue
                self._begun[int(rows[place])] = position
                goal_step, resting = int(passage.goal_since[place]), bool(passage.resting[place])
                if settling[place]:
                    self._end_moving(
                        int(rows[place]),
                        goal_step if passage.arrived[place] else None,
                        at_rest=bool(resting and passage.arrived[place]),
                    )
                    continue
                self._finish_stage(
                    int(rows[place]),
                    goal_step if passage.held[place] else None,
                    at_rest=resting,
                    at_goal=bool(passage.reached[place]),
                )
        return np.asarray(taken)

    def _conditions(self, rows: Numbers) -> Conditions:
        """Return what ends the present stages of structures."""
        plan, stage, settling = self._plan, self.stage[rows], self._settling[rows]
        lost = np.array([bool(self._lost[row]) for row in rows], dtype=bool)
        return Conditions(
            folds=[self._folds[row] for row in rows],
            senses=self._senses[rows],
            watched=plan.watched,
            distances=self._distances,
            lowest=plan.lowest[rows],
            highest=plan.highest[rows],
            rest_speed=plan.rest_speed[rows],
            least=plan.least[rows, stage],
            most=plan.most[rows, stage],
            has_bounds=plan.has_bounds[rows, stage],
            ends_at_rest=plan.ends_at_rest[rows, stage],
            may_stick=plan.may_stick[rows, stage],
            hold=plan.hold[rows, stage],
            least_hold=plan.least_hold[rows],
            window=plan.window[rows],
            settled=plan.settled[rows],
            taken=self.steps[rows],
            start=np.where(settling, self._limit_start[rows], self.stage_start[rows]),
            risen=self.stage_start[rows] + self._risen[rows, stage],
            limit=self._limit_start[rows] + plan.limit[rows, stage],
            goal_since=self._goal_since[rows],
            rest_since=self._rest_since[rows],
            settling=settling,
            snapping=lost & plan.has_bounds[rows, stage],
        )

    def _finish_stage(self, row: int, goal_step: int | None, *, at_rest: bool, at_goal: bool) -> None:
        """End the stage of a structure, or start its wait."""
        if goal_step is None or not self._plan.wait[row, self.stage[row]] > 0:
            self._end_stage(row, goal_step, at_rest=at_rest, at_goal=at_goal)
            return
        self._rested[row] = self._rested[row] if self._rested[row] >= 0 else self.steps[row]
        self._limit_start[row] = self.steps[row]
        self._goal_since[row] = self._rest_since[row] = -1
        self.waiting.append(row)

    def left_to_wait(self, row: int) -> tuple[float, float]:
        """Return the remaining wait of a resting structure in its stage, and the least time of stepping, s."""
        timestep, stage = self._plan.timestep[row], self.stage[row]
        passed = timestep * (self.steps[row] - self._rested[row]) + self.waited[row] - self._waited_before[row]
        left = self._plan.wait[row, stage] - passed
        return float(left) if left > timestep / 2 else 0.0, float(self._plan.hold[row, stage] * timestep)

    def end_wait(self, row: int) -> None:
        """End the stage of a structure that has waited and is at rest."""
        self._end_stage(row, int(self.steps[row] - self._plan.hold[row, self.stage[row]]), at_rest=True, at_goal=True)

    def stop(self, row: int) -> None:
        """End the stage and the run of a structure short of the stage's goal."""
        self._end_stage(row, None, at_rest=False, at_goal=False)
        self.ended[row] = self._stopped[row] = True

    def follow_leader(self, row: int, leader: int) -> None:
        """Copy the progress of another structure, which has had the same motion so far."""
        for values in (
            self.waited,
            self._waited_before,
            self._limit_start,
            self._rested,
            self.steps,
            self.stage,
            self.stage_start,
            self._goal_since,
            self._rest_since,
            self._met,
            self._stopped,
            self._begun,
            self._carried,
        ):
            values[row] = values[leader]
        self.ends[row] = list(self.ends[leader])
        self.diverged_at[row] = self.diverged_at[leader]
        self.ended[row] = self._stopped[row] or self.stage[row] > self._plan.last[row]
        self._begin_stage(row)

    def growing_load(self, row: int) -> tuple[Array, Array, float]:
        """Return the settings before and after a structure's quasi-static stage, (motor,), and its present share.

        Settings are in the model's units.
        """
        return self._before[row], self._after(row), float(self._share[row])

    def longest_stage(self, row: int) -> int:
        """Return the number of steps over which the drive of a structure's quasi-static stage grows."""
        return int(self._plan.limit[row, self.stage[row]])

    def rest_again(self, row: int) -> None:
        """Let a structure that rests without an equilibrium move on in its quasi-static stage.

        Just beyond the drive at which an equilibrium is lost, a structure moves so slowly that it counts as at rest.
        The excess of the drive is then doubled.
        """
        if self._lost[row]:
            self._share[row] = min(2 * self._share[row] - self._lost[row][-1], 1.0)
        self.at_rest[row] = False

    def lose(self, row: int, share: float, beyond: float, steps: int) -> None:
        """Let a structure move until it rests again, because it has lost its equilibrium in its quasi-static stage.

        Args:
            row: number of the structure.
            share: share of the stage at which the equilibrium is lost.
            beyond: share at which the structure moves.
            steps: number of steps that the structure has rested.
        """
        self.steps[row] += steps
        self._limit_start[row] = self.steps[row]
        self._lost[row].append(share)
        self._share[row], self.at_rest[row] = beyond, False

    def end_at_rest(self, row: int, share: float, steps: int, position: Array, *, at_goal: bool) -> None:
        """End the quasi-static stage of a structure at a share of the stage, after a number of steps at rest.

        Args:
            row: number of the structure.
            share: share of the stage.
            steps: number of steps that the structure has rested.
            position: of its joints, (dof,).
            at_goal: whether the goal of the stage, a bound, is met.
        """
        self.steps[row] += steps
        self._share[row], self._begun[row] = share, position
        self._carry(row)
        rests = at_goal or bool(self._plan.ends_at_rest[row, self.stage[row]])
        self._end_stage(row, int(self.steps[row]) if rests else None, at_rest=True, at_goal=rests)

    def _end_moving(self, row: int, goal_step: int | None, *, at_rest: bool) -> None:
        """End the quasi-static stage of a structure that moves, at its goal or because it does not come to rest."""
        self._carry(row)
        self._end_stage(row, goal_step, at_rest=at_rest, at_goal=goal_step is not None)

    def _carry(self, row: int) -> None:
        """Keep the settings of the motors at the end of a quasi-static stage, from which the next one continues."""
        share = self._share[row]
        self._carried[row] = (1 - share) * self._before[row] + share * self._after(row)

    def _after(self, row: int) -> Array:
        """Return the settings of the motors at the full strength of the present stage's drives, (motor,)."""
        return np.asarray(self._plan.torques[row, self.stage[row]].sum(axis=0))

    def _settings(self, row: int) -> Array:
        """Return the settings of the motors while a structure moves in a quasi-static stage, (motor,).

        Points are displaced from where they were at the beginning of the stage.
        """
        share, before = self._share[row], self._before[row]
        return np.asarray((1 - share) * before + share * self._after(row) - np.where(self._displaces, before, 0.0))

    def _begin_stage(self, row: int) -> None:
        """Begin the present stage of a structure; if it is quasi-static, from rest.

        After another quasi-static stage, the settings of the motors change evenly from where they are, except that a
        displacement by a drive that no longer acts is released. After a motion, and at the start, they begin at 0.
        """
        self._settling[row] = self.at_rest[row] = False
        self._share[row], self._lost[row] = 0.0, []
        if self.ended[row] or not self._plan.quasi_static[row, self.stage[row]]:
            return
        before = self.stage[row] - 1
        continued = before >= 0 and bool(self._plan.quasi_static[row, before])
        released = self._displaces & (self._after(row) == 0)
        self._before[row] = np.where(released, 0.0, self._carried[row]) if continued else 0.0
        self._settling[row], self.at_rest[row] = True, continued and self.ends[row][-1].at_rest

    def progress(self, row: int) -> tuple[str, float, float]:
        """Return the name of a structure's stage, the time so far and the longest time of its protocol, s."""
        stages = self._models[row].design.protocol.stages[self.stage[row] :]
        start = float(self.stage_start[row] * self._plan.timestep[row])
        passed = float(self.steps[row] * self._plan.timestep[row])
        return stages[0].name, passed, start + sum(stage.time_limit for stage in stages)

    def _end_stage(self, row: int, goal_step: int | None, *, at_rest: bool, at_goal: bool) -> None:
        stage = self._models[row].design.protocol.stages[self.stage[row]]
        goes_on = not self._plan.has_bounds[row, self.stage[row]] and not self._plan.wait[row, self.stage[row]] > 0
        # what does not come to rest has no equilibria to follow
        goes_on = goes_on and (at_rest or not stage.quasi_static)
        timestep = float(self._plan.timestep[row])
        self.ends[row].append(
            StageEnd(
                stage=stage,
                start=int(self.stage_start[row]) * timestep,
                end=int(self.steps[row]) * timestep,
                goal_time=None if goal_step is None else goal_step * timestep,
                at_rest=at_rest,
                at_goal=at_goal,
                waited=float(self.waited[row] - self._waited_before[row]),
                share=float(self._share[row]) if stage.quasi_static else None,
                lost=tuple(self._lost[row]),
                met=bool(self._met[row]) if goal_step is None else None,
            )
        )
        self._waited_before[row] = self.waited[row]
        self._met[row] = False
        self._stopped[row] = goal_step is None and not goes_on
        self.ended[row] = self._stopped[row] or self.stage[row] == self._plan.last[row]
        self.stage[row] += 1
        self.stage_start[row] = self._limit_start[row] = self.steps[row]
        self._goal_since[row] = self._rest_since[row] = self._rested[row] = -1
        self._begin_stage(row)
