"""A fan whose veins have different lengths, hub radii and sector angles, given as shares of common values."""

import math

import numpy as np
import pytest
from hypothesis import given, settings

import forficula as ff
from forficula.errors import InputError
from forficula.pattern import (
    EarwigFan,
    big_little_big_residuals,
    earwig_pattern,
    fan_fold_angles,
    hub_points,
    maekawa_residuals,
    ring_directions,
    ring_ratios,
    ring_sectors,
    ring_vertices,
    tips,
    vein_gaps,
)
from tests.different_fans import different_fans

REFERENCE = {
    "proximal_length": 0.12,
    "distal_length": 0.10,
    "hub_radius": 0.015,
    "sector_angle": math.radians(20),
    "units": 2,
}
# every vein is 4 % longer than the one before it
SERIES = (1.0, 1.04, 1.0816, 1.124864, 1.16985856)


def fan(**changes):
    return EarwigFan(**(REFERENCE | changes))


@given(different_fans())
def test_every_vein_has_its_length_and_touches_the_hub(drawn):
    hub, ring, tip = hub_points(drawn), ring_vertices(drawn), tips(drawn)
    size = drawn.proximal_length
    assert np.linalg.norm(ring - hub, axis=1) == pytest.approx(drawn.proximal_lengths, rel=1e-12)
    assert np.linalg.norm(tip - ring, axis=1) == pytest.approx(drawn.distal_lengths, rel=1e-12)
    along = (ring - hub) / np.linalg.norm(ring - hub, axis=1)[:, None]
    assert np.abs((along * hub).sum(axis=1)).max() < 1e-14 * size
    assert np.linalg.norm(hub, axis=1) == pytest.approx(drawn.hub_radius, rel=1e-12)


@given(different_fans())
def test_neighbouring_veins_enclose_the_sector_angle_times_the_share_of_the_panel(drawn):
    directions = ring_vertices(drawn) - hub_points(drawn)
    azimuths = np.unwrap(np.arctan2(directions[:, 1], directions[:, 0]))
    assert np.diff(azimuths) == pytest.approx(drawn.sector_angle * np.array(drawn.sector_shares), rel=1e-9)
    # the middle ring vertex lies on the x axis
    assert ring_vertices(drawn)[drawn.units, 1] == pytest.approx(0, abs=1e-15)


@given(different_fans())
def test_mountains_and_valleys_of_different_veins_suit_a_fan_that_folds_flat(drawn):
    pattern = earwig_pattern(drawn)
    assert not maekawa_residuals(pattern).any()
    assert not big_little_big_residuals(pattern).any()
    assert (ring_ratios(drawn) > 0).all()


@settings(max_examples=25)
@given(different_fans())
def test_different_veins_are_mirror_images_on_the_other_side_of_the_hub(drawn):
    other = EarwigFan(
        **{key: getattr(drawn, key) for key in ("proximal_length", "distal_length", "hub_radius", "sector_angle")},
        units=drawn.units,
        tangent="left" if drawn.tangent == "right" else "right",
        proximal_shares=drawn.proximal_shares[::-1],
        distal_shares=drawn.distal_shares[::-1],
        sector_shares=drawn.sector_shares[::-1],
    )
    for points in (hub_points, ring_vertices, tips):
        assert points(other)[::-1] * [1, -1, 1] == pytest.approx(points(drawn), abs=1e-13 * drawn.proximal_length)


@pytest.mark.parametrize("tangent", ["left", "right"])
def test_shares_of_one_are_the_fan_with_four_numbers_bit_for_bit(tangent):
    ones = dict.fromkeys(("proximal_shares", "distal_shares", "hub_shares"), (1.0,) * 5)
    one, other = fan(tangent=tangent), fan(tangent=tangent, sector_shares=(1.0,) * 4, **ones)
    for points in (hub_points, ring_vertices, tips, ring_directions, ring_ratios):
        np.testing.assert_array_equal(points(one), points(other))
    shares = np.linspace(0, 1, 11)
    assert vein_gaps(one, shares) == pytest.approx(vein_gaps(other, shares), rel=1e-12)
    np.testing.assert_array_equal(fan_fold_angles(one, 1.2), fan_fold_angles(other, 1.2))


def test_equal_veins_have_the_ratio_of_the_construction_with_four_numbers():
    one = fan()
    assert ring_ratios(one) == pytest.approx(math.sin(one.epsilon) / math.cos(math.radians(10)), rel=1e-15)


def test_veins_in_a_geometric_series_fold_at_one_rate():
    """The ring fold is then a polygon in a logarithmic spiral, and all ring vertices are similar."""
    series = fan(proximal_shares=SERIES, hub_shares=SERIES, distal_shares=SERIES)
    for sectors in ring_sectors(series):
        assert np.ptp(sectors) < 1e-15
    assert np.ptp(ring_ratios(series)) < 1e-15
    assert ring_ratios(series)[0] > ring_ratios(fan())[0]
    radii = np.linalg.norm(ring_vertices(series, continued=True), axis=1)
    assert radii[1:] / radii[:-1] == pytest.approx(1.04, rel=1e-14)


