import json
import math

import numpy as np
import pytest

from forficula.errors import InputError
from forficula.pattern import (
    EarwigFan,
    earwig_pattern,
    fold_pattern,
    interior_vertices,
    kawasaki_residuals,
    maekawa_residuals,
    read_fold,
    read_folded_frames,
    write_fold,
)
from tests.pattern.fold_files import OTHERS, SQUARE, outcome, written

FAN = EarwigFan(proximal_length=0.12, distal_length=0.10, hub_radius=0.015, sector_angle=math.radians(20), units=2)


def test_missing_assignments_fold_angles_and_faces_are_filled_in(tmp_path):
    pattern = read_fold(written(tmp_path / "square.fold"))
    assert pattern.edges_assignment == ("B", "B", "B", "B", "U")
    assert np.isnan(pattern.edges_fold_angle).all()
    assert {frozenset(face) for face in pattern.faces_vertices} == {frozenset({0, 1, 2}), frozenset({0, 2, 3})}
    assert len(interior_vertices(pattern)) == 0


def test_faces_found_from_the_edges_are_those_of_the_fan(tmp_path):
    pattern, path = earwig_pattern(FAN), tmp_path / "fan.fold"
    write_fold(pattern, path)
    document = json.loads(path.read_text(encoding="utf-8"))
    del document["faces_vertices"]
    path.write_text(json.dumps(document), encoding="utf-8")
    result = read_fold(path)

    def from_lowest(face):
        first = face.index(min(face))
        return face[first:] + face[:first]

    assert {from_lowest(face) for face in result.faces_vertices} == {
        from_lowest(face) for face in pattern.faces_vertices
    }


def test_clockwise_faces_are_turned(tmp_path):
    pattern = read_fold(written(tmp_path / "square.fold", {"faces_vertices": [[0, 2, 1], [0, 2, 3]]}))
    assert pattern.faces_vertices == ((1, 2, 0), (0, 2, 3))


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        (
            {"frame_unit": "unit"},
            'frame_unit: need .*, one of m, .*, got "unit"; set .* pattern.unit = "1 cm", .* --unit "1 cm"$',
        ),
        ({"frame_unit": None}, 'frame_unit: need a unit .* got no frame_unit; set the length .* --unit "1 cm"$'),
        ({"frame_unit": ["mm"]}, "frame_unit: need a unit of length"),
        ({"vertices_coords": []}, "vertices_coords: need at least one vertex, got none"),
        ({"vertices_coords": [[0]]}, r"vertices_coords\[0\]: need two or three numbers, got \[0\]"),
        ({"vertices_coords": [["0", 1]]}, r"vertices_coords\[0\]: need a number, got '0'"),
        ({"vertices_coords": [[10**400, 1]]}, r"vertices_coords\[0\]: need a finite number, got inf"),
        ({"vertices_coords": 7}, "vertices_coords: need a list, got int"),
        (
            {"edges_vertices": [[0, 1], [1, 9]]},
            r"edges_vertices\[1\]: vertex 9 does not exist, the pattern has 4 vertices",
        ),
        ({"edges_vertices": [[0, 1], [1, 2, 3]]}, r"edges_vertices\[1\]: need two vertices, got 3"),
        ({"edges_vertices": [[0, 1], [1, 2.5]]}, r"edges_vertices\[1\]: need whole numbers, got 2\.5"),
        ({"edges_vertices": [[0, 1], 4]}, r"edges_vertices\[1\]: need a list of vertices, got 4"),
        ({"edges_vertices": [[0, 1], [1, 0]]}, r"edges_vertices\[1\]: need every edge once"),
        ({"edges_vertices": [[0, 1], [2, 3]]}, "faces_vertices: need the key in the file, .* connected"),
        (
            {"vertices_coords": [[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]]},
            "faces_vertices: .* got a shape that is not flat",
        ),
        ({"edges_assignment": ["B"]}, "edges_assignment: need one letter for each of the 5 edges, got 1"),
        ({"edges_assignment": [[], 1, 2, 3, 4]}, r"edges_assignment\[0\]: need one of"),
        ({"edges_foldAngle": ["x", 0, 0, 0, 0]}, r"edges_foldAngle\[0\]: need a number, got 'x'"),
        (
            {"edges_assignment": list("BBBBM"), "edges_foldAngle": [None] * 4 + [1]},
            r"edges_foldAngle\[4\]: need <= 0 on a",
        ),
        (
            {"edges_assignment": list("BBBBV"), "edges_foldAngle": [None] * 4 + [-1]},
            r"edges_foldAngle\[4\]: need >= 0 on",
        ),
        ({"edges_foldAngle": [None] * 4 + [1e9]}, r"edges_foldAngle\[4\]: need -180 to 180 deg, got 1e\+09"),
        (
            {"faces_vertices": [[0, 1, 2], [0, 2, 3], [2, 0, 1]]},
            r"faces_vertices\[2\]: need every face once, got 0 again",
        ),
        ({"faces_vertices": [[0, 1, 2], [2, 1, 0]]}, r"faces_vertices\[1\]: need every face once, got 0 again"),
        ({"faces_vertices": [[0, 1, 2, 1]]}, r"faces_vertices\[0\]: need every vertex once, got 1 twice"),
        ({"file_spec": 99}, "file_spec: need a version from 1 to below 2 of the FOLD format, got 99"),
        ({"file_spec": "1.2"}, "file_spec: need a version"),
        ({"faces_vertices": [[0, 1, 8]]}, r"faces_vertices\[0\]: vertex 8 does not exist"),
        ({"faces_vertices": [[0, 1, 3]]}, r"faces_vertices\[0\]: need an edge along every side, got none from"),
    ],
)
def test_a_file_that_holds_no_pattern_is_refused_with_its_name_and_key(tmp_path, changes, message):
    with pytest.raises(InputError, match=rf"square\.fold: {message}") as refusal:
        read_fold(written(tmp_path / "square.fold", changes))
    assert "\n" not in str(refusal.value)


