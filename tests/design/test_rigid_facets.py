"""Refusals of sheets of rigid facets, and their reasons."""

import math
import re

import numpy as np
import pytest

from forficula.design import load_design, with_values
from forficula.errors import InputError
from forficula.structure import built_lengths, structure_of
from tests.plate_sheets import miura, plates, pleats, vertex

BARS = r'or take facet\.kind = "bars", whose facets bend'
OPENS = 'extension = "1e4 N/m^2"'


def refused(match, pattern, **more):
    with pytest.raises(InputError, match=match):
        plates(pattern, **more)


def test_an_octahedron_does_not_fold_and_bars_are_offered():
    """Cauchy 1813: convex polyhedra are rigid."""
    corners = [(1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)]
    ring = [(number, (number + 1) % 4) for number in range(4)]
    facets = [[*pair, 4] for pair in ring] + [[two, one, 5] for one, two in ring]
    edges = [*map(list, ring), *([rim, pole] for rim in range(4) for pole in (4, 5))]
    coords = "\n".join(
        f"vertices_{axis} = {[f'{corner[place]} cm' for corner in corners]}" for place, axis in enumerate("xyz")
    )
    sheet = f'kind = "fold-file"\n{coords}\nedges = {edges}\nassignment = "{"U" * 12}"\nfacets = {facets}\n'
    refused(rf"as built it has 0 degrees of freedom and 0 states of self-stress; {BARS}", sheet)


def test_a_closed_kresling_cell_folds_only_by_bending_wherever_it_is_held():
    cell = load_design("kresling-cell")
    with pytest.raises(InputError, match=rf"0 degrees of freedom and 6 states of self-stress; {BARS}"):
        with_values(cell, {"facet.kind": "rigid", "pattern.end_plates": True})


def test_a_waterbomb_with_one_crease_of_the_wrong_sense_does_not_fold_rigidly():
    sectors = [45, 90, 45, 45, 90, 45]
    assert structure_of(plates(vertex(sectors, "MVVMVV"))).closures
    why = rf"around vertex 0 it has 0 degrees of freedom in which every crease folds as assigned; {BARS}"
    refused(why, vertex(sectors, "MMVMVV"))
    refused(why, vertex(sectors, "MMMMMM"))


def test_creases_that_may_bend_back_have_no_sense_to_fold_in():
    design = plates(vertex([90, 90, 90, 90], "MMMM"), crease='back_limit = "180 deg"')
    assert len(structure_of(design).closures) == 1
    refused("0 degrees of freedom", vertex([90, 90, 90, 90], "MMMM"))


def test_unassigned_creases_fold_in_both_senses():
    structure = structure_of(plates(vertex([60, 90, 120, 90])))
    assert {(hinge.lower, hinge.upper) for hinge in structure.hinges} == {(-math.pi, math.pi)}


def test_facets_that_are_not_flat_are_refused():
    corners = 'vertices_x = ["0 cm", "1 cm", "1 cm", "0 cm", "2 cm", "2 cm"]\n'
    corners += 'vertices_y = ["0 cm", "0 cm", "1 cm", "1 cm", "0 cm", "1 cm"]\n'
    corners += 'vertices_z = ["0 cm", "0 cm", "0 cm", "2 mm", "0 cm", "0 cm"]\n'
    sheet = f'kind = "fold-file"\n{corners}edges = [[0, 1], [1, 2], [2, 3], [3, 0], [1, 4], [4, 5], [5, 2]]\n'
    sheet += 'assignment = "BVBBBBB"\nfacets = [[0, 1, 2, 3], [1, 4, 5, 2]]\n'
    refused(rf"need flat facets to be rigid, got facet 0, which is not; {BARS}", sheet)


def test_starts_at_which_the_facets_do_not_meet_are_refused():
    refused(
        "crease.start: need angles at which the facets meet",
        vertex([60, 90, 120, 90], "MVVV"),
        crease='start = "10 deg"',
    )


def test_a_sheet_that_is_built_folded_starts_in_that_shape():
    assert [hinge.start for hinge in structure_of(plates(miura(2))).hinges] == [
        hinge.built for hinge in structure_of(plates(miura(2))).hinges
    ]
    refused("crease.start: need 0 deg for a sheet that starts as built, got 5 deg", miura(2), crease='start = "5 deg"')
    refused(r"pattern: need >= 0 deg .* <= 20 deg .* at crease \d+, got", miura(2), crease='fold_limit = "20 deg"')


def test_creases_open_between_rigid_facets_only():
    refused('crease.extension: is for facet.kind = "rigid"', miura(2), crease=OPENS, facet='kind = "bars"')


def test_a_loop_opens_somewhere_or_nowhere():
    group = f'[[crease.group]]\nof = "crease 0"\n{OPENS}'
    structure = structure_of(plates(vertex([87.5] * 4), more=group))
    assert (len(structure.closures), len(structure.springs)) == (0, 3)
    refused("need a crease that opens in every loop, or in none", miura(3), more=group.replace("crease 0", "crease 4"))


def test_only_one_of_connected_facets_is_a_base_where_creases_open():
    two = '[[support]]\nof = "facet 0"\n[[support]]\nof = "facet 1"'
    opening = f'{two}\n[[crease.group]]\nof = "crease 1"\n{OPENS}'
    refused("support: facet 1 is connected to another facet that is held", pleats(3, "VM"), more=opening)
    assert structure_of(plates(pleats(3, "VM"), crease=OPENS, more=two)).bodies[2].turns


def test_further_supports_of_hinged_facets_hold_points():
    more = (
        '[[support]]\nof = "facet 0"\n[[support]]\nof = "edge 3"\naxes = "yz"\n[[support]]\nof = "vertex 7"\naxes = "z"'
    )
    structure = structure_of(plates(pleats(3, "VM"), more=more))
    assert [hold.axis.tolist().index(1) for hold in structure.holds] == [1, 2, 1, 2, 2]
    assert not structure.bodies[0].turns
    assert structure_of(plates(pleats(3, "VM"), more=more[more.index("\n[[") :])).bodies[0].turns


def test_forces_act_on_plates_that_open_and_not_on_hinged_ones():
    drive = '[[drive]]\nname = "push"\nkind = "force"\nof = "facet 1 at centre"\nvalue = "1 N"\ndirection = [0, 0, 1]'
    refused('need "torque" where facets are hinged, got "force"', miura(2), more=drive)
    structure = structure_of(plates(pleats(2, "V"), crease=OPENS, more=drive))
    assert structure.points[structure.motors[0].points[0]].body == 1
    refused(
        "drive.0.of: need a facet from 0 to 1, got 7",
        pleats(2, "V"),
        crease=OPENS,
        more=drive.replace("facet 1", "facet 7"),
    )


def test_the_message_names_no_key_twice():
    with pytest.raises(InputError) as caught:
        plates(vertex([90, 90, 90, 90], "MMMM"))
    assert len(re.findall("facet.kind", str(caught.value))) == 2


def test_places_on_facets_lie_on_them_where_the_sheet_is_built_folded():
    tendon = '[[tendon]]\nname = "t"\nfrom = "facet 0 at centre"\nto = "facet 3 at 0.5, 0.5"\n'
    tendon += 'stiffness = "1 N/cm"\nrest_length = "1 cm"'
    design = plates(miura(2, "80 deg"), more=tendon)
    sheet = design.sheet
    # the mean of the corners of parallelograms
    one, other = (sheet.vertices_coords[list(sheet.faces_vertices[facet])].mean(axis=0) for facet in (0, 3))
    assert built_lengths(structure_of(design)) == pytest.approx([np.linalg.norm(other - one)], rel=1e-12)
