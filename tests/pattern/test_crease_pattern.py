import math

import numpy as np
import pytest

from forficula.errors import InputError
from forficula.pattern import (
    CreasePattern,
    big_little_big_residuals,
    creases_inside,
    interior_vertices,
    kawasaki_residuals,
    maekawa_residuals,
    sectors_between,
)


def star(directions_deg, letters, **changes):
    """Creases from one interior vertex to a rim of radius 10 cm."""
    count = len(directions_deg)
    angles = np.radians(directions_deg)
    rim = 0.1 * np.column_stack([np.cos(angles), np.sin(angles), np.zeros(count)])
    spokes = [(0, i + 1) for i in range(count)]
    edges = spokes + [(i + 1, (i + 1) % count + 1) for i in range(count)]
    fields = {
        "vertices_coords": np.concatenate([np.zeros((1, 3)), rim]),
        "edges_vertices": np.array(edges),
        "edges_assignment": tuple(letters) + ("B",) * count,
        "edges_fold_angle": np.full(2 * count, np.nan),
        "faces_vertices": tuple((0, i + 1, (i + 1) % count + 1) for i in range(count)),
    }
    return CreasePattern(**(fields | changes))


def test_only_the_middle_of_a_star_is_interior():
    assert interior_vertices(star([0, 90, 180, 270], "MMMV")).tolist() == [0]


def test_a_vertex_on_a_cut_is_not_interior():
    assert interior_vertices(star([0, 90, 180, 270], "MMMC")).tolist() == []


def test_a_vertex_whose_faces_leave_a_gap_is_not_interior():
    whole = star([0, 90, 180, 270], "UUUU")
    assert interior_vertices(star([0, 90, 180, 270], "UUUU", faces_vertices=whole.faces_vertices[:3])).tolist() == []


def test_sectors_of_a_star_are_the_drawn_ones_counterclockwise():
    pattern = star([0, 45, 165, 300], "MMMV")
    ((vertex, around),) = creases_inside(pattern)
    assert (vertex, around.tolist()) == (0, [0, 1, 2, 3])
    assert np.degrees(sectors_between(pattern, vertex, around)) == pytest.approx([45, 120, 135, 60])


def test_a_sector_beyond_a_half_turn_is_measured():
    pattern = star([10, 80, 130, 250], "MMMF")
    assert np.degrees(sectors_between(pattern, *creases_inside(pattern)[0])) == pytest.approx([70, 50, 240])


def test_kawasaki_holds_where_opposite_sectors_sum_to_a_half_turn():
    assert kawasaki_residuals(star([0, 45, 165, 300], "MMMV")) == pytest.approx([0], abs=1e-14)


def test_kawasaki_residual_is_twice_the_turn_of_one_crease():
    residual = kawasaki_residuals(star([0, 48, 165, 300], "MMMV"))
    assert abs(np.degrees(residual)) == pytest.approx([6])


def test_an_odd_vertex_never_folds_flat():
    assert kawasaki_residuals(star([0, 120, 240], "MMV")).tolist() == [math.inf]


@pytest.mark.parametrize(("letters", "residual"), [("MMMV", 0), ("VVVM", 0), ("MMVV", -2), ("MMMM", 2), ("MVFF", -2)])
def test_mountains_and_valleys_differ_by_two(letters, residual):
    assert maekawa_residuals(star([0, 90, 180, 270], letters)).tolist() == [residual]


@pytest.mark.parametrize(("letters", "count"), [("MMMV", 1), ("MVMM", 0), ("UMMV", 0), ("MVVV", 0), ("VVVM", 1)])
def test_the_smallest_sector_needs_one_mountain_and_one_valley(letters, count):
    assert big_little_big_residuals(star([0, 45, 165, 300], letters)).tolist() == [count]


def test_equal_sectors_count_no_trapped_sector():
    assert big_little_big_residuals(star([0, 90, 180, 270], "MMMV")).tolist() == [0]


def test_flat_edges_do_not_change_a_vertex():
    pattern = star([0, 45, 100, 165, 300], "MVFMM")
    assert kawasaki_residuals(pattern) == pytest.approx([0], abs=1e-14)
    assert maekawa_residuals(pattern).tolist() == [0]
    assert big_little_big_residuals(pattern).tolist() == [0]


