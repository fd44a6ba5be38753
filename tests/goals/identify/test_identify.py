"""Hidden values are identified from their effects, and mutually exclusive facts are reported."""

import numpy as np
import pytest

from forficula.design import load_design
from forficula.goals.identify import observations_of
from forficula.goals.identify.exclusion import Together
from forficula.goals.identify.identify import identify_samples
from forficula.goals.identify.marginal import marginals
from forficula.goals.identify.result import build_result
from forficula.show.goals.identify_text import agrees_sentences, print_identification, together_sentences
from tests.goals.identify.closed_form import assess, count_fact, row_of, time_fact

# below the smallest overbend
SETTINGS = {"protocol.initial_overbend": "0 deg"}
UNKNOWN = {
    "hinge.overbend": {"distribution": "uniform", "low": "1 deg", "high": "8 deg"},
    "hinge.damping": {"distribution": "log-uniform", "low": "1e-4 N m s/rad", "high": "1e-2 N m s/rad"},
}


def observed(facts, samples=64, directed=0, unknown=UNKNOWN, rows=assess):
    """Result of observations of the reference wing."""
    tables = {
        "name": "planted",
        "design": "binder2025",
        "settings": SETTINGS,
        "unknown": unknown,
        "sampling": {"samples": samples, "directed": directed},
        "fact": facts,
    }
    requested = observations_of(tables)
    return build_result(requested, identify_samples(requested, rows), 0)


def planted(overbend, damping):
    """The reference wing with hidden values."""
    hidden = {"hinge.overbend": f"{overbend} deg", "hinge.damping": f"{damping} N m s/rad"}
    return load_design("binder2025", {**SETTINGS, **hidden})


def what_it_does(hidden):
    """The number of the paper's tendons that fold with 50 N cm, and the fold time of the reference, s."""
    folds = [
        row_of(hidden.with_values({"tendon.stiffness": 1e3 * k, "tendon.rest_length": 0.01 * l0}))["folded"]
        for k in range(1, 7)
        for l0 in range(10)
    ]
    return sum(folds), row_of(hidden)["fold_time_s"]


# overbend, deg, and damping, N m s/rad
HIDDEN = [(3.0, 1e-3), (5.5, 4e-3), (2.2, 3e-4)]


@pytest.fixture(scope="module")
def looked_for():
    """Effects of each hidden value, searched among the same samples: two facts for each value."""
    facts = []
    for hidden in HIDDEN:
        count, time = what_it_does(planted(*hidden))
        facts.append(count_fact(f"count of {hidden}", equals=count, tolerance=5))
        facts.append(time_fact(f"time of {hidden}", equals=f"{time} s", tolerance="5 ms"))
    return observed(facts, samples=192)


@pytest.mark.parametrize(("overbend", "damping"), HIDDEN)
def test_hidden_values_are_identified_from_their_effects(looked_for, overbend, damping):
    first_fact = 2 * HIDDEN.index((overbend, damping))
    met = looked_for.sel(sample=looked_for.met.isel(fact=[first_fact, first_fact + 1]).all("fact"))
    assert 3 <= met.sizes["sample"] < 64
    # within a third of the overbend the count changes by five; 5 ms is 0.43 of the hinge's time scale, 11.5 ms
    np.testing.assert_allclose(np.degrees(met.hinge_overbend), overbend, rtol=1 / 3)
    np.testing.assert_allclose(met.hinge_damping, damping, atol=0.44e-3)
    # the agreeing range contains the hidden value
    assert float(np.degrees(met.hinge_overbend).mean()) == pytest.approx(overbend, rel=0.1)


@pytest.fixture(scope="module")
def contradicted():
    """Two facts that contradict each other."""
    return observed([count_fact("many", at_least=40), count_fact("few", at_most=30)], samples=64, directed=32)


def test_contradicting_facts_are_reported_to_exclude_one_another(contradicted):
    result = contradicted
    assert result.met.any("sample").all()
    assert int(result.met_together[0, 1]) == int(result.met_together_placed[0, 1]) == 0
    assert result.together.values[0, 1] == Together.EXCLUDED
    # none of 64: less than 3 / 64 of the priors, by the rule of three
    assert float(result.together_share_high[0, 1]) == pytest.approx(3 / 64, rel=0.05)
    assert result.attrs["most_met"] == 1
    said = [*together_sentences(result), *agrees_sentences(result)]
    assert "No sample meets all 2 facts, and according to a model fitted between the samples no values do" in said[0]
    assert any(item.startswith("No values meet all facts") for item in said)
    assert sorted(result.attrs["met_most"]) == ["few", "many"]


