import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from forficula.pattern.geometry import polygon_normal
from forficula.show.structure.drawn_polygons import drawn_pieces, is_convex

ARROW = np.array([[0, 0, 0], [2, 0, 0], [1, 1, 0], [2, 2, 0], [0, 2, 0]], dtype=float)


def area(corners):
    return float(np.linalg.norm(polygon_normal(corners))) / 2


def test_an_area_is_that_of_the_polygon_wherever_it_lies():
    assert polygon_normal(ARROW) == pytest.approx([0, 0, 6])
    assert area(ARROW + np.array([3, 4, 5])) == pytest.approx(3)
    assert is_convex(ARROW[[0, 1, 3, 4]])
    assert not is_convex(ARROW)


def test_a_polygon_of_four_convex_corners_is_one_piece_that_looks_upwards():
    square = ARROW[[0, 1, 3, 4]]
    assert drawn_pieces(square) == [(0, 1, 2, 3)]
    (turned,) = drawn_pieces(square[::-1])
    assert polygon_normal(square[::-1][list(turned)])[2] > 0


@given(st.integers(3, 12), st.integers(0, 10_000))
def test_pieces_cover_a_polygon_and_no_more(count, seed):
    random = np.random.default_rng(seed)
    angle = np.sort(random.uniform(0, 2 * np.pi, count))
    # seen from an inner point, with gaps below half a turn, sides do not cross, whatever the distances
    if np.diff([*angle, angle[0] + 2 * np.pi]).max() >= np.pi:
        return
    radius = random.uniform(0.3, 1.0, count)
    corners = np.column_stack([radius * np.cos(angle), radius * np.sin(angle), np.zeros(count)])
    pieces = drawn_pieces(corners)
    parts = [polygon_normal(corners[list(piece)])[2] / 2 for piece in pieces]
    assert min(parts) > -1e-12
    assert sum(parts) == pytest.approx(area(corners))
    assert {corner for piece in pieces for corner in piece} == set(range(count))
