"""The least value of any key that reaches a state agrees with single runs."""

import csv
import io
import math

import numpy as np
import pytest

import forficula as ff
from forficula.analysis import Verdict
from forficula.design import with_values
from forficula.errors import InputError
from forficula.study import load_study, run_study, table_csv
from forficula.study.running.kept_runs import kept_runs, runs_to_keep

LENGTHS = '"tendon.rest_length" = ["5 cm", "9 cm"]'
# lengths and a membrane whose wings open, or fail to, at half the timestep, too; other single runs are undecided
DECIDED = '"tendon.rest_length" = ["6 cm", "9 cm"]\n"membrane.youngs_modulus" = ["0.2 MPa"]'
STIFFNESS = '[search]\nkey = "tendon.stiffness"\nvalues = "2..20 N/cm step 6"'


def searched(study_file, tmp_path, search, factors=LENGTHS):
    study = load_study(study_file(factors, 'ask = "least-value"', search))
    return study, run_study(study, tmp_path / "out")


def single(study, point, key, value):
    return ff.measure(ff.run(with_values(study.base, {**study.points[point], key: value}), confirm=False))


def first_that_works(study, point, key, values, state):
    """The least value whose run reaches a state, and its outcome; nan and None after an inconclusive run."""
    for value in values:
        outcome = single(study, point, key, value)
        if not outcome.verdict.conclusive:
            return math.nan, None
        if outcome.holds[state]:
            return value, outcome
    return math.nan, None


@pytest.mark.parametrize(("values", "extreme"), [("2..20 N/cm step 6", "least"), ('["20 N/cm", "2 N/cm"]', "largest")])
def test_the_result_of_falling_values_is_called_the_largest(study_file, values, extreme):
    written = values if values.startswith("[") else f'"{values}"'
    search = f'[search]\nkey = "tendon.stiffness"\nvalues = {written}'
    step = load_study(study_file(LENGTHS, 'ask = "least-value"', search)).search.first
    assert step.result_name == f"{extreme}_stiffness"


@pytest.mark.parametrize(
    ("key", "values", "state", "transition", "factors"),
    [
        ("tendon.stiffness", "2..20 N/cm step 6", "folded", "fold", LENGTHS),
        ("hinge.damping", '["1e-4 N m s/rad", "1e-3 N m s/rad", "1e-2 N m s/rad"]', "opened", "unfold", DECIDED),
        ("membrane.youngs_modulus", '["0.2 MPa", "1 MPa"]', "folded", "fold", LENGTHS),
        ("protocol.stages.3.hold", '["0 ms", "5 ms", "20 ms"]', "opened", "unfold", DECIDED),
    ],
)
def test_the_least_value_is_the_first_whose_run_alone_reaches_the_state(
    study_file, tmp_path, key, values, state, transition, factors
):
    written = values if values.startswith("[") else f'"{values}"'
    search = f'[search]\nkey = "{key}"\nvalues = {written}\nstate = "{state}"'
    study, table = searched(study_file, tmp_path, search, factors)
    step = study.search.first
    assert (step.key, step.state, study.search.second) == (key, state, None)
    name = f"least_{'_'.join(key.split('.')[1:])}"
    assert step.result_name == name
    for point in range(len(study.points)):
        value, outcome = first_that_works(study, point, key, step.values, state)
        row = table.isel(tendon_rest_length=point)
        assert row["outcome"].item() != "undecided"
        assert np.array_equal(row[name].item(), value, equal_nan=True)
        if outcome is None:
            continue
        assert row[f"{transition}_time"].item() == outcome.transitions[transition].time
        assert row[f"{transition}_work"].item() == outcome.transitions[transition].work
        assert row[f"{state}_energy"].item() == float(np.sum(outcome.states[state].tendon_energy))
        assert row["status"].item() == outcome.status


def test_least_values_exist_and_depend_on_the_point(study_file, tmp_path):
    study, table = searched(study_file, tmp_path, STIFFNESS)
    assert table["least_stiffness"].values.tolist() == [200.0, 800.0]
    assert table["least_stiffness"].attrs == {
        "units": "N/m",
        "long_name": "least tendon.stiffness with which the structure folds",
    }
    assert table.attrs["ask"] == "least-value"
    assert table["stiffness"].values.tolist() == [200.0, 800.0, 1400.0, 2000.0]
    assert table["folded_by_value"].values.tolist() == [[True] * 4, [False, True, True, True]]
    rows = list(csv.DictReader(io.StringIO(table_csv(study, table))))
    assert [float(row["least_stiffness_N_per_m"]) for row in rows] == [200.0, 800.0]


def test_halving_the_step_refines_the_least_value(study_file, tmp_path):
    search = f"{STIFFNESS}\nrefinements = 4"
    study, table = searched(study_file, tmp_path, search, '"tendon.rest_length" = ["8.5 cm"]')
    (least,) = table["least_stiffness"].values
    step = 600.0 / 2**4
    assert 200 < least <= 800
    assert single(study, 0, "tendon.stiffness", least).holds["folded"]
    assert not single(study, 0, "tendon.stiffness", least - step).holds["folded"]


