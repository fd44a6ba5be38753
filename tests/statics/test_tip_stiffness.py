"""Stiffness against a load at the tips."""

from __future__ import annotations

import math

import pytest

from forficula.design import load_design
from forficula.statics.tree.ensemble import ensemble_of
from forficula.statics.tree.hinge import tendon_hinges
from forficula.statics.tree.quasi_static import start_state
from forficula.statics.tree.tip_stiffness import tip_stiffness
from forficula.structure import structure_of


def loaded(design):
    structures = ensemble_of([design])
    return tip_stiffness(structures, start_state(structures).position)


def test_a_locked_wing_holds_what_its_tendons_press_onto_the_stops(reference):
    hinge = tendon_hinges(structure_of(reference))[0]
    # the distal bar meets the ring crease at 90 deg less half the sector angle, less epsilon
    lever = 0.10 * math.cos(math.radians(10) + reference.fan.epsilon)
    result = loaded(reference)
    assert result.holding_force == pytest.approx(float(hinge.moment(math.radians(3))) / lever, rel=2e-3)
    assert result.flat_against is None
    assert result.deflection == pytest.approx(1e-3)


def test_along_folding_the_locked_wing_is_as_stiff_as_the_secant_says(reference):
    hinge = tendon_hinges(structure_of(reference))[0]
    lever = 0.10 * math.cos(math.radians(10) + reference.fan.epsilon)
    bent = math.radians(3) - 1e-3 / lever
    result = loaded(reference)
    assert result.flat_along == pytest.approx(float(hinge.moment(bent)) / lever / 1e-3, rel=0.02)
    assert result.flat_along * result.deflection < result.holding_force


def test_unlocked_it_runs_away_by_itself(reference):
    """-k a b (1 - lambda) / l_d^2 for the tendon alone; the membrane makes it slightly less negative."""
    hinge = tendon_hinges(structure_of(reference))[0]
    lever = 0.10 * math.cos(math.radians(10) + reference.fan.epsilon)
    result = loaded(reference)
    assert result.unlocked_along == result.unlocked_against
    assert result.unlocked_along == pytest.approx(float(hinge.stiffness(0.0)) / lever**2, rel=0.03)
    assert result.unlocked_along < 0 < result.flat_along


def test_without_an_overbend_nothing_locks():
    result = loaded(load_design("binder2025", {"hinge.overbend": "0 deg", "protocol.initial_overbend": "0 deg"}))
    assert result.flat_against == result.unlocked_against
    assert result.holding_force == pytest.approx(0, abs=1e-6)
