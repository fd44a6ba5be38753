"""Sheets opened along their cuts."""

import dataclasses

import numpy as np

from forficula.pattern import CreasePattern, miura_pattern, pleat_pattern
from forficula.pattern.cut_open import cut_open
from forficula.pattern.shared_edges import shared_edges


def with_letter(pattern, edge, letter):
    letters = list(pattern.edges_assignment)
    letters[edge] = letter
    angles = pattern.edges_fold_angle.copy()
    angles[edge] = np.nan
    return dataclasses.replace(pattern, edges_assignment=tuple(letters), edges_fold_angle=angles)


def test_a_sheet_without_cuts_is_unchanged():
    sheet = miura_pattern(2, 2, 0.02, 0.02, 1.0)
    opened = cut_open(sheet)
    assert opened.pattern is sheet
    assert opened.vertices.tolist() == list(range(9))


def test_a_cut_from_border_to_border_parts_the_sheet():
    sheet = with_letter(pleat_pattern([0.1, 0.1, 0.1], 0.2, "MV"), 0, "C")
    opened = cut_open(sheet)
    # both ends of the cut are duplicated at the same position
    assert len(opened.pattern.vertices_coords) == len(sheet.vertices_coords) + 2
    assert opened.vertices[-2:].tolist() == [1, 5]
    assert opened.pattern.vertices_coords.tolist() == sheet.vertices_coords[opened.vertices].tolist()
    assert not set(opened.pattern.faces_vertices[0]) & set(opened.pattern.faces_vertices[1])
    # and so is its edge; the other numbers are unchanged
    assert opened.pattern.edges_assignment == (*sheet.edges_assignment, "C")
    assert [edge.edge for edge in shared_edges(opened.pattern)] == [1]


def test_a_cut_that_ends_inside_opens_at_the_border_only():
    """Two by two squares, the crease from the middle of one side to the centre cut."""
    coords = [(x, y, 0.0) for y in (0, 1, 2) for x in (0, 1, 2)]
    faces = ((0, 1, 4, 3), (1, 2, 5, 4), (3, 4, 7, 6), (4, 5, 8, 7))
    inside = [(1, 4), (3, 4), (4, 5), (4, 7)]
    border = [(0, 1), (1, 2), (2, 5), (5, 8), (8, 7), (7, 6), (6, 3), (3, 0)]
    sheet = CreasePattern(
        vertices_coords=np.array(coords),
        edges_vertices=np.array([*inside, *border]),
        edges_assignment=("C", "M", "V", "M", *"B" * 8),
        edges_fold_angle=np.full(12, np.nan),
        faces_vertices=faces,
    )
    opened = cut_open(sheet)
    assert opened.vertices.tolist() == [*range(9), 1]
    assert opened.pattern.faces_vertices == ((0, 1, 4, 3), (9, 2, 5, 4), (3, 4, 7, 6), (4, 5, 8, 7))
    assert opened.pattern.edges_vertices[-1].tolist() == [9, 4]
    assert sorted(edge.edge for edge in shared_edges(opened.pattern)) == [1, 2, 3]


def test_a_cut_that_reaches_no_border_stays_closed():
    sheet = miura_pattern(3, 3, 0.02, 0.02, 1.0)
    inside = next(edge for edge, ends in enumerate(sheet.edges_vertices.tolist()) if set(ends) == {5, 9})
    opened = cut_open(with_letter(sheet, inside, "C"))
    assert len(opened.pattern.vertices_coords) == 16
    assert opened.pattern.faces_vertices == sheet.faces_vertices
