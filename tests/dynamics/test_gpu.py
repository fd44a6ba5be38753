"""Runs on a device, by MuJoCo Warp: the same protocol, other arithmetic. Its device "warp-cpu" needs no hardware."""

import os
import sys

import numpy as np
import pytest

import forficula as ff
from forficula.analysis import measure, run_warnings
from forficula.analysis.summary import summary
from forficula.dynamics import compile_model, load_record, save_record, versions
from forficula.dynamics.gpu.device import check_available, check_device
from forficula.dynamics.stepping.stages import StageTracker
from forficula.dynamics.stepping.stepper import Stepper
from forficula.study.running.evaluate import evaluate, row_key
from forficula.study.running.runs import run_each

MISSING = 'MuJoCo Warp is not there: pip install "forficula[gpu]", or make test-gpu'
# set by make test-gpu: these tests then fail without MuJoCo Warp
DEMANDED = "FORFICULA_GPU" in os.environ
ON_DEVICE = {"protocol.device": "warp-cpu"}


@pytest.fixture(scope="module")
def warp():
    """Skip the test where MuJoCo Warp is not installed."""
    if DEMANDED:
        import mujoco_warp  # noqa: F401
    else:
        pytest.importorskip("mujoco_warp", reason=MISSING)


@pytest.fixture(scope="module")
def joint():
    return ff.load_design("binder2025-joint")


@pytest.fixture(scope="module")
def records(warp, joint):  # noqa: ARG001
    """Records of a joint that folds and of one whose torque is too small, in double and in single precision."""
    weak = joint.with_values({"protocol.fold_torque": joint.protocol.fold_torque / 20})
    designs = [joint, weak]
    placed = [design.with_values(ON_DEVICE) for design in designs]
    return [dict(run_each(some)) for some in (designs, placed)]


def test_cpu_is_the_device_of_a_design_without_one(joint):
    named = joint.with_values({"protocol.device": "cpu"})
    assert named == joint
    assert named.hash == joint.hash
    assert joint.with_values({"protocol.device": "gpu"}).hash != joint.hash


def test_an_unknown_device_is_refused(joint):
    with pytest.raises(ff.InputError, match=r'protocol.device: need "cpu", "gpu" or "warp-cpu", got "tpu"'):
        joint.with_values({"protocol.device": "tpu"})


def test_missing_extra_is_reported_with_its_installation(monkeypatch, joint):
    monkeypatch.setitem(sys.modules, "mujoco_warp", None)
    monkeypatch.setitem(sys.modules, "warp", None)
    monkeypatch.setattr("forficula.dynamics.gpu.device.find_spec", lambda _: None)
    with pytest.raises(ff.InputError, match=r'pip install "forficula\[gpu\]"; "cpu" needs no further package'):
        ff.run(joint, device="gpu", confirm=False)


def test_a_computer_without_a_graphics_processor_refuses_it_in_one_line(monkeypatch):
    monkeypatch.setattr("forficula.dynamics.gpu.device.find_spec", lambda _: object())
    monkeypatch.setattr("forficula.dynamics.gpu.device._has_driver", lambda: False)
    with pytest.raises(ff.InputError, match=r'^protocol.device: need "cpu" on this computer.*, got "gpu"$'):
        check_available("gpu")


@pytest.mark.parametrize(
    ("name", "values", "reason"),
    [
        ("miura-sheet", {}, "creases of sheets and nets"),
        ("binder2025", {"protocol.contact": True}, "the number of contacts differs"),
    ],
)
def test_structures_that_stay_on_the_processor_are_refused_with_the_reason(name, values, reason):
    design = ff.load_design(name).with_values({**values, "protocol.device": "warp-cpu"})
    with pytest.raises(
        ff.InputError, match=rf'{name}: protocol.device: need "cpu", because {reason}.*, got "warp-cpu"'
    ):
        check_device(compile_model(design))


def test_single_precision_reaches_the_same_verdicts_at_the_same_steps(records):
    for row in range(2):
        double, single = (measure(part[row]) for part in records)
        assert (single.verdict, single.status) == (double.verdict, double.status)
    double, single = (part[0] for part in records)
    assert [end.goal_time for end in single.stages] == [end.goal_time for end in double.stages]
    assert single.series["hinge_angle"].shape == double.series["hinge_angle"].shape
    # measured: 2e-5 rad
    assert np.abs(single.series["hinge_angle"] - double.series["hinge_angle"]).max() < 2e-4


