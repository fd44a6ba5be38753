"""Energy of membrane and guards, against numerical differentiation, the simulator's, and rigid motions."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.design import load_design, with_values
from forficula.statics.sheet import sheet_energy, wing_sheet
from forficula.statics.wing import FOLD, TURN, flat_wing, pose

REFERENCE = load_design("binder2025")
DENSE = with_values(
    REFERENCE,
    {
        "pattern.units": 2,
        "pattern.sector_angle": math.radians(15),
        "membrane.proximal_rows": [0.3, 0.6],
        "membrane.distal_rows": [0.5],
    },
)
JOINTS = ("sweep_angle", "lift_angle", "turn_angle", "distal_angle")


def sheet_of(design):
    return wing_sheet(flat_wing(design))


SHEETS = [sheet_of(REFERENCE), sheet_of(DENSE)]


@settings(deadline=None, max_examples=20)
@given(st.sampled_from(SHEETS), st.integers(0, 1000), st.floats(0.01, 1))
def test_slope_and_curvature_are_derivatives_of_the_energy(sheet, seed, spread):
    veins, small = sheet.panels + 1, 1e-4
    angles = np.random.default_rng(seed).uniform(-spread, spread, (1, veins, 4))
    _, slope, curvature = sheet_energy(sheet, angles)
    slopes, curvatures, pulls = zip(*(differences(sheet, angles, step) for step in (small, small / 2)), strict=True)
    stiff = np.abs(curvature).max()
    # Richardson's extrapolation: an error of 1e-16 of the stiffness, four times differentiated; rounding of the energy
    # by 1e-4; where a guard begins to pull the curvature jumps, which no step may cross
    if not any(pulls):
        assert slope[0] == pytest.approx((4 * slopes[1] - slopes[0]) / 3, abs=1e-9 * stiff)
        assert curvature[0] == pytest.approx((4 * curvatures[1] - curvatures[0]) / 3, abs=1e-9 * stiff)
    assert curvature[0] == pytest.approx(curvature[0].T, abs=1e-14 * stiff)


def differences(sheet, angles, step):
    """Central differences of energy and slope, and whether a guard begins to pull between them."""
    steps = step * np.eye(angles.size).reshape(-1, *angles.shape[1:])
    ahead, behind = sheet_energy(sheet, angles + steps), sheet_energy(sheet, angles - steps)
    begins = guards_begin(sheet, np.concatenate([angles + steps, angles - steps]))
    return (ahead[0] - behind[0]) / (2 * step), (ahead[1] - behind[1]) / (2 * step), begins


def guards_begin(sheet, angles):
    tips = pose(sheet.wing, angles).points[:, sheet.wing.tips]
    pulls = np.linalg.norm(np.diff(tips, axis=1), axis=2) > sheet.guard_lengths
    return (pulls != pulls[0]).any()


@pytest.mark.parametrize("sheet", SHEETS)
def test_the_flat_wing_stores_nothing_and_nothing_moves_it(sheet):
    energy, slope, curvature = sheet_energy(sheet, np.zeros((1, sheet.panels + 1, 4)))
    # rounding of a strain of 1e-16
    assert energy[0] == pytest.approx(0, abs=1e-25)
    assert slope[0] == pytest.approx(0, abs=1e-12)
    assert np.linalg.eigvalsh(curvature[0]).min() > -1e-12 * curvature.max()


def test_all_along_the_reference_the_membrane_has_the_energy_of_the_record(reference_run):
    sheet = sheet_of(with_values(reference_run.design, {"guard.stretch": 10.0}))
    energy = sheet_energy(sheet, np.stack([reference_run.series[name] for name in JOINTS], axis=2))[0]
    record = reference_run.series["membrane_energy"]
    assert record.max() > 1e-3
    # rounding
    assert energy == pytest.approx(record, rel=1e-9, abs=1e-12)


@given(st.floats(-math.pi, math.pi))
def test_what_turns_as_a_whole_stores_what_it_did(angle):
    """Without a hub all veins start at one point: a sweep of all is a rigid motion."""
    sheet = sheet_of(with_values(REFERENCE, {"pattern.hub_radius": 0.0}))
    angles = np.random.default_rng(1).uniform(-0.3, 0.3, (1, 3, 4))
    turned = angles + np.array([angle, 0, 0, 0])
    energy, slope, curvature = sheet_energy(sheet, angles)
    other = sheet_energy(sheet, turned)
    # rounding
    assert other[0] == pytest.approx(energy, rel=1e-11)
    assert other[1] == pytest.approx(slope, abs=1e-11 * np.abs(slope).max())
    assert other[2] == pytest.approx(curvature, abs=1e-11 * np.abs(curvature).max())
    assert slope[0, 0::4].sum() == pytest.approx(0, abs=1e-11 * np.abs(slope).max())


def test_a_guard_pulls_beyond_its_length_only():
    """Two tips spread by sweeping an outer vein: the distance of the tips, less the guard's length, on a spring."""
    soft = with_values(REFERENCE, {"membrane.youngs_modulus": 1e6})
    slack, taut = sheet_of(with_values(soft, {"guard.stretch": 10.0})), sheet_of(soft)
    angles = np.zeros((2, 3, 4))
    angles[:, 2, 0] = [0.001, 0.1]
    tips = pose(taut.wing, angles).points[:, taut.wing.tips]
    beyond = np.linalg.norm(tips[:, 2] - tips[:, 1], axis=1) - taut.guard_lengths[1]
    assert beyond[0] < 0 < beyond[1]
    more = sheet_energy(taut, angles)[0] - sheet_energy(slack, angles)[0]
    spring = 100 * 1e6 * REFERENCE.membrane.thickness
    assert more == pytest.approx([0, spring / 2 * beyond[1] ** 2])


@settings(deadline=None)
@given(st.floats(0.3, 3))
def test_energy_goes_with_the_modulus_and_the_thickness(factor):
    angles = np.zeros((1, 3, 4))
    angles[..., TURN], angles[..., FOLD] = 0.7, -1.2
    energy = sheet_energy(SHEETS[0], angles)[0]
    for key in ("youngs_modulus", "thickness"):
        stiffer = {f"membrane.{key}": factor * getattr(REFERENCE.membrane, key)}
        assert sheet_energy(sheet_of(with_values(REFERENCE, stiffer)), angles)[0] == pytest.approx(factor * energy)
