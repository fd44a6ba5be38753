import numpy as np
import pytest

from forficula.material.tensile.strain_history import StrainHistory, rate_range, strain_rate
from tests.material.synthetic import SPEED, cyclic_test, loading_program, sampled, viscoelastic_stress

STEPS = ((0.4, 0.1), (None, 300), (0.8, 1.0), (None, 600), (0.0, 0.01), (0.6, 0.003))


def history(time, strain, **details):
    return StrainHistory(time=time, strain=strain, stress=np.ones_like(time), **details)


def test_the_rates_of_a_test_are_those_of_its_ramps_without_holds():
    knots = loading_program(STEPS)
    time = sampled(knots)
    strain, _ = viscoelastic_stress(knots, time, (1e6,))
    # the turns take four per cent of a ramp
    assert rate_range(history(time, strain)) == pytest.approx((0.003, 1.0), rel=0.05)


@pytest.mark.parametrize("noise", [0.0, 1e-5, 1e-3])
def test_noise_of_the_strain_makes_no_rate(noise):
    test = cyclic_test(lambda strain, _: 1e6 * strain)
    strain = test.strain + noise * np.random.default_rng(1).standard_normal(len(test.time))
    assert rate_range(history(test.time, strain)) == pytest.approx((SPEED / 0.06, SPEED / 0.06), rel=0.05)


def test_a_first_cycle_that_is_left_out_does_not_affect_the_rates():
    slow, fast = np.linspace(0, 100, 201), np.linspace(0, 2, 41)[1:]
    strain = np.concatenate([1 - np.abs(1 - slow / 50), 1 - np.abs(1 - fast)])
    whole = history(np.concatenate([slow, 100 + fast]), strain)
    assert rate_range(whole) == pytest.approx((0.02, 1.0))
    later = history(whole.time, strain, first=201)
    assert rate_range(later) == pytest.approx((1.0, 1.0))


def test_the_rate_does_not_depend_on_uneven_sampling():
    knots = loading_program(STEPS)
    time = sampled(knots)
    strain, _ = viscoelastic_stress(knots, time, (1e6,))
    off = strain_rate(history(time, strain)) - np.interp(time, *knots)
    # a ramp of 1 1/s after a hold of 300 s, six samples in each turn
    assert np.sqrt(np.mean(off**2)) < 0.02
