"""Materials and runs that several test modules draw, write and print."""

from dataclasses import replace

import pytest

from forficula.material.characterisation import characterise
from forficula.material.law.law_family import family_forms
from tests.material.synthetic import cyclic_test, tpu
from tests.show.plates import PARTS, plates_run


@pytest.fixture(scope="session")
def tpu_material():
    """Three specimens like the paper's, with few laws to choose from."""
    forms = (*family_forms("zener"), *family_forms("kelvin-voigt"))
    return characterise([tpu(seed) for seed in (1, 2, 3)], name="tpu", source="made up", forms=forms)


@pytest.fixture(scope="session")
def elastic_material():
    """One linear specimen of 4.8 MPa, without loss."""
    test = cyclic_test(lambda strain, _: 4.8e6 * strain, cycles=3, samples=100, noise=1e4, name="elastic")
    return characterise([test], name="elastic", forms=family_forms("linear"))


@pytest.fixture(scope="session")
def lawless_material(tpu_material):
    """A material like tpu_material whose data determine no law."""
    return replace(tpu_material, fit=None, law=None, remarks=("there is no law: too few rows",))


@pytest.fixture(scope="session")
def plates_runs():
    """Runs of plates that lack some parts, with their outcomes, by a description of the parts."""
    return {name: plates_run(**parts) for name, parts in PARTS.items()}
