import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.special import ellipk

import forficula as ff
from forficula.analysis.simulated_snap import (
    finely_sampled,
    hinge_name,
    inner_tendon,
    simulated_snap,
)
from forficula.statics import crossed_hinges
from forficula.structure import hinges_of, structure_of


def snap_of(record):
    """Return the simulated snap of the hinge of an inner tendon."""
    crossed = crossed_hinges(record.structure, 2)
    return simulated_snap(record, next(item for item in crossed if item.tendon == inner_tendon(record.structure)))


def folding(record, angle):
    """Return a record whose hinges all fold along the given angles, rad over s, before any opens."""
    time = np.linspace(0, 0.2, 2001)
    fold = angle(time)
    angles = np.zeros((len(time), len(record.structure.hinges)))
    angles[:, list(hinges_of(record.structure, "ring"))] = -fold[:, None]
    return replace(record, time=time, series=dict(record.series) | {"hinge_angle": angles}, stages=record.stages[:2])


def test_a_known_fold_is_timed_to_what_straight_lines_between_rows_allow(reference_run):
    rate, start = 30.0, math.radians(1)
    # exponential growth, like that of a hinge that leaves straight, up to its limit
    record = folding(reference_run, lambda time: np.minimum(start / 2 * np.exp(rate * time), math.pi))
    snap = snap_of(record)
    # rows every 0.1 ms: linear interpolation of an exponential deviates by (rate * interval)^2 / 8 of it, or 4e-8 s
    assert snap.folded_time == pytest.approx(math.log(150) / rate, abs=1e-7)
    assert snap.fold_time == pytest.approx(math.log(180) / rate, abs=1e-4)
    assert snap.peak_speed == pytest.approx(rate * math.pi, rel=5e-3)


def test_a_fold_counts_from_the_last_time_that_the_hinge_leaves_straight(reference_run):
    def angle(time):
        early = 0.1 * np.sin(2 * math.pi * time / 0.1)  # past 1 deg and back
        return np.where(time < 0.1, early, 100 * (time - 0.1))

    snap = snap_of(folding(reference_run, angle))
    assert snap.folded_time == pytest.approx((math.radians(150) - math.radians(1)) / 100, abs=1e-6)


def test_a_hinge_that_does_not_arrive_has_no_time_but_an_angle(reference_run):
    snap = snap_of(folding(reference_run, lambda time: np.minimum(10 * time, 1.0)))
    assert (snap.folded_time, snap.fold_time) == (None, None)
    assert snap.largest_fold == pytest.approx(1.0)


def test_a_run_that_diverged_has_no_snap(reference_run):
    assert snap_of(replace(reference_run, diverged_at=0.1)) is None


def test_the_predicted_time_to_the_fold_limit_is_the_elliptic_integral(reference):
    structure = structure_of(ff.load_design("binder2025", {"tendon.rest_length": "0 cm"}))
    ideal = crossed_hinges(structure, 2)[0].ideal
    scale = math.sqrt(ideal.hinge.inertia / (1000 * 0.055**2))
    # docs/model/theory.md, section Snap of a hinge: t* K(m), m = cos^2(start / 2)
    assert ideal.fold_time == pytest.approx(scale * ellipk(math.cos(math.radians(0.5)) ** 2), rel=1e-9)
    assert 0 < ideal.time_to(reference.protocol.folded_angle) < ideal.fold_time


def test_a_shorter_sample_interval_does_not_change_the_motion(reference, reference_run):
    fine = ff.run(finely_sampled(reference), confirm=False)
    assert len(fine.time) > 4 * len(reference_run.time)
    rows = np.searchsorted(fine.time, reference_run.time - 1e-9)
    same = fine.angles("ring")[rows] == reference_run.angles("ring")
    assert same.all()


def test_the_representative_tendon_is_an_inner_one_and_its_hinge_has_a_name(reference):
    fan, letter = structure_of(reference), structure_of(ff.load_design("letter-fold"))
    assert (inner_tendon(fan), hinge_name(fan, 1)) == (1, "second hinge")
    # of two hinges none is between others
    assert (inner_tendon(letter), hinge_name(letter, 0)) == (0, "crease 0 (left)")
    assert inner_tendon(replace(fan, tendons=())) is None


def test_a_hinge_that_folds_to_positive_angles_is_timed_in_the_same_way():
    record = ff.run(ff.load_design("letter-fold"), confirm=False).record
    time = np.linspace(0, 0.2, 2001)
    fold = np.minimum(10 * time, 1.7)
    series = dict(record.series) | {"hinge_angle": np.stack([fold, fold], axis=1)}
    snap = snap_of(replace(record, time=time, series=series, stages=record.stages[:2]))
    # from 1 deg to the 90 deg that its protocol asks for, at 10 rad/s
    assert snap.folded_time == pytest.approx(math.radians(89) / 10, abs=1e-9)
    assert (snap.fold_time, snap.largest_fold) == (None, pytest.approx(1.7))


def test_a_fold_counts_from_beside_where_an_offset_tendon_is_longest():
    offset = {"tendon.proximal_offset": "2 mm", "tendon.distal_offset": "2 mm"}
    record = ff.run(ff.load_design("binder2025", offset), confirm=False).record
    snap = snap_of(folding(record, lambda time: np.minimum(20 * time, math.pi)))
    crossing = record.structure.tendons[1].crossing
    # the energy maximum is at the offset angle, and the hinge starts 1 deg past it
    start = crossing.offset_angle + math.radians(1)
    assert snap.folded_time == pytest.approx((math.radians(150) - start) / 20, abs=1e-9)


def test_a_slack_tendon_is_sampled_as_the_protocol_says():
    slack = ff.load_design("binder2025", {"tendon.rest_length": "12 cm"})
    assert finely_sampled(slack) is slack
