"""Every verdict: from constructed records, from runs, and as a text."""

import json
import math
from dataclasses import replace

import numpy as np
import pytest

import forficula as ff
from forficula.analysis import Ending, Verdict, ending_text, ending_word, measure, summary
from forficula.analysis.advice import NOTHING, run_advice
from forficula.analysis.run_warnings import run_warnings
from forficula.design import with_values
from forficula.show import print_outcome
from forficula.show.folder.run_folder import run_drawings
from forficula.show.page.run_page import run_page
from tests.analysis.test_outcome import ENDS, FOLDS_AND_OPENS, REFERENCE, planted

DEG = math.radians(1)
SETTLE, FOLD = REFERENCE.protocol.stages[:2]
# sufficient for a verdict on folding
SHORT = [SETTLE.model_copy(update={"time_limit": 0.02}), FOLD.model_copy(update={"time_limit": 0.1})]


def short(**values):
    provided = {key.replace("__", "."): value for key, value in values.items()}
    return with_values(REFERENCE, {"protocol.stages": [stage.model_dump() for stage in SHORT], **provided})


def moving(record):
    """Return a record in which the time limits ended all stages."""
    return replace(record, stages=tuple(replace(end, at_rest=False) for end in record.stages))


def missing(record, joule):
    """Return a record in which this much energy is unaccounted for."""
    lost = record.series["stop_work"].copy()
    lost[-1] -= joule
    return replace(record, series={**record.series, "stop_work": lost})


STUCK = planted((0.2, 0.3, 0.4), (0, -34, -34), ends=ENDS[:2], goals=(None, None))
SHUT = planted((0.3, 0.4), (0, -170), ends=ENDS[:4], goals=(None, 0.4, 0.7, None))
WORKED = planted(**FOLDS_AND_OPENS, proximal_work=((0.3, 0.4), (0, 2)), hinge_damping_work=((0.3, 0.4), (0, -2)))


@pytest.mark.parametrize(
    ("record", "verdict", "goal", "text", "word", "advice"),
    [
        (planted(**FOLDS_AND_OPENS), "reached", "unfold", "folded and opened", "folded and opened", ""),
        (planted(**FOLDS_AND_OPENS, ends=ENDS[:3]), "reached", "fold", "folded", "folded", ""),
        (planted(ends=ENDS[:1]), "reached", "none", "settled", "settled", ""),
        (
            moving(STUCK),
            "moving",
            "fold",
            "still moving at -34.0 deg when its time to fold was over",
            "still folding",
            'In the last 100 ms of the stage "fold" it approached its goal no faster than a structure at rest.',
        ),
        (
            moving(SHUT),
            "moving",
            "unfold",
            "still moving when its time to open was over",
            "still opening",
            'In the last 100 ms of the stage "unfold" it approached its goal no faster than a structure at rest.',
        ),
        (STUCK, "stuck", "fold", "stuck at -34.0 deg", "stuck on the way", ""),
        (SHUT, "stuck", "unfold", "did not open", "did not open", ""),
        (
            planted((0.3, 0.4), (0, -4), ends=ENDS[:2], goals=(None, None)),
            "stuck",
            "fold",
            "did not fold",
            "did not fold",
            "",
        ),
        (
            planted((0.3, 0.4, 0.5), (0, -170, 3), ends=ENDS[:3]),
            "not held",
            "fold",
            "did not stay folded",
            "did not stay folded",
            "Hold it longer before the release: protocol.stages.fold.hold = 1 s instead of 0 s",
        ),
        (
            planted((0.3, 0.4, 0.7, 0.8, 0.9, 1.0), (0, -170, -170, 3, 3, -170)),
            "not held",
            "unfold",
            "did not stay open",
            "did not stay open",
            "Hold it longer before the release: protocol.stages.unfold.hold = ",
        ),
        (
            planted(**FOLDS_AND_OPENS, diverged_at=1.2),
            "diverged",
            "unfold",
            "diverged at t = 1.2 s",
            "diverged",
            "Take a shorter timestep",
        ),
        (
            missing(WORKED, 0.05),
            "untrusted",
            "unfold",
            "unreliable: the energy balance misses 2.5 %",
            "unreliable",
            "Take a timestep of about 40 µs instead of 0.2 ms: a residual of 0.5 % is allowed"
            " (protocol.residual_limit)",
        ),
        (
            missing(WORKED, 3.0),
            "untrusted",
            "unfold",
            "unreliable: the energy balance misses more than the exchanged energy",
            "unreliable",
            "Take a shorter timestep",
        ),
        (
            replace(WORKED, doubt="its outcome still changes with the timestep"),
            "untrusted",
            "unfold",
            "unreliable: its outcome still changes with the timestep",
            "unreliable",
            "The design is at a boundary",
        ),
    ],
)
def test_every_verdict_has_its_sentence_its_word_and_its_advice(record, verdict, goal, text, word, advice):
    outcome = measure(record)
    ending = outcome.ending
    assert outcome.verdict is ending.verdict is Verdict(verdict)
    assert "unfold" in (ending.goal, goal) or ending.goal == goal
    assert (outcome.status, ending_word(ending)) == (text, word)
    assert outcome.advice.startswith(advice)
    assert bool(outcome.advice) == bool(advice)
    assert outcome.verdict.conclusive == (outcome.holds["folded"] is not None) == (outcome.holds["opened"] is not None)
    plain = json.loads(json.dumps(summary(record, outcome, {}), allow_nan=False))
    assert (plain["verdict"], plain["status"]) == (verdict, text)
    assert (plain["folded"], plain["opened"]) == (outcome.holds["folded"], outcome.holds["opened"])
    assert (plain["residual"] is None) == (verdict == "diverged")


