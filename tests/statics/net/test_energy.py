"""The energy of nets: its slope and curvature, invariance and scaling, and closed forms of its parts."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.sparse import csr_array, eye_array, vstack
from scipy.spatial.transform import Rotation

from forficula.material.law.tendon_law import ElasticLaw
from forficula.statics.net.energy import built_shape, expand, shape_at
from forficula.statics.net.factor import as_dense
from forficula.statics.net.load import Load
from forficula.statics.net.net import NetCreases, Tendons, Triangles
from forficula.statics.net.net_state import strength
from tests.statics.net.nets import miura, sheet, truss


def everything(scale=1.0, moved=lambda nodes: nodes):
    """Return a folded sheet with membranes and tendons, one ending inside a facet; `scale` of length and stiffness."""
    nodes, facets = miura(2, 2, fold=0.7)
    nodes = moved(scale * nodes)
    net = sheet(nodes, facets, axial=1e4 * scale, crease=scale, facet=1e2 * scale)[0]
    inside = csr_array(([0.25, 0.25, 0.5], ([0, 0, 0], [0, 3, 4])), shape=(1, 9))
    law = ElasticLaw(
        rest_length=scale * np.array([0.5, 9.0]),
        linear=np.array([3.0, 2.0]),
        quadratic=np.zeros(2),
        cubic=np.array([1.0, 0.0]) / scale**2,
    )
    corners = np.array([[0, 3, 4], [1, 4, 5]])
    return replace(
        net,
        points=csr_array(vstack((eye_array(9), inside))),
        tendons=Tendons(points=np.array([[9, 8], [2, 6]]), law=law),
        membranes=Triangles(
            points=corners, built=nodes[corners], youngs_modulus=100.0, poisson_ratio=0.3, thickness=0.1
        ),
    )


@settings(deadline=None, max_examples=5)
@given(st.integers(0, 10**6))
def test_slope_and_curvature_are_those_of_the_energy(seed):
    random, net = np.random.default_rng(seed), replace(everything(), gravity=9.81)
    start = built_shape(net)
    shape = shape_at(net, net.nodes + 0.1 * random.standard_normal((9, 3)), start.angles)
    load = Load(
        forces=random.standard_normal((9, 3)),
        torques=random.standard_normal(len(start.angles)),
        displacements=np.zeros((9, 3)),
    )
    current, step = expand(net, shape, load, 0.7), 1e-6
    for node, axis in np.ndindex(9, 3):
        off = np.zeros((9, 3))
        off[node, axis] = step
        after, before = (
            expand(net, shape_at(net, shape.positions + sign * off, shape.angles), load, 0.7) for sign in (1, -1)
        )
        rise = (after.energy - before.energy) / (2 * step)
        assert current.slope[node, axis] == pytest.approx(rise, rel=1e-5, abs=1e-7 * np.abs(current.slope).max())
        rises = (after.slope - before.slope).ravel() / (2 * step)
        column = current.curvature.toarray()[:, 3 * node + axis]
        np.testing.assert_allclose(column, rises, atol=1e-6 * np.abs(current.curvature.data).max())


@settings(deadline=None, max_examples=10)
@given(st.integers(0, 10**6), st.floats(1e-3, 1e3))
def test_moving_and_scaling_a_net_changes_nothing(seed, scale):
    random = np.random.default_rng(seed)
    turn, shift = Rotation.random(random_state=seed % 2**31).as_matrix(), random.standard_normal(3)
    one = everything()
    other = everything(scale, lambda nodes: nodes @ turn.T + scale * shift)
    bent = one.nodes + 0.1 * random.standard_normal((9, 3))
    current = expand(one, shape_at(one, bent, built_shape(one).angles))
    present = expand(other, shape_at(other, scale * (bent @ turn.T + shift), built_shape(other).angles))
    np.testing.assert_allclose(present.shape.angles, current.shape.angles, atol=1e-9)
    assert present.stored == pytest.approx(scale**2 * current.stored, rel=1e-9)


def test_held_coordinates_are_left_out_of_the_free_part():
    net = sheet(*miura(2, 2, fold=0.7), held=[0, (4, 2)])[0]
    current = expand(net, built_shape(net))
    flags = net.free.ravel()
    np.testing.assert_array_equal(as_dense(current.free), current.curvature.toarray()[flags][:, flags])
    assert current.free.shape == (23, 23)


def test_springs_without_a_resting_length_pull_straight_and_may_have_no_length():
    net = truss([[0, 0, 0], [0, 0, 0], [1, 0, 0]], [[0, 1]], stiffness=5.0, rest=0.0)
    current = expand(net, built_shape(net))
    np.testing.assert_array_equal(current.slope, 0)
    np.testing.assert_allclose(current.curvature.toarray()[:3, :3], 5 * np.eye(3))


def test_a_membrane_stretched_one_way_stores_what_its_law_says():
    nodes = np.array([[0, 0, 0], [2.0, 0, 0], [0, 1.0, 0]])
    net = truss(nodes, np.zeros((0, 2)), stiffness=1.0)
    sheet_ = Triangles(
        points=np.array([[0, 1, 2]]), built=nodes[None], youngs_modulus=1e6, poisson_ratio=0.3, thickness=1e-3
    )
    net = replace(net, membranes=sheet_)
    strain = (1.1**2 - 1) / 2
    across = np.sqrt(1 - 2 * 0.3 * strain)  # no stress across
    current = shape_at(net, nodes * (1.1, across, 1))
    assert expand(net, current).stored == pytest.approx(1e6 * strain**2 / 2 * 1e-3)
    np.testing.assert_allclose(strength(net, current).stresses, [[1e6 * strain, 0]], atol=1e-6)


def test_an_open_crease_turns_about_the_mean_of_its_edges():
    net = sheet(*miura(1, 2, fold=0.4))[0]
    apart = np.concatenate((net.nodes, net.nodes + np.array((0.01, 0.02, 0.0))))
    points = net.creases.points + np.array([0, 0, 0, 6, 6, 6])
    open_ = replace(
        truss(apart, np.zeros((0, 2)), stiffness=1.0),
        creases=NetCreases(points=points, law=net.creases.law),
    )
    np.testing.assert_allclose(built_shape(open_).angles, built_shape(net).angles, atol=1e-12)
