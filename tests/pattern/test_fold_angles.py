"""Fold angles computed from the positions of the vertices."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.pattern import (
    CreasePattern,
    EarwigFan,
    built_fold_angles,
    earwig_pattern,
    fan_fold_angles,
    folded_coordinates,
    pleat_pattern,
    triangulated,
    with_built_fold_angles,
)

FAN = EarwigFan(proximal_length=0.12, distal_length=0.1, hub_radius=0.015, sector_angle=0.3, units=2)


@settings(max_examples=50)
@given(st.lists(st.floats(-math.pi, math.pi), min_size=3, max_size=3))
def test_fold_angles_of_a_folded_strip_are_recovered(angles):
    strip = pleat_pattern([0.1, 0.2, 0.1, 0.3], 0.05, "".join("V" if angle >= 0 else "M" for angle in angles))
    given_angles = np.array([*angles, *[math.nan] * (len(strip.edges_vertices) - 3)])
    folded = replace(strip, vertices_coords=folded_coordinates(strip, given_angles))
    # 1e-9 rad: rounding of coordinates of the size of the strip over its shortest panel
    assert built_fold_angles(folded) == pytest.approx(given_angles, abs=1e-12, nan_ok=True)


@pytest.mark.parametrize("degrees", [0, 30, 120, 179, 180])
def test_a_folded_fan_is_folded_by_its_closed_form(degrees):
    pattern = earwig_pattern(FAN)
    angles = fan_fold_angles(FAN, math.radians(degrees))
    folded = replace(pattern, vertices_coords=folded_coordinates(pattern, angles))
    assert built_fold_angles(folded) == pytest.approx(angles, abs=1e-12, nan_ok=True)


def test_a_flat_sheet_is_not_folded_at_all():
    folds = built_fold_angles(earwig_pattern(FAN))
    assert np.isnan(folds).tolist() == [letter == "B" for letter in earwig_pattern(FAN).edges_assignment]
    assert not np.nan_to_num(folds).any()


def test_turning_a_sheet_changes_no_fold_angle():
    pattern = earwig_pattern(FAN)
    angles = fan_fold_angles(FAN, 1.0)
    turn, _ = np.linalg.qr(np.random.default_rng(3).normal(size=(3, 3)))
    turn *= np.linalg.det(turn)
    folded = replace(pattern, vertices_coords=folded_coordinates(pattern, angles) @ turn.T + 0.3)
    assert built_fold_angles(folded) == pytest.approx(angles, abs=1e-12, nan_ok=True)


def warped():
    """Two square facets side by side; one corner of the right one is lifted off."""
    return CreasePattern(
        vertices_coords=np.array([(-1, 0, 0), (0, 0, 0), (1, 0, 0), (1, 1, 0.5), (0, 1, 0), (-1, 1, 0)], dtype=float),
        edges_vertices=np.array([(1, 4), (0, 1), (1, 2), (2, 3), (3, 4), (4, 5), (5, 0)]),
        edges_assignment=("U", *"B" * 6),
        edges_fold_angle=np.full(7, np.nan),
        faces_vertices=((0, 1, 4, 5), (1, 2, 3, 4)),
    )


def test_beside_a_warped_facet_the_triangle_at_the_edge_counts():
    """The shorter diagonal, 2 to 4, leaves the triangle 1, 2, 4 at the edge, which lies flat."""
    assert built_fold_angles(warped())[0] == 0
    folds = built_fold_angles(triangulated(warped()).pattern)
    assert folds[0] == 0
    # the lifted corner is 0.5 high and sqrt(1/2) from the diagonal
    assert np.nanmax(folds) == pytest.approx(math.atan(0.5 / math.sqrt(0.5)))


def test_a_cut_has_no_fold_angle():
    assert np.isnan(built_fold_angles(replace(warped(), edges_assignment=("C", *"B" * 6)))).all()


@pytest.mark.parametrize(("angle", "letter"), [(0.5, "V"), (-0.5, "M"), (0.0, "F")])
def test_an_unassigned_crease_gets_the_letter_of_its_fold_angle_as_built(angle, letter):
    strip = pleat_pattern([0.1, 0.1], 0.1, "V")
    angles = np.array([angle, *[math.nan] * 6])
    folded = replace(
        strip, vertices_coords=folded_coordinates(strip, angles), edges_assignment=("U", *strip.edges_assignment[1:])
    )
    kept = with_built_fold_angles(folded)
    assert kept.edges_assignment == (letter, *"B" * 6)
    assert kept.edges_fold_angle == pytest.approx(angles, abs=1e-15, nan_ok=True)
