"""Comparison of a form of a law with measured histories: fitted stress and its sensitivity to every value."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
import scipy
from numpy.typing import NDArray

from forficula.arrays import Array, Flags
from forficula.material.law.law_form import LawForm
from forficula.material.law.material_law import MaxwellBranch
from forficula.material.law.softening import Triple, spring_energy
from forficula.material.law.stress import branch_stress, set_history
from forficula.material.tensile.strain_history import StrainHistory, rate_range, strain_rate

MOST_ROWS = 10_000
MOST_POINTS = 2000
_REMEMBERED = 32  # number of cached Maxwell branches
_CLOSE = 0.1  # quantile of the time between samples: a machine may record faster while the force changes
_LOG = 300.0  # largest logarithm: larger values make no sense, and exp may overflow
_STEP = 1e-6  # step of finite differences of a share, of a logarithm, or relative to the largest strain


@dataclass(frozen=True, kw_only=True, eq=False)
class FitProblem:
    """Concatenated measured histories, and the blocks of rows whose means are compared with a model.

    The model is computed for every row, and means over at most `MOST_POINTS` blocks of neighbouring rows are compared.
    Stress changes little within a block, so the means lose little information, and they reduce noise.

    Attributes:
        histories: measured histories.
        strain: strain of all histories, concatenated, shape (rows,).
        rate: strain rate, 1/s, shape (rows,).
        starts: first row of each block, shape (blocks,).
        counts: number of rows in each block, shape (blocks,).
        compared: whether each block is compared, shape (blocks,); the arrays below contain only compared blocks.
        stress: mean of each block minus the known zero of the force, Pa, shape (blocks,).
        specimen: index of the history of each block, shape (blocks,).
        time: mean time of each block relative to the middle of its history, divided by half of its duration, shape
            (blocks,).
        largest_strain: largest strain of all measured rows.
        rates: lowest and highest strain rate of the histories, 1/s, see `rate_range`.
        remembered: cached stresses of Maxwell branches by relaxation time.
    """

    histories: tuple[StrainHistory, ...]
    strain: Array
    rate: Array
    starts: NDArray[np.int64]
    counts: Array
    compared: Flags
    stress: Array
    specimen: NDArray[np.int64]
    time: Array
    largest_strain: float
    rates: tuple[float, float]
    remembered: dict[float, Array] = field(default_factory=dict)

    @cached_property
    def unknown_zeros(self) -> NDArray[np.int64]:
        """Indices of the histories whose zero of the force must be fitted."""
        unknown = [index for index, history in enumerate(self.histories) if history.offset is None]
        return np.array(unknown, dtype=np.int64)

    @cached_property
    def membership(self) -> Array:
        """1 if a block belongs to a history, otherwise 0, shape (blocks, histories)."""
        return np.asarray(self.specimen[:, None] == np.arange(len(self.histories)), dtype=np.float64)

    @cached_property
    def peak(self) -> float:
        """Largest mean stress of a block, Pa."""
        return float(np.max(np.abs(self.stress)))

    @cached_property
    def times(self) -> tuple[float, float]:
        """Shortest and longest observable relaxation time, s: two sampling intervals, and the longest history."""
        steps = [float(np.quantile(np.diff(history.time), _CLOSE)) for history in self.histories]
        return 2 * min(steps), max(float(history.time[-1] - history.time[0]) for history in self.histories)

    def block(self, values: Array) -> Array:
        """Compute means of rows over compared blocks; shape (rows, ...) becomes (blocks, ...)."""
        sums = np.add.reduceat(values, self.starts, axis=0)
        means = sums / self.counts.reshape(-1, *([1] * (values.ndim - 1)))
        return np.asarray(means[self.compared])

    def branch(self, time: float) -> Array:
        """Compute the stress of a Maxwell branch with modulus 1, shape (rows,)."""
        if time not in self.remembered:
            unit = MaxwellBranch(modulus=1.0, time=time)
            if len(self.remembered) >= _REMEMBERED:
                self.remembered.pop(next(iter(self.remembered)))
            rows = np.concatenate([history.time for history in self.histories])
            starts = np.cumsum([len(history.time) for history in self.histories])[:-1]
            self.remembered[time] = branch_stress(unit, rows, self.strain, starts)
        return self.remembered[time]

    def set_strain(self, residual: float, yield_strain: float | None) -> Array:
        """Compute the strain at which the spring becomes slack, shape (rows,)."""
        return np.concatenate([set_history(history.strain, residual, yield_strain) for history in self.histories])


def problem_of(histories: Sequence[StrainHistory]) -> FitProblem:
    """Concatenate histories and define the blocks.

    If there are more rows than `MOST_ROWS`, they are replaced by means of neighbouring rows, whose strain agrees with
    the history except for a few rows at turning points.
    """
    size = -(-sum(len(history.time) for history in histories) // MOST_ROWS)
    largest = max(float(np.max(history.strain)) for history in histories)
    lowest, highest = zip(*map(rate_range, histories), strict=True)
    histories = [_thinned(history, size) for history in histories]
    rows = sum(len(history.time) for history in histories)
    size = -(-rows // MOST_POINTS)
    blocks = [np.arange(0, len(history.time), size) for history in histories]
    begins = np.cumsum([0, *(len(history.time) for history in histories)])
    starts = np.concatenate([begin + block for begin, block in zip(begins[:-1], blocks, strict=True)])
    counts = np.diff([*starts, rows]).astype(np.float64)
    compared = np.concatenate([block >= history.first for history, block in zip(histories, blocks, strict=True)])

    def means(values: Sequence[Array]) -> Array:
        block_means = np.add.reduceat(np.concatenate(values), starts) / counts
        return np.asarray(block_means[compared])

    return FitProblem(
        histories=tuple(histories),
        strain=np.concatenate([history.strain for history in histories]),
        rate=np.concatenate([strain_rate(history) for history in histories]),
        starts=starts,
        counts=counts,
        compared=compared,
        stress=means([history.stress - history.zero for history in histories]),
        specimen=np.repeat(np.arange(len(histories)), [len(block) for block in blocks])[compared],
        time=means([_from_middle(history.time) for history in histories]),
        largest_strain=largest,
        rates=(min(lowest), max(highest)),
    )


def _from_middle(time: Array) -> Array:
    return np.asarray((time - (time[0] + time[-1]) / 2) / ((time[-1] - time[0]) / 2))


def _thinned(history: StrainHistory, size: int) -> StrainHistory:
    """Replace groups of `size` neighbouring rows by their means; an incomplete group at the end is dropped."""
    if size == 1 or len(history.time) < 2 * size:
        return history
    kept = len(history.time) // size * size

    def mean(values: Array) -> Array:
        return np.asarray(values[:kept].reshape(-1, size).mean(axis=1))

    return replace(
        history,
        time=mean(history.time),
        strain=mean(history.strain),
        stress=mean(history.stress),
        first=history.first // size,
    )


@dataclass(frozen=True, kw_only=True, eq=False)
class LawModel:
    """A form of a law as a model of measured histories.

    Its values are, in this order: the values of `LawForm.keys`; the logarithms of the specimens' amplitudes except the
    last, which makes their sum 0; and the baseline, which has, for each history with an unknown zero of the force, an
    offset and, if it has two terms, a drift, both in Pa. Relaxation times and `softening.m` are logarithms, and
    `softening.r` is 1/r.

    Specimens of a material differ in amplitude, because their areas are known to some per cent only and the material
    varies. Without amplitudes, these differences would be a misfit common to all rows that hides all finer effects. So
    the law is that of the specimens' geometric mean, and each specimen multiplies its stress by an amplitude.

    Attributes:
        form: form of the law.
        problem: the histories.
        baseline: number of terms of the baseline of each history: 0, 1 (offset) or 2 (offset and drift).
    """

    form: LawForm
    problem: FitProblem
    baseline: int

    @cached_property
    def baseline_columns(self) -> Array:
        """Derivatives by the values of the baseline, shape (blocks, histories with an unknown zero times terms)."""
        offsets = self.problem.membership[:, self.problem.unknown_zeros]
        terms = [offsets, offsets * self.problem.time[:, None]][: self.baseline]
        return np.concatenate(terms, axis=1) if terms else np.empty((len(offsets), 0))

    def parts(self, values: Array) -> tuple[Array, Array, Array]:
        """Split values into those of the law, logarithms of all amplitudes, shape (histories,), and the baseline."""
        count, others = len(self.form.keys), len(self.problem.histories) - 1
        law_values, free, zeros = np.split(values, [count, count + others])
        return law_values, self._contrasts @ free, zeros

    @cached_property
    def _contrasts(self) -> Array:
        """Derivatives of the logarithms of all amplitudes by the free ones, shape (histories, histories - 1)."""
        others = len(self.problem.histories) - 1
        return np.concatenate([np.eye(others), np.full((1, others), -1.0)])

    def fitted(self, values: Array) -> Array:
        """Compute the stress of each block, Pa, shape (blocks,); a specimen that would push is slack."""
        law_values, logarithms, zeros = self.parts(values)
        pull = self.problem.block(np.maximum(self.total(law_values), 0.0))
        return np.asarray(pull * self._amplitudes(logarithms) + self.baseline_columns @ zeros)

    def _amplitudes(self, logarithms: Array) -> Array:
        """Return the amplitude of the specimen of each block, shape (blocks,)."""
        return np.asarray(np.exp(np.clip(logarithms, -_LOG, _LOG))[self.problem.specimen])

    def sensitivity(self, values: Array) -> Array:
        """Compute the derivatives of `fitted`, shape (blocks, values)."""
        count, proportional = len(self.form.keys), len(self.form.linear_keys)
        law_values, logarithms, _ = self.parts(values)
        columns = np.empty((len(self.problem.strain), count))
        # with softening, the stress depends on the moduli also through the energy, so it is not linear in them
        if self.form.softening == "none":
            done = proportional
            columns[:, :done] = self.columns(law_values[proportional:])
            total = columns[:, :done] @ law_values[:done]
        else:
            done, total = 0, self.total(law_values)
        for index in range(done, count):
            moved, step = law_values.copy(), _STEP * self._scale(index)
            moved[index] += step
            columns[:, index] = (self.total(moved) - total) / step
        columns[total <= 0] = 0.0
        amplitudes = self._amplitudes(logarithms)[:, None]
        pull = self.problem.block(np.maximum(total, 0.0))[:, None] * (self.problem.membership @ self._contrasts)
        return np.concatenate(
            [amplitudes * self.problem.block(columns), amplitudes * pull, self.baseline_columns], axis=1
        )

    def total(self, values: Array) -> Array:
        """Compute the stress of spring, damper and branches in each row from the law's values, Pa, shape (rows,)."""
        proportional, order = len(self.form.linear_keys), self.form.order
        columns, linear = self.columns(values[proportional:]), values[:proportional]
        if self.form.softening == "none":
            return np.asarray(columns @ linear)
        first, second, third = (*linear[:order], 0.0, 0.0)[:3]
        share = self.softening_share((first, second, third), columns[:, 0], values[proportional:])
        return np.asarray(share * (columns[:, :order] @ linear[:order]) + columns[:, order:] @ linear[order:])

    def columns(self, others: Array) -> Array:
        """Compute the stress per unit of each linear value, shape (rows, linear values)."""
        form, problem = self.form, self.problem
        extended = np.maximum(problem.strain - self._set_strain(others), 0.0)
        rate = problem.rate
        columns = [extended**power for power in range(1, form.order + 1)]
        columns += [rate * np.abs(rate) ** power for power in range(form.damper)]
        shortest, longest = problem.times
        for logarithm in others[: form.branches]:
            columns.append(problem.branch(float(np.exp(np.clip(logarithm, *np.log([shortest / 20, longest * 20]))))))
        return np.stack(columns, axis=1)

    def softening_share(self, moduli: Triple, extended: Array, others: Array) -> Array:
        """Compute Ogden and Roxburgh's eta in each row, shape (rows,), from the strain of the spring, shape (rows,)."""
        energy = spring_energy(moduli, extended)
        ends = np.cumsum([len(history.time) for history in self.problem.histories])[:-1]
        largest = np.concatenate([np.maximum.accumulate(part) for part in np.split(energy, ends)])
        lost, logarithm = others[-3:-1] if self.form.softening == "m and beta" else others[-2:]
        beta = others[-1] if self.form.softening == "m and beta" else 0.0
        least = 1e-9 * float(np.max(np.abs(energy))) + np.finfo(float).tiny
        width = np.maximum(np.exp(np.clip(logarithm, -_LOG, _LOG)) + beta * largest, least)
        return np.asarray(1 - lost * scipy.special.erf((largest - energy) / width))

    def _set_strain(self, others: Array) -> Array:
        at = float(others[self.form.branches]) if self.form.permanent_set != "none" else 0.0
        if self.form.permanent_set == "yield":
            return self.problem.set_strain(0.0, at)
        return self.problem.set_strain(at, None)

    def _scale(self, index: int) -> float:
        """Return the scale of a value, for the step of a finite difference."""
        key = self.form.keys[index]
        if key.startswith("modulus"):
            return float(self.problem.peak / self.problem.largest_strain ** (index + 1))
        return self.problem.largest_strain if key.endswith("strain") else 1.0
