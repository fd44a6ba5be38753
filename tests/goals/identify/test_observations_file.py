"""Observations files: allowed content, and errors."""

import pytest

from forficula.design import key_value
from forficula.design.files.key_table import key_facts
from forficula.errors import InputError
from forficula.goals.identify import load_observations, named_observations, observations_of
from forficula.goals.identify.fact_text import requirement_text
from forficula.goals.identify.observations_file import ObservationsFile
from forficula.goals.identify.prior import prior_shares, values_at
from tests.goals.identify.closed_form import TENDONS, count_fact

UNKNOWN = {"hinge.overbend": {"distribution": "uniform", "low": "1 deg", "high": "8 deg"}}
TIME = {"name": "t", "quantity": "fold_time", "absent": "1 s", "at_most": "50 ms"}
PLACE = {**TIME, "statistic": "least at", "over": TENDONS}
PLACE.pop("at_most")
LEAST = {"key": "protocol.fold_torque", "values": "10..50 N cm step 10", "state": "folded"}


def tables(**fact):
    return {"design": "binder2025", "unknown": UNKNOWN, "fact": [fact]}


def test_named_observations_have_the_values_that_the_paper_does_not_report():
    assert named_observations() == ["binder2025-lost"]
    seen = load_observations("binder2025-lost")
    keys = [prior.key for prior in seen.priors]
    # the paper does not report lengths, angles, masses and damping, but stiffness, resting length and overbend
    assert {"pattern.hub_radius", "vein.diameter", "pattern.tangent", "hinge.damping"} <= set(keys)
    assert not {"tendon.stiffness", "tendon.rest_length", "hinge.overbend"} & set(keys)
    requested = {fact.name: requirement_text(fact) for fact in seen.facts}
    assert requested["20 N cm is the least"] == "20 N cm"
    assert requested["none of 9 cm folds"] == "none"
    assert requested["least work at 7 to 8 cm"] == "least at tendon.rest_length 7 cm or 8 cm"
    assert requested["unfolding costs twice"] == "at least 2 fold_work"
    assert requested["32 of 60 fold"] == "32 within 2"
    # the values of the reference wing lie within the priors
    for prior in seen.priors:
        now = key_value(seen.base, prior.key)
        if prior.distribution is None:
            assert now in prior.values
        else:
            assert prior.distribution.first <= now <= prior.distribution.second


def test_an_unknown_key_must_not_be_under_settings():
    with pytest.raises(InputError, match=r"^unknown\.hinge\.overbend: is under \[settings\], too; need it in one"):
        observations_of({**tables(**TIME), "settings": {"hinge.overbend": "3 deg"}})


@pytest.mark.parametrize(
    ("believed", "quarter"),
    [
        ({"distribution": "uniform", "low": "1 deg", "high": "5 deg"}, "2 deg"),
        ({"distribution": "log-uniform", "low": "1 deg", "high": "16 deg"}, "2 deg"),
        # 0.6745 standard deviations below the mean
        ({"distribution": "normal", "mean": "3 deg", "deviation": "1 deg"}, "2.32551 deg"),
        (["1 deg", "2 deg", "3 deg", "4 deg"], "2 deg"),
    ],
)
def test_value_at_a_quarter_is_the_lower_quartile_of_the_prior(believed, quarter):
    (prior,) = observations_of({**tables(**TIME), "unknown": {"hinge.overbend": believed}}).priors
    assert values_at([prior], [0.25]) == {"hinge.overbend": quarter}


def test_longer_draws_begin_with_the_shorter_ones():
    seen = load_observations("binder2025-lost")
    assert (prior_shares(seen.priors, 100, 0)[:50] == prior_shares(seen.priors, 50, 0)).all()


