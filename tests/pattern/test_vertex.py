"""One vertex with any sectors: flat, cone, saddle, or four folded facets."""

import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from forficula.errors import InputError
from forficula.pattern import (
    built_fold_angles,
    degree4_fold_angles,
    kawasaki_residuals,
    maekawa_residuals,
    vertex_pattern,
)
from tests.pattern.closing import closure_residual, opposite_fold_angle

SHARES = st.lists(st.floats(0.2, 1), min_size=3, max_size=8)


def sectors_of(pattern):
    """Angles at vertex 0 of every facet, rad."""
    apart = []
    for apex, one, other in pattern.faces_vertices:
        along = pattern.vertices_coords[[one, other]] - pattern.vertices_coords[apex]
        apart.append(math.atan2(np.linalg.norm(np.cross(*along)), along[0] @ along[1]))
    return apart


def lengths_of(pattern):
    return np.linalg.norm(pattern.vertices_coords[1:], axis=1)


def scaled(shares, degrees):
    sectors = [math.radians(degrees) * share / sum(shares) for share in shares]
    assume(max(sectors) < math.pi - 1e-3 and 2 * max(sectors) < sum(sectors) * (1 - 1e-6))
    return sectors


@settings(max_examples=100)
@given(SHARES, st.floats(20, 359.9), st.sampled_from(["", "V"]))
def test_a_cone_has_its_sectors_at_one_inclination(shares, degrees, letter):
    sectors = scaled(shares, degrees)
    lengths = [0.1 + 0.01 * k for k in range(len(sectors))]
    cone = vertex_pattern(sectors, lengths, letter * len(sectors))
    assert sectors_of(cone) == pytest.approx(sectors, abs=1e-9)
    assert lengths_of(cone) == pytest.approx(lengths, rel=1e-12)
    inclination = np.arcsin(cone.vertices_coords[1:, 2] / lengths)
    assert np.ptp(inclination) < 1e-9
    assert (inclination[0] > 0) == (letter == "V")


@settings(max_examples=100)
@given(st.lists(st.floats(0.5, 1), min_size=4, max_size=8), st.floats(360.1, 480))
def test_a_saddle_has_its_sectors_with_creases_alternately_up_and_down(shares, degrees):
    sectors = scaled(shares, degrees)
    try:
        saddle = vertex_pattern(sectors, 0.1)
    except InputError as refused:
        assert "alternately above and below the plane" in str(refused)  # noqa: PT017
        return
    assert sectors_of(saddle) == pytest.approx(sectors, abs=1e-8)
    heights = saddle.vertices_coords[1:, 2]
    even = len(sectors) - len(sectors) % 2
    assert (heights[:even:2] > 0).all()
    assert heights[:even:2] == pytest.approx(-heights[1:even:2])
    assert not heights[even:].any()


@settings(max_examples=50)
@given(SHARES, st.sampled_from([300, 359, 361, 400]))
def test_the_fold_angles_of_cones_and_saddles_close_the_vertex(shares, degrees):
    sectors = scaled(shares, degrees)
    assume(len(sectors) > 3 and max(sectors) < 2 and (degrees < 360 or min(sectors) > 0.7))
    built = vertex_pattern(sectors, 0.1)
    folds = built.edges_fold_angle[: len(sectors)]
    assert folds == pytest.approx(built_fold_angles(built)[: len(sectors)])
    assert closure_residual(sectors, folds) < 1e-7
    for letter, angle in zip(built.edges_assignment, folds.tolist(), strict=False):
        assert letter == ("F" if abs(angle) < 1e-9 else "V" if angle > 0 else "M")


def test_a_pyramid_of_four_equilateral_triangles_is_half_an_octahedron():
    pyramid = vertex_pattern([math.pi / 3] * 4, 0.1)
    assert pyramid.vertices_coords[1:, 2] == pytest.approx([-0.1 / math.sqrt(2)] * 4)
    # the dihedral angle of the octahedron is acos(-1/3)
    assert pyramid.edges_fold_angle[:4] == pytest.approx([math.acos(-1 / 3) - math.pi] * 4)
    assert pyramid.edges_assignment == ("M",) * 4 + ("B",) * 4


