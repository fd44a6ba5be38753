"""The page of an optimisation: what was asked and how far it is met, and every design that was tried, to be played."""

from __future__ import annotations

import math
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from forficula.analysis import Verdict
from forficula.files import write_text
from forficula.goals.goal import Goal, Objective
from forficula.goals.limit import Limit
from forficula.goals.outcome_quantity import PROBABILITY, OutcomeQuantity
from forficula.quantities import show_quantity
from forficula.show.page.bars import BarRow, bar, bar_table
from forficula.show.page.deviation_text import deviation_text
from forficula.show.page.html import section, table
from forficula.show.page.outcome_words import signs_of
from forficula.show.page.rich_html import LaidOut
from forficula.show.page.samples_data import MET, Number, Samples, samples_data
from forficula.show.page.samples_page import about_rows, samples_page
from forficula.structure import structure_of
from forficula.study.kept_runs import KeptRun
from forficula.study.outcome_kinds import transitions_text

if TYPE_CHECKING:
    from xarray import Dataset

_MEETS, _MISSES = "meets the goal", "works, misses a limit"
_NOT_RUN = "ruled out without a run"


def write_goal_page(
    goal: Goal, results: Dataset, found: LaidOut, path: Path, kept: Iterable[KeptRun], count: int, csv: str = ""
) -> None:
    """Write an optimisation as one HTML file that needs no network.

    Args are those of `goal_page`.

    Raises:
        InputError: it cannot be written.
    """
    write_text(path, goal_page(goal, results, found, kept, count, csv))


def goal_page(goal: Goal, results: Dataset, found: LaidOut, kept: Iterable[KeptRun], count: int, csv: str = "") -> str:
    """An optimisation as one page: the goal, the best design's margins, and all that were tried.

    Args:
        goal: what was asked.
        results: what was tried, over "candidate", in the order tried.
        found: the sentence, the tables and the remarks, as the terminal has them.
        kept: the runs that can be played; `point` is the number of the candidate.
        count: how many these are.
        csv: the text of `table.csv`.
    """
    best = best_candidate(results)
    data = _data(goal, results)
    asked = [_limits_table(goal, results, best), _objectives_table(goal, results, best)]
    lines = [each["key"] for each in data["factors"]]
    lines += [name for each in goal.quantities if (name := each.dimension) in results and each.source != "design"]
    objectives = [each.quantity.dimension for each in goal.objectives if each.quantity.dimension in results]
    planes = [*objectives, "margin", lines[0]]
    views = {
        "lines": [*lines, "margin"],
        "plane": {"title": "Front" if len(objectives) > 1 else "Designs", "x": planes[0], "y": planes[1]},
        "order": ["lines", "plane"],
        "best_word": "best",
        "front": _flags(results, "front") if len(objectives) > 1 else [],
        "best": best,
    }
    return samples_page(
        name=goal.name,
        kind="optimise",
        found=found,
        told=(section("What was asked, and what the best one comes to", *filter(None, asked), name="asked"),),
        data=data,
        views=views,
        headings=("All designs that were tried", "The goal"),
        about=_about(goal),
        kept=kept,
        count=count,
        csv=csv,
    )


def best_candidate(results: Dataset) -> int | None:
    """Number of the best candidate; of none that is best, of that which comes nearest; None of none at all."""
    if results.sizes["candidate"] == 0:
        return None
    best = np.flatnonzero(results["best"].values.astype(bool))
    if len(best):
        return int(best[0])
    margins = results["margin"].values.astype(float)
    return int(np.nanargmax(margins)) if np.isfinite(margins).any() else 0


def _data(goal: Goal, results: Dataset) -> dict[str, Any]:
    """The candidates for the page's script."""
    structure = structure_of(goal.base)
    named = results.assign_attrs(transitions=transitions_text(structure, None))
    feasible = results["feasible"].values.astype(bool)
    works = results["works"].values
    words = [
        _MEETS if meets else _MISSES if does else str(word)
        for meets, does, word in zip(feasible, _works(works), results["outcome"].values, strict=True)
    ]
    return samples_data(
        Samples(
            name=goal.name,
            noun="design",
            file="table.csv",
            keeps="The runs of the best designs are kept, as many as --keep says.",
            table=results,
            factors=tuple(each.factor.dimension for each in goal.parameters),
            numbers=_numbers(goal, results),
            words=words,
            signs=signs_of(named, {_MEETS: "●", _MISSES: "◐", _NOT_RUN: "·"}),
            statuses=[str(each) for each in results["status"].values],
            built=[str(each) != Verdict.NOT_BUILT for each in results["verdict"].values],
        )
    )


def _works(works: Any) -> Any:
    """Whether candidates work, whose table has that as a margin or as yes and no."""
    return np.asarray(works, dtype=float) > 0


def _numbers(goal: Goal, results: Dataset) -> tuple[Number, ...]:
    """Quantities with their limits, the least margin, and that of each limit."""
    numbers = []
    aims = {each.quantity.name: each.kind for each in goal.objectives}
    own = {each.factor.dimension for each in goal.parameters}
    for quantity in goal.quantities:
        if quantity.dimension in results and quantity.dimension not in own:
            bounds = tuple((each.kind, each.bound) for each in goal.limits if each.quantity.name == quantity.name)
            aim = aims.get(quantity.name, "")
            numbers.append(Number(variable=quantity.dimension, title=title_of(quantity), aim=aim, bounds=bounds))
    numbers.append(Number(variable="margin", title="least margin", bounds=MET))
    for limit, name in limit_margins(goal):
        if name in results:
            numbers.append(Number(variable=name, title=f"margin: {_limit_text(limit)}", bounds=MET))
    return tuple(numbers)


