"""Strength checks of joints by formulas: bars, pegs, pins, knuckles, stops and straps.

The loads are the tendon's largest pull within the joint's range, from peg to peg as made, and at stops also the drives
of the design. They are static: impact and a tendon's damping are not included. Strengths are the least that the sources
of a material give. For pegs, knuckles and printed axles it is the strength across layers, the lower one, whatever their
orientation.
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

# [chosen] required safety factor
SAFE = 2.0
# [chosen] rad, allowed twist of a bar by a drive: a sixth of the right angle through which veins turn
_TWIST = math.radians(15.0)
# cos of the largest angle between a hinge and a bar for which the hinge twists the bar
_ITSELF = math.cos(math.radians(30.0))
# Poisson's ratio of polymers, 0.35 to 0.4
_POISSON = 0.4
# shear strength / tensile strength (von Mises)
_SHEAR = 1 / math.sqrt(3)
_ANGLES = 61
# number of points along each of the two bars
_PLACES = 33
# largest load that is tried, as a fraction of Euler's load
_NEAR = 1 - 1e-6


def strength_checks(parts: PartSet) -> Iterator[Check]:
    """Check the strength of the joints of a set of parts by formulas."""
    for joint in parts.joints:
        place = next((strap for strap in parts.straps if strap.tendon == joint.tendon), None)
        if place is None:
            continue
        stock = stock_of(joint.make.bar_material)
        pulls = largest_pulls(parts.structure, joint, place)
        pull, longest = float(pulls.sum()), float(pulls.max())
        stops = [stop_load(parts.structure, joint, place, stop) for stop in ("overbend", "fold")]
        yield from _column(joint, place, stock, pull)
        yield from _pegs(joint, place, stock, longest)
        yield from _feet(joint, stock, pull)
        yield from _pin(joint, stock, pull, stops)
        yield from (_stop(joint, stock, load) for load in stops)
        yield _strap(parts, joint, place, longest)
    arms = [(joint, arm) for joint in parts.joints for arm in (joint.proximal, joint.distal)]
    for body in dict.fromkeys(arm.body for _, arm in arms):
        yield from _twist(parts, *next(pair for pair in arms if pair[1].body == body))


def largest_pulls(structure: Structure, joint: JointLayout, place: StrapPlace) -> Array:
    """Return the pull of each strap at the angle at which their total pull is largest, for one joint, N, (strap,).

    Across an oblique hinge the straps have different lengths. Each has its share of the tendon's law.
    """
    law, pulls = structure.tendons[place.tendon].law.elastic, []
    for angle in np.linspace(joint.lower, joint.upper, _ANGLES):
        lengths = np.linalg.norm(turned(joint, float(angle)).of(place.ends[:, 1]) - place.ends[:, 0], axis=1)
        pulls.append(law.force(lengths) / place.strap.count)
    most: Array = max(pulls, key=lambda pull: float(pull.sum()))
    return most


def _factor(name: str, joint: JointLayout, bears: float | None, load: float, text: str, mend: str) -> Check:
    """Return a check of a strength / a load in the same unit. It is not done if the strength is unknown."""
    factor = math.inf if bears is None or load <= 0 else bears / load
    ok = None if bears is None else factor >= SAFE
    if bears is None:
        text += "; not checked, because no source gives the strength of its material"
    return Check(
        name=name,
        part=joint.name,
        ok=ok,
        value=math.nan if bears is None else factor,
        limit=SAFE,
        unit="",
        text=text + (f"; {mend}" if ok is False else ""),
    )


def column_of(joint: JointLayout, place: StrapPlace, youngs_modulus: float) -> BucklingColumn:
    """Return the bars of a joint between its pegs as a column, with the joint at its overbend stop.

    There the bars are rigidly connected: in the sheet's plane by their knuckles, and out of it by the stop.
    """
    opened = turned(joint, joint.upper)
    start, end = place.ends[:, 0].mean(axis=0), opened.of(place.ends[:, 1].mean(axis=0))
    direction = (end - start) / np.linalg.norm(end - start)
    in_sheet = np.cross(joint.frame[:, 2], direction) / np.linalg.norm(np.cross(joint.frame[:, 2], direction))
    rise = joint.standoff * joint.frame[:, 2]
    inner, outer = joint.proximal, joint.distal
    # points on the bars' axes
    points = np.array(
        [
            joint.origin + rise + inner.peg * inner.along,
            joint.origin + rise,
            opened.of(joint.origin + rise + outer.peg * outer.along),
        ]
    )
    offsets = points - start
    return BucklingColumn(
        lengths=(float((offsets[1] - offsets[0]) @ direction), float((offsets[2] - offsets[1]) @ direction)),
        offsets=offsets @ np.column_stack([in_sheet, np.cross(direction, in_sheet)]),
        section=bar_section(joint.bar_diameter),
        youngs_modulus=youngs_modulus,
    )


def _column(joint: JointLayout, place: StrapPlace, stock: Stock, pull: float) -> Iterator[Check]:
    """Check the bars between the pegs as a column: Euler's load of a straight one, and the strength of the bent one."""
    modulus, strength = stock.youngs_modulus, stock.strength
    length = float(np.linalg.norm(np.diff(place.ends.mean(axis=0), axis=0)))
    buckles = None if modulus is None else euler_load(length, bar_section(joint.bar_diameter), modulus)
    advice = "choose thicker bars (vein.diameter), a softer tendon, or pegs nearer to each other"
    shown = "" if buckles is None else f"; they buckle at {buckles:.0f} N (Euler)"
    yield _factor(
        "buckling of the bars",
        joint,
        buckles,
        pull,
        f"the tendon compresses {1e3 * length:.0f} mm of bars with {pull:.1f} N{shown}",
        advice,
    )
    # a tendon across several hinges has more than two bars between its pegs
    if not (joint.proximal.peg and joint.distal.peg):
        return
    column = column_of(joint, place, modulus or math.nan)
    bears = None if modulus is None or strength is None else column.bears(strength)
    beside = float(np.linalg.norm(column.offsets, axis=1).max())
    shown = "" if bears is None else f"; with this eccentricity, they withstand {bears:.0f} N"
    yield _factor(
        "bending of the bars",
        joint,
        bears,
        pull,
        f"the line of the tendon is up to {1e3 * beside:.1f} mm away from the bars' axes{shown}",
        advice,
    )


