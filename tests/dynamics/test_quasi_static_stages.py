"""Stages that statics computes, between stages that are simulated."""

import numpy as np
import pytest

from forficula.analysis import Verdict, measure
from forficula.analysis.summary import summary
from forficula.design import load_design, with_values
from forficula.dynamics import compile_model, load_record, save_record, simulate, versions, why_not_portable
from forficula.errors import InputError
from forficula.quantities import show_value
from forficula.show.run.outcome_rows import quasi_static_text
from forficula.study.running.runs import run, run_each
from tests.elastic_joint import FOLDED, FOLDING, STRENGTH, energy, joint, moment, slow, stage

VISCOUS = {"linear_modulus": 1e6, "branches": [{"modulus": 6e5, "time": 4.0}]}
HALF, REST = "distal_angle > -120 deg", np.radians(120)


@pytest.fixture(scope="module")
def loaded():
    """The joint, opened slowly to 120 deg and unloaded slowly."""
    return run(joint(slow("load", "unfold", HALF), slow("unload", "none", "rest")))


def angles(record):
    return -record.series["hinge_angle"][:, 0]


def rows_of(record, number):
    end = record.stages[number]
    return (record.time >= end.start) & (record.time < end.end)


def test_a_structure_rests_while_its_drive_grows(loaded):
    rows = rows_of(loaded, 3) & (loaded.series["kinetic_energy"] == 0)
    assert rows.sum() > 20
    # the drive grows evenly over the time limit
    rate = np.diff(moment(angles(loaded)[rows])[-20:-10]) / np.diff(loaded.time[rows][-20:-10])
    assert rate == pytest.approx(STRENGTH / 90, rel=1e-3)
    assert loaded.stages[3].share * STRENGTH == pytest.approx(moment(REST), rel=1e-8)
    assert loaded.stages[3].goal_time == loaded.stages[3].end


def test_slow_unloading_returns_the_work_of_slow_loading(loaded):
    load, unload = measure(loaded).stages[-2:]
    assert load.work == pytest.approx(energy(REST) - energy(FOLDED), rel=1e-6)
    assert unload.work == pytest.approx(-load.work, rel=1e-6)
    assert angles(loaded)[-1] == pytest.approx(FOLDED)
    assert loaded.stages[4].at_rest
    assert loaded.stages[4].share == 1


def test_a_moving_structure_comes_to_rest_before_statics_takes_over():
    stages = [*FOLDING[:2], slow("load", "unfold", HALF)]
    record = run(joint(**{"protocol.stages": stages}))
    rows, outcome = rows_of(record, 2), measure(record)
    assert record.series["kinetic_energy"][rows].max() > 0.01
    assert record.stages[2].share * STRENGTH == pytest.approx(moment(REST), rel=1e-8)
    assert record.stages[2].lost == ()
    assert outcome.energy_balance.residual < 5e-3
    assert outcome.energy_balance.settling is not None


def test_a_snap_that_meets_the_goal_ends_a_slow_stage_and_a_slow_stage_after_it_first_comes_to_rest():
    record = run(joint(slow("open", "unfold", "opened"), slow("unload", "none", "rest")))
    opened, unload = record.stages[3:]
    assert len(opened.lost) == 1
    assert not opened.at_rest
    last = int(np.argmin(np.abs(record.time - opened.end)))
    assert angles(record)[last] == pytest.approx(0, abs=0.01)
    assert record.series["kinetic_energy"][last] > 1e-3
    # the torque keeps the joint at its stop while it comes to rest, and then falls to 0
    assert (unload.share, unload.lost, unload.at_rest) == (1.0, (), True)
    assert np.degrees(angles(record)[-1]) == pytest.approx(-3)
    assert measure(record).energy_balance.residual < 1e-3


def test_a_hinge_without_a_spring_creeps_from_stop_to_stop_in_slow_stages_one_after_another():
    torque, damping, width = 0.04, 5e-2, 0.08
    stages = [
        stage("close", "close", "creases > 170 deg"),
        slow("open", "open", "creases < 1 deg", 10.0),
        slow("close again", "close", "rest", 10.0),
        slow("open again", "open", "rest", 10.0),
    ]
    # the two plates of the claval line of the hindwing, with motors that do not brake
    design = with_values(
        load_design("earwig-hindwing").base,
        {
            **{f"drive.{name}.no_load_speed": None for name in ("close", "open")},
            **{"drive.close.value": torque, "drive.open.value": -torque},
            **{"protocol.timestep": 2.5e-4, "protocol.window": 0.05, "protocol.stages": stages},
        },
    )
    record = run(design)
    opened, closed, last = record.stages[1:]
    assert [end.goal_time is not None for end in record.stages] == [True] * 4
    # the smallest excess of the drive over 0 turns the hinge more slowly than the speed of rest
    speed = 1e-4 * torque / (damping * width)
    assert speed < np.radians(2)
    assert opened.lost == (0.0,)
    assert opened.end - opened.start < 0.2
    assert last.end - closed.start < 20.5
    outcome, turn = measure(record), np.radians(175)
    assert outcome.stages[1].work == pytest.approx(opened.share * torque * turn, rel=1e-6)
    # the drive of the stage before acts against the turn until it has fallen to 0
    assert closed.lost[0] == pytest.approx(opened.share / (1 + opened.share), abs=1e-6)
    assert last.lost[0] == pytest.approx(0.5, abs=1e-6)
    assert np.degrees(record.series["hinge_angle"][-1, 0]) == pytest.approx(0, abs=1e-6)
    assert outcome.energy_balance.residual < 1e-6


