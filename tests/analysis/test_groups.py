"""Dimensionless groups compared with closed forms that are computed by hand from a design's numbers."""

import json
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import forficula as ff
from forficula.analysis.groups import changed, dominance, groups_of
from forficula.analysis.scales import scale_of
from forficula.analysis.summary import summary
from forficula.design import load_design, scale_design, with_values
from forficula.serial import plain
from forficula.structure import GROUND, Body, Hinge, Point, Structure, structure_of

REFERENCE = load_design("binder2025")
# rounding of sums and products of a few floats
ROUNDING = 1e-12
# reference, by hand: k a b, and the inertia of a distal bar about the centre of its end, m (l^2 / 3 + r^2 / 4)
MOMENT = 1000.0 * 0.055**2
BAR = 1270.0 * math.pi / 4 * 0.005**2 * 0.10
INERTIA = BAR * (0.10**2 / 3 + 0.0025**2 / 4)
TIME = math.sqrt(INERTIA / MOMENT)
# ring vertices lie on a circle, a sector of 20 deg apart
RADIUS = math.hypot(0.12, 0.015)
WIDTH = 2 * RADIUS * math.sin(math.radians(10))
# tip speed of a bar with the distal bar's length and inertia
BY_LENGTH, SPEED = 3 * INERTIA / 0.10**3, 0.10 / TIME
# sine between the distal bar of vein 0 and the ring crease: 90 deg - 20 deg / 2 - eps
TILT = math.sin(math.radians(80) - math.asin(0.015 / RADIUS))


def groups(design):
    return groups_of(structure_of(design), design.protocol.timestep)


def values(design):
    result = groups(design)
    return {} if result is None else {group.name: group.value for group in result.every}


def test_the_groups_of_the_reference_equal_a_calculation_by_hand():
    expected = {
        "torque_fold": 0.5 / MOMENT,
        "torque_unfold": 1.0 / MOMENT,
        "armature": 1e-5 / INERTIA,
        "hinge_damping": 1e-3 / (MOMENT * TIME),
        "tendon_damping": 0.1 * math.sqrt(0.055**2 / (1000.0 * INERTIA)),
        "gravity_left_out": BAR * 9.81 * 0.05 * TILT / MOMENT,
        "medium_mass_left_out": math.pi / 4 * 1.2 * WIDTH**2 / BY_LENGTH,
        "drag_left_out": 1.2 * WIDTH * 0.10 / BY_LENGTH,
        "reynolds_left_out": 1.2 * WIDTH * SPEED / 1.8e-5,
        "membrane": 1e6 * 1e-4 * WIDTH / (1000.0 * 0.055),
        "membrane_relaxation": 1e-3 / TIME,
        "timestep": 2e-4 / TIME,
        "rest_length": 0.09 / 0.11,
        "arms": 1.0,
        "bar_slenderness": 0.005 / 0.10,
        "bar_width": 0.005 / WIDTH,
        "margin": 0.02 / WIDTH,
        "thickness": 1e-4 / WIDTH,
    }
    assert values(REFERENCE) == pytest.approx(expected, rel=ROUNDING)


def test_the_groups_of_the_reference_equal_published_values():
    known = {
        "torque_fold": 0.165,
        "torque_unfold": 0.331,
        "armature": 1.2,
        "hinge_damping": 0.20,
        "tendon_damping": 0.06,
        "membrane": 0.076,
        "medium_mass_left_out": 0.07,
        "drag_left_out": 0.20,
    }
    result = values(REFERENCE)
    # the reference values have two or three digits
    assert {name: round(result[name], len(str(value)) - 2) for name, value in known.items()} == known
    assert f"{result['gravity_left_out']:.0e}" == "4e-04"
    assert f"{result['reynolds_left_out']:.1e}" == "1.7e+05"


def test_gravity_that_is_on_resists_and_is_that_of_the_run():
    on = values(with_values(REFERENCE, {"protocol.gravity": 1.62}))
    assert on["gravity"] == pytest.approx(values(REFERENCE)["gravity_left_out"] * 1.62 / 9.81, rel=ROUNDING)
    assert "gravity_left_out" not in on


