"""Kresling's truss between rigid polygons agrees with the closed form of its energy in height and twist.

n bars of each of two kinds join two regular polygons of radius R at a distance h, twisted by t. Their squared lengths
are h^2 + 2 R^2 (1 - cos t), and the same with t + 2 pi / n (Kresling 1995; the truss as in Yasuda, Tachi, Lee and Yang
2017, doi 10.1038/s41467-017-00670-w). Both lengths recur at the twist pi - 2 pi / n - t.
"""

from itertools import combinations

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

from forficula.statics.net.energy import built_shape
from forficula.statics.net.load import point_forces
from forficula.statics.net.load_path import load_path
from forficula.statics.net.saddle import find_saddle
from forficula.statics.net.stable_states import find_stable_states
from tests.statics.net.nets import truss

SIDES, RADIUS, STIFFNESS = 6, 1.0, 1000.0
TWIST, HEIGHT = np.deg2rad(40), 1.3
STEP = 2 * np.pi / SIDES
RIGID = 1e5  # stiffness of polygons over that of bars; energies are too low by its inverse
APEX = 2 * SIDES  # above the upper polygon


def kresling():
    """Net of bars: the upper polygon and its apex joined by all their diagonals, the lower polygon held."""
    turn = STEP * np.arange(SIDES)
    lower = np.stack((RADIUS * np.cos(turn), RADIUS * np.sin(turn), 0 * turn), axis=1)
    upper = np.stack((RADIUS * np.cos(turn + TWIST), RADIUS * np.sin(turn + TWIST), 0 * turn + HEIGHT), axis=1)
    nodes = np.concatenate((lower, upper, [[0, 0, HEIGHT + RADIUS]]))
    bars = [(i, SIDES + i) for i in range(SIDES)] + [(i, SIDES + (i + 1) % SIDES) for i in range(SIDES)]
    block = list(combinations(range(SIDES, 2 * SIDES + 1), 2))
    stiffness = [STIFFNESS] * len(bars) + [RIGID * STIFFNESS] * len(block)
    return truss(nodes, bars + block, stiffness=stiffness, held=range(SIDES))


def energy(height, twist):
    def length(h, t):
        return np.sqrt(h**2 + 2 * RADIUS**2 * (1 - np.cos(t)))

    sides = length(height, twist) - length(HEIGHT, TWIST)
    diagonals = length(height, twist + STEP) - length(HEIGHT, TWIST + STEP)
    return SIDES * STIFFNESS / 2 * (sides**2 + diagonals**2)


def twisted(height):
    """Twist of least energy at a height, and that energy."""
    result = minimize_scalar(
        lambda twist: energy(height, twist), bounds=(0.5, 1.6), method="bounded", options={"xatol": 1e-12}
    )
    return result.x, result.fun


@pytest.fixture(scope="module")
def truss_and_states():
    net = kresling()
    return net, find_stable_states(net, [built_shape(net)], tries=12)


def test_the_truss_has_two_stress_free_states(truss_and_states, agree):
    _, result = truss_and_states
    other = np.pi - STEP - TWIST
    low = np.sqrt(HEIGHT**2 + 2 * RADIUS**2 * (np.cos(other) - np.cos(TWIST)))
    heights = sorted(state.shape.positions[APEX, 2] - RADIUS for state in result.states)
    agree("heights of both states", heights, [low, HEIGHT], unit="m", by="bars of equal length", abs=1e-9)
    agree("energies of both states", [state.energy for state in result.states], 0, unit="J", by="no stress", abs=1e-18)


def test_the_barrier_is_that_of_the_closed_form(truss_and_states, agree):
    net, result = truss_and_states
    saddle = find_saddle(net, *result.states)
    assert saddle is not None
    assert saddle.joins
    top = minimize_scalar(
        lambda height: -twisted(height)[1], bounds=(0.72, 1.29), method="bounded", options={"xatol": 1e-9}
    )
    agree("barrier between them", saddle.rest.energy, -top.fun, unit="J", by="the closed form's top", rel=2 / RIGID)
    height = saddle.rest.shape.positions[APEX, 2] - RADIUS
    agree("height at the barrier", height, top.x, unit="m", by="the closed form's top", abs=1e-4)


def test_the_load_path_follows_the_closed_form_up_to_its_peak(agree):
    net = kresling()
    push = point_forces(net, np.array([APEX]), np.array([[0.0, 0.0, -1.0]]))
    path = load_path(net, built_shape(net), push, step=0.02, target=0.0)
    assert path.ended == "target"  # at the saddle, where no force acts
    assert [event.kind for event in path.events] == ["limit"]

    def force(height):
        return (twisted(height - 1e-5)[1] - twisted(height + 1e-5)[1]) / 2e-5

    heights = np.array([point.shape.positions[SIDES : 2 * SIDES, 2].mean() for point in path.points[1:-1]])
    agree(
        "force on the tower",
        [point.factor for point in path.points[1:-1]],
        [force(height) for height in heights],
        unit="N",
        by="slope of the closed form",
        rel=1e-4,
        abs=1e-3,
        over=("displacement (m)", HEIGHT - heights),
    )
    peak = -minimize_scalar(lambda height: -force(height), bounds=(1.1, 1.29), method="bounded").fun
    agree("limit load", path.events[0].point.factor, peak, unit="N", by="the closed form", rel=1e-4)
