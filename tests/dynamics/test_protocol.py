"""Rising torques, goals that must hold for a while, and angles far beyond a stop."""

import math
from dataclasses import replace

import numpy as np
import pytest

import forficula as ff
from forficula.design import StageSection, with_values
from forficula.dynamics import compile_model, energy_balance, simulate
from forficula.dynamics.stepping.stage_plan import stage_torques
from forficula.dynamics.stepping.stages import StageTracker
from forficula.dynamics.stepping.steps import Steps
from forficula.structure import hinges_of
from tests.dynamics.protocols import on_protocol

OPEN = StageSection(name="open", drive="unfold", until="time", hold="0 s", time_limit="1 s")
FOLD = StageSection(name="fold", drive="fold", until="folded", hold="0 s", time_limit="0.15 s")
TORQUE = 0.02  # N m


def through(hinge, stage, **protocol):
    """Return a hinge with a protocol of one stage, which no design file can express."""
    changed = hinge.wing.design.protocol.model_copy(update={"stages": (stage,), **protocol})
    design = hinge.wing.design.model_copy(update={"protocol": changed})
    return replace(hinge, wing=on_protocol(hinge.wing, design))


def pushed(one_hinge, rise, duration):
    """Return a hinge with a slack tendon, folded by 60 deg, that a torque opens."""
    # the tendon's largest length
    hinge = one_hinge(0.11, start=math.radians(60), timestep=1e-4)
    return through(hinge, OPEN.model_copy(update={"time_limit": duration}), rise=rise, unfold_torque=TORQUE)


@pytest.mark.parametrize("share", [0.25, 0.5, 1.0, 1.5])
def test_a_rising_torque_gives_the_impulse_and_travel_of_its_ramp(one_hinge, share):
    """I w = T t^2 / (2 rise) up to the end of the ramp and T (t - rise / 2) after it, with w = 0 at the start."""
    rise = 0.04
    time = share * rise
    hinge = pushed(one_hinge, rise, time)
    angles, record = hinge.run()
    impulse = TORQUE * (time**2 / (2 * rise) if share <= 1 else time - rise / 2)
    speed = impulse / hinge.inertia
    # every step has the torque of its midpoint, so the sum over a ramp is exact
    assert record.series["kinetic_energy"][-1] == pytest.approx(hinge.inertia * speed**2 / 2, rel=1e-9)
    # half of the rise, half of the torque
    torque = TORQUE * min(share, 1.0)
    assert record.series["motor_power"][-1].sum() == pytest.approx(torque * speed, rel=1e-9)
    way = (min(time, rise) ** 3 / (6 * rise) + max(time - rise, 0) * time / 2) * TORQUE / hinge.inertia
    # the travel's error is of first order in the timestep
    assert angles[0] - angles[-1] == pytest.approx(way, rel=0.02)


def test_the_work_of_a_torque_that_rises_is_the_energy_of_what_it_moves(one_hinge):
    _, record = pushed(one_hinge, 0.04, 0.05).run()
    balance = energy_balance(record)
    assert balance.work > 0
    assert balance.kinetic == pytest.approx(balance.work, rel=1e-9)
    assert balance.residual < 1e-9


@pytest.fixture(scope="module")
def short(reference):
    stages = [stage.model_dump() for stage in reference.protocol.stages[:2]]
    stages[0]["time_limit"] = 0.02
    stages[1]["time_limit"] = 0.3
    return with_values(reference, {"protocol.stages": stages})


def test_the_balance_of_a_wing_closes_when_its_torques_rise(short):
    at_once, slowly = (
        ff.measure(ff.run(with_values(short, {"protocol.rise": rise}), confirm=False)) for rise in ("0 s", "0.1 s")
    )
    assert slowly.holds["folded"]
    assert slowly.ending.residual < 0.005
    assert at_once.transitions["fold"].time < slowly.transitions["fold"].time
    assert 0 < slowly.transitions["fold"].work < at_once.transitions["fold"].work


def test_without_a_rise_every_step_has_the_torque_of_its_stage_to_the_bit(short):
    wing = compile_model(with_values(short, {"protocol.fold_torque": 0.3, "protocol.rise": 0.0}))
    tracker = StageTracker([wing])
    tracker.stage[:] = 1
    torques = tracker.torques(np.array([0]), 7)
    ((fold, rise),) = stage_torques(wing, short.protocol.stages[1])
    assert rise == 0.0
    assert torques.tolist() == [[list(fold)] * 7]


