"""Places on the veins, in the flat wing or anywhere in space: rows of the membrane's mesh."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from forficula.design.fan import FanDesign

Points = NDArray[np.float64]


def mesh_rows(hub: Points, ring: Points, tip: Points, design: FanDesign) -> Points:
    """Place the rows of the membrane's mesh on a vein.

    Args:
        hub: hub end of the vein, in any unit of length, (axis,).
        ring: its ring vertex, alike.
        tip: its tip, alike.
        design: the rows, in shares of the two lengths.

    Returns:
        Hub to tip, (row, axis); the row of the ring fold follows the proximal ones, that of the tip comes last.
    """
    proximal = np.array([*design.membrane.proximal_rows, 1.0])[:, np.newaxis]
    distal = np.array([*design.membrane.distal_rows, 1.0])[:, np.newaxis]
    return np.concatenate([hub + proximal * (ring - hub), ring + distal * (tip - ring)])


def margin_edge(here: Points, there: Points, design: FanDesign) -> Points:
    """Where a row of a panel leaves the margin on its vein, from that vein to the next, (axis,)."""
    width = float(np.linalg.norm(there - here))
    margin = min(design.membrane.margin, design.membrane.margin_limit * width)
    return np.asarray(here + margin / width * (there - here))
