"""Recording of one structure's motion: rows at the sample interval, and the work done between them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array, Flags, Indices
from forficula.dynamics.energies.energy import state_energies, state_series
from forficula.dynamics.energies.work_balance import (
    motor_force_name,
    motor_power_name,
    motor_setting_name,
    motor_work_name,
)
from forficula.dynamics.engine.closures import APART_TEXT, LARGEST_GAP
from forficula.dynamics.engine.contact_geometry import overlap_doubt
from forficula.dynamics.engine.model import Model
from forficula.dynamics.record import Record, StageEnd
from forficula.dynamics.stepping.stage_plan import NEVER
from forficula.dynamics.stepping.steps import MEMORY, EngineState, Steps


@dataclass(frozen=True, kw_only=True)
class Chunk:
    """Some steps of many structures; those of each structure are within one stage.

    Attributes:
        steps: of all structures, in their models' units.
        first: number of the first step of each structure, (structure,).
        begins: whether the stage begins with this step, (structure,).
        taken: number of each structure's steps that count, (structure,).
        account: by name, the work since the start before each step, J, and the powers in it, W, (structure, step).
    """

    steps: Steps
    first: Indices
    begins: Flags
    taken: Indices
    account: Mapping[str, Array]


@dataclass(frozen=True, kw_only=True)
class _Rows:
    """Kept states, (row, ...), in the model's units, and work and power until then, SI."""

    number: Indices
    angle: Array
    derived: Mapping[str, Array]
    account: Mapping[str, Array]


# a slice of rows, to avoid copies
_Part = tuple[_Rows, slice]