def test_facts_that_every_sample_meets_return_the_prior():
    result = observed([count_fact("some", at_least=0), time_fact("ever", at_most="1 s")], samples=64, directed=32)
    assert result.met.all()
    assert result.agrees.all()
    # no sample is placed, because there is nothing to refute
    assert result.sizes["sample"] == result.attrs["drawn"] == 64
    # a scrambled Sobol sequence has equally many points in every sixteenth
    for share in (result.hinge_overbend_share, result.hinge_damping_share):
        assert np.histogram(share.values, bins=16, range=(0, 1))[0].tolist() == [4] * 16


def test_placed_samples_refute_an_accidental_exclusion():
    # one corner of the priors: both facts leave a narrow band of each unknown, which few drawn samples reach
    count, time = what_it_does(planted(2.2, 3e-4))
    facts = [
        count_fact("count", equals=count, tolerance=1),
        time_fact("time", equals=f"{time} s", tolerance="0.1 ms"),
    ]
    drawn = observed(facts, samples=64)
    assert int(drawn.met_together[0, 1]) == 0
    assert drawn.together.values[0, 1] != Together.EXCLUDED
    # although the hidden values meet both
    assert (
        "No sample meets all 2 facts, but there are too few samples to exclude other values"
        in together_sentences(drawn)[0]
    )
    for marginal in marginals(drawn):
        planted_at = {"hinge.overbend": np.radians(2.2), "hinge.damping": 3e-4}[marginal.key]
        assert marginal.agrees[0] <= planted_at <= marginal.agrees[1]
    placed = observed(facts, samples=64, directed=96)
    assert int(placed.met_together_placed[0, 1]) > 0
    assert placed.together.values[0, 1] == Together.PLACED
    # placed samples are not used for the likelihood of values
    assert not placed.agrees.sel(sample=placed.directed).any()
    assert float(placed.together_share_high[0, 1]) == float(drawn.together_share_high[0, 1])


def test_a_hidden_choice_is_identified_from_its_effect():
    unknown = {"tendon.distal_attachment": ["4 cm", "5 cm", "5.5 cm"], **UNKNOWN}
    hidden = planted(3.0, 1e-3).with_values({"tendon.distal_attachment": "4 cm"})
    time = row_of(hidden)["fold_time_s"]
    facts = [time_fact("time", equals=f"{time} s", tolerance="0.2 ms", settings={"protocol.fold_torque": "500 N cm"})]
    unknown["hinge.damping"] = ["1e-3 N m s/rad"]
    result = observed(facts, unknown=unknown)
    met = result.sel(sample=result.met.all("fact"))
    assert 0 < met.sizes["sample"] < 64
    np.testing.assert_allclose(met.tendon_distal_attachment.astype(float), 0.04)
    assert {marginal.key: marginal.agrees for marginal in marginals(result)}["tendon.distal_attachment"] == ("4 cm",)


def test_a_fact_with_inconclusive_runs_is_met_only_if_every_outcome_meets_it():
    def silent(runs):
        rows = assess(runs)
        for run, row in zip(runs, rows, strict=True):
            if run.values["tendon.rest_length"] == "9 cm":
                row["verdict"] = "diverged"
        return rows

    plain = count_fact("ten", equals=10, over={"tendon.rest_length": "0..9 cm step 1"}, rising=[], falling=[])
    plain["settings"] = {"protocol.fold_torque": "500 N cm"}
    assert observed([plain], samples=4).met.all()
    output = observed([plain], samples=4, rows=silent)
    assert (output.untold == 1).all()
    assert not output.met.any()
    assert (output.distance == 1).all()
    assert observed([{**plain, "tolerance": 1}], samples=4, rows=silent).met.all()


def silent_at(length):
    """Rows in which the runs with one resting length are inconclusive."""

    def rows(runs):
        result = assess(runs)
        for run, row in zip(runs, result, strict=True):
            if run.values["tendon.rest_length"] == length:
                row["verdict"] = "untrusted"
        return result

    return rows


LENGTHS = {"over": {"tendon.rest_length": ["8 cm", "9 cm"]}}


