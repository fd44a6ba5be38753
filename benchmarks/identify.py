"""Coverage of the ranges of an identification: hidden values are planted, and looked for by what they bring about.

Facts are what a design with hidden values does, exactly or with an error that is uniform within the fact's tolerance.
Hidden values are drawn from what is believed. Stand-ins are closed forms in place of runs of the letter fold, with 60
drawn samples and none placed:

- smooth: a time and an energy over two values;
- steps: how many of 21 conditions close, and an energy;
- jump: a time that part of the samples does not have, and an energy;
- four: three smooth numbers over four values.

    python benchmarks/identify.py [--plantings N] [--only NAME ...] [--folder DIR] [--verbose] [--json FILE]

`letter-fold` runs the simulation, of 48 drawn and up to 12 placed samples, in a folder whose rows are used again; its
default is 24 plantings.
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

from forficula.design import load_design
from forficula.goals.identify import observations_of
from forficula.goals.identify.identify import Finding, Sample
from forficula.goals.identify.marginal import marginals
from forficula.goals.identify.observations import Observations
from forficula.goals.identify.prior import prior_shares, values_at
from forficula.goals.identify.result import build_result
from forficula.goals.identify.run_identify import identify
from forficula.study.factors import Factor
from forficula.study.running.evaluate import evaluate

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
    """Four values in two numbers; facts use the energy twice, once with another stiffness."""
    stiffness, damping = values[_STIFFNESS] / 50, values[_DAMPING] / 0.04
    length, density = (values[_LENGTH] - 0.05) / 0.005, values[_DENSITY] / 800
    return (
        0.2 + 0.16 * density * damping**0.6 / math.sqrt(stiffness) * (1 + 0.2 * length),
        0.04 * stiffness * (1 - 0.3 * length) + 0.01 * density * stiffness**2,
    )


COUNTED: dict[str, Any] = {"quantity": "closed", "statistic": "count", "until": "close"}
COUNTED["over"] = {_LENGTH: "4..6 cm step 0.1"}
LENGTHS = np.linspace(0.04, 0.06, 21).tolist()
# of what a stand-in does not vary, SI
OWN = {_LENGTH: 0.05, _DENSITY: 800.0}
_ABSENT = 2.0
# form, unknowns, facts without their bounds
CASES: dict[str, tuple[Form | None, dict[str, Any], list[dict[str, Any]]]] = {
    "smooth": (smooth, TWO, [CLOSE, STORED]),
    "steps": (steps, TWO, [COUNTED, STORED]),
    "jump": (jump, TWO, [CLOSE, STORED]),
    "four": (
        four,
        FOUR,
        [CLOSE, STORED, {**STORED, "at": {_STIFFNESS: 50.0}}],
    ),
    "letter-fold": (None, TWO, [CLOSE, STORED]),
}


def values_of(form: Form, facts: Sequence[dict[str, Any]], values: Mapping[str, float]) -> list[float]:
    """Return the quantities of the facts for a stand-in, SI."""
    seen = []
    for fact in facts:
        all_values = {**values, **fact.get("at", {})}
        time_, stored = form(all_values)
        if fact["quantity"] == "closed":
            seen.append(float(sum(form({**all_values, _LENGTH: length})[0] is not None for length in LENGTHS)))
        elif fact["quantity"] == "close_time":
            seen.append(_ABSENT if time_ is None else time_)
        else:
            seen.append(stored)
    return seen


def stand_in_samples(form: Form, facts: Sequence[dict[str, Any]], observations: Observations) -> list[Sample]:
    """Return samples of a stand-in, all of them drawn."""
    samples = []
    for number, shares in enumerate(prior_shares(observations.priors, observations.samples, observations.seed)):
        values = {prior.key: float(_si(prior, share)) for prior, share in zip(observations.priors, shares, strict=True)}
        seen = values_of(form, facts, {**OWN, **values})
        findings = []
        for fact, value in zip(observations.facts, seen, strict=True):
            assert isinstance(fact.bound, float)
            miss = value - fact.bound
            met = abs(miss) <= fact.tolerance
            findings.append(Finding(value=value, miss=miss, distance=abs(miss), met=met, conclusive=True, untold=0))
        point = values_at(observations.priors, shares)
        samples.append(Sample(number=number, shares=shares, values=point, findings=tuple(findings)))
    return samples


def _si(prior: Factor, share: float) -> float:
    assert prior.distribution is not None
    return float(prior.distribution.quantiles(np.array([share]))[0])


def observed(
    unknown: dict[str, Any], facts: list[dict[str, Any]], bounds: Sequence[tuple[float, float]], seed: int, samples: int
) -> Observations:
    """Return the facts with their bounds and tolerances, SI."""
    tables = []
    for number, (fact, (bound, tolerance)) in enumerate(zip(facts, bounds, strict=True)):
        unit = {"close_time": " s", "flat_energy": " J"}.get(fact["quantity"])
        bound_keys = {"equals": f"{bound!r}{unit}", "tolerance": f"{tolerance!r}{unit}"} if unit else None
        plain = {key: value for key, value in fact.items() if key != "at"}
        tables.append({"name": f"fact {number}", **plain, **(bound_keys or {"equals": bound, "tolerance": tolerance})})
    sampling = {"samples": samples, "directed": PLACED, "seed": seed}
    return observations_of(
        {"name": "planted", "design": "letter-fold", "unknown": unknown, "sampling": sampling, "fact": tables}
    )


def planting(name: str, number: int, folder: Path) -> dict[str, Any]:
    """Plant values, identify them, and return whether the ranges contain them."""
    form, unknown, facts = CASES[name]
    generator = np.random.default_rng([number, 2026])
    blank = observed(unknown, facts, [(1.0, 0.0)] * len(facts), 0, 1)
    shares = generator.uniform(0, 1, len(unknown))
    hidden = {prior.key: _si(prior, share) for prior, share in zip(blank.priors, shares, strict=True)}
    if form is None:
        (row,) = evaluate([load_design("letter-fold", values_at(blank.priors, shares))])
        seen = [_ABSENT if row["close_time_s"] is None else row["close_time_s"], row["flat_energy_J"]]
    else:
        seen = values_of(form, facts, {**OWN, **hidden})
    bounds = []
    for fact, value in zip(facts, seen, strict=True):
        counted = fact["quantity"] == "closed"
        tolerance = 2.0 if counted else max(TOLERANCE * abs(value), 1e-9)
        # every other planting has an error
        error = generator.uniform(-1, 1) * tolerance * (number % 2)
        bounds.append((float(round(value + error)) if counted else value + error, tolerance))
    start = time.process_time()
    if form is None:
        # the drawn samples are run once for six plantings
        result = identify(observed(unknown, facts, bounds, number // 6, SAMPLES), folder, threads=1)
    else:
        observations = observed(unknown, facts, bounds, number, SAMPLES + PLACED)
        result = build_result(observations, stand_in_samples(form, facts, observations), 0)
    return {**summary(result, hidden), "seconds": time.process_time() - start}


def summary(result: xarray.Dataset, hidden: Mapping[str, float]) -> dict[str, Any]:
    """Return whether every range contains the hidden value, its width, and the conclusion on all facts together."""
    holds, widths, before = [], [], []
    for marginal in marginals(result):
        low, high = (float(end) for end in marginal.agrees)  # type: ignore[arg-type]
        truth = hidden[marginal.key]
        holds.append(bool(low <= truth * (1 + 1e-6) and truth * (1 - 1e-6) <= high))
        shares, values = result[f"{marginal.name}_share"].values, result[marginal.name].values
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
    """Plant values and print how often the ranges contain them."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--plantings", type=int, help="100 of stand-ins, 24 of the simulation")
    parser.add_argument("--only", nargs="*", choices=list(CASES), default=list(CASES))
    parser.add_argument("--folder", type=Path, help="of the letter fold's rows")
    parser.add_argument("--verbose", action="store_true", help="print every planting")
    parser.add_argument("--json", type=Path)
    arguments = parser.parse_args()
    records = {}
    with tempfile.TemporaryDirectory() as scratch:
        for name in arguments.only:
            count = arguments.plantings or (24 if CASES[name][0] is None else 100)
            plantings = []
            for number in range(count):
                plantings.append(planting(name, number, arguments.folder or Path(scratch)))
                if arguments.verbose:
                    print(name, number, json.dumps(plantings[-1]), flush=True)
            held, before = (np.array([one[key] for one in plantings]) for key in ("holds", "before"))
            unmet = [one for one in plantings if not one["met"]]
            records[name] = {
                "plantings": count,
                "values held": [int(held.sum()), held.size],
                "all values held": int(held.all(axis=1).sum()),
                "values held before": [int(before.sum()), before.size],
                "width, share of what is believed": float(np.median([one["widths"] for one in plantings])),
                "no sample met all facts": len(unmet),
                "said to be excluded": sum(one["excluded"] for one in unmet),
                "CPU of a planting, s": float(np.median([one["seconds"] for one in plantings])),
            }
            print(name, json.dumps(records[name]), flush=True)
    if arguments.json:
        arguments.json.write_text(json.dumps(records, indent=2) + "\n", "utf-8")


if __name__ == "__main__":
    main()
