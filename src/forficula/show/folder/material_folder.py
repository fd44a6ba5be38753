"""Files of a characterised material."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from forficula.files import replacing_all, write_text
from forficula.material.characterisation import Characterisation
from forficula.material.law.law_file import save_law
from forficula.serial import json_text
from forficula.show.folder.notebook_cell import picture, printed
from forficula.show.folder.presentation import Presentation
from forficula.show.material.cycles_figure import draw_cycles
from forficula.show.material.drift_figure import draw_drift
from forficula.show.material.law_figure import draw_fit
from forficula.show.material.material_table import material_table
from forficula.show.material.modulus_figure import draw_moduli
from forficula.show.page.parts.rich_html import printed_result
from forficula.show.page.results_page import figure_sections, results_page
from forficula.show.style import PAGE_WIDTH, Drawing, figure_files, save_figures

LAW_FILE = "tendon_law.toml"
_HEADINGS = {
    "fit": "Tests, fitted law and residuals",
    "cycles": "Cycles",
    "modulus": "Moduli by class of strain",
    "drift": "Change over the cycles",
}


def write_material(material: Characterisation, folder: Path) -> None:
    """Write the summary, the law, figures and page; all of them, or none.

    Args:
        material: the material.
        folder: folder, created if missing; files of an earlier material are replaced, its law and the figure of
                the fit removed if this one has none.

    Raises:
        InputError: the folder cannot be written.
    """
    with replacing_all(folder, remove=(LAW_FILE, *figure_files("fit"))) as unfinished:
        _write_files(material, unfinished)


def _write_files(material: Characterisation, folder: Path) -> None:
    write_text(folder / "material.json", json_text(material))
    if material.law is not None:
        save_law(material.law, folder / LAW_FILE)
    texts = save_figures(material_drawings(material), folder)
    printed_text = printed_result(material_table(material))
    page = results_page("material", material.name, printed_text, figure_sections(folder, _HEADINGS, texts))
    write_text(folder / "report.html", page)


def material_drawings(material: Characterisation) -> dict[str, Drawing]:
    """Return the drawings of a material by the stems of their files."""
    drawings: dict[str, Drawing] = {
        "cycles": lambda width: draw_cycles(material, width),
        "modulus": lambda width: draw_moduli(material, width),
        "drift": lambda width: draw_drift(material, width),
    }
    if material.law is not None:
        drawings["fit"] = lambda width: draw_fit(material, width)
    return drawings


def _cell(material: Characterisation) -> Iterator[str]:
    yield from printed(material_table(material))
    drawings = material_drawings(material)
    yield picture(drawings.get("fit", drawings["cycles"])(PAGE_WIDTH))


PRESENTATION = Presentation(
    drawings=material_drawings,
    cell=_cell,
    copied="a material cannot be drawn again without its tests",
    write=write_material,
)
