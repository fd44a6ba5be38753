"""Landscapes of sliding points, compared with the closed form of a von Mises truss: a pyramid that snaps through.

Four bars of stiffness k and length L, at a height h of the apex over the rim: the force is 4 k (L / l - 1) h with
l^2 = L^2 - rise^2 + h^2, the barrier 2 k (L - sqrt(L^2 - rise^2))^2 (e.g. Bazant and Cedolin 2010, section 4.4). The
creases of the pyramid are soft enough to be neglected.
"""

from dataclasses import replace

import numpy as np
import pytest

from forficula.design import load_design
from forficula.errors import InputError
from forficula.statics import energy_landscape, landscape_summary
from forficula.statics.net import net_landscape
from forficula.statics.net.energy import shape_at
from forficula.statics.net.saddle import Saddle
from forficula.structure import structure_of
from tests.pyramid import RISE, SIDE, pyramid

HALF = np.sqrt(SIDE**2 - RISE**2)


@pytest.fixture(scope="module")
def reports():
    return []


@pytest.fixture(scope="module")
def landscape(reports):
    return energy_landscape(pyramid(), progress=reports.append)


@pytest.fixture(scope="module")
def slanting():
    """Return the stiffness of the bars to the apex, N/m."""
    (stiffness,) = {round(spring.stiffness, 9) for spring in structure_of(pyramid()).springs if 0 in spring.points}
    return stiffness


def force(stiffness, height):
    return 4 * stiffness * (SIDE / np.hypot(HALF, height) - 1) * height


def test_both_states_are_found_with_the_names_of_the_protocol(landscape):
    assert [state.name for state in landscape.states] == ["up", "down"]
    heights = [state.readings["height"][0] for state in landscape.states]
    assert heights[0] - heights[1] == pytest.approx(2 * RISE, rel=1e-3)
    assert [rest.name for rest in landscape.rests] == ["up", "down", "up again"]
    assert landscape.rests[2].same_as == "up"
    assert all(rest.stable and rest.within for rest in landscape.rests)


def test_energies_are_reported_by_the_part_that_stores_them(landscape):
    up, down = landscape.states
    assert up.energy == 0
    assert set(down.stored) == {"creases", "bars"}
    assert sum(down.stored.values()) == pytest.approx(down.energy)
    assert down.stored["creases"] > 100 * down.stored["bars"]


def test_the_barrier_is_that_of_the_bars_pressed_flat(landscape, slanting):
    (way,) = landscape.passes
    assert way.ends == (0, 1)
    assert way.barriers == pytest.approx([2 * slanting * (SIDE - HALF) ** 2] * 2, rel=5e-3)
    assert way.barriers[0] - way.barriers[1] == pytest.approx(landscape.states[1].energy, rel=1e-9)


def test_states_and_barriers_of_a_net_are_asked_for_as_those_of_a_wing(landscape):
    (way,) = landscape.passes
    assert [state.name for state in landscape.states] == ["up", "down"]
    for ends, climb in zip((("up", "down"), ("down", "up")), way.barriers, strict=True):
        assert landscape.barrier(*ends) == pytest.approx(climb, rel=1e-9)
    with pytest.raises(InputError, match=r'\(up, down\), got "dwn", did you mean "down"'):
        landscape.barrier("up", "dwn")
    with pytest.raises(InputError, match='no saddle was found that leads from "up" to "down"'):
        replace(landscape, passes=()).barrier("up", "down")


def test_the_barrier_is_that_of_the_path_with_the_lowest_maximum(landscape):
    up, down = landscape.states
    between = replace(up, name="between", energy=1.0)
    direct = replace(landscape.passes[0], energy=9.0)
    around = (replace(direct, ends=(0, 2), energy=5.0), replace(direct, ends=(1, 2), energy=6.0))
    three = replace(landscape, states=(up, down, between), passes=(direct, *around))
    assert three.barrier("up", "down") == 6.0
    assert three.barrier("between", "up") == 4.0


def test_drives_snap_at_the_largest_force_of_the_bars(landscape, slanting):
    largest = force(slanting, np.linspace(0, RISE, 20001)).max()
    courses = {course.name: course for course in landscape.courses}
    assert list(courses) == ["push", "pull"]
    for course in courses.values():
        assert course.least == pytest.approx(largest, rel=5e-3)
        assert [snap.kind for snap in course.slow.snaps] == ["limit"]
        assert course.slow.ended == "stop"
        # the equilibria continue from there, down to the opposite limit force and up again
        assert min(point.factor for point in course.through.points) < -0.9 * course.slow.snaps[0].factor


def test_states_withstand_the_loads_of_the_closed_form(landscape, slanting):
    up, down = ({withstand.load: withstand for withstand in state.withstands} for state in landscape.states)
    largest = force(slanting, np.linspace(0, RISE, 20001)).max()
    assert up["force push"].value == pytest.approx(largest, rel=5e-3)
    assert up["force push"].kind == "limit"
    assert up["force pull"].kind == "none"
    assert up["force pull"].value > 5 * largest
    assert down["force pull"].value == pytest.approx(largest, rel=5e-3)
    # an acceleration of the supports acts on the mass of the apex
    mass = structure_of(pyramid()).bodies[0].mass
    assert up["supports accelerated along +z"].value == pytest.approx(largest / mass, rel=5e-3)
    assert up["supports accelerated along +x"].kind == "none"


