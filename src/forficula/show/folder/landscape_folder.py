"""The files that a landscape leaves."""

from __future__ import annotations

import json
from pathlib import Path

from forficula.analysis.simulated_snap import INNER_VEIN, simulation_summary
from forficula.design import save_design
from forficula.dynamics import Record, versions
from forficula.files import replacing_all, write_text
from forficula.show.landscape.landscape_figure import draw_wing
from forficula.show.landscape.levels_figure import draw_levels
from forficula.show.landscape.tendon_figure import draw_tendon
from forficula.show.style import Drawing, save_figures
from forficula.statics import EnergyLandscape, landscape_summary


def write_landscape(
    landscape: EnergyLandscape, folder: Path, record: Record | None = None, vein: int = INNER_VEIN
) -> None:
    """Write design, landscape and figures; all of them, or none.

    Args:
        landscape: what to write.
        folder: made where it is missing; what an earlier landscape left there is replaced.
        record: a run of the design, to be shown beside; one that diverged is named and not drawn.
        vein: number of the one, from 0, whose tendon stands for those of the wing.

    Raises:
        InputError: the folder cannot be written.
    """
    with replacing_all(folder) as unfinished:
        _write_files(landscape, unfinished, record, vein)


def _write_files(landscape: EnergyLandscape, folder: Path, record: Record | None, vein: int) -> None:
    save_design(landscape.design, folder / "design.toml")
    content = landscape_summary(landscape) | {
        "simulation": None if record is None else simulation_summary(record, vein),
        "versions": versions(),
    }
    # what does not exist is null; not every reader of JSON knows NaN
    text = json.dumps(content, indent=2, ensure_ascii=False, allow_nan=False)
    write_text(folder / "landscape.json", text + "\n")
    save_figures(landscape_drawings(landscape, record, vein), folder)


def landscape_drawings(
    landscape: EnergyLandscape, record: Record | None = None, vein: int = INNER_VEIN
) -> dict[str, Drawing]:
    """What draws a landscape, by the stem of its file; a run that diverged is not drawn beside it."""
    drawn = record if record is not None and record.diverged_at is None else None
    return {
        "tendon": lambda width: draw_tendon(landscape, drawn, width, vein),
        "wing": lambda width: draw_wing(landscape, width),
        "levels": lambda width: draw_levels(landscape, width),
    }
