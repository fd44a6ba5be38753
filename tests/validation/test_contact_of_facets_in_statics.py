"""Facets that touch in statics: stacks, contact forces and paths against closed forms, and rest against a slow run."""

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from forficula.statics import quasi_static_path
from forficula.statics.net.contact.contact_energy import contact_forces
from forficula.statics.net.energy import expand, moved_shape
from forficula.statics.net.minimum import minimum
from forficula.statics.net.net_of import own_angles, start_shape
from forficula.structure import structure_of
from forficula.study.running.runs import run
from tests.touching_strips import FACETS, LAYER, LENGTH, STIFFNESS, THICK, crease_angles, rest_of, strip

# two facets of one length that turn about a crease touch where the height of their far corners is the thickness
TOUCHING = 4e-3
WEDGE = math.asin(TOUCHING / LENGTH)


def folded(facets):
    return rest_of("fold", facets, rest="180 deg", thickness="4 mm")


def corners(net, shape, part):
    """Return the heights of the corners of a part, m."""
    parts = net.contact.parts
    number = parts.names.index(part)
    nodes = np.unique(parts.triangles[parts.triangle_parts == number])
    return (net.contact.points @ shape.positions)[nodes, 2]


@pytest.mark.parametrize("facets", FACETS)
def test_a_folded_crease_presses_two_facets_on_each_other_with_its_moment_divided_by_the_lever_arm(facets, agree):
    structure, net, rest = folded(facets)
    angle = crease_angles(structure, own_angles(structure, rest.shape))[0]
    # bars and pins of plates are 1e6 times as stiff as the crease
    near = 1e-9 if facets == "nodes" else 1e-6
    agree("fold angle", angle, math.pi - WEDGE, by="closed form", unit="rad", rel=near)
    forces = contact_forces(net, rest.shape)
    force = STIFFNESS * WEDGE / (LENGTH * math.cos(WEDGE))
    assert rest.stable
    assert list(forces) == ["facet 0 and facet 1"]
    agree("contact force", forces["facet 0 and facet 1"], force, by="closed form", unit="N", rel=10 * near)


def test_no_small_motion_without_a_crossing_lowers_the_energy_of_touching_facets(holds):
    _, net, rest = folded("nodes")
    random, free, allowed = np.random.default_rng(1), replace(net, contact=None), 0
    for _ in range(300):
        pushed = rest.shape.positions + 1e-6 * random.standard_normal(net.nodes.shape) * net.free
        places = net.contact.points @ pushed
        pairs, _ = net.contact.near(places)
        distances = net.contact.closest(places[pairs.nodes], pairs.of_triangles).distance
        if distances.min(initial=np.inf) >= TOUCHING:
            allowed += 1
            energy = expand(free, moved_shape(free, rest.shape, pushed)).stored
            holds("energy after a push", energy / rest.energy, above=1.0, by="energy minimum")
    assert allowed > 20


@pytest.mark.parametrize("facets", FACETS)
def test_layers_of_a_letter_fold_lie_a_thickness_above_each_other(facets, agree):
    structure, net, rest = rest_of("letter", facets)
    assert rest.stable
    heights = [corners(net, rest.shape, f"facet {part}") for part in (2, 0, 4)]
    # the free edges touch; the spines are longer by a thousandth
    for layer, height in enumerate(heights):
        agree("height of a layer", height.min(), layer * THICK, by="closed form", unit="m", abs=1.1e-6)
        assert np.ptp(height) <= 2e-6
    if facets == "plates":
        moments = STIFFNESS * (math.radians(100) - crease_angles(structure, own_angles(structure, rest.shape)))
        forces = contact_forces(net, rest.shape)
        upper, lower = forces["facet 0 and facet 4"], forces["facet 2 and facet 0"]
        # the upper layer presses 3 mm from the crease of the lower one
        agree("force of the upper layer", upper, moments[3] / LAYER, by="closed form", unit="N", rel=1e-6)
        on_lower = (moments[0] + upper * (LENGTH - LAYER)) / LAYER
        agree("force of the lower layer", lower, on_lower, by="closed form", unit="N", rel=1e-4)