def _pegs(joint: JointLayout, place: StrapPlace, stock: Stock, pull: float) -> Iterator[Check]:
    """Check a peg in bending at its bar, as a cantilever with the strap of larger pull at its end."""
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
        "choose thicker pegs (make.peg_diameter), a narrower hinge (make.hinge_width) or a softer tendon",
    )


def _feet(joint: JointLayout, stock: Stock, pull: float) -> Iterator[Check]:
    """Check the foot of a peg off its bar in bending: a block as wide as the bar and as long as the peg is thick."""
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
        f"{pull:.1f} N act at {1e3 * off:.1f} mm from the bar's axis, {stress / 1e6:.1f} MPa",
        "choose pegs nearer to the height of the bars (make.anchors) or thicker ones (make.peg_diameter)",
    )


def _pin(joint: JointLayout, stock: Stock, pull: float, stops: list[StopLoad]) -> Iterator[Check]:
    """Check shear and bending of the pin, and tension in the walls of its knuckles, by the largest force on it.

    Away from the stops the force is the whole pull; at a stop, it is the resultant of pull and stop force if this is
    larger. A couple across the hinge's axis loads one outer knuckle more. The pin is a beam held in the outer knuckles:
    with N spread evenly over the middle c of a span s, its largest moment is there, N (3 s^2 - c^2) / (24 s).
    """
    make = joint.make
    inner, outer = joint.side_widths
    force = max([pull, *(stop.on_pin for stop in stops)])
    couple = max(stop.couple for stop in stops)
    side = force / 2 + couple / (outer + joint.width / 2)
    bought = make.hinge == "pin"
    strength = stock_of(make.pin_material).strength if bought else stock.strength_across
    advice = "choose a thicker pin (make.pin_diameter)" + ("" if bought else " or one made of metal (make.hinge)")
    load = f"the pin carries up to {force:.1f} N, {side:.1f} N of it on one side"
    shear = side / (math.pi / 4 * make.pin_diameter**2)
    yield _factor(
        "shear of the pin",
        joint,
        None if strength is None else _SHEAR * strength,
        shear,
        f"{load}, {shear / 1e6:.2f} MPa in shear",
        advice,
    )
    span, middle = 2 * outer, 2 * inner
    moment = force * (3 * span**2 - middle**2) / (24 * span)
    bending = 32 * moment / (math.pi * make.pin_diameter**3)
    yield _factor(
        "bending of the pin",
        joint,
        strength,
        bending,
        f"{load}, {bending / 1e6:.1f} MPa in bending between its knuckles",
        advice,
    )
    walls = 2 * make.hinge_wall
    tension = max(force / (middle * walls), side / ((joint.width / 2 - outer) * walls))
    yield _factor(
        "knuckles tear",
        joint,
        stock.strength_across,
        tension,
        f"{load}, {tension / 1e6:.1f} MPa in walls of {1e3 * make.hinge_wall:.1f} mm",
        "choose thicker walls (make.hinge_wall) or a wider hinge (make.hinge_width)",
    )


