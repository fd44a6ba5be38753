"""The energy residual, as a share of the energies that torques, springs and weight gave or took."""

import pytest

from forficula.design import load_design
from forficula.dynamics import EnergyBalance, energy_balance
from forficula.study.running.runs import run

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
        # kinetic energy and losses are where the energy went, not where it came from
        ({"kinetic": 1.25, "hinge_damping": 3.1}, -0.1, 9.5),
        ({"work": 0.0}, -5.0, 4.5),
        ({"branches": -2.0, "branch_damping": 1.5}, 0.5, 11.5),
        ({"yielding": 0.3, "letting_go": -0.1}, -0.2, 9.5),
    ],
)
def test_the_residual_is_missing_energy_divided_by_exchanged_energy(values, missing, exchanged):
    balance = EnergyBalance(**(CLOSED | values))
    assert balance.missing == pytest.approx(missing, abs=1e-12)
    assert balance.exchanged == pytest.approx(exchanged, rel=1e-12)
    assert balance.residual == pytest.approx(abs(missing) / exchanged, abs=1e-12)


def test_a_small_exchange_is_compared_with_a_share_of_the_stored_energy():
    step = CLOSED | dict.fromkeys(CLOSED, 0.0) | {"tendon": -3e-8, "kinetic": 2e-8}
    assert EnergyBalance(**step, stored=1.0).residual == pytest.approx(1e-3)
    assert EnergyBalance(**step, stored=1e-3).residual == pytest.approx(1 / 3)


def test_a_single_step_to_a_goal_that_is_already_met_is_reliable():
    stage = {"name": "close", "drive": "close", "until": "mouth < 50 cm", "hold": "0 s", "time_limit": "2 s"}
    record = run(load_design("letter-fold", {"protocol.stages": [stage]}))
    balance = energy_balance(record)
    assert abs(balance.missing) > 0.1 * balance.exchanged
    assert balance.residual < 0.002


def test_without_exchanged_energy_the_residual_is_zero():
    assert EnergyBalance(**dict.fromkeys(CLOSED, 0.0)).residual == 0.0


@pytest.mark.parametrize("kind", ["bars", "membrane"])
def test_a_sheet_that_nothing_moves_is_at_rest_and_misses_nothing_but_rounding(kind):
    flat = {"pattern.columns": 2, "pattern.rows": 2, "pattern.fold": "0 deg", "facet.kind": kind}
    stage = {"name": "settle", "drive": "none", "until": "rest", "hold": "5 ms", "time_limit": "0.05 s"}
    around = {"support": [{"of": "facet 0"}], "drive": [], "measure": [], "tendon": [], "protocol.stages": [stage]}
    balance = energy_balance(run(load_design("miura-sheet", flat | around)))
    assert balance.residual < 1e-3
