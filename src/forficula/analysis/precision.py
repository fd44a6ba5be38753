"""Precision of the arithmetic with which runs were computed, in words."""

from __future__ import annotations

from typing import Literal

from forficula.analysis.margin import SMALL_MARGIN
from forficula.design import Design

Precision = Literal["single", "double"]

_LESS_RELIABLE = f"a verdict with a margin below {100 * SMALL_MARGIN:.0f} % is less reliable than in double precision"


def precision_of(design: Design) -> Precision:
    """Return the precision with which a design is simulated."""
    return "double" if design.protocol.device is None else "single"


def precision_text(design: Design) -> str:
    """Return a sentence about a run in single precision; empty for double precision."""
    if design.protocol.device is None:
        return ""
    where = "a graphics processor" if design.protocol.device == "gpu" else "the processor"
    return (
        f"computed in single precision, about 7 digits instead of 16, by MuJoCo Warp on {where}: {_LESS_RELIABLE},"
        ' which protocol.device = "cpu" uses'
    )


def precisions_text(single: int, points: int) -> str:
    """Return a sentence about the points of a study that were computed in single precision; empty if there are none."""
    if not single:
        return ""
    which = "All" if single == points else f"{single} of {points}"
    return f"{which} points were computed in single precision by MuJoCo Warp: {_LESS_RELIABLE}"
