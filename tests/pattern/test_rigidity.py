import dataclasses
import math
from importlib import import_module

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from forficula.errors import InputError
from forficula.pattern import CreasePattern, miura_pattern, pleat_pattern, rigidity
from tests.pattern.test_crease_pattern import star


def sheet(columns, rows, fold=0.0):
    return miura_pattern(columns, rows, 0.03, 0.02, math.radians(60), fold)


def counts(mobility):
    return mobility.mechanisms, mobility.self_stress


def with_letter(pattern, edge, letter):
    letters = list(pattern.edges_assignment)
    letters[edge] = letter
    return dataclasses.replace(pattern, edges_assignment=tuple(letters))


def test_a_hinge_of_two_panels_has_one_freedom_and_no_self_stress():
    assert counts(rigidity(pleat_pattern([0.1, 0.1], 0.2, "V"))) == (1, 0)


def test_a_flat_crease_makes_one_plate_that_moves_where_facets_bend():
    strip = with_letter(pleat_pattern([0.1, 0.1, 0.1], 0.2, "VV"), 0, "F")
    assert counts(rigidity(strip)) == (1, 0)
    # two creases and three diagonals
    assert counts(rigidity(strip, bending=True)) == (5, 0)


def test_a_cut_leaves_two_pieces_that_move_independently():
    parts = rigidity(with_letter(pleat_pattern([0.1, 0.1, 0.1], 0.2, "VV"), 0, "C"))
    assert (parts.parts, *counts(parts)) == (2, 1, 0)


def test_a_triangle_alone_is_rigid():
    assert counts(rigidity(star([0, 120, 240], "FFF"))) == (0, 0)


def test_a_flat_vertex_has_a_freedom_more_than_a_folded_one_and_can_be_stressed():
    flat = star([0, 60, 150, 260], "UUUU")
    raised = flat.vertices_coords.copy()
    raised[0, 2] = 0.03
    assert counts(rigidity(flat)) == (2, 1)
    assert counts(rigidity(flat, raised)) == (1, 0)


def test_a_closed_tetrahedron_is_rigid():
    coords = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
    closed = CreasePattern(
        vertices_coords=coords,
        edges_vertices=np.array([[0, 1], [0, 2], [0, 3], [1, 2], [2, 3], [3, 1]]),
        edges_assignment=("U",) * 6,
        edges_fold_angle=np.full(6, np.nan),
        faces_vertices=((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)),
    )
    assert counts(rigidity(closed)) == (0, 0)


@settings(max_examples=20, deadline=None)
@given(st.integers(0, 2**32 - 1), st.floats(1e-3, 1e3), st.sampled_from([0.0, 0.7]))
def test_turning_and_scaling_a_sheet_changes_no_count(seed, scale, fold):
    pattern = sheet(3, 3, fold)
    turn = Rotation.random(rng=np.random.default_rng(seed)).as_matrix()
    moved = scale * pattern.vertices_coords @ turn.T + 5.0 * scale
    for bending in (False, True):
        assert rigidity(pattern, moved, bending=bending) == rigidity(pattern, bending=bending)


@pytest.mark.parametrize("fold", [0.0, 0.3, 1.0])
@pytest.mark.parametrize("bending", [False, True])
def test_counting_pivots_and_singular_values_gives_the_same_rank(monkeypatch, fold, bending):
    pattern = sheet(6, 5, fold)
    dense = rigidity(pattern, bending=bending)
    # the package calls the function by the name of its module
    monkeypatch.setattr(import_module("forficula.pattern.facts.rigidity"), "_MOST_DENSE", 0)
    assert rigidity(pattern, bending=bending) == dense
    assert dense.clear


def test_rank_survives_the_seven_digits_of_a_file():
    folded = sheet(4, 4, 0.7)
    assert counts(rigidity(folded, np.round(folded.vertices_coords, 8))) == (1, 4)


def test_positions_of_another_number_are_refused():
    with pytest.raises(InputError, match=r"coords: need shape \(4, 3\), got \(3, 3\)"):
        rigidity(star([0, 120, 240], "MMM"), np.zeros((3, 3)))
