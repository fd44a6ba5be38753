"""Plates on the facets of a sheet: positions, hinges, drives, tendons and measures."""

import math

import numpy as np
import pytest

from forficula.design import design_frames, design_pattern, key_value, load_design, with_values
from forficula.pattern import folded_coordinates, write_fold
from forficula.structure import (
    built_points,
    drive_keys,
    goal_of,
    hinges_between,
    measure_of,
    state_of,
    structure_of,
    structure_warnings,
    tendon_arms,
    transition_of,
    with_protocol,
)
from tests.structures import supports

LETTER = load_design("letter-fold")
STAGE = {"hold": 0.0, "time_limit": 1.0}


def zigzag(**values):
    """Five panels, held in the middle."""
    changes = {"pattern.panels": 5, "pattern.panel_lengths": [0.1, 0.12, 0.08], "pattern.assignment": "MV"}
    changes |= {"support": [{"of": "facet 2"}], "tendon": [], "measure": []}
    stages = {"protocol.stages": [{"name": "wait", "drive": "none", "until": "time", **STAGE}]}
    return with_values(LETTER, changes | stages | values)


def point(structure, name):
    return built_points(structure)[[item.name for item in structure.points].index(name)]


def test_every_corner_lies_where_the_pattern_has_it():
    design = zigzag()
    structure, pattern = structure_of(design), design_pattern(design)
    for facet, corners in enumerate(pattern.faces_vertices):
        for vertex in corners:
            assert point(structure, f"facet{facet}_vertex{vertex}") == pytest.approx(pattern.vertices_coords[vertex])
    assert len(structure.plates) == 5
    assert structure.span == pytest.approx(0.52)
    # the heaviest plate: density times volume
    assert structure.mass == pytest.approx(1270 * 0.12 * 0.21 * 0.5e-3)


def test_plates_are_connected_to_the_held_plate():
    structure = structure_of(zigzag())
    assert supports(structure) == ["facet2"]
    parents = {body.name: body.parent for body in structure.bodies}
    assert parents["facet2"] == -1
    assert {name: structure.bodies[parent].name for name, parent in parents.items() if parent >= 0} == {
        "facet1": "facet2",
        "facet0": "facet1",
        "facet3": "facet2",
        "facet4": "facet3",
    }
    # every plate is hinged to the previous one in the order of bodies
    assert [hinge.name for hinge in structure.hinges] == ["crease1", "crease0", "crease2", "crease3"]
    assert [hinge.body for hinge in structure.hinges] == [1, 2, 3, 4]


def turned_points(structure, angles):
    """Positions of the points after the hinges rotate by angles in their folding senses."""
    origins, frames = [], []
    for number, body in enumerate(structure.bodies):
        origin, frame = (np.zeros(3), np.eye(3)) if body.parent < 0 else (origins[body.parent], frames[body.parent])
        origin, frame = origin + frame @ body.position, frame @ body.frame
        for hinge, angle in zip(structure.hinges, angles, strict=True):
            if hinge.body == number:
                x, y, z = hinge.axis
                cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
                turn = hinge.sense * angle
                frame = frame @ (np.eye(3) + math.sin(turn) * cross + (1 - math.cos(turn)) * cross @ cross)
        origins.append(origin)
        frames.append(frame)
    return np.array([origins[item.body] + frames[item.body] @ item.place for item in structure.points])


@pytest.mark.parametrize("held", range(5))
def test_folding_in_its_own_sense_is_folding_as_assigned(held):
    """With one angle at all hinges, the plates agree with the facets of the pattern's kinematics."""
    design = zigzag(support=[{"of": f"facet {held}"}])
    structure, pattern = structure_of(design), design_pattern(design)
    sizes = np.radians([20, 50, 110, 170])
    letters = pattern.edges_assignment[:4]
    signed = np.full(len(pattern.edges_assignment), np.nan)
    signed[:4] = [size if letter == "V" else -size for size, letter in zip(sizes, letters, strict=True)]
    folded = folded_coordinates(pattern, signed, fixed_face=held)
    fold_angles = [sizes[int(hinge.name.removeprefix("crease"))] for hinge in structure.hinges]
    for item, place in zip(structure.points, turned_points(structure, fold_angles), strict=True):
        vertex = int(item.name.partition("vertex")[2])
        assert place == pytest.approx(folded[vertex], abs=1e-14)


