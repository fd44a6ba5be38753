import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from forficula.errors import InputError
from forficula.material import TensileTest


def made(**changes):
    values = {
        "name": "tendon 1",
        "time": np.array([0.0, 1.0, 2.0]),
        "extension": np.array([0.0, 0.01, 0.02]),
        "force": np.array([0.0, 4.0, 8.0]),
        "length": 0.06,
        "area": 5e-6,
    }
    return TensileTest(**(values | changes))


@given(length=st.floats(1e-3, 1), area=st.floats(1e-9, 1e-3))
def test_strain_and_stress_are_those_of_the_specimen_before_the_test(length, area):
    test = made(length=length, area=area)
    np.testing.assert_allclose(test.strain * length, test.extension, rtol=1e-15)
    np.testing.assert_allclose(test.stress * area, test.force, rtol=1e-15)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"time": np.array([0.0])}, "time: need at least two rows, got shape (1,)"),
        ({"force": np.array([0.0, 1.0])}, "force: need as many rows as there are times, (3,), got (2,)"),
        ({"extension": np.array([0.0, np.nan, 0.02])}, "extension: need finite numbers, got nan in row 1"),
        ({"time": np.array([0.0, 2.0, 1.0])}, "time: need times that never decrease, got 1 s after 2 s"),
        ({"length": 0.0}, "length: need 0.001 mm to 1e+05 mm, got 0 mm; is its unit wrong?"),
        ({"area": -5e-6}, "area: need 1e-09 mm^2 to 1e+06 mm^2, got -5 mm^2; is its unit wrong?"),
        ({"length": np.nan}, "length: need 0.001 mm to 1e+05 mm, got nan mm; is its unit wrong?"),
    ],
)
def test_an_invalid_test_is_refused_with_name_rule_and_value(changes, message):
    with pytest.raises(InputError) as refused:
        made(**changes)
    assert str(refused.value) == f"tendon 1: {message}"


def test_two_samples_of_one_rounded_time_are_allowed():
    assert len(made(time=np.array([0.0, 1.0, 1.0])).time) == 3