def test_a_wing_that_cannot_be_built_says_why_and_has_no_advice():
    ending = Ending(verdict=Verdict.NOT_BUILT, why="vein.diameter: need < 3 mm")
    assert ending_text(ending) == "cannot be built: vein.diameter: need < 3 mm"
    assert (ending_word(ending), run_advice(WORKED, ending)) == ("cannot be built", NOTHING)


def test_the_limit_of_the_residual_is_a_setting():
    for share, limit, trusted in ((0.0049, 0.005, True), (0.0051, 0.005, False), (0.0051, 0.01, True)):
        design = with_values(REFERENCE, {"protocol.residual_limit": limit})
        outcome = measure(missing(replace(WORKED, design=design), share * 2))
        assert outcome.ending.residual == pytest.approx(share, rel=1e-9)
        assert outcome.verdict.conclusive is trusted


def test_a_run_with_a_residual_of_nan_is_unreliable():
    assert measure(missing(WORKED, math.nan)).verdict is Verdict.UNTRUSTED


def test_the_advised_timestep_decreases_with_the_residual():
    assert "about 0.1 ms instead of 0.2 ms" in measure(missing(WORKED, 0.02)).advice
    assert "about 20 µs instead of 0.2 ms" in measure(missing(WORKED, 0.1)).advice


# ---- real runs


def test_a_wing_that_reaches_its_time_limit_before_it_folds_is_still_moving():
    # the reference folds in 58.8 ms
    outcome = measure(ff.run(short(protocol__stages__1__time_limit="30 ms"), confirm=False))
    assert outcome.verdict is Verdict.MOVING
    assert outcome.status.startswith("still moving at -")
    assert (
        outcome.advice
        == "It is still approaching its goal: raise protocol.stages.fold.time_limit from 30 ms to 120 ms."
    )
    assert outcome.advised.values == {"protocol.stages.fold.time_limit": 0.12}
    assert outcome.holds["folded"] is False
    longer = measure(ff.run(short(), confirm=False))
    assert (longer.verdict, longer.transitions["fold"].time) == (Verdict.REACHED, pytest.approx(0.0532, abs=5e-4))


def test_a_wing_that_rests_at_its_stop_is_stuck():
    resting = [
        SETTLE.model_dump() | {"time_limit": 0.02},
        FOLD.model_dump() | {"time_limit": 1.0},
    ]
    stiff = with_values(REFERENCE, {"tendon.rest_length": "0 cm", "tendon.stiffness": "60 N/cm"})
    outcome = measure(ff.run(with_values(stiff, {"protocol.stages": resting}), confirm=False))
    assert (outcome.verdict, outcome.status) == (Verdict.STUCK, "did not fold")


@pytest.mark.parametrize("modulus", ["20 MPa", "30 MPa"])
def test_a_membrane_too_stiff_for_the_timestep_gets_the_advice_to_shorten_the_timestep_and_not_to_raise_the_torque(
    modulus,
):
    outcome = measure(ff.run(short(membrane__youngs_modulus=modulus), confirm=False))
    assert outcome.verdict in (Verdict.UNTRUSTED, Verdict.DIVERGED)
    assert outcome.advice.startswith(("Take a shorter timestep", "Take a timestep of about "))
    assert 'protocol.timestep = "auto" chooses one' in outcome.advice
    assert "torque" not in outcome.advice
    assert (outcome.holds["folded"], outcome.holds["opened"]) == (None, None)


