from dataclasses import replace

import numpy as np
import pytest

from forficula.analysis import measure
from forficula.analysis.advice import Advice
from forficula.design import with_values
from forficula.show.page.parts.run_sentences import (
    angle_range,
    energy_text,
    outcome_remarks,
    outcome_sentence,
    readable,
    reading_range,
    reading_text,
    structure_text,
)
from forficula.show.page.playback import make_clip
from forficula.show.run.release import release_sentences
from tests.analysis.test_outcome import ENDS, REFERENCE, planted


@pytest.fixture
def summary(short_outcome):
    """Return the sentence about a short run with a partly changed outcome."""

    def tell(status=short_outcome.status, **changed):
        both = {name: {**getattr(short_outcome, name), **value} for name, value in changed.items()}
        return outcome_sentence("wing", replace(short_outcome, status=status, **both))

    return tell


def test_a_run_that_folds_and_opens_is_summarised_in_one_sentence_with_its_numbers(summary, short_outcome):
    fold, unfold = short_outcome.transitions.values()
    sentence = summary()
    assert sentence.startswith(f"wing folded in {1e3 * fold.time:.4g} ms with 50 N cm on every proximal joint (")
    assert f"opened again in {1e3 * unfold.time:.4g} ms with 100 N cm on every joint" in sentence
    assert "stayed folded when released, opened" in sentence
    assert sentence.endswith(" of work), and stayed open.")


def test_a_failure_is_reported_with_its_torque(summary):
    stuck = summary("stuck at -40.0 deg", holds={"folded": False, "opened": False})
    assert stuck == "wing: stuck at -40.0 deg, with 50 N cm on every proximal joint."
    shut = summary("did not open", holds={"opened": False})
    assert shut.endswith("stayed folded when released, and did not open with 100 N cm on every joint.")
    assert summary(transitions={"unfold": None}).endswith(" of work) and stayed folded when released.")
    assert summary("settled", transitions={"fold": None, "unfold": None}) == "wing: settled."


def sprung_back(angle):
    """A wing folded to -170 deg whose release, without a named state, leaves it at an angle, deg."""
    named = with_values(REFERENCE, {"protocol.stages.1.state": "folded"})
    return measure(planted((0.3, 0.4, 0.6), (0, -170, angle), ends=ENDS[:3], design=named))


@pytest.mark.parametrize("angle", [3.0, -178.0])
def test_without_a_named_state_the_angles_after_release_are_reported_without_a_claim(angle):
    outcome = sprung_back(angle)
    sentence = outcome_sentence("wing", outcome)
    went = f"went from -170.0 deg to {angle:.1f} deg when released (largest of distal angle)"
    assert "stayed" not in sentence
    assert sentence.endswith(f" of work) and {went}.")
    assert release_sentences(outcome)[0].startswith(f"The wing {went}.")


def test_a_release_that_ends_in_the_state_is_claimed_and_needs_no_further_sentence(short_outcome):
    assert release_sentences(short_outcome) == []
    assert [transition.held for transition in short_outcome.transitions.values()] == [True, True]


def test_the_time_of_a_stage_that_ends_on_the_way_is_not_called_the_time_of_folding():
    """Like binder2025-joint, which is pushed to -20 deg and then snaps."""
    pushed = with_values(REFERENCE, {"protocol.stages.1.until": "distal_angle < -20 deg"})
    outcome = measure(planted((0.3, 0.4, 0.6), (0, -21, -170), ends=ENDS[:3], design=pushed))
    sentence = outcome_sentence("wing", outcome)
    assert sentence.startswith("wing folded (distal_angle < -20 deg in 100 ms with 50 N cm on every proximal joint, ")
    assert "folded in" not in sentence


def test_all_drives_of_the_stages_of_a_transition_are_named_with_their_strengths(short_outcome):
    fold = replace(short_outcome.transitions["fold"], drives=("fold", "unfold"))
    sentence = outcome_sentence("wing", replace(short_outcome, transitions={"fold": fold, "unfold": None}))
    assert " with 50 N cm on every proximal joint and 100 N cm on every joint (" in sentence


def test_remarks_have_advice_swinging_states_and_the_energy_residual(short_run, short_outcome):
    states = {**short_outcome.states, "folded": replace(short_outcome.states["folded"], swings=True)}
    states["flat"] = replace(states["flat"], swings=False)
    odd = replace(short_outcome, status="did not open", advise=lambda: Advice(text="Raise it."), states=states)
    remarks = outcome_remarks(short_run, odd)
    assert remarks[0] == "Did not open. Raise it."
    assert any(remark.startswith("In the folded state the wing still moves") for remark in remarks)
    series = {name: values.copy() for name, values in short_run.series.items()}
    series["stop_work"][-1] += 1.0  # J
    unsound = replace(short_run, series=series)
    outcome = measure(unsound)
    (remark, *_) = outcome_remarks(unsound, outcome)
    assert remark.startswith("Unreliable: the energy balance misses ")
    assert "Take a timestep of about " in remark
    sentence = outcome_sentence("wing", outcome)
    assert sentence.startswith("wing: unreliable: the energy balance misses ")


def test_a_wing_that_never_rests_is_reported(short_run, short_outcome):
    ends = [replace(end, goal_time=None) if end.stage.until == "rest" else end for end in short_run.stages]
    remarks = outcome_remarks(replace(short_run, stages=tuple(ends)), short_outcome)
    assert 'In the stage "release folded" the wing did not come to rest within 100 ms.' in remarks


def test_plots_are_described_by_the_values_in_the_states(short_run, short_outcome):
    clip = make_clip(short_run, short_outcome)
    angles = [np.degrees(state.readings["distal_angle"].mean) for state in short_outcome.states.values()]
    text = reading_text(clip.readings[0], angles, clip)
    assert f"{angle_range(angles[1])} folded" in text
    assert text.startswith("Distal hinge angle of 3 veins: ")
    assert text.count("°") >= 3
    assert [text.find(name) > 0 for name in ("flat", "folded", "opened")] == [True, True, True]
    assert "0 J folded" in energy_text(clip)
    # the record knows it for every step, the frames do not
    assert f"kinetic {readable(short_run.kinetic_peak[1], 'J')}" in energy_text(clip)


def test_a_structure_is_described_by_its_text_or_by_its_parts(short_run):
    start = "A fan of 3 veins and 2 membrane panels, each vein 12 cm long up to the ring fold and 10 cm beyond it, "
    assert structure_text(short_run.structure).startswith(start)
    nameless = replace(short_run.structure, appearance=replace(short_run.structure.appearance, text=""))
    counted = "A wing of 6 bars, 2 membranes, 12 hinges and 3 tendons, 22 cm in size, moving over time."
    assert structure_text(nameless) == counted


@pytest.mark.parametrize(
    ("angles", "text"),
    [([3.04, 3.0], "3.0°"), ([-170.9, -168.8], "−170.9° to −168.8°"), ([-0.01, 0.01], "0.0°")],
)
def test_angles_are_a_range_with_a_real_minus_sign_and_no_negative_zero(angles, text):
    assert angle_range(np.array(angles)) == text


def test_lengths_are_a_range_with_their_unit():
    assert reading_range(np.array([4.5821, 12.0]), "cm") == "4.582 to 12 cm"
    assert reading_range(np.array([3.0]), "mm") == "3 mm"
