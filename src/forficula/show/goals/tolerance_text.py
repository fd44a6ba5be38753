"""A tolerance as text that a person understands."""

from __future__ import annotations

import numpy as np
from rich.console import Console, Group, RenderableType
from rich.table import Table
from rich.text import Text

from forficula.goals.tolerance import Tolerance
from forficula.goals.tolerance.advice import advice, percent
from forficula.goals.tolerance.nearest_failure import Answer, Reach
from forficula.show.study.factor_text import key_text


def print_tolerance(found: Tolerance) -> None:
    """Print what `tolerance_text` lays out."""
    Console(width=110, highlight=False, markup=False).print(tolerance_text(found))


def tolerance_text(found: Tolerance) -> RenderableType:
    """Lay out the probabilities, what decides them, how far each value may go alone, and the sentences.

    Args:
        found: what the runs say.
    """
    first, *others = advice(found)
    parts: list[RenderableType] = [Text(f"{found.question.design.name}: {first}", style="bold")]
    parts += [*map(Text, others), Text()]
    parts += [Text("how likely it is", style="italic"), _facts(found), Text()]
    parts += [Text("what the designs came to", style="italic"), _outcomes(found), Text()]
    if found.tells_what_decides:
        parts += [Text(_decides_title(found), style="italic"), _indices(found), Text()]
    if found.reaches:
        parts += [Text("how far each value may go alone", style="italic"), _reaches(found), Text()]
    return Group(*parts[:-1])


def _table(*headings: str) -> Table:
    """A table whose first column is words."""
    table = Table(box=None, padding=(0, 2, 0, 0))
    for number, heading in enumerate(headings):
        table.add_column(heading, justify="right" if number else "left")
    return table


def _facts(found: Tolerance) -> Table:
    table = _table("", "probability", "of runs")
    for name, each in found.probabilities.items():
        unknown = f", {each.unknown} unknown" if each.unknown else ""
        table.add_row(name, percent(each), f"{each.works} of {each.works + each.fails}{unknown}")
    return table


def _outcomes(found: Tolerance) -> Table:
    table = _table("", "designs")
    for outcome, count in found.outcomes.items():
        table.add_row(outcome, str(count))
    return table


def _decides_title(found: Tolerance) -> str:
    if not found.plan.rows:
        return "shares of the margin's variance, by straight lines"
    return "shares of the margin's variance, with 95 % intervals"


def _indices(found: Tolerance) -> Table:
    """The factors that matter, those that decide most first, the others as one, and what half a tolerance gains."""
    question, indices = found.question, found.indices
    table = _table("", "tolerance", "alone", "and with others", "half of it gains")
    for place in found.shown:
        own = place < len(found.kept)
        factor = found.kept[place] if own else -1
        gain = found.narrowed[factor]
        table.add_row(
            key_text(question.keys[factor]) if own else f"the {_others(found)} others",
            question.width_text(factor) if own else "",
            _share(indices.first[0, place], indices.first_low[0, place], indices.first_high[0, place]),
            _share(indices.total[0, place], indices.total_low[0, place], indices.total_high[0, place]),
            f"{100 * gain.gain:+.0f} % ({100 * gain.gain_low:+.0f} to {100 * gain.gain_high:+.0f})" if own else "",
        )
    return table


def _others(found: Tolerance) -> int:
    return len(found.question.keys) - len(found.kept)


def _share(share: float, low: float, high: float) -> str:
    if not np.isfinite(share):
        return "-"
    return f"{share:.2f} ({low:.2f} to {high:.2f})"


def _reaches(found: Tolerance) -> Table:
    """The factors that fail alone, the nearest first; how many do not."""
    table = _table("", "value", "fails below", "in tolerances", "fails above", "in tolerances")
    nearest = [
        min((reach.fails for reach in ways if reach.fails is not None), default=np.inf) for ways in found.reaches
    ]
    for factor in np.argsort(nearest, kind="stable").tolist():
        if not np.isfinite(nearest[factor]):
            continue
        down, up = found.reaches[factor]
        cells = [*_reach(found, factor, down, -1), *_reach(found, factor, up, 1)]
        table.add_row(key_text(found.question.keys[factor]), found.question.value_text(factor, 0.0), *cells)
    if (sound := sum(map(np.isinf, nearest))) > 0:
        who = f"{sound} {'others' if np.isfinite(nearest).any() else 'values'}"
        table.add_row(who, "", "no", f"within {found.plan.steps[-1]:g}", "no", f"within {found.plan.steps[-1]:g}")
    return table


def _reach(found: Tolerance, factor: int, reach: Reach, sign: int) -> tuple[str, str]:
    """The value at which it fails, and how many tolerances away that is."""
    if reach.fails is not None:
        return found.question.value_text(factor, sign * reach.fails), f"{sign * reach.fails:+.2g}"
    if reach.why is Answer.UNKNOWN:
        return "not to be trusted", f"{sign * (reach.beyond or 0.0):+.2g}"
    return "no", f"beyond {sign * reach.works:+.2g}"
