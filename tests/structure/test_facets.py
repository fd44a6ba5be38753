"""Facets between points: their triangles, the lines that fold between them, and the held corners."""

import numpy as np
import pytest

from forficula.design import load_design
from forficula.structure import built_points, facet_triangles, held_corners, hinge_groups, structure_of

LOOSE = {"support": [], "drive": [], "measure": [], "protocol.stages": []}


@pytest.mark.parametrize("name", ["miura-sheet", "waterbomb-base", "kresling-cell"])
def test_the_triangles_of_a_facet_cover_it_with_the_same_orientation(name):
    structure = structure_of(load_design(name))
    triangles, numbers = facet_triangles(structure)
    points = built_points(structure)
    one, two, three = points[triangles].transpose(1, 0, 2)
    halves = np.cross(two - one, three - one) / 2
    for number, facet in enumerate(structure.facets):
        corners = points[list(facet.points)]
        # the area vector of a polygon, by the formula of the shoelace
        whole = np.cross(corners, np.roll(corners, -1, axis=0)).sum(axis=0) / 2
        assert halves[numbers == number].sum(axis=0) == pytest.approx(whole, abs=1e-12)


def test_a_bending_line_inside_a_facet_is_not_a_crease():
    structure = structure_of(load_design("miura-sheet"))
    groups = hinge_groups(structure)
    assert {kind: len(hinges) for kind, hinges in groups.items()} == {"creases": 24, "facet bends": 16}
    assert {structure.hinges[hinge].assignment for hinge in groups["creases"]} == {"M", "V"}
    fan = structure_of(load_design("binder2025"))
    assert hinge_groups(fan) == {"hinges": tuple(range(len(fan.hinges)))}


def test_corners_with_constrained_directions_count_as_held():
    structure = structure_of(load_design("miura-sheet"))
    assert {structure.points[point].name for point in held_corners(structure)} == {
        f"vertex{number}" for number in load_design("miura-sheet").sheet.faces_vertices[5]
    }
    axes = load_design("miura-sheet", {"support": [{"of": "vertex 3", "axes": "z"}]})
    assert [structure_of(axes).points[point].name for point in held_corners(structure_of(axes))] == ["vertex3"]
    assert held_corners(structure_of(load_design("letter-fold"))) == ()