@pytest.mark.parametrize("key", ["vertices_coords", "edges_vertices"])
def test_a_missing_key_is_named(tmp_path, key):
    with pytest.raises(InputError, match=f"{key}: need a list, but the key is missing"):
        read_fold(written(tmp_path / "square.fold", without=(key,)))


def test_a_base_of_origami_simulator_lies_flat_seen_from_above():
    pattern, remarks = fold_pattern(OTHERS / "squareBase.fold", unit=0.01)
    assert remarks == ["vertices_coords: the sheet is rotated into z = 0; in the file, up is along (0, 1, 0)"]
    assert not pattern.vertices_coords[:, 2].any()
    assert pattern.vertices_coords[1] == pytest.approx([0.00707106769, 0.00707106769, 0], rel=1e-9)  # far right in xz
    assert sorted(map(len, pattern.faces_vertices)) == [3] * 8
    assert np.abs(kawasaki_residuals(pattern)).max() < 1e-6  # single precision
    assert maekawa_residuals(pattern).tolist() == [0]
    assert np.degrees(pattern.edges_fold_angle[8:]).tolist() == [-180] * 4 + [180] * 2 + [0] * 2


def test_a_folded_form_is_not_moved():
    pattern, remarks = fold_pattern(OTHERS / "simple.fold", unit=0.01)
    assert remarks == []
    np.testing.assert_array_equal(pattern.vertices_coords[4], pattern.vertices_coords[5])
    assert pattern.vertices_coords[1].tolist() == [0, 0, 0.01]
    assert pattern.edges_assignment == tuple("VMMBBBBBB")


def test_a_crease_pattern_of_an_editor_needs_a_unit_only():
    pattern = read_fold(OTHERS / "diagonal-cp.fold", unit=0.05)
    assert pattern.vertices_coords[2].tolist() == [0.05, 0.05, 0]
    assert pattern.title == "diagonal"
    with pytest.raises(
        InputError, match=r"diagonal-cp\.fold: frame_unit: need a unit .*, got no frame_unit; set the length"
    ):
        read_fold(OTHERS / "diagonal-cp.fold")


def test_faces_of_a_folded_form_come_from_a_flat_frame_with_its_edges(tmp_path):
    solid = {"vertices_coords": [[0, 0, 0], [10, 0, 5], [10, 10, 0], [0, 10, 5]]}
    flat = {"frame_inherit": True, "vertices_coords": SQUARE["vertices_coords"]}
    pattern, remarks = outcome(tmp_path, solid | {"file_frames": [flat]})
    assert {frozenset(face) for face in pattern.faces_vertices} == {frozenset({0, 1, 2}), frozenset({0, 2, 3})}
    assert pattern.vertices_coords[1, 2] == pytest.approx(5e-3)
    assert remarks == ["faces_vertices: 2 found between the edges"]


def test_a_form_folded_flat_keeps_the_faces_that_are_turned_over(tmp_path):
    folded = {
        "vertices_coords": [[0, 0], [10, 0], [0, 0], [0, 10]],
        "edges_vertices": [[0, 1], [1, 2], [2, 3], [3, 0], [1, 3]],
    }
    faces = {
        "faces_vertices": [[0, 1, 3], [1, 2, 3]],
        "frame_classes": ["foldedForm"],
        "edges_assignment": list("BBBBV"),
    }
    pattern, _ = outcome(tmp_path, folded | faces)
    assert pattern.faces_vertices == ((0, 1, 3), (1, 2, 3))
    with pytest.raises(InputError, match=r"faces_vertices\[1\]: need a sheet laid flat, .*, got a face turned over"):
        kawasaki_residuals(pattern)


def test_border_between_two_faces_is_a_cut(tmp_path):
    pattern, remarks = outcome(tmp_path, {"edges_assignment": list("BBBBB")})
    assert pattern.edges_assignment == tuple("BBBBC")
    assert "edges_assignment: border between two faces taken as a cut, edge 4" in remarks


def test_flat_lines_that_end_in_a_face_and_lone_vertices_are_left_out(tmp_path):
    """Auxiliary lines as Oriedita writes them."""
    loose = {
        "vertices_coords": [[50, 50], *SQUARE["vertices_coords"], [4, 2], [6, 3]],
        "edges_vertices": [[5, 6], [1, 2], [2, 3], [3, 4], [4, 1], [1, 3], [3, 5]],
        "edges_assignment": list("FBBBBVF"),
        "forficula:edges_role": list("abcdefg"),
    }
    bent = {"frame_classes": ["foldedForm"], "frame_inherit": True}
    pattern, remarks = outcome(tmp_path, loose | {"file_frames": [bent]})
    assert remarks == [
        "faces_vertices: 2 found between the edges",
        "edges_vertices: left out, as no face is beside it, edges 0 and 6; later numbers move up",
        "vertices_coords: left out, as no edge is at it, vertices 0, 5 and 6; later numbers move up",
    ]
    assert pattern.edges_assignment == tuple("BBBBV")
    assert pattern.edges_role == tuple("bcdef")
    assert pattern.edges_vertices.tolist() == [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]]
    ((_, coords, folds),) = read_folded_frames(tmp_path / "square.fold")
    np.testing.assert_array_equal(coords, pattern.vertices_coords)
    assert folds.shape == (5,)
