from itertools import combinations

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from forficula.pattern.segments import crossings, points_on_segments

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
