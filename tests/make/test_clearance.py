"""Planted collisions are found at their position and time, and angles of roots agree with closed forms."""

import math
from dataclasses import replace

import numpy as np
import pytest

from forficula.design import load_design
from forficula.dynamics import Record, StageEnd
from forficula.make.checks.motion_checks import built_checks, motion_checks, root_angles, root_moments
from forficula.make.flat.clearance import recorded_collisions
from forficula.make.hinge.free_range import half
from forficula.make.make_parts import make_parts
from forficula.make.solid.mesh import placed
from forficula.make.solid.poses import different_rows, poses_of
from forficula.pattern.rotation import rotation_about
from forficula.structure import built_points

# short straps, far from those of the next vein
APART = {
    "pattern.sector_angle": "28 deg",
    "tendon.proximal_attachment": "3 cm",
    "tendon.distal_attachment": "2.6 cm",
    "tendon.rest_length": "4 cm",
    "make.anchors": "on the bars",
}
ROWS = 401


@pytest.fixture(scope="module")
def parts():
    return make_parts(load_design("binder2025").with_values(APART), "section")


def record_of(parts, angles):
    """A record in which hinges turn evenly from 0 to the angles, by name, within a second of its first stage."""
    time, names = np.linspace(0.0, 1.0, ROWS), [hinge.name for hinge in parts.structure.hinges]
    turned = np.zeros((ROWS, len(names)))
    for name, angle in angles.items():
        turned[:, names.index(name)] = angle * time
    stage = parts.design.protocol.stages[0]
    end = StageEnd(stage=stage, start=0.0, end=1.0, goal_time=None, at_rest=True)
    return Record(
        design=parts.design,
        structure=parts.structure,
        time=time,
        series={"hinge_angle": turned},
        stages=(end,),
        diverged_at=None,
    )


def test_poses_reproduce_positions_of_the_run(reference_run):
    rows = [0, 320, 400, len(reference_run.time) - 1]
    poses, built = poses_of(reference_run, rows), built_points(reference_run.structure)
    bodies = [point.body for point in reference_run.structure.points]
    places = np.einsum("rpij,pj->rpi", poses.frames[:, bodies], built) + poses.origins[:, bodies]
    assert places == pytest.approx(reference_run.series["point_position"][rows], abs=1e-9)


def test_selected_rows_are_as_different_as_possible(reference_run):
    rows, angles = different_rows(reference_run, 20), reference_run.series["hinge_angle"]
    apart = np.abs(angles[rows][:, None] - angles[rows][None]).max(axis=2) + 10 * np.eye(len(rows))
    left = np.abs(angles[:, None] - angles[rows][None]).max(axis=2).min(axis=1)
    assert len(set(rows)) == 20
    assert left.max() <= apart.min()


def test_a_planted_collision_is_found_when_it_happens(parts):
    record = record_of(parts, {"sweep0": math.radians(40)})
    result = recorded_collisions(parts, record)
    # without culling, pieces and steps: the whole vein against the others, row by row
    origin = parts.structure.bodies[0].position
    others = [half(parts, body) for body in (2, 3)]
    moving = [half(parts, body) for body in (0, 1)]

    def touch(row):
        frame = rotation_about(np.array([0.0, 0.0, 1.0]), math.radians(40) * float(record.time[row]))
        swept = [placed(item, frame, origin - frame @ origin) for item in moving]
        return any((current ^ present).volume() > 1e-2 for current in swept for present in others)

    low, high = 0, ROWS - 1
    while high - low > 1:
        middle = (low + high) // 2
        low, high = (low, middle) if touch(middle) else (middle, high)
    assert result[0].time == pytest.approx(float(record.time[high]), abs=1e-9)
    assert result[0].stage == "settle"
    assert 0.1 < result[0].time < 0.9
    (check, *_) = motion_checks(parts, record, mend=False)
    assert check.ok is False
    assert check.part == " and ".join(result[0].bodies)
    assert check.value > check.limit


def test_nothing_touches_where_nothing_moves(parts):
    record = record_of(parts, {})
    assert recorded_collisions(parts, record) == ()
    checks = [check for check in motion_checks(parts, record) if check.name == "overlap in the recorded motion"]
    assert [check.ok for check in checks] == [True]


def test_overlaps_as_built_are_reported(parts, made_section):
    (check,) = built_checks(parts)
    assert (check.ok, check.value) == (True, 0.0)
    # straps of the design's own length, on distant pegs: those of neighbours collide
    (check,) = built_checks(made_section)
    assert check.ok is False
    assert "proximal0 and proximal2 (0.37" in check.text


def test_a_diverged_run_is_not_checked(parts):
    (check,) = motion_checks(parts, replace(record_of(parts, {}), diverged_at=0.5))
    assert check.ok is None


def test_motion_beyond_a_stop_is_reported(parts):
    record = record_of(parts, {"fold1": parts.joints[1].upper + math.radians(2.5)})
    checks = {check.part: check for check in motion_checks(parts, record, mend=False) if "stops" in check.name}
    assert [checks[name].ok for name in ("fold0", "fold1", "fold2")] == [True, False, True]
    assert checks["fold1"].value == pytest.approx(math.radians(2.5))


def test_a_root_bends_and_turns_as_far_as_its_hinges_do(parts):
    record = record_of(parts, {"lift1": math.radians(-25), "turn1": math.radians(80)})
    bend, turn = root_angles(record, parts.roots[1])
    assert np.degrees([bend, turn]) == pytest.approx([25.0, 80.0])


def test_a_root_takes_the_moments_of_its_closed_forms(parts):
    root = parts.roots[0]
    # tpu-95a, 12.3 MPa; 4 mm thick, 10 mm long
    second = math.pi * 4e-3**4 / 64
    bending, twisting = root_moments(root, 1.0, 1.0)
    assert bending == pytest.approx(12.3e6 * second / 10e-3)
    assert twisting == pytest.approx(12.3e6 / 3 * 2 * second / 10e-3)