@pytest.mark.parametrize(
    ("statistic", "settings", "met", "tells"),
    [
        # the conclusive run takes 11.5 ms or more: the least is at most this, the largest at least
        ("least", {"at_most": "1 s"}, True, True),
        ("least", {"at_least": "1 s"}, False, True),
        ("least", {"at_least": "1 ms"}, False, False),
        ("largest", {"at_least": "1 ms"}, True, True),
        ("largest", {"at_most": "1 ms"}, False, True),
        ("largest", {"at_most": "1 s"}, False, False),
        ("mean", {"at_least": "1 ms"}, False, False),
        ("least at", {"at": {"tendon.rest_length": "8 cm"}}, False, False),
    ],
)
def test_a_number_with_an_inconclusive_run_is_decided_only_if_this_run_cannot_matter(statistic, settings, met, tells):
    fact = time_fact("time", statistic=statistic, **LENGTHS, **settings)
    result = observed([fact], samples=4, rows=silent_at("9 cm"))
    assert (result.met == met).all()
    assert (result.tells == tells).all()
    assert (result.untold == 1).all()
    assert np.isfinite(result.distance).all()
    assert int(result.told[0]) == (4 if tells else 0)
    if not tells:
        # four of four may meet the fact, or none
        assert (float(result.met_share_low[0]), float(result.met_share_high[0])) == (0.0, 1.0)


def test_a_least_value_is_bounded_by_inconclusive_values_and_the_first_success():
    def silent(runs):
        computed = assess(runs)
        for run, row in zip(runs, computed, strict=True):
            if run.values["protocol.fold_torque"] == "20 N cm":
                row["verdict"] = "diverged"
        return computed

    least = {"key": "protocol.fold_torque", "values": "10..50 N cm step 10", "state": "folded"}
    requested = {"name": "torque", "quantity": "least value", "least": least, "until": "fold"}
    requested |= {"over": {"tendon.rest_length": "5 cm"}, "tolerance": "1 N cm"}
    unknown = {"hinge.overbend": ["3 deg", "8 deg"]}

    def met_and_conclusive(**bound):
        result = observed([{**requested, **bound}], samples=2, unknown=unknown, rows=silent)
        return [result[name].sortby("hinge_overbend").values[:, 0].tolist() for name in ("met", "tells")]

    # 10 N cm suffice at 3 deg; at 8 deg 20 N cm may, and 30 N cm do
    assert met_and_conclusive(at_most="30 N cm") == [[True, True], [True, True]]
    assert met_and_conclusive(equals="30 N cm") == [[False, False], [True, False]]
    assert met_and_conclusive(at_least="20 N cm") == [[False, True], [True, True]]
    assert met_and_conclusive(equals="40 N cm") == [[False, False], [True, True]]


def test_evidence_for_an_exclusion_is_reported_with_numbers(contradicted):
    many, few = (int(item) for item in (contradicted.met_alone[0, 1], contradicted.met_alone[1, 0]))
    output = together_sentences(contradicted)
    assert "Pairs that exclude one another, as far as samples show" in output[-2]
    assert f"many | few: 0 of 64 samples meet both, those that meet one: {many} and {few} (" in output[-1]
    assert "would meet both if independent); at most 4.6 % of the prior (95 %); none of" in output[-1]
    assert int(contradicted.tried_together[0, 1]) == 32


def test_a_sample_without_a_valid_design_is_reported_and_not_counted():
    unknown = {"tendon.distal_attachment": {"distribution": "uniform", "low": "5 cm", "high": "15 cm"}, **UNKNOWN}
    result = observed([count_fact("some", at_least=0)], samples=32, unknown=unknown)
    missing = result.status.values != "ran"
    # the distal bars are 10 cm long
    assert missing.tolist() == (result.tendon_distal_attachment.values.astype(float) > 0.1).tolist()
    assert result.attrs["could_not_run"] == missing.sum() > 10
    assert np.isnan(result.distance.values[missing]).all()
    assert float(result.met_share[0]) == 1
    assert not result.agrees.values[missing].any()


def test_names_with_brackets_are_unchanged_in_the_table(capsys):
    print_identification(observed([count_fact("b [red]/[9 cm]", at_least=0)], samples=1))
    said = capsys.readouterr().out
    assert "planted: 1 sample of 2 unknown values of binder2025 drawn; 0 runs" in said
    assert "b [red]/[9 cm]  at least 0" in said
    # of a single sample nothing follows for the values beside it
    assert "There are too few samples to compute which values agree: 1 ran" in said
    assert "One sample meets the fact." in said


def test_reason_is_reported_if_no_sample_can_be_built():
    unknown = {"tendon.distal_attachment": {"distribution": "uniform", "low": "12 cm", "high": "15 cm"}}
    result = observed([count_fact("some", at_least=0)], samples=4, directed=4, unknown=unknown)
    assert result.attrs["could_not_run"] == 4
    assert together_sentences(result)[0].startswith(
        "4 samples cannot be built, mostly: binder2025: tendon.distal_attach"
    )
    assert agrees_sentences(result) == ["No sample agrees, because none can be built."]
