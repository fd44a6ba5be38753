"""Crease patterns read from files; the ending of the file name gives the format."""

from __future__ import annotations

import os
from pathlib import Path

from forficula.allowed_files import check_may_read
from forficula.errors import InputError
from forficula.files import shown_path
from forficula.pattern.crease_pattern import CreasePattern
from forficula.pattern.drawings.drawing_file import read_drawing
from forficula.pattern.files.fold_file import fold_pattern
from forficula.quantities import as_written

PATTERN_FILES = {".fold": "FOLD", ".svg": "SVG", ".dxf": "DXF"}


def read_pattern(
    path: str | os.PathLike[str],
    unit: float | None = None,
    *,
    frame: int | str | None = None,
    tolerance: float | None = None,
    choose_unit: bool = False,
) -> tuple[CreasePattern, list[str]]:
    """Read a crease pattern from a FOLD file (.fold) or a drawing (.svg, .dxf).

    Args:
        path: path of the file.
        unit: length of the file's unit, m, for a file without one.
        frame: number, title or class of a frame of a FOLD file.
        tolerance: largest distance between lines of a drawing that meet, m.
        choose_unit: whether to take the largest dimension as 20 cm if neither the file nor `unit` gives a length; a
            remark says so.

    Returns:
        The pattern, as `fold_pattern` or `read_drawing` reads it, and remarks.

    Raises:
        InputError: the file has another ending, an option does not apply to its format, or an error of these functions.
    """
    file = Path(path)
    check_may_read(file)
    ending = file.suffix.lower()
    if ending not in PATTERN_FILES:
        known = ", ".join(f"{key} ({what})" for key, what in PATTERN_FILES.items())
        raise InputError(
            f"{shown_path(file)}: need a file that ends with one of {known}, got {as_written(file.suffix)}"
        )
    if ending == ".fold":
        if tolerance is not None:
            raise InputError(
                f"{shown_path(file)}: tolerance: need none for a FOLD file, whose edges name their vertices"
            )
        return fold_pattern(file, unit, frame, choose_unit=choose_unit)
    if frame is not None:
        raise InputError(f"{shown_path(file)}: frame: need none for a drawing, got {as_written(frame)}")
    return read_drawing(file, unit, tolerance, choose_unit=choose_unit)
