"""How fast the paper's search runs, beside a plain loop and beside the bare engine, on this machine, in one run."""

from __future__ import annotations

import argparse
import copy
import dataclasses
import json
import os
import platform
import statistics
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from unittest import mock

import mujoco
import numpy as np
from mujoco.batch import Batch

import forficula as ff
from forficula.design import Design, StageSection, key_value, stage_drives, with_values
from forficula.dynamics import Model, compile_model, simulate, versions
from forficula.dynamics.stepping.stages import StageTracker
from forficula.dynamics.stepping.steps import Steps
from forficula.structure import drive_of, goal_of, hinges_of
from forficula.study.running.evaluate import row_key
from forficula.study.running.journal import Row
from forficula.study.running.run_study import run_study
from forficula.study.search_steps import Search
from forficula.study.study import Study
from forficula.study.study_designs import first_design, second_design
from forficula.study.tables.study_table import StudyTable

_STUDY = "binder2025-search"
_OTHERS = 0.04  # of the cores' time: what others may take of such a round
_MOST_ROUNDS = 2.3  # rounds made at most, by the rounds wanted in which others leave the cores to us
_BENCH_TIME = 0.6  # s, simulated by every wing in the comparison of paces

# steps by design and name of the stage
StepCounts = Counter[tuple[str, str]]


