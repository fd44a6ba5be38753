"""Files of a run."""

from __future__ import annotations

import textwrap
from collections.abc import Collection, Iterator
from functools import cache
from pathlib import Path

from matplotlib.figure import Figure

from forficula.analysis import Outcome, Verdict, measure
from forficula.analysis.package import smallest_package
from forficula.analysis.run_files import read_run, write_run_files
from forficula.analysis.storage import storages
from forficula.dynamics import Record, compile_model
from forficula.files import replacing_all, write_text
from forficula.show.folder.cycling_folder import CYCLING_FILES
from forficula.show.folder.notebook_cell import framed
from forficula.show.folder.presentation import Presentation
from forficula.show.page import write_run_page
from forficula.show.page.run_page import run_page
from forficula.show.run.angles_figure import draw_angles
from forficula.show.run.energies_figure import draw_energies
from forficula.show.run.folding_figure import draw_folding
from forficula.show.run.mechanisms_figure import draw_mechanisms
from forficula.show.run.missed_goal import needed_torque
from forficula.show.run.package_figure import draw_package
from forficula.show.run.storage_figure import draw_storage
from forficula.show.structure.pattern_figure import draw_pattern
from forficula.show.style import VERMILION, Drawing, copy_files, figure_style, save_figures

_HEADING, _LETTERS = 8.0, 15  # size of a heading in pt, and its letters per inch
STRAIN, MECHANISMS = "strain", "mechanisms"  # names of figures that are drawn only on request
_KINDS = ("pattern", "angles", "energy", "folding", "package", "storage")  # names of a run's figures
_SMALLER = 0.9  # largest area of a package, as a share of the area at the start


def write_run(
    record: Record, outcome: Outcome, folder: Path, *, engine: bool = True, copies: Collection[str] = ()
) -> None:
    """Write the design, model, record, summary, figures and page; all of them, or none.

    Figures are written as PNG. `forficula figure` draws any of them in another format.

    Args:
        record: the simulated motion.
        outcome: the outcome of the run.
        folder: folder, created if missing; files of an earlier run are replaced, its cycling analysis removed.
        engine: whether the page contains the simulator, with which a reader can vary the run.
        copies: endings of formats in which column-wide figures are also written: ".svg", ".pdf".

    Raises:
        InputError: the folder cannot be written.
    """
    # copies of an earlier run
    stale = [file for kind in _KINDS for file in copy_files(kind)]
    with replacing_all(folder, remove=(*CYCLING_FILES, *stale)) as unfinished:
        _write_files(record, outcome, unfinished, engine=engine, copies=copies)


def _write_files(record: Record, outcome: Outcome, folder: Path, *, engine: bool, copies: Collection[str]) -> None:
    write_run_files(record, outcome, folder)
    write_text(folder / "model.xml", compile_model(record.design).xml)
    drawings = run_drawings(record, outcome)
    for name in (STRAIN, MECHANISMS):
        drawings.pop(name, None)
    save_figures(drawings, folder, copies)
    write_run_page(record, outcome, folder / "report.html", engine=engine)


def run_drawings(record: Record, outcome: Outcome) -> dict[str, Drawing]:
    """Return the drawings of a run by the stems of their files; the package only if a state takes less area."""
    smallest = smallest_package(record)
    stuck = outcome.verdict is Verdict.STUCK  # then the advice has already computed the least torque
    needed = cache(lambda: outcome.advised.least_torque if stuck else needed_torque(record))
    folds = smallest is not None and smallest[2].area_ratio < _SMALLER
    package: dict[str, Drawing] = {"package": lambda width: _marked(draw_package(record, width), outcome)}
    strain: Drawing = lambda width: _marked(draw_folding(record, outcome, width, strain=True), outcome)  # noqa: E731
    storage: dict[str, Drawing] = {"storage": lambda width: _marked(draw_storage(record, width), outcome)}
    return {
        "pattern": lambda width: draw_pattern(record.structure, width),
        "angles": lambda width: _marked(draw_angles(record, outcome, width, needed), outcome),
        "energy": lambda width: _marked(draw_energies(record, width), outcome),
        MECHANISMS: lambda width: _marked(draw_mechanisms(record, width), outcome),
        "folding": lambda width: _marked(draw_folding(record, outcome, width), outcome),
        **({STRAIN: strain} if record.structure.membranes else {}),
        **(package if folds else {}),
        **(storage if any(storage.pulls is not None for storage in storages(record)) else {}),
    }


def _marked(figure: Figure, outcome: Outcome) -> Figure:
    """Write on a figure the outcome of a run that did not reach its goal, and the advice."""
    if outcome.verdict is not Verdict.REACHED:
        status = f"{outcome.status[:1].upper()}{outcome.status[1:]}"
        advice = f". {outcome.advice}" if outcome.verdict.conclusive and outcome.advice else ""
        words = textwrap.fill(status + advice, int(_LETTERS * figure.get_figwidth()))
        with figure_style():  # names may contain "$", which must not start a formula
            figure.suptitle(words, color=VERMILION, fontweight=None if advice else "bold", fontsize=_HEADING)
    return figure


def _drawings(record: Record) -> dict[str, Drawing]:
    return run_drawings(record, measure(record))


def _cell(record: Record) -> Iterator[str]:
    """Yield the page of the run, which plays it back."""
    yield framed(run_page(record, measure(record)), f"{record.design.name}, playback")


PRESENTATION = Presentation(
    drawings=_drawings,
    cell=_cell,
    read=lambda folder: _drawings(read_run(folder)),
    write=lambda record, folder: write_run(record, measure(record), folder),
    page=lambda record, path, engine: write_run_page(record, measure(record), path, engine=engine),
)
