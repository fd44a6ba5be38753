"""What a search for the best design came to, as text that a person understands."""

from __future__ import annotations

from rich.console import Console, Group, RenderableType
from rich.table import Table
from rich.text import Text

from forficula.goals.optimise.candidate import Verification
from forficula.goals.optimise.optimum import Optimum
from forficula.goals.optimise.telling import told
from forficula.goals.outcome_quantity import PROBABILITY, OutcomeQuantity
from forficula.quantities import show_quantity


def print_optimum(found: Optimum) -> None:
    """Print what `optimum_text` lays out."""
    Console(width=110, highlight=False, markup=False).print(optimum_text(found))


def optimum_text(found: Optimum) -> RenderableType:
    """Lay out the best designs, how they do where the search did not look, and what follows in sentences.

    Args:
        found: what the search came to.
    """
    first, *others = told(found)
    parts: list[RenderableType] = [Text(f"{found.goal.name}: {first}", style="bold"), *map(Text, others)]
    shown = found.best or found.discarded[:1]
    if shown:
        title = "the best designs" if found.best else "what came nearest, but does not hold"
        parts += [Text(), Text(title, style="italic"), _designs(found, shown)]
    return Group(*parts)


def _designs(found: Optimum, shown: tuple[Verification, ...]) -> Table:
    """A line a quantity, a column a design: short lists of designs read well so."""
    goal = found.goal
    table = Table(box=None, padding=(0, 2, 0, 0))
    table.add_column("")
    for number in range(len(shown)):
        table.add_column(str(number + 1) if len(shown) > 1 else "", justify="right")
    for each in goal.parameters:
        table.add_row(each.key, *(str(one.candidate.values[each.key]) for one in shown))
    for quantity in goal.quantities:
        if quantity.name != PROBABILITY:
            table.add_row(quantity.name, *(_value(one, quantity) for one in shown))
    table.add_row("least margin", *(f"{100 * one.candidate.found.least:.3g} %" for one in shown))
    if goal.deviations:
        table.add_row("neighbours that work", *(_neighbours(one) for one in shown))
    if goal.simulate:
        table.add_row("energy missing", *("" if one.residual is None else f"{one.residual:.2g}" for one in shown))
    return table


def _value(one: Verification, quantity: OutcomeQuantity) -> str:
    value = one.candidate.value(quantity)
    return "" if value is None else show_quantity(value, quantity.unit)


def _neighbours(one: Verification) -> str:
    return "" if one.fresh is None else f"{one.fresh.works} of {one.fresh.tried}"
