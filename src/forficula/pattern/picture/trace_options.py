"""Sizes and corners of a sheet, as texts or numbers."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np

from forficula.arrays import Array
from forficula.errors import InputError, error_prefix
from forficula.quantities import Unit, as_written, parse_quantity

_LENGTH = Unit(display="mm", si="m", example="20 cm")
_NUMBER = r"[0-9]+(?:\.[0-9]*)?"
_TWO = re.compile(rf"\s*({_NUMBER})\s*([a-z]*)\s*[x×*]\s*({_NUMBER})\s*([a-z]+)\s*")
_PLACE = re.compile(rf"(-?{_NUMBER})\s*,\s*(-?{_NUMBER})")
_NO_CORNERS = "none"


def read_size(size: object) -> tuple[float, float | None]:
    """Return width and height of a sheet, m, of a text such as "29.7 x 21 cm" or "20 cm", or of numbers in m.

    Returns:
        Width and height, or the longer side and None.

    Raises:
        InputError: no length, or a length that is not > 0.
    """
    with error_prefix("size: "):
        if isinstance(size, str) and (two := _TWO.fullmatch(size)):
            width = parse_quantity(f"{two[1]} {two[2] or two[4]}", _LENGTH)
            return _positive(width), _positive(parse_quantity(f"{two[3]} {two[4]}", _LENGTH))
        if isinstance(size, str):
            return _positive(parse_quantity(size, _LENGTH)), None
        numbers = np.asarray(size, dtype=np.float64).ravel().tolist()
        if len(numbers) not in (1, 2):
            raise InputError(f"need one length or width and height, got {len(numbers)} numbers")
        return _positive(numbers[0]), _positive(numbers[1]) if len(numbers) == 2 else None


def read_length(length: object, key: str) -> float:
    """Return a length, m, of a text such as "0.5 mm", or of a number in m.

    Raises:
        InputError: no length, or a length that is not > 0; the message names the key.
    """
    with error_prefix(f"{key}: "):
        if isinstance(length, str):
            return _positive(parse_quantity(length, _LENGTH))
        return _positive(float(np.asarray(length, dtype=np.float64)))


def _positive(length: float) -> float:
    if not 0 < length < np.inf:
        raise InputError(f"need > 0, got {length:g} m")
    return length


def read_corners(corners: str | Sequence[Sequence[float]] | None) -> tuple[Array | None, bool]:
    """Return four corners, pixels, of a text such as "12,30 900,41 880,700 20,690" or of an array.

    Returns:
        The corners, shape (4, 2), or None to find them; and whether to find them, False for the word "none".

    Raises:
        InputError: not four corners.
    """
    if corners is None:
        return None, True
    if isinstance(corners, str):
        if corners.strip().lower() == _NO_CORNERS:
            return None, False
        places = _PLACE.findall(corners)
        rest = _PLACE.sub("", corners).strip(" ;\t")
        if len(places) != 4 or rest:
            raise InputError(
                'corners: need "none" or x,y of four corners in pixels, clockwise from the upper left one, such as'
                f' "12,30 900,41 880,700 20,690", got {as_written(corners)}'
            )
        return np.array([[float(x), float(y)] for x, y in places]), True
    array = np.asarray(corners, dtype=np.float64)
    if array.shape != (4, 2):
        raise InputError(f"corners: need four corners, each x and y in pixels, got shape {array.shape}")
    return array, True
