"""The simulation of one tendon across one hinge agrees with the closed form.

The closed form uses the law of cosines, energy conservation and the elliptic integral of a pendulum. A bar of inertia I
turns about a hinge perpendicular to it. A tendon of stiffness k and resting length l0 joins points a before and b
beyond the hinge: L^2 = a^2 + b^2 + 2 a b cos(phi), U = k/2 max(L - l0, 0)^2, t* = sqrt(I / (k a b)).
"""

import math
from itertools import pairwise

import mujoco
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad
from scipy.special import ellipk

REST_LENGTHS = [0.0, 0.03, 0.06, 0.09]
ARMS = [(0.055, 0.055), (0.055, 0.045), (0.07, 0.09)]

cases = pytest.mark.parametrize(("rest_length", "arms"), [(rest, arms) for rest in REST_LENGTHS for arms in ARMS])


@st.composite
def tendons(draw):
    """Resting lengths and arms with at least 10 % stretch when straight."""
    proximal, distal = draw(st.floats(0.02, 0.1)), draw(st.floats(0.02, 0.1))
    return draw(st.floats(0, 0.9)) * (proximal + distal), proximal, distal


def slack_angle(hinge):
    """Angle at which the tendon goes slack: its length is the resting length."""
    tendon = hinge.wing.design.tendon
    a, b, rest = tendon.proximal_attachment, tendon.distal_attachment, tendon.rest_length
    return math.acos(np.clip((rest**2 - a**2 - b**2) / (2 * a * b), -1, 1))


def time_to(hinge, angle):
    """Time from rest at the start: the integral of dphi / sqrt(2 (U0 - U) / I).

    With phi = start + x^2 the integrand is finite where the speed is zero; the kink where the tendon goes slack is the
    end of a piece. U0 - U is written as a product, which keeps its digits where it is small.
    """
    tendon = hinge.wing.design.tendon
    first = hinge.length(hinge.start)

    def slowness(x):
        phi = min(hinge.start + x * x, slack_angle(hinge))
        shortened = 4 * tendon.proximal_attachment * tendon.distal_attachment / (first + hinge.length(phi))
        shortened *= math.sin((phi + hinge.start) / 2) * math.sin((phi - hinge.start) / 2)
        released = tendon.stiffness / 2 * shortened * (first + hinge.length(phi) - 2 * tendon.rest_length)
        return 2 * x / math.sqrt(2 * released / hinge.inertia)

    ends = [0.0, *(math.sqrt(end - hinge.start) for end in sorted({min(slack_angle(hinge), angle), angle}))]
    return sum(quad(slowness, *piece, epsabs=0, epsrel=1e-9, limit=200)[0] for piece in pairwise(ends))


def crossing(angles, timestep, angle):
    """Time at which the angle was passed, between two steps."""
    after = int(np.argmax(angles >= angle))
    assert after > 0
    return timestep * (after - 1 + (angle - angles[after - 1]) / (angles[after] - angles[after - 1]))


def swing(one_hinge, rest_length, arms, steps):
    """A swing to 180 deg in about a number of steps, followed by a few more steps."""
    time = time_to(one_hinge(rest_length, *arms), math.pi)
    hinge = one_hinge(rest_length, *arms, timestep=time / steps, duration=time * (1 + 5 / steps))
    return hinge, *hinge.run()


@cases
def test_the_bar_has_the_inertia_of_a_cylinder_about_its_end(agree, one_hinge, rest_length, arms):
    wing = (hinge := one_hinge(rest_length, *arms)).wing
    data = mujoco.MjData(wing.engine)
    mujoco.mj_forward(wing.engine, data)
    inertia = np.zeros((1, 1))
    mujoco.mj_fullM(wing.engine, data, inertia)
    # rounding
    result = inertia[0, 0] * wing.units.mass * wing.units.length**2
    agree("inertia of the bar", result, hinge.inertia, unit="kg m²", by="m (r²/4 + l²/3)", rel=1e-12)


@cases
def test_the_recorded_energy_is_that_of_the_recorded_angle(agree, one_hinge, rest_length, arms):
    hinge, angles, record = swing(one_hinge, rest_length, arms, steps=500)
    energy = record.data["tendon_energy"].values[:, 0]
    assert angles.max() > math.radians(179)
    # rounding; a length that lags its angle by one step would deviate by 1e-3
    ours, theirs = energy / hinge.energy(0), hinge.energy(angles) / hinge.energy(0)
    agree("energy divided by that when straight", ours, theirs, by="law of cosines", abs=1e-12)


@settings(max_examples=50, deadline=None)
@given(tendons(), st.floats(math.radians(-3), math.pi))
def test_the_engine_gives_the_moment_of_the_tendon(agree, one_hinge, tendon, angle):
    hinge = one_hinge(*tendon)
    wing = hinge.wing
    data = mujoco.MjData(wing.engine)
    data.qpos[0] = -angle
    mujoco.mj_forward(wing.engine, data)
    # rounding
    scale = wing.design.tendon.stiffness * min(tendon[1:]) * sum(tendon[1:])
    result = -data.qfrc_passive[0] * wing.units.energy / scale
    agree("moment divided by k a (a + b)", result, hinge.moment(angle) / scale, by="law of cosines", abs=1e-12)


