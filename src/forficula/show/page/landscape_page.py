"""Page of a landscape: a run beside its position on the energy curves, figures and numbers."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from forficula.analysis import measure
from forficula.analysis.simulated_snap import inner_hinge
from forficula.dynamics import Record
from forficula.show.landscape.landscape_table import landscape_table
from forficula.show.page.data.landscape_curves import EnergyPlot, curve_data, landscape_curves
from forficula.show.page.data.landscape_poses import NO_POSE, LandscapePoses, pose_clip, poses_of
from forficula.show.page.data.packing import packed
from forficula.show.page.parts.design_rows import design_title
from forficula.show.page.parts.rich_html import printed_result
from forficula.show.page.parts.run_sentences import outcome_sentence, structure_text
from forficula.show.page.playback import clip_data, energy_scale, legend_data, make_clip, structure_noun
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
    curves = landscape_curves(landscape, drawn, tendon)
    data: dict[str, Any] | None = None
    drawn_curves: list[dict[str, Any]] = []
    if curves and drawn is None:
        poses = poses_of(landscape, inner_hinge(landscape, tendon))
        data = {"kind": "curves", **({} if poses is None else _still_data(poses))}
        drawn_curves = [curve_data(curve) | _pose_data(curve, landscape, poses) for curve in curves]
    if drawn is not None:
        outcome = measure(drawn)
        clip = make_clip(drawn, outcome)
        run = f"Run of this design: {outcome_sentence(name, outcome)}"
        data = playback_data(clip)
        drawn_curves = [curve_data(curve) for curve in landscape_curves(landscape, drawn, tendon, clip.time)]
    return results_page(
        "landscape",
        name,
        printed_result(landscape_table(landscape, record, tendon)),
        figure_sections(folder, _HEADINGS, texts),
        run=run,
        data=None if data is None else data | {"curves": drawn_curves},
    )


def _still_data(poses: LandscapePoses) -> dict[str, Any]:
    """Return the data of a structure that a slider moves, for the page's script."""
    clip = pose_clip(poses, poses.structure.name)
    return {
        "whole": structure_noun([clip]),
        "clips": [clip_data(clip)],
        "energy": energy_scale([clip]),
        "legend": legend_data([clip]),
        "text": structure_text(poses.structure),
    }


def _pose_data(curve: EnergyPlot, landscape: EnergyLandscape, poses: LandscapePoses | None) -> dict[str, Any]:
    """Return the angles of the poses on a curve, rising, deg, and a text on how they were computed or why not."""
    if poses is None:
        return {"poses": None, "drawn": NO_POSE}
    if curve.hinge is not None:
        angle = poses.angles[:, curve.hinge]
        if np.ptp(angle) == 0:  # it does not fold with the others
            return {"poses": None, "drawn": NO_POSE}
    else:
        path = landscape.fold_path
        assert path is not None  # the curve is computed from the path
        angle = -path.ring_angle if np.any(path.ring_angle) else path.pleat_angle
    return {"poses": packed(np.degrees(angle), "f4"), "drawn": poses.why}
