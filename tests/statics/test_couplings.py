"""Coupled joints at rest: springs between them add up, and rigid couplings are the limit of stiff ones."""

import math
from dataclasses import replace

import numpy as np
import pytest

from forficula.design import load_design, with_values
from forficula.errors import InputError
from forficula.statics import energy_landscape
from forficula.statics.tree.couplings import ties_of
from forficula.statics.tree.ensemble import ensemble, ensemble_of
from forficula.statics.tree.potential import rest, stored_energy
from forficula.statics.tree.quasi_static import least_slow_torque, start_state, state_beyond
from forficula.structure import GROUND, Body, Coupling, Hinge, Motor, Structure, hinges_of
from tests.statics.test_potential import check_derivatives
from tests.statics.trees import tree

TIED = load_design("binder2025-coupled")
SPRINGS = (0.03, 0.05, 0.02)
MOST = 0.5


def levers(stiffness, ratios=(1.0, 1.0), springs=SPRINGS, **limits):
    """Return bodies side by side, each on a sprung hinge coupled to the next; a motor drives the first."""
    hinges = [
        Hinge(name=f"h{number}", role="hinge", body=number, axis=np.array([0.0, 0.0, 1.0]), stiffness=spring, **limits)
        for number, spring in enumerate(springs)
    ]
    return Structure(
        name="levers",
        bodies=tuple(
            Body(name=f"b{number}", role="body", parent=GROUND, position=np.zeros(3), frame=np.eye(3))
            for number in range(len(springs))
        ),
        points=(),
        hinges=tuple(hinges),
        couplings=tuple(
            Coupling(name=f"c{number}", hinges=(number, number + 1), stiffness=stiffness, ratio=ratio)
            for number, ratio in enumerate(ratios)
        ),
        motors=(Motor(name="first", hinges=(0,)),),
        span=0.1,
        mass=0.1,
    )


def pushed(built, torque):
    return rest(ensemble([built]), np.zeros((1, len(built.hinges))), [torque])


@pytest.mark.parametrize("ratios", [(1.0, 1.0), (2.0, -0.5)])
def test_joints_tied_rigidly_turn_as_their_springs_together_let_them(ratios):
    turns = np.array([1.0, ratios[0], ratios[0] * ratios[1]])
    result = pushed(levers(math.inf, ratios), 0.04)
    assert result.position[0] == pytest.approx(0.04 / (SPRINGS @ turns**2) * turns, rel=1e-6)
    assert result.rests.all()
    assert result.stiffness[0] == pytest.approx(SPRINGS @ turns**2)


def test_a_spring_between_joints_turns_the_second_by_its_share():
    """k2 and the coupling c act in series: k2 c / (k2 + c), in parallel with the spring of the first."""
    first, second, tie = 0.03, 0.05, 0.04
    result = pushed(levers(tie, (1.0,), (first, second)), 0.04)
    angle = 0.04 / (first + second * tie / (second + tie))
    assert result.position[0] == pytest.approx([angle, angle * tie / (second + tie)], rel=1e-5)
    energy = stored_energy(ensemble([levers(tie, (1.0,), (first, second))]), result.position)
    assert energy["couplings"][0] == pytest.approx(tie / 2 * (angle * second / (second + tie)) ** 2, rel=1e-5)


def test_a_stop_of_one_joint_stops_all_that_are_tied_to_it():
    built = levers(math.inf, (2.0, 1.0), upper=0.3)
    assert pushed(built, 1.0).position[0] == pytest.approx([0.15, 0.3, 0.3])
    # a stop bears what the springs do not, for any joint that has the stop
    slope = pushed(built, 1.0).slope[0]
    assert slope @ [1.0, 2.0, 2.0] == pytest.approx(SPRINGS @ np.array([0.15, 0.6, 0.6]) - 1.0)


def test_joints_that_start_apart_start_in_the_middle_and_held_ones_hold_all():
    built = ensemble([levers(math.inf, springs=(0.0, 0.0, 0.0))])
    assert rest(built, np.array([[0.0, 0.3, 0.6]])).position[0] == pytest.approx([0.3] * 3)
    assert rest(built, np.array([[0.0, 0.3, 0.6]]), fixed=[2]).position[0] == pytest.approx([0.6] * 3)


def test_ties_in_a_ring_fit_together_or_are_refused():
    built = levers(math.inf, (2.0, 3.0))
    ring = (*built.couplings, Coupling(name="c2", hinges=(0, 2), stiffness=math.inf, ratio=6.0))
    assert ties_of(replace(built, couplings=ring)).ratio == pytest.approx([1, 2, 6])
    jammed = (*built.couplings, Coupling(name="c2", hinges=(0, 2), stiffness=math.inf, ratio=5.0))
    with pytest.raises(InputError, match="h0 and h2 tied with the ratios 6 and 5"):
        ties_of(replace(built, couplings=jammed))


@pytest.mark.parametrize("seed", [1, 2, 3])
def test_slope_and_curvature_with_ties_are_derivatives(seed):
    built = tree(seed)
    random = np.random.default_rng(seed)
    first, second, third = random.choice(len(built.hinges), 3, replace=False).tolist()
    ties = (
        Coupling(name="c0", hinges=(first, second), stiffness=0.2, ratio=-1.5),
        Coupling(name="c1", hinges=(second, third), stiffness=0.05),
    )
    angles = random.uniform(-0.5, 0.5, (1, len(built.hinges)))
    check_derivatives(ensemble([replace(built, couplings=ties)]), angles, np.zeros((1, 0)))


def least(design):
    wings = ensemble_of([design])
    return least_slow_torque(wings, start_state(wings).position, wings.structure.transitions[0], MOST)


def tied(stiffness, veins=(0,)):
    return with_values(TIED, {"coupling.stiffness": stiffness, "protocol.driven_veins": list(veins)})


def test_the_least_slow_torque_of_one_motor_is_that_of_all_together():
    one, all_three = (least(tied("rigid", veins)).torque[0] for veins in ((0,), (0, 1, 2)))
    # 1 % each
    assert one == pytest.approx(3 * all_three, rel=0.02)


def test_stiffer_couplings_converge_to_the_rigid_one_and_soft_ones_leave_the_wing_open():
    rigid, stiff = least(tied("rigid")), least(tied(1e4))
    assert stiff.torque[0] == pytest.approx(rigid.torque[0], rel=1e-9)
    turns = list(hinges_of(ensemble_of([TIED]).structure, "turn"))
    assert np.ptp(rigid.position[0, turns]) < 1e-12
    assert math.isnan(least(tied(0.01)).torque[0])


def test_a_tied_wing_rests_folded_with_all_veins_turned_by_the_same_angle():
    wings = ensemble_of([TIED])
    beyond = state_beyond(wings, wings.structure.transitions[0])
    turns = list(hinges_of(wings.structure, "turn"))
    assert np.degrees(beyond.position[0, turns]) == pytest.approx([90.0] * 3)
    assert beyond.rests.all()


def test_the_landscape_of_a_coupled_wing_includes_the_energy_of_its_couplings():
    output = energy_landscape(tied(0.3), points=31)
    assert {"tendons", "membranes", "couplings"} == set(output.rests[0].stored)
    assert output.least_torques["fold"] == pytest.approx(least(tied(0.3)).torque[0])
    # as for every rest of a landscape
    wings = ensemble_of([TIED])
    assert "couplings" not in stored_energy(wings, start_state(wings).position)
