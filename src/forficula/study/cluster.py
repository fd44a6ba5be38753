"""Runs on a Dask cluster that exists: designs go out as text, rows of plain numbers come back."""

from __future__ import annotations

import math
import time
from collections import deque
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from typing import Any

from forficula.design import Design, design_from_text, design_text
from forficula.dynamics import versions
from forficula.errors import InputError
from forficula.study.evaluate import evaluate
from forficula.study.journal import Row
from forficula.study.run_study import Evaluate

# A task costs Dask 1.6 ms, which 0.2 s of work make good; neighbours, which share their first stages within a chunk,
# want more than that.
_CHUNK_SECONDS = 1.0
# Chunks in the hands of the cluster for every thread that it has: one at work, one that waits.
_AHEAD = 2
_CONNECT_SECONDS = 3


@contextmanager
def dask_cluster(address: str) -> Iterator[Evaluate]:
    """Connect to a cluster and hand out what `run_study` takes as `cluster`.

    A worker that dies costs the time of its chunk: Dask gives it to another one, and a chunk that keeps killing workers
    is run here. Each chunk runs on one thread.

    Args:
        address: of the scheduler, such as "tcp://scheduler:8786".

    Raises:
        InputError: Dask is not installed; nothing answers at the address, or it has no workers; later on, the scheduler
            is gone, or a worker lacks forficula or has it in other versions.
    """
    try:
        from distributed import Client
    except ImportError:
        raise InputError('--dask: needs Dask; install it with: pip install "forficula[cluster]"') from None
    try:
        client = Client(address, timeout=_CONNECT_SECONDS, set_as_default=False)
    except (OSError, ValueError, TypeError) as error:
        raise InputError(f"--dask: no Dask scheduler answers at {address}: {error}") from None
    with client:
        try:
            client.wait_for_workers(1, timeout=_CONNECT_SECONDS)
        except TimeoutError:
            raise InputError(f"--dask: the Dask scheduler at {address} has no workers") from None
        yield lambda designs, until_opened: _evaluate(client, address, designs, until_opened)


def _evaluate(client: Any, address: str, designs: Sequence[Design], until_opened: bool) -> Iterator[Row]:
    """Rows in the order in which the cluster finishes them."""
    from distributed import as_completed

    left = deque(design_text(design) for design in designs)
    chunks: dict[Any, list[str]] = {}
    # of the runs that came back; how long a run takes is not known before
    runs, seconds = 0, 0.0
    finished = as_completed(loop=client.loop)

    def submit(size: int) -> None:
        texts = [left.popleft() for _ in range(min(size, len(left)))]
        # two chunks are never one task: a key of its own for each, made from nothing
        future = client.submit(_run_chunk, texts, until_opened, pure=False)
        chunks[future] = texts
        finished.add(future)

    if left:
        submit(1)
    for future in finished:
        texts = chunks.pop(future)
        done = _result(client, address, future) or _run_chunk(texts, until_opened)
        runs, seconds = runs + len(texts), seconds + done["seconds"]
        size = math.ceil(_CHUNK_SECONDS / max(seconds / runs, 1e-4))
        while left and len(chunks) < _AHEAD * max(1, sum(client.nthreads().values())):
            submit(size)
        yield from done["rows"]


def _result(client: Any, address: str, future: Any) -> dict[str, Any] | None:
    """What a chunk's task left, or None where its workers died of it."""
    from distributed import KilledWorker

    if client.status != "running" or future.cancelled():
        raise InputError(f"--dask: the scheduler at {address} is gone; the same command goes on where it stood")
    error = future.exception()
    if isinstance(error, KilledWorker):
        return None
    if error is not None:
        raise InputError(f"--dask: a worker cannot run forficula: {type(error).__name__}: {error}")
    done: dict[str, Any] = future.result()
    if done["versions"] != versions():
        raise InputError(f"--dask: a worker has other versions: {done['versions']} there, {versions()} here")
    return done


def _run_chunk(texts: list[str], until_opened: bool) -> dict[str, Any]:
    """Run designs on one thread; this is what a worker does."""
    start = time.perf_counter()
    rows = list(evaluate([design_from_text(text) for text in texts], threads=1, until_opened=until_opened))
    return {"rows": rows, "seconds": time.perf_counter() - start, "versions": versions()}
