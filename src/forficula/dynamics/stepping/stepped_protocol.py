"""A protocol in steps and in a model's units, which can be simulated without the design."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.design import stage_drives
from forficula.dynamics.engine.closures import LARGEST_GAP
from forficula.dynamics.engine.model import Model
from forficula.dynamics.stepping.stage_plan import NEVER, divergence_bounds, longest_rest, rest_speeds, stage_goal
from forficula.structure import Drive, StageGoal, drive_unit


@dataclass(frozen=True, kw_only=True)
class SteppedDrive:
    """A drive that a stage may switch on.

    Attributes:
        drive: of the structure, SI.
        unit: SI unit of its strength.
        torques: of every motor for a strength of 1 in that unit, in the model's units, (motor,).
        rise: duration of the rise, in steps.
    """

    drive: Drive
    unit: str
    torques: Array
    rise: float


@dataclass(frozen=True, kw_only=True)
class SteppedStage:
    """A stage of a protocol.

    Attributes:
        name: of the stage.
        drives: numbers of the acting drives.
        goal: that ends the stage, in the model's units.
        hold: number of steps for which the goal must hold.
        limit: largest number of steps.
    """

    name: str
    drives: tuple[int, ...]
    goal: StageGoal
    hold: int
    limit: int


@dataclass(frozen=True, kw_only=True)
class SteppedProtocol:
    """The protocol of a structure in steps.

    Attributes:
        timestep: s.
        explicit: whether steps are those of Runge and Kutta instead of semi-implicit Euler.
        drives: of the structure.
        stages: in order.
        rest_speeds: speeds below which every coordinate is at rest, in the model's units, (dof,).
        window: averaging window of states, in steps.
        stuck: number of steps at rest short of the goal after which a structure is stuck.
        least_hold: time for which a goal must hold, as a share of the time to the goal.
        interval: between two rows of a record, in steps.
        lowest: positions below which a run has diverged, (position,).
        highest: positions above which a run has diverged, (position,).
        largest_gap: allowed gap of creases that close loops, in the model's units.
    """

    timestep: float
    explicit: bool
    drives: tuple[SteppedDrive, ...]
    stages: tuple[SteppedStage, ...]
    rest_speeds: Array
    window: float
    stuck: int
    least_hold: float
    interval: int
    lowest: Array
    highest: Array
    largest_gap: float


def stepped_protocol(model: Model) -> SteppedProtocol:
    """Return a model's protocol in steps."""
    protocol, structure = model.design.protocol, model.structure
    timestep = float(protocol.timestep)
    names = [drive.name for drive in structure.drives]
    lowest, highest = divergence_bounds(model)

    def steps(time: float) -> int:
        return round(min(time, NEVER * timestep) / timestep)

    return SteppedProtocol(
        timestep=timestep,
        explicit=model.explicit,
        drives=tuple(
            SteppedDrive(
                drive=drive,
                unit=drive_unit(structure, drive),
                torques=np.array(drive.shares) * _strength_unit(model, drive),
                rise=drive.rise / timestep,
            )
            for drive in structure.drives
        ),
        stages=tuple(
            SteppedStage(
                name=stage.name,
                drives=tuple(names.index(name) for name in stage_drives(stage)),
                goal=stage_goal(model, stage),
                hold=steps(stage.hold),
                limit=steps(stage.time_limit),
            )
            for stage in protocol.stages
        ),
        rest_speeds=rest_speeds(model),
        window=protocol.window / timestep,
        stuck=steps(longest_rest(model)),
        least_hold=protocol.least_hold,
        interval=max(1, steps(protocol.sample_interval)),
        lowest=lowest,
        highest=highest,
        largest_gap=LARGEST_GAP * structure.span / model.units.length,
    )


def _strength_unit(model: Model, drive: Drive) -> float:
    """Return the SI unit of a drive's strength in the model's units."""
    units = {"N m": model.units.energy, "N": model.units.energy / model.units.length, "m": model.units.length}
    return 1 / units.get(drive_unit(model.structure, drive), 1.0)
