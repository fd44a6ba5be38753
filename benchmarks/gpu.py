"""How fast a graphics processor runs designs, and whether its single precision changes verdicts of the paper's search.

Designs are the reference wing with other tendons, which share all numbers that cannot differ on a device. The
processor runs the same designs in double precision.
"""

from __future__ import annotations

import argparse
import dataclasses
import json
import os
import platform
import tempfile
import time
from collections.abc import Iterator, Sequence
from importlib.util import find_spec
from pathlib import Path

import numpy as np

import forficula as ff
from forficula.design import Design, with_values
from forficula.dynamics import Model, compile_model, simulate_each, versions
from forficula.dynamics.stepping.stages import StageTracker
from forficula.dynamics.stepping.stepper import Stepper
from forficula.study.running.evaluate import evaluate
from forficula.study.running.journal import Row
from forficula.study.study import Study

_DESIGN, _STUDY = "binder2025", "binder2025-search"
# numbers of a run that are compared, besides its verdict
_NUMBERS = ("fold_time_s", "fold_work_J", "unfold_time_s", "unfold_work_J", "folded_energy_J")
# steps of a chunk, and number of chunks that are measured
_CHUNK, _CHUNKS = 100, 5
_MARGINS = ("fold_margin", "unfold_margin")


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--device", choices=("gpu", "warp-cpu"), default="gpu")
    parser.add_argument("--worlds", type=int, nargs="*", default=[60, 4096, 65536], help="designs side by side")
    parser.add_argument("--threads", type=int, nargs="*", default=[2, 16], help="threads of the processor, to compare")
    parser.add_argument("--most", type=int, default=4096, help="designs that the processor runs at most")
    parser.add_argument("--short", type=float, help="simulated time of each stage, s, at most, as a check")
    parser.add_argument(
        "--verdicts", type=int, nargs="?", const=60, help="compare the search of this number of tendons"
    )
    parser.add_argument("--steps", action="store_true", help="measure steps per second only, without protocols")
    parser.add_argument("--smallest", action="store_true", help="a check that needs no graphics processor")
    parser.add_argument("--json", type=Path, help="write the numbers here, too")
    arguments = parser.parse_args()
    if arguments.smallest:
        if find_spec("mujoco_warp") is None:
            print('not measured: pip install "forficula[gpu]"')
            return
        arguments.device, arguments.worlds, arguments.threads, arguments.short = "warp-cpu", [2], [1], 0.01
    numbers: dict[str, object] = {
        "machine": {"cores": os.cpu_count(), "python": platform.python_version(), **versions(arguments.device)},
        "device": arguments.device,
    }
    print(json.dumps(numbers))
    if arguments.steps:
        numbers["steps"] = measure_steps(arguments)
    elif arguments.verdicts:
        numbers["verdicts"] = compare_verdicts(_thinned(ff.load_study(_STUDY), arguments.verdicts), arguments.device)
    else:
        numbers["speed"] = measure_speed(arguments)
    if arguments.json is not None:
        arguments.json.write_text(json.dumps(numbers, indent=2) + "\n")


def measure_speed(arguments: argparse.Namespace) -> list[dict[str, object]]:
    """Measure designs per second of the device and of the processor, by number of designs."""
    rows: list[dict[str, object]] = []
    for count in arguments.worlds:
        designs = _designs(count, arguments.short)
        cases = [(arguments.device, 0, designs)]
        cases += [("cpu", threads, designs[: arguments.most]) for threads in arguments.threads]
        for device, threads, some in cases:
            if device != "cpu":
                # compiles kernels, which are kept
                _run_time(some[:2], device, threads)
            wall = _run_time(some, device, threads)
            row = {"device": device, "threads": threads, "designs": len(some), "s": wall, "per_s": len(some) / wall}
            rows.append(row)
            print(
                f"{device:9} threads {threads or '-':>2}  {len(some):6} designs  {wall:8.2f} s  {row['per_s']:9.1f} /s",
                flush=True,
            )
    return rows


def measure_steps(arguments: argparse.Namespace) -> list[dict[str, object]]:
    """Measure steps per second in the first stage of folding, by number of designs, without energies and records.

    Designs are at most 60 different ones, repeated, because compiling the models of 65 536 designs takes minutes.
    """
    models = {place: _models(_designs(60, arguments.short), place) for place in (arguments.device, "cpu")}
    rows: list[dict[str, object]] = []
    for count in arguments.worlds:
        cases = [(arguments.device, 0, count)]
        cases += [("cpu", threads, min(count, arguments.most)) for threads in arguments.threads]
        for device, threads, worlds in cases:
            rate = _step_rate([models[device][number % 60] for number in range(worlds)], threads)
            rows.append({"device": device, "threads": threads, "designs": worlds, "steps_per_s": rate})
            print(f"{device:9} threads {threads or '-':>2}  {worlds:6} designs  {rate:12.0f} steps/s", flush=True)
    return rows


