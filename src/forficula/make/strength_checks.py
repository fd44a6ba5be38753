"""What is checked of joints by formulas: whether bars, pegs, pins, knuckles, stops and straps bear the tendon's pull.

The pull is the largest that the tendon has within the joint's range, from peg to peg as made. Strengths are the least
that the sources of a material give; what bends a printed peg or tears a knuckle pulls its layers apart.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from forficula.make.check import Check
from forficula.make.joint import is_level, peg_flats, turned
from forficula.make.joint_layout import FLAT, JointLayout
from forficula.make.part import PartSet
from forficula.make.stock import Stock, stock_of
from forficula.make.strap_shape import StrapPlace
from forficula.structure import Structure, built_frames
from forficula.structure.parts import Array

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


@dataclass(frozen=True, kw_only=True)
class Section:
    """Of a bar with its flat: area, m^2, and the least and the polar second moment of area, m^4."""

    area: float
    least: float
    polar: float

    @property
    def torsion(self) -> float:
        """Torsion constant, m^4, by Saint-Venant's A^4 / (4 pi^2 I_p), exact for ellipses."""
        return self.area**4 / (4 * math.pi**2 * self.polar)


def bar_section(diameter: float) -> Section:
    """The section of a round bar with a flat at `FLAT` of its radius, by the integrals of a circular segment."""
    radius, half = diameter / 2, math.acos(FLAT)
    sine, cosine = math.sin(half), math.cos(half)
    gone = radius**2 * (half - sine * cosine)
    area = math.pi * radius**2 - gone
    # of the segment about the circle's middle, across the flat and along it
    first = 2 / 3 * radius**3 * sine**3
    across = radius**4 / 4 * (half - sine * cosine + 2 * sine**3 * cosine)
    along = radius**4 / 4 * (half - sine * cosine - 2 / 3 * sine**3 * cosine)
    circle = math.pi * radius**4 / 4
    bending = (circle - across - first**2 / area, circle - along)
    return Section(area=area, least=min(bending), polar=sum(bending))


def peg_modulus(joint: JointLayout) -> float:
    """Section modulus of a peg against a pull along its bar, m^3: of a circle with the flats that it is cut with.

    The second moment of what is left between heights z about the upright through the middle is the integral of
    2/3 (r^2 - z^2)^(3/2), whose closed form is (z (5 r^2 - 2 z^2) sqrt(r^2 - z^2) + 3 r^4 asin(z / r)) / 12.
    """
    radius = joint.make.peg_diameter / 2
    heights = peg_flats(joint) if is_level(joint, joint.proximal) else (-radius, radius)
    low, high = (min(radius, max(-radius, height)) for height in heights)

    def integral(z: float) -> float:
        across = radius**2 - z**2
        return (z * (5 * radius**2 - 2 * z**2) * math.sqrt(across) + 3 * radius**4 * math.asin(z / radius)) / 12

    return (integral(high) - integral(low)) / radius


def strength_checks(parts: PartSet) -> Iterator[Check]:
    """Check by formulas what the joints of a set of parts bear."""
    for joint in parts.joints:
        place = next((each for each in parts.straps if each.tendon == joint.tendon), None)
        stock = stock_of(joint.make.bar_material)
        if place is not None:
            each = largest_pulls(parts.structure, joint, place)
            pull, longest = float(each.sum()), float(each.max())
            yield _column(joint, place, stock, pull)
            yield _pegs(joint, place, stock, longest)
            yield _pin(joint, stock, pull)
            yield _knuckles(joint, stock, pull)
            yield _stop(joint, place, stock, pull)
            yield _strap(parts, joint, place, longest)
        yield from _twists(parts, joint, stock)


def largest_pulls(structure: Structure, joint: JointLayout, place: StrapPlace) -> Array:
    """The pull of each strap where they pull most together, while one joint goes through its range, N, (strap,).

    Across an oblique hinge the one is longer than the other; each has its share of the tendon's law.
    """
    law, pulls = structure.tendons[place.tendon].law.elastic, []
    for angle in np.linspace(joint.lower, joint.upper, _ANGLES):
        frame, by = turned(joint, float(angle))
        lengths = np.linalg.norm(place.ends[:, 1] @ frame.T + by - place.ends[:, 0], axis=1)
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


def _column(joint: JointLayout, place: StrapPlace, stock: Stock, pull: float) -> Check:
    """Euler's load of the bars between the pegs, as one column whose ends turn freely, straight in the stop."""
    length = float(np.linalg.norm(np.diff(place.ends.mean(axis=0), axis=0)))
    modulus, least = stock.youngs_modulus, bar_section(joint.bar_diameter).least
    bears = None if modulus is None else math.pi**2 * modulus * least / length**2
    shown = "" if bears is None else f"; they buckle at {bears:.0f} N (Euler)"
    return _factor(
        "buckling of the bars",
        joint,
        bears,
        pull,
        f"the tendon presses {1e3 * length:.0f} mm of bars together with {pull:.1f} N{shown}",
        "take thicker bars (vein.diameter), a softer tendon, or pegs nearer to each other",
    )


