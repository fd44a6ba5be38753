"""Results as notebooks show them: the sentence, tables with units, a figure, a run that plays."""

from __future__ import annotations

import base64
import io
from collections.abc import Iterator
from functools import singledispatch
from typing import TYPE_CHECKING

import xarray
from rich.console import RenderableType

from forficula.analysis import Outcome, measure
from forficula.design import Design
from forficula.displayed import Displayed
from forficula.dynamics import Record
from forficula.goals import Goal
from forficula.goals.identify import Observations
from forficula.goals.identify.fact_text import asked_text
from forficula.goals.identify.identification_table import IdentificationTable
from forficula.goals.optimise import Optimum
from forficula.goals.tolerance.tolerance_table import ToleranceTable
from forficula.make.part import PartSet
from forficula.material import MaterialLaw
from forficula.material.characterisation import Characterisation
from forficula.names import counted, listed
from forficula.show.folder.figure_kinds import drawings_of
from forficula.show.goals.identify_text import identification_text
from forficula.show.goals.optimum_text import optimum_text
from forficula.show.landscape.landscape_table import landscape_table
from forficula.show.material.material_table import law_table, material_table
from forficula.show.page.design_tables import design_tables
from forficula.show.page.html import escaped, paragraph, table
from forficula.show.page.outcome_tables import outcome_tables
from forficula.show.page.parts_page import parts_page
from forficula.show.page.rich_html import laid_out
from forficula.show.page.run_page import run_page
from forficula.show.page.words import outcome_sentence
from forficula.show.structure.pattern_figure import draw_pattern
from forficula.show.study.assumptions_table import assumptions_table
from forficula.show.study.convergence_table import convergence_table
from forficula.show.style import PAGE_WIDTH, description
from forficula.statics import EnergyLandscape
from forficula.structure import structure_of
from forficula.study.assumptions import Assumptions
from forficula.study.convergence import Convergence
from forficula.study.factors import Factor
from forficula.study.study import Study
from forficula.study.study_table import StudyTable

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# no colours of our own: what a notebook has by day and by night
_STYLE = (
    "<style>.forficula table{border-collapse:collapse;margin:.5em 0}.forficula caption{text-align:left;font-weight:600}"
    ".forficula .table{overflow-x:auto}"
    ".forficula th,.forficula td{padding:.15em .8em .15em 0;text-align:left;vertical-align:top}"
    ".forficula .numbers td{text-align:right}.forficula img{max-width:min(100%,46em);background:#fff}"
    ".forficula small{display:block;opacity:.7}.forficula p{margin:.4em 0;max-width:46em}</style>"
)
_HEIGHT = 640  # pixels, of a page
_DPI = 110
_MOST_VALUES = 12  # of a factor, that are told


def notebook_html(result: Displayed) -> str:
    """A result as HTML for a cell of a notebook."""
    return f'{_STYLE}<div class="forficula">{"".join(_parts(result))}</div>'


@singledispatch
def _parts(result: Displayed) -> Iterator[str]:
    raise TypeError(f"nothing to show of a {type(result).__name__}")


@_parts.register
def _design(design: Design) -> Iterator[str]:
    yield _title(design.name)
    yield paragraph(design.shows or "")
    yield _picture(draw_pattern(structure_of(design)))
    yield f"<details><summary>Every value</summary>{''.join(design_tables(design))}</details>"


@_parts.register
def _record(record: Record) -> Iterator[str]:
    """The page of the run: it plays."""
    yield _framed(run_page(record, measure(record)), f"{record.design.name}, playing")


@_parts.register
def _parts_to_make(parts: PartSet) -> Iterator[str]:
    """The page of the parts, of which nothing has been checked: that takes seconds, and is asked for by itself."""
    yield _framed(parts_page(parts, ()), f"{parts.design.name}, parts to make")


@_parts.register
def _outcome(outcome: Outcome) -> Iterator[str]:
    yield paragraph(outcome_sentence(outcome.name, outcome))
    yield paragraph(outcome.advice)
    yield from outcome_tables(outcome)


@_parts.register
def _landscape(landscape: EnergyLandscape) -> Iterator[str]:
    yield from _told(landscape_table(landscape))
    yield _first_figure(landscape)


@_parts.register
def _material(material: Characterisation) -> Iterator[str]:
    yield from _told(material_table(material))
    drawings = drawings_of(material)
    yield _picture(drawings.get("fit", drawings["cycles"])(PAGE_WIDTH))


@_parts.register
def _law(law: MaterialLaw) -> Iterator[str]:
    yield _title(law.name)
    yield from _told(law_table(law))
    yield paragraph(f"Source: {law.source}" if law.source else "")