def test_four_plates_with_a_deficit_of_10_deg_match_the_law_of_cosines():
    """Two neighbouring creases are 90 deg apart about the axis: sin(s / 2) = cos(inclination) sin(45 deg)."""
    plates = vertex_pattern([math.radians(87.5)] * 4, 0.1)
    inclination = math.acos(math.sin(math.radians(43.75)) / math.sin(math.pi / 4))
    assert plates.vertices_coords[1:, 2] == pytest.approx([-0.1 * math.sin(inclination)] * 4, rel=1e-10)


def test_a_sector_almost_as_large_as_all_others_takes_more_than_half_a_turn():
    sectors = [math.radians(item) for item in (60, 25, 20, 20)]
    cone = vertex_pattern(sectors, 0.1)
    assert sectors_of(cone) == pytest.approx(sectors, abs=1e-12)
    azimuth = np.unwrap(np.arctan2(cone.vertices_coords[1:, 1], cone.vertices_coords[1:, 0]))
    assert azimuth[1] % (2 * math.pi) > math.pi


@settings(max_examples=50)
@given(SHARES)
def test_sectors_of_360_deg_lie_flat(shares):
    sectors = scaled(shares, 360)
    flat = vertex_pattern(sectors, 0.1, "M" * len(sectors))
    assert not flat.vertices_coords[:, 2].any()
    assert sectors_of(flat) == pytest.approx(sectors, abs=1e-12)
    assert flat.edges_fold_angle[: len(sectors)].tolist() == [-math.pi] * len(sectors)
    assert np.isnan(vertex_pattern(sectors, 0.1).edges_fold_angle).all()
    assert set(vertex_pattern(sectors, 0.1).edges_assignment) == {"U", "B"}


@settings(max_examples=60)
@given(st.floats(20, 160), st.floats(20, 160), st.floats(1, 179), st.sampled_from(["MV", "VM", "VV", "MM"]))
def test_a_flat_foldable_vertex_folds_by_its_half_tangents(alpha, beta, degrees, letters):
    """Huffman 1976, Tachi 2009, in both modes: the sense of the opposite crease chooses between them."""
    alpha, beta, fold = math.radians(alpha), math.radians(beta), math.radians(degrees)
    assume(abs(math.cos((alpha + beta) / 2)) > 0.01)
    pattern = vertex_pattern([alpha, math.pi - beta, math.pi - alpha, beta], 0.1, f"{letters[0]}U{letters[1]}U", fold)
    assert sectors_of(pattern) == pytest.approx([alpha, math.pi - beta, math.pi - alpha, beta], abs=1e-9)
    signed = fold if letters[0] == "V" else -fold
    mode = "earwig" if letters[0] == letters[1] else "miura"
    expected = degree4_fold_angles(alpha, beta, signed, mode)
    assert built_fold_angles(pattern)[:4] == pytest.approx(expected, abs=1e-6)
    assert kawasaki_residuals(vertex_pattern(sectors_of(pattern), 0.1))[0] == pytest.approx(0, abs=1e-9)


@settings(max_examples=80)
@given(
    st.lists(st.floats(30, 150), min_size=4, max_size=4), st.floats(0, 179), st.sampled_from(["MV", "VM", "VV", "MM"])
)
def test_four_facets_of_any_sectors_fold_by_the_law_of_cosines(degrees, fold, letters):
    sectors, fold = [math.radians(degree) for degree in degrees], math.radians(fold)
    assume(2 * max(sectors) < sum(sectors) and abs(sum(sectors) - 2 * math.pi) > 1e-3)
    try:
        pattern = vertex_pattern(sectors, 0.1, f"{letters[0]}F{letters[1]}F", fold)
    except InputError as refused:
        assert "for the facets to meet" in str(refused) or "lie on one line" in str(refused)  # noqa: PT017
        with pytest.raises(InputError):
            opposite_fold_angle(sectors, fold)
        return
    folds = built_fold_angles(pattern)[:4]
    assert sectors_of(pattern) == pytest.approx(sectors, abs=1e-8)
    assert abs(folds[0]) == pytest.approx(fold, abs=1e-7)
    assert abs(folds[2]) == pytest.approx(opposite_fold_angle(sectors, fold), abs=1e-5)
    assert closure_residual(sectors, folds) < 1e-6
    for crease, letter in ((0, letters[0]), (2, letters[1])):
        assert abs(folds[crease]) < 1e-6 or (folds[crease] > 0) == (letter == "V")


