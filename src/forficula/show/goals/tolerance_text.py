"""Results of a tolerance analysis as text."""

from __future__ import annotations

import numpy as np
from rich.console import Console, Group, RenderableType
from rich.table import Table
from rich.text import Text

from forficula.goals.tolerance import Tolerance
from forficula.goals.tolerance.advice import advice, percent
from forficula.goals.tolerance.nearest_failure import Answer, Reach
from forficula.show.study.factor_text import key_text


def print_tolerance(tolerance: Tolerance) -> None:
    """Print the text of `tolerance_text`."""
    Console(width=110, highlight=False, markup=False).print(tolerance_text(tolerance))


def tolerance_text(tolerance: Tolerance) -> RenderableType:
    """Return the sentences about a tolerance analysis, and tables of probabilities, outcomes, indices and failures.

    Args:
        tolerance: the result.
    """
    first, *others = advice(tolerance)
    parts: list[RenderableType] = [Text(f"{tolerance.question.design.name}: {first}", style="bold")]
    parts += [*map(Text, others), Text()]
    parts += [Text("probability of working", style="italic"), _facts(tolerance), Text()]
    parts += [Text("outcomes of the designs", style="italic"), _outcomes(tolerance), Text()]
    if tolerance.can_rank_factors:
        parts += [Text(_decides_title(tolerance), style="italic"), _indices(tolerance), Text()]
    if tolerance.reaches:
        parts += [Text("deviation of one value at which the design fails", style="italic"), _reaches(tolerance), Text()]
    return Group(*parts[:-1])


def _table(*headings: str) -> Table:
    """Return a table whose first column is text."""
    table = Table(box=None, padding=(0, 2, 0, 0))
    for number, heading in enumerate(headings):
        table.add_column(heading, justify="right" if number else "left")
    return table


def _facts(tolerance: Tolerance) -> Table:
    table = _table("", "probability", "runs")
    for name, probability in tolerance.probabilities.items():
        unknown = f", {probability.unknown} unknown" if probability.unknown else ""
        table.add_row(
            name, percent(probability), f"{probability.works} of {probability.works + probability.fails}{unknown}"
        )
    return table


def _outcomes(tolerance: Tolerance) -> Table:
    table = _table("", "designs")
    for outcome, count in tolerance.outcomes.items():
        table.add_row(outcome, str(count))
    return table


def _decides_title(tolerance: Tolerance) -> str:
    if not tolerance.plan.rows:
        return "shares of the margin's variance, by linear regression"
    return "shares of the margin's variance, with 95 % intervals"


def _indices(tolerance: Tolerance) -> Table:
    """Return the most sensitive factors, the others as one row, and the gain from halving each tolerance."""
    question, indices = tolerance.question, tolerance.indices
    table = _table("", "tolerance", "alone", "with interactions", "gain from half of it")
    for index in tolerance.shown:
        single = index < len(tolerance.kept)
        factor = tolerance.kept[index] if single else -1
        gain = tolerance.narrowed[factor]
        table.add_row(
            key_text(question.keys[factor]) if single else f"the {_others(tolerance)} others",
            question.width_text(factor) if single else "",
            _share(indices.first[0, index], indices.first_low[0, index], indices.first_high[0, index]),
            _share(indices.total[0, index], indices.total_low[0, index], indices.total_high[0, index]),
            f"{100 * gain.gain:+.0f} % ({100 * gain.gain_low:+.0f} to {100 * gain.gain_high:+.0f})" if single else "",
        )
    return table


def _others(tolerance: Tolerance) -> int:
    return len(tolerance.question.keys) - len(tolerance.kept)


def _share(share: float, low: float, high: float) -> str:
    if not np.isfinite(share):
        return "-"
    return f"{share:.2f} ({low:.2f} to {high:.2f})"


def _reaches(tolerance: Tolerance) -> Table:
    """Return the factors that fail alone, the nearest failure first, and the number of those that do not."""
    table = _table("", "value", "fails below", "in tolerances", "fails above", "in tolerances")
    nearest = [
        min((reach.fails for reach in pair if reach.fails is not None), default=np.inf) for pair in tolerance.reaches
    ]
    for factor in np.argsort(nearest, kind="stable").tolist():
        if not np.isfinite(nearest[factor]):
            continue
        down, up = tolerance.reaches[factor]
        cells = [*_reach(tolerance, factor, down, -1), *_reach(tolerance, factor, up, 1)]
        table.add_row(key_text(tolerance.question.keys[factor]), tolerance.question.value_text(factor, 0.0), *cells)
    if (sound := sum(map(np.isinf, nearest))) > 0:
        who = f"{sound} {'others' if np.isfinite(nearest).any() else 'values'}"
        table.add_row(
            who, "", "no", f"within {tolerance.plan.steps[-1]:g}", "no", f"within {tolerance.plan.steps[-1]:g}"
        )
    return table


def _reach(tolerance: Tolerance, factor: int, reach: Reach, sign: int) -> tuple[str, str]:
    """Return the value at which the design fails, and its deviation in tolerances."""
    if reach.fails is not None:
        return tolerance.question.value_text(factor, sign * reach.fails), f"{sign * reach.fails:+.2g}"
    if reach.why is Answer.UNKNOWN:
        return "undecided", f"{sign * (reach.beyond or 0.0):+.2g}"
    return "no", f"beyond {sign * reach.works:+.2g}"
