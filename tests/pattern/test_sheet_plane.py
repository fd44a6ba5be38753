import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from forficula.pattern import read_fold
from tests.pattern.fold_files import SQUARE, written


def turned_square(turn):
    """The square with its faces, rotated into another plane and shifted."""
    coords = np.array([[x, y, 0] for x, y in SQUARE["vertices_coords"]]) @ turn.T + np.array([3, -4, 5])
    return {"vertices_coords": coords.tolist(), "faces_vertices": [[0, 1, 2], [0, 2, 3]]}


@given(st.lists(st.floats(-1, 1), min_size=4, max_size=4).filter(lambda q: np.linalg.norm(q) > 0.1))
def test_a_sheet_in_any_plane_is_laid_flat_with_its_faces_up(tmp_path_factory, quaternion):
    turn = Rotation.from_quat(quaternion).as_matrix()
    path = written(tmp_path_factory.getbasetemp() / "turned.fold", turned_square(turn))
    pattern = read_fold(path)
    assert np.ptp(pattern.vertices_coords[:, 2]) == 0
    assert set(pattern.faces_vertices) <= {(0, 1, 2), (0, 2, 3), (2, 1, 0), (3, 2, 0)}
    areas = [
        np.cross(*(pattern.vertices_coords[[b, c]] - pattern.vertices_coords[a]))[2]
        for a, b, c in pattern.faces_vertices
    ]
    assert areas == pytest.approx([1e-4] * 2)  # counterclockwise, of their size
    if abs(turn[2, 2] + 1) > 1e-5:  # a sheet upside down in its own plane is only renamed
        assert pattern.faces_vertices == ((0, 1, 2), (0, 2, 3))
