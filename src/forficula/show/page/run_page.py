"""The page of a run: the structure moving, its plots, and every number."""

from __future__ import annotations

import base64
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from forficula.analysis import Outcome, run_warnings
from forficula.analysis.storage import storage_texts
from forficula.design import Design, design_text
from forficula.dynamics import Record, timestep_warnings, versions
from forficula.files import write_text
from forficula.show.page.data.live_data import live_data
from forficula.show.page.data.time_spans import run_spans, span_data
from forficula.show.page.page import page_html
from forficula.show.page.parts.design_rows import design_title
from forficula.show.page.parts.design_tables import design_tables
from forficula.show.page.parts.html import escaped, paragraph, remarks, section, table
from forficula.show.page.parts.outcome_tables import groups_table, outcome_tables, strength_table
from forficula.show.page.parts.plots import energy_plot, plot_data, reading_plot
from forficula.show.page.parts.words import energy_text, outcome_remarks, outcome_sentence, shape_text, structure_text
from forficula.show.page.playback import BUDGET, Clip, clip_data, energy_scale, legend_data, make_clip, whole_of
from forficula.structure import structure_warnings

# bytes of a clip in a page that has the engine, so that all of it stays below 5 MB
_BESIDE_ENGINE = 550_000


def write_run_page(record: Record, outcome: Outcome, path: Path, *, engine: bool = True) -> None:
    """Write a run as one HTML file that needs no network.

    Args:
        record: what happened.
        outcome: what it means.
        path: of the file.
        engine: whether the simulator is in it, with which a reader moves the structure.

    Raises:
        InputError: it cannot be written.
    """
    write_text(path, run_page(record, outcome, engine=engine))


def run_page(record: Record, outcome: Outcome, *, engine: bool = False) -> str:
    """A run as one page: the structure in 3-D, its plots, its numbers, its design and how to repeat it.

    Args:
        record: what happened.
        outcome: what it means.
        engine: whether the simulator is in it; it takes 3.5 MB.
    """
    design = record.design
    clip = make_clip(record, outcome, budget=_BESIDE_ENGINE if engine else BUDGET)
    measures = [each.measure for each in clip.readings]
    live = live_data(design, measures, clip.mesh.anchors.tolist()) if engine else None
    title = design_title(design)
    sentence = paragraph(outcome_sentence(design.name, outcome), "outcome")
    places = "".join(f'<div id="{name}"></div>\n' for name in ("player", "plots", "readout"))
    trial = "" if live is None else '<section id="try" aria-label="try it"></section>\n'
    places = places.replace('<div id="plots">', f'{trial}<div id="plots">')
    body = f"<header><h1>{escaped(title)}</h1>{sentence}</header>\n<main>{places}{numbers(record, outcome)}</main>"
    return page_html(f"{title}: {outcome.status}", body, playback_data(clip), live)


def numbers(record: Record, outcome: Outcome, run_versions: Mapping[str, str] | None = None) -> str:
    """The sections of a run's page under its plots, as HTML.

    Args:
        record: what happened.
        outcome: what it means.
        run_versions: that the run was made with; those of now if not given.
    """
    design = record.design
    known = [*structure_warnings(design, record.structure), *timestep_warnings(design), *run_warnings(record)]
    warnings = [*outcome_remarks(record, outcome), *storage_texts(record, outcome), *known]
    return "".join(
        (
            section("What to know", remarks(warnings) or paragraph("There is nothing to warn of.")),
            section("Outcome", *outcome_tables(outcome), strength_table(record), name="outcome"),
            section("What weighs how much", groups_table(record), name="groups"),
            section("Design", *design_tables(design), name="design"),
            section("Run it again", *_repeat(design, run_versions or versions()), name="repeat"),
        )
    )


def playback_data(clip: Clip) -> dict[str, Any]:
    """A run as data for JSON: what moves, its plots, and the parts of its time that are shown close up."""
    energies = [(name, 0, values) for name, values in clip.stored_energy.items()]
    plots = (
        *(reading_plot(clip, number) for number in range(len(clip.readings))),
        energy_plot("energy", energies, energy_text(clip)),
    )
    return {
        "kind": "run",
        "whole": whole_of([clip]),
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
        paragraph("The design file holds every value; running it with the same versions gives the same numbers."),
        *repeat(design),
        table(
            "Versions",
            ("", ""),
            [*([name, version] for name, version in run_versions.items()), ["design hash", design.hash]],
            numbers=False,
        ),
    ]


def repeat(design: Design) -> list[str]:
    """A design's file to download, and the command that runs it, as HTML."""
    content = base64.b64encode(design_text(design).encode()).decode("ascii")
    return [
        f'<p><a class="button" download="design.toml" href="data:application/toml;base64,{content}">'
        "Download design.toml</a></p>\n<pre><code>forficula run design.toml</code></pre>",
    ]
