"""Lines of drawings, independent of the file format, and the colours that define the kinds of edges."""

from __future__ import annotations

import colorsys
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from forficula.errors import InputError

_DARK, _PALE, _COLOURLESS = 0.25, 0.95, 0.15
# letters by hue: red mountain, yellow flat, green cut, blue valley, magenta unassigned, as Origami Simulator has them
_HUES = ((0, 25, "M"), (60, 15, "F"), (120, 40, "C"), (235, 25, "V"), (305, 30, "U"), (360, 25, "M"))
COLOUR_MEANINGS = (
    "red (mountain), blue (valley), black (border), green (cut), yellow or grey (flat), magenta (unassigned)"
)


class DrawnLine(NamedTuple):
    """A straight line of a drawing.

    Attributes:
        start: x and y, y up, in the drawing's unit.
        end: the other end.
        letter: one of "BMVFUC".
        fold_angle: rad; nan if the drawing gives none.
        name: name of the line in the file, such as "line 3 (id a1)".
    """

    start: tuple[float, float]
    end: tuple[float, float]
    letter: str
    fold_angle: float
    name: str


@dataclass(frozen=True, kw_only=True)
class Drawing:
    """Content of a drawing.

    Attributes:
        lines: lines of the sheet.
        unit: unit of length in the file, m; None if the file gives none.
        assumed_unit: unit of length if neither the file nor the user gives one, m; None if none can be assumed.
        title: title of the drawing.
        remarks: remarks on lines that were left out.
    """

    lines: tuple[DrawnLine, ...]
    unit: float | None
    assumed_unit: float | None
    title: str
    remarks: tuple[str, ...]


def letter_of_colour(red: float, green: float, blue: float) -> str | None:
    """Return the kind of edge that a colour means.

    Black is border, red mountain, blue valley, green cut, yellow and grey flat, magenta unassigned. Similar colours
    also count: hues within 15 to 40 deg, and any colour darker than a quarter of white as black.

    Args:
        red: 0 to 1.
        green: 0 to 1.
        blue: 0 to 1.

    Returns:
        One of "BMVFUC"; None for any other colour, and for white.
    """
    hue, saturation, value = colorsys.rgb_to_hsv(red, green, blue)
    if value <= _DARK:
        return "B"
    if saturation <= _COLOURLESS:
        return "F" if value < _PALE else None
    return next((letter for middle, width, letter in _HUES if abs(360 * hue - middle) <= width), None)


def check_has_lines(lines: Sequence[DrawnLine], left_out: Counter[str]) -> tuple[str, ...]:
    """Return remarks on lines without a meaning, and refuse a drawing without any line of a sheet.

    Raises:
        InputError: the drawing has no line of a sheet.
    """
    others = ", ".join(f"{count} of {what}" for what, count in sorted(left_out.items()))
    if not lines:
        got = f"only {others}" if others else "none"
        raise InputError(f"need lines in {COLOUR_MEANINGS}, or in layers or groups with these names, got {got}")
    return (f"lines left out, because neither colour nor layer defines their kind: {others}",) if others else ()