def test_the_energy_balance_closes_in_single_precision(records):
    double, single = (measure(part[0]).energy_balance for part in records)
    assert single.residual == pytest.approx(double.residual, abs=1e-5)
    assert single.exchanged == pytest.approx(double.exchanged, rel=1e-4)


def test_results_state_their_precision(records, tmp_path):
    double, single = (part[0] for part in records)
    assert any("single precision" in text for text in run_warnings(single))
    assert not any("precision" in text for text in run_warnings(double))
    written = summary(single, measure(single), versions("warp-cpu"))
    assert written["precision"] == "single"
    assert "mujoco-warp" in written["versions"]
    assert "precision" not in summary(double, measure(double), versions())
    save_record(single, tmp_path / "record.nc")
    assert load_record(tmp_path).design.protocol.device == "warp-cpu"


@pytest.mark.usefixtures("warp")
def test_a_table_states_the_precision_of_every_point(joint):
    short = joint.with_values({"protocol.stages.1.time_limit": 0.01, "protocol.stages.2.time_limit": 0.01})
    table = ff.new_study(short, {"protocol.device": ["cpu", "warp-cpu"]}).run()
    assert table["precision"].values.tolist() == ["double", "single"]
    assert len(set(table["status"].values.tolist())) == 1


def test_rows_of_a_device_are_not_taken_for_rows_in_double_precision(joint):
    assert row_key(joint) != row_key(joint.with_values(ON_DEVICE))


@pytest.mark.usefixtures("warp")
def test_structures_on_one_device_may_differ_in_tendons(joint):
    stiff = [joint.with_values({"tendon.area": factor * joint.tendon.area}) for factor in (0.8, 0.9, 1.0)]
    double = [row["fold_work_J"] for row in sorted(evaluate(stiff), key=lambda row: row["key"])]
    rows = {row["key"]: row for row in evaluate([design.with_values(ON_DEVICE) for design in stiff])}
    keys = {row_key(design.with_values(ON_DEVICE)): row_key(design) for design in stiff}
    single = [row["fold_work_J"] for _, row in sorted(rows.items(), key=lambda item: keys[item[0]])]
    assert single == pytest.approx(double, rel=1e-4)


@pytest.mark.usefixtures("warp")
def test_the_device_finds_the_same_ends_of_stages_as_the_processor():
    """Compare the passage through a chunk that the kernel finds with that of the same numbers on the processor."""
    pull = {"name": "pull", "drive": "pull", "until": "rest", "hold": "0 s", "time_limit": "0.2 s"}
    stages = ff.load_design("two-clasps").as_tables()["protocol"]["stages"]
    design = ff.load_design("two-clasps", {"protocol.stages": [pull, *stages]}).with_values(ON_DEVICE)
    models = [compile_model(design)] * 3
    stepper, tracker = Stepper(models, 1, True, 200), StageTracker(models)
    rows = np.arange(3)
    try:
        for _ in range(12):
            torques = tracker.torques(rows, 200)
            steps = stepper.start(rows, tracker.controls(rows, torques), torques).result()
            conditions = tracker._conditions(rows)
            on_device = steps.passage(conditions)
            # as arrays, on the processor
            expected = type(steps).__mro__[1].passage(steps, conditions)
            assert on_device.end.tolist() == expected.end.tolist()
            assert on_device.sound.tolist() == expected.sound.tolist()
            for name in ("goal_since", "held", "resting", "reached"):
                ended = on_device.end <= 200
                assert getattr(on_device, name)[ended].tolist() == getattr(expected, name)[ended].tolist()
            for name in ("carried_goal", "carried_rest"):
                assert getattr(on_device, name)[~ended].tolist() == getattr(expected, name)[~ended].tolist()
            taken = tracker.follow(rows, steps)
            stepper.take_back(rows, steps, taken)
            rows = np.flatnonzero(~tracker.ended)
            if not len(rows):
                break
    finally:
        stepper.close()


@pytest.mark.usefixtures("warp")
def test_divergence_is_found_on_the_device(joint):
    wild = joint.with_values({"protocol.timestep": 0.02, **ON_DEVICE})
    assert measure(ff.run(wild, confirm=False).record).verdict in ("diverged", "untrusted")
