"""Endings of runs that are certain before the run ends, because its energy is too small for another outcome.

Derivation: docs/model/reliability.md, section When a repetition ends early.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from forficula.analysis import Outcome, Verdict
from forficula.arrays import Array
from forficula.design import stage_drives
from forficula.dynamics import Record
from forficula.statics.tree.energy_bound import EnergyBound, bounds_hinges_only, has_bound, torques_of
from forficula.structure import StageGoal, Structure, drive_of, goal_of


@dataclass(frozen=True, kw_only=True)
class CertainEnding:
    """The last stage of a run, and how the stage ends: the structure keeps a goal, or stays short of a goal.

    Attributes:
        stage: number of the stage.
        goal: the goal, bounds on angles of hinges.
        kept: whether the structure keeps the goal; otherwise it stays short of the goal.
        rise: time in the stage from which the torques are constant, s.
        bound: lower bound of the energy in this stage.
    """

    stage: int
    goal: StageGoal
    kept: bool
    rise: float
    bound: EnergyBound

    def is_certain(self, passed: float, angles: Array, energy: float) -> bool:
        """Return whether a run of the same protocol is certain to end in this manner.

        Args:
            passed: time in the stage, s.
            angles: of its hinges in own senses, rad, (hinge,).
            energy: energy of motion and of all elements, J.
        """
        if passed < self.rise:
            return False
        ends = self.bound.keeps if self.kept else self.bound.misses
        return ends(self.goal, angles, energy)


def certain_ending(record: Record, outcome: Outcome) -> CertainEnding | None:
    """Return the ending of a run if the energy of another run can show that both end in the same manner; else None."""
    structure, number = record.structure, len(record.stages) - 1
    stage = record.stages[number].stage
    if stage.quasi_static or stage.wait or record.design.protocol.device is not None:
        return None
    if not stage_drives(stage):
        return _ending(structure, number, _kept_goal(record, outcome), kept=True)
    missed = record.stages[number].goal_time is None and outcome.verdict in (Verdict.STUCK, Verdict.MOVING)
    goal = goal_of(structure, stage.until) if missed else None
    return _ending(structure, number, goal, stage_drives(stage), kept=False)


def _ending(
    structure: Structure, stage: int, goal: StageGoal | None, drives: tuple[str, ...] = (), *, kept: bool
) -> CertainEnding | None:
    drives_of_stage = [drive_of(structure, name) for name in drives]
    strengths = np.zeros(len(structure.motors))
    for drive in drives_of_stage:
        strengths += drive.strengths
    torques = torques_of(structure, strengths)
    if goal is None or torques is None or not bounds_hinges_only(goal, len(structure.hinges)):
        return None
    if not has_bound(structure, torques):
        return None
    return CertainEnding(
        stage=stage,
        goal=goal,
        kept=kept,
        rise=max((drive.rise for drive in drives_of_stage), default=0.0),
        bound=EnergyBound(structure=structure, torques=torques),
    )


def _kept_goal(record: Record, outcome: Outcome) -> StageGoal | None:
    """Return the goal that the last stage, a release, kept after the transition before it; None if it did not."""
    structure, last = record.structure, len(record.stages) - 1
    for transition in structure.transitions:
        if transition.stage != last - 1 or structure.stage_states[last] != transition.state:
            continue
        if record.stages[last - 1].stage.until == transition.goal and outcome.holds[transition.state]:
            return goal_of(structure, transition.released)
    return None
