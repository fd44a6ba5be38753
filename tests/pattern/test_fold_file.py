import json
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from forficula.errors import InputError
from forficula.pattern import (
    EarwigFan,
    earwig_pattern,
    fan_fold_angles,
    folded_coordinates,
    interior_vertices,
    read_fold,
    read_folded_frames,
    write_fold,
)

FAN = EarwigFan(proximal_length=0.12, distal_length=0.10, hub_radius=0.015, sector_angle=math.radians(20), units=2)
SQUARE = {
    "frame_unit": "mm",
    "vertices_coords": [[0, 0], [10, 0], [10, 10], [0, 10]],
    "edges_vertices": [[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]],
}


def written(path, changes=None, without=()):
    """A FOLD file of a square with a diagonal, 10 mm wide, as another program may write it."""
    document = {key: value for key, value in (SQUARE | (changes or {})).items() if key not in without}
    path.write_text(json.dumps(document), encoding="utf-8")
    return path


@given(length=st.floats(1e-3, 1), radius=st.floats(0, 1), angle=st.floats(0.05, 0.6), units=st.integers(1, 4))
def test_what_is_written_is_read_back_bit_for_bit(tmp_path_factory, length, radius, angle, units):
    pattern = earwig_pattern(
        EarwigFan(
            proximal_length=length,
            distal_length=0.7 * length,
            hub_radius=radius * length,
            sector_angle=angle,
            units=units,
        )
    )
    path = tmp_path_factory.getbasetemp() / "fan.fold"
    write_fold(pattern, path)
    again = read_fold(path)
    np.testing.assert_array_equal(again.vertices_coords, pattern.vertices_coords)
    np.testing.assert_array_equal(again.edges_vertices, pattern.edges_vertices)
    np.testing.assert_allclose(again.edges_fold_angle, pattern.edges_fold_angle, rtol=0, atol=1e-12)
    assert again.faces_vertices == pattern.faces_vertices
    assert again.edges_assignment == pattern.edges_assignment
    assert again.edges_role == pattern.edges_role
    assert again.title == pattern.title


def test_the_file_is_fold_in_metres_and_degrees(tmp_path):
    pattern = earwig_pattern(FAN)
    write_fold(pattern, tmp_path / "fan.fold")
    document = json.loads((tmp_path / "fan.fold").read_text(encoding="utf-8"))
    assert document["file_spec"] == 1.2
    assert document["file_creator"] == "forficula"
    assert document["frame_unit"] == "m"
    assert document["frame_classes"] == ["creasePattern"]
    meaning = {"M": -180, "V": 180, "B": None}
    assert document["edges_foldAngle"] == [meaning[letter] for letter in document["edges_assignment"]]
    assert len(document["faces_vertices"]) == 8
    assert document["forficula:edges_role"][0] == "proximal"
    assert [path.name for path in tmp_path.iterdir()] == ["fan.fold"]


def test_folded_states_become_frames_that_inherit(tmp_path):
    pattern, folds = earwig_pattern(FAN), fan_fold_angles(FAN, 2.0)
    coords = folded_coordinates(pattern, folds)
    write_fold(pattern, tmp_path / "fan.fold", frames=[("half folded", coords, folds)])
    (frame,) = json.loads((tmp_path / "fan.fold").read_text(encoding="utf-8"))["file_frames"]
    assert frame["frame_classes"] == ["foldedForm"]
    assert frame["frame_parent"] == 0
    assert frame["frame_inherit"] is True
    assert frame["vertices_coords"] == coords.tolist()
    assert frame["edges_foldAngle"][1] == pytest.approx(math.degrees(2.0))
    assert read_fold(tmp_path / "fan.fold").edges_fold_angle[1] == pytest.approx(math.pi)


@given(st.lists(st.floats(0, 3.1), max_size=3))
def test_folded_states_are_read_back_with_the_bits_of_their_positions(tmp_path_factory, angles):
    pattern = earwig_pattern(FAN)
    states = [(f"state {angle}", fan_fold_angles(FAN, angle)) for angle in angles]
    written_frames = [(title, folded_coordinates(pattern, folds), folds) for title, folds in states]
    path = tmp_path_factory.getbasetemp() / "states.fold"
    write_fold(pattern, path, frames=written_frames)
    frames = read_folded_frames(path)
    assert [title for title, _, _ in frames] == [title for title, _, _ in written_frames]
    for (_, coords, folds), (_, written_coords, written_folds) in zip(frames, written_frames, strict=True):
        np.testing.assert_array_equal(coords, written_coords)
        np.testing.assert_allclose(folds, written_folds, rtol=0, atol=1e-12)  # degrees in the file


FOLDED = {"frame_classes": ["foldedForm"], "vertices_coords": [[0, 0], [10, 0], [0, 0], [0, 10]]}


