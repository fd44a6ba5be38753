import math
import re

import numpy as np
import pytest

from forficula.errors import InputError
from forficula.pattern import read_fold
from tests.pattern.fold_files import outcome, written


@pytest.mark.parametrize(
    ("unit", "metres"),
    [("m", 10), ("cm", 0.1), ("mm", 0.01), ("um", 1e-5), ("nm", 1e-8), ("in", 0.254), ("pt", 0.254 / 72)],
)
def test_every_unit_of_length_is_converted_to_metres(tmp_path, unit, metres):
    pattern = read_fold(written(tmp_path / "square.fold", {"frame_unit": unit}))
    assert pattern.vertices_coords[2] == pytest.approx([metres, metres, 0], rel=1e-15)


@pytest.mark.parametrize("unit", ["unit", None, "ell"])
def test_the_unit_of_the_caller_applies_if_the_file_has_none(tmp_path, unit):
    pattern, _ = outcome(tmp_path, {"frame_unit": unit}, unit=0.01)
    assert pattern.vertices_coords[2].tolist() == [0.1, 0.1, 0]


def test_two_units_that_differ_are_refused(tmp_path):
    with pytest.raises(
        InputError, match='frame_unit: need no unit that contradicts that of the file, "mm", got 10 mm; remove'
    ):
        outcome(tmp_path, unit=0.01)
    assert outcome(tmp_path, unit=1e-3)[0].vertices_coords[2].tolist() == [0.01, 0.01, 0]
    with pytest.raises(InputError, match="unit: need a length > 0, got 0 m"):
        outcome(tmp_path, unit=0.0)


def test_a_join_is_flat_and_null_is_no_fold_angle(tmp_path):
    changes = {"edges_assignment": list("BBBBJ"), "edges_foldAngle": [None, None, None, None, 90]}
    pattern = read_fold(written(tmp_path / "square.fold", changes))
    assert pattern.edges_assignment == tuple("BBBBF")
    assert pattern.edges_fold_angle[4] == pytest.approx(math.pi / 2)
    assert np.isnan(pattern.edges_fold_angle[:4]).all()


def test_letters_come_from_the_signs_of_fold_angles(tmp_path):
    angles = {"edges_foldAngle": [None, 0, 0, None, -30]}
    assert outcome(tmp_path, angles)[0].edges_assignment == tuple("BBBBM")
    angles = {"edges_foldAngle": [None, 0, 0, None, 0]}
    assert outcome(tmp_path, angles)[0].edges_assignment == tuple("BBBBF")


@pytest.mark.parametrize(("letter", "degrees"), [("M", -180), ("V", 180), ("F", 0), ("U", math.nan), ("J", 0)])
def test_fold_angles_come_from_the_letters(tmp_path, letter, degrees):
    for angles in ({}, {"edges_foldAngle": [0, 0, 0, 0, None]}):
        pattern, _ = outcome(tmp_path, {"edges_assignment": [*"BBBB", letter]} | angles)
        np.testing.assert_array_equal(np.degrees(pattern.edges_fold_angle), [math.nan] * 4 + [degrees])


def test_small_letters_words_and_null_are_understood(tmp_path):
    letters = {"edges_assignment": ["b", "Boundary", "border", "B", "mountain"]}
    assert outcome(tmp_path, letters)[0].edges_assignment == tuple("BBBBM")
    letters = {"edges_assignment": ["B", "B", "B", "B", None]}
    assert outcome(tmp_path, letters)[0].edges_assignment == tuple("BBBBU")


def test_edges_fold_angles_of_fold_1_0_are_read_with_radians_of_origami_simulator(tmp_path):
    letters = {"edges_assignment": list("BBBBV"), "file_spec": 1}
    degrees = letters | {"edges_foldAngles": [0, 0, 0, 0, 3]}
    assert outcome(tmp_path, degrees)[0].edges_fold_angle[4] == math.radians(3)
    pattern, remarks = outcome(tmp_path, degrees | {"file_creator": "Origami Simulator: http://..."})
    assert pattern.edges_fold_angle[4] == pytest.approx(3)
    assert "edges_foldAngles: taken as radians, which Origami Simulator wrote under this name" in remarks


def test_edges_come_from_faces_where_the_file_has_faces_only(tmp_path):
    faces = {"faces_vertices": [[0.0, 1, 2], [0, 2, 3]]}
    pattern, _ = outcome(tmp_path, faces, without=("edges_vertices",))
    assert pattern.edges_vertices.tolist() == [[0, 1], [1, 2], [0, 2], [2, 3], [0, 3]]
    assert pattern.edges_assignment == tuple("BBUBB")
    with pytest.raises(
        InputError, match="edges_vertices: need the key in the file, for edges_assignment says something"
    ):
        outcome(tmp_path, faces | {"edges_assignment": list("BBBBB")}, without=("edges_vertices",))


@pytest.mark.parametrize("unit", [1e300, 1e-300, 1e13, 1e-14])
def test_a_unit_by_which_a_sheet_is_larger_than_worlds_or_smaller_than_atoms_is_refused(tmp_path, unit):
    message = rf"need a sheet of a size from 1e-12 m to 1e\+12 m, got 10 units of {re.escape(f'{unit:g}')} m each"
    with pytest.raises(InputError, match=message):
        outcome(tmp_path, {"frame_unit": "unit"}, unit=unit)
