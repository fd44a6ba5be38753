"""Windows of a sheet: where straps pass through it, where hinges stand in it, and where tendons are knotted."""

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

LEAST_STRIP = 2e-3  # m, of sheet between what is cut out of it


@dataclass(frozen=True, kw_only=True, eq=False)
class SheetWindow:
    """What is cut out of a sheet for a part that passes through it.

    Attributes:
        name: of the tendon that it is for.
        outline: counterclockwise, of its nominal size, m, (corner, 2).
    """

    name: str
    outline: Array


def sheet_windows(
    design: Design, structure: Structure, pattern: CreasePattern, sheet: Unfolding
) -> tuple[tuple[SheetWindow, ...], list[tuple[str, Array]]]:
    """What is cut out of a sheet for its tendons.

    Between bars, which lie on the sheet along creases, a taut strap goes from peg to peg and through the sheet's plane
    when the hinge between them folds: its window is as wide as it is, from eye to eye, where the joint has it. Another
    is around the knuckles of each hinge, which stand in the sheet. All are grown by `make.window`, with round corners.

    A sheet without bars is hung on its tendons itself. Each end has a hole of the diameter `make.peg_diameter` for a
    peg, a rivet or a knot; one at the sheet's edge is left to a clip. A tendon that lies in the flat sheet across
    creases swings to either side of it: between its holes is a slot as wide as its straps beside one another, grown by
    `make.window`, that leaves 2 mm, or a peg's diameter, of sheet around them. One that goes through the air, as
    between facets of a sheet that is built folded, needs none.

    Args:
        design: in SI.
        structure: of it.
        pattern: of the structure, as built.
        sheet: the same, flat.

    Returns:
        The windows; and the holes by the name of the tendon, m, (2,).

    Raises:
        InputError: a tendon of which no strap can be made.
    """
    make = design.make or MakeSection()
    if structure.bars:
        return tuple(_joint_windows(design, make, structure)), []
    windows, holes = [], []
    points = built_points(structure)
    for tendon in structure.tendons:
        laid = [laid_place(pattern, sheet, points[end]) for end in tendon.points]
        ends = [place for each in laid if each is not None for place in [each[1]]]
        holes += [(tendon.name, place) for place in ends if _room(sheet, place) > make.peg_diameter / 2 + LEAST_STRIP]
        apart = float(np.linalg.norm(ends[1] - ends[0])) if len(ends) == 2 else 0.0
        as_built = float(np.linalg.norm(points[tendon.points[1]] - points[tendon.points[0]]))
        if len({each[0] for each in laid if each is not None}) == 2 and abs(apart - as_built) <= 1e-6 * as_built:
            slot = _slot(design, make, tendon, ends[0], ends[1])
            windows += [slot] if slot is not None else []
    return tuple(windows), holes


def _joint_windows(design: Design, make: MakeSection, structure: Structure) -> Iterator[SheetWindow]:
    """The windows of straps and hinges between bars."""
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
    """The window of a tendon in a sheet without bars; None where there is no room for one between its holes."""
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
    """Corners of a strip around a line, that reaches beyond its ends, counterclockwise, m, (4, 2)."""
    along = (end - start) / np.linalg.norm(end - start)
    across = np.array([-along[1], along[0]]) * width / 2
    one, other = start - beyond * along, end + beyond * along
    return np.array([one - across, other - across, other + across, one + across])


def _room(sheet: Unfolding, place: Array) -> float:
    """How far a place of a flat sheet lies from its edge, m; a hole of twice that would touch it."""
    faces = region_of([sheet.pattern.vertices_coords[list(face), :2] for face in sheet.pattern.faces_vertices])
    return distance_to_sides(sides_of(faces), place)
