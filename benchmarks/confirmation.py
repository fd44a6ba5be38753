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
from forficula.goals.deviation import default_deviations, off_values
from forficula.goals.share_interval import share_interval
from forficula.study.running.evaluate import needs_confirmation
from forficula.study.running.runs import check_of, half_step, run, run_each


def builds(name: str, count: int, seed: int) -> list[Design]:
    """Return designs whose values are off those of a named one by up to 10 % each."""
    base, rng = ff.load_design(name), np.random.default_rng(seed)
    deviations, found = default_deviations(base), []
    while len(found) < count:
        try:
            found.append(base.with_values(off_values(base, deviations, 2 * rng.random(len(deviations)) - 1)))
        except InputError:  # what does not fit together
            continue
    return found


def calibrate(name: str, count: int, seed: int) -> None:
    """Print the flips of a full check, and those that the rule finds."""
    designs = builds(name, count, seed)
    rows = dict(run_each(designs, sparse=True))
    told = {}
    for number, record in rows.items():
        if not isinstance(record, InputError) and (outcome := measure(record)).verdict.tells:
            margins = transition_margins(record, outcome)
            told[number] = (outcome, needs_confirmation(record, outcome, margins))
    kinds = {"half the timestep": [half_step(designs[number]) for number in told]}
    kinds["another start"] = [each for number in told if (each := designs[number].with_other_start()) is not None]
    repeated = sum(chosen for _, chosen in told.values())
    print(f"{name}: {len(told)} of {count} builds tell; the rule repeats {repeated} of them")
    for kind, others in kinds.items():
        flips, caught, words = 0, 0, []
        numbers = list(told)
        for place, record in run_each(others, sparse=True):
            outcome, chosen = told[numbers[place]]
            if isinstance(record, InputError):
                continue
            other = check_of("", 0.0, measure(record))
            if not same_ending(outcome.ending, other):
                flips, caught = flips + 1, caught + chosen
                words.append(f"{outcome.verdict.value} > {other.verdict}")
        low, high = share_interval(caught, flips) if flips else (0.0, 1.0)
        share = f"{caught} of {flips} flips found (95 % interval {100 * low:.0f} to {100 * high:.0f} %)"
        print(f"  {kind}: {share}: {', '.join(f'{words.count(each)} {each}' for each in sorted(set(words)))}")


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
    given = parser.parse_args()
    for name in given.of:
        if given.cost:
            cost(name, given.cost)
        else:
            calibrate(name, given.designs, given.seed)


if __name__ == "__main__":
    main()
