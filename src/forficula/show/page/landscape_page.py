"""Page of a landscape: a run beside its position on the energy curves, figures and numbers."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from forficula.analysis import measure
from forficula.analysis.simulated_snap import inner_hinge
from forficula.dynamics import Record
from forficula.show.landscape.landscape_table import landscape_table
from forficula.show.page.data.fold_view import fold_view
from forficula.show.page.data.landscape_curves import (
    Travel,
    curve_data,
    landscape_curves,
    posed_travel,
    run_travel,
)
from forficula.show.page.data.landscape_poses import poses_of, poses_travel, poses_view
from forficula.show.page.data.shape_mesh import shape_mesh
from forficula.show.page.data.shown_path import fold_of, shown_rows
from forficula.show.page.parts.design_rows import design_title
from forficula.show.page.parts.rich_html import printed_result
from forficula.show.page.parts.run_sentences import outcome_sentence
from forficula.show.page.playback import make_clip
from forficula.show.page.results_page import figure_sections, results_page
from forficula.show.page.run_page import playback_data
from forficula.statics import EnergyLandscape

_HEADINGS = {
    "tendon": "Energy of one tendon and its hinge",
    "wing": "Energy along the fold",
    "rests": "Equilibria",
    "levels": "Energy with some hinges folded",
    "states": "Stable states",
    "barriers": "Barriers between them",
    "courses": "Motion under the drives",
    "modes": "Modes of vibration",
}


def landscape_page(
    landscape: EnergyLandscape,
    folder: Path,
    texts: Mapping[str, str],
    record: Record | None = None,
    tendon: int | None = None,
) -> str:
    """Return a landscape as one page.

    Args:
        landscape: what is shown.
        folder: folder that contains its figures.
        texts: descriptions of the figures, by the stems of their files.
        record: a run of the same design, played back on the page; a run that diverged is only named.
        tendon: index of the tendon shown as an example; an inner one by default.
    """
    name, run = design_title(landscape.design), ""
    drawn = record if record is not None and record.diverged_at is None else None
    shown = inner_hinge(landscape, tendon)
    fold, poses = fold_of(landscape.structure), poses_of(landscape, shown)
    data: dict[str, Any] = {"kind": "curves", "whole": landscape.structure.appearance.whole}
    if drawn is not None:
        outcome = measure(drawn)
        clip = make_clip(drawn, outcome)
        run = f"Run of this design: {outcome_sentence(name, outcome)}"
        data = playback_data(clip) | {"curves": _curves(landscape, run_travel(drawn, clip.time), tendon)}
    paths = []
    if poses is not None:
        curves = {"curves": _curves(landscape, poses_travel(poses), tendon)}
        paths.append(poses_view(poses, beside_run=drawn is not None) | curves)
    if fold.path is not None:
        path, rows = fold.path, shown_rows(fold.path, shape_mesh(landscape.structure))
        travel = posed_travel(path.structure, path.angles[rows], path.positions[rows], path.stored[rows])
        paths.append(fold_view(path, beside_run=drawn is not None) | {"curves": _curves(landscape, travel, tendon)})
    if not paths and drawn is None:
        data |= {"curves": _curves(landscape, None, tendon)}
    return results_page(
        "landscape",
        name,
        printed_result(landscape_table(landscape, record, tendon)),
        figure_sections(folder, _HEADINGS, texts),
        run=run,
        data=data | {"paths": paths} if drawn is not None or paths or data.get("curves") else None,
        missing=fold.missing,
    )


def _curves(landscape: EnergyLandscape, travel: Travel | None, tendon: int | None) -> list[dict[str, Any]]:
    return [curve_data(curve) for curve in landscape_curves(landscape, travel, tendon)]
