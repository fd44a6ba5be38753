"""The whole potential of a wing: its derivatives, its tendons, the work of torques, and where wings rest."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.design import load_design, with_values
from forficula.errors import InputError
from forficula.statics import wing_hinges
from forficula.statics.potential import FOLD, SWEEP, TURN, potential, rest, section, straight_start
from forficula.statics.sheet import sheet_energy

REFERENCE = load_design("binder2025")
TENDONS = [(1000.0, 0.09), (3000.0, 0.05), (6000.0, 0.0)]
DESIGNS = [with_values(REFERENCE, {"tendon.stiffness": k, "tendon.rest_length": rest}) for k, rest in TENDONS]
WINGS = section(DESIGNS)
NONE = np.zeros(3)


@settings(deadline=None, max_examples=20)
@given(st.integers(0, 1000))
def test_it_is_the_sheet_and_the_tendons_less_the_work_of_torques(seed):
    angles = np.random.default_rng(seed).uniform(-0.5, 0.5, (3, 12))
    by_vein = angles.reshape(3, 3, 4)
    proximal, distal = np.array([0.1, 0.2, 0.3]), np.array([0.0, -0.1, 0.4])
    energy = potential(WINGS, angles, proximal, distal)[0]
    tendons = [
        sum(float(hinge.energy(angle)) for hinge, angle in zip(wing_hinges(design), folds, strict=True))
        for design, folds in zip(DESIGNS, by_vein[:, :, FOLD], strict=True)
    ]
    # torques towards folding turn the veins forwards and the hinges to negative angles
    work = proximal * by_vein[:, :, TURN].sum(axis=1) - distal * by_vein[:, :, FOLD].sum(axis=1)
    assert energy == pytest.approx(sheet_energy(WINGS.sheet, by_vein)[0] + tendons - work, rel=1e-12)


@settings(deadline=None, max_examples=20)
@given(st.integers(0, 1000), st.floats(-0.5, 0.5), st.floats(-0.5, 0.5))
def test_slope_and_curvature_are_its_derivatives(seed, proximal, distal):
    small, one = 1e-5, section(DESIGNS[:1])
    # tips close enough to leave the guards slack, tendons taut
    angles = np.random.default_rng(seed).uniform(-0.05, 0.05, (1, 12))
    angles[:, TURN::4] += 0.5
    both = np.array([proximal]), np.array([distal])
    _, slope, curvature = potential(one, angles, *both)
    many, steps = one.only(np.zeros(12, dtype=np.int64)), small * np.eye(12)
    torques = [np.repeat(torque, 12) for torque in both]
    ahead, behind = potential(many, angles + steps, *torques), potential(many, angles - steps, *torques)
    stiff = np.abs(curvature).max()
    # central differences
    assert slope[0] == pytest.approx((ahead[0] - behind[0]) / (2 * small), abs=1e-8 * stiff)
    assert curvature[0] == pytest.approx((ahead[1] - behind[1]) / (2 * small), abs=1e-7 * stiff)


def test_wings_side_by_side_do_not_touch_each_other():
    together = rest(WINGS, straight_start(WINGS), 0.1)
    for case in range(3):
        alone = rest(section(DESIGNS[case : case + 1]), straight_start(WINGS)[case : case + 1], 0.1)
        # the same steps, but for what counts as no torque, which goes with the stiffest tendon
        assert alone.energy[0] == pytest.approx(together.energy[case], abs=1e-9)
        # a hinge with a slack tendon hardly resists
        assert alone.position[0] == pytest.approx(together.position[case], abs=0.01)


def test_wings_that_rest_have_no_torque_left_but_on_their_stops():
    found = rest(WINGS, straight_start(WINGS), 0.1)
    assert found.rests.all()
    free = (found.position > WINGS.lower) & (found.position < WINGS.upper)
    assert np.abs(found.slope[free]).max() < 1e-4
    on_upper = found.position == WINGS.upper
    assert (found.slope[on_upper] <= 1e-4).all()
    assert (found.slope[found.position == WINGS.lower] >= -1e-4).all()


def test_joints_that_are_held_stay_and_none_turns_farther_than_it_may():
    start = straight_start(WINGS)
    start[:, TURN::4] = 0.4
    held = rest(WINGS, start, fixed=(TURN, FOLD)).position
    assert (held[:, TURN::4] == 0.4).all()
    assert (held[:, FOLD::4] == start[:, FOLD::4]).all()
    assert np.abs(held[:, SWEEP::4]).max() > 0.01
    near = rest(WINGS, start, 0.3, within=0.1).position
    assert np.abs(near - start).max() == pytest.approx(0.1)


def test_wings_of_another_pattern_are_refused():
    other = with_values(REFERENCE, {"name": "wide", "pattern.sector_angle": math.radians(25)})
    with pytest.raises(InputError, match="wide: need wings that differ in their tendons only, got another pattern"):
        section([REFERENCE, other])
