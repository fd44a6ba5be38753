"""What is missing of the energy, as a share of what torques, springs and weight gave or took."""

import pytest

from forficula.dynamics import EnergyBalance

CLOSED = {
    "work": 5.0,
    "tendon": -3.0,
    "membrane": 0.5,
    "kinetic": 0.25,
    "gravitational": -1.0,
    "hinge_damping": 4.0,
    "elastic_damping": 1.25,
    "stops": 3.0,
}


@pytest.mark.parametrize(
    ("values", "missing", "exchanged"),
    [
        ({}, 0.0, 9.5),
        ({"stops": 2.9}, 0.1, 9.5),
        ({"stops": 3.1}, -0.1, 9.5),
        # motion and what is taken are where the energy went, not where it came from
        ({"kinetic": 1.25, "hinge_damping": 3.1}, -0.1, 9.5),
        ({"work": 0.0}, -5.0, 4.5),
        ({"branches": -2.0, "branch_damping": 1.5}, 0.5, 11.5),
        ({"yielding": 0.3, "letting_go": -0.1}, -0.2, 9.5),
    ],
)
def test_the_residual_is_what_is_missing_by_what_was_exchanged(values, missing, exchanged):
    balance = EnergyBalance(**(CLOSED | values))
    assert balance.missing == pytest.approx(missing, abs=1e-12)
    assert balance.exchanged == pytest.approx(exchanged, rel=1e-12)
    assert balance.residual == pytest.approx(abs(missing) / exchanged, abs=1e-12)


def test_where_nothing_is_exchanged_nothing_is_missing():
    assert EnergyBalance(**dict.fromkeys(CLOSED, 0.0)).residual == 0.0
