"""Facets split into triangles."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.errors import InputError
from forficula.pattern import CreasePattern, EarwigFan, earwig_pattern, miura_pattern, triangulated
from tests.pattern.facets import vector_areas


def polygon(points, turn=0.0):
    """One facet, rotated about an axis that is not a coordinate axis."""
    points = np.array([(*point, 0.0)[:3] for point in points], dtype=float)
    axis = np.array([1.0, 2.0, 2.0]) / 3
    cross = np.cross(np.eye(3), -axis)
    points = points @ (np.eye(3) + math.sin(turn) * cross + (1 - math.cos(turn)) * cross @ cross).T
    count = len(points)
    return CreasePattern(
        vertices_coords=points,
        edges_vertices=np.array([(k, (k + 1) % count) for k in range(count)]),
        edges_assignment=("B",) * count,
        edges_fold_angle=np.full(count, np.nan),
        faces_vertices=(tuple(range(count)),),
    )


def diagonals(pattern):
    split = triangulated(pattern).pattern
    return [tuple(ends) for ends in split.edges_vertices[len(pattern.edges_vertices) :].tolist()]


@settings(max_examples=30)
@given(st.integers(3, 9), st.floats(0, 6), st.data())
def test_triangles_keep_area_and_normal_of_their_facet_convex_or_not(count, turn, data):
    radii = data.draw(st.lists(st.floats(0.2, 1), min_size=count, max_size=count))
    around = 2 * math.pi * np.arange(count) / count
    star = polygon(np.column_stack([radii * np.cos(around), radii * np.sin(around)]), turn)
    split, facets = triangulated(star)
    areas = vector_areas(split)
    normal = vector_areas(star)[0] / np.linalg.norm(vector_areas(star)[0])
    assert len(areas) == count - 2
    assert facets.tolist() == [0] * (count - 2)
    assert areas.sum(axis=0) == pytest.approx(vector_areas(star)[0], abs=1e-14)
    sizes = np.linalg.norm(areas, axis=1)
    assert areas / sizes[:, None] == pytest.approx(np.tile(normal, (count - 2, 1)), abs=1e-6)
    assert sizes.min() > 0


def test_vertices_and_edges_keep_their_numbers_and_diagonals_follow():
    fan = earwig_pattern(
        EarwigFan(proximal_length=0.12, distal_length=0.1, hub_radius=0.015, sector_angle=0.3, units=2)
    )
    split, facets = triangulated(fan)
    count = len(fan.edges_vertices)
    assert split.vertices_coords.tolist() == fan.vertices_coords.tolist()
    assert split.edges_vertices[:count].tolist() == fan.edges_vertices.tolist()
    assert split.edges_assignment[:count] == fan.edges_assignment
    assert set(split.edges_assignment[count:]) == {"F"}
    assert set(split.edges_role[count:]) == {"diagonal"}
    assert not split.edges_fold_angle[count:].any()
    assert facets.tolist() == sorted([*range(8), *range(8)])
    assert all(set(split.faces_vertices[k]) <= set(fan.faces_vertices[facet]) for k, facet in enumerate(facets))
    summed = np.zeros((8, 3))
    np.add.at(summed, facets, vector_areas(split))
    assert summed == pytest.approx(vector_areas(fan), abs=1e-17)


def test_a_quadrilateral_is_split_along_its_shorter_diagonal():
    for facet in miura_pattern(3, 3, 0.02, 0.03, 1.0).faces_vertices:
        assert len(facet) == 4
    flat = miura_pattern(3, 3, 0.02, 0.03, 1.0)
    for one, other in diagonals(flat):
        length = np.linalg.norm(flat.vertices_coords[one] - flat.vertices_coords[other])
        assert length == pytest.approx(math.sqrt(0.02**2 + 0.03**2 - 2 * 0.02 * 0.03 * math.cos(1.0)))


def test_a_dart_is_split_through_its_hollow_corner():
    assert diagonals(polygon([(-1, 0), (0, 0.2), (1, 0), (0, 1)][::-1])) == [(0, 2)]


def test_equal_diagonals_leave_the_choice_to_the_numbers_however_the_facet_is_turned():
    square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    assert {tuple(diagonals(polygon(square, turn))) for turn in np.linspace(0, 6, 25)} == {((0, 2),)}


def test_a_hexagon_is_a_large_triangle_and_three_around_it():
    around = math.pi / 3 * np.arange(6)
    assert diagonals(polygon(np.column_stack([np.cos(around), np.sin(around)]), 1.0)) == [(0, 2), (0, 4), (2, 4)]


def test_a_corner_on_a_straight_side_makes_no_sliver():
    assert diagonals(polygon([(0, 0), (1, 0), (2, 0), (0, 2)])) == [(1, 3)]


def test_two_facets_with_the_same_corners_take_different_diagonals():
    """A bag of two quadrilaterals, sewn along their rims and open."""
    points = np.array([(0, 0, 0.0), (1, 0, 0.1), (1, 1, 0), (0, 1, 0.1)])
    bag = CreasePattern(
        vertices_coords=points,
        edges_vertices=np.array([(0, 1), (1, 2), (2, 3), (3, 0), (0, 2)]),
        edges_assignment=("B",) * 5,
        edges_fold_angle=np.full(5, np.nan),
        faces_vertices=((0, 1, 2, 3),),
    )
    assert diagonals(bag) == [(1, 3)]


def test_a_pattern_of_triangles_is_unchanged():
    triangle = polygon([(0, 0), (1, 0), (0, 1)])
    assert triangulated(triangle).pattern.faces_vertices == ((0, 1, 2),)
    assert diagonals(triangle) == []


@pytest.mark.parametrize(
    ("points", "message"),
    [
        ([(0, 0), (2, 1), (2, 0), (0, 1)], "faces_vertices[0]: need a face with an area, got 0 cm2"),
        ([(0, 0), (1, 0), (2, 0), (3, 0)], "faces_vertices[0]: need a face with an area, got 0 cm2"),
        ([(0, 0), (4, 3), (4, 0), (0, 2)], "faces_vertices[0]: need a face that diagonals split into triangles"),
    ],
)
def test_a_facet_that_crosses_itself_is_refused(points, message):
    with pytest.raises(InputError) as caught:
        triangulated(polygon(points))
    assert str(caught.value).startswith(message)