def test_the_frequency_follows_from_the_bars_and_the_mass_of_the_apex(landscape, slanting):
    structure = structure_of(pyramid())
    expected = np.sqrt(4 * slanting * (RISE / SIDE) ** 2 / structure.bodies[0].mass) / (2 * np.pi)
    assert landscape.states[0].frequencies[0] == pytest.approx(expected, rel=5e-3)


def test_degrees_of_freedom_and_self_stress_are_counted(landscape):
    # three of the apex's four bars fix its three displacements; the bars of the rim are between supports
    assert landscape.net.built.degrees_of_freedom == 0
    assert landscape.net.built.self_stresses == 1 + 4
    assert landscape.states[1].mobility == landscape.net.built


def test_the_same_seed_finds_the_same(landscape):
    again = energy_landscape(pyramid())
    assert landscape_summary(again) == landscape_summary(landscape)


def test_the_summary_has_units_in_its_keys_and_plain_numbers(landscape):
    net = landscape_summary(landscape)["net"]
    assert net["search"] == {"seed": 0, "tries": 16, "found": 2, "failed": 0}
    assert net["states"][1]["readings"]["height_m"] == pytest.approx([0.2 - 2 * RISE], rel=1e-3)
    push = net["courses"][0]
    assert push["least_N"] == pytest.approx(push["snaps"][0]["drive_N"])
    assert len(push["slow"]["drive_N"]) == len(push["slow"]["gone_m"]) == len(push["slow"]["ways_downhill"])
    assert "net" not in landscape_summary(energy_landscape(load_design("letter-fold"), points=31))


def test_a_transition_that_its_drive_cannot_make_has_no_least_value():
    """A pyramid that is pulled up does not snap down."""
    stages = [{"name": "pull", "drive": "pull", "until": "height < 19 cm", "hold": 0.0, "time_limit": 1.0}]
    done = {"name": "rest", "drive": "none", "until": "rest", "state": "low", "hold": 0.0, "time_limit": 1.0}
    result = energy_landscape(pyramid(**{"protocol.stages": [*stages, done]}))
    pull = next(course for course in result.courses if course.name == "pull")
    assert pull.least is None
    assert result.rests[-1].name == "not low"
    assert not result.rests[-1].within


def test_a_sheet_without_springs_in_its_creases_and_without_supports_rests_nowhere_firmly():
    loose = {"crease.stiffness": 0.0, "facet.bend_stiffness": 0.0, "support": [], "drive": [], "measure": []}
    stage = {"name": "wait", "drive": "none", "until": "time", "hold": 0.0, "time_limit": 1.0}
    result = energy_landscape(pyramid(**loose, **{"protocol.stages": [stage], "pattern.sectors": [1.2, 1.2, 1.2, 1.3]}))
    assert result.states == ()
    assert any("a part can move without any force" in remark for remark in result.remarks)


def test_progress_is_reported(landscape, reports):
    assert landscape.states
    assert reports[0] == "resting shape and effects of the drives"
    assert "loads that it withstands: down" in reports


def pressed(direction):
    """Return the landscape of a pyramid whose apex is displaced through the plane of its rim."""
    _, pull = pyramid().drive
    press = {"name": "push", "kind": "displacement", "of": "vertex 0", "direction": direction, "distance": RISE}
    return energy_landscape(pyramid(drive=[press, pull.model_dump(exclude_none=True)]))


def test_a_displaced_apex_takes_the_force_of_the_closed_form_through_the_snap(slanting):
    landscape = pressed([0, 0, -1])
    course = landscape.courses[0]
    (summary,) = [item for item in landscape_summary(landscape)["net"]["courses"] if item["name"] == "push"]
    path = summary["slow"]
    expected = force(slanting, RISE - np.array(path["gone_m"]))
    largest = np.abs(expected).max()
    assert path["force_N"] == pytest.approx(expected, abs=1e-2 * largest)
    assert min(path["force_N"]) < -0.5 * largest
    assert not course.slow.snaps
    assert summary["largest_force_N"] == pytest.approx(max(expected), rel=1e-2)


def test_a_displacement_along_no_axis_gives_a_remark_and_the_states_are_computed():
    landscape = pressed([0, 1, -1])
    assert len(landscape.states) == 2
    (remark,) = [remark for remark in landscape.remarks if "cannot be computed" in remark]
    assert "direction: need x, y or z" in remark


def test_a_state_beyond_a_saddle_that_the_search_missed_is_listed_and_joined(landscape, monkeypatch):
    """The search has found "up" and a shape that nothing joins; a saddle leads to "down"."""
    (up, down), net = landscape.states, landscape.net.net
    lost = replace(up, name="lost", energy=2 * down.energy, rest=replace(up.rest, shape=shape_at(net, 2 * net.nodes)))
    (joint,) = landscape.passes
    path = Saddle(
        rest=replace(up.rest, energy=joint.energy, shape=joint.shape), ends=(up.rest, down.rest), joins=False, path=None
    )
    monkeypatch.setattr(net_landscape, "find_saddle", lambda *_, **__: path)
    search = replace(landscape.net.search, states=(up.rest,), counts=(3,))
    searched, states, passes = net_landscape._joined(landscape.structure, net, search, [up, lost])
    assert [state.name for state in states] == ["up", "state 3", "lost"]
    assert states[1].hits == 0
    assert searched.counts == (3, 0)
    ((ends, barriers),) = [(item.ends, item.barriers) for item in passes]
    assert ends == (0, 1)
    assert barriers == pytest.approx(joint.barriers)