@pytest.mark.parametrize(
    ("entries", "error"),
    [
        ({"design": "binder2025", "unknown": UNKNOWN}, r"fact: is missing; need at least one table \[\[fact\]\]"),
        ({**tables(**TIME), "unknown": {}}, "unknown: need a table with at least one"),
        ({**tables(**TIME), "facts": []}, r"facts: unknown key, got \[\]; did you mean fact\?"),
        (
            {**tables(**TIME), "sampling": {"samples": 0}},
            "sampling.samples: need a whole number >= 1 and <= 1000000, got 0",
        ),
        (tables(quantity="folded"), "fact 0: name: is missing; give it"),
        (tables(**{**TIME, "quantity": "fold_tim"}), 'fact t: quantity: need .* did you mean "fold_time"'),
        (
            tables(**{**TIME, "quantity": "fold_time + fold_work"}),
            "need a sum of quantities with one unit, got J and s",
        ),
        (tables(**{**TIME, "statistic": "count"}), 'statistic: need "least", "largest", "mean"'),
        (tables(**{**TIME, "at_most": "5 J"}), 'at_most: .*"5 J"'),
        (tables(**{**TIME, "at_most": 5}), "at_most: the unit is missing"),
        (tables(**{**TIME, "equals": "1 s"}), "need one of equals, at_least, at_most, got equals and at_most"),
        (tables(name="t", quantity="fold_time", at_most="1 s"), "absent: is missing"),
        (tables(**TIME, until="fol"), 'until: need "fold" or "unfold", got "fol"; did you mean "fold"'),
        (tables(**TIME, at={"tendon.stiffness": "10 N/cm"}), "at: belongs to statistic"),
        (tables(**PLACE, at={"tendon.stiffness": "15 N/cm"}), 'need values of the grid, got "15 N/cm"'),
        (tables(**PLACE, at={"tendon.stiffnes": "10 N/cm"}), "at: need .*tendon.stiffness"),
        (tables(name="n", quantity="least value", equals="1 N cm"), '"least value" needs a table least'),
        (tables(name="n", quantity="least value", least={**LEAST, "values": ["2 N cm", "1 N cm"]}), "values that rise"),
        (tables(name="n", quantity="folded", equals=1), 'equals: is not allowed with statistic = "all"'),
        (tables(**count_fact("n", equals=1, rising=["tendon.length"])), "rising: need"),
        (tables(**count_fact("n", equals="1 s")), 'equals: need a number, got "1 s"'),
        (
            tables(
                **TIME,
                over={"hinge.damping": {"distribution": "log-uniform", "low": "1e-4 N m s/rad", "high": "1 N m s/rad"}},
            ),
            "over.hinge.damping: need a list or a range",
        ),
        ({**tables(**TIME), "unknown": {"hinge.overbend": {}}}, "unknown.hinge.overbend.distribution: is missing"),
        ({**tables(**TIME), "unknown": {"hinge.overbnd": ["1 deg"]}}, "unknown.hinge.overbnd: .*hinge.overbend"),
        (tables(**TIME, over={"tendon.stiffness": {}}), "fact t: over.tendon.stiffness.distribution: is missing"),
    ],
)
def test_errors_name_the_fact_the_key_and_what_is_allowed(entries, error):
    with pytest.raises(InputError, match=error):
        observations_of(entries)


def test_facts_need_names_of_their_own():
    with pytest.raises(InputError, match="fact t: need a name of its own"):
        observations_of({**tables(**TIME), "fact": [TIME, TIME]})


def test_every_key_of_an_observations_file_is_listed():
    output = {fact.key for fact in key_facts("", ObservationsFile)}
    assert {"unknown.KEY", "fact.0.quantity", "fact.0.least.key", "sampling.directed"} <= output
    assert all(fact.meaning and fact.allowed for fact in key_facts("fact", ObservationsFile))


def test_an_observations_file_names_itself_and_paths_start_from_it(tmp_path):
    (tmp_path / "seen.toml").write_text(
        'design = "binder2025"\n[unknown]\n"hinge.overbend" = ["2 deg", "3 deg"]\n'
        '[[fact]]\nname = "folds"\nquantity = "folded"\n',
        "utf-8",
    )
    seen = load_observations(tmp_path / "seen.toml")
    assert (seen.name, seen.samples, seen.directed) == ("seen", 256, 128)
    with pytest.raises(InputError, match="neither a named observations file nor"):
        load_observations("binder2025-los")


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"tolerance": "-1 ms"}, 'tolerance: need >= 0, got "-1 ms"'),
        ({"scale": "0 ms"}, 'scale: need > 0, got "0 ms"'),
        ({"scale": "-1 ms"}, 'scale: need > 0, got "-1 ms"'),
        ({"settings": {"tendon.stifness": "4 N/cm"}}, "settings: "),
        ({"over": {"tendon.7.stiffness": ["4 N/cm"]}}, "need one of 0, 1 or 2 after tendon"),
    ],
)
def test_a_fact_that_no_run_can_decide_is_rejected(change, says):
    with pytest.raises(InputError) as error:
        observations_of(tables(**TIME, **change))
    assert says in str(error.value)


@pytest.mark.parametrize(
    ("believed", "says"),
    [
        (
            {"distribution": "uniform", "low": "-1 N/cm", "high": "4 N/cm"},
            "unknown.tendon.stiffness.low: need >= 0, got -1 N/cm",
        ),
        ({"distribution": "normal", "mean": "-1 N/cm", "deviation": "4 N/cm"}, "unknown.tendon.stiffness.mean: need"),
        (["-1 N/cm", "4 N/cm"], "unknown.tendon.stiffness: need >= 0, got -1 N/cm"),
    ],
)
def test_priors_must_lie_within_the_bounds_of_their_keys(believed, says):
    with pytest.raises(InputError) as error:
        observations_of({**tables(**TIME), "unknown": {"tendon.stiffness": believed}})
    assert says in str(error.value)


def test_a_normal_prior_may_extend_beyond_the_bounds_of_its_key():
    believed = {"distribution": "normal", "mean": "1 N/cm", "deviation": "4 N/cm"}
    assert observations_of({**tables(**TIME), "unknown": {"tendon.stiffness": believed}}).priors


@pytest.mark.parametrize(
    ("fact", "says"),
    [
        ({**TIME, "over": {"hinge.overbend": ["2 deg", "3 deg"]}}, "fact t: over.hinge.overbend: is under [unknown]"),
        (
            {"name": "t", "quantity": "least value", "least": LEAST | {"key": "hinge.overbend", "values": ["2 deg"]},
             "at_most": "2 deg"},
            "fact t: least.key: is under [unknown], too, as hinge.overbend; need it in one of them",
        ),
    ],
)  # fmt: skip
def test_an_unknown_key_cannot_be_a_condition_of_a_fact(fact, says):
    with pytest.raises(InputError) as error:
        observations_of(tables(**fact))
    assert says in str(error.value)
