"""Repetitions at half the timestep that end as soon as their outcome is certain."""

import numpy as np
import pytest

import forficula as ff
from forficula.analysis import measure
from forficula.design import with_values
from forficula.dynamics import Record
from forficula.study.running import evaluate as evaluate_module
from forficula.study.running.certain_ending import certain_ending
from forficula.study.running.evaluate import evaluate
from forficula.study.running.runs import run_each

WING = ff.load_design("binder2025")
STAGES = WING.protocol.stages
KEPT = with_values(WING, {"tendon.rest_length": "5 cm", "protocol.stages": STAGES[:3]})
SHORT = with_values(
    WING,
    {
        "tendon.rest_length": "2 cm",
        "protocol.stages": STAGES[:4],
        "protocol.rest_speed": "10 deg/s",
        "protocol.fold_torque": "500 N cm",
        "protocol.unfold_torque": "10 N cm",
    },
)


@pytest.mark.parametrize(("design", "outcome"), [(KEPT, "folded"), (SHORT, "did not open")])
def test_a_repetition_ends_early_and_its_row_keeps_its_bits(monkeypatch, design, outcome):
    ends = []

    def watched(designs, *arguments, **options):
        for number, record in run_each(designs, *arguments, **options):
            ends.append(record.time[-1])
            yield number, record

    monkeypatch.setattr(evaluate_module, "run_each", watched)
    (early,) = evaluate([design])
    monkeypatch.setattr(evaluate_module, "certain_ending", lambda *_: None)
    (complete,) = evaluate([design])
    assert early == complete
    assert (early["outcome"], early["confirmed"]) == (outcome, True)
    _, half, _, whole = ends
    assert half < whole - 0.1


def test_an_ending_is_not_certain_with_other_loads_or_goals():
    def ending(values, stages=STAGES[:3]):
        design = with_values(KEPT, {"protocol.stages": stages, **values})
        ((_, record),) = run_each([design], sparse=True)
        assert isinstance(record, Record)
        return certain_ending(record, measure(record))

    certain = ending({})
    assert (certain.stage, certain.kept) == (2, True)
    folded = np.where(np.isfinite(certain.goal.most[:12]), np.radians(-170.0), 0.0)
    assert certain.is_certain(0.0, folded, 0.1)
    assert not certain.is_certain(0.0, folded, 10.0)
    assert ending({"protocol.gravity": "9.81 m/s^2"}) is None
    # the last stage reached its goal under the drive
    assert ending({}, STAGES[:2]) is None
