"""Coverage of the ranges of an identification: hidden values are planted, and looked for by what they bring about.

Facts are what a design with hidden values does, exactly or with an error that is uniform within the fact's tolerance.
Hidden values are drawn from what is believed. Stand-ins are closed forms in place of runs of the letter fold:

- smooth: a time and an energy over two values;
- steps: how many of 21 conditions close, and an energy;
- jump: a time that part of the samples does not have, and an energy;
- four: three smooth numbers over four values.

    python benchmarks/identify.py [--plantings N] [--only NAME ...] [--folder DIR] [--json FILE]

`letter-fold` runs the simulation, in a folder whose rows are used again; its default is 24 plantings.
"""

from __future__ import annotations

import argparse
import json
import math
import tempfile
import time
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
import xarray

from forficula.design import key_value, load_design
from forficula.goals.identify import observations_of
from forficula.goals.identify.identify import identify_samples
from forficula.goals.identify.marginal import marginals
from forficula.goals.identify.observations import Observations
from forficula.goals.identify.prior import values_at
from forficula.goals.identify.result import build_result
from forficula.goals.identify.run_identify import identify
from forficula.goals.identify.sample_runs import ConditionRun
from forficula.study.evaluate import evaluate, row_key
from forficula.study.journal import Row

SAMPLES, PLACED, TOLERANCE = 48, 12, 0.04
_STIFFNESS, _DAMPING = "tendon.left.stiffness", "crease.damping"
_LENGTH, _DENSITY = "tendon.left.rest_length", "facet.density"
TWO: dict[str, Any] = {
    _STIFFNESS: {"distribution": "uniform", "low": "0.2 N/cm", "high": "1 N/cm"},
    _DAMPING: {"distribution": "log-uniform", "low": "0.01 N m s/rad/m", "high": "0.1 N m s/rad/m"},
}
FOUR: dict[str, Any] = {
    **TWO,
    _LENGTH: {"distribution": "uniform", "low": "4.5 cm", "high": "5.5 cm"},
    _DENSITY: {"distribution": "uniform", "low": "600 kg/m^3", "high": "1000 kg/m^3"},
}
CLOSE: dict[str, Any] = {"until": "close", "absent": "2 s", "quantity": "close_time"}
STORED: dict[str, Any] = {"until": "close", "absent": "0 J", "quantity": "flat_energy"}
# of a row: time, s, energy, J, or None where it does not close
Numbers = tuple[float | None, float]
Form = Callable[[Mapping[str, float]], Numbers]


def smooth(values: Mapping[str, float]) -> Numbers:
    """Longer where the creases damp more, and more energy where the tendon is stiff."""
    stiffness, damping = values[_STIFFNESS] / 50, values[_DAMPING] / 0.04
    return 0.2 + 0.16 * damping**0.6 / math.sqrt(stiffness), 0.04 * stiffness + 0.02 * stiffness**2 + 5e-3 * damping


def steps(values: Mapping[str, float]) -> Numbers:
    """Closes where a tendon pulls enough at a resting length, which is a condition."""
    time, stored = smooth(values)
    pull = values[_STIFFNESS] / 50 * (0.06 - values[_LENGTH]) / 0.01 - 0.3 * values[_DAMPING] / 0.04
    return (time if pull > 0.2 else None), stored


def jump(values: Mapping[str, float]) -> Numbers:
    """Does not close at all where the damping is large for the stiffness."""
    time, stored = smooth(values)
    return (time if values[_DAMPING] / 0.04 < 0.6 + values[_STIFFNESS] / 50 else None), stored


def four(values: Mapping[str, float]) -> Numbers:
    """Four values in two numbers, of which facts take three combinations of conditions."""
    stiffness, damping = values[_STIFFNESS] / 50, values[_DAMPING] / 0.04
    length, density = (values[_LENGTH] - 0.05) / 0.005, values[_DENSITY] / 800
    return (
        0.2 + 0.16 * density * damping**0.6 / math.sqrt(stiffness) * (1 + 0.2 * length),
        0.04 * stiffness * (1 - 0.3 * length) + 0.01 * density * stiffness**2,
    )


COUNTED: dict[str, Any] = {"quantity": "closed", "statistic": "count", "until": "close"}
LENGTHS = {"over": {_LENGTH: "4..6 cm step 0.1"}}
# form, unknowns, facts without their bounds
CASES: dict[str, tuple[Form | None, dict[str, Any], list[dict[str, Any]]]] = {
    "smooth": (smooth, TWO, [CLOSE, STORED]),
    "steps": (steps, TWO, [{**COUNTED, **LENGTHS}, STORED]),
    "jump": (jump, TWO, [CLOSE, STORED]),
    "four": (
        four,
        FOUR,
        [CLOSE, STORED, {**STORED, "settings": {_STIFFNESS: "0.5 N/cm"}}],
    ),
    "letter-fold": (None, TWO, [CLOSE, STORED]),
}


def rows_of(form: Form, runs: Sequence[ConditionRun]) -> list[Row]:
    """Rows as runs of the letter fold have them, by a closed form."""
    rows = []
    for run in runs:
        numbers = form({key: float(key_value(run.design, key)) for key in FOUR})
        rows.append(
            {
                "key": row_key(run.design),
                "verdict": "reached" if numbers[0] is not None else "stuck",
                "closed": numbers[0] is not None,
                "close_time_s": numbers[0],
                "flat_energy_J": numbers[1],
            }
        )
    return rows


