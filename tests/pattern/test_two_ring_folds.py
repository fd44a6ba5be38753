"""A fan with two ring folds: its folded layers are one pitch apart, and the rest of the fan is unchanged."""

import math
from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

import forficula as ff
from forficula.pattern import EarwigFan, earwig_pattern, hub_points, ring_directions, ring_vertices, tips

ONE = EarwigFan(proximal_length=0.12, distal_length=0.10, hub_radius=0.018, sector_angle=math.radians(20), units=1)
TWO = replace(ONE, ring_folds=2, pitch=0.002, gusset_height=0.0015)


@pytest.mark.parametrize("tangent", ["left", "right"])
@pytest.mark.parametrize("units", [1, 2, 3])
def test_folded_layers_lie_a_pitch_apart(units, tangent):
    """In veins folded by 90 deg at both ring folds, the gusset is 2 k pitches higher with k layers inside."""
    fan = replace(TWO, units=units, tangent=tangent)
    first, second, axes = ring_vertices(fan), ring_vertices(fan, fold=1), ring_directions(fan)
    folded = Rotation.from_rotvec(math.pi / 2 * axes).apply(second - first)
    heights = np.sort(np.abs(folded[:, 2]))
    assert np.diff(heights) == pytest.approx(2 * fan.pitch, rel=1e-9)
    assert heights[0] == pytest.approx(fan.gusset_height, rel=1e-9)
    # beyond the second fold a vein lies flat again
    beyond = Rotation.from_rotvec(math.pi * axes).apply(tips(fan) - second)
    assert beyond[:, 2] == pytest.approx(0.0, abs=1e-12)


def test_without_a_pitch_and_a_gusset_both_ring_folds_are_the_one():
    flat = replace(TWO, pitch=1e-15, gusset_height=1e-15)
    assert ring_vertices(flat) == pytest.approx(ring_vertices(ONE), abs=1e-12)
    assert ring_vertices(flat, fold=1) == pytest.approx(ring_vertices(ONE), abs=1e-12)
    assert tips(flat) == pytest.approx(tips(ONE), abs=1e-12)
    assert np.array_equal(hub_points(TWO), hub_points(ONE))


def test_the_pattern_has_gussets_and_shares_the_angles_of_the_ring():
    pattern = earwig_pattern(TWO)
    roles = np.array(pattern.edges_role)
    assert (roles == "gusset").sum() == TWO.vein_count
    assert (roles == "ring").sum() == 2 * (TWO.vein_count - 1)
    ring = np.abs(pattern.edges_fold_angle[roles == "ring"])
    assert ring == pytest.approx(math.pi / 2)
    assert len(pattern.faces_vertices) == 3 * (TWO.vein_count - 1)


def test_a_design_with_two_ring_folds_has_a_hinge_at_each_and_the_same_hash_without():
    design = ff.load_design("binder2025")
    two = design.with_values({"pattern.ring_folds": 2, "vein.diameter": "1 mm"})
    built = ff.structure_of(two)
    assert sum(hinge.role == "ring" for hinge in built.hinges) == 2 * two.fan.vein_count
    assert sum(bar.diameter == pytest.approx(1e-3) for bar in built.bars) == 3 * two.fan.vein_count
    assert design.with_values({"pattern.ring_folds": 1}).hash == design.hash
    assert two.hash != design.hash


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"pattern.ring_folds": 3}, r"pattern.ring_folds: .*2"),
        ({"pattern.pitch": "2 mm"}, r"pattern.pitch: is for two ring folds"),
        ({"pattern.ring_folds": 2, "pattern.pitch": "0 mm"}, r"pattern.pitch: need > 0"),
        ({"pattern.ring_folds": 2, "pattern.pitch": "1 mm"}, r"pattern.pitch: folded layers overlap: need >= 5 mm"),
    ],
)
def test_what_two_ring_folds_cannot_be_is_refused(values, message):
    with pytest.raises(ff.InputError, match=message):
        ff.load_design("binder2025").with_values(values)
