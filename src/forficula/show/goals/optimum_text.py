"""What an optimisation came to as text that a person understands."""

from __future__ import annotations

from rich.console import Console, Group, RenderableType
from rich.table import Table
from rich.text import Text

from forficula.goals.limit import Limit
from forficula.goals.optimise.optimum import Optimum
from forficula.goals.optimise.telling import told
from forficula.goals.optimise.verification import Verification
from forficula.goals.outcome_quantity import PROBABILITY
from forficula.quantities import show_quantity

_MOST_SHOWN = 12


def print_optimum(found: Optimum) -> None:
    """Print what `optimum_text` lays out."""
    Console(width=110, highlight=False).print(optimum_text(found))


def optimum_text(found: Optimum) -> RenderableType:
    """Lay out what was found, the best designs, and by how much they meet each limit.

    Args:
        found: what the search came to.
    """
    first, *others = told(found)
    parts: list[RenderableType] = [Text(f"{found.goal.name}: {first}", style="bold"), *map(Text, others)]
    if len(found.best) == 1:
        parts += [Text(), Text("by how much the design meets the goal", style="italic"), _limits(found)]
    elif found.best:
        parts += [Text(), Text("the front", style="italic"), _front(found)]
    return Group(*parts)


def _limits(found: Optimum) -> Table:
    """Every limit of the goal, the value of the best design, and its margin."""
    table = Table(box=None, padding=(0, 2, 0, 0))
    for heading, side in (("asked", "left"), ("design", "right"), ("margin", "right")):
        table.add_column(heading, justify="right" if side == "right" else "left")
    (best,) = found.best
    if found.goal.simulate:
        table.add_row("does what its protocol asks for", "yes", _percent(best.candidate.found.works))
    for limit in found.goal.given:
        table.add_row(str(limit), "run with it", "")
    for limit in found.goal.limits:
        value = _value(best, limit)
        shown = "unknown" if value is None else show_quantity(value, limit.quantity.unit)
        table.add_row(str(limit), shown, _percent(limit.margin(value)))
    return table


def _value(best: Verification, limit: Limit) -> float | None:
    """The value of a limit's quantity; of the probability that of fresh neighbours."""
    if limit.quantity.name == PROBABILITY:
        return None if best.fresh is None else best.fresh.share
    return best.candidate.value(limit.quantity)


def _front(found: Optimum) -> Table:
    """The designs of a front: what they come to, and their parameters."""
    table = Table(box=None, padding=(0, 2, 0, 0))
    objectives = [each.quantity for each in found.goal.objectives]
    for name in (*(each.name for each in objectives), *(each.key for each in found.goal.parameters)):
        table.add_column(name, justify="right")
    for each in found.best[:_MOST_SHOWN]:
        values = [each.candidate.value(quantity) for quantity in objectives]
        told_values = [
            "unknown" if value is None else show_quantity(value, quantity.unit)
            for value, quantity in zip(values, objectives, strict=True)
        ]
        table.add_row(*told_values, *(str(value) for value in each.candidate.values.values()))
    return table


def _percent(margin: float) -> str:
    return f"{100 * margin:+.3g} %"
