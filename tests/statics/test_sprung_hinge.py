"""A hinge with a spring in parallel with its tendon, compared with independently computed numbers."""

import math
from dataclasses import replace

import numpy as np
import pytest

from forficula.design import load_design
from forficula.statics import HingeSpring, hinge_landscape, ideal_hinges
from forficula.structure import structure_of


@pytest.fixture(scope="module")
def hinge():
    return ideal_hinges(structure_of(load_design("binder2025")))[0]


def test_a_very_soft_spring_hardly_changes_the_landscape(hinge):
    alone = hinge_landscape(hinge)
    sprung = hinge_landscape(hinge, spring=HingeSpring(stiffness=1e-9, rest_angle=0.0))
    assert sprung.barrier == pytest.approx(alone.barrier, rel=1e-6)
    assert sprung.barrier_angle == pytest.approx(0.0, abs=1e-6)
    assert sprung.holding_torque == pytest.approx(alone.holding_torque, rel=1e-6)
    assert sprung.peak_opening.torque == pytest.approx(alone.peak_opening.torque, rel=1e-6)
    assert sprung.peak_opening.angle == pytest.approx(alone.peak_opening.angle, abs=1e-5)
    assert sprung.growth_rate == pytest.approx(alone.growth_rate, rel=1e-6)
    assert sprung.states[0].angle == alone.states[0].angle


def test_states_barrier_and_peak_are_those_of_the_sum(hinge):
    spring = HingeSpring(stiffness=0.05, rest_angle=math.radians(-20))
    result = hinge_landscape(hinge, spring=spring)
    angle = np.linspace(hinge.overbend, -hinge.fold_limit, 400_001)
    energy = hinge.energy(angle) + 0.05 / 2 * (angle - spring.rest_angle) ** 2
    top = int(np.argmax(energy))
    assert result.barrier == pytest.approx(energy[top] - energy[0], rel=1e-6)
    assert result.barrier_angle == pytest.approx(angle[top], abs=1e-4)
    # the spring rests on the folded side and moves the energy maximum into the overbend
    assert result.barrier_angle > 0
    bottom = top + int(np.argmin(energy[top:]))
    assert [state.kind for state in result.states] == ["stop", "minimum"]
    assert result.states[1].angle == pytest.approx(angle[bottom], abs=1e-4)
    moment = -np.gradient(energy, angle)
    assert result.peak_opening.torque == pytest.approx(-moment[top:bottom].min(), rel=1e-6)
    assert result.holding_torque == pytest.approx(moment[1], rel=1e-3)
    assert result.stored_energy(result.angle) == pytest.approx(result.energy + result.spring_energy)


def test_a_too_stiff_spring_leaves_one_state_and_gives_a_remark(hinge):
    result = hinge_landscape(hinge, spring=HingeSpring(stiffness=10.0, rest_angle=0.0))
    assert (result.barrier, result.peak_opening, result.growth_rate) == (None, None, None)
    (state,) = result.states
    assert (state.kind, state.angle) == ("minimum", pytest.approx(0.0, abs=1e-9))
    assert "rests only at 0 deg, so there is no barrier" in result.remarks[0]


def test_a_slack_tendon_leaves_the_spring_alone(hinge):
    slack = replace(hinge, law=replace(hinge.law, rest_length=1.0))
    result = hinge_landscape(slack, spring=HingeSpring(stiffness=0.1, rest_angle=-1.0))
    assert [state.angle for state in result.states] == pytest.approx([-1.0])
    assert "only the spring of the hinge moves it" in result.remarks[0]