def test_a_fold_that_no_facets_allow_is_answered_with_those_that_they_do():
    sectors = [math.radians(item) for item in (80, 120, 60, 60)]
    # creases 1 and 3 are at least 60 deg apart: cos 60 = cos 80 cos 60 - sin 80 sin 60 cos(fold)
    most = math.degrees(math.acos((math.cos(sectors[0]) - 1) / 2 / math.sin(sectors[0]) / math.sin(sectors[3])))
    with pytest.raises(InputError, match=f"pattern.fold: need 0 deg to {most:.6g} deg for the facets to meet, got 175"):
        vertex_pattern(sectors, 0.1, "MVMM", math.radians(175))


def test_assigned_letters_set_the_target_fold_angles():
    plates = vertex_pattern([math.radians(87.5)] * 4, 0.1, "VVMF")
    assert plates.edges_fold_angle[:4] == pytest.approx([math.pi, math.pi, -math.pi, 0])
    assert plates.edges_assignment[:4] == ("V", "V", "M", "F")
    assert plates.vertices_coords[1, 2] > 0  # more valleys than mountains: the vertex lies below its rim
    flat = vertex_pattern([math.pi / 2] * 4, 0.1, "VVVM")
    assert maekawa_residuals(flat).tolist() == [0]


QUARTER = math.pi / 2


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (([2.0, 2.0], 0.1), "pattern.sectors: need 3 or more, got 2"),
        (([QUARTER, QUARTER, -1.0], 0.1), "pattern.sectors.2: need > 0 deg and < 180 deg, got -57.2958 deg"),
        (
            ([2.5, 1.0, 1.0], 0.1),
            "pattern.sectors: need none as large as all others together, 114.592 deg, got",
        ),
        (([3.0, 3.0, 3.0], 0.1), "pattern.sectors: need sectors that close with creases alternately above and below"),
        (([QUARTER] * 4, [0.1] * 3), "pattern.lengths: need one for each of the 4 creases, got 3"),
        (([QUARTER] * 4, [0.1, 0.1, 0, 0.1]), "pattern.lengths.2: need > 0 and finite, got 0 cm"),
        (
            ([QUARTER] * 4, 0.1, "MV"),
            'pattern.assignment: need "M", "V", "F" or "U" for each of the 4 creases, got',
        ),
        (([QUARTER] * 4, 0.1, "MVMB"), 'pattern.assignment: need "M", "V", "F" or "U" for each of the 4 creases'),
        (([1.5] * 4, 0.1, "MVMV", math.pi), "pattern.fold: need >= 0 deg and < 180 deg, got 180 deg"),
        (([1.2] * 5, 0.1, "MVMVM", 1.0), "pattern.fold: need four creases to fold by one angle, got 5"),
        (([1.5] * 4, 0.1, "", 1.0), 'pattern.assignment: need "M" or "V" at creases 0 and 2'),
        (([QUARTER, 1.5, 1.5, QUARTER], 0.1, "MVMV", 0.0), "pattern.fold: need a fold at which creases 1 and 3"),
    ],
)
def test_a_vertex_that_cannot_be_drawn_is_refused(arguments, message):
    with pytest.raises(InputError) as caught:
        vertex_pattern(*arguments)
    assert str(caught.value).startswith(message)
