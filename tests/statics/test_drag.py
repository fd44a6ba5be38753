"""Quasi-static drag: closed form of a crease, targets out of reach, and shapes on the path of a drive."""

import math

import numpy as np
import pytest

import forficula as ff
from forficula.statics import quasi_static_path, start_drag
from forficula.structure import built_points, structure_of

SPRING = 2e-2 * 0.21  # of a crease of letter-fold, N m/rad
ARM = 0.099  # from a crease to the outer edge of a panel, m
# facets between nodes that hardly bend or stretch
STIFF = {"facet.kind": "bars", "facet.thickness": "5 mm", "facet.bend_stiffness": "1e3 N m/rad/m"}
SOLVERS = {"tree": {}, "net": STIFF}


def letter(solver):
    """Return letter-fold without tendons, and the two places at the outer edge of its last panel."""
    settings = {"tendon": [], "crease.start": "0 deg"} | SOLVERS[solver]
    structure = structure_of(ff.load_design("letter-fold", settings))
    points = built_points(structure)
    outer = np.flatnonzero(np.isclose(points[:, 0], points[:, 0].max()))
    corners = outer[[np.argmin(points[outer, 1]), np.argmax(points[outer, 1])]].tolist()
    return structure, dict.fromkeys(corners, 0.5)


def turned(structure, places, angle):
    """Return the middle of the outer edge with the last panel turned about its crease, m, (3,)."""
    middle = sum(weight * built_points(structure)[place] for place, weight in places.items())
    return middle + ARM * np.array([math.cos(angle) - 1, 0, math.sin(angle)])


@pytest.mark.parametrize("solver", SOLVERS)
def test_the_force_that_turns_a_panel_is_the_moment_of_its_crease_over_the_lever_arm(solver):
    structure, places = letter(solver)
    drag = start_drag(structure, places)
    shape = drag.start
    for degrees in (10, 40, 80, 120):
        angle = math.radians(degrees)
        moved = drag.to(turned(structure, places, angle), shape)
        shape = moved.point
        assert moved.reached
        assert moved.stable
        assert np.linalg.norm(moved.position - moved.target) <= 1e-4 * structure.span
        across = np.array([-math.sin(angle), 0, math.cos(angle)])
        assert moved.force @ across == pytest.approx(SPRING * angle / ARM, rel=5e-3)
        assert sum(shape.energy.values()) == pytest.approx(
            SPRING / 2 * angle**2, rel=2e-3 if solver == "tree" else 2e-2
        )
        assert "holds the point here" in moved.text
    released = drag.to(turned(structure, places, 0.0), shape)
    assert np.abs(released.force).max() <= 1e-3 * SPRING / ARM


@pytest.mark.parametrize("solver", SOLVERS)
def test_a_target_out_of_reach_gives_the_nearest_equilibrium(solver):
    structure, places = letter(solver)
    angle = math.radians(40)
    on_circle = turned(structure, places, angle)
    radial = np.array([math.cos(angle), 0, math.sin(angle)])
    drag = start_drag(structure, places)
    near = drag.to(on_circle).point
    moved = drag.to(on_circle + 0.02 * radial, near)
    assert not moved.reached
    assert moved.position == pytest.approx(on_circle, abs=3e-3)
    assert "cannot reach" in moved.text
    # the crease alone resists; the panel does not yield along its length
    across = np.array([-math.sin(angle), 0, math.cos(angle)])
    assert moved.force == pytest.approx(SPRING * angle / ARM * across, rel=5e-2, abs=2e-3)


def test_a_point_of_a_shape_on_a_path_is_dragged_without_force_to_where_it_is():
    for name in ("miura-sheet", "letter-fold"):
        path = quasi_static_path(name)
        point = path.point(1.0)
        place = int(np.argmax(np.ptp(path.positions, axis=0).max(axis=1)))
        drag = start_drag(name, place, point, path.name)
        moved = drag.to(point.positions[place])
        assert moved.reached
        assert np.abs(moved.point.positions - point.positions).max() <= 1e-3 * path.structure.span
        away = drag.to(point.positions[place] + 0.01 * path.structure.span)
        assert away.point.strength == point.strength
        assert not away.reached or np.linalg.norm(away.force) > 10 * np.linalg.norm(moved.force)


def test_the_work_of_the_force_is_the_change_of_the_stored_energy():
    """A corner of letter-fold between nodes: the crease turns, and the facets bend."""
    structure = structure_of(
        ff.load_design("letter-fold", {"tendon": [], "crease.start": "0 deg", "facet.kind": "bars"})
    )
    corner = int(np.argmax(built_points(structure) @ [1, 1, 0]))
    drag = start_drag(structure, corner)
    # the nearest equilibrium to any target is a position that the corner can reach
    near = drag.to(drag.start.positions[corner] + np.array([-0.01, 0.0, 0.04]))
    middle = drag.to(near.position, near.point)
    assert middle.reached
    along = middle.force / np.linalg.norm(middle.force)
    ends = [drag.to(middle.position + step * along, middle.point) for step in (-1e-3, 1e-3)]
    stored = [sum(end.point.energy.values()) for end in ends]
    work = (ends[0].force + ends[1].force) / 2 @ (ends[1].position - ends[0].position)
    assert stored[1] - stored[0] == pytest.approx(work, rel=1e-2)


def test_only_a_place_that_moves_can_be_dragged():
    structure, places = letter("tree")
    net = structure_of(ff.load_design("miura-sheet"))
    held = next(number for number, point in enumerate(net.points) if not net.bodies[point.body].slides)
    for built, place, message in (
        (structure, 99, "places: need numbers from 0 to 13, got 99"),
        (structure, {next(iter(places)): 0.5}, "need weights that add up to 1, got 0.5"),
        (net, held, "need a point that can move"),
    ):
        with pytest.raises(ff.InputError, match=message):
            start_drag(built, place)
    with pytest.raises(ff.InputError, match="target: need three finite coordinates"):
        start_drag(structure, places).to([0, 0, math.nan])
