"""The Miura sheet as built, compared with the closed forms of its vertices and its size."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.errors import InputError
from forficula.pattern import (
    big_little_big_residuals,
    built_fold_angles,
    degree4_fold_angles,
    folded_coordinates,
    interior_vertices,
    kawasaki_residuals,
    maekawa_residuals,
    miura_pattern,
    miura_size,
)
from tests.pattern.facets import corner_distances, folding

SHEETS = {
    "columns": st.integers(1, 5),
    "rows": st.integers(1, 5),
    "long_side": st.floats(0.2, 5),
    "short_side": st.floats(0.2, 5),
    "acute_angle": st.floats(math.radians(5), math.radians(85)),
}
FOLDS = st.one_of(st.just(0.0), st.floats(0, math.radians(179)))


def sheet(**changes):
    values = {"columns": 4, "rows": 3, "long_side": 0.02, "short_side": 0.03, "acute_angle": math.radians(60)}
    return miura_pattern(**(values | {"fold": 0.0} | changes))


@settings(max_examples=40)
@given(st.fixed_dictionaries(SHEETS), FOLDS)
def test_every_facet_has_the_requested_shape_at_any_fold(values, fold):
    a, b, angle = values["long_side"], values["short_side"], values["acute_angle"]
    short, long = (math.sqrt(a * a + b * b - sign * 2 * a * b * math.cos(angle)) for sign in (1, -1))
    for distances in corner_distances(miura_pattern(**values, fold=fold)):
        assert [distances[0, 1], distances[1, 2]] == pytest.approx([b, a], rel=1e-12)
        assert sorted([distances[0, 2], distances[1, 3]]) == pytest.approx([short, long], rel=1e-12)


@settings(max_examples=40)
@given(st.fixed_dictionaries(SHEETS), FOLDS)
def test_the_box_around_the_sheet_is_that_of_schenk_and_guest(values, fold):
    """Compared with the formulas in the form of Schenk and Guest 2013, with tangents."""
    box = np.ptp(miura_pattern(**values, fold=fold).vertices_coords, axis=0)
    a, b, angle, theta = values["long_side"], values["short_side"], values["acute_angle"], fold / 2
    root = math.sqrt(1 + (math.cos(theta) * math.tan(angle)) ** 2)
    length = a * math.sqrt(1 - (math.sin(theta) * math.sin(angle)) ** 2)
    printed = (
        values["columns"] * b * math.cos(theta) * math.tan(angle) / root,
        values["rows"] * length + b / root,
        a * math.sin(theta) * math.sin(angle),
    )
    assert box == pytest.approx(printed, rel=1e-12)
    assert miura_size(**values, fold=fold) == pytest.approx(printed, rel=1e-12)


@settings(max_examples=40)
@given(st.fixed_dictionaries(SHEETS), st.floats(math.radians(0.1), math.radians(179)))
def test_every_crease_folds_as_far_as_the_half_tangents_of_its_vertices_ask(values, fold):
    """Huffman 1976, Tachi 2009: around a vertex of equal sectors tan(straight / 2) = cos(sector) tan(zigzag / 2)."""
    pattern = miura_pattern(**values, fold=fold)
    folds = built_fold_angles(pattern)
    ratio = math.cos(values["acute_angle"])
    for edge in folding(pattern):
        share = ratio if pattern.edges_role[edge] == "straight" else 1.0
        sense = 1 if pattern.edges_assignment[edge] == "V" else -1
        assert math.tan(folds[edge] / 2) == pytest.approx(sense * share * math.tan(fold / 2), rel=1e-9)


def test_the_two_closed_forms_agree_at_a_vertex():
    angle, fold = math.radians(60), math.radians(100)
    pattern = sheet(acute_angle=angle, fold=fold)
    straight = abs(built_fold_angles(pattern)[pattern.edges_role.index("straight")])
    folds = degree4_fold_angles(angle, angle, straight, "miura")
    assert abs(folds[1]) == pytest.approx(fold, rel=1e-12)


@settings(max_examples=20)
@given(st.fixed_dictionaries(SHEETS))
def test_the_flat_sheet_folds_flat_at_every_vertex(values):
    pattern = miura_pattern(**values)
    inside = (values["columns"] - 1) * (values["rows"] - 1)
    assert not pattern.vertices_coords[:, 2].any()
    assert len(interior_vertices(pattern)) == inside
    assert np.abs(kawasaki_residuals(pattern)).max(initial=0) < 1e-12
    assert not maekawa_residuals(pattern).any()
    assert not big_little_big_residuals(pattern).any()


def test_folding_the_flat_sheet_by_its_fold_angles_gives_the_folded_one():
    flat, folded = sheet(), sheet(fold=math.radians(130))
    walked = folded_coordinates(flat, built_fold_angles(folded))
    for one, other in zip(corner_distances(flat, walked), corner_distances(folded), strict=True):
        assert one == pytest.approx(other, abs=1e-15)
    spans = [np.linalg.norm(coords[-1] - coords[0]) for coords in (walked, folded.vertices_coords)]
    assert spans[0] == pytest.approx(spans[1], rel=1e-12)


def test_the_targets_close_the_sheet_to_a_stack_in_one_plane():
    """At theta = 90 deg every row is L = a cos(acute_angle) long, the zigzag adds b, and H = a sin(acute_angle)."""
    flat = sheet(columns=5, rows=5)
    shut = folded_coordinates(flat, flat.edges_fold_angle)
    assert np.ptp(shut[:, 2]) < 1e-15
    angle = math.radians(60)
    across = math.hypot(5 * 0.02 * math.cos(angle) + 0.03, 0.02 * math.sin(angle))
    assert np.linalg.norm(shut[-1] - shut[0]) == pytest.approx(across, rel=1e-12)


def test_zigzags_lie_across_and_straight_creases_along():
    pattern = sheet()
    assert [pattern.edges_role.count(role) for role in ("zigzag", "straight", "border")] == [8, 9, 14]
    assert len(pattern.faces_vertices) == 12
    assert [role == "border" for role in pattern.edges_role] == [letter == "B" for letter in pattern.edges_assignment]


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"columns": 0}, "pattern.columns: need a whole number, 1 or more, got 0"),
        ({"rows": 2.5}, "pattern.rows: need a whole number, 1 or more, got 2.5"),
        ({"long_side": -0.01}, "pattern.long_side: need > 0 and finite, got -1 cm"),
        ({"short_side": math.nan}, "pattern.short_side: need > 0 and finite, got nan cm"),
        ({"short_side": 1e-20}, "pattern.short_side: need more than 1e-12 of the longest, 2 cm, got 1e-18 cm"),
        ({"acute_angle": math.pi / 2}, "pattern.acute_angle: need > 0 deg and < 90 deg, got 90 deg"),
        ({"fold": math.pi}, "pattern.fold: need >= 0 deg and < 180 deg, got 180 deg"),
        ({"fold": -0.1}, "pattern.fold: need >= 0 deg and < 180 deg, got -5.72958 deg"),
    ],
)
def test_a_sheet_that_cannot_be_drawn_is_refused(changes, message):
    with pytest.raises(InputError) as caught:
        sheet(**changes)
    assert str(caught.value) == message
    values = {"columns": 4, "rows": 3, "long_side": 0.02, "short_side": 0.03, "acute_angle": 1.0} | changes
    with pytest.raises(InputError, match=str(caught.value).split(":")[0]):
        miura_size(**values)
