"""Where everything of a joint is: two bars, the hinge between them, its stops, and the pegs that straps hang on.

In the axes of a joint x points to the distal side, square to the hinge, y lies along the hinge and z points to the side
that its overbend raises the distal bar to. Bars stand off the hinge to that side, so that the hinge itself, and with it
what folds there, stays in the plane of the sheet.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from forficula.arrays import Array
from forficula.design import Design, MakeSection
from forficula.design.section import SMALL_LENGTH
from forficula.errors import InputError
from forficula.make.hinge.straps import Strap, strap_of
from forficula.quantities import show_quantity
from forficula.structure import Bar, Structure, built_frames, built_points, hinges_between

# of a bar's radius: above it a flat is cut, which lies on the printer's bed, so that nothing hangs further than 45 deg
FLAT = math.sqrt(0.5)
# cos of the largest angle at which a bar may stand against the plane square to its hinge
_OBLIQUE = math.cos(math.radians(60.0))


@dataclass(frozen=True, kw_only=True, eq=False)
class Arm:
    """One side of a joint.

    Attributes:
        body: number of the body that its bar is.
        along: unit vector from the hinge along the bar, in the axes of the ground as built, (3,).
        length: of the bar, m.
        peg: along the bar from the hinge to the peg that straps hang on, m; 0 without one.
        height: of the peg over the hinge, to the overbend side, m.
    """

    body: int
    along: Array
    length: float
    peg: float = 0.0
    height: float = 0.0


@dataclass(frozen=True, kw_only=True, eq=False)
class JointLayout:
    """A joint to make, in the axes of the ground as the structure is built.

    Attributes:
        name: of its hinge.
        hinge: number of the hinge.
        tendon: number of the tendon across it; None without one.
        origin: where the hinge's axis is between the two bars, m, (3,).
        frame: x, y and z of the joint as columns, (3, 3).
        proximal: the side that the other one turns against.
        distal: the side that turns.
        lower: where the stop of the fold is, rad, < 0.
        upper: where the stop of the overbend is, rad, >= 0.
        bar_diameter: m.
        standoff: of the bars' axes from the hinge's, m.
        knuckle_diameter: of the hinge, m.
        width: of all knuckles of the hinge, along it, m.
        lug: how far the two lugs with the stops reach along the bars, m.
        strap: that the tendon is made as; None without one.
        aside: of each strap's middle from the bar's axis, in the plane of the sheet, m; 0 of a single one.
        make: how it is made.
    """

    name: str
    hinge: int
    tendon: int | None
    origin: Array
    frame: Array
    proximal: Arm
    distal: Arm
    lower: float
    upper: float
    bar_diameter: float
    standoff: float
    knuckle_diameter: float
    width: float
    lug: float
    strap: Strap | None
    aside: float
    make: MakeSection

    @property
    def top(self) -> float:
        """Height of the flat that a joint lies on when it is printed, m."""
        return self.standoff + FLAT * self.bar_diameter / 2

    @property
    def play(self) -> float:
        """Gap between pin and knuckles that turn on it, m: half the clearance for a pin, all of it for an axle."""
        return self.make.clearance / (2 if self.make.hinge == "pin" else 1)

    @property
    def side_widths(self) -> tuple[float, float]:
        """Along the hinge: half the middle knuckle, and where the two outer ones begin, m, from the middle."""
        middle = (self.width - 2 * self.make.clearance) / 4
        return middle, middle + self.make.clearance

    def peg_of(self, arm: Arm) -> Array:
        """Where the middle of a peg is as built, m, (3,)."""
        place: Array = self.origin + arm.peg * arm.along + arm.height * self.frame[:, 2]
        return place

    def across(self, arm: Arm) -> Array:
        """Unit vector across a bar in the plane of the sheet, to the side that the hinge's y is on, (3,)."""
        across: Array = np.cross(self.frame[:, 2], arm.along)
        return across * math.copysign(1.0, float(across @ self.frame[:, 1]))


def joint_layouts(design: Design, structure: Structure) -> tuple[JointLayout, ...]:
    """The joints of a structure of bars: one at each hinge by which a bar turns against another.

    Raises:
        InputError: it has no such hinge, or one that cannot be made: without stops, with bars that run along it, or
            too narrow for its knuckles.
    """
    bars = {bar.body: bar for bar in structure.bars}
    found = [_layout(design, structure, number, bars) for number in bar_hinges(structure)]
    if not found:
        raise InputError(
            f"{design.name}: no bar is hinged to another, so there is no joint to make; --part sheet makes its sheet"
        )
    # a tendon across several hinges has one width over all of them
    widest = {each.tendon: max(other.aside for other in found if other.tendon == each.tendon) for each in found}
    return tuple(replace(each, aside=widest[each.tendon]) for each in found)


def bar_hinges(structure: Structure) -> tuple[int, ...]:
    """Numbers of the hinges by which a bar turns against another."""
    bars = {bar.body for bar in structure.bars}
    return tuple(
        number
        for number, hinge in enumerate(structure.hinges)
        if hinge.body in bars and structure.bodies[hinge.body].parent in bars
    )


