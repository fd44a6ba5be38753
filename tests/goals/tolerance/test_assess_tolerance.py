"""A tolerance analysis recovers a planted closed-form model, and interruptions do not change the result."""

import json
import shutil
from dataclasses import replace

import numpy as np
import pytest

from forficula.design import load_design
from forficula.errors import InputError
from forficula.goals.tolerance import assess_tolerance, estimate_tolerance
from forficula.goals.tolerance.advice import advice, most_important, tighten_first
from forficula.goals.tolerance.nearest_failure import Answer
from forficula.goals.tolerance.plan import PLANS
from forficula.goals.tolerance.question_file import question_of
from forficula.goals.tolerance.saved_plan import kept_plan, saved_plan
from forficula.goals.tolerance.tolerance_table import tolerance_table
from tests.goals.tolerance.closed_form import (
    EDGE,
    FACTORS,
    KEYS,
    LINE,
    SMALL,
    WEIGHTS,
    ClosedForm,
    assessed,
    line,
    question_about,
)


@pytest.fixture(scope="module")
def design():
    return load_design("letter-fold")


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Folder with the runs of `tolerance`."""
    return tmp_path_factory.mktemp("tolerance")


@pytest.fixture(scope="module")
def tolerance(design, folder):
    return assessed(design, folder, SMALL, line)


def works_within(width):
    """Probability of 0.2 u - 0.1 v < EDGE for offsets u within a width and v within 1: all except a triangle's."""
    leg = width - (EDGE - 0.1) / 0.2
    return 1 - leg**2 / (4 * width)


WORKS = works_within(1.0)


def test_probability_equals_closed_form(tolerance):
    works = tolerance.probability
    assert works.count == 128 + 32
    assert works.low <= WORKS <= works.high
    assert works.share == pytest.approx(WORKS, abs=0.05)


def test_every_transition_has_its_own_probability(tolerance):
    assert list(tolerance.probabilities) == ["works", "gets closed", "stays closed", "gets opened", "stays opened"]
    assert tolerance.probabilities["gets closed"].share == 1
    assert tolerance.probabilities["stays opened"] == tolerance.probabilities["works"]


def test_planted_factors_are_found_and_others_are_unimportant(tolerance):
    assert [KEYS[factor] for factor in tolerance.order] == [KEYS[1], KEYS[3]]
    for share, low, high in zip(
        (0.8, 0.2, 0), tolerance.indices.total_low[0], tolerance.indices.total_high[0], strict=True
    ):
        assert low <= share <= high
    assert KEYS[most_important(tolerance)] == KEYS[1]
    np.testing.assert_allclose(tolerance.effects, [0, 0.8, 0, 0.2, 0], atol=0.1)


def test_range_of_each_value_alone_ends_at_zero_margin(tolerance):
    down, up = tolerance.reaches[1]
    assert up.works <= EDGE / 0.2 <= up.fails
    assert up.fails - up.works == pytest.approx(2.0**-SMALL.halvings)
    assert down.fails is None
    other, _ = tolerance.reaches[3]
    assert other.works <= EDGE / 0.1 <= other.fails
    assert all(reach.fails is None for factor in (0, 2, 4) for reach in tolerance.reaches[factor])


def test_the_nearest_failure_of_all_together_is_the_corner(tolerance):
    """0.2 t + 0.1 t = EDGE, if both deviate by the same fraction of their tolerances."""
    assert tolerance.nearest.works * tolerance.nearest.largest <= EDGE / 0.3 <= tolerance.nearest.largest <= 0.625
    assert np.sign(tolerance.nearest.offsets[[1, 3]]).tolist() == [1, -1]


def test_gain_of_a_halved_tolerance_equals_closed_form(tolerance):
    gain = tolerance.narrowed[1]
    assert gain.gain_low <= works_within(0.5) - WORKS <= gain.gain_high
    assert tolerance.narrowed[0].gain_low <= 0 <= tolerance.narrowed[0].gain_high


def test_conclusions_name_the_tolerance_to_tighten_and_the_value_to_change(tolerance):
    output = " ".join(advice(tolerance))
    assert f"Tighten the tolerance of {KEYS[1]}, ± 10 %, first." in output
    assert f"A smaller {KEYS[1]} than 5 cm would help" in output
    assert "The remaining tolerances (3) together explain 0 % (0 to 0 %): they are uncritical." in output


def test_map_shows_the_two_most_important_factors_and_their_failures(tolerance):
    drawn = tolerance.map
    assert (KEYS[drawn.first], KEYS[drawn.second]) == (KEYS[1], KEYS[3])
    assert np.count_nonzero(drawn.samples.offsets[:, [0, 2, 4]]) == 0
    works = drawn.samples.offsets @ WEIGHTS < EDGE
    np.testing.assert_array_equal(drawn.samples.answers == Answer.WORKS, works)


def test_the_runs_are_no_more_than_the_plan_says(tolerance):
    assert 300 < tolerance.runs <= SMALL.most_runs(5)


