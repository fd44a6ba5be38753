"""Measure steps, load paths, energy landscapes and designs side by side for sheets of nodes and of plates.

python benchmarks/sheets.py [--most N] [--json FILE]
"""

from __future__ import annotations

import argparse
import json
import os
import platform
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

from forficula.design import Design, load_design, with_values
from forficula.dynamics import compile_model, simulate, stable_timestep, versions
from forficula.errors import InputError
from forficula.statics import energy_landscape
from forficula.statics.net import crease_torques, load_path
from forficula.statics.net.driven.net_course import released
from forficula.statics.net.energy import expand
from forficula.statics.net.factor import factored
from forficula.statics.net.net import Net, NetShape
from forficula.statics.net.net_of import bends, net_of, start_shape
from forficula.structure import structure_of

_SIZES = (4, 8, 16)
_KINDS = ("bars", "membrane", "rigid")
_STEPS = {4: 2000, 8: 1000, 16: 300}
_INCREMENTS = 100
_DESIGNS, _TOGETHER = 40, 500
_LANDSCAPES = (
    "miura-sheet",
    "bistable-miura",
    "bistable-clasp",
    "force-clasp",
    "four-plate-snap",
    "kresling-cell",
    "waterbomb-base",
)
_REPEATS = 60
_SWING = 0.4  # s
_SWUNG = (4e-4, 1.6e-3)  # timesteps of swinging sheets, s
_LARGE = 32  # facets along a side of the largest sheet that is released


def sheet(size: int, kind: str = "bars", steps: int = 1, **values: object) -> Design:
    """Return the design miura-sheet with another size and other facets, driven for some of the longest stable steps."""
    stage = {"name": "fold", "drive": "fold", "until": "time", "hold": 0.0}
    drive = {"name": "fold", "kind": "torque", "of": "role:zigzag", "value": 1e-5}
    changes = {
        "pattern.columns": size,
        "pattern.rows": size,
        "facet.kind": kind,
        "measure": [],
        "support": [{"of": "facet 0"}],
        "drive": [drive],
        "protocol.timestep": 1e-4,
        "protocol.stages": [{**stage, "time_limit": 1.0}],
    }
    design = with_values(load_design("miura-sheet"), changes | values)
    return with_values(design, _duration(stable_timestep(design), steps))


def _duration(timestep: float, steps: int) -> dict[str, object]:
    return {
        "protocol.timestep": timestep,
        "protocol.sample_interval": timestep * steps / 10,
        "protocol.stages.0.time_limit": timestep * steps,
    }


def steps_per_second(size: int, kind: str) -> dict[str, Any]:
    """Steps of one sheet by wall and CPU time, and how far a step goes; why not, where it cannot be built."""
    steps = _STEPS[size]
    try:
        model = compile_model(sheet(size, kind, steps))
    except InputError as error:
        return {"size": size, "kind": kind, "fault": str(error)}
    wall, cpu, _ = _timed(lambda: simulate([model]))
    return {
        "size": size,
        "kind": kind,
        "dof": int(model.engine.nv),
        "timestep_s": float(model.design.protocol.timestep),
        "steps_per_s": steps / wall,
        "steps_per_cpu_s": steps / cpu,
    }


def path_time(size: int) -> dict[str, Any]:
    """Time of a load path of `_INCREMENTS`, a torque on all zigzag creases, from the sheet as built."""
    structure = structure_of(sheet(size))
    net = net_of(structure)
    zigzag = np.array([hinge.role == "zigzag" for hinge in structure.hinges])
    senses = np.array([hinge.sense for hinge in structure.hinges])
    load = crease_torques(net, np.flatnonzero(zigzag), 1e-5 * senses[zigzag])
    start = start_shape(structure, net)
    wall, cpu, path = _timed(lambda: load_path(net, start, load, increments=_INCREMENTS, step=net.size / 1000))
    return {
        "size": size,
        "nodes": len(net.nodes),
        "creases": int((~bends(structure)).sum()),
        "increments": len(path.points) - 1,
        "ended": path.ended,
        "wall_s": wall,
        "cpu_s": cpu,
    }


def landscape_time(name: str) -> dict[str, Any]:
    """Return the time of the landscape of a named design, in seconds and relative to one Newton step of its net."""
    design = load_design(name)
    structure = structure_of(design)
    net = net_of(structure)
    wall, cpu, landscape = _timed(lambda: energy_landscape(design))
    return {
        "design": name,
        "free_coordinates": int(np.count_nonzero(net.free)),
        "states": len(landscape.states),
        "passes": len(landscape.passes),
        "wall_s": wall,
        "cpu_s": cpu,
        "newton_steps": cpu / _newton_step(net, start_shape(structure, net)),
    }


