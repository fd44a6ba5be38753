"""Calibrate which runs a study repeats at half the timestep: `python benchmarks/confirmation.py --designs 200`.

Every build of a design within 10 % runs at its timestep, at half of it, and from a slightly different start. A verdict
that is not the same is a flip. The rule of `needs_confirmation` is held against the flips of this full check: how many
it finds, and how many repetitions it takes. The time of confirming a run is measured side by side, as a ratio.
"""

from __future__ import annotations

import argparse
import time

import numpy as np

import forficula as ff
from forficula.analysis import measure
from forficula.analysis.confirmation import same_ending
from forficula.analysis.margin import transition_margins
from forficula.design import Design
from forficula.errors import InputError
from forficula.goals.binomial_interval import binomial_interval
from forficula.goals.deviation import default_deviations, deviating_values
from forficula.study.running.evaluate import needs_confirmation
from forficula.study.running.runs import run, run_each
from forficula.study.running.second_runs import check_of, half_step


def builds(name: str, count: int, seed: int) -> list[Design]:
    """Return designs whose values are off those of a named one by up to 10 % each."""
    base, rng = ff.load_design(name), np.random.default_rng(seed)
    deviations, designs = default_deviations(base), []
    while len(designs) < count:
        try:
            designs.append(base.with_values(deviating_values(base, deviations, 2 * rng.random(len(deviations)) - 1)))
        except InputError:  # what does not fit together
            continue
    return designs


def calibrate(name: str, count: int, seed: int) -> None:
    """Print the flips of a full check, and those that the rule finds."""
    designs = builds(name, count, seed)
    rows = dict(run_each(designs, sparse=True))
    reliable = {}
    for number, record in rows.items():
        if not isinstance(record, InputError) and (outcome := measure(record)).verdict.conclusive:
            margins = transition_margins(record, outcome)
            reliable[number] = (outcome, needs_confirmation(record, outcome, margins))
    kinds = {"half the timestep": [half_step(designs[number]) for number in reliable]}
    kinds["another start"] = [start for number in reliable if (start := designs[number].with_other_start()) is not None]
    repeated = sum(chosen for _, chosen in reliable.values())
    print(f"{name}: {len(reliable)} of {count} builds have a reliable result; the rule repeats {repeated} of them")
    for kind, others in kinds.items():
        flips, caught, words = 0, 0, []
        numbers = list(reliable)
        for place, record in run_each(others, sparse=True):
            outcome, chosen = reliable[numbers[place]]
            if isinstance(record, InputError):
                continue
            other = check_of("", 0.0, measure(record))
            if not same_ending(outcome.ending, other):
                flips, caught = flips + 1, caught + chosen
                words.append(f"{outcome.verdict.value} > {other.verdict}")
        low, high = binomial_interval(caught, flips) if flips else (0.0, 1.0)
        share = f"{caught} of {flips} flips found (95 % interval {100 * low:.0f} to {100 * high:.0f} %)"
        print(f"  {kind}: {share}: {', '.join(f'{words.count(change)} {change}' for change in sorted(set(words)))}")


def cost(name: str, times: int) -> None:
    """Print how long a confirmed run takes by one alone, pair by pair."""
    design, ratios = ff.load_design(name), []
    run(design)
    for _ in range(times):
        spent = []
        for confirm in (False, True):
            start = time.perf_counter()
            run(design, confirm=confirm)
            spent.append(time.perf_counter() - start)
        ratios.append(spent[1] / spent[0])
    low, middle, high = np.min(ratios), np.median(ratios), np.max(ratios)
    print(f"{name}: a confirmed run takes {middle:.2f} times as long as one alone ({low:.2f} to {high:.2f})")


def main() -> None:
    """Calibrate the rule on builds of some designs, or measure what confirming costs."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--of", nargs="+", default=["binder2025", "binder2025-joint"], help="named designs")
    parser.add_argument("--designs", type=int, default=200)
    parser.add_argument("--seed", type=int, default=11)
    parser.add_argument("--cost", type=int, default=0, help="measure the time of so many pairs of runs instead")
    arguments = parser.parse_args()
    for name in arguments.of:
        if arguments.cost:
            cost(name, arguments.cost)
        else:
            calibrate(name, arguments.designs, arguments.seed)


if __name__ == "__main__":
    main()
