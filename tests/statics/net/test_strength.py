"""Loads in the parts of a net, and its motion with consistent, lumped or missing masses."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.sparse import csr_array

from forficula.errors import InputError
from forficula.material.law.tendon_law import ElasticLaw
from forficula.statics.net.energy import built_shape, expand, shape_at
from forficula.statics.net.modes import natural_modes
from forficula.statics.net.net import Tendons
from forficula.statics.net.net_state import strength
from tests.statics.net.nets import sheet, truss


def test_bars_tendons_and_creases_bear_what_their_laws_say():
    nodes = np.array([(0, 0, 0), (1, 0, 0), (0.5, 1, 0), (0.5, -1, 0)])
    net = sheet(nodes, [(0, 1, 2), (1, 0, 3)], crease=2.0, rest=0.5, axial=10.0)[0]
    law = ElasticLaw(rest_length=np.array([1.0, 3.0]), linear=np.array([4.0, 4.0]))
    net = replace(net, tendons=Tendons(points=np.array([[2, 3], [2, 3]]), law=law))
    borne = strength(net, shape_at(net, nodes * (1.1, 1.1, 1)))
    np.testing.assert_allclose(borne.strains, 0.1)
    np.testing.assert_allclose(borne.forces, 1.0)  # EA times the strain
    np.testing.assert_allclose(borne.moments, [-1.0])
    np.testing.assert_allclose(borne.pulls, [4.0 * 1.2, 0.0])
    np.testing.assert_allclose(borne.extensions, [1.2, 0.0])
    assert borne.stresses.shape == (0, 2)


def test_springs_without_a_resting_length_have_forces_but_no_strain():
    net = truss([[0, 0, 0], [2, 0, 0]], [[0, 1]], stiffness=5.0, rest=0.0)
    borne = strength(net, built_shape(net))
    np.testing.assert_array_equal(borne.strains, [0])
    np.testing.assert_array_equal(borne.forces, [10])


def test_nodes_without_a_mass_follow_at_once():
    # two springs in series have half the stiffness of one
    nodes = np.array([(0.0, 0, 0), (1, 0, 0), (2, 0, 0)])
    held = [0, (1, 1), (1, 2), (2, 1), (2, 2)]
    net = truss(nodes, [[0, 1], [1, 2]], stiffness=8.0, held=held, masses=[0, 0, 0.5])
    modes = natural_modes(net, built_shape(net))
    np.testing.assert_allclose(2 * np.pi * modes.frequencies, [np.sqrt(8.0)])
    np.testing.assert_allclose(modes.shapes[0, 1:, 0] / modes.shapes[0, 2, 0], [0.5, 1])


def test_a_matrix_of_masses_is_the_mass_of_a_rod():
    # a rod of mass m between two nodes: m / 3 on the diagonal, m / 6 off it (e.g. Cook 1981)
    nodes = np.array([(0.0, 0, 0), (1, 0, 0)])
    net = truss(nodes, [[0, 1]], stiffness=6.0, held=[(0, 1), (0, 2), (1, 1), (1, 2)])
    net = replace(net, masses=csr_array(0.5 * np.array([[1 / 3, 1 / 6], [1 / 6, 1 / 3]])))
    modes = natural_modes(net, built_shape(net))
    np.testing.assert_allclose((2 * np.pi * modes.frequencies[1]) ** 2, 12 * 6.0 / 0.5)
    assert list(modes.rigid) == [True, False]
    weighed = replace(net, gravity=10.0)
    np.testing.assert_allclose(expand(weighed, built_shape(weighed)).slope[:, 2], 0.25 * 10)


def test_a_net_without_mass_has_no_modes():
    net = truss([[0, 0, 0], [1, 0, 0]], [[0, 1]], stiffness=6.0, held=[0], masses=[1.0, 0.0])
    with pytest.raises(InputError, match=r"net\.masses: need some > 0 that move, got none"):
        natural_modes(net, built_shape(net))
