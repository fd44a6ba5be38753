"""A study of many points: planned, run in shards, killed, resumed, collected, tabled and drawn; time and peak memory.

The runs are not simulated. A stand-in evaluator returns rows of three real runs of the design, which opens, does not
open or does not fold, in three regions of the space of the factors, with scaled numbers. Everything else is what
`forficula study` does: the shards by `run_study`, the rest by the command itself.
"""

from __future__ import annotations

import argparse
import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Iterator, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import forficula as ff
from forficula.design import Design, key_value
from forficula.study import load_study, run_study
from forficula.study.running.evaluate import evaluate, row_key

STUDY = """
name = "many-points"
design = "binder2025"

[factors]
"tendon.stiffness" = {{ distribution = "uniform", low = "2 N/cm", high = "60 N/cm" }}
"tendon.rest_length" = {{ distribution = "uniform", low = "4 cm", high = "10 cm" }}
"vein.density" = {{ distribution = "log-uniform", low = "0.5 g/cm^3", high = "5 g/cm^3" }}

[sampling]
method = "{method}"
count = {points}
seed = 5
"""
# designs of the three real runs, which open, do not open, and do not fold: tendon stiffness, N/cm, and rest length, cm
_REAL = ((30, 10), (30, 6), (60, 6))


def stand_in(opens: dict[str, Any], folds: dict[str, Any], fails: dict[str, Any]) -> Any:
    """Return a function that `run_study` accepts as `cluster`, which returns rows without simulating anything."""

    def rows(designs: Sequence[Design], _: bool) -> Iterator[dict[str, Any]]:
        for design in designs:
            key = row_key(design)
            stiffness, length, density = (
                float(key_value(design, name)) for name in ("tendon.stiffness", "tendon.rest_length", "vein.density")
            )
            noise = int(key[-4:], 16) / 2**16 - 0.5
            margin = (length - 0.06) / 0.03 - (stiffness - 3000) / 3000 * (density / 2000) ** 0.5 + 0.1 * noise
            row = opens if margin > 0 else folds if margin > -0.4 else fails
            scale = 1 + 0.3 * margin
            yield {"key": key} | {
                name: scale * value if isinstance(value, float) and name != "timestep_s" else value
                for name, value in row.items()
                if name != "key"
            }

    return rows


def run_shard(path: str, folder: str, number: int, count: int) -> None:
    """Run a shard of the study with the stand-in evaluator."""
    study = load_study(path)
    real = json.loads((Path(folder) / "rows.json").read_text())
    run_study(study, folder, shard=(number, count), cluster=stand_in(*real))


def real_rows(folder: Path) -> None:
    """Write the rows of the three real runs."""
    base = ff.load_design("binder2025")
    designs = [
        base.with_values({"tendon.stiffness": f"{stiffness} N/cm", "tendon.rest_length": f"{length} cm"})
        for stiffness, length in _REAL
    ]
    by_key = {row["key"]: row for row in evaluate(designs)}
    (folder / "rows.json").write_text(json.dumps([by_key[row_key(design)] for design in designs]))


class Measured:
    """A process with its wall time, CPU time and peak memory."""

    def __init__(self, what: str, command: Sequence[str]) -> None:
        self.what, self._start = what, time.perf_counter()
        self.process = subprocess.Popen(command, stdout=subprocess.DEVNULL)

    def end(self, expected: int = 0) -> dict[str, Any]:
        """Wait for the process, print its numbers and return them."""
        _, status, usage = os.wait4(self.process.pid, 0)
        self.process.returncode = os.waitstatus_to_exitcode(status)
        assert self.process.returncode == expected, f"{self.what}: exit status {self.process.returncode}"
        seconds, cpu = time.perf_counter() - self._start, usage.ru_utime + usage.ru_stime
        print(f"| {self.what} | {seconds:.1f} s | {cpu:.1f} s | {usage.ru_maxrss / 1024:.0f} MB |", flush=True)
        return {"what": self.what, "wall_s": seconds, "cpu_s": cpu, "peak_MB": usage.ru_maxrss / 1024}


def main() -> None:
    """Measure every step in a process of its own."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--points", type=int, default=100_000, metavar="N", help="number of points")
    parser.add_argument("--shards", type=int, default=4, metavar="N", help="number of shards, one after another")
    parser.add_argument("--method", choices=["random", "sobol"], default="random", help="sampling method")
    parser.add_argument("--folder", type=Path, help="folder for all files; by default a temporary one")
    parser.add_argument("--json", type=Path, metavar="FILE", help="file for the numbers")
    parser.add_argument("--shard", nargs=4, metavar=("STUDY", "FOLDER", "NUMBER", "COUNT"), help=argparse.SUPPRESS)
    options = parser.parse_args()
    if options.shard is not None:
        path, folder, number, count = options.shard
        run_shard(path, folder, int(number), int(count))
        return
    with TemporaryDirectory() as temporary:
        numbers = measure(options.folder or Path(temporary), options.points, options.shards, options.method)
    if options.json is not None:
        options.json.write_text(json.dumps(numbers, indent=2))


def measure(folder: Path, points: int, shards: int, method: str) -> list[dict[str, Any]]:
    """Return the numbers of every step, and print them."""
    out = folder / "out"
    out.mkdir(parents=True)
    study = folder / "many-points.toml"
    study.write_text(STUDY.format(points=points, method=method))
    real_rows(out)
    command = [sys.executable, "-m", "forficula", "study", str(study), "--out", str(out)]
    print(f"{points} points, {shards} shards\n\n| step | wall | CPU | peak memory |\n|---|---|---|---|")
    done = [Measured("plan (`--dry-run`, one real run)", [*command, "--dry-run"]).end()]
    for number in range(1, shards + 1):
        again = [sys.executable, __file__, "--shard", str(study), str(out), str(number), str(shards)]
        if number == shards:
            journal = out / f"journal-{number}-of-{shards}.jsonl"
            killed = Measured(f"shard {number}, killed half-way", again)
            while not journal.exists() or journal.stat().st_size < 400 * points / shards:
                time.sleep(0.01)
                assert killed.process.poll() is None, "the shard ended before it was killed"
            killed.process.send_signal(signal.SIGKILL)
            done.append(killed.end(-signal.SIGKILL))
        done.append(Measured(f"shard {number}{', resumed' if number == shards else ''}", again).end())
    done.append(Measured("collect, table, maps and page", [*command, "--collect", "--keep", "0"]).end())
    reading = f"import xarray; t = xarray.open_dataset({str(out / 'table.nc')!r}); print(t['status'][-3:].values)"
    done.append(Measured("open the table, read three texts", [sys.executable, "-c", reading]).end())
    drawing = [
        sys.executable,
        "-m",
        "forficula",
        "figure",
        str(out),
        "--kind",
        "status",
        "--out",
        str(folder / "status.png"),
    ]
    done.append(Measured("draw a map again", drawing).end())
    sizes = {file.name: file.stat().st_size / 1e6 for file in sorted(out.iterdir()) if file.is_file()}
    print("\n" + ", ".join(f"{name} {size:.1f} MB" for name, size in sizes.items() if size >= 0.05))
    return [*done, {"what": "sizes", "MB": sizes}]


if __name__ == "__main__":
    main()
