"""The advice on a failing run helps, names values that a design can have, and is omitted where it would not help."""

import re

import numpy as np
import pytest

from forficula.analysis import Verdict, measure
from forficula.analysis.margin import combined_margin, transition_margins
from forficula.design import load_design, with_values
from forficula.study.running.runs import run_each
from tests.analysis.test_outcome import ENDS, planted
from tests.analysis.test_verdict import moving

# the wings of `benchmarks/advice.py` fail for more reasons but take minutes; a joint takes milliseconds
DESIGNS = 14


def joints():
    """Return random joints, drawn with a fixed seed; most of them fail."""
    rng = np.random.default_rng(4)

    def log(least, most):
        return float(np.exp(rng.uniform(np.log(least), np.log(most))))

    return [
        load_design(
            "binder2025-joint",
            {
                "tendon.stiffness": f"{log(3, 60)} N/cm",
                "tendon.rest_length": f"{rng.uniform(5, 12)} cm",
                "protocol.fold_torque": f"{log(2, 50)} N cm",
                "protocol.unfold_torque": f"{log(5, 150)} N cm",
                "protocol.stages.push.time_limit": f"{log(0.05, 1)} s",
                "protocol.stages.snap.time_limit": "0.5 s",
                "protocol.timestep": "0.2 ms",
            },
        )
        for _ in range(DESIGNS)
    ]


def outcomes(designs):
    result = {}
    for number, record in run_each(designs, sparse=True):
        outcome = measure(record)
        result[number] = outcome, combined_margin(list(transition_margins(record, outcome).values()))
    return [result[number] for number in range(len(designs))]


@pytest.fixture(scope="module")
def advised():
    """Return design, outcome and margin of the failing joints that have an advice."""
    designs = joints()
    result = [(design, *outcome) for design, outcome in zip(designs, outcomes(designs), strict=True)]
    return [item for item in result if item[1].advised.values]


def test_each_advice_helps_nine_of_ten_failing_joints(advised):
    assert len(advised) >= 8
    assert len({outcome.advised.kind for _, outcome, _ in advised}) >= 3
    again = outcomes([with_values(design, outcome.advised.values) for design, outcome, _ in advised])
    helped = [
        new.verdict is Verdict.REACHED or (new.verdict.conclusive and better > margin)
        for (_, _, margin), (new, better) in zip(advised, again, strict=True)
    ]
    assert sum(helped) >= 0.9 * len(helped)


def test_the_advice_names_the_keys_that_a_design_takes_and_their_values(advised):
    for design, outcome, _ in advised:
        for key in outcome.advised.values:
            assert key in outcome.advice
            if key.endswith("time_limit"):  # the key contains the stage's name, as for --set
                assert load_design("binder2025-joint", {key: "3 s"}).protocol != design.protocol


def test_a_wing_that_moves_away_from_its_goal_is_not_advised_to_take_more_time():
    away = moving(planted((0.2, 0.3, 0.4), (0, -141, -133), ends=ENDS[:2], goals=(None, None)))
    towards = moving(planted((0.2, 0.3, 0.4), (0, -133, -141), ends=ENDS[:2], goals=(None, None)))
    assert measure(away).advised.values == {}
    assert (
        measure(away).advice
        == 'In the last 100 ms of the stage "fold" it approached its goal no faster than a structure at rest.'
    )
    assert list(measure(towards).advised.values) == ["protocol.stages.fold.time_limit"]


def test_more_torque_is_advised_only_where_statics_find_that_it_is_enough():
    weak = load_design("binder2025-joint", {"protocol.fold_torque": "4 N cm"})
    barred = with_values(weak, {"tendon.stiffness": "300 N/cm"})
    (enough, _), (none, _) = outcomes([weak, barred])
    assert (enough.verdict, none.verdict) == (Verdict.STUCK, Verdict.STUCK)
    assert enough.advised.values["protocol.fold_torque"] == pytest.approx(1.2 * enough.advised.least_torque, rel=0.1)
    assert re.fullmatch(
        r"Raise protocol.fold_torque from 4 N cm to \d+ N cm: a slowly growing torque of [\d.]+ N cm makes it fold.",
        enough.advice,
    )
    assert none.advice.startswith("No slowly growing torque up to 40 N cm makes it fold.")
    assert "protocol.fold_torque" not in none.advised.values
