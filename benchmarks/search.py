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
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any
from unittest import mock

import mujoco
import numpy as np
from mujoco.batch import Batch

import forficula as ff
from forficula.design import Design, StageSection, stage_drives, with_values
from forficula.dynamics import Model, compile_model, simulate, versions
from forficula.structure import drive_of, goal_of, hinges_of
from forficula.study.running.journal import Row
from forficula.study.search import first_design, second_design
from forficula.study.search_steps import Search
from forficula.study.study import Study

_STUDY = "binder2025-search"
_OTHERS = 0.04  # of the cores' time: what others may take of such a round
_MOST_ROUNDS = 2.3  # rounds made at most, by the rounds wanted in which others leave the cores to us
_BENCH_TIME = 0.6  # s, simulated by every wing in the comparison of paces


def main() -> None:
    """Measure and print a table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--points", type=int, help="only so many of the 60 tendons, evenly spaced")
    parser.add_argument("--plain", type=int, default=24, help="runs of the plain loop")
    parser.add_argument("--wings", type=int, default=240, help="wings of the comparison of paces")
    parser.add_argument("--rounds", type=int, default=11, help="rounds of that comparison in which the cores are idle")
    parser.add_argument("--json", type=Path, help="write the numbers here, too")
    arguments = parser.parse_args()
    study = _thinned(ff.load_study(_STUDY), arguments.points)
    numbers = {
        "machine": {"cpu": _cpu(), "cores": os.cpu_count(), "python": platform.python_version(), **versions()},
        "load_before": os.getloadavg()[0],
        "search": measure_search(study),
        "plain_loop": measure_plain_loop(study, arguments.plain),
        "pace": measure_pace(study, arguments.wings, arguments.rounds),
        "load_after": os.getloadavg()[0],
    }
    _show(numbers)
    if arguments.json is not None:
        arguments.json.write_text(json.dumps(numbers, indent=2) + "\n")


def measure_search(study: Study) -> dict[str, float]:
    """The whole search as a user runs it, from the study to the table, s of wall and of all cores' time.

    Steps are those that the engine was asked for, so that stages which wings go through together count once.
    """
    runs, steps, rollout = 0, 0, Batch.rollout

    def count_run(done: int, needed: int, row: Row) -> None:  # noqa: ARG001
        nonlocal runs
        runs += 1

    def counted(batch: Batch, nstep: int, **options: Any) -> Any:
        nonlocal steps
        steps += nstep * len(options["ids"])
        return rollout(batch, nstep, **options)

    with tempfile.TemporaryDirectory() as folder, mock.patch.object(Batch, "rollout", counted):
        start = _clocks()
        ff.run_study(study, folder, progress=count_run)
        wall, cpu = _since(start)
    return {"points": len(study.points), "runs": runs, "steps": steps, "wall_s": wall, "cpu_s": cpu}


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
    search, plain, pace = numbers["search"], numbers["plain_loop"], numbers["pace"]
    ratio, cpu_ratio, loaded = pace["ratio"], pace["ratio_of_cpu"], pace["ratio_of_all_rounds"]
    rows = [
        ("machine", ", ".join(f"{name} {value}" for name, value in numbers["machine"].items())),
        ("load before, after", f"{numbers['load_before']:.1f}, {numbers['load_after']:.1f}"),
        ("search: tendons, runs", f"{search['points']}, {search['runs']}"),
        ("search: wall, CPU", f"{search['wall_s']:.1f} s, {search['cpu_s']:.1f} s"),
        ("search: steps, pace", f"{search['steps'] / 1e6:.2f} M, {search['steps'] / search['wall_s']:.0f} steps/s"),
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
    width = max(len(name) for name, _ in rows)
    for name, value in rows:
        print(f"{name:<{width}}  {value}")


if __name__ == "__main__":
    main()
