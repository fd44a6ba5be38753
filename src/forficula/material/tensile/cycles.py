"""The cycles of a tensile test: loading and unloading, and what each cycle loses and leaves."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import Annotated

import numpy as np

from forficula.arrays import Array, Flags
from forficula.errors import InputError
from forficula.material.tensile.tensile_test import TensileTest
from forficula.material.tensile.turning_points import turning_points
from forficula.serial import JoulesPerCubicMetre, Key, Pascals, Written

BAND = 0.05  # share of the largest travel; a crosshead's noise is a thousandth of it or less
_SLACK_SHARE = 0.01  # of the peak stress: less is called no force
_SLACK_NOISE = 5.0  # standard deviations: one sample in three million is further out
_HANGING_SHARE = 0.05  # lowest part of the strains of an unloading, where a slack specimen hangs
_FLAT_SHARE = 0.01  # of the slope of the unloading: less is flat
_FOOT = (0.02, 0.1)  # shares of the peak stress between which the foot of an unloading is taken for straight
_FEWEST = 5  # samples that give a straight line
_GAUSS = 1.4826  # standard deviations in a median absolute deviation of normal noise


@dataclass(frozen=True, kw_only=True, eq=False)
class CycleBranch:
    """One way of a cycle, in the order of time.

    Attributes:
        time: s, shape (sample,).
        strain: engineering strain from the specimen's first length on, shape (sample,).
        stress: engineering stress as the load cell had it, Pa, shape (sample,).
    """

    time: Array
    strain: Array
    stress: Array


@dataclass(frozen=True, kw_only=True, eq=False)
class Cycle:
    """One loading and the unloading after it.

    Every strain counts from the specimen's first length, as in Binder et al. 2025; nothing is shifted to where the
    force begins. Where that is, is said by `onset_strain`, `slack_strain` and `residual_strain`.

    Attributes:
        number: of the cycle in the test, from 1; those that were dropped count.
        loading: from the turn below to the turn above, both in it.
        unloading: from the turn above to the turn below, both in it.
    """

    number: Annotated[int, Key("cycle")]
    loading: Annotated[CycleBranch, Written.NEVER]
    unloading: Annotated[CycleBranch, Written.NEVER]

    @property
    def largest_strain(self) -> Annotated[float, Written.ALWAYS]:
        """Strain at the turn above."""
        return float(self.loading.strain[-1])

    @property
    def loss(self) -> JoulesPerCubicMetre:
        """Energy lost per volume, J/m3: the integral of stress over strain around the cycle.

        Trapezoids between the samples. Where the end is not where the cycle began, a straight line closes the loop.
        """
        up, down = self.loading, self.unloading
        closing = (down.stress[-1] + up.stress[0]) / 2 * (up.strain[0] - down.strain[-1])
        return float(np.trapezoid(up.stress, up.strain) + np.trapezoid(down.stress, down.strain) + closing)

    @property
    def secant_modulus(self) -> Pascals:
        """Stress above `zero_stress` over strain, both at the largest strain, Pa."""
        return (self._peak_stress - self.zero_stress) / self.largest_strain

    @cached_property
    def zero_stress(self) -> Pascals:
        """What the load cell shows while the specimen hangs slack, Pa: its offset.

        The median over the samples that hang slack; 0 where none do, as then nothing tells an offset from a force.
        """
        hanging = self.unloading.stress[self.hanging]
        return float(np.median(hanging)) if len(hanging) else 0.0

    @cached_property
    def hanging(self) -> Flags:
        """Which samples of the unloading show a slack specimen, shape (sample,).

        Those in the lowest 5 % of the unloading's strains, where the stress is flat there: its slope is less than 1 %
        of the slope of the whole unloading, or than three of its standard errors. None elsewhere.
        """
        down = self.unloading
        span = float(np.ptp(down.strain))
        hanging = down.strain <= down.strain.min() + _HANGING_SHARE * span
        strain, stress = down.strain[hanging], down.stress[hanging]
        away = strain - strain.mean()
        if len(strain) < _FEWEST or not away.any():
            return np.zeros_like(hanging)
        slope = float(away @ stress / (away @ away))
        steepest = max(_FLAT_SHARE * float(np.ptp(down.stress)) / span, 3 * self.noise / float(np.sqrt(away @ away)))
        return hanging if abs(slope) < steepest else np.zeros_like(hanging)

    @property
    def slack_strain(self) -> Annotated[float, Written.ALWAYS]:
        """Strain below which the unloading carries no force.

        No force is less than 1 % of the peak stress, or than five standard deviations of the noise where that is more,
        above `zero_stress`. Nan where the unloading ends under force. A specimen that never hangs slack has the strain
        at 1 % of its peak stress here.
        """
        down = self.unloading
        carrying = np.flatnonzero(down.stress - self.zero_stress > self._least_force)
        if not len(carrying) or carrying[-1] == len(down.stress) - 1:
            return math.nan
        return float(down.strain[carrying[-1] + 1])

    @property
    def onset_strain(self) -> Annotated[float, Written.ALWAYS]:
        """Strain above which the loading carries force, by the same threshold as `slack_strain`.

        What is left of the slack after the rest between the two; the first cycle's is slack from clamping. Nan where
        the loading begins under force.
        """
        up = self.loading
        slack = np.flatnonzero(up.stress - self.zero_stress <= self._least_force)
        return float(up.strain[slack[-1]]) if len(slack) and slack[-1] < len(up.stress) - 1 else math.nan

    @property
    def residual_strain(self) -> Annotated[float, Written.ALWAYS]:
        """Strain at which the unloading comes to zero stress, by a straight line through its foot.

        That is how residual strain is defined for elastomers in cycles (Qi and Boyce 2005, Mechanics of Materials 37,
        817; Bartolome et al. 2013, Materials and Design 49, 974). The line is by least squares from 2 to 10 % of the
        peak stress, so that neither noise nor slack decides; a law that curves there gives what its foot points to.
        Part of it recovers: tension set after a rest (ISO 2285) is smaller. Nan where the unloading does not come down
        to 10 %, or has fewer than five samples in between.
        """
        down, peak = self.unloading, self._peak_stress - self.zero_stress
        stress = down.stress - self.zero_stress
        lowest = max(_FOOT[0] * peak, self._least_force)
        above = np.flatnonzero(stress > _FOOT[1] * peak)
        below = above[-1] + 1 if len(above) else len(stress)
        foot = below + np.flatnonzero(stress[below:] > lowest)
        if len(foot) < _FEWEST or not np.ptp(down.strain[foot]) > 0:
            return math.nan
        slope, stress_at_zero = np.polyfit(down.strain[foot], stress[foot], 1)
        return float(-stress_at_zero / slope) if slope > 0 else math.nan

    @cached_property
    def noise(self) -> float:
        """Standard deviation of the stress from sample to sample, Pa.

        From second differences, which a smooth curve has hardly any of.
        """
        rough = np.concatenate([np.diff(branch.stress, n=2) for branch in (self.loading, self.unloading)])
        return _GAUSS * float(np.median(np.abs(rough))) / math.sqrt(6) if len(rough) else 0.0

    @property
    def _peak_stress(self) -> float:
        return float(self.loading.stress[-1])

    @property
    def _least_force(self) -> float:
        """Stress above `zero_stress` from which on it counts as force, Pa."""
        # the first samples may be an offset, so the peak is taken above the lowest of the loop
        span = self._peak_stress - float(np.median(np.sort(self.unloading.stress)[:_FEWEST]))
        return max(_SLACK_SHARE * span, _SLACK_NOISE * self.noise)


def find_cycles(test: TensileTest, *, band: float = BAND, drop_first: bool = True) -> tuple[Cycle, ...]:
    """Cut a test into cycles at the turning points of its travel.

    A cycle ends where the next loading begins; the last one, that nothing follows, counts if it comes down by half or
    more of what it went up.

    Args:
        test: of one specimen.
        band: hysteresis, a share of the largest travel, 0 to 1: a turn back by less is noise, not a turning point.
        drop_first: leave out the first cycle, as Binder et al. 2025 do for the Mullins effect and first yielding.

    Returns:
        The cycles in order, numbered from 1; from 2 where the first is dropped.

    Raises:
        InputError: a band out of range, or no cycle is left.
    """
    if not 0 < band < 1:
        raise InputError(f"{test.name}: band: need a share of the largest travel, > 0 and < 1, got {band:g}")
    turns = turning_points(test.extension, band * float(np.ptp(test.extension)))
    ups = [place for place in range(len(turns) - 1) if test.extension[turns[place + 1]] > test.extension[turns[place]]]
    cycles = []
    for number, place in enumerate((place for place in ups if place + 2 < len(turns)), start=1):
        start, top, end = turns[place : place + 3]
        rise, fall = test.extension[top] - test.extension[start], test.extension[top] - test.extension[end]
        if place + 3 < len(turns) or fall >= rise / 2:
            cycles.append(Cycle(number=number, loading=_branch(test, start, top), unloading=_branch(test, top, end)))
    kept = cycles[1:] if drop_first else cycles
    if not kept:
        found = "none" if not cycles else "one, that drop_first leaves out"
        raise InputError(f"{test.name}: need a cycle of loading and unloading, found {found}")
    for cycle in kept:
        if not cycle.loading.stress[-1] > cycle.unloading.stress.min() or not cycle.largest_strain > 0:
            raise InputError(f"{test.name}: cycle {cycle.number}: need a pull, got no force at the largest travel")
    return tuple(kept)


def _branch(test: TensileTest, first: int, last: int) -> CycleBranch:
    rows = slice(first, last + 1)
    return CycleBranch(time=test.time[rows], strain=test.strain[rows], stress=test.stress[rows])