def _stop(joint: JointLayout, stock: Stock, load: StopLoad) -> Check:
    """Check the pressure on the faces of a stop."""
    pressure = 0.0 if load.force <= 0 else math.inf if load.area == 0 else load.force / load.area
    drive = f' and the drive "{load.drive}" with {100 * load.by_drive:.1f} N cm' if load.drive else ""
    return _factor(
        f"pressure on the {load.stop} stop",
        joint,
        stock.strength,
        pressure,
        f"the tendon presses it with {100 * load.by_tendon:.1f} N cm about the pin{drive}: {load.force:.1f} N on"
        f" {1e6 * load.area:.0f} mm^2, {pressure / 1e6:.2f} MPa",
        "choose a wider hinge (make.hinge_width)",
    )


def _strap(parts: PartSet, joint: JointLayout, place: StrapPlace, pull: float) -> Check:
    """Check the engineering stress in the strap of larger pull."""
    stock = parts.strap_of(place.tendon).stock
    stress = pull / (place.strap.width * place.strap.thickness)
    return _factor(
        "straps tear",
        joint,
        stock.strength,
        stress,
        f"{1e3 * place.strap.width:.1f} x {1e3 * place.strap.thickness:.1f} mm of {stock.name} carry {pull:.1f} N,"
        f" {stress / 1e6:.1f} MPa",
        "choose a longer tendon of the same stiffness, whose strain is smaller",
    )


def _twist(parts: PartSet, joint: JointLayout, arm: Arm) -> Iterator[Check]:
    """Check the twist of a bar by the drive with the largest torque about it at its far end; nothing without one."""
    torque = _torque_about(parts.structure, arm)
    if torque == 0:
        return
    stock = stock_of(joint.make.bar_material)
    known = stock.youngs_modulus is not None
    rigidity = (stock.youngs_modulus or math.nan) / (2 * (1 + _POISSON)) * bar_section(joint.bar_diameter).torsion
    twist = torque * arm.length / rigidity
    ok = twist <= _TWIST if known else None
    text = f"{100 * torque:.0f} N cm twist {1e3 * arm.length:.0f} mm of {stock.name}"
    text += f" by {math.degrees(twist):.0f} deg" if known else "; not checked, because no source gives its modulus"
    yield Check(
        name="twist of the bar",
        part=parts.structure.bodies[arm.body].name,
        ok=ok,
        value=twist,
        limit=_TWIST,
        unit="rad",
        text=text + ("; choose thicker bars (vein.diameter)" if ok is False else ""),
    )


