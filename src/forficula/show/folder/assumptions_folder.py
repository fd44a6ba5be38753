"""The files that the assumptions of a design leave."""

from __future__ import annotations

from pathlib import Path

from forficula.csv_text import csv_text
from forficula.files import replacing_all, write_text
from forficula.show.folder.cell import printed_with_figure
from forficula.show.folder.presentation import Presentation
from forficula.show.page.results_page import write_results_page
from forficula.show.study.assumptions_figure import draw_assumptions
from forficula.show.study.assumptions_table import assumption_rows, assumptions_table
from forficula.show.style import Drawing, save_figures
from forficula.study.assumptions.assumptions import Assumptions
from forficula.study.assumptions.assumptions_file import ASSUMPTIONS_FILE, load_assumptions, save_assumptions

_HEADINGS = {"assumptions": "What each assumption changes"}


def write_assumptions(found: Assumptions, folder: Path) -> None:
    """Write assumptions.json, assumptions.csv, the figure and the page; all of them, or none.

    Args:
        found: what to write.
        folder: made where it is missing; earlier assumptions in it are replaced.

    Raises:
        InputError: the folder cannot be written.
    """
    with replacing_all(folder) as unfinished:
        _write_files(found, unfinished)


def _write_files(found: Assumptions, folder: Path) -> None:
    rows = assumption_rows(found)
    cells = [["" if value is None else value for value in row.values()] for row in rows]
    write_text(folder / "assumptions.csv", csv_text([list(rows[0]), *cells]))
    save_assumptions(found, folder / ASSUMPTIONS_FILE)
    texts = save_figures(assumptions_drawings(found), folder)
    write_results_page(folder, "assumptions", found.design.name, assumptions_table(found), _HEADINGS, texts)


def assumptions_drawings(found: Assumptions) -> dict[str, Drawing]:
    """What draws assumptions, by the stem of its file; nothing where no assumption applies."""
    return {"assumptions": lambda width: draw_assumptions(found, width)} if found.runs else {}


PRESENTATION = Presentation(
    drawings=assumptions_drawings,
    cell=lambda found: printed_with_figure(assumptions_table(found), assumptions_drawings(found)),
    read=lambda folder: assumptions_drawings(load_assumptions(folder / ASSUMPTIONS_FILE)),
    write=write_assumptions,
)
