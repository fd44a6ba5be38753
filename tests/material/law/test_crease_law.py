"""Laws of creases: energy, moment and stiffness are consistent; values out of bounds are refused."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.errors import InputError
from forficula.material.law.crease_law import CreaseLaw

LOCKING = CreaseLaw(stiffness=2.0, rest_angle=0.3, lock_below=-2.0, lock_above=2.5)
STOPPED = CreaseLaw(stiffness=2.0, rest_angle=0.3, lower=-1.0, upper=1.5, stop_stiffness=50.0)


@settings(deadline=None)
@given(st.floats(-2.9, 2.9), st.sampled_from([LOCKING, STOPPED, CreaseLaw(stiffness=1.0)]))
def test_the_moment_is_the_derivative_of_the_energy_and_its_stiffness_that_of_the_moment(angle, law):
    step = 1e-5
    rise = (law.energy(angle + step) - law.energy(angle - step)) / (2 * step)
    assert law.moment(angle) == pytest.approx(rise, rel=1e-6, abs=2e-4)
    kinks = np.abs(angle - np.array((-2.0, 2.5, -1.0, 1.5)))
    if kinks.min() > 2 * step:
        rise = (law.moment(angle + step) - law.moment(angle - step)) / (2 * step)
        assert law.slope(angle) == pytest.approx(rise, rel=1e-5, abs=1e-6)


@settings(deadline=None)
@given(st.floats(-2.9, 2.9), st.floats(-1, 1), st.sampled_from([LOCKING, STOPPED, CreaseLaw(stiffness=1.0)]))
def test_as_a_spring_rests_further_on_its_energy_falls_by_its_own_moment_even_where_it_locks(angle, further, law):
    step = 1e-5
    fall = (law.energy(angle, further - step) - law.energy(angle, further + step)) / (2 * step)
    assert law.rest_moment(angle, further) == pytest.approx(fall, rel=1e-6, abs=2e-4)


@settings(deadline=None)
@given(st.lists(st.floats(-2.9, 2.9), min_size=1, max_size=3), st.sampled_from([LOCKING, STOPPED]))
def test_the_expansion_is_energy_moment_and_slope(angles, law):
    angles = np.array(angles)
    for value, expected in zip(law.expansion(angles), (law.energy(angles), *law.moment_and_slope(angles)), strict=True):
        assert value.shape == angles.shape
        np.testing.assert_allclose(value, expected, rtol=1e-12, atol=1e-14)


def test_a_locking_crease_follows_the_published_law():
    # Liu and Paulino 2017 by the angle from contact, theta = pi + fold angle, below theta_1:
    # M = k (theta_1 - theta_0) + (2 k theta_1 / pi) tan(pi (theta - theta_1) / (2 theta_1))
    theta, theta_1, theta_0 = 0.4, np.pi - 2.0, np.pi + 0.3
    moment = 2.0 * (theta_1 - theta_0)
    moment += 2 * 2.0 * theta_1 / np.pi * np.tan(np.pi * (theta - theta_1) / (2 * theta_1))
    assert LOCKING.moment(theta - np.pi) == pytest.approx(moment, rel=1e-12)


def test_panels_that_lock_never_touch():
    assert LOCKING.energy(-np.pi) == np.inf
    assert LOCKING.energy(3.5) == np.inf
    assert LOCKING.moment(-np.pi + 1e-6) < -1e5
    assert LOCKING.moment(np.pi - 1e-6) > 1e5


def test_stops_only_push_back():
    inside, below, above = STOPPED.moment(np.array([0.3, -1.1, 1.6]))
    assert inside == 0
    assert below == pytest.approx(2.0 * -1.4 - 5.0)
    assert above == pytest.approx(2.0 * 1.3 + 5.0)


def test_arrays_of_laws_and_angles_broadcast():
    law = CreaseLaw(
        stiffness=np.array([1.0, 2.0]), rest_angle=np.array([0.0, 0.3]), lock_below=np.array([-np.inf, -2.0])
    )
    assert law.moment(np.array([-2.5, -2.5]))[0] == pytest.approx(-2.5)
    assert law.moment(np.array([-2.5, -2.5]))[1] == pytest.approx(
        CreaseLaw(stiffness=2.0, rest_angle=0.3, lock_below=-2.0).moment(-2.5)
    )


@pytest.mark.parametrize(
    ("numbers", "rule"),
    [
        ({"stiffness": -1.0}, "stiffness: need a finite number >= 0, got -1"),
        ({"stiffness": np.array([1.0, -2.0])}, "got -2"),
        ({"stiffness": 1.0, "rest_angle": np.nan}, "rest_angle: need a finite angle"),
        ({"stiffness": 1.0, "lock_above": 3.5}, "lock_above: need an angle between"),
        ({"stiffness": 1.0, "lower": 1.0, "upper": 0.5}, "lower: need an angle below upper"),
        ({"stiffness": 1.0, "stop_stiffness": np.inf}, "stop_stiffness: need a finite number"),
    ],
)
def test_what_no_crease_does_is_refused(numbers, rule):
    with pytest.raises(InputError, match=rule):
        CreaseLaw(**numbers)