def test_alternating_veins_continue_beyond_the_rim():
    alternating = fan(proximal_shares=(1.0, 0.9, 1.0, 0.9, 1.0))
    ratios = ring_ratios(alternating)
    assert ratios[::2] == pytest.approx(ratios[0], rel=1e-12)
    assert ratios[1::2] == pytest.approx(ratios[1], rel=1e-12)


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"proximal_shares": (1.0,) * 4}, r"pattern\.proximal_shares: need 5 numbers, one for each of the 5 veins"),
        ({"sector_shares": (1.0,) * 5}, r"pattern\.sector_shares: need 4 numbers, one for each of the 4 panels"),
        ({"distal_shares": (1.0, 1.0, 0.0, 1.0, 1.0)}, r"pattern\.distal_shares: entry 2: need > 0, got 0"),
        ({"hub_shares": (1.0, math.nan, 1.0, 1.0, 1.0)}, r"pattern\.hub_shares: entry 1: need a finite number"),
        ({"sector_shares": (5.0,) * 4}, r"pattern\.sector_shares: the fan closes on itself: .* got 400 deg"),
        (
            {"proximal_shares": SERIES[::-1]},
            r"pattern\.proximal_shares: vein 0 would fold in the same sense as its neighbours: .* got 8[0-9.]+ deg",
        ),
        (
            {"hub_radius": 0.7, "distal_shares": (0.9, 1.0, 1.0, 1.0, 0.9)},
            r"pattern\.distal_shares: vein 0 does not cross the ring fold: .* got -0\.2[0-9]* deg",
        ),
        ({"hub_shares": (1.0, 1.2, 1.0, 1.0, 1.0)}, r"pattern\.hub_shares: the proximal parts of veins 0 and 1 cross"),
        (
            {"proximal_shares": (0.8, 1.3, 1.1, 1.1, 1.3), "distal_length": 0.2, "hub_radius": 0.04},
            r"pattern\.proximal_shares: a panel between veins 2 and 3 bends inwards",
        ),
        (
            {"distal_shares": (1.0,) * 5, "ring_folds": 2, "pitch": 0.002, "gusset_height": 0.002},
            r"pattern\.distal_shares: needs one ring fold",
        ),
    ],
)
def test_veins_that_do_not_make_a_fan_are_refused_with_the_reason(changes, message):
    with pytest.raises(InputError, match=message) as refusal:
        fan(**changes)
    assert "\n" not in str(refusal.value)


def test_without_a_hub_the_tilt_of_the_ring_alone_decides_the_sense_of_the_veins():
    assert not ring_ratios(fan(hub_radius=0.0, distal_shares=(0.9, 1.0, 1.1, 1.0, 0.9))).any()
    assert (ring_ratios(fan(hub_radius=0.0, proximal_shares=SERIES)) > 0).all()
    with pytest.raises(InputError, match=r"vein 0 would fold in the same sense"):
        fan(hub_radius=0.0, proximal_shares=SERIES, tangent="left")


def test_a_design_takes_shares_and_keeps_its_hash_without_them():
    design = ff.load_design("binder2025")
    short = design.with_values({"pattern.distal_shares": [0.9, 1.0, 0.9]})
    assert short.fan.distal_lengths == pytest.approx((0.09, 0.10, 0.09))
    assert short.hash != design.hash
    assert "distal_shares" not in design.as_tables()["pattern"]
    assert ff.load_design("binder2025", short.as_tables()).hash == short.hash


def test_bars_and_tendons_of_a_design_have_the_lengths_of_their_veins():
    design = ff.load_design("graded-fan")
    built = ff.structure_of(design)
    lengths = [float(np.linalg.norm(bar.end)) for bar in built.bars]
    assert lengths[::2] == pytest.approx(design.fan.proximal_lengths, rel=1e-12)
    assert lengths[1::2] == pytest.approx(design.fan.distal_lengths, rel=1e-12)
    assert built.span == pytest.approx(0.20 * 1.16985856)
    # inertia of a thin bar grows with the cube of its length
    inertias = [tendon.crossing.inertia - design.hinge.armature for tendon in built.tendons]
    assert np.array(inertias) / inertias[0] == pytest.approx(np.array(SERIES) ** 3, rel=1e-3)
    with pytest.raises(InputError, match=r"tendon\.proximal_attachment: lies beyond the bar"):
        design.with_values({"tendon.proximal_attachment": "11.5 cm"})


def test_only_veins_that_fold_at_one_rate_have_an_energy_along_the_rigid_fold():
    graded = ff.structure_of(ff.load_design("graded-fan"))
    assert graded.rigid_fold is not None
    assert graded.remarks == ()
    design = ff.load_design("binder2025", {"pattern.proximal_shares": [1.0, 0.98, 1.0]})
    built = ff.structure_of(design)
    assert built.rigid_fold is None
    assert "every vein at its own rate" in built.remarks[0]
    assert "11.76 cm to 12 cm long up to the ring fold" in built.appearance.text