class Recorder:
    """Recorder of one structure's motion."""

    def __init__(self, model: Model, sparse: bool) -> None:
        """Start without rows; if sparse, only rows that the states at the ends of stages need will be kept."""
        self.model = model
        self._sparse = sparse
        protocol = model.design.protocol
        self._timestep = float(protocol.timestep)  # s
        longest = NEVER * self._timestep
        self._window = round(min(protocol.window, longest) / self._timestep)
        self.interval = max(1, round(min(protocol.sample_interval, longest) / self._timestep))  # steps
        # the rows of each stage so far, in parts
        self._stages: list[list[_Part]] = []
        # number of the step with the largest kinetic energy before it, and that energy, in the model's units
        self._peak = (0, -np.inf)
        # largest change of length of taut tendons in a step, in the model's units, (tendon,), if laws have a rate limit
        materials = [tendon.material for tendon in model.structure.tendons]
        tested = [material is not None and material.highest_strain_rate is not None for material in materials]
        self._fastest = None if sparse or not any(tested) else np.full(len(tested), np.nan)
        self._last: tuple[Array, Flags] | None = None
        self._leaps = any(stage.wait for stage in protocol.stages)

    def fork(self, model: Model) -> Recorder:
        """Return a recorder for another structure, which has had the same motion so far."""
        other = Recorder(model, self._sparse)
        other._stages = [[*parts] for parts in self._stages]
        other._peak, other._last = self._peak, self._last
        other._fastest = None if self._fastest is None else self._fastest.copy()
        return other

    def add(self, rows: _Rows, selected: slice, chunk: Chunk, place: int) -> None:
        """Keep some rows of one structure of the chunk; the first row begins the stage if the stage begins there."""
        if chunk.begins[place]:
            if self._stages:
                self._close_stage()
            first = slice(selected.start, selected.start + 1)
            self._stages.append([_joined([(rows, first)])])
            selected = slice(first.stop, selected.stop)
        parts = self._stages[-1]
        if selected.start < selected.stop:
            parts.append((rows, selected))
        if self._sparse:
            oldest = chunk.first[place] + chunk.taken[place] - self._window
            while len(parts) > 2 and parts[2][0].number[parts[2][1]][0] <= oldest:
                del parts[1]

    def add_at_rest(
        self, number: Indices, states: Sequence[EngineState], account: Mapping[str, Array], *, begins: bool
    ) -> None:
        """Keep states at rest between two chunks of steps.

        Args:
            number: numbers of the steps before which the structure is in these states, (row,).
            states: as many.
            account: as for a chunk, (row,).
            begins: whether the first state begins a stage.
        """
        rows = _Rows(
            number=number,
            angle=np.array([state.angle for state in states]),
            derived={
                name: np.array([state.derived[name] for state in states]) for name in self._stages[-1][0][0].derived
            },
            account=account,
        )
        if begins:
            self._close_stage()
            self._stages.append([])
        self._stages[-1].append((rows, slice(None)))
        # the rate at which tendons lengthen is not that of a motion
        self._last = None

    def update_kinetic_peak(self, number: int, energy: float) -> None:
        """Update the peak with the kinetic energy before a step, in the model's units."""
        if energy > self._peak[1]:
            self._peak = number, energy

    def update_strain_rates(self, chunk: Chunk, place: int) -> None:
        """Update the highest rates at which taut tendons lengthen or shorten with the steps of a chunk."""
        if self._fastest is None:
            return
        model, steps, taken = self.model, chunk.steps, int(chunk.taken[place])
        length = steps.derived["ten_length"][place, :taken][:, model.tendons]
        slack = np.tile(np.asarray(model.elastic.rest_length, dtype=np.float64), (taken, 1))
        if (yielding := model.creep >= 0).any():
            crept = steps.states(np.full(taken, place), np.arange(taken), steps.inner["plastic"])
            slack[:, yielding] = crept[:, model.creep[yielding]]
        taut = length > slack
        if self._last is not None:
            length, taut = (
                np.concatenate([one[None], every]) for one, every in zip(self._last, (length, taut), strict=True)
            )
        change = np.where(taut[1:] & taut[:-1], np.abs(np.diff(length, axis=0)), np.nan)
        self._fastest = np.fmax(self._fastest, np.fmax.reduce(change, axis=0, initial=np.nan))
        # a wait between two chunks skips time
        self._last = None if self._leaps or not len(length) else (length[-1].copy(), taut[-1])

    def record(
        self,
        step: int,
        start: EngineState,
        end: EngineState,
        account: Mapping[str, float],
        stages: tuple[StageEnd, ...],
        diverged_at: float | None,
    ) -> Record:
        """Return the record; its last row is the final state of the structure.

        Args:
            step: number of steps.
            start: first state.
            end: final state.
            account: the work since the start, J, and the powers in the final state, W.
            stages: stages that took place.
            diverged_at: when the structure diverged, s, or None.
        """
        recorded = self._stages[-1][0][0].derived
        last = _Rows(
            number=np.array([step]),
            angle=end.angle[None],
            derived={name: end.derived[name][None] for name in recorded},
            account={name: np.array([value]) for name, value in account.items()},
        )
        self._stages[-1].append((last, slice(None)))
        self._close_stage()
        rows, _ = _joined([part for parts in self._stages for part in parts])
        works = self._works(rows.account)
        efforts = works.pop("motor_setting")
        series = {**state_series(self.model, rows.angle, rows.derived, efforts), **works}
        if self._sparse:
            series |= self._energies_at_ends(start, end, len(rows.number))
        return Record(
            design=self.model.design,
            structure=self.model.structure,
            time=np.asarray(rows.number * self._timestep),
            series=series,
            stages=stages,
            diverged_at=diverged_at,
            doubt=self._closure_doubt(account) or self._contact_doubt(account),
            kinetic_peak=self._kinetic_peak(),
            strain_rates=self._strain_rates(),
        )

    def _strain_rates(self) -> Array | None:
        """Return the highest strain rates of taut tendons, 1/s, (tendon,); None if they were not recorded."""
        if self._fastest is None:
            return None
        gauge = [tendon.gauge_length or np.nan for tendon in self.model.structure.tendons]
        return np.asarray(self.model.units.length * self._fastest / self._timestep / gauge)

    def _kinetic_peak(self) -> tuple[float, float] | None:
        """Return time, s, and value, J, of the largest kinetic energy; None if not every step was recorded."""
        number, energy = self._peak
        if not np.isfinite(energy):
            return None
        return float(number * self._timestep), float(self.model.units.energy * energy)

    def _closure_doubt(self, account: Mapping[str, float]) -> str:
        """Return why the run is unreliable if closures opened by more than a thousandth of the structure's size."""
        gap, span = account.get("closure_gap", 0.0), self.model.structure.span
        if gap <= LARGEST_GAP * span:
            return ""
        return APART_TEXT.format(share=f"{gap / span:.2g}")

    def _contact_doubt(self, account: Mapping[str, float]) -> str:
        """Return why the run is unreliable if parts that touch overlap by more than half their thickness."""
        contact = self.model.structure.contact
        return "" if contact is None else overlap_doubt(contact, account.get("contact_overlap", 0.0))

    def _works(self, account: Mapping[str, Array]) -> dict[str, Array]:
        """Return works and powers, those of all motors as one array each, (row, motor)."""
        series = dict(account)
        if not any(stage.wait for stage in self.model.design.protocol.stages):
            # another structure waits, but not this one
            series.pop("waited", None)
        if not any(stage.quasi_static for stage in self.model.design.protocol.stages):
            series.pop("settling_work", None)
        contact = self.model.structure.contact
        if contact is None or not contact.friction:
            series.pop("friction_spring_energy", None)
        motors = range(len(self.model.structure.motors))
        for name, of_motor in (
            ("motor_work", motor_work_name),
            ("motor_power", motor_power_name),
            ("motor_setting", motor_setting_name),
        ):
            columns = [series.pop(of_motor(motor)) for motor in motors]
            series[name] = np.stack(columns, axis=1) if columns else np.zeros((len(series["stop_work"]), 0))
        forces = {motor: series.pop(motor_force_name(motor)) for motor in motors if motor_force_name(motor) in series}
        if forces:
            series["motor_force"] = np.full_like(series["motor_work"], np.nan)
            series["motor_force"][:, list(forces)] = np.stack(list(forces.values()), axis=1)
        return series

    def _energies_at_ends(self, start: EngineState, end: EngineState, count: int) -> dict[str, Array]:
        """Return the energies that sparse rows lack, J, (row,): known at the start and at the end, nan between."""
        energies: dict[str, Array] = {}
        for place, state in ((0, start), (-1, end)):
            derived = {name: values[None] for name, values in state.derived.items()}
            for name, values in state_energies(self.model, derived).items():
                energies.setdefault(name, np.full(count, np.nan))[place] = values[0]
        return energies

    def _close_stage(self) -> None:
        """Copy the stage's rows into one part, so that the chunks of all structures can be freed."""
        parts = self._stages[-1]
        parts[:] = [_joined(parts)]


