"""Kresling towers as built, compared with the closed form of their crease lengths."""

import math
from collections import Counter

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.errors import InputError
from forficula.pattern import (
    built_fold_angles,
    folded_coordinates,
    kresling_lengths,
    kresling_other_state,
    kresling_pattern,
    triangulated,
)
from forficula.pattern.shared_edges import shared_edges
from tests.pattern.facets import folding, vector_areas


@st.composite
def towers(draw):
    sides = draw(st.integers(3, 8))
    most = math.pi - 2 * math.pi / sides
    return {
        "sides": sides,
        "layers": draw(st.integers(1, 3)),
        "radius": draw(st.floats(0.1, 2)),
        "height": draw(st.floats(0.1, 2)),
        "twist": draw(st.floats(0.02, 0.98)) * most * draw(st.sampled_from([-1, 1])),
        "alternating": draw(st.booleans()),
        "end_plates": draw(st.booleans()),
    }


def lengths_of(pattern, role):
    ends = pattern.vertices_coords[pattern.edges_vertices[[edge == role for edge in pattern.edges_role]]]
    return np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)


@settings(max_examples=40)
@given(towers())
def test_crease_lengths_match_the_closed_form(values):
    pattern = kresling_pattern(**values)
    sides, radius = values["sides"], values["radius"]
    expected = kresling_lengths(sides, radius, values["height"], abs(values["twist"]))
    count = sides * values["layers"]
    assert lengths_of(pattern, "mountain") == pytest.approx([float(expected.mountain)] * count, rel=1e-12)
    assert lengths_of(pattern, "valley") == pytest.approx([float(expected.valley)] * count, rel=1e-12)
    ring = 2 * radius * math.sin(math.pi / sides)
    rings = np.concatenate([lengths_of(pattern, role) for role in ("polygon", "border")])
    assert rings == pytest.approx([ring] * sides * (values["layers"] + 1), rel=1e-12)


@settings(max_examples=40)
@given(towers())
def test_mountains_and_valleys_fold_as_they_are_called_seen_from_outside(values):
    pattern = kresling_pattern(**values)
    assert pattern.edges_fold_angle.tolist() == pytest.approx(built_fold_angles(pattern).tolist(), nan_ok=True)
    for letter, role, fold in zip(pattern.edges_assignment, pattern.edges_role, pattern.edges_fold_angle, strict=True):
        assert role != "mountain" or (letter == "M" and fold < 0)
        assert role != "valley" or (letter == "V" and fold > 0)
        assert role != "polygon" or letter == ("F" if abs(fold) < 1e-9 else "V" if fold > 0 else "M")


@settings(max_examples=30)
@given(towers())
def test_every_edge_joins_two_facets_but_the_rims_and_a_closed_tower_has_the_volume_of_its_facets(values):
    pattern = kresling_pattern(**values)
    sides, layers = values["sides"], values["layers"]
    rims = 0 if values["end_plates"] else 2 * sides
    assert pattern.edges_assignment.count("B") == rims
    assert len(shared_edges(pattern)) == len(folding(pattern)) == sides * (3 * layers + 1) - rims
    # the vector areas of a closed surface add up to 0, those of an open one to the areas of its rims, which cancel
    assert np.abs(vector_areas(pattern).sum(axis=0)).max() < 1e-12
    if values["end_plates"]:
        split = triangulated(pattern).pattern
        corners = split.vertices_coords[np.array(split.faces_vertices)]
        assert np.linalg.det(corners).sum() > 0  # six times the volume: all face outwards


def test_a_twist_in_the_opposite_sense_gives_the_mirror_image():
    one, other = (kresling_pattern(5, 2, 0.03, 0.02, twist) for twist in (0.6, -0.6))
    mirrored = {tuple(np.round(point * [1, -1, 1], 12)) for point in one.vertices_coords}
    assert mirrored == {tuple(np.round(point, 12)) for point in other.vertices_coords}
    assert np.sort(one.edges_fold_angle) == pytest.approx(np.sort(other.edges_fold_angle), abs=1e-12, nan_ok=True)


def test_layers_that_alternate_end_as_they_began():
    tower = kresling_pattern(6, 2, 0.03, 0.02, 0.6, alternating=True)
    assert tower.vertices_coords[12:, :2] == pytest.approx(tower.vertices_coords[:6, :2], abs=1e-15)
    assert tower.vertices_coords[12:, 2] == pytest.approx([0.04] * 6)
    # the polygon between is a mirror plane: both sides have the same inclination
    assert Counter(tower.edges_role) == {"mountain": 12, "valley": 12, "polygon": 6, "border": 12}


