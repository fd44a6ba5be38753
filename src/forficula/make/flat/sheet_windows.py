"""Windows of a sheet: for straps that pass through it, for hinges in it, and for the ends of tendons."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from forficula.arrays import Array
from forficula.design import Design, MakeSection
from forficula.make.flat.regions import Region, loops_of, region_of, rounded, sides_of
from forficula.make.flat.unfolding import Unfolding, laid_place
from forficula.make.hinge.joint_layout import joint_layouts
from forficula.make.hinge.strap_shape import bows_beside, strap_places
from forficula.make.hinge.straps import strap_of
from forficula.pattern import CreasePattern
from forficula.pattern.geometry import distance_to_sides
from forficula.structure import Structure, Tendon, built_points

LEAST_STRIP = 2e-3  # m, minimum width of sheet between cut-outs


@dataclass(frozen=True, kw_only=True, eq=False)
class SheetWindow:
    """A cut-out of a sheet for a part that passes through it.

    Attributes:
        name: name of the tendon.
        outline: counterclockwise, nominal size, m, (corner, 2).
    """

    name: str
    outline: Array


def sheet_windows(
    design: Design, structure: Structure, pattern: CreasePattern, sheet: Unfolding
) -> tuple[tuple[SheetWindow, ...], list[tuple[str, Array]]]:
    """Return the cut-outs of a sheet for its tendons.

    With bars on the sheet along creases, a taut strap runs from peg to peg and passes through the sheet's plane when
    the hinge between them folds. Its window has the strap's width and extends from eye to eye. Another window surrounds
    the knuckles of each hinge, which are in the plane of the sheet. All are offset by `make.window`, with round
    corners.

    A sheet without bars is attached to its tendons directly. Each end has a hole of the diameter `make.peg_diameter`
    for a peg, a rivet or a knot; an end at the sheet's edge has none and needs a clip. A tendon in the flat sheet
    across creases swings to either side of it: between its holes there is a slot with the total width of its straps,
    offset by `make.window`, that leaves 2 mm or a peg's diameter of sheet around the holes. A tendon through the air,
    such as between facets of a sheet that is built folded, needs no slot.

    Args:
        design: in SI.
        structure: structure of the design.
        pattern: pattern of the structure, as built.
        sheet: flat pattern.

    Returns:
        The windows; and the holes by the name of the tendon, m, (2,).

    Raises:
        InputError: a tendon for which no strap can be made.
    """
    make = design.make or MakeSection()
    if structure.bars:
        return tuple(_joint_windows(design, make, structure)), []
    windows, holes = [], []
    points = built_points(structure)
    for tendon in structure.tendons:
        laid = [laid_place(pattern, sheet, points[end]) for end in tendon.points]
        ends = [place for end in laid if end is not None for place in [end[1]]]
        holes += [(tendon.name, place) for place in ends if _room(sheet, place) > make.peg_diameter / 2 + LEAST_STRIP]
        apart = float(np.linalg.norm(ends[1] - ends[0])) if len(ends) == 2 else 0.0
        as_built = float(np.linalg.norm(points[tendon.points[1]] - points[tendon.points[0]]))
        if len({end[0] for end in laid if end is not None}) == 2 and abs(apart - as_built) <= 1e-6 * as_built:
            slot = _slot(design, make, tendon, ends[0], ends[1])
            windows += [slot] if slot is not None else []
    return tuple(windows), holes


def _joint_windows(design: Design, make: MakeSection, structure: Structure) -> Iterator[SheetWindow]:
    """Yield the windows of straps and hinges between bars."""
    joints = bows_beside(joint_layouts(design, structure))
    for place in strap_places(joints):
        tendon = structure.tendons[place.tendon]
        for start, end in place.ends[:, :, :2]:
            yield _window(tendon, make, region_of([_band(start, end, place.strap.width, place.eye_diameter / 2)]))
    for joint in joints:
        half = joint.width / 2 * joint.frame[:2, 1]
        middle, across = joint.origin[:2], joint.knuckle_diameter + 2 * make.clearance
        knuckles = region_of([_band(middle - half, middle + half, across, 0.0)])
        label = structure.hinges[joint.hinge].label or joint.name
        yield SheetWindow(name=f"hinge of {label}", outline=loops_of(rounded(knuckles, make.window))[0])


def _slot(design: Design, make: MakeSection, tendon: Tendon, start: Array, end: Array) -> SheetWindow | None:
    """Return the window of a tendon in a sheet without bars; None if there is not enough space between its holes."""
    strap = strap_of(design, tendon)
    length = float(np.linalg.norm(end - start))
    kept = make.peg_diameter / 2 + max(LEAST_STRIP, make.peg_diameter) + make.window
    if length <= 2 * kept:
        return None
    along = (end - start) / length
    width = strap.count * strap.width + (strap.count - 1) * make.clearance
    return _window(tendon, make, region_of([_band(start + kept * along, end - kept * along, width, 0.0)]))


def _window(tendon: Tendon, make: MakeSection, passing: Region) -> SheetWindow:
    return SheetWindow(name=tendon.label or tendon.name, outline=loops_of(rounded(passing, make.window))[0])


def _band(start: Array, end: Array, width: float, beyond: float) -> Array:
    """Return corners of a strip around a line that extends beyond its ends, counterclockwise, m, (4, 2)."""
    along = (end - start) / np.linalg.norm(end - start)
    across = np.array([-along[1], along[0]]) * width / 2
    one, other = start - beyond * along, end + beyond * along
    return np.array([one - across, other - across, other + across, one + across])


def _room(sheet: Unfolding, place: Array) -> float:
    """Return the distance of a point in a flat sheet from its edge, m."""
    faces = region_of([sheet.pattern.vertices_coords[list(face), :2] for face in sheet.pattern.faces_vertices])
    return distance_to_sides(sides_of(faces), place)
