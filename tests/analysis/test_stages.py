"""Results of every stage: its drive, its goal, its duration, and the work of its torques."""

import json
import math
from dataclasses import replace

import numpy as np
import pytest

import forficula as ff
from forficula.analysis import Verdict, measure, summary
from forficula.analysis.margin import transition_margins
from forficula.design import load_design, with_values
from forficula.study.running.runs import run
from tests.analysis.test_outcome import ENDS, FOLDS_AND_OPENS, REFERENCE, planted
from tests.elastic_joint import stage as stage_of

NAMES = ["settle", "fold", "release folded", "unfold", "release opened"]


def test_every_stage_of_the_reference_says_its_drive_its_goal_and_its_time(reference_run, reference_outcome):
    stages = reference_outcome.stages
    assert [stage.name for stage in stages] == NAMES
    assert [stage.drive for stage in stages] == [(), ("fold",), (), ("unfold",), ()]
    assert [stage.goal for stage in stages] == ["time", "folded", "rest", "opened", "rest"]
    assert [stage.reached for stage in stages] == [None, True, True, True, True]
    for stage, end in zip(stages, reference_run.stages, strict=True):
        moment = end.end if end.goal_time is None else end.goal_time
        assert stage.time == moment - end.start
    assert [stages[place].time for place in (1, 3)] == [
        reference_outcome.transitions[name].time for name in ("fold", "unfold")
    ]


def test_the_works_of_the_stages_add_up_to_that_of_the_balance(reference_outcome):
    works = [stage.work for stage in reference_outcome.stages]
    assert [works[place] for place in (0, 2, 4)] == [0, 0, 0]
    assert works[1] == reference_outcome.transitions["fold"].work
    assert works[3] == reference_outcome.transitions["unfold"].work
    # rounding of sums over 1e4 steps
    assert sum(works) == pytest.approx(reference_outcome.energy_balance.work, rel=1e-12)


def test_the_summary_has_every_stage_under_its_name(reference_run, reference_outcome):
    plain = json.loads(json.dumps(summary(reference_run, reference_outcome, {}), allow_nan=False))
    assert list(plain["stages"]) == NAMES
    for stage in reference_outcome.stages:
        assert plain["stages"][stage.name] == {
            "drive": stage.drive[0] if stage.drive else "none",
            "goal": stage.goal,
            "reached": stage.reached,
            "time_s": stage.time,
            "work_J": stage.work,
        }
    assert sum(item["work_J"] for item in plain["stages"].values()) == pytest.approx(
        plain["energy_balance"]["work_J"], rel=1e-12
    )


def test_a_stage_that_missed_its_goal_has_no_time_and_those_after_it_are_not_there():
    outcome = measure(planted((0.3, 0.4), (0, -4), ends=ENDS[:2], goals=(None, None)))
    assert [stage.name for stage in outcome.stages] == NAMES[:2]
    settle, fold = outcome.stages
    # a stage that ends by its time limit took that time
    assert (settle.reached, settle.time) == (None, pytest.approx(0.3))
    assert (fold.reached, fold.time) == (False, None)


def test_the_time_of_a_stage_is_until_its_goal_and_not_until_its_end():
    outcome = measure(planted(**FOLDS_AND_OPENS, goals=(None, 0.35, 0.6, 0.8, 1.1)))
    assert [stage.time for stage in outcome.stages] == pytest.approx([0.3, 0.05, 0.2, 0.1, 0.2])


def test_an_unreliable_run_reports_no_goals():
    doubtful = replace(planted(**FOLDS_AND_OPENS), doubt="its outcome still changes with the timestep")
    assert [stage.reached for stage in measure(doubtful).stages] == [None] * 5


def test_a_stage_with_a_list_of_drives_says_all_of_them():
    design = with_values(REFERENCE, {"protocol.stages.1.drive": ["fold"]})
    record = planted(**FOLDS_AND_OPENS, design=design)
    assert summary(record, measure(record), {})["stages"]["fold"]["drive"] == "fold"
    # two drives at once, which a fan does not have
    fold = record.stages[1].stage.model_copy(update={"drive": ("fold", "unfold")})
    both = replace(record, stages=(record.stages[0], replace(record.stages[1], stage=fold), *record.stages[2:]))
    outcome = measure(both)
    assert outcome.stages[1].drive == outcome.transitions["fold"].drives == ("fold", "unfold")
    assert summary(both, outcome, {})["stages"]["fold"]["drive"] == ["fold", "unfold"]


@pytest.mark.parametrize("torque", ["5 N cm", "500 N cm"])
def test_works_of_stages_add_up_in_failed_runs(torque):
    values = {"protocol.fold_torque": torque, "protocol.stages.1.time_limit": "0.1 s", "protocol.timestep": "0.1 ms"}
    outcome = measure(ff.run(with_values(REFERENCE, values), confirm=False))
    works = [stage.work for stage in outcome.stages]
    assert sum(works) == pytest.approx(outcome.energy_balance.work, rel=1e-12)


def flap(**values):
    """Two plates on a hinge without a spring, which two drives open one after the other; the goal is on a distance."""
    stages = [
        stage_of("close", "close", "creases > 170 deg", state="closed"),
        stage_of("open", "open", "time", 0.1),
        stage_of("open further", "open", "rest", 0.5),
        stage_of("press", "open", "time", 0.05),
        stage_of("release", "none", "creases < 1 deg", 0.1),
        stage_of("straight", "none", "span > 6.99 cm", 0.1, state="opened"),
    ]
    quick = {f"drive.{name}.no_load_speed": None for name in ("close", "open")}
    quick |= {"drive.close.value": 0.04, "drive.open.value": -0.04, "protocol.timestep": 2.5e-4}
    return with_values(load_design("earwig-hindwing").base, quick | {"protocol.stages": stages, **values})


def test_time_and_work_of_a_transition_are_those_of_all_stages_since_the_previous_state():
    record = run(flap())
    outcome = measure(record)
    close, press = outcome.transitions["close"], outcome.transitions["press"]
    works = [made.work for made in outcome.stages]
    assert outcome.verdict is Verdict.REACHED
    assert close.work == works[0]
    assert press.work == pytest.approx(sum(works[1:4]), rel=1e-12)
    assert press.work == pytest.approx(0.04 * math.radians(170), rel=0.05)
    assert press.time == pytest.approx(record.stages[4].goal_time - record.stages[1].start)
    assert 0 < transition_margins(record, outcome)["press"] < 1


def test_a_state_is_missed_if_the_stage_that_ends_in_it_misses_its_own_goal():
    record = run(flap(**{"crease.back_limit": math.radians(90)}))
    outcome = measure(record)
    assert record.stages[4].goal_time is not None
    assert np.degrees(record.series["hinge_angle"][-1, 0]) == pytest.approx(-90, abs=1)
    assert outcome.verdict is not Verdict.REACHED
    assert outcome.status == 'missed the goal of stage "straight"'
    assert outcome.holds == {"closed": True, "opened": False}
    assert outcome.transitions["press"].time is None
    assert -1 < transition_margins(record, outcome)["press"] < 0
