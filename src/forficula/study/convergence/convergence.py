"""Whether a design's timestep, membrane and mesh are fine enough: the same run at several values of one of them."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from forficula.analysis import Verdict
from forficula.arrays import Array, Flags
from forficula.design import Design, with_values
from forficula.dynamics import Model, compile_model
from forficula.dynamics.stepping.simulate import simulate_each
from forficula.errors import InputError
from forficula.quantities import as_written
from forficula.results import Result, pandas_module
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

# Rows that a run keeps at most while its stages last: with more, a very short timestep would fill the memory.
_MOST_ROWS = 100_000


@dataclass(frozen=True, kw_only=True)
class Convergence(Result):
    """One design at several values of one setting, from coarse to fine, soft to stiff.

    Attributes:
        design: what ran.
        key: `TIMESTEP`, `YOUNGS_MODULUS` or `MESH`.
        values: timesteps in s, moduli in Pa, or how many times finer the mesh is, (run,).
        own: the design's own among them.
        rows: of the membrane's mesh, by run.
        statuses: what each run came to, in a few words.
        verdicts: likewise, in a word.
        transition_times: by transition, from the start of its stage until the last of what its goal bounds has crossed
            its bound for good, s, nan where it did not, (run,).
        starts: by transition, when its stage began, s, nan where it did not, (run,).
        orders: by transition, how its time goes with the timestep; None for another key, or without two times to
            compare.
        times: of the rows of each run, s, (row,).
        hinge: number of the hinge that is shown, among those of the first measure, from 0.
        angles: what that measure reads of it in each run, rad, (row,).
        tolerance: largest allowed difference from the limit, as a share of it.
        fine: whether the design's own timestep is; None where that cannot be told, or for another key.
        verdict: in a sentence.
    """

    design: Design
    key: str
    values: Array
    own: float
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

        words = {"verdict": [each.value for each in self.verdicts], "status": list(self.statuses)}
        times = {f"{name}_time_s": each for name, each in self.transition_times.items()}
        return pandas.DataFrame(words | times, index=pandas.Index(self.values, name=self.key))

    @property
    def own_verdict(self) -> Verdict:
        """What the run at the design's own value came to."""
        return self.verdicts[int(np.flatnonzero(self.values == self.own)[0])]


def converge(
    design: Design,
    key: str,
    values: Sequence[float],
    *,
    tolerance: float = 0.02,
    hinge: int | None = None,
    progress: Progress | None = None,
) -> Convergence:
    """Run a design at several timesteps, membrane moduli or meshes and say what that changes.

    The design's own value is run, too, whether it is among the values or not.

    Args:
        design: what to run.
        key: `TIMESTEP`, `YOUNGS_MODULUS`, or `MESH`.
        values: two at least, in any order: s, Pa, or whole numbers by which the spacing of the mesh's rows is divided.
        tolerance: by how much of its limit a time may be off at a timestep that is fine.
        hinge: number of the hinge to show, among those of the first measure, from 0; the last if not given, or where
            there are fewer.
        progress: called with the runs done, all runs, and the verdict and the word of the last, as a row.

    Raises:
        InputError: another key, fewer than two values, one of them twice, or one that the design cannot have.
    """
    if key not in (TIMESTEP, YOUNGS_MODULUS, MESH):
        raise InputError(f"key: need {TIMESTEP}, {YOUNGS_MODULUS} or {MESH}, got {as_written(key)}")
    check_values(key, values)
    design = resolved(design) if key == TIMESTEP else design
    own = own_value(design, key)
    # a timestep goes from coarse to fine, the others from soft or coarse on
    ordered = sorted([own, *(value for value in values if not same(value, own))], reverse=key == TIMESTEP)
    models = [compile_model(_with_dense_record(resolved(with_value(design, key, value)))) for value in ordered]
    compared = compare_models(models, key, ordered, own, tolerance=tolerance, hinge=hinge, progress=progress)
    return replace(compared, design=design)


def compare_models(
    models: Sequence[Model],
    key: str,
    values: Sequence[float],
    own: float,
    *,
    tolerance: float = 0.02,
    hinge: int | None = None,
    progress: Progress | None = None,
) -> Convergence:
    """Do as `converge` does with compiled models, one for each value, in the order of the values."""
    runs, rows = _run_all(models, hinge, progress), tuple(_row_count(model) for model in models)
    here = list(values).index(own)
    transitions = models[here].structure.transitions
    times = {each.name: np.array([run.transition_times[each.name] for run in runs]) for each in transitions}
    labels = [each.wording.time for each in transitions]
    steps, alike = np.array(values, dtype=float), np.array([run.outcome == runs[here].outcome for run in runs])
    orders: dict[str, OrderFit | None] = dict.fromkeys(times)
    fine: bool | None = None
    if key == TIMESTEP:
        orders = {name: _fit_where_known(steps, each, alike) for name, each in times.items()}
        each_time = list(times.values())
        fine, verdict = judge_timestep(steps, here, runs, alike, labels, each_time, list(orders.values()), tolerance)
    else:
        names = [f"{rows[i]} rows" if key == MESH else value_text(key, value) for i, value in enumerate(values)]
        verdict = judge_moves(names, here, runs, alike, labels, list(times.values()))
    return Convergence(
        design=models[here].design,
        key=key,
        values=steps,
        own=own,
        rows=rows,
        statuses=tuple(run.status for run in runs),
        verdicts=tuple(run.verdict for run in runs),
        transition_times=times,
        starts={each.name: np.array([run.starts[each.name] for run in runs]) for each in transitions},
        orders=orders,
        times=tuple(run.times for run in runs),
        hinge=runs[here].hinge,
        angles=tuple(run.angle for run in runs),
        tolerance=tolerance,
        fine=fine,
        verdict=verdict,
    )


def _row_count(model: Model) -> int:
    """Rows of the mesh; 0 where there is none."""
    return row_count(model.design) if model.structure.membranes else 0


def _with_dense_record(design: Design) -> Design:
    """Keep every step, or as many as fit, so that a crossing can be found between two of them."""
    timestep = float(design.protocol.timestep)
    steps = sum(stage.time_limit for stage in design.protocol.stages) / timestep
    return with_values(design, {"protocol.sample_interval": timestep * max(1, math.ceil(steps / _MOST_ROWS))})


def _run_all(models: Sequence[Model], hinge: int | None, progress: Progress | None) -> list[TimedRun]:
    """Run all models, those of one topology side by side, and keep of each record only what is needed."""
    topologies: dict[int, list[int]] = {}
    for index, model in enumerate(models):
        topologies.setdefault(len(model.mesh.built), []).append(index)
    runs: dict[int, TimedRun] = {}
    for members in topologies.values():
        for row, record in simulate_each([models[index] for index in members]):
            run = runs[members[row]] = timed_run(record, hinge)
            if progress is not None:
                progress(len(runs), len(models), {"verdict": run.verdict, "outcome": run.word})
    return [runs[index] for index in range(len(models))]


def _fit_where_known(steps: Array, times: Array, alike: Flags) -> OrderFit | None:
    """A fit over the runs that ended as the design's own does and have a time; None without two of them."""
    known = alike & np.isfinite(times)
    return fit_order(steps[known], times[known]) if known.sum() >= 2 else None
