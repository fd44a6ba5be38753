"""Results of an optimisation as text."""

from __future__ import annotations

from rich.console import Console, Group, RenderableType
from rich.table import Table
from rich.text import Text

from forficula.goals.optimise.candidate import Verification
from forficula.goals.optimise.optimum import Optimum
from forficula.goals.optimise.summary import summary_sentences
from forficula.goals.outcome_quantity import PROBABILITY, OutcomeQuantity
from forficula.quantities import show_quantity


def print_optimum(optimum: Optimum) -> None:
    """Print the text of `optimum_text`."""
    Console(width=110, highlight=False, markup=False).print(optimum_text(optimum))


def optimum_text(optimum: Optimum) -> RenderableType:
    """Return the sentences about an optimisation, and a table of the best designs with their verification.

    Args:
        optimum: the result of the optimisation.
    """
    first, *others = summary_sentences(optimum)
    parts: list[RenderableType] = [Text(f"{optimum.goal.name}: {first}", style="bold"), *map(Text, others)]
    shown = optimum.best or optimum.discarded[:1]
    if shown:
        title = "the best designs" if optimum.best else "nearest design, which verification did not confirm"
        parts += [Text(), Text(title, style="italic"), _designs(optimum, shown)]
    return Group(*parts)


def _designs(optimum: Optimum, shown: tuple[Verification, ...]) -> Table:
    """Return a table with one row for each quantity and one column for each design."""
    goal = optimum.goal
    table = Table(box=None, padding=(0, 2, 0, 0))
    table.add_column("")
    for number in range(len(shown)):
        table.add_column(str(number + 1) if len(shown) > 1 else "", justify="right")
    for parameter in goal.parameters:
        table.add_row(parameter.key, *(str(one.candidate.values[parameter.key]) for one in shown))
    for quantity in goal.quantities:
        if quantity.name != PROBABILITY:
            table.add_row(quantity.name, *(_value(one, quantity) for one in shown))
    table.add_row("least margin", *(f"{100 * one.candidate.screened.least:.3g} %" for one in shown))
    if goal.deviations:
        table.add_row("neighbours that work", *(_neighbours(one) for one in shown))
    if goal.simulate:
        table.add_row("energy residual", *("" if one.residual is None else f"{one.residual:.2g}" for one in shown))
    return table


def _value(one: Verification, quantity: OutcomeQuantity) -> str:
    value = one.candidate.value(quantity)
    return "" if value is None else show_quantity(value, quantity.unit)


def _neighbours(one: Verification) -> str:
    return "" if one.fresh is None else f"{one.fresh.works} of {one.fresh.tried}"
