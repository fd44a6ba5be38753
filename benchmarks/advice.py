"""Whether the advice that a failing run gives helps: random failing designs, run again with the values advised."""

from __future__ import annotations

import argparse
import json
import time
from collections import defaultdict
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from forficula.analysis import Outcome, Verdict, measure
from forficula.analysis.margin import combined_margin, transition_margins
from forficula.design import Design, load_design, with_values
from forficula.errors import InputError
from forficula.study.running.runs import run_each

Values = dict[str, object]

_WANTED = 0.90  # of the designs that a kind of advice is given to


@dataclass(frozen=True, kw_only=True)
class Trial:
    """A design that failed, the advice that its run gave, and what that did.

    Attributes:
        kind: of the advice, or of the failure where no values were advised.
        text: of the advice.
        values: that were advised.
        before: the verdict and the margin.
        after: with these values; None where none were advised.
        helped: whether the run reached its goals, its margin grew, or it says something where it said nothing.
    """

    kind: str
    text: str
    values: Values
    before: tuple[str, float]
    after: tuple[str, float] | None
    helped: bool | None


def main() -> None:
    """Try the advice, and print a table by kind."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--designs", type=int, default=100, help="of each family")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--family", choices=sorted(FAMILIES), action="append", help="only these")
    parser.add_argument("--json", type=Path, help="write every trial here, too")
    arguments = parser.parse_args()
    trials: list[Trial] = []
    for family in arguments.family or FAMILIES:
        start = time.perf_counter()
        tried = try_advice(draw(family, arguments.designs, arguments.seed))
        trials += tried
        print(
            f"{family}: {len(tried)} of {arguments.designs} fail, {time.perf_counter() - start:.0f} s",
            flush=True,
        )
    print(table(trials))
    if arguments.json is not None:
        arguments.json.write_text(json.dumps([vars(trial) for trial in trials], indent=1, default=str) + "\n")


def try_advice(designs: Sequence[Design], threads: int = 1) -> list[Trial]:
    """Run designs, and those that fail once more with the values that their runs advise."""
    first = _run(designs, threads)
    failed = [(design, *run) for design, run in zip(designs, first, strict=True) if run and not _good(run[0])]
    advised = [(design, outcome.advised, _margin) for design, outcome, _margin in failed if outcome.advised.values]
    again = iter(_run([with_values(design, advice.values) for design, advice, _ in advised], threads))
    trials = []
    for _, outcome, margin in failed:
        advice, before = outcome.advised, (outcome.verdict.value, margin)
        if not advice.values:
            kind = f"none: {outcome.verdict.value}"
            trials.append(Trial(kind=kind, text=advice.text, values={}, before=before, after=None, helped=None))
            continue
        repeated = next(again)
        helped = repeated is not None and _helped(outcome, margin, *repeated)
        after = ("not built", -1.0) if repeated is None else (repeated[0].verdict.value, repeated[1])
        trials.append(
            Trial(
                kind=advice.kind,
                text=advice.text,
                values=dict(advice.values),
                before=before,
                after=after,
                helped=helped,
            )
        )
    return trials


def _helped(before: Outcome, margin: float, after: Outcome, new_margin: float) -> bool:
    if not after.verdict.conclusive:
        return False
    return _good(after) or new_margin > margin or not before.verdict.conclusive


def _good(outcome: Outcome) -> bool:
    return outcome.verdict is Verdict.REACHED


def _run(designs: Sequence[Design], threads: int) -> list[tuple[Outcome, float] | None]:
    """The outcome and the margin of each design; None of one that cannot be built."""
    results: list[tuple[Outcome, float] | None] = [None] * len(designs)
    for number, record in run_each(designs, threads, sparse=True):
        if not isinstance(record, InputError):
            outcome = measure(record)
            results[number] = outcome, combined_margin(list(transition_margins(record, outcome).values()))
    return results


def table(trials: Sequence[Trial]) -> str:
    """How many designs each kind of advice was given to, and how many of them it helped, as Markdown."""
    kinds: defaultdict[str, list[Trial]] = defaultdict(list)
    for trial in trials:
        kinds[trial.kind].append(trial)
    rows = ["| advice | designs | helps | reaches its goals | |", "|---|---|---|---|---|"]
    for kind, of in sorted(kinds.items()):
        if of[0].after is None:
            rows.append(f"| {kind} | {len(of)} | | | |")
            continue
        helped = sum(bool(trial.helped) for trial in of)
        reached = sum(trial.after is not None and trial.after[0] == "reached" for trial in of)
        share = helped / len(of)
        verdict = "" if share >= _WANTED else "fails"
        rows.append(f"| {kind} | {len(of)} | {helped} ({100 * share:.0f} %) | {reached} | {verdict} |")
    return "\n".join(rows)


def draw(family: str, count: int, seed: int) -> list[Design]:
    """Random designs of a family; what cannot be read is drawn again."""
    rng = np.random.default_rng(seed)
    name, values = FAMILIES[family]
    base, designs = load_design(name), list[Design]()
    while len(designs) < count:
        try:
            designs.append(with_values(base, values(rng)))
        except InputError:
            continue
    return designs


def _log(rng: np.random.Generator, least: float, most: float) -> float:
    return float(np.exp(rng.uniform(np.log(least), np.log(most))))


def _wing(rng: np.random.Generator) -> Values:
    """Return wings within the ranges of the paper and around the reference, some with less time.

    Timesteps are 0.1 to 0.4 ms, and some wings diverge.
    """
    return {
        "tendon.stiffness": f"{_log(rng, 3, 60)} N/cm",
        "tendon.rest_length": f"{rng.uniform(3, 12)} cm",
        "protocol.fold_torque": f"{_log(rng, 5, 100)} N cm",
        "protocol.unfold_torque": f"{_log(rng, 10, 150)} N cm",
        "protocol.rise": f"{rng.choice([0, 0, 0, 0.2])} s",
        "pattern.sector_angle": f"{rng.uniform(12, 28)} deg",
        "pattern.proximal_length": f"{rng.uniform(8, 14)} cm",
        "pattern.distal_length": f"{rng.uniform(7, 11)} cm",
        "hinge.overbend": f"{rng.uniform(1, 8)} deg",
        "hinge.damping": f"{_log(rng, 3e-4, 1e-2)} N m s/rad",
        "membrane.youngs_modulus": f"{_log(rng, 0.3, 5)} MPa",
        "protocol.stages.1.time_limit": f"{_log(rng, 0.05, 2)} s",
        "protocol.stages.3.time_limit": f"{_log(rng, 0.12, 2)} s",
        "protocol.initial_overbend": "0.9 deg",
        "protocol.timestep": f"{rng.choice([0.1, 0.1, 0.1, 0.2])} ms",
    }


def _stiff(rng: np.random.Generator) -> Values:
    """Membranes too stiff for the timestep: runs that diverge or miss energy."""
    return {
        "membrane.youngs_modulus": f"{_log(rng, 10, 60)} MPa",
        "tendon.stiffness": f"{_log(rng, 5, 20)} N/cm",
        "hinge.damping": f"{_log(rng, 3e-4, 1e-2)} N m s/rad",
        "protocol.stages": [stage.model_dump() for stage in load_design("binder2025").protocol.stages[:2]],
    }


def _joint(rng: np.random.Generator) -> Values:
    return {
        "tendon.stiffness": f"{_log(rng, 3, 60)} N/cm",
        "tendon.rest_length": f"{rng.uniform(5, 12)} cm",
        "protocol.fold_torque": f"{_log(rng, 2, 50)} N cm",
        "protocol.unfold_torque": f"{_log(rng, 5, 150)} N cm",
        "hinge.overbend": f"{rng.uniform(1, 8)} deg",
        "hinge.damping": f"{_log(rng, 3e-4, 1e-2)} N m s/rad",
        "protocol.stages.1.time_limit": f"{_log(rng, 0.05, 2)} s",
        "protocol.stages.3.time_limit": f"{_log(rng, 0.12, 2)} s",
        "protocol.initial_overbend": "0.9 deg",
    }


def _letter(rng: np.random.Generator) -> Values:
    """A sheet of three plates: other tendons, weaker and stronger drives, less time."""
    return {
        "tendon.left.stiffness": f"{_log(rng, 0.1, 3)} N/cm",
        "tendon.right.stiffness": f"{_log(rng, 0.1, 3)} N/cm",
        "drive.close.value": f"{_log(rng, 0.3, 10)} N cm",
        "drive.open.value": f"{-_log(rng, 0.3, 10)} N cm",
        "protocol.stages.1.time_limit": f"{_log(rng, 0.1, 3)} s",
        "protocol.stages.3.time_limit": f"{_log(rng, 0.2, 3)} s",
    }


FAMILIES: dict[str, tuple[str, Callable[[np.random.Generator], Values]]] = {
    "wing": ("binder2025", _wing),
    "stiff": ("binder2025", _stiff),
    "joint": ("binder2025-joint", _joint),
    "letter": ("letter-fold", _letter),
}


if __name__ == "__main__":
    main()
