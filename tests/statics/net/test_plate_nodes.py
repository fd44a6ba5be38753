"""Rigid plates as four nodes each: their masses, their connections, and the signs of their fold angles."""

import numpy as np
import pytest

from forficula.design import load_design, with_values
from forficula.statics.net.energy import shape_at
from forficula.statics.net.minimum import minimum
from forficula.statics.net.modes import natural_modes
from forficula.statics.net.net_of import is_net, net_of, own_angles, point_positions, start_shape
from forficula.structure import built_points, structure_of

WAIT = {"name": "wait", "drive": "none", "until": "time", "hold": 0.0, "time_limit": 1.0}
RIGID = {
    "facet.kind": "rigid",
    "pattern.columns": 2,
    "pattern.rows": 2,
    "pattern.fold": 0.7,
    "crease.rest_angle": 1.2,
    "crease.back_limit": 3.0,
    "support": [{"of": "facet 0"}],
    "drive": [],
    "measure": [],
    "protocol.stages": [WAIT],
}
MIURA = structure_of(with_values(load_design("miura-sheet"), RIGID))
FREE = structure_of(load_design("four-plate-snap"))


@pytest.mark.parametrize("structure", [MIURA, FREE], ids=["hinged", "sprung"])
def test_points_and_angles_are_those_of_the_structure_as_built(structure):
    net = net_of(structure)
    shape = start_shape(structure, net)
    assert point_positions(net, shape)[: len(structure.points)] == pytest.approx(built_points(structure), abs=1e-15)
    built = [hinge.start if hinge.flaps else hinge.built for hinge in structure.hinges]
    assert own_angles(structure, shape) == pytest.approx(built, abs=1e-12)


def test_plates_without_loops_stay_a_tree():
    assert is_net(MIURA)
    assert is_net(FREE)
    assert not is_net(structure_of(load_design("letter-fold")))


def test_nodes_have_the_mass_and_the_inertia_of_their_plates():
    """Of a triangle that turns in its plane at 1 rad/s, twice the kinetic energy is the polar moment of inertia."""
    net, structure = net_of(FREE), FREE
    mass = net.mass_matrix.toarray()
    area = 0.02**2 * np.sin(np.radians(87.5)) / 2
    plate_mass = 1270 * 0.5e-3 * area
    assert mass[:4, :4].sum() == pytest.approx(plate_mass)
    corners = built_points(structure)[list(structure.plates[0].points)]
    centre = corners.mean(axis=0)
    normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
    speeds = np.cross(normal / np.linalg.norm(normal), net.nodes[:4] - centre)
    # about the centre of a triangle, in its plane: m / 36 x the sum of the squares of its sides
    sides = sum(float(np.sum((corners[one] - corners[one - 1]) ** 2)) for one in range(3))
    polar = plate_mass / 36 * sides
    assert np.einsum("ix,ij,jx->", speeds, mass[:4, :4], speeds) == pytest.approx(polar, rel=1e-2)


def test_joints_hold_and_plates_stay_rigid_where_they_fold():
    net = net_of(MIURA)
    rest = minimum(net, start_shape(MIURA, net))
    assert rest.stable
    present, built = point_positions(net, rest.shape), built_points(MIURA)
    assert np.abs(own_angles(MIURA, rest.shape) - own_angles(MIURA, start_shape(MIURA, net))).max() > 0.1
    for plate in MIURA.plates:
        for one in plate.points:
            for other in plate.points:
                length = np.linalg.norm(built[one] - built[other])
                assert np.linalg.norm(present[one] - present[other]) == pytest.approx(length, abs=1e-5 * 0.02)
    for closure in MIURA.closures:
        for one, other in closure.points:
            assert np.linalg.norm(present[one] - present[other]) < 1e-4 * 0.02


def test_a_free_plate_has_zero_frequencies_for_rigid_body_motions():
    net = net_of(FREE)
    rest = minimum(net, start_shape(FREE, net))
    modes = natural_modes(net, rest.shape, 8)
    assert modes.rigid.sum() == 6
    assert (modes.frequencies[~modes.rigid] > 1).all()


def test_a_plate_may_be_anywhere():
    net = net_of(FREE)
    turn = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 1.0]])
    shape = start_shape(FREE, net)
    moved = shape_at(net, shape.positions @ turn.T + [1, 2, 3], shape.angles)
    assert own_angles(FREE, moved) == pytest.approx(own_angles(FREE, shape))
    assert point_positions(net, moved) == pytest.approx(point_positions(net, shape) @ turn.T + [1, 2, 3])
