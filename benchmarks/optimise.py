"""Compare optimisers on five goals at equal numbers of designs, and measure the price of robustness of the wing.

Every optimiser has the interface `ask` and `tell`. The libraries beside SciPy are compared where they are installed:
pip install cmaes cma
"""

from __future__ import annotations

import argparse
import contextlib
import importlib.util
import json
import math
import platform
import queue
import tempfile
import threading
from collections.abc import Callable, Mapping, Sequence
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
from forficula.goals.optimise.candidate import Candidate, axes_of, trial_of
from forficula.goals.optimise.optimise import optimise_goal
from forficula.goals.optimise.parabola_search import Optimiser, ParabolaSearch
from forficula.goals.optimise.screening import screened
from forficula.goals.optimise.trials import Axis, Point, Trial, placed, standing
from forficula.quantities import parse_quantity

# the reference wing that 30 N cm fold and 60 N cm open, and that holds itself open best
_WING = {
    "name": "wing",
    "design": "binder2025",
    "vary": {
        "tendon.stiffness": {"low": "4 N/cm", "high": "40 N/cm"},
        "tendon.rest_length": {"low": "4 cm", "high": "10.5 cm"},
        "hinge.overbend": {"low": "1 deg", "high": "8 deg"},
        "pattern.hub_radius": {"low": "1.2 cm", "high": "2 cm"},
    },
    "limits": {"least_fold_torque": "<= 30 N cm", "least_unfold_torque": "<= 60 N cm"},
    "objectives": {"hinge_holding_torque": "largest"},
}
_TOLERANCES = {"all": "10 %"}
_WANTED = {"probability": ">= 95 %"}
PROBLEMS: dict[str, dict[str, Any]] = {
    "wing": _WING,
    # the named goal clasp-5-to-8 without tolerances, with the static limits 10 % within those of its protocol
    "clasp": {
        "name": "clasp",
        "design": "force-clasp",
        "vary": {
            "tendon.band.stiffness": {"low": "5 N/cm", "high": "12 N/cm"},
            "tendon.band.rest_length": {"low": "44 mm", "high": "54 mm"},
            "crease.rest_angle": {"low": "0 deg", "high": "50 deg"},
        },
        "limits": {"slow_open": [">= 5.5 N", "<= 7.2 N"]},
        "objectives": {"closed_tendon_energy": "least"},
    },
    # the lightest joint within two limits, both active; statics alone
    "joint": {
        "name": "joint",
        "design": "binder2025-joint",
        "simulate": False,
        "vary": {
            "tendon.area": {"low": "1 mm^2", "high": "20 mm^2"},
            "tendon.rest_length": {"low": "4 cm", "high": "9 cm"},
        },
        "limits": {"hinge_holding_torque": ">= 8 N cm", "hinge_opening_torque": "<= 32 N cm"},
        "objectives": {"mass": "least"},
    },
    # statics of every hinge of the wing
    "wing-statics": {
        "name": "wing-statics",
        "design": "binder2025",
        "simulate": False,
        "vary": _WING["vary"],
        "limits": {"hinge_opening_torque": "<= 40 N cm", "hinge_barrier": "<= 8 mJ"},
        "objectives": {"hinge_holding_torque": "largest"},
    },
    # the joint that is hardest to snap shut, for one torque that opens it and another that its stop bears
    "joint-barrier": {
        "name": "joint-barrier",
        "design": "binder2025-joint",
        "simulate": False,
        "vary": {
            "tendon.area": {"low": "1 mm^2", "high": "20 mm^2"},
            "tendon.rest_length": {"low": "4 cm", "high": "9 cm"},
            "tendon.proximal_attachment": {"low": "4 cm", "high": "8 cm"},
            "tendon.distal_attachment": {"low": "4 cm", "high": "8 cm"},
            "hinge.overbend": {"low": "1 deg", "high": "10 deg"},
        },
        "limits": {"hinge_opening_torque": "<= 40 N cm", "hinge_holding_torque": "<= 10 N cm"},
        "objectives": {"hinge_barrier": "largest"},
    },
}


class SobolPoints:
    """Scrambled Sobol points, which do not depend on trials."""

    def __init__(self, axes: Sequence[Axis], batch: int, seed: int) -> None:
        self._axes, self._batch = axes, batch
        self._points = qmc.Sobol(len(axes), rng=np.random.default_rng(seed))

    def ask(self) -> list[Point]:
        """Return the next batch of the sequence."""
        return placed(self._axes, np.array([self._points.random()[0] for _ in range(self._batch)]))

    def tell(self, trials: Sequence[Trial]) -> None:
        """Learn nothing."""


