"""The energy of membrane and guards in any pose of the wing, with its slopes and curvatures by the joint angles."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from forficula.statics.wing import Wing, pose

Array = NDArray[np.float64]
# energy, slope and curvature
Expansion = tuple[Array, Array, Array]

# A guard is a limit and no spring; it is as many times stiffer than the membrane, E t, as keeps its own stretch small.
_GUARD_STIFFNESS = 100.0


@dataclass(frozen=True, kw_only=True)
class Sheet:
    """What joins the veins of a wing.

    Attributes:
        wing: the wing.
        weights: by which the points add up to the deformation gradient of each triangle, 1/m, (triangle, point, 2).
        volumes: of the triangles, m^3, (triangle,).
        guard_lengths: largest distances of neighbouring tips, m, (vein - 1,).
    """

    wing: Wing
    weights: Array
    volumes: Array
    guard_lengths: Array


def wing_sheet(wing: Wing) -> Sheet:
    """Lay the membrane and the guards over a flat wing."""
    design = wing.design
    corners = wing.flat[wing.triangles, :2]
    sides = np.stack([corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]], axis=2)
    of_corners = np.array([[-1.0, -1.0], [1.0, 0.0], [0.0, 1.0]]) @ np.linalg.inv(sides)
    weights = np.zeros((len(wing.triangles), len(wing.points), 2))
    weights[np.arange(len(wing.triangles))[:, None], wing.triangles] = of_corners
    return Sheet(
        wing=wing,
        weights=weights,
        volumes=design.membrane.thickness * np.abs(np.linalg.det(sides)) / 2,
        guard_lengths=design.guard.stretch * np.linalg.norm(np.diff(wing.flat[wing.tips], axis=0), axis=1),
    )


def sheet_energy(sheet: Sheet, angles: Array) -> Expansion:
    """Energy of membrane and guards.

    Args:
        sheet: what joins the veins.
        angles: sweep, lift, turn and fold of each vein, the last two in its own sense, rad, (case, vein, 4).

    Returns:
        J, (case,); by the angles, vein by vein, N m, (case, angle), and N m/rad, (case, angle, angle).
    """
    wing, at = sheet.wing, pose(sheet.wing, angles)
    energy, force, stiffness = membrane_energy(sheet, at.points)
    _add_guards(sheet, at.points, energy, force, stiffness)
    cases, points, size = len(angles), len(wing.points), wing.size
    # every point moves with the joints of its own vein
    moves = np.zeros((cases, points, 3, size // 4, 4))
    moves[:, np.arange(points), :, wing.carriers] = np.swapaxes(np.moveaxis(at.moves, 1, 0), 2, 3)
    flat_moves = moves.reshape(cases, 3 * points, size)
    slope = (force.reshape(cases, 1, -1) @ flat_moves)[:, 0]
    curvature = np.swapaxes(flat_moves, 1, 2) @ stiffness.reshape(cases, 3 * points, -1) @ flat_moves
    # a joint turns the axes of those after it: d2x = outer x (inner x r)
    turned = np.cross(force[:, :, None], at.axes[:, wing.carriers]) @ np.swapaxes(at.moves, 2, 3)
    turned = np.triu(turned) + np.swapaxes(np.triu(turned, 1), 2, 3)
    for vein in range(size // 4):
        own = slice(4 * vein, 4 * vein + 4)
        curvature[:, own, own] += turned[:, wing.carriers == vein].sum(axis=1)
    return energy, slope, curvature


def membrane_energy(sheet: Sheet, points: Array) -> Expansion:
    """Stretch energy of the membrane by the positions of its points.

    Saint Venant-Kirchhoff in plane stress, triangles of constant strain: with the Green strain e, per volume
    mu tr(e^2) + lambda / 2 tr(e)^2, mu = E / (2 (1 + nu)), lambda = E nu / (1 - nu^2) (Timoshenko and
    Woinowsky-Krieger, Theory of Plates and Shells, for plane stress).

    Args:
        sheet: the membrane.
        points: m, (case, point, 3).

    Returns:
        J, (case,); N, (case, point, 3); N/m, (case, point, 3, point, 3).
    """
    law = sheet.wing.design.membrane
    shear = law.youngs_modulus / (2 * (1 + law.poisson_ratio))
    lame = law.youngs_modulus * law.poisson_ratio / (1 - law.poisson_ratio**2)
    weights, volumes = sheet.weights, sheet.volumes
    gradient = np.einsum("cpi,tpa->ctia", points, weights, optimize=True)
    strain = (np.swapaxes(gradient, 2, 3) @ gradient - np.eye(2)) / 2
    trace = np.trace(strain, axis1=2, axis2=3)
    energy = (shear * np.sum(strain**2, axis=(2, 3)) + lame / 2 * trace**2) @ volumes
    stress = 2 * shear * strain + lame * trace[..., None, None] * np.eye(2)
    force = np.einsum("t,ctia,tpa->cpi", volumes, gradient @ stress, weights, optimize=True)
    # d2 = weights stress weights + (lambda pulled pulled + mu (pulled pulled)^T + mu pairs squares), by triangle
    count = len(sheet.wing.points)
    pulled = np.einsum("ctia,tpa->ctpi", gradient, weights, optimize=True).reshape(len(points), len(volumes), -1)
    products = (np.swapaxes(pulled * volumes[:, None], 1, 2) @ pulled).reshape(-1, count, 3, count, 3)
    pairs = (volumes[:, None, None] * (weights @ np.swapaxes(weights, 1, 2))).reshape(len(volumes), -1)
    squares = (gradient @ np.swapaxes(gradient, 2, 3)).reshape(len(points), -1, 9)
    mixed = (np.swapaxes(squares, 1, 2) @ pairs).reshape(-1, 3, 3, count, count)
    pressed = np.einsum("t,tpa,ctab,tqb->cpq", volumes, weights, stress, weights, optimize=True)
    stiffness = lame * products + shear * np.swapaxes(products, 2, 4) + shear * np.transpose(mixed, (0, 3, 1, 4, 2))
    stiffness += pressed[:, :, None, :, None] * np.eye(3)[:, None, :]
    return energy, force, stiffness


def _add_guards(sheet: Sheet, points: Array, energy: Array, force: Array, stiffness: Array) -> None:
    """Add the guards between neighbouring tips, which pull beyond their lengths only."""
    law, tips = sheet.wing.design.membrane, sheet.wing.tips
    spring = _GUARD_STIFFNESS * law.youngs_modulus * law.thickness
    apart = np.diff(points[:, tips], axis=1)
    distance = np.linalg.norm(apart, axis=2)
    beyond = np.maximum(distance - sheet.guard_lengths, 0.0)
    energy += spring / 2 * np.sum(beyond**2, axis=1)
    along = apart / distance[..., None]
    ratio = (beyond / distance)[..., None, None]
    outer = along[..., :, None] * along[..., None, :]
    block = spring * ((beyond > 0)[..., None, None] * outer + ratio * (np.eye(3) - outer))
    for guard, (one, other) in enumerate(pairwise(tips.tolist())):
        pull = spring * beyond[:, guard, None] * along[:, guard]
        force[:, other] += pull
        force[:, one] -= pull
        for here, there, sign in ((one, one, 1), (other, other, 1), (one, other, -1), (other, one, -1)):
            stiffness[:, here, :, there] += sign * block[:, guard]
