"""Energy, barrier and least torques of the printed joint agree with the closed form, statics and simulation.

The ends of a tendon are at p and d along bars at the angles alpha and beta to the hinge's axis, and at the heights h_p
and h_d above the plane of both bars. They are on two circles about the axis, of radii A and B, at a distance c along
it:

    a = p sin alpha, b = d sin beta, c = p cos alpha + d cos beta, A^2 = a^2 + h_p^2, B^2 = b^2 + h_d^2,
    delta = atan(h_p / a) + atan(h_d / b), L^2 = A^2 + B^2 + c^2 + 2 A B cos(phi + delta)

with the hinge's angle phi, and the tendon's lever about it is A B sin(phi + delta) / L.
"""

import math
from pathlib import Path

import numpy as np
import pytest
from scipy.optimize import minimize_scalar

import forficula as ff
from forficula.make.as_made import as_made
from forficula.statics.tree.hinge import tendon_hinges
from forficula.structure import structure_of

BY = "the closed form"
JOINT = ff.load_design("binder2025-joint")
# N/m and m, measured and stated in the paper
STIFFNESS, REST_LENGTH = 400.0, 0.06
P, D, HEIGHT = 0.059, 0.051, 0.003
# sectors count from the bar towards the hinge, and away from the bar beyond it
ALPHA, BETA = math.radians(180 - 87), math.radians(107)
OVERBEND = math.radians(3)

ARMS = P * math.sin(ALPHA), D * math.sin(BETA)
CIRCLES = tuple(math.hypot(arm, HEIGHT) for arm in ARMS)
ALONG = P * math.cos(ALPHA) + D * math.cos(BETA)
DELTA = sum(math.atan(HEIGHT / arm) for arm in ARMS)


def length(angle):
    one, other = CIRCLES
    return np.sqrt(one**2 + other**2 + ALONG**2 + 2 * one * other * np.cos(angle + DELTA))


def energy(angle):
    return STIFFNESS / 2 * np.maximum(length(angle) - REST_LENGTH, 0) ** 2


def moment(angle):
    """Moment towards the overbend, N m."""
    lever = CIRCLES[0] * CIRCLES[1] * np.sin(angle + DELTA) / length(angle)
    return STIFFNESS * np.maximum(length(angle) - REST_LENGTH, 0) * lever


@pytest.fixture(scope="module")
def joint_run():
    return ff.run(JOINT, confirm=False)


def test_the_hinge_of_the_joint_has_the_energy_and_moment_of_the_closed_form_at_every_angle(agree):
    (hinge,) = tendon_hinges(structure_of(JOINT))
    angles = np.radians(np.linspace(-180, 3, 184))
    over = ("hinge angle (deg)", np.degrees(angles))
    agree("tendon length", hinge.length(angles), length(angles), by=BY, unit="m", rel=1e-12, over=over)
    agree("tendon energy", hinge.energy(angles), energy(angles), by=BY, unit="J", rel=1e-9, abs=1e-15, over=over)
    agree("moment about the hinge", hinge.moment(angles), moment(angles), by=BY, unit="N m", abs=1e-13, over=over)


def test_the_landscape_of_the_joint_has_the_barrier_and_holding_torque_of_the_closed_form(agree):
    surveyed = ff.landscape(JOINT)
    (hinge,) = surveyed.tendons
    agree("angle of the barrier", hinge.barrier_angle, -DELTA, by=BY, unit="rad", abs=1e-9)
    agree("barrier", hinge.barrier, energy(-DELTA) - energy(OVERBEND), by=BY, unit="J", rel=1e-9)
    agree("holding torque", hinge.holding_torque, moment(OVERBEND), by=BY, unit="N m", rel=1e-9)
    steepest = minimize_scalar(lambda angle: float(moment(angle)), bounds=(-2.0, 0.0), method="bounded")
    agree("peak against opening", hinge.peak_opening.torque, -steepest.fun, by=BY, unit="N m", rel=1e-9)
    fold, unfold = (surveyed.least_torques[name] for name in ("fold", "unfold"))
    agree("least slow torque that folds", fold, moment(OVERBEND), by=BY, unit="N m", rel=0.01)
    agree("least slow torque that opens", unfold, -steepest.fun, by=BY, unit="N m", rel=0.01)
    # it rests in both end states, open and folded
    assert [(rest.name, rest.stable) for rest in surveyed.rests[:2]] == [("flat", True), ("folded", True)]


