"""The design from which a file of a given size starts."""

from __future__ import annotations

import re

import numpy as np

from forficula.design.design import Design
from forficula.design.files.design_file import load_design
from forficula.design.files.kinds import KINDS, OTHER_REFERENCE
from forficula.design.sheets.crease_pattern import design_pattern
from forficula.design.similarity import scale_design
from forficula.errors import InputError
from forficula.quantities import show_value

# [chosen] m, sizes between which every kind has been run
_SMALLEST, _LARGEST = 1e-4, 1e4
_LONG_NUMBER = re.compile(r"\d+\.\d{6,}(?:e-?\d+)?")


def sized_design(kind: str, size: float) -> Design:
    """Return the reference of a kind of pattern, scaled so that its flat pattern has a largest dimension.

    The scaled design has the same materials and gravity (see `scale_design`).

    Args:
        kind: one of `KINDS`; a kind without a named design has its example pattern.
        size: largest dimension, m.

    Raises:
        InputError: the size is not between 0.1 mm and 10 km, or the kind takes its pattern from a file.
    """
    if kind == "fold-file":
        raise InputError("size: a fold-file has the size of its file; set pattern.unit in the design instead")
    if not _SMALLEST <= size <= _LARGEST:
        raise InputError(f"size: need >= 0.1 mm and <= 10 km, got {show_value(size, 'm')}")
    if KINDS[kind].reference is None:
        pattern = {"pattern": {"kind": kind, **KINDS[kind].example}, "tendon": [], "support": [], "measure": []}
        design = load_design(OTHER_REFERENCE, pattern)
    else:
        design = load_design(KINDS[kind].reference or OTHER_REFERENCE)
    extent = float(np.ptp(design_pattern(design).vertices_coords, axis=0).max())
    return scale_design(design, size / extent, natural=True)


def with_short_numbers(text: str) -> str:
    """Return the text of a file with numbers of many digits rounded to six."""
    return _LONG_NUMBER.sub(lambda number: f"{float(number[0]):.6g}", text)
