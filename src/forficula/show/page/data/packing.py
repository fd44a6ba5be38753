"""Text form of numbers in a page."""

from __future__ import annotations

import base64

import numpy as np
from numpy.typing import ArrayLike

_WHOLE = 32767  # integer that stands for a component of 1


def packed(values: ArrayLike, kind: str) -> str:
    """Pack numbers as little-endian floats of four ("f4") or eight ("f8") bytes, row by row, in base64."""
    return base64.b64encode(np.ascontiguousarray(values, dtype=f"<{kind}").tobytes()).decode("ascii")


def packed_directions(vectors: ArrayLike) -> str:
    """Pack unit vectors as 2-byte integers, 32767 times their components."""
    return packed(np.rint(_WHOLE * np.asarray(vectors)), "i2")
