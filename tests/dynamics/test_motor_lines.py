"""Motors whose torque falls with speed: closed forms of a panel of known inertia."""

import math

import numpy as np
import pytest

from forficula.analysis import measure
from forficula.design import load_design, with_values
from forficula.dynamics import compile_model, energy_balance, simulate, stable_timestep, timestep_warnings
from forficula.errors import InputError
from forficula.structure import structure_of

LETTER = load_design("letter-fold")
LENGTH, WIDTH, THICKNESS, DENSITY = 0.05, 0.04, 1e-3, 1000.0
MASS = DENSITY * THICKNESS * LENGTH * WIDTH
TORQUE, SPEED = 7e-4, math.radians(720)
TURN = {"name": "turn", "kind": "torque", "of": "creases", "value": TORQUE, "no_load_speed": SPEED, "rise": 0.0}


def strip(kind="rigid", drive=TURN, **values):
    """Return two panels without springs, the first held."""
    stage = {"name": "turn", "drive": "turn", "until": "time", "hold": 0.0, "time_limit": 0.13}
    changes = {
        "pattern.panels": 2,
        "pattern.panel_lengths": [LENGTH],
        "pattern.width": WIDTH,
        "facet.kind": kind,
        "facet.thickness": THICKNESS,
        "facet.density": DENSITY,
        "crease.stiffness": 0.0,
        "crease.damping": 0.0,
        "crease.rest_angle": 0.0,
        "crease.start": 0.0,
        "crease.fold_limit": None,
        "crease.back_limit": None if kind == "bars" else math.pi / 2,
        "support": [{"of": "facet 0"}],
        "tendon": [],
        "measure": [],
        "drive": [drive],
        "protocol.stages": [stage],
        "protocol.gravity": 0.0,
        "protocol.least_hold": 0.0,
        "protocol.timestep": 2e-4,
        "protocol.sample_interval": 2e-3,
    }
    if kind == "bars":
        changes |= {"facet.youngs_modulus": 2e6, "facet.stretch_damping": 0.0, "facet.bend_stiffness": 10.0}
        changes |= {"protocol.timestep": 5e-5}
    return with_values(LETTER, changes | values)


def turned(inertia, time):
    """Return the angle by I dw/dt = T (1 - w / w0), from rest."""
    scale = inertia * SPEED / TORQUE
    return SPEED * (time - scale * (1 - np.exp(-time / scale)))


@pytest.mark.parametrize(("kind", "inertia"), [("rigid", MASS * LENGTH**2 / 3), ("bars", MASS * LENGTH**2 / 2)])
@pytest.mark.parametrize("way", [1, -1])
def test_a_motor_approaches_its_speed_along_the_closed_form(kind, inertia, way):
    """Inertia: a plate has m L^2 / 3; nodes, each with a third of its triangles, m L^2 / 2."""
    (record,) = simulate([compile_model(strip(kind, TURN | {"value": way * TORQUE}))])
    expected = way * turned(inertia, record.time)
    assert abs(expected[-1]) > 1.0
    angle = record.series["hinge_angle"][:, 0]
    assert angle == pytest.approx(expected, abs=0.01 * abs(expected[-1]))
    balance = energy_balance(record)
    assert balance.residual < 5e-3
    # all of its work is the panel's kinetic energy, without damping
    assert balance.work == pytest.approx(record.series["kinetic_energy"][-1], rel=0.01)
    assert abs(balance.hinge_damping) < 1e-3 * balance.work
    # near its no-load speed there is hardly any power
    power = record.series["motor_power"][:, 0]
    assert 0 < power[-1] < 0.25 * power.max()


def test_a_motor_brakes_a_joint_above_its_no_load_speed():
    slow = TURN | {"no_load_speed": SPEED / 100}
    (record,) = simulate([compile_model(strip("rigid", slow))])
    speed = np.gradient(record.series["hinge_angle"][:, 0], record.time)
    assert speed[-5:] == pytest.approx(SPEED / 100, rel=0.01)


@pytest.mark.parametrize(
    ("drives", "message"),
    [
        ([TURN | {"no_load_speed": 0.0}], r"drive\.0\.no_load_speed: need .*> 0"),
        ([TURN, TURN | {"name": "other", "no_load_speed": 1.0}], r"drive\.1\.no_load_speed: need that of drive\.0"),
        ([{"name": "a", "kind": "rest-angle", "of": "creases", "angle": 1.0, "no_load_speed": 1.0}], "no_load_speed"),
    ],
)
def test_an_impossible_torque_speed_line_is_rejected(drives, message):
    stage = {"name": "wait", "drive": "none", "until": "time", "hold": 0.0, "time_limit": 0.1}
    with pytest.raises(InputError, match=message):
        structure_of(with_values(strip("bars"), {"drive": drives, "protocol.stages": [stage]}))


