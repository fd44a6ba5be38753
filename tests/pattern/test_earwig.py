import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from forficula.errors import InputError
from forficula.pattern import (
    EarwigFan,
    big_little_big_residuals,
    creases_inside,
    earwig_pattern,
    hub_points,
    interior_vertices,
    maekawa_residuals,
    ring_vertices,
    sectors_between,
    tips,
)

REFERENCE = {
    "proximal_length": 0.12,
    "distal_length": 0.10,
    "hub_radius": 0.015,
    "sector_angle": math.radians(20),
    "units": 1,
}


def fan(**changes):
    return EarwigFan(**(REFERENCE | changes))


@st.composite
def fans(draw):
    units = draw(st.integers(1, 5))
    length = draw(st.floats(0.001, 1))
    return EarwigFan(
        proximal_length=length,
        distal_length=length * draw(st.floats(0.2, 2)),
        hub_radius=length * draw(st.one_of(st.just(0.0), st.floats(0.01, 1.5))),
        sector_angle=math.radians(draw(st.floats(2, min(60, 175 / units)))),
        units=units,
        tangent=draw(st.sampled_from(["left", "right"])),
    )


def distance_of_origin_from_line(start, end):
    along = (end - start) / np.linalg.norm(end - start, axis=1)[:, None]
    return along[:, 0] * start[:, 1] - along[:, 1] * start[:, 0]


@given(fans())
def test_veins_have_their_lengths_and_ring_vertices_lie_on_one_circle(drawn):
    hub, ring, tip = hub_points(drawn), ring_vertices(drawn), tips(drawn)
    assert hub.shape == ring.shape == tip.shape == (2 * drawn.units + 1, 3)
    scale = drawn.ring_radius
    assert np.linalg.norm(ring - hub, axis=1) == pytest.approx(drawn.proximal_length, abs=1e-14 * scale)
    assert np.linalg.norm(tip - ring, axis=1) == pytest.approx(drawn.distal_length, abs=1e-14 * scale)
    assert np.linalg.norm(ring, axis=1) == pytest.approx(math.sqrt(drawn.proximal_length**2 + drawn.hub_radius**2))
    assert drawn.epsilon == pytest.approx(math.asin(drawn.hub_radius / drawn.ring_radius))


@given(fans())
def test_proximal_and_distal_veins_touch_the_hub_on_opposite_sides(drawn):
    side = {"right": -1, "left": 1}[drawn.tangent]  # +1: the hub's centre lies to the right, the vein passes left of it
    proximal = distance_of_origin_from_line(hub_points(drawn), ring_vertices(drawn))
    distal = distance_of_origin_from_line(ring_vertices(drawn), tips(drawn))
    assert proximal == pytest.approx(side * drawn.hub_radius, abs=1e-14 * drawn.ring_radius)
    assert distal == pytest.approx(-side * drawn.hub_radius, abs=1e-12 * drawn.ring_radius)


def test_the_right_tangent_passes_the_hub_on_the_right_hand_looking_outwards():
    middle = hub_points(fan(tangent="right"))[1]
    assert middle[1] < 0  # looking along +x, right is -y


def test_left_and_right_are_mirror_images():
    mirror = np.array([1, -1, 1])
    for points in (hub_points, ring_vertices, tips):
        mirrored = points(fan(tangent="left"))[::-1] * mirror
        assert points(fan(tangent="right")) == pytest.approx(mirrored, abs=1e-16)


def test_the_middle_ring_vertex_is_on_x_and_veins_are_counterclockwise():
    ring = ring_vertices(fan(units=2))
    azimuths = np.degrees(np.arctan2(ring[:, 1], ring[:, 0]))
    assert azimuths == pytest.approx([-40, -20, 0, 20, 40])


def test_the_pattern_continued_has_one_ring_vertex_more():
    ring, continued = ring_vertices(fan()), ring_vertices(fan(), continued=True)
    assert continued[:-1].tolist() == ring.tolist()
    assert np.degrees(np.arctan2(continued[-1, 1], continued[-1, 0])) == pytest.approx(40)


def test_sectors_at_the_ring_fold_are_those_of_the_construction():
    pattern = earwig_pattern(fan())
    ((vertex, around),) = creases_inside(pattern)
    epsilon = math.degrees(math.asin(0.015 / math.sqrt(0.12**2 + 0.015**2)))
    expected = [80 - epsilon, 80 + epsilon, 100 - epsilon, 100 + epsilon]
    assert sorted(np.degrees(sectors_between(pattern, vertex, around))) == pytest.approx(sorted(expected))


