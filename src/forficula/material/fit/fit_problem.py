"""A form of a law held against measured histories: fitted stress and its sensitivity to every value."""

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
_REMEMBERED = 32
_CLOSE = 0.1  # share of the samples: a machine may take more while the force changes
_LOG = 300.0  # beyond which no value of a fit makes sense, and exp may overflow
_STEP = 1e-6  # of finite differences: of a share, a logarithm or the largest strain


@dataclass(frozen=True, kw_only=True, eq=False)
class FitProblem:
    """Measured histories, end to end, and the blocks of rows whose means are compared.

    The model runs over every row; the means of neighbouring rows are compared, as many as make `MOST_POINTS` blocks.
    Taking means loses little, since stress changes little within a block, and makes noise smaller.

    Attributes:
        histories: as measured.
        strain: shape (rows,), of all histories end to end.
        rate: 1/s, shape (rows,).
        starts: first row of each block, shape (blocks,).
        counts: rows in each block, shape (blocks,).
        compared: whether a block counts, shape (blocks,); below, only those that do are blocks.
        stress: mean of each block less what is known of the force's zero, Pa, shape (blocks,).
        specimen: index of the history of each block, shape (blocks,).
        time: mean of each block less the middle of its history, in halves of its duration, shape (blocks,).
        largest_strain: of all rows that were measured.
        rates: lowest and highest of the histories, 1/s, see `rate_range`.
        remembered: the last stresses of a Maxwell branch by relaxation time.
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
        """Indices of the histories whose zero of the force has to be fitted."""
        return np.array([index for index, each in enumerate(self.histories) if each.offset is None], dtype=np.int64)

    @cached_property
    def membership(self) -> Array:
        """1 where a block is of a history, else 0, shape (blocks, histories)."""
        return np.asarray(self.specimen[:, None] == np.arange(len(self.histories)), dtype=np.float64)

    @cached_property
    def peak(self) -> float:
        """Largest stress that was measured in a block, Pa."""
        return float(np.max(np.abs(self.stress)))

    @cached_property
    def times(self) -> tuple[float, float]:
        """Between which a relaxation time can be seen: two samples where they are close, and the longest history, s."""
        steps = [float(np.quantile(np.diff(each.time), _CLOSE)) for each in self.histories]
        return 2 * min(steps), max(float(each.time[-1] - each.time[0]) for each in self.histories)

    def block(self, values: Array) -> Array:
        """Means over blocks of values by row; shape (rows, ...) becomes (blocks, ...)."""
        sums = np.add.reduceat(values, self.starts, axis=0)
        means = sums / self.counts.reshape(-1, *([1] * (values.ndim - 1)))
        return np.asarray(means[self.compared])

    def branch(self, time: float) -> Array:
        """Stress of a Maxwell branch of modulus 1, shape (rows,)."""
        if time not in self.remembered:
            unit = MaxwellBranch(modulus=1.0, time=time)
            if len(self.remembered) >= _REMEMBERED:
                self.remembered.pop(next(iter(self.remembered)))
            rows = np.concatenate([each.time for each in self.histories])
            starts = np.cumsum([len(each.time) for each in self.histories])[:-1]
            self.remembered[time] = branch_stress(unit, rows, self.strain, starts)
        return self.remembered[time]

    def set_strain(self, residual: float, yield_strain: float | None) -> Array:
        """The strain at which the spring is slack, shape (rows,)."""
        return np.concatenate([set_history(each.strain, residual, yield_strain) for each in self.histories])


def problem_of(histories: Sequence[StrainHistory]) -> FitProblem:
    """Put histories end to end and choose the blocks.

    Where there are more rows than `MOST_ROWS`, the means of neighbours take their place: their strain lies on the
    history but for a few rows at its turning points.
    """
    size = -(-sum(len(each.time) for each in histories) // MOST_ROWS)
    largest = max(float(np.max(each.strain)) for each in histories)
    lowest, highest = zip(*map(rate_range, histories), strict=True)
    histories = [_thinned(each, size) for each in histories]
    rows = sum(len(each.time) for each in histories)
    size = -(-rows // MOST_POINTS)
    blocks = [np.arange(0, len(each.time), size) for each in histories]
    begins = np.cumsum([0, *(len(each.time) for each in histories)])
    starts = np.concatenate([begin + own for begin, own in zip(begins[:-1], blocks, strict=True)])
    counts = np.diff([*starts, rows]).astype(np.float64)
    compared = np.concatenate([own >= each.first for each, own in zip(histories, blocks, strict=True)])

    def means(values: Sequence[Array]) -> Array:
        every = np.add.reduceat(np.concatenate(values), starts) / counts
        return np.asarray(every[compared])

    return FitProblem(
        histories=tuple(histories),
        strain=np.concatenate([each.strain for each in histories]),
        rate=np.concatenate([strain_rate(each) for each in histories]),
        starts=starts,
        counts=counts,
        compared=compared,
        stress=means([each.stress - each.zero for each in histories]),
        specimen=np.repeat(np.arange(len(histories)), [len(own) for own in blocks])[compared],
        time=means([_from_middle(each.time) for each in histories]),
        largest_strain=largest,
        rates=(min(lowest), max(highest)),
    )


def _from_middle(time: Array) -> Array:
    return np.asarray((time - (time[0] + time[-1]) / 2) / ((time[-1] - time[0]) / 2))


def _thinned(history: StrainHistory, size: int) -> StrainHistory:
    """Means of neighbouring rows, some rows each; too few rows to fill one at the end are dropped."""
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
    """A form held against histories.

    Values are in the order of `LawForm.keys`; then the logarithms of the specimens' amplitudes, of all but the last,
    which makes their sum 0; then the baseline: for each history whose zero of the force is unknown an offset and, where
    it has one, a drift, both in Pa. A relaxation time and `softening.m` stand as logarithms, `softening.r` as 1/r.

    Specimens of one material differ in amplitude: their area is known to some per cent, and their fabric differs. Taken
    for lack of fit, that would pass for a misfit that every row shares and hide all that is finer. So the law is that
    of the specimens' geometric mean, and each has every stress of it times an amplitude of its own.

    Attributes:
        form: of the law.
        problem: the histories.
        baseline: terms of the baseline of each history: none, an offset, or an offset and a drift.
    """

    form: LawForm
    problem: FitProblem
    baseline: int

    @cached_property
    def baseline_columns(self) -> Array:
        """Shape (blocks, histories with an unknown zero times terms)."""
        own = self.problem.membership[:, self.problem.unknown_zeros]
        terms = [own, own * self.problem.time[:, None]][: self.baseline]
        return np.concatenate(terms, axis=1) if terms else np.empty((len(own), 0))

    def parts(self, values: Array) -> tuple[Array, Array, Array]:
        """Values of the law, logarithms of all amplitudes, shape (histories,), and values of the baseline."""
        count, others = len(self.form.keys), len(self.problem.histories) - 1
        own, free, zeros = np.split(values, [count, count + others])
        return own, self._contrasts @ free, zeros

    @cached_property
    def _contrasts(self) -> Array:
        """The logarithms of all amplitudes by those that are free, shape (histories, histories - 1)."""
        others = len(self.problem.histories) - 1
        return np.concatenate([np.eye(others), np.full((1, others), -1.0)])

    def fitted(self, values: Array) -> Array:
        """Stress of each block, Pa, shape (blocks,); a specimen gives way rather than push."""
        own, logarithms, zeros = self.parts(values)
        pull = self.problem.block(np.maximum(self.total(own), 0.0))
        return np.asarray(pull * self._amplitudes(logarithms) + self.baseline_columns @ zeros)

    def _amplitudes(self, logarithms: Array) -> Array:
        """Of the specimen of each block, shape (blocks,)."""
        return np.asarray(np.exp(np.clip(logarithms, -_LOG, _LOG))[self.problem.specimen])

    def sensitivity(self, values: Array) -> Array:
        """Derivatives of `fitted`, shape (blocks, values)."""
        count, proportional = len(self.form.keys), len(self.form.linear_keys)
        own, logarithms, _ = self.parts(values)
        columns = np.empty((len(self.problem.strain), count))
        # softening makes the spring's moduli act by way of its energy, too
        if self.form.softening == "none":
            done = proportional
            columns[:, :done] = self.columns(own[proportional:])
            total = columns[:, :done] @ own[:done]
        else:
            done, total = 0, self.total(own)
        for index in range(done, count):
            moved, step = own.copy(), _STEP * self._scale(index)
            moved[index] += step
            columns[:, index] = (self.total(moved) - total) / step
        columns[total <= 0] = 0.0
        amplitudes = self._amplitudes(logarithms)[:, None]
        pull = self.problem.block(np.maximum(total, 0.0))[:, None] * (self.problem.membership @ self._contrasts)
        return np.concatenate(
            [amplitudes * self.problem.block(columns), amplitudes * pull, self.baseline_columns], axis=1
        )

    def total(self, own: Array) -> Array:
        """Stress of spring, damper and branches in each row, Pa, shape (rows,)."""
        proportional, order = len(self.form.linear_keys), self.form.order
        columns, linear = self.columns(own[proportional:]), own[:proportional]
        if self.form.softening == "none":
            return np.asarray(columns @ linear)
        first, second, third = (*linear[:order], 0.0, 0.0)[:3]
        share = self.softening_share((first, second, third), columns[:, 0], own[proportional:])
        return np.asarray(share * (columns[:, :order] @ linear[:order]) + columns[:, order:] @ linear[order:])

    def columns(self, others: Array) -> Array:
        """Stress by unit of each linear value, shape (rows, linear values)."""
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
        """Ogden and Roxburgh's eta in each row, shape (rows,), from the strain of the spring, of the same shape."""
        energy = spring_energy(moduli, extended)
        ends = np.cumsum([len(each.time) for each in self.problem.histories])[:-1]
        largest = np.concatenate([np.maximum.accumulate(each) for each in np.split(energy, ends)])
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
        """Of a value, for the step of a finite difference."""
        key = self.form.keys[index]
        if key.startswith("modulus"):
            return float(self.problem.peak / self.problem.largest_strain ** (index + 1))
        return self.problem.largest_strain if key.endswith("strain") else 1.0
