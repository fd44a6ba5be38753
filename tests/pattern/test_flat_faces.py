import pytest

from forficula.errors import InputError
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
            r"edges_vertices\[5\]: need edges that go on to the next, got one that ends freely at vertex 4; lead it on",
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
            r"vertices_coords\[4\]: need every vertex of a flat sheet at a place of its own, got that of vertex 1",
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
            r"faces_vertices\[0\]: need faces side by side, got vertex 4, of a part that does not hang together",
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
