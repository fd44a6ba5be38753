"""How accurate are runs whose timestep is "auto"? Random designs of one to three units, beside a quarter of the step.

python benchmarks/timestep.py [--designs N] [--seed S] [--json FILE]
"""

from __future__ import annotations

import argparse
import json
import math
import os
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from pathlib import Path
from typing import Any

import numpy as np

from forficula.analysis import measure
from forficula.design import Design, load_design, with_values
from forficula.dynamics import with_timestep
from forficula.errors import InputError
from forficula.study.running.runs import run_each


def random_designs(seed: int, count: int, *, wide: bool = False, **values: object) -> Iterator[Design]:
    """Draw designs that can be built: sizes of 3 to 40 cm, and every other value by its scale with the size.

    What only has a magnitude is drawn evenly in its logarithm, up to three times what the paper, its prototype or the
    reference have, or less; `wide`, up to nine times.
    """
    rng, base = np.random.default_rng(seed), load_design("binder2025")
    while count:
        try:
            drawn = _drawn(rng, 2.0 if wide else 1.0)
            yield with_values(base, {**drawn, "name": f"random-{count}", "protocol.timestep": "auto", **values})
        except InputError:  # of values that do not fit together
            continue
        count -= 1


def _drawn(rng: np.random.Generator, width: float) -> dict[str, object]:
    """Return values of one design by dotted key, SI; those of a wing of 12 cm are scaled by powers of its size."""

    def even(low: float, high: float) -> float:
        return float(rng.uniform(low, high))

    def spread(low: float, high: float) -> float:
        middle, half = math.log(low * high) / 2, width * math.log(high / low) / 2
        return float(np.exp(rng.uniform(middle - half, middle + half)))

    proximal = float(np.exp(rng.uniform(math.log(0.03), math.log(0.4))))
    size, distal, units = proximal / 0.12, proximal * even(0.4, 1.5), int(rng.choice([1, 1, 1, 2, 2, 3]))
    arms = proximal * even(0.15, 0.9), distal * even(0.15, 0.9)
    overbend = math.radians(even(0.5, 10))
    return {
        "pattern.units": units,
        "pattern.proximal_length": proximal,
        "pattern.distal_length": distal,
        "pattern.hub_radius": proximal * even(0.02, 0.25),
        "pattern.sector_angle": math.radians(even(8, 40 if units == 1 else 25)),
        "pattern.tangent": str(rng.choice(["left", "right"])),
        "vein.diameter": size * spread(3e-3, 8e-3),
        "vein.density": spread(600, 2700),
        "membrane.youngs_modulus": spread(0.4e6, 3e6),
        "membrane.thickness": size * spread(0.05e-3, 0.2e-3),
        "membrane.poisson_ratio": even(0, 0.49),
        "membrane.damping": size * spread(0.3e-3, 3e-3),
        "membrane.margin": size * even(0.003, 0.025),
        "membrane.margin_limit": even(0.3, 0.9),
        "hinge.overbend": overbend,
        "hinge.damping": size**4 * spread(3e-4, 3e-3),
        "hinge.armature": size**5 * spread(3e-6, 3e-5),
        "tendon.stiffness": size * spread(400, 6000),
        "tendon.rest_length": even(0, 1) * sum(arms),
        "tendon.damping": size**2 * spread(0.03, 0.3),
        "tendon.proximal_attachment": arms[0],
        "tendon.distal_attachment": arms[1],
        "protocol.fold_torque": size**3 * spread(0.1, 1),
        "protocol.unfold_torque": size**3 * spread(0.3, 2),
        "protocol.initial_overbend": overbend * even(0.2, 0.9),
        "protocol.sample_interval": 1e-3 * size,
        "protocol.window": 0.1 * size,
        "protocol.rest_speed": math.radians(5) / size,
        **{
            f"protocol.stages.{number}.time_limit": limit * size
            for number, limit in enumerate((0.3, 1.0, 1.0, 1.0, 1.0))
        },
        **{f"protocol.stages.{number}.hold": 0.1 * size for number in (2, 3, 4)},
    }


def judge(design: Design) -> dict[str, Any]:
    """Run a design with the timestep that "auto" finds, with a quarter of it, and with the first guess alone."""
    ((_, record),) = run_each([design], threads=1, sparse=True)
    if isinstance(record, InputError):
        return {"name": design.name, "fault": str(record)}
    step, guess = float(record.design.protocol.timestep), float(with_timestep(design).protocol.timestep)
    runs = {"auto": record}
    for name, timestep in (("quarter", step / 4), ("guess", guess)):
        ((_, runs[name]),) = run_each([with_values(design, {"protocol.timestep": timestep})], threads=1, sparse=True)
    results: dict[str, Any] = {"name": design.name, "units": design.pattern.units}
    for name, record in runs.items():
        outcome, timestep = measure(record), float(record.design.protocol.timestep)
        results[name] = {
            "timestep_s": timestep,
            "status": outcome.status,
            "verdict": outcome.verdict.value,
            "goal": outcome.ending.goal,
            "residual": outcome.energy_balance.residual,
            "fold_time_s": outcome.transitions["fold"].time if outcome.transitions["fold"] else None,
            "steps": round(float(record.time[-1]) / timestep),
        }
    # what the search for the step took: every halving between the first guess and the last step
    results["tries"] = round(math.log2(guess / step))
    return results


def report(rows: list[dict[str, Any]]) -> None:
    """Print shares of designs, by rule."""
    valid = [row for row in rows if "fault" not in row]
    print(f"{len(valid)} designs, {len(rows) - len(valid)} that cannot be built")
    for rule in ("auto", "guess"):
        fine = [row[rule]["residual"] <= 0.005 for row in valid]
        folded = [row for row in valid if row["quarter"]["fold_time_s"] and row[rule]["fold_time_s"]]
        near = [abs(row[rule]["fold_time_s"] / row["quarter"]["fold_time_s"] - 1) <= 0.03 for row in folded]
        same = [
            (row[rule]["verdict"], row[rule]["goal"]) == (row["quarter"]["verdict"], row["quarter"]["goal"])
            for row in valid
        ]
        print(
            f"{rule}: residual <= 0.5 % in {sum(fine)} of {len(fine)}, fold time within 3 % in {sum(near)} of"
            f" {len(near)}, the same outcome in {sum(same)} of {len(same)}"
        )
    ratio = [row["auto"]["steps"] / max(row["guess"]["steps"], 1) for row in valid]
    print(
        f"steps by those of the guess: median {np.median(ratio):.3g}, mean {np.mean(ratio):.3g}, most {max(ratio):.3g}"
    )


def main() -> None:
    """Run and report."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--designs", type=int, default=120)
    parser.add_argument("--seed", type=int, default=2026)
    parser.add_argument("--wide", action="store_true")
    parser.add_argument("--json", type=Path)
    parser.add_argument("--least-hold", type=float)
    arguments = parser.parse_args()
    values = {} if arguments.least_hold is None else {"protocol.least_hold": arguments.least_hold}
    rows = []
    with ProcessPoolExecutor(os.cpu_count()) as workers:
        for row in workers.map(judge, random_designs(arguments.seed, arguments.designs, wide=arguments.wide, **values)):
            rows.append(row)
            print(json.dumps(row), flush=True)
            if arguments.json:
                arguments.json.write_text(json.dumps(rows))
    report(rows)


if __name__ == "__main__":
    main()
