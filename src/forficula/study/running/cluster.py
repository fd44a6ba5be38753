"""Runs on a Dask cluster, and the SLURM job array that runs the shards of a study."""

from __future__ import annotations

import gc
import math
import re
import shlex
import time
from collections import deque
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

from forficula.design import Design, design_from_text, design_text
from forficula.dynamics import versions
from forficula.errors import InputError
from forficula.quantities import as_written
from forficula.study.running.evaluate import evaluate
from forficula.study.running.journal import Row
from forficula.study.running.run_study import Evaluate

# A task costs Dask 1.6 ms, which 0.2 s of work make good: less is run here. A chunk is meant to be longer, for its runs
# share their first stages, and how long they take is known from earlier ones only.
_LEAST_SECONDS = 0.2
_CHUNK_SECONDS = 1.0
# Chunks in the hands of the cluster for every thread that it has: one at work, one that waits.
_AHEAD = 2
_CONNECT_SECONDS = 3
_LOOK_SECONDS = 0.05
# How long a study waits for a worker where all have left.
_PATIENCE_SECONDS = 60
_MOST_SHARDS = 10_000


@dataclass
class _Pace:
    """How long a run takes on one thread, from those that are done."""

    runs: int = 0
    seconds: float = 0.0

    def add(self, done: dict[str, Any], runs: int) -> list[Row]:
        """Take note of what a chunk of so many runs took, and hand on its rows."""
        self.runs, self.seconds = self.runs + runs, self.seconds + done["seconds"]
        return list(done["rows"])

    def runs_in(self, seconds: float) -> int:
        """How many runs take so long at least."""
        return math.ceil(seconds / max(self.seconds / self.runs, 1e-4))

    def chunk(self, left: int) -> int:
        """How many runs go out next: all, where those after them would be too few for a chunk."""
        size = self.runs_in(_CHUNK_SECONDS)
        return left if left - size < self.runs_in(_LEAST_SECONDS) else size


@contextmanager
def dask_cluster(address: str) -> Iterator[Evaluate]:
    """Connect to a cluster and hand out what `run_study` takes as `cluster`.

    A worker that dies costs the time of its chunk: Dask gives it to another one, and a chunk that keeps killing workers
    is run here. Each chunk runs on one thread and is meant to take a second, 0.2 s at least; the first runs, which tell
    how many runs that is, and rounds of a search that take less than 0.2 s, run here.

    Args:
        address: of the scheduler, such as "tcp://scheduler:8786".

    Raises:
        InputError: Dask is not installed; nothing answers at the address, or it has no workers; later on, the scheduler
            is gone, all workers have been gone for a minute, or one lacks forficula or has it in other versions.
    """
    try:
        from distributed import Client
    except ImportError:
        raise InputError('--dask: needs Dask; install it with: pip install "forficula[cluster]"') from None
    why = ""
    try:
        client = Client(address, timeout=_CONNECT_SECONDS, set_as_default=False)
    except (OSError, ValueError, TypeError) as error:
        why = f"no Dask scheduler answers at {address}: {error}"
    except AssertionError:  # of Dask's own: its thread did not start within ten seconds
        why = "Dask cannot start here, the machine is too busy; try again"
    if why:
        # were the client that failed collected while another one starts, it would wait for that one's lock for ever
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
    """Rows in the order in which the cluster finishes them."""
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
            # two chunks are never one task: a key of its own for each, made from nothing
            future = client.submit(_run_chunk, texts, until_last, pure=False)
            chunks[future] = texts
            finished.add(future)
        _wait(client, address, finished)
        future = next(finished)
        texts = chunks.pop(future)
        yield from pace.add(_result(client, address, future) or _run_chunk(texts, until_last), len(texts))


def _wait(client: Any, address: str, finished: Any) -> None:
    """Wait until a chunk is done, but not for ever where nobody is at work."""
    seen = time.monotonic()
    while not finished.has_ready():
        if _threads(client, address):
            seen = time.monotonic()
        elif time.monotonic() - seen > _PATIENCE_SECONDS:
            raise InputError(
                f"--dask: the scheduler at {address} has had no workers for {_PATIENCE_SECONDS} s;"
                " the same command goes on where it stood"
            )
        time.sleep(_LOOK_SECONDS)


def _threads(client: Any, address: str) -> int:
    """How many threads the workers have."""
    try:
        return sum(client.nthreads().values())
    except OSError:
        raise _gone(address) from None


def _gone(address: str) -> InputError:
    return InputError(f"--dask: the scheduler at {address} is gone; the same command goes on where it stood")


def _result(client: Any, address: str, future: Any) -> dict[str, Any] | None:
    """What a chunk's task left, or None where its workers died of it."""
    from distributed import KilledWorker

    if client.status != "running" or future.cancelled():
        raise _gone(address)
    error = future.exception()
    if isinstance(error, KilledWorker):
        return None
    if error is not None:
        raise InputError(f"--dask: a worker cannot run forficula: {type(error).__name__}: {error}")
    done: dict[str, Any] = future.result()
    if done["versions"] != versions():
        raise InputError(f"--dask: a worker has other versions: {done['versions']} there, {versions()} here")
    return done


def _run_chunk(texts: Iterable[str], until_last: bool) -> dict[str, Any]:
    """Run designs on one thread; this is what a worker does."""
    start = time.perf_counter()
    rows = list(evaluate([design_from_text(text) for text in texts], threads=1, until_last=until_last))
    return {"rows": rows, "seconds": time.perf_counter() - start, "versions": versions()}


def slurm_script(study: str, out: str, shards: int) -> str:
    """Write the text of a job array, one job a shard.

    Args:
        study: name or path, as the command line takes it.
        out: folder of the study, on a disk that all machines see.
        shards: how many jobs.

    Raises:
        InputError: not a sensible number of jobs.
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
