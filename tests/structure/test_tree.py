"""The tree of a fan's bodies against its crease pattern and against distances by hand."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.design import load_design, with_values
from forficula.pattern import earwig_pattern, hub_points, ring_vertices, tips
from forficula.structure import (
    GROUND,
    ancestry,
    built_points,
    drawn_points,
    hinges_between,
    hinges_of,
    structure_of,
    tendon_arms,
)
from tests.structures import supports

REFERENCE = load_design("binder2025")
STRUCTURE = structure_of(REFERENCE)


def numbers(structure, role):
    return [number for number, point in enumerate(structure.points) if point.role == role]


def body(name):
    return [item.name for item in STRUCTURE.bodies].index(name)


def named(hinges):
    return [STRUCTURE.hinges[hinge].name for hinge in hinges]


@settings(max_examples=50, deadline=None)
@given(
    st.integers(1, 5),
    st.floats(8, 20),
    st.floats(0, 0.03),
    st.sampled_from(["left", "right"]),
)
def test_a_fan_is_built_on_the_vertices_of_its_pattern(units, sector, hub, tangent):
    values = {
        "pattern.units": units,
        "pattern.sector_angle": math.radians(sector),
        "pattern.hub_radius": hub,
        "pattern.tangent": tangent,
        "vein.diameter": 1e-3,
        "membrane.margin": 1e-3,
        "guard.stretch": 10.0,
    }
    design = with_values(REFERENCE, values)
    structure, fan = structure_of(design), design.fan
    points = built_points(structure)
    for role, expected in (("hub", hub_points(fan)), ("ring", ring_vertices(fan)), ("tip", tips(fan))):
        # rounding of a turn there and back, of lengths of 22 cm
        assert np.abs(points[numbers(structure, role)] - expected).max() < 1e-15 * (1 + units)
    vertices = earwig_pattern(fan).vertices_coords
    for point in points[drawn_points(structure)]:
        assert np.linalg.norm(vertices - point, axis=1).min() < 1e-15 * (1 + units)


def test_the_bars_of_the_reference_lie_on_its_vertices_to_the_last_digits():
    points, fan = built_points(STRUCTURE), REFERENCE.fan
    for role, expected in (("hub", hub_points(fan)), ("ring", ring_vertices(fan)), ("tip", tips(fan))):
        assert np.abs(points[numbers(STRUCTURE, role)] - expected).max() < 1e-15


def test_tendons_are_attached_at_the_distance_of_the_design_from_the_ring():
    structure = structure_of(
        with_values(REFERENCE, {"tendon.proximal_attachment": 0.04, "tendon.distal_attachment": 0.07})
    )
    points = built_points(structure)
    rings, hubs, ends = (points[numbers(structure, role)] for role in ("ring", "hub", "tip"))
    for place, tendon in enumerate(structure.tendons):
        for point, end, distance in zip(tendon.points, (hubs, ends), (0.04, 0.07), strict=True):
            along = (end[place] - rings[place]) / np.linalg.norm(end[place] - rings[place])
            assert points[point] == pytest.approx(rings[place] + distance * along, abs=1e-15)
        # the hinge that it lies across, and how far its nearer end is from there
        ((hinge, arm),) = tendon_arms(structure, tendon)
        assert hinge == tendon.crossing.hinge == hinges_of(structure, "ring")[place]
        assert arm == pytest.approx(0.04, rel=1e-12)


def test_a_tendon_from_tip_to_tip_crosses_both_veins_with_arms_up_to_its_nearer_end():
    first, second = numbers(STRUCTURE, "tip")[:2]
    across = replace(STRUCTURE.tendons[0], name="across", points=(first, second), crossing=None)
    points = built_points(STRUCTURE)
    arms = dict(tendon_arms(STRUCTURE, across))
    assert named(arms) == ["sweep0", "lift0", "turn0", "fold0", "sweep1", "lift1", "turn1", "fold1"]
    for vein, start in ((0, 0), (1, 4)):
        hub, ring = points[numbers(STRUCTURE, "hub")[vein]], points[numbers(STRUCTURE, "ring")[vein]]
        to_hub, to_ring = (min(np.linalg.norm(points[tip] - place) for tip in (first, second)) for place in (hub, ring))
        assert [arms[hinge] for hinge in range(start, start + 4)] == pytest.approx([to_hub] * 3 + [to_ring], rel=1e-12)


def test_distal_bars_are_hinged_to_proximal_ones_and_these_to_the_ground():
    assert ancestry(STRUCTURE, body("distal1")) == (body("distal1"), body("proximal1"))
    assert ancestry(STRUCTURE, body("proximal2")) == (body("proximal2"),)
    assert ancestry(STRUCTURE, GROUND) == ()


@pytest.mark.parametrize(
    ("one", "other", "between"),
    [
        ("proximal0", "distal0", ["fold0"]),
        ("distal1", "distal1", []),
        ("proximal0", "distal1", ["sweep0", "lift0", "turn0", "sweep1", "lift1", "turn1", "fold1"]),
    ],
)
def test_hinges_between_two_bodies_are_those_that_move_them_against_each_other(one, other, between):
    for ends in ((one, other), (other, one)):
        assert named(hinges_between(STRUCTURE, *map(body, ends))) == between


def test_all_hinges_of_a_vein_lie_between_its_tip_and_the_ground():
    assert named(hinges_between(STRUCTURE, GROUND, body("distal2"))) == ["sweep2", "lift2", "turn2", "fold2"]


def test_a_body_on_the_ground_without_a_hinge_is_a_support(one_hinge):
    assert supports(STRUCTURE) == []
    fixed = one_hinge().wing.structure
    assert supports(fixed) == ["proximal0"]
    assert [hinge.name for hinge in fixed.hinges] == ["fold0"]


def test_bars_are_drawn_from_hub_to_ring_to_tip():
    assert drawn_points(STRUCTURE) == sorted(
        number for role in ("hub", "ring", "tip") for number in numbers(STRUCTURE, role)
    )