def _torque_about(structure: Structure, arm: Arm) -> float:
    """Return the largest torque of a drive about a bar's own axis, by the hinges that turn it, N m."""
    _, frames = built_frames(structure)
    most = 0.0
    for drive in structure.drives:
        torque = 0.0
        for motor, strength in zip(structure.motors, drive.strengths, strict=True):
            for number in motor.hinges if motor.kind == "torque" else ():
                hinge = structure.hinges[number]
                along_bar = abs(float(frames[arm.body] @ hinge.axis @ arm.along))
                if hinge.body == arm.body and along_bar > _ITSELF:
                    torque += strength * along_bar
        most = max(most, abs(torque))
    return most


def euler_load(length: float, section: CrossSection, youngs_modulus: float) -> float:
    """Return the buckling load of a straight column, m long, with hinged ends, about its weaker axis, N."""
    return math.pi**2 * youngs_modulus * section.least / length**2


@dataclass(frozen=True, kw_only=True, eq=False)
class BucklingColumn:
    """Two rigidly connected bars, compressed along the line between their far ends.

    Attributes:
        lengths: lengths of the two bars, m.
        offsets: distances of the bars' axes from the load's line, unloaded, at the first end, at the connection, and
            at the other end, m, (3, 2): in the sheet's plane and out of it.
        section: cross-section of both bars.
        youngs_modulus: Pa.
    """

    lengths: tuple[float, float]
    offsets: Array
    section: CrossSection
    youngs_modulus: float

    @property
    def buckles_at(self) -> float:
        """Euler's load of a straight column of the same length, N."""
        return euler_load(sum(self.lengths), self.section, self.youngs_modulus)

    def bows(self, push: float) -> Array:
        """Return distances of the axes from the line of a load, N, below `buckles_at`, m, (point, 2), first end first.

        With k = sqrt(push / (E I)) the offset v of each bar obeys v'' = -k^2 v. It is given at the ends. At the
        connection, its slope has the same jump as in the unloaded state. The offset V there follows, with lengths a and
        b and unloaded offsets e_0, e_1, e_2, from k (V (cot ka + cot kb) - e_0 / sin ka - e_2 / sin kb) = (e_1 - e_0) /
        a + (e_1 - e_2) / b. Equal offsets e_0 = e_1 = e_2 give the secant formula (Timoshenko and Gere 1961, Theory of
        Elastic Stability, chapter 1).
        """
        (first, middle, last), (a, b) = self.offsets, self.lengths
        seconds = np.array([self.section.in_sheet, self.section.out_of_sheet])
        wave = np.sqrt(push / (self.youngs_modulus * seconds))
        jump = (middle - first) / a + (middle - last) / b
        at_joint = jump / wave + first / np.sin(wave * a) + last / np.sin(wave * b)
        at_joint /= 1 / np.tan(wave * a) + 1 / np.tan(wave * b)

        def between(end: Array, length: float) -> Array:
            at = np.linspace(0.0, length, _PLACES)[:, None]
            bow: Array = (end * np.sin(wave * (length - at)) + at_joint * np.sin(wave * at)) / np.sin(wave * length)
            return bow

        return np.vstack([between(first, a), between(last, b)[::-1]])

    def bears(self, strength: float) -> float:
        """Return the load at which the largest stress reaches a strength, Pa, or at which the column buckles, N."""

        def missing(push: float) -> float:
            return self.section.stress(push, push * self.bows(push)) - strength

        most = _NEAR * self.buckles_at
        return most if missing(most) <= 0 else float(scipy.optimize.brentq(missing, most * 1e-9, most))