def main() -> None:
    """Measure and print a table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--points", type=int, help="only so many of the 60 tendons, evenly spaced")
    parser.add_argument("--study", default=_STUDY, help="another study that searches for the least torques")
    parser.add_argument("--full", action="store_true", help="compare with a scan of all torques, cell by cell")
    parser.add_argument("--search-only", action="store_true", help="neither the plain loop nor the paces")
    parser.add_argument("--plain", type=int, default=24, help="runs of the plain loop")
    parser.add_argument("--wings", type=int, default=240, help="wings of the comparison of paces")
    parser.add_argument("--rounds", type=int, default=11, help="rounds of that comparison in which the cores are idle")
    parser.add_argument("--json", type=Path, help="write the numbers here, too")
    arguments = parser.parse_args()
    study = _thinned(ff.load_study(arguments.study), arguments.points)
    searched, table = measure_search(study)
    numbers: dict[str, Any] = {
        "machine": {"cpu": _cpu(), "cores": os.cpu_count(), "python": platform.python_version(), **versions()},
        "load_before": os.getloadavg()[0],
        "search": searched,
    }
    if arguments.full:
        search = dataclasses.replace(_search(study), scan="full")
        numbers["full_scan"], full = measure_search(dataclasses.replace(study, search=search))
        numbers["different_cells"] = different_cells(table, full)
    if not arguments.search_only:
        numbers["plain_loop"] = measure_plain_loop(study, arguments.plain)
        numbers["pace"] = measure_pace(study, arguments.wings, arguments.rounds)
    numbers["load_after"] = os.getloadavg()[0]
    _show(numbers)
    if arguments.json is not None:
        arguments.json.write_text(json.dumps(numbers, indent=2) + "\n")


def measure_search(study: Study) -> tuple[dict[str, Any], StudyTable]:
    """The whole search as a user runs it, from the study to the table, s of wall and of all cores' time.

    Steps are those that the engine was asked for, so that stages which wings go through together count once.
    """
    rows: list[Row] = []
    with tempfile.TemporaryDirectory() as folder, _counted_steps() as (counts, designs):
        start = _clocks()
        table = run_study(study, folder, progress=lambda _done, _needed, row: rows.append(row))
        assert isinstance(table, StudyTable)
        wall, cpu = _since(start)
    return {
        "points": len(study.points),
        "runs": len(rows),
        "steps": sum(counts.values()),
        "wall_s": wall,
        "cpu_s": cpu,
        "points_by_monotony": dict(Counter(table["monotony"].values.ravel().tolist())) if "monotony" in table else {},
        "steps_by_purpose": _steps_by_purpose(study, counts, designs, rows),
    }, table


@contextmanager
def _counted_steps() -> Iterator[tuple[StepCounts, dict[str, Design]]]:
    """Count steps by design and stage, including the few beyond the end of a stage; also yield the designs."""
    counts: StepCounts = Counter()
    designs: dict[str, Design] = {}

    class CountingTracker(StageTracker):
        def __init__(self, models: Sequence[Model]) -> None:
            super().__init__(models)
            self.designs = [model.design for model in models]

        def follow(self, rows: np.ndarray[Any, np.dtype[np.int64]], steps: Steps) -> np.ndarray[Any, Any]:
            for row in rows.tolist():
                design = self.designs[row]
                designs[design.hash] = design
                counts[design.hash, design.protocol.stages[self.stage[row]].name] += steps.position.shape[1]
            return super().follow(rows, steps)

    with mock.patch("forficula.dynamics.stepping.simulate.StageTracker", CountingTracker):
        yield counts, designs


def _steps_by_purpose(
    study: Study, counts: StepCounts, designs: Mapping[str, Design], rows: Sequence[Row]
) -> list[dict[str, Any]]:
    """Steps by purpose, in falling order: the transition that a run tries, its value, its outcome, and the stage.

    Repetitions at half the timestep have the outcome of the run that they repeat, and "again" before their stage. The
    outcome of a run without a row is unknown, because it does not count.
    """
    steps = _search(study).steps
    outcomes = {row["key"]: row["outcome"] for row in rows}
    total: Counter[tuple[str, float, str, str]] = Counter()
    for (name, stage), count in counts.items():
        design, again = designs[name], ""
        protocol = design.protocol.model_copy(update={"timestep": 2 * float(design.protocol.timestep)})
        if row_key(repeated := design.model_copy(update={"protocol": protocol})) in outcomes:
            design, again = repeated, "again: "
        driven = {drive for section in design.protocol.stages for drive in stage_drives(section)}
        step = next((step for step in reversed(steps) if step.drive in driven), steps[0])
        value = abs(float(str(key_value(design, step.key))))
        total[step.transition, value, outcomes.get(row_key(design), "unknown"), again + stage] += count
    return [
        {"transition": transition, "value": value, "outcome": outcome, "stage": stage, "steps": count}
        for (transition, value, outcome, stage), count in total.most_common()
    ]


def different_cells(table: StudyTable, full: StudyTable) -> dict[str, int]:
    """Cells of a table that differ from those of the full scan, by variable, without those about the scan itself."""
    counts = {}
    for name, values in full.data_vars.items():
        one, other = np.atleast_1d(table[name].values).astype(object), np.atleast_1d(values.values).astype(object)
        equal = (one == other) | ((one != one) & (other != other))
        counts[str(name)] = int((~equal.astype(bool)).sum())
    return counts


def measure_plain_loop(study: Study, runs: int) -> dict[str, float]:
    """The same search as one writes it with MuJoCo alone: every run compiled, every stage as long as it may take.

    Only a few runs, drawn with a fixed seed, are made; a step of the others is taken to cost the same.
    """
    designs = _grid_designs(study)
    chosen = [designs[index] for index in np.random.default_rng(0).permutation(len(designs))[:runs]]
    start, steps = _clocks(), 0
    for design in chosen:
        steps += _plain_run(design)
    wall, cpu = _since(start)
    every = sum(_step_counts(design).sum() for design in designs)
    share = float(every / steps)
    return {
        "runs_made": len(chosen),
        "runs": len(designs),
        "steps": int(every),
        "steps_per_s": steps / wall,
        "wall_s": wall * share,
        "cpu_s": cpu * share,
    }


def measure_pace(study: Study, count: int, wanted: int) -> dict[str, Any]:
    """Steps per second of `simulate(sparse=True)` and of bare `Batch.step`: the same wings, steps, and two threads.

    Every wing is driven by its fold torque for a fixed time, so that none ends early. Neither computes energies, which
    a sparse run does without. The two take turns, at going first too, for the machine's pace drifts; rounds count in
    which no other process took the cores.
    """
    wings = _driven_wings(study, count)
    engines = _without_energy(wings)
    steps = round(_BENCH_TIME / float(wings[0].design.protocol.timestep)) * len(wings)
    order: list[tuple[str, Callable[[], object]]] = [
        ("bare", lambda: _bare(wings, engines)),
        ("simulate", lambda: simulate(wings, threads=2, sparse=True)),
    ]
    rounds: list[dict[str, tuple[float, float]]] = []
    quiet: list[dict[str, tuple[float, float]]] = []
    while len(quiet) < wanted and len(rounds) < _MOST_ROUNDS * wanted:
        paces, others = {}, []
        for name, work in order:
            start, busy = _clocks(), _busy()
            work()
            wall, cpu = _since(start)
            paces[name] = steps / wall, steps / cpu
            others.append((_busy() - busy - cpu) / wall / (os.cpu_count() or 1))
        rounds.append(paces)
        if max(others) < _OTHERS:
            quiet.append(paces)
        order.reverse()
    return {
        "wings": len(wings),
        "rounds": len(rounds),
        "quiet_rounds": len(quiet),
        "ratio_of_all_rounds": _ratio(rounds, 0),
        **_paces(quiet or rounds),
    }


def _paces(rounds: Sequence[dict[str, tuple[float, float]]]) -> dict[str, Any]:
    return {
        "bare_steps_per_s": _spread([paces["bare"][0] for paces in rounds]),
        "simulate_steps_per_s": _spread([paces["simulate"][0] for paces in rounds]),
        "ratio": _ratio(rounds, 0),
        "ratio_of_cpu": _ratio(rounds, 1),
    }


def _ratio(rounds: Sequence[dict[str, tuple[float, float]]], clock: int) -> dict[str, float]:
    """Pace of `simulate` by that of the bare engine, in each round, by wall (0) or CPU time (1)."""
    return _spread([paces["simulate"][clock] / paces["bare"][clock] for paces in rounds])


def _thinned(study: Study, points: int | None) -> Study:
    if points is None or points >= len(study.points):
        return study
    chosen = np.linspace(0, len(study.points) - 1, points).round().astype(int)
    return dataclasses.replace(study, points=tuple(study.points[index] for index in chosen), sampled=True)


def _grid_designs(study: Study) -> list[Design]:
    """All that a plain loop must run: it releases and opens every wing, for it looks at nothing on the way."""
    search = _search(study)
    designs = [with_values(study.base, dict(point)) for point in study.points]
    return [
        run
        for design in designs
        for run in [
            *(first_design(design, search, torque) for torque in search.first.values),
            *(second_design(design, search, torque) for torque in (search.second.values if search.second else ())),
        ]
    ]


def _search(study: Study) -> Search:
    assert study.search is not None
    return study.search


def _step_counts(design: Design) -> np.ndarray[Any, np.dtype[np.int64]]:
    timestep = float(design.protocol.timestep)
    return np.array([round(stage.time_limit / timestep) for stage in design.protocol.stages])


def _plain_run(design: Design) -> int:
    """Compile a wing, take it through its stages, look at every state as one who wants to know when it folded."""
    wing = compile_model(design)
    engine, data = wing.engine, mujoco.MjData(wing.engine)
    data.qpos[:] = _start(wing)
    folds = list(hinges_of(wing.structure, "ring"))
    folded = goal_of(wing.in_units, "folded").most[folds]
    steps, folded_at = 0, None
    for stage, count in zip(design.protocol.stages, _step_counts(design), strict=True):
        data.ctrl[:] = _controls(wing, stage)
        for _ in range(count):
            mujoco.mj_step(engine, data)
            if folded_at is None and (wing.folds.senses[folds] * data.qpos[folds] <= folded).all():
                folded_at = data.time
        steps += int(count)
    return steps


def _start(wing: Model) -> np.ndarray[Any, np.dtype[np.float64]]:
    return np.array([hinge.sense * hinge.start for hinge in wing.in_units.hinges])


def _controls(wing: Model, stage: StageSection) -> np.ndarray[Any, np.dtype[np.float64]]:
    """What drives a stage, (control,)."""
    torques = np.zeros(len(wing.in_units.motors))
    for name in stage_drives(stage):
        torques += np.array(drive_of(wing.in_units, name).strengths)
    return torques[wing.motors]


def _driven_wings(study: Study, count: int) -> list[Model]:
    """Wings of the study's tendons, folded with its torques one after another, for a fixed time."""
    search = _search(study)
    stage = study.base.protocol.stages[1].model_copy(update={"until": "time", "hold": 0.0, "time_limit": _BENCH_TIME})
    wings = []
    for index in range(count):
        design = with_values(study.base, dict(study.points[index % len(study.points)]))
        # torques differ by less than matters, because equal wings would run once only
        values = search.first.values
        torque = values[index % len(values)] * (1 + 1e-6 * index) + 1e-6 * index
        protocol = design.protocol.model_copy(update={"fold_torque": torque, "stages": (stage,)})
        wings.append(compile_model(design.model_copy(update={"protocol": protocol})))
    return wings


