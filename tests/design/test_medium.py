"""The medium in a design."""

import pytest

from forficula.design import load_design, scale_design, with_values
from forficula.errors import InputError

REFERENCE = load_design("binder2025")


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"medium.density": -1.0}, r"medium\.density: need >= 0, got -0\.001 g/cm\^3"),
        ({"medium.viscosity": "1 mm"}, r"medium\.viscosity: .*Pa s"),
        ({"medium.viscosity": -1.0}, r"medium\.viscosity: need >= 0, got -1 Pa s"),
        ({"medium.name": "air"}, r"medium\.name: unknown key"),
        (
            {"medium.density": 1000.0, "protocol.gravity": 9.81},
            r"medium\.density: buoyancy is not modelled: need <= 0\.0127 g/cm\^3, a hundredth of"
            r" vein\.density, or protocol\.gravity = 0, got 1 g/cm\^3",
        ),
    ],
)
def test_a_medium_that_cannot_be_is_refused(values, message):
    with pytest.raises(InputError, match=message):
        with_values(REFERENCE, values)


@pytest.mark.parametrize("name", ["letter-fold", "miura-sheet"])
def test_sheets_may_weigh_in_air_and_not_in_water(name):
    sheet = with_values(load_design(name), {"protocol.gravity": 9.81, "medium.density": 1.2})
    assert sheet.medium.density == 1.2
    with pytest.raises(InputError, match=r"a hundredth of facet\.density"):
        with_values(sheet, {"medium.density": 1000.0})


def test_a_size_change_does_not_change_the_medium_but_similarity_does():
    air = load_design("binder2025-built")
    smaller = scale_design(air, 0.1, natural=True).medium
    assert smaller.viscosity == air.medium.viscosity
    assert smaller.density == pytest.approx(air.medium.density, rel=1e-12)
    similar = scale_design(air, 0.1).medium
    assert similar.density == pytest.approx(air.medium.density, rel=1e-12)
    # at a tenth of the size and the same speed, a tenth of the viscosity gives the same Reynolds number
    assert similar.viscosity == pytest.approx(0.1 * air.medium.viscosity, rel=1e-12)


def test_what_a_medium_is_counts_in_the_hash():
    hashes = {with_values(REFERENCE, {"medium.density": density}).hash for density in (0.0, 1.2, 1000.0)}
    assert len(hashes) == 3
    assert REFERENCE.hash in hashes
