"""Von Mises' truss, two bars between supports, agrees with its closed form (von Mises 1923, ZAMM 3, 406-422)."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import brentq

from forficula.errors import InputError
from forficula.material.law.tendon_law import ElasticLaw
from forficula.statics.net.collapse import collapse, state_after_collapse
from forficula.statics.net.energy import built_shape, expand
from forficula.statics.net.load import acceleration, held_displacements, point_forces
from forficula.statics.net.load_path import load_path
from forficula.statics.net.minimum import minimum
from forficula.statics.net.modes import natural_modes
from forficula.statics.net.net import Tendons
from forficula.statics.net.saddle import find_saddle
from forficula.statics.net.stable_states import find_stable_states
from tests.statics.net.nets import truss

STIFFNESS, HALF = 1000.0, 1.0  # N/m, m
DOWN = np.array([[0.0, 0.0, -1.0]])
APEX = np.array([1])


def von_mises(height, held=()):
    nodes = [[-HALF, 0, 0], [0, 0, height], [HALF, 0, 0]]
    return truss(nodes, [[0, 1], [1, 2]], stiffness=STIFFNESS, held=[0, 2, (1, 1), *held])


def force(height, z):
    """Downward force on the apex, N."""
    return 2 * STIFFNESS * z * (np.hypot(HALF, height) / np.hypot(HALF, z) - 1)


def limit(height):
    """Largest force: where the cubed bar length equals the resting length times the squared half span."""
    length = (np.hypot(HALF, height) * HALF**2) ** (1 / 3)
    return force(height, np.sqrt(length**2 - HALF**2))


@settings(deadline=None, max_examples=8)
@given(st.floats(0.05, 1.5))
def test_the_load_path_under_a_force_follows_the_closed_form_through_both_limits(agree, height):
    net = von_mises(height)
    path = load_path(net, built_shape(net), point_forces(net, APEX, DOWN), step=height / 10, increments=26)
    z = np.array([point.shape.positions[1, 2] for point in path.points])
    factors = np.array([point.factor for point in path.points])
    by = "von Mises 1923"
    most = limit(height)
    agree("force divided by the largest", factors / most, force(height, z) / most, by=by, abs=1e-9)
    assert z[-1] < -height
    assert [event.kind for event in path.events] == ["limit", "limit"]
    for event, sign in zip(path.events, (1, -1), strict=True):
        agree("limit load", event.point.factor, sign * limit(height), unit="N", by=by, rel=1e-9)
    inside = np.abs(z) < np.sqrt((np.hypot(HALF, height) * HALF**2) ** (2 / 3) - HALF**2)
    assert [point.index for point in path.points] == list(inside.astype(int))


@pytest.mark.parametrize("height", [0.003, 0.01, 0.02, 0.05])
@pytest.mark.parametrize("step", [0.02, 0.08])
def test_the_limit_of_a_shallow_truss_is_found_although_an_increment_could_step_over_it(agree, height, step):
    net = von_mises(height)
    path = load_path(net, built_shape(net), point_forces(net, APEX, DOWN), step=step, increments=20, events=1)
    assert [event.kind for event in path.events] == ["limit"]
    result, known = path.events[0].point.factor, limit(height)
    agree("limit load", result, known, unit="N", by="von Mises 1923", rel=1e-6)


def test_the_path_under_a_displacement_has_no_limit(agree):
    net = von_mises(0.3, held=[1])
    move = np.zeros((3, 3))
    move[1] = DOWN
    path = load_path(net, built_shape(net), held_displacements(net, move), target=0.6, increments=200)
    assert path.ended == "target"
    assert not path.events
    ways = np.array([point.factor for point in path.points])
    agree(
        "force on the apex of a truss",
        [-expand(net, point.shape).slope[1, 2] for point in path.points],
        force(0.3, 0.3 - ways),
        unit="N",
        by="von Mises 1923",
        abs=1e-9,
        over=("displacement (m)", ways),
    )


def test_with_a_soft_spring_in_series_the_truss_snaps_back_under_displacement(agree):
    height, soft = 0.3, 30.0
    nodes = [[-HALF, 0, 0], [0, 0, height], [HALF, 0, 0], [0, 0, 2.0]]
    net = truss(nodes, [[0, 1], [1, 2], [1, 3]], stiffness=[STIFFNESS, STIFFNESS, soft], held=[0, 2, 3, (1, 0), (1, 1)])
    move = np.zeros((4, 3))
    move[3] = DOWN
    path = load_path(net, built_shape(net), held_displacements(net, move), step=0.02, increments=60)

    def driven(z):
        return height - z + force(height, z) / soft

    def slope(z):
        return (driven(z + 1e-6) - driven(z - 1e-6)) / 2e-6

    z = np.array([point.shape.positions[1, 2] for point in path.points])
    ways, by = [point.factor for point in path.points], "von Mises 1923 and a spring"
    agree("displacement", ways, driven(z), unit="m", by=by, abs=1e-9)
    turns = [brentq(slope, 0.0, height), brentq(slope, -height, 0.0)]
    assert driven(turns[1]) < driven(turns[0])  # it does snap back
    assert [event.kind for event in path.events] == ["limit", "limit"]
    for event, turn in zip(path.events, turns, strict=True):
        agree("displacement at the limit", event.point.factor, driven(turn), unit="m", by=by, rel=1e-8)


def test_the_path_has_a_corner_where_a_tendon_goes_slack(agree):
    # it pulls the apex down to 0.1 m, and prevents a snap up to there
    slack, pull = 0.1, 400.0
    nodes = [[-HALF, 0, 0], [0, 0, 0.3], [HALF, 0, 0], [0, 0, -1]]
    net = truss(nodes, [[0, 1], [1, 2]], stiffness=STIFFNESS, held=[0, 2, 3, (1, 0), (1, 1)])
    law = ElasticLaw(rest_length=np.array([1 + slack]), linear=np.array([pull]))
    net = replace(net, tendons=Tendons(points=np.array([[1, 3]]), law=law))
    start = minimum(net, built_shape(net))
    path = load_path(net, start.shape, point_forces(net, APEX, DOWN), step=0.02, increments=40)
    assert path.ended == "count"
    z = np.array([point.shape.positions[1, 2] for point in path.points])
    known = force(0.3, z) - pull * np.maximum(z - slack, 0)
    result, by = [point.factor for point in path.points], "von Mises 1923 and a tendon"
    agree("force", result, known, unit="N", by=by, abs=1e-8)
    assert z[-1] < -0.3
    assert [event.kind for event in path.events] == ["limit", "limit"]
    agree("force at the corner", path.events[0].point.factor, force(0.3, slack), unit="N", by=by, rel=1e-3)


def test_a_tall_truss_buckles_sideways_first(agree):
    # the sideways stiffness 1 - L0 z^2 / L^3 falls to 0 above the limit where L0 > 3 sqrt(3) / 2 of the half span
    height = 2.6
    net = von_mises(height)
    rest = np.hypot(HALF, height)
    z = brentq(lambda z: np.hypot(HALF, z) ** 3 - rest * z**2, np.sqrt(2), height)
    path = load_path(net, built_shape(net), point_forces(net, APEX, DOWN), events=1, increments=200)
    event = path.events[0]
    assert event.kind == "bifurcation"
    by = "1 - L₀ z² / L³ = 0"
    agree("buckling force", event.point.factor, force(height, z), unit="N", by=by, rel=1e-5)
    np.testing.assert_allclose(event.mode[1], (1, 0, 0), atol=1e-6)

    for sense in (1, -1):
        aside = load_path(
            net,
            event.point.shape,
            point_forces(net, APEX, DOWN),
            factor=event.point.factor,
            direction=sense * event.mode,
            increments=20,
        )
        for point in aside.points[1:]:
            x, _, z = point.shape.positions[1]
            assert sense * x > 0
            lengths = np.hypot(x + HALF, z), np.hypot(x - HALF, z)
            pulls = [STIFFNESS * (rest / length - 1) for length in lengths]
            assert pulls[0] * (x + HALF) + pulls[1] * (x - HALF) == pytest.approx(0, abs=1e-8)
            assert sum(pulls) * z == pytest.approx(point.factor, abs=1e-8)


def test_the_saddle_between_both_states_has_straight_bars(agree):
    net = von_mises(0.3)
    result = find_stable_states(net, [built_shape(net)], tries=10)
    heights = sorted(state.shape.positions[1, 2] for state in result.states)
    agree("heights of both states", heights, [-0.3, 0.3], unit="m", by="bars of equal length", rel=1e-6)
    saddle = find_saddle(net, *result.states)
    assert saddle is not None
    assert saddle.joins
    barrier = STIFFNESS * (np.hypot(HALF, 0.3) - HALF) ** 2
    agree("barrier of a truss of two bars", saddle.barriers, barrier, unit="J", by="straight bars", rel=1e-9)


def test_the_truss_collapses_at_the_same_limit_under_force_and_acceleration(agree):
    net = replace(von_mises(0.3), masses=np.array([1.0, 0.2, 1.0]))
    rest = minimum(net, built_shape(net))
    pushed = collapse(net, rest, point_forces(net, APEX, DOWN))
    shaken = collapse(net, rest, acceleration(net, np.array([0.0, 0.0, 1.0])))
    assert pushed.kind == shaken.kind == "limit"
    agree("force", pushed.factor, limit(0.3), unit="N", by="von Mises 1923", rel=1e-9)
    agree("acceleration", shaken.factor, limit(0.3) / 0.2, unit="m/s²", by="limit load divided by the mass", rel=1e-9)
    assert collapse(net, rest, point_forces(net, APEX, DOWN), most=limit(0.3) / 2).kind == "none"


def test_the_truss_snaps_from_its_limit_to_the_inverted_shape_under_the_same_force(agree):
    net = von_mises(0.3)
    state = minimum(net, built_shape(net))
    lost = collapse(net, state, point_forces(net, APEX, DOWN))
    present = state_after_collapse(net, lost)
    assert present.stable
    z = brentq(lambda z: force(0.3, z) - 1.001 * limit(0.3), -1.0, -0.3)
    agree("height after the snap", present.shape.positions[1], (0, 0, z), unit="m", by="von Mises 1923", abs=1e-8)
    assert minimum(net, present.shape).shape.positions[1, 2] == pytest.approx(-0.3)
    held = collapse(net, state, point_forces(net, APEX, DOWN), most=1.0)
    with pytest.raises(InputError, match="lost: need a state that collapses"):
        state_after_collapse(net, held)


def test_the_frequency_of_the_apex_follows_from_its_stiffness(agree):
    net = von_mises(0.3)
    modes = natural_modes(net, built_shape(net))
    squares = 2 * STIFFNESS * np.array([0.3**2, HALF**2]) / (0.3**2 + HALF**2)
    result = 2 * np.pi * modes.frequencies
    # the relative error of a square is twice that of its base
    agree("frequencies", result, np.sqrt(squares), unit="rad/s", by="√(k / m)", rel=0.5e-9)
    assert not modes.rigid.any()
