"""The energy of membrane and guards in any pose of the wing, with its slopes and curvatures by the joint angles."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from forficula.statics.wing import Pose, Wing, cross, pose

Array = NDArray[np.float64]
# energy, slope and curvature
Expansion = tuple[Array, Array, Array]

# A guard is a limit and no spring; it is as many times stiffer than the membrane, E t, as keeps its own stretch small.
_GUARD_STIFFNESS = 100.0


@dataclass(frozen=True, kw_only=True)
class Sheet:
    """What joins the veins of a wing: in every panel triangles of membrane, and a guard from tip to tip.

    Attributes:
        wing: the wing.
        sides: by which the points add up to the sides of what is stretched, (side, point): for each triangle, panel by
            panel, the two columns of its deformation gradient, 1/m, then for each guard the way between its tips.
        of_panel: the same, split in what moves with the panel's first vein and with its second one, (2, side, point).
        of_vein: 1 where a vein carries a point, else 0, (vein, point).
        volumes: of the triangles, m^3, (triangle,).
        guard_lengths: largest distances of neighbouring tips, m, (panel,).
    """

    wing: Wing
    sides: Array
    of_panel: Array
    of_vein: Array
    volumes: Array
    guard_lengths: Array

    @property
    def panels(self) -> int:
        """How many panels."""
        return len(self.guard_lengths)


def wing_sheet(wing: Wing) -> Sheet:
    """Lay the membrane and the guards over a flat wing."""
    design, triangles, tips = wing.design, wing.triangles, wing.tips
    panels, count = len(tips) - 1, len(triangles)
    corners = wing.flat[triangles, :2]
    edges = np.stack([corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]], axis=2)
    of_corners = np.array([[-1.0, -1.0], [1.0, 0.0], [0.0, 1.0]]) @ np.linalg.inv(edges)
    sides = np.zeros((2 * count + panels, len(wing.points)))
    sides[np.arange(2 * count).reshape(-1, 1, 2), triangles[:, :, None]] = of_corners
    guards = np.arange(2 * count, len(sides))
    sides[guards, tips[1:]], sides[guards, tips[:-1]] = 1.0, -1.0
    panel = np.concatenate([np.repeat(np.arange(panels), 2 * count // panels), np.arange(panels)])
    first = wing.carriers == panel[:, None]
    return Sheet(
        wing=wing,
        sides=sides,
        of_panel=np.stack([sides * first, sides * ~first]),
        of_vein=np.asarray(wing.carriers == np.arange(panels + 1)[:, None], dtype=np.float64),
        volumes=design.membrane.thickness * np.abs(np.linalg.det(edges)) / 2,
        guard_lengths=design.guard.stretch * np.linalg.norm(np.diff(wing.flat[tips], axis=0), axis=1),
    )


def sheet_energy(sheet: Sheet, angles: Array) -> Expansion:
    """Energy of membrane and guards.

    Args:
        sheet: what joins the veins.
        angles: sweep, lift, turn and fold of each vein, the last two in its own sense, rad, (case, vein, 4).

    Returns:
        J, (case,); by the angles, vein by vein, N m, (case, angle), and N m/rad, (case, angle, angle).
    """
    at = pose(sheet.wing, angles)
    sides, moves = sheet.sides @ at.points, _side_moves(sheet, at)
    membrane = slice(2 * len(sheet.volumes))
    guards = slice(membrane.stop, None)
    energy, pull, stiffness = membrane_energy(sheet, sides[:, membrane])
    of_panels = _by_joints(moves[:, membrane], stiffness, sheet.panels)
    guard_energy, guard_pull, stiffness = _guard_energy(sheet, sides[:, guards])
    of_panels += _by_joints(moves[:, guards], stiffness, sheet.panels)
    force = sheet.sides.T @ np.concatenate([pull, guard_pull], axis=1)
    slope = (sheet.of_vein @ np.sum(at.moves * force[:, :, None], axis=3)).reshape(len(angles), -1)
    curvature = np.zeros((*slope.shape, sheet.wing.size))
    for panel in range(sheet.panels):
        both = slice(4 * panel, 4 * panel + 8)
        curvature[:, both, both] += of_panels[:, panel]
    _add_turning(sheet, at, force, curvature)
    return energy + guard_energy, slope, curvature


def _side_moves(sheet: Sheet, at: Pose) -> Array:
    """How the sides move with the joints of the two veins of their panel, (case, side, 3, joint)."""
    cases, points, joints, _ = at.moves.shape
    of_sides = sheet.of_panel.reshape(-1, points) @ at.moves.reshape(cases, points, -1)
    by_vein = of_sides.reshape(cases, 2, len(sheet.sides), joints, 3)
    return np.transpose(by_vein, (0, 2, 4, 1, 3)).reshape(cases, len(sheet.sides), 3, 2 * joints)


def _by_joints(moves: Array, stiffness: Array, panels: int) -> Array:
    """Stiffness of what sides stretch, (case, element, coordinate, coordinate), by joints: (case, panel, 8, 8)."""
    cases, joints = len(moves), moves.shape[3]
    by_element = moves.reshape(*stiffness.shape[:3], joints)
    by_panel = (cases, panels, -1, joints)
    pulled = (stiffness @ by_element).reshape(by_panel)
    return np.asarray(np.swapaxes(by_element.reshape(by_panel), 2, 3) @ pulled)


def _add_turning(sheet: Sheet, at: Pose, force: Array, curvature: Array) -> None:
    """Add what comes of the points' ways being curved: a joint turns the axes of those after it in its vein."""
    cases = len(force)
    # d2x = outer x (inner x arm), and force . (outer x move) = outer . (move x force)
    moments = (sheet.of_vein @ cross(at.moves, force[:, :, None]).reshape(cases, -1, 12)).reshape(cases, -1, 4, 3)
    turned = at.axes @ np.swapaxes(moments, 2, 3)
    turned = np.triu(turned) + np.swapaxes(np.triu(turned, 1), 2, 3)
    for vein in range(sheet.panels + 1):
        own = slice(4 * vein, 4 * vein + 4)
        curvature[:, own, own] += turned[:, vein]


