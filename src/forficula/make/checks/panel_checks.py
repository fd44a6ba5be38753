"""Check of thick panels: whether their solids overlap along the fold path."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import combinations

import numpy as np
from manifold3d import Manifold

from forficula.make.checks.check import Check
from forficula.make.part import PartSet
from forficula.make.solid.mesh import MILLIMETRES, placed
from forficula.make.solid.panels import closing_fold
from forficula.make.solid.poses import tree_poses

# [chosen] poses of the fold path; poses for each crease where creases close one after another
_POSES, _POSES_OF_CREASE = 9, 6
_ROUNDING = 1e-6  # overlap that counts as rounding, as a share of the smallest panel


def panel_checks(parts: PartSet) -> Iterator[Check]:
    """Check that thick panels do not overlap along their fold path, by boolean operations on their meshes.

    This check shares neither the kinematics nor the geometry with the construction of the panels (`thick_sheet`).
    """
    panels = [part for part in parts.parts if part.kind == "panel"]
    if not panels:
        return
    name, limit = "overlap of panels along the fold path", _ROUNDING * min(panel.volume for panel in panels)
    fold = parts.fold
    if fold is None:
        fold = closing_fold(parts.design, parts.structure, _POSES_OF_CREASE)
    if fold is None:
        text = (
            "not checked, because the fold path of a sheet with such vertices or holes has no closed form; a run"
            " reports panels that pass through each other"
        )
        yield Check(name=name, part=parts.design.name, ok=None, value=math.nan, limit=limit, unit="m^3", text=text)
        return
    rows = np.linspace(0, len(fold) - 1, _POSES if parts.fold is not None else len(fold)).astype(np.int64)
    poses = tree_poses(parts.structure, fold[rows], rows)
    worst, pair, at = 0.0, "", 0
    for row, (frames, origins) in enumerate(zip(poses.frames, poses.origins, strict=True)):
        bodies = [panel.body or 0 for panel in panels]
        moved = [placed(panel.shape, frames[body], origins[body]) for panel, body in zip(panels, bodies, strict=True)]
        for one, other in combinations(range(len(moved)), 2):
            volume = _overlap(moved[one], moved[other])
            if volume > worst:
                worst, pair, at = volume, f"{panels[one].name} and {panels[other].name}", row
    ok = worst <= limit
    order = "" if parts.fold is not None else ", in which creases close one after another"
    text = f"no two panels overlap in {len(rows)} poses from flat to folded{order}"
    if not ok:
        angle = math.degrees(float(np.abs(fold[rows[at]]).max()))
        text = f"{pair} overlap by {worst * 1e9:.3g} mm^3 where the largest fold angle is {angle:.4g} deg"
    yield Check(name=name, part=parts.design.name, ok=ok, value=worst, limit=limit, unit="m^3", text=text)


def _overlap(one: Manifold, other: Manifold) -> float:
    """Return the volume of the intersection of two solids, m^3."""
    return float((one ^ other).volume()) / MILLIMETRES**3
