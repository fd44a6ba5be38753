"""Files of a landscape."""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from typing import Any

from matplotlib.figure import Figure

from forficula.analysis.simulated_rests import rest_distances
from forficula.analysis.simulated_snap import inner_hinge, simulation_summary
from forficula.design import load_design, save_design
from forficula.dynamics import Record, versions
from forficula.errors import InputError
from forficula.files import replacing_all, write_text
from forficula.reproduction import shown_tendon
from forficula.serial import json_text
from forficula.show.folder.notebook_cell import printed_with_figure
from forficula.show.folder.presentation import Presentation
from forficula.show.landscape.barriers_figure import draw_barriers
from forficula.show.landscape.equilibria_figure import draw_equilibria
from forficula.show.landscape.landscape_figure import draw_fold_path
from forficula.show.landscape.landscape_table import landscape_table
from forficula.show.landscape.levels_figure import draw_levels
from forficula.show.landscape.slow_paths_figure import draw_slow_paths
from forficula.show.landscape.states_figure import draw_modes, draw_states
from forficula.show.landscape.tendon_figure import draw_tendon
from forficula.show.page.landscape_page import landscape_page
from forficula.show.style import Drawing, save_figures
from forficula.statics import EnergyLandscape, folding_hinges, landscape_summary
from forficula.study.landscape_and_run import landscape_and_run


def write_landscape(
    landscape: EnergyLandscape, folder: Path, record: Record | None = None, tendon: int | None = None
) -> None:
    """Write the design, the landscape, figures and page; all of them, or none.

    Args:
        landscape: the landscape.
        folder: folder, created if missing; files of an earlier landscape are replaced.
        record: a run of the design for comparison; a run that diverged is named and not drawn.
        tendon: index of the tendon shown as an example; an inner one by default.

    Raises:
        InputError: the folder cannot be written.
    """
    with replacing_all(folder) as unfinished:
        _write_files(landscape, unfinished, record, tendon)


def _write_files(landscape: EnergyLandscape, folder: Path, record: Record | None, tendon: int | None) -> None:
    save_design(landscape.design, folder / "design.toml")
    content = landscape_summary(landscape) | {
        "simulation": None if record is None else simulation_summary(record, inner_hinge(landscape, tendon)),
        **({} if record is None or landscape.net is None else _rest_distances_data(landscape, record)),
        "versions": versions(),
        "figures": list(landscape_kinds(landscape)),
    }
    write_text(folder / "landscape.json", json_text(content))
    texts = save_figures(landscape_drawings(landscape, record, tendon), folder)
    write_text(folder / "report.html", landscape_page(landscape, folder, texts, record, tendon))


def _rest_distances_data(landscape: EnergyLandscape, record: Record) -> dict[str, Any]:
    return {"rests_apart_m": dict(rest_distances(landscape, record))}


def landscape_drawings(
    landscape: EnergyLandscape, record: Record | None = None, tendon: int | None = None
) -> dict[str, Drawing]:
    """Return the drawings of a landscape by the stems of their files; a run that diverged is not drawn."""
    drawn = record if record is not None and record.diverged_at is None else None
    drawings: dict[str, Drawing] = {
        "tendon": lambda width: draw_tendon(landscape, drawn, width, tendon),
        "wing": lambda width: draw_fold_path(landscape, width),
        "rests": lambda width: draw_equilibria(landscape, width),
        "levels": lambda width: draw_levels(landscape, width),
        "states": lambda width: draw_states(landscape, width),
        "modes": lambda width: draw_modes(landscape, width),
        "barriers": lambda width: draw_barriers(landscape, width),
        "courses": lambda width: draw_slow_paths(landscape, width),
    }
    return {kind: drawings[kind] for kind in landscape_kinds(landscape)}


def landscape_kinds(landscape: EnergyLandscape) -> tuple[str, ...]:
    """Return the figures of a landscape, by the stems of their files.

    Figures without contents are left out: no tendon across a single hinge, no folding hinge. If there is more than one
    way to fold, or on a table, the equilibria replace the path; for points that slide, the stable states do.
    """
    structure = landscape.structure
    if landscape.net is not None:
        states = ("states", "modes") if landscape.states else ()
        return (*states, *["barriers"] * (len(landscape.states) > 1), *["courses"] * bool(landscape.courses))
    tendon = ("tendon",) if landscape.hinges else ()
    # a single hinge has no intermediate levels, and a figure of its own
    several = len(folding_hinges(structure)) > bool(tendon)
    levels = ("levels",) if several and landscape.partial_folds else ()
    return (*tendon, "rests" if landscape.fold_path is None else "wing", *levels)


def _read(folder: Path) -> dict[str, Drawing]:
    """Return the drawings of a folder, which compute the landscape again: that takes a second, a file many MB."""
    design = load_design(str(folder / "design.toml"))
    try:
        written = json.loads((folder / "landscape.json").read_text("utf-8"))
        simulated, kinds = written["simulation"] is not None, list(map(str, written["figures"]))
    except (OSError, LookupError, ValueError, TypeError) as error:
        raise InputError(f"{folder / 'landscape.json'}: not a landscape of forficula: {error}") from None

    @cache
    def again(simulation: bool) -> dict[str, Drawing]:
        return landscape_drawings(*landscape_and_run(design, simulation=simulation), shown_tendon(design))

    def drawing(kind: str) -> Drawing:
        # only the tendon's figure shows the run
        def draw(width: float) -> Figure:
            return again(simulated and kind == "tendon")[kind](width)

        return draw

    return {kind: drawing(kind) for kind in kinds}


PRESENTATION = Presentation(
    drawings=landscape_drawings,
    cell=lambda landscape: printed_with_figure(landscape_table(landscape), landscape_drawings(landscape)),
    read=_read,
    write=write_landscape,
)
