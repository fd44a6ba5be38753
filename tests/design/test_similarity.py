import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.design import in_units, load_design, scale_design, with_values
from forficula.errors import InputError

REFERENCE = load_design("binder2025")

# One rounding a factor of at most seven powers and products, an ulp each.
ROUNDING = 20 * 2.0**-52

# Exponents of the size by dimensional analysis at fixed modulus (M L^-1 T^-2) and density (M L^-3): M = L^3, T = L.
EXPONENTS = {
    "pattern.proximal_length": 1,
    "pattern.sector_angle": 0,
    "vein.diameter": 1,
    "vein.density": 0,
    "membrane.youngs_modulus": 0,
    "membrane.thickness": 1,
    "membrane.poisson_ratio": 0,
    "membrane.damping": 1,
    "membrane.margin": 1,
    "hinge.overbend": 0,
    "hinge.damping": 4,
    "hinge.armature": 5,
    "tendon.stiffness": 1,
    "tendon.rest_length": 1,
    "tendon.damping": 2,
    "guard.stretch": 0,
    "protocol.timestep": 1,
    "protocol.sample_interval": 1,
    "protocol.fold_torque": 3,
    "protocol.rest_speed": -1,
    "protocol.window": 1,
    "protocol.gravity": -1,
}


def value(design, key):
    section, name = key.split(".")
    return getattr(getattr(design, section), name)


@settings(deadline=None)
@given(st.floats(1e-3, 1e3))
def test_every_value_of_a_scaled_wing_scales_with_the_power_from_dimensional_analysis(factor):
    original = with_values(REFERENCE, {"protocol.gravity": 9.81})
    scaled = scale_design(original, factor)
    for key, exponent in EXPONENTS.items():
        assert value(scaled, key) == pytest.approx(factor**exponent * value(original, key), rel=ROUNDING), key
    for after, before in zip(scaled.protocol.stages, original.protocol.stages, strict=True):
        assert after.time_limit == pytest.approx(factor * before.time_limit, rel=ROUNDING)
        assert after.hold == pytest.approx(factor * before.hold, rel=ROUNDING)


def test_dimensionless_values_are_unchanged():
    original = with_values(REFERENCE, {"protocol.timestep": "auto", "membrane.distal_rows": [0.5], "pattern.units": 2})
    scaled = scale_design(original, 0.1)
    assert scaled.protocol.timestep == "auto"
    assert scaled.membrane.distal_rows == (0.5,)
    assert (scaled.pattern.units, scaled.pattern.tangent) == (2, "right")


def test_the_name_of_a_scaled_wing_contains_the_scale():
    assert scale_design(REFERENCE, 0.1).name == "binder2025-x0.1"


@pytest.mark.parametrize("factor", [0, -1, math.nan, math.inf, 1e-10, 1e10, 1e-300, 1e300])
def test_a_factor_that_no_wing_can_have_is_refused(factor):
    with pytest.raises(InputError) as caught:
        scale_design(REFERENCE, factor)
    assert str(caught.value) == f"factor: need >= 1e-09 and <= 1e+09, got {factor}"


def test_a_value_that_leaves_the_range_of_numbers_is_refused():
    stiff = with_values(REFERENCE, {"tendon.stiffness": 1e300})
    with pytest.raises(InputError, match=r"tendon\.stiffness: need a finite number"):
        scale_design(stiff, 1e9)


def test_a_design_can_be_written_in_other_units():
    in_centimetres_grams_and_milliseconds = in_units(REFERENCE, length=1e-2, mass=1e-3, time=1e-3)
    # 10 N/cm = 1e6 g/s^2 = 1 g/ms^2; 0.5 N m = 5e6 g cm^2/s^2 = 5 g cm^2/ms^2; 1.27 g/cm^3
    assert value(in_centimetres_grams_and_milliseconds, "tendon.stiffness") == pytest.approx(1.0, rel=ROUNDING)
    assert value(in_centimetres_grams_and_milliseconds, "protocol.fold_torque") == pytest.approx(5.0, rel=ROUNDING)
    assert value(in_centimetres_grams_and_milliseconds, "vein.density") == pytest.approx(1.27, rel=ROUNDING)
    assert value(in_centimetres_grams_and_milliseconds, "hinge.overbend") == math.radians(3)


def test_values_that_do_not_depend_on_size_are_unchanged():
    heavy = with_values(REFERENCE, {"protocol.gravity": 9.81})
    scaled, similar = scale_design(heavy, 0.1, natural=True), scale_design(heavy, 0.1)
    assert scaled.protocol.gravity == 9.81
    assert scaled.membrane.damping == REFERENCE.membrane.damping
    kept = {"protocol.gravity": similar.protocol.gravity, "membrane.damping": similar.membrane.damping}
    assert with_values(scaled, kept).hash == similar.hash


def test_a_tendon_has_the_same_material_at_any_size():
    made = load_design("binder2025", {"tendon.law": "tpu-82a", "tendon.area": "12.5 mm^2"})
    scaled = scale_design(made, 0.1, natural=True)
    assert scaled.tendon.law == made.tendon.law
    assert scaled.tendon.area == pytest.approx(made.tendon.area / 100, rel=ROUNDING)


def test_given_relaxation_is_unchanged_and_chosen_relaxation_scales_with_size():
    given_one, chosen = load_design("kresling-cell"), load_design("miura-sheet")
    assert scale_design(given_one, 0.1, natural=True).facet.stretch_damping == given_one.facet.stretch_damping
    small = scale_design(chosen, 0.1, natural=True)
    assert small.facet.stretch_damping == pytest.approx(chosen.settled().facet.stretch_damping / 10, rel=ROUNDING)


def test_a_bound_on_a_distance_scales_with_the_structure():
    bounds = [stage.until for stage in scale_design("kresling-cell", 0.5).protocol.stages]
    assert bounds == ["time", "top_distance < 11.7 cm", "rest", "top_distance > 12.15 cm", "rest"]
    angles = [stage.until for stage in scale_design("letter-fold", 0.5).protocol.stages]
    assert angles == [stage.until for stage in load_design("letter-fold").protocol.stages]


def test_parts_of_an_assembly_scale_as_they_do_alone(tmp_path):
    file = tmp_path / "whole.toml"
    file.write_text(
        """
source = "a test"
[part.cell]
based_on = "kresling-cell"
[part.sheet]
based_on = "miura-sheet"
[[joint]]
name = "stand"
kind = "rigid"
part = "sheet"
points = ["vertex0"]
position = ["40 cm", "0 cm", "0 cm"]
[[protocol.stages]]
name = "press"
drive = "cell.push"
until = "cell.top_distance < 23.4 cm"
time_limit = "1 s"
""",
        encoding="utf-8",
    )
    whole = scale_design(load_design(file), 0.5, natural=True)
    assert whole.joint[0].position == (0.2, 0.0, 0.0)
    assert whole.protocol.stages[0].until == "cell.top_distance < 11.7 cm"
    for name in ("kresling-cell", "miura-sheet"):
        part = getattr(whole, "cell" if name == "kresling-cell" else "sheet")
        alone = scale_design(name, 0.5, natural=True)
        for section in ("facet", "crease", "stops"):
            assert getattr(part, section) == getattr(alone, section), (name, section)
        assert [stage.until for stage in part.protocol.stages] == [stage.until for stage in alone.protocol.stages]