def test_a_rise_begins_anew_with_every_stage(short):
    wing = compile_model(with_values(short, {"protocol.rise": "10 ms", "protocol.timestep": "1 ms"}))
    tracker = StageTracker([wing])
    tracker.stage[:], tracker.stage_start[:], tracker.steps[:] = 1, 30, 34
    (((fold, _), rise),) = stage_torques(wing, short.protocol.stages[1])
    assert rise == 0.01
    shares = tracker.torques(np.array([0]), 8)[0, :, 0] / fold
    assert shares == pytest.approx([0.45, 0.55, 0.65, 0.75, 0.85, 0.95, 1, 1], rel=1e-12)


def held_since(angles, timestep, folded, least_hold):
    """Return when the hinge folded to stay (for a share of the elapsed time), s, and when that was found; or None."""
    since = None
    for number, angle in enumerate(angles):
        if angle < folded:
            since = None
            continue
        since = number if since is None else since
        if number - since >= least_hold * since:
            return since * timestep, number * timestep
    return None


@pytest.mark.parametrize("least_hold", [0.0, 0.05, 0.25, 1.0, 3.0])
def test_a_goal_that_is_met_for_an_instant_only_does_not_end_a_stage(one_hinge, least_hold):
    """An undamped hinge snaps past 150 deg and bounces back from its stop to less."""
    timestep = 1e-4

    hinge = one_hinge(0.03, timestep=timestep, start=math.radians(10))
    angles, _ = through(hinge, FOLD.model_copy(update={"until": "time"})).run()
    _, record = through(hinge, FOLD, least_hold=least_hold).run()
    (end,) = record.stages
    expected = held_since(angles, timestep, record.design.protocol.folded_angle, least_hold)
    if expected is None:
        assert (end.goal_time, end.end) == (None, pytest.approx(0.15))
    else:
        assert (end.goal_time, end.end) == pytest.approx(expected, abs=1e-9)


def test_bounces_are_what_the_least_hold_is_for(one_hinge):
    """The instant at which the hinge first passes 150 deg meets a goal without hold, not one with a long hold."""
    ends = []
    for hold in (0.0, 3.0):
        _, record = through(one_hinge(0.03, timestep=1e-4, start=math.radians(10)), FOLD, least_hold=hold).run()
        ends.append(record.stages[0].goal_time)
    assert ends[0] is not None
    assert ends[1] is None or ends[1] > ends[0]


def test_a_hold_scales_with_the_wing_and_not_with_a_stage_that_waits(short):
    """Stages that end by rest or by time do not wait for a share of it."""
    settling = [short.protocol.stages[0].model_dump() | {"until": "rest", "hold": 0.01, "time_limit": 1.0}]
    runs = [
        ff.run(with_values(short, {"protocol.stages": settling, "protocol.least_hold": hold}), confirm=False)
        for hold in (0.0, 10.0)
    ]
    assert runs[0].stages[0].end == runs[1].stages[0].end < 1.0


@pytest.mark.parametrize(("beyond", "diverged"), [(44.9, False), (45.1, True)])
def test_a_hinge_more_than_45_deg_beyond_its_stop_is_a_divergence(short, beyond, diverged):
    wing = compile_model(short)
    tracker, count = StageTracker([wing]), 3
    position = np.zeros((1, count, wing.engine.nv))
    fold = hinges_of(wing.structure, "ring")[1]
    # the overbend's stop, in the hinge's own sense
    position[0, 1, fold] = wing.folds.senses[fold] * (short.hinge.overbend + math.radians(beyond))
    time = wing.timestep * np.arange(1, count + 1)[None, :, None]
    steps = Steps(
        positions=wing.engine.nq,
        dof=wing.engine.nv,
        inner={},
        before=np.zeros((1, 1 + 2 * wing.engine.nv)),
        after=np.concatenate([time, position, np.zeros_like(position)], axis=2),
        derived={"ten_length": np.zeros((1, count, wing.engine.ntendon))},
        kept=(),
    )
    taken = tracker.follow(np.array([0]), steps)
    assert taken.tolist() == [1 if diverged else count]
    assert (tracker.diverged_at[0] is not None) == diverged
    if diverged:
        assert tracker.diverged_at[0] == pytest.approx(2 * float(short.protocol.timestep))


def test_wings_that_share_their_first_stages_have_the_same_rise(short):
    rising = with_values(short, {"protocol.rise": "50 ms"})
    one, other = simulate([compile_model(rising), compile_model(rising)])
    for name, values in one.series.items():
        assert values.tobytes() == other.series[name].tobytes()
