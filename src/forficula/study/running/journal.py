"""Rows of a study on disk, appended as runs finish. A crash leaves the file valid."""

from __future__ import annotations

import json
import sys
import zlib
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path
from typing import IO, Any

from forficula.design import Design
from forficula.dynamics import versions
from forficula.errors import InputError
from forficula.files import open_to_append
from forficula.lock import hold_lock

Row = dict[str, Any]

# Increase this if the meaning of a row changes: old rows are then rejected instead of mixed with new ones.
SCHEMA = 5
_CHECKSUM = "crc32"


def read_rows(folder: Path, base: Design) -> dict[str, Row]:
    """Return all rows of a study's folder by key, from all shards and machines.

    A damaged row, cut short by a crash or changed on disk, is skipped with a warning on stderr. Its run is repeated.

    Args:
        folder: folder of the study; it need not exist.
        base: the study's design.

    Raises:
        InputError: a journal cannot be read, or was written for another design or by other versions; the message says
            what differs.
    """
    rows: dict[str, Row] = {}
    try:
        paths = sorted(folder.glob("journal*.jsonl"))
    except OSError as error:
        raise InputError(f"{folder}: cannot be read: {error.strerror}") from None
    for path in paths:
        signed, damaged = False, 0
        for entry in _entries(path):
            if isinstance(entry.get("written_by"), dict):
                _check_signature(path, entry["written_by"], _signature(base))
                signed = True
            elif not signed and isinstance(entry.get("key"), str):
                raise InputError(
                    f"{path}: has rows without the versions that wrote them; choose another folder with --out"
                )
            elif _is_whole(entry):
                rows[entry["key"]] = entry
            else:
                damaged += 1
        if damaged:
            damage = "1 damaged row is" if damaged == 1 else f"{damaged} damaged rows are"
            print(f"warning: {path}: {damage} skipped; missing runs are repeated", file=sys.stderr)
    return rows


def _entries(path: Path) -> Iterator[dict[str, Any]]:
    """Yield the lines of a journal: rows and signatures of those who wrote them; an invalid line is empty."""
    if path.is_symlink() or not path.is_file():
        raise InputError(f"{path}: cannot be read: need a file")
    try:
        lines = path.read_bytes().split(b"\n")
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    for line in lines:
        if not line:
            continue
        try:
            entry = json.loads(line)
        except (ValueError, RecursionError):
            entry = None
        yield entry if isinstance(entry, dict) else {}


def _checksum(row: Mapping[str, Any]) -> int:
    """Return the checksum of a row's text, which is unchanged by writing and reading; any flipped bit changes it."""
    return zlib.crc32(json.dumps(row, allow_nan=False).encode())


def _is_whole(entry: dict[str, Any]) -> bool:
    """Return whether a row is intact. Its checksum is removed."""
    checksum = entry.pop(_CHECKSUM, None)
    try:
        return isinstance(entry.get("key"), str) and checksum == _checksum(entry)
    except (ValueError, RecursionError):
        return False


def _signature(base: Design) -> dict[str, Any]:
    """Return the identity of a writer of rows: the varied design and the versions."""
    return {"schema": SCHEMA, "design": base.name, "design_hash": base.hash, **versions(base.protocol.device)}


def _check_signature(path: Path, in_file: Mapping[str, Any], current: Mapping[str, Any]) -> None:
    # designs are distinguished by their hash; their names are not compared
    differing = [
        f"{name} {in_file.get(name)} in the file, {current.get(name)} now"
        for name in sorted({*in_file, *current} - {"design"})
        if in_file.get(name) != current.get(name)
    ]
    if differing:
        raise InputError(
            f"{path}: has rows of another design or other versions: {'; '.join(differing)};"
            " choose another folder with --out"
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
        self._write({**row, _CHECKSUM: _checksum(row)})

    def sign(self, base: Design) -> None:
        """Write the identity of the writer of the following rows.

        Raises:
            InputError: see `append`.
        """
        self._write({"written_by": _signature(base)})

    def _write(self, entry: Mapping[str, Any]) -> None:
        try:
            self._file.write(json.dumps(entry).encode() + b"\n")
            self._file.flush()
        except OSError as error:
            raise InputError(f"{self._path}: cannot be written: {error.strerror}") from None


@contextmanager
def open_journal(folder: Path, base: Design, shard: tuple[int, int]) -> Iterator[Journal]:
    """Open the journal of a shard of a study for appending; its first line identifies the writer.

    Only one process at a time may open it. A second one would only repeat the same runs, so it is rejected at once.

    Args:
        folder: folder of the study; created if missing.
        base: the study's design.
        shard: number, from 1, and count.

    Raises:
        InputError: the file cannot be written, is a link, or is used by another process.
    """
    number, count = shard
    path = folder / ("journal.jsonl" if count == 1 else f"journal-{number}-of-{count}.jsonl")
    with ExitStack() as stack:
        try:
            folder.mkdir(parents=True, exist_ok=True)
            locked = stack.enter_context(hold_lock(folder / f".{path.name}.lock", wait=False))
        except OSError as error:
            raise InputError(f"{path}: cannot be written: {error.strerror}") from None
        if locked is False:
            what = "this study" if count == 1 else f"shard {number}/{count} of this study"
            raise InputError(
                f"{path}: another process is running {what} in this folder; wait for it, or choose another folder"
            )
        file = open_to_append(path)
        try:
            journal = Journal(file, path)
            if file.tell():
                # a line that a crash cut short must not merge with the next one
                file.write(b"\n")
            if not any("written_by" in entry for entry in _entries(path)):
                journal.sign(base)
            yield journal
        finally:
            # every row was flushed when it was appended: an error of a full disk has been reported already
            with suppress(OSError):
                file.close()
