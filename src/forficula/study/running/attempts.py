"""Attempts to run a shard: what each process that runs a shard writes to the journal about its progress and its end.

The entries contain durations, not times of day, because the clocks of machines differ. A process that is alive writes
an entry at a regular interval. How long ago it did so follows from the time at which the file was changed, by the clock
of the file system.
"""

from __future__ import annotations

import math
import os
import tempfile
import time
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Any

# [chosen] age of the last change of a journal from which its process counts as gone, s: network file systems may show
# the time of a change a minute late
STALE = 300.0
KEY = "attempt"


@dataclass(frozen=True, kw_only=True)
class Attempt:
    """One process that runs or ran a shard, as far as its journal shows.

    Attributes:
        study: mark of the study, see `study_mark`.
        host: name of the machine.
        job: identifier of the job in its engine; empty outside engines.
        points: number of points of the shard that are complete.
        runs_left: number of runs that are known to be needed.
        rows: number of rows that the process wrote.
        seconds: time since the start of the process's work, s.
        ended: whether the process has ended by itself.
        why: reason why it ended before the shard was complete; empty if it did not.
        stored: number of runs in the journals of the shard when the process ended.
    """

    study: str = ""
    host: str = ""
    job: str = ""
    points: int = 0
    runs_left: int = 0
    rows: int = 0
    seconds: float = 0.0
    ended: bool = False
    why: str = ""
    stored: int = 0


def attempts_in(entries: Iterable[Mapping[str, Any]]) -> list[Attempt]:
    """Return the attempts that entries of a journal describe, in the order of their starts; other entries are ignored.

    Damaged values are ignored, too.

    Args:
        entries: lines of a journal. The entries of two processes may be mixed.
    """
    names = {field.name: field.default for field in fields(Attempt)}
    attempts: dict[str, Attempt] = {}
    for entry in entries:
        facts = entry.get(KEY)
        if isinstance(facts, dict) and isinstance(name := facts.get("name"), str):
            known = {key: value for key, value in facts.items() if key in names and _is_valid(value, names[key])}
            attempts[name] = replace(attempts.get(name, Attempt()), **known)
    return list(attempts.values())


def _is_valid(value: object, default: object) -> bool:
    """Return whether a value of an entry may be that of a field with a default."""
    if isinstance(default, bool | str):
        return isinstance(value, type(default))
    kinds = int if isinstance(default, int) else int | float
    return isinstance(value, kinds) and not isinstance(value, bool) and 0 <= value < math.inf


def file_clock(folder: Path) -> float:
    """Return the present time by the clock of a folder's file system; by this machine's clock if it is not writable."""
    try:
        with tempfile.TemporaryFile(dir=folder) as file:
            return os.fstat(file.fileno()).st_mtime
    except OSError:
        return time.time()
