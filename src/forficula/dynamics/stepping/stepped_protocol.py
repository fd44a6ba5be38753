"""A protocol in steps and in a model's units: what goes through it needs no design any more."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.design import stage_drives
from forficula.dynamics.engine.closures import LARGEST_GAP
from forficula.dynamics.engine.model import Model
from forficula.dynamics.stepping.stage_plan import NEVER, far_beyond, longest_rest, rest_speeds, stage_goal
from forficula.structure import Drive, StageGoal, drive_unit


@dataclass(frozen=True, kw_only=True)
class SteppedDrive:
    """What a stage may switch on.

    Attributes:
        drive: of the structure, SI.
        unit: SI unit of its strength.
        torques: on every motor for a strength of 1 in that unit, in the model's units, (motor,).
        rise: over which they rise, in steps.
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
        drives: numbers of those that act.
        goal: that ends it, in the model's units.
        hold: for how many steps it must hold.
        limit: the most steps.
    """

    name: str
    drives: tuple[int, ...]
    goal: StageGoal
    hold: int
    limit: int


@dataclass(frozen=True, kw_only=True)
class SteppedProtocol:
    """What a structure goes through.

    Attributes:
        timestep: s.
        explicit: whether steps are those of Runge and Kutta, and not of semi-implicit Euler.
        drives: of the structure.
        stages: in order.
        rest_speeds: below which every velocity is at rest, in the model's units, (dof,).
        window: over which states are averaged, in steps.
        stuck: for how many steps what rests short of its goal must rest to be stuck.
        least_hold: for how long a goal must hold, by the time that it took.
        interval: between two rows of a record, in steps.
        lowest: positions below which nothing sound is, (position,).
        highest: alike.
        largest_gap: by which creases that close loops may come apart, in the model's units.
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
    """Write a model's protocol in steps."""
    protocol, structure = model.design.protocol, model.structure
    timestep = float(protocol.timestep)
    names = [drive.name for drive in structure.drives]
    lowest, highest = far_beyond(model)

    def steps(time: float) -> int:
        return round(min(time, NEVER * timestep) / timestep)

    return SteppedProtocol(
        timestep=timestep,
        explicit=model.explicit,
        drives=tuple(
            SteppedDrive(
                drive=drive,
                unit=drive_unit(structure, drive),
                torques=np.array(drive.shares) * _unit(model, drive),
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


def _unit(model: Model, drive: Drive) -> float:
    """The SI unit of a drive's strength in the model's units."""
    units = {"N m": model.units.energy, "N": model.units.energy / model.units.length, "m": model.units.length}
    return 1 / units.get(drive_unit(model.structure, drive), 1.0)
