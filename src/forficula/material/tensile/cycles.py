"""Cycles of a tensile test: loading and unloading, energy loss and residual strain."""

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

BAND = 0.05  # share of the largest travel; the noise of a crosshead is at most a thousandth of the travel
_SLACK_SHARE = 0.01  # share of the peak stress below which the force counts as 0
_SLACK_NOISE = 5.0  # standard deviations of noise below which the force counts as 0: exceeded once in three million
_HANGING_SHARE = 0.05  # lowest share of the strains of an unloading, in which a slack specimen hangs
_FLAT_SHARE = 0.01  # slope, as a share of that of the whole unloading, below which the stress is flat
_FOOT = (0.02, 0.1)  # shares of the peak stress between which the foot of an unloading counts as straight
_FEWEST = 5  # least number of samples for a straight line
_GAUSS = 1.4826  # standard deviation divided by the median absolute deviation of normal noise


@dataclass(frozen=True, kw_only=True, eq=False)
class CycleBranch:
    """The loading or the unloading of a cycle, in the order of time.

    Attributes:
        time: s, shape (sample,).
        strain: engineering strain relative to the specimen's initial length, shape (sample,).
        stress: engineering stress from the load cell, Pa, shape (sample,).
    """

    time: Array
    strain: Array
    stress: Array


