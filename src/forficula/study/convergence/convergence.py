"""Convergence study: the same run at several timesteps, membrane moduli or meshes."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from forficula.analysis import Verdict
from forficula.arrays import Array, Flags
from forficula.design import Design, with_values
from forficula.dynamics import Model, check_available, check_device, compile_model
from forficula.dynamics.stepping.simulate import simulate_each
from forficula.errors import InputError
from forficula.quantities import as_written
from forficula.results import Result, pandas_module
from forficula.statics.survey import check_quasi_static, stage_rest_path
from forficula.study.convergence.observed_order import OrderFit, fit_order
from forficula.study.convergence.refinement import (
    MESH,
    TIMESTEP,
    YOUNGS_MODULUS,
    check_values,
    own_value,
    row_count,
    same,
    value_text,
    with_value,
)
from forficula.study.running.runs import resolved
from forficula.study.running.timed_run import TimedRun, timed_run
from forficula.study.tables.verdict import judge_moves, judge_timestep

if TYPE_CHECKING:
    from forficula.results import DataFrame

Progress = Callable[[int, int, dict[str, Any]], None]

# Largest number of rows of a record. A very short timestep would otherwise fill the memory.
_MOST_ROWS = 100_000


@dataclass(frozen=True, kw_only=True)
class Convergence(Result):
    """Runs of one design at several values of one setting, from coarse to fine or from soft to stiff.

    Attributes:
        design: the design.
        key: `TIMESTEP`, `YOUNGS_MODULUS` or `MESH`.
        values: timesteps in s, moduli in Pa, or refinement factors of the mesh, (run,).
        design_value: the design's own value, one of `values`.
        rows: rows of the membrane's mesh, by run.
        statuses: outcome of each run, in a few words.
        verdicts: verdict of each run.
        transition_times: by transition, time from the start of its stage until all that its goal bounds has crossed the
            bound for the last time, s, nan if the transition failed, (run,).
        starts: by transition, start time of its stage, s, nan if it did not start, (run,).
        orders: by transition, how its time depends on the timestep; None for another key, or without two times to
            compare.
        times: times of the rows of each run, s, (row,).
        hinge: index of the displayed hinge among those of the first measure, from 0.
        angles: reading of the first measure at this hinge in each run, rad, (row,).
        tolerance: largest allowed difference from the limit, as a fraction of the limit.
        fine: whether the design's own timestep is fine enough; None if this cannot be decided, or for another key.
        verdict: conclusion, in a sentence.
    """

    design: Design
    key: str
    values: Array
    design_value: float
    rows: tuple[int, ...]
    statuses: tuple[str, ...]
    verdicts: tuple[Verdict, ...]
    transition_times: Mapping[str, Array]
    starts: Mapping[str, Array]
    orders: Mapping[str, OrderFit | None]
    times: tuple[Array, ...]
    hinge: int
    angles: tuple[Array, ...]
    tolerance: float
    fine: bool | None
    verdict: str

    def __repr__(self) -> str:
        """Design, key and verdict."""
        return f"<Convergence of {self.design.name} over {self.key}: {self.verdict}>"

    def to_dataframe(self) -> DataFrame:
        """Return the runs as a pandas table: value of the setting, SI, verdict, status, time of each transition, s."""
        pandas = pandas_module()

        words = {"verdict": [verdict.value for verdict in self.verdicts], "status": list(self.statuses)}
        times = {f"{name}_time_s": time for name, time in self.transition_times.items()}
        return pandas.DataFrame(words | times, index=pandas.Index(self.values, name=self.key))

    @property
    def own_verdict(self) -> Verdict:
        """Verdict of the run at the design's own value."""
        return self.verdicts[int(np.flatnonzero(self.values == self.design_value)[0])]


