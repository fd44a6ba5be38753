"""Page with a structure that the reader can move, without a run."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from forficula.analysis import measure
from forficula.design import Design, with_values
from forficula.dynamics import compile_model, simulate, why_not_portable, with_timestep
from forficula.errors import InputError
from forficula.files import write_text
from forficula.quantities import reading_unit
from forficula.show.page.data.live_data import live_data
from forficula.show.page.page import page_html
from forficula.show.page.parts.design_rows import design_title
from forficula.show.page.parts.design_tables import design_tables
from forficula.show.page.parts.html import escaped, paragraph, remarks, section
from forficula.show.page.parts.run_sentences import shape_text, structure_text
from forficula.show.page.playback import Clip, clip_data, legend_data, make_clip, structure_noun
from forficula.show.page.run_page import repeat
from forficula.structure import structure_warnings

_STEPS = 2  # length of the run that gives the shape at the start, timesteps


def write_live_page(design: Design, path: Path) -> None:
    """Write a design as one HTML file in which the reader moves its structure, without a network.

    Raises:
        InputError: the engine in a page would simulate the design differently (with the reason), or the file cannot be
            written.
    """
    write_text(path, live_page(design))


def live_page(design: Design) -> str:
    """Return a design as one page: its structure, simulated live, with sliders for some of its values, and all values.

    Raises:
        InputError: the engine in a page would simulate the design differently (with the reason).
    """
    design = with_timestep(design)
    if why := why_not_portable(compile_model(design)):
        raise InputError(f"{design.name}: cannot be moved in a page: {why}; forficula run {design.name} simulates it")
    clip = start_clip(design)
    title = design_title(design)
    shows = f"{design.shows[:1].upper()}{design.shows[1:]}." if design.shows else ""
    body = "".join(
        (
            f"<header><h1>{escaped(title)}</h1>{paragraph(shows, 'outcome')}</header>\n",
            '<main><section id="try" aria-label="try it"></section>\n',
            section("What to know", remarks(structure_warnings(design, clip.structure))),
            section("Design", *design_tables(design), name="design"),
            section("Run it", *repeat(design), name="repeat"),
            "</main>",
        )
    )
    live = live_data(design, [reading.measure for reading in clip.readings], clip.mesh.anchors.tolist())
    return page_html(f"{title}: interactive", body, live_page_data(clip), live)


def start_clip(design: Design) -> Clip:
    """Return the structure at its start as a clip, from a run of two timesteps."""
    timestep = float(design.protocol.timestep)
    stage = {"name": "start", "drive": "none", "until": "time", "hold": 0.0, "time_limit": _STEPS * timestep}
    short = with_values(design, {"protocol.stages": [stage]})
    (record,) = simulate([compile_model(short)])
    return make_clip(record, measure(record), name=design.name)


def live_page_data(clip: Clip) -> dict[str, Any]:
    """Return a structure that the reader moves, as data for JSON: its shape and what the picture needs."""
    tendons = clip.structure.tendons
    largest = max((float(tendon.law.elastic.energy(tendon.longest)) for tendon in tendons), default=0.0)
    unit, factor = reading_unit("J", largest)
    return {
        "kind": "bench",
        "whole": structure_noun([clip]),
        "clips": [clip_data(clip)],
        "energy": {"unit": unit, "factor": factor, "largest_J": largest},
        "legend": legend_data([clip]),
        "text": structure_text(clip.structure),
        "shape": shape_text(clip.structure),
    }
