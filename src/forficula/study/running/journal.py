"""Rows of a study on disk, appended as runs finish. A crash leaves the file valid."""

from __future__ import annotations

import errno
import json
import os
import re
import socket
import sys
import threading
import zlib
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager, suppress
from itertools import count as count_from
from pathlib import Path
from typing import IO, Any

from forficula.design import Design
from forficula.dynamics import versions
from forficula.errors import InputError
from forficula.files import open_to_append
from forficula.lock import hold_lock
from forficula.study.running.attempts import KEY, STALE, attempts_in, file_clock
from forficula.study.running.stored_rows import CHECKSUM, StoredRows

Row = dict[str, Any]

# Increase this if the meaning of a row changes: old rows are then rejected instead of mixed with new ones.
SCHEMA = 5
_NAMES = "journal*.jsonl"
_NAME = re.compile(r"journal(-(?P<number>\d+)-of-(?P<count>\d+))?(\.\d+)?\.jsonl")
# beginning of the line of an entry of a process
_ENTRY = f'{{"{KEY}": '.encode()
# [chosen] bytes at the end of a journal that contain the last entry, if the entry has no long reason
_LONGEST_ENTRY = 1000
# errors of file systems that cannot force data to the disk
_CANNOT_SYNC = (errno.EINVAL, errno.ENOSYS, errno.ENOTSUP, errno.EROFS)
# beginning of the line of a row, and of its end
_BEGINNING, _END = b'{"key": "', f', "{CHECKSUM}": '.encode()


def read_rows(folder: Path, base: Design) -> dict[str, Row]:
    """Return all rows of a study's folder by key, from all shards and machines.

    Args and errors are those of `stored_rows`.
    """
    return dict(stored_rows(folder, base))


def stored_rows(folder: Path, base: Design, shard: tuple[int, int] = (1, 1)) -> StoredRows:
    """Return the rows of a study's folder by key, from all machines; they stay on disk until they are used.

    A damaged row, cut short by a crash or changed on disk, is skipped with a warning on stderr. Its run is repeated.

    A shard does not need the rows of the other shards of the same division. Their journals are left out, because
    otherwise each of 1000 jobs would read the journals of all of them.

    Args:
        folder: folder of the study; it need not exist.
        base: the study's design.
        shard: number, from 1, and count of the shard that needs the rows; (1, 1) for all rows.

    Raises:
        InputError: a journal cannot be read, or was written for another design or by other versions; the message says
            what differs.
    """
    rows = StoredRows()
    for path in journals(folder):
        division = shard_of(path)
        if division is not None and division[1] == shard[1] and division != shard:
            continue
        damaged = 0
        for offset, key, entry in read_journal(path, base):
            if key is not None:
                rows.index(key, path, offset)
            damaged += key is None and entry is None
        if damaged:
            damage = "1 damaged row is" if damaged == 1 else f"{damaged} damaged rows are"
            print(f"warning: {path}: {damage} skipped; missing runs are repeated", file=sys.stderr)
    return rows


def journals(folder: Path) -> list[Path]:
    """Return the paths of all journals in a folder, sorted.

    Raises:
        InputError: the folder cannot be read.
    """
    try:
        return sorted(folder.glob(_NAMES))
    except OSError as error:
        raise InputError(f"{folder}: cannot be read: {error.strerror}") from None


def shard_of(path: Path) -> tuple[int, int] | None:
    """Return the number and count of the shard to which a journal belongs, from its name; None for other names."""
    match = _NAME.fullmatch(path.name)
    return None if match is None else (int(match["number"] or 1), int(match["count"] or 1))


