import dataclasses
import itertools
import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from forficula.errors import InputError
from forficula.pattern import (
    EarwigFan,
    begins_as_assigned,
    degree4_closure,
    earwig_pattern,
    folded_as_assigned,
    folded_coordinates,
    miura_pattern,
    pleat_pattern,
    vertex_creases,
    vertex_folds,
    waterbomb_pattern,
)
from tests.pattern.test_crease_pattern import star

FAN = EarwigFan(proximal_length=0.12, distal_length=0.1, hub_radius=0.015, sector_angle=math.radians(20), units=2)


def folds(directions, letters):
    pattern = star(directions, letters)
    (around,) = vertex_creases(pattern)
    return vertex_folds(pattern, around)


@settings(max_examples=50, deadline=None)
@given(st.lists(st.floats(20, 100), min_size=4, max_size=4))
def test_a_vertex_of_four_creases_leaves_the_flat_state_in_the_two_ways_of_its_linkage(shares):
    sectors = np.array(shares) * 2 * math.pi / sum(shares)
    assume(sectors.max() < math.pi - 1e-3)
    directions = np.degrees(np.concatenate([[0.0], np.cumsum(sectors[:-1])])).tolist()
    possible = {letters for letters in map("".join, itertools.product("MV", repeat=4)) if folds(directions, letters)}
    # straight creases fold alone, which combines both solutions
    assume(min(abs(sectors[0] + sectors[1] - math.pi), abs(sectors[1] + sectors[2] - math.pi)) > 1e-2)
    assert len(possible) == 4
    for way in (*degree4_closure(sectors, 1e-4), *degree4_closure(sectors, -1e-4)):
        if np.abs(way).min() > 1e-6 and np.abs(way).max() < 0.05:
            assert "".join("V" if angle > 0 else "M" for angle in way) in possible


def force_area(rates, directions):
    """Second order of the closure of a flat vertex: the area that the fold rates along their creases enclose."""
    ends = np.cumsum(rates[:, None] * np.column_stack([np.cos(directions), np.sin(directions)]), axis=0)
    return float(np.sum(ends[:-1, 0] * ends[1:, 1] - ends[:-1, 1] * ends[1:, 0]))


@settings(max_examples=25, deadline=None)
@given(st.integers(5, 6), st.integers(0, 2**32 - 1))
def test_a_vertex_of_more_creases_folds_where_rates_exist_to_the_second_order(degree, seed):
    """Rates that close at first order are a cone whose edges are three creases each; the area needs both signs."""
    draw = np.random.default_rng(seed)
    directions, signs = np.sort(draw.uniform(0, 2 * math.pi, degree)), draw.choice([-1, 1], degree)
    # a star has no facet beyond 180 deg
    assume(np.diff([*directions, directions[0] + 2 * math.pi]).max() < math.pi - 1e-3)
    rays = []
    for chosen in map(list, itertools.combinations(range(degree), 3)):
        forces = signs[chosen] * np.stack([np.cos(directions[chosen]), np.sin(directions[chosen])])
        sizes = np.linalg.svd(forces)[2][-1]
        if (sizes > 0).all() or (sizes < 0).all():
            rays.append(np.zeros(degree))
            rays[-1][chosen] = signs[chosen] * np.abs(sizes)
    all_fold = bool(rays) and bool((np.abs(rays).sum(axis=0) > 0).all())
    areas = (
        [force_area(mix @ np.array(rays), directions) for mix in draw.dirichlet([0.2] * len(rays), 500)] if rays else []
    )
    letters = "".join("V" if sign > 0 else "M" for sign in signs)
    assert folds(np.degrees(directions).tolist(), letters) == (all_fold and min(areas) < 0 < max(areas))


@pytest.mark.parametrize(
    ("directions", "letters", "expected"),
    [
        ([0, 60, 120, 180, 240, 300], "MVMVMV", True),
        ([0, 60, 120, 180, 240, 300], "MMMMMM", False),
        ([0, 120, 240], "MMM", False),
        ([0, 90, 180, 270], "MFMF", True),
        ([0, 90, 180, 270], "MFVF", False),
        ([0, 90, 180, 270], "UFMF", None),
        ([0, 90, 170, 270], "MFMF", False),
        ([0, 90, 180, 270], "UUUU", None),
        ([0, 30, 60, 90], "UUUU", False),
        ([0, 90, 180, 270], "FFFF", True),
    ],
)
def test_the_condition_at_a_vertex_needs_no_folded_state(directions, letters, expected):
    assert folds(directions, letters) is expected


@pytest.mark.parametrize(
    "pattern",
    [
        miura_pattern(4, 3, 0.03, 0.02, math.radians(60)),
        waterbomb_pattern(2, 2, 0.04),
        earwig_pattern(FAN),
        pleat_pattern([0.1, 0.1, 0.1], 0.2, "VM"),
        star([0, 60, 120, 180, 240, 300], "MVMVMV"),
    ],
)
def test_sheets_of_rigid_facets_are_found_folded_in_their_sense(pattern):
    angles = folded_as_assigned(pattern)
    assert begins_as_assigned(pattern)
    for letter, angle in zip(pattern.edges_assignment, angles, strict=True):
        sign = {"V": 1, "M": -1}.get(letter, 0)
        assert sign * angle >= math.radians(1) or (sign == 0 and angle == 0)
    folded = folded_coordinates(pattern, angles)
    before, after = (
        np.linalg.norm(np.diff(points[pattern.edges_vertices], axis=1), axis=2)
        for points in (pattern.vertices_coords, folded)
    )
    assert after == pytest.approx(before)


def test_a_vertex_of_mountains_only_has_first_order_motion_but_does_not_fold():
    pattern = star([0, 120, 240], "MMM")
    assert begins_as_assigned(pattern)
    assert folded_as_assigned(pattern) is None


def test_a_vertex_with_the_wrong_crease_as_its_valley_does_not_begin():
    assert not begins_as_assigned(star([0, 60, 180, 240], "MMMV"))


def test_creases_without_a_sense_are_not_folded():
    pattern = star([0, 90, 180, 270], "UUUU")
    assert begins_as_assigned(pattern)
    assert folded_as_assigned(pattern) is None


def test_a_sheet_that_would_tear_at_a_slit_is_not_reported_to_fold():
    pattern = miura_pattern(4, 4, 0.03, 0.02, math.radians(60))
    without = tuple(face for number, face in enumerate(pattern.faces_vertices) if number not in (5, 6, 9, 10))
    holed = dataclasses.replace(pattern, faces_vertices=without)
    angles = folded_as_assigned(holed)
    assert angles is None or np.isfinite(folded_coordinates(holed, angles)[list(without[0])]).all()


@pytest.mark.parametrize("look", [begins_as_assigned, folded_as_assigned])
def test_a_sheet_that_has_begun_to_fold_is_refused(look):
    with pytest.raises(InputError, match="need a sheet that lies flat and unfolded"):
        look(miura_pattern(2, 2, 0.03, 0.02, math.radians(60), 0.5))
