"""Both folds beside a strip share the angles of the crease that they replace. Strips are plates, too."""

import math

import pytest

from forficula import InputError
from forficula.design import with_values
from forficula.design.sheets.sheet_creases import creases_of
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


def test_a_crease_by_a_number_of_its_edges_is_both_of_its_folds():
    """A group, a drive and a measure of the crease apply to the whole fold, whose second edge has another number."""
    group = '[[crease.group]]\nof = "crease 1"\nrest_angle = "60 deg"\nstiffness = "2e-3 N m/rad/m"'
    more = '[[drive]]\nname = "close"\nkind = "torque"\nof = "crease 1"\nvalue = "1 N m"\n'
    more += '[[measure]]\nname = "flap"\nkind = "fold-angle"\nof = "crease 1"'
    design = letter(group, more=more)
    structure = structure_of(design)
    both = [number for number, hinge in enumerate(structure.hinges) if design.sheet.edges_fold[hinge.edge] == 1]
    assert len(both) == 2
    last = structure.hinges[both[-1]].edge
    assert creases_of(design.sheet, f"crease {last}") == creases_of(design.sheet, "crease 1") == (1, last)
    assert [structure.hinges[number].rest_angle for number in both] == pytest.approx([math.radians(30)] * 2)
    assert structure.hinges[both[0]].stiffness == structure.hinges[both[1]].stiffness
    assert next(measure.hinges for measure in structure.measures if measure.name == "flap") == tuple(both)
    (drive,) = design.named_protocol.drives
    assert drive.actions[0].edges == tuple(structure.hinges[number].edge for number in both)


def test_a_bound_below_a_stop_at_zero_names_zero():
    stages = [{"name": "open", "until": "creases < -20 deg", "limit": "1 s"}]
    with pytest.raises(InputError, match=r"need a value >= 0 deg, got -20 deg"):
        letter(stages=stages)
