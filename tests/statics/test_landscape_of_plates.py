"""Landscapes of structures without a single folding path: plates on sprung hinges, and tendons between them."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import ndimage
from scipy.optimize import minimize

import forficula as ff
from forficula.design import with_values
from forficula.errors import InputError
from forficula.statics import landscape_summary
from forficula.statics.tree.ensemble import ensemble
from forficula.statics.tree.potential import potential
from forficula.statics.tree.quasi_static import least_slow_torque, start_state
from forficula.structure import structure_of


@pytest.fixture(scope="module")
def landscape(surveyed):
    return surveyed("plates")


def test_it_rests_flat_closed_and_opened(landscape):
    assert [(state.name, state.stable) for state in landscape.rests] == [
        ("flat", True),
        ("closed", True),
        ("opened", True),
    ]
    flat, closed, opened = landscape.rests
    # at the stops against bending back
    assert flat.angles == pytest.approx(np.full(2, -math.radians(3)))
    assert opened.angles == pytest.approx(flat.angles)
    assert closed.energy < flat.energy


def test_the_resting_shape_equals_that_of_another_minimiser(landscape):
    structures = ensemble([structure_of(ff.load_design("letter-fold"))])
    for state in landscape.rests:
        result = minimize(
            lambda angles: potential(structures, angles[None])[0][0],
            state.angles,
            jac=lambda angles: potential(structures, angles[None])[1][0],
            bounds=list(zip(structures.lower, structures.upper, strict=True)),
            method="L-BFGS-B",
            options={"ftol": 1e-15, "gtol": 1e-12},
        )
        # L-BFGS-B stops at the rounding of the energy, the square of the position's
        assert state.angles == pytest.approx(result.x, abs=1e-5)
        assert state.energy <= result.fun + 1e-12


def test_the_folding_sense_of_a_hinge_is_that_of_its_larger_range(landscape):
    for tendon in landscape.tendons:
        assert math.degrees(tendon.hinge.overbend) == pytest.approx(3)
        assert math.degrees(tendon.hinge.fold_limit) == pytest.approx(175)
        # a crease counts as positive while it folds
        assert tendon.hinge.sense == -1
        assert tendon.barrier > 0
    # nothing couples them
    alone = [tendon.barrier for tendon in landscape.tendons]
    assert landscape.hinge_barriers == pytest.approx(alone, rel=1e-5)


@pytest.mark.parametrize(
    ("stiffness", "rest_angle", "back_limit"),
    [(0.02, 0, 3), (0.12, 0, 3), (0.12, 60, 3), (0.05, 120, 3), (0.05, -60, 120), (0.02, 20, 120)],
)
def test_hinges_fold_alone_exactly_if_tendon_and_spring_give_two_equilibria(stiffness, rest_angle, back_limit):
    """Scan of all angles: tendon by the law of cosines, arms 4.95 and 3.96 cm, and a crease of 21 cm."""
    angles = np.radians(np.linspace(-back_limit, 175, 20001))
    length = np.sqrt(0.0495**2 + 0.0396**2 + 2 * 0.0495 * 0.0396 * np.cos(angles))
    energy = 25 * np.maximum(length - 0.05, 0) ** 2 + stiffness * 0.21 / 2 * (angles - math.radians(rest_angle)) ** 2
    around = np.concatenate([[np.inf], energy, [np.inf]])
    wells = np.flatnonzero((energy < around[:-2]) & (energy < around[2:]))
    crease = {
        "stiffness": f"{stiffness} N m/rad/m",
        "rest_angle": f"{rest_angle} deg",
        "back_limit": f"{back_limit} deg",
        "start": f"{0.9 * math.degrees(angles[wells[0]]):.1f} deg",
    }
    letter = ff.load_design("letter-fold", {f"crease.{key}": value for key, value in crease.items()})
    landscape = ff.landscape(letter, points=61)
    assert sum(state.stable for state in landscape.partial_folds) == len(wells) ** 2
    if len(wells) == 1:
        assert landscape.easiest_barrier is None
        assert landscape.partial_folds[-1].stable or landscape.partial_folds[0].stable
    else:
        climb = energy[wells[0] : wells[1]].max() - energy[wells[0]]
        assert landscape.hinge_barriers == pytest.approx(np.full(2, climb), rel=1e-5)


def test_a_transition_whose_goal_is_already_met_needs_no_torque_and_has_a_remark():
    landscape = ff.landscape(ff.load_design("letter-fold", {"crease.rest_angle": "90 deg"}), points=61)
    assert landscape.least_torques["close"] == 0
    assert (
        'no torque is needed to get closed: the goal of "close" is already met in the state before it'
        in landscape.remarks
    )


def test_both_hinges_fold_alone_and_together(landscape):
    assert [state.folded for state in landscape.partial_folds] == [(), (0,), (1,), (0, 1)]
    assert all(state.stable for state in landscape.partial_folds)
    by_count = [state.energy for state in landscape.partial_folds]
    assert by_count[0] > by_count[1] == pytest.approx(by_count[2])
    assert by_count[1] > by_count[3]


def test_the_least_torque_that_closes_it_is_the_steepest_climb(landscape):
    """For both creases: the largest d energy / d angle of tendon and spring from the stop on, to 1 %."""
    hinge, structure = landscape.tendons[0].hinge, landscape.structure
    folds = np.linspace(-math.radians(3), math.radians(100), 4001)
    spring = structure.hinges[0].stiffness * (folds - structure.hinges[0].rest_angle)
    steepest = float(np.max(hinge.moment(-folds) + spring))
    assert 0.99 * steepest < landscape.least_torques["close"] < 1.03 * steepest


def test_the_least_torque_that_opens_it_is_the_steepest_climb_back(landscape):
    """By the law of cosines, as above: the largest decrease of energy with the angle, between straight and closed."""
    angles = np.radians(np.linspace(0, 105.6, 200001))
    length = np.sqrt(0.0495**2 + 0.0396**2 + 2 * 0.0495 * 0.0396 * np.cos(angles))
    energy = 25 * np.maximum(length - 0.05, 0) ** 2 + 0.02 * 0.21 / 2 * angles**2
    steepest = -float(np.min(np.diff(energy) / np.diff(angles)))
    assert steepest * (1 - 1e-6) < landscape.least_torques["open"] < 1.03 * steepest


def test_results_that_need_a_single_folding_path_are_left_out_or_rejected(landscape):
    assert (landscape.fold_path, landscape.tips, landscape.hinge) == (None, None, None)
    assert landscape.fold_barrier is None
    summary = landscape_summary(landscape)
    assert summary["wing"] is None
    assert [state["name"] for state in summary["rests"]] == ["flat", "closed", "opened"]
    json.dumps(summary, allow_nan=False)


def test_the_path_between_states_leads_over_the_saddles_of_single_hinges(landscape):
    """Nothing couples the hinges: the first folds alone over the barrier of one hinge, then the second."""
    assert [state.name for state in landscape.states] == ["flat", "closed"]
    assert landscape.states == (landscape.rests[0], landscape.rests[1])
    assert landscape.barrier("flat", "closed") == pytest.approx(landscape.easiest_barrier, rel=1e-5)
    (saddle,) = landscape.passes
    top = -landscape.tendons[0].barrier_angle
    # one hinge at its top, the other still flat
    assert sorted(saddle.angles) == pytest.approx(sorted([landscape.rests[0].angles[0], top]), abs=1e-4)


def test_a_barrier_to_a_state_that_does_not_exist_is_not_claimed(landscape):
    with pytest.raises(InputError, match=r'need a stable state of the structure \(flat, closed\), got "halfway"'):
        landscape.barrier("flat", "halfway")


LEFT = {"from": "facet 0 at 0.5, 0.5", "to": "facet 1 at 0.4, 0.5", "rest_length": "5 cm"}


def test_two_tendons_across_one_hinge_are_one_of_twice_the_stiffness():
    def letter(*tendons):
        return ff.landscape(ff.load_design("letter-fold", {"tendon": list(tendons)}), points=61)

    one = letter(LEFT | {"name": "whole", "stiffness": "0.5 N/cm"})
    two = letter(*(LEFT | {"name": name, "stiffness": "0.25 N/cm"} for name in ("upper", "lower")))
    assert two.hinge_barriers == pytest.approx(one.hinge_barriers, rel=1e-4)
    assert [rest.energy for rest in two.rests] == pytest.approx([rest.energy for rest in one.rests])
    said = (
        "upper, lower lie across one hinge, crease 0: each landscape of this hinge includes one of them; all other"
        " results include all of them"
    )
    assert said in two.remarks
    assert not any("lie across" in remark for remark in one.remarks)


def test_tendons_across_several_hinges_are_said_to_be_left_out_of_a_single_one():
    over = {"name": "over", "from": "facet 0 at 0.5, 0.5", "to": "facet 2 at 0.5, 0.5", "stiffness": "0.1 N/cm"}
    tendons = [LEFT | {"name": "left", "stiffness": "0.5 N/cm"}, over | {"rest_length": "5 cm"}]
    remarks = ff.landscape(ff.load_design("letter-fold", {"tendon": tendons}), points=61).remarks
    assert "the landscapes of single hinges leave out tendons across several hinges: over" in remarks


@pytest.mark.parametrize(
    ("stiffness", "rest_angle", "over", "length", "right"),
    [
        (0.02, 0, 0.2, 8, True),
        (0.02, 0, 0.05, 15, True),
        (0.01, 0, 0.3, 12, False),
        (0.05, 30, 0.2, 8, True),
        (0.02, 0, 1.0, 3, False),
    ],
)
def test_states_and_barriers_of_hinges_that_a_tendon_couples(stiffness, rest_angle, over, length, right):
    """The letter with a tendon across both creases: by a grid of plane coordinates over all angles, and flooding.

    The lowest barrier is the level at which the basin of the first state joins another basin.
    """
    ends = {
        "left": ("facet 0 at 0.5, 0.5", "facet 1 at 0.4, 0.5"),
        "right": ("facet 2 at 0.5, 0.5", "facet 1 at 0.6, 0.5"),
    }
    tendons = [
        {"name": name, "from": ends[name][0], "to": ends[name][1], "stiffness": 50.0, "rest_length": 0.05}
        for name in (["left", "right"] if right else ["left"])
    ]
    tendons.append({"name": "over", "from": ends["left"][0], "to": ends["right"][0]})
    tendons[-1] |= {"stiffness": 100 * over, "rest_length": length / 100}
    values = {"tendon": tendons, "crease.stiffness": stiffness, "crease.rest_angle": math.radians(rest_angle)}
    landscape = ff.landscape(with_values(ff.load_design("letter-fold"), values), points=11)

    angles = np.radians(np.linspace(-3, 175, 713))
    one, other = np.meshgrid(angles, angles, indexing="ij")

    def across(angle):
        return 25 * np.maximum(np.sqrt(0.0495**2 + 0.0396**2 + 2 * 0.0495 * 0.0396 * np.cos(angle)) - 0.05, 0) ** 2

    wide = np.hypot(0.099 + 0.0495 * (np.cos(one) + np.cos(other)), 0.0495 * (np.sin(one) - np.sin(other)))
    energy = across(one) + right * across(other) + 50 * over * np.maximum(wide - length / 100, 0) ** 2
    energy += stiffness * 0.21 / 2 * ((one - math.radians(rest_angle)) ** 2 + (other - math.radians(rest_angle)) ** 2)
    wells = np.argwhere(energy == ndimage.minimum_filter(energy, 3))
    result = np.array([state.angles for state in landscape.partial_folds if state.stable])
    apart = np.abs(angles[wells][:, None] - result).max(axis=2)
    assert max(apart.min(axis=0).max(), apart.min(axis=1).max()) < math.radians(0.5)

    # a position that the grid contains twice
    wells = wells[apart.argmin(axis=0)]
    first = tuple(wells[np.abs(angles[wells] - landscape.rests[0].angles).sum(axis=1).argmin()])
    low, high = energy[first], float(energy.max())
    while high - low > 1e-9:
        level = (low + high) / 2
        valleys, _ = ndimage.label(energy <= level, np.ones((3, 3)))
        joined = sum(valleys[tuple(well)] == valleys[first] for well in wells) > 1
        low, high = (low, level) if joined else (level, high)
    if landscape.easiest_barrier is None:  # folded at the start: no hinge is left to fold
        assert (landscape.rests[0].angles > math.radians(90)).all()
    else:
        assert landscape.easiest_barrier == pytest.approx(high - energy[first], rel=0.005)


def test_without_tendons_it_rests_at_one_place_and_nothing_opens_what_never_closed():
    landscape = ff.landscape(ff.load_design("letter-fold", {"tendon": []}), points=11)
    assert [(state.name, state.energy, state.same_as) for state in landscape.rests] == [
        ("flat", 0, ""),
        ("not closed", 0, "flat"),
        ("opened", 0, "flat"),
    ]
    assert landscape.least_torques["close"] > 0
    assert landscape.least_torques["open"] is None
    assert landscape.remarks[-1] == (
        'no slowly growing torque makes it get opened from the state "closed", because it does not rest in this state'
    )


def test_heavy_panels_hang_down():
    """Horizontal, held at the middle panel: the outer panels bend back to their stops."""
    light, heavy = (
        ff.landscape(
            ff.load_design("letter-fold", {"protocol.gravity": gravity, "crease.back_limit": "80 deg"}), points=11
        )
        for gravity in ("0 m/s^2", "9.81 m/s^2")
    )
    assert heavy.rests[0].energy != light.rests[0].energy
    assert (heavy.rests[0].angles < light.rests[0].angles + 1e-12).all()


@settings(max_examples=40)
@given(st.floats(8, 120), st.floats(0.01, 0.2), st.floats(1.05, 4))
def test_the_least_torque_on_springs_alone_is_that_of_springs(goal, stiffness, more):
    """k w (phi - phi0), k per length and a width w, to 1 %, whatever the largest torque of the search."""
    letter = with_values(ff.load_design("letter-fold", {"tendon": []}), {"crease.stiffness": stiffness})
    expected = stiffness * 0.21 * math.radians(goal)
    bound = {"protocol.stages.1.until": f"creases > {goal} deg", "drive.close.value": more * expected}
    structures = ensemble([structure_of(with_values(letter, bound))])
    close = structures.structure.transitions[0]
    result = least_slow_torque(structures, start_state(structures).position, close, more * expected)
    assert 0.999 * expected < result.torque[0] < 1.011 * expected
