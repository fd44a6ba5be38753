"""Files of a characterised crease."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from forficula.files import replacing_all, write_text
from forficula.material.folding.crease_characterisation import CreaseCharacterisation
from forficula.material.law.crease_law_file import save_crease_law
from forficula.serial import json_text
from forficula.show.folder.notebook_cell import picture, printed
from forficula.show.folder.presentation import Presentation
from forficula.show.material.crease_figure import draw_crease
from forficula.show.material.crease_table import crease_table
from forficula.show.page.parts.rich_html import printed_result
from forficula.show.page.results_page import figure_sections, results_page
from forficula.show.style import PAGE_WIDTH, Drawing, save_figures

CREASE_LAW_FILE = "crease_law.toml"
_HEADINGS = {"fit": "Tests, fitted law and residuals"}


def write_crease(crease: CreaseCharacterisation, folder: Path) -> None:
    """Write the summary, the law, figures and page; all of them, or none.

    Args:
        crease: the characterised crease.
        folder: folder, created if missing; files of an earlier crease are replaced.

    Raises:
        InputError: the folder cannot be written.
    """
    with replacing_all(folder) as unfinished:
        write_text(unfinished / "crease.json", json_text(crease))
        save_crease_law(crease.law, unfinished / CREASE_LAW_FILE)
        texts = save_figures(crease_drawings(crease), unfinished)
        sections = figure_sections(unfinished, _HEADINGS, texts)
        page = results_page("crease", crease.name, printed_result(crease_table(crease)), sections)
        write_text(unfinished / "report.html", page)


def crease_drawings(crease: CreaseCharacterisation) -> dict[str, Drawing]:
    """Return the drawings of a crease by the stems of their files."""
    return {"fit": lambda width: draw_crease(crease, width)}


def _cell(crease: CreaseCharacterisation) -> Iterator[str]:
    yield from printed(crease_table(crease))
    yield picture(draw_crease(crease, PAGE_WIDTH))


PRESENTATION = Presentation(
    drawings=crease_drawings,
    cell=_cell,
    copied="a law of creases cannot be drawn again without its tests",
    write=write_crease,
)