def cost(trial: Trial) -> float:
    """Return the objective of a feasible trial; of any other, its violation of the limits, far above all objectives."""
    return trial.objectives[0] if trial.feasible else 1e3 * sum(standing(trial)[:3])


class ClosedError(Exception):
    """No more trials follow."""


class CallbackOptimiser:
    """An optimiser that calls back to evaluate points, run in a thread of its own behind `ask` and `tell`."""

    def __init__(self, axes: Sequence[Axis], run: Callable[[Callable[[np.ndarray], list[Trial]]], Any]) -> None:
        self._axes = axes
        self._asked: queue.Queue[np.ndarray | None] = queue.Queue()
        self._told: queue.Queue[Sequence[Trial] | None] = queue.Queue()

        def evaluate(points: np.ndarray) -> list[Trial]:
            self._asked.put(points)
            trials = self._told.get()
            if trials is None:
                raise ClosedError
            return list(trials)

        def work() -> None:
            with contextlib.suppress(ClosedError):
                run(evaluate)
            self._asked.put(None)

        threading.Thread(target=work, daemon=True).start()

    def ask(self) -> list[Point]:
        """Return the points that the optimiser waits for; none once it has ended."""
        points = self._asked.get()
        return [] if points is None else placed(self._axes, points)

    def tell(self, trials: Sequence[Trial]) -> None:
        """Hand trials to the optimiser."""
        self._told.put(trials)

    def close(self) -> None:
        """End the thread, because COBYQA holds a lock as long as it runs."""
        self._told.put(None)


