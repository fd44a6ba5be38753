"""What is checked of joints by formulas: whether bars, pegs, pins, knuckles, stops and straps bear what loads them.

That is the tendon's pull, the largest within the joint's range, from peg to peg as made, and at stops also the drives
of the design. Nothing moves: impact and a tendon's damping are no part of it. Strengths are the least that the sources
of a material give; for pegs, knuckles and printed axles that across layers, which is the lesser one however they lie.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.make.checks.check import Check
from forficula.make.hinge.joint import is_level, turned
from forficula.make.hinge.joint_layout import Arm, JointLayout
from forficula.make.hinge.stop_load import StopLoad, stop_load
from forficula.make.hinge.strap_shape import StrapPlace
from forficula.make.part import PartSet
from forficula.make.solid.sections import CrossSection, bar_section, peg_modulus
from forficula.make.stock import Stock, stock_of
from forficula.structure import Structure, built_frames

# what anything must bear, by what it has to; chosen
SAFE = 2.0
# rad, by which a drive may twist a bar: a sixth of the right angle that veins turn through; chosen
_TWIST = math.radians(15.0)
# cos of the largest angle between a hinge and a bar that it turns about itself
_ITSELF = math.cos(math.radians(30.0))
# of polymers, 0.35 to 0.4
_POISSON = 0.4
# of a material's strength in tension, that in shear (von Mises)
_SHEAR = 1 / math.sqrt(3)
_ANGLES = 61
# along each of the two bars
_PLACES = 33
# of Euler's load: as near to it as loads are tried
_NEAR = 1 - 1e-6


def strength_checks(parts: PartSet) -> Iterator[Check]:
    """Check by formulas what the joints of a set of parts bear."""
    for joint in parts.joints:
        place = next((each for each in parts.straps if each.tendon == joint.tendon), None)
        if place is None:
            continue
        stock = stock_of(joint.make.bar_material)
        each = largest_pulls(parts.structure, joint, place)
        pull, longest = float(each.sum()), float(each.max())
        stops = [stop_load(parts.structure, joint, place, stop) for stop in ("overbend", "fold")]
        yield from _column(joint, place, stock, pull)
        yield from _pegs(joint, place, stock, longest)
        yield from _feet(joint, stock, pull)
        yield from _pin(joint, stock, pull, stops)
        yield from (_stop(joint, stock, load) for load in stops)
        yield _strap(parts, joint, place, longest)
    arms = [(joint, arm) for joint in parts.joints for arm in (joint.proximal, joint.distal)]
    for body in dict.fromkeys(arm.body for _, arm in arms):
        yield from _twist(parts, *next(each for each in arms if each[1].body == body))


def largest_pulls(structure: Structure, joint: JointLayout, place: StrapPlace) -> Array:
    """The pull of each strap where they pull most together, while one joint goes through its range, N, (strap,).

    Across an oblique hinge the one is longer than the other; each has its share of the tendon's law.
    """
    law, pulls = structure.tendons[place.tendon].law.elastic, []
    for angle in np.linspace(joint.lower, joint.upper, _ANGLES):
        lengths = np.linalg.norm(turned(joint, float(angle)).of(place.ends[:, 1]) - place.ends[:, 0], axis=1)
        pulls.append(law.force(lengths) / place.strap.count)
    most: Array = max(pulls, key=lambda pull: float(pull.sum()))
    return most


def _factor(name: str, joint: JointLayout, bears: float | None, load: float, text: str, mend: str) -> Check:
    """A check of what something bears by what it has to, in any one unit; not made where the material is not known."""
    factor = math.inf if bears is None or load <= 0 else bears / load
    held = None if bears is None else factor >= SAFE
    if bears is None:
        text += "; not checked, for no source gives the strength of what it is made of"
    return Check(
        name=name,
        part=joint.name,
        ok=held,
        value=math.nan if bears is None else factor,
        limit=SAFE,
        unit="",
        text=text + (f"; {mend}" if held is False else ""),
    )


def column_of(joint: JointLayout, place: StrapPlace, youngs_modulus: float) -> BucklingColumn:
    """The bars of a joint between its pegs as a column, as the joint rests against its overbend stop.

    There the bars are one in the sheet's plane by their knuckles, and out of it by the stop.
    """
    opened = turned(joint, joint.upper)
    start, end = place.ends[:, 0].mean(axis=0), opened.of(place.ends[:, 1].mean(axis=0))
    way = (end - start) / np.linalg.norm(end - start)
    in_sheet = np.cross(joint.frame[:, 2], way) / np.linalg.norm(np.cross(joint.frame[:, 2], way))
    rise = joint.standoff * joint.frame[:, 2]
    inner, outer = joint.proximal, joint.distal
    # of the bars' axes
    places = np.array(
        [
            joint.origin + rise + inner.peg * inner.along,
            joint.origin + rise,
            opened.of(joint.origin + rise + outer.peg * outer.along),
        ]
    )
    off = places - start
    return BucklingColumn(
        lengths=(float((off[1] - off[0]) @ way), float((off[2] - off[1]) @ way)),
        offsets=off @ np.column_stack([in_sheet, np.cross(way, in_sheet)]),
        section=bar_section(joint.bar_diameter),
        youngs_modulus=youngs_modulus,
    )


def _column(joint: JointLayout, place: StrapPlace, stock: Stock, pull: float) -> Iterator[Check]:
    """The bars between the pegs as a column: Euler's load of a straight one, and what one as bent as it is bears."""
    modulus, strength = stock.youngs_modulus, stock.strength
    length = float(np.linalg.norm(np.diff(place.ends.mean(axis=0), axis=0)))
    buckles = None if modulus is None else euler_load(length, bar_section(joint.bar_diameter), modulus)
    mend = "take thicker bars (vein.diameter), a softer tendon, or pegs nearer to each other"
    shown = "" if buckles is None else f"; they buckle at {buckles:.0f} N (Euler)"
    yield _factor(
        "buckling of the bars",
        joint,
        buckles,
        pull,
        f"the tendon presses {1e3 * length:.0f} mm of bars together with {pull:.1f} N{shown}",
        mend,
    )
    # the bars between the pegs of a tendon across several hinges are more than two
    if not (joint.proximal.peg and joint.distal.peg):
        return
    column = column_of(joint, place, modulus or math.nan)
    bears = None if modulus is None or strength is None else column.bears(strength)
    beside = float(np.linalg.norm(column.offsets, axis=1).max())
    shown = "" if bears is None else f"; bent so, they bear {bears:.0f} N"
    yield _factor(
        "bending of the bars",
        joint,
        bears,
        pull,
        f"the tendon's line passes up to {1e3 * beside:.1f} mm beside the bars' axes{shown}",
        mend,
    )


