"""Plates that pass through each other: which ones and from when, for given positions and for a run."""

from dataclasses import replace
from time import process_time

import numpy as np
import pytest

from forficula.analysis import run_warnings
from forficula.analysis.crossing_facets import crossing_facets, facets_that_cross
from forficula.design import design_pattern, load_design
from forficula.dynamics import Record
from forficula.pattern import folded_coordinates
from forficula.structure import GROUND, Body, Plate, Point, Structure, built_points, structure_of
from forficula.study.running.runs import run


def strip(letters, *angles):
    """Return a record of a strip of panels: a row every 10 ms, each with one angle of all creases, deg."""
    values = {"pattern.panels": len(letters) + 1, "pattern.assignment": letters}
    nothing = {"tendon": [], "measure": [], "support": [], "drive": []}
    stages = [{"name": "rest", "drive": "none", "until": "time", "hold": "0 s", "time_limit": "1 s"}]
    design = load_design("letter-fold", values | nothing | {"protocol.stages": stages})
    structure, pattern = structure_of(design), design_pattern(design)
    signs = np.array([{"V": 1.0, "M": -1.0}.get(letter, np.nan) for letter in pattern.edges_assignment])
    vertices = [int(point.name.partition("vertex")[2]) for point in structure.points]
    places = np.array([folded_coordinates(pattern, np.radians(angle) * signs)[vertices] for angle in angles])
    time = 0.01 * np.arange(len(angles))
    return Record(
        design=design,
        structure=structure,
        time=time,
        series={"point_position": places},
        stages=(),
        diverged_at=None,
    )


def names(record):
    """Return the names of the bodies whose plates cross, and from when."""
    return [(*(name.replace(" ", "") for name in facet.names), facet.time) for facet in facets_that_cross(record)]


def test_two_plates_that_cross_are_named_with_the_first_time():
    assert names(strip("VV", 0, 100, 122, 140, 90)) == [("facet0", "facet2", 0.02)]


@pytest.mark.parametrize(
    ("letters", "angle"),
    [("VV", 120), ("VVV", 90), ("VM", 180), ("VV", 180), ("VM", 179), ("V", 170)],
    ids=["edges meet", "a box", "on one another", "rolled up", "nearly on one another", "hinged"],
)
def test_plates_that_touch_or_lie_on_one_another_do_not_cross(letters, angle):
    assert facets_that_cross(strip(letters, 0, angle)) == []


@pytest.mark.parametrize(("place", "crosses"), [(1.5, False), (0.5, True), (3.5, False)])
def test_a_plate_may_pass_through_the_gap_of_one_that_is_not_convex(place, crosses):
    around = [(0, 0), (3, 0), (3, 3), (2, 3), (2, 1), (1, 1), (1, 3), (0, 3)]
    level = np.column_stack([np.array(around, dtype=float), np.zeros(8)])
    upright = np.array([(place - 0.2, 2, -1), (place + 0.2, 2, -1), (place + 0.2, 2, 1), (place - 0.2, 2, 1)])
    corners = np.concatenate([level, upright])
    bodies = [
        Body(name=f"facet{body}", role="facet", parent=GROUND, position=np.zeros(3), frame=np.eye(3)) for body in (0, 1)
    ]
    points = [Point(name=f"p{k}", role="corner", body=int(k > 7), place=corner) for k, corner in enumerate(corners)]
    plates = [
        Plate(body=body, points=tuple(numbers), thickness=1e-3, density=1.0)
        for body, numbers in enumerate((range(8), range(8, 12)))
    ]
    structure = Structure(
        name="gap", bodies=tuple(bodies), points=tuple(points), plates=tuple(plates), hinges=(), span=3.0, mass=1.0
    )
    record = replace(strip("V", 0), structure=structure, series={"point_position": corners[None]})
    assert bool(facets_that_cross(record)) is crosses


def test_a_letter_that_closes_too_fast_passes_through_itself_and_the_example_does_not():
    fast, letter = (run(load_design("letter-fold", more)) for more in ({"crease.damping": "5e-3 N m s/rad/m"}, {}))
    (warning,) = run_warnings(fast)
    crossing = "facet 0 and facet 2 pass through each other from 0.444 s"
    assert warning == f"{crossing}: contact is switched off; protocol.contact = true keeps them apart"
    assert np.degrees(letter.measured("creases")).max() < 115
    assert run_warnings(letter) == []


@pytest.fixture(scope="module")
def sheet():
    """Return a Miura sheet of nodes, and the positions of its vertices."""
    structure = structure_of(load_design("miura-sheet"))
    return structure, built_points(structure)


@pytest.mark.parametrize(("angle", "crosses"), [(179, False), (184, False), (200, True), (-200, True)])
def test_facets_of_a_sheet_that_fold_through_each_other_at_their_crease_are_named(sheet, angle, crosses):
    structure, places = sheet
    crease = next(number for number, hinge in enumerate(structure.hinges) if hinge.edge >= 0 and hinge.flaps)
    angles = np.zeros((3, len(structure.hinges)))
    angles[1:, crease] = np.radians(angle)
    series = {"point_position": np.repeat(places[None], 3, axis=0), "hinge_angle": angles}
    record = replace(strip("V", 0), structure=structure, series=series, time=np.array([0.0, 0.1, 0.2]))
    ends = set(structure.hinges[crease].flaps[:2])
    beside = [facet.name for facet in structure.facets if ends <= set(facet.points)]
    assert names(record) == ([(*beside, 0.1)] if crosses else [])


def test_facets_of_a_sheet_that_share_a_side_or_a_corner_do_not_cross(sheet):
    structure, places = sheet
    assert crossing_facets(structure, places) == []


def test_a_facet_whose_corner_goes_through_another_facet_is_named(sheet):
    structure, places = sheet
    corner, target = structure.facets[0].points[0], structure.facets[5]
    middle = places[list(target.points)].mean(axis=0)
    one, two, three = places[list(target.points[:3])]
    normal = np.cross(two - one, three - one)
    moved = places.copy()
    moved[corner] = middle + 0.2 * normal / np.sqrt(np.linalg.norm(normal))
    others = crossing_facets(structure, moved)
    moved[corner] = middle - 0.2 * normal / np.sqrt(np.linalg.norm(normal))
    # on one of the two sides it passes through
    assert ("facet 0", "facet 5") in [*others, *crossing_facets(structure, moved)]


def test_many_facets_over_many_rows_are_checked_in_seconds():
    design = load_design("miura-sheet", {"pattern.columns": 16, "pattern.rows": 16, "measure": []})
    structure = structure_of(design)
    places = np.repeat(built_points(structure)[None], 400, axis=0)
    record = replace(strip("V", 0), structure=structure, series={"point_position": places}, time=np.linspace(0, 1, 400))
    started = process_time()
    assert facets_that_cross(record) == []
    assert process_time() - started < 10
