import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.integrate import quad

from forficula.errors import InputError
from forficula.material import ElasticLaw

RESTS = st.floats(0, 0.1)
EXTENSIONS = st.floats(1e-3, 0.1)


@st.composite
def laws(draw):
    """Stiffening, softening and without a linear term; the terms are of one size at 5 cm."""
    linear, cubic = draw(st.floats(100, 6000)), draw(st.floats(0, 2e6))
    softest = -1.9 * math.sqrt(linear * cubic)
    return ElasticLaw(rest_length=draw(RESTS), linear=linear, quadratic=draw(st.floats(softest, 1e5)), cubic=cubic)


@given(laws(), EXTENSIONS)
def test_energy_is_the_integral_of_the_force(law, extension):
    length = law.rest_length + extension
    integral = quad(law.force, law.rest_length, length, epsabs=0, epsrel=1e-12)[0]
    # rounding of the extension, 1e-17 m of 1e-3 m
    assert law.energy(length) == pytest.approx(integral, rel=1e-11)


@given(laws(), EXTENSIONS)
def test_stiffness_is_the_slope_of_the_force(law, extension):
    step, length = 1e-6, law.rest_length + extension
    slope = (law.force(length + step) - law.force(length - step)) / (2 * step)
    # a cubic's central difference is out by cubic step^2; rounding of the length, 1e-17 m of a step of 1e-6 m
    scale = law.linear + 2 * abs(law.quadratic) * extension + 3 * law.cubic * extension**2
    assert law.stiffness(length) == pytest.approx(slope, abs=1e-9 * scale + law.cubic * step**2)


@given(laws(), EXTENSIONS)
def test_it_pulls_when_stretched_and_not_when_slack(law, extension):
    assert law.force(law.rest_length + extension) > 0
    slack = max(law.rest_length - extension, 0)
    if slack < law.rest_length:
        assert law.force(slack) == law.energy(slack) == law.stiffness(slack) == 0


@given(laws(), EXTENSIONS, st.floats(0, 0.1))
def test_released_energy_is_the_difference_of_stored_energies(law, extension, shortening):
    length = law.rest_length + extension
    released = law.energy(length) - law.energy(length - shortening)
    # rounding of the larger energy
    assert law.released(length, shortening) == pytest.approx(released, abs=1e-13 * float(law.energy(0.2)))


def test_released_energy_is_accurate_over_a_short_distance():
    law = ElasticLaw(rest_length=0.0, linear=1000.0)
    # force times way, to first order in 1e-12 m / 0.1 m
    assert law.released(0.1, 1e-12) == pytest.approx(100 * 1e-12, rel=1e-10)


def test_without_resting_length_it_is_stiff_where_its_ends_meet():
    law = ElasticLaw(rest_length=0.0, linear=1000.0)
    assert (law.force(0.0), law.stiffness(0.0)) == (0, 1000)


def test_it_keeps_the_shape_of_the_lengths():
    law = ElasticLaw(rest_length=0.05, linear=1000.0)
    lengths = np.linspace(0, 0.1, 6).reshape(2, 3)
    for values in (law.force(lengths), law.energy(lengths), law.stiffness(lengths), law.released(lengths, 0.01)):
        assert values.shape == (2, 3)


@pytest.mark.parametrize(
    ("numbers", "message"),
    [
        ({"rest_length": -0.03}, "rest_length: need >= 0, got -0.03 m"),
        ({"rest_length": math.nan}, "rest_length: need a finite number, got nan m"),
        ({"linear": -1.0}, "linear: need >= 0, got -1 N/m"),
        ({"cubic": -1.0}, r"cubic: need >= 0, got -1 N/m\^3"),
        ({"quadratic": math.inf}, r"quadratic: need a finite number, got inf N/m\^2"),
        ({"quadratic": -1.0}, "quadratic: need >= 0 or the tendon would push at some extension, got -1"),
        ({"linear": 1.0, "cubic": 4.0, "quadratic": -4.0}, r"quadratic: need > -4 N/m\^2, -2 sqrt\(linear cubic\)"),
    ],
)
def test_an_invalid_law_is_refused(numbers, message):
    with pytest.raises(InputError, match=message):
        ElasticLaw(**{"rest_length": 0.0, "linear": 0.0, **numbers})
