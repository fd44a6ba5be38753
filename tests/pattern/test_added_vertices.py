"""Vertices added to a sheet of triangles."""

import dataclasses

import numpy as np
import pytest

from forficula.pattern import CreasePattern, pleat_pattern, triangulated
from forficula.pattern.added_vertices import with_vertices

STRIP = pleat_pattern([0.1, 0.1], 0.2, "M")


def areas(pattern):
    corners = pattern.vertices_coords[np.array(pattern.faces_vertices)]
    return np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])[:, 2] / 2


@pytest.mark.parametrize(
    ("place", "triangles", "edges"),
    [((0.02, 0.1), 2, 3), ((0.1, 0.05), 2, 3), ((0.0, 0.05), 1, 2), ((0.05, 0.1), 2, 3), ((0.0, 0.0), 0, 0)],
    ids=["inside", "crease", "border", "diagonal", "vertex"],
)
def test_triangles_around_a_place_are_split_and_no_others(place, triangles, edges):
    split = triangulated(STRIP)
    added = with_vertices(split, [(0, np.array([*place, 0.0]))])
    assert added.pattern.vertices_coords[added.vertices[0]] == pytest.approx([*place, 0.0])
    assert len(added.pattern.faces_vertices) == len(split.pattern.faces_vertices) + triangles
    assert len(added.pattern.edges_vertices) == len(split.pattern.edges_vertices) + edges
    assert (areas(added.pattern) > 0).all()
    assert areas(added.pattern).sum() == pytest.approx(0.04)
    # the area of every facet is unchanged
    assert np.bincount(added.facets, areas(added.pattern)) == pytest.approx([0.02, 0.02])


def test_both_halves_of_a_split_edge_have_its_properties():
    crease = STRIP.edges_assignment.index("M")
    added = with_vertices(triangulated(STRIP), [(0, np.array([0.1, y, 0.0])) for y in (0.05, 0.15, 0.1)])
    parts = np.flatnonzero(added.sources == crease)
    assert [added.pattern.edges_assignment[part] for part in parts] == ["M"] * 4
    assert added.pattern.edges_fold_angle[parts].tolist() == [-np.pi] * 4
    ends = added.pattern.vertices_coords[added.pattern.edges_vertices[parts]]
    assert np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1) == pytest.approx([0.05] * 4)


def test_a_point_on_a_cut_belongs_to_one_side():
    letters = tuple("C" if letter == "M" else letter for letter in STRIP.edges_assignment)
    cut = triangulated(dataclasses.replace(STRIP, edges_assignment=letters))
    added = with_vertices(cut, [(1, np.array([0.1, 0.05, 0.0]))])
    having = {
        int(facet)
        for facet, corners in zip(added.facets, added.pattern.faces_vertices, strict=True)
        if added.vertices[0] in corners
    }
    assert having == {1}
    assert isinstance(added.pattern, CreasePattern)
