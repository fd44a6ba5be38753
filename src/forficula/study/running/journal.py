"""The rows of a study on disk: appended as runs finish, whole after any crash."""

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
from forficula.lock import held

Row = dict[str, Any]

# Raise it when a row's meaning changes: old rows are then refused instead of mixed in.
SCHEMA = 5
_CHECKSUM = "crc32"


def read_rows(folder: Path, base: Design) -> dict[str, Row]:
    """All rows of a study's folder by key, whichever shard or machine wrote them.

    A row that is not what was written, for a crash cut it short or a disk or a hand changed it, is left out, and a line
    on stderr says so: its run is done again.

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
        signed, damaged = False, 0
        for entry in _entries(path):
            if isinstance(entry.get("written_by"), dict):
                _check_signature(path, entry["written_by"], _signature(base))
                signed = True
            elif not signed and isinstance(entry.get("key"), str):
                raise InputError(
                    f"{path}: holds rows that do not say which versions wrote them; take another folder for --out"
                )
            elif _is_whole(entry):
                rows[entry["key"]] = entry
            else:
                damaged += 1
        if damaged:
            left_out = "1 damaged row is" if damaged == 1 else f"{damaged} damaged rows are"
            print(f"warning: {path}: {left_out} left out; runs that are missing are done again", file=sys.stderr)
    return rows


def _entries(path: Path) -> Iterator[dict[str, Any]]:
    """The lines of a journal: rows, and who wrote those that follow; empty where a line is neither."""
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
    """Of a row's text, which is the same again when it has been read: any flipped bit changes it."""
    return zlib.crc32(json.dumps(row, allow_nan=False).encode())


def _is_whole(entry: dict[str, Any]) -> bool:
    """Whether a row is what was written; its checksum is taken out."""
    checksum = entry.pop(_CHECKSUM, None)
    try:
        return isinstance(entry.get("key"), str) and checksum == _checksum(entry)
    except (ValueError, RecursionError):
        return False


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
        self._write({**row, _CHECKSUM: _checksum(row)})

    def sign(self, base: Design) -> None:
        """Write who writes the rows that follow.

        Raises:
            InputError: as of `append`.
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
    """Open the journal that a shard of a study appends to; its first line says who writes it.

    One process at a time has it: a second one would only do the same runs, for hours, so it is refused at once.

    Args:
        folder: of the study; made where it is missing.
        base: the study's design.
        shard: number, from 1 on, and count.

    Raises:
        InputError: it cannot be written, is a link, or another process has it.
    """
    number, count = shard
    path = folder / ("journal.jsonl" if count == 1 else f"journal-{number}-of-{count}.jsonl")
    with ExitStack() as stack:
        try:
            folder.mkdir(parents=True, exist_ok=True)
            taken = stack.enter_context(held(folder / f".{path.name}.lock", wait=False))
        except OSError as error:
            raise InputError(f"{path}: cannot be written: {error.strerror}") from None
        if taken is False:
            what = "this study" if count == 1 else f"shard {number}/{count} of this study"
            raise InputError(f"{path}: another process is running {what} there; wait for it, or take another folder")
        file = open_to_append(path)
        try:
            journal = Journal(file, path)
            if file.tell():
                # a line that a crash cut short must not swallow the next one
                file.write(b"\n")
            if not any("written_by" in entry for entry in _entries(path)):
                journal.sign(base)
            yield journal
        finally:
            # every row is flushed as it is appended: what a full disk leaves in the buffer has been told of
            with suppress(OSError):
                file.close()
