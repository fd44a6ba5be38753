"""The sheet around two bars that a hinge joins."""

import math

import numpy as np
import pytest

from forficula.errors import InputError
from forficula.pattern import (
    flat_folding_faults,
    folded_coordinates,
    kawasaki_residuals,
    sectors_between,
    strip_pattern,
)

PROXIMAL, DISTAL = math.radians(87), math.radians(107)


def strip(*, valley=True, **changes):
    sizes = {
        "proximal_length": 0.12,
        "distal_length": 0.1,
        "proximal_sector": PROXIMAL,
        "distal_sector": DISTAL,
        "width": 0.04,
    }
    return strip_pattern(**(sizes | changes), valley=valley)


def bar(pattern, role, coords=None):
    """A bar from its inner end to its outer one, m."""
    tail, head = pattern.edges_vertices[pattern.edges_role.index(role)]
    places = pattern.vertices_coords if coords is None else coords
    return places[head] - places[tail]


def test_bars_meet_the_crease_at_their_sectors():
    pattern = strip()
    edges = [pattern.edges_role.index("proximal"), pattern.edges_role.index("distal"), 3]
    sectors = sectors_between(pattern, 4, np.array([edges[0], edges[1], edges[2]]))
    assert sectors == pytest.approx([2 * math.pi - PROXIMAL - DISTAL, DISTAL, PROXIMAL], abs=1e-12)
    assert np.linalg.norm([bar(pattern, "proximal"), bar(pattern, "distal")], axis=1) == pytest.approx([0.12, 0.1])


@pytest.mark.parametrize("valley", [True, False])
def test_a_strip_folds_flat_with_its_bars_apart_by_the_difference_of_their_sectors(valley):
    pattern = strip(valley=valley)
    assert flat_folding_faults(pattern) == []
    assert kawasaki_residuals(pattern) == pytest.approx([0.0], abs=1e-12)
    folded = folded_coordinates(pattern, pattern.edges_fold_angle)
    inwards, outwards = -bar(pattern, "proximal", folded), bar(pattern, "distal", folded)
    apart = math.acos(inwards @ outwards / np.linalg.norm(inwards) / np.linalg.norm(outwards))
    assert apart == pytest.approx(DISTAL - PROXIMAL, abs=1e-9)
    # half folded, the valley points up and the mountain down
    half = folded_coordinates(pattern, pattern.edges_fold_angle / 2)
    faces = [half[list(face), 2].mean() for face in pattern.faces_vertices]
    assert np.ptp(faces) > 0.01


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"width": 0.0}, "pattern.width: need > 0 and finite, got 0 cm"),
        ({"distal_sector": math.pi}, "pattern.distal_sector: need > 0 deg and < 180 deg, got 180 deg"),
    ],
)
def test_a_strip_that_cannot_be_drawn_is_refused(changes, message):
    with pytest.raises(InputError) as caught:
        strip(**changes)
    assert str(caught.value) == message