@dataclass(frozen=True, kw_only=True, eq=False)
class Cycle:
    """One loading and the following unloading.

    All strains are relative to the specimen's initial length, as in Binder et al. 2025; they are not shifted to the
    strain at which the force begins. `onset_strain`, `slack_strain` and `residual_strain` give that strain.

    Attributes:
        number: number of the cycle in the test, from 1; cycles that were left out are counted.
        loading: samples from the lower to the upper turning point, inclusive.
        unloading: samples from the upper to the lower turning point, inclusive.
    """

    number: Annotated[int, Key("cycle")]
    loading: Annotated[CycleBranch, Written.NEVER]
    unloading: Annotated[CycleBranch, Written.NEVER]

    @property
    def largest_strain(self) -> Annotated[float, Written.ALWAYS]:
        """Strain at the upper turning point."""
        return float(self.loading.strain[-1])

    @property
    def loss(self) -> JoulesPerCubicMetre:
        """Energy lost per volume, J/m3: the integral of stress over strain around the cycle.

        The integral is by the trapezoidal rule. If the cycle does not end where it began, a straight line closes it.
        """
        up, down = self.loading, self.unloading
        closing = (down.stress[-1] + up.stress[0]) / 2 * (up.strain[0] - down.strain[-1])
        return float(np.trapezoid(up.stress, up.strain) + np.trapezoid(down.stress, down.strain) + closing)

    @property
    def secant_modulus(self) -> Pascals:
        """Stress above `zero_stress` divided by strain, both at the largest strain, Pa."""
        return (self._peak_stress - self.zero_stress) / self.largest_strain

    @cached_property
    def zero_stress(self) -> Pascals:
        """Offset of the load cell, Pa: the median of the stress while the specimen hangs slack.

        It is 0 if the specimen never hangs slack, because then an offset cannot be distinguished from a force.
        """
        hanging = self.unloading.stress[self.hanging]
        return float(np.median(hanging)) if len(hanging) else 0.0

    @cached_property
    def hanging(self) -> Flags:
        """Samples of the unloading in which the specimen hangs slack, shape (sample,).

        These are the samples in the lowest 5 % of the unloading's strains, if the stress is flat there, that is, if its
        slope is less than 1 % of that of the whole unloading, or less than three standard errors.
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

        The force counts as 0 below the larger of 1 % of the peak stress and five standard deviations of the noise,
        above `zero_stress`. The strain is nan if the unloading ends under force. For a specimen that never hangs slack
        it is the strain at 1 % of the peak stress.
        """
        down = self.unloading
        carrying = np.flatnonzero(down.stress - self.zero_stress > self._least_force)
        if not len(carrying) or carrying[-1] == len(down.stress) - 1:
            return math.nan
        return float(down.strain[carrying[-1] + 1])

    @property
    def onset_strain(self) -> Annotated[float, Written.ALWAYS]:
        """Strain above which the loading carries force, with the threshold of `slack_strain`.

        It is the slack that remains after the specimen has recovered since the previous unloading; in the first cycle,
        slack from clamping. It is nan if the loading begins under force.
        """
        up = self.loading
        slack = np.flatnonzero(up.stress - self.zero_stress <= self._least_force)
        return float(up.strain[slack[-1]]) if len(slack) and slack[-1] < len(up.stress) - 1 else math.nan

    @property
    def residual_strain(self) -> Annotated[float, Written.ALWAYS]:
        """Strain at which the unloading reaches zero stress, extrapolated by a straight line through its foot.

        This is the definition of residual strain for elastomers in cycles (Qi and Boyce 2005, Mechanics of Materials
        37, 817; Bartolome et al. 2013, Materials and Design 49, 974). The line is fitted by least squares from 2 to 10
        % of the peak stress, so that noise and slack have little influence. Part of the residual strain recovers:
        tension set after a rest (ISO 2285) is smaller. The strain is nan if the unloading does not reach 10 %, or has
        fewer than five samples between 2 and 10 %.
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
        """Standard deviation of the noise of the stress, Pa.

        It is computed from second differences, which are small for smooth curves.
        """
        rough = np.concatenate([np.diff(branch.stress, n=2) for branch in (self.loading, self.unloading)])
        return _GAUSS * float(np.median(np.abs(rough))) / math.sqrt(6) if len(rough) else 0.0

    @property
    def _peak_stress(self) -> float:
        return float(self.loading.stress[-1])

    @property
    def _least_force(self) -> float:
        """Least stress above `zero_stress` that counts as a force, Pa."""
        # the first samples may have an offset, so the peak is taken relative to the lowest samples of the loop
        span = self._peak_stress - float(np.median(np.sort(self.unloading.stress)[:_FEWEST]))
        return max(_SLACK_SHARE * span, _SLACK_NOISE * self.noise)


def find_cycles(test: TensileTest, *, band: float = BAND, drop_first: bool = True) -> tuple[Cycle, ...]:
    """Split a test into cycles at the turning points of its travel.

    A cycle ends where the next loading begins. The last one, without a following loading, counts if its unloading
    covers at least half of its loading.

    Args:
        test: test of one specimen.
        band: hysteresis as a share of the largest travel, 0 to 1: smaller reversals are noise, not turning points.
        drop_first: leave out the first cycle, as Binder et al. 2025 do because of the Mullins effect and first
            yielding.

    Returns:
        The cycles in order, numbered from 1; from 2 if the first is left out.

    Raises:
        InputError: a band out of range, or no cycle is left.
    """
    if not 0 < band < 1:
        raise InputError(f"{test.name}: band: need a share of the largest travel, > 0 and < 1, got {band:g}")
    turns = turning_points(test.extension, band * float(np.ptp(test.extension)))
    ups = [index for index in range(len(turns) - 1) if test.extension[turns[index + 1]] > test.extension[turns[index]]]
    cycles = []
    for number, index in enumerate((index for index in ups if index + 2 < len(turns)), start=1):
        start, top, end = turns[index : index + 3]
        rise, fall = test.extension[top] - test.extension[start], test.extension[top] - test.extension[end]
        if index + 3 < len(turns) or fall >= rise / 2:
            cycles.append(Cycle(number=number, loading=_branch(test, start, top), unloading=_branch(test, top, end)))
    kept = cycles[1:] if drop_first else cycles
    if not kept:
        got = "none" if not cycles else "one, which drop_first leaves out"
        raise InputError(f"{test.name}: need a cycle of loading and unloading, found {got}")
    for cycle in kept:
        if not cycle.loading.stress[-1] > cycle.unloading.stress.min() or not cycle.largest_strain > 0:
            raise InputError(f"{test.name}: cycle {cycle.number}: need a pull, got no force at the largest travel")
    return tuple(kept)


def _branch(test: TensileTest, first: int, last: int) -> CycleBranch:
    rows = slice(first, last + 1)
    return CycleBranch(time=test.time[rows], strain=test.strain[rows], stress=test.stress[rows])
