"""Nets of bars built from designs agree with published closed forms of origami sheets."""

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

from forficula.pattern import (
    kresling_lengths,
    kresling_other_state,
    kresling_pattern,
    miura_pattern,
    waterbomb_base,
)
from forficula.statics.net import built_shape, find_stable_states, rigidity, rigidity_matrix, shape_at
from forficula.statics.net.net_of import bends, net_of, start_shape
from forficula.structure import structure_of
from tests.sheets import sheet_design, stage
from tests.statics.net.nets import mechanisms

FREE = {"support": [], "protocol.stages": [stage()]}


@pytest.mark.parametrize(("acute", "fold"), [(60, 30), (70, 90), (45, 60), (80, 150)])
def test_the_in_plane_poissons_ratio_of_a_miura_sheet_is_that_of_schenk_and_guest(agree, acute, fold):
    """Expansion along by that across, in the one way to fold: cos^2(theta) tan^2(gamma).

    It follows from S and L of the unit cell, theta being half the fold angle of the zigzag creases and gamma the acute
    angle (Schenk and Guest 2013, doi 10.1073/pnas.1217998110, equations 1 to 5; Wei, Guo, Dudte, Liang and Mahadevan
    2013, Phys. Rev. Lett. 110, 215501): Poisson's ratio is the negative of it, negative in every shape.
    """
    gamma, angle = np.deg2rad(acute), np.deg2rad(fold)
    built = structure_of(sheet_design(miura_pattern(4, 4, 0.03, 0.02, gamma, angle), FREE))
    net = net_of(built)
    assert rigidity(net, built_shape(net), bends(built)).degrees_of_freedom == 1
    way = mechanisms(net, bends(built))[0]

    def strain(one, other):
        apart = net.nodes[other] - net.nodes[one]
        return apart @ (way[other] - way[one]) / (apart @ apart)

    across, along = strain(0, 4), strain(0, 20)
    known = (np.cos(angle / 2) * np.tan(gamma)) ** 2
    what = f"strain along by strain across of a Miura sheet, {acute} deg, folded by {fold} deg"
    agree(what, along / across, known, by="Schenk and Guest 2013", rel=1e-9)


