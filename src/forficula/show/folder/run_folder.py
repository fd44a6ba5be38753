"""The files that a run leaves."""

from __future__ import annotations

from pathlib import Path

from matplotlib.figure import Figure

from forficula.analysis import Outcome
from forficula.analysis.package import smallest_package
from forficula.analysis.run_files import write_run_files
from forficula.analysis.storage import storages
from forficula.dynamics import Record, compile_model
from forficula.files import replacing_all, write_text
from forficula.show.folder.cycling_folder import CYCLING_FILES
from forficula.show.page import write_run_page
from forficula.show.run.folding_figure import draw_folding
from forficula.show.run.package_figure import draw_package
from forficula.show.run.storage_figure import draw_storage
from forficula.show.run.time_figures import draw_angles, draw_energies
from forficula.show.structure.pattern_figure import draw_pattern
from forficula.show.style import VERMILION, Drawing, save_figures

_SMALLER = 0.9  # of the area as it begins: what takes more is not folded away


def write_run(record: Record, outcome: Outcome, folder: Path) -> None:
    """Write design, model, record, summary, figures and page; all of them, or none.

    Args:
        record: what happened.
        outcome: what it means.
        folder: made where it is missing; what an earlier run left there is replaced, its cycles removed.

    Raises:
        InputError: the folder cannot be written.
    """
    with replacing_all(folder, remove=CYCLING_FILES) as unfinished:
        _write_files(record, outcome, unfinished)


def _write_files(record: Record, outcome: Outcome, folder: Path) -> None:
    write_run_files(record, outcome, folder)
    write_text(folder / "model.xml", compile_model(record.design).xml)
    save_figures(run_drawings(record, outcome), folder)
    write_run_page(record, outcome, folder / "report.html")


def run_drawings(record: Record, outcome: Outcome) -> dict[str, Drawing]:
    """What draws a run, by the stem of its file; the room that it takes where a state takes less."""
    smallest = smallest_package(record)
    folds = smallest is not None and smallest[2].area_ratio < _SMALLER
    package: dict[str, Drawing] = {"package": lambda width: _marked(draw_package(record, width), outcome)}
    storage: dict[str, Drawing] = {"storage": lambda width: _marked(draw_storage(record, width), outcome)}
    return {
        "pattern": lambda width: draw_pattern(record.structure, width),
        "angles": lambda width: _marked(draw_angles(record, outcome, width), outcome),
        "energy": lambda width: _marked(draw_energies(record, width), outcome),
        "folding": lambda width: _marked(draw_folding(record, outcome, width), outcome),
        **(package if folds else {}),
        **(storage if any(each.pulls is not None for each in storages(record)) else {}),
    }


def _marked(figure: Figure, outcome: Outcome) -> Figure:
    """Say on a figure where what it shows is not what the structure would do."""
    if not outcome.verdict.tells:
        figure.suptitle(
            f"{outcome.status[:1].upper()}{outcome.status[1:]}",
            color=VERMILION,
            fontweight="bold",
            fontsize="medium",
            wrap=True,
        )
    return figure