def read_journal(path: Path, base: Design) -> Iterator[tuple[int, str | None, dict[str, Any] | None]]:
    """Yield the lines of a journal.

    Args:
        path: path of the journal.
        base: design of the study.

    Yields:
        The byte at which the line begins, and the key of an intact row, or the entry of a process, see `attempts`, or
        neither for a damaged line.

    Raises:
        InputError: see `stored_rows`.
    """
    signed = False
    for offset, line in _lines(path):
        key = _intact_key(line) if signed else None
        entry = _entry(line) if key is None else {}
        if key is not None:
            yield offset, key, None
        elif isinstance(entry.get("written_by"), dict):
            _check_signature(path, entry["written_by"], _signature(base))
            signed = True
        elif not signed and isinstance(entry.get("key"), str):
            raise InputError(f"{path}: has rows without the versions that wrote them; choose another folder with --out")
        elif KEY in entry:
            yield offset, None, entry
        else:
            yield offset, entry["key"] if _is_whole(entry) else None, None


def _lines(path: Path) -> Iterator[tuple[int, bytes]]:
    """Yield the lines of a journal that are not empty, and the bytes at which they begin."""
    if path.is_symlink() or not path.is_file():
        raise InputError(f"{path}: cannot be read: need a file")
    offset = 0
    try:
        with path.open("rb") as file:
            for line in file:
                if text := line.rstrip(b"\n"):
                    yield offset, text
                offset += len(line)
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None


def _entry(line: bytes) -> dict[str, Any]:
    """Return a row, or the signature of those who wrote rows; an invalid line is empty."""
    try:
        entry = json.loads(line)
    except (ValueError, RecursionError):
        entry = None
    return entry if isinstance(entry, dict) else {}


def _intact_key(line: bytes) -> str | None:
    """Return the key of a row whose line is as it was written; None for any other line."""
    end = line.rfind(_END)
    if not line.startswith(_BEGINNING) or not line[end + len(_END) : -1].isdigit() or not line.endswith(b"}"):
        return None
    if zlib.crc32(line[:end] + b"}") != int(line[end + len(_END) : -1]):
        return None
    key = line[len(_BEGINNING) : line.index(b'"', len(_BEGINNING))]
    return None if b"\\" in key else key.decode()


def _checksum(row: Mapping[str, Any]) -> int:
    """Return the checksum of a row's text, which is unchanged by writing and reading; any flipped bit changes it."""
    return zlib.crc32(json.dumps(row, allow_nan=False).encode())


def _is_whole(entry: dict[str, Any]) -> bool:
    """Return whether a row is intact. Its checksum is removed."""
    checksum = entry.pop(CHECKSUM, None)
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
    """An open file of rows. Several threads may write to it."""

    def __init__(self, file: IO[bytes], path: Path) -> None:
        self._file = file
        self._path = path
        self._lock = threading.Lock()
        self._failure = ""

    @property
    def path(self) -> Path:
        """Path of the file."""
        return self._path

    def append(self, row: Mapping[str, Any]) -> int:
        """Write a row so that killing this process does not lose it, and return the byte at which its line begins.

        Raises:
            InputError: the disk is full, or the file cannot be written.
        """
        return self._write({**row, CHECKSUM: _checksum(row)})

    def sign(self, base: Design) -> None:
        """Write the identity of the writer of the following rows.

        Raises:
            InputError: see `append`.
        """
        self._write({"written_by": _signature(base)})

    def write_entry(self, entry: Mapping[str, Any]) -> None:
        """Write a line that is neither a row nor a signature.

        Raises:
            InputError: see `append`.
        """
        self._write(entry)

    def sync(self) -> None:
        """Let the operating system write all lines to the disk or the file server.

        Network file systems report only now that a disk is full or a quota is exceeded. They report this once, so
        nothing can be written to the journal afterwards.

        Raises:
            InputError: see `append`.
        """
        try:
            os.fsync(self._file.fileno())
        except OSError as error:
            if error.errno not in _CANNOT_SYNC:
                self._failure = str(error.strerror)
                raise self._error(self._failure) from None

    def count_rows(self) -> int:
        """Return the number of runs that have an intact row in the journals of this shard."""
        shard = shard_of(self._path)
        paths = [path for path in journals(self._path.parent) if shard_of(path) == shard]
        keys = {key for path in paths for _, line in _lines(path) if (key := _intact_key(line)) is not None}
        return len(keys)

    def _write(self, entry: Mapping[str, Any]) -> int:
        line = json.dumps(entry).encode() + b"\n"
        with self._lock:
            if self._failure:
                raise self._error(self._failure)
            try:
                self._file.write(line)
                self._file.flush()
                # another process may have appended lines before this one
                return self._file.tell() - len(line)
            except OSError as error:
                raise self._error(str(error.strerror)) from None

    def _error(self, reason: str) -> InputError:
        return InputError(f"{self._path}: cannot be written: {reason}")


