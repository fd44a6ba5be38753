"""Landscapes and materials that several test modules draw, write and print."""

import pickle
import tempfile
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest

from forficula.design import load_design, scale_design
from forficula.material.characterisation import characterise
from forficula.material.law.law_family import family_forms
from forficula.statics import EnergyLandscape, energy_landscape
from tests.material.synthetic import cyclic_test, tpu
from tests.show.plates import PARTS, plates_run

SETTINGS = {
    "reference": {},
    "without rest length": {"tendon.rest_length": "0 cm"},
    "without hub": {"pattern.hub_radius": "0 cm"},
    "without overbend": {"hinge.overbend": "0 deg", "protocol.initial_overbend": "0 deg"},
    "slack": {"tendon.rest_length": "12 cm"},
    "without stiffness": {"tendon.stiffness": "0 N/cm"},
    # theory: make.md's table of anchors that stand off the bars
    "off the bars": {"tendon.proximal_offset": "2 mm", "tendon.distal_offset": "2 mm"},
    "beyond the stop": {"tendon.proximal_offset": "-2 mm", "tendon.distal_offset": "-2 mm"},
    "folds by itself": {"tendon.proximal_offset": "-6 cm", "tendon.distal_offset": "-6 cm"},
}
PLATES = {"plates": {}, "soft plates": {"crease.stiffness": "0 N m/rad/m"}, "plates without tendons": {"tendon": []}}
# two veins with tendons of their own, and one between them without
OWN = """
based_on = "binder2025"
name = "own"
[[tendon]]
vein = 0
[[tendon]]
vein = 2
stiffness = "15 N/cm"
rest_length = "9.5 cm"
"""


@pytest.fixture(scope="session")
def surveyed(tmp_path_factory):
    """The landscape of the reference with some settings, by name; "small" is one of 10 mm.

    "own tendons" has none on one vein; "plates" are rigid ones on hinges with springs, "soft plates" without springs.
    """

    shared = tmp_path_factory.getbasetemp().parent  # by all workers of a session

    @cache
    def survey(name: str) -> EnergyLandscape:
        path = shared / f"landscape-{name.replace(' ', '-')}.pickle"
        if path.exists():
            return pickle.loads(path.read_bytes())
        landscape = surveyed_now(name)
        with tempfile.NamedTemporaryFile(dir=shared, delete=False) as unfinished:
            unfinished.write(pickle.dumps(landscape))
        Path(unfinished.name).replace(path)
        return landscape

    def surveyed_now(name: str) -> EnergyLandscape:
        if name in PLATES:
            return energy_landscape(load_design("letter-fold", PLATES[name]), points=61)
        if name == "own tendons":
            path = tmp_path_factory.mktemp("own") / "own.toml"
            path.write_text(OWN, "utf-8")
            return energy_landscape(load_design(path), points=61)
        design = load_design("binder2025", SETTINGS.get(name, {}))
        return energy_landscape(scale_design(design, 1 / 22) if name == "small" else design, points=61)

    return survey


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
    """As tpu_material, but the data tell no law."""
    return replace(tpu_material, fit=None, law=None, remarks=("there is no law: too few rows",))


@pytest.fixture(scope="session")
def plates_runs():
    """Runs of plates with what they are made of in part, and their outcomes, by what is told of these parts."""
    return {name: plates_run(**parts) for name, parts in PARTS.items()}
