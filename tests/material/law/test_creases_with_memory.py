"""Nonlinear moments, Maxwell branches and damage of creases against closed forms of their laws."""

import numpy as np
import pytest
from scipy.integrate import quad

from forficula.errors import InputError
from forficula.material.law.crease_law import CreaseLaw
from forficula.material.law.maxwell_element import MaxwellElement
from forficula.material.law.relaxation import followed_share, square_integrals, working_share

BENT = CreaseLaw(stiffness=2.0, rest_angle=0.3, quadratic=-0.4, cubic=0.5, lock_above=2.0)


@pytest.mark.parametrize("angle", [-2.5, -0.4, 0.3, 1.5, 2.9])
def test_the_energy_of_a_nonlinear_spring_is_the_integral_of_its_moment(angle):
    integral = quad(lambda at: float(BENT.moment(at)), 0.3, angle, points=[2.0] if angle > 2 else None)[0]
    assert float(BENT.energy(angle)) == pytest.approx(integral, rel=1e-9, abs=1e-15)
    slope = (float(BENT.moment(angle + 1e-6)) - float(BENT.moment(angle - 1e-6))) / 2e-6
    assert float(BENT.slope(angle)) == pytest.approx(slope, rel=1e-7)
    ends = [float(BENT.energy(angle, change)) for change in (-1e-6, 1e-6)]
    if angle < 2:
        assert float(BENT.rest_moment(angle)) == pytest.approx((ends[0] - ends[1]) / 2e-6, rel=1e-7, abs=1e-7)


def test_shares_of_a_ramp_have_their_limits():
    time = np.array([0.1, 1.0, 1e9])
    shares = followed_share(time, 1.0)
    assert shares == pytest.approx([0.1 * (1 - np.exp(-10)), 1 - np.exp(-1), 1.0], rel=1e-9)
    assert followed_share(time, 0.0) == pytest.approx(1.0)
    # the work of a spring of that slope is the loss and the energy of the branch
    force = shares
    loss = square_integrals(time, 1.0)[2] * force**2 / time
    assert working_share(time, 1.0) / 2 == pytest.approx(loss + force**2 / 2, rel=1e-8)
    below, above = working_share(np.array([100.001, 99.999]), 1.0)
    assert below == pytest.approx(above, rel=1e-6)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"cubic": np.nan}, "cubic: need a finite number"),
        ({"branch_stiffness": np.array([-1.0]), "branch_time": np.ones(1)}, "branch_stiffness: need a finite number"),
        ({"branch_stiffness": np.ones(1), "branch_time": np.zeros(1)}, "branch_time: need > 0, got 0 s"),
        ({"damage_loss": 1.5}, "damage_loss: need a share from 0 to 1, got 1.5"),
        ({"damage_turn": 0.0}, "damage_turn: need > 0, got 0 rad"),
    ],
)
def test_numbers_without_a_meaning_are_refused(values, message):
    with pytest.raises(InputError, match=message):
        CreaseLaw(stiffness=1.0, **values)


def test_a_branch_needs_a_stiffness_and_a_time():
    with pytest.raises(InputError, match=r"branch\.time: need a finite number > 0, got 0 s"):
        MaxwellElement(stiffness=1.0, time=0.0)
