"""Panels that pass through each other."""

import numpy as np
import pytest

from forficula.design import load_design, with_values
from forficula.statics.net.energy import built_shape, shape_at
from forficula.statics.net.minimum import minimum
from forficula.statics.net.net_of import net_of, panels, start_shape
from forficula.statics.net.panel_crossing import panels_cross
from forficula.structure import structure_of
from tests.statics.net.nets import sheet, truss

TWO = np.array([[0, 1, 2], [3, 4, 5]])


def pair(low, high):
    """Return a horizontal triangle, and an upright one that passes through it between two heights."""
    nodes = [[-1, -1, 0], [2, -1, 0], [-1, 2, 0], [0, 0, low], [0.1, 0, low], [0, 0.1, high]]
    return truss(nodes, [(0, 1)], stiffness=1.0)


@pytest.mark.parametrize(("low", "high", "passes"), [(-0.5, 0.5, True), (0.1, 0.5, False), (-0.5, -0.1, False)])
def test_a_side_that_goes_through_a_triangle_is_found(low, high, passes):
    net = pair(low, high)
    assert panels_cross(net, built_shape(net), TWO) is passes


def test_triangles_apart_or_that_share_a_corner_do_not_pass():
    net = truss([[0, 0, 0], [1, 0, 0], [0, 1, 0], [5, 5, 5], [6, 5, 5], [5, 6, 5]], [(0, 1)], stiffness=1.0)
    assert not panels_cross(net, built_shape(net), TWO)
    assert not panels_cross(net, built_shape(net), np.array([[0, 1, 2], [0, 1, 3]]))


def test_a_crease_beyond_half_a_turn_passes():
    net, _ = sheet([[0, 0, 0], [1, 0, 0], [0.5, 1, 0], [0.5, -1, 0]], [(0, 1, 2), (1, 0, 3)])
    triangles = np.array([[0, 1, 2], [1, 0, 3]])
    present = net.nodes.copy()
    present[3] = [0.5, np.cos(0.1), np.sin(0.1)]
    assert not panels_cross(net, shape_at(net, present, np.array([np.pi - 0.1])), triangles)
    # on the other side of the panel: folded around it, or passed through it
    present[3, 2] *= -1
    assert not panels_cross(net, shape_at(net, present, np.array([0.1 - np.pi])), triangles)
    assert panels_cross(net, shape_at(net, present, np.array([np.pi + 0.1])), triangles)


def test_two_plates_that_fold_onto_one_another_up_to_their_stop_do_not_pass():
    shut = {"crease.fold_limit": np.pi, "crease.rest_angle": 3.0, "tendon.0.rest_length": 0.005}
    structure = structure_of(with_values(load_design("force-clasp"), shut))
    net = net_of(structure)
    rest = minimum(net, start_shape(structure, net)).shape
    assert np.degrees(rest.angles[0]) == pytest.approx(179.7, abs=0.31)
    assert not panels_cross(net, rest, panels(structure))
