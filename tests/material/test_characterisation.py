import json
import math
from dataclasses import replace

import numpy as np
import pytest

from forficula.errors import InputError
from forficula.material import characterisation
from forficula.material.characterisation import characterise, known_length, strain_history
from forficula.material.law.law_family import FAMILIES, family_forms
from forficula.material.law.law_file import load_law, save_law
from forficula.material.law.law_form import all_forms
from forficula.serial import plain
from tests.material.synthetic import AREA, LENGTH, SPEED, cyclic_test, few_rows, tpu

MODULUS = 4.8e6


def elastic(**details):
    return cyclic_test(lambda strain, _: MODULUS * strain, **{"cycles": 4, "samples": 100, "noise": 1e4} | details)


@pytest.fixture(scope="module")
def three_elastic():
    tests = [elastic(seed=seed, name=f"s{seed}") for seed in (1, 2, 3)]
    return characterise(tests, name="linear", source="made up", forms=family_forms("linear"))


def test_a_known_modulus_is_recovered_within_its_interval(three_elastic):
    law = three_elastic.law
    (bounds,) = [interval for interval in law.intervals if interval.key == "modulus.linear"]
    assert bounds.low < MODULUS < bounds.high
    # noise of 10 kPa in hundreds of points: about 0.1 %
    assert bounds.high - bounds.low < 0.01 * MODULUS
    assert (law.name, law.source) == ("linear", "made up")


def test_the_band_is_that_of_10_to_60_newtons_a_centimetre_at_the_specimens_size(three_elastic):
    # docs/model/theory.md, "Tendon material": k = E A / L
    low, high = three_elastic.simulated_moduli
    assert [low * AREA / LENGTH, high * AREA / LENGTH] == pytest.approx([1000, 6000])


def test_a_law_keeps_the_length_of_its_specimens_through_its_file(three_elastic, tmp_path):
    save_law(three_elastic.law, tmp_path / "law.toml")
    assert known_length(load_law(tmp_path / "law.toml")) == pytest.approx(LENGTH)
    assert known_length(load_law("tpu-82a")) == 0.06  # docs/model/theory.md, "Values from the paper"
    assert known_length(load_law("resilin")) is None


def test_specimens_that_differ_in_size_leave_no_length_behind():
    test = elastic()
    longer = replace(test, name="longer", length=2 * LENGTH, extension=2 * test.extension)
    result = characterise([test, longer], forms=family_forms("linear"))
    assert known_length(result.law) is None
    assert any("differ in size" in remark for remark in result.remarks)


def test_the_first_cycle_is_left_out_by_default():
    dropped, kept = (characterise([tpu(1)], drop_first=drop, forms=family_forms("linear")) for drop in (True, False))
    assert [cycle.number for cycle in dropped.cycles] == [2, 3, 4]
    assert [cycle.number for cycle in kept.cycles] == [1, 2, 3, 4]
    assert [item.number for item in dropped.specimens[0].left_out] == [1]
    assert kept.specimens[0].left_out == ()


def test_a_law_runs_through_the_first_cycle_but_is_not_compared_with_it():
    test = elastic()
    history = strain_history(characterise([test], forms=family_forms("linear")).specimens[0])
    assert len(history.time) == len(test.time)
    # the second of four equal cycles begins at a quarter
    assert history.time[history.first] == pytest.approx(test.time[-1] / 4, rel=0.02)


def test_rows_with_the_same_time_count_once():
    test = elastic()
    time = test.time.copy()
    time[5] = time[4]
    history = strain_history(characterise([replace(test, time=time)], forms=family_forms("linear")).specimens[0])
    assert len(history.time) == len(test.time) - 1
    assert np.all(np.diff(history.time) > 0)


def test_drift_is_that_which_was_planted():
    result = characterise([tpu(seed, cycles=5) for seed in (1, 2, 3)], forms=family_forms("linear"))
    # stress falls by 5.5 % of ln N, so from cycle 2 to 5 by this factor
    planted = (1 - 0.055 * math.log(5)) / (1 - 0.055 * math.log(2))
    factor, low, high = result.drifts["peak_stress"].change(5)
    assert factor == pytest.approx(planted, rel=5e-3)  # a law linear in ln N, fitted as a power
    assert low < factor < high
    assert result.drifts["residual_strain"].change(5)[0] > 0


def test_without_a_law_other_results_exist_and_a_remark_gives_the_reason(monkeypatch):
    def refuse(*_, **__):
        raise InputError("no law can be determined: too few rows")

    monkeypatch.setattr(characterisation, "fit_law", refuse)
    result = characterise([elastic()])
    assert (result.law, result.fit) == (None, None)
    assert "there is no law: no law can be determined: too few rows" in result.remarks
    assert json.dumps(plain(result), allow_nan=False)
    assert len(result.cycles) == 3


def test_a_requested_law_that_cannot_be_fitted_is_an_error():
    with pytest.raises(InputError, match="no law can be determined"):
        characterise([elastic()], forms=family_forms("prony"))


def test_one_specimen_gives_a_remark():
    result = characterise([elastic()], forms=family_forms("linear"))
    assert any(remark.startswith("one specimen: ") for remark in result.remarks)