def _pegs(joint: JointLayout, place: StrapPlace, stock: Stock, pull: float) -> Check:
    """Bending of a peg where it leaves its bar, as a cantilever with the strap on its end that pulls more."""
    lever = max(joint.aside - joint.bar_diameter / 2, place.strap.width / 2)
    stress = pull * lever / peg_modulus(joint)
    return _factor(
        "bending of the pegs",
        joint,
        stock.strength_across,
        stress,
        f"a strap pulls {pull:.1f} N at {1e3 * lever:.1f} mm from the bar, {stress / 1e6:.1f} MPa",
        "take thicker pegs (make.peg_diameter), a narrower hinge (make.hinge_width) or a softer tendon",
    )


def _pin(joint: JointLayout, stock: Stock, pull: float) -> Check:
    """Shear of the pin at both sides of the middle knuckle; off the stop it takes all of the pull."""
    make = joint.make
    strength = stock_of(make.pin_material).strength if make.hinge == "pin" else stock.strength_across
    stress = pull / (2 * math.pi / 4 * make.pin_diameter**2)
    return _factor(
        "shear of the pin",
        joint,
        None if strength is None else _SHEAR * strength,
        stress,
        f"off the stop the pin takes all of {pull:.1f} N in two sections, {stress / 1e6:.2f} MPa",
        "take a thicker pin (make.pin_diameter) or one of metal (make.pin_material)",
    )


def _knuckles(joint: JointLayout, stock: Stock, pull: float) -> Check:
    """Tension in the walls of the knuckle that has the least of them."""
    inner, outer = joint.side_widths
    wide = min(2 * inner, 2 * (joint.width / 2 - outer))
    stress = pull / (wide * 2 * joint.make.hinge_wall)
    return _factor(
        "knuckles tear",
        joint,
        stock.strength_across,
        stress,
        f"walls of {1e3 * joint.make.hinge_wall:.1f} mm on {1e3 * wide:.1f} mm of knuckles take {pull:.1f} N,"
        f" {stress / 1e6:.1f} MPa",
        "take thicker walls (make.hinge_wall) or a wider hinge (make.hinge_width)",
    )


def _stop(joint: JointLayout, place: StrapPlace, stock: Stock, pull: float) -> Check:
    """Pressure on the faces of the overbend stop, by the moments about the pin."""
    low, high = joint.knuckle_diameter / 2 + joint.make.clearance, joint.top
    start, end = place.ends.mean(axis=0) - joint.origin
    share = float(start @ joint.frame[:, 0]) / float((start - end) @ joint.frame[:, 0])
    height = float((start + share * (end - start)) @ joint.frame[:, 2])
    force = pull * max(0.0, height) / ((low + high) / 2)
    area = (high - low) * joint.width
    taken = max(0.0, 1 - abs(pull - force) / pull) if pull > 0 else 0.0
    return _factor(
        "pressure on the overbend stop",
        joint,
        stock.strength,
        force / area,
        f"the tendon passes {1e3 * height:.1f} mm over the pin and presses {force:.1f} N on the stop's"
        f" {1e6 * area:.0f} mm^2, {force / area / 1e6:.2f} MPa; the pin is spared {100 * taken:.0f} % of its pull",
        "take a wider hinge (make.hinge_width)",
    )


def _strap(parts: PartSet, joint: JointLayout, place: StrapPlace, pull: float) -> Check:
    """Engineering stress in the strap that pulls more."""
    stock = next(part.stock for part in parts.parts if part.kind == "strap")
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


def _twists(parts: PartSet, joint: JointLayout, stock: Stock) -> Iterator[Check]:
    """The twist of bars by the drives that turn them about themselves at their far ends."""
    structure, section = parts.structure, bar_section(joint.bar_diameter)
    _, frames = built_frames(structure)
    for arm in (joint.proximal, joint.distal):
        torque = 0.0
        for drive in structure.drives:
            along = 0.0
            for motor, share in zip(structure.motors, drive.shares, strict=True):
                for number in motor.hinges:
                    hinge = structure.hinges[number]
                    own = abs(float(frames[arm.body] @ hinge.axis @ arm.along))
                    if hinge.body == arm.body and own > _ITSELF:
                        along += drive.strength * share * own
            torque = max(torque, abs(along))
        if torque == 0 or stock.youngs_modulus is None:
            continue
        rigidity = stock.youngs_modulus / (2 * (1 + _POISSON)) * section.torsion
        twist = torque * arm.length / rigidity
        yield Check(
            name="twist of the bar",
            part=structure.bodies[arm.body].name,
            ok=twist <= _TWIST,
            value=twist,
            limit=_TWIST,
            unit="rad",
            text=f"{100 * torque:.0f} N cm twist {1e3 * arm.length:.0f} mm of {stock.name} by"
            f" {math.degrees(twist):.0f} deg" + ("" if twist <= _TWIST else "; take thicker bars (vein.diameter)"),
        )