def limit_margins(goal: Goal) -> list[tuple[Limit, str]]:
    """Each limit with the variable that has its margin: a second one on the same quantity is numbered."""
    found, seen = [], dict[str, int]()
    for limit in goal.limits:
        name = f"margin_{limit.quantity.dimension}"
        seen[name] = seen.get(name, 0) + 1
        found.append((limit, name if seen[name] == 1 else f"{name}_{seen[name]}"))
    return found


def title_of(quantity: OutcomeQuantity) -> str:
    """A quantity's name in words."""
    return quantity.name.replace(".", " ").replace("_", " ")


def _flags(results: Dataset, name: str) -> list[int]:
    """Numbers of the candidates of which something holds."""
    return [int(number) for number in np.flatnonzero(results[name].values.astype(bool))]


def _limits_table(goal: Goal, results: Dataset, best: int | None) -> str:
    """Every limit with what the best design comes to, and the margin as a bar about 0."""
    if best is None:
        return ""
    rows = []
    for limit, name in limit_margins(goal):
        margin = float(results[name].values[best]) if name in results else math.nan
        rows.append(
            BarRow(
                name=_limit_text(limit),
                lanes=((bar(margin, "good" if margin >= 0 else "bad"),),),
                cells=(_value(results, limit.quantity, best), _signed(margin)),
                note=limit.quantity.meaning,
            )
        )
    given = [
        BarRow(
            name=_limit_text(each),
            lanes=((),),
            cells=("given", "—"),
            note="what drives it in every run: what works needs no more",
        )
        for each in goal.given
    ]
    rows = given + rows
    if goal.simulate and "works" in results:
        margin = float(results["works"].values[best])
        does = " and ".join(each.wording.does for each in structure_of(goal.base).transitions) or "it rests"
        row = BarRow(
            name="works in a run",
            lanes=((bar(margin, "good" if margin > 0 else "bad"),),),
            cells=("yes" if margin > 0 else "no", _signed(margin)),
            note=f"{does}; its margin is the share of the time limit that was left",
        )
        rows.insert(0, row)
    if not rows:
        return ""
    which = "the best" if bool(results["best"].values[best]) else "which comes nearest; none meets all"
    caption = f"Limits, and what design {best + 1} comes to, {which}: right of the line is met"
    return bar_table(caption, ("", "missed | met", "comes to", "margin"), rows, (-1.0, 1.0))


def _limit_text(limit: Limit) -> str:
    sign = {">=": "≥", "<=": "≤"}[limit.kind]
    return f"{title_of(limit.quantity)} {sign} {show_quantity(limit.bound, limit.quantity.unit)}"


def _value(results: Dataset, quantity: OutcomeQuantity, point: int) -> str:
    """A quantity of a candidate, a probability with its interval."""
    if quantity.dimension not in results:
        return "—"
    value = float(results[quantity.dimension].values[point])
    if math.isnan(value):
        return "—"
    text = show_quantity(value, quantity.unit)
    if quantity.name == PROBABILITY and "probability_low" in results:
        ends = [float(results[f"probability_{end}"].values[point]) for end in ("low", "high")]
        text += f" ({100 * ends[0]:.3g} to {100 * ends[1]:.3g} %)"
    return text


def _signed(margin: float) -> str:
    """A margin in per cent with its sign."""
    return "—" if math.isnan(margin) else f"{100 * margin:+.3g} %".replace("-", "−")


def _objectives_table(goal: Goal, results: Dataset, best: int | None) -> str:
    """What is to be least or largest, of the best and over all that meet the limits."""
    if best is None:
        return ""
    rows = []
    for each in goal.objectives:
        values = _feasible_values(results, each)
        ends = (
            [show_quantity(float(end), each.quantity.unit) for end in (values.min(), values.max())]
            if len(values)
            else []
        )
        spread = f"{ends[0]} to {ends[1]}" if ends else "none meets them"
        rows.append([f"{each.kind} {title_of(each.quantity)}", _value(results, each.quantity, best), spread])
    headings = ("objective", f"design {best + 1}", "over all that meet the limits")
    return table("What is to be as small or as large as can be", headings, rows)


def _feasible_values(results: Dataset, objective: Objective) -> Any:
    name = objective.quantity.dimension
    if name not in results:
        return np.array([])
    values = results[name].values.astype(float)[results["feasible"].values.astype(bool)]
    return values[np.isfinite(values)]


def _about(goal: Goal) -> list[str]:
    """The goal as its file has it, and how to repeat it."""
    rows = [["design", goal.base.name]]
    rows += [["may vary", str(each)] for each in goal.parameters]
    rows += [["must hold", f"{each}".replace(">=", "≥").replace("<=", "≤")] for each in goal.limits]
    rows += [["to be", f"{each.kind} {title_of(each.quantity)}"] for each in goal.objectives]
    for each in goal.deviations:
        rows.append(["built within", f"{each.key} {deviation_text(goal.base, each)}"])
    rows += [["designs at most", str(goal.runs)], ["side by side", str(goal.batch)], ["seed", str(goal.seed)]]
    if goal.deviations:
        rows.append(["neighbours of one", str(goal.neighbours)])
    return about_rows(rows, goal.base.hash, goal.source, f"forficula optimise {goal.name}")