def _pegs(joint: JointLayout, place: StrapPlace, stock: Stock, pull: float) -> Iterator[Check]:
    """Bending of a peg where it leaves its bar, as a cantilever with the strap on its end that pulls more."""
    arms = [arm for arm in (joint.proximal, joint.distal) if arm.peg]
    if not arms:
        return
    lever = max(joint.aside - joint.bar_diameter / 2, place.strap.width / 2)
    stress = pull * lever / min(peg_modulus(joint, arm) for arm in arms)
    yield _factor(
        "bending of the pegs",
        joint,
        stock.strength_across,
        stress,
        f"a strap pulls {pull:.1f} N at {1e3 * lever:.1f} mm from the bar, {stress / 1e6:.1f} MPa",
        "take thicker pegs (make.peg_diameter), a narrower hinge (make.hinge_width) or a softer tendon",
    )


def _feet(joint: JointLayout, stock: Stock, pull: float) -> Iterator[Check]:
    """Bending of what carries a peg that is off its bar: a block as wide as the bar and as long as the peg is thick."""
    lifted = [arm for arm in (joint.proximal, joint.distal) if arm.peg and not is_level(joint, arm)]
    if not lifted:
        return
    off = max(abs(arm.height - joint.standoff) for arm in lifted)
    stress = 6 * pull * off / (joint.bar_diameter * joint.make.peg_diameter**2)
    yield _factor(
        "bending of the peg's foot",
        joint,
        stock.strength_across,
        stress,
        f"{pull:.1f} N pull at {1e3 * off:.1f} mm from the bar's axis, {stress / 1e6:.1f} MPa",
        "take pegs nearer to the height of the bars (make.anchors) or thicker ones (make.peg_diameter)",
    )


