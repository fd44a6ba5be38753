"""How often the strongest of many tolerances are chosen for indices of their own, on functions with known indices.

    python benchmarks/screening.py [--repetitions N] [--json FILE]

Beside the choice by all rows stands the one by the few exchanged rows of each factor alone.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from forficula.goals.tolerance.indices import total_effects
from forficula.goals.tolerance.plan import PLANS, exchanged, two_samples
from forficula.goals.tolerance.screening import screening

Values = NDArray[np.float64]
FACTORS = 25
# as it is where a factor has few rows: the smallest plan with a screening
PLAN = next(plan for plan in reversed(PLANS) if plan.screened)


def ishigami(points: Values) -> Values:
    """Ishigami and Homma (1990) over three factors: total indices of 0.56, 0.44 and 0.24; others are inactive."""
    first, second, third = (2 * points[:, [4, 9, 17]].T - 1) * np.pi
    return np.asarray(np.sin(first) + 7 * np.sin(second) ** 2 + 0.1 * third**4 * np.sin(first))


def sobol_g(points: Values) -> Values:
    """Sobol (1993) with a = 0, 1, 4.5, 9 and 99: total indices of 0.79, 0.24, 0.034, 0.010 and 0.0001."""
    a = np.array([0.0, 1.0, 4.5, 9.0, *np.full(FACTORS - 4, 99.0)])
    return np.asarray(np.prod((np.abs(4 * points - 2) + a) / (1 + a), axis=1))


def line(points: Values) -> Values:
    """A linear margin of five factors, with shares of 0.51, 0.23, 0.13, 0.08 and 0.06; others are inactive."""
    return np.asarray(points[:, :5] @ [3.0, 2.0, 1.5, 1.2, 1.0])


def step(points: Values) -> Values:
    """A margin that is lost beyond a plane: total indices of 0.77, 0.27, 0.21, 0.15, and 0.035 of 21 others."""
    weights = np.array([2.0, 1.0, 0.8, 0.6, *np.full(FACTORS - 4, 0.15)])
    along = (points - 0.5) @ weights
    return np.asarray(np.where(along > 0.25 * np.sqrt(np.sum(weights**2) / 12), -0.4, 0.6) - 0.05 * along)


STRONGEST: dict[Callable[[Values], Values], list[int]] = {
    ishigami: [4, 9, 17],
    sobol_g: [0, 1, 2],
    line: [0, 1, 2, 3, 4],
    step: [0, 1, 2, 3],
}


def measure(function: Callable[[Values], Values], strongest: list[int], repetitions: int) -> dict[str, list[int]]:
    """Count in how many repetitions each of the strongest factors is chosen, and exceeds chance."""
    chosen, resolved, before = (np.zeros(FACTORS, dtype=int) for _ in range(3))
    for seed in range(repetitions):
        first, second = two_samples(FACTORS, PLAN.points, seed)
        one, other = first[: PLAN.screened], second[: PLAN.screened]
        points = np.concatenate([first, second[: PLAN.rows]])
        values = function(points)
        mixed = np.array([function(exchanged(one, other, [factor])) for factor in range(FACTORS)])
        effects = total_effects(function(one), mixed, (other - one).T) / np.var(values)
        screened = screening(points, values, effects, PLAN.kept, seed)
        chosen[list(screened.kept)] += 1
        resolved += screened.resolved
        before[np.argsort(-effects, kind="stable")[: PLAN.kept]] += 1
    return {
        name: counts[strongest].tolist()
        for name, counts in (("chosen", chosen), ("beyond chance", resolved), ("by exchanged rows alone", before))
    }


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--repetitions", type=int, default=100)
    parser.add_argument("--json", type=Path)
    arguments = parser.parse_args()
    records = {
        function.__name__: measure(function, factors, arguments.repetitions) for function, factors in STRONGEST.items()
    }
    for name, counts in records.items():
        print(name, json.dumps(counts))
    if arguments.json:
        arguments.json.write_text(json.dumps(records, indent=2) + "\n", "utf-8")


if __name__ == "__main__":
    main()
