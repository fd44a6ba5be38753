"""Rigid motions: which ones supports leave free, and how they are removed."""

import numpy as np
import pytest

from forficula.statics.net.energy import built_shape
from forficula.statics.net.minimum import minimum
from forficula.statics.net.rigidity import rigidity
from forficula.statics.net.supports import loose_motions, rigid_motions, supported
from tests.statics.net.nets import miura, sheet, truss

NODES, FACETS = miura(3, 2, fold=0.5)


@pytest.mark.parametrize(
    ("held", "left"), [((), 6), ((0,), 3), ((0, 1), 1), (((0, 2), (1, 2), (4, 2)), 3), ((0, 1, 2, 4), 0)]
)
def test_supports_leave_the_motions_that_they_do_not_hold(held, left):
    net = sheet(NODES, FACETS, held=held)[0]
    assert loose_motions(net).shape[2] == left
    pinned, pins = supported(net)
    assert len(pins) == left
    assert loose_motions(pinned).shape[2] == 0
    assert supported(pinned)[1] == ()


def test_pins_strain_nothing():
    net, diagonals = sheet(NODES, FACETS)
    free, pinned = (rigidity(item, built_shape(item), diagonals) for item in (net, supported(net)[0]))
    assert (free.degrees_of_freedom, free.rigid_motions) == (1, 6)
    assert (pinned.degrees_of_freedom, pinned.rigid_motions) == (1, 0)
    assert pinned.self_stresses == free.self_stresses


def test_where_it_rests_does_not_depend_on_what_pins_it():
    net = sheet(NODES, FACETS, rest=0.4)[0]
    other = sheet(NODES, FACETS, rest=0.4, held=[(0, 0), (0, 1), (0, 2), (1, 0), (1, 2), (3, 2)])[0]
    one, another = (minimum(item, built_shape(item)) for item in (net, other))
    assert one.stable
    assert another.stable
    assert one.energy == pytest.approx(another.energy, rel=1e-9)
    np.testing.assert_allclose(one.shape.angles, another.shape.angles, atol=1e-8)


def test_weight_matters_so_that_nothing_is_pinned_under_it():
    net = truss([[0, 0, 0], [1, 0, 0]], [[0, 1]], stiffness=1.0, held=[0], gravity=9.81)
    assert supported(net)[1] == ()


def test_nodes_on_a_line_have_five_motions():
    assert rigid_motions(np.array([[0.0, 0, 0], [1, 0, 0], [2, 0, 0]])).shape[2] == 5
