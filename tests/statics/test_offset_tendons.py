"""Tendons whose ends are offset from the bars: the barrier is not at straight, which shifts all other numbers.

The table is a joint's of 10 N/cm and 9 cm between arms of 5.5 cm, with a stop at 3 deg and both ends at a height above
the hinge's axis, computed from vectors (docs/model/theory.md, section Tendon off the hinge axis).
"""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import solve_ivp

from forficula.design import load_design, with_values
from forficula.material import ElasticLaw
from forficula.statics import (
    TendonHinge,
    crossed_hinges,
    final_speed,
    fold_time,
    hinge_landscape,
    hinge_remarks,
    ideal_hinges,
    slack_angle,
)
from forficula.structure import structure_of
from tests.statics.hinge_numbers import growth_rate, hinge_states, holding_torque, peak_opening_torque, top_barrier

REFERENCE = load_design("binder2025")
DEGREE = math.radians(1)


def standing_off(height):
    return with_values(REFERENCE, {"tendon.proximal_offset": height, "tendon.distal_offset": height})


@pytest.mark.parametrize(
    ("height", "barrier", "torque", "top"),
    [
        (-1.44, 0.0, 0.0, 3.0),
        (0.0, 0.75, 2.9, 0.0),
        (1.0, 2.16, 4.9, -2.1),
        (2.0, 4.30, 6.8, -4.2),
        (3.1, 7.49, 9.0, -6.5),
        (6.0, 20.2, 14.6, -12.5),
    ],
)
def test_the_joint_has_the_values_of_the_table(height, barrier, torque, top):
    hinge = ideal_hinges(structure_of(standing_off(height / 1000)))[0]
    # mJ, N cm and deg
    assert 1e3 * top_barrier(hinge) == pytest.approx(barrier, abs=0.05 if barrier > 10 else 0.01)
    assert 100 * holding_torque(hinge) == pytest.approx(torque, abs=0.05)
    assert math.degrees(hinge.top) == pytest.approx(top, abs=0.05)


@st.composite
def hinges(draw):
    """Return hinges with any arms, energy maxima on either side of both overbend stops, taut or slack there."""
    arm = draw(st.floats(0.03, 0.08))
    return TendonHinge(
        law=ElasticLaw(rest_length=draw(st.floats(0, 2.2)) * arm, linear=draw(st.floats(100, 6000))),
        proximal_arm=arm,
        distal_arm=arm * draw(st.floats(0.5, 2)),
        axial_offset=draw(st.floats(-0.02, 0.02)),
        offset_angle=draw(st.floats(-0.3, 0.3)),
        overbend=draw(st.floats(0.01, 0.2)),
        fold_limit=draw(st.floats(1.0, math.pi)),
        inertia=2e-5,
    )


@given(hinges())
def test_the_barrier_is_the_highest_energy_above_that_of_the_overbend_stop(hinge):
    angles = np.linspace(-hinge.fold_limit, hinge.overbend, 20_001)
    energy = hinge.energy(angles)
    barrier = top_barrier(hinge)
    climbs = energy.max() - energy[-1]
    # the squared spacing of the angles times the largest curvature
    near = 1e-6 * float(hinge.energy(hinge.top)) + 1e-12
    if barrier is None:
        assert climbs <= near or angles[energy.argmax()] < hinge.overbend - 1e-3 or not hinge.pulls
        assert not hinge.pulls or hinge.top >= hinge.overbend or hinge.top <= -hinge.fold_limit
    else:
        assert barrier == pytest.approx(climbs, abs=near)
        assert holding_torque(hinge) == pytest.approx(float(hinge.moment(hinge.overbend)))


@given(hinges())
def test_states_are_where_the_energy_is_least_nearby(hinge):
    surveyed = hinge_landscape(hinge, 721)
    states = hinge_states(hinge)
    assert states
    for state in states:
        inside = (surveyed.angle - state.angle) * (surveyed.angle - state.far_angle) <= 1e-18
        around = inside | np.append(inside[1:], False) | np.insert(inside[:-1], 0, False)
        assert surveyed.energy[around].min() >= state.energy - 1e-9
        assert {state.angle, state.far_angle} <= set(surveyed.angle.tolist())
    # and only there: every minimum of the curve is a state
    lowest = np.flatnonzero(
        (surveyed.energy[1:-1] < surveyed.energy[:-2]) & (surveyed.energy[1:-1] < surveyed.energy[2:])
    )
    for place in surveyed.angle[1:-1][lowest]:
        assert any(abs(place - state.angle) < 0.02 or abs(place - state.far_angle) < 0.02 for state in states)