def _without_energy(wings: Sequence[Model]) -> list[mujoco.MjModel]:
    engines = [copy.copy(wing.engine) for wing in wings]
    for engine in engines:
        engine.opt.enableflags &= ~int(mujoco.mjtEnableBit.mjENBL_ENERGY)
    return engines


def _bare(wings: Sequence[Model], engines: Sequence[mujoco.MjModel]) -> None:
    """The engine alone, in one call."""
    batch = Batch(engines[0], len(wings), 2)
    batch.set_models(engines)
    for row, wing in enumerate(wings):
        batch.bind("qpos")[row] = _start(wing)
        batch.bind("ctrl")[row] = _controls(wing, wing.design.protocol.stages[0])
    batch.step(nstep=round(_BENCH_TIME / float(wings[0].design.protocol.timestep)))


def _clocks() -> tuple[float, float]:
    return time.perf_counter(), time.process_time()


def _since(start: tuple[float, float]) -> tuple[float, float]:
    return time.perf_counter() - start[0], time.process_time() - start[1]


def _busy() -> float:
    """Return the time that all cores have worked for any process, s; 0 if the machine does not report it."""
    try:
        user, nice, system, _, _, *others = map(int, Path("/proc/stat").read_text().split("\n", 1)[0].split()[1:9])
    except OSError:
        return 0.0
    return float(user + nice + system + sum(others)) / os.sysconf("SC_CLK_TCK")


