"""Layout of a joint: two bars, the hinge between them, its stops, and the pegs for straps.

In the axes of a joint, x points to the distal side, perpendicular to the hinge, y points along the hinge, and z points
to the side to which its overbend raises the distal bar. Bars are offset from the hinge to this side, so that the hinge
itself stays in the plane of the sheet.
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

# the flat of a bar on the printer's bed is at this fraction of its radius, so that no overhang exceeds 45 deg
FLAT = math.sqrt(0.5)
# cos of the largest angle between a bar and the plane perpendicular to its hinge
_OBLIQUE = math.cos(math.radians(60.0))


@dataclass(frozen=True, kw_only=True, eq=False)
class Arm:
    """One side of a joint.

    Attributes:
        body: index of the bar's body.
        along: unit vector from the hinge along the bar, in the axes of the ground as built, (3,).
        length: length of the bar, m.
        peg: distance along the bar from the hinge to the peg for straps, m; 0 without one.
        height: height of the peg over the hinge, to the overbend side, m.
    """

    body: int
    along: Array
    length: float
    peg: float = 0.0
    height: float = 0.0


@dataclass(frozen=True, kw_only=True, eq=False)
class JointLayout:
    """A joint to make, in the axes of the ground as built.

    Attributes:
        name: name of its hinge.
        hinge: index of the hinge.
        tendon: index of the tendon across it; None without one.
        origin: origin of the hinge's axis between the two bars, m, (3,).
        frame: x, y and z of the joint as columns, (3, 3).
        proximal: the side that is fixed in the joint's axes.
        distal: the side that turns.
        lower: angle of the fold stop, rad, < 0.
        upper: angle of the overbend stop, rad, >= 0.
        bar_diameter: m.
        standoff: distance of the bars' axes from the hinge's axis, m.
        knuckle_diameter: knuckle diameter of the hinge, m.
        width: width of all knuckles of the hinge, along it, m.
        lug: length of the two lugs with the stops along the bars, m.
        strap: strap that forms the tendon; None without one.
        aside: distance of each strap's middle from the bar's axis, in the plane of the sheet, m; 0 for a single strap.
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
        """Height of the flat on which a joint is printed, m."""
        return self.standoff + FLAT * self.bar_diameter / 2

    @property
    def play(self) -> float:
        """Gap between pin and turning knuckles, m: half the clearance for a pin, the whole clearance for an axle."""
        return self.make.clearance / (2 if self.make.hinge == "pin" else 1)

    @property
    def side_widths(self) -> tuple[float, float]:
        """Along the hinge, from the middle: end of the middle knuckle, and beginning of the two outer ones, m."""
        middle = (self.width - 2 * self.make.clearance) / 4
        return middle, middle + self.make.clearance

    def peg_of(self, arm: Arm) -> Array:
        """Return the middle of a peg as built, m, (3,)."""
        place: Array = self.origin + arm.peg * arm.along + arm.height * self.frame[:, 2]
        return place

    def across(self, arm: Arm) -> Array:
        """Return the unit vector across a bar in the plane of the sheet, on the side of the hinge's y, (3,)."""
        across: Array = np.cross(self.frame[:, 2], arm.along)
        return across * math.copysign(1.0, float(across @ self.frame[:, 1]))


def joint_layouts(design: Design, structure: Structure) -> tuple[JointLayout, ...]:
    """Return the joints of a structure with bars: one at each hinge between two bars.

    Raises:
        InputError: there is no such hinge, or one that cannot be made: without stops, with bars along it, or too narrow
            for its knuckles.
    """
    bars = {bar.body: bar for bar in structure.bars}
    layouts = [_layout(design, structure, number, bars) for number in bar_hinges(structure)]
    if not layouts:
        raise InputError(
            f"{design.name}: no bar is hinged to another, so there is no joint to make; --part sheet makes its sheet"
        )
    # a tendon across several hinges has the same distance from the bars at all of them
    widest = {
        layout.tendon: max(other.aside for other in layouts if other.tendon == layout.tendon) for layout in layouts
    }
    return tuple(replace(layout, aside=widest[layout.tendon]) for layout in layouts)


def bar_hinges(structure: Structure) -> tuple[int, ...]:
    """Return indices of the hinges between two bars."""
    bars = {bar.body for bar in structure.bars}
    return tuple(
        number
        for number, hinge in enumerate(structure.hinges)
        if hinge.body in bars and structure.bodies[hinge.body].parent in bars
    )


