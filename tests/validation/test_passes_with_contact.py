"""Passes between states with contact, against a closed form and against a slow run."""

import math
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from scipy.optimize import brentq, minimize_scalar

import forficula as ff
from forficula.design import load_design
from forficula.statics.net import net_state
from forficula.statics.net.contact.contact_energy import contact_forces
from forficula.statics.net.energy import shape_at
from forficula.statics.net.minimum import minimum
from forficula.statics.net.net_of import net_of
from forficula.statics.net.saddle import find_saddle
from forficula.structure import structure_of
from tests.touching_strips import LAYER, LENGTH, THICK, strip

# A flap on a spring lies under a lid whose crease has two stable angles. While the lid opens, the flap follows it.
SPRING, FLAP_REST = 1e-3, math.radians(120)  # N m/rad, rad
LID_REST, LID_PASS, LID_OPEN, CUBIC = math.radians(155), -0.5, -1.2, 0.02  # rad; further angles from rest; N m/rad^3
LID = CUBIC * LID_PASS * LID_OPEN, -CUBIC * (LID_PASS + LID_OPEN)  # N m/rad, N m/rad^2
CONTACT = {"protocol.contact": True}
RIGID = 100.0  # multiple of the stiffness of bars and bends


def flap_angle(lid):
    """Return the fold angle of the flap, whose tip is a thickness from the lid."""
    return 2 * math.pi - lid - np.arcsin((LENGTH * np.sin(lid) - THICK) / LAYER)


def energy(lid):
    """Return the energy with the flap in contact with the lid, J."""
    turned, flap = lid - LID_REST, flap_angle(lid) - FLAP_REST
    return LID[0] * turned**2 / 2 + LID[1] * turned**3 / 3 + CUBIC * turned**4 / 4 + SPRING * flap**2 / 2


@cache
def flap_and_lid():
    """Return a net of nearly rigid facets, and its closed and its opened state."""
    structure = structure_of(strip("flap"))
    net = net_of(structure)
    one, two = (number for number, hinge in enumerate(structure.hinges) if hinge.name.startswith("crease"))
    zeros = np.zeros(len(structure.hinges))
    values = {"stiffness": RIGID * (net.creases.law.stiffness + zeros), "rest_angle": zeros.copy()}
    values |= {"quadratic": zeros.copy(), "cubic": zeros.copy()}
    values["stiffness"][[one, two]], values["rest_angle"][[one, two]] = (SPRING, LID[0]), (FLAP_REST, LID_REST)
    values["quadratic"][two], values["cubic"][two] = LID[1], CUBIC
    net = replace(
        net,
        creases=replace(net.creases, law=replace(net.creases.law, **values)),
        springs=replace(net.springs, stiffness=RIGID * net.springs.stiffness),
    )
    return net, *(minimum(net, bent(net, *np.radians(angles))) for angles in ((178.2, 138), (120, 86)))


def bent(net, flap, lid):
    """Return the shape of the net with both outer facets turned about their creases."""
    nodes = net.nodes.copy()
    # the creases are at x = LAYER and x = LAYER + LENGTH
    for out, angle, crease in ((-1, flap, LAYER), (1, lid, LAYER + LENGTH)):
        length = out * (net.nodes[:, 0] - net.nodes[:, 0].min() - crease)
        moved = length > 1e-9
        nodes[moved, 0] += out * (np.cos(angle) - 1) * length[moved]
        nodes[moved, 2] += np.sin(angle) * length[moved]
    return shape_at(net, nodes)


@cache
def saddle():
    """Return the saddle between both states."""
    return find_saddle(*flap_and_lid(), increments=100, tries=1)


def test_the_pass_of_a_lid_that_a_flap_follows_is_that_of_one_coordinate(agree):
    top = minimize_scalar(
        lambda lid: -energy(lid), bounds=np.radians((120, 140)), method="bounded", options={"xatol": 1e-12}
    )
    # closed, the flap lies on the middle facet
    least = math.pi - math.asin(THICK / LAYER)
    shut = brentq(lambda lid: flap_angle(lid) - least, math.radians(140), math.radians(150))
    net, _, _ = flap_and_lid()
    assert saddle().joins
    assert saddle().rest.index == 1
    # facets count as larger by a thousandth of the thickness
    agree("energy of the pass", saddle().rest.energy, -top.fun, by="closed form", unit="J", rel=2e-5)
    agree("barrier", saddle().barriers[0], -top.fun - energy(shut), by="closed form", unit="J", rel=3e-4)
    agree("angle of the lid", saddle().rest.shape.angles[1], top.x, by="closed form", unit="rad", rel=2e-5)
    # the flap presses on the lid with its moment divided by the lever arm of the force
    force = SPRING * (flap_angle(top.x) - FLAP_REST) / (LAYER * abs(math.cos(flap_angle(top.x) + top.x)))
    forces = contact_forces(net, saddle().rest.shape)
    assert list(forces) == ["facet 0 and facet 2"]
    agree("contact force", forces["facet 0 and facet 2"], force, by="closed form", unit="N", rel=1e-3)


@pytest.mark.parametrize(("stiffer", "step"), [(0.5, None), (1.0, 0.005)])
def test_the_pass_depends_neither_on_the_stiffness_of_the_lagrangian_nor_on_the_step_of_the_path(stiffer, step, agree):
    net, closed, opened = flap_and_lid()
    net = replace(net, contact=replace(net.contact, stiffness=stiffer * net.contact.stiffness))
    other = find_saddle(net, closed, opened, step=None if step is None else step * net.size, increments=400, tries=1)
    agree(
        "energy of the pass", other.rest.energy, saddle().rest.energy, by="first stiffness and step", unit="J", rel=1e-8
    )


@pytest.fixture(scope="module")
def letter():
    """Return the landscape of a folded letter with contact, without the loads that its states withstand."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(net_state, "_tried_loads", lambda *_: [])
        return ff.landscape(load_design("letter-fold", CONTACT), points=3)


def test_with_contact_a_landscape_of_plates_has_the_states_of_one_without(letter, agree):
    without = ff.landscape("letter-fold", points=3)
    assert [rest.name for rest in letter.rests] == [rest.name for rest in without.rests]
    for one, other in zip(letter.rests, without.rests, strict=True):
        agree(f"energy {one.name}", one.energy, other.energy, by="landscape without contact", unit="J", rel=1e-5)
    assert not any(state.passing for state in letter.states)
    assert not any("may come to another state" in remark for remark in letter.remarks)
    assert not any("barriers" in remark for remark in letter.remarks)


def test_the_energy_of_a_slow_run_with_contact_rises_to_the_pass_of_both_creases(letter, agree):
    # 10 % more than the least torque, reached within 1.5 s
    slow = {"drive.close.value": "0.22 N cm", "drive.close.rise": "1.5 s"}
    result = ff.run(load_design("letter-fold", CONTACT | slow))
    series = result.record.series
    stored = series["tendon_energy"].sum(axis=1) + series["hinge_energy"].sum(axis=1)
    rest = stored[np.searchsorted(result.record.time, 0.29)]
    climbed = sum(letter.barrier(*pair) for pair in (("flat", "state 3"), ("state 3", "closed")))
    agree("energy climbed", stored.max() - rest, climbed, by="slow run", unit="J", rel=1e-3)
