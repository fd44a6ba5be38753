"""How many runs the best wing takes to find, beside other ways to look for it, and what it costs to be robust."""

from __future__ import annotations

import argparse
import json
import math
import platform
import tempfile
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from scipy import optimize
from scipy.stats import qmc

from forficula.dynamics import versions
from forficula.errors import InputError
from forficula.goals.assessor import Assessor, open_assessor
from forficula.goals.goal import Goal
from forficula.goals.goal_file import goal_of
from forficula.goals.optimise.axis import placed
from forficula.goals.optimise.candidate import Candidate, axes_of, trial_of
from forficula.goals.optimise.optimise import optimise_goal
from forficula.goals.optimise.ranking import standing
from forficula.goals.optimise.screening import screened
from forficula.goals.optimise.trial import Trial

# the trial of the reference wing that this answers: fold with 30, open with 60 N cm, and hold as well as can be
_WING = {
    "name": "wing-that-holds",
    "design": "binder2025",
    "vary": {
        "tendon.stiffness": {"low": "4 N/cm", "high": "40 N/cm"},
        "tendon.rest_length": {"low": "4 cm", "high": "10.5 cm"},
        "hinge.overbend": {"low": "1 deg", "high": "8 deg"},
        "pattern.hub_radius": {"low": "1.2 cm", "high": "2 cm"},
    },
    "limits": {"least_fold_torque": "<= 30 N cm", "least_unfold_torque": "<= 60 N cm"},
    "objectives": {"hinge_holding_torque": "largest"},
    "tolerances": {"all": "10 %"},
}
_WANTED = {"probability": ">= 95 %"}


def main() -> None:
    """Measure and print tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=256, help="designs that each way may try")
    parser.add_argument("--batch", type=int, default=16, help="designs at a time; at least 4")
    parser.add_argument("--seeds", type=int, default=3, help="how often each way tries")
    parser.add_argument("--only", choices=("ways", "robust"), help="one of the two comparisons")
    parser.add_argument("--json", type=Path, help="write the numbers here, too")
    arguments = parser.parse_args()
    numbers: dict[str, Any] = {"machine": {"python": platform.python_version(), **versions()}}
    with tempfile.TemporaryDirectory() as folder:
        if arguments.only != "robust":
            numbers["ways"] = measure_ways(Path(folder) / "ways", arguments.runs, arguments.batch, arguments.seeds)
            show_ways(numbers["ways"], arguments.batch)
        if arguments.only != "ways":
            numbers["robust"] = measure_robust(Path(folder), arguments.runs, arguments.batch)
            show_robust(numbers["robust"])
    if arguments.json is not None:
        arguments.json.write_text(json.dumps(numbers, indent=2) + "\n")


def measure_ways(folder: Path, runs: int, batch: int, seeds: int) -> dict[str, list[list[float]]]:
    """The best holding torque, N m, after every batch, by way and seed; nan before anything works.

    What is ruled out before any run counts as tried, as it does in the goal.
    """
    found: dict[str, list[list[float]]] = {"ours": [], "Sobol": [], "differential evolution": []}
    # without tolerances, which no way looks at: only the best design of one way would be checked for them
    goal = goal_of(
        {key: value for key, value in _WING.items() if key != "tolerances"} | {"search": {"batch": batch, "runs": runs}}
    )
    for seed in range(seeds):
        ours = optimise_goal(replace(goal, seed=seed), folder)
        found["ours"].append(_course(goal, [trial_of(goal, each) for each in ours.candidates]))
        with open_assessor(folder, goal.base) as assess:
            points = qmc.Sobol(len(goal.parameters), rng=np.random.default_rng(seed)).random(runs)
            found["Sobol"].append(_course(goal, _trials(goal, assess, points)))
            found["differential evolution"].append(_course(goal, _by_evolution(goal, assess, runs, seed)))
    return found


def _by_evolution(goal: Goal, assess: Assessor, runs: int, seed: int) -> list[Trial]:
    """All trials of scipy's, at its own settings but for a population of one batch; what fails costs what it misses."""
    trials: list[Trial] = []

    def cost(points: np.ndarray) -> np.ndarray:
        told = _trials(goal, assess, points.T)
        trials.extend(told)
        return np.array([each.objectives[0] if each.feasible else 1e3 * sum(standing(each)[:3]) for each in told])

    optimize.differential_evolution(
        cost,
        [(0.0, 1.0)] * len(goal.parameters),
        popsize=goal.batch // len(goal.parameters),
        maxiter=math.ceil(runs / goal.batch) - 1,
        rng=np.random.default_rng(seed),
        polish=False,
        updating="deferred",
        vectorized=True,
        tol=0.0,
    )
    return trials[:runs]