def test_springs_are_proportional_to_crease_length_and_groups_change_them():
    design = zigzag(
        **{
            "crease.stiffness": 0.5,
            "crease.damping": 0.01,
            "crease.group": [{"of": "mountains", "stiffness": 2.0}, {"of": "crease 2", "rest_angle": 0.3}],
        }
    )
    hinges = {hinge.name: hinge for hinge in structure_of(design).hinges}
    assert [hinges[f"crease{k}"].stiffness for k in range(4)] == pytest.approx([0.42, 0.105, 0.42, 0.105])
    assert [hinges[f"crease{k}"].rest_angle for k in range(4)] == [0, 0, 0.3, 0]
    assert [hinges[f"crease{k}"].damping for k in range(4)] == pytest.approx([0.0021] * 4)
    assert {hinge.role for hinge in hinges.values()} == {"crease"}


def test_a_tendon_is_never_longer_than_the_path_over_the_sheet():
    values = {"name": "across", "stiffness": 1.0, "rest_length": 0.0}
    far = {"from": "facet 0 at 0.1, 0.9", "to": "facet 4 at 0.8, 0.2"}
    near = {"from": "facet 3 at centre", "to": "facet 2 at 0.5, 0.1", "name": "near"}
    structure = structure_of(zigzag(tendon=[values | far, values | near]))
    across, one = structure.tendons
    rng = np.random.default_rng(1)
    lengths = []
    for _ in range(300):
        angles = rng.uniform(-math.pi, math.pi, 4)
        ends = turned_points(structure, angles)[list(across.points)]
        lengths.append(float(np.linalg.norm(ends[1] - ends[0])))
    assert max(lengths) <= across.longest
    # the straight line of the flat sheet, Pythagoras: panels of 10, 12, 8, 10, 12 cm
    assert across.longest == pytest.approx(math.hypot(0.01 - 0.4 - 0.8 * 0.12, 0.7 * 0.21), rel=1e-12)
    assert across.crossing is None
    assert [structure.hinges[hinge].name for hinge, _ in tendon_arms(structure, across)] == [
        f"crease{k}" for k in (1, 0, 2, 3)
    ]
    assert one.crossing is not None
    assert structure.hinges[one.crossing.hinge].name == "crease2"
    bodies = [structure.points[number].body for number in one.points]
    assert hinges_between(structure, *bodies) == (one.crossing.hinge,)


def test_flat_edges_join_facets_and_paths_continue_across_them(tmp_path):
    """A strip of three with a flat edge in place of a crease: two plates move as one."""
    pattern = design_pattern(LETTER)
    path = tmp_path / "sheet.fold"
    write_fold(pattern, path)
    path.write_text(path.read_text().replace('"V"', '"F"', 1).replace("180.0", "0.0", 1))
    tendon = {"name": "t", "from": "facet 0 at centre", "to": "facet 2 at centre", "stiffness": 1.0, "rest_length": 0.0}
    design = with_values(
        LETTER,
        {"pattern.kind": "fold-file", "pattern.path": str(path), "support": [], "tendon": [tendon]},
    )
    structure = structure_of(design)
    assert [hinge.name for hinge in structure.hinges] == ["crease1"]
    assert len(structure.bodies) == 3
    assert structure.tendons[0].crossing.hinge == 0
    assert structure.tendons[0].longest == pytest.approx(0.198)


def test_creases_that_the_same_drives_act_on_share_a_motor():
    drives = [
        {"name": "all", "kind": "torque", "of": "creases", "value": 1.0, "rise": 0.5},
        {"name": "hills", "kind": "torque", "of": "mountains", "value": -2.0},
        {"name": "one", "kind": "torque", "of": "crease 0", "value": 4.0},
    ]
    design = zigzag(drive=drives, **{"protocol.rise": 0.25})
    structure = structure_of(design)
    names = [[structure.hinges[hinge].name for hinge in motor.hinges] for motor in structure.motors]
    assert names == [["crease1", "crease3"], ["crease0"], ["crease2"]]
    assert [motor.name for motor in structure.motors] == ["crease1, crease3", "crease 0", "crease2"]
    assert [drive.strengths for drive in structure.drives] == [(1, 1, 1), (0, -2, -2), (0, 4, 0)]
    assert [drive.rise for drive in structure.drives] == [0.5, 0.25, 0.25]
    assert drive_keys(design) == ("drive.all.value", "drive.hills.value", "drive.one.value")
    for drive, key in zip(structure.drives, drive_keys(design), strict=True):
        assert (drive.key, drive.strength) == (key, key_value(design, key))
    assert [motor.name for motor in structure_of(LETTER).motors] == ["creases"]