@given(fans())
def test_mountains_and_valleys_suit_a_fan_that_folds_flat(drawn):
    pattern = earwig_pattern(drawn)
    assert len(interior_vertices(pattern)) == 2 * drawn.units - 1
    assert not maekawa_residuals(pattern).any()
    assert not big_little_big_residuals(pattern).any()


@given(fans())
def test_faces_run_counterclockwise_and_tile_the_fan(drawn):
    pattern = earwig_pattern(drawn)
    areas = []
    for face in pattern.faces_vertices:
        x, y = pattern.vertices_coords[list(face), :2].T
        areas.append(0.5 * np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))
    assert min(areas) > 0
    assert np.allclose(areas[: len(areas) // 2], areas[0])
    assert np.allclose(areas[len(areas) // 2 :], areas[-1])
    vertices, edges, faces = len(pattern.vertices_coords), len(pattern.edges_vertices), len(pattern.faces_vertices)
    assert vertices - edges + faces == 1  # Euler's formula for a disc


def test_outer_veins_are_border_and_inner_ones_alternate():
    pattern = earwig_pattern(fan(units=2))
    letters = {role: [] for role in ("proximal", "distal", "ring", "hub", "outer")}
    for role, letter in zip(pattern.edges_role, pattern.edges_assignment, strict=True):
        letters[role].append(letter)
    assert letters == {
        "proximal": list("BVMVB"),
        "distal": list("BVMVB"),
        "ring": list("MVMV"),
        "hub": list("BBBB"),
        "outer": list("BBBB"),
    }


def test_fold_angles_of_the_pattern_are_half_turns_with_the_sign_of_the_letter():
    pattern = earwig_pattern(fan(units=3))
    meaning = {"V": math.pi, "M": -math.pi, "B": math.nan}
    expected = [meaning[letter] for letter in pattern.edges_assignment]
    np.testing.assert_array_equal(pattern.edges_fold_angle, expected)


@pytest.mark.parametrize("radius", [0, 5e-324, 1e-17])
def test_a_hub_without_radius_is_one_vertex(radius):
    pattern = earwig_pattern(fan(hub_radius=radius))
    assert len(pattern.vertices_coords) == 1 + 3 + 3
    assert "hub" not in pattern.edges_role


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"hub_radius": -0.015}, r"pattern\.hub_radius: need >= 0, got -1\.5 cm"),
        ({"hub_radius": math.nan}, r"pattern\.hub_radius: need a finite number, got nan cm"),
        ({"proximal_length": 0}, r"pattern\.proximal_length: need > 0, got 0 cm"),
        ({"distal_length": -0.1}, r"pattern\.distal_length: need > 0, got -10 cm"),
        ({"distal_length": math.inf}, r"pattern\.distal_length: need a finite number, got inf cm"),
        ({"distal_length": "10 cm"}, r"pattern\.distal_length: need a number, got '10 cm'"),
        ({"sector_angle": 0.0}, r"pattern\.sector_angle: need > 0 deg and < 180 deg, got 0 deg"),
        ({"sector_angle": math.pi}, r"pattern\.sector_angle: need > 0 deg and < 180 deg, got 180 deg"),
        ({"units": 0}, r"pattern\.units: need a whole number of fan units, 1 or more, got 0"),
        ({"units": 1.5}, r"pattern\.units: need a whole number of fan units, 1 or more, got 1\.5"),
        ({"units": True}, r"pattern\.units: need a whole number of fan units, 1 or more, got True"),
        ({"tangent": "up"}, r"pattern\.tangent: need left or right, got 'up'"),
        (
            {"units": 9},
            r"pattern\.units: .* at most 8 at 20 deg, or pattern\.sector_angle < 20 deg at 9, got 9 units",
        ),
        (
            {"hub_radius": 0.7},
            r"pattern\.hub_radius: need < 68\.0554 cm, .* longer proximal_length, got 70 cm",  # 12 cm / tan 10 deg
        ),
    ],
)
def test_a_fan_that_cannot_be_is_refused_by_name(changes, message):
    with pytest.raises(InputError, match=message) as refusal:
        fan(**changes)
    assert "\n" not in str(refusal.value)


def test_the_largest_number_of_units_that_the_refusal_names_is_accepted():
    assert fan(units=8).vein_count == 17
