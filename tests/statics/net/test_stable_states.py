"""Searches for stable states, saddles and holding torques, on a panel that a tendon snaps across its crease."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import minimize_scalar
from scipy.spatial.transform import Rotation

from forficula.errors import InputError
from forficula.material.law.tendon_law import ElasticLaw
from forficula.statics.net.collapse import collapse, holding_torque
from forficula.statics.net.energy import built_shape, expand, shape_at
from forficula.statics.net.factor import as_dense
from forficula.statics.net.load import crease_torques
from forficula.statics.net.minimum import minimum
from forficula.statics.net.net import Tendons
from forficula.statics.net.saddle import Saddle, find_saddle
from forficula.statics.net.stable_states import by_energy, find_stable_states, same_shape
from tests.statics.net.nets import miura, sheet

STIFFNESS, PULL, REST = 0.2, 2.0, 1.2  # N m/rad, N/m, m
ANCHOR = np.array([0.5, -0.8, -0.4])


def panel():
    """Return a panel of height 1 on a held edge; a tendon pulls its corner across the edge: the crease snaps."""
    nodes = np.array([(0, 0, 0), (1, 0, 0), (0.5, 1, 0), (0.5, -1, 0), ANCHOR])
    net = sheet(nodes, [(0, 1, 2), (1, 0, 3)], crease=STIFFNESS, axial=1e6, held=[0, 1, 3, 4])[0]
    law = ElasticLaw(rest_length=np.array([REST]), linear=np.array([PULL]))
    return replace(net, tendons=Tendons(points=np.array([[2, 4]]), law=law))


def energy(angle):
    """Return the energy of crease and tendon as a function of the fold angle."""
    length = np.linalg.norm(np.array([0.5, np.cos(angle), np.sin(angle)]) - ANCHOR)
    return STIFFNESS * angle**2 / 2 + PULL * max(length - REST, 0) ** 2 / 2


def torque(angle):
    return (energy(angle + 1e-5) - energy(angle - 1e-5)) / 2e-5


def least(sign, low, high, of=energy):
    minimum = minimize_scalar(lambda x: sign * of(x), bounds=(low, high), method="bounded", options={"xatol": 1e-10})
    return minimum.x, sign * minimum.fun


@pytest.fixture(scope="module")
def search():
    net = panel()
    return net, find_stable_states(net, [built_shape(net)], tries=24)


def test_the_search_finds_both_states_of_the_closed_form(search):
    _, states = search
    known = sorted((least(1, -np.pi, 0.3), least(1, 0.6, np.pi)), key=lambda item: item[1])
    assert len(states.states) == 2
    for state, (angle, stored) in zip(states.states, known, strict=True):
        assert state.stable
        # bars are 1e6 times stiffer than the tendon
        assert state.shape.angles[0] == pytest.approx(angle, abs=1e-5)
        assert state.energy == pytest.approx(stored, rel=1e-5)
    assert sum(states.counts) + states.failed == states.tries + 1


def test_the_same_seed_finds_the_same(search):
    net, states = search
    again = find_stable_states(net, [built_shape(net)], tries=24)
    assert [state.energy for state in again.states] == [state.energy for state in states.states]
    assert again.counts == states.counts


def test_the_saddle_is_the_top_between_them(search):
    net, states = search
    saddle = find_saddle(net, *states.states)
    assert saddle is not None
    assert saddle.joins
    angle, top = least(-1, 0.1, 1.0)
    assert saddle.rest.shape.angles[0] == pytest.approx(angle, abs=1e-5)
    assert saddle.barriers == pytest.approx([top - state.energy for state in states.states], rel=1e-4)


def test_a_saddle_that_is_known_is_not_descended_from_again(search, monkeypatch):
    net, states = search
    known = list[Saddle]()
    first = find_saddle(net, *states.states, known=known)
    assert [saddle.rest for saddle in known] == [first.rest]
    monkeypatch.setattr("forficula.statics.net.saddle.minimum", None)  # it would be called for a descent
    again = find_saddle(net, *states.states[::-1], known=known)
    assert len(known) == 1
    assert again.joins
    assert again.barriers == first.barriers[::-1]


def test_states_of_equal_energy_keep_their_order():
    assert by_energy([2.0, 1.0 + 1e-12, 3.0, 1.0]) == [1, 3, 0, 2]
    assert by_energy([0.0, 0.0]) == [0, 1]
    assert by_energy([]) == []


def test_the_torque_that_holds_is_the_steepest_slope(search):
    net, states = search
    valley = max(states.states, key=lambda state: state.shape.angles[0])
    between = np.linspace(least(-1, 0.1, 1.0)[0], valley.shape.angles[0], 4001)
    lost = holding_torque(net, valley, 0, sense=-1)
    assert lost.kind == "limit"
    assert lost.factor == pytest.approx(-min(torque(angle) for angle in between), rel=1e-4)
    assert holding_torque(net, valley, 0, increments=20).kind == "none"


def test_only_stable_states_collapse(search):
    net, states = search
    with pytest.raises(InputError, match="state: need a stable one, got one with 1 ways downhill"):
        collapse(net, replace(states.states[0], index=1), crease_torques(net, np.array([0]), 1.0))


def test_a_free_sheet_has_states_that_saddles_join():
    net, flat = sheet(*miura(4, 4, fold=0.6), facet=10.0)
    law = replace(net.creases.law, rest_angle=np.where(flat, 0.0, built_shape(net).angles))
    net = replace(net, creases=replace(net.creases, law=law))
    states = find_stable_states(net, [built_shape(net)], tries=12).states
    assert len(states) > 1
    saddle = find_saddle(net, states[0], states[1])
    assert saddle is not None
    assert saddle.joins
    assert min(saddle.barriers) > 0
    values = np.linalg.eigvalsh(as_dense(expand(net, saddle.rest.shape).free))
    assert np.count_nonzero(values < -1e-6) == 1
    assert np.abs(expand(net, saddle.rest.shape).slope).max() < 1e-6


def test_a_shape_moved_as_a_whole_is_the_same_and_its_mirror_image_is_not():
    net = sheet(*miura(2, 2, fold=0.5))[0]
    shape = built_shape(net)
    turn = Rotation.from_euler("xyz", (0.3, 1.0, -2.0)).as_matrix()
    assert same_shape(net, shape, shape_at(net, net.nodes @ turn.T + (3, 2, 1), shape.angles))
    assert not same_shape(net, shape, shape_at(net, net.nodes * (1, 1, -1)))
    held = sheet(*miura(2, 2, fold=0.5), held=[0, 1, 3])[0]
    assert not same_shape(held, shape, shape_at(net, net.nodes + np.array((0.1, 0, 0)), shape.angles))


def test_a_panel_that_went_through_the_other_is_another_state():
    net = panel()
    shape = minimum(net, built_shape(net)).shape
    assert not same_shape(net, shape, replace(shape, angles=shape.angles + 2 * np.pi))
