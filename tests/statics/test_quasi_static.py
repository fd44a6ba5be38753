"""Slowly growing torques: folding and opening without help by inertia, independent of the torque's steps."""

import numpy as np
import pytest

from forficula.design import load_design, with_values
from forficula.statics import tendon_hinges
from forficula.statics.tree import potential as potential_module
from forficula.statics.tree import quasi_static
from forficula.statics.tree import sheet as sheet_module
from forficula.statics.tree.ensemble import ensemble_of
from forficula.statics.tree.quasi_static import start_state, state_beyond
from forficula.structure import Drive, hinges_of, structure_of
from tests.statics.hinge_numbers import peak_opening_torque

REFERENCE = load_design("binder2025")
# stiffness in N/cm, resting length in cm: on both sides of the map's boundaries
CELLS = [(10, 5), (10, 6), (10, 7), (10, 9), (20, 8), (20, 9), (30, 9), (40, 9)]
FOLDS = [None, None, 10, 10, None, 10, None, None]
OPENS = [None, 100, 70, 30, 90, 50, 70, 100]  # N cm
DESIGNS = [
    with_values(REFERENCE, {"tendon.stiffness": 100.0 * stiffness, "tendon.rest_length": length / 100})
    for stiffness, length in CELLS
]


FOLDS_AT = list(hinges_of(structure_of(REFERENCE), "ring"))
FOLD, UNFOLD = structure_of(REFERENCE).transitions
BY_NAME = {"fold": FOLD, "unfold": UNFOLD}
DISTAL = Drive(name="distal", shares=(0.0, 1.0), rise=0.0, key="", strength=1.0)


def flat_state(wings):
    return start_state(wings).position


def folded_state(wings):
    return state_beyond(wings, FOLD).position


def slow_transition(wings, start, name, torques):
    return quasi_static.slow_transition(wings, start, BY_NAME[name], torques)


def least_slow_torque(wings, start, name, most):
    return quasi_static.least_slow_torque(wings, start, BY_NAME[name], most)


def least(drive, steps):
    """Return the least torque, N cm; None where none suffices."""
    wings = ensemble_of(DESIGNS)
    start = flat_state(wings) if drive == "fold" else folded_state(wings)
    torques = slow_transition(wings, start, drive, np.array(steps) / 100).torque
    return [None if np.isnan(torque) else float(torque) * 100 for torque in torques]


def rounded_up(torques):
    """Return a torque rounded up to 10 N cm."""
    return [None if torque is None else 10 * int(np.ceil(torque / 10 - 1e-9)) for torque in torques]


@pytest.mark.parametrize("step", [10, 2.5])
def test_torques_that_grow_in_smaller_steps_fold_and_open_the_same_wings(step):
    assert rounded_up(least("fold", np.arange(step, 51, step))) == FOLDS
    assert rounded_up(least("unfold", np.arange(step, 101, step))) == OPENS


@pytest.mark.parametrize(
    ("module", "name", "value"),
    [(potential_module, "_LONGEST_STEP", 0.05), (sheet_module, "_LIMIT_STIFFNESS", 300.0)],
)
def test_what_folds_and_opens_does_not_depend_on_the_steps_or_on_the_guards_stiffness(monkeypatch, module, name, value):
    monkeypatch.setattr(module, name, value)
    assert least("fold", range(10, 51, 10)) == FOLDS
    assert least("unfold", range(10, 101, 10)) == OPENS


def test_the_least_torque_on_the_distal_hinges_is_the_largest_moment_of_their_tendons():
    """With equally opening hinges panels do not interact: the torque is the largest moment (docs/model/theory.md)."""
    wings = ensemble_of([REFERENCE])
    folded = folded_state(wings)
    peak = peak_opening_torque(tendon_hinges(structure_of(REFERENCE))[0]).torque
    result = quasi_static.least_slow_torque(wings, folded, UNFOLD, 4 * peak, DISTAL)
    # 1 % from the search, which rounds up
    assert 0.99 * peak < result.torque[0] < 1.02 * peak
    assert (result.position[0, FOLDS_AT] > 0).all()
    below, above = (
        quasi_static.least_slow_torque(wings, folded, UNFOLD, share * peak, DISTAL).torque for share in (0.98, 1.02)
    )
    assert np.isnan(below).all()
    assert above == pytest.approx([peak], rel=0.02)


@pytest.fixture(scope="module")
def slowly_folded():
    """Return the reference, its flat state, and its path under a slowly growing folding torque up to 20 N cm."""
    wings = ensemble_of([REFERENCE])
    flat = flat_state(wings)
    return wings, flat, least_slow_torque(wings, flat, "fold", 0.2)


def test_the_least_fold_torque_is_that_of_small_equal_steps(slowly_folded):
    wings, flat, least_torque = slowly_folded
    result = least_torque.torque[0]
    ramp = slow_transition(wings, flat, "fold", np.arange(0.0001, 0.01, 0.0001)).torque[0]
    # 1 % from the search, and one step of 1e-4 N m of 7e-3
    assert result == pytest.approx(ramp, rel=0.03)


def test_hinges_turn_by_less_than_a_tenth_from_equilibrium_to_equilibrium_without_a_snap(slowly_folded):
    wings, flat, least_torque = slowly_folded
    recorded = quasi_static.least_slow_torque(wings, flat, FOLD, 0.2, recorded=True)
    (path,) = recorded.paths
    turned = np.abs(np.diff(path.position, axis=0)).max(axis=1)
    snapping = np.zeros(len(turned), dtype=bool)
    for first, last in path.snaps:
        snapping[first:last] = True
    assert recorded.torque == least_torque.torque
    assert snapping.any()
    assert turned[~snapping].max() <= 0.1
    # a step is lengthened until it turns the hinges by more than half of this
    assert np.median(turned[~snapping]) > 0.02


def test_wings_side_by_side_have_the_least_torques_that_they_have_alone():
    pair = [DESIGNS[3], DESIGNS[5]]
    wings = ensemble_of(pair)
    together = least_slow_torque(wings, flat_state(wings), "fold", 0.2).torque
    assert np.isfinite(together).all()
    for case, design in enumerate(pair):
        alone = ensemble_of([design])
        torque = least_slow_torque(alone, flat_state(alone), "fold", 0.2).torque
        assert torque == pytest.approx(together[case : case + 1], rel=0.02)


def test_a_wing_at_its_goal_needs_no_torque_and_one_that_never_gets_there_has_none():
    wings = ensemble_of([REFERENCE, with_values(REFERENCE, {"tendon.rest_length": 0.03})])
    folded, flat = folded_state(wings), flat_state(wings)
    assert least_slow_torque(wings, folded, "fold", 0.5).torque.tolist() == [0, 0]
    assert least_slow_torque(wings, flat, "unfold", 0.5).torque.tolist() == [0, 0]
    assert np.isnan(least_slow_torque(wings, flat, "fold", 0.001).torque).all()
    assert np.isnan(slow_transition(wings, flat, "fold", [0.001]).torque).all()


def test_a_negative_torque_goes_the_other_way(slowly_folded):
    """The fold's drive with its sense reversed twice is the fold's drive."""
    wings, flat, present = slowly_folded
    turned = Drive(name="turned", shares=(-1.0, 0.0), rise=0.0, key="", strength=-0.5)
    back = quasi_static.least_slow_torque(wings, flat, FOLD, 0.2, turned)
    assert present.torque == back.torque
    assert present.position == pytest.approx(back.position)