def _pin(joint: JointLayout, stock: Stock, pull: float, stops: list[StopLoad]) -> Iterator[Check]:
    """Shear and bending of the pin, and tension in the walls of its knuckles, by the largest force on it.

    Off the stops that is all of the pull, and at a stop the larger, what is left of pull and stop. A couple across the
    hinge's axis loads the one outer knuckle more. The pin is a beam held in the outer knuckles: with N spread evenly
    over the middle c of a span s it has its largest moment there, N (3 s^2 - c^2) / (24 s).
    """
    make = joint.make
    inner, outer = joint.side_widths
    force = max([pull, *(load.on_pin for load in stops)])
    couple = max(load.couple for load in stops)
    side = force / 2 + couple / (outer + joint.width / 2)
    bought = make.hinge == "pin"
    strength = stock_of(make.pin_material).strength if bought else stock.strength_across
    mend = "take a thicker pin (make.pin_diameter)" + ("" if bought else " or one of metal (make.hinge)")
    told = f"the pin takes up to {force:.1f} N, {side:.1f} N of it on one side"
    shear = side / (math.pi / 4 * make.pin_diameter**2)
    yield _factor(
        "shear of the pin",
        joint,
        None if strength is None else _SHEAR * strength,
        shear,
        f"{told}, {shear / 1e6:.2f} MPa in shear",
        mend,
    )
    span, middle = 2 * outer, 2 * inner
    moment = force * (3 * span**2 - middle**2) / (24 * span)
    bending = 32 * moment / (math.pi * make.pin_diameter**3)
    yield _factor(
        "bending of the pin",
        joint,
        strength,
        bending,
        f"{told}, {bending / 1e6:.1f} MPa in bending between its knuckles",
        mend,
    )
    walls = 2 * make.hinge_wall
    tension = max(force / (middle * walls), side / ((joint.width / 2 - outer) * walls))
    yield _factor(
        "knuckles tear",
        joint,
        stock.strength_across,
        tension,
        f"{told}, {tension / 1e6:.1f} MPa in walls of {1e3 * make.hinge_wall:.1f} mm",
        "take thicker walls (make.hinge_wall) or a wider hinge (make.hinge_width)",
    )


def _stop(joint: JointLayout, stock: Stock, load: StopLoad) -> Check:
    """Pressure on the faces of a stop."""
    pressure = 0.0 if load.force <= 0 else math.inf if load.area == 0 else load.force / load.area
    drive = f' and the drive "{load.drive}" with {100 * load.by_drive:.1f} N cm' if load.drive else ""
    return _factor(
        f"pressure on the {load.stop} stop",
        joint,
        stock.strength,
        pressure,
        f"the tendon presses it with {100 * load.by_tendon:.1f} N cm about the pin{drive}: {load.force:.1f} N on"
        f" {1e6 * load.area:.0f} mm^2, {pressure / 1e6:.2f} MPa",
        "take a wider hinge (make.hinge_width)",
    )


def _strap(parts: PartSet, joint: JointLayout, place: StrapPlace, pull: float) -> Check:
    """Engineering stress in the strap that pulls more."""
    stock = parts.strap_of(place.tendon).stock
    stress = pull / (place.strap.width * place.strap.thickness)
    return _factor(
        "straps tear",
        joint,
        stock.strength,
        stress,
        f"{1e3 * place.strap.width:.1f} x {1e3 * place.strap.thickness:.1f} mm of {stock.name} take {pull:.1f} N,"
        f" {stress / 1e6:.1f} MPa",
        "take a longer tendon of the same stiffness, which is stretched by a smaller share",
    )


