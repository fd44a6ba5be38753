"""Tables of an optimisation's page: margins, objectives, verification and number of runs."""

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

# reasons for which a design is ruled out before its run, by the quantity that was checked
_RULED_OUT_BY = {
    "not built": "cannot be built",
    "design": "its own values",
    "parts": "its parts",
    "sheet": "its flat-folded sheet",
    "hinges": "closed forms of its hinges",
    "fold": "the energy along its fold",
    "slow": "slowly growing drives",
}


def limit_margins(goal: Goal) -> list[tuple[Limit, str]]:
    """Return a design's own limits with the variables of their margins; a second limit on a quantity is numbered."""
    limits, seen = [], dict[str, int]()
    for limit in own_limits(goal):
        name = f"margin_{limit.quantity.dimension}"
        seen[name] = seen.get(name, 0) + 1
        limits.append((limit, name if seen[name] == 1 else f"{name}_{seen[name]}"))
    return limits


def title_of(quantity: OutcomeQuantity) -> str:
    """Return a quantity's name in words."""
    return quantity.name.replace(".", " ").replace("_", " ")


def limit_text(limit: Limit) -> str:
    """Return a limit in words, such as "holding torque ≥ 5 N cm"."""
    sign = {">=": "≥", "<=": "≤"}[limit.kind]
    return f"{title_of(limit.quantity)} {sign} {show_quantity(limit.bound, limit.quantity.unit)}"


def limits_table(optimum: Optimum, results: Dataset, point: int) -> str:
    """Return a table of every limit, with the candidate's value and its margin as a bar about 0."""
    goal = optimum.goal
    rows = []
    if goal.simulate:
        margin = float(results["margin_works"].values[point])
        does = (
            " and ".join(transition.wording.does for transition in structure_of(goal.base).transitions)
            or "comes to rest"
        )
        note = f"{does}; margin: remaining share of a time limit, or missing share of the motion"
        yes = "—" if math.isnan(margin) else "yes" if margin > 0 else "no"
        rows.append(_margin_row("works in a run", margin, yes, note, met=margin > 0))
    for limit in goal.torque_limits:
        note = "every run is driven with this value, so a design that works meets the limit"
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
    caption = f"Limits and values of design {point + 1}{which}; a bar right of the line means that the limit is met"
    return bar_table(caption, ("", "missed | met", "value", "margin"), rows, (-1.0, 1.0))


def _margin_row(name: str, margin: float, value: str, note: str, *, met: bool) -> BarRow:
    signed = "—" if math.isnan(margin) else f"{'+' if margin > 0 else ''}{percent_text(margin)} %"
    return BarRow(name=name, lanes=((bar(margin, "good" if met else "bad"),),), cells=(value, signed), note=note)


def _value(results: Dataset, quantity: OutcomeQuantity, point: int) -> str:
    """Return a quantity of a candidate as text, a probability with its interval."""
    source = results.get(quantity.dimension)
    if source is None or math.isnan(value := float(source.values[point])):
        return "—"
    if quantity.name != PROBABILITY:
        return show_quantity(value, quantity.unit)
    ends = (float(results[f"{PROBABILITY}_{end}"].values[point]) for end in ("low", "high"))
    return f"{percent_text(value)} % ({' to '.join(map(percent_text, ends))})"


def objectives_table(optimum: Optimum, results: Dataset, point: int) -> str:
    """Return a table of the objectives: the value of one candidate and the range over all that meet the limits."""
    rows = []
    for objective in optimum.goal.objectives:
        ends = [_shown(objective, end) for end in _ends(results, objective)]
        title = f"{objective.kind} {title_of(objective.quantity)}"
        rows.append([title, _value(results, objective.quantity, point), " to ".join(ends) or "no design meets them"])
    headings = ("objective", f"design {point + 1}", "range of all designs that meet the limits")
    return table("Objectives", headings, rows)


def _shown(objective: Objective, value: float) -> str:
    unit = objective.quantity.unit
    return f"{percent_text(value)} %" if unit.display == "%" else show_quantity(value, unit)


def _ends(results: Dataset, objective: Objective) -> list[float]:
    """Return the least and the largest value of the designs that meet all limits."""
    values = results[objective.quantity.dimension].values.astype(float)
    values = values[results["feasible"].values.astype(bool) & np.isfinite(values)]
    return [float(values.min()), float(values.max())] if len(values) else []


def verifications_table(optimum: Optimum) -> str:
    """Return a table of verifications: the best designs at a finer timestep, and fresh neighbours of theirs."""
    numbers = {candidate.point: str(number + 1) for number, candidate in enumerate(optimum.candidates)}
    checked = [item for item in (*optimum.best, *optimum.discarded) if item.finer is not None or item.fresh is not None]
    rows = [
        [numbers.get(item.candidate.point, ""), *_finer(item), _fresh(item.fresh), "yes" if item.holds else "no"]
        for item in checked
    ]
    headings = (
        "design",
        "timestep (checked at 1/4)",
        "margin at 1/4",
        "energy residual",
        "new neighbours that work",
        "confirmed",
    )
    return table("Verification at a finer timestep and with new neighbours", headings, rows) if rows else ""


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
    """Return a table for a goal that no design meets: largest margin of each limit, alone and with the others met."""
    names = [limit_text(limit) for limit in own_limits(optimum.goal)] + ["works in a run"]
    rows = [
        BarRow(
            name=names[relaxation.limit],
            lanes=((bar(relaxation.best, "good" if relaxation.best >= 0 else "bad"),),),
            cells=(_margin_text(relaxation.best), _margin_text(relaxation.alone)),
        )
        for relaxation in optimum.relaxations
    ]
    headings = ("", "missed | met", "of any design", "of designs that meet all other limits")
    return bar_table("Largest margins", headings, rows, (-1.0, 1.0)) if rows else ""


def _margin_text(margin: float) -> str:
    return "none" if math.isnan(margin) else f"{percent_text(margin)} %"


def effort_table(optimum: Optimum) -> str:
    """Return a table of the number of runs that the search made and saved."""
    effort = optimum.effort
    rows: list[list[Any]] = [["designs tried", str(effort.tried)], ["designs run", str(effort.runs)]]
    rows += [
        [f"ruled out without a run by {_RULED_OUT_BY.get(by, by)}", str(count)]
        for by, count in effort.ruled_out.items()
    ]
    if optimum.goal.deviations:
        rows.append(["neighbours run", str(effort.neighbour_runs)])
        rows.append(["neighbours that needed no run", str(effort.spared_neighbours)])
    rows.append(["runs to verify the best", str(effort.verification_runs)])
    rows.append(["runs saved", str(effort.spared_runs + effort.spared_neighbours)])
    return table("Number of runs", ("", ""), rows)
