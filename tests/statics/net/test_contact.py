"""Contact of nets: closest points, motions that cross, sheets that touch as built, and what statics refuses."""

from dataclasses import replace

import numpy as np
import pytest

from forficula.design import load_design, with_values
from forficula.errors import InputError
from forficula.statics import start_drag
from forficula.statics.net.contact.closest import corner_to_triangle, distance_hessians, edge_to_edge, gradients
from forficula.statics.net.contact.contact_energy import contact_forces, with_contact_forces
from forficula.statics.net.driven.net_course import released
from forficula.statics.net.factor import Factorisation
from forficula.statics.net.load import crease_torques
from forficula.statics.net.load_path import load_path
from forficula.statics.net.net_of import is_net, net_of, own_angles, panels, start_shape
from forficula.statics.net.panel_crossing import panels_cross
from forficula.statics.net.stable_states import find_stable_states
from forficula.statics.survey import check_quasi_static
from forficula.statics.tree_remarks import ignored_contact_remarks
from forficula.structure import structure_of
from forficula.structure.contact.distances import node_from_triangle, side_from_side, squared_sines
from tests.plate_sheets import plates, pleats
from tests.touching_strips import rest_of, strip

STEP = 1e-6
KINDS = {"corner": (corner_to_triangle, node_from_triangle), "edge": (edge_to_edge, side_from_side)}


@pytest.mark.parametrize("kind", KINDS)
def test_distances_and_their_gradients_equal_those_of_runs(kind):
    ours, theirs = KINDS[kind]
    places = np.random.default_rng(2).standard_normal((200, 4, 3))
    nearest, other = ours(places), theirs(places)
    assert nearest.distance == pytest.approx(other.distances, rel=1e-9)
    assert gradients(nearest) == pytest.approx(other.weights[:, :, None] * other.normals[:, None], abs=1e-9)


@pytest.mark.parametrize("larger", [0.0, 0.01])
@pytest.mark.parametrize("kind", KINDS)
def test_hessians_of_distances_are_the_changes_of_their_gradients(kind, larger):
    closest = KINDS[kind][0]
    places = np.random.default_rng(3).standard_normal((60, 4, 3))
    hessians = distance_hessians(places, closest(places, larger))
    for number in range(12):
        step = np.zeros(12)
        step[number] = STEP
        ends = [gradients(closest(places + sign * step.reshape(4, 3), larger)).reshape(-1, 12) for sign in (1, -1)]
        assert hessians[:, :, number] == pytest.approx((ends[0] - ends[1]) / (2 * STEP), abs=1e-5, rel=1e-5)


def test_the_sine_of_the_angle_of_parallel_edges_is_zero():
    places = np.array([[[0, 0, 0], [1, 0, 0], [0, 0, 1], [2, 0, 1]], [[0, 0, 0], [1, 0, 0], [0, 0, 1], [0, 3, 1.0]]])
    sines, slopes = squared_sines(places)
    assert sines == pytest.approx([0, 1], abs=1e-15)
    assert not slopes.any()


def test_a_motion_through_a_facet_crosses_and_one_beside_it_does_not():
    structure, net, rest = rest_of("strip", "plates")
    contact = net.contact
    places = contact.points @ rest.shape.positions
    upper = [node for node, point in enumerate(contact.parts.points) if structure.points[point].body == 2]
    for shift, crosses in (([0, 0, -2e-3], True), ([0, 0, 2e-3], False), ([1e-4, 0, 1e-3], False)):
        moved = places.copy()
        moved[upper] += shift
        assert contact.crossed(places, moved) == crosses


def test_contact_forces_of_a_shape_that_is_no_minimum_follow_from_the_overlap():
    _, net, rest = rest_of("fold", "nodes", rest="180 deg", thickness="4 mm")
    parts = net.contact.parts
    thicker = replace(net, contact=replace(net.contact, parts=replace(parts, half=(1 + 1e-4) * parts.half)))
    saddle = Factorisation(index=1, solve=np.negative)
    shape, converged = with_contact_forces(thicker, rest.shape, saddle)
    assert not converged
    assert shape.pressing.forces.max() > 0


