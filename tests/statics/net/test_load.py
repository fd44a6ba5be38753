"""Loads: where they act, and which are rejected."""

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest

from forficula.errors import InputError
from forficula.statics.net.energy import built_shape, load_slope
from forficula.statics.net.load import (
    acceleration,
    check_load,
    held_displacements,
    no_load,
    point_forces,
    pressure,
    same_load,
)
from forficula.statics.net.minimum import minimum
from forficula.statics.net.net import Net
from tests.statics.net.nets import truss

TETRAHEDRON = truss([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)], list(combinations(range(4), 2)), stiffness=3.0)


def test_pressure_on_a_closed_surface_adds_up_to_nothing():
    outwards = np.array([(0, 1, 2), (0, 3, 1), (0, 2, 3), (1, 3, 2)])
    load = pressure(TETRAHEDRON, built_shape(TETRAHEDRON), outwards)
    np.testing.assert_allclose(load.forces.sum(axis=0), 0, atol=1e-14)
    # the work of growth is pressure times change of volume: 3 volumes per unit of scale
    assert np.sum(load.forces * TETRAHEDRON.nodes) == pytest.approx(3 * 8 / 3)


def test_pressure_on_a_triangle_is_its_area_along_its_normal():
    load = pressure(TETRAHEDRON, built_shape(TETRAHEDRON), np.array([(0, 1, 2)]))
    assert np.linalg.norm(load.forces.sum(axis=0)) == pytest.approx(np.sqrt(3) / 4 * 8)


def test_a_force_on_a_combination_of_nodes_is_shared_by_its_weights():
    middle = Net(
        nodes=TETRAHEDRON.nodes,
        free=TETRAHEDRON.free,
        points=type(TETRAHEDRON.points)(np.full((1, 4), 0.25)),
        masses=TETRAHEDRON.masses,
    )
    load = point_forces(middle, np.array([0]), np.array([[0, 0, 4.0]]))
    np.testing.assert_allclose(load.forces, np.tile((0, 0, 1.0), (4, 1)))


def test_accelerated_supports_are_a_weight_the_other_way():
    net = replace(TETRAHEDRON, gravity=9.81)
    free = replace(TETRAHEDRON, gravity=0.0)
    load = acceleration(free, np.array([0, 0, 9.81]))
    np.testing.assert_allclose(load_slope(free, built_shape(free), load)[:, 2], -9.81)
    held = net.free.copy()
    held[:3] = False
    one = minimum(replace(net, free=held), built_shape(net))
    other = minimum(replace(free, free=held), built_shape(free), load, 1.0)
    np.testing.assert_allclose(one.shape.positions, other.shape.positions, atol=1e-12)


def test_free_coordinates_cannot_be_displaced():
    with pytest.raises(InputError, match=r"load.displacements: need 0 where no support holds, got .* at node 0"):
        check_load(TETRAHEDRON, held_displacements(TETRAHEDRON, np.ones((4, 3))))


def test_a_load_of_another_net_is_refused():
    with pytest.raises(InputError, match=r"load\.forces: need an array of shape"):
        check_load(TETRAHEDRON, replace(no_load(TETRAHEDRON), forces=np.zeros((3, 3))))


def test_a_load_that_carries_the_whole_away_is_refused():
    with pytest.raises(InputError, match="support: need some that hold the whole against the load, got 6"):
        minimum(TETRAHEDRON, built_shape(TETRAHEDRON), acceleration(TETRAHEDRON, np.array([0, 0, 1.0])), 1.0)


def test_loads_are_equal_if_all_their_forces_torques_and_displacements_are():
    net = truss([[0, 0, 0], [1, 0, 0]], [[0, 1]], stiffness=1.0, held=[0])
    push = point_forces(net, np.array([1]), np.array([[1.0, 0.0, 0.0]]))
    assert same_load(push, replace(push, forces=push.forces.copy()))
    assert not same_load(push, replace(push, forces=2 * push.forces))
    assert not same_load(push, held_displacements(net, np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 0.0]])))
