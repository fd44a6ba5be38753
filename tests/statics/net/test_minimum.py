"""Minimization: it goes downhill from its start, proves the minimum by a matrix's inertia, and reports failures."""

import time
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.design import load_design, with_values
from forficula.material.law.crease_law import CreaseLaw
from forficula.statics.net.energy import built_shape, expand, shape_at
from forficula.statics.net.factor import as_dense
from forficula.statics.net.load import crease_torques, point_forces
from forficula.statics.net.minimum import minimum, stationary
from forficula.statics.net.net_of import net_of, start_shape
from forficula.structure import structure_of
from tests.statics.net.nets import miura, sheet, truss


@settings(deadline=None, max_examples=10)
@given(st.integers(0, 1000))
def test_a_disturbed_sheet_comes_back_to_rest_without_a_slope(seed):
    net = sheet(*miura(3, 3, fold=0.5), rest=0.3)[0]
    first = minimum(net, built_shape(net))
    push = 0.02 * np.random.default_rng(seed).standard_normal(net.nodes.shape)
    back = minimum(net, shape_at(net, first.shape.positions + push, first.shape.angles))
    assert back.stable
    assert back.energy == pytest.approx(first.energy, rel=1e-10)
    assert back.slope < 1e-7
    assert np.linalg.eigvalsh(as_dense(expand(net, back.shape).free))[6] > 0


def test_a_torque_on_a_crease_turns_it_by_its_stiffness():
    # two triangles on the edge of a fixed one: only the crease resists
    nodes = np.array([(0, 0, 0), (1, 0, 0), (0.5, 1, 0), (0.5, -1, 0)])
    net = sheet(nodes, [(0, 1, 2), (1, 0, 3)], crease=2.0, held=[0, 1, 3])[0]
    rest = minimum(net, built_shape(net), crease_torques(net, np.array([0]), 1.0), 0.6)
    assert rest.shape.angles == pytest.approx([0.3], abs=1e-9)
    assert rest.energy == pytest.approx(2.0 * 0.3**2 / 2)


def test_a_flat_sheet_exactly_on_the_ridge_is_at_rest_but_not_stable():
    net = sheet(*miura(2, 2, fold=0.0), crease=0.0, facet=0.0)[0]
    squeezed = replace(net, springs=replace(net.springs, rest_length=1.05 * net.springs.rest_length))
    # when flat, the longer bars fit a flat sheet 1.05 times as large, so a smaller one compresses them
    frame = squeezed.free.copy()
    frame[[0, 1, 2, 3, 5, 6, 7, 8], :] = False
    rest = minimum(replace(squeezed, free=frame), built_shape(squeezed))
    assert rest.settled
    assert rest.index == 1
    assert not rest.stable


def test_a_mechanism_without_springs_is_neutral():
    net, flat = sheet(*miura(2, 2, fold=0.5))
    law = CreaseLaw(stiffness=np.where(flat, 1e2, 0.0))
    rest = minimum(replace(net, creases=replace(net.creases, law=law)), built_shape(net))
    assert rest.settled
    assert rest.index == 0
    assert rest.neutral == 1
    assert not rest.stable


def test_an_unsupported_net_under_gravity_does_not_settle():
    net = truss([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1], [1, 2], [2, 0]], stiffness=1.0, gravity=9.81)
    assert not minimum(net, built_shape(net)).settled


def test_locking_panels_stop_short_of_contact():
    nodes = np.array([(0, 0, 0), (1, 0, 0), (0.5, 1, 0), (0.5, -1, 0)])
    net = sheet(nodes, [(0, 1, 2), (1, 0, 3)], held=[0, 1, 3])[0]
    law = CreaseLaw(stiffness=np.ones(1), lock_above=np.array([2.5]))
    net = replace(net, creases=replace(net.creases, law=law))
    rest = minimum(net, built_shape(net), crease_torques(net, np.array([0]), 1.0), 50.0)
    assert rest.stable
    assert 2.5 < rest.shape.angles[0] < np.pi
    assert law.moment(rest.shape.angles)[0] == pytest.approx(50.0)


def test_newtons_method_finds_the_nearby_saddle():
    net = truss([[-1, 0, 0], [0, 0, 0.3], [1, 0, 0]], [[0, 1], [1, 2]], stiffness=1e3, held=[0, 2, (1, 1)])
    ridge = stationary(net, shape_at(net, net.nodes * (1, 1, 0.1)))
    assert ridge.settled
    assert ridge.index == 1
    assert ridge.shape.positions[1] == pytest.approx((0, 0, 0), abs=1e-12)


def test_a_sheet_of_961_nodes_folds_in_seconds():
    net, flat = sheet(*miura(30, 30, fold=0.3), axial=1e6)
    goal = built_shape(sheet(*miura(30, 30, fold=0.9))[0]).angles
    law = replace(net.creases.law, rest_angle=np.where(flat, 0.0, goal))
    began = time.process_time()
    rest = minimum(replace(net, creases=replace(net.creases, law=law)), built_shape(net))
    assert time.process_time() - began < 20  # 1.2 s on one core
    assert rest.stable
    np.testing.assert_allclose(rest.shape.angles, law.rest_angle, atol=1e-8)


def test_one_coordinate_goes_downhill_over_an_inflection_where_nothing_is_stiff():
    # von Mises' truss under a force above its limit: the curvature vanishes twice on the path
    net = truss([[-1, 0, 0], [1, 0, 0], [0, 0, 0.4]], [(0, 2), (1, 2)], stiffness=100.0, held=(0, 1, (2, 0), (2, 1)))
    load = point_forces(net, np.array([2]), np.array([[0.0, 0.0, -1.0]]))
    for force in np.linspace(2.4, 4.0, 5):
        for longest in (0.03, 0.1, 0.3):
            rest = minimum(net, built_shape(net), load, force, longest_step=longest)
            assert rest.stable, (force, longest)
            assert rest.shape.positions[2, 2] < -0.4


def test_a_large_folded_sheet_comes_to_rest_flat_in_few_steps_with_dampers_between_its_nodes():
    """In the sheet of 32 x 32 facets of the benchmark, 42 steps replace 212."""
    keys = {"pattern.columns": 12, "pattern.rows": 12, "pattern.fold": np.pi / 2, "crease.rest_angle": "flat"}
    structure = structure_of(with_values(load_design("miura-sheet"), keys))
    net = net_of(structure)
    start = start_shape(structure, net)
    between, on_nodes = (minimum(net, start, between_nodes=chosen) for chosen in (True, False))
    for rest in (between, on_nodes):
        assert rest.stable
        assert rest.energy < 1e-12 * expand(net, start).energy
        assert np.abs(rest.shape.angles).max() < 1e-6
    assert 2 * between.steps < on_nodes.steps
