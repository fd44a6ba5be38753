import json
import math
from time import process_time

import numpy as np
import pytest

from forficula.errors import InputError
from forficula.pattern import read_fold
from forficula.pattern.drawings.flat_faces import check_face_sides
from tests.pattern.fold_files import SQUARE, outcome

CENTRE = [*SQUARE["vertices_coords"], [5, 5]]

RIM = SQUARE["edges_vertices"][:4]


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        (
            {"edges_vertices": [*RIM, [0, 2], [1, 3]]},
            r"edges_vertices\[5\]: need a vertex where edges cross, got 1 to 3 across edge 4, 0 to 2; split both there",
        ),
        (
            {"vertices_coords": CENTRE, "edges_vertices": [*RIM, [0, 2], [1, 4]]},
            r"edges_vertices\[5\]: need edges without a free end, got one with a free end at vertex 4; extend it",
        ),
        (
            {"vertices_coords": CENTRE, "edges_vertices": [*RIM, [0, 2], [1, 4], [4, 3]]},
            r"edges_vertices\[4\]: need vertices at its ends only, got vertex 4 on the edge from 0 to 2; write",
        ),
        (
            {
                "vertices_coords": [*SQUARE["vertices_coords"], [10, 0]],
                "edges_vertices": [*RIM, [0, 2], [2, 4], [4, 0]],
            },
            r"vertices_coords\[4\]: need vertices of a flat sheet at different positions, got that of vertex 1",
        ),
        (
            {"edges_vertices": [[0, 1], [1, 3], [3, 2], [2, 0]], "faces_vertices": [[0, 1, 3, 2]]},
            r"faces_vertices\[0\]: need a face that does not cross itself, got its sides 3 to 1 and 0 to 2 crossing",
        ),
        ({"faces_vertices": [[0, 1, 2], []]}, r"faces_vertices\[1\]: need at least 3 vertices, got 0"),
        ({"vertices_coords": [[1e200, 0], [0, 0]]}, r"vertices_coords: need numbers up to 1e\+100, got 1e\+200"),
        (
            {"faces_vertices": [[0, 1, 2, 3], [0, 1, 2]]},
            r"faces_vertices\[0\]: need faces between the edges, got the edge from 2 to 0 inside the face; split",
        ),
        (
            {"edges_vertices": [*RIM, [0, 2], [1, 3]], "faces_vertices": [[0, 1, 2], [0, 2, 3], [0, 1, 3]]},
            r"edges_vertices\[5\]: need a vertex where edges cross",
        ),
        (
            {
                "vertices_coords": [*SQUARE["vertices_coords"], [7, 2], [8, 2], [8, 3]],
                "edges_vertices": [*RIM, [0, 2], [4, 5], [5, 6], [6, 4]],
                "faces_vertices": [[0, 1, 2], [0, 2, 3], [4, 5, 6]],
            },
            r"faces_vertices\[0\]: need faces side by side, got vertex 4, of a part that is not connected",
        ),
        (
            {
                "vertices_coords": [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [0, -1, 1]],
                "edges_vertices": [[0, 1], [1, 2], [2, 0], [1, 3], [3, 0], [1, 4], [4, 0]],
                "faces_vertices": [[0, 1, 2], [0, 1, 3], [0, 1, 4]],
            },
            r"edges_vertices\[0\]: need at most two faces at an edge, got 3; split the edge",
        ),
    ],
)
def test_what_cannot_be_built_is_refused_with_its_key(tmp_path, changes, message):
    with pytest.raises(InputError, match=rf"square\.fold: {message}") as refusal:
        outcome(tmp_path, changes)
    assert "\n" not in str(refusal.value)


def test_a_face_that_crosses_itself_is_found_in_a_solid_shape(tmp_path):
    bow_tie = {
        "vertices_coords": [[0, 0, 0], [0, 10, 0], [0, 10, 10], [0, 0, 10], [5, 0, 0]],
        "edges_vertices": [[0, 1], [1, 3], [3, 2], [2, 0], [1, 4], [4, 0]],
        "faces_vertices": [[0, 1, 3, 2], [0, 4, 1]],
    }
    with pytest.raises(InputError, match=r"faces_vertices\[0\]: need a face that does not cross itself, got its sides"):
        outcome(tmp_path, bow_tie)


def test_a_grid_of_thousands_of_squares_without_faces_is_read_in_seconds(tmp_path):
    count = 70
    number = np.arange(count**2).reshape(count, count)
    across, upwards = (number[:, :-1], number[:, 1:]), (number[:-1], number[1:])
    edges = np.concatenate([np.column_stack([one.ravel(), other.ravel()]) for one, other in (across, upwards)])
    document = {
        "vertices_coords": [[x, y] for y in range(count) for x in range(count)],
        "edges_vertices": edges.tolist(),
    }
    path = tmp_path / "grid.fold"
    path.write_text(json.dumps(document))
    before = process_time()
    result = {frozenset(face) for face in read_fold(path, 0.01).faces_vertices}
    assert process_time() - before < 6  # all pairs of edges took four times as long
    corners = (number[:-1, :-1], number[:-1, 1:], number[1:, 1:], number[1:, :-1])
    assert result == {frozenset(face) for face in zip(*(corner.flat for corner in corners), strict=True)}


@pytest.mark.parametrize("corners", [[0, 2, 4, 1, 3], [0, 1, 3, 2, 4], [0, 3, 1, 4, 2]])
def test_a_face_like_a_star_which_turns_to_one_side_crosses_itself(corners):
    places = [[math.cos(angle), math.sin(angle)] for angle in np.radians([0, 72, 144, 216, 288])]
    with pytest.raises(InputError, match="need a face that does not cross itself"):
        check_face_sides(np.column_stack([places, np.zeros(5)]), [corners])
    check_face_sides(np.column_stack([places, np.zeros(5)]), [[0, 1, 2, 3, 4], [4, 3, 2, 1, 0]])
