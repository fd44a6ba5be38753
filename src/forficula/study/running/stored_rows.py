"""Rows of a study that stay on disk: an index of their positions, with which single rows are read when needed."""

from __future__ import annotations

import hashlib
import json
import os
from array import array
from collections import OrderedDict
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from forficula.errors import InputError

_Row = dict[str, Any]

# key of a row's checksum in its line
CHECKSUM = "crc32"

# Number of rows in memory, about 4 kB each. [chosen]
_MOST_IN_MEMORY = 10_000
# Bytes that are read together; most rows are shorter.
_PIECE = 4096
# A position is the number of the file and the byte at which the row begins.
_BYTES_BITS = 44
# Number of added rows after which the sorted index is rebuilt.
_MOST_ADDED = 65_536


class StoredRows(Mapping[str, _Row]):
    """Rows of all journals of a study by key. Only the most recently used rows are in memory.

    The index takes 16 bytes for each row. If a key has several rows, the last one counts.
    """

    def __init__(self) -> None:
        self._paths: list[Path] = []
        self._names: NDArray[np.uint64] = np.zeros(0, dtype=np.uint64)
        self._positions: NDArray[np.uint64] = np.zeros(0, dtype=np.uint64)
        self._added: dict[int, int] = {}
        self._read_names, self._read_positions = array("Q"), array("Q")
        self._rows: OrderedDict[str, _Row] = OrderedDict()

    def __contains__(self, key: object) -> bool:
        """Whether there is a row with a key."""
        return isinstance(key, str) and self._position(key) is not None

    def __getitem__(self, key: str) -> _Row:
        """Return the row with a key."""
        if key in self._rows:
            self._rows.move_to_end(key)
            return self._rows[key]
        position = self._position(key)
        row = None if position is None else self._row_at(position)
        if row is None or row["key"] != key:
            raise KeyError(key)
        self._remember(row)
        return row

    def __len__(self) -> int:
        """Return the number of rows."""
        self._merge()
        return len(self._names)

    def __iter__(self) -> Iterator[str]:
        """Yield the keys in the order of the files."""
        self._merge()
        for position in np.sort(self._positions).tolist():
            row = self._row_at(position)
            self._remember(row)
            yield row["key"]

    def index(self, key: str, path: Path, offset: int) -> None:
        """Add a row of a file to the index.

        Args:
            key: key of the row.
            path: file of the row.
            offset: byte at which the row begins.
        """
        self._read_names.append(_name(key))
        self._read_positions.append(self._place(path, offset))

    def add(self, row: _Row, path: Path, offset: int) -> None:
        """Add a row that was appended to a file just now; see `index`."""
        self._added[_name(row["key"])] = self._place(path, offset)
        self._remember(row)
        if len(self._added) > _MOST_ADDED:
            self._merge()

    def _place(self, path: Path, offset: int) -> int:
        if not self._paths or self._paths[-1] != path:
            if path not in self._paths:
                self._paths.append(path)
            return self._paths.index(path) << _BYTES_BITS | offset
        return len(self._paths) - 1 << _BYTES_BITS | offset

    def _position(self, key: str) -> int | None:
        name = _name(key)
        if name in self._added:
            return self._added[name]
        if self._read_names:
            self._merge()
        place = int(np.searchsorted(self._names, np.uint64(name)))
        if place < len(self._names) and self._names[place] == name:
            return int(self._positions[place])
        return None

    def _merge(self) -> None:
        """Sort all rows into the index; the last row with a key remains."""
        if not self._read_names and not self._added:
            return
        names = np.concatenate(
            [self._names, np.array(self._read_names, dtype=np.uint64), np.array([*self._added], dtype=np.uint64)]
        )
        positions = np.concatenate(
            [
                self._positions,
                np.array(self._read_positions, dtype=np.uint64),
                np.array([*self._added.values()], dtype=np.uint64),
            ]
        )
        self._names, last = np.unique(names[::-1], return_index=True)
        self._positions = positions[::-1][last]
        self._read_names, self._read_positions, self._added = array("Q"), array("Q"), {}

    def _row_at(self, position: int) -> _Row:
        """Read a row.

        Raises:
            InputError: its file cannot be read, or has changed since the index was made.
        """
        number, offset = position >> _BYTES_BITS, position & (1 << _BYTES_BITS) - 1
        path = self._paths[number]
        try:
            row: _Row = json.loads(_line(path, offset))
        except OSError as error:
            raise InputError(f"{path}: cannot be read: {error.strerror}") from None
        except ValueError:
            raise InputError(f"{path}: has changed while it was read; run the same command again") from None
        row.pop(CHECKSUM, None)
        return row

    def _remember(self, row: _Row) -> None:
        self._rows[row["key"]] = row
        if len(self._rows) > _MOST_IN_MEMORY:
            self._rows.popitem(last=False)


def _name(key: str) -> int:
    """Return 64 bits that identify a key: among 10^6 keys, two agree with a probability of 3e-8."""
    return int.from_bytes(hashlib.blake2b(key.encode(), digest_size=8).digest(), "little")


def _line(path: Path, offset: int) -> bytes:
    """Return the line of a file that begins at a byte."""
    descriptor = os.open(path, os.O_RDONLY | getattr(os, "O_BINARY", 0))
    try:
        os.lseek(descriptor, offset, os.SEEK_SET)
        line = os.read(descriptor, _PIECE)
        while b"\n" not in line and (piece := os.read(descriptor, _PIECE)):
            line += piece
    finally:
        os.close(descriptor)
    return line.split(b"\n", 1)[0]
