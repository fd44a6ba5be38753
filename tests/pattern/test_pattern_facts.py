import dataclasses
import math

import numpy as np
import pytest

from forficula.pattern import (
    CreasePattern,
    kresling_pattern,
    miura_pattern,
    pattern_facts,
    pleat_pattern,
    yoshimura_tube,
)
from tests.pattern.test_crease_pattern import star


def sheet(columns=4, rows=4, fold=0.0):
    return miura_pattern(columns, rows, 0.03, 0.02, math.radians(60), fold)


def test_a_sheet_is_counted():
    facts = pattern_facts(sheet())
    assert (facts.vertices, facts.facets, facts.parts, facts.holes) == (25, 16, 1, 0)
    assert sum(facts.edges.values()) == 40
    assert list(facts.edges) == ["B", "M", "V"]
    assert len(facts.inside) == 9
    assert facts.flat
    assert "closes a loop" in facts.loop
    assert facts.freedoms.begins
    assert all(item.folds and item.developable for item in facts.inside)


def test_a_strip_is_a_tree_of_facets():
    facts = pattern_facts(pleat_pattern([0.1] * 4, 0.2, "VMV"))
    assert facts.loop == ""
    assert facts.freedoms.folded.mechanisms == 3


def test_a_folded_sheet_is_counted_in_its_shape_and_not_folded_again():
    facts = pattern_facts(sheet(fold=0.5))
    assert not facts.flat
    assert (facts.freedoms.begins, facts.freedoms.folded, facts.freedoms.fold_range) == (None, None, None)
    assert facts.freedoms.rigid.mechanisms == 1


@pytest.mark.parametrize(
    ("pattern", "holes"),
    [
        (kresling_pattern(6, 1, 0.05, 0.04, math.radians(30)), 1),
        (kresling_pattern(6, 2, 0.05, 0.04, math.radians(30), end_plates=True), 0),
        (yoshimura_tube(6, 4, 0.04, 0.015), 1),
        (dataclasses.replace(sheet(), faces_vertices=sheet().faces_vertices[:5] + sheet().faces_vertices[6:]), 1),
        (dataclasses.replace(sheet(), faces_vertices=sheet().faces_vertices[1:]), 0),
    ],
)
def test_holes_are_borders_beyond_the_first(pattern, holes):
    assert pattern_facts(pattern).holes == holes


def test_cuts_divide_a_sheet_into_pieces():
    strip = pleat_pattern([0.1] * 3, 0.2, "VV")
    cut = dataclasses.replace(strip, edges_assignment=("C", *strip.edges_assignment[1:]))
    facts = pattern_facts(cut)
    assert (facts.parts, facts.holes, facts.freedoms.rigid.parts) == (2, 0, 2)


def test_a_sheet_that_cannot_begin_to_fold_is_not_looked_for_folded():
    facts = pattern_facts(star([0, 60, 180, 240], "MMMV"))
    assert facts.freedoms.begins is False
    assert facts.freedoms.folded is None
    assert [item.folds for item in facts.inside] == [False]


def test_faces_of_both_orientations_are_not_counted_and_the_reason_is_given():
    coords = np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 1], [0, 1, 0]])
    facts = pattern_facts(
        CreasePattern(
            vertices_coords=coords,
            edges_vertices=np.array([[0, 1], [1, 2], [2, 3], [3, 0], [0, 2]]),
            edges_assignment=("B", "B", "B", "B", "M"),
            edges_fold_angle=np.full(5, np.nan),
            faces_vertices=((0, 1, 2), (0, 3, 2)),
        )
    )
    assert facts.freedoms is None
    assert "need faces counterclockwise" in facts.not_counted
