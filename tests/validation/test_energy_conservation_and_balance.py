"""Energy is conserved without dissipation, and the energy balance closes with dissipation.

Semi-implicit Euler is symplectic and of order one (Hairer, Lubich, Wanner, Geometric Numerical Integration, 2006, I.1
and IX.8): its energy error is proportional to the timestep and does not grow.
"""

import math
import warnings

import numpy as np
import pytest

import forficula as ff
from forficula.design import with_values
from forficula.dynamics import compile_model, simulate
from tests.structures import motor_work

TIMESTEPS = [2e-4, 1e-4, 5e-5, 2.5e-5]  # s
STORED = ("tendon_energy", "membrane_energy", "kinetic_energy")
TAKEN = ("hinge_damping_work", "elastic_damping_work", "stop_work")
# no guard and freely turning joints: a structure released for some ms meets no stop
NO_STOPS = {"guard.stretch": 1e3, "hinge.turn_limit": math.pi, "hinge.turn_back": math.pi}
NO_DAMPING = {"hinge.damping": 0.0, "tendon.damping": 0.0, "membrane.damping": 0.0}
FREE = [{"name": "let go", "drive": "none", "until": "time", "hold": 0.0, "time_limit": 0.012}]


def stored(record):
    return sum(record.data[name].values.reshape(len(record.data["time"]), -1).sum(axis=1) for name in STORED)


def order(errors):
    return np.polyfit(np.log(TIMESTEPS), np.log(errors), 1)[0]


def release(reference, values):
    """The wing, bent by 20 deg at every distal hinge and released for 12 ms, at every timestep."""
    bent = {**NO_STOPS, **values, "protocol.initial_overbend": math.radians(-20), "protocol.stages": FREE}
    designs = [
        with_values(reference, {**bent, "protocol.timestep": timestep, "protocol.sample_interval": timestep})
        for timestep in TIMESTEPS
    ]
    with warnings.catch_warnings():
        # MuJoCo warns that a flex without damping has no forces; its elasticity acts nevertheless
        warnings.filterwarnings("ignore", message="flex 'membrane' is not rigid")
        wings = [compile_model(design) for design in designs]
    return simulate(wings)


@pytest.fixture(scope="module")
def free_runs(reference):
    return release(reference, NO_DAMPING)


@pytest.fixture(scope="module")
def damped_runs(reference):
    return release(reference, {})


@pytest.fixture(scope="module")
def every_step(reference):
    """The reference with every step recorded."""
    return ff.run(with_values(reference, {"protocol.sample_interval": reference.protocol.timestep}), confirm=False)


@pytest.mark.parametrize("rest_length", [0.0, 0.06])
def test_an_undamped_hinge_conserves_energy_to_the_order_of_the_integrator(agree, holds, one_hinge, rest_length):
    drifts = []
    for timestep in TIMESTEPS:
        # ends before 180 deg
        duration = {0.0: 0.0145, 0.06: 0.022}[rest_length]
        angles, record = one_hinge(rest_length, timestep=timestep, duration=duration).run()
        assert math.radians(90) < angles[-1] < math.pi
        energy = stored(record)
        drifts.append(np.abs(energy - energy[0]).max() / energy[0])
    agree("order of the drift in the timestep", order(drifts), 1, by="symplectic Euler", abs=0.2)
    holds("drift of the energy at 25 µs", drifts[-1], below=5e-3, by="conservation of energy")


def test_an_undamped_wing_conserves_energy_to_the_order_of_the_integrator(agree, free_runs):
    drifts = []
    for record in free_runs:
        # it moves, by elasticity and inertia only
        assert record.data["kinetic_energy"].values.max() > 0.05 * stored(record)[0]
        assert all(np.abs(record.data[name].values).max() == 0 for name in (*TAKEN, "motor_work"))
        drifts.append(np.abs(stored(record) - stored(record)[0]).max() / stored(record)[0])
    agree("order of the drift in the timestep", order(drifts), 1, by="symplectic Euler", abs=0.2)


