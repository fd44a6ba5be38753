"""Page of a study: its maps, its runs to play back, and its table."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, Any

from forficula.design import TORQUE
from forficula.dynamics import versions
from forficula.files import write_text
from forficula.names import listed
from forficula.quantities import show_quantity
from forficula.reproduction import Comparison
from forficula.show.page.data.kept_run_data import runs_data
from forficula.show.page.data.study_data import page_bins, study_data
from forficula.show.page.page import page_html
from forficula.show.page.parts.html import Cell, escaped, paragraph, remarks, section, table
from forficula.show.page.parts.points_table import has_rows, points_table
from forficula.show.page.results_page import figure_html
from forficula.show.page.study_live import study_live
from forficula.show.study.bins import Bins
from forficula.show.study.changes_figure import change_drawings
from forficula.show.study.choices_figure import choice_rows
from forficula.show.study.maps import map_drawings, table_view
from forficula.show.style import Drawing, save_figures
from forficula.structure import structure_of
from forficula.study import Study, named_studies, table_csv
from forficula.study.assumptions.choices import choice_label
from forficula.study.factors import Factor
from forficula.study.refine.summary import boundary_sentences
from forficula.study.running.kept_runs import KeptRun
from forficula.study.search_steps import SearchStep
from forficula.study.tables.outcome_kinds import (
    TableTransition,
    least_values,
    lost_text,
    reached_all,
    reliability_sentences,
    studied_transitions,
    undecided_text,
)
from forficula.study.tables.redundancy import change_rows, redundancy_sentences

if TYPE_CHECKING:
    from xarray import Dataset

# bytes that runs leave to the engine on a page that contains it; the engine takes 3.5 MB
_ENGINE = 2_900_000
_AGREES = {True: "yes", False: "no", None: "unknown"}


def write_study_page(
    study: Study,
    results: Dataset,
    path: Path,
    kept: Iterable[KeptRun],
    count: int,
    compared: Comparison | None = None,
    *,
    engine: bool = True,
) -> None:
    """Write a study as one HTML file that needs no network.

    Args are those of `study_page`.

    Raises:
        InputError: it cannot be written.
    """
    write_text(path, study_page(study, results, kept, count, compared, engine=engine))


def study_page(
    study: Study,
    results: Dataset,
    kept: Iterable[KeptRun],
    count: int,
    compared: Comparison | None = None,
    *,
    engine: bool = True,
) -> str:
    """Return a study as one page: maps, the runs of their cells, all points, and the claims of a paper.

    Args:
        study: the study.
        results: table of its points.
        kept: runs that the page can play back.
        count: number of these runs; they share a budget of bytes, so that a page with 60 points stays below 10 MB.
        compared: claims of a paper beside the study's results.
        engine: whether the page contains the simulator, which simulates points whose runs were not kept.
    """
    data, bins = study_data(study, results), page_bins(results)
    changes = _changes(results) if study.plan else []
    boundaries = _boundaries(results) if study.boundaries is not None else []
    body = "".join(
        (
            f"<header><h1>{escaped(study.name)}</h1>{paragraph(study_sentence(study, results), 'outcome')}</header>\n",
            '<main class="study">',
            paragraph("" if bins is None else _binned_text(bins, table_view(results).note), "note"),
            '<div id="explorer"></div>\n',
            section("Boundaries", *boundaries, name="boundaries"),
            section("Redundancy and margins", *changes, name="changes"),
            section("Choices side by side", _choices(results), name="choices"),
            section("All points", _points(study, data, binned=bins is not None), name="points"),
            section("Comparison with the paper", _comparison(compared), name="comparison"),
            section("The study", *_about(study), name="about"),
            "</main>",
        )
    )
    live = study_live(study, binned=bins is not None) if engine else None
    beside = 0 if live is None or "refused" in live else _ENGINE
    runs = runs_data(kept, count, beside)
    shown = {
        "kind": "study",
        "study": data,
        "runs": runs if bins is None else _runs_in_bins(runs, bins, results),
        "csv": table_csv(study, results) if bins is None and has_rows(data) else None,
    }
    return page_html(f"{study.name}: {len(study.points)} points", body, shown, live)


def _binned_text(bins: Bins, note: str) -> str:
    """Return what the page of a study of many points shows."""
    part = f" The page shows the part of the study {note}." if note else ""
    return (
        f"This page shows {bins.size_text}, because a map of all points is not legible.{part} A number is the mean of a"
        " bin, and an outcome is the most frequent one of a bin. If most points of a bin have no value, the bin has"
        " their most frequent outcome."
    )


def _points(study: Study, data: dict[str, Any], *, binned: bool) -> str:
    """Return the table of all points, or where it is."""
    if not binned:
        return points_table(data)
    return paragraph(f"A table of {len(study.points)} points is too long for this page; {data['file']} lists all.")


def _runs_in_bins(runs: list[dict[str, Any]], bins: Bins, results: Dataset) -> list[dict[str, Any]]:
    """Return the kept runs with the bins of their points; of several runs of one part in a bin, the first."""
    first: dict[tuple[int, str], dict[str, Any]] = {}
    for run in runs:
        number = bins.bin_of(run["point"], results)
        if number is not None:
            title = f"point {run['point'] + 1}: {run['title']}"
            first.setdefault((number, run["part"]), run | {"point": number, "title": title})
    return [first[key] for key in sorted(first)]


def study_sentence(study: Study, results: Dataset) -> str:
    """Return a sentence with the number of points and of those that completed each transition."""
    count, transitions = f"{len(study.points)} points", studied_transitions(results)
    confirmed = "".join(f" {sentence}" for sentence in reliability_sentences(results))
    if study.plan:
        return f"{count}. {redundancy_sentences(results)[0]}{confirmed}"
    if study.boundaries is not None:
        # the share of points that succeed depends on where refinement places them
        return f"{boundary_sentences(results)[0]}{confirmed}"
    if study.search is None:
        counts = [
            f"{int(reached_all(results, transitions[: index + 1]).sum())} {_can(transitions, index)}"
            for index in range(len(transitions))
        ]
        return f"{count}: {', '.join(counts)}.{confirmed}" if counts else f"{count}.{confirmed}"
    parts = []
    for index, (step, item) in enumerate(zip(study.search.steps, transitions, strict=True)):
        what = _can(transitions, index, again=False) if index == 0 else f"{item.wording.verb} again"
        values = least_values(results, item)
        if not len(values):
            parts.append(f"none can {what}{undecided_text(results, item)}")
            continue
        low, high = (show_quantity(float(end), step.unit) for end in (values.min(), values.max()))
        between = low if low == high else f"{low} to {high}"
        parts.append(f"{len(values)}{undecided_text(results, item)} {what}, with {between}{lost_text(results, item)}")
    return f"{count}: {'; '.join(parts)}.{confirmed}"


def _can(transitions: Sequence[TableTransition], index: int, *, again: bool = True) -> str:
    """Return the verbs of the transitions up to an index, such as "fold and open again"."""
    verbs = [transition.wording.verb for transition in transitions[: index + 1]]
    return f"{' and '.join(verbs)}{' again' if index and again else ''}"


def _choices(results: Dataset) -> str:
    """Return a table with the number of points that completed each transition, for every choice."""
    headings, rows = choice_rows(results)
    return table("One value is changed at a time", headings, rows) if rows else ""


def _changes(results: Dataset) -> list[str]:
    """Return the conclusions on named changes, their table and their figures."""
    headings, rows = change_rows(results)
    sentences = remarks(redundancy_sentences(results))
    alone = table("Every change alone", headings, rows, numbers=False)
    return [sentences, *_figures(change_drawings(results)), alone]


def _boundaries(results: Dataset) -> list[str]:
    """Return the figure of located boundaries and the conclusions."""
    drawings = {"boundaries": map_drawings(results)["boundaries"]}
    return [*_figures(drawings), remarks(boundary_sentences(results))]


def _figures(drawings: Mapping[str, Drawing]) -> list[str]:
    """Return figures as elements of the page."""
    with TemporaryDirectory() as name:
        texts = save_figures(drawings, Path(name), copies=(".svg",))
        return [figure_html(Path(name), stem, texts[stem]) for stem in drawings]


def _comparison(compared: Comparison | None) -> str:
    if compared is None:
        return ""
    paper, rows = compared.paper, compared.claims
    decided = [row.agrees for row in rows if row.agrees is not None]
    cells: list[list[str | Cell]] = [
        [
            Cell(text=row.claim, note=row.why),
            row.paper if row.mark == "paper" else f"{row.paper} [{row.mark}]",
            row.ours,
            _AGREES[row.agrees],
        ]
        for row in rows
    ]
    return paragraph(f"{sum(decided)} of {len(decided)} claims of {paper.authors} ({paper.published}) agree.") + table(
        "Claims", ("claim", "paper", "forficula", "agrees"), cells, numbers=False
    )


def _about(study: Study) -> list[str]:
    """Return the varied values, the search and the command that repeats the study."""
    rows = [["design", study.base.name], *([factor.key, _values(study, factor)] for factor in study.factors)]
    rows += [[change.name, choice_label(study.base, change.values)] for change in study.plan.changes]
    if study.choices:
        rows.append(["varied", "one at a time"])
        rows += [[f"{factor.key}, at every choice", _values(study, factor)] for factor in study.grid]
    if study.boundaries is not None:
        rows[1 : 1 + len(study.factors)] = [
            [f"{factor.key}, initial grid", _values(study, factor)] for factor in study.factors
        ]
        kind = study.boundaries.boundary
        rows.append(["boundaries between", kind if isinstance(kind, str) else f"reached or not: {listed(kind)}"])
        rows.append(["points of the full grid", str(study.boundaries.full_grid)])
    if study.search is not None:
        search = study.search
        first, second = search.first, search.second
        rows.append([f"{_plural(first)} tried", _torques(first)])
        if second is not None:
            large = show_quantity(search.reference, first.unit)
            nouns = [
                transition.wording.noun
                for transition in structure_of(study.base).transitions
                if transition.name == second.transition
            ]
            rows.append([f"{first.state} before {nouns[0]} with", large])
            rows.append([f"{_plural(second)} tried", _torques(second)])
        rows.append(["halvings of the last step", str(search.refinements)])
    rows += [[name, version] for name, version in versions(study.base.protocol.device).items()]
    rows.append(["design hash", study.base.hash])
    file = study.name if study.name in named_studies() else f"{study.name}.toml"
    return [
        paragraph(f"Source: {study.source}" if study.source else "", "note"),
        table("Varied values and versions", ("", ""), rows, numbers=False),
        paragraph("The same command repeats the study with the same numbers, or continues it if it was interrupted."),
        f"<pre><code>forficula study {escaped(file)}</code></pre>",
    ]


def _values(study: Study, factor: Factor) -> str:
    """Return a factor's values, or their number if they were drawn."""
    if study.sampled and study.boundaries is None:
        return f"{len(study.points)} values drawn"
    values = list(dict.fromkeys(str(value) for value in factor.values))
    return ", ".join(values) if len(values) <= 12 else f"{values[0]} to {values[-1]}, {len(values)} values"


def _plural(step: SearchStep) -> str:
    return f"{step.value_name.replace('_', ' ')}s"


def _torques(step: SearchStep) -> str:
    first, last = show_quantity(step.values[0], step.unit), show_quantity(step.values[-1], step.unit)
    what = "torques" if step.unit is TORQUE else "values"
    return first if len(step.values) == 1 else f"{first} to {last}, {len(step.values)} {what}"