def uniform_fields(pattern):
    """Displacements by which a Miura sheet stretches and bends evenly, but for the same in every unit cell.

    A plate's field moves and turns each cell with its corner. In addition, all cells deform identically. All bars of
    one kind therefore change by the same length, and one cell represents an infinite sheet.

    Returns by curvatures (x, y, twist), strains (x, y, shear) and the twelve coordinates of a cell, (node, 3, 18).
    """
    corners = pattern.vertices_coords
    line, place = np.divmod(np.arange(49), 7)
    at = corners[14 * (line // 2) + 2 * (place // 2)] * (1, 1, 0)
    x, y, none = *at[:, :2].T, np.zeros(49)
    fields = []
    for across, along, twist in np.eye(3):
        turn = np.stack((-along * y - twist * x, across * x + twist * y, none), axis=1)
        rise = -(across * x**2 + along * y**2) / 2 - twist * x * y
        fields.append(np.cross(turn, corners - at) + rise[:, None] * (0, 0, 1))
    fields += [np.stack(item, axis=1) for item in ((x, none, none), (none, y, none), (y, x, none))]
    kinds = (2 * (line % 2) + place % 2)[:, None] == np.arange(4)
    opposite = kinds[:, None, :, None] * np.eye(3)[None, :, None, :]
    return np.concatenate((np.stack(fields, axis=-1), opposite.reshape(49, 3, 12)), axis=-1)


@pytest.mark.parametrize(("acute", "fold"), [(60, 30), (70, 90), (45, 60), (80, 150)])
def test_the_bending_poissons_ratio_of_a_miura_sheet_is_minus_the_in_plane_ratio(agree, acute, fold):
    """Poisson's ratio of bending is that of stretching with the other sign; with flat facets it does not bend.

    Wei, Guo, Dudte, Liang and Mahadevan 2013 (doi 10.1103/PhysRevLett.110.215501); the saddle of Schenk and Guest
    2013. Facets bend along a diagonal, and the sheet can fold, bend to one saddle and twist, and nothing else.
    """
    gamma, angle = np.deg2rad(acute), np.deg2rad(fold)
    pattern = miura_pattern(6, 6, 0.03, 0.02, gamma, angle)
    built = structure_of(sheet_design(pattern, FREE))
    net = net_of(built)
    fields = uniform_fields(pattern).reshape(-1, 18)
    sizes = np.linalg.norm(fields, axis=0)

    def ways(stiff):
        """Curvatures and strains of strain-free uniform fields without rigid shifts, (way, 6)."""
        _, values, axes = np.linalg.svd(rigidity_matrix(net, built_shape(net), stiff) @ (fields / sizes))
        _, remain, spanned = np.linalg.svd(axes[values < 1e-9 * values[0], :6] / sizes[:6], full_matrices=False)
        return spanned[remain > 1e-9 * remain[0]]

    ratio = (np.cos(angle / 2) * np.tan(gamma)) ** 2
    flat = ways(bends(built))
    assert len(flat) == 1
    stretch = flat[0] / flat[0, 3]
    agree("curvatures and strains of flat facets", stretch, [0, 0, 0, 1, ratio, 0], by="Wei et al. 2013", abs=1e-7)
    bent = ways(np.zeros_like(bends(built)))
    assert len(bent) == 3
    assert (
        np.linalg.matrix_rank(bent[:, :3] / np.abs(bent[:, :3]).max(), tol=1e-6) == 2
    )  # a saddle mode and a twist mode
    across, along = bent[:, :2].T / np.abs(bent[:, :2]).max()
    agree("curvature along, of bent facets", along, -ratio * across, by="Wei et al. 2013", abs=1e-7)


def test_a_waterbomb_base_has_two_states_at_the_minima_of_its_symmetric_energy(agree):
    """One stable state with the centre up and one with it down (Hanna, Lund, Lang, Magleby and Howell 2014).

    With rigid facets and equally folded diagonals, the angle of the diagonals determines that of the midlines, on
    either side of flat (doi 10.1088/0964-1726/23/9/094009). The minimum of the energy of eight linear springs is then
    computed along a line.
    """
    side, fold, stiffness = 0.1, np.deg2rad(60), 0.02
    pattern = waterbomb_base(side, fold, "up")
    values = {"facet.youngs_modulus": 2e10, "crease.stiffness": stiffness, "crease.rest_angle": "as built"}
    built = structure_of(sheet_design(pattern, FREE | values))
    net = net_of(built)
    start = start_shape(built, net)
    lengths = np.linalg.norm(pattern.vertices_coords[1:], axis=1)

    def angles(diagonal, apex):
        """Angles of the creases in the order of the surrounding vertices."""
        other = waterbomb_base(side, diagonal, apex)
        return shape_at(net, other.vertices_coords, start.angles).angles

    order = net.creases.points[:, 1]
    springs = stiffness * lengths[order - 1]

    def energy(diagonal):
        return springs @ (angles(diagonal, "down") - start.angles) ** 2 / 2

    least = minimize_scalar(energy, bounds=(0.02, 1.5), method="bounded", options={"xatol": 1e-9})
    assert 0.05 < least.x < 1.45
    down = shape_at(net, waterbomb_base(side, float(least.x), "down").vertices_coords, start.angles)
    result = find_stable_states(net, [start, down], tries=2)
    energies = sorted(state.energy for state in result.states)
    assert len(energies) >= 2
    by = "Hanna et al. 2014, eight linear springs"
    agree(
        "energy with the centre up, divided by that with the centre down",
        energies[0] / least.fun,
        0,
        by="as built",
        abs=1e-9,
    )
    agree("energy with the centre down", 1e3 * energies[1], 1e3 * least.fun, unit="mJ", by=by, rel=1e-3)


@pytest.mark.parametrize(("sides", "height", "twist"), [(6, 1.5, 30), (8, 2.0, 40), (5, 1.4, 25)])
def test_the_second_state_of_a_kresling_tower_is_that_of_the_closed_form(agree, holds, sides, height, twist):
    """Both twists add up to 180 deg - 360 deg / sides where the creases keep their lengths.

    Cai, Deng, Zhou, Feng and Tu 2015 (doi 10.1115/1.4030158); Yasuda, Tachi, Lee and Yang 2017
    (doi 10.1038/s41467-017-00670-w); the tower has bars in both polygons and no springs in its creases.
    """
    radius = 0.03
    pattern = kresling_pattern(sides, 1, radius, height * radius, np.deg2rad(twist))
    held = [{"of": f"vertex {vertex}"} for vertex in range(sides)]
    values = {"crease.stiffness": 0.0, "support": held, "protocol.stages": [stage()]}
    built = structure_of(sheet_design(pattern, values))
    net = net_of(built)
    other = kresling_other_state(sides, radius, height * radius, np.deg2rad(twist))
    agree(
        "twist of the second state",
        np.rad2deg(other.twist),
        180 - 360 / sides - twist,
        unit="deg",
        by="Cai et al. 2015",
        rel=1e-6,
    )
    placed = kresling_pattern(sides, 1, radius, other.height, other.twist)
    present = shape_at(net, placed.vertices_coords)
    result = find_stable_states(net, [built_shape(net), present], tries=4)
    rests = sorted((state.shape.positions[sides:, 2].mean(), state.energy) for state in result.states)
    found_heights = [100 * rest[0] for rest in (rests[0], rests[-1])]
    known = [100 * other.height, 100 * height * radius]
    agree(
        f"heights of a Kresling tower of {sides} sides", found_heights, known, unit="cm", by="Cai et al. 2015", rel=1e-6
    )
    scale = net.springs.stiffness.max() * radius**2
    holds(
        "energy divided by bars' stiffness and radius²",
        max(rests[0][1], rests[-1][1]) / scale,
        below=1e-12,
        by="no stress",
    )
    lengths = kresling_lengths(sides, radius, other.height, other.twist)
    built_lengths = kresling_lengths(sides, radius, height * radius, np.deg2rad(twist))
    ours, theirs = 100 * lengths.mountain, 100 * built_lengths.mountain
    agree("mountain creases in the second state", ours, theirs, unit="cm", by="as built", rel=1e-6)
