"""Run studies on a Dask cluster, and write SLURM job arrays that run the shards of a study."""

from __future__ import annotations

import gc
import math
import re
import shlex
import time
from collections import deque
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

from forficula.design import Design, design_from_text, design_text
from forficula.dynamics import versions
from forficula.errors import InputError
from forficula.optional_module import optional_module
from forficula.quantities import as_written
from forficula.study.running.evaluate import evaluate
from forficula.study.running.journal import Row
from forficula.study.running.run_study import Evaluate

# A task costs Dask 1.6 ms, so a chunk of less than 0.2 s of work runs in this process. Chunks are meant to be longer,
# because their runs share their first stages. The time of a run is estimated from earlier runs.
_LEAST_SECONDS = 0.2
_CHUNK_SECONDS = 1.0
# Chunks submitted per thread of the cluster: one that runs and one that waits.
_AHEAD = 2
_CONNECT_SECONDS = 3
_LOOK_SECONDS = 0.05
# How long a study waits for a worker if none is connected.
_PATIENCE_SECONDS = 60
_MOST_SHARDS = 10_000


@dataclass
class _Pace:
    """Average time of a run on one thread, from completed runs."""

    runs: int = 0
    seconds: float = 0.0

    def add(self, done: dict[str, Any], runs: int) -> list[Row]:
        """Record the time of a chunk with a number of runs, and return its rows."""
        self.runs, self.seconds = self.runs + runs, self.seconds + done["seconds"]
        return list(done["rows"])

    def runs_in(self, seconds: float) -> int:
        """Return the number of runs that take at least this time."""
        return math.ceil(seconds / max(self.seconds / self.runs, 1e-4))

    def chunk(self, left: int) -> int:
        """Return the size of the next chunk; all runs if too few would remain for another chunk."""
        size = self.runs_in(_CHUNK_SECONDS)
        return left if left - size < self.runs_in(_LEAST_SECONDS) else size


@contextmanager
def dask_cluster(address: str) -> Iterator[Evaluate]:
    """Connect to a cluster and yield the function that `run_study` accepts as `cluster`.

    A worker that dies costs the time of its chunk, because Dask gives the chunk to another worker. A chunk that keeps
    killing workers runs in this process. Each chunk runs on one thread and is meant to take 1 s, at least 0.2 s. The
    first runs, which measure the time of a run, and rounds of a search that take less than 0.2 s run in this process.

    Args:
        address: address of the scheduler, such as "tcp://scheduler:8786".

    Raises:
        InputError: Dask is not installed; nothing answers at the address, or it has no workers. Later: the scheduler
            has gone, all workers have been gone for a minute, or a worker lacks forficula or has other versions.
    """
    distributed = optional_module("distributed", "a cluster needs Dask", "forficula[cluster]")
    why = ""
    try:
        client = distributed.Client(address, timeout=_CONNECT_SECONDS, set_as_default=False)
    except (OSError, ValueError, TypeError) as error:
        why = f"no Dask scheduler answers at {address}: {error}"
    except AssertionError:  # raised by Dask: its thread did not start within ten seconds
        why = "Dask cannot start because this machine is too busy; try again"
    if why:
        # if the failed client were collected while another one starts, it would wait for that one's lock for ever
        gc.collect()
        raise InputError(f"--dask: {why}")
    with client:
        try:
            client.wait_for_workers(1, timeout=_CONNECT_SECONDS)
        except TimeoutError:
            raise InputError(f"--dask: the Dask scheduler at {address} has no workers") from None
        pace = _Pace()
        yield lambda designs, until_last: _evaluate(client, address, pace, designs, until_last)