def states(path, *frames, changes=None):
    """The folded states in a file of the square, each coordinate and angle as numbers."""
    read = read_folded_frames(written(path / "square.fold", {"file_frames": list(frames)} | (changes or {})))
    return [(title, coords.tolist(), folds.tolist()) for title, coords, folds in read]


def test_a_frame_inherits_edges_fold_angles_and_unit_along_its_parents(tmp_path):
    inherits = FOLDED | {"frame_inherit": True}
    angles = {"edges_foldAngle": [0, 0, 0, 0, 90]}
    frames = [inherits | angles | {"frame_parent": 0}, inherits | {"frame_parent": 1, "frame_title": "same angles"}]
    (_, coords, folds), (title, _, same) = states(tmp_path, *frames)
    assert coords == [[0, 0, 0], [0.01, 0, 0], [0, 0, 0], [0, 0.01, 0]]
    assert folds == same == [0, 0, 0, 0, pytest.approx(math.pi / 2)]
    assert title == "same angles"


def test_a_frame_may_hold_vertices_edges_and_unit_of_its_own(tmp_path):
    own = {"frame_classes": ["foldedForm"], "vertices_coords": [[0, 0], [1, 0]], "edges_vertices": [[0, 1]]}
    ((_, coords, _), (_, in_metres, _)) = states(tmp_path, own, own | {"frame_unit": "m"})
    assert coords == [[0, 0, 0], [1e-3, 0, 0]]
    assert in_metres == [[0, 0, 0], [1, 0, 0]]


def test_frames_that_are_no_folded_states_are_left_out(tmp_path):
    assert states(tmp_path, {"frame_title": "notes"}, {"frame_classes": ["graph"]}) == []
    assert read_folded_frames(written(tmp_path / "square.fold")) == []


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"frame_parent": 0}, "vertices_coords: need 4 positions, as many as in the parent, got 1"),
        ({}, "frame_parent: need the number of a frame, 0 to 1, got None"),
        ({"frame_parent": 7}, "frame_parent: need the number of a frame, 0 to 1, got 7"),
        ({"frame_parent": 1}, "frame_parent: need a parent that does not inherit from the frame itself, got 1"),
        ({"frame_inherit": False, "frame_unit": "ell"}, "frame_unit: need a unit of length"),
        ({"frame_inherit": False, "vertices_coords": [[0]]}, r"vertices_coords\[0\]: need two or three numbers"),
        ({"frame_inherit": False, "edges_foldAngle": [0]}, "edges_foldAngle: need one for each of the 0 edges, got 1"),
        ({"frame_classes": "foldedForm", "frame_inherit": False}, "frame_classes: need a list, got str"),
    ],
)
def test_a_frame_that_is_no_folded_state_is_refused_with_its_number_and_key(tmp_path, changes, message):
    frame = {"frame_classes": ["foldedForm"], "frame_inherit": True, "vertices_coords": [[0, 0]]} | changes
    with pytest.raises(InputError, match=rf"square\.fold: file_frames\[0\]: {message}") as refusal:
        states(tmp_path, frame)
    assert "\n" not in str(refusal.value)


def test_a_chain_of_frames_may_be_as_long_as_a_film(tmp_path):
    states = {"frame_classes": ["foldedForm"], "frame_inherit": True}
    frames = [states | {"frame_title": str(number), "frame_parent": number + 2} for number in range(3000)]
    frames[-1]["frame_parent"] = 0
    read = read_folded_frames(written(tmp_path / "square.fold", {"file_frames": frames}))
    assert [title for title, _, _ in read] == [str(number) for number in range(3000)]
    assert all(coords.shape == (4, 3) for _, coords, _ in read)


def test_a_chain_of_frames_that_closes_is_refused(tmp_path):
    states = {"frame_classes": ["foldedForm"], "frame_inherit": True}
    frames = [states | {"frame_parent": number % 3000 + 1} for number in range(1, 3001)]
    with pytest.raises(InputError, match=r"file_frames\[0\]: frame_parent: need a parent that does not inherit from"):
        read_folded_frames(written(tmp_path / "square.fold", {"file_frames": frames}))


def test_frames_that_are_no_objects_are_refused(tmp_path):
    with pytest.raises(InputError, match=r"square\.fold: file_frames\[0\]: need a JSON object with FOLD keys, got int"):
        states(tmp_path, 7)
    with pytest.raises(InputError, match=r"square\.fold: file_frames: need a list, got dict"):
        states(tmp_path, changes={"file_frames": {}})


