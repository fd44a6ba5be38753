"""What an optimisation came to, in tables of its page: margins, objectives, what was verified, what it took."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from forficula.goals.goal import Goal, Objective, own_limits
from forficula.goals.limit import Limit
from forficula.goals.optimise.candidate import Neighbours, Verification
from forficula.goals.optimise.optimum import Optimum
from forficula.goals.outcome_quantity import PROBABILITY, OutcomeQuantity
from forficula.quantities import show_quantity, show_value
from forficula.show.page.parts.bars import BarRow, bar, bar_table, percent_text
from forficula.show.page.parts.html import table
from forficula.structure import structure_of

if TYPE_CHECKING:
    from xarray import Dataset

# what rules a design out before it is run, by what is asked of it
_BY = {
    "not built": "cannot be built",
    "design": "its own values",
    "parts": "its parts",
    "hinges": "closed forms of its hinges",
    "fold": "the energy along its fold",
    "slow": "slowly growing drives",
}


def limit_margins(goal: Goal) -> list[tuple[Limit, str]]:
    """Each of a design's own limits with the variable of its margin: a second one on the same quantity is numbered."""
    found, seen = [], dict[str, int]()
    for limit in own_limits(goal):
        name = f"margin_{limit.quantity.dimension}"
        seen[name] = seen.get(name, 0) + 1
        found.append((limit, name if seen[name] == 1 else f"{name}_{seen[name]}"))
    return found


def title_of(quantity: OutcomeQuantity) -> str:
    """A quantity's name in words."""
    return quantity.name.replace(".", " ").replace("_", " ")


def limit_text(limit: Limit) -> str:
    """A limit in words, such as "holding torque ≥ 5 N cm"."""
    sign = {">=": "≥", "<=": "≤"}[limit.kind]
    return f"{title_of(limit.quantity)} {sign} {show_quantity(limit.bound, limit.quantity.unit)}"


def limits_table(optimum: Optimum, results: Dataset, point: int) -> str:
    """Every limit with what a candidate comes to, and the margin as a bar about 0."""
    goal = optimum.goal
    rows = []
    if goal.simulate:
        margin = float(results["margin_works"].values[point])
        does = " and ".join(each.wording.does for each in structure_of(goal.base).transitions) or "comes to rest"
        note = f"{does}; its margin is the share of a time limit that was left, or of the way that was missing"
        yes = "—" if math.isnan(margin) else "yes" if margin > 0 else "no"
        rows.append(_margin_row("works in a run", margin, yes, note, met=margin > 0))
    for limit in goal.given:
        note = "drives every run: what works needs no more"
        rows.append(BarRow(name=limit_text(limit), lanes=((),), cells=("given", "—"), note=note))
    for limit, name in limit_margins(goal):
        margin = float(results[name].values[point])
        value = _value(results, limit.quantity, point)
        rows.append(_margin_row(limit_text(limit), margin, value, limit.quantity.meaning, met=margin >= 0))
    for limit in goal.limits:
        if limit.quantity.name == PROBABILITY:
            share = float(results[PROBABILITY].values[point])
            margin = math.nan if math.isnan(share) else limit.margin(share)
            value = _value(results, limit.quantity, point)
            rows.append(_margin_row(limit_text(limit), margin, value, limit.quantity.meaning, met=margin >= 0))
    if not rows:
        return ""
    which = "" if optimum.feasible else ", which comes nearest: none meets all"
    caption = f"Limits, and what design {point + 1} comes to{which}; right of the line is met"
    return bar_table(caption, ("", "missed | met", "comes to", "margin"), rows, (-1.0, 1.0))


def _margin_row(name: str, margin: float, value: str, note: str, *, met: bool) -> BarRow:
    signed = "—" if math.isnan(margin) else f"{'+' if margin > 0 else ''}{percent_text(margin)} %"
    return BarRow(name=name, lanes=((bar(margin, "good" if met else "bad"),),), cells=(value, signed), note=note)


def _value(results: Dataset, quantity: OutcomeQuantity, point: int) -> str:
    """A quantity of a candidate, a probability with its interval."""
    source = results.get(quantity.dimension)
    if source is None or math.isnan(value := float(source.values[point])):
        return "—"
    if quantity.name != PROBABILITY:
        return show_quantity(value, quantity.unit)
    ends = (float(results[f"{PROBABILITY}_{end}"].values[point]) for end in ("low", "high"))
    return f"{percent_text(value)} % ({' to '.join(map(percent_text, ends))})"


