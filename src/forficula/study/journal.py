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
from forficula.files import write_text

Row = dict[str, Any]

# Raise it when a row's meaning changes: old rows are then refused instead of mixed in.
SCHEMA = 1
_MANIFEST = "manifest.json"


def open_folder(folder: Path, base: Design) -> None:
    """Make a study's folder, or check that the rows in it belong to this design and these versions.

    Raises:
        InputError: they do not, and what differs; or the folder cannot be written.
    """
    manifest: dict[str, Any] = {"schema": SCHEMA, "design": base.name, "design_hash": base.hash, "versions": versions()}
    path = folder / _MANIFEST
    try:
        is_new = not path.exists()
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    if is_new:
        if any(folder.glob("journal*.jsonl")):
            raise InputError(f"{folder}: holds rows but no {_MANIFEST} that says whose; take another folder for --out")
        write_text(path, json.dumps(manifest, indent=2) + "\n")
        return
    try:
        there = json.loads(path.read_text("utf-8"))
        differing = [
            f"{name} {old.get(name)!r} there, {new.get(name)!r} now"
            for old, new in ((there, manifest), (there["versions"], manifest["versions"]))
            for name in sorted({*old, *new} - {"versions", "design"})
            if old.get(name) != new.get(name)
        ]
    except (OSError, ValueError, KeyError, AttributeError, TypeError) as error:
        raise InputError(f"{path}: not a manifest of a study: {error}") from None
    if differing:
        raise InputError(
            f"{folder}: holds rows of another study: {'; '.join(differing)}; take another folder for --out"
        )


def read_rows(folder: Path) -> dict[str, Row]:
    """All rows of a study's folder by key, whichever shard wrote them.

    A line that a crash cut short, or two, is left out: its run is done again.

    Raises:
        InputError: a journal cannot be read.
    """
    rows: dict[str, Row] = {}
    for path in sorted(folder.glob("journal*.jsonl")):
        try:
            lines = path.read_bytes().split(b"\n")
        except OSError as error:
            raise InputError(f"{path}: cannot be read: {error.strerror}") from None
        for line in lines:
            try:
                row = json.loads(line)
                rows[row["key"]] = row
            except (ValueError, KeyError, TypeError):
                continue
    return rows


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
def open_journal(folder: Path, shard: tuple[int, int]) -> Iterator[Journal]:
    """Open the journal that a shard of a study appends to.

    Args:
        folder: of the study.
        shard: number, from 1 on, and count.

    Raises:
        InputError: it cannot be written.
    """
    number, count = shard
    path = folder / ("journal.jsonl" if count == 1 else f"journal-{number}-of-{count}.jsonl")
    try:
        file = path.open("ab")
    except OSError as error:
        raise InputError(f"{path}: cannot be written: {error.strerror}") from None
    try:
        if file.tell():
            # a line that a crash cut short must not swallow the next one
            file.write(b"\n")
        yield Journal(file, path)
    finally:
        # every row is flushed as it is appended: what a full disk leaves in the buffer has been told of
        with suppress(OSError):
            file.close()
