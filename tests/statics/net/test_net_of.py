"""Conversion of structures of sliding points to nets: parts and signs."""

import numpy as np
import pytest

from forficula.design import load_design, with_values
from forficula.errors import InputError
from forficula.statics.net.energy import expand, shape_at
from forficula.statics.net.net_of import bends, is_net, motor_load, net_of, own_angles, start_shape, valley_law
from forficula.structure import built_creases, structure_of

MIURA = structure_of(load_design("miura-sheet"))
KRESLING = structure_of(load_design("kresling-cell"))
DRIVE = {"name": "fold", "kind": "torque", "of": "creases", "value": 2e-3, "rise": 0.1}


def test_nodes_masses_and_supports_are_those_of_the_bodies():
    net = net_of(MIURA)
    bodies = len(MIURA.bodies)
    assert net.masses[:bodies] == pytest.approx([body.mass for body in MIURA.bodies])
    assert [tuple(np.flatnonzero(free)) for free in net.free[:bodies]] == [body.slides for body in MIURA.bodies]


def test_points_on_the_ground_neither_move_nor_make_the_net_larger():
    net = net_of(KRESLING)
    ground = [number for number, point in enumerate(KRESLING.points) if point.role == "ground"]
    assert ground
    assert not net.free[ground].any()
    assert net.size == pytest.approx(KRESLING.span)


def test_angles_count_in_the_sense_of_each_crease():
    net = net_of(MIURA)
    shape = start_shape(MIURA, net)
    assert own_angles(MIURA, shape) == pytest.approx(built_creases(MIURA))
    creases = ~bends(MIURA)
    # creases are folded as assigned: mountain angles have the opposite sign of valley angles
    assert (own_angles(MIURA, shape)[creases] > 0).all()
    assert {float(np.sign(angle)) for angle in shape.angles[creases]} == {-1.0, 1.0}


def test_nothing_is_stored_where_springs_rest_as_built():
    net = net_of(MIURA)
    present = expand(net, start_shape(MIURA, net))
    assert present.stored == pytest.approx(0.0, abs=1e-20)
    assert np.abs(present.slope).max() < 1e-12


def test_laws_of_mountains_are_those_of_valleys_seen_from_behind():
    limits = {"crease.fold_limit": 2.5, "crease.back_limit": 0.2, "crease.law": "locking", "crease.lock_angle": 1.2}
    structure = structure_of(with_values(load_design("miura-sheet"), limits))
    law = valley_law(structure)
    for number, hinge in enumerate(structure.hinges):
        ends = sorted([hinge.sense * hinge.lower, hinge.sense * hinge.upper])
        locks = sorted([hinge.sense * hinge.lock_below, hinge.sense * hinge.lock_above])
        assert [law.lower[number], law.upper[number]] == pytest.approx(ends)
        assert [law.lock_below[number], law.lock_above[number]] == pytest.approx(locks)
        assert law.rest_angle[number] == pytest.approx(hinge.sense * hinge.rest_angle)


def test_springs_that_rest_further_on_push_as_the_torque_does_that_their_law_has():
    """For a linear and a locking law: moment(angle, shift) is the moment less stiffness x shift."""
    net = net_of(MIURA)
    motors = [motor.kind for motor in MIURA.motors]
    assert motors == ["rest-angle"]
    load = motor_load(MIURA, net, (0.3,))
    motor, law = MIURA.motors[0], net.creases.law
    senses = np.array([hinge.sense for hinge in MIURA.hinges])
    further = np.zeros(len(senses))
    further[list(motor.hinges)] = 0.3 * np.array(motor.gains or 1.0) * senses[list(motor.hinges)]
    angles = np.random.default_rng(0).uniform(-3, 3, len(senses))
    assert law.moment(angles) - load.torques == pytest.approx(law.moment(angles, further), rel=1e-12, abs=1e-18)


def test_torques_fold_and_forces_push_where_their_motors_say():
    driven = {"drive": [DRIVE], "protocol.stages": [{**STAGE, "drive": "fold"}]}
    structure = structure_of(with_values(load_design("miura-sheet"), driven))
    net = net_of(structure)
    load = motor_load(structure, net, (2e-3,))
    creases = ~bends(structure)
    assert (load.torques[creases] * start_shape(structure, net).angles[creases] > 0).all()
    assert np.abs(load.torques[creases]) == pytest.approx(2e-3)
    push = motor_load(KRESLING, net_of(KRESLING), (1.0, 0.0))
    assert push.forces.sum(axis=0) == pytest.approx([0, 0, -6])


STAGE = {"name": "fold", "until": "time", "hold": 0.0, "time_limit": 1.0}


def test_the_slope_of_the_energy_is_its_change():
    structure = structure_of(with_values(load_design("bistable-clasp"), {"protocol.gravity": 9.81}))
    net = net_of(structure)
    random = np.random.default_rng(1)
    places = net.nodes + 0.01 * net.size * random.standard_normal(net.nodes.shape)
    present, way = shape_at(net, places), random.standard_normal(net.nodes.shape)
    step = 1e-7
    ends = [expand(net, shape_at(net, places + sign * step * way, present.angles)).stored for sign in (1, -1)]
    assert (ends[0] - ends[1]) / (2 * step) == pytest.approx(np.sum(expand(net, present).slope * way), rel=1e-6)


def test_bodies_on_joints_are_not_a_net():
    structure = structure_of(load_design("letter-fold"))
    assert not is_net(structure)
    with pytest.raises(InputError, match="letter-fold: need points that slide and springs between them, got joints"):
        net_of(structure)