def test_the_energy_balance_with_motor_lines_closes_for_plates_in_loops():
    """The speed, and so the torque, changes within a Runge-Kutta step."""
    turn = TURN | {"of": "creases", "value": 1e-4, "no_load_speed": math.radians(720)}
    stage = {"name": "turn", "drive": "turn", "until": "time", "hold": 0.0, "time_limit": 0.1}
    values = {"pattern.columns": 2, "pattern.rows": 2, "facet.kind": "rigid", "support": [{"of": "facet 0"}]}
    values |= {"drive": [turn], "measure": [], "protocol.stages": [stage], "protocol.timestep": 2e-4}
    (record,) = simulate([compile_model(with_values(load_design("miura-sheet"), values))])
    free = with_values(record.design, {"drive.turn.no_load_speed": None})
    (unbraked,) = simulate([compile_model(free)])
    balances = [energy_balance(item) for item in (record, unbraked)]
    assert 0 < balances[0].work < 0.9 * balances[1].work
    assert balances[0].residual < 5e-4


def test_a_servo_that_is_too_steep_for_the_timestep_is_named():
    wing = load_design("binder2025")
    (warning,) = timestep_warnings(with_values(wing, {"protocol.no_load_speed": 2.0}))
    assert "is too long" in warning
    assert "no_load_speed" in warning
    assert not timestep_warnings(wing)


@pytest.mark.parametrize("kind", ["rigid", "bars"])
def test_the_longest_timestep_accounts_for_a_steep_torque_speed_line(kind):
    """A step with a damper only reverses the speed where h T / (I w) > 2."""
    steep = TURN | {"value": 100 * TORQUE, "no_load_speed": SPEED / 100}
    longest, flipping = stable_timestep(strip(kind, steep)), 2 * MASS * LENGTH**2 / 3 * SPEED / (1e4 * TORQUE)
    assert longest < 2 * flipping
    assert longest < 0.5 * stable_timestep(strip(kind))


def servo_joint(**values):
    """Return a printed joint that a servo folds from straight, with a slack tendon and without damping."""
    settle = {"name": "settle", "drive": "none", "until": "time", "hold": 0.0, "time_limit": 0.01}
    fold = {"name": "fold", "drive": "fold", "until": "time", "hold": 0.0, "time_limit": 0.2}
    changes = {
        "tendon.stiffness": 1.0,
        "tendon.rest_length": 0.5,
        "tendon.damping": 0.0,
        "hinge.damping": 0.0,
        "hinge.armature": 2e-5,
        "protocol.initial_overbend": 0.0,
        "protocol.fold_torque": 2e-3,
        "protocol.no_load_speed": 10.0,
        "protocol.rise": 0.0,
        "protocol.stages": [settle, fold],
        "protocol.timestep": 1e-4,
    }
    weightless = with_values(load_design("binder2025-joint"), {"tendon.density": 0.0})
    return with_values(weightless, changes | values)


def test_a_servo_turns_a_joint_by_the_closed_form():
    """Inertia of a bar about one end: m L^2 / 3 + m d^2 / 16 across, m d^2 / 8 along; plus the motor's armature."""
    design = servo_joint()
    (record,) = simulate([compile_model(design)])
    length, diameter = design.pattern.distal_length, design.vein.diameter
    mass = design.vein.density * math.pi * diameter**2 / 4 * length
    across, along = math.sin(design.pattern.distal_sector) ** 2, math.cos(design.pattern.distal_sector) ** 2
    inertia = mass * ((length**2 / 3 + diameter**2 / 16) * across + diameter**2 / 8 * along) + design.hinge.armature
    scale = inertia * design.protocol.no_load_speed / design.protocol.fold_torque
    time = np.maximum(record.time - 0.01, 0.0)
    expected = design.protocol.no_load_speed * (time - scale * (1 - np.exp(-time / scale)))
    assert 0.5 < expected[-1] < math.pi
    assert -record.series["hinge_angle"][:, 0] == pytest.approx(expected, abs=0.01 * expected[-1])
    balance = energy_balance(record)
    assert balance.work == pytest.approx(record.series["kinetic_energy"][-1], rel=0.01)
    assert balance.residual < 5e-3


def test_a_servo_folds_a_wing_later_and_with_less_work():
    wing = load_design("binder2025")
    held = with_values(wing, {"protocol.no_load_speed": 35.0})
    free, line = (measure(record) for design in (wing, held) for record in simulate([compile_model(design)]))
    assert line.status == free.status == "folded and opened"
    for name in ("fold", "unfold"):
        assert line.transitions[name].time > 1.2 * free.transitions[name].time
        assert 0 < line.transitions[name].work < 0.5 * free.transitions[name].work
    assert line.energy_balance.residual < wing.protocol.residual_limit
    assert held.hash != wing.hash