def digest(tolerance):
    table = tolerance_table(tolerance)
    return json.dumps(table.to_dict(), default=str, sort_keys=True)


def test_three_interruptions_do_not_change_the_result(design, tmp_path, tolerance):
    folder = tmp_path / "killed"
    for after in (3, 100, 60):
        with pytest.raises(KeyboardInterrupt):
            assessed(design, folder, SMALL, line, killed_after=after)
    assert digest(assessed(design, folder, SMALL, line)) == digest(tolerance)


def test_repeating_a_finished_analysis_runs_nothing(design, folder, tolerance):
    again = assessed(design, folder, SMALL, line, killed_after=0)
    assert digest(again) == digest(tolerance)


def test_unreliable_runs_are_counted_separately_and_widen_the_interval(design, tmp_path, tolerance):
    doubtful = assessed(design, tmp_path / "doubtful", SMALL, line, untrusted=lambda offsets: offsets[0] > 0.9)
    works = doubtful.probability
    assert works.unknown == np.sum(doubtful.samples.offsets[:, 0] > 0.9) > 0
    assert works.count == tolerance.probability.count
    assert works.low < tolerance.probability.low
    assert works.high >= works.share
    assert "unreliable or cannot be built" in " ".join(advice(doubtful))
    # an inconclusive run does not count as a failure of a single value
    assert doubtful.reaches[0][1].fails is None


def test_a_failing_nominal_design_has_a_probability_but_no_distance_to_failure(design, tmp_path):
    failing = assessed(design, tmp_path / "failing", SMALL, lambda offsets: line(offsets) - 0.2)
    assert not failing.nominal_works
    assert failing.reaches == ()
    assert failing.nearest is None
    assert 0 < failing.probability.share < 0.5
    output = advice(failing)
    assert output[0].startswith("The nominal design does not work")
    assert any(sentence.startswith(f"A smaller {KEYS[1]}") for sentence in output)


def test_constant_margins_need_no_tighter_tolerance(design, tmp_path):
    sound = assessed(design, tmp_path / "sound", SMALL, lambda _: 0.5)
    assert sound.probability.share == 1
    assert most_important(sound) is None
    assert "No tolerance changes the margin." in advice(sound)


def test_without_failures_importance_is_reported_and_no_tolerance_tightened(design, tmp_path):
    sound = assessed(design, tmp_path / "sound", SMALL, lambda offsets: line(offsets) + 0.2)
    assert sound.probability.fails == 0
    output = " ".join(advice(sound))
    assert "Tighten" not in output
    assert (
        f"None of the {sound.probability.works} conclusive designs fails: no tolerance needs to be tightened." in output
    )
    assert f"What matters most is the tolerance of {KEYS[1]}, ± 10 %: it explains" in output
    # the distance to failure is reported, too
    assert f"If only one value deviates, the nearest failure is {KEYS[1]} at" in output
    assert tighten_first(sound) is None


def test_without_successes_no_tolerance_is_blamed(design, tmp_path):
    hopeless = assessed(design, tmp_path / "hopeless", SMALL, lambda offsets: line(offsets) - 0.6)
    assert hopeless.probability.works == 0
    output = " ".join(advice(hopeless))
    assert "Tighten" not in output
    assert "None of the designs works: change the design before its tolerances." in output
    assert tighten_first(hopeless) is None


def test_nearly_equal_tolerances_are_reported_as_unresolved(design, tmp_path):
    close = assessed(design, tmp_path / "close", SMALL, lambda offsets: 0.2 - float(offsets @ [0, 0.16, 0, -0.15, 0]))
    output = " ".join(advice(close))
    assert "There are too few runs to resolve which tolerance explains most of the variance: in resamplings" in output
    assert close.indices.leads[0].sum() == pytest.approx(1)


def test_a_dominant_tolerance_is_resolved(tolerance):
    assert "too few runs" not in " ".join(advice(tolerance))
    assert tolerance.indices.leads[0, tolerance.kept.index(1)] > 0.95
    assert tolerance_table(tolerance)["screening_resolved"].values.tolist() == [False, True, False, True, False]


def test_linear_indices_find_the_important_factors_if_time_is_short(design, tmp_path):
    lines = assessed(design, tmp_path / "lines", LINE, line)
    assert [KEYS[factor] for factor in lines.order[:2]] == [KEYS[1], KEYS[3]]
    np.testing.assert_allclose(lines.indices.first[0], [0, 0.8, 0, 0.2, 0], atol=0.12)
    assert np.isnan(lines.indices.total).all()
    assert lines.runs <= LINE.most_runs(5)


def test_too_few_designs_for_ranking_are_reported(design, tmp_path):
    few = assessed(design, tmp_path / "few", replace(PLANS[-1], points=8), line)
    assert most_important(few) is None
    assert "There are too few designs to rank the tolerances: increase the time." in advice(few)


