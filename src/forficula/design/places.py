"""Places on the veins, in the flat wing or anywhere in space: rows of the membrane's mesh."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from forficula.design.fans.fan import FanDesign

Points = NDArray[np.float64]


def mesh_rows(places: Sequence[Points], design: FanDesign) -> Points:
    """Place the rows of the membrane's mesh on a vein.

    Args:
        places: hub end of the vein, its ring vertices and its tip, from the hub outwards, in any unit of length,
            (axis,) each.
        design: the rows, in shares of the two lengths.

    Returns:
        Hub to tip, (row, axis); those of the ring folds follow the proximal ones, that of the tip comes last.
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
    """The bar of a vein across so many ring folds that lies between a row of the mesh and the next, (row - 1,)."""
    counts = [len(design.membrane.proximal_rows), *[1] * (folds - 1), len(design.membrane.distal_rows) + 1]
    return [bar for bar, count in enumerate(counts) for _ in range(count)]


def margin_edge(here: Points, there: Points, design: FanDesign, along: Points | None = None) -> Points:
    """Where a row of a panel leaves the margin on its vein, (axis,).

    Args:
        here: on the axis of the vein, (axis,).
        there: on that of the next one, (axis,).
        design: how wide margins are.
        along: unit vector to the edge, (axis,); without it, towards `there`.
    """
    width = float(np.linalg.norm(there - here))
    margin = min(design.membrane.margin, design.membrane.margin_limit * width)
    return np.asarray(here + (margin / width * (there - here) if along is None else margin * along))
