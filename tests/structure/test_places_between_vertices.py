"""Places on edges and facets of bending sheets: every place is a node, and the sheet is otherwise unchanged."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.design import load_design, with_values
from forficula.errors import InputError
from forficula.structure import built_points, measure_of, structure_of
from forficula.structure.sheets.facets import facet_triangles
from forficula.structure.sheets.sheet_measures import hinges_by_edge

MIURA = load_design("miura-sheet")
WAIT = {"name": "wait", "drive": "none", "until": "time", "hold": 0.0, "time_limit": 1.0}
SMALL = {"pattern.columns": 2, "pattern.rows": 2}
NOTHING = {"tendon": [], "support": [], "drive": [], "measure": [], "protocol.stages": [WAIT]}


def sheet(*places, **values):
    """Two by two parallelograms with a band from the first corner to each place."""
    bands = [
        {"name": f"band{number}", "from": "vertex 0", "to": place, "stiffness": 1.0, "rest_length": 0.01}
        for number, place in enumerate(places)
    ]
    return structure_of(with_values(MIURA, NOTHING | SMALL | {"tendon": bands} | values))


def area(structure):
    """Area of all triangles that are drawn, m^2."""
    corners = built_points(structure)[facet_triangles(structure)[0]]
    return np.linalg.norm(np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]), axis=1).sum() / 2


def crease_of(structure):
    """A crease between two facets."""
    return next(hinge.edge for hinge in structure.hinges if hinge.edge >= 0)


share = st.floats(0.01, 0.99)


@settings(max_examples=15, deadline=None)
@given(along=share, second=share, down=share, fold=st.floats(0, 2.5))
def test_splitting_changes_neither_mass_nor_area_nor_crease_stiffness(along, second, down, fold):
    folded = {"pattern.fold": fold}
    whole = sheet(**folded)
    crease = crease_of(whole)
    places = [f"crease {crease} at {along}", f"edge {crease} at {second}", "facet 3 at centre", f"edge 0 at {down}"]
    split = sheet(*places, **folded)
    assert sum(body.mass for body in split.bodies) == pytest.approx(sum(body.mass for body in whole.bodies))
    assert area(split) == pytest.approx(area(whole))
    for key in ("stiffness", "damping"):
        sums = [
            {
                edge: sum(getattr(structure.hinges[part], key) for part in parts)
                for edge, parts in hinges_by_edge(structure.hinges).items()
            }
            for structure in (split, whole)
        ]
        assert sums[0] == pytest.approx(sums[1])
    starts = [{hinge.edge: hinge.start for hinge in item.hinges if hinge.edge >= 0} for item in (split, whole)]
    assert starts[0] == pytest.approx(starts[1], abs=1e-6)


def test_a_place_is_where_the_sheet_is_as_built():
    structure = sheet("edge 0 at 0.25", "facet 1 at centre", "facet 1 at 0.5, 0.25")
    pattern = with_values(MIURA, NOTHING | SMALL).sheet
    coords = pattern.vertices_coords
    points = built_points(structure)
    on_edge, centre, within = (points[band.points[1]] for band in structure.tendons)
    tail, head = coords[pattern.edges_vertices[0]]
    assert on_edge == pytest.approx(0.75 * tail + 0.25 * head)
    corners = coords[list(pattern.faces_vertices[1])]
    assert centre == pytest.approx(corners.mean(axis=0))
    normal = np.cross(corners[1] - corners[0], corners[2] - corners[0])
    assert (within - corners[0]) @ normal == pytest.approx(0, abs=1e-12)


def test_both_parts_of_a_crease_are_driven_and_measured_as_one():
    crease = crease_of(sheet())
    measure = {"name": "gate", "kind": "fold-angle", "of": f"crease {crease}"}
    drive = {"name": "turn", "kind": "torque", "of": "creases", "value": 0.03}
    structure = sheet(f"crease {crease} at 0.25", drive=[drive], measure=[measure])
    gate = measure_of(structure, "gate").hinges
    assert [structure.hinges[hinge].edge for hinge in gate] == [crease] * 2
    (motor,) = structure.motors
    gains = dict(zip(motor.hinges, motor.gains, strict=True))
    assert sorted(gains[hinge] for hinge in gate) == pytest.approx([0.25, 0.75])
    assert sum(gains.values()) == pytest.approx(len(hinges_by_edge(structure.hinges)))


def test_a_place_at_a_vertex_is_that_vertex():
    structure = sheet("edge 0 at 1.0", "edge 0 at 0.9999999")
    assert len(structure.bodies) == 9
    assert {band.points[1] for band in structure.tendons} == {
        int(with_values(MIURA, NOTHING | SMALL).sheet.edges_vertices[0, 1])
    }


def test_a_facet_is_held_with_all_places_on_it():
    structure = sheet("facet 2 at 0.5, 0.6", support=[{"of": "facet 2"}])
    held = [body.name for body in structure.bodies if not body.slides]
    assert "place0" in held
    assert len(held) == 5


def test_a_force_acts_at_places():
    drive = {"name": "pull", "kind": "force", "of": ["edge 0 at 0.5", "vertex 3"], "direction": [0, 0, 1], "force": 1.0}
    structure = sheet(drive=[drive])
    assert [structure.points[point].name for point in structure.motors[0].points] == ["place0", "vertex3"]


@pytest.mark.parametrize(
    ("place", "message"),
    [
        ("facet 9 at centre", r"tendon\.0\.to: need a facet from 0 to 3, got 9"),
        ("facet 3 at 2, 1", r"tendon\.0\.to: need a place on facet 3"),
        ("middle", r"tendon\.0\.to: need a place such as"),
    ],
)
def test_an_invalid_place_is_refused(place, message):
    with pytest.raises(InputError, match=message):
        sheet(place)


def test_a_tendon_needs_two_places():
    band = {"name": "a", "from": "edge 0 at 0.5", "to": "edge 0 at 0.50", "stiffness": 1.0, "rest_length": 0.01}
    with pytest.raises(InputError, match=r"tendon\.0\.to: need another place than tendon\.0\.from"):
        sheet(tendon=[band])


def test_shares_in_a_vertical_facet_are_refused():
    with pytest.raises(InputError, match=r"tendon\.0\.to: need a facet that is not vertical"):
        sheet("facet 0 at 0.5, 0.5", **{"pattern.acute_angle": 0.5, "pattern.fold": np.pi - 1e-9})