def test_the_table_has_values_in_si_that_lie_within_the_tolerances(tolerance):
    table = tolerance_table(tolerance)
    lengths = table["tendon_left_rest_length"]
    assert lengths.attrs == {"units": "m", "display": "cm", "key": "tendon.left.rest_length"}
    assert float(lengths.min()) >= 0.045
    assert float(lengths.max()) <= 0.055
    assert float(table["probability"].sel(fact="works")) == tolerance.probability.share
    assert float(table["total_index"].sel(result="margin", group=KEYS[1])) == tolerance.indices.total[0, 0]


def test_first_runs_determine_the_plan_and_it_is_kept(design, tmp_path):
    """Runs of a closed form are so short that the largest plan is chosen."""
    question = question_about(design)
    assert kept_plan(tmp_path, question, 0.3, 1) is None
    cluster = ClosedForm(design, FACTORS, line, killed_after=40)
    with pytest.raises(KeyboardInterrupt):
        assess_tolerance(question, tmp_path, minutes=0.3, seed=1, cluster=cluster)
    plan = kept_plan(tmp_path, question, 0.3, 1)
    assert plan in PLANS
    assert kept_plan(tmp_path, question, 5.0, 1) is None
    assert kept_plan(tmp_path, replace(question, deviations=question.deviations[:4]), 0.3, 1) is None


def test_existing_rows_are_not_used_to_time_runs(design, tmp_path):
    """Half a second does not suffice for 256 points, although the folder has rows of earlier runs."""
    with pytest.raises(KeyboardInterrupt):
        assess_tolerance(question_about(design), tmp_path, cluster=ClosedForm(design, FACTORS, line, killed_after=300))
    slow = ClosedForm(design, FACTORS, line, pause=0.02)
    assert assess_tolerance(question_about(design), tmp_path, minutes=0.5 / 60, cluster=slow).plan in PLANS[4:]


def test_two_processes_that_share_runs_get_the_same_result(design, folder, tmp_path, tolerance):
    """Each process finds the rows of the other in its folder, here those of an earlier process."""
    shared = tmp_path / "shared"
    shutil.copytree(folder, shared)
    (shared / "journal.jsonl").rename(shared / "journal-1-of-2.jsonl")
    assert digest(assessed(design, shared, SMALL, line, shard=(2, 2), killed_after=0)) == digest(tolerance)


@pytest.mark.parametrize(
    ("wrong", "message"),
    [({"minutes": 0}, "minutes: need a number > 0"), ({"seed": -1}, "seed: need a whole number")],
)
def test_numbers_that_are_not_allowed_are_refused(design, tmp_path, wrong, message):
    with pytest.raises(InputError, match=message):
        assess_tolerance(question_about(design), tmp_path, **wrong)


def test_an_estimate_runs_a_few_and_writes_nothing(design, tmp_path):
    plan, most, seconds = estimate_tolerance(question_about(design), tmp_path / "not-there", minutes=0.01)
    assert plan is PLANS[-1]
    assert most == plan.most_runs(5)
    assert seconds > 0
    assert not (tmp_path / "not-there").exists()


def test_values_beyond_bounds_are_built_at_the_bound_and_reported(design, tmp_path):
    """A crease that stops at 175 deg, 10 % uniform: 36 % of the values would lie beyond its bound of 180 deg."""
    keys = ("crease.fold_limit", "facet.thickness")
    question = question_of(design, dict.fromkeys(keys, "10 %"))
    plan = replace(PLANS[-1], points=64, cells=5)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("forficula.goals.tolerance.saved_plan.PLANS", (plan,))
        saved_plan(tmp_path, question, 5.0, 0, plan)
        built = ClosedForm(design, question.deviations, lambda offsets: 0.3 + 0.1 * offsets[1] + 0.01 * offsets[0])
        tolerance = assess_tolerance(question, tmp_path, cluster=built)
    table = tolerance_table(tolerance)
    limits = table["crease_fold_limit"].values
    assert limits.max() == pytest.approx(np.pi, rel=1e-12)
    at_bound = int(np.sum(np.isclose(limits, np.pi, rtol=1e-12)))
    assert at_bound == pytest.approx(64 * (1 - 5 / 17.5) / 2, abs=2)
    assert table["map_x" if tolerance.map.first == 0 else "map_y"].values.max() <= np.pi * (1 + 1e-12)
    says = f"crease.fold_limit cannot go beyond 180 deg: {at_bound} of 64 designs would exceed this bound"
    assert any(item.startswith(says) for item in advice(tolerance))
    assert not any("facet.thickness cannot" in item for item in advice(tolerance))


@pytest.mark.parametrize(("minutes", "seed", "says"), [(0, 0, "minutes: need"), (5.0, -1, "seed: need")])
def test_estimate_rejects_the_same_arguments_as_the_analysis(design, tmp_path, minutes, seed, says):
    with pytest.raises(InputError, match=says):
        estimate_tolerance(question_about(design), tmp_path, minutes, seed)