def _evaluate(client: Any, address: str, pace: _Pace, designs: Sequence[Design], until_last: bool) -> Iterator[Row]:
    """Yield rows in the order in which the cluster finishes them."""
    from distributed import as_completed

    left = deque(design_text(design) for design in designs)
    while left and pace.seconds < _LEAST_SECONDS:
        yield from pace.add(_run_chunk([left.popleft()], until_last), 1)
    if left and len(left) < pace.runs_in(_LEAST_SECONDS):
        yield from pace.add(_run_chunk(left, until_last), len(left))
        return
    chunks: dict[Any, list[str]] = {}
    finished = as_completed(loop=client.loop)
    while left or chunks:
        ahead = _AHEAD * max(1, _threads(client, address))
        while left and len(chunks) < ahead:
            texts = [left.popleft() for _ in range(pace.chunk(len(left)))]
            # pure=False: every chunk gets a key of its own, so that two chunks are never one task
            future = client.submit(_run_chunk, texts, until_last, pure=False)
            chunks[future] = texts
            finished.add(future)
        _wait(client, address, finished)
        future = next(finished)
        texts = chunks.pop(future)
        yield from pace.add(_result(client, address, future) or _run_chunk(texts, until_last), len(texts))


def _wait(client: Any, address: str, finished: Any) -> None:
    """Wait until a chunk is done, but not for ever if there are no workers."""
    last_seen = time.monotonic()
    while not finished.has_ready():
        if _threads(client, address):
            last_seen = time.monotonic()
        elif time.monotonic() - last_seen > _PATIENCE_SECONDS:
            raise InputError(
                f"--dask: the scheduler at {address} has had no workers for {_PATIENCE_SECONDS} s;"
                " the same command continues where it stopped"
            )
        time.sleep(_LOOK_SECONDS)


def _threads(client: Any, address: str) -> int:
    """Return the number of threads of all workers."""
    try:
        return sum(client.nthreads().values())
    except OSError:
        raise _gone(address) from None


def _gone(address: str) -> InputError:
    return InputError(f"--dask: the scheduler at {address} is gone; the same command continues where it stopped")


def _result(client: Any, address: str, future: Any) -> dict[str, Any] | None:
    """Return the result of a chunk, or None if it killed its workers."""
    from distributed import KilledWorker

    if client.status != "running" or future.cancelled():
        raise _gone(address)
    error = future.exception()
    if isinstance(error, KilledWorker):
        return None
    if error is not None:
        raise InputError(f"--dask: a worker cannot run forficula: {type(error).__name__}: {error}")
    done: dict[str, Any] = future.result()
    _check_versions(done["versions"])
    return done


def _check_versions(of_worker: Mapping[str | None, Mapping[str, str]]) -> None:
    """Refuse rows of a worker whose packages have other versions than those of this process.

    Args:
        of_worker: versions of the packages by device; None for the processor.

    Raises:
        InputError: a version differs.
    """
    for device, names in of_worker.items():
        if names != (current := versions(device)):
            raise InputError(f"--dask: a worker has other versions: {names}, but this process has {current}")


def _run_chunk(texts: Iterable[str], until_last: bool) -> dict[str, Any]:
    """Run designs on one thread, in a worker."""
    start = time.perf_counter()
    designs = [design_from_text(text) for text in texts]
    rows = list(evaluate(designs, threads=1, until_last=until_last))
    of_devices = {device: versions(device) for device in {design.protocol.device for design in designs}}
    return {"rows": rows, "seconds": time.perf_counter() - start, "versions": of_devices}


def slurm_script(study: str, out: str, shards: int) -> str:
    """Return the text of a job array with one job per shard.

    Args:
        study: name or path, as on the command line.
        out: folder of the study, on a disk that all machines share.
        shards: number of jobs.

    Raises:
        InputError: a number of jobs that is not allowed, or a name with a line break or not in UTF-8.
    """
    if not 1 <= shards <= _MOST_SHARDS:
        raise InputError(f"--slurm: need a number of jobs from 1 to {_MOST_SHARDS}, got {shards}")
    for text in (study, out):
        if any(sign in text for sign in "\r\n"):
            raise InputError("--slurm: need names on one line, got a line break in the name of the study or its folder")
        if re.search("[\ud800-\udfff]", text):
            raise InputError(f"--slurm: need names in UTF-8, got {as_written(text)}")
    command = f"forficula study {shlex.quote(study)} --out {shlex.quote(out)}"
    return f"""#!/bin/bash
#SBATCH --job-name=forficula
#SBATCH --array=1-{shards}
#SBATCH --cpus-per-task=4
#SBATCH --output={shlex.quote(out)}/slurm-%a.log
# Submit with: sbatch THIS_FILE. When all jobs are done: {command} --collect
{command} --shard "${{SLURM_ARRAY_TASK_ID}}/{shards}"
"""