def observed(
    unknown: dict[str, Any], facts: list[dict[str, Any]], bounds: Sequence[tuple[float, float]], seed: int
) -> Observations:
    """The facts with what they are to be, and their tolerances, SI."""
    tables = []
    for number, (fact, (bound, tolerance)) in enumerate(zip(facts, bounds, strict=True)):
        unit = {"close_time": " s", "flat_energy": " J"}.get(fact["quantity"])
        asked = {"equals": f"{bound!r}{unit}", "tolerance": f"{tolerance!r}{unit}"} if unit else None
        tables.append({"name": f"fact {number}", **fact, **(asked or {"equals": bound, "tolerance": tolerance})})
    sampling = {"samples": SAMPLES, "directed": PLACED, "seed": seed}
    return observations_of(
        {"name": "planted", "design": "letter-fold", "unknown": unknown, "sampling": sampling, "fact": tables}
    )


def planting(name: str, number: int, folder: Path) -> dict[str, Any]:
    """Plant values, look for them, and say whether the ranges hold them."""
    form, unknown, facts = CASES[name]
    generator = np.random.default_rng([number, 2026])
    blank = observed(unknown, facts, [(1.0, 0.0)] * len(facts), 0)
    hidden = values_at(blank.priors, generator.uniform(0, 1, len(unknown)))

    def assess(runs: Sequence[ConditionRun]) -> list[Row]:
        if form is not None:
            return rows_of(form, runs)
        rows = {row["key"]: row for row in evaluate([run.design for run in runs])}
        return [rows[run.key] for run in runs]

    # what the hidden values bring about: one sample of choices, each with one value
    alone = observations_of(
        {
            "name": "hidden",
            "design": "letter-fold",
            "unknown": {key: [value] for key, value in hidden.items()},
            "sampling": {"samples": 1, "directed": 0},
            "fact": [{"name": f"fact {each}", **fact, "equals": _none(fact)} for each, fact in enumerate(facts)],
        }
    )
    seen = [each.value for each in identify_samples(alone, assess)[0].findings]
    bounds = []
    for fact, value in zip(facts, seen, strict=True):
        counted = fact["quantity"] == "closed"
        tolerance = 2.0 if counted else max(TOLERANCE * abs(value), 1e-9)
        # every other planting has an error
        error = generator.uniform(-1, 1) * tolerance * (number % 2)
        bounds.append((float(round(value + error)) if counted else value + error, tolerance))
    # the letter fold's samples are run once for six plantings
    asked = observed(unknown, facts, bounds, number // 6 if form is None else number)
    start = time.process_time()
    if form is None:
        result = identify(asked, folder, threads=1)
    else:
        result = build_result(asked, identify_samples(asked, assess), 0)
    return {**told(result, load_design("letter-fold", hidden)), "seconds": time.process_time() - start}


def _none(fact: dict[str, Any]) -> object:
    return 0 if fact["quantity"] == "closed" else "0 " + {"close_time": "s", "flat_energy": "J"}[fact["quantity"]]


def told(result: xarray.Dataset, hidden: Any) -> dict[str, Any]:
    """Whether every range holds what was hidden, how wide it is, and what is said of all facts together."""
    holds, widths, before = [], [], []
    for each in marginals(result):
        low, high = (float(end) for end in each.agrees)  # type: ignore[arg-type]
        truth = float(key_value(hidden, each.key))
        holds.append(bool(low <= truth * (1 + 1e-6) and truth * (1 - 1e-6) <= high))
        shares, values = result[f"{each.name}_share"].values, result[each.name].values
        widths.append(float(np.ptp(np.interp([low, high], np.sort(values), np.sort(shares)))))
        # what was printed before: 5th to 95th percentile of the drawn samples that agree
        agreeing = np.sort(values[result["agrees"].values])
        ends = agreeing[[int(0.05 * len(agreeing)), min(int(0.95 * len(agreeing)), len(agreeing) - 1)]]
        before.append(bool(ends[0] <= truth <= ends[1]))
    met = bool(result["met"].values.all(axis=1).any())
    return {
        "holds": holds,
        "widths": widths,
        "before": before,
        "met": met,
        "excluded": not met and not result.attrs["between_possible"],
    }


def main() -> None:
    """Plant, and print how often the ranges hold what was planted."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--plantings", type=int, help="100 of stand-ins, 24 of the simulation")
    parser.add_argument("--only", nargs="*", choices=list(CASES), default=list(CASES))
    parser.add_argument("--folder", type=Path, help="of the letter fold's rows")
    parser.add_argument("--json", type=Path)
    given = parser.parse_args()
    records = {}
    with tempfile.TemporaryDirectory() as scratch:
        for name in given.only:
            count = given.plantings or (24 if CASES[name][0] is None else 100)
            found = [planting(name, number, given.folder or Path(scratch)) for number in range(count)]
            held, before = (np.array([each[key] for each in found]) for key in ("holds", "before"))
            unmet = [each for each in found if not each["met"]]
            records[name] = {
                "plantings": count,
                "values held": [int(held.sum()), held.size],
                "all values held": int(held.all(axis=1).sum()),
                "values held before": [int(before.sum()), before.size],
                "width, share of what is believed": float(np.median([each["widths"] for each in found])),
                "no sample met all facts": len(unmet),
                "said to be excluded": sum(each["excluded"] for each in unmet),
                "CPU of a planting, s": float(np.median([each["seconds"] for each in found])),
            }
            print(name, json.dumps(records[name]), flush=True)
    if given.json:
        given.json.write_text(json.dumps(records, indent=2) + "\n", "utf-8")


if __name__ == "__main__":
    main()
