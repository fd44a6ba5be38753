"""Slowly growing loads: von Mises' truss snaps at its limit load, and a buckling strut takes a branch."""

import numpy as np
import pytest
from scipy.optimize import brentq

from forficula.statics.net.collapse import collapse, state_after_collapse
from forficula.statics.net.driven.slow_path import slow_path
from forficula.statics.net.energy import built_shape
from forficula.statics.net.load import held_displacements, point_forces
from forficula.statics.net.minimum import minimum
from tests.statics.net.nets import truss

HALF, RISE, STIFFNESS = 1.0, 0.4, 100.0


def von_mises():
    """Return two bars that meet at an apex, which moves vertically only."""
    nodes = [[-HALF, 0, 0], [HALF, 0, 0], [0, 0, RISE]]
    return truss(nodes, [(0, 2), (1, 2)], stiffness=STIFFNESS, held=(0, 1, (2, 0), (2, 1)))


def force(height):
    """Return the downward force on the apex that balances the bars at a height, N."""
    length = np.hypot(HALF, height)
    return 2 * STIFFNESS * (np.hypot(HALF, RISE) / length - 1) * height


def test_it_snaps_at_the_largest_force_and_lands_beyond_its_mirror_image():
    net = von_mises()
    heights = np.linspace(0, RISE, 20001)
    largest = force(heights).max()
    load = point_forces(net, np.array([2]), np.array([[0.0, 0.0, -1.0]]))
    path = slow_path(net, built_shape(net), load, end=2 * largest)
    assert path.ended == "target"
    (snap,) = path.snaps
    assert snap.kind == "limit"
    assert snap.factor == pytest.approx(largest, rel=1e-4)
    landed = snap.after.shape.positions[2, 2]
    assert landed < -RISE
    assert force(landed) == pytest.approx(largest, rel=1e-3)
    # dissipated: the work of the force less the energy that the bars store
    before = snap.before.positions[2, 2]
    stored = [STIFFNESS * (np.hypot(HALF, height) - np.hypot(HALF, RISE)) ** 2 for height in (before, landed)]
    assert snap.released == pytest.approx(largest * (before - landed) + stored[0] - stored[1], rel=1e-3)


def test_a_force_that_falls_again_snaps_back_at_the_other_limit():
    net = von_mises()
    largest = force(np.linspace(0, RISE, 20001)).max()
    load = point_forces(net, np.array([2]), np.array([[0.0, 0.0, -1.0]]))
    present = slow_path(net, built_shape(net), load, end=2 * largest)
    back = slow_path(net, present.points[-1].shape, load, begin=2 * largest, end=-2 * largest)
    assert [snap.factor for snap in back.snaps] == pytest.approx([-largest], rel=1e-4)


def test_a_path_stops_during_a_snap_where_the_stop_condition_holds():
    net = von_mises()
    largest = force(np.linspace(0, RISE, 20001)).max()
    load = point_forces(net, np.array([2]), np.array([[0.0, 0.0, -1.0]]))
    path = slow_path(net, built_shape(net), load, end=2 * largest, stop=lambda shape: shape.positions[2, 2] < 0)
    assert path.ended == "stop"
    assert -0.2 < path.snaps[0].after.shape.positions[2, 2] < 0


def test_a_strut_that_buckles_turns_into_one_of_two_branches():
    """Two collinear bars with a spring across them buckle at k L / 2 (e.g. Bazant and Cedolin 2010, section 4.5)."""
    side, length = 2.0, 1.0
    nodes = [[0, 0, 0], [length, 0, 0], [2 * length, 0, 0], [length, 0, 1.0]]
    held = (0, (1, 1), (2, 1), (2, 2), 3)
    net = truss(nodes, [(0, 1), (1, 2), (1, 3)], stiffness=[1e4, 1e4, side], held=held)
    load = point_forces(net, np.array([2]), np.array([[-1.0, 0.0, 0.0]]))
    path = slow_path(net, built_shape(net), load, end=1.2 * side * length / 2, step=0.002)
    assert path.snaps
    assert path.snaps[0].kind in ("branch", "bifurcation")
    assert path.snaps[0].factor == pytest.approx(side * length / 2, rel=1e-3)


def test_a_displacement_through_a_soft_spring_snaps_back_and_goes_on_to_its_end():
    """The end of the spring moves by the apex's displacement plus the force divided by the spring's stiffness."""
    soft, length = 4.0, 8.0
    nodes = [[-HALF, 0, 0], [HALF, 0, 0], [0, 0, RISE], [0, 0, RISE + length]]
    net = truss(nodes, [(0, 2), (1, 2), (2, 3)], stiffness=[STIFFNESS, STIFFNESS, soft], held=(0, 1, (2, 0), (2, 1), 3))

    def gone(height):
        return RISE - height + force(height) / soft

    heights = np.linspace(0, RISE, 20001)
    furthest = gone(heights).max()
    move = np.zeros((4, 3))
    move[3, 2] = -1.0
    path = slow_path(net, built_shape(net), held_displacements(net, move), end=1.5 * furthest)
    (snap,) = path.snaps
    assert path.ended == "target"
    assert snap.factor == pytest.approx(furthest, rel=1e-6)
    landing = brentq(lambda height: gone(height) - furthest, -3 * RISE, -RISE / 2)
    assert snap.after.shape.positions[2, 2] == pytest.approx(landing, abs=1e-4)
    stored = [
        STIFFNESS * (np.hypot(HALF, height) - np.hypot(HALF, RISE)) ** 2 + force(height) ** 2 / (2 * soft)
        for height in (heights[gone(heights).argmax()], landing)
    ]
    assert snap.released == pytest.approx(stored[0] - stored[1], rel=1e-3)
    assert path.points[-1].shape.positions[3, 2] == pytest.approx(RISE + length - 1.5 * furthest, abs=1e-9)
    lost = collapse(net, minimum(net, built_shape(net)), held_displacements(net, move))
    over = state_after_collapse(net, lost).shape.positions
    assert over[2, 2] == pytest.approx(landing, abs=1e-3)
    assert over[3, 2] == pytest.approx(RISE + length - 1.001 * furthest, abs=1e-6)
