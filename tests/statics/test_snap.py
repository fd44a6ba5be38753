"""The snap of one hinge, compared with a pendulum's elliptic integral and with its integrated motion."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from scipy.special import ellipk

from forficula.design import load_design, scale_design
from forficula.errors import InputError
from forficula.material import ElasticLaw
from forficula.statics import TendonHinge, final_speed, fold_time, tendon_hinges, time_scale
from forficula.structure import structure_of
from tests.statics.hinge_numbers import growth_rate

REFERENCE = load_design("binder2025")
DEGREE = math.radians(1)


def hinge(rest_length=0.0, proximal=0.055, distal=0.055, quadratic=0.0, cubic=0.0, linear=1000.0, **changes):
    law = ElasticLaw(rest_length=rest_length, linear=linear, quadratic=quadratic, cubic=cubic)
    fixed = {"overbend": math.radians(3), "fold_limit": math.pi, "inertia": 2e-5}
    return TendonHinge(law=law, proximal_arm=proximal, distal_arm=distal, **{**fixed, **changes})


OTHERS = [
    hinge(0.09),
    hinge(0.03, 0.055, 0.045),
    hinge(0.05, 0.07, 0.09, axial_offset=-0.02, fold_limit=2.8),
    hinge(0.06, quadratic=-3e4, cubic=1e6),
    hinge(0.02, 0.03, 0.06, cubic=1e6, fold_limit=1.0),
    hinge(0.04, linear=0.0, quadratic=2e4),
]


def motion(hinge, start, duration):
    """Integrate inertia * acceleration = moment from rest just past straight; return final angle and speed."""

    def rates(_, state):
        return [state[1], float(hinge.moment(state[0])) / hinge.inertia]

    def limit(_, state):
        return state[0] + hinge.fold_limit

    limit.terminal = True
    return solve_ivp(
        rates, (0, duration), [-start, 0.0], method="DOP853", events=limit, rtol=1e-11, atol=1e-13 / duration
    )


@given(st.floats(1e-4, 3.0))
def test_without_resting_length_it_folds_in_the_time_of_a_pendulum(start):
    """docs/model/theory.md, section Snap of a hinge: t* K(m), m = cos^2(start / 2)."""
    ideal = hinge()
    # accuracy of the quadrature
    assert fold_time(ideal, start) == pytest.approx(time_scale(ideal) * ellipk(math.cos(start / 2) ** 2), rel=1e-9)


@pytest.mark.parametrize("start", [0.1, 1, 20])
@pytest.mark.parametrize("other", OTHERS)
def test_it_folds_in_the_time_and_to_the_speed_of_the_integrated_motion(other, start):
    predicted = fold_time(other, start * DEGREE)
    solution = motion(other, start * DEGREE, 1.1 * predicted)
    # integrator: 1e-11 per step, amplified by 1 / start from straight on; kink where the tendon becomes slack
    assert solution.t_events[0] == pytest.approx([predicted], rel=1e-6)
    assert -solution.y_events[0][0, 1] == pytest.approx(final_speed(other, start * DEGREE), rel=1e-6)


@given(st.floats(0, 0.99), st.floats(1e-3, 0.1))
def test_the_final_speed_is_two_cosines_less_the_resting_length(share, start):
    """docs/model/theory.md, section Snap of a hinge, equal arms: 2 cos(start / 2) - l0 / a, divided by t*."""
    ideal = hinge(0.11 * share)
    closed_form = 2 * (math.cos(start / 2) - share)
    if closed_form <= 0:
        assert final_speed(ideal, start) is None
    else:
        # rounding of an extension
        speed = final_speed(ideal, start) * time_scale(ideal)
        assert speed == pytest.approx(closed_form, rel=1e-9, abs=1e-12)


@given(st.floats(0, 0.99))
def test_the_growth_rate_is_that_of_a_taut_tendon_at_straight(share):
    """docs/model/theory.md, section Snap of a hinge: sqrt(1 - lambda) / t*."""
    ideal = hinge(0.11 * share)
    assert growth_rate(ideal) * time_scale(ideal) == pytest.approx(math.sqrt(1 - share), rel=1e-12)


@pytest.mark.parametrize("other", OTHERS)
def test_it_leaves_straight_with_the_hyperbolic_cosine_of_its_growth_rate(other):
    start, rate = 1e-6, growth_rate(other)
    solution = motion(other, start, 3 / rate)
    grown = -solution.y[0] / start
    # linear up to the square of 1e-5 rad; integrator error of 1e-13 at an angle of 1e-6 rad
    assert grown == pytest.approx(np.cosh(rate * solution.t), rel=1e-6)


def test_the_fold_takes_longer_by_one_growth_time_for_every_e_fold_nearer_to_straight():
    other = hinge(0.09)
    later = fold_time(other, 1e-9) - fold_time(other, 1e-9 * math.e)
    # the quadrature's accuracy for a time of 25 growth times
    assert later * growth_rate(other) == pytest.approx(1, rel=1e-7)


@settings(deadline=None)
@given(st.floats(1e-3, 1e3))
def test_a_scaled_wing_folds_in_a_time_in_proportion_to_its_size(factor):
    """docs/model/theory.md, section Similarity."""
    small, large = (tendon_hinges(structure_of(design))[0] for design in (REFERENCE, scale_design(REFERENCE, factor)))
    for number, power in ((time_scale, 1), (fold_time, 1), (final_speed, -1), (growth_rate, -1)):
        # rounding, and the quadrature
        assert number(large) == pytest.approx(factor**power * number(small), rel=1e-9)


@pytest.mark.parametrize(
    "still",
    [
        hinge(0.11),
        hinge(linear=0.0),
        hinge(0.109999),  # slack half a degree past straight
        hinge(fold_limit=0.01),
    ],
)
def test_a_hinge_that_does_not_fold_has_no_time_and_no_speed(still):
    assert fold_time(still) is None
    assert final_speed(still) is None


def test_without_a_linear_term_there_is_no_time_scale_but_a_fold():
    other = hinge(linear=0.0, cubic=1e6)
    assert time_scale(other) is None
    assert fold_time(other) > 0


@pytest.mark.parametrize("start", [0.0, -0.1, math.nan])
def test_a_start_at_straight_is_refused(start):
    with pytest.raises(InputError, match="start: need > 0 deg, past straight, got"):
        fold_time(hinge(), start)
