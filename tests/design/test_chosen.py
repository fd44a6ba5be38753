"""Values that a design of a sheet leaves out: the rules that choose them, and their form in the file."""

import math
import tomllib

import numpy as np
import pytest

from forficula.design import design_from_text, design_text, in_units, load_design, scale_design, with_values
from forficula.design.sheets.crease_sections import Crease
from forficula.design.sheets.sheet_sections import FacetSection
from forficula.structure import structure_of

MIURA = load_design("miura-sheet")
CLASP = load_design("bistable-clasp")
# a design of a Miura sheet without values for its card and its creases
NOTHING = MIURA.model_copy(update={"facet": FacetSection(), "crease": Crease()})


def chosen(design):
    return {f"{choice.section}.{choice.key}": choice.value for choice in design.chosen}


def test_values_in_the_file_are_not_chosen():
    assert not {"facet.thickness", "facet.density", "crease.stiffness", "crease.damping"} & chosen(MIURA).keys()
    assert chosen(with_values(MIURA, {"facet.youngs_modulus": 1e9})).keys() < chosen(MIURA).keys()
    rigid = load_design("letter-fold")
    assert rigid.chosen == ()
    assert rigid.settled() == rigid


def test_a_crease_is_as_soft_as_a_plate_of_a_hundred_thicknesses():
    """D / L* with D = E t^3 / (12 (1 - nu^2)) (Lechenault, Thiria and Adda-Bedia 2014)."""
    values = chosen(NOTHING)
    thickness = math.sqrt(0.02**2 * math.sin(math.radians(60))) / 100
    assert values["facet.thickness"] == pytest.approx(thickness)
    plate = 2e9 * thickness**3 / (12 * (1 - 0.3**2))
    assert values["crease.stiffness"] == pytest.approx(plate / (100 * thickness))


def test_bars_are_stiff_beside_creases_of_a_given_stiffness():
    """EA = 1e4 k, with the stiffness per length of the stiffest crease and the mean area per length of the bars."""
    design = with_values(MIURA, {"crease.group": [{"of": "role:zigzag", "stiffness": 0.05}]})
    structure = structure_of(design)
    lengths = np.array([spring.rest_length for spring in structure.springs])
    axial = np.array([spring.stiffness for spring in structure.springs]) * lengths
    assert (axial * lengths).sum() / lengths.sum() == pytest.approx(1e4 * 0.05)


def test_chosen_values_are_marked_with_a_reason_and_read_back_to_the_bit():
    text = design_text(NOTHING)
    lines = {line.split(" = ")[0]: line for line in text.splitlines() if "# [chosen] " in line}
    assert {f"{section}.{key}" for section in ("facet", "crease") for key in lines} >= chosen(NOTHING).keys()
    again = design_from_text(text)
    assert again == NOTHING.settled()
    assert again.hash == NOTHING.hash
    assert again.chosen == ()
    # a value of the file is not marked
    assert "[chosen]" not in design_text(again)
    assert tomllib.loads(text) == tomllib.loads(design_text(again))


def test_chosen_values_follow_those_that_they_follow_from():
    thick = with_values(NOTHING, {"facet.thickness": 1e-3})
    assert chosen(thick)["crease.stiffness"] > chosen(NOTHING)["crease.stiffness"]
    assert thick.hash != NOTHING.hash


def test_chosen_values_convert_to_other_units():
    present = in_units(NOTHING, length=1e-2, mass=1e-3, time=1e-2)
    assert present.chosen == ()
    assert present.facet.thickness == pytest.approx(100 * NOTHING.settled().facet.thickness)


def test_a_sheet_of_twice_the_size_has_similar_motion():
    """Chosen values scale with the sheet: stiffness per length with the square of the size."""
    large = scale_design(NOTHING, 2.0)
    assert large.crease.stiffness == pytest.approx(4 * NOTHING.settled().crease.stiffness)
    assert large.facet.youngs_modulus == pytest.approx(NOTHING.settled().facet.youngs_modulus)


@pytest.mark.parametrize("turn", [0.3, 2.0])
def test_turning_a_sheet_changes_nothing_that_is_chosen(turn):
    sheet = MIURA.sheet
    cos, sin = math.cos(turn), math.sin(turn)
    coords = sheet.vertices_coords @ np.array([[cos, sin, 0], [-sin, cos, 0], [0, 0, 1]])
    values = {f"vertices_{axis}": column for axis, column in zip("xyz", coords.T.tolist(), strict=True)}
    values |= {"kind": "fold-file", "edges": sheet.edges_vertices.tolist(), "roles": list(sheet.edges_role)}
    values |= {"assignment": "".join(sheet.edges_assignment), "facets": [list(face) for face in sheet.faces_vertices]}
    assert chosen(with_values(MIURA, {"pattern": values})) == pytest.approx(chosen(MIURA))