@_parts.register
def _convergence(convergence: Convergence) -> Iterator[str]:
    yield from _told(convergence_table(convergence))
    yield _first_figure(convergence)


@_parts.register
def _assumptions(assumptions: Assumptions) -> Iterator[str]:
    yield from _told(assumptions_table(assumptions))
    yield _first_figure(assumptions)


@_parts.register
def _study(study: Study) -> Iterator[str]:
    yield _title(study.name)
    asked = "runs its protocol" if study.search is None else "finds the least values that do"
    yield paragraph(f"{len(study.points)} points of {study.base.name}, at each of which it {asked}.")
    rows = [(factor.key, _values(factor)) for factor in (*study.factors, *study.grid)]
    yield table("What is varied", ("key", "values"), rows, numbers=False)


@_parts.register
def _tolerance(found: ToleranceTable) -> Iterator[str]:
    first, *others = str(found.attrs["says"]).splitlines()
    yield _title(f"{found.attrs['design']}: {first}")
    yield from map(paragraph, others)
    yield _first_figure(found)
    yield xarray.Dataset._repr_html_(found)


@_parts.register
def _table(found: StudyTable) -> Iterator[str]:
    yield _first_figure(found)
    yield xarray.Dataset._repr_html_(found)


@_parts.register
def _goal(goal: Goal) -> Iterator[str]:
    asked = listed([f"the {each.kind} {each.quantity.name}" for each in goal.objectives])
    yield _title(goal.name)
    yield paragraph(f"{asked[0].upper()}{asked[1:]} of {goal.base.name}, of at most {counted(goal.runs, 'design')}.")
    yield table("What may vary", ("", ""), [tuple(str(each).split(" ", 1)) for each in goal.parameters], numbers=False)
    yield table("Limits", ("",), [(str(each),) for each in (*goal.given, *goal.limits)], numbers=False)


@_parts.register
def _optimum(found: Optimum) -> Iterator[str]:
    yield from _told(optimum_text(found))
    yield _first_figure(found)


@_parts.register
def _observations(seen: Observations) -> Iterator[str]:
    yield _title(seen.name)
    yield paragraph(f"{counted(len(seen.facts), 'fact')} on {seen.base.name}.")
    yield table(
        "What is unknown", ("key", "believed"), [(prior.key, _values(prior)) for prior in seen.priors], numbers=False
    )
    yield table(
        "What was seen", ("fact", "to be"), [(fact.name, asked_text(fact)) for fact in seen.facts], numbers=False
    )


@_parts.register
def _identification(found: IdentificationTable) -> Iterator[str]:
    # of a part of it nothing is told
    if found.sizes.keys() >= {"sample", "fact", "other_fact"} and "most_met" in found.attrs:
        yield from _told(identification_text(found))
        yield _first_figure(found)
    yield xarray.Dataset._repr_html_(found)


def _framed(page: str, title: str) -> str:
    """A page in a frame of its own: its style and script touch nothing else."""
    return (
        f'<iframe srcdoc="{escaped(page)}" title="{escaped(title)}"'
        f' sandbox="allow-scripts allow-downloads" style="width:100%;height:{_HEIGHT}px;border:0"></iframe>'
    )


def _title(text: str) -> str:
    return f"<h3>{escaped(text)}</h3>"


def _first_figure(result: object) -> str:
    drawings = drawings_of(result)
    return _picture(next(iter(drawings.values()))(PAGE_WIDTH)) if drawings else ""


def _picture(figure: Figure) -> str:
    """A figure within the cell, with the text that stands for it."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    content = io.BytesIO()
    figure.set_dpi(_DPI)
    FigureCanvasAgg(figure).print_png(content)  # type: ignore[no-untyped-call]
    packed = base64.b64encode(content.getvalue()).decode("ascii")
    return f'<p><img src="data:image/png;base64,{packed}" alt="{escaped(description(figure))}"></p>'


def _values(factor: Factor) -> str:
    if factor.distribution is not None:
        drawn = factor.distribution
        return f"{drawn.name}, {drawn.first:g} to {drawn.second:g} in SI"
    shown = [str(value) for value in factor.values]
    return ", ".join(shown if len(shown) <= _MOST_VALUES else [*shown[: _MOST_VALUES - 2], "…", shown[-1]])


def _told(renderable: RenderableType) -> Iterator[str]:
    """What the terminal shows of a result."""
    found = laid_out(renderable)
    if found.heading:
        yield f"<p><strong>{escaped(found.heading)}</strong></p>"
    yield from found.tables
    yield from map(paragraph, found.sentences)