def _spread(values: Sequence[float]) -> dict[str, float]:
    return {"median": statistics.median(values), "least": min(values), "most": max(values)}


def _cpu() -> str:
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        return platform.processor()
    return next((line.partition(":")[2].strip() for line in lines if line.startswith("model name")), "unknown")


def _show(numbers: dict[str, Any]) -> None:
    rows = [
        ("machine", ", ".join(f"{name} {value}" for name, value in numbers["machine"].items())),
        ("load before, after", f"{numbers['load_before']:.1f}, {numbers['load_after']:.1f}"),
        *_search_rows("search", numbers["search"]),
    ]
    if "full_scan" in numbers:
        rows += _search_rows("full scan", numbers["full_scan"])
        different = {name: count for name, count in numbers["different_cells"].items() if count}
        rows.append(("cells that differ from the full scan", str(different or "none")))
    if "plain_loop" in numbers:
        rows += _pace_rows(numbers)
    width = max(len(name) for name, _ in rows)
    for name, value in rows:
        print(f"{name:<{width}}  {value}")
    for name in ("search", "full_scan"):
        if name in numbers:
            _show_purposes(name.replace("_", " "), numbers[name])


def _search_rows(name: str, search: Mapping[str, Any]) -> list[tuple[str, str]]:
    return [
        (f"{name}: points, runs", f"{search['points']}, {search['runs']}"),
        (f"{name}: wall, CPU", f"{search['wall_s']:.1f} s, {search['cpu_s']:.1f} s"),
        (f"{name}: steps, pace", f"{search['steps'] / 1e6:.2f} M, {search['steps'] / search['wall_s']:.0f} steps/s"),
        (f"{name}: points by monotony", str(search["points_by_monotony"] or "all values tried")),
    ]


def _show_purposes(name: str, search: Mapping[str, Any]) -> None:
    """Print the steps by purpose, values of one transition, outcome and stage together."""
    total: Counter[tuple[str, str, str]] = Counter()
    for part in search["steps_by_purpose"]:
        total[part["transition"], part["outcome"], part["stage"]] += part["steps"]
    print(f"{name}: steps by purpose: run that tries a transition, outcome, stage")
    for (transition, outcome, stage), count in total.most_common(16):
        print(f"  {count / search['steps']:6.1%}  {transition}, {outcome}, {stage}")


def _pace_rows(numbers: dict[str, Any]) -> list[tuple[str, str]]:
    search, plain, pace = numbers["search"], numbers["plain_loop"], numbers["pace"]
    ratio, cpu_ratio, loaded = pace["ratio"], pace["ratio_of_cpu"], pace["ratio_of_all_rounds"]
    return [
        (f"plain loop, from {plain['runs_made']} of {plain['runs']} runs", f"{plain['wall_s']:.0f} s"),
        ("plain loop: steps, pace", f"{plain['steps'] / 1e6:.1f} M, {plain['steps_per_s']:.0f} steps/s"),
        ("search faster than the plain loop", f"{plain['wall_s'] / search['wall_s']:.0f} times"),
        ("  by CPU time", f"{plain['cpu_s'] / search['cpu_s']:.0f} times"),
        ("bare Batch.step, two threads", f"{pace['bare_steps_per_s']['median']:.0f} steps/s"),
        ("simulate(sparse=True), two threads", f"{pace['simulate_steps_per_s']['median']:.0f} steps/s"),
        ("rounds, undisturbed ones", f"{pace['rounds']}, {pace['quiet_rounds']}"),
        ("  ratio: median (range)", f"{ratio['median']:.2f} ({ratio['least']:.2f} to {ratio['most']:.2f})"),
        ("  by CPU time", f"{cpu_ratio['median']:.2f} ({cpu_ratio['least']:.2f} to {cpu_ratio['most']:.2f})"),
        ("  of all rounds", f"{loaded['median']:.2f} ({loaded['least']:.2f} to {loaded['most']:.2f})"),
    ]


if __name__ == "__main__":
    main()
