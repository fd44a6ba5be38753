"""Drives that displace points, with whatever force this takes."""

import numpy as np
import pytest

from forficula.design import load_design, with_values
from forficula.dynamics import compile_model, energy_balance, simulate, stable_timestep
from forficula.errors import InputError
from forficula.statics.net.driven.net_course import drive_course, drive_displacement, reaction
from forficula.statics.net.minimum import minimum
from forficula.statics.net.net_of import net_of, start_shape
from forficula.structure import structure_of

MIURA = load_design("miura-sheet")
SOFT = {
    "pattern.columns": 2,
    "pattern.rows": 2,
    "facet.kind": "bars",
    "facet.youngs_modulus": 1e6,
    "crease.damping": 1e-3,
    "tendon": [],
    "measure": [],
    "support": [{"of": "facet 0"}],
    "protocol.least_hold": 0.0,
    "protocol.timestep": 8e-5,
    "protocol.sample_interval": 1e-3,
}
LIFT = {
    "name": "lift",
    "kind": "displacement",
    "of": "vertex 8",
    "direction": [0, 0, 2],
    "distance": 4e-3,
    "rise": 0.05,
}


def stage(drive, limit):
    return {"name": f"{drive} {limit}", "drive": drive, "until": "time", "hold": 0.0, "time_limit": limit}


def sheet(*stages, **values):
    """Return two by two parallelograms, the first held."""
    return with_values(MIURA, SOFT | {"drive": [LIFT], "protocol.stages": list(stages)} | values)


def _without(key):
    """Return the drive without one of its keys."""
    return {name: value for name, value in LIFT.items() if name != key}


def moved(record, point, axis):
    """Return the distance of a point from its first position, m, (time,)."""
    places = record.series["point_position"][:, point, axis]
    return places - places[0]


def test_a_displaced_point_follows_its_target_and_is_released():
    (record,) = simulate([compile_model(sheet(stage("lift", 0.15), stage("none", 0.15)))])
    way, end = moved(record, 8, 2), record.stages[0].end
    held = (record.time > 0.1) & (record.time < end)
    assert way[held] == pytest.approx(4e-3, rel=0.01)
    # half of the displacement at half its rise, free at the end
    assert way[np.searchsorted(record.time, 0.025)] == pytest.approx(2e-3, rel=0.1)
    assert way[-1] < 1e-3
    assert energy_balance(record).residual < 5e-3
    work = record.series["motor_work"][:, 0]
    assert work[np.searchsorted(record.time, end)] > 0
    assert work[-1] == work[np.searchsorted(record.time, end + 1e-3)]


def test_a_displacement_starts_at_the_present_position():
    """Growing rest angles have lifted the point before: it does not return to its built position."""
    further = {"name": "further", "kind": "rest-angle", "of": "creases", "angle": 0.3, "rise": 0.05}
    both = sheet(stage("further", 0.1), stage(["further", "lift"], 0.15), drive=[further | {"rise": 0.0}, LIFT])
    (record,) = simulate([compile_model(both)])
    begin = np.searchsorted(record.time, record.stages[0].end)
    way = moved(record, 8, 2)
    assert abs(way[begin]) > 5e-4
    assert way[-1] - way[begin] == pytest.approx(4e-3, rel=0.03)


def test_a_sheet_that_is_taken_along_rests_where_it_does_by_statics():
    design = sheet(stage("lift", 0.3))
    structure = structure_of(design)
    net = net_of(structure)
    course = drive_course(structure, net, minimum(net, start_shape(structure, net)), structure.drives[0], None)
    (record,) = simulate([compile_model(design)])
    present = course.slow.points[-1].shape.positions
    assert present[8, 2] - net.nodes[8, 2] == pytest.approx(4e-3)
    apart = np.linalg.norm(record.series["point_position"][-1] - present, axis=1).max()
    assert apart < 1e-2 * 4e-3
    # it returns after its release
    assert course.rest.shape.positions == pytest.approx(net.nodes, abs=1e-5)


def test_the_work_of_a_displacement_is_force_times_travel_and_equals_that_of_statics():
    design = sheet(stage("lift", 0.3))
    structure = structure_of(design)
    net = net_of(structure)
    course = drive_course(structure, net, minimum(net, start_shape(structure, net)), structure.drives[0], None)
    (record,) = simulate([compile_model(design)])
    force, way = record.series["motor_force"][:, 0], moved(record, 8, 2)
    work = np.sum((force[1:] + force[:-1]) / 2 * np.diff(way))
    assert work == pytest.approx(record.series["motor_work"][-1, 0], rel=0.01)
    assert force[-1] == pytest.approx(course.largest_force, rel=1e-2)
    # the stored energy changes by the force times the displacement
    points = course.slow.points
    forces = [reaction(structure, net, course.drive, point.shape) for point in points]
    ways = [drive_displacement(structure, net, course.drive, point.shape) for point in points]
    stored = np.trapezoid(forces, ways)
    assert stored == pytest.approx(points[-1].energy - points[0].energy, rel=1e-3)


def test_drives_that_displace_nothing_have_no_force():
    further = {"name": "further", "kind": "rest-angle", "of": "creases", "angle": 0.3, "rise": 0.05}
    (record,) = simulate([compile_model(sheet(stage("further", 0.05), drive=[further, LIFT]))])
    assert np.isnan(record.series["motor_force"][:, 0]).all()
    assert np.abs(record.series["motor_force"][:, 1]).max() == 0
    (record,) = simulate([compile_model(sheet(stage("further", 0.01), drive=[further]))])
    assert "motor_force" not in record.series


def test_a_servo_shortens_the_longest_timestep():
    lifted, free = (stable_timestep(sheet(stage("none", 0.1), drive=drive)) for drive in ([LIFT], []))
    assert 0.4 * free < lifted < free


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"drive": [LIFT | {"force": 1.0}]}, r'drive\.0\.force: is not for kind = "displacement"'),
        ({"drive": [_without("distance")]}, r"drive\.0\.distance: is missing; needed here: .* distance, direction"),
        ({"drive": [_without("direction")]}, r"drive\.0\.direction: is missing"),
        ({"drive": [LIFT | {"direction": [0, 0, 0]}]}, r"drive\.0\.direction: need a direction that is not zero"),
        ({"drive": [LIFT], "facet.kind": "rigid", "support": []}, r'drive\.0\.kind: need "torque"'),
        ({"drive": [LIFT | {"of": "vertex 0"}]}, r"drive\.0\.of: need a vertex that is free along"),
    ],
)
def test_an_impossible_displacement_is_rejected(values, message):
    with pytest.raises(InputError, match=message):
        structure_of(sheet(stage("none", 0.1), **values))
