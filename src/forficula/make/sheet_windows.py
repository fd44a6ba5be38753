"""Windows of a sheet: where straps pass through it, where hinges stand in it, and where tendons are knotted."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from manifold3d import CrossSection
from numpy.typing import NDArray

from forficula.design import Design, MakeSection
from forficula.make.regions import MILLIMETRES, Region, distance_to, loops_of, region_of, rounded, sides_of
from forficula.make.straps import strap_of
from forficula.make.unfolding import Unfolding, laid_place
from forficula.pattern import CreasePattern
from forficula.structure import Structure, Tendon, built_hinges, built_points, hinges_between

Array = NDArray[np.float64]

LEAST_STRIP = 2e-3  # m, of sheet between what is cut out of it


@dataclass(frozen=True, kw_only=True, eq=False)
class Window:
    """What is cut out of a sheet for a part that passes through it.

    Attributes:
        name: of the tendon that it is for.
        outline: counterclockwise, of its nominal size, m, (corner, 2).
    """

    name: str
    outline: Array


def sheet_windows(
    design: Design, structure: Structure, pattern: CreasePattern, sheet: Unfolding
) -> tuple[tuple[Window, ...], list[tuple[str, Array]]]:
    """What is cut out of a sheet for its tendons.

    Between bars, which lie on the sheet along creases, a strap goes from peg to peg and through the sheet's plane when
    the hinge between them folds. Its window is the least convex area, which has no corner to tear from, around the way
    along the bars and the straight way between the pegs, as wide as the bar with its straps beside it, and around the
    hinges' knuckles, which stand in the sheet, grown by `make.window`.

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
        return tuple(_bar_window(design, make, structure, tendon) for tendon in structure.tendons), []
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


def _bar_window(design: Design, make: MakeSection, structure: Structure, tendon: Tendon) -> Window:
    """The window of a tendon between bars."""
    strap, points = strap_of(design, tendon), built_points(structure)
    origins, axes = built_hinges(structure)
    start, end = (points[point, :2] for point in tendon.points)
    between = hinges_between(structure, *(structure.points[point].body for point in tendon.points))
    places = sorted((origins[hinge, :2] for hinge in between), key=lambda place: float(np.linalg.norm(place - start)))
    bodies = {structure.points[point].body for point in tendon.points}
    diameter = max(bar.diameter for bar in structure.bars if bar.body in bodies)
    beside = 2 * (make.clearance + strap.width) if strap.count == 2 else max(0.0, strap.width - diameter)
    width = diameter + beside
    around_peg = make.peg_diameter / 2 + strap.thickness
    corners = [_band(start, end, width, around_peg)]
    corners += [_band(one, other, width, 0.0) for one, other in zip([start, *places], [*places, end], strict=True)]
    across = make.pin_diameter + 2 * (make.hinge_wall + make.clearance)
    for hinge in between:
        along = axes[hinge, :2] / np.linalg.norm(axes[hinge, :2]) * make.hinge_width / 2
        corners.append(_band(origins[hinge, :2] - along, origins[hinge, :2] + along, across, 0.0))
    return _window(tendon, make, CrossSection.hull_points(MILLIMETRES * np.concatenate(corners)))


def _slot(design: Design, make: MakeSection, tendon: Tendon, start: Array, end: Array) -> Window | None:
    """The window of a tendon in a sheet without bars; None where there is no room for one between its holes."""
    strap = strap_of(design, tendon)
    length = float(np.linalg.norm(end - start))
    kept = make.peg_diameter / 2 + max(LEAST_STRIP, make.peg_diameter) + make.window
    if length <= 2 * kept:
        return None
    along = (end - start) / length
    width = strap.count * strap.width + (strap.count - 1) * make.clearance
    return _window(tendon, make, region_of([_band(start + kept * along, end - kept * along, width, 0.0)]))


def _window(tendon: Tendon, make: MakeSection, passing: Region) -> Window:
    return Window(name=tendon.label or tendon.name, outline=loops_of(rounded(passing, make.window))[0])


def _band(start: Array, end: Array, width: float, beyond: float) -> Array:
    """Corners of a strip around a line, that reaches beyond its ends, counterclockwise, m, (4, 2)."""
    along = (end - start) / np.linalg.norm(end - start)
    across = np.array([-along[1], along[0]]) * width / 2
    one, other = start - beyond * along, end + beyond * along
    return np.array([one - across, other - across, other + across, one + across])


def _room(sheet: Unfolding, place: Array) -> float:
    """How far a place of a flat sheet lies from its edge, m; a hole of twice that would touch it."""
    faces = region_of([sheet.pattern.vertices_coords[list(face), :2] for face in sheet.pattern.faces_vertices])
    return distance_to(sides_of(faces), place)
