"""A run warns where its tendons stretch far faster than in the tests of their material."""

from dataclasses import replace
from importlib import import_module
from types import MappingProxyType

import numpy as np
import pytest

from forficula.analysis import Verdict, measure, summary
from forficula.analysis.run_warnings import highest_strain_rates, run_warnings
from forficula.analysis.strength import Peak, membrane_peaks
from forficula.design import load_design, with_values
from forficula.dynamics import Record, energy_balance, load_record, save_record
from forficula.structure import structure_of
from forficula.study.running.runs import run
from tests.analysis.test_outcome import ENDS, planted

LENGTH = 0.06


def design(**law):
    values = {"linear_modulus": 4.8e6, "name": "tpu", "highest_strain_rate": 0.1} | law
    settings = {"tendon.law": values, "tendon.area": 12.5e-6, "tendon.rest_length": LENGTH}
    return with_values(load_design("binder2025"), settings)


def moving(speed, *, start=1.5, of=None, rows=11):
    """Return a record of two tendons: one stretched at a speed in m/s, one slack and fast."""
    time = np.linspace(0, 1e-3, rows)
    length = np.stack([start * LENGTH + speed * time, 0.5 * LENGTH + 100 * abs(speed) * (time - 1e-3)], axis=1)
    series = MappingProxyType({"tendon_length": length})
    wing = with_values(of or design(), {"tendon": [{"vein": vein} | tables(of or design()) for vein in (0, 2)]})
    return Record(
        design=wing, structure=structure_of(wing), time=time, series=series, stages=(), diverged_at=None, doubt=""
    )


def tables(wing):
    """Return the record's tendons as a table, SI."""
    return wing.tendon.as_tables(lambda value, _: value)


@pytest.mark.parametrize("speed", [1.2, -1.2])
def test_tendons_a_hundred_times_faster_than_the_tests_give_a_warning_with_both_rates(speed):
    # 1.2 m/s / 6 cm = 20 1/s
    (warning,) = run_warnings(moving(speed))
    assert warning.startswith(
        "taut tendons reach a strain rate of 20 1/s, 200 times the 0.1 1/s up to which tpu was measured"
    )


@pytest.mark.parametrize(
    "record",
    [
        moving(0.5),
        moving(1.2, start=0.5),
        moving(1.2, of=design(highest_strain_rate=None)),
        moving(1.2, of=load_design("binder2025")),
        replace(moving(1.2), diverged_at=1e-3),
        moving(1.2, rows=1),
    ],
    ids=["not that fast", "slack", "unknown rates", "no law", "diverged", "one row"],
)
def test_a_run_without_problems_has_no_warnings(record):
    assert run_warnings(record) == []


def test_tendons_that_have_yielded_are_slack_below_their_new_length():
    record = moving(1.2, start=1.1)
    grown = np.full((11, 2), 1.2 * LENGTH)
    assert run_warnings(record)
    assert run_warnings(replace(record, series={**record.series, "tendon_rest_length": grown})) == []


def test_tendons_are_named_where_others_are_of_another_material():
    record = moving(1.2)
    mixed = with_values(record.design, {"tendon.2.law": "none", "tendon.2.stiffness": 1000.0})
    (warning,) = run_warnings(replace(record, design=mixed, structure=structure_of(mixed)))
    assert warning.startswith("tendon0: taut tendons reach a strain rate of 20 1/s, 200 times the 0.1 1/s")
    untested = with_values(record.design, {"tendon.0.law": "none", "tendon.0.stiffness": 1000.0})
    assert run_warnings(replace(record, design=untested, structure=structure_of(untested))) == []


def test_a_goal_that_is_met_before_its_stage_is_reported_as_such_and_not_as_lost():
    steps = [start + 2e-4 for start in ENDS[:-1]]
    record = planted(goals=(None, *steps))
    outcome = measure(record)
    assert outcome.status == 'the goal of stage "fold" is already met before the stage begins'
    assert outcome.advice == "Choose a goal that is not met before its drive acts."
    held = measure(planted((0.0, *steps, 0.8), (3, -180, -180, 3, 3, 3), goals=(None, *steps)))
    assert (held.ending.verdict, held.holds) == (Verdict.NOT_HELD, {"folded": False, "opened": False})
    # a release stage has no drive, and may rest immediately
    assert run_warnings(record) == [
        f'the goal of stage "{name}" is already met before the stage begins' for name in ("fold", "unfold")
    ]
    later = planted(goals=(None, *(step + 2e-4 for step in steps)))
    assert (measure(later).status, run_warnings(later)) == ("did not stay folded", [])


