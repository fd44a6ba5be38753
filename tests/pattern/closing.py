"""Closure conditions of any vertex as a slow but simple reference for the closed forms."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import ArrayLike

from forficula.errors import InputError

_REACHABLE = 1e-12  # rounding allowed in the squared sine or cosine of half a fold angle


def closure_residual(sector_angles: ArrayLike, fold_angles: ArrayLike) -> float:
    """Compute the closure error of the panels around a vertex.

    Walking once around a vertex, turning by every fold angle about its crease and by every sector in its panel, must
    lead back to the start (Kawasaki 1989; Belcastro and Hull 2002). This holds for any vertex, one with an angle
    deficit too.

    Args:
        sector_angles: rad, shape (degree,); number i lies between creases i and i + 1.
        fold_angles: rad, shape (degree,).

    Returns:
        Frobenius norm of the product of all Rx(fold angle) Rz(sector) minus the identity, 0 to sqrt(8).

    Raises:
        InputError: the two arrays differ in length or are no rows of finite numbers.
    """
    sectors = np.asarray(sector_angles, dtype=np.float64)
    folds = np.asarray(fold_angles, dtype=np.float64)
    if sectors.ndim != 1 or sectors.shape != folds.shape:
        raise InputError(f"fold_angles: need one for each sector angle, got shapes {folds.shape} and {sectors.shape}")
    if not (np.isfinite(sectors).all() and np.isfinite(folds).all()):
        raise InputError("fold_angles: need finite angles, got nan or inf")
    product = np.eye(3)
    for sector, fold in zip(sectors.tolist(), folds.tolist(), strict=True):
        about_crease = np.array([[1, 0, 0], [0, math.cos(fold), -math.sin(fold)], [0, math.sin(fold), math.cos(fold)]])
        in_panel = np.array(
            [[math.cos(sector), -math.sin(sector), 0], [math.sin(sector), math.cos(sector), 0], [0, 0, 1]]
        )
        product = product @ about_crease @ in_panel
    return float(np.linalg.norm(product - np.eye(3)))


def opposite_fold_angle(sector_angles: ArrayLike, fold_angle: float) -> float:
    """Compute the size of the fold angle of the opposite crease at any vertex of four creases, flat or not.

    Both pairs of panels span the same angle between the two creases in the middle (spherical law of cosines):
    cos a1 cos a4 - sin a1 sin a4 cos rho1 = cos a2 cos a3 - sin a2 sin a3 cos rho3, here written with half angles,
    which keeps all digits at 0 and at 180 deg. A cyclic shift of the sectors relates creases 2 and 4.

    Args:
        sector_angles: a1, a2, a3, a4, rad, shape (4,); a1 between creases 1 and 2, a4 between creases 4 and 1.
        fold_angle: of crease 1, rad.

    Returns:
        Size of the fold angle of crease 3, 0 to pi, rad; the relation leaves its sign open.

    Raises:
        InputError: sectors outside 0 to 180 deg or not four, or a fold angle that the vertex cannot reach.
    """
    sectors = np.asarray(sector_angles, dtype=np.float64)
    if sectors.shape != (4,):
        raise InputError(f"sector_angles: need four, got shape {sectors.shape}")
    if not ((sectors > 0) & (sectors < math.pi)).all():
        raise InputError(f"sector_angles: need > 0 deg and < 180 deg, got {np.degrees(sectors).tolist()} deg")
    first, second, third, fourth = sectors.tolist()
    near, far = math.sin(first) * math.sin(fourth), math.sin(second) * math.sin(third)
    excess = math.sin((sectors.sum()) / 2) * math.sin((second + third - first - fourth) / 2)
    sine_squared = (near * math.sin(fold_angle / 2) ** 2 + excess) / far
    skew = math.sin((second - third + first - fourth) / 2) * math.sin((first - fourth - second + third) / 2)
    cosine_squared = (near * math.cos(fold_angle / 2) ** 2 + skew) / far
    if not (sine_squared >= -_REACHABLE and cosine_squared >= -_REACHABLE):
        listed = ", ".join(f"{angle:.6g}" for angle in np.degrees(sectors).tolist())
        raise InputError(
            f"fold_angle: need an angle that sectors of {listed} deg allow, got {math.degrees(fold_angle):.6g} deg"
        )
    return 2 * math.atan2(math.sqrt(max(sine_squared, 0.0)), math.sqrt(max(cosine_squared, 0.0)))
