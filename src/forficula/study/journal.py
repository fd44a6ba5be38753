"""The rows of a study on disk: appended as runs finish, whole after any crash."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO, Any

from forficula.design import Design
from forficula.dynamics import versions
from forficula.errors import InputError

Row = dict[str, Any]

# Raise it when a row's meaning changes: old rows are then refused instead of mixed in.
SCHEMA = 1


def read_rows(folder: Path, base: Design) -> dict[str, Row]:
    """All rows of a study's folder by key, whichever shard or machine wrote them.

    A line that a crash cut short, or two, is left out: its run is done again.

    Args:
        folder: of the study; it need not be there.
        base: the study's design.

    Raises:
        InputError: a journal cannot be read, or another design or other versions wrote it, and what differs.
    """
    rows: dict[str, Row] = {}
    try:
        paths = sorted(folder.glob("journal*.jsonl"))
    except OSError as error:
        raise InputError(f"{folder}: cannot be read: {error.strerror}") from None
    for path in paths:
        signed = False
        for entry in _entries(path):
            if "written_by" in entry:
                _check_signature(path, entry["written_by"], _signature(base))
                signed = True
            elif signed:
                rows[entry["key"]] = entry
            else:
                raise InputError(
                    f"{path}: holds rows that do not say which versions wrote them; take another folder for --out"
                )
    return rows


def _entries(path: Path) -> Iterator[dict[str, Any]]:
    """The whole lines of a journal: rows, and who wrote those that follow."""
    try:
        lines = path.read_bytes().split(b"\n")
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    for line in lines:
        try:
            entry = json.loads(line)
        except ValueError:
            continue
        if isinstance(entry, dict) and (isinstance(entry.get("key"), str) or isinstance(entry.get("written_by"), dict)):
            yield entry


def _signature(base: Design) -> dict[str, Any]:
    """Who writes rows: which design was varied, by which versions."""
    return {"schema": SCHEMA, "design": base.name, "design_hash": base.hash, **versions()}


def _check_signature(path: Path, theirs: Mapping[str, Any], ours: Mapping[str, Any]) -> None:
    # the hash tells designs apart; what they are called is for people
    differing = [
        f"{name} {theirs.get(name)} there, {ours.get(name)} now"
        for name in sorted({*theirs, *ours} - {"design"})
        if theirs.get(name) != ours.get(name)
    ]
    if differing:
        raise InputError(
            f"{path}: holds rows of another design or other versions: {'; '.join(differing)};"
            " take another folder for --out"
        )


class Journal:
    """An open file of rows."""

    def __init__(self, file: IO[bytes], path: Path) -> None:
        self._file = file
        self._path = path

    def append(self, row: Mapping[str, Any]) -> None:
        """Write a row so that killing this process does not lose it.

        Raises:
            InputError: the disk is full, or the file cannot be written.
        """
        try:
            self._file.write(json.dumps(row, allow_nan=False).encode() + b"\n")
            self._file.flush()
        except OSError as error:
            raise InputError(f"{self._path}: cannot be written: {error.strerror}") from None


@contextmanager
def open_journal(folder: Path, base: Design, shard: tuple[int, int]) -> Iterator[Journal]:
    """Open the journal that a shard of a study appends to; its first line says who writes it.

    Args:
        folder: of the study; made where it is missing.
        base: the study's design.
        shard: number, from 1 on, and count.

    Raises:
        InputError: it cannot be written.
    """
    number, count = shard
    path = folder / ("journal.jsonl" if count == 1 else f"journal-{number}-of-{count}.jsonl")
    try:
        folder.mkdir(parents=True, exist_ok=True)
        file = path.open("ab")
    except OSError as error:
        raise InputError(f"{path}: cannot be written: {error.strerror}") from None
    try:
        journal = Journal(file, path)
        if file.tell():
            # a line that a crash cut short must not swallow the next one
            file.write(b"\n")
        if not any("written_by" in entry for entry in _entries(path)):
            journal.append({"written_by": _signature(base)})
        yield journal
    finally:
        # every row is flushed as it is appended: what a full disk leaves in the buffer has been told of
        with suppress(OSError):
            file.close()
