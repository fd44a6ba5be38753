"""Page of an optimisation: the goal, its margins for the best design, and all designs that were tried, to play back."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from forficula.analysis import Verdict
from forficula.files import write_text
from forficula.goals.goal import Goal
from forficula.goals.optimise.optimum import Optimum
from forficula.goals.optimise.optimum_table import optimum_csv
from forficula.goals.outcome_quantity import PROBABILITY
from forficula.show.page.data.samples_data import MET, PointQuantity, ShownSamples, samples_data
from forficula.show.page.parts.deviation_text import deviation_text
from forficula.show.page.parts.goal_tables import (
    effort_table,
    limit_margins,
    limit_text,
    limits_table,
    objectives_table,
    relaxations_table,
    title_of,
    verifications_table,
)
from forficula.show.page.parts.html import section
from forficula.show.page.parts.outcome_words import signs_of
from forficula.show.page.parts.rich_html import PrintedResult
from forficula.show.page.samples_page import about_rows, samples_page
from forficula.structure import structure_of
from forficula.study.running.kept_runs import KeptRun
from forficula.study.tables.outcome_kinds import transitions_text

if TYPE_CHECKING:
    from xarray import Dataset

_MEETS, _MISSES, _FEW = "meets the goal", "works, misses a limit", "works, too few neighbours work"
_UNASKED, _LOST = "meets its limits, neighbours not run", "not confirmed by verification"
_RULED_OUT, _MISSES_PLAINLY = "ruled out without a run", "misses a limit"
_SIGNS = {_MEETS: "●", _UNASKED: "○", _LOST: "□", _FEW: "◒", _MISSES: "◐", _MISSES_PLAINLY: "×", _RULED_OUT: "·"}
_NOT_RUN = "not run"
_SHARE = {"units": "", "display": "%"}


def write_goal_page(
    optimum: Optimum, printed: PrintedResult, path: Path, kept: Iterable[KeptRun] = (), count: int = 0
) -> None:
    """Write an optimisation as one HTML file that needs no network.

    Args are those of `goal_page`.

    Raises:
        InputError: it cannot be written.
    """
    write_text(path, goal_page(optimum, printed, kept, count))


def goal_page(optimum: Optimum, printed: PrintedResult, kept: Iterable[KeptRun] = (), count: int = 0) -> str:
    """Return an optimisation as one page: the goal, the best design's margins, and all designs that were tried.

    Args:
        optimum: the result of the optimisation.
        printed: the sentence and the remarks of the terminal; tables that this page does not have.
        kept: runs that the page can play back; `point` is the index of the candidate.
        count: number of these runs.
    """
    goal, best = optimum.goal, shown_candidate(optimum)
    results = _in_percent(optimum)
    answers = (
        [limits_table(optimum, results, best), objectives_table(optimum, results, best), verifications_table(optimum)]
        if best is not None
        else []
    )
    return samples_page(
        name=goal.name,
        kind="optimise",
        printed=printed,
        before=(
            section("Limits, objectives and verification", *answers, name="asked"),
            section("Limits that no design meets", relaxations_table(optimum), name="give"),
        ),
        after=(section("Cost of the search", effort_table(optimum), name="effort"),),
        data=_data(goal, optimum, results),
        views=_views(goal, optimum, results, best),
        headings=("All designs that were tried", "The goal"),
        about=_about(goal),
        kept=kept,
        count=count,
        csv=optimum_csv(optimum.table),
    )


def shown_candidate(optimum: Optimum) -> int | None:
    """Return the index of the candidate that a page opens with: the best with the largest margin, or the nearest.

    None if no design was tried.
    """
    if not optimum.candidates:
        return None
    margins = optimum.table["margin"].values.astype(float)
    best = optimum.table["best"].values.astype(bool)
    # the margin of a candidate that was ruled out early includes only the limits checked until then
    known = best if best.any() else optimum.table["works"].values.astype(bool)
    known = known if known.any() else np.ones(len(margins), dtype=bool)
    return int(np.argmax(np.where(known & np.isfinite(margins), margins, -np.inf)))


def _in_percent(optimum: Optimum) -> Dataset:
    """Return the table with shares marked to be shown in per cent."""
    table = optimum.table.copy()
    for name in map(str, table.data_vars):
        if name.startswith(("margin", PROBABILITY)):
            table[name] = table[name].assign_attrs(_SHARE)
    return table.assign_attrs(transitions=transitions_text(structure_of(optimum.goal.base), None))


def _views(goal: Goal, optimum: Optimum, results: Dataset, best: int | None) -> dict[str, Any]:
    lines = [parameter.key for parameter in goal.parameters]
    lines += [
        quantity.dimension
        for quantity in goal.quantities
        if quantity.dimension in results and quantity.name not in lines
    ]
    several = len(goal.objectives) > 1
    keys = {parameter.key for parameter in goal.parameters}
    objectives = [objective.quantity for objective in goal.objectives]
    named = [objective.name if objective.name in keys else objective.dimension for objective in objectives]
    planes = [*(name for name in named if name in keys or name in results), "margin", lines[0]]
    return {
        "order": ["lines", "plane"],
        "lines": [*lines, "margin"],
        "plane": {"title": "Front" if several else "Designs", "x": planes[0], "y": planes[1]},
        "front": np.flatnonzero(results["front"].values.astype(bool)).tolist() if several else [],
        "best": best,
        "best_word": ("most margin" if several else "best") if optimum.feasible else "nearest",
    }


def _data(goal: Goal, optimum: Optimum, results: Dataset) -> dict[str, Any]:
    """Return the candidates as data for the page's script."""
    return samples_data(
        ShownSamples(
            name=goal.name,
            noun="design",
            file="table.csv",
            keeps="The runs of the best designs, and of some others, are kept.",
            table=results,
            factors=tuple(parameter.factor.dimension for parameter in goal.parameters),
            numbers=_numbers(goal, results),
            words=[_word(optimum, results, number) for number in range(len(optimum.candidates))],
            signs=signs_of(results, _SIGNS),
            statuses=[str(value) for value in results["status"].values],
            built=[str(value) != Verdict.NOT_BUILT for value in results["verdict"].values],
        )
    )


