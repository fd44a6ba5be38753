"""Both folds beside a strip share the angles of the crease that they replace. Strips are plates, too."""

import math

import pytest

from forficula import InputError
from forficula.design import with_values
from forficula.structure import structure_of
from tests.plate_sheets import plates, pleats


def letter(crease="", **more):
    facet = 'kind = "rigid"\nthickness_method = "split"'
    return plates(pleats(3, "VV"), facet=facet, crease='stiffness = "1e-3 N m/rad/m"\n' + crease, **more)


def test_two_folds_share_limit_and_rest_angle_of_a_crease():
    design = letter('fold_limit = "170 deg"\nrest_angle = "60 deg"')
    structure = structure_of(design)
    shares = [float(design.sheet.edges_share[hinge.edge]) for hinge in structure.hinges]
    assert sorted(shares) == [0.5, 0.5, 1.0]
    for hinge, share in zip(structure.hinges, shares, strict=True):
        assert hinge.upper == pytest.approx(share * math.radians(170))
        assert hinge.rest_angle == pytest.approx(share * math.radians(60))


def test_a_strip_is_a_plate_of_its_own_thickness_in_contact():
    structure = structure_of(with_values(letter(), {"protocol.contact": True}))
    assert [plate.thickness for plate in structure.plates] == pytest.approx([5e-4, 5e-4, 2.5e-4, 5e-4])
    assert [plate.touching_distance for plate in structure.plates] == [None, None, pytest.approx(2.5e-4), None]


def test_the_width_of_strips_follows_the_thickness():
    wide = with_values(letter(), {"facet.thickness": 2e-3}).sheet.vertices_coords[:, 0]
    assert wide.max() - letter().sheet.vertices_coords[:, 0].max() == pytest.approx(1.5e-3)


def test_facets_that_bend_are_refused():
    with pytest.raises(InputError, match=r'need facet\.kind = "rigid" for thick panels, got "bars"'):
        with_values(letter(), {"facet.kind": "bars"})
