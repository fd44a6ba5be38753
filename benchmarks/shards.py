"""A study in many shards that fail, vanish, are cut, changed or written twice: status, repair and collection.

The runs are not simulated: the stand-in evaluator of `many_points.py` returns their rows. The shards run one after
another in one process. Everything else is what `forficula study` does with `--shard`, `--status` and `--collect`.
"""

from __future__ import annotations

import argparse
import json
import os
import random
import resource
import time
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np
from many_points import STUDY, real_rows, stand_in

from forficula.errors import InputError
from forficula.study import Study, collect, load_study, run_study
from forficula.study.running.study_status import StudyStatus, study_status

_HOUR = 3600.0


def main() -> None:
    """Run all shards, do the damage, and measure how long it takes to find, repair and collect."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--points", type=int, default=100_000, metavar="N", help="number of points")
    parser.add_argument("--shards", type=int, default=1000, metavar="N", help="number of shards, at least 12")
    parser.add_argument("--folder", type=Path, help="folder for all files; by default a temporary one")
    parser.add_argument("--json", type=Path, metavar="FILE", help="file for the numbers")
    options = parser.parse_args()
    with TemporaryDirectory() as temporary:
        numbers = measure(options.folder or Path(temporary), options.points, options.shards)
    if options.json is not None:
        options.json.write_text(json.dumps(numbers, indent=2))


def measure(folder: Path, points: int, shards: int) -> dict[str, float]:
    """Return the time of every step, s, and the peak memory, MB."""
    out = folder / "out"
    out.mkdir(parents=True)
    path = folder / "many-points.toml"
    path.write_text(STUDY.format(points=points, method="random"))
    real_rows(out)
    study, rows = load_study(path), stand_in(*json.loads((out / "rows.json").read_text()))
    damaged = dict(
        zip(_FAULTS, np.array_split(random.Random(1).sample(range(1, shards + 1), shards // 2), 6), strict=True)
    )
    numbers: dict[str, float] = {}

    def timed(what: str, start: float) -> None:
        numbers[what] = time.perf_counter() - start
        print(f"| {what} | {numbers[what]:.1f} s |", flush=True)

    print(f"{points} points, {shards} shards\n\n| step | wall |\n|---|---|")
    start = time.perf_counter()
    for number in range(1, shards + 1):
        fails = number in damaged["failed"]
        run_shard(study, out, (number, shards), _failing(rows) if fails else rows)
    for fault, numbers_of_shards in damaged.items():
        for number in numbers_of_shards:
            _FAULTS[fault](out / f"journal-{number}-of-{shards}.jsonl")
    timed("all shards", start)
    start = time.perf_counter()
    status = study_status(study, out)
    timed("status with damage", start)
    expected = {int(number) for fault, chosen in damaged.items() if fault != "written twice" for number in chosen}
    assert again(status) == expected, (again(status), expected)
    start = time.perf_counter()
    for number in sorted(expected):
        run_shard(study, out, (number, shards), rows)
    timed(f"{len(expected)} shards again", start)
    start = time.perf_counter()
    status = study_status(study, out)
    timed("status when complete", start)
    assert status.complete, status.run_again
    assert status.points_done == points
    start = time.perf_counter()
    table = collect(study, out)
    timed("collect", start)
    for number in range(1, shards + 1):
        (out / f"journal-{number}-of-{shards}.jsonl").unlink()
    if points <= 100_000:
        whole = run_study(study, folder / "whole", cluster=rows)
        assert table.identical(whole), "the table differs from that of the undivided study"
    numbers["peak_MB"] = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    print(f"\npeak memory {numbers['peak_MB']:.0f} MB")
    return numbers


def run_shard(study: Study, out: Path, shard: tuple[int, int], rows: Any) -> None:
    """Run a shard; an error of the evaluator ends it as a failed job."""
    with suppress(InputError):
        run_study(study, out, shard=shard, cluster=rows)


def again(status: StudyStatus) -> set[int]:
    """Return the numbers of the shards that must run again."""
    numbers: set[int] = set()
    for part in filter(None, status.run_again.split(",")):
        first, _, last = part.partition("-")
        numbers |= set(range(int(first), int(last or first) + 1))
    return numbers


def _failing(rows: Any) -> Any:
    """Return an evaluator that fails after the first row."""

    def first_row(designs: Any, until_last: bool) -> Iterator[dict[str, Any]]:
        yield next(rows(designs, until_last))
        raise InputError("node is out of memory")

    return first_row


def _vanish(path: Path) -> None:
    path.unlink()


def _cut(path: Path) -> None:
    """Cut a journal in the middle of a line, as a killed job does, an hour ago."""
    content = path.read_bytes()
    path.write_bytes(content[: len(content) // 2])
    os.utime(path, (time.time() - _HOUR,) * 2)


def _flip(path: Path) -> None:
    """Change one bit in the middle of a journal, as a faulty disk does."""
    content = bytearray(path.read_bytes())
    content[len(content) // 2] ^= 4
    path.write_bytes(content)


def _lose_lines(path: Path) -> None:
    """Remove the first half of the rows; the last lines remain."""
    lines = path.read_bytes().splitlines(keepends=True)
    rows = [line for line in lines if line.startswith(b'{"key"')]
    lost = set(rows[: (len(rows) + 1) // 2])
    path.write_bytes(b"".join(line for line in lines if line not in lost))


def _write_twice(path: Path) -> None:
    """Write a journal twice, as two jobs with the same shard do."""
    path.with_suffix(".2.jsonl").write_bytes(path.read_bytes())


_FAULTS = {
    "failed": lambda _: None,
    "vanished": _vanish,
    "cut": _cut,
    "changed": _flip,
    "lines lost": _lose_lines,
    "written twice": _write_twice,
}


if __name__ == "__main__":
    main()