def test_a_spine_narrower_than_the_thickness_is_an_error_that_names_both_layers_and_the_largest_thickness():
    with pytest.raises(
        InputError,
        match=r"need at most 1.001 mm, because facet 2 and facet 0 are 1.001 mm apart as built, got 1.2 mm",
    ):
        net_of(structure_of(strip("strip", "plates", thickness="1.2 mm")))
    net_of(structure_of(strip("strip", "plates", thickness="1.001 mm")))


@pytest.mark.parametrize("method", ["hinge-shift", "split"])
def test_thick_panels_that_touch_when_flat_have_statics_with_contact(method):
    facet = f'kind = "rigid"\nthickness_method = "{method}"'
    design = with_values(plates(pleats(3, "VV"), facet=facet), {"protocol.contact": True})
    structure = structure_of(design)
    assert net_of(structure).contact is not None


def test_facets_that_are_apart_exert_no_force():
    _, net, rest = rest_of("strip", "nodes", rest="80 deg")
    assert rest.stable
    assert contact_forces(net, rest.shape) == {}


def test_no_stable_state_of_a_search_has_crossing_layers():
    structure, net, rest = rest_of("strip", "plates")
    search = find_stable_states(net, [rest.shape], tries=2)
    assert len(search.states) >= 1
    for state in search.states:
        assert not panels_cross(net, state.shape, panels(structure))


def test_a_point_dragged_towards_another_layer_stops_at_the_thickness():
    structure = structure_of(strip("strip", "nodes", rest="85 deg"))
    drag = start_drag(structure, 0)
    before = drag.start.positions[0]
    blocked = drag.to(before - np.array([0, 0, 1e-2]))
    assert not blocked.reached
    assert blocked.position[2] == pytest.approx(1e-3, abs=3e-5)


def test_rigid_facets_in_a_tree_are_solved_as_a_net_if_they_touch():
    assert is_net(structure_of(strip("strip", "plates")))


def test_paths_through_unstable_equilibria_refuse_contact():
    _, net, rest = rest_of("strip", "plates")
    with pytest.raises(InputError, match="need None for a path through unstable equilibria"):
        load_path(net, rest.shape, crease_torques(net, np.array([0]), 1.0))


def test_quasi_static_stages_refuse_friction():
    stage = {"name": "fold", "drive": "fold", "until": "time", "time_limit": 1.0, "hold": 0.0, "motion": "quasi-static"}
    design = with_values(strip("strip", "plates"), {"protocol.stages": [stage], "contact.friction": 0.3})
    with pytest.raises(InputError, match="statics ignores the friction of contact"):
        check_quasi_static(structure_of(design), design.protocol)


def test_statics_of_a_fan_reports_that_it_ignores_contact():
    structure = structure_of(load_design("binder2025", {"protocol.contact": True}))
    assert not is_net(structure)
    assert ignored_contact_remarks(structure)[0].startswith(
        "statics ignores contact of the bars and panels of this wing"
    )
    assert ignored_contact_remarks(structure_of(load_design("binder2025"))) == ()


def test_plates_in_a_tree_come_to_rest_with_contact_where_a_run_and_the_statics_without_contact_do():
    design = load_design("two-clasps", {"protocol.contact": True})
    structure = structure_of(design)
    net = net_of(structure)
    rest = released(net, start_shape(structure, net))[0]
    assert np.rad2deg(own_angles(structure, rest.shape)) == pytest.approx([60, 60], abs=1e-3)
    assert not panels_cross(net, rest.shape, panels(structure))


def test_plates_that_start_on_the_far_side_of_a_crease_stay_there():
    structure = structure_of(load_design("letter-fold", {"protocol.contact": True}))
    net = net_of(structure)
    begin = start_shape(structure, net)
    assert np.rad2deg(begin.angles) == pytest.approx([-3, -3], abs=1e-6)
    # neighbouring plates meet at their crease and do not pass through each other
    assert not panels_cross(net, begin, panels(structure))
