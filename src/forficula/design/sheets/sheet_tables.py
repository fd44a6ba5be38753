"""The pattern of a FOLD file or a drawing in the tables of a design: its path is replaced by its content."""

from __future__ import annotations

import math
import warnings
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from forficula.design.families.fold_file import FOLDED
from forficula.design.section import ANGLE, LENGTH
from forficula.errors import InputError
from forficula.pattern import CreasePattern, read_pattern
from forficula.pattern.files.fold_frame import CHOSEN_UNIT
from forficula.quantities import format_quantity, parse_quantity

# keys of a file, which its content replaces
_OF_THE_FILE = ("path", "unit", "tolerance", "frame")
_UNIT_KEY = 'set the length of one unit in the design, such as pattern.unit = "1 cm"'
# what the source of a design says about a file without a unit
CHOSEN_SIZE_SOURCE = "; [chosen] its largest dimension is 20 cm, because it states no unit of length"


def with_sheet_read(tables: Mapping[str, Any], *, folder: Path | None = None) -> dict[str, Any]:
    """Replace the path of a FOLD file or a drawing by the content of the file, so that a design is complete.

    The largest dimension of a file that states no unit of length is taken as 20 cm, with a warning. The source of the
    tables then says so.

    Args:
        tables: tables of a design file, or values by dotted key.
        folder: folder to which a path is relative; the working folder if not given.

    Raises:
        InputError: the file cannot be read, or contains no sheet.
    """
    read, remarks = dict(tables), list[str]()
    keys = [f"pattern.{key}" for key in _OF_THE_FILE]
    if isinstance(read.get(keys[0]), str):
        named = {key: read.pop(f"pattern.{key}", None) for key in _OF_THE_FILE}
        sheet, remarks = _sheet(named, folder)
        read |= {f"pattern.{key}": value for key, value in sheet.items()}
    pattern = read.get("pattern")
    if isinstance(pattern, dict) and isinstance(pattern.get("path"), str):
        others = {key: value for key, value in pattern.items() if key not in _OF_THE_FILE}
        sheet, remarks = _sheet({key: pattern.get(key) for key in _OF_THE_FILE}, folder)
        read["pattern"] = others | sheet
    if CHOSEN_UNIT in remarks and isinstance(read.get("source"), str):
        read["source"] += CHOSEN_SIZE_SOURCE
    return read


def _sheet(named: Mapping[str, Any], folder: Path | None) -> tuple[dict[str, Any], list[str]]:
    """Read the pattern of a file, given the keys of `_OF_THE_FILE`: keys of a design's section, and remarks."""
    file = Path(named["path"]) if folder is None else folder / named["path"]
    lengths: dict[str, float | None] = {}
    for key in ("unit", "tolerance"):
        try:
            lengths[key] = None if named[key] is None else parse_quantity(named[key], LENGTH)
        except InputError as error:
            raise InputError(f"pattern.{key}: {error}") from None
    try:
        pattern, remarks = read_pattern(
            file, lengths["unit"], frame=named["frame"], tolerance=lengths["tolerance"], choose_unit=True
        )
    except InputError as error:
        raise InputError(f"pattern.path: {error}") from None
    if CHOSEN_UNIT in remarks:
        warnings.warn(f"{file}: {CHOSEN_UNIT}; {_UNIT_KEY}", UserWarning, stacklevel=2)
    return sheet_values(pattern) | {"title": pattern.title or file.stem}, remarks


def sheet_values(pattern: CreasePattern) -> dict[str, Any]:
    """Return a pattern as the keys of a design's section."""
    across, upwards, above = pattern.vertices_coords.T.tolist()
    values = {
        "kind": "fold-file",
        "vertices_x": [format_quantity(value, LENGTH) for value in across],
        "vertices_y": [format_quantity(value, LENGTH) for value in upwards],
        "edges": pattern.edges_vertices.tolist(),
        "assignment": "".join(pattern.edges_assignment),
        "roles": list(pattern.edges_role),
        "facets": [list(facet) for facet in pattern.faces_vertices],
    }
    if any(above):
        values["vertices_z"] = [format_quantity(value, LENGTH) for value in above]
    if (pattern.edges_share < 1).any():
        values["folds"] = pattern.edges_fold.tolist()
    folded = [FOLDED.get(letter, math.nan) for letter in pattern.edges_assignment]
    if not np.array_equal(pattern.edges_fold_angle, folded, equal_nan=True):
        angles = pattern.edges_fold_angle.tolist()
        values["fold_angles"] = ["none" if math.isnan(angle) else format_quantity(angle, ANGLE) for angle in angles]
    return values
