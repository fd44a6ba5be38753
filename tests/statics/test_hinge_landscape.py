import math

import numpy as np
import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

from forficula.design import load_design
from forficula.errors import InputError
from forficula.material import ElasticLaw
from forficula.statics import TendonHinge, hinge_landscape, hinge_remarks, ideal_hinges, tendon_hinges
from forficula.structure import structure_of
from tests.statics.hinge_numbers import (
    closed_barrier,
    closed_growth_rate,
    closed_holding_torque,
    closed_states,
    hinge_states,
)

REFERENCE = load_design("binder2025")


def hinge(rest_length=0.09, linear=1000.0, proximal=0.055, distal=0.055, cubic=0.0, **changes):
    fixed = {"overbend": math.radians(3), "fold_limit": math.pi, "inertia": 2e-5}
    law = ElasticLaw(rest_length=rest_length, linear=linear, cubic=cubic)
    return TendonHinge(law=law, proximal_arm=proximal, distal_arm=distal, **{**fixed, **changes})


def kinds(hinge):
    return [state.kind for state in hinge_states(hinge)]


@given(st.floats(0, 0.12), st.just(0.0) | st.floats(1e-12, 0.1), st.floats(0.2, math.pi), st.integers(2, 500))
@example(0.10999, 0.05, 3.0, 100)  # slack in the overbend, too
def test_the_angles_hold_both_ends_straight_and_where_it_goes_slack(rest_length, overbend, fold_limit, points):
    surveyed = hinge_landscape(hinge(rest_length, overbend=overbend, fold_limit=fold_limit), points)
    angle = surveyed.angle
    assert (angle[0], angle[-1]) == (overbend, -fold_limit)
    assert 0 in angle
    assert surveyed.slack_angle is None or surveyed.slack_angle in angle
    ends = {end for state in surveyed.states for end in (state.angle, state.far_angle)}
    assert ends <= set(angle.tolist())
    assert (np.diff(angle) < 0).all()
    assert points - 1 <= len(angle) <= points + 5
    assert surveyed.energy.shape == surveyed.moment.shape == angle.shape


@given(st.floats(0, 0.12), st.floats(1e-6, 0.1), st.floats(0.2, math.pi))
def test_no_angle_nearby_has_less_energy_than_a_stable_state(rest_length, overbend, fold_limit):
    surveyed = hinge_landscape(hinge(rest_length, overbend=overbend, fold_limit=fold_limit))
    for state in surveyed.states:
        near = (surveyed.angle - state.angle) * (surveyed.angle - state.far_angle) <= 0
        around = near | np.append(near[1:], False) | np.insert(near[:-1], 0, False)
        # rounding
        assert surveyed.energy[around].min() >= state.energy - 1e-14
        assert np.ptp(surveyed.energy[near]) <= 1e-14


@given(
    st.floats(0, 0.12),
    st.just(0.0) | st.floats(1e-3, 0.1),
    st.floats(0.2, math.pi),
    st.floats(0.03, 0.08),
    st.just(0.0) | st.floats(-0.15, 0.15),
    st.sampled_from([0.0, 1e6]),
)
@example(0.0, 0.0, 3.125, 0.0625, -0.125, 0.0)  # beyond half a turn the tendon pulls back
def test_along_its_angle_a_hinge_has_the_numbers_of_its_closed_forms(
    rest_length, overbend, fold_limit, distal, offset, cubic
):
    hinged = hinge(
        rest_length, distal=distal, cubic=cubic, overbend=overbend, fold_limit=fold_limit, offset_angle=offset
    )
    # rounding decides whether a maximum at a stop is before or beyond it
    assume(min(abs(hinged.top_to_overbend), abs(hinged.top_to_fold)) > 1e-6 or offset == 0)
    surveyed = hinge_landscape(hinged)
    # rounding of the energies, whose difference is small for a maximum close to its stop
    rounding = 1e-15 * float(hinged.energy(hinged.top))
    assert surveyed.barrier == approx_or_none(closed_barrier(hinged), abs=rounding)
    assert surveyed.holding_torque == approx_or_none(closed_holding_torque(hinged))
    assert surveyed.growth_rate == approx_or_none(closed_growth_rate(hinged))
    ends = [(state.angle, state.far_angle) for state in surveyed.states]
    assert np.array(ends) == pytest.approx(np.array(closed_states(hinged)), rel=0, abs=1e-12)


def approx_or_none(expected, **tolerance):
    return None if expected is None else pytest.approx(expected, rel=1e-9, **tolerance)


