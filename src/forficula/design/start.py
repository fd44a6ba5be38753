"""Where a wing starts, and whether its guard tendons let it."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
import scipy

from forficula.pattern import EarwigFan, ring_directions, ring_vertices, tips


@lru_cache(maxsize=64)  # asked of every design that is made of one, most of which start alike
def start_stretch(fan: EarwigFan, overbend: float) -> float:
    """How far apart neighbouring tips are where every distal hinge is bent past straight, by their flat distance.

    Neighbouring veins bend to opposite sides of the sheet, evenly at their ring folds.

    Args:
        fan: the crease pattern.
        overbend: of every distal hinge, rad.

    Returns:
        The largest share of all pairs.
    """
    flat = bent = tips(fan)
    # odd veins are valleys, as `earwig_pattern` has them
    senses = (-1.0) ** (np.arange(len(flat)) + 1)
    for fold in reversed(range(fan.ring_folds)):
        turned = scipy.spatial.transform.Rotation.from_rotvec(
            overbend / fan.ring_folds * senses[:, None] * ring_directions(fan)
        )
        ring = ring_vertices(fan, fold=fold)
        bent = ring + turned.apply(bent - ring)
    distances = (np.linalg.norm(np.diff(points, axis=0), axis=1) for points in (bent, flat))
    return float(np.max(next(distances) / next(distances)))


def largest_start(fan: EarwigFan, stretch: float, bend: float) -> float:
    """How far one may bend towards a bend, rad, at which tips are further apart than so many times as when flat."""
    share = scipy.optimize.brentq(lambda share: start_stretch(fan, share * bend) - stretch, 0.0, 1.0, xtol=1e-6)
    return float(share * bend)
