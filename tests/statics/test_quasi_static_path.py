"""Quasi-static paths of trees and nets: closed forms, landscapes, snaps, work of the drive, growth and continuation."""

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from scipy.interpolate import CubicSpline
from scipy.optimize import minimize_scalar

import forficula as ff
from forficula.statics import quasi_static_path
from forficula.statics.net.energy import shape_at
from forficula.statics.net.net_landscape import slow_courses
from forficula.statics.net.net_of import net_of
from forficula.statics.net.net_state import strength
from forficula.structure import structure_of

SPRING = 2e-2 * 0.21  # of a crease of letter-fold, N m/rad
SOLVERS = {"tree": {}, "net": {"facet.kind": "bars"}}
LETTER = {"tendon": [], "crease.start": "0 deg"}


@cache
def structure(name, *settings):
    return structure_of(ff.load_design(name, dict(settings)))


@cache
def path_of(name, error=2e-3):
    return quasi_static_path(structure(name), error=error)


def letter(solver, **settings):
    """Return letter-fold without tendons: rigid panels on joints, or facets between nodes."""
    return structure_of(ff.load_design("letter-fold", LETTER | SOLVERS[solver] | settings))


@pytest.mark.parametrize("solver", SOLVERS)
def test_a_linear_crease_stores_half_its_stiffness_times_the_square_of_its_angle(solver):
    path = quasi_static_path(letter(solver))
    creases = [number for number, hinge in enumerate(path.structure.hinges) if hinge.assignment == "V"]
    angles = path.angles[:, creases]
    # facets between nodes bend a little under the torques on their edges
    near = {"rel": 1e-9 if solver == "tree" else 2e-2}
    assert path.reached
    assert path.strength == pytest.approx(SPRING * angles[:, 0], abs=1e-9, **near)
    assert path.stored == pytest.approx(SPRING / 2 * np.sum(angles**2, axis=1), abs=1e-9, **near)
    assert path.moments[:, creases] == pytest.approx(SPRING * angles, rel=1e-9, abs=1e-12)
    assert math.degrees(angles[-1].min()) == pytest.approx(90, abs=1.1 if solver == "tree" else 1e-4)


@pytest.mark.parametrize("name", ["bistable-miura", "kresling-cell", "miura-sheet"])
def test_the_path_has_the_shapes_of_the_course_of_the_landscape(name):
    built = structure(name)
    course, path = slow_courses(built)[0], path_of(name)
    assert [mark.strength for mark in path.marks if mark.kind == "snap"] == pytest.approx(
        [snap.factor * course.drive.strength for snap in course.slow.snaps], rel=1e-6
    )
    rising = np.flatnonzero(path.resting[: path.resting.argmin() or None])
    compared = 0
    for point in course.slow.paths[0].points[:-1]:
        size = point.factor * course.drive.strength
        if not path.strength[rising[0]] <= size <= path.strength[rising[-1]]:
            continue
        shape = [np.interp(size, path.strength[rising], column) for column in path.coordinates[rising].T]
        moved = point.shape.positions - net_of(built).nodes
        assert np.abs(np.reshape(shape, (-1, 3)) - moved).max() <= 3e-3 * built.span
        compared += 1
    assert compared >= 5


def test_the_path_of_a_tree_ends_at_its_least_slow_torque():
    for name in ("letter-fold", "binder2025-joint"):
        path, landscape = path_of(name), ff.landscape(name, points=11)
        assert path.strength[-1] == pytest.approx(landscape.least_torques[path.name], rel=1e-9)