def keep_rows(recorders: Sequence[Recorder], chunk: Chunk) -> None:
    """Keep the states of a chunk's structures at their sample intervals and at the beginning of stages."""
    steps, step = chunk.steps, np.arange(chunk.steps.after.shape[1])
    number = chunk.first[:, None] + step
    if "energy" in steps.kept:
        kinetic = np.where(step < chunk.taken[:, None], steps.derived["energy"][..., 1], -np.inf)
        kinetic[~np.isfinite(kinetic)] = -np.inf  # diverging structures
        for place, most in enumerate(kinetic.argmax(axis=1).tolist()):
            recorders[place].update_kinetic_peak(int(number[place, most]), float(kinetic[place, most]))
    for place, recorder in enumerate(recorders):
        recorder.update_strain_rates(chunk, place)
    interval = np.array([recorder.interval for recorder in recorders])
    kept = (number % interval[:, None] == 0) & (step < chunk.taken[:, None])
    # also the beginning of a stage, even if its first step diverges
    kept |= chunk.begins[:, None] & (step == 0)
    # for all structures at once, which replaces thousands of calls by a few
    structure, before = np.nonzero(kept)
    inner = {name: steps.states(structure, before, place) for name, place in steps.inner.items()}
    angles = _angles(recorders, steps, structure, before)
    if steps.memory is not None:
        inner[MEMORY] = _memory(recorders, steps, structure, before, angles)
    rows = _Rows(
        number=number[structure, before],
        angle=angles,
        derived={name: steps.derived[name][structure, before] for name in steps.kept} | inner,
        account={name: values[structure, before] for name, values in chunk.account.items()},
    )
    bounds = [0, *np.cumsum(kept.sum(axis=1)).tolist()]
    for place in np.flatnonzero(kept.any(axis=1)).tolist():
        recorders[place].add(rows, slice(bounds[place], bounds[place + 1]), chunk, place)


def _angles(recorders: Sequence[Recorder], steps: Steps, structure: Indices, before: Indices) -> Array:
    """Return the angles of all hinges in the kept states, in own senses, rad, (row, hinge)."""
    positions = steps.states(structure, before, slice(1, 1 + steps.positions))
    if steps.angles is None:
        senses = np.array([recorder.model.folds.senses for recorder in recorders])[structure]
        return np.asarray(senses * positions[:, recorders[0].model.folds.joints])
    angles = np.zeros((len(positions), len(recorders[0].model.folds.senses)))
    for place in np.unique(structure).tolist():
        rows, folds = structure == place, recorders[place].model.folds
        every = np.arange(angles.shape[1])
        angles[rows] = steps.angles_of(folds, place, positions[rows], before[rows], every)
    return angles


def _memory(recorders: Sequence[Recorder], steps: Steps, structure: Indices, before: Indices, angles: Array) -> Array:
    """Return the memory of creases in the kept states with the angles of all hinges, (row, slot, crease)."""
    assert steps.memory is not None
    memory = np.zeros((len(before), len(steps.memory), steps.memory.shape[-1]))
    for place in np.unique(structure).tolist():
        rows, model = structure == place, recorders[place].model
        at = steps.memory_at(model, place, before[rows], angles[rows][:, model.followed_hinges])
        memory[rows] = np.moveaxis(at, 0, 1)
    return memory


def _joined(parts: Sequence[_Part]) -> _Part:
    """Return rows one after another, copied."""
    first, _ = parts[0]
    rows = _Rows(
        number=np.concatenate([rows.number[selected] for rows, selected in parts]),
        angle=np.concatenate([rows.angle[selected] for rows, selected in parts]),
        derived={
            name: np.concatenate([rows.derived[name][selected] for rows, selected in parts]) for name in first.derived
        },
        account={
            name: np.concatenate([rows.account[name][selected] for rows, selected in parts]) for name in first.account
        },
    )
    return rows, slice(None)
