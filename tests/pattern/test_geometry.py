import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from forficula.pattern.geometry import cross, dot, is_inside, polygon_normal, triangle_areas, triangle_normals
from forficula.pattern.rotation import IDENTITY_MOTION, frame_along, rotation_about, turn_about

ARROW = np.array([[0, 0, 0], [2, 0, 0], [1, 1, 0], [2, 2, 0], [0, 2, 0]], dtype=float)
vectors = st.tuples(*[st.floats(-1, 1)] * 3).filter(lambda item: math.hypot(*item) > 0.1).map(np.array)
angles = st.floats(-math.pi, math.pi)


@given(vectors, vectors)
def test_products_of_vectors_are_those_of_numpy(one, other):
    assert cross(one, other) == pytest.approx(np.cross(one, other))
    assert dot(one, other) == pytest.approx(one @ other)


@given(vectors, angles, vectors)
def test_the_normal_of_a_polygon_turns_with_the_polygon_and_does_not_depend_on_its_position(axis, angle, shift):
    turn = rotation_about(axis / np.linalg.norm(axis), angle)
    assert polygon_normal(ARROW @ turn.T + shift) == pytest.approx(turn @ [0, 0, 6], abs=1e-12)


def test_the_normals_of_the_triangles_of_a_polygon_add_up_to_its_own():
    triangles = ARROW[[[0, 1, 2], [0, 2, 3], [0, 3, 4]]]
    assert triangle_normals(triangles).sum(axis=0) == pytest.approx(polygon_normal(ARROW))
    assert triangle_areas(triangles) == pytest.approx([1, 0, 2])


@pytest.mark.parametrize(
    ("place", "beside", "inside"),
    [((0.5, 1), 0, True), ((1.5, 1), 0, False), ((1.5, 1), 0.4, True), ((1.5, 1), 0.3, False), ((0, 2), 1e-9, True)],
)
def test_a_position_is_inside_or_within_a_distance_of_a_side(place, beside, inside):
    assert is_inside(np.array(place), ARROW[:, :2], beside) is inside


@given(vectors, vectors, angles, angles)
def test_turns_about_one_line_add_up_and_leave_the_line(origin, axis, one, other):
    axis = axis / np.linalg.norm(axis)
    both = turn_about(origin, axis, one).after(turn_about(origin, axis, other))
    assert both.of(ARROW) == pytest.approx(turn_about(origin, axis, one + other).of(ARROW), abs=1e-12)
    assert both.of(origin + axis) == pytest.approx(origin + axis, abs=1e-12)
    assert IDENTITY_MOTION.after(both).shift == pytest.approx(both.shift)


@given(vectors)
def test_axes_along_a_direction_are_right_handed_and_square(direction):
    frame = frame_along(direction / np.linalg.norm(direction))
    assert frame.T @ frame == pytest.approx(np.eye(3), abs=1e-12)
    assert np.linalg.det(frame) == pytest.approx(1)