def test_a_slow_stage_without_rest_ends_the_run():
    record = run(joint(slow("load", "unfold", HALF, 0.01), stage("release")))
    assert len(record.stages) == 4
    assert not record.stages[3].at_rest
    assert measure(record).verdict is Verdict.MOVING


def test_a_weak_drive_ends_a_slow_stage_at_its_full_strength_short_of_the_goal():
    record = run(joint(slow("load", "unfold", HALF), **{"protocol.unfold_torque": 0.2}))
    assert record.stages[3].share == 1
    assert record.stages[3].goal_time is None
    assert measure(record).verdict is Verdict.STUCK


def test_results_do_not_depend_on_other_runs_beside_them():
    designs = [
        joint(slow("load", "unfold", HALF), stage("release", "none", "rest")),
        joint(slow("load", "unfold", HALF), slow("unload", "none", "rest")),
        joint(slow("load", "unfold", HALF), **{"protocol.unfold_torque": 1.9}),
        joint(stage("load", "unfold", HALF)),
    ]
    together = dict(run_each(designs))
    for number in (1, 2):
        alone = run(designs[number])
        assert np.array_equal(alone.time, together[number].time)
        assert all(np.array_equal(values, together[number].series[name]) for name, values in alone.series.items())
    ((_, sparse),) = run_each(designs[1:2], sparse=True)
    assert measure(sparse).stages == measure(together[1]).stages
    assert measure(sparse).energy_balance == measure(together[1]).energy_balance


def test_a_file_keeps_how_far_the_drive_of_a_slow_stage_has_grown(loaded, tmp_path):
    save_record(loaded, tmp_path / "record.nc")
    read = load_record(tmp_path / "record.nc")
    assert read.stages == loaded.stages
    assert np.array_equal(read.series["settling_work"], loaded.series["settling_work"])


def test_outcomes_name_the_slow_stages(loaded):
    outcome = measure(loaded)
    stages = summary(loaded, outcome, versions())["stages"]
    assert stages["load"]["motion"] == "quasi-static"
    assert "motion" not in stages["push"]
    text = quasi_static_text(loaded.structure, outcome)
    assert f'"load" ended at {show_value(moment(REST), "N m")}' in text
    assert '"unload" ended at 100 % of the change of its drives' in text


def test_simulation_needs_a_static_solver_for_slow_stages():
    with pytest.raises(InputError, match='the stage "load" is quasi-static: need a static solver'):
        simulate([compile_model(joint(slow("load", "unfold", HALF)))])


def test_a_page_does_not_simulate_slow_stages():
    model = compile_model(joint(slow("load", "unfold", HALF)))
    assert why_not_portable(model) == "a quasi-static stage is computed by statics"


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"tendon.law": VISCOUS, "tendon.stiffness": None, "tendon.damping": None}, "has Maxwell branches"),
        ({"hinge.friction": 1e-3}, "dry friction"),
    ],
)
def test_structures_that_statics_cannot_solve_are_refused_with_the_stage_and_the_reason(values, message):
    ((_, error),) = run_each([joint(slow("load", "unfold", HALF), **values)])
    assert isinstance(error, InputError)
    assert str(error).startswith('protocol.stages.3.motion: need "dynamic" for the stage "load" of binder2025-joint')
    assert message in str(error)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"motion": "slow"}, r'protocol.stages.1.motion: need "dynamic" or "quasi-static", got "slow"'),
        ({"motion": "quasi-static", "hold": 0.1}, r"protocol.stages.1.hold: need 0 s in a quasi-static stage"),
        (
            {"motion": "quasi-static", "until": "rest", "wait": 1.0},
            r"protocol.stages.1.wait: need 0 s in a quasi-static stage",
        ),
    ],
)
def test_keys_that_contradict_a_slow_stage_are_refused(values, message):
    stages = [stage("settle"), {**stage("push", "fold", "distal_angle < -20 deg"), **values}]
    with pytest.raises(InputError, match=message):
        joint(**{"protocol.stages": stages})


def test_a_slow_stage_with_contact_of_bars_is_refused():
    slow_fold = {"protocol.contact": True, "protocol.stages.1.motion": "quasi-static"}
    ((_, error),) = run_each([with_values(load_design("binder2025"), slow_fold)])
    assert 'protocol.stages.1.motion: need "dynamic"' in str(error)
    assert "because statics ignores contact of its bars and panels" in str(error)


def test_a_stage_is_dynamic_unless_it_says_otherwise():
    plain = joint(stage("load", "unfold", HALF))
    assert joint(stage("load", "unfold", HALF, motion="dynamic")).hash == plain.hash
    assert joint(slow("load", "unfold", HALF, 2.0)).hash != plain.hash


def test_a_slow_cycle_without_losses_is_compared_with_the_work_of_its_stages():
    strip = with_values(
        load_design("letter-fold"),
        {
            "tendon": [],
            "pattern.panels": 2,
            "crease.start": "0 deg",
            "support": [{"of": "facet 0"}],
            "protocol.stages": [
                {**stage, "until": "time", "time_limit": "5 s", "motion": "quasi-static"}
                for stage in (
                    {"name": "load", "drive": "close", "state": "loaded"},
                    {"name": "unload", "drive": "none", "state": "unloaded"},
                )
            ],
        },
    )
    outcome = measure(run(strip))
    assert outcome.energy_balance.exchanged >= 2 * outcome.stages[0].work * 0.99
    assert outcome.energy_balance.residual < 1e-6
    # a state is the equilibrium at the end of its stage, not a mean over angles under a growing drive
    angle = np.degrees(0.03 / (0.02 * 0.21))
    assert np.degrees(outcome.states["loaded"].readings["creases"].mean) == pytest.approx(min(angle, 175), abs=1e-3)
