from itertools import combinations
from time import process_time

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from forficula.pattern.drawings.segments import boxes_that_meet, crossings, points_on_segments

corner = st.tuples(st.integers(-50, 50), st.integers(-50, 50))
lines = st.lists(st.tuples(corner, corner).filter(lambda ends: ends[0] != ends[1]), min_size=2, max_size=12)


def side(a, b, point):
    """Which side of the line from a to b, in whole numbers and so exactly."""
    return (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0])


@given(lines)
def test_lines_cross_where_the_ends_of_each_lie_on_two_sides_of_the_other(drawn):
    exact = {
        (one, other)
        for (one, (a, b)), (other, (c, d)) in combinations(enumerate(drawn), 2)
        if side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0
    }
    ends = np.array(drawn, dtype=float)
    pairs, points = crossings(ends[:, 0], ends[:, 1], 1e-9)
    assert set(map(tuple, pairs.tolist())) == exact
    for numbers, point in zip(pairs.tolist(), points, strict=True):
        for number in numbers:
            start, end = ends[number]
            assert abs(side(start, end, point)) <= 1e-10 * np.linalg.norm(end - start) * 100


@given(lines, st.lists(corner, min_size=1, max_size=12))
def test_points_lie_on_lines_where_they_are_in_line_and_between_the_ends(drawn, points):
    exact = {
        (place, number)
        for place, point in enumerate(points)
        for number, (a, b) in enumerate(drawn)
        if side(a, b, point) == 0 and (point[0] - a[0]) * (point[0] - b[0]) + (point[1] - a[1]) * (point[1] - b[1]) < 0
    }
    ends = np.array(drawn, dtype=float)
    pairs, _ = points_on_segments(np.array(points, dtype=float), ends[:, 0], ends[:, 1], 1e-6)
    assert set(map(tuple, pairs.tolist())) == exact


@pytest.mark.parametrize("seed", range(6))
def test_meeting_boxes_match_a_comparison_of_all_pairs(seed):
    random = np.random.default_rng(seed)
    # points, lines along an axis, boxes of any size and places that are equal to the bit
    low = random.integers(0, [400, 30], (300, 2)) / 7
    high = low + random.choice([0, 0.3, 1, 40], (300, 2), p=[0.5, 0.2, 0.2, 0.1])
    other_low, other_high = low[::-2] * [1, 1 + 0.5 * (seed > 2)], high[::-2] * [1, 1 + 0.5 * (seed > 2)]
    meet = (low[:, np.newaxis] <= other_high) & (other_low <= high[:, np.newaxis])
    assert np.array_equal(boxes_that_meet(low, high, other_low, other_high), np.argwhere(meet.all(axis=2)))
    assert 300 < len(np.argwhere(meet.all(axis=2))) < meet.size / 4


def test_the_time_for_separate_boxes_is_proportional_to_their_number():
    low = np.stack(np.meshgrid(np.arange(200.0), np.arange(200.0)), axis=-1).reshape(-1, 2)
    before = process_time()
    pairs = boxes_that_meet(low, low + 0.5, low, low + 0.5)
    assert process_time() - before < 3  # a comparison of all pairs takes ten times as long
    assert np.array_equal(pairs, np.repeat(np.arange(40_000), 2).reshape(-1, 2))
