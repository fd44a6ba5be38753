import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from forficula.kept_frames import kept_frames


def drawn_between(time, points, rows):
    """Return the points at all times, interpolated between some rows."""
    flat = points.reshape(len(time), -1)
    columns = [np.interp(time, time[rows], column[rows]) for column in flat.T]
    return np.stack(columns, axis=1).reshape(points.shape)


def furthest(time, points, rows):
    return np.linalg.norm(drawn_between(time, points, rows) - points, axis=2).max()


@pytest.fixture
def snap():
    """A point that rests, snaps within 10 ms and rests again; another one that never moves."""
    time = np.linspace(0, 1, 1001)
    height = 0.1 * np.clip((time - 0.5) / 0.01, 0, 1) ** 2
    points = np.zeros((1001, 2, 3))
    points[:, 0, 2] = height
    return time, points


def test_few_frames_are_kept_at_rest_and_all_frames_of_a_snap(snap):
    rows = kept_frames(*snap, moments=[], most=1000, tolerance=1e-9)
    assert set(range(500, 511)) <= set(rows)
    assert len(rows) <= 13


def test_straight_motion_needs_only_its_corners():
    time = np.arange(10.0)
    points = np.zeros((10, 1, 3))
    points[:, 0, 0] = np.interp(time, [0, 4, 9], [0, 8, 3])
    assert list(kept_frames(time, points, [], most=10, tolerance=1e-9)) == [0, 4, 9]


@given(
    st.integers(2, 60),
    st.integers(2, 30),
    st.lists(st.floats(0, 1), max_size=3),
    st.sampled_from([0.0, 1e-3, 0.1]),
    st.integers(0, 1000),
)
def test_omitted_frames_are_within_the_tolerance_unless_the_number_of_frames_is_reached(
    count, most, moments, tolerance, seed
):
    random = np.random.default_rng(seed)
    time = np.linspace(0, 1, count)
    points = random.normal(size=(count, 3, 3)).cumsum(axis=0)
    rows = kept_frames(time, points, moments, most=most, tolerance=tolerance)
    assert list(rows) == sorted(set(rows))
    assert {0, count - 1} <= set(rows)
    for moment in moments:
        assert np.abs(time - moment).min() == pytest.approx(np.abs(time[rows] - moment).min())
    assert len(rows) >= most or furthest(time, points, rows) <= tolerance
    assert len(rows) <= max(most, len(moments) + 2)


def test_more_frames_never_increase_the_error(short_run):
    points = short_run.series["point_position"]
    rows = [kept_frames(short_run.time, points, [], most=most, tolerance=0.0) for most in (10, 30, 100)]
    errors = [furthest(short_run.time, points, row) for row in rows]
    assert errors == sorted(errors, reverse=True)
    # a hundred rows show a wing of 22 cm to 1 % of its length
    assert errors[-1] < 2.2e-3


def test_rows_that_are_not_finite_are_left_out(snap):
    time, points = snap
    points[990:] = np.nan
    points[0] = 1e300  # finite, but not as a 4-byte float
    rows = kept_frames(time, points, [1.0], most=1000, tolerance=1e-9)
    assert rows.min() == 1
    assert rows.max() == 989
    assert len(kept_frames(time, np.full_like(points, np.inf), [], most=10, tolerance=0.0)) == 0
