"""The lines of a drawing, whatever file they come from, and the colours and layers by which they mean creases."""

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
COLOURS_MEANT = (
    "red (mountain), blue (valley), black (border), green (cut), yellow or grey (flat), magenta (unassigned)"
)


class DrawnLine(NamedTuple):
    """A straight line of a drawing.

    Attributes:
        start: x and y, y up, in the drawing's unit.
        end: the other end.
        letter: one of "BMVFUC".
        fold_angle: rad; nan where the drawing says none.
        name: what the line is called in the file, such as "line 3 (id a1)".
    """

    start: tuple[float, float]
    end: tuple[float, float]
    letter: str
    fold_angle: float
    name: str


@dataclass(frozen=True, kw_only=True)
class Drawing:
    """What a drawing holds.

    Attributes:
        lines: that are part of a sheet.
        unit: length of the drawing's unit as the file says it, m; None where it says none.
        assumed_unit: what to take where neither file nor user says a length, m; None where nothing can be assumed.
        title: of the drawing.
        remarks: what was left out.
    """

    lines: tuple[DrawnLine, ...]
    unit: float | None
    assumed_unit: float | None
    title: str
    remarks: tuple[str, ...]


def letter_of_colour(red: float, green: float, blue: float) -> str | None:
    """Find what kind of edge a colour means.

    Black is border, red mountain, blue valley, green cut, yellow and grey flat, magenta unassigned; what a printer or
    an office makes of these colours counts, too: hues within 15 to 40 deg, and any black below a quarter of white.

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


def check_some(lines: Sequence[DrawnLine], left_out: Counter[str]) -> tuple[str, ...]:
    """Remark on lines that mean nothing, and refuse a drawing without any that do.

    Raises:
        InputError: there is no line of a sheet.
    """
    others = ", ".join(f"{count} of {what}" for what, count in sorted(left_out.items()))
    if not lines:
        got = f"only {others}" if others else "none"
        raise InputError(f"need lines in {COLOURS_MEANT}, or in layers or groups with these names, got {got}")
    return (f"lines left out, as neither colour nor layer says what they are: {others}",) if others else ()
