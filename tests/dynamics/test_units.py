import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.design import load_design, scale_design, with_values
from forficula.dynamics import compile_model
from forficula.dynamics.engine.units import design_in_model_units, model_units
from forficula.errors import InputError
from forficula.structure import structure_of

REFERENCE = load_design("binder2025")
sizes = st.floats(-6, 6).map(lambda power: 10.0**power)


@settings(deadline=None)
@given(sizes)
def test_a_wing_of_any_size_has_a_span_and_a_vein_mass_between_1_and_10_in_its_units(size):
    design = scale_design(REFERENCE, size)
    units = model_units(structure_of(design))
    scaled = design_in_model_units(design, units)
    span = scaled.pattern.proximal_length + scaled.pattern.distal_length
    mass = scaled.vein.density * span * math.pi / 4 * scaled.vein.diameter**2
    rounding = 1e-12  # of a few products
    assert 1 - rounding <= span < 10 + rounding
    assert 1 - rounding <= mass < 10 + rounding


@settings(deadline=None)
@given(sizes)
def test_the_units_are_powers_of_ten_with_the_metre_a_second_for_speed(size):
    units = model_units(structure_of(scale_design(REFERENCE, size)))
    for unit in (units.length, units.mass):
        assert unit == float(f"1e{round(math.log10(unit))}")
    assert units.length / units.time == 1.0


def test_energy_and_power_have_their_units():
    units = model_units(structure_of(REFERENCE))
    # span 22 cm and mass 1.27 g/cm3 x 22 cm x pi/4 x (5 mm)^2 = 5.5 g: 0.1 m, 1 g, 0.1 s
    assert (units.length, units.mass, units.time) == (0.1, 1e-3, 0.1)
    assert (units.energy, units.power) == pytest.approx((1e-3, 1e-2), rel=1e-15)  # one rounding


@pytest.mark.parametrize("size", [1e-6, 10 / 220, 1e3])
def test_wings_from_a_cell_to_a_building_compile_into_the_same_numbers(size):
    compiled = compile_model(scale_design(REFERENCE, size)).engine
    reference = compile_model(REFERENCE).engine
    # the scaled size is the same up to a power of ten for all masses
    ratios = compiled.body_mass[1:] / reference.body_mass[1:]
    assert ratios == pytest.approx(ratios[0], rel=1e-9)  # products of many factors, none of them ill-conditioned
    assert 0.1 < ratios[0] < 10


@pytest.mark.parametrize(("key", "value"), [("vein.density", 1e-320), ("vein.diameter", 1e-200)])
def test_a_vein_so_light_that_its_mass_is_no_number_is_refused_by_the_keys_that_make_its_mass(key, value):
    with pytest.raises(InputError, match=r"^vein\.diameter and vein\.density: need a vein with a mass > 0") as caught:
        model_units(structure_of(with_values(REFERENCE, {key: value})))
    assert f"{value:g} " in str(caught.value)
