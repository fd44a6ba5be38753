import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from forficula.errors import InputError
from forficula.pattern import (
    CreasePattern,
    EarwigFan,
    degree4_fold_angles,
    earwig_pattern,
    fan_fold_angles,
    folded_coordinates,
)
from tests.pattern.closing import closure_residual, opposite_fold_angle

SECTORS = st.floats(0.01, math.pi - 0.01)
FOLDS = st.one_of(st.sampled_from([-math.pi, 0.0, math.pi]), st.floats(-math.pi, math.pi))
MODES = st.sampled_from(["earwig", "miura"])
REFERENCE = EarwigFan(
    proximal_length=0.12, distal_length=0.10, hub_radius=0.015, sector_angle=math.radians(20), units=2
)


@given(SECTORS, SECTORS, FOLDS, MODES)
def test_the_closed_form_closes_the_vertex_in_both_modes_and_orientations(alpha, beta, proximal, mode):
    next_first = degree4_fold_angles(alpha, beta, proximal, mode)
    assert closure_residual([alpha, math.pi - beta, math.pi - alpha, beta], next_first) < 1e-12
    previous_first = next_first[[0, 3, 2, 1]]
    assert closure_residual([beta, math.pi - alpha, math.pi - beta, alpha], previous_first) < 1e-12


@pytest.mark.parametrize("mode", ["earwig", "miura"])
def test_a_vertex_with_the_ring_sign_reversed_does_not_close(mode):
    folds = degree4_fold_angles(1.3, 1.1, 1.0, mode) * [1, -1, 1, -1]
    assert closure_residual([1.3, math.pi - 1.1, math.pi - 1.3, 1.1], folds) > 0.01


def test_at_half_a_turn_every_crease_is_folded_flat():
    for mode, signs in (("earwig", [1, 1, 1, -1]), ("miura", [1, -1, -1, -1])):
        folds = degree4_fold_angles(1.3, 1.1, [-math.pi, math.pi], mode)
        assert folds[:, 1].tolist() == [sign * math.pi for sign in signs]
        assert folds[:, 0].tolist() == (-folds[:, 1]).tolist()


def test_equal_sectors_leave_the_ring_flat_in_mode_earwig():
    folds = degree4_fold_angles(1.2, 1.2, np.linspace(-math.pi, math.pi, 9))
    assert not folds[[1, 3]].any()


def test_fold_angles_keep_the_shape_of_the_input():
    assert degree4_fold_angles(1.3, 1.1, np.zeros((2, 5))).shape == (4, 2, 5)


def test_the_ratio_of_the_half_tangents_is_that_of_the_fan():
    epsilon, theta = REFERENCE.epsilon, REFERENCE.sector_angle
    square = math.pi / 2 - theta / 2
    folds = degree4_fold_angles(square + epsilon, square - epsilon, 2.0)
    assert math.tan(folds[1] / 2) / math.tan(1.0) == pytest.approx(math.sin(epsilon) / math.cos(theta / 2))


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        ((0.0, 1.0, 0.0, "earwig"), "alpha: need > 0 deg and < 180 deg, got 0 deg"),
        ((1.0, math.pi, 0.0, "earwig"), "beta: need > 0 deg and < 180 deg, got 180 deg"),
        ((1.0, 1.0, 2 * math.pi, "earwig"), "proximal_fold_angle: need -180 to 180 deg, got 360 deg"),
        ((1.0, 1.0, math.nan, "earwig"), "proximal_fold_angle: need -180 to 180 deg, got nan deg"),
        ((1.0, 1.0, 0.0, "moth"), "mode: need earwig or miura, got 'moth'"),
    ],
)
def test_an_invalid_vertex_is_refused(arguments, message):
    with pytest.raises(InputError, match=message):
        degree4_fold_angles(*arguments)


def test_four_equal_plates_with_a_deficit_close_at_the_published_fold():
    """Mid-wing plates of the earwig at 350 deg, Faber et al. 2018: cos(sum / 4) = cot^2((180 deg - rho) / 2)."""
    sector = math.radians(350) / 4
    fold = math.pi - 2 * math.atan(1 / math.sqrt(math.cos(sector)))
    assert math.degrees(fold) == pytest.approx(23.6, abs=0.05)
    assert closure_residual([sector] * 4, [fold] * 4) < 1e-12
    assert opposite_fold_angle([sector] * 4, fold) == pytest.approx(fold)


def test_closure_refuses_rows_that_do_not_match():
    with pytest.raises(InputError, match="need one for each sector angle"):
        closure_residual([1, 2, 3], [1, 2])
    with pytest.raises(InputError, match="need finite angles"):
        closure_residual([1.0, math.nan], [1.0, 2.0])


def angle_between(first, second):
    return math.atan2(np.linalg.norm(np.cross(first, second)), first @ second)


def fold_at(crease, before, after):
    """Size of the fold angle from the dihedral angle between two panels."""
    inwards = np.cross(crease, before), np.cross(crease, after)
    return math.pi - angle_between(*inwards)