def test_a_zigzag_of_four_facets_without_spines_closes_to_two_thicknesses(agree):
    structure, net, rest = rest_of("zigzag", rest="180 deg")
    assert rest.stable
    angles = crease_angles(structure, own_angles(structure, rest.shape))
    agree("fold angles", angles, math.pi - math.asin(THICK / LENGTH), by="closed form", unit="rad", rel=1e-6)
    height = corners(net, rest.shape, "facet 3").max()
    agree("height of the stack", height, 2 * THICK, by="closed form", unit="m", rel=1e-5)


@cache
def closing():
    return quasi_static_path(structure_of(strip("fold", "plates", rest="0 deg", thickness="4 mm")), error=0.05)


def test_a_fold_under_a_growing_torque_closes_to_its_contact_and_no_further(agree, holds):
    path = closing()
    (touch,) = [mark for mark in path.marks if mark.kind == "contact"]
    first = STIFFNESS * (math.pi - WEDGE)
    agree("torque at which facets touch", touch.strength, first, by="closed form", unit="N m", rel=1e-5)
    assert touch.text.startswith('Facet 0 and facet 1 begin to touch when the drive "fold" is 3.041 N cm')
    (forces,) = path.contacts.values()
    apart = path.strength < touch.strength
    assert path.reached
    assert not forces[apart].any()
    holds("contact force", forces, above=-1e-12, by="no adhesion", unit="N")
    theory = (path.strength - first) / (LENGTH * math.cos(WEDGE))
    agree("contact force", forces[~apart], theory[~apart], by="closed form", unit="N", rel=1e-4, abs=2e-6)
    # bars of plates yield by millionths
    agree("fold angle", path.angles[~apart, 0], math.pi - WEDGE, by="closed form", unit="rad", abs=1e-5)


def test_a_strip_that_springs_back_presses_on_the_layer_below_with_the_excess_of_the_force(agree):
    path = quasi_static_path(structure_of(strip("strip", rest="85 deg", drive="force")), error=0.05)
    (touch,) = [mark for mark in path.marks if mark.kind == "contact"]
    (forces,) = path.contacts.values()
    pressed = path.strength > 1.5 * touch.strength
    # the force acts on both corners of the free edge, which touches the layer below
    moments = STIFFNESS * (crease_angles(path.structure, path.angles) - math.radians(85))
    free, hinge = path.positions[:, 0], path.positions[:, 1]
    arm = np.abs(free[:, 0] - hinge[:, 0])
    agree(
        "contact force",
        forces[pressed],
        2 * path.strength[pressed] - moments[pressed, 0] / arm[pressed],
        by="closed form",
        unit="N",
        rel=5e-3,
    )
    # the facet bends about one of its diagonals, so one corner touches first
    lower = path.positions[pressed][:, [0, 4], 2].min(axis=1)
    agree("height of the free edge", lower, THICK, by="closed form", unit="m", rel=1e-6)


def test_a_slow_run_rests_where_statics_does(agree):
    design = strip("strip", "plates")
    record = run(design)
    structure, _, rest = rest_of("strip", "plates")
    # the contact of the run yields by hundredths of its thickness
    agree(
        "fold angles",
        record.series["hinge_angle"][-1],
        own_angles(structure, rest.shape),
        by="statics",
        unit="rad",
        abs=1e-3,
    )


def test_contact_forces_do_not_depend_on_the_stiffness_of_the_augmented_lagrangian(agree):
    structure, net, rest = folded("nodes")
    other = replace(net, contact=replace(net.contact, stiffness=5 * net.contact.stiffness))
    forces = contact_forces(other, minimum(other, start_shape(structure, other)).shape)
    agree(
        "contact force",
        list(forces.values()),
        list(contact_forces(net, rest.shape).values()),
        by="a stiffness 5 times as large",
        unit="N",
        rel=1e-7,
    )
