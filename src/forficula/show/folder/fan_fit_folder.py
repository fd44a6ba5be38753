"""Files of a fan that was fitted to clicked points."""

from __future__ import annotations

from pathlib import Path

from forficula.design import design_text
from forficula.files import replacing_all, write_text
from forficula.goals.clicks.fan_fit import FanFit
from forficula.serial import json_text
from forficula.show.folder.notebook_cell import printed_with_figure
from forficula.show.folder.presentation import Presentation
from forficula.show.goals.fan_fit_figures import draw_fan_fit, draw_vein_deviations
from forficula.show.goals.fan_fit_text import fan_fit_table
from forficula.show.page.results_page import write_results_page
from forficula.show.style import Drawing, save_figures

DESIGN_FILE = "design.toml"
_DIFFERENT_FILE = "design-different-veins.toml"
_HEADINGS = {"fan": "Fitted fan", "veins": "Deviations by vein"}


def write_fan_fit_folder(fit: FanFit, folder: Path) -> None:
    """Write the designs, fan.json, figures and page; all of them, or none.

    Args:
        fit: fitted fan.
        folder: folder, created if missing; files of an earlier fit are replaced.

    Raises:
        InputError: the folder cannot be written.
    """
    with replacing_all(folder) as unfinished:
        write_text(unfinished / "fan.json", json_text(fit))
        for name, design in (
            (DESIGN_FILE, fit.design),
            (_DIFFERENT_FILE, fit.different.design if fit.different else None),
        ):
            if design is not None:
                write_text(unfinished / name, design_text(design))
        texts = save_figures(fan_fit_drawings(fit), unfinished)
        write_results_page(unfinished, "fan fit", fit.name or "fan", fan_fit_table(fit), _HEADINGS, texts)


def fan_fit_drawings(fit: FanFit) -> dict[str, Drawing]:
    """Return the drawings of a fitted fan by the stems of their files."""
    return {
        "fan": lambda width: draw_fan_fit(fit, width),
        "veins": lambda width: draw_vein_deviations(fit, width),
    }


PRESENTATION = Presentation(
    drawings=fan_fit_drawings,
    cell=lambda fit: printed_with_figure(fan_fit_table(fit), fan_fit_drawings(fit)),
    copied="a fitted fan cannot be drawn again without its picture",
    write=write_fan_fit_folder,
)
