"""Numbers that patterns are drawn with, checked under the names that a design file has for them."""

from __future__ import annotations

import math
import numbers
from collections.abc import Mapping

from forficula.errors import InputError

# share of the longest length; a shorter one is lost in the rounding of the coordinates
_POINT = 1e-12


def check_count(key: str, count: object, least: int) -> None:
    """Refuse what is no whole number, or too few.

    Raises:
        InputError: so it is.
    """
    if isinstance(count, bool) or not isinstance(count, numbers.Integral) or count < least:
        raise InputError(f"pattern.{key}: need a whole number, {least} or more, got {count!r}")


def check_lengths(lengths: Mapping[str, float]) -> None:
    """Refuse lengths, in m by key, of which no sheet can be drawn.

    Raises:
        InputError: one that is not > 0 and finite, or too short to be drawn beside the longest.
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
    """Refuse an angle, in rad, that does not lie between two others; low_too says that it may be the lower one.

    Raises:
        InputError: so it is.
    """
    if not (low < angle < high or (low_too and angle == low)):
        least, most, got = (f"{math.degrees(each):.6g} deg" for each in (low, high, angle))
        raise InputError(f"pattern.{key}: need {'>=' if low_too else '>'} {least} and < {most}, got {got}")