def test_measures_are_valley_positive_and_goals_of_roles_count_in_their_sense():
    measures = [
        {"name": "hills", "kind": "fold-angle", "of": "mountains"},
        {"name": "gap", "kind": "distance", "from": "vertex 0", "to": "facet 4 at centre"},
    ]
    structure = structure_of(zigzag(measure=measures))
    hills = measure_of(structure, "hills")
    assert [structure.hinges[hinge].name for hinge in hills.hinges] == ["crease0", "crease2"]
    assert hills.signs == (-1, -1)
    assert measure_of(structure, "creases").signs == (1, 1, 1, 1)
    goal = goal_of(structure, "hills < -90 deg")
    # in its folding sense a mountain is beyond 90 deg then
    assert np.isfinite(goal.least).tolist() == [False, True, True, False, False]
    assert goal.least[[1, 2]] == pytest.approx(math.pi / 2)
    assert goal_of(structure, "creases > 90 deg").least[:4] == pytest.approx(math.pi / 2)
    assert goal_of(structure, "gap < 3 cm").most[4] == pytest.approx(0.03)


def test_states_and_transitions_come_from_the_stages_and_read_as_sentences():
    structure = structure_of(LETTER)
    assert [state.name for state in structure.states] == ["flat", "closed", "opened"]
    flat, closed = (goal_of(structure, state_of(structure, name).goal) for name in ("flat", "closed"))
    assert closed.least == pytest.approx([math.pi / 2] * 2 + [-math.inf])
    assert not np.isfinite(flat.least).any()
    assert state_of(structure, "closed").missed == "not closed"
    closing, opening = structure.transitions
    assert (closing.drive, closing.goal, closing.state) == ("close", "creases > 90 deg", "closed")
    assert (opening.drive, opening.goal, opening.state) == ("open", "creases < 0 deg", "opened")
    assert (closing.stage, opening.stage) == (1, 3)
    # for increasing angles the smallest one is furthest from the goal
    assert (closing.furthest, opening.furthest) == ("smallest", "largest")
    assert structure.stage_states == ("flat", "", "closed", "", "opened")
    assert goal_of(structure, closing.goal) is structure.goals[0]
    assert measure_of(structure, closing.measure) is not None
    assert transition_of(structure, "open") is opening
    words = closing.wording
    assert f"still {words.doing}" == "still getting closed"
    assert f"did not {words.verb}" == "did not get closed"
    assert f"did not stay {words.stays}" == "did not stay closed"
    assert (words.done, opening.wording.done) == ("closed", "closed and opened")


def test_a_stage_without_a_state_makes_no_transition():
    stages = [
        {"name": "push", "drive": "close", "until": "creases > 90 deg", **STAGE},
        {"name": "pull", "drive": "open", "until": "time", "state": "there", **STAGE},
    ]
    structure = structure_of(with_values(LETTER, {"protocol.stages": stages}))
    assert structure.transitions == ()
    assert [state.name for state in structure.states] == ["there"]


def test_another_protocol_on_the_same_plates():
    other = with_values(LETTER, {"drive.close.value": 1.0})
    structure = with_protocol(structure_of(LETTER), other)
    assert structure.drives[0].strengths == (1.0,)
    assert [drive.name for drive in structure.drives] == ["close", "open"]


@pytest.mark.parametrize(("first", "second", "size"), [(0.02, -0.03, 0.02), (0.0, -0.03, -0.03)])
def test_drives_of_one_stage_grow_together_for_all_combinations_of_strengths(first, second, size):
    both = {"protocol.stages.1.drive": ["close", "open"], "drive.close.value": first, "drive.open.value": second}
    structure = structure_of(with_values(LETTER, both))
    drive = structure.drives[-1]
    assert drive.name == "close and open"
    assert drive.strength == size
    assert drive.strengths == pytest.approx([first + second])


def test_a_folded_letter_is_written_as_frames():
    titles = [title for title, *_ in design_frames(LETTER)]
    assert titles == ["creases at 45 deg", "creases at 90 deg", "creases at 135 deg", "creases at 180 deg"]
    flat = design_frames(LETTER)[-1][1]
    assert np.ptp(flat[:, 0]) == pytest.approx(0.099)


def test_a_strip_gives_no_warnings():
    assert structure_warnings(LETTER, structure_of(LETTER)) == []
