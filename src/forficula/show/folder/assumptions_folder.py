"""Files of an analysis of assumptions."""

from __future__ import annotations

from pathlib import Path

from forficula.csv_text import csv_table
from forficula.files import replacing_all, write_text
from forficula.show.folder.notebook_cell import printed_with_figure
from forficula.show.folder.presentation import Presentation
from forficula.show.page.results_page import write_results_page
from forficula.show.study.assumptions_figure import draw_assumptions
from forficula.show.study.assumptions_table import assumption_rows, assumptions_table
from forficula.show.style import Drawing, save_figures
from forficula.study.assumptions.assumptions import Assumptions
from forficula.study.assumptions.assumptions_file import ASSUMPTIONS_FILE, load_assumptions, save_assumptions

_HEADINGS = {"assumptions": "Effect of each assumption"}


def write_assumptions(results: Assumptions, folder: Path) -> None:
    """Write assumptions.json, assumptions.csv, the figure and the page; all of them, or none.

    Args:
        results: the results.
        folder: folder, created if missing; earlier assumptions in it are replaced.

    Raises:
        InputError: the folder cannot be written.
    """
    with replacing_all(folder) as unfinished:
        _write_files(results, unfinished)


def _write_files(results: Assumptions, folder: Path) -> None:
    write_text(folder / "assumptions.csv", csv_table(assumption_rows(results)))
    save_assumptions(results, folder / ASSUMPTIONS_FILE)
    texts = save_figures(assumptions_drawings(results), folder)
    write_results_page(folder, "assumptions", results.design.name, assumptions_table(results), _HEADINGS, texts)


def assumptions_drawings(results: Assumptions) -> dict[str, Drawing]:
    """Return the drawings of assumptions by the stems of their files; empty if no assumption applies."""
    return {"assumptions": lambda width: draw_assumptions(results, width)} if results.runs else {}


PRESENTATION = Presentation(
    drawings=assumptions_drawings,
    cell=lambda results: printed_with_figure(assumptions_table(results), assumptions_drawings(results)),
    read=lambda folder: assumptions_drawings(load_assumptions(folder / ASSUMPTIONS_FILE)),
    write=write_assumptions,
)