def membrane_energy(sheet: Sheet, gradient: Array) -> Expansion:
    """Stretch energy of the membrane by the deformation gradients of its triangles.

    Saint Venant-Kirchhoff in plane stress, triangles of constant strain: with the Green strain e, per volume
    mu tr(e^2) + lambda / 2 tr(e)^2, mu = E / (2 (1 + nu)), lambda = E nu / (1 - nu^2) (Timoshenko and
    Woinowsky-Krieger, Theory of Plates and Shells, for plane stress).

    Args:
        sheet: the membrane.
        gradient: the columns, two of each triangle, (case, column, 3).

    Returns:
        J, (case,); its slope, J, (case, column, 3); its curvature, J, (case, triangle, 6, 6).
    """
    law = sheet.wing.design.membrane
    shear = law.youngs_modulus / (2 * (1 + law.poisson_ratio))
    lame = law.youngs_modulus * law.poisson_ratio / (1 - law.poisson_ratio**2)
    cases, volumes = len(gradient), sheet.volumes[:, None]
    columns = gradient.reshape(cases, -1, 2, 3)
    # strains along, across, and twice the mixed one, and their slopes
    squares = columns @ np.swapaxes(columns, 2, 3)
    strain = np.stack([squares[..., 0, 0] - 1, squares[..., 1, 1] - 1, 2 * squares[..., 0, 1]], axis=-1) / 2
    by_column = np.zeros((cases, len(volumes), 3, 6))
    by_column[:, :, 0, :3], by_column[:, :, 1, 3:] = columns[:, :, 0], columns[:, :, 1]
    by_column[:, :, 2, :3], by_column[:, :, 2, 3:] = columns[:, :, 1], columns[:, :, 0]
    law_matrix = np.array([[2 * shear + lame, lame, 0.0], [lame, 2 * shear + lame, 0.0], [0.0, 0.0, shear]])
    stress = volumes * (strain @ law_matrix)
    pull = stress[:, :, None] @ by_column
    curvature = np.swapaxes(by_column, 2, 3) @ (volumes[:, :, None] * (law_matrix @ by_column))
    for coordinate in range(3):
        one, other = coordinate, coordinate + 3
        curvature[:, :, one, one] += stress[:, :, 0]
        curvature[:, :, other, other] += stress[:, :, 1]
        curvature[:, :, one, other] += stress[:, :, 2]
        curvature[:, :, other, one] += stress[:, :, 2]
    return np.sum(stress * strain, axis=(1, 2)) / 2, pull.reshape(cases, -1, 3), curvature


def _guard_energy(sheet: Sheet, apart: Array) -> Expansion:
    """Energy of the guards, which pull beyond their lengths only, by the ways between their tips (case, guard, 3)."""
    law = sheet.wing.design.membrane
    spring = _GUARD_STIFFNESS * law.youngs_modulus * law.thickness
    distance = np.linalg.norm(apart, axis=2)
    beyond = np.maximum(distance - sheet.guard_lengths, 0.0)
    along = apart / distance[..., None]
    ratio = (beyond / distance)[..., None, None]
    outer = along[..., :, None] * along[..., None, :]
    curvature = spring * ((beyond > 0)[..., None, None] * outer + ratio * (np.eye(3) - outer))
    return spring / 2 * np.sum(beyond**2, axis=1), spring * beyond[..., None] * along, curvature