def test_a_snap_is_marked_with_its_torque_and_its_energy():
    """Letter-fold lies at the stops at -3 deg; the tendons resist most there, so it snaps when they are overcome."""

    def energy(angle):
        longer = np.sqrt(4.95**2 + 3.96**2 + 2 * 4.95 * 3.96 * np.cos(angle)) / 100 - 0.05
        return 50 / 2 * np.maximum(longer, 0) ** 2 + SPRING / 2 * angle**2

    stop, small = math.radians(-3), 1e-6
    torque = (energy(stop + small) - energy(stop)) / small
    path = path_of("letter-fold")
    snap, goal = path.marks
    assert (snap.kind, goal.kind) == ("snap", "goal")
    assert snap.strength == pytest.approx(torque, rel=0.011)
    assert "snaps" in snap.text
    assert "releases" in snap.text
    # it lands where the moment equals the torque again; both creases release the difference of their potentials
    landed = minimize_scalar(
        lambda angle: energy(angle) - snap.strength * angle, bounds=(1.2, 3), method="bounded", options={"xatol": 1e-9}
    )
    released = 2 * (energy(stop) - snap.strength * stop - landed.fun)
    assert snap.released == pytest.approx(released, rel=1e-4)
    first, last = path.index(snap.share), len(path.share) - 1
    assert path.resting[last]
    assert not path.resting[first + 1 : last].any()
    assert np.ptp(path.strength[first + 1 :]) < 1e-12


def test_the_stored_energy_is_the_work_of_the_drive():
    """The drive changes all rest angles; its work is that of the springs' moments against the change."""
    path = path_of("miura-sheet", error=2e-5)
    creases = [number for number, hinge in enumerate(path.structure.hinges) if hinge.assignment in ("M", "V")]
    power = -path.moments[:, creases].sum(axis=1)
    work = CubicSpline(path.strength, power).integrate(0, path.strength[-1])
    assert path.stored[-1] - path.stored[0] == pytest.approx(work, rel=1e-6)


def test_the_stored_energy_is_the_work_of_a_torque():
    path = quasi_static_path(letter("net"), error=2e-5)
    creases = [number for number, hinge in enumerate(path.structure.hinges) if hinge.assignment == "V"]
    turned = path.angles[:, creases].sum(axis=1)
    work = CubicSpline(turned, path.strength).integrate(turned[0], turned[-1])
    assert path.stored[-1] - path.stored[0] == pytest.approx(work, rel=1e-6)


def test_linear_interpolation_between_points_is_as_accurate_as_requested():
    for name, error in (("miura-sheet", 5e-3), ("letter-fold", 5e-3)):
        coarse, fine = path_of(name, error=error), path_of(name, error=error / 50)
        assert len(coarse.share) <= len(fine.share)
        assert coarse.error <= error
        drawn = np.array([coarse.point(share).positions for share in np.linspace(0, 1, 1001)])
        for shape in fine.positions[fine.resting]:
            away = np.linalg.norm(drawn - shape, axis=2).max(axis=1).min()
            assert away <= error * coarse.structure.span


def test_strains_are_those_of_the_solver_and_of_stretched_triangles():
    built, path = structure("kresling-cell"), path_of("kresling-cell")
    net = net_of(built)
    shape = shape_at(net, net.nodes + path.coordinates[3].reshape(-1, 3))
    assert path.strains["bars"][3] == pytest.approx(strength(net, shape).strains[: len(built.springs)], abs=1e-12)
    wing = path_of("binder2025-joint")
    assert set(wing.strains) == {"tendons"}
    fan = structure("binder2025")
    place = np.concatenate([[point.place for point in fan.points], *(membrane.built for membrane in fan.membranes)])
    stretched = replace(wing, structure=fan, positions=np.array([place, 1.1 * place]))
    assert stretched.strains["membranes"] == pytest.approx(
        np.outer([0, 0.105], np.ones(stretched.strains["membranes"].shape[1])), abs=1e-7
    )


@pytest.mark.parametrize("name", ["miura-sheet", "letter-fold"])
def test_the_path_is_shown_while_it_grows_and_ends_when_the_caller_stops(name):
    shown = []

    def follow(path):
        shown.append(path)
        return len(shown) < 4

    path = quasi_static_path(structure(name), follow=follow)
    assert [len(part.share) for part in shown] == [2, 3, 4, 5]
    assert not any(part.complete for part in shown)
    assert not path.complete
    assert not path.reached
    assert "lost" not in {mark.kind for mark in path.marks}
    assert len(path.share) < len(path_of(name).share)
    whole = []
    assert quasi_static_path(structure(name), follow=lambda part: whole.append(part) or True).complete
    assert [len(part.share) for part in whole[:3]] == [2, 3, 4]


