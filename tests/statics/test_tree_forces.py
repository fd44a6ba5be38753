"""Forces at points of bodies on joints in a tree: derivatives, closed forms, work, and the order of two snaps."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import brentq, minimize_scalar

from forficula.design import load_design, with_values
from forficula.dynamics import compile_model, energy_balance, simulate
from forficula.statics import energy_landscape, landscape_summary
from forficula.statics.net.driven.net_rest import net_rest_path
from forficula.statics.survey import stage_rest_path
from forficula.statics.tree.ensemble import ensemble, start_angles
from forficula.statics.tree.pose import pose, tree_of
from forficula.statics.tree.potential import hinge_angles, potential, rest
from forficula.statics.tree.quasi_static import start_state
from forficula.statics.tree.saddle import level_between
from forficula.statics.tree.tree_path import place_positions, tree_path
from forficula.statics.tree.tree_rest import tree_rest_path
from forficula.structure import Drive, GrowingLoad, Motor, RestShape, StageGoal, structure_of
from tests.plate_sheets import strip
from tests.statics.test_potential import check_derivatives
from tests.statics.trees import tree, unit

STIFFNESS = 0.05  # N m/rad


def slow_path(structure, start, before, after):
    """Return the equilibria from angles of all hinges on, under settings of motors that grow evenly."""
    joints = np.array([start])
    at, count = pose(tree_of(structure), joints), len(structure.bodies)
    points = place_positions(structure, joints)[0][: len(structure.points)]
    shape = RestShape(angles=np.array(start), points=points, origins=at.origins[0, :count], frames=at.frames[0, :count])
    none = np.full(len(structure.hinges), np.inf)
    load = GrowingLoad(
        before=np.array(before, dtype=float),
        after=np.array(after, dtype=float),
        begin=0.0,
        goal=StageGoal(name="time", kind="time", least=-none, most=none),
        built_on=points,
        rest_speed=math.radians(2),
        duration=1.0,
    )
    return stage_rest_path(structure, shape, load)


@settings(deadline=None, max_examples=20)
@given(st.integers(0, 10_000))
def test_slope_and_curvature_under_forces_are_the_derivatives_of_the_potential(seed):
    random = np.random.default_rng(seed)
    built = tree(seed, 5, gravity=9.81, limit=100.0)
    numbers = random.integers(0, len(built.points), 3).tolist()
    motors = (
        Motor(name="torque", hinges=(0,)),
        Motor(name="one", kind="force", points=(numbers[0],), direction=unit(random)),
        Motor(name="two", kind="force", points=(numbers[1], numbers[2]), direction=unit(random)),
    )
    structures, strengths = ensemble([replace(built, motors=motors)]), np.array([0.1, 20.0, -15.0])
    angles = random.uniform(-1, 1, (1, structures.size))
    check_derivatives(structures, angles, strengths)
    # the potential falls by the work of the forces, from positions of points that statics of drags use as well
    at = np.concatenate([angles, np.zeros_like(angles)])
    moved = -np.diff(place_positions(built, at), axis=0)[0]
    fallen = [potential(structures.repeated(2), at, load)[0] for load in (np.zeros(3), strengths * [0, 1, 1])]
    work = sum(
        strength * float(moved[list(motor.points)].sum(axis=0) @ motor.direction)
        for motor, strength in zip(motors[1:], strengths[1:], strict=True)
    )
    assert -np.diff(fallen[0] - fallen[1])[0] == pytest.approx(work, abs=1e-9)


def pushed_plate():
    """Return a plate of 10 cm on a sprung hinge whose far corner a motor pushes up, and its joint."""
    plain = structure_of(strip(2, **{"crease.stiffness": STIFFNESS, "crease.rest_angle": 0.0}))
    (joint,) = plain.hinges
    heights = place_positions(plain, np.array([[0.1]]))[0, :, 2]
    motor = Motor(name="push", kind="force", points=(int(heights.argmax()),), direction=np.array([0.0, 0.0, 1.0]))
    return replace(plain, motors=(motor,)), joint


def test_a_plate_on_a_sprung_hinge_bends_under_a_dead_force_as_in_closed_form():
    """The torque k angle balances F L cos(angle), and the work of the force is the energy of the spring."""
    built, joint = pushed_plate()
    structures, length = ensemble([built]), 0.1
    for force in (0.01, 0.1, 1.0):
        known = brentq(lambda angle, force=force: joint.stiffness * angle - force * length * math.cos(angle), 0, 1.57)
        assert rest(structures, start_angles(structures), [force]).position[0, 0] == pytest.approx(known, abs=1e-6)
    path = slow_path(built, [0.0], [0.0], [1.0])
    assert path.ended == "full"
    assert path.shapes[-1].angles[0] == pytest.approx(known, abs=1e-11)
    assert path.work[-1, 0] == pytest.approx(joint.stiffness * known**2 / 2, abs=1e-9 * length)
    drive = Drive(name="push", shares=(1.0,), rise=0.0, key="", strength=1.0)
    followed = tree_path(replace(built, drives=(drive,)), drive, None, error=1e-3)
    assert [mark.kind for mark in followed.marks] == ["goal"]
    assert followed.angles[-1, 0] == pytest.approx(known, abs=1e-6)


# the named design two-clasps, from its file
NEAR, FAR, BAND, SPRING, RESTS = 0.03, 0.04, 0.05, 0.02, math.radians(30)
INNER, OUTER = 800.0, 200.0  # N/m
SHUT, OPEN = math.radians(60), -math.radians(30)
CLOSED, HALF_OPEN, BOTH_OPEN = [SHUT, SHUT], [SHUT, OPEN], [OPEN, OPEN]
PULL, PRESS = np.array([1.0, 0.0]), np.array([0.0, -1.0])
SMALL = 1e-6


def stored(inner, outer):
    """Return the energy of two hinge springs and two bands."""
    energy = 0.0
    for angle, stiffness in ((inner, INNER), (outer, OUTER)):
        stretch = math.sqrt(NEAR**2 + FAR**2 + 2 * NEAR * FAR * math.cos(angle)) - BAND
        energy += stiffness / 2 * max(stretch, 0.0) ** 2 + SPRING / 2 * (angle - RESTS) ** 2
    return energy


def end(inner, outer):
    """Return the end of the outer clasp behind the inner hinge."""
    return np.array(
        [
            (FAR + NEAR) * math.cos(inner) + FAR * math.cos(inner + outer),
            (FAR + NEAR) * math.sin(inner) + FAR * math.sin(inner + outer),
        ]
    )


def needed(angles, hinge, direction):
    """Return the force in a direction at which the moment about a hinge vanishes; inf if the force cannot open it."""
    ends = [np.array(angles) + sign * SMALL * np.eye(2)[hinge] for sign in (-1, 1)]
    moment = np.diff([stored(*at) for at in ends])[0]
    lever = np.diff([end(*at) @ direction for at in ends])[0]
    return moment / lever if lever < 0 else math.inf


def limit(angles, hinge, direction):
    """Return the largest force that a hinge withstands on its way open while the other one is on its stop."""

    def at(angle):
        return [angle if number == hinge else angles[number] for number in range(2)]

    scanned = np.linspace(SHUT, math.radians(5), 400)
    top = int(np.argmax([needed(at(angle), hinge, direction) for angle in scanned]))
    around = scanned[min(top + 1, 399)], scanned[max(top - 1, 0)]
    highest = minimize_scalar(
        lambda angle: -needed(at(angle), hinge, direction), bounds=around, method="bounded", options={"xatol": 1e-9}
    )
    return max(-highest.fun, needed(at(SHUT), hinge, direction))


def first_snap():
    """Return the pull that opens the outer clasp, and the pull at which the inner one begins to open."""
    return limit(CLOSED, 1, PULL), needed(CLOSED, 0, PULL)


def second_snap():
    """Return the press that opens the inner clasp when the outer one is open."""
    return limit(HALF_OPEN, 0, PRESS)


def test_the_weaker_of_two_clasps_opens_first_and_the_stronger_one_at_a_larger_force():
    outer, inner = first_snap()
    assert outer == pytest.approx(0.867, abs=1e-3)
    assert second_snap() == pytest.approx(1.975, abs=1e-3)
    assert outer < inner < second_snap()
    landscape = energy_landscape(load_design("two-clasps"))
    assert [rest.name for rest in landscape.states] == ["closed", "outer open", "both open"]
    for state, known in zip(landscape.states, (CLOSED, HALF_OPEN, BOTH_OPEN), strict=True):
        assert state.angles == pytest.approx(known, abs=1e-9)
        assert state.energy == pytest.approx(stored(*known), rel=1e-9)
    # least drives are resolved to 1 %
    assert list(landscape.least_forces.values()) == pytest.approx([outer, second_snap()], rel=0.011)
    assert landscape.least_torques == {}
    written = landscape_summary(landscape)
    assert list(written["least_forces_N"].values()) == list(landscape.least_forces.values())
    # equilibria under a growing force are lost at the snaps
    built = structure_of(load_design("two-clasps"))
    paths = slow_path(built, CLOSED, [0, 0], [1.2, 0]), slow_path(built, HALF_OPEN, [0, 0], [0, 2.5])
    assert [path.ended for path in paths] == ["lost", "lost"]
    assert 1.2 * paths[0].share[-1] == pytest.approx(outer, rel=1e-6)
    assert 2.5 * paths[1].share[-1] == pytest.approx(second_snap(), rel=1e-6)
    # the work of the force is the change of the stored energy
    ends = [path.shapes[-1].angles for path in paths]
    assert paths[0].work[-1, 0] == pytest.approx(stored(*ends[0]) - stored(*CLOSED), abs=1e-9 * stored(*CLOSED))
    assert ends[1] == pytest.approx(HALF_OPEN, abs=1e-9)


def test_a_landscape_reports_the_force_that_a_state_withstands():
    stages = [
        {"name": "settle", "drive": "none", "until": "rest", "state": "closed", "hold": 0.01, "time_limit": 1.0},
        {"name": "load", "drive": "press", "until": "inner.creases > 10 deg", "hold": 0.0, "time_limit": 1.0},
        {"name": "rest", "drive": "none", "until": "rest", "state": "loaded", "hold": 0.01, "time_limit": 1.0},
    ]
    landscape = energy_landscape(with_values(load_design("two-clasps"), {"protocol.stages": stages}))
    (course,) = landscape.courses
    assert (course.least, course.unit) == (0, "N")
    # the press closes the outer clasp, and the inner one holds
    assert course.withstood == pytest.approx(limit(CLOSED, 0, PRESS), rel=0.011)
    assert any("leaves the goal of" in remark for remark in landscape.remarks)


def test_shapes_between_which_a_hinge_without_a_spring_turns_are_level():
    free, sprung = (ensemble([structure_of(strip(2, **{"crease.stiffness": value}))]) for value in (0.0, 1.0))
    assert level_between(free, np.array([0.2]), np.array([1.4]))
    assert not level_between(sprung, np.array([-0.5]), np.array([0.5]))


def test_simulated_clasps_open_within_half_a_percent_of_the_snap_forces():
    # a force just above the snap force opens a damped clasp slowly
    slow = {f"protocol.stages.{number}.time_limit": 4.0 for number in (1, 3)}
    design = with_values(load_design("two-clasps"), slow)
    designs = [
        with_values(design, {f"drive.{name}.value": share * force})
        for name, force in (("pull", first_snap()[0]), ("press", second_snap()))
        for share in (0.995, 1.005)
    ]
    records = simulate([compile_model(slower) for slower in designs])
    opened = [
        [stage.name for stage, end in zip(record.design.protocol.stages, record.stages, strict=False) if end.at_goal]
        for record in records
    ]
    assert ["open the outer clasp" in names for names in opened] == [False, True, True, True]
    assert ["open the inner clasp" in names for names in opened[2:]] == [False, True]
    # the work of forces on trees without creases that open is counted
    balance = energy_balance(records[3])
    assert balance.residual < 1e-3
    assert balance.work > 0.2


@pytest.mark.parametrize("kind", ["time", "bounds"])
def test_slow_stages_of_trees_and_nets_agree_where_a_crease_opens(kind):
    """The states of a tree are angles of its joints; shapes and goals include creases between flaps."""
    built = structure_of(load_design("earwig-midwing"))
    locked = ensemble([built])
    joints = start_state(locked).position
    at, count = pose(tree_of(built), joints), len(built.bodies)
    shown = RestShape(
        angles=hinge_angles(locked, joints)[0],
        points=place_positions(built, joints)[0],
        origins=at.origins[0, :count],
        frames=at.frames[0, :count],
    )
    (crease,) = (number for number, hinge in enumerate(built.hinges) if hinge.flaps)
    bounds = np.full(len(built.hinges), np.inf)
    most = bounds.copy()
    if kind == "bounds":
        most[crease] = shown.angles[crease] - math.radians(3)
    load = GrowingLoad(
        before=np.zeros(len(built.motors)),
        after=0.6 * np.array(built.drives[0].strengths),
        begin=0.0,
        goal=StageGoal(name="less", kind=kind, least=-bounds, most=most),
        built_on=shown.points,
        rest_speed=math.radians(2),
        duration=1.0,
    )
    one, other = (solve(built, shown, load) for solve in (tree_rest_path, net_rest_path))
    assert one.ended == other.ended
    assert one.share[-1] == pytest.approx(other.share[-1], rel=1e-3)
    assert one.shapes[-1].angles == pytest.approx(other.shapes[-1].angles, abs=1e-4)
    assert one.shapes[-1].points == pytest.approx(other.shapes[-1].points, abs=1e-6)
    assert one.work[-1] == pytest.approx(other.work[-1], rel=1e-3)
