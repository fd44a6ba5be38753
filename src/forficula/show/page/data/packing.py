"""Text form of numbers in a page."""

from __future__ import annotations

import base64
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

_WHOLE = 32767  # integer that stands for a component of 1
_FINEST = 65535  # largest number of steps


def packed(values: ArrayLike, kind: str) -> str:
    """Pack numbers as little-endian floats of four ("f4") or eight ("f8") bytes, row by row, in base64."""
    return base64.b64encode(np.ascontiguousarray(values, dtype=f"<{kind}").tobytes()).decode("ascii")


def packed_directions(vectors: ArrayLike) -> str:
    """Pack unit vectors as 2-byte integers, 32767 times their components."""
    return packed(np.rint(_WHOLE * np.asarray(vectors)), "i2")


def packed_steps(values: ArrayLike) -> dict[str, Any]:
    """Pack numbers, (row, column), as 2-byte steps of 1/65535 of the range of their column, with these ranges."""
    table = np.asarray(values, dtype=np.float64)
    low, high = (table.min(axis=0), table.max(axis=0)) if len(table) else (np.zeros(table.shape[1]),) * 2
    step = (high - low) / _FINEST
    steps = np.rint((table - low) / np.where(step > 0, step, 1.0))
    return {"low": low.tolist(), "step": step.tolist(), "steps": packed(steps, "u2")}