def test_a_tendon_of_the_reference_is_held_open_and_free_when_folded():
    opened, folded = hinge_landscape(ideal_hinges(structure_of(REFERENCE))[0]).states
    assert (opened.kind, opened.angle) == ("stop", math.radians(3))
    # k a sin(3 deg / 2) (2 cos(3 deg / 2) - 2 lambda) a, docs/model/theory.md, section Tendon across a hinge
    torque = 1000 * 0.055**2 * 2 * math.sin(math.radians(1.5)) * (math.cos(math.radians(1.5)) - 9 / 11)
    assert opened.holding_torque == pytest.approx(torque, rel=1e-12)
    assert (folded.kind, folded.energy, folded.holding_torque) == ("neutral", 0, 0)
    assert (folded.angle, folded.far_angle) == (pytest.approx(-2 * math.acos(9 / 11)), -math.pi)


@pytest.mark.parametrize(
    ("surveyed", "expected"),
    [
        (hinge(0.0), ["stop", "minimum"]),
        (hinge(0.0, fold_limit=3.0), ["stop", "stop"]),
        (hinge(0.0, distal=0.03), ["stop", "minimum"]),
        (hinge(0.09, fold_limit=1.0), ["stop", "stop"]),
        (hinge(0.09, overbend=0.0), ["neutral"]),
        (hinge(0.10999), ["neutral", "neutral"]),
        (hinge(0.12), ["neutral"]),
    ],
)
def test_states_are_pressed_on_a_stop_or_at_a_minimum_or_free(surveyed, expected):
    assert kinds(surveyed) == expected


def test_the_tendons_of_a_wing_are_identical():
    first, second, third = (hinge_landscape(one) for one in tendon_hinges(structure_of(REFERENCE)))
    # rounding of the turned coordinates
    for other in (second, third):
        assert other.energy == pytest.approx(first.energy, rel=1e-12, abs=1e-15)
        assert other.fold_time == pytest.approx(first.fold_time, rel=1e-12)


@pytest.mark.parametrize(
    ("surveyed", "sentence"),
    [
        (hinge(0.12), "the tendon is slack at every angle: nothing moves the hinge, and there is no barrier; take a"
         " resting length below 11 cm, its length at straight, not 12 cm"),
        (hinge(linear=0.0), "the tendon has no stiffness: nothing moves the hinge, and there is no barrier"),
        (hinge(overbend=0.0), "the overbend is 0 deg: straight is no stable state, so there is no barrier and no"
         " holding torque; an overbend > 0 deg gives both"),
        (hinge(0.10999), "the tendon is slack beyond 1.545 deg of overbend: nothing holds the hinge at its stop of 3"
         " deg; a shorter resting length or a smaller overbend does"),
        (hinge(), "the tendon is slack from -70.19 deg to -180 deg: nothing moves the folded hinge there"),
        (hinge(fold_limit=1.0), "the tendon pulls up to the fold limit of 57.3 deg and never goes slack"),
        (hinge(fold_limit=0.01), "the fold limit of 0.573 deg is not beyond 1 deg past straight, where the fold starts,"
         " so there is no fold time and no final speed"),
        (hinge(0.109999), "the tendon is slack 1 deg past straight, where the fold starts, so there is no fold time"
         " and no final speed; a shorter resting length gives both"),
        (hinge(linear=0.0, cubic=1e6), "the law has no linear term, so there is no time scale"),
    ],
)  # fmt: skip
def test_missing_values_of_a_hinge_have_a_remark(surveyed, sentence):
    assert sentence in hinge_remarks(surveyed)


@given(
    st.floats(0, 0.12),
    st.sampled_from([0.0, 1e-3, 0.05]),
    st.floats(1e-3, math.pi),
    st.sampled_from([0.0, 1000.0]),
    st.sampled_from([0.0, 1e6]),
)
def test_values_that_are_none_have_a_remark_and_no_value_is_nan(rest_length, overbend, fold_limit, linear, cubic):
    surveyed = hinge_landscape(hinge(rest_length, linear, cubic=cubic, overbend=overbend, fold_limit=fold_limit))
    # a hinge without a spring has no missing number
    numbers = {name: getattr(surveyed, name) for name in surveyed.__dataclass_fields__ if name != "spring"}
    assert surveyed.remarks or all(number is not None for number in numbers.values())
    assert all(math.isfinite(number) for number in numbers.values() if isinstance(number, float))
    assert np.isfinite([surveyed.energy, surveyed.moment]).all()


def test_a_survey_of_one_point_is_refused():
    with pytest.raises(InputError, match="points: need >= 2, got 1"):
        hinge_landscape(hinge(), 1)
