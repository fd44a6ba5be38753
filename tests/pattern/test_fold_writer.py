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
    read_fold,
    read_folded_frames,
    write_fold,
)
from tests.pattern.fold_files import OTHERS, SQUARE, written

FAN = EarwigFan(proximal_length=0.12, distal_length=0.10, hub_radius=0.015, sector_angle=math.radians(20), units=2)


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


def test_a_folded_state_of_another_shape_does_not_change_the_old_file(tmp_path):
    pattern, path = earwig_pattern(FAN), tmp_path / "fan.fold"
    path.write_text("old", encoding="utf-8")
    with pytest.raises(InputError, match=r"frames\[0\]: need finite positions"):
        write_fold(pattern, path, frames=[("short", np.zeros((2, 3)), pattern.edges_fold_angle)])
    with pytest.raises(InputError, match=r"frames\[0\]: need finite fold angles"):
        write_fold(pattern, path, frames=[("short", pattern.vertices_coords, np.zeros(2))])
    assert path.read_text(encoding="utf-8") == "old"
    assert [entry.name for entry in tmp_path.iterdir()] == ["fan.fold"]


def same(one, other):
    for key in ("vertices_coords", "edges_vertices", "edges_fold_angle"):
        np.testing.assert_array_equal(getattr(one, key), getattr(other, key))
    for key in ("edges_assignment", "faces_vertices", "edges_role", "title"):
        assert getattr(one, key) == getattr(other, key)


@pytest.mark.parametrize("name", ["squareBase", "simple", "diagonal-cp"])
def test_what_others_wrote_is_read_back_bit_for_bit_once_written(tmp_path, name):
    first = read_fold(OTHERS / f"{name}.fold", unit=0.0123)
    write_fold(first, tmp_path / "again.fold")
    same(read_fold(tmp_path / "again.fold"), first)


@given(
    angle=st.floats(-180, 180),
    corners=st.lists(st.tuples(st.floats(-1e-3, 1e-3), st.floats(-1e-3, 1e-3)), min_size=4, max_size=4),
    lift=st.floats(0, 5),
    unit=st.sampled_from(["mm", "in", None]),
)
def test_in_and_out_and_in_again_is_the_same(tmp_path_factory, angle, corners, lift, unit):
    base = tmp_path_factory.getbasetemp()
    moved = [[x + dx, y + dy] for (x, y), (dx, dy) in zip(SQUARE["vertices_coords"], corners, strict=True)]
    moved[0] = [*moved[0], lift]
    changes = {"frame_unit": unit, "vertices_coords": moved, "edges_foldAngle": [None, 0, None, 0, angle]}
    faces = {"faces_vertices": [[0, 1, 2], [0, 2, 3]]}
    given_unit = None if unit else 0.0254 / 72
    first = read_fold(written(base / "first.fold", changes | faces), unit=given_unit)
    write_fold(first, base / "again.fold")
    same(read_fold(base / "again.fold"), first)
    assert math.radians(angle) == first.edges_fold_angle[4]


def test_own_values_are_written_in_the_namespace_forficula(tmp_path):
    pattern = earwig_pattern(FAN)
    extra = {"edges_stiffness": [0.5] * len(pattern.edges_vertices), "faces_thickness": [None, 1e-4] * 4}
    write_fold(pattern, tmp_path / "fan.fold", extra=extra)
    document = json.loads((tmp_path / "fan.fold").read_text(encoding="utf-8"))
    assert document["forficula:edges_stiffness"][3] == 0.5
    assert document["forficula:faces_thickness"][:2] == [None, 1e-4]
    same(read_fold(tmp_path / "fan.fold"), pattern)


@pytest.mark.parametrize(
    ("extra", "message"),
    [
        ({"faces_thickness": [1.0]}, r"own\.faces_thickness: need one value for each of the 8 faces, got 1"),
        ({"thickness": []}, 'own: need keys that begin with vertices_, edges_ or faces_, got "thickness"'),
        ({"edges_role": []}, 'own: need keys .* got "edges_role"'),
        (
            {"faces_thickness": [math.inf] * 8},
            r"own\.faces_thickness\[0\]: need a finite number, text or None, got inf",
        ),
    ],
)
def test_own_values_of_another_number_are_refused(tmp_path, extra, message):
    with pytest.raises(InputError, match=message):
        write_fold(earwig_pattern(FAN), tmp_path / "fan.fold", extra=extra)
    assert not list(tmp_path.iterdir())
