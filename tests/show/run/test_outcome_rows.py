"""Numbers of states with their uncertainty, and labels of an energy balance."""

import re
from dataclasses import replace

import pytest

from forficula.analysis.confirmation import HALF_STEP
from forficula.analysis.outcome import compared_outcome, outcome_values
from forficula.dynamics import NumericalCheck
from forficula.show.page.parts.outcome_tables import outcome_tables
from forficula.show.run.outcome_rows import balance_remark, state_rows


@pytest.fixture(scope="module")
def uncertain(reference, reference_outcome):
    """The reference with a planted run at half the timestep.

    In that run energies of states differ by 1 % and lengths by 2 %, but the energy of the first tendon is the same.
    """
    by = {"tendon.energy": 1.01, "tendon.length": 1.02, "membrane.energy": 1.01}
    values = {
        name: tuple(number * by.get(name.partition(".")[2], 1.0) for number in numbers)
        for name, numbers in outcome_values(reference_outcome).items()
    }
    for state in reference_outcome.states:
        values[f"{state}.tendon.energy"] = (
            float(reference_outcome.states[state].tendon_energy[0]),
            *values[f"{state}.tendon.energy"][1:],
        )
    half = NumericalCheck(
        name=HALF_STEP,
        timestep=float(reference.protocol.timestep) / 2,
        verdict=reference_outcome.verdict.value,
        goal=reference_outcome.ending.goal,
        status=reference_outcome.status,
        holds=reference_outcome.holds,
        values=values,
    )
    return compared_outcome(reference_outcome, [half], reference)


def test_states_have_uncertainties_of_twice_the_difference_to_half_the_timestep(uncertain):
    rows = state_rows(uncertain.structure, {"flat": uncertain.states["flat"]}, uncertain.confirmation)
    assert [row[2] for row in rows.parts] == ["10.91 ± 0.44"] * 3
    assert [row[3] for row in rows.parts] == ["0.1827", "0.183 ± 0.004", "0.183 ± 0.004"]
    assert rows.sums[-1] == "0.548 ± 0.007"


def test_without_second_runs_numbers_have_no_uncertainty(uncertain):
    rows = state_rows(uncertain.structure, {"flat": uncertain.states["flat"]})
    assert [row[2:] for row in rows.parts] == [["10.91", "0.1827"]] * 3
    assert rows.sums[-1] == "0.548"


def test_the_page_has_the_uncertainty_of_the_energy_of_the_membrane_too(uncertain):
    rows = re.findall(r">membrane<.*?</tr>", outcome_tables(uncertain)[0])
    assert [len(re.findall(r"[\d.]+ ± [\d.]+ µJ", row)) for row in rows] == [1, 1, 1]


def test_large_energies_of_slack_branches_are_explained(reference_outcome):
    balance = replace(reference_outcome.energy_balance, branches=0.1, branch_damping=13.2, letting_go=-12.9)
    output = balance_remark(balance)
    assert "Of the 13.2 J dissipated by branches, 12.9 J belong to slack branches; no work was done for them" in output
    assert output.endswith("The sum is 0.3 J.")


def test_small_energies_of_slack_branches_are_not_explained(reference_outcome):
    balance = reference_outcome.energy_balance
    assert not balance_remark(balance)
    assert not balance_remark(replace(balance, branches=0.1, branch_damping=0.2, letting_go=-0.2))