def objectives_table(optimum: Optimum, results: Dataset, point: int) -> str:
    """What is to be least or largest, of one candidate and over all that meet the limits."""
    rows = []
    for each in optimum.goal.objectives:
        ends = [_shown(each, end) for end in _ends(results, each)]
        title = f"{each.kind} {title_of(each.quantity)}"
        rows.append([title, _value(results, each.quantity, point), " to ".join(ends) or "none meets them"])
    headings = ("objective", f"design {point + 1}", "over all that meet the limits")
    return table("What is to be as small or as large as can be", headings, rows)


def _shown(objective: Objective, value: float) -> str:
    unit = objective.quantity.unit
    return f"{percent_text(value)} %" if unit.display == "%" else show_quantity(value, unit)


def _ends(results: Dataset, objective: Objective) -> list[float]:
    """The least and the largest value of those that meet all limits."""
    values = results[objective.quantity.dimension].values.astype(float)
    values = values[results["feasible"].values.astype(bool) & np.isfinite(values)]
    return [float(values.min()), float(values.max())] if len(values) else []


def verifications_table(optimum: Optimum) -> str:
    """How the best do where the search did not look: at a finer timestep, and of fresh neighbours."""
    numbers = {each.point: str(number + 1) for number, each in enumerate(optimum.candidates)}
    checked = [each for each in (*optimum.best, *optimum.discarded) if each.finer is not None or each.fresh is not None]
    rows = [
        [numbers.get(each.candidate.point, ""), *_finer(each), _fresh(each.fresh), "yes" if each.holds else "no"]
        for each in checked
    ]
    headings = ("design", "a quarter of", "margin there", "energy missing", "fresh neighbours that work", "holds")
    return table("Verified where the search did not look", headings, rows) if rows else ""


def _finer(verification: Verification) -> list[str]:
    finer, step, residual = verification.finer, verification.timestep, verification.residual
    if finer is None:
        return ["—", "—", "—"]
    missing = "—" if residual is None else f"{percent_text(residual)} %"
    return ["—" if step is None else show_value(step, "s"), f"{percent_text(finer.least)} %", missing]


def _fresh(neighbours: Neighbours | None) -> str:
    if neighbours is None:
        return "—"
    low, high = neighbours.interval
    return f"{neighbours.works} of {neighbours.tried} ({percent_text(low)} to {percent_text(high)} %)"


def relaxations_table(optimum: Optimum) -> str:
    """Where nothing meets the goal, how near each limit was met, and what would be had if it alone gave."""
    names = [limit_text(each) for each in own_limits(optimum.goal)] + ["works in a run"]
    rows = [
        BarRow(
            name=names[each.limit],
            lanes=((bar(each.best, "good" if each.best >= 0 else "bad"),),),
            cells=(_margin_text(each.best), _margin_text(each.alone)),
        )
        for each in optimum.relaxations
    ]
    headings = ("", "missed | met", "largest margin of any", "where all others are met")
    return bar_table("The largest margin that any design has", headings, rows, (-1.0, 1.0)) if rows else ""


def _margin_text(margin: float) -> str:
    return "none" if math.isnan(margin) else f"{percent_text(margin)} %"


def effort_table(optimum: Optimum) -> str:
    """What the search cost, and what it did without."""
    effort = optimum.effort
    rows: list[list[Any]] = [["designs that were tried", str(effort.tried)], ["of these run", str(effort.runs)]]
    rows += [[f"ruled out before, by {_BY.get(by, by)}", str(count)] for by, count in effort.ruled_out.items()]
    if optimum.goal.deviations:
        rows.append(["neighbours that were run", str(effort.neighbour_runs)])
        rows.append(["neighbours that did not need to be asked", str(effort.spared_neighbours)])
    rows.append(["runs to verify the best", str(effort.verification_runs)])
    rows.append(["runs saved", str(effort.spared_runs + effort.spared_neighbours)])
    return table("Runs that were made, and those that were not", ("", ""), rows)
