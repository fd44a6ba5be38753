"""Start values of a fit: the best node of a grid over the values to which the stress is not proportional."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import combinations, product

import numpy as np

from forficula.arrays import Array
from forficula.material.fit.fit_problem import FitProblem, LawModel
from forficula.material.law.law_form import LawForm

_MOST_ROWS = 500
_HALVINGS = 2  # refinements of the grid's spacing
_RESIDUAL = (0.03, 0.1, 0.2, 0.3, 0.4, 0.55)  # residual strain as a share of the largest strain
_YIELD = (0.4, 0.55, 0.7, 0.8, 0.9, 0.97)  # yield strain as a share of the largest strain
_LOST = (0.25, 0.5, 0.8)  # 1/r of softening
_WIDTH = (0.05, 0.2, 0.6)  # m of softening as a share of the energy at the peak


class Starter:
    """Start values for forms of a law; the columns of histories at the nodes of the grid are computed once."""

    def __init__(self, problem: FitProblem) -> None:
        self._problem = problem
        self._rows = slice(None, None, max(1, -(-len(problem.stress) // _MOST_ROWS)))
        self._branches: dict[float, Array] = {}
        self._springs: dict[tuple[str, float], Array] = {}
        rate = problem.rate
        self._damper = self._thin(np.stack([rate * np.abs(rate) ** power for power in range(3)], axis=1))

    def start(self, model: LawModel) -> Array:
        """Return the values of a model at the best node, with proportional values, amplitudes and baseline fitted."""
        best, misfit = min((self._fitted(model, node) for node in self._nodes(model)), key=lambda fit: fit[1])
        # refine the relaxation times, because branches that start in the wrong place may merge irreversibly
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
        """Return the fitted values at a node, and the misfit: whether a branch vanishes, and sum of squares, Pa^2."""
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
        """Return the logarithms of the relaxation times of a form's grid and their spacing, about half a decade."""
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
            "residual": [(share,) for share in _RESIDUAL],
            "yield": [(share,) for share in _YIELD],
        }
        sets = [tuple(share * problem.largest_strain for share in node) for node in shares[form.permanent_set]]
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
            # energy of a linear spring, accurate enough for start values
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
    """Solve the least-squares problem in which rows that would push count as slack, and specimens have amplitudes.

    Args:
        columns: stress per unit of each proportional value, shape (rows, values).
        baseline: shape (rows, terms).
        stress: Pa, shape (rows,).
        membership: 1 for rows of a specimen, otherwise 0, shape (rows, specimens).

    Returns:
        The values in the order of a model, and the sum of squares, Pa^2.
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
    """Compute the logarithms of each specimen's stress divided by a common pull, by least squares, minus their mean."""
    products, squares = (pull * stress) @ membership, pull**2 @ membership
    known = (products > 0) & (squares > 0)
    logarithms = np.log(np.where(known, products, 1.0) / np.where(known, squares, 1.0))
    return np.asarray(np.where(known, logarithms - logarithms[known].mean() if known.any() else 0.0, 0.0))


def _solve(columns: Array, stress: Array) -> Array:
    """Solve a least-squares problem by normal equations of unit columns, accurate enough for start values."""
    norms = np.maximum(np.linalg.norm(columns, axis=0), np.finfo(float).tiny)
    unit = columns / norms
    normal = unit.T @ unit
    normal[np.diag_indices_from(normal)] += 1e-10
    return np.asarray(np.linalg.solve(normal, unit.T @ stress) / norms)