def test_a_folded_state_of_another_shape_leaves_the_old_file_alone(tmp_path):
    pattern, path = earwig_pattern(FAN), tmp_path / "fan.fold"
    path.write_text("old", encoding="utf-8")
    with pytest.raises(InputError, match=r"frames\[0\]: need finite positions"):
        write_fold(pattern, path, frames=[("short", np.zeros((2, 3)), pattern.edges_fold_angle)])
    with pytest.raises(InputError, match=r"frames\[0\]: need finite fold angles"):
        write_fold(pattern, path, frames=[("short", pattern.vertices_coords, np.zeros(2))])
    assert path.read_text(encoding="utf-8") == "old"
    assert [entry.name for entry in tmp_path.iterdir()] == ["fan.fold"]


@pytest.mark.parametrize(
    ("unit", "metres"),
    [("m", 10), ("cm", 0.1), ("mm", 0.01), ("um", 1e-5), ("nm", 1e-8), ("in", 0.254), ("pt", 0.254 / 72)],
)
def test_every_unit_of_length_is_converted_to_metres(tmp_path, unit, metres):
    pattern = read_fold(written(tmp_path / "square.fold", {"frame_unit": unit}))
    assert pattern.vertices_coords[2] == pytest.approx([metres, metres, 0], rel=1e-15)


def test_missing_assignments_fold_angles_and_faces_are_filled_in(tmp_path):
    pattern = read_fold(written(tmp_path / "square.fold"))
    assert pattern.edges_assignment == ("U",) * 5
    assert np.isnan(pattern.edges_fold_angle).all()
    assert {frozenset(face) for face in pattern.faces_vertices} == {frozenset({0, 1, 2}), frozenset({0, 2, 3})}
    assert len(interior_vertices(pattern)) == 0


def test_faces_found_from_the_edges_are_those_of_the_fan(tmp_path):
    pattern, path = earwig_pattern(FAN), tmp_path / "fan.fold"
    write_fold(pattern, path)
    document = json.loads(path.read_text(encoding="utf-8"))
    del document["faces_vertices"]
    path.write_text(json.dumps(document), encoding="utf-8")
    found = read_fold(path)

    def from_lowest(face):
        first = face.index(min(face))
        return face[first:] + face[:first]

    assert {from_lowest(face) for face in found.faces_vertices} == {
        from_lowest(face) for face in pattern.faces_vertices
    }


def test_clockwise_faces_are_turned(tmp_path):
    pattern = read_fold(written(tmp_path / "square.fold", {"faces_vertices": [[0, 2, 1], [0, 2, 3]]}))
    assert pattern.faces_vertices == ((1, 2, 0), (0, 2, 3))


def test_a_join_is_flat_and_null_is_no_fold_angle(tmp_path):
    changes = {"edges_assignment": list("BBBBJ"), "edges_foldAngle": [None, None, None, None, 90]}
    pattern = read_fold(written(tmp_path / "square.fold", changes))
    assert pattern.edges_assignment == tuple("BBBBF")
    assert pattern.edges_fold_angle[4] == pytest.approx(math.pi / 2)
    assert np.isnan(pattern.edges_fold_angle[:4]).all()


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        (
            {"frame_unit": "unit"},
            'frame_unit: need a unit of length, one of m, cm, .*, got "unit"; write .* as in "frame_unit": "cm"$',
        ),
        ({"frame_unit": None}, 'frame_unit: need a unit .* got no frame_unit; write .* as in "frame_unit": "cm"$'),
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
        ({"edges_vertices": [[0, 1], [2, 3]]}, "faces_vertices: need the key in the file, .* hang together"),
        ({"vertices_coords": [[0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]]}, "faces_vertices: .* got a solid shape"),
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


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"solid fan", r"need JSON, as FOLD files are: Expecting value \(at line 1, column 1\)$"),
        (b"\xff\xfe\x00", "need JSON, as FOLD files are: not UTF-8 text from byte 0 on$"),
        (b"[" * 100_000, "need JSON, as FOLD files are: nested too deeply$"),
        (b"[1" + b"0" * 5000 + b"]", "need JSON, as FOLD files are: a whole number has too many digits$"),
        (b"[1, 2]", "need a JSON object with FOLD keys, got list"),
        (b'{"vertices_coords": [[NaN, 0]]}', "need finite numbers only, got NaN"),
        (b'{"frame_unit": "m", "vertices_coords": [[1e999, 0]]}', r"vertices_coords\[0\]: need a finite number"),
    ],
)
def test_a_file_that_is_no_fold_file_is_refused(tmp_path, content, message):
    (tmp_path / "fan.fold").write_bytes(content)
    with pytest.raises(InputError, match=rf"fan\.fold: {message}") as refusal:
        read_fold(tmp_path / "fan.fold")
    assert "\n" not in str(refusal.value)


def test_a_file_that_is_not_there_is_refused(tmp_path):
    with pytest.raises(InputError, match=r"none\.fold: need a file that can be read, got No such file"):
        read_fold(tmp_path / "none.fold")
