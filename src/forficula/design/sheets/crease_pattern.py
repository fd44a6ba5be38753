"""The crease pattern of a design of any kind, and its folded states."""

from __future__ import annotations

import numpy as np

from forficula.arrays import Array
from forficula.design.assembly.assembly import AssemblyDesign
from forficula.design.design import Design
from forficula.design.fans.fan import FanDesign
from forficula.design.fans.joint import JointDesign
from forficula.design.sheets.sheet import SheetDesign
from forficula.errors import InputError
from forficula.pattern import CreasePattern, earwig_pattern, folded_coordinates, folded_frames

_SHARES = (0.25, 0.5, 0.75, 1.0)


def design_pattern(design: Design) -> CreasePattern:
    """Return the crease pattern of a design, in the units of the design's numbers.

    Raises:
        InputError: the design has no crease pattern.
    """
    if isinstance(design, FanDesign):
        return earwig_pattern(design.fan)
    if isinstance(design, JointDesign):
        return design.pattern.sheet
    if isinstance(design, SheetDesign):
        return design.sheet
    if isinstance(design, AssemblyDesign):
        raise InputError(
            f"{design.name}: an assembly has no crease pattern of its own, but its parts have, such as"
            f" {design.parts[0]}"
        )
    raise InputError(f"{design.name}: has no crease pattern")


def part_patterns(design: Design) -> dict[str, CreasePattern]:
    """Return the crease patterns of all parts of an assembly by name, or that of another design under ""."""
    if not isinstance(design, AssemblyDesign):
        return {"": design_pattern(design)}
    return {
        f"{name}.{inner}".rstrip("."): pattern
        for name, part in design.designs.items()
        for inner, pattern in part_patterns(part).items()
    }


def design_frames(design: Design) -> list[tuple[str, Array, Array]]:
    """Compute folded states of a design's sheet, from nearly open to flat-folded, as `write_fold` takes them.

    In each state all creases have the same share of their target angles. A sheet that is not built flat, or cannot fold
    in this manner, has none.
    """
    if isinstance(design, FanDesign):
        return folded_frames(design.fan) if design.fan.ring_folds == 1 else []
    pattern, frames = design_pattern(design), []
    if np.ptp(pattern.vertices_coords[:, 2]) > 0:
        return []
    for share in _SHARES:
        angles = share * pattern.edges_fold_angle
        try:
            frames.append((f"creases at {180 * share:g} deg", folded_coordinates(pattern, angles), angles))
        except InputError:
            return []
    return frames