def converge(
    design: Design,
    key: str,
    values: Sequence[float],
    *,
    tolerance: float = 0.02,
    hinge: int | None = None,
    progress: Progress | None = None,
) -> Convergence:
    """Run a design at several timesteps, membrane moduli or meshes, and compare the results.

    The design's own value is always run, even if it is not in `values`.

    Args:
        design: the design.
        key: `TIMESTEP`, `YOUNGS_MODULUS`, or `MESH`.
        values: at least two, in any order: s, Pa, or whole numbers by which the spacing of the mesh's rows is divided.
        tolerance: a timestep is fine enough if every time deviates from its limit by at most this fraction.
        hinge: index of the hinge to display, among those of the first measure, from 0. By default, or if there are
            fewer hinges, the last one.
        progress: called after each run with the number of completed runs, the number of all runs, and the verdict and
            the word for the outcome of the last run, as a row.

    Raises:
        InputError: another key, fewer than two values, equal values, or a value that the design does not allow.
    """
    if key not in (TIMESTEP, YOUNGS_MODULUS, MESH):
        raise InputError(f"key: need {TIMESTEP}, {YOUNGS_MODULUS} or {MESH}, got {as_written(key)}")
    check_values(key, values)
    design = resolved(design) if key == TIMESTEP else design
    design_value = own_value(design, key)
    # timesteps are ordered from coarse to fine, the other settings from soft or coarse to stiff or fine
    ordered = sorted(
        [design_value, *(value for value in values if not same(value, design_value))], reverse=key == TIMESTEP
    )
    models = [compile_model(_with_dense_record(resolved(with_value(design, key, value)))) for value in ordered]
    compared = compare_models(models, key, ordered, design_value, tolerance=tolerance, hinge=hinge, progress=progress)
    return replace(compared, design=design)


def compare_models(
    models: Sequence[Model],
    key: str,
    values: Sequence[float],
    design_value: float,
    *,
    tolerance: float = 0.02,
    hinge: int | None = None,
    progress: Progress | None = None,
) -> Convergence:
    """Do the same as `converge` with compiled models, one for each value, in the order of the values."""
    for model in models:
        if model.design.protocol.device is not None:
            check_available(model.design.protocol.device)
        check_device(model)
        check_quasi_static(model.structure, model.design.protocol)
    runs, rows = _run_all(models, hinge, progress), tuple(_row_count(model) for model in models)
    own_index = list(values).index(design_value)
    transitions = models[own_index].structure.transitions
    times = {
        transition.name: np.array([run.transition_times[transition.name] for run in runs]) for transition in transitions
    }
    labels = [transition.wording.time for transition in transitions]
    steps, alike = np.array(values, dtype=float), np.array([run.outcome == runs[own_index].outcome for run in runs])
    orders: dict[str, OrderFit | None] = dict.fromkeys(times)
    fine: bool | None = None
    if key == TIMESTEP:
        orders = {name: _fit_where_known(steps, values_at, alike) for name, values_at in times.items()}
        transition_times = list(times.values())
        fine, verdict = judge_timestep(
            steps, own_index, runs, alike, labels, transition_times, list(orders.values()), tolerance
        )
    else:
        names = [f"{rows[i]} rows" if key == MESH else value_text(key, value) for i, value in enumerate(values)]
        verdict = judge_moves(names, own_index, runs, alike, labels, list(times.values()))
    return Convergence(
        design=models[own_index].design,
        key=key,
        values=steps,
        design_value=design_value,
        rows=rows,
        statuses=tuple(run.status for run in runs),
        verdicts=tuple(run.verdict for run in runs),
        transition_times=times,
        starts={transition.name: np.array([run.starts[transition.name] for run in runs]) for transition in transitions},
        orders=orders,
        times=tuple(run.times for run in runs),
        hinge=runs[own_index].hinge,
        angles=tuple(run.angle for run in runs),
        tolerance=tolerance,
        fine=fine,
        verdict=verdict,
    )


def _row_count(model: Model) -> int:
    """Return the number of rows of the mesh; 0 without a mesh."""
    return row_count(model.design) if model.structure.membranes else 0


def _with_dense_record(design: Design) -> Design:
    """Record every step, or as many as allowed, so that crossings can be interpolated between steps."""
    timestep = float(design.protocol.timestep)
    steps = sum(stage.time_limit for stage in design.protocol.stages) / timestep
    return with_values(design, {"protocol.sample_interval": timestep * max(1, math.ceil(steps / _MOST_ROWS))})


def _run_all(models: Sequence[Model], hinge: int | None, progress: Progress | None) -> list[TimedRun]:
    """Run all models, those of the same topology together, and keep only the required part of each record."""
    topologies: dict[int, list[int]] = {}
    for index, model in enumerate(models):
        topologies.setdefault(len(model.mesh.built), []).append(index)
    runs: dict[int, TimedRun] = {}
    for members in topologies.values():
        for row, record in simulate_each([models[index] for index in members], solver=stage_rest_path):
            run = runs[members[row]] = timed_run(record, hinge)
            if progress is not None:
                progress(len(runs), len(models), {"verdict": run.verdict, "outcome": run.word})
    return [runs[index] for index in range(len(models))]


def _fit_where_known(steps: Array, times: Array, alike: Flags) -> OrderFit | None:
    """Fit runs that end like the design's own and have a time; None with fewer than two of them."""
    known = alike & np.isfinite(times)
    return fit_order(steps[known], times[known]) if known.sum() >= 2 else None
