"""Stops of hinges agree with closed forms: rebound, depth, and convergence with the timestep."""

import math

import mujoco
import numpy as np
import pytest

import forficula as ff
from forficula.analysis import Verdict, measure
from forficula.design import with_values
from forficula.dynamics import compile_model
from forficula.study.running.runs import run_each

SPEED = 20.0  # rad/s, of the impact
JOINT = ff.load_design("binder2025-joint", {"hinge.damping": "0 N m s/rad", "hinge.armature": "0 kg m^2"})


def rebound(damping_ratio):
    """Ratio of speeds after and before an impact on a spring and damper that never pull (Schwager, Poeschel 2007).

    They let go where the deceleration ends, not where the depth does: at the phase
    atan2(2 z s, 2 z^2 - 1) with s^2 = 1 - z^2.
    """
    if damping_ratio == 1:
        return math.exp(-2)
    sine = math.sqrt(1 - damping_ratio**2)
    phase = math.atan2(2 * damping_ratio * sine, 2 * damping_ratio**2 - 1)
    return math.exp(-damping_ratio * phase / sine)


def drop(damping_ratio, steps):
    """Drop a joint without a tendon on its stop; return rebound, and depth divided by speed and time constant."""
    values = {"stops.time_constant": "2 ms", "stops.damping_ratio": damping_ratio, "protocol.timestep": 2e-3 / steps}
    model = compile_model(with_values(JOINT, values))
    engine, data, unit = model.engine, mujoco.MjData(model.engine), model.units.time
    engine.tendon_stiffness[:] = engine.tendon_damping[:] = 0
    speed, upper = SPEED * unit, engine.jnt_range[0, 1]
    data.qpos[0], data.qvel[0] = upper - 1.3 * speed * engine.opt.timestep, speed
    deepest = 0.0
    for _ in range(20 * steps):
        mujoco.mj_step(engine, data)
        deepest = max(deepest, data.qpos[0] - upper)
        if data.qpos[0] < upper and data.qvel[0] < 0:
            break
    return -data.qvel[0] / speed, deepest / (SPEED * 2e-3)


@pytest.mark.parametrize("damping_ratio", [0.3, 0.6, 1.0])
def test_the_rebound_of_a_joint_from_its_stop_is_that_of_the_closed_form(damping_ratio, agree):
    result, _ = drop(damping_ratio, 400)
    agree("rebound", result, rebound(damping_ratio), unit="", by="exp(-z phase / sqrt(1 - z^2))", abs=3e-3)


def test_the_depth_of_a_critically_damped_stop_is_proportional_to_speed_and_time_constant(agree):
    agree("depth divided by v T", drop(1.0, 400)[1], math.exp(-1), unit="", by="1 / e", rel=5e-3)


def test_four_steps_per_time_constant_are_close_to_the_closed_form(holds):
    result = [abs(drop(ratio, 4)[0] - rebound(ratio)) for ratio in (0.6, 1.0)]
    holds("error of the rebound", max(result), below=0.06, by="closed form")


def test_the_reference_opens_in_the_same_time_at_every_timestep(holds):
    steps = ("0.2 ms", "0.1 ms", "0.05 ms")
    designs = [ff.load_design("binder2025", {"protocol.timestep": step}) for step in steps]
    outcomes = [measure(record) for _, record in sorted(run_each(designs, sparse=True), key=lambda pair: pair[0])]
    assert [outcome.verdict for outcome in outcomes] == [Verdict.REACHED] * 3
    for name, resolution in (("fold", 1e-3), ("unfold", 2e-4)):
        times = np.array([outcome.transitions[name].time for outcome in outcomes])
        holds(f"scatter of the {name} time", float(np.ptp(times)), below=resolution, by="the same time, s")


def test_a_run_with_unresolved_stops_is_unreliable_and_names_both_keys():
    outcome = ff.measure(ff.run(ff.load_design("binder2025", {"stops.time_constant": "0.4 ms"}), confirm=False))
    assert outcome.verdict is Verdict.UNTRUSTED
    for said in ("protocol.timestep of 0.2 ms", "stops.time_constant of 0.4 ms", "need <= 0.1 ms"):
        assert said in outcome.status


def test_stops_do_not_depend_on_the_timestep():
    models = [
        compile_model(ff.load_design("binder2025", {"protocol.timestep": item})) for item in ("0.2 ms", "0.05 ms")
    ]
    first, second = (model.engine.jnt_solref * [model.units.time, 1] for model in models)
    assert np.array_equal(first, second)
    assert np.allclose(first[:, 0], 1e-3)
    limits = [
        model.engine.tendon_solref_lim[model.engine.tendon_limited == 1, 0] * model.units.time for model in models
    ]
    assert np.allclose(limits, 1e-3)
