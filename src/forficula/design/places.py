"""Positions of the rows of the membrane's mesh on the veins, in the flat wing or in space."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from forficula.design.fans.fan import FanDesign

Points = NDArray[np.float64]


def mesh_rows(places: Sequence[Points], design: FanDesign) -> Points:
    """Compute the positions of the rows of the membrane's mesh on a vein.

    Args:
        places: hub end of the vein, ring vertices and tip, from the hub outwards, in any unit of length, each (axis,).
        design: design with the rows as shares of the two lengths.

    Returns:
        Positions from hub to tip, (row, axis): proximal rows, ring folds, distal rows, tip.
    """
    first, last = design.membrane.proximal_rows, design.membrane.distal_rows
    shares = [first, *[()] * (len(places) - 3), last]
    return np.concatenate(
        [
            near + np.array([*share, 1.0])[:, np.newaxis] * (far - near)
            for share, (near, far) in zip(shares, pairwise(places), strict=True)
        ]
    )


def row_bars(folds: int, design: FanDesign) -> list[int]:
    """Return, for each interval between two rows of the mesh, the number of the bar on which it lies, (row - 1,).

    Args:
        folds: number of ring folds.
        design: design with the rows.
    """
    counts = [len(design.membrane.proximal_rows), *[1] * (folds - 1), len(design.membrane.distal_rows) + 1]
    return [bar for bar, count in enumerate(counts) for _ in range(count)]


def margin_edge(start: Points, end: Points, design: FanDesign, along: Points | None = None) -> Points:
    """Compute the position at which a row of a panel leaves the margin on its vein, (axis,).

    Args:
        start: point of the row on the axis of the vein, (axis,).
        end: point of the row on the axis of the next vein, (axis,).
        design: design with the width of the margins.
        along: unit vector to the edge, (axis,); if not given, towards `end`.
    """
    width = float(np.linalg.norm(end - start))
    margin = min(design.membrane.margin, design.membrane.margin_limit * width)
    return np.asarray(start + (margin / width * (end - start) if along is None else margin * along))