def _step_rate(models: Sequence[Model], threads: int) -> float:
    """Return the number of steps of all structures per second."""
    stepper, tracker, numbers = Stepper(models, threads, True, _CHUNK), StageTracker(models), np.arange(len(models))
    try:
        torques = tracker.torques(numbers, _CHUNK)
        controls, walls = tracker.controls(numbers, torques), []
        for _ in range(1 + _CHUNKS):
            start = time.perf_counter()
            steps = stepper.start(numbers, controls, torques).result()
            # waits for the device
            steps.states(numbers[:1], np.array([_CHUNK]))
            walls.append(time.perf_counter() - start)
    finally:
        stepper.close()
    # the first chunk compiles kernels
    return len(models) * _CHUNK * _CHUNKS / sum(walls[1:])


def _models(designs: Sequence[Design], device: str) -> list[Model]:
    """Return the compiled models of designs for a device."""
    return [compile_model(with_values(design, {"protocol.device": device})) for design in designs]


def _run_time(designs: Sequence[Design], device: str, threads: int) -> float:
    """Return the time in which designs run through their protocols, s, without compiling their models."""
    models = _models(designs, device)
    start = time.perf_counter()
    for _ in simulate_each(models, threads, sparse=True):
        pass
    return time.perf_counter() - start


def _designs(count: int, short: float | None) -> list[Design]:
    """Return the reference wing with tendons of 10 to 60 N/cm, and stages that are at most so long."""
    base = ff.load_design(_DESIGN)
    if short is not None:
        limits = {f"protocol.stages.{place}.time_limit": short for place in range(len(base.protocol.stages))}
        base = with_values(base, limits)
    return [with_values(base, {"tendon.stiffness": float(value)}) for value in np.linspace(1e3, 6e3, count)]


def compare_verdicts(study: Study, device: str) -> dict[str, object]:
    """Run a study on the processor and on a device; return how many runs and cells differ, and list them."""
    runs: dict[str, dict[str, Row]] = {}
    tables, times = {}, {}
    for place in ("cpu", device):
        runs[place], start = {}, time.perf_counter()
        based = dataclasses.replace(study, base=with_values(study.base, {"protocol.device": place}))
        with tempfile.TemporaryDirectory() as folder:
            tables[place] = ff.run_study(based, folder, cluster=_keeping(runs[place]))
        times[place] = time.perf_counter() - start
        print(f"{place}: {len(runs[place])} runs in {times[place]:.1f} s", flush=True)
    both = runs["cpu"].keys() & runs[device].keys()
    differing = [
        {place: {name: runs[place][key].get(name) for name in ("status", "confirmed", *_MARGINS)} for place in runs}
        for key in sorted(both)
        if runs["cpu"][key]["verdict"] != runs[device][key]["verdict"]
    ]
    for pair in differing:
        print("verdicts differ:", *(f"{place}: {row}" for place, row in pair.items()), sep="\n  ")
    same = [key for key in both if runs["cpu"][key]["verdict"] == runs[device][key]["verdict"]]
    largest = {
        name: _largest_change([(runs["cpu"][key], runs[device][key]) for key in same], name) for name in _NUMBERS
    }
    cells = {
        str(name): int(np.sum(tables["cpu"][name].astype(str).values != tables[device][name].astype(str).values))
        for name in tables["cpu"].data_vars
        if name.endswith(("_torque", "outcome", "verdict"))
    }
    result: dict[str, object] = {
        "runs": {place: len(rows) for place, rows in runs.items()},
        "s": times,
        "runs of both": len(both),
        "differing verdicts": differing,
        "largest relative changes": largest,
        "differing cells": cells,
    }
    print(json.dumps({name: value for name, value in result.items() if name != "differing verdicts"}, indent=1))
    return result


def _largest_change(pairs: Sequence[tuple[Row, Row]], name: str) -> float:
    """Return the largest relative change of a number between two runs of one design."""
    known = [(one[name], other[name]) for one, other in pairs if one.get(name) and other.get(name) is not None]
    return max((abs(other / one - 1) for one, other in known), default=0.0)


class _keeping:  # noqa: N801
    """Function that evaluates designs as a study does, and keeps the row of each, whatever its device."""

    def __init__(self, rows: dict[str, Row]) -> None:
        self._rows = rows

    def __call__(self, designs: Sequence[Design], until_last: bool) -> Iterator[Row]:
        """Yield the rows of designs."""
        from forficula.study.running.evaluate import row_key

        names = {row_key(design): with_values(design, {"protocol.device": "cpu"}).hash for design in designs}
        for row in evaluate(designs, until_last=until_last):
            self._rows[names[row["key"]]] = row
            yield row


def _thinned(study: Study, points: int) -> Study:
    """Return a study of some of its points, evenly spaced."""
    chosen = np.linspace(0, len(study.points) - 1, min(points, len(study.points))).round().astype(int)
    if len(chosen) == len(study.points):
        return study
    # points of a thinned grid are no grid
    return dataclasses.replace(study, points=tuple(study.points[number] for number in chosen), sampled=True)


if __name__ == "__main__":
    main()