@pytest.mark.parametrize("name", ["binder2025", "letter-fold", "miura-sheet"])
def test_a_medium_that_is_there_resists_and_is_that_of_the_run(name):
    empty = load_design(name)
    thin, thick = (
        values(with_values(empty, {"medium.density": density, "medium.viscosity": 1e-3})) for density in (1.2, 1000.0)
    )
    left_out = values(empty)
    assert thin["medium_mass"] == pytest.approx(left_out["medium_mass_left_out"], rel=ROUNDING)
    assert thick["medium_mass"] == pytest.approx(thin["medium_mass"] * 1000 / 1.2, rel=ROUNDING)
    assert thin["reynolds"] == pytest.approx(left_out["reynolds_left_out"] * 1.8e-5 / 1e-3, rel=ROUNDING)
    assert thin["drag"] == pytest.approx(left_out["drag_left_out"], rel=ROUNDING)
    assert thin["viscous_drag"] == pytest.approx(32 / math.pi * thin["drag"] / thin["reynolds"], rel=ROUNDING)
    assert not {f"{group}_left_out" for group in ("medium_mass", "drag", "reynolds")} & set(thick)
    assert "the medium's mass" in dominance(groups(with_values(empty, {"medium.density": 1000.0})))


def test_masses_on_the_distal_bar_slow_the_tendon_and_an_armature_does_not():
    heavy = with_values(REFERENCE, {"vein.added_mass": 1e-3, "tendon.area": 1e-5, "tendon.density": 1200.0})
    # half of the tendon's mass is at its distal end; the hinge's mass is on its axis
    end = 1200.0 * 1e-5 * 0.09 / 2
    assert scale_of(structure_of(heavy)).inertia == pytest.approx(INERTIA + end * (0.055 * TILT) ** 2, rel=1e-9)
    stiller = with_values(REFERENCE, {"hinge.armature": 1e-3})
    assert scale_of(structure_of(stiller)).inertia == pytest.approx(INERTIA, rel=1e-9)


def test_the_strongest_of_tendons_that_differ_is_the_scale():
    tendons = [{"vein": 0}, {"vein": 2, "stiffness": "30 N/cm", "distal_attachment": "4 cm"}]
    scale = scale_of(structure_of(load_design("binder2025", {"tendon": tendons})))
    assert scale.name == "tendon2"
    assert scale.moment == pytest.approx(3000.0 * 0.055 * 0.04, rel=ROUNDING)


def test_a_plate_on_a_crease_has_the_inertia_of_a_plate_about_its_edge():
    letter = with_values(load_design("letter-fold"), {"tendon": ()})
    scale = scale_of(structure_of(letter))
    panel = 1270.0 * 0.5e-3 * 0.099 * 0.21
    assert scale.moment == pytest.approx(2e-2 * 0.21, rel=ROUNDING)
    assert scale.inertia == pytest.approx(panel * (0.099**2 / 3 + 0.5e-3**2 / 12), rel=1e-9)
    result = values(letter)
    assert result["hinge_damping"] == pytest.approx(3e-2 / 2e-2 / scale.time, rel=1e-9)
    assert result["gravity_left_out"] == pytest.approx(panel * 9.81 * 0.099 / 2 / scale.moment, rel=1e-9)
    assert "armature" not in result


def two_flaps(held=()):
    """Return two corners beside a crease along y: 1 g at 3 cm and 2 g at 1 cm."""
    places = [(0.0, 0.0), (0.0, 0.1), (-0.03, 0.05), (0.01, 0.05)]
    masses = [1.0, 1.0, 1e-3, 2e-3]
    return Structure(
        name="two flaps",
        bodies=tuple(
            Body(
                name=f"v{number}",
                role="vertex",
                parent=GROUND,
                position=np.array([*place, 0.0]),
                frame=np.eye(3),
                slides=() if number in held else (0, 1, 2),
                mass=mass,
            )
            for number, (place, mass) in enumerate(zip(places, masses, strict=True))
        ),
        points=tuple(Point(name=f"v{number}", role="vertex", body=number, place=np.zeros(3)) for number in range(4)),
        hinges=(Hinge(name="c", role="crease", flaps=(0, 1, 2, 1, 0, 3), stiffness=0.5),),
        span=0.1,
        mass=1e-3,
    )


def test_corners_of_a_crease_turn_against_each_other():
    one, other = 1e-3 * 0.03**2, 2e-3 * 0.01**2
    assert scale_of(two_flaps()).inertia == pytest.approx(1 / (1 / one + 1 / other), rel=ROUNDING)
    assert scale_of(two_flaps(held=(3,))).inertia == pytest.approx(one, rel=ROUNDING)
    assert scale_of(two_flaps(held=(2, 3))).time == 0