def test_pushed_over_its_barrier_the_joint_folds_by_itself_stays_folded_and_reopens(joint_run, agree):
    outcome = ff.measure(joint_run)
    assert outcome.verdict == "reached"
    assert outcome.energy_balance.residual < 1e-4
    angles, stored = joint_run.angles("ring")[:, 0], joint_run.series["tendon_energy"][:, 0]
    over = ("time (s)", joint_run.time)
    agree("tendon energy of the run", stored, energy(angles), by=BY, unit="J", rel=1e-9, abs=1e-12, over=over)
    push, snap = joint_run.stages[1:3]
    pushed = joint_run.time <= push.end
    climbed = stored[pushed].max() - stored[joint_run.time <= push.start][-1]
    agree("energy climbed in the run", climbed, energy(-DELTA) - energy(OVERBEND), by="statics", unit="J", rel=2e-3)
    # no torque acts any more, and it continues to fold
    assert np.degrees(angles[pushed][-1]) > -25
    rested = np.degrees(angles[joint_run.time <= snap.end][-1])
    assert -180 <= rested < -150


@pytest.mark.parametrize(
    ("key", "torques", "closed"),
    [
        ("fold", np.arange(8.3, 8.71, 0.05), float(moment(OVERBEND))),
        ("unfold", np.arange(36.0, 38.1, 0.2), -float(np.min(moment(np.linspace(-2, 0, 2001))))),
    ],
)
def test_the_least_torques_of_simulated_joints_are_those_of_statics(agree, key, torques, closed):
    """One run per slowly applied torque, up to the first torque that reaches the goal."""

    def stage(drive, until, time_limit):
        return {"name": drive, "drive": drive, "until": until, "hold": 0.0, "time_limit": time_limit}

    # a slow run works against the tendon's force only
    stages = [stage("none", "time", 0.02), stage("fold", "distal_angle < -20 deg", 0.4)]
    if key == "unfold":
        stages += [{**stage("none", "time", 0.1), "name": "snap"}, stage("unfold", "opened", 0.8)]
    for torque in torques:
        run = ff.run(
            JOINT.with_values({f"protocol.{key}_torque": torque / 100, "protocol.stages": stages}), confirm=False
        )
        if run.stages[-1].at_goal:
            break
    # the first torque that suffices, less half a step
    step = torques[1] - torques[0]
    least = (torque - step / 2) / 100
    agree(f"least torque of runs, {key}", least, closed, by="statics", unit="N m", abs=step / 100)


def test_simulated_as_its_parts_are_made_it_has_two_stable_states_with_the_numbers_of_the_readme():
    made = as_made(ff.make.parts(JOINT, "joint"))
    outcome = ff.measure(ff.run(made, confirm=False))
    assert outcome.status == "folded and opened"
    flat = {f"tendon.{end}_offset": "0 mm" for end in ("proximal", "distal")}
    output = [
        (f"{1e3 * hinge.barrier:.2f} mJ", f"{1e2 * hinge.holding_torque:.2f} N cm")
        for design in (made, JOINT.with_values(flat))
        for hinge in ff.landscape(design).tendons
    ]
    text = " ".join((Path(__file__).parents[2] / "README.md").read_text("utf-8").split())
    assert "a barrier of {} and a holding torque of {}".format(*output[0]) in text
    assert "they are {} and {}".format(*output[1]) in text
