"""Degrees of freedom and self-stresses agree with independent counts.

The rigidity matrix is computed from bars and panels. It is compared with counts from the closure of vertices, from
Euler's formula, and from independent code.
"""

import math

import numpy as np
import pytest

from forficula.pattern import folded_as_assigned, miura_pattern, pattern_facts, rigidity, vertex_creases, vertex_walk


def sheet(columns, rows, fold=0.0):
    return miura_pattern(columns, rows, 0.03, 0.02, math.radians(60), fold)


def creases_of(pattern):
    return sum(letter in "MV" for letter in pattern.edges_assignment)


@pytest.mark.parametrize(("size", "flat"), [(4, 6), (8, 14)])
def test_miura_sheets_have_the_number_of_mechanisms_of_independent_code(agree, size, flat):
    """Independent code found 6 and 14 in flat sheets of 4 x 4 and 8 x 8 panels, and 1 in a folded sheet."""
    facts = pattern_facts(sheet(size, size))
    result = (facts.freedoms.rigid.mechanisms, facts.freedoms.folded.mechanisms)
    agree(f"mechanisms of {size} x {size} panels, flat and folded", result, (flat, 1), by="another code")
    assert rigidity(sheet(size, size, 0.5)).mechanisms == 1


@pytest.mark.parametrize(("columns", "rows"), [(2, 2), (3, 5), (7, 4)])
def test_each_vertex_of_a_flat_sheet_removes_two_degrees_of_freedom_and_adds_one_self_stress(agree, columns, rows):
    """Fold rates as vectors along creases sum to 0 in the plane: two of three equations (Belcastro, Hull 2002)."""
    result, inside = rigidity(sheet(columns, rows)), (columns - 1) * (rows - 1)
    known = (creases_of(sheet(columns, rows)) - 2 * inside, inside)
    what = f"mechanisms and self-stresses of {columns} x {rows} flat panels"
    agree(what, (result.mechanisms, result.self_stress), known, by="Belcastro and Hull 2002")


@pytest.mark.parametrize(("columns", "rows"), [(2, 3), (5, 4)])
def test_a_folded_sheet_has_the_degrees_of_freedom_of_the_loops_around_its_vertices(agree, columns, rows):
    """Mechanisms: creases minus the rank of the loops' derivatives; self-stresses: 3 per vertex minus it."""
    pattern = sheet(columns, rows)
    angles = folded_as_assigned(pattern)
    around = vertex_creases(pattern)
    slope = np.zeros((3 * len(around), len(angles)))
    for number, item in enumerate(around):
        slope[3 * number : 3 * number + 3, item.edges] = vertex_walk(item.sectors, angles[item.edges])[1].T
    rank = np.linalg.matrix_rank(slope, tol=1e-9)
    result = pattern_facts(pattern).freedoms.folded
    known = (creases_of(pattern) - rank, 3 * len(around) - rank)
    what = f"mechanisms and self-stresses of {columns} x {rows} folded panels"
    agree(what, (result.mechanisms, result.self_stress), known, by="walks around vertices, Tachi 2009")


@pytest.mark.parametrize(("columns", "rows"), [(2, 2), (4, 4), (5, 3)])
def test_a_folded_sheet_with_bending_facets_has_three_degrees_of_freedom_fewer_than_border_edges(agree, columns, rows):
    """A triangulated disc with B border edges has 3 V - 6 - E = B - 3 by Euler's formula."""
    result = rigidity(sheet(columns, rows, 0.6), bending=True)
    known = (2 * (columns + rows) - 3, 0)
    what = f"mechanisms and self-stresses of {columns} x {rows} panels that bend"
    agree(what, (result.mechanisms, result.self_stress), known, by="Euler's formula")
