"""Places on the veins, in the flat wing or anywhere in space: ends of the tendons, rows of the membrane's mesh."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from forficula.design.fan import FanDesign

Points = NDArray[np.float64]


def tendon_ends(hub: Points, ring: Points, tip: Points, design: FanDesign) -> tuple[Points, Points]:
    """Place the two ends of the veins' tendons on the axes of their bars.

    Args:
        hub: hub ends of the veins, in the units of `design`, (..., vein, axis).
        ring: their ring vertices, alike.
        tip: their tips, alike.
        design: where tendons are attached.

    Returns:
        The ends on the proximal and on the distal bars, shaped alike; nan for a vein without a tendon.
    """
    proximal, distal = (
        np.array([[math.nan if each is None else getattr(each, f"{end}_attachment")] for each in design.tendons])
        for end in ("proximal", "distal")
    )
    before = ring + (hub - ring) * proximal / design.pattern.proximal_length
    beyond = ring + (tip - ring) * distal / design.pattern.distal_length
    return before, beyond


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