def test_end_plates_are_polygons_that_face_outwards():
    tower = kresling_pattern(6, 1, 0.03, 0.02, 0.6, end_plates=True)
    areas = vector_areas(tower)[-2:]
    area = 6 / 2 * 0.03**2 * math.sin(math.pi / 3)
    assert areas == pytest.approx(np.array([[0, 0, -area], [0, 0, area]]), abs=1e-18)
    assert [len(face) for face in tower.faces_vertices] == [3] * 12 + [6, 6]
    assert set(tower.edges_assignment[:]) == {"M", "V"}


@settings(max_examples=60)
@given(towers())
def test_the_other_state_has_the_same_creases(values):
    """Both states have the same crease lengths, so a truss of bars has no energy in either."""
    sides, radius, height, twist = (values[key] for key in ("sides", "radius", "height", "twist"))
    most = math.pi - 2 * math.pi / sides
    if height**2 < 4 * radius**2 * (math.sin((most - abs(twist)) / 2) ** 2 - math.sin(abs(twist) / 2) ** 2):
        with pytest.raises(InputError, match="for a second state"):
            kresling_other_state(sides, radius, height, twist)
        return
    other = kresling_other_state(sides, radius, height, twist)
    assert (other.twist > 0) == (twist > 0)
    current = kresling_lengths(sides, radius, height, abs(twist))
    present = kresling_lengths(sides, radius, other.height, abs(other.twist))
    assert present == pytest.approx(current, rel=1e-12)


def test_a_tower_in_both_states_has_congruent_facets_and_folds_from_one_to_the_other():
    one = kresling_pattern(6, 1, 0.03, 0.05, math.radians(30))
    state = kresling_other_state(6, 0.03, 0.05, math.radians(30))
    other = kresling_pattern(6, 1, 0.03, state.height, state.twist)
    assert math.degrees(state.twist) == pytest.approx(90)
    for role in ("mountain", "valley", "border"):
        assert lengths_of(one, role) == pytest.approx(lengths_of(other, role), rel=1e-12)
    folds = built_fold_angles(other)
    # the unfolded facets of one state, folded by the angles of the other, close around the axis
    unrolled = folded_coordinates(one, folds - built_fold_angles(one))
    box = [np.linalg.norm(coords[:6] - coords[:6].mean(axis=0), axis=1) for coords in (unrolled, other.vertices_coords)]
    assert box[0] == pytest.approx(box[1], rel=1e-12)


def test_lengths_have_the_shape_of_heights_and_twists():
    lengths = kresling_lengths(6, 0.03, np.zeros((3, 1)), np.linspace(0, 1, 4))
    assert lengths.mountain.shape == lengths.valley.shape == (3, 4)
    assert lengths.mountain[:, 0].tolist() == [0, 0, 0]
    assert lengths.valley[:, 0] == pytest.approx([0.03] * 3)  # a side of a hexagon


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"sides": 2}, "pattern.sides: need a whole number, 3 or more, got 2"),
        ({"layers": 0}, "pattern.layers: need a whole number, 1 or more, got 0"),
        ({"radius": 0.0}, "pattern.radius: need > 0 and finite, got 0 cm"),
        ({"height": -0.01}, "pattern.height: need > 0 and finite, got -1 cm"),
        (
            {"twist": 0.0},
            "pattern.twist: need > 0 deg and < 120 deg, 180 deg - 360 deg / sides, or the same with a minus, got 0 deg",
        ),
        ({"twist": math.nan}, "pattern.twist: need > 0 deg and < 120 deg, 180 deg - 360 deg / sides"),
        ({"twist": math.radians(-121)}, "pattern.twist: need > 0 deg and < 120 deg"),
    ],
)
def test_a_tower_that_cannot_be_drawn_is_refused(changes, message):
    with pytest.raises(InputError) as caught:
        kresling_pattern(**({"sides": 6, "layers": 1, "radius": 0.03, "height": 0.02, "twist": 0.5} | changes))
    assert str(caught.value).startswith(message)


def test_a_low_tower_has_no_second_state_and_the_error_names_the_least_height():
    with pytest.raises(InputError) as caught:
        kresling_other_state(6, 0.03, 0.01, math.radians(30))
    assert str(caught.value).startswith("pattern.height: need at least 3.94822 cm for a second state, got 1 cm")