def _twist(parts: PartSet, joint: JointLayout, arm: Arm) -> Iterator[Check]:
    """The twist of a bar by the drive that turns it most about itself at its far end; nothing where none does."""
    torque = _torque_about(parts.structure, arm)
    if torque == 0:
        return
    stock = stock_of(joint.make.bar_material)
    known = stock.youngs_modulus is not None
    rigidity = (stock.youngs_modulus or math.nan) / (2 * (1 + _POISSON)) * bar_section(joint.bar_diameter).torsion
    twist = torque * arm.length / rigidity
    held = twist <= _TWIST if known else None
    text = f"{100 * torque:.0f} N cm twist {1e3 * arm.length:.0f} mm of {stock.name}"
    text += f" by {math.degrees(twist):.0f} deg" if known else "; not checked, for no source gives its modulus"
    yield Check(
        name="twist of the bar",
        part=parts.structure.bodies[arm.body].name,
        ok=held,
        value=twist,
        limit=_TWIST,
        unit="rad",
        text=text + ("; take thicker bars (vein.diameter)" if held is False else ""),
    )


def _torque_about(structure: Structure, arm: Arm) -> float:
    """The largest torque of a drive about a bar itself, by the hinges that turn it there, N m."""
    _, frames = built_frames(structure)
    most = 0.0
    for drive in structure.drives:
        torque = 0.0
        for motor, strength in zip(structure.motors, drive.strengths, strict=True):
            for number in motor.hinges if motor.kind == "torque" else ():
                hinge = structure.hinges[number]
                own = abs(float(frames[arm.body] @ hinge.axis @ arm.along))
                if hinge.body == arm.body and own > _ITSELF:
                    torque += strength * own
        most = max(most, abs(torque))
    return most


def euler_load(length: float, section: CrossSection, youngs_modulus: float) -> float:
    """At which a straight column, m long, whose ends turn freely, buckles to its weaker side, N."""
    return math.pi**2 * youngs_modulus * section.least / length**2


@dataclass(frozen=True, kw_only=True, eq=False)
class BucklingColumn:
    """Two bars, rigidly joined where they meet, pressed together along the line between their far ends.

    Attributes:
        lengths: of the two bars, m.
        offsets: of the bars' axes from the line of the load as they are made, at the first end, where they meet, and at
            the other end, m, (3, 2): in the sheet's plane and out of it.
        section: of both.
        youngs_modulus: Pa.
    """

    lengths: tuple[float, float]
    offsets: Array
    section: CrossSection
    youngs_modulus: float

    @property
    def buckles_at(self) -> float:
        """Euler's load of it, were it straight, N."""
        return euler_load(sum(self.lengths), self.section, self.youngs_modulus)

    def bows(self, push: float) -> Array:
        """How far the axes are off the line of a load below `buckles_at`, N, m, (place, 2), first end first.

        With k = sqrt(push / (E I)) the offset v of each bar obeys v'' = -k^2 v. It is given at the ends; where the bars
        meet its slope has the jump that they are made with. So there, with lengths a and b and offsets as made of
        e_0, e_1, e_2: k (V (cot ka + cot kb) - e_0 / sin ka - e_2 / sin kb) = (e_1 - e_0) / a + (e_1 - e_2) / b. Ends
        e_0 = e_1 = e_2 give the secant formula (Timoshenko and Gere 1961, Theory of Elastic Stability, chapter 1).
        """
        (first, middle, last), (a, b) = self.offsets, self.lengths
        seconds = np.array([self.section.in_sheet, self.section.out_of_sheet])
        wave = np.sqrt(push / (self.youngs_modulus * seconds))
        jump = (middle - first) / a + (middle - last) / b
        there = jump / wave + first / np.sin(wave * a) + last / np.sin(wave * b)
        there /= 1 / np.tan(wave * a) + 1 / np.tan(wave * b)

        def between(end: Array, length: float) -> Array:
            at = np.linspace(0.0, length, _PLACES)[:, None]
            bow: Array = (end * np.sin(wave * (length - at)) + there * np.sin(wave * at)) / np.sin(wave * length)
            return bow

        return np.vstack([between(first, a), between(last, b)[::-1]])

    def bears(self, strength: float) -> float:
        """The load at which the largest stress anywhere comes to a strength, Pa, or at which it buckles, N."""

        def missing(push: float) -> float:
            return self.section.stress(push, push * self.bows(push)) - strength

        most = _NEAR * self.buckles_at
        return most if missing(most) <= 0 else float(scipy.optimize.brentq(missing, most * 1e-9, most))
