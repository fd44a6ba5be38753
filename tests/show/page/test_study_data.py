"""Data of a study's page: every number and every reason agrees with the table."""

import json
import math

import numpy as np
import pytest

from forficula.show.page.data.study_data import study_data
from forficula.show.study.maps import missing_reasons
from forficula.structure import structure_of
from forficula.study import load_study
from forficula.study.tables.outcome_kinds import transitions_text
from tests.show.study.test_maps import TORQUES, TWO, as_run, doubtful, many_ends, planted, sampled

GRID = '"tendon.stiffness" = ["10 N/cm", "20 N/cm", "30 N/cm"]\n"tendon.rest_length" = ["0 cm", "3 cm", "6 cm", "9 cm"]'
DRAWN = """
[factors."tendon.stiffness"]
distribution = "uniform"
low = "10 N/cm"
high = "30 N/cm"
[factors."tendon.rest_length"]
distribution = "uniform"
low = "0 cm"
high = "9 cm"
"""
# factors from SI to the displayed units
FACTORS = {"N cm": 100, "mN cm": 1e5, "s": 1, "ms": 1000, "J": 1, "mJ": 1000}


@pytest.fixture
def study(study_file):
    return load_study(study_file(GRID, 'ask = "least-torques"'))


def quantities(data):
    return {item["name"]: item for item in data["quantities"]}


def word(data, number):
    return data["words"][number]["word"]


def test_numbers_are_those_of_the_table_in_the_unit_beside_them(study):
    table = many_ends()
    data = study_data(study, table)
    for name, quantity in quantities(data).items():
        if name == "status" or ":" in name:
            continue
        expected = FACTORS[quantity["unit"]] * table[name].values.ravel()
        provided = np.array([math.nan if value is None else value for value in quantity["values"]])
        assert np.allclose(provided, expected, rtol=1e-6, equal_nan=True)
        assert np.nanmax(np.abs(provided), initial=0.1) < 1000


def test_quantities_name_their_transition(study):
    """By index, so that a page can relate kept runs to quantities; None for quantities without transition."""
    table = many_ends()
    table.attrs |= {"start_state": "flat", "transitions": transitions_text(structure_of(study.base), study.search)}
    for state in ("flat", "folded", "opened"):
        table[f"{state}_energy"] = table["fold_work"]
    output = {name: quantity["transition"] for name, quantity in quantities(study_data(study, table)).items()}
    assert (output["status"], output["flat_energy"]) == (None, None)
    assert [output[name] for name in ("least_fold_torque", "fold_work", "folded_energy")] == [0, 0, 0]
    assert [output[name] for name in ("least_unfold_torque", "unfold_work", "opened_energy")] == [1, 1, 1]
    assert {number for name, number in output.items() if name.startswith("fold_time_by")} == {0}


def test_fold_times_have_a_map_for_every_torque_that_was_tried(study):
    table = many_ends()
    times = [
        quantity for name, quantity in quantities(study_data(study, table)).items() if name.startswith("fold_time_by")
    ]
    assert [time["title"] for time in times] == [f"fold time with {100 * torque:.0f} N cm" for torque in TORQUES]
    assert len({time["unit"] for time in times}) == 1
    for index, time in enumerate(times):
        expected = FACTORS[time["unit"]] * table["fold_time_by_torque"].values[..., index].ravel()
        provided = [math.nan if value is None else value for value in time["values"]]
        assert np.allclose(provided, expected, rtol=1e-6, equal_nan=True)


def test_reasons_for_missing_values_are_those_of_the_figures(study):
    table = many_ends()
    data = study_data(study, table)
    for name in ("least_fold_torque", "unfold_work", "opened_energy"):
        quantity = quantities(data)[name]
        reasons = missing_reasons(table, name).values.ravel()
        for value, reason, expected in zip(quantity["values"], quantity["reasons"], reasons, strict=True):
            assert (value is None) == (reason is not None)
            if reason is not None:
                assert word(data, reason) == expected


def test_each_torque_has_its_own_reason_for_no_fold_time(study):
    table = doubtful()
    data = study_data(study, table)
    times = [quantity for name, quantity in quantities(data).items() if name.startswith("fold_time_by")]
    for index, time in enumerate(times):
        expected = table["fold_outcome_by_torque"].values[..., index].ravel()
        for value, reason, became in zip(time["values"], time["reasons"], expected, strict=True):
            assert (value is None) == (reason is not None) == (became != "folded")
            if reason is not None:
                assert word(data, reason) == became
    assert {"diverged", "unreliable", "still folding"} <= {item["word"] for item in data["words"]}


def test_every_point_has_a_verdict_and_the_verdicts_are_counted(study):
    data = study_data(study, many_ends())
    verdicts = [word(data, number) for number in data["verdicts"]]
    assert verdicts[:4] == ["folded and opened", "folded and opened", "did not open", "did not fold"]
    assert verdicts[6:8] == ["stuck on the way", "diverged"]
    assert data["statuses"][6] == "stuck at -134.6 deg"
    for entry in data["words"]:
        assert entry["count"] == verdicts.count(entry["word"])


def test_reasons_have_signs_of_their_own(study):
    for table, least in ((many_ends(), 5), (doubtful(), 4)):
        words = study_data(study, table)["words"]
        assert len({entry["sign"] for entry in words}) == len(words) > least


def test_factors_are_in_the_units_of_design_files(study):
    stiffness, length = study_data(study, planted(TWO))["factors"]
    assert (stiffness["key"], stiffness["name"], stiffness["unit"]) == ("tendon.stiffness", "tendon stiffness", "N/cm")
    assert stiffness["values"] == [10, 20, 30]
    assert (length["unit"], length["texts"]) == ("cm", ["0", "3", "6", "9"])


def test_plain_runs_have_no_torques_and_no_words_of_a_search(study_file):
    data = study_data(load_study(study_file(GRID)), as_run(many_ends()))
    assert not data["search"]
    assert set(quantities(data)) == {
        "status",
        "fold_time",
        "unfold_time",
        "fold_work",
        "unfold_work",
        "flat_energy",
        "folded_energy",
        "opened_energy",
    }


def test_drawn_points_have_a_value_of_every_factor_each(study_file):
    study = load_study(study_file(DRAWN, "[sampling]\ncount = 12\n"))
    data = study_data(study, sampled(many_ends()))
    assert data["sampled"]
    assert [len(factor["values"]) for factor in data["factors"]] == [12, 12]


def test_the_data_are_valid_json_without_nan_or_infinity(study):
    for table in (many_ends(), planted(TWO, np.full((3, 4), "did not fold", dtype=object))):
        text = json.dumps(study_data(study, table), allow_nan=False)
        assert json.loads(text)["points"] == 12