@pytest.mark.parametrize(
    ("name", "key", "value"),
    [("miura-sheet", "crease.stiffness", "3e-2 N m/rad/m"), ("binder2025", "tendon.stiffness", "8 N/cm")],
)
def test_a_path_is_continued_from_a_shape_when_a_value_has_changed(name, key, value):
    before, changed = path_of(name), structure(name, (key, value))
    share = 0.5 * (before.marks[-2].share if len(before.marks) > 1 else 1.0)
    shown = []
    path = quasi_static_path(changed, near=before.point(share), follow=lambda part: shown.append(part) or True)
    assert shown[0].at == 0
    # the first shape is at rest under the same drive, and the whole path is that computed from its start
    assert shown[0].strength[0] == pytest.approx(before.point(share).strength)
    assert path.complete
    assert 0 < path.at < 1
    assert path.point(path.at).strength == pytest.approx(shown[0].strength[0], rel=0.1)
    whole = quasi_static_path(changed)
    assert np.abs(path.positions[[0, -1]] - whole.positions[[0, -1]]).max() <= 1e-6 * changed.span


def test_a_shape_of_other_parts_is_ignored():
    path = quasi_static_path(structure("miura-sheet"), near=path_of("letter-fold").point(0.5))
    assert path.at is None
    assert path.reached


def test_the_path_of_a_later_transition_starts_where_the_one_before_ends():
    opening = quasi_static_path(structure("letter-fold"), "open")
    assert opening.strength[-1] < 0
    assert np.degrees(opening.angles[0]).min() > 90
    with pytest.raises(ff.InputError, match=r'transition: need "?close"?'):
        quasi_static_path(structure("letter-fold"), "clse")


def test_a_transition_of_a_structure_without_transitions_is_refused_with_the_reason():
    bent = ff.load_design("miura-sheet", {"protocol.stages": [
        {"name": "fold", "drive": "fold", "until": "rest", "state": "folded", "hold": "0 s", "time_limit": "1 s"}
    ]})  # fmt: skip
    with pytest.raises(ff.InputError, match=r'transition: .* has none, because no driven stage .*, got "folded"'):
        quasi_static_path(structure_of(bent), "folded")


def test_a_structure_without_a_drive_has_no_path():
    idle = ff.load_design("miura-sheet", {"drive": [], "protocol.stages": [
        {"name": "settle", "drive": "none", "until": "rest", "hold": "0 s", "time_limit": "1 s"}
    ]})  # fmt: skip
    with pytest.raises(ff.InputError, match="need a drive that folds it"):
        quasi_static_path(idle)


def test_a_path_that_misses_its_goal_says_so():
    path = quasi_static_path(structure("letter-fold", ("drive.close.value", "0.01 N cm"), ("tendon", ())))
    assert not path.reached
    assert path.marks[-1].kind == "lost"
    assert path.remarks


def test_a_snap_past_the_goal_ends_there_and_the_drive_is_released():
    """Under its drive, the apex of four-plate-snap would come to rest beyond the goal of its second transition."""
    path = quasi_static_path(structure("four-plate-snap"), "pull")
    snap, goal = path.marks
    assert (snap.kind, goal.kind) == ("snap", "goal")
    assert snap.end == goal.share < 1
    assert path.reached
    assert path.resting[-1]
    assert path.strength[-1] == 0
    assert np.degrees(path.angles[-1]).min() > 10
    assert "released" in path.remarks[-1]


def test_a_drive_without_strength_is_refused():
    with pytest.raises(ff.InputError, match='need a drive "fold" with a strength other than 0'):
        quasi_static_path(structure("miura-sheet", ("drive.fold.angle", "0 deg")))


@pytest.mark.parametrize("error", [-1e-3, 0.0, math.nan, math.inf])
def test_an_error_that_no_path_can_have_is_refused(error):
    with pytest.raises(ff.InputError, match="error: need a number above 0 and up to 1, got "):
        quasi_static_path(structure("letter-fold"), error=error)


@pytest.mark.parametrize("share", [-0.1, 1.1, math.nan, "0.5", None])
def test_a_position_beyond_the_path_is_refused(share):
    with pytest.raises(ff.InputError, match="share: need a number from 0 to 1, got "):
        path_of("letter-fold").point(share)
