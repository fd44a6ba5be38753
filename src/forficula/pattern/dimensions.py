"""Checks of the dimensions of patterns, with error messages that name the keys of a design file."""

from __future__ import annotations

import math
import numbers
from collections.abc import Mapping

from forficula.errors import InputError

# share of the longest length; a shorter length is below the rounding of coordinates
_POINT = 1e-12


def check_count(key: str, count: object, least: int) -> None:
    """Refuse a value that is not a whole number, or is too small.

    Raises:
        InputError: the value is not allowed.
    """
    if isinstance(count, bool) or not isinstance(count, numbers.Integral) or count < least:
        raise InputError(f"pattern.{key}: need a whole number, {least} or more, got {count!r}")


def check_lengths(lengths: Mapping[str, float]) -> None:
    """Refuse lengths, in m by key, with which no sheet can be drawn.

    Raises:
        InputError: a length that is not > 0 and finite, or too short compared with the longest.
    """
    for key, length in lengths.items():
        if not 0 < length < math.inf:
            raise InputError(f"pattern.{key}: need > 0 and finite, got {100 * length:.6g} cm")
    longest = max(lengths.values())
    for key, length in lengths.items():
        if length < _POINT * longest:
            raise InputError(
                f"pattern.{key}: need more than {_POINT:g} of the longest, {100 * longest:.6g} cm,"
                f" got {100 * length:.6g} cm"
            )


def check_angle(key: str, angle: float, low: float, high: float, low_too: bool = False) -> None:
    """Refuse an angle, in rad, that is not between two bounds; with `low_too` the lower bound is allowed.

    Raises:
        InputError: the angle is out of bounds.
    """
    if not (low < angle < high or (low_too and angle == low)):
        least, most, got = (f"{math.degrees(value):.6g} deg" for value in (low, high, angle))
        raise InputError(f"pattern.{key}: need {'>=' if low_too else '>'} {least} and < {most}, got {got}")
