"""Positions of arrows of drives and of rods along fixed parts, for any structure."""

import numpy as np
import pytest

from forficula.design import load_design, with_values
from forficula.dynamics import compile_model, simulate
from forficula.show.page.data.shape_mesh import fixed_rods, shape_mesh
from forficula.show.page.parts.efforts import crease_ends, efforts_data, efforts_of
from forficula.structure import built_points, structure_of
from forficula.structure.sheets.flaps import flap_angles
from tests.statics.test_tree_springs import FOUR_DESIGN


def test_arrows_of_torques_follow_the_axes_of_their_hinges(short_run):
    rows = np.arange(len(short_run.time))
    efforts = efforts_of(short_run, rows)
    assert [drive.name for drive in efforts.drives] == ["fold", "unfold"]
    ends = {end.stage.name: (end.start, end.end) for end in short_run.stages}
    assert efforts.stages == ((*ends["fold"], (0,)), (*ends["unfold"], (1,)))
    structure, points = short_run.structure, short_run.series["point_position"]
    # the rigid outer part of a vein keeps its angle to the axis about which it turns, wherever it is
    distal = [turn for turn in efforts.turns if turn.shares == (0.0, 1.0)]
    motor = next(motor for motor in structure.motors if motor.name == "distal")
    for turn, hinge in zip(distal, motor.hinges, strict=True):
        bar = next(bar for bar in structure.bars if bar.body == structure.hinges[hinge].body)
        root, tip = (points[np.isin(short_run.time, efforts.time)][:, point] for point in bar.points)
        assert turn.pivot == pytest.approx(root, abs=1e-9)
        assert np.ptp(np.sum(turn.axis * (tip - root), axis=1)) < 1e-9
        assert np.ptp(tip - root, axis=0).max() > 0.1


def test_the_torque_on_a_joint_has_an_arrow_although_another_crease_opens():
    stage = {"name": "push", "drive": "trigger", "until": "time", "time_limit": 5e-3}
    quick = {"protocol.timestep": 5e-5, "crease.damping": 1e-4, "protocol.stages": [stage]}
    (record,) = simulate([compile_model(with_values(FOUR_DESIGN, quick))])
    (turn,) = efforts_of(record, np.arange(len(record.time))).turns
    names = [point.name for point in record.structure.points]
    (tip,) = (number for number, name in enumerate(names) if name == "facet2_vertex3")
    along = record.series["point_position"][-1, tip]
    # crease 2 runs from the vertex at the origin to vertex 3
    assert np.cross(turn.axis[-1], along) == pytest.approx(np.zeros(3), abs=1e-6)
    assert turn.pivot[-1] == pytest.approx(along / 2, abs=1e-6)


def test_a_page_has_drives_in_the_units_of_its_other_numbers(letter_run):
    rows = np.array([0, 1])
    data = efforts_data(efforts_of(letter_run, rows), shape_mesh(letter_run.structure).anchors)
    (close, _) = data["drives"]
    assert (close["text"], close["unit"], close["factor"]) == ("torque on the creases", "N cm", 100.0)
    assert len(data["turns"]) == 2


def test_a_right_handed_turn_of_the_left_flap_about_a_creases_arrow_folds_it_in_its_own_sense():
    structure = structure_of(load_design("bistable-clasp"))
    points, turned = built_points(structure), 1e-3
    for hinge in structure.hinges:
        tail, head = points[list(crease_ends(hinge))]
        corners = points[list(hinge.flaps)]
        axis = (head - tail) / np.linalg.norm(head - tail)
        moved = corners.copy()
        moved[2] += turned * np.cross(axis, corners[2] - tail)
        angles = [hinge.sense * float(flap_angles(item)) for item in (corners, moved)]
        assert angles[1] - angles[0] == pytest.approx(turned, rel=1e-2)


@pytest.mark.parametrize(("name", "rods"), [("binder2025", 2), ("letter-fold", 4), ("kresling-cell", 0)])
def test_rods_are_drawn_along_fixed_parts(name, rods):
    structure = structure_of(load_design(name))
    result = fixed_rods(structure)
    assert result.shape == (rods, 2, 3)
    away = np.linalg.norm(result.reshape(-1, 1, 3) - built_points(structure), axis=2).min(axis=1, initial=np.inf)
    assert np.all(away < 1e-9)
