"""Page of a run: the moving structure, its plots, and all numbers."""

from __future__ import annotations

import base64
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from forficula.analysis import Outcome, run_warnings
from forficula.analysis.contact_overlap import contact_text
from forficula.analysis.order_of_events import event_texts
from forficula.analysis.storage import storage_texts
from forficula.design import Design, design_text
from forficula.dynamics import Record, timestep_warnings, versions
from forficula.files import write_text
from forficula.show.page.data.fold_view import fold_view
from forficula.show.page.data.live_data import live_data
from forficula.show.page.data.shown_path import fold_of
from forficula.show.page.data.time_spans import run_spans, span_data
from forficula.show.page.page import page_html
from forficula.show.page.parts.design_rows import design_title
from forficula.show.page.parts.design_tables import design_tables
from forficula.show.page.parts.html import escaped, paragraph, remarks, section, table
from forficula.show.page.parts.outcome_tables import groups_table, outcome_tables, strength_table
from forficula.show.page.parts.plots import energy_plot, mechanisms_plot, plot_data, reading_plot
from forficula.show.page.parts.run_sentences import (
    energy_text,
    outcome_remarks,
    outcome_sentence,
    shape_text,
    structure_text,
)
from forficula.show.page.playback import BUDGET, Clip, clip_data, energy_scale, legend_data, make_clip, structure_noun
from forficula.structure import structure_warnings

# bytes of a clip on a page that contains the engine, so that the page stays below 5 MB
_BESIDE_ENGINE = 550_000


def write_run_page(record: Record, outcome: Outcome, path: Path, *, engine: bool = True) -> None:
    """Write a run as one HTML file that works offline.

    Args:
        record: the simulated motion.
        outcome: the outcome of the run.
        path: path of the file.
        engine: whether the page contains the simulator, with which a reader can vary the run.

    Raises:
        InputError: it cannot be written.
    """
    write_text(path, run_page(record, outcome, engine=engine))


def run_page(record: Record, outcome: Outcome, *, engine: bool = False) -> str:
    """Return a run as one page: the structure in 3-D, its plots, its numbers, its design and how to repeat it.

    Args:
        record: the simulated motion.
        outcome: the outcome of the run.
        engine: whether the page contains the simulator, which takes 3.5 MB.
    """
    design = record.design
    clip = make_clip(record, outcome, budget=_BESIDE_ENGINE if engine else BUDGET)
    measures = [reading.measure for reading in clip.readings]
    live = live_data(design, measures, clip.mesh.anchors.tolist()) if engine else None
    title = design_title(design)
    sentence = paragraph(outcome_sentence(design.name, outcome), "outcome")
    fold = fold_of(record.structure)
    elements = "".join(f'<div id="{name}"></div>\n' for name in ("player", "plots", "readout"))
    trial = "" if live is None else '<section id="try" aria-label="try it"></section>\n'
    elements = elements.replace('<div id="plots">', f'{paragraph(fold.missing, "note")}{trial}<div id="plots">')
    body = f"<header><h1>{escaped(title)}</h1>{sentence}</header>\n<main>{elements}{numbers(record, outcome)}</main>"
    stack = mechanisms_plot(record, clip)
    data = playback_data(clip) | {"paths": [] if fold.path is None else [fold_view(fold.path, beside_run=True)]}
    data["plots"] += plot_data([] if stack is None else [stack])
    return page_html(f"{title}: {outcome.status}", body, data, live)


def numbers(record: Record, outcome: Outcome, run_versions: Mapping[str, str] | None = None) -> str:
    """Return the sections below the plots of a run's page, as HTML.

    Args:
        record: the simulated motion.
        outcome: the outcome of the run.
        run_versions: versions with which the run was made; the installed ones by default.
    """
    design = record.design
    known = [*structure_warnings(design, record.structure), *timestep_warnings(design), *run_warnings(record)]
    derived = [text] if (text := contact_text(record)) else []
    warnings = [*outcome_remarks(record, outcome), *derived, *storage_texts(record, outcome), *known]
    events = [paragraph(text) for text in event_texts(record)]
    return "".join(
        (
            section("What to know", remarks(warnings) or paragraph("There are no warnings.")),
            section("Outcome", *events, *outcome_tables(outcome), strength_table(record), name="outcome"),
            section("Dimensionless groups", groups_table(record), name="groups"),
            section("Design", *design_tables(design), name="design"),
            section("Run it again", *_repeat(design, run_versions or versions(design.protocol.device)), name="repeat"),
        )
    )


def playback_data(clip: Clip) -> dict[str, Any]:
    """Return a run as data for JSON: the motion, its plots, and the time spans that the page shows enlarged."""
    energies = [(name, 0, values) for name, values in clip.stored_energy.items()]
    plots = (
        *(reading_plot(clip, number) for number in range(len(clip.readings))),
        energy_plot("energy", energies, energy_text(clip)),
    )
    return {
        "kind": "run",
        "whole": structure_noun([clip]),
        "clips": [clip_data(clip)],
        "spans": [span_data(span) for span in run_spans(clip)],
        "plots": plot_data(plots),
        "energy": energy_scale([clip]),
        "legend": legend_data([clip]),
        "text": structure_text(clip.structure),
        "shape": shape_text(clip.structure),
    }


def _repeat(design: Design, run_versions: Mapping[str, str]) -> list[str]:
    return [
        paragraph("The design file contains every value; running it with the same versions gives the same numbers."),
        *repeat(design),
        table(
            "Versions",
            ("", ""),
            [*([name, version] for name, version in run_versions.items()), ["design hash", design.hash]],
            numbers=False,
        ),
    ]


def repeat(design: Design) -> list[str]:
    """Return the HTML of a link to a design's file and of the command that runs the design."""
    content = base64.b64encode(design_text(design).encode()).decode("ascii")
    return [
        f'<p><a class="button" download="design.toml" href="data:application/toml;base64,{content}">'
        "Download design.toml</a></p>\n<pre><code>forficula run design.toml</code></pre>",
    ]