def are_others_complete(folder: Path, shard: tuple[int, int]) -> bool:
    """Return whether the last entries of their journals say that all other shards are complete.

    This reads a few bytes of each journal. Each of many shards can therefore call it.
    """
    paths: dict[int, list[Path]] = {}
    for path in journals(folder):
        number, count = shard_of(path) or shard
        if count == shard[1] and number != shard[0]:
            paths.setdefault(number, []).append(path)
    return len(paths) == shard[1] - 1 and all(any(map(_ends_complete, of_shard)) for of_shard in paths.values())


def _ends_complete(path: Path) -> bool:
    try:
        with path.open("rb") as file:
            file.seek(max(0, path.stat().st_size - _LONGEST_ENTRY))
            lines = file.read().splitlines()
        last = json.loads(lines[-1])[KEY]
        return bool(last["ended"] and not last["why"])
    except (OSError, ValueError, LookupError, TypeError):
        return False


def _open(folder: Path, stem: str, *, alone: bool) -> tuple[Path, IO[bytes]]:
    """Open the first journal of a shard to which no other process can be writing.

    Args:
        folder: folder of the study.
        stem: beginning of the names of the shard's journals.
        alone: whether a lock excludes other processes, at least on this machine.
    """
    for number in count_from(1):
        path = folder / (f"{stem}.jsonl" if number == 1 else f"{stem}.{number}.jsonl")
        if alone and not _is_written_elsewhere(path):
            return path, open_to_append(path)
        with suppress(FileExistsError):
            return path, open_to_append(path, new=True)
    raise AssertionError


def _is_written_elsewhere(path: Path) -> bool:
    """Return whether a process of another machine has written to a journal lately and has not ended."""
    try:
        age = file_clock(path.parent) - path.stat().st_mtime
    except OSError:
        return False
    if age > STALE:
        return False
    host = socket.gethostname()
    return any(
        not attempt.ended and attempt.host != host for attempt in attempts_in(_entry(line) for _, line in _lines(path))
    )


@contextmanager
def open_journal(folder: Path, base: Design, shard: tuple[int, int]) -> Iterator[Journal]:
    """Open the journal of a shard of a study for appending; its first line identifies the writer.

    Only one process at a time may open it. A second one would only repeat the same runs, so it is rejected at once.
    Some network file systems support no locks, or only locks between processes of one machine. There, a process writes
    to a file of its own if another process may be writing. If both run the same shard, their rows are equal.

    Args:
        folder: folder of the study; created if missing.
        base: the study's design.
        shard: number, from 1, and count.

    Raises:
        InputError: the file cannot be written, is a link, or is used by another process.
    """
    number, count = shard
    stem = "journal" if count == 1 else f"journal-{number}-of-{count}"
    path = folder / f"{stem}.jsonl"
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
        path, file = _open(folder, stem, alone=locked is True)
        try:
            journal = Journal(file, path)
            if file.tell():
                # a line that a crash cut short must not merge with the next one
                file.write(b"\n")
            if not any("written_by" in _entry(line) for _, line in _lines(path)):
                journal.sign(base)
            yield journal
            journal.sync()
        finally:
            # an error of a full disk has been reported by now
            with suppress(OSError):
                file.close()