def evolution(axes: Sequence[Axis], batch: int, seed: int) -> Optimiser:
    """SciPy's differential evolution at its own settings but for a population of one batch."""

    def run(evaluate: Callable[[np.ndarray], list[Trial]]) -> None:
        optimize.differential_evolution(
            lambda points: np.array([cost(trial) for trial in evaluate(points.T)]),
            [(0.0, 1.0)] * len(axes),
            popsize=max(1, batch // len(axes)),
            maxiter=10_000,
            rng=np.random.default_rng(seed),
            polish=False,
            updating="deferred",
            vectorized=True,
            tol=0.0,
        )

    return CallbackOptimiser(axes, run)


def cobyqa(axes: Sequence[Axis], batch: int, seed: int) -> Optimiser:
    """SciPy's COBYQA, one point at a time, from the best of a batch of Sobol points, again and again."""

    def run(evaluate: Callable[[np.ndarray], list[Trial]]) -> None:
        points = qmc.Sobol(len(axes), rng=np.random.default_rng(seed))
        while True:
            first = np.array([points.random()[0] for _ in range(batch)])
            start = min(zip(evaluate(first), first, strict=True), key=lambda pair: cost(pair[0]))[1]
            known: dict[bytes, Trial] = {}

            def at(place: np.ndarray, known: dict[bytes, Trial] = known) -> Trial:
                if place.tobytes() not in known:
                    (known[place.tobytes()],) = evaluate(place[None])
                return known[place.tobytes()]

            def margins(place: np.ndarray, at: Callable[[np.ndarray], Trial] = at) -> np.ndarray:
                return np.nan_to_num(np.array(at(place).margins), nan=-1.0)

            optimize.minimize(
                lambda place, at=at: float(np.nan_to_num(at(place).objectives[0], nan=1e3)),
                start,
                method="COBYQA",
                bounds=[(0.0, 1.0)] * len(axes),
                constraints=optimize.NonlinearConstraint(margins, 0.0, np.inf),
                options={"initial_tr_radius": 0.1, "final_tr_radius": 1e-5},
            )

    return CallbackOptimiser(axes, run)


class RankedAdaptation:
    """CMA-ES of the package `cmaes` at its own settings, from the middle; limits enter by the ranks of trials."""

    def __init__(self, axes: Sequence[Axis], _batch: int, seed: int) -> None:
        from cmaes import CMA

        bounds = np.array([[0.0, 1.0]] * len(axes))
        self._axes, self._points = axes, np.zeros((0, len(axes)))
        self._method = CMA(mean=np.full(len(axes), 0.5), sigma=0.3, bounds=bounds, seed=seed)

    def ask(self) -> list[Point]:
        """Return the next population."""
        self._points = np.array([self._method.ask() for _ in range(self._method.population_size)])
        return placed(self._axes, self._points)

    def tell(self, trials: Sequence[Trial]) -> None:
        """Rank a population."""
        self._method.tell([(point, cost(trial)) for point, trial in zip(self._points, trials, strict=True)])


class LagrangianAdaptation:
    """CMA-ES of the package `cma` at its own settings, from the middle; limits enter by an augmented Lagrangian."""

    def __init__(self, axes: Sequence[Axis], _batch: int, seed: int) -> None:
        import cma

        self._axes, self._points = axes, list[np.ndarray]()
        # objective and violated margins by point
        self._known: dict[tuple[float, ...], tuple[float, list[float]]] = {}
        options = {"bounds": [0, 1], "seed": seed + 1, "verbose": -9}
        self._method = cma.CMAEvolutionStrategy(np.full(len(axes), 0.5), 0.3, options)
        self._cost = cma.ConstrainedFitnessAL(
            lambda point: self._known[tuple(point)][0], lambda point: self._known[tuple(point)][1], logging=False
        )

    def ask(self) -> list[Point]:
        """Return the next population."""
        self._points = self._method.ask()
        return placed(self._axes, np.array(self._points))

    def tell(self, trials: Sequence[Trial]) -> None:
        """Hand objectives and margins of a population to the augmented Lagrangian."""
        for point, trial in zip(self._points, trials, strict=True):
            margins = np.nan_to_num(np.array(trial.margins), nan=-1.0)
            self._known[tuple(point)] = float(np.nan_to_num(trial.objectives[0], nan=1e3)), list(-margins)
        self._method.tell(self._points, [self._cost(point) for point in self._points])
        self._cost.update(self._method)


METHODS: dict[str, Callable[[Sequence[Axis], int, int], Optimiser]] = {
    "ours": lambda axes, batch, seed: ParabolaSearch(axes, 1, batch, seed),
    "Sobol points": SobolPoints,
    "differential evolution": evolution,
    "COBYQA": cobyqa,
    "CMA-ES (cmaes)": RankedAdaptation,
    "CMA-ES (cma)": LagrangianAdaptation,
}
_NEEDS = {"CMA-ES (cmaes)": "cmaes", "CMA-ES (cma)": "cma"}


def main() -> None:
    """Measure and print tables."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--runs", type=int, default=128, help="designs that each method may try")
    parser.add_argument("--batch", type=int, default=16, help="designs at a time; at least 4")
    parser.add_argument("--seeds", type=int, default=5, help="how often each method tries")
    parser.add_argument("--only", choices=("methods", "robust"), help="one of the two comparisons")
    parser.add_argument("--goals", nargs="+", choices=PROBLEMS, default=list(PROBLEMS), help="of the comparison")
    parser.add_argument("--methods", nargs="+", choices=METHODS, default=list(METHODS), help="that are compared")
    parser.add_argument("--folder", type=Path, help="where runs are kept, so that none is made twice")
    parser.add_argument("--json", type=Path, help="write the numbers here, too")
    arguments = parser.parse_args()
    numbers: dict[str, Any] = {"machine": {"python": platform.python_version(), **versions()}}
    with tempfile.TemporaryDirectory() as temporary:
        folder = arguments.folder or Path(temporary)
        if arguments.only != "robust":
            numbers["methods"] = {}
            for name in arguments.goals:
                goal = goal_of(PROBLEMS[name])
                courses = {
                    method: measure_method(folder / name, goal, method, arguments)
                    for method in arguments.methods
                    if method not in _NEEDS or importlib.util.find_spec(_NEEDS[method])
                }
                numbers["methods"][name] = courses
                show_methods(goal, courses)
        if arguments.only != "methods":
            numbers["robust"] = measure_robust(folder, arguments.runs, arguments.batch)
            show_robust(numbers["robust"])
    if arguments.json is not None:
        arguments.json.write_text(json.dumps(numbers, indent=2) + "\n")


def measure_method(folder: Path, goal: Goal, method: str, settings: argparse.Namespace) -> list[list[float]]:
    """Return the best objective, SI, after every design, by seed; nan before any design meets the goal.

    Designs that statics rules out before any run count as tried, as they do in the goal.
    """
    courses = []
    with open_assessor(folder, goal.base, threads=1) as assess:
        for seed in range(settings.seeds):
            optimiser = METHODS[method](axes_of(goal), settings.batch, seed)
            trials: list[Trial] = []
            while len(trials) < settings.runs and (points := optimiser.ask()):
                latest = _trials(goal, assess, points)
                optimiser.tell(latest)
                trials += latest
            if isinstance(optimiser, CallbackOptimiser):
                optimiser.close()
            courses.append(_course(goal, trials[: settings.runs]))
    return courses


def _trials(goal: Goal, assess: Assessor, points: Sequence[Point]) -> list[Trial]:
    """What becomes of points of the unit cube."""
    values = [goal.values(point) for point in points]
    designs = []
    for point_values in values:
        try:
            designs.append(goal.base.with_values(dict(point_values)))
        except InputError as error:
            designs.append(str(error))
    assessed = screened(goal, assess, designs)
    return [
        trial_of(goal, Candidate(point=point, values=value, screened=result))
        for point, value, result in zip(points, values, assessed, strict=True)
    ]


def _course(goal: Goal, trials: Sequence[Trial]) -> list[float]:
    """The best so far after every design."""
    best, course = math.nan, []
    for trial in trials:
        if trial.feasible:
            best = trial.objectives[0] if math.isnan(best) else min(best, trial.objectives[0])
        course.append(abs(best) if goal.objectives[0].kind == "largest" else best)
    return course


def show_methods(goal: Goal, courses: Mapping[str, list[list[float]]]) -> None:
    """Print the best objective by designs tried: the median of the seeds, and at last the worst and the best."""
    objective = goal.objectives[0]
    unit = objective.quantity.unit
    scale = parse_quantity(f"1 {unit.display}", unit)
    most = min(len(course) for every in courses.values() for course in every)
    counts = sorted({count for count in (32, 64, 128, 256) if count < most} | {most})
    print(f"{goal.name}: {objective.kind} {objective.quantity.name}, {unit.display}")
    print(f"{'designs tried':24}", *(f"{count:>10}" for count in counts), f"{'from':>10}", f"{'to':>10}")
    for name, every in courses.items():
        # a seed that found nothing is worse than any that did
        lost = math.inf if objective.kind == "least" else -math.inf
        values = np.nan_to_num(np.array([course[:most] for course in every]), nan=lost) / scale
        middle = [float(np.median(values[:, count - 1])) for count in counts]
        ends = values[:, -1].min(), values[:, -1].max()
        print(f"{name:24}", *(f"{value:10.4f}" for value in (*middle, *ends)))


def measure_robust(folder: Path, runs: int, batch: int) -> dict[str, dict[str, Any]]:
    """The best wing by the plain goal and by the one that wants 95 of 100 neighbours to work, on fresh neighbours."""
    results = {}
    search = {"batch": batch, "runs": runs}
    for name, limits in (("plain", _WING["limits"]), ("robust", {**_WING["limits"], **_WANTED})):
        goal = goal_of({**_WING, "limits": limits, "tolerances": _TOLERANCES, "search": search})
        optimum = optimise_goal(goal, folder / name)
        chosen = (*optimum.best, *optimum.discarded)[:1]
        shares = [candidate.neighbours.share for candidate in optimum.candidates if candidate.neighbours is not None]
        results[name] = {
            "holds": bool(optimum.best),
            "designs": [dict(design.candidate.values) for design in chosen],
            "holding_torque": [design.candidate.value(goal.objectives[0].quantity) for design in chosen],
            "fresh_share": [design.fresh.share for design in chosen if design.fresh is not None],
            "largest_share_asked": max(shares, default=None),
            "neighbour_runs": optimum.effort.neighbour_runs,
            "runs": optimum.effort.runs,
        }
    return results


def show_robust(robust: dict[str, dict[str, Any]]) -> None:
    """Print what either goal leads to."""
    for name, result in robust.items():
        torque = ", ".join(f"{100 * value:.2f} N cm" for value in result["holding_torque"]) or "nothing"
        shares = ", ".join(f"{100 * value:.0f} %" for value in result["fresh_share"])
        print(f"{name:8} holds with {torque}; of its fresh neighbours {shares} work; {result['neighbour_runs']} asked")


if __name__ == "__main__":
    main()