def test_least_torque_is_a_special_case_of_least_value(study_file, tmp_path):
    torque = '[search]\nkey = "protocol.fold_torque"\nvalues = "0..40 N cm step 20"'
    _, value = searched(study_file, tmp_path / "value", torque)
    study = load_study(
        study_file(
            LENGTHS, 'ask = "least-torques"', '[search]\nfold_torques = "0..40 N cm step 20"\nunfold_torques = []'
        )
    )
    table = run_study(study, tmp_path / "torques")
    for name in ("least_fold_torque", "fold_time", "fold_work"):
        assert np.array_equal(value[name].values, table[name].values, equal_nan=True)


def test_dependent_values_follow_a_changed_value(study_file, tmp_path):
    # a given stiffness replaces the law
    law = '[settings.tendon]\nlaw = "tpu-82a"\narea = "12.5 mm^2"'
    path = study_file(LENGTHS, 'ask = "least-value"', STIFFNESS)
    path.write_text(path.read_text("utf-8") + f"\n{law}\n", "utf-8")
    study = load_study(path)
    assert study.base.tendon.law is not None
    table = run_study(study, tmp_path / "out")
    assert table["least_stiffness"].values.tolist() == [200.0, 800.0]


def test_a_point_that_does_not_allow_all_values_has_a_row_that_says_so(study_file, tmp_path):
    search = '[search]\nkey = "tendon.distal_attachment"\nvalues = ["5 cm", "9 cm"]'
    _, table = searched(study_file, tmp_path, search, '"pattern.distal_length" = ["8 cm", "10 cm"]')
    assert table["verdict"].values[0] == Verdict.NOT_BUILT
    assert "tendon.distal_attachment" in str(table["status"].values[0])
    assert np.isnan(table["least_distal_attachment"].values[0])
    assert table["verdict"].values[1] != Verdict.NOT_BUILT


def test_the_run_that_a_row_comes_from_is_kept(study_file, tmp_path):
    study, table = searched(study_file, tmp_path, STIFFNESS)
    kept = {run.point: run for run in kept_runs(runs_to_keep(study, table), tmp_path / "out")}
    for point, least in enumerate(table["least_stiffness"].values):
        assert kept[point].record.design.tendon.stiffness == least
        assert kept[point].outcome.transitions["fold"].time == table["fold_time"].values[point]
    assert [run.point for run in runs_to_keep(study, table, 1)] == [0]


@pytest.mark.parametrize(
    ("search", "message"),
    [
        ("", "search.key: is missing; give the key whose least value is asked for"),
        ("key = 3", "search.key: need text in quotes, got 3"),
        ('key = "tendon.stifness"', "tendon.stifness: unknown key; did you mean tendon.stiffness?"),
        ('key = "pattern.units"\nvalues = [1, 2]', "search.key: need a key whose value has a unit, got pattern.units"),
        ('key = "tendon.stiffness"', 'search.values: need values such as "0..50 N/cm step 10", got '),
        ('key = "tendon.stiffness"\nvalues = []', "search.values: need values such as "),
        (
            'key = "tendon.stiffness"\nvalues = [2]',
            'search.values: the unit is missing; write it as text such as "10 N/cm"',
        ),
        (
            'key = "tendon.stiffness"\nvalues = ["2 cm"]',
            'search.values: "cm" is not a unit of the right kind; write it',
        ),
        (
            'key = "tendon.stiffness"\nvalues = ["2 N/cm", "1 N/cm", "3 N/cm"]',
            "search.values: need values that rise, or that fall, got ",
        ),
        (
            'key = "tendon.stiffness"\nvalues = "0..2000 N/cm step 1"',
            "search.values: need at most 1000 values, got 2001",
        ),
        (
            'key = "tendon.stiffness"\nvalues = ["1 N/cm"]\nstate = "foldet"',
            'search.state: need "folded" or "opened", got "foldet"; did you mean "folded"?',
        ),
        (
            'key = "tendon.stiffness"\nvalues = ["1 N/cm"]\nfold_torques = []',
            "search.fold_torques: unknown key, got []; allowed here: key, values, state, refinements",
        ),
        (
            'key = "tendon.stiffness"\nvalues = ["1 N/cm"]\nrefinements = 21',
            "search.refinements: need a whole number >= 0 and <= 20, got 21",
        ),
        (
            'key = "tendon.rest_length"\nvalues = ["1 cm"]',
            'factors.tendon.rest_length: is what "least-value" looks for; give it under [search], or ask "run"',
        ),
    ],
)
def test_an_invalid_search_is_rejected_in_one_line(study_file, search, message):
    with pytest.raises(InputError) as caught:
        load_study(study_file(LENGTHS, 'ask = "least-value"', f"[search]\n{search}"))
    assert f"small.toml: {message}" in str(caught.value)
    assert len(str(caught.value).splitlines()) == 1