def test_a_wing_of_the_papers_tpu_folds_far_faster_than_the_papers_machine_pulled():
    wing = load_design("binder2025", {"tendon.law": "tpu-82a", "tendon.area": "12.5 mm^2"})
    record = run(wing)
    rate, tested = highest_strain_rates(record).max(), wing.tendon.law.highest_strain_rate
    # at most the hinge's speed times the sum of the tendon's arms
    speed = np.abs(np.diff(record.angles("ring"), axis=0)) / np.diff(record.time)[:, None]
    arms = wing.tendon.proximal_attachment + wing.tendon.distal_attachment
    assert 1e3 * tested < rate < speed.max() * arms / wing.tendon.rest_length
    (said,) = [item for item in summary(record, measure(record), {})["warnings"] if "was measured" in item]
    assert said in run_warnings(record)


def test_the_rate_of_strain_does_not_depend_on_how_often_the_record_is_sampled(tmp_path):
    joint = load_design("binder2025-joint")
    rates = [
        highest_strain_rates(run(joint.with_values({"protocol.sample_interval": interval})))
        for interval in ("0.5 ms", "1e30 s")
    ]
    assert rates[0] == rates[1]
    # every step is a row, so the rows give the same maximum
    every = run(joint.with_values({"protocol.sample_interval": joint.protocol.timestep}))
    assert highest_strain_rates(replace(every, strain_rates=None)) == pytest.approx(rates[0], rel=1e-9)
    save_record(every, tmp_path / "record.nc")
    assert load_record(tmp_path / "record.nc").strain_rates == rates[0]


def test_energy_supplied_by_contacts_gives_a_warning_and_counts_as_missing():
    stage = {"name": "settle", "drive": "none", "until": "time", "hold": "0 s", "time_limit": "4 ms"}
    wing = load_design("binder2025", {"protocol.contact": True, "protocol.stages": [stage]})
    record = run(wing)
    assert not any("contacts supplied" in warning for warning in run_warnings(record))
    provided = {name: record.series[name].copy() for name in ("contact_work", "kinetic_energy")}
    for values in provided.values():
        values[-1] += 1.0  # J
    gifted = replace(record, series={**record.series, **provided})
    assert energy_balance(gifted).missing == pytest.approx(energy_balance(record).missing - 1.0, abs=1e-4)
    assert any(warning.startswith("contacts supplied 1 J, ") for warning in run_warnings(gifted))


def test_membranes_beyond_linear_elasticity_give_a_warning_with_their_largest_strain(reference_run):
    (warning,) = (warning for warning in run_warnings(reference_run) if "true strain" in warning)
    peak = max(membrane_peaks(reference_run), key=lambda item: item.strain)
    stretch = np.sqrt(1 + 2 * peak.strain)
    assert stretch > 2
    assert warning == (
        f"membrane {peak.part} reaches a true strain of {100 * np.log(stretch):.3g} %, {stretch:.3g} times its length"
        f" as built, at {peak.time:.3g} s (2 membranes exceed 20 %): membranes are modelled as linearly elastic, which"
        " holds up to about 20 %, so forces and energies of membranes at larger strains are extrapolated"
    )


@pytest.mark.parametrize(("strain", "warned"), [(0.19, False), (0.21, True), (-0.19, False), (-0.21, True)])
def test_the_limit_of_linear_elasticity_is_a_true_strain_of_20_percent(monkeypatch, strain, warned):
    peak = Peak(
        kind="membranes",
        strain=np.expm1(2 * strain) / 2,
        stress=None,
        part="panel0",
        time=0.1,
        stressed_at=0.1,
    )
    # the package has a function of the module's name
    module = import_module("forficula.analysis.run_warnings")
    monkeypatch.setattr(module, "membrane_peaks", lambda _: [peak])
    assert len(run_warnings(moving(0.5))) == warned


def test_a_wing_that_only_settles_strains_its_membranes_too_little_for_a_warning(reference):
    settle = [{"name": "settle", "drive": "none", "until": "time", "hold": 0.0, "time_limit": 0.1}]
    record = run(with_values(reference, {"protocol.stages": settle}))
    assert all(abs(peak.strain) < 0.05 for peak in membrane_peaks(record))
    assert not any("true strain" in warning for warning in run_warnings(record))
