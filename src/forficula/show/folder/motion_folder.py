"""Files of angles over time that were measured in a film."""

from __future__ import annotations

from pathlib import Path

from forficula.files import replacing_all, write_text
from forficula.goals.clicks.motion import ObservedMotion
from forficula.serial import json_text
from forficula.show.folder.notebook_cell import printed_with_figure
from forficula.show.folder.presentation import Presentation
from forficula.show.goals.motion_figures import draw_motion, motion_table
from forficula.show.page.results_page import write_results_page
from forficula.show.style import Drawing, save_figures

OBSERVATIONS_FILE = "observations.toml"
_HEADINGS = {"motion": "Angles over time"}


def write_motion_folder(motion: ObservedMotion, folder: Path) -> None:
    """Write the observations file, motion.json, the figure and the page; all of them, or none.

    Args:
        motion: angles over time.
        folder: folder, created if missing; files of an earlier film are replaced.

    Raises:
        InputError: the folder cannot be written.
    """
    with replacing_all(folder) as unfinished:
        write_text(unfinished / "motion.json", json_text(motion))
        write_text(unfinished / OBSERVATIONS_FILE, motion.observations_text)
        texts = save_figures(motion_drawings(motion), unfinished)
        write_results_page(unfinished, "motion", motion.name or "film", motion_table(motion), _HEADINGS, texts)


def motion_drawings(motion: ObservedMotion) -> dict[str, Drawing]:
    """Return the drawing of angles over time by the stem of its file."""
    return {"motion": lambda width: draw_motion(motion, width)}


PRESENTATION = Presentation(
    drawings=motion_drawings,
    cell=lambda motion: printed_with_figure(motion_table(motion), motion_drawings(motion)),
    copied="angles over time cannot be drawn again without their clicked points",
    write=write_motion_folder,
)