def test_structures_without_elastic_parts_have_no_groups():
    soft = with_values(REFERENCE, {"tendon.stiffness": 0.0})
    assert groups(soft) is None
    assert plain(None) is None


@pytest.mark.parametrize("stiffness", [1e-300, 1e300])
def test_values_that_overflow_give_no_groups(stiffness):
    assert groups(with_values(REFERENCE, {"tendon.stiffness": stiffness})) is None


@pytest.mark.parametrize("name", [name for name in ff.examples() if name != "binder2025-thick"])
def test_every_named_design_has_groups_that_json_can_hold(name):
    result = groups(load_design(name))
    assert json.dumps(plain(result), allow_nan=False)
    assert len({group.name for group in result.every}) == len(result.every)
    assert dominance(result).endswith(".")


def test_tendons_across_two_ring_folds_have_no_groups():
    """Such tendons have no single moment k a b."""
    assert groups(load_design("binder2025-thick")) is None


@settings(deadline=None, max_examples=15)
@given(
    factor=st.floats(1e-3, 1e3),
    name=st.sampled_from(["binder2025", "binder2025-built", "letter-fold", "bistable-clasp", "miura-sheet"]),
)
def test_scaling_changes_only_groups_of_natural_constants(factor, name):
    given_one = load_design(name)
    before, after = values(given_one), values(scale_design(given_one, factor))
    weight = before.pop("gravity_left_out"), after.pop("gravity_left_out")
    if "reynolds_left_out" in before:
        speeds = [item.pop("reynolds_left_out") for item in (before, after)]
        assert speeds[1] == pytest.approx(factor * speeds[0], rel=1e-9)
    assert after == pytest.approx(before, rel=1e-9)
    # m g l / (k a b) scales as s^3 s / s^3
    assert weight[1] == pytest.approx(factor * weight[0], rel=1e-9)


@settings(deadline=None, max_examples=10)
@given(st.floats(1e-3, 1e3))
def test_a_wing_of_the_same_material_in_the_same_air_under_the_same_gravity_keeps_all_but_four_groups(factor):
    air = {"medium.density": 1.2, "medium.viscosity": 1.8e-5}
    heavy = with_values(REFERENCE, {"protocol.gravity": 9.81, **air})
    pairs = changed(groups(heavy), groups(scale_design(heavy, factor, natural=True)))
    ratios = {old.name: new.value / old.value for old, new in pairs}
    expected = {"gravity": factor, **dict.fromkeys(("membrane_relaxation", "viscous_drag"), 1 / factor)}
    expected = {} if math.isclose(factor, 1, rel_tol=1e-8) else {**expected, "reynolds": factor}
    assert ratios == pytest.approx(expected, rel=1e-9)


def test_the_sentence_on_groups_lists_the_largest_resistance_first():
    assert dominance(groups(REFERENCE)) == (
        "The largest resistance is the armature (1.2), followed by the inertia of the part that turns (1), the hinge's"
        " damping (0.2) and the tendon's damping (0.06); the strongest drive has 0.33 times the tendon's moment;"
        " stretch of the membrane is softer than the tendon (0.076)."
    )
    damped = with_values(REFERENCE, {"hinge.damping": 3e-2, "hinge.armature": 0.0, "membrane.youngs_modulus": 1e10})
    output = dominance(groups(damped))
    assert output.startswith(
        "The largest resistance is the hinge's damping (6), followed by the inertia of the part that turns (1)"
    )
    assert "stretch of the membrane is far stiffer than the tendon (7.6e+02)" in output


def test_the_summary_of_a_run_contains_its_groups():
    short = with_values(
        REFERENCE,
        {
            "protocol.stages": [
                {"name": "settle", "drive": "none", "until": "time", "hold": 0.0, "time_limit": 2e-3},
            ]
        },
    )
    record = ff.run(short, confirm=False)
    output = summary(record, ff.measure(record), {})["groups"]
    assert output["armature"] == pytest.approx(1e-5 / INERTIA, rel=ROUNDING)
    assert output["measured_by"]["time_s"] == pytest.approx(TIME, rel=ROUNDING)
    assert output["in_words"].startswith("The largest resistance is the armature")
