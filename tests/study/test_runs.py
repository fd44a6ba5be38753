"""Automatic timesteps are found by halving, and the result depends only on the design."""

import dataclasses
import itertools

import pytest

import forficula as ff
from forficula.analysis import Verdict, measure
from forficula.cli import main
from forficula.design import load_design, with_values
from forficula.dynamics import with_timestep
from forficula.study.running import numerical_settings, runs
from forficula.study.running.evaluate import evaluate
from forficula.study.running.runs import run, run_each

SETTLE = {"name": "settle", "drive": "none", "until": "time", "hold": "0 s", "time_limit": "10 ms"}
FOLD = {"name": "fold", "drive": "fold", "until": "folded", "hold": "0 s", "time_limit": "0.1 s"}


def auto(**values):
    provided = {key.replace("__", "."): value for key, value in values.items()}
    return load_design("binder2025", {"protocol.timestep": "auto", "protocol.stages": [SETTLE, FOLD], **provided})


DESIGNS = [
    auto(),
    auto(tendon__rest_length="7 cm"),
    auto(membrane__youngs_modulus="5 MPa"),
    auto(protocol__fold_torque="60 N cm"),
    auto(protocol__timestep="0.2 ms"),
]


def test_rows_do_not_depend_on_order_other_designs_or_threads():
    together = {row["key"]: row for row in evaluate(DESIGNS)}
    assert {row["key"]: row for row in evaluate(DESIGNS[::-1], threads=1)} == together
    for design in DESIGNS:
        (alone,) = evaluate([design], threads=2)
        assert together[alone["key"]] == alone
    assert len(together) == len(DESIGNS)


def test_a_given_timestep_is_used():
    assert run(DESIGNS[4]).design == DESIGNS[4]


def test_running_the_design_of_a_record_again_gives_the_same_bits():
    record = run(DESIGNS[0])
    timestep = record.design.protocol.timestep
    assert isinstance(timestep, float)
    again = run(with_values(DESIGNS[0], {"protocol.timestep": timestep}))
    assert again.design == record.design
    for name, values in again.series.items():
        assert values.tobytes() == record.series[name].tobytes()


@pytest.mark.usefixtures("undrawn")
def test_design_file_of_a_run_has_the_automatic_timestep(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    limit = {"protocol.stages.0.time_limit": "10 ms", "protocol.stages.1.time_limit": "20 ms"}
    settings = [f"--set={key}={value}" for key, value in (limit | {"protocol.timestep": "auto"}).items()]
    with pytest.raises(SystemExit) as ended:
        main(["run", "binder2025", *settings, "--out", "there"])
    # still moving when its time limit ends
    assert ended.value.code == 2
    assert "still moving" in capsys.readouterr().out
    kept = ff.load_design(tmp_path / "there" / "design.toml")
    assert kept.protocol.timestep == ff.load_run(tmp_path / "there" / "record.nc").design.protocol.timestep
    assert isinstance(kept.protocol.timestep, float)


def test_a_design_whose_first_timestep_diverges_ends_reliable(monkeypatch):
    tried, design = [], auto(membrane__youngs_modulus="30 MPa", protocol__fold_torque="200 N cm")
    # as if the estimate were much too long
    estimate = float(with_timestep(design).protocol.timestep)
    longer = with_values(design, {"protocol.timestep": 16 * estimate})
    monkeypatch.setattr(
        numerical_settings, "with_timestep", lambda item: longer if item.protocol.timestep == "auto" else item
    )
    # longer by this factor, hence more halvings
    monkeypatch.setattr(numerical_settings, "_HALVINGS", numerical_settings._HALVINGS + 4)
    monkeypatch.setattr(runs, "measure", lambda record: tried.append(measure(record)) or tried[-1])
    outcome = measure(run(design))
    assert tried[0].verdict is Verdict.DIVERGED
    assert outcome.verdict.conclusive
    assert outcome.ending.residual <= 0.005


def test_the_timestep_is_accepted_when_the_outcome_is_stable(monkeypatch):
    tried = []
    monkeypatch.setattr(runs, "measure", lambda record: tried.append((record, measure(record))) or tried[-1][1])
    record = run(DESIGNS[0])
    steps = [float(item.design.protocol.timestep) for item, _ in tried]
    assert len(steps) >= 3
    assert all(later <= earlier / 2 for earlier, later in itertools.pairwise(steps))
    assert float(record.design.protocol.timestep) == steps[-1]
    last = tried[-1][1]
    for _, outcome in tried[-3:-1]:
        assert outcome.verdict is last.verdict
        assert outcome.transitions["fold"].time == pytest.approx(last.transitions["fold"].time, rel=0.02)


def test_a_run_whose_outcome_never_stabilises_is_reported_as_unreliable(monkeypatch):
    """A wing that folds at every second timestep, as if it were at a boundary between outcomes."""
    number = [0]

    def flips(record):
        number[0] += 1
        outcome = measure(record)
        if number[0] % 2 or record.doubt:
            return outcome
        return dataclasses.replace(outcome, ending=dataclasses.replace(outcome.ending, verdict=Verdict.STUCK))

    monkeypatch.setattr(runs, "measure", flips)
    # few and long steps, so that it is quick
    monkeypatch.setattr(numerical_settings, "_HALVINGS", 3)
    ((_, record),) = run_each([DESIGNS[0]])
    outcome = measure(record)
    assert record.doubt
    assert outcome.verdict is Verdict.UNTRUSTED
    assert outcome.holds["folded"] is None
    assert outcome.status == f"unreliable: {record.doubt}"
