"""Bars between two pegs as a column that a tendon presses together: how far a bent one bows, and what it bears."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import scipy

from forficula.arrays import Array
from forficula.make.sections import Section

# along each of the two bars
_PLACES = 33
# of Euler's load: as near to it as loads are tried
_NEAR = 1 - 1e-6


def euler_load(length: float, section: Section, youngs_modulus: float) -> float:
    """At which a straight column, m long, whose ends turn freely, buckles to its weaker side, N."""
    return math.pi**2 * youngs_modulus * section.least / length**2


@dataclass(frozen=True, kw_only=True, eq=False)
class Column:
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
    section: Section
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
