"""States of a run: means over the end of the stages that name them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np

from forficula.analysis.confirmation import StateValues
from forficula.arrays import Array
from forficula.design import stage_drives
from forficula.dynamics import Record, StageEnd
from forficula.quantities import reading_unit, show_value
from forficula.structure import RestState, StageGoal, Structure, goal_coordinates, goal_of, measure_of, state_of

_STIR = np.radians(0.1)
_STIR_SHARE = 1e-3  # of the size of the structure
_SHOWN = 1e-3  # share of a reading from which half its range is shown
# kinds of elastic parts besides tendons; a state has an energy for each kind that the structure has
SPRUNG = ("hinge", "spring", "coupling")


@dataclass(frozen=True, kw_only=True)
class Reading:
    """Readings of a measure over a time window: one per hinge of an angle, rad, or a distance, m, (reading,).

    Attributes:
        kind: "angle" or "distance".
        mean: means over the window.
        low: lowest values.
        high: highest values.
    """

    kind: Literal["angle", "distance"]
    mean: Array
    low: Array
    high: Array

    def __repr__(self) -> str:
        """Return the means in the units of tables, with half the range where they swing."""
        if self.kind == "angle":
            unit, factor = "deg", float(np.degrees(1.0))
        else:
            unit, factor = reading_unit("m", float(np.abs(self.mean).max(initial=0)))
        halves = factor * (self.high - self.low) / 2
        values = (
            f"{value:.4g}{f' ± {half:.2g}' if half >= _SHOWN * abs(value) else ''}"
            for value, half in zip((factor * self.mean).tolist(), halves.tolist(), strict=True)
        )
        return f"{', '.join(values)} {unit}"


@dataclass(frozen=True, kw_only=True)
class State:
    """A state that a protocol names: means over the last part of a stage, and whether it still swings.

    Attributes:
        name: such as "folded".
        time: end of the stage, s.
        coordinates: means of the coordinates that goals bound, rad or m, the angles of all hinges first, (coordinate,).
        readings: by name of the measure.
        tendon_length: m, (tendon,).
        tendon_energy: J, (tendon,).
        membrane_energy: J; nan in a sparse record of a structure with membranes.
        hinge_energy: of the hinges' springs, J, (hinge,); None if no hinge has a spring.
        spring_energy: of the springs between points, J, (spring,); None if there are none.
        coupling_energy: of the couplings between joints, J, (coupling,); None if none is elastic.
        within: whether the coordinates are within the bounds of the named state.
        swings: whether a measure still moves, an angle by more than 0.1 deg or a distance by more than 0.1 % of the
            structure's size.
        furthest: reading furthest from the goal of the transition to this state, rad or m; for other states, the
            largest reading of the first measure; None where nothing is measured.
        furthest_kind: kind of that measure.
    """

    name: str
    time: float
    coordinates: Array
    readings: Mapping[str, Reading]
    tendon_length: Array
    tendon_energy: Array
    membrane_energy: float
    hinge_energy: Array | None
    spring_energy: Array | None
    coupling_energy: Array | None
    within: bool
    swings: bool
    furthest: float | None
    furthest_kind: Literal["angle", "distance"]

    @property
    def values(self) -> StateValues:
        """Return the numbers of the state, SI: readings by the name of their measure, others by names with a dot.

        Energies of parts that the structure lacks are absent, and energies of membranes in a sparse record.
        """
        stored = {kind: getattr(self, f"{kind}_energy") for kind in SPRUNG}
        return {
            **{name: reading.mean for name, reading in self.readings.items()},
            "goal.coordinates": self.coordinates,
            "tendon.length": self.tendon_length,
            "tendon.energy": self.tendon_energy,
            **({"membrane.energy": np.array([self.membrane_energy])} if np.isfinite(self.membrane_energy) else {}),
            **{f"{kind}.energy": energy for kind, energy in stored.items() if energy is not None},
        }

    def __repr__(self) -> str:
        """Return the readings and the energy of the tendons, in the units of tables."""
        parts = [f"{name} {reading!r}" for name, reading in self.readings.items()]
        parts += [f"tendons {show_value(float(self.tendon_energy.sum()), 'J')}"] if len(self.tendon_energy) else []
        return f"<{self.name} at {show_value(self.time, 's')}: {'; '.join(parts) or 'nothing is measured'}>"


def stage_end_state(record: Record, end: StageEnd, name: str) -> State:
    """Return the state at the end of a stage, with the name and the goal of a named state."""
    snapped = bool(stage_drives(end.stage)) and end.goal_time is not None
    # a stage that ends at its goal ends in motion, and a quasi-static stage while its drive still changes
    at_end = snapped or end.stage.quasi_static
    start = end.end if at_end else max(end.start, end.end - record.design.protocol.window)
    if end.stage.until == "rest" and end.goal_time is not None:
        start = max(start, end.goal_time)  # it still moved before
    # half a step either way, because times are multiples of the timestep up to rounding
    half = float(record.design.protocol.timestep) / 2
    # as row numbers, because applying a mask to every series takes longer
    window = np.flatnonzero((record.time >= start - half) & (record.time <= end.end + half))
    distances = record.series.get("distance")
    coordinates = goal_coordinates(
        record.structure, record.series["hinge_angle"][window], None if distances is None else distances[window]
    )
    readings = {}
    # the measures, and groups of hinges by role that goals of transitions bound without being measures
    watched = [
        *(measure.name for measure in record.structure.measures),
        *(t.measure for t in record.structure.transitions),
    ]
    for measure_name in dict.fromkeys(watched):
        values = record.measured(measure_name)[window]
        measure = measure_of(record.structure, measure_name)
        readings[measure_name] = Reading(
            kind="angle" if measure is None else measure.kind,
            mean=values.mean(axis=0),
            low=values.min(axis=0),
            high=values.max(axis=0),
        )
    swung = [readings[measure.name] for measure in record.structure.measures if measure.kind == "angle"]
    far = _STIR_SHARE * record.structure.span
    moved = [readings[measure.name] for measure in record.structure.measures if measure.kind == "distance"]
    mean, rest_state = coordinates.mean(axis=0), state_of(record.structure, name)
    hinges, springs, couplings = (
        record.series[series][window].mean(axis=0) if (series := f"{kind}_energy") in record.series else None
        for kind in SPRUNG
    )
    furthest, kind = _furthest(record.structure, name, readings)
    return State(
        name=name,
        time=end.end,
        coordinates=mean,
        readings=readings,
        tendon_length=record.series["tendon_length"][window].mean(axis=0),
        tendon_energy=record.series["tendon_energy"][window].mean(axis=0),
        membrane_energy=float(record.series["membrane_energy"][window].mean()) if record.structure.membranes else 0.0,
        hinge_energy=hinges,
        spring_energy=springs,
        coupling_energy=couplings,
        within=rest_state is not None and within_bounds(mean, goal_of(record.structure, rest_state.goal)),
        swings=any(bool(np.any(reading.high - reading.low > _STIR)) for reading in swung)
        or any(bool(np.any(reading.high - reading.low > far)) for reading in moved),
        furthest=furthest,
        furthest_kind=kind,
    )


def named_state(record: Record, state: RestState) -> State | None:
    """Return a state that no transition leads to, at the end of the stage that names it."""
    names = record.structure.stage_states
    number = names.index(state.name) if state.name in names else len(names)
    return (
        stage_end_state(record, record.stages[number], state.name) if ended_without_divergence(record, number) else None
    )


def within_bounds(coordinates: Array, bounds: StageGoal) -> bool:
    """Return whether coordinates are within the bounds of a goal."""
    return bool(np.all((coordinates >= bounds.least) & (coordinates <= bounds.most)))


def ended_without_divergence(record: Record, stage: int) -> bool:
    """Return whether a stage took place without diverging."""
    return len(record.stages) > stage and (record.diverged_at is None or stage < len(record.stages) - 1)


def _furthest(
    structure: Structure, state: str, readings: Mapping[str, Reading]
) -> tuple[float | None, Literal["angle", "distance"]]:
    """Return the reading furthest from the goal of a state, and its kind."""
    for transition in structure.transitions:
        if transition.state == state and transition.measure in readings:
            mean = readings[transition.measure].mean
            return float(np.max(mean) if transition.furthest == "largest" else np.min(mean)), transition.kind
    for measure in structure.measures:
        return float(np.max(readings[measure.name].mean)), measure.kind
    return None, "angle"
