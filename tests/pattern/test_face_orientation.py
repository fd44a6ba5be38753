"""Faces of sheets in space with any orientation in the file."""

import json

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from forficula.design import load_design
from forficula.errors import InputError
from forficula.pattern import read_fold
from forficula.pattern.facts.pattern_facts import pattern_facts
from forficula.pattern.files.fold_file import oriented_faces

FACES = [list(face) for face in load_design("miura-sheet").sheet.faces_vertices]


@given(st.sets(st.integers(0, len(FACES) - 1), max_size=len(FACES) // 2 - 1))
def test_the_fewer_are_turned_back(over):
    mixed = [face[::-1] if number in over else face for number, face in enumerate(FACES)]
    faces, turned = oriented_faces(mixed)
    assert turned == sorted(over)
    assert faces == FACES


def test_pieces_are_turned_by_themselves():
    faces, turned = oriented_faces([[0, 1, 2], [2, 1, 3], [4, 5, 6], [5, 6, 7]])
    assert turned == [3]
    assert faces[3] == [7, 6, 5]


def test_a_sheet_of_one_side_is_refused():
    strip = [[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 5], [4, 5, 1], [1, 5, 0]]
    with pytest.raises(InputError, match="with only one side"):
        oriented_faces(strip)


def test_a_folded_sheet_with_faces_in_any_sense_is_read(tmp_path):
    sheet = load_design("miura-sheet").sheet
    text = {
        "file_spec": 1.1,
        "frame_unit": "m",
        "vertices_coords": sheet.vertices_coords.tolist(),
        "edges_vertices": sheet.edges_vertices.tolist(),
        "edges_assignment": list(sheet.edges_assignment),
        "faces_vertices": [face[::-1] if number in (3, 7) else face for number, face in enumerate(FACES)],
    }
    (tmp_path / "mixed.fold").write_text(json.dumps(text), "utf-8")
    read = read_fold(tmp_path / "mixed.fold")
    assert [list(face) for face in read.faces_vertices] == FACES
    assert pattern_facts(read).freedoms == pattern_facts(sheet).freedoms
    np.testing.assert_array_equal(read.vertices_coords, sheet.vertices_coords)
