import math

import pytest

from forficula.errors import InputError
from forficula.pattern import fold_pattern, read_fold, read_folded_frames
from tests.pattern.fold_files import outcome, written

FOLDED = {"frame_classes": ["foldedForm"], "vertices_coords": [[0, 0], [10, 0], [0, 0], [0, 10]]}


def states(path, *frames, changes=None):
    """The folded states in a file of the square, as numbers."""
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


def test_a_frame_can_have_other_vertices_edges_and_unit_than_the_file(tmp_path):
    frame = {"frame_classes": ["foldedForm"], "vertices_coords": [[0, 0], [1, 0]], "edges_vertices": [[0, 1]]}
    ((_, coords, _), (_, in_metres, _)) = states(tmp_path, frame, frame | {"frame_unit": "m"})
    assert coords == [[0, 0, 0], [1e-3, 0, 0]]
    assert in_metres == [[0, 0, 0], [1, 0, 0]]


def test_frames_without_the_class_folded_form_are_left_out(tmp_path):
    assert states(tmp_path, {"frame_title": "notes"}, {"frame_classes": ["graph"]}) == []
    assert read_folded_frames(written(tmp_path / "square.fold")) == []


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"frame_parent": 0}, "vertices_coords: need 4 positions, as many as in the parent, got 1"),
        ({}, "vertices_coords: need 4 positions, as many as in the parent, got 1"),
        ({"frame_parent": None}, "frame_parent: need the number of a frame, 0 to 1, got None"),
        ({"frame_parent": 7}, "frame_parent: need the number of a frame, 0 to 1, got 7"),
        ({"frame_parent": 1}, "frame_parent: need a parent that does not inherit from the frame itself, got 1"),
        ({"frame_inherit": False, "frame_unit": "ell"}, "frame_unit: need a unit of length"),
        ({"frame_inherit": False, "vertices_coords": [[0]]}, r"vertices_coords\[0\]: need two or three numbers"),
        ({"frame_inherit": False, "edges_foldAngle": [0]}, "edges_foldAngle: need one for each of the 0 edges, got 1"),
        ({"frame_classes": "foldedForm", "frame_inherit": False}, "frame_classes: need a list, got str"),
    ],
)
def test_an_invalid_folded_state_is_refused_with_its_number_and_key(tmp_path, changes, message):
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


def test_frames_are_chosen_by_number_title_or_class(tmp_path):
    pattern = {"frame_title": "flat", "frame_classes": ["creasePattern"], "frame_inherit": True, "frame_parent": 0}
    smaller = pattern | {"vertices_coords": [[0, 0], [5, 0], [5, 5], [0, 5]]}
    frames = {"file_frames": [{"frame_title": "notes"}, smaller]}
    for frame in (2, "flat", "creasePattern"):
        assert outcome(tmp_path, frames, frame=frame)[0].vertices_coords[2, 0] == pytest.approx(5e-3)
    assert outcome(tmp_path, frames)[0].vertices_coords[2, 0] == pytest.approx(0.01)


@pytest.mark.parametrize(
    ("frame", "message"),
    [
        (3, "frame: need the number of a frame, 0 to 1, got 3"),
        (-1, "frame: need the number of a frame, 0 to 1, got -1"),
        ("flatt", 'frame: need the title of a frame, "flat", .* or a class .*, got "flatt"; did you mean "flat"'),
        (1, r"file_frames\[0\]: vertices_coords: need a list, but the key is missing"),
        (True, "frame: need a number or a title, got true"),
    ],
)
def test_a_missing_frame_is_refused(tmp_path, frame, message):
    with pytest.raises(InputError, match=message):
        outcome(tmp_path, {"file_frames": [{"frame_title": "flat"}]}, frame=frame)


def test_a_film_of_origami_simulator_begins_with_its_first_state(tmp_path):
    """Its frames contain the vertices and no parent; the key frame contains the rest."""
    state = {"frame_classes": ["foldedForm"], "frame_inherit": True, "frame_title": "film", "frame_unit": "unit"}
    flat = state | {"vertices_coords": [[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1]]}
    bent = state | {"vertices_coords": [[0, 0, 0], [1, 0.5, 0], [1, 0, 1], [0, 0.5, 1]]}
    changes = {"file_frames": [flat, bent], "faces_vertices": [[0, 2, 1], [0, 3, 2]]}
    path = written(tmp_path / "film.fold", changes, without=("vertices_coords", "frame_unit"))
    pattern, remarks = fold_pattern(path, unit=0.01)
    assert remarks[0] == 'file_frames[0]: used, "film", because the key frame has no vertices'
    assert pattern.vertices_coords[2].tolist() == [0.01, -0.01, 0]
    ((_, coords, _),) = read_folded_frames(path, unit=0.01)
    assert coords[1].tolist() == [0.01, 0, 0.005]  # rotated like the sheet: up was y


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
def test_an_invalid_fold_file_is_refused(tmp_path, content, message):
    (tmp_path / "fan.fold").write_bytes(content)
    with pytest.raises(InputError, match=rf"fan\.fold: {message}") as refusal:
        read_fold(tmp_path / "fan.fold")
    assert "\n" not in str(refusal.value)


def test_a_missing_file_is_refused(tmp_path):
    with pytest.raises(InputError, match=r"none\.fold: no such file"):
        read_fold(tmp_path / "none.fold")
