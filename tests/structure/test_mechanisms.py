from dataclasses import replace

import pytest

from forficula.design import load_design
from forficula.structure import Mechanism, mechanisms_of, structure_of


@pytest.mark.parametrize(
    ("name", "names"),
    [
        ("binder2025", ["tendons", "membrane"]),
        ("four-plate-snap", ["creases", "openings"]),
        ("bistable-clasp", ["tendons", "creases", "bars"]),
        ("miura-sheet", ["creases", "facet bends", "bars"]),
    ],
)
def test_without_mechanisms_elements_are_grouped_by_kind(name, names):
    structure = structure_of(load_design(name))
    mechanisms = mechanisms_of(structure)
    assert [mechanism.name for mechanism in mechanisms] == names
    for kind in ("springs", "tendons", "membranes"):
        numbers = [number for mechanism in mechanisms for number in getattr(mechanism, kind)]
        assert numbers == list(range(len(getattr(structure, kind))))


def test_every_spring_of_a_hinge_belongs_to_one_mechanism():
    structure = structure_of(load_design("miura-sheet"))
    numbers = sorted(number for mechanism in mechanisms_of(structure) for number in mechanism.hinges)
    assert numbers == [number for number, hinge in enumerate(structure.hinges) if hinge.stiffness]


def test_only_elastic_couplings_store_energy():
    coupled = structure_of(load_design("binder2025-coupled", {"coupling.stiffness": "1 N m/rad"}))
    rigid = structure_of(load_design("binder2025-coupled", {"coupling.stiffness": "rigid"}))
    assert mechanisms_of(coupled)[-1] == Mechanism(name="couplings", couplings=(0, 1))
    assert [mechanism.name for mechanism in mechanisms_of(rigid)] == ["tendons", "membrane"]


@pytest.mark.parametrize(("tendons", "count"), [((0, 1), "0"), ((0, 1, 2, 2), "2")])
def test_an_element_outside_of_all_mechanisms_or_in_two_is_refused(tendons, count):
    structure = structure_of(load_design("binder2025"))
    mechanisms = (Mechanism(name="veins", tendons=tendons), Mechanism(name="panels", membranes=(0, 1)))
    with pytest.raises(ValueError, match=f"tendons: tendon2 belongs to {count} mechanisms, need exactly one"):
        mechanisms_of(replace(structure, mechanisms=mechanisms))