@settings(max_examples=12, deadline=None)
@given(tendons())
def test_the_hinge_folds_in_the_time_of_the_quadrature(agree, one_hinge, tendon):
    hinge, angles, record = swing(one_hinge, tendon[0], tendon[1:], steps=1000)
    time = crossing(angles, record.design.protocol.timestep, math.pi)
    # from rest, semi-implicit Euler runs half a step ahead: 1 / 2000
    known = time_to(hinge, math.pi)
    agree("time to 180 deg", 1e3 * time, 1e3 * known, unit="ms", by="∫ dφ / √(2 (U₀ - U) / I)", rel=1e-3)


@pytest.mark.parametrize("start", [0.1, 1, 10])
def test_without_resting_length_the_hinge_folds_in_the_time_of_a_pendulum(one_hinge, agree, start):
    phi = math.radians(start)
    time = one_hinge(start=phi).time_scale * ellipk(math.cos(phi / 2) ** 2)
    hinge = one_hinge(timestep=time / 1000, duration=1.01 * time, start=phi)
    angles, record = hinge.run()
    result = crossing(angles, record.design.protocol.timestep, math.pi)
    # half a step: 1 / 2000
    agree(f"time from {start} deg to 180 deg", 1e3 * result, 1e3 * time, unit="ms", by="t* K(cos²(φ₀/2))", rel=1e-3)


@pytest.mark.parametrize("rest_length", REST_LENGTHS)
def test_the_error_is_proportional_to_the_timestep(agree, holds, one_hinge, rest_length):
    steps = [125, 250, 500, 1000, 2000]
    errors = []
    for count in steps:
        hinge, angles, record = swing(one_hinge, rest_length, (0.055, 0.055), count)
        time = crossing(angles, record.design.protocol.timestep, math.pi)
        errors.append(abs(time / time_to(hinge, math.pi) - 1))
    slope = -np.polyfit(np.log(steps), np.log(errors), 1)[0]
    # order 1, to 0.2; half an order would need a second cause of error
    agree("order of the time's error in the timestep", slope, 1, by="symplectic Euler", abs=0.2)
    holds("error at 2000 steps", errors[-1], below=1e-3)
    if rest_length == 0.03:
        share = 100 * np.array(errors)
        at_first = share[-1] * steps[-1] / np.array(steps)
        axis = ("steps to 180 deg", steps)
        # a line of first order through the last error; 25 % off is still no other order
        agree("error of the time to 180 deg", share, at_first, unit="%", by="first order", rel=0.25, over=axis)


@pytest.mark.parametrize("rest_length", REST_LENGTHS)
def test_the_final_speed_is_that_of_energy_conservation(one_hinge, agree, rest_length):
    hinge, angles, record = swing(one_hinge, rest_length, (0.055, 0.055), steps=1000)
    last = int(np.argmax(angles >= math.pi))  # the step that passes 180 deg does not act on a stop yet
    speed = (angles[last] - angles[last - 1]) / record.design.protocol.timestep
    closed_form = 2 * math.cos(hinge.start / 2) - rest_length / 0.055
    # first order: one step in a thousand
    what = f"final speed times t*, resting length {100 * rest_length:.0f} cm"
    agree(what, speed * hinge.time_scale, closed_form, by="conservation of energy", rel=1e-3)


@pytest.mark.parametrize("rest_length", REST_LENGTHS[1:])
def test_after_the_tendon_goes_slack_the_speed_is_constant(holds, one_hinge, rest_length):
    _, angles, record = swing(one_hinge, rest_length, (0.055, 0.055), steps=1000)
    slack = 2 * math.acos(rest_length / 0.11)
    taut = record.data["tendon_energy"].values[:, 0] > 0
    assert np.array_equal(taut, angles < slack)
    speed = np.diff(angles[np.argmax(angles > slack) : np.argmax(angles >= math.pi) + 1])
    # without force the speed is constant up to rounding of angles, 1e-16 rad in steps of 1e-3 rad
    holds("change of the speed with a slack tendon", np.ptp(speed) / speed[0], below=1e-11, by="no force")


@pytest.mark.parametrize("rest_length", REST_LENGTHS)
def test_the_hinge_leaves_the_barrier_at_its_growth_rate(one_hinge, agree, rest_length):
    start = math.radians(0.01)
    scale = one_hinge(rest_length).time_scale / math.sqrt(1 - rest_length / 0.11)
    hinge = one_hinge(rest_length, timestep=scale / 1000, duration=5 * scale, start=start)
    angles, record = hinge.run()
    # linear near straight: the angle grows with cosh(t / scale); half a step of 1e-3, to cosh(5) times 0.01 deg
    time = record.data["time"].values
    agree(
        f"angle past straight, resting length {100 * rest_length:.0f} cm",
        np.degrees(angles),
        np.degrees(start * np.cosh(time / scale)),
        unit="deg",
        by="φ₀ cosh(t / scale)",
        rel=1e-3,
        over=("time (ms)", 1e3 * time) if rest_length == 0.06 else None,
    )