@pytest.mark.parametrize(
    ("tests", "message"),
    [
        ([], "at least one tensile test"),
        ([elastic(cycles=1, name="lone")], r"lone: need two cycles.*--keep-first"),
        ([few_rows()], "5 samples in half a class"),
    ],
)
def test_tests_without_information_are_refused(tests, message):
    with pytest.raises(InputError, match=message):
        characterise(tests, forms=family_forms("linear"))


def test_families_contain_all_forms_except_those_with_damper_and_branches():
    named = [form for name in FAMILIES for form in family_forms(name)]
    assert len(named) == len(set(named))
    assert {form for form in all_forms() if form not in named} == {
        form for form in all_forms() if form.damper and form.branches
    }
    with pytest.raises(InputError, match="did you mean kelvin-voigt"):
        family_forms("kelvin")


def test_the_summary_is_json_with_units_and_all_results(three_elastic):
    content = json.loads(json.dumps(plain(three_elastic), allow_nan=False))
    assert [entry["cycle"] for entry in content["cycles"]] == [2, 3, 4]
    for entry in content["cycles"]:
        assert entry["secant_modulus_Pa"] == pytest.approx(MODULUS, rel=0.01)
        assert {"loss_J_per_m3", "residual_strain", "slack_strain"} < set(entry)
    ways = {(entry["cycle"], entry["way"]) for entry in content["modulus_by_strain"]}
    assert ways == {(cycle, way) for cycle in (2, 3, 4, "pooled") for way in ("loading", "unloading")}
    (parameter,) = [entry for entry in content["law"]["parameters"] if entry["key"] == "modulus.linear"]
    assert parameter["unit"] == "Pa"
    assert parameter["interval_95"][0] < MODULUS < parameter["interval_95"][1]
    compared = content["fit"]["compared"]
    assert all((entry["refused"] is None) != (entry["bayesian_information_criterion"] is None) for entry in compared)
    assert content["specimens"][0]["strain_rate_per_s"] == pytest.approx(SPEED / LENGTH, rel=1e-6)
    rates = {entry["key"]: entry for entry in content["law"]["parameters"] if entry["key"].endswith("strain_rate")}
    assert set(rates) == {"lowest_strain_rate", "highest_strain_rate"}
    for entry in rates.values():
        assert (entry["value"], entry["unit"]) == (pytest.approx(SPEED / LENGTH, rel=0.01), "1/s")
    # noise of 10 kPa in hundreds of rows of up to 4.8 MPa
    assert [entry["amplitude"] for entry in content["fit"]["amplitudes"]] == pytest.approx([1, 1, 1], abs=1e-3)
    assert 0 < content["fit"]["amplitude_standard_deviation"] < 1e-3


def test_scatter_between_specimens_is_reported_in_the_law_and_its_file(tmp_path):
    modulus = {"a": 4.6e6, "b": 4.8e6, "c": 5.0e6}
    tests = [
        cyclic_test(lambda strain, _, value=value: value * strain, cycles=4, samples=100, noise=1e4, name=name)
        for name, value in modulus.items()
    ]
    result = characterise(tests, forms=family_forms("linear"))
    save_law(result.law, tmp_path / "law.toml")
    law = load_law(tmp_path / "law.toml")
    # the standard deviation of their logarithms
    scatter = np.log(list(modulus.values())).std(ddof=1)
    (fact,) = [fact for fact in law.facts if "amplitudes" in fact.what]
    assert float(fact.value.removesuffix(" %")) == pytest.approx(100 * scatter, rel=0.02)
    (bounds,) = [interval for interval in law.intervals if interval.key == "modulus.linear"]
    # Student's t of 2, by the square root of 3
    assert math.log(bounds.high / bounds.low) == pytest.approx(2 * 4.303 * scatter / math.sqrt(3), rel=0.05)


def test_what_a_cycle_does_not_have_is_null_in_the_summary():
    # never unloaded below half of its strain: no slack, no foot
    up = np.concatenate([np.linspace(0.5, 1, 100), np.linspace(1, 0.5, 100)[1:-1]])
    strain = np.tile(up, 4)
    test = elastic(cycles=4)
    rows = len(strain)
    test = replace(
        test,
        time=np.arange(rows, dtype=float),
        extension=strain * LENGTH,
        force=MODULUS * strain * AREA,
    )
    content = plain(characterise([test], forms=family_forms("linear")))
    json.dumps(content, allow_nan=False)
    assert content["cycles"][0]["slack_strain"] is None
    assert content["drift"]["residual_strain"] is None


def test_the_zero_of_the_force_is_what_the_load_cell_shows_of_a_slack_specimen():
    """An offset of 0.01 N on 5 mm2, less than the scatter of specimens would show if it were fitted with the law."""
    tests = [replace(item, force=item.force + 0.01) for item in (tpu(1), tpu(2), tpu(3))]
    result = characterise(tests, forms=family_forms("polynomial"))
    for residual in result.fit.residuals:
        # 15 samples with a noise of 4 kPa
        assert residual.offset == pytest.approx(2e3, abs=3.5e3)