def _word(optimum: Optimum, results: Dataset, number: int) -> str:
    """Return the outcome of a candidate in a few words."""
    if bool(results["feasible"].values[number]):
        return _MEETS
    candidate, outcome = optimum.candidates[number], str(results["outcome"].values[number])
    if candidate.point in {item.candidate.point for item in optimum.discarded}:
        return _LOST
    if candidate.screened.meets:
        return _UNASKED if candidate.neighbours is None else _FEW
    if outcome == _NOT_RUN:
        return _RULED_OUT if optimum.goal.simulate else _MISSES_PLAINLY
    return _MISSES if candidate.screened.works > 0 else outcome


def _numbers(goal: Goal, results: Dataset) -> tuple[PointQuantity, ...]:
    """Return the quantities with their limits, the least margin, and the margin of each limit."""
    numbers = []
    aims = {objective.quantity.name: objective.kind for objective in goal.objectives}
    varied = {parameter.factor.dimension for parameter in goal.parameters}
    for quantity in goal.quantities:
        if quantity.dimension in results and quantity.dimension not in varied:
            bounds = tuple((limit.kind, limit.bound) for limit in goal.limits if limit.quantity.name == quantity.name)
            aim = aims.get(quantity.name, "")
            numbers.append(PointQuantity(variable=quantity.dimension, title=title_of(quantity), aim=aim, bounds=bounds))
    numbers.append(PointQuantity(variable="margin", title="least margin", bounds=MET))
    if goal.simulate:
        numbers.append(PointQuantity(variable="margin_works", title="margin: works in a run", bounds=MET))
    for limit, name in limit_margins(goal):
        if name in results:
            numbers.append(PointQuantity(variable=name, title=f"margin: {limit_text(limit)}", bounds=MET))
    return tuple(numbers)


def _about(goal: Goal) -> list[str]:
    """Return the goal as in its file, and the command that repeats the optimisation."""
    rows = [["design", goal.base.name]]
    rows += [["may vary", str(parameter)] for parameter in goal.parameters]
    rows += [["must hold", limit_text(limit)] for limit in (*goal.torque_limits, *goal.limits)]
    rows += [["objective", f"{objective.kind} {title_of(objective.quantity)}"] for objective in goal.objectives]
    rows += [["tolerance", f"{deviation.key} {deviation_text(goal.base, deviation)}"] for deviation in goal.deviations]
    rows += [
        ["largest number of designs", str(goal.runs)],
        ["designs per batch", str(goal.batch)],
        ["seed", str(goal.seed)],
    ]
    if goal.deviations:
        rows.append(["neighbours of one design", str(goal.neighbours)])
    return about_rows(rows, goal.base.hash, goal.source, f"forficula optimise {goal.name}")
