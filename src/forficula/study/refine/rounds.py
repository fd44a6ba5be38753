"""Run a study that locates boundaries in rounds: the points of a round depend on the results of earlier rounds."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

import numpy as np

from forficula.analysis import Verdict
from forficula.analysis.margin import margin_column
from forficula.study.refine.boundary_plan import BoundaryPlan, Position
from forficula.study.refine.cells import locate
from forficula.study.refine.lattice import position_values
from forficula.study.study import Study
from forficula.study.tables.outcome_kinds import TableTransition, table_transitions

if TYPE_CHECKING:
    from xarray import Dataset

# computes the table of a study that has the points of one round
RunRound = Callable[[Study], "Dataset"]


def refined_study(study: Study, run_round: RunRound) -> Study:
    """Return a study with all points that locate its boundaries.

    The points of a round depend only on the results of the points of earlier rounds. An interrupted study therefore
    repeats the same rounds, whose rows exist already.

    Args:
        study: study with a plan of boundaries.
        run_round: function that runs the points of a round.

    Raises:
        InputError: raised by `run_round`.
    """
    plan = study.boundaries
    assert plan is not None
    labels: dict[Position, str] = {}
    margins: dict[Position, Sequence[float]] = {}
    wanted: Sequence[Position] = plan.initial_grid
    while wanted:
        part = _with_points(study, wanted)
        table = run_round(part)
        labels |= zip(wanted, point_labels(table, plan), strict=True)
        margins |= zip(wanted, _margins(table), strict=True)
        wanted = locate(plan, labels, margins).wanted[: max(plan.most_points - len(labels), 0)]
    return _with_points(study, list(labels))


def _with_points(study: Study, positions: Sequence[Position]) -> Study:
    """Return the study with the points at some positions."""
    plan = study.boundaries
    assert plan is not None
    keys = [factor.key for factor in study.factors]
    points = tuple(
        dict(zip(keys, position_values(study.factors, plan.axes, position), strict=True)) for position in positions
    )
    return replace(study, points=points)


def point_labels(table: Dataset, plan: BoundaryPlan) -> list[str]:
    """Return the text that distinguishes the region of each point of a table."""
    if isinstance(plan.boundary, str):
        return [str(word) for word in table[plan.boundary].values.ravel()]
    transitions = {transition.state: transition for transition in table_transitions(table)}
    columns = [_reached_texts(table, transitions[state]) for state in plan.boundary]
    return [", ".join(texts) for texts in zip(*columns, strict=True)]


def _reached_texts(table: Dataset, transition: TableTransition) -> list[str]:
    """Return for each point whether a state is reached; the outcome if its run is inconclusive."""
    state, least = transition.state, transition.least
    inconclusive = [verdict.value for verdict in Verdict if not verdict.conclusive]
    verdicts, outcomes = (table[name].values.ravel().astype(str) for name in ("verdict", "outcome"))
    unknown = np.isin(verdicts, inconclusive)
    reached = np.isfinite(table[least].values.ravel()) if least else table[state].values.ravel().astype(bool)
    if least:
        # a search that succeeds is conclusive, whatever the runs of later transitions are
        unknown &= ~reached
    return [
        str(outcome) if silent else state if done else f"not {state}"
        for outcome, silent, done in zip(outcomes, unknown, reached, strict=True)
    ]


def _margins(table: Dataset) -> list[tuple[float, ...]]:
    """Return the margins of the transitions of each point; none for a search."""
    names = [margin_column(transition.name) for transition in table_transitions(table)]
    columns = [table[name].values.ravel().tolist() for name in names if name in table]
    return list(zip(*columns, strict=True)) if columns else [()] * table.sizes["sample"]
