"""The design of a FOLD file or a drawing alone: its sheet, folded to the target angles of its creases."""

from __future__ import annotations

import math
import warnings
from pathlib import Path
from typing import Any

import numpy as np

from forficula.design.chosen import choices, facet_areas
from forficula.design.section import SHORT_TIME, TIME
from forficula.design.sheets.crease_sections import Crease
from forficula.design.sheets.sheet_creases import fold_edges
from forficula.design.sheets.sheet_sections import FacetSection
from forficula.design.sheets.sheet_tables import CHOSEN_SIZE_SOURCE, sheet_values
from forficula.errors import InputError
from forficula.pattern import CreasePattern, read_pattern
from forficula.pattern.files.fold_frame import CHOSEN_UNIT, UNIT_OPTION
from forficula.quantities import format_quantity

# in periods of the sheet: rise time of the rest angles, slow enough that the sheet hardly swings, and time limit
_RISE, _LIMIT = 5.0, 50.0
_ROWS = 20  # rows of the record per period


def file_tables(path: Path, unit: float | None = None) -> dict[str, Any]:
    """Return the tables of a design that folds the sheet of a file; rules choose all other values.

    The rest angles of the creases change linearly from the angles as built to the targets: the fold angles in the file,
    or else 180 deg for a valley and -180 deg for a mountain.

    Args:
        path: path of a file that `read_pattern` reads.
        unit: length of its unit, m, if the file does not state it; by default, the largest dimension of such a file is
            taken as 20 cm, with a warning.

    Raises:
        InputError: the file cannot be read, or contains no pattern.
    """
    sheet, remarks = read_pattern(path, unit, choose_unit=True)
    size = ""
    if CHOSEN_UNIT in remarks:
        warnings.warn(f"{path}: {CHOSEN_UNIT}; {UNIT_OPTION}", UserWarning, stacklevel=2)
        size = CHOSEN_SIZE_SOURCE
    try:
        period = _period(sheet)
    except InputError as error:
        raise InputError(f"{path}: {error}") from None
    targets = [edge for edge in fold_edges(sheet) if not math.isnan(sheet.edges_fold_angle[edge])]
    drive = {"name": "fold", "kind": "rest-angle", "of": "creases", "to": "target"}
    stage = {"name": "fold", "drive": "fold", "until": "target", "state": "folded"}
    if not targets:
        stage = {"name": "settle", "drive": "none", "until": "rest", "state": "at rest"}
    return {
        "name": path.stem,
        "source": f"{path.name}; rules chose the values that it does not contain{size}",
        "pattern": sheet_values(sheet) | {"title": sheet.title or path.stem},
        "drive": [drive | {"rise": _seconds(_RISE * period)}] if targets else [],
        "protocol": {
            "timestep": "auto",
            "sample_interval": format_quantity(_rounded(period / _ROWS), SHORT_TIME),
            "rest_speed": "2 deg/s",
            "window": _seconds(period),
            "gravity": "0 m/s^2",
            "contact": False,
            "stages": [stage | {"hold": _seconds(period), "time_limit": _seconds(_LIMIT * period)}],
        },
    }


def _period(sheet: CreasePattern) -> float:
    """Estimate the slowest period of a sheet, s: a bar with the sheet's mass and length on all creases together."""
    made = {choice.key: choice.value for choice in choices(sheet, FacetSection(), Crease()) if choice.key != "damping"}
    mass = made["density"] * made["thickness"] * sum(facet_areas(sheet))
    ends = sheet.vertices_coords[sheet.edges_vertices[list(fold_edges(sheet))]]
    stiffness = made["stiffness"] * float(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum())
    extent = float(np.ptp(sheet.vertices_coords, axis=0).max())
    return 2 * math.pi * math.sqrt(mass * extent**2 / 12 / stiffness) if stiffness else 1.0


def _seconds(time: float) -> str:
    return format_quantity(_rounded(time), TIME)


def _rounded(time: float) -> float:
    """Round a time to two digits, s."""
    return float(f"{time:.1e}")
