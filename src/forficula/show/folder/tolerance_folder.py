"""The files that a tolerance leaves beside its journal."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from forficula.csv_text import csv_text
from forficula.design import save_design
from forficula.dynamics import versions
from forficula.files import write_text
from forficula.goals.tolerance import Tolerance
from forficula.goals.tolerance.advice import advice, most_telling
from forficula.goals.tolerance.nearest_failure import Reach
from forficula.goals.tolerance.probability import Probability
from forficula.goals.tolerance.tolerance_table import tolerance_table
from forficula.show.goals.tolerance_figures import draw_cloud, draw_indices, draw_reaches
from forficula.show.goals.tolerance_text import tolerance_text
from forficula.show.page.results_page import figure_sections, results_page
from forficula.show.page.rich_html import laid_out
from forficula.show.style import Drawing, save_figures

if TYPE_CHECKING:
    from xarray import Dataset

TOLERANCE_FILE = "tolerance.json"
_HEADINGS = {
    "indices": "What decides it",
    "cloud": "What is built, over the map of verdicts",
    "reaches": "How far each value may go alone",
}


def write_tolerance(found: Tolerance, folder: Path) -> Dataset:
    """Write design.toml, tolerance.json, tolerance.nc, samples.csv, the figures and the page.

    Args:
        found: what the runs say.
        folder: with the journal; what an earlier result left there is replaced.

    Returns:
        The table that was written.

    Raises:
        InputError: the folder cannot be written.
    """
    table = tolerance_table(found)
    save_design(found.question.design, folder / "design.toml")
    write_text(folder / TOLERANCE_FILE, json.dumps(tolerance_json(found), indent=2, ensure_ascii=False) + "\n")
    write_text(folder / "samples.csv", _samples_csv(found))
    E