def _layout(design: Design, structure: Structure, number: int, bars: Mapping[int, Bar]) -> JointLayout:
    """Lay out the joint at a hinge, with straps as far aside as it needs alone."""
    make, hinge = design.make or MakeSection(), structure.hinges[number]
    if not (-math.pi <= hinge.lower < 0 <= hinge.upper < math.pi / 2):
        raise InputError(
            f"{design.name}: no stops can be built for {hinge.name}: need a range from -180 deg or more to less than"
            f" 90 deg, got {math.degrees(hinge.lower):g} to {math.degrees(hinge.upper):g} deg"
        )
    parent, (origins, frames) = structure.bodies[hinge.body].parent, built_frames(structure)
    turn = hinge.sense * frames[hinge.body] @ hinge.axis
    ends = (-frames[parent] @ bars[parent].end, frames[hinge.body] @ bars[hinge.body].end)
    ways = [end / np.linalg.norm(end) for end in ends]
    if min(np.linalg.norm(np.cross(turn, way)) for way in ways) < _OBLIQUE:
        raise InputError(
            f"{design.name}: a bar runs along {hinge.name}, so no joint can be made: need 30 deg or more between them"
        )
    up = np.cross(turn, ways[1]) / np.linalg.norm(np.cross(turn, ways[1]))
    diameter, knuckle = bars[hinge.body].diameter, _knuckle(make)
    standoff = (max(diameter, knuckle) + make.clearance) / 2
    tendon, pegs = _tendon_across(structure, number)
    layout = JointLayout(
        name=hinge.name,
        hinge=number,
        tendon=tendon,
        origin=origins[hinge.body],
        frame=np.column_stack([np.cross(-turn, up), -turn, up]),
        proximal=Arm(body=parent, along=ways[0], length=float(np.linalg.norm(ends[0]))),
        distal=Arm(body=hinge.body, along=ways[1], length=float(np.linalg.norm(ends[1]))),
        lower=hinge.lower,
        upper=hinge.upper,
        bar_diameter=diameter,
        standoff=standoff,
        knuckle_diameter=knuckle,
        width=make.hinge_width,
        lug=knuckle / 2 + make.clearance + diameter,
        strap=None if tendon is None else strap_of(design, structure.tendons[tendon]),
        aside=0.0,
        make=make,
    )
    _check_width(layout)
    layout = replace(
        layout, proximal=_with_peg(layout, layout.proximal, pegs), distal=_with_peg(layout, layout.distal, pegs)
    )
    if layout.strap is None or layout.strap.count == 1:
        return layout
    return replace(layout, aside=_aside(layout, layout.strap, [place for _, place in pegs]))


def _check_width(layout: JointLayout) -> None:
    """Refuse a hinge without room for its three knuckles."""
    make = layout.make
    if layout.side_widths[0] < make.nozzle:
        least = 2 * (2 * make.nozzle + make.clearance)
        raise InputError(
            f"make.hinge_width: no room for three knuckles: need >= {show_quantity(least, SMALL_LENGTH)}, by"
            f" make.nozzle and make.clearance, got {show_quantity(make.hinge_width, SMALL_LENGTH)}"
        )


def _knuckle(make: MakeSection) -> float:
    """Diameter of a knuckle with a wall of its own around what turns in it, m."""
    return make.pin_diameter + make.clearance * (1 if make.hinge == "pin" else 2) + 2 * make.hinge_wall


def _tendon_across(structure: Structure, hinge: int) -> tuple[int | None, list[tuple[int, Array]]]:
    """The first tendon across a hinge, and the bodies and places as built of its ends, proximal first."""
    places = built_points(structure)
    for number, tendon in enumerate(structure.tendons):
        bodies = [structure.points[point].body for point in tendon.points]
        if hinge in hinges_between(structure, *bodies):
            return number, [(body, places[point]) for body, point in zip(bodies, tendon.points, strict=True)]
    return None, []


def _with_peg(layout: JointLayout, arm: Arm, pegs: Sequence[tuple[int, Array]]) -> Arm:
    """An arm with the peg that the tendon ends on, if that is on it."""
    for body, place in pegs:
        if body == arm.body:
            off = place - layout.origin
            height = float(off @ layout.frame[:, 2]) if layout.make.anchors == "as designed" else layout.standoff
            return replace(arm, peg=float(off @ arm.along), height=height)
    return arm


def _aside(layout: JointLayout, strap: Strap, ends: Sequence[Array]) -> float:
    """How far aside of the bars two straps must be to pass the hinge and its lugs on either side, flat, m.

    A strap goes straight from one peg to the other; what it is aside at an end counts by how near that is.
    """
    need = strap.width / 2 + layout.make.clearance
    (start, end), x, y = (np.asarray(ends) - layout.origin), layout.frame[:, 0], layout.frame[:, 1]
    ways = [layout.across(arm) for arm in (layout.proximal, layout.distal)]
    # square to bars that lean a share of it is along the hinge
    leaning = min(abs(float(way @ y)) for way in ways)
    aside = layout.bar_diameter / 2 + need
    for at in (-layout.lug, 0.0, layout.lug):
        middle = start + (at - float(start @ x)) / float((end - start) @ x) * (end - start)
        aside = max(aside, (layout.width / 2 + need + abs(float(middle @ y))) / leaning)
    return aside
