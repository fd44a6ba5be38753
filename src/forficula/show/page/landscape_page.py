"""The page of a landscape: the run and where it is on the curves of energy, figures and numbers."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from forficula.analysis import measure
from forficula.dynamics import Record
from forficula.show.landscape.landscape_table import landscape_table
from forficula.show.page.design_rows import design_title
from forficula.show.page.landscape_curves import curve_data, landscape_curves
from forficula.show.page.playback import make_clip
from forficula.show.page.results_page import figure_sections, results_page
from forficula.show.page.rich_html import laid_out
from forficula.show.page.run_page import playback_data
from forficula.show.page.words import outcome_sentence
from forficula.statics import EnergyLandscape

_HEADINGS = {
    "tendon": "One tendon over its hinge",
    "wing": "Along the fold",
    "rests": "Where it rests",
    "levels": "With some hinges folded",
    "states": "Stable states",
    "barriers": "Barriers between them",
    "courses": "What drives do",
    "modes": "How it swings",
}


def landscape_page(
    landscape: EnergyLandscape,
    folder: Path,
    texts: Mapping[str, str],
    record: Record | None = None,
    tendon: int | None = None,
) -> str:
    """A landscape as one page.

    Args:
        landscape: what is shown.
        folder: in which its figures lie.
        texts: that stand for them, by the stems of their files.
        record: a run of its design, which plays there; one that diverged is named only.
        tendon: number of the one that stands for all; an inner one if not given.
    """
    name, run = design_title(landscape.design), ""
    drawn = record if record is not None and record.diverged_at is None else None
    curves = landscape_curves(landscape, drawn, tendon)
    data: dict[str, Any] | None = {"kind": "curves"} if curves else None
    if drawn is not None:
        outcome = measure(drawn)
        clip = make_clip(drawn, outcome)
        run = f"The run beside it: {outcome_sentence(name, outcome)}"
        data, curves = playback_data(clip), landscape_curves(landscape, drawn, tendon, clip.time)
    return results_page(
        "landscape",
        name,
        laid_out(landscape_table(landscape, record, tendon)),
        figure_sections(folder, _HEADINGS, texts),
        run=run,
        data=None if data is None else data | {"curves": [curve_data(each) for each in curves]},
    )
