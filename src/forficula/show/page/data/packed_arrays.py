"""Compact text form of large arrays: differences, column by column, compressed, in base64."""

from __future__ import annotations

import base64
import zlib
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

_ALIGNED = 8  # bytes, alignment of every array
_FINEST = 65535  # largest number of two bytes


class PackedArrays:
    """Arrays for a page, one after the other. Each method returns where the page's script finds the array."""

    def __init__(self) -> None:
        self._parts: list[bytes] = []
        self._length = 0

    def floats(self, values: ArrayLike) -> dict[str, Any]:
        """Add numbers as 4-byte floats; return their position."""
        return self._add(np.asarray(values, dtype="<f4").tobytes(), "f4", np.shape(values))

    def doubles(self, values: ArrayLike) -> dict[str, Any]:
        """Add numbers as 8-byte floats; return their position."""
        return self._add(np.asarray(values, dtype="<f8").tobytes(), "f8", np.shape(values))

    def whole(self, rows: ArrayLike) -> dict[str, Any]:
        """Add whole numbers, (row, column), as differences from the row before; return their position."""
        table = np.asarray(rows, dtype=np.int64)
        kind = "u2" if table.size == 0 or table.max() <= _FINEST else "u4"
        steps = np.diff(table, axis=0, prepend=0).astype(f"<{kind}")
        return self._add(steps.T.tobytes(), kind, table.shape)

    def places(self, points: ArrayLike) -> dict[str, Any]:
        """Add points, (point, 3), in steps of 1/65535 of their bounding box; return their position and the box."""
        table = np.asarray(points, dtype=np.float64)
        low, high = table.min(axis=0), table.max(axis=0)
        step = np.where(high > low, (high - low) / _FINEST, 1.0)
        return self.whole(np.rint((table - low) / step)) | {"low": low.tolist(), "step": step.tolist()}

    def text(self) -> str:
        """Return all arrays as text."""
        return base64.b64encode(zlib.compress(b"".join(self._parts), 9)).decode("ascii")

    def _add(self, content: bytes, kind: str, shape: tuple[int, ...]) -> dict[str, Any]:
        start = self._length
        padded = content + bytes(-len(content) % _ALIGNED)
        self._parts.append(padded)
        self._length += len(padded)
        return {"kind": kind, "start": start, "shape": list(shape)}
