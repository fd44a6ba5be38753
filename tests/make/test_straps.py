import dataclasses

import pytest

from forficula.design import load_design
from forficula.errors import InputError
from forficula.make.hinge.straps import strap_of
from forficula.make.stock import stock_of
from forficula.material import LawFact, load_law
from forficula.structure import structure_of


def wing_strap(**values):
    wing = load_design("binder2025").with_values(values)
    return strap_of(wing, structure_of(wing).tendons[0])


def test_straps_are_as_stiff_together_as_the_tendon_they_are_made_for():
    strap = wing_strap(**{"make.strap_thickness": "0.8 mm", "make.straps": 2})
    modulus = load_law("tpu-95a").moduli[0]
    assert strap.count * modulus * strap.width * strap.thickness / strap.rest_length == pytest.approx(1000)
    assert (strap.thickness, strap.rest_length, strap.material) == (0.8e-3, 0.09, "tpu-95a")
    assert wing_strap(**{"make.straps": 1}).width == pytest.approx(2 * wing_strap(**{"make.straps": 2}).width)


def test_a_strap_of_the_tendons_own_law_has_the_designs_area():
    law = {"tendon.law": "tpu-82a", "tendon.area": "9 mm^2"}
    strap = wing_strap(**law)
    assert (strap.material, strap.area) == ("tpu-82a", pytest.approx(9e-6))
    # a strap of another material is thinner by the ratio of the moduli
    other = wing_strap(**law, **{"make.strap_material": "tpu-95a"})
    assert other.area / strap.area == pytest.approx(4.8 / 12.3)


@pytest.mark.parametrize(
    ("values", "said"),
    [
        ({"tendon.rest_length": "0 cm"}, "tendon: cannot be made as a strap: length: .* resting length > 0"),
        ({"make.strap_material": "petg"}, "^make.strap_material: no strap can be made of it: petg"),
        (
            {"make.strap_material": "resilin"},
            "^make.strap_material: no strap can be made of it: resilin: .* as a range",
        ),
        ({"tendon.stiffness": "0 N/cm"}, "stiffness: need > 0"),
        (
            {"make.strap_thickness": "1e-30 m"},
            "^make.strap_thickness: makes tendon.* a strap .* wide and .* long; need",
        ),
    ],
)
def test_a_tendon_without_a_possible_strap_is_rejected(values, said):
    with pytest.raises(InputError, match=said):
        wing_strap(**values)


def test_density_is_that_of_the_facts_and_the_middle_of_a_range():
    assert stock_of("petg").density == pytest.approx(1270)
    assert stock_of("steel").density == pytest.approx(7900)
    assert stock_of("resilin").density is None
    wrong = dataclasses.replace(load_law("petg"), facts=(LawFact(what="density", value="heavy", source=""),))
    with pytest.raises(InputError, match="petg: facts: density: need a number and a unit"):
        stock_of(wrong)
