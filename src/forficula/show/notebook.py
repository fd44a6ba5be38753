"""Results in notebooks: a sentence, tables with units, a figure, a run that plays."""

from __future__ import annotations

from collections.abc import Iterator
from functools import singledispatch
from typing import TYPE_CHECKING

from forficula.analysis import Outcome
from forficula.design import Design
from forficula.displayed import Displayed
from forficula.goals import Goal
from forficula.goals.identify import Observations
from forficula.goals.identify.fact_text import requirement_text
from forficula.material import MaterialLaw
from forficula.names import counted, listed
from forficula.show.folder.notebook_cell import heading, picture, printed
from forficula.show.folder.presentation import presentation, result_kind
from forficula.show.material.material_table import law_table
from forficula.show.page.parts.design_tables import design_tables
from forficula.show.page.parts.html import paragraph, table
from forficula.show.page.parts.outcome_tables import outcome_tables
from forficula.show.page.parts.run_sentences import outcome_sentence
from forficula.show.structure.pattern_figure import draw_pattern
from forficula.structure import structure_of
from forficula.study.assumptions.choices import choice_label
from forficula.study.factors import Factor
from forficula.study.study import Study

if TYPE_CHECKING:
    pass

# without colours, so that light and dark themes of a notebook apply
_STYLE = (
    "<style>.forficula table{border-collapse:collapse;margin:.5em 0}.forficula caption{text-align:left;font-weight:600}"
    ".forficula .table{overflow-x:auto}"
    ".forficula th,.forficula td{padding:.15em .8em .15em 0;text-align:left;vertical-align:top}"
    ".forficula .numbers td{text-align:right}.forficula img{max-width:min(100%,46em);background:#fff}"
    ".forficula small{display:block;opacity:.7}.forficula p{margin:.4em 0;max-width:46em}</style>"
)
_MOST_VALUES = 12  # largest number of values listed for a factor


def notebook_html(result: Displayed) -> str:
    """Return a result as HTML for a cell of a notebook."""
    return f'{_STYLE}<div class="forficula">{"".join(_parts(result))}</div>'


@singledispatch
def _parts(result: Displayed) -> Iterator[str]:
    return presentation(result_kind(result)).cell(result)


@_parts.register
def _design(design: Design) -> Iterator[str]:
    yield heading(design.name)
    yield paragraph(design.shows or "")
    yield picture(draw_pattern(structure_of(design)))
    yield f"<details><summary>Every value</summary>{''.join(design_tables(design))}</details>"


@_parts.register
def _outcome(outcome: Outcome) -> Iterator[str]:
    yield paragraph(outcome_sentence(outcome.name, outcome))
    yield paragraph(outcome.advice)
    yield from outcome_tables(outcome)


@_parts.register
def _law(law: MaterialLaw) -> Iterator[str]:
    yield heading(law.name)
    yield from printed(law_table(law))
    yield paragraph(f"Source: {law.source}" if law.source else "")


@_parts.register
def _study(study: Study) -> Iterator[str]:
    yield heading(study.name)
    task = "runs the protocol" if study.search is None else "searches for the least values that suffice"
    yield paragraph(f"{len(study.points)} points of {study.base.name}. Each point {task}.")
    if study.plan:
        changes = [(change.name, choice_label(study.base, change.values)) for change in study.plan.changes]
        yield table("Changes", ("name", "changed values"), changes, numbers=False)
        return
    rows = [(factor.key, _values(factor)) for factor in (*study.factors, *study.grid)]
    yield table("Varied values", ("key", "values"), rows, numbers=False)


@_parts.register
def _goal(goal: Goal) -> Iterator[str]:
    aims = listed([f"the {objective.kind} {objective.quantity.name}" for objective in goal.objectives])
    yield heading(goal.name)
    yield paragraph(f"{aims[0].upper()}{aims[1:]} of {goal.base.name}, of at most {counted(goal.runs, 'design')}.")
    yield table(
        "Parameters", ("", ""), [tuple(str(parameter).split(" ", 1)) for parameter in goal.parameters], numbers=False
    )
    yield table("Limits", ("",), [(str(limit),) for limit in (*goal.torque_limits, *goal.limits)], numbers=False)


@_parts.register
def _observations(observations: Observations) -> Iterator[str]:
    yield heading(observations.name)
    yield paragraph(f"{counted(len(observations.facts), 'fact')} on {observations.base.name}.")
    yield table(
        "Unknown values",
        ("key", "prior"),
        [(prior.key, _values(prior)) for prior in observations.priors],
        numbers=False,
    )
    yield table(
        "Facts",
        ("fact", "observed"),
        [(fact.name, requirement_text(fact)) for fact in observations.facts],
        numbers=False,
    )


def _values(factor: Factor) -> str:
    if factor.distribution is not None:
        drawn = factor.distribution
        return f"{drawn.name}, {drawn.first:g} to {drawn.second:g} in SI"
    shown = [str(value) for value in factor.values]
    return ", ".join(shown if len(shown) <= _MOST_VALUES else [*shown[: _MOST_VALUES - 2], "…", shown[-1]])