@given(st.lists(st.floats(-0.6, 0.6), min_size=4, max_size=4))
def test_opposite_folds_agree_with_a_vertex_measured_in_space(heights):
    azimuths = np.radians([0, 80, 190, 280])
    creases = np.column_stack([np.cos(azimuths), np.sin(azimuths), heights])
    creases /= np.linalg.norm(creases, axis=1)[:, None]
    sectors = [angle_between(creases[i], creases[(i + 1) % 4]) for i in range(4)]
    folds = [fold_at(creases[i], creases[i - 1], creases[(i + 1) % 4]) for i in range(4)]
    # a nearly flat vertex turns an error e of a cosine into an angle of sqrt(e)
    assert opposite_fold_angle(sectors, folds[0]) == pytest.approx(folds[2], abs=1e-6)
    assert opposite_fold_angle(sectors[1:] + sectors[:1], folds[1]) == pytest.approx(folds[3], abs=1e-6)


@given(SECTORS, SECTORS, FOLDS, MODES)
def test_opposite_folds_of_a_flat_foldable_vertex_are_equal(alpha, beta, proximal, mode):
    folds = np.abs(degree4_fold_angles(alpha, beta, proximal, mode))
    sectors = [alpha, math.pi - beta, math.pi - alpha, beta]
    # rounding of the sectors, 1e-16, under a square root and divided by sin^2(0.01)
    assert opposite_fold_angle(sectors, float(folds[0])) == pytest.approx(folds[2], abs=1e-5)


def test_a_fold_that_the_sectors_do_not_allow_is_refused():
    with pytest.raises(InputError, match="fold_angle: need an angle that sectors of 120, 30, 30, 120 deg allow"):
        opposite_fold_angle(np.radians([120, 30, 30, 120]), 0.0)
    with pytest.raises(InputError, match="sector_angles: need four"):
        opposite_fold_angle([1, 2, 3], 0.1)
    with pytest.raises(InputError, match="sector_angles: need > 0 deg"):
        opposite_fold_angle([0, 2, 2, 2], 0.1)


def hinge(letter="V"):
    """Two unit squares that share the edge x = 1, the second beyond it."""
    return CreasePattern(
        vertices_coords=np.array([[0.0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [2, 0, 0], [2, 1, 0]]),
        edges_vertices=np.array([[1, 2], [0, 1], [2, 3], [3, 0], [1, 4], [4, 5], [5, 2]]),
        edges_assignment=(letter,) + ("B",) * 6,
        edges_fold_angle=np.full(7, np.nan),
        faces_vertices=((0, 1, 2, 3), (1, 4, 5, 2)),
    )


def test_a_valley_rises_towards_the_viewer():
    folds = [math.pi / 2] + [math.nan] * 6
    folded = folded_coordinates(hinge(), folds)
    assert folded[4:] == pytest.approx(np.array([[1, 0, 1], [1, 1, 1]]), abs=1e-15)
    other_way = folded_coordinates(hinge(), folds, fixed_face=1)
    assert other_way[[0, 3]] == pytest.approx(np.array([[1, 0, 1], [1, 1, 1]]), abs=1e-15)


def test_a_flat_edge_needs_no_fold_angle_and_a_valley_does():
    assert folded_coordinates(hinge("F"), [math.nan] * 7) == pytest.approx(hinge().vertices_coords)
    with pytest.raises(InputError, match=r"fold_angles\[0\]: need a finite angle between two faces, got nan"):
        folded_coordinates(hinge("V"), [math.nan] * 7)


@pytest.mark.parametrize(
    ("letter", "folds", "face", "message"),
    [
        ("C", [0.0] * 7, 0, r"faces_vertices\[1\]: need a face that is connected to face 0"),
        ("V", [0.0] * 6, 0, r"fold_angles: need shape \(7,\), got \(6,\)"),
        ("V", [0.0] * 7, 2, "fixed_face: need a face from 0 to 1, got 2"),
    ],
)
def test_what_cannot_be_folded_is_refused(letter, folds, face, message):
    with pytest.raises(InputError, match=message):
        folded_coordinates(hinge(letter), folds, face)


def test_clockwise_faces_are_refused():
    flat = hinge()
    turned = CreasePattern(
        vertices_coords=flat.vertices_coords,
        edges_vertices=flat.edges_vertices,
        edges_assignment=flat.edges_assignment,
        edges_fold_angle=flat.edges_fold_angle,
        faces_vertices=((0, 1, 2, 3), (2, 5, 4, 1)),
    )
    with pytest.raises(InputError, match=r"faces_vertices\[1\]: need faces counterclockwise"):
        folded_coordinates(turned, [0.0] * 7)


def test_a_sheet_that_would_tear_is_refused():
    folds = fan_fold_angles(REFERENCE, 1.0)
    pattern = earwig_pattern(REFERENCE)
    folds[pattern.edges_role.index("ring")] += 0.01
    with pytest.raises(InputError, match=r"need angles for which the sheet closes, .* between faces"):
        folded_coordinates(pattern, folds)


def test_fold_angles_of_the_fan_have_the_senses_of_its_pattern():
    pattern = earwig_pattern(REFERENCE)
    np.testing.assert_array_equal(fan_fold_angles(REFERENCE, math.pi), pattern.edges_fold_angle)


@pytest.mark.parametrize("pleat", [-0.1, 3.2, math.nan])
def test_a_pleat_outside_half_a_turn_is_refused(pleat):
    with pytest.raises(InputError, match="pleat_angle: need 0 to 180 deg"):
        fan_fold_angles(REFERENCE, pleat)
