"""Where a fit begins: the best of a grid of the values that the stress is not proportional to."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, product

import numpy as np

from forficula.arrays import Array
from forficula.material.fit.fit_problem import FitProblem, LawModel
from forficula.material.law.law_form import LawForm

_MOST_ROWS = 500
_HALVINGS = 2  # of the grid's spacing
_RESIDUAL = (0.03, 0.1, 0.2, 0.3, 0.4, 0.55)  # of the largest strain
_YIELD = (0.4, 0.55, 0.7, 0.8, 0.9, 0.97)
_LOST = (0.25, 0.5, 0.8)
_WIDTH = (0.05, 0.2, 0.6)  # of the energy at the peak


class Starter:
    """Columns of histories at the nodes of the grid, worked out once for every form."""

    def __init__(self, problem: FitProblem) -> None:
        self._problem = problem
        self._rows = slice(None, None, max(1, -(-len(problem.stress) // _MOST_ROWS)))
        self._branches: dict[float, Array] = {}
        self._springs: dict[tuple[str, float], Array] = {}
        rate = problem.rate
        self._damper = self._thin(np.stack([rate * np.abs(rate) ** power for power in range(3)], axis=1))

    def start(self, model: LawModel) -> Array:
        """The best node, with proportional values, amplitudes and baseline that fit it, as a model has them."""
        best, misfit = min((self._fitted(model, each) for each in self._nodes(model)), key=lambda each: each[1])
        # branches that a coarse grid sets wrong may merge, and never part again
        step = self._times(model.form)[1] if model.form.branches > 1 else 0.0
        first = len(model.form.linear_keys)
        for _ in range(_HALVINGS if step else 0):
            step /= 2
            for index, sign in product(range(model.form.branches), (-1, 1)):
                others = best[first : len(model.form.keys)].copy()
                others[index] += sign * step
                moved, less = self._fitted(model, others)
                if less < misfit:
                    best, misfit = moved, less
        return best

    def _fitted(self, model: LawModel, others: Array) -> tuple[Array, tuple[bool, float]]:
        """The values that fit a node, and how badly: whether a branch is none, and the sum of squares, Pa^2."""
        count, form = len(model.form.linear_keys), model.form
        solution, squares = pulling_solution(
            self._columns(model, others),
            model.baseline_columns[self._rows],
            self._problem.stress[self._rows],
            self._problem.membership[self._rows],
        )
        values = np.concatenate([solution[:count], others, solution[count:]])
        return values, (bool(np.any(solution[count - form.branches : count] <= 0)), squares)

    def _times(self, form: LawForm) -> tuple[Array, float]:
        """Logarithms of the relaxation times of a form's grid, half a decade or so from one to the next, and that."""
        shortest, longest = np.log(self._problem.times)
        count = int(np.clip(2 * (longest - shortest) / np.log(10), 4, 8 if form.branches > 1 else 12))
        times = np.linspace(shortest, longest, count + 2)
        return times[1:-1], float(times[1] - times[0])

    def _thin(self, values: Array) -> Array:
        return self._problem.block(values)[self._rows]

    def _nodes(self, model: LawModel) -> Iterator[Array]:
        form, problem = model.form, self._problem
        times = self._times(form)[0]
        shares: dict[str, list[tuple[float, ...]]] = {
            "none": [()],
            "residual": [(each,) for each in _RESIDUAL],
            "yield": [(each,) for each in _YIELD],
        }
        sets = [tuple(each * problem.largest_strain for each in share) for share in shares[form.permanent_set]]
        energy = problem.peak * problem.largest_strain / 2
        soft: dict[str, list[tuple[float, ...]]] = {
            "none": [()],
            "m": [(lost, np.log(width * energy)) for lost, width in product(_LOST, _WIDTH)],
            "m and beta": [(lost, np.log(width * energy), 0.1) for lost, width in product(_LOST, _WIDTH)],
        }
        for parts in product(combinations(times, form.branches), sets, soft[form.softening]):
            yield np.array([value for part in parts for value in part])

    def _columns(self, model: LawModel, others: Array) -> Array:
        form = model.form
        if form.softening != "none":
            # energy of a linear spring, near enough to begin with
            modulus = self._problem.peak / self._problem.largest_strain
            columns = model.columns(others)
            share = model.softening_share((modulus, 0.0, 0.0), columns[:, 0], others)
            columns[:, : form.order] *= share[:, None]
            return self._thin(columns)
        at = float(others[form.branches]) if form.permanent_set != "none" else 0.0
        branches = [self._branch(float(time)) for time in others[: form.branches]]
        spring = self._spring(form.permanent_set, at)[:, : form.order]
        return np.column_stack([spring, self._damper[:, : form.damper], *branches])

    def _branch(self, logarithm: float) -> Array:
        if logarithm not in self._branches:
            self._branches[logarithm] = self._thin(self._problem.branch(float(np.exp(logarithm))))
        return self._branches[logarithm]

    def _spring(self, kind: str, at: float) -> Array:
        if (kind, at) not in self._springs:
            residual, yield_strain = (0.0, at) if kind == "yield" else (at, None)
            extended = np.maximum(self._problem.strain - self._problem.set_strain(residual, yield_strain), 0.0)
            self._springs[kind, at] = self._thin(np.stack([extended**power for power in (1, 2, 3)], axis=1))
        return self._springs[kind, at]


def pulling_solution(columns: Array, baseline: Array, stress: Array, membership: Array) -> tuple[Array, float]:
    """Least squares where rows whose specimen would push count as slack, and specimens have amplitudes of their own.

    Args:
        columns: stress by unit of each proportional value, shape (rows, values).
        baseline: shape (rows, terms).
        stress: Pa, shape (rows,).
        membership: 1 where a row is of a specimen, else 0, shape (rows, specimens).

    Returns:
        The values, as a model has them, and the sum of squares, Pa^2.
    """
    count = columns.shape[1]
    solution = _solve(np.concatenate([columns, baseline], axis=1), stress)
    pull = np.maximum(columns @ solution[:count], 0.0)
    logarithms = _amplitudes(pull, stress - baseline @ solution[count:], membership)
    scaled = columns * ((pull > 0) * (membership @ np.exp(logarithms)))[:, None]
    active = np.concatenate([scaled, baseline], axis=1)
    solution = _solve(active, stress)
    misfit = active @ solution - stress
    return np.concatenate([solution[:count], logarithms[:-1], solution[count:]]), float(misfit @ misfit)


def _amplitudes(pull: Array, stress: Array, membership: Array) -> Array:
    """Logarithms of what each specimen's stress is of a common pull, least squares, less their mean."""
    products, squares = (pull * stress) @ membership, pull**2 @ membership
    seen = (products > 0) & (squares > 0)
    logarithms = np.log(np.where(seen, products, 1.0) / np.where(seen, squares, 1.0))
    return np.asarray(np.where(seen, logarithms - logarithms[seen].mean() if seen.any() else 0.0, 0.0))


def _solve(columns: Array, stress: Array) -> Array:
    """Least squares by the normal equations of columns of unit length: quick, and good enough to begin with."""
    norms = np.maximum(np.linalg.norm(columns, axis=0), np.finfo(float).tiny)
    unit = columns / norms
    normal = unit.T @ unit
    normal[np.diag_indices_from(normal)] += 1e-10
    return np.asarray(np.linalg.solve(normal, unit.T @ stress) / norms)