@given(hinges())
def test_slack_and_peak_are_where_curves_have_them(hinge):
    slack, peak = slack_angle(hinge), peak_opening_torque(hinge)
    if slack is not None:
        assert hinge.length(slack) == pytest.approx(hinge.law.rest_length, rel=1e-9)
        assert -hinge.fold_limit - 1e-12 <= slack <= hinge.top
    if peak is not None:
        angles = np.linspace(min(hinge.top, hinge.overbend), -hinge.fold_limit, 4001)
        assert -hinge.moment(angles).min() <= peak.torque * (1 + 1e-9) + 1e-15
        assert peak.torque == pytest.approx(-float(hinge.moment(peak.angle)))


OTHERS = [
    (0.09, 0.055, 0.055, 0.11, math.pi),
    (0.03, 0.055, 0.045, -0.02, math.pi),  # past its shortest length before it is folded
    (0.109, 0.055, 0.055, -0.05, math.pi),  # slack, then taut again
    (0.05, 0.07, 0.09, 0.2, 2.8),
    (0.02, 0.03, 0.06, -0.3, 1.5),  # its maximum is beyond the overbend: released at the stop
]


@pytest.mark.parametrize(("rest", "proximal", "distal", "offset", "limit"), OTHERS)
def test_it_folds_in_the_time_and_to_the_speed_of_the_integrated_motion(rest, proximal, distal, offset, limit):
    hinge = TendonHinge(
        law=ElasticLaw(rest_length=rest, linear=1000.0),
        proximal_arm=proximal,
        distal_arm=distal,
        axial_offset=-0.01,
        offset_angle=offset,
        overbend=3 * DEGREE,
        fold_limit=limit,
        inertia=2e-5,
    )
    start = min(hinge.top - DEGREE, hinge.overbend)
    predicted = fold_time(hinge)

    def rates(_, state):
        return [state[1], float(hinge.moment(state[0])) / hinge.inertia]

    def folded(_, state):
        return state[0] + hinge.fold_limit

    folded.terminal = True
    motion = solve_ivp(
        rates, (0, 1.1 * predicted), [start, 0.0], method="DOP853", events=folded, rtol=1e-11, atol=1e-13 / predicted
    )
    # as without offsets; kink where the tendon becomes slack
    assert motion.t_events[0] == pytest.approx([predicted], rel=1e-5)
    assert -motion.y_events[0][0, 1] == pytest.approx(final_speed(hinge), rel=1e-5)


def test_from_its_top_it_grows_at_its_growth_rate():
    hinge = ideal_hinges(structure_of(standing_off(0.0031)))[0]
    rate, start = growth_rate(hinge), 1e-6

    def rates(_, state):
        return [state[1], float(hinge.moment(state[0])) / hinge.inertia]

    motion = solve_ivp(rates, (0, 3 / rate), [hinge.top - start, 0.0], method="DOP853", rtol=1e-11, atol=1e-16)
    assert (hinge.top - motion.y[0]) / start == pytest.approx(np.cosh(rate * motion.t), rel=1e-4)


def test_a_top_beyond_the_overbend_gives_a_remark():
    hinge = ideal_hinges(structure_of(standing_off(-0.003)))[0]
    assert top_barrier(hinge) is None
    assert [state.kind for state in hinge_states(hinge)] == ["neutral"]
    assert any("is not beyond it, so there is no barrier" in remark for remark in hinge_remarks(hinge))


def test_a_wing_whose_tendons_stand_off_climbs_their_barriers(landscape_of):
    landscape = landscape_of(standing_off(0.002))
    one = landscape.tendons[0].barrier
    assert landscape.tendons[0].barrier_angle == pytest.approx(-4.2 * DEGREE, abs=0.2 * DEGREE)
    assert one > 5 * crossed_hinges(structure_of(REFERENCE), 11)[0].actual.barrier
    assert landscape.hinge_barriers == pytest.approx(np.full(3, one), rel=0.02)
    assert [state.stable for state in landscape.partial_folds[:1]] == [True]
