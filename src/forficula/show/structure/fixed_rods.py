"""What a structure is held by, as rods: drawn only, for it has no shape of its own."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from forficula.arrays import Array
from forficula.structure import GROUND, Structure, built_frames, built_points

_SAME = 1e-6  # of the length of the whole: places no further apart are one
_STUB = 0.04  # of that: a rod of a single place


def fixed_rods(structure: Structure) -> Array:
    """Lay rods through the places at which a structure hangs on the ground, and around plates that cannot move.

    Places are joined in the order of their bodies, as veins stand around a hub; a single one has a stub across.

    Returns:
        Ends, m, (rod, end, axis). None where nothing hangs on a joint and no plate is fixed, as of a sheet between
        nodes.
    """
    origins, _ = built_frames(structure)
    hinged = {hinge.body for hinge in structure.hinges if hinge.flaps is None}
    grounded = [number for number, body in enumerate(structure.bodies) if body.parent == GROUND and not body.slides]
    points = built_points(structure)
    rods = [
        (points[one], points[other])
        for plate in structure.plates
        if plate.body in grounded and plate.body not in hinged
        for one, other in pairwise([*plate.points, plate.points[0]])
    ]
    pivots: list[Array] = []
    for number in grounded:
        place = origins[number]
        if number in hinged and all(np.linalg.norm(place - other) > _SAME * structure.span for other in pivots):
            pivots.append(place)
    if len(pivots) == 1:
        aside = np.array([0.0, 0.5 * _STUB * structure.span, 0.0])
        pivots = [pivots[0] - aside, pivots[0] + aside]
    return np.array([*rods, *pairwise(pivots)]).reshape(-1, 2, 3)
