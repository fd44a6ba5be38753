"""Landscapes that several test modules draw, write and print."""

from functools import cache

import pytest

from forficula.design import load_design, scale_design
from forficula.statics import EnergyLandscape, energy_landscape

SETTINGS = {
    "reference": {},
    "without rest length": {"tendon.rest_length": "0 cm"},
    "without hub": {"pattern.hub_radius": "0 cm"},
    "without overbend": {"hinge.overbend": "0 deg", "protocol.initial_overbend": "0 deg"},
    "slack": {"tendon.rest_length": "12 cm"},
    "without stiffness": {"tendon.stiffness": "0 N/cm"},
}


@pytest.fixture(scope="session")
def surveyed():
    """The landscape of the reference with some settings, by name; "small" is one of 10 mm."""

    @cache
    def survey(name: str) -> EnergyLandscape:
        design = load_design("binder2025", SETTINGS.get(name, {}))
        return energy_landscape(scale_design(design, 1 / 22) if name == "small" else design, points=61)

    return survey
