"""Load paths: what ends them, and what they report; cases with closed forms are in tests/validation."""

import time
from dataclasses import replace

import numpy as np
import pytest

from forficula.errors import InputError
from forficula.statics.net.energy import built_shape, expand, shape_at
from forficula.statics.net.load import crease_torques, no_load, point_forces
from forficula.statics.net.load_path import load_path
from tests.statics.net.nets import miura, sheet, truss

NET = truss([[-1, 0, 0], [0, 0, 0.3], [1, 0, 0]], [[0, 1], [1, 2]], stiffness=1e3, held=[0, 2, (1, 1)])
PUSH = point_forces(NET, np.array([1]), np.array([[0.0, 0.0, -1.0]]))


def test_a_path_ends_exactly_at_its_target():
    path = load_path(NET, built_shape(NET), PUSH, target=5.0)
    assert path.ended == "target"
    assert path.points[-1].factor == 5.0
    assert np.abs(expand(NET, path.points[-1].shape, PUSH, 5.0).slope[NET.free]).max() < 1e-9
    assert not path.events


def test_a_path_ends_after_its_increments_at_its_stop_and_at_the_first_event():
    assert len(load_path(NET, built_shape(NET), PUSH, increments=7).points) == 8
    stopped = load_path(NET, built_shape(NET), PUSH, stop=lambda point: point.factor > 5.0)
    assert stopped.ended == "stop"
    assert stopped.points[-2].factor <= 5.0 < stopped.points[-1].factor
    assert len(load_path(NET, built_shape(NET), PUSH, events=1).events) == 1


def test_a_path_without_events_has_the_same_points():
    path = load_path(NET, built_shape(NET), PUSH, increments=60)
    plain = load_path(NET, built_shape(NET), PUSH, increments=60, locate_events=False)
    assert {event.kind for event in path.events} == {"limit"}
    assert plain.events == ()
    assert [point.factor for point in plain.points] == [point.factor for point in path.points]


def test_the_limit_is_where_the_load_is_largest():
    (event,) = load_path(NET, built_shape(NET), PUSH, events=1).events
    # the force of two bars of stiffness k and length L at a height h: 2 k (L / l - 1) h with l^2 = 1 + h^2
    heights = np.linspace(0, 0.3, 100_001)
    forces = 2e3 * (np.hypot(1, 0.3) / np.hypot(1, heights) - 1) * heights
    assert event.point.factor == pytest.approx(forces.max(), rel=1e-8)
    assert event.point.shape.positions[1, 2] == pytest.approx(heights[np.argmax(forces)], abs=1e-5)


def test_a_path_back_from_a_state_under_load_leads_to_the_state_without():
    present = load_path(NET, built_shape(NET), PUSH, target=8.0).points[-1]
    back = load_path(NET, present.shape, PUSH, factor=8.0, target=0.0, rising=False)
    np.testing.assert_allclose(back.points[-1].shape.positions, NET.nodes, atol=1e-9)


def test_points_do_not_depend_on_the_length_of_the_increments():
    ends = [load_path(NET, built_shape(NET), PUSH, target=9.0, step=step).points[-1] for step in (0.003, 0.05)]
    np.testing.assert_allclose(ends[0].shape.positions, ends[1].shape.positions, atol=1e-9)


def test_torques_fold_a_free_sheet_which_turns_with_them():
    net, flat = sheet(*miura(3, 3, fold=0.5))
    angles = built_shape(net).angles
    law = replace(net.creases.law, rest_angle=np.where(flat, 0.0, angles))
    net = replace(net, creases=replace(net.creases, law=law))
    load = crease_torques(net, np.flatnonzero(~flat), 0.1 * np.sign(angles[~flat]))
    path = load_path(net, built_shape(net), load, increments=20)
    assert len(path.pins) == 6
    assert all(point.index == 0 for point in path.points)
    energies = [point.energy for point in path.points]
    assert np.all(np.diff(energies) > 0)
    for point in path.points:
        # without pins there is no reaction: the torques are in balance
        assert np.abs(expand(net, point.shape, load, point.factor).slope).max() < 1e-6


def test_a_sheet_of_961_nodes_goes_a_hundred_increments_in_a_minute():
    net, flat = sheet(*miura(30, 30, fold=0.6))
    angles = built_shape(net).angles
    law = replace(net.creases.law, rest_angle=np.where(flat, 0.0, angles))
    net = replace(net, creases=replace(net.creases, law=law))
    load = crease_torques(net, np.flatnonzero(~flat), 0.1 * np.sign(angles[~flat]))
    began = time.process_time()
    path = load_path(net, built_shape(net), load, increments=10)
    assert time.process_time() - began < 6  # 1.5 s on one core
    assert all(point.index == 0 for point in path.points)


@pytest.mark.parametrize("step", [0.02, 0.1, 0.3])
def test_a_panel_that_locks_is_not_led_through_the_one_it_meets(step):
    # a panel, built at right angles to the other, is pressed onto it; its spring locks from 135 deg
    net, _ = sheet([[0, 0, 0], [0, 1, 0], [-1, 0.5, 0], [0, 0.5, 1]], [(0, 1, 2), (1, 0, 3)], held=[0, 1, 2])
    law = replace(net.creases.law, rest_angle=np.pi / 2, lock_above=np.deg2rad(135))
    net = replace(net, creases=replace(net.creases, law=law))
    push = point_forces(net, np.array([3]), np.array([[-1.0, 0.0, -0.2]]))
    path = load_path(net, built_shape(net), push, step=step, increments=120)
    angles = np.array([point.shape.angles[0] for point in path.points])
    assert np.all(np.isfinite([point.energy for point in path.points]))
    assert np.all(np.diff(angles) > 0)
    assert np.deg2rad(160) < angles[-1] < np.pi


def test_energy_is_the_work_of_the_load():
    path = load_path(NET, built_shape(NET), PUSH, step=0.001, increments=300)
    down = np.array([0.3 - point.shape.positions[1, 2] for point in path.points])
    work = np.trapezoid([point.factor for point in path.points], down)
    assert work == pytest.approx(path.points[-1].energy, rel=2e-5)  # trapezoidal rule


@pytest.mark.parametrize(
    ("start", "load", "rule"),
    [
        (built_shape(NET), no_load(NET), "load: need one that acts, got none"),
        (shape_at(NET, NET.nodes * (1, 1, 0.61)), PUSH, "start: need a shape at rest"),
    ],
)
def test_loads_that_do_not_move_the_net_are_rejected(start, load, rule):
    net = replace(NET, springs=replace(NET.springs, stiffness=0 * NET.springs.stiffness)) if "start" in rule else NET
    with pytest.raises(InputError, match=rule):
        load_path(net, start, load, factor=1.0)