def test_a_vertex_of_flat_edges_alone_breaks_no_rule():
    pattern = star([0, 90, 180, 270], "FFFF")
    assert kawasaki_residuals(pattern).tolist() == [0]
    assert maekawa_residuals(pattern).tolist() == [0]
    assert big_little_big_residuals(pattern).tolist() == [0]


def test_arrays_are_read_only_copies():
    coords = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0]])
    pattern = CreasePattern(
        vertices_coords=coords,
        edges_vertices=np.array([[0, 1], [1, 2], [2, 0]]),
        edges_assignment=("B", "B", "B"),
        edges_fold_angle=np.full(3, np.nan),
        faces_vertices=((0, 1, 2),),
    )
    coords[0, 0] = 7
    assert pattern.vertices_coords[0, 0] == 0
    with pytest.raises(ValueError, match="read-only"):
        pattern.vertices_coords[0, 0] = 7


def test_a_bent_sheet_has_no_sectors():
    coords = star([0, 90, 180, 270], "MMMV").vertices_coords.copy()
    coords[1, 2] = 0.01
    with pytest.raises(InputError, match=r"need one z for all vertices, got 0 to 0\.01 m"):
        creases_inside(star([0, 90, 180, 270], "MMMV", vertices_coords=coords))


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        (
            {"edges_vertices": [[0, 1], [0, 2], [0, 3], [0, 99], [1, 2], [2, 3], [3, 4], [4, 1]]},
            r"edges_vertices\[3\]: vertex 99 does not exist, the pattern has 5 vertices \(0 to 4\)",
        ),
        (
            {"edges_vertices": [[0, 1], [0, 2], [0, 3], [4, 4], [1, 2], [2, 3], [3, 4], [4, 1]]},
            r"edges_vertices\[3\]: need two vertices apart, got 4 and 4 at one place",
        ),
        (
            {"edges_vertices": [[0, 1], [0, 2], [0, 3], [1, 0], [1, 2], [2, 3], [3, 4], [4, 1]]},
            r"edges_vertices\[3\]: need every edge once, got edge 0 again",
        ),
        ({"edges_vertices": [[0.0, 1.5]]}, "edges_vertices: need whole numbers, got float64"),
        ({"edges_vertices": [0, 1]}, r"edges_vertices: need shape \(edges, 2\), got \(2,\)"),
        ({"vertices_coords": np.zeros((5, 2))}, r"vertices_coords: need shape \(vertices, 3\), got \(5, 2\)"),
        ({"vertices_coords": np.full((5, 3), np.nan)}, r"vertices_coords\[0\]: need finite numbers"),
        ({"vertices_coords": np.zeros((5, 3))}, r"edges_vertices\[0\]: need two vertices apart"),
        (
            {"vertices_coords": np.array([[1e-300, 0, 0], [0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]])},
            r"edges_vertices\[0\]: need two vertices apart",
        ),
        ({"vertices_coords": "here"}, "vertices_coords: need an array of numbers, got str"),
        ({"edges_assignment": tuple("MMXVBBBB")}, r"edges_assignment\[2\]: need one of B \(border\).*, got 'X'"),
        ({"edges_assignment": tuple("MMM")}, "edges_assignment: need one letter for each of the 8 edges, got 3"),
        ({"edges_fold_angle": np.zeros(3)}, r"edges_fold_angle: need shape \(8,\), got \(3,\)"),
        ({"edges_fold_angle": np.full(8, np.inf)}, r"edges_fold_angle\[0\]: need a finite angle or nan, got inf"),
        ({"edges_role": ("ring",)}, "edges_role: need one label for each of the 8 edges, got 1"),
        ({"faces_vertices": ()}, "faces_vertices: need at least one face, got none"),
        ({"faces_vertices": ((0, 1),)}, r"faces_vertices\[0\]: need at least 3 vertices, got 2"),
        ({"faces_vertices": ((0, 1, 9),)}, r"faces_vertices\[0\]: vertex 9 does not exist"),
        (
            {"faces_vertices": ((0, 1, 3),)},
            r"faces_vertices\[0\]: need an edge along every side, got none from 1 to 3",
        ),
    ],
)
def test_an_invalid_pattern_is_refused_with_the_name_of_the_field(changes, message):
    with pytest.raises(InputError, match=message) as refusal:
        star([0, 90, 180, 270], "MMMV", **changes)
    assert "\n" not in str(refusal.value)
