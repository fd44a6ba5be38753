"""Writing of what a process that runs a shard does: its start, its progress and its end, see `attempts`."""

from __future__ import annotations

import hashlib
import json
import os
import secrets
import socket
import threading
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from typing import Any

from forficula.errors import InputError
from forficula.study.running.attempts import KEY
from forficula.study.running.journal import Journal, Row
from forficula.study.study import Study

# [chosen] interval at which a running process writes an entry, s
_INTERVAL = 30.0
# variables in which engines name a job, see the how-to page on clusters
_JOBS = (
    *("SLURM_ARRAY_JOB_ID", "SLURM_JOB_ID", "AWS_BATCH_JOB_ID", "BATCH_TASK_ID", "AZ_BATCH_TASK_ID"),
    *("PBS_JOBID", "LSB_JOBID", "JOB_ID"),
)


class AttemptWriter:
    """Writes the entries of one process to its journal."""

    def __init__(self, journal: Journal, study: Study) -> None:
        self._journal = journal
        self._start = time.monotonic()
        self._name = secrets.token_hex(4)
        self._progress: dict[str, Any] = {}
        self._rows = 0
        job, task = next((os.environ[name] for name in _JOBS if name in os.environ), ""), _task()
        self._write({"study": study_mark(study), "host": socket.gethostname(), "job": f"{job}{task}"})

    def append(self, row: Row) -> int:
        """Write a row to the journal, and return the byte at which its line begins; see `Journal.append` for errors."""
        offset = self._journal.append(row)
        self._rows += 1
        return offset

    def report(self, points: int, runs_left: int) -> None:
        """Set the progress that the next entry contains.

        Args:
            points: number of points of the shard that are complete.
            runs_left: number of runs that are known to be needed.
        """
        self._progress = {"points": points, "runs_left": runs_left}

    def write_progress(self) -> None:
        """Write the progress to the disk."""
        self._write(self._progress)
        self._journal.sync()

    def end(self, why: str = "") -> None:
        """Write the end of the process's work.

        Args:
            why: reason why the shard is not complete; empty if it is complete.
        """
        self._journal.sync()
        self._write({**self._progress, "ended": True, "why": why, "stored": self._journal.count_rows()})

    def _write(self, facts: Mapping[str, Any]) -> None:
        seconds = round(time.monotonic() - self._start, 3)
        self._journal.write_entry({KEY: {"name": self._name, "rows": self._rows, "seconds": seconds, **facts}})


@contextmanager
def attempt(journal: Journal, study: Study) -> Iterator[AttemptWriter]:
    """Write to a journal that this process runs a shard of a study, its progress every half minute, and its end."""
    writer, ended = AttemptWriter(journal, study), threading.Event()

    def write_progress() -> None:
        while not ended.wait(_INTERVAL):
            # the next row reports that the journal cannot be written
            with suppress(InputError):
                writer.write_progress()

    thread = threading.Thread(target=write_progress, daemon=True)
    thread.start()
    try:
        yield writer
    except BaseException as error:
        ended.set()
        thread.join()
        stopped = isinstance(error, KeyboardInterrupt | SystemExit)
        with suppress(InputError):
            writer.end("stopped" if stopped else str(error) or type(error).__name__)
        raise
    ended.set()
    thread.join()
    writer.end()


def study_mark(study: Study) -> str:
    """Return a mark by which attempts to run different studies in one folder are distinguished."""
    count = len(study.points)
    points = [dict(study.points[number]) for number in sorted({0, count // 2, count - 1}) if 0 <= number < count]
    text = json.dumps([count, points], default=repr) + repr(study.search)
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def _task() -> str:
    """Return the index of a job in its array, with an underscore before it as in SLURM; empty outside arrays."""
    task = os.environ.get("SLURM_ARRAY_TASK_ID", "")
    return f"_{task}" if task else ""
