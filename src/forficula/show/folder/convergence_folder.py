"""Files of a convergence study."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any

import numpy as np

from forficula.csv_text import csv_table
from forficula.design.design import DesignIdentity
from forficula.dynamics import versions
from forficula.files import replacing_all, write_text
from forficula.serial import Written, json_text
from forficula.show.folder.notebook_cell import printed_with_figure
from forficula.show.folder.presentation import Presentation
from forficula.show.page.results_page import write_results_page
from forficula.show.study.convergence_figure import draw_convergence_angles, draw_convergence_times
from forficula.show.study.convergence_table import convergence_rows, convergence_table
from forficula.show.style import Drawing, save_figures
from forficula.study.convergence.convergence import Convergence
from forficula.study.convergence.convergence_file import load_convergence, save_convergence
from forficula.study.convergence.observed_order import OrderFit

CONVERGENCE_FILE = "convergence.nc"
_HEADINGS = {"times": "Times and their limits", "angles": "Every run"}


def write_convergence(convergence: Convergence, folder: Path) -> None:
    """Write convergence.json, convergence.csv, convergence.nc, the figures and the page; all of them, or none.

    Args:
        convergence: the study.
        folder: folder, created if missing; files of an earlier study are replaced.

    Raises:
        InputError: the folder cannot be written.
    """
    with replacing_all(folder) as unfinished:
        _write_files(convergence, unfinished)


def _write_files(convergence: Convergence, folder: Path) -> None:
    write_text(folder / "convergence.csv", csv_table(convergence_rows(convergence)))
    write_text(folder / "convergence.json", json_text(convergence_summary(convergence)))
    save_convergence(convergence, folder / CONVERGENCE_FILE)
    texts = save_figures(convergence_drawings(convergence), folder)
    write_results_page(folder, "convergence", convergence.design.name, convergence_table(convergence), _HEADINGS, texts)


@dataclass(frozen=True, kw_only=True)
class ConvergenceSummary:
    """Convergence study as in `convergence.json`, with the fitted order of each time over the timestep."""

    design: Annotated[DesignIdentity, Written.BESIDE]
    key: str
    verdict: str
    fine: bool | None
    tolerance: float
    own: Mapping[str, Any]
    runs: Sequence[Mapping[str, Any]]
    times: Annotated[Mapping[str, OrderFit | None], Written.BESIDE]
    versions: Mapping[str, str]


def convergence_summary(convergence: Convergence) -> ConvergenceSummary:
    """Return the contents of `convergence.json`."""
    rows = convergence_rows(convergence)
    return ConvergenceSummary(
        design=convergence.design.identity,
        key=convergence.key,
        verdict=convergence.verdict,
        fine=convergence.fine,
        tolerance=convergence.tolerance,
        own=rows[int(np.argmax(convergence.values == convergence.design_value))],
        runs=rows,
        times={f"{name}_time": fit for name, fit in convergence.orders.items()},
        versions=versions(),
    )


def convergence_drawings(convergence: Convergence) -> dict[str, Drawing]:
    """Return the drawings of a convergence study by the stems of their files."""
    drawings: dict[str, Drawing] = {"angles": lambda width: draw_convergence_angles(convergence, width)}
    if convergence.transition_times:
        drawings["times"] = lambda width: draw_convergence_times(convergence, width)
    return drawings


PRESENTATION = Presentation(
    drawings=convergence_drawings,
    cell=lambda convergence: printed_with_figure(convergence_table(convergence), convergence_drawings(convergence)),
    read=lambda folder: convergence_drawings(load_convergence(folder / CONVERGENCE_FILE)),
    write=write_convergence,
)