def _trials(goal: Goal, assess: Assessor, points: Sequence[Sequence[float]]) -> list[Trial]:
    """What becomes of points of the unit cube."""
    places = placed(axes_of(goal), np.array(points))
    values = [goal.values(place) for place in places]
    designs = []
    for each in values:
        try:
            designs.append(goal.base.with_values(dict(each)))
        except InputError as error:
            designs.append(str(error))
    found = screened(goal, assess, designs)
    return [
        trial_of(goal, Candidate(point=place, values=value, found=each))
        for place, value, each in zip(places, values, found, strict=True)
    ]


def _course(goal: Goal, trials: Sequence[Trial]) -> list[float]:
    """The best so far after every batch."""
    return [
        max((-each.objectives[0] for each in trials[:last] if each.feasible), default=math.nan)
        for last in range(goal.batch, len(trials) + 1, goal.batch)
    ]


def measure_robust(folder: Path, runs: int, batch: int) -> dict[str, dict[str, Any]]:
    """The best wing by the plain goal and by the one that wants 95 of 100 neighbours to work, on fresh neighbours."""
    found = {}
    for name, limits in (("plain", _WING["limits"]), ("robust", {**_WING["limits"], **_WANTED})):
        goal = goal_of({**_WING, "limits": limits, "search": {"batch": batch, "runs": runs}})
        optimum = optimise_goal(goal, folder / name)
        chosen = (*optimum.best, *optimum.discarded)[:1]
        asked = [each.neighbours.share for each in optimum.candidates if each.neighbours is not None]
        found[name] = {
            "holds": bool(optimum.best),
            "designs": [dict(each.candidate.values) for each in chosen],
            "holding_torque": [each.candidate.value(goal.objectives[0].quantity) for each in chosen],
            "fresh_share": [each.fresh.share for each in chosen if each.fresh is not None],
            "largest_share_asked": max(asked, default=None),
            "neighbour_runs": optimum.effort.neighbour_runs,
            "runs": optimum.effort.runs,
        }
    return found


def show_ways(ways: dict[str, list[list[float]]], batch: int) -> None:
    """Print the best holding torque by designs tried, the median of the seeds."""
    counts = [
        count for count in (32, 64, 128, 256, 512) if all(len(c) * batch >= count for w in ways.values() for c in w)
    ]
    print(f"{'designs tried':24}", *(f"{count:>8}" for count in counts))
    for name, courses in ways.items():
        middle = [np.nanmedian([course[count // batch - 1] for course in courses]) for count in counts]
        print(f"{name:24}", *(f"{100 * value:8.3f}" for value in middle), " N cm")


def show_robust(robust: dict[str, dict[str, Any]]) -> None:
    """Print what either goal leads to."""
    for name, each in robust.items():
        torque = ", ".join(f"{100 * value:.2f} N cm" for value in each["holding_torque"]) or "nothing"
        shares = ", ".join(f"{100 * value:.0f} %" for value in each["fresh_share"])
        print(f"{name:8} holds with {torque}; of its fresh neighbours {shares} work; {each['neighbour_runs']} asked")


if __name__ == "__main__":
    main()