def _layout(design: Design, structure: Structure, number: int, bars: Mapping[int, Bar]) -> JointLayout:
    """Return the layout of the joint at a hinge, with straps as far aside as this joint needs."""
    make, hinge = design.make or MakeSection(), structure.hinges[number]
    if not (-math.pi <= hinge.lower < 0 <= hinge.upper < math.pi / 2):
        raise InputError(
            f"{design.name}: no stops can be built for {hinge.name}: need a range from -180 deg or more to less than"
            f" 90 deg, got {math.degrees(hinge.lower):g} to {math.degrees(hinge.upper):g} deg"
        )
    parent, (origins, frames) = structure.bodies[hinge.body].parent, built_frames(structure)
    turn = hinge.sense * frames[hinge.body] @ hinge.axis
    ends = (-frames[parent] @ bars[parent].end, frames[hinge.body] @ bars[hinge.body].end)
    directions = [end / np.linalg.norm(end) for end in ends]
    if min(np.linalg.norm(np.cross(turn, direction)) for direction in directions) < _OBLIQUE:
        raise InputError(
            f"{design.name}: a bar runs along {hinge.name}, so no joint can be made: need 30 deg or more between them"
        )
    up = np.cross(turn, directions[1]) / np.linalg.norm(np.cross(turn, directions[1]))
    diameter, knuckle = bars[hinge.body].diameter, _knuckle(make)
    standoff = (max(diameter, knuckle) + make.clearance) / 2
    tendon, pegs = _tendon_across(structure, number)
    layout = JointLayout(
        name=hinge.name,
        hinge=number,
        tendon=tendon,
        origin=origins[hinge.body],
        frame=np.column_stack([np.cross(-turn, up), -turn, up]),
        proximal=Arm(body=parent, along=directions[0], length=float(np.linalg.norm(ends[0]))),
        distal=Arm(body=hinge.body, along=directions[1], length=float(np.linalg.norm(ends[1]))),
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
    """Reject a hinge without space for its three knuckles."""
    make = layout.make
    if layout.side_widths[0] < make.nozzle:
        least = 2 * (2 * make.nozzle + make.clearance)
        raise InputError(
            f"make.hinge_width: no space for three knuckles: need >= {show_quantity(least, SMALL_LENGTH)}, by"
            f" make.nozzle and make.clearance, got {show_quantity(make.hinge_width, SMALL_LENGTH)}"
        )


def _knuckle(make: MakeSection) -> float:
    """Return the diameter of a knuckle with its wall around the pin or axle, m."""
    return make.pin_diameter + make.clearance * (1 if make.hinge == "pin" else 2) + 2 * make.hinge_wall


def _tendon_across(structure: Structure, hinge: int) -> tuple[int | None, list[tuple[int, Array]]]:
    """Return the first tendon across a hinge, and bodies and built positions of its ends, proximal first."""
    places = built_points(structure)
    for number, tendon in enumerate(structure.tendons):
        bodies = [structure.points[point].body for point in tendon.points]
        if hinge in hinges_between(structure, *bodies):
            return number, [(body, places[point]) for body, point in zip(bodies, tendon.points, strict=True)]
    return None, []


def _with_peg(layout: JointLayout, arm: Arm, pegs: Sequence[tuple[int, Array]]) -> Arm:
    """Return an arm with the peg of the tendon's end, if it is on this arm."""
    for body, place in pegs:
        if body == arm.body:
            off = place - layout.origin
            height = float(off @ layout.frame[:, 2]) if layout.make.anchors == "as designed" else layout.standoff
            return replace(arm, peg=float(off @ arm.along), height=height)
    return arm


def _aside(layout: JointLayout, strap: Strap, ends: Sequence[Array]) -> float:
    """Return the distance from the bars at which two straps pass the hinge and its lugs on either side, flat, m.

    A strap is straight from one peg to the other, so its distance at the hinge is interpolated between its ends.
    """
    need = strap.width / 2 + layout.make.clearance
    (start, end), x, y = (np.asarray(ends) - layout.origin), layout.frame[:, 0], layout.frame[:, 1]
    across_bars = [layout.across(arm) for arm in (layout.proximal, layout.distal)]
    # the direction across an oblique bar has only a component along the hinge
    leaning = min(abs(float(across @ y)) for across in across_bars)
    aside = layout.bar_diameter / 2 + need
    for at in (-layout.lug, 0.0, layout.lug):
        middle = start + (at - float(start @ x)) / float((end - start) @ x) * (end - start)
        aside = max(aside, (layout.width / 2 + need + abs(float(middle @ y))) / leaning)
    return aside