def _newton_step(net: Net, shape: NetShape) -> float:
    """Return the median CPU time of energy, Hessian and factorisation, s."""
    times = [_timed(lambda: factored(expand(net, shape).free))[1] for _ in range(_REPEATS)]
    return sorted(times)[_REPEATS // 2]


def release_time(size: int) -> dict[str, Any]:
    """Return the time in which a folded sheet whose creases rest flat comes to rest by statics."""
    design = with_values(sheet(size), {"crease.rest_angle": "flat"})
    structure = structure_of(design)
    net = net_of(structure)
    wall, cpu, (rest, _) = _timed(lambda: released(net, start_shape(structure, net)))
    return {"size": size, "nodes": len(net.nodes), "steps": rest.steps, "wall_s": wall, "cpu_s": cpu}


def swing(size: int, timestep: float) -> dict[str, Any]:
    """Return CPU time and errors of an undamped sheet of rigid plates that swings through more than 100 deg."""
    changes = {
        "pattern.long_side": 0.02,
        "pattern.short_side": 0.02,
        "pattern.fold": np.radians(30),
        "facet.thickness": 5e-4,
        "facet.density": 1200.0,
        "crease.stiffness": 1e-3,
        "crease.damping": 0.0,
        "crease.rest_angle": np.radians(75),
        "drive": [],
        "support": [],
        "protocol.timestep": timestep,
        "protocol.sample_interval": _SWING / 100,
        "protocol.stages": [
            {"name": "swing", "drive": "none", "until": "time", "hold": 0.0, "time_limit": _SWING},
        ],
    }
    model = compile_model(with_values(sheet(size, "rigid"), changes))
    _, cpu, (record,) = _timed(lambda: simulate([model]))
    energy = record.series["hinge_energy"].sum(axis=1) + record.series["kinetic_energy"]
    return {
        "size": size,
        "timestep_s": timestep,
        "swing_deg": float(np.degrees(np.ptp(record.series["hinge_angle"], axis=0).max())),
        "cpu_per_second": cpu / _SWING,
        "energy_error": float(np.abs(energy / energy[0] - 1).max()),
        "gap": float(record.series["closure_gap"][-1] / 0.02),
    }


def side_by_side() -> dict[str, Any]:
    """Designs of differing crease stiffness as one batch, by the same one after another."""
    stiffness = np.geomspace(0.01, 0.04, _DESIGNS).tolist()
    timestep = float(sheet(4, **{"crease.stiffness": max(stiffness)}).protocol.timestep)
    limits = _duration(timestep, _TOGETHER)
    models = [compile_model(with_values(sheet(4, **{"crease.stiffness": value}), limits)) for value in stiffness]
    simulate(models[:1])
    together = _timed(lambda: simulate(models))
    apart = _timed(lambda: [simulate([model]) for model in models])
    return {
        "designs": _DESIGNS,
        "together_steps_per_s": _DESIGNS * _TOGETHER / together[0],
        "apart_steps_per_s": _DESIGNS * _TOGETHER / apart[0],
        "ratio": apart[0] / together[0],
        "ratio_of_cpu": apart[1] / together[1],
    }


def _timed(work: Callable[[], Any]) -> tuple[float, float, Any]:
    """Return wall and CPU time, s, and the result."""
    wall, cpu = time.perf_counter(), time.process_time()
    done = work()
    return time.perf_counter() - wall, time.process_time() - cpu, done


def _show(numbers: dict[str, Any]) -> None:
    for key in ("machine", "load_before", "load_after"):
        print(f"{key}: {numbers[key]}")
    for row in numbers["steps"]:
        name = f"Miura {row['size']}x{row['size']}, {row['kind']}"
        if "fault" in row:
            print(f"{name}: {row['fault']}")
            continue
        print(
            f"{name}: {row['dof']} dof, {row['steps_per_s']:.0f} steps/s ({row['steps_per_cpu_s']:.0f} by CPU),"
            f" {1e6 * row['timestep_s']:.3g} us a step"
        )
    for row in numbers["paths"]:
        print(
            f"load path, {row['size']}x{row['size']}, {row['nodes']} nodes: {row['increments']} increments"
            f" ({row['ended']}) in {row['wall_s']:.2f} s, {row['cpu_s']:.2f} s CPU"
        )
    for row in numbers["landscapes"]:
        print(
            f"landscape of {row['design']}: {row['states']} states, {row['passes']} saddles, {row['wall_s']:.2f} s,"
            f" {row['cpu_s']:.2f} s CPU, {row['newton_steps']:.0f} times a Newton step"
        )
    for row in numbers["releases"]:
        print(
            f"release, {row['size']}x{row['size']}, {row['nodes']} nodes: {row['steps']} steps, {row['wall_s']:.2f} s,"
            f" {row['cpu_s']:.2f} s CPU"
        )
    for row in numbers["swings"]:
        print(
            f"swing of {row['size']}x{row['size']} rigid plates by {row['swing_deg']:.0f} deg,"
            f" {1e3 * row['timestep_s']:.3g} ms: {row['cpu_per_second']:.2g} s CPU per second,"
            f" energy within {row['energy_error']:.1e}, gap {row['gap']:.1e} of an edge"
        )
    batch = numbers["batch"]
    print(
        f"{batch['designs']} designs as one batch: {batch['together_steps_per_s']:.0f} steps/s, one after another"
        f" {batch['apart_steps_per_s']:.0f}: {batch['ratio']:.1f} times as fast by wall,"
        f" {batch['ratio_of_cpu']:.1f} by CPU"
    )


def main() -> None:
    """Run and report."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--most", type=int, default=max(_SIZES), help="largest sheet, facets along a side")
    parser.add_argument("--json", type=Path)
    arguments = parser.parse_args()
    sizes = [size for size in _SIZES if size <= arguments.most]
    whole = arguments.most >= max(_SIZES)
    numbers: dict[str, Any] = {
        "machine": {"cores": os.cpu_count(), "python": platform.python_version(), **versions()},
        "load_before": os.getloadavg()[0],
        "steps": [steps_per_second(size, kind) for size in sizes for kind in _KINDS],
        "paths": [path_time(size) for size in sizes],
        "landscapes": [landscape_time(name) for name in (_LANDSCAPES if whole else _LANDSCAPES[:1])],
        "releases": [release_time(size) for size in (*sizes, *([_LARGE] if whole else []))],
        "swings": [swing(size, step) for size in sizes for step in _SWUNG],
        "batch": side_by_side(),
        "load_after": os.getloadavg()[0],
    }
    _show(numbers)
    if arguments.json:
        arguments.json.write_text(json.dumps(numbers, indent=1))


if __name__ == "__main__":
    main()