@pytest.mark.parametrize("timestep", ["5 ms", "20 ms", "1 s"])
def test_a_timestep_far_too_long_diverges_and_never_folds(timestep):
    record = ff.run(with_values(REFERENCE, {"protocol.timestep": timestep}), confirm=False)
    outcome = measure(record)
    assert outcome.verdict is Verdict.DIVERGED
    assert outcome.status.startswith("diverged at t = ")
    assert "folded" not in json.dumps(summary(record, outcome, {})["status"])
    # the recorded part is valid: no hinge is 45 deg beyond its stop
    hinge = REFERENCE.hinge
    angles = record.angles("ring")
    assert angles.min() >= -hinge.fold_limit - 45 * DEG
    assert angles.max() <= hinge.overbend + 45 * DEG
    assert np.abs(record.angles("turn")).max() <= hinge.turn_limit + 45 * DEG


@pytest.fixture(scope="module")
def bent():
    """Return a wing whose hinges are at -79 deg after its first stage."""
    stages = [SETTLE.model_dump() | {"time_limit": 0.002}, FOLD.model_dump() | {"time_limit": 0.002}]
    values = {
        "protocol.initial_overbend": "-79 deg",
        "guard.stretch": 1e3,  # with all hinges bent so far, neighbouring tips are far apart
        "protocol.stages": stages,
        "protocol.timestep": "20 µs",
    }
    record = ff.run(with_values(REFERENCE, values), confirm=False)
    return record, measure(record)


@pytest.fixture(scope="module")
def doubtful():
    """Return a run whose membrane is too stiff for its timestep."""
    record = ff.run(short(membrane__youngs_modulus="20 MPa"), confirm=False)
    return record, measure(record)


def texts(figure):
    result = [text.get_text() for axes in figure.axes for text in (*axes.texts, axes.title)]
    result += [text.get_text() for item in figure.legends for text in item.get_texts()]
    return " ".join(result)


def test_a_state_with_a_hinge_at_79_deg_is_never_called_flat(bent, capsys):
    record, outcome = bent
    assert np.degrees(outcome.states["flat"].readings["distal_angle"].mean).max() < -70
    assert outcome.state_names["flat"] == "not flat"
    print_outcome("bent", outcome)
    page, output = run_page(record, outcome), capsys.readouterr().out
    for text in (output, texts(run_drawings(record, outcome)["folding"](7.0))):
        assert text.count("flat") == text.count("not flat") > 0
    assert '"not flat"' in page
    assert '"flat"' not in page.partition('id="data"')[2].partition("</script>")[0].replace('"not flat"', "")


def test_an_unreliable_run_is_marked_wherever_it_is_shown(doubtful, capsys):
    record, outcome = doubtful
    assert outcome.verdict is Verdict.UNTRUSTED
    said = "nreliable: the energy balance misses"
    plain = summary(record, outcome, {})
    assert (plain["verdict"], plain["folded"], plain["opened"]) == ("untrusted", None, None)
    assert plain["fold"]["succeeded"] is False
    assert plain["residual"] > 0.005
    print_outcome("doubtful", outcome)
    output = capsys.readouterr().out
    assert said in output
    assert "Take a timestep of about 0.1 ms" in output.replace("\n", " ")
    page = run_page(record, outcome)
    assert said in page
    assert "Take a timestep of about 0.1 ms" in page
    for name, drawing in run_drawings(record, outcome).items():
        # the pattern file does not change
        assert (said in drawing(7.0).get_suptitle()) == (name != "pattern")


@pytest.mark.parametrize("changed", [{"protocol.timestep": "5 ms"}, {"crease.stiffness": "1 kN m/rad/m"}])
def test_a_diverging_sheet_gives_no_arithmetic_warnings(changed):
    # warnings are errors in tests
    record = ff.run(ff.load_design("miura-sheet", changed), confirm=False)
    outcome = measure(record)
    run_warnings(record)
    summary(record, outcome, {})
    assert outcome.verdict is Verdict.DIVERGED


def test_figures_of_a_diverged_run_are_marked(capsys):
    record = ff.run(with_values(REFERENCE, {"protocol.timestep": "5 ms"}), confirm=False)
    outcome = measure(record)
    for name, drawing in run_drawings(record, outcome).items():
        assert ("Diverged at t = " in drawing(7.0).get_suptitle()) == (name != "pattern")
    print_outcome("wild", outcome)
    assert "diverged at t = " in capsys.readouterr().out
