"""Fold angles: their sign, their continuation beyond contact, slopes and curvatures."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.statics.net.fold_angle import (
    add_curvature,
    angle_gradients,
    corner_shares,
    crease_frames,
    fold_angles,
)


def fold_angle_derivatives(sides):
    """Return the gradient of fold angles by coordinate and side, and their Hessian by pairs of these."""
    frames, curvature = crease_frames(sides), np.zeros((3, 3, 3, 3, sides.shape[2]))
    shares = corner_shares(sides, frames)
    slope = angle_gradients(frames, shares)
    add_curvature(curvature, frames, shares, slope, np.ones(sides.shape[2]))
    return slope, curvature


def sides(angle, left=(0.3, 1.0), right=(0.6, 0.8)):
    """Return a crease along x whose left panel is turned up by an angle, with heights and offsets of the corners."""
    up = (left[0], left[1] * np.cos(angle), left[1] * np.sin(angle))
    return np.array([(1.5, 0, 0), up, (right[0], -right[1], 0)]).T[:, :, None]


@pytest.mark.parametrize("angle", [-3.1, -1.0, 0.0, 1e-9, 0.7, 3.1])
def test_a_left_panel_that_rises_folds_a_valley(angle):
    assert fold_angles(sides(angle), np.zeros(1)) == pytest.approx([angle], abs=1e-14)


def test_a_panel_that_passes_through_contact_goes_on_without_a_jump():
    angle = np.zeros(1)
    for turned in np.linspace(0, 9, 50):
        angle = fold_angles(sides(turned), angle)
        assert angle == pytest.approx([turned], abs=1e-12)


@settings(deadline=None, max_examples=40)
@given(st.integers(0, 10**6))
def test_slope_and_curvature_are_those_of_the_angle(seed):
    current = np.random.default_rng(seed).standard_normal((3, 3, 1))
    near, step = fold_angles(current, np.zeros(1)), 1e-6
    slope, curvature = fold_angle_derivatives(current)
    scale = np.abs(curvature).max()
    for side, axis in np.ndindex(3, 3):
        off = np.zeros((3, 3, 1))
        off[axis, side] = step
        rise = (fold_angles(current + off, near) - fold_angles(current - off, near)) / (2 * step)
        assert slope[axis, side, 0] == pytest.approx(rise[0], rel=1e-4, abs=1e-6 * scale)
        rises = (fold_angle_derivatives(current + off)[0] - fold_angle_derivatives(current - off)[0]) / (2 * step)
        np.testing.assert_allclose(curvature[axis, :, side, :, 0], rises[:, :, 0], atol=1e-4 * scale)


@pytest.mark.parametrize("angle", [0.0, 1e-12, np.pi, np.pi - 1e-9])
def test_nothing_is_singular_at_flat_and_at_contact(angle):
    slope, curvature = fold_angle_derivatives(sides(angle))
    assert slope[:, 1, 0] == pytest.approx((0, -np.sin(angle), np.cos(angle)), abs=1e-12)
    assert np.all(np.isfinite(curvature))
