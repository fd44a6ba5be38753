"""Every command writes the JSON that it wrote before: the same keys, units and numbers."""

import pytest

from tests.golden.cases import CASES, answer, differences, kept


@pytest.mark.usefixtures("undrawn")
@pytest.mark.parametrize("case", CASES)
def test_json_keeps_its_keys_and_values(case, tmp_path):
    assert list(differences(kept(case), answer(case, tmp_path), relative=1e-6, absolute=1e-9)) == []


def test_a_missing_key_another_unit_and_another_number_are_differences():
    before = {"torque_N_m": 1.0, "states": [{"name": "folded"}], "verdict": "reached"}

    def compared(today):
        return list(differences(before, today, relative=1e-6, absolute=1e-9))

    assert compared(before | {"another": 1}) == []
    assert compared(before | {"torque_N_m": 1 + 1e-9}) == []
    assert compared({"torque_N_cm": 100.0, "states": [{}], "verdict": "stuck"}) == [
        ".torque_N_m is missing",
        ".states.0.name is missing",
        ".verdict: 'stuck' instead of 'reached'",
    ]
    assert compared(before | {"torque_N_m": 1.1}) == [".torque_N_m: 1.1 instead of 1.0"]