def test_with_damping_the_lost_energy_is_the_work_of_the_dampers(holds, damped_runs):
    residuals = []
    for record in damped_runs:
        taken = -sum(record.data[name].values[-1] for name in TAKEN)
        assert taken > 0.01 * stored(record)[0]
        residuals.append(abs(stored(record)[0] - stored(record)[-1] - taken) / stored(record)[0])
    holds("order of the missing energy in the timestep", order(residuals), above=0.8, by="symplectic Euler has 1")
    holds("missing energy at 0.2 ms", residuals[0], below=5e-3, by="conservation of energy")


def test_the_energy_balance_of_the_reference_closes(holds, reference_outcome):
    # hinges meet the stops within one step, which sets the error: 0.5 % at 0.2 ms
    residual = reference_outcome.energy_balance.residual
    holds("missing energy", residual, below=5e-3, by="conservation of energy")


def test_the_energy_balance_is_the_sum_of_its_parts(agree, reference_run, reference_outcome):
    work = reference_run.work[-1]
    taken = sum(reference_run.data[name].values[-1] for name in TAKEN)
    change = stored(reference_run)[-1] - stored(reference_run)[0]
    # rounding of sums over 1e4 steps
    missing, known = reference_outcome.energy_balance.missing, work + taken - change
    agree("missing energy", 1e3 * missing, 1e3 * known, unit="mJ", by="sum of the record", abs=1e-8 * work)


@pytest.mark.parametrize("rest_length", [0.0, 0.06])
def test_force_times_mean_velocity_gives_the_kinetic_energy_and_the_later_velocity_deviates_by_half_a_step(
    agree, holds, one_hinge, rest_length
):
    excess = []
    for timestep in TIMESTEPS:
        hinge = one_hinge(rest_length, timestep=timestep, duration=0.0125)
        angles, record = hinge.run()
        later = np.diff(angles) / timestep
        earlier = np.concatenate([[0.0], later[:-1]])
        moment = hinge.moment(angles[:-1])
        kinetic = record.data["kinetic_energy"].values[-1]
        by_mean = np.sum(moment * timestep * (earlier + later) / 2)
        # rounding of angles of 1e-17 rad over steps of 1e-5 rad
        agree("work of the tendon", 1e3 * by_mean, 1e3 * kinetic, unit="mJ", by="kinetic energy", rel=1e-9)
        excess.append(np.sum(moment * timestep * later) / kinetic - 1)
    holds("deviation with the later velocity", min(excess), above=0)
    agree("order of this deviation in the timestep", order(excess), 1, by="half a step", abs=0.2)


def test_the_work_of_a_constant_torque_is_torque_times_the_angle_turned(agree, every_step):
    """The tolerance is half a step: torque times timestep times half the change of speed."""
    protocol = every_step.design.protocol
    step = float(protocol.timestep)
    torques = {
        "fold": {"proximal": protocol.fold_torque, "distal": 0.0},
        "unfold": {"proximal": -protocol.unfold_torque, "distal": protocol.unfold_torque},
        "none": {"proximal": 0.0, "distal": 0.0},
    }
    angles = {"proximal": every_step.angles("turn"), "distal": every_step.angles("ring")}
    assert [end.stage.drive for end in every_step.stages] == ["none", "fold", "none", "unfold", "none"]
    for end in every_step.stages:
        first, last = round(end.start / step), round(end.end / step)
        for name, angle in angles.items():
            torque = torques[end.stage.drive][name]
            turned = (angle[last] - angle[first]).sum()
            speed_before = (angle[first] - angle[max(first - 1, 0)]).sum() / step
            speed_after = (angle[last] - angle[last - 1]).sum() / step
            done = motor_work(every_step, name)
            work = done[last] - done[first]
            # rounding of a sum over 1e4 steps
            known = torque * (turned - step / 2 * (speed_after - speed_before))
            agree("work of torques", work, known, unit="J", by="torque times angle", abs=1e-10 * protocol.unfold_torque)
            assert abs(work - torque * turned) <= abs(torque) * step / 2 * abs(speed_after - speed_before) + 1e-10


def test_power_is_the_time_derivative_of_work(agree, every_step):
    series, step = every_step.series, float(every_step.design.protocol.timestep)
    # rounding of the work, 1e-15 of 10 J, over one step
    rates = np.diff(series["motor_work"], axis=0) / step
    assert series["motor_power"].shape == (len(every_step.time), 2)
    agree("power of the motors", series["motor_power"][:-1], rates, unit="W", by="differences of work", abs=1e-8)
