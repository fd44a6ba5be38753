"""A thinned record has the same outcome, bit for bit, and shows every motion."""

from dataclasses import asdict, replace

import numpy as np
import pytest

import forficula as ff
from forficula.dynamics import load_record, save_record
from forficula.study.running.kept_runs import thin_record
from tests.places import places


def same(one, other):
    """Return whether two outcomes are equal bit for bit."""
    # advice depends on the record itself
    return repr(asdict(replace(one, advise=None))) == repr(asdict(replace(other, advise=None)))


@pytest.fixture(scope="module")
def thinned(reference_run):
    return thin_record(reference_run)


def test_a_thinned_record_has_the_outcome_of_the_whole_one_to_the_bit(reference_outcome, thinned):
    assert same(ff.measure(thinned), reference_outcome)


def test_a_thinned_record_read_from_a_file_has_the_same_outcome(tmp_path, reference_outcome, thinned):
    save_record(thinned, tmp_path / "record.nc")
    assert same(ff.measure(load_record(tmp_path / "record.nc")), reference_outcome)


def test_every_row_that_stays_is_one_of_the_whole_record(reference_run, thinned):
    places = np.searchsorted(reference_run.time, thinned.time)
    assert np.array_equal(reference_run.time[places], thinned.time)
    for name, rows in thinned.series.items():
        assert np.array_equal(rows, reference_run.series[name][places])


def test_a_thinned_record_has_at_most_two_thirds_of_the_rows(reference_run, thinned):
    assert len(thinned.time) < 2 / 3 * len(reference_run.time)


def test_between_two_rows_no_point_moves_far_and_little_time_passes(reference_run, thinned):
    tips = places(thinned, "tip")
    moved = np.linalg.norm(np.diff(tips, axis=0), axis=2).max(axis=1)
    gaps = np.diff(thinned.time)
    size = np.ptp(np.concatenate([places(reference_run, role)[0] for role in ("hub", "ring", "tip")]), axis=0).max()
    interval = reference_run.design.protocol.sample_interval
    assert gaps.max() < 5e-3 + 1.5 * interval
    # rows of the full record may differ by more than the share; no row between them can be kept
    apart = gaps > 1.5 * interval
    fastest = np.linalg.norm(np.diff(places(reference_run, "tip"), axis=0), axis=2).max()
    assert moved[apart].max() < 0.005 * size + fastest


def test_a_thinned_record_keeps_the_whole_fold(reference_run, thinned):
    fold = reference_run.stages[1]
    inside = [(rows.time >= fold.start) & (rows.time <= fold.end) for rows in (reference_run, thinned)]
    assert inside[0].sum() == inside[1].sum() > 10


def test_a_wing_that_diverges_keeps_its_last_row():
    settings = {"membrane.youngs_modulus": "30 MPa", "protocol.timestep": "0.4 ms"}
    record = ff.run(ff.load_design("binder2025", settings), confirm=False).record
    thinned = thin_record(record)
    assert record.diverged_at is not None
    assert thinned.time[-1] == record.time[-1]
    assert same(ff.measure(thinned), ff.measure(record))
