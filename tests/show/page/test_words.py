from dataclasses import replace

import numpy as np
import pytest

from forficula.analysis import measure
from forficula.show.page.playback import make_clip
from forficula.show.page.words import angle_range, angle_text, energy_text, outcome_remarks, outcome_sentence


def test_a_wing_that_folded_and_opened_is_told_in_one_sentence_with_its_numbers(short_outcome):
    sentence = outcome_sentence("wing", short_outcome)
    assert sentence.startswith(f"wing folded in {1e3 * short_outcome.fold.time:.4g} ms with 50 N cm on every proximal")
    assert f"opened again in {1e3 * short_outcome.unfold.time:.4g} ms with 100 N cm on every joint" in sentence
    assert sentence.endswith("stayed open.")


def test_what_failed_is_told_with_its_torque(short_outcome):
    stuck = replace(short_outcome, status="stuck at -40.0 deg", folded=False, opened=False)
    assert outcome_sentence("wing", stuck) == "wing: stuck at -40.0 deg, with 50 N cm on every proximal joint."
    shut = replace(short_outcome, status="did not open", opened=False)
    end = "stayed folded when released, and did not open with 100 N cm on every joint."
    assert outcome_sentence("wing", shut).endswith(end)
    assert outcome_sentence("wing", replace(short_outcome, unfold=None)).endswith("and stayed folded when released.")
    assert outcome_sentence("wing", replace(short_outcome, fold=None, status="settled")) == "wing: settled."


def test_remarks_tell_what_to_try_what_swings_and_what_the_balance_misses(short_run, short_outcome):
    state = replace(short_outcome.folded_state, distal_angle_high=short_outcome.folded_state.distal_angle_low + 0.1)
    odd = replace(short_outcome, status="did not open", advice="Raise it.", folded_state=state)
    remarks = outcome_remarks(short_run, odd)
    assert remarks[0] == "Did not open. Raise it."
    assert any(remark.startswith("Where the folded state is taken, hinges still swing") for remark in remarks)
    series = {name: values.copy() for name, values in short_run.series.items()}
    series["stop_work"][-1] += 1.0  # J
    unsound = replace(short_run, series=series)
    (remark, *_) = outcome_remarks(unsound, measure(unsound))
    assert remark.startswith("Not to be trusted: the energy balance misses ")
    assert "Take a timestep of about " in remark
    assert outcome_sentence("wing", measure(unsound)).startswith("wing: not to be trusted: the energy balance misses ")


def test_a_wing_that_never_rests_is_told(short_run, short_outcome):
    ends = [replace(end, goal_time=None) if end.stage.until == "rest" else end for end in short_run.stages]
    remarks = outcome_remarks(replace(short_run, stages=tuple(ends)), short_outcome)
    assert 'In the stage "release folded" the wing did not come to rest within 100 ms.' in remarks


def test_plots_are_told_by_the_values_in_the_states(short_run, short_outcome):
    clip = make_clip(short_run, short_outcome)
    states = (short_outcome.flat, short_outcome.folded_state, short_outcome.opened_state)
    text = angle_text("distal hinge angle", [np.degrees(state.distal_angle) for state in states], clip)
    assert f"{angle_range(np.degrees(states[1].distal_angle))} folded" in text
    assert text.startswith("Distal hinge angle of 3 veins: ")
    assert text.count("°") >= 3
    assert [text.find(name) > 0 for name in ("flat", "folded", "opened")] == [True, True, True]
    assert "0 J folded" in energy_text(clip)


@pytest.mark.parametrize(
    ("angles", "text"),
    [([3.04, 3.0], "3.0°"), ([-170.9, -168.8], "−170.9° to −168.8°"), ([-0.01, 0.01], "0.0°")],
)
def test_angles_are_a_range_with_a_real_minus_sign_and_no_negative_zero(angles, text):
    assert angle_range(np.array(angles)) == text
