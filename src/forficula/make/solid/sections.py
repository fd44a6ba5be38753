"""Sections of bars and pegs, which are round with flats: areas, second moments, section moduli."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from forficula.arrays import Array
from forficula.make.hinge.joint import is_level, peg_flats
from forficula.make.hinge.joint_layout import FLAT, Arm, JointLayout

# number of corners of an outline at which stress is evaluated
_CORNERS = 181


@dataclass(frozen=True, kw_only=True)
class CrossSection:
    """Section of a bar with its flat.

    Attributes:
        diameter: m.
        area: m^2.
        centre: height of the centroid above the middle of the circle, towards the flat, m, < 0.
        in_sheet: second moment of area about the normal of the flat, which resists bending in the sheet's plane, m^4.
        out_of_sheet: second moment of area about the line along the flat through the centroid, m^4.
    """

    diameter: float
    area: float
    centre: float
    in_sheet: float
    out_of_sheet: float

    @property
    def least(self) -> float:
        """Smallest second moment of area, m^4."""
        return min(self.in_sheet, self.out_of_sheet)

    @property
    def torsion(self) -> float:
        """Torsion constant, m^4, by Saint-Venant's A^4 / (4 pi^2 I_p), exact for ellipses."""
        return self.area**4 / (4 * math.pi**2 * (self.in_sheet + self.out_of_sheet))

    @cached_property
    def outline(self) -> Array:
        """Outline from one edge of the flat to the other, from the centroid, m, (point, 2): along it, up."""
        half = math.acos(FLAT)
        turns = math.pi / 2 + np.linspace(half, 2 * math.pi - half, _CORNERS)
        around: Array = self.diameter / 2 * np.column_stack([np.cos(turns), np.sin(turns)]) - [0.0, self.centre]
        return around

    def stress(self, push: float, moments: Array) -> float:
        """Return the largest compression or tension in the section, Pa.

        Args:
            push: along the bar, N.
            moments: bending moments in the sheet's plane and out of it, N m, (..., 2).
        """
        shares = np.asarray(moments) / [self.in_sheet, self.out_of_sheet]
        return push / self.area + float(np.abs(shares @ self.outline.T).max())


def bar_section(diameter: float) -> CrossSection:
    """Return the section of a round bar with a flat at `FLAT` of its radius, by the integrals of a circular segment."""
    radius, half = diameter / 2, math.acos(FLAT)
    sine, cosine = math.sin(half), math.cos(half)
    segment = radius**2 * (half - sine * cosine)
    area = math.pi * radius**2 - segment
    # moments of the segment about the circle's middle, perpendicular to the flat and along it
    first = 2 / 3 * radius**3 * sine**3
    square = radius**4 / 4 * (half - sine * cosine + 2 * sine**3 * cosine)
    along = radius**4 / 4 * (half - sine * cosine - 2 / 3 * sine**3 * cosine)
    circle = math.pi * radius**4 / 4
    return CrossSection(
        diameter=diameter,
        area=area,
        centre=-first / area,
        in_sheet=circle - along,
        out_of_sheet=circle - square - first**2 / area,
    )


def peg_modulus(joint: JointLayout, arm: Arm) -> float:
    """Return the section modulus of a peg against a pull along its bar, m^3: of a circle with the flats of the peg.

    The second moment of the part between heights z about the upright through the middle is the integral of
    2/3 (r^2 - z^2)^(3/2), whose closed form is (z (5 r^2 - 2 z^2) sqrt(r^2 - z^2) + 3 r^4 asin(z / r)) / 12.
    """
    radius = joint.make.peg_diameter / 2
    heights = peg_flats(joint) if is_level(joint, arm) else (-radius, radius)
    low, high = (min(radius, max(-radius, height)) for height in heights)

    def integral(z: float) -> float:
        across = radius**2 - z**2
        return (z * (5 * radius**2 - 2 * z**2) * math.sqrt(across) + 3 * radius**4 * math.asin(z / radius)) / 12

    return (integral(high) - integral(low)) / radius
