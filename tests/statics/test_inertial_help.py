"""Snaps on a slow path that release more energy than the rest of the path absorbs."""

import math

import numpy as np
import pytest

from forficula.design import load_design
from forficula.statics.tree import quasi_static
from forficula.statics.tree.ensemble import ensemble_of
from forficula.statics.tree.inertial_help import inertial_help
from forficula.statics.tree.potential import potential
from forficula.statics.tree.quasi_static import TorquePath, least_slow_torque, start_state
from forficula.structure import Drive, drive_of, hinges_of

WINGS = ensemble_of([load_design("binder2025")])
RINGS = list(hinges_of(WINGS.structure, "ring"))
PUSH = Drive(name="push", shares=(0.0, 1.0), rise=0.0, key="", strength=1.0)


def path(angles, torques, snap):
    """Return a path: one ring hinge at these angles, deg, all others at 0; one tendon with changing energy."""
    position = np.zeros((len(angles), WINGS.size))
    position[:, RINGS[1]] = np.radians(angles)
    return TorquePath(
        torque=np.array(torques) / 100, position=position, snaps=(snap, (len(angles) - 2, len(angles) - 1))
    )


def test_a_snap_helps_where_it_releases_more_than_the_rest_of_the_path_climbs(monkeypatch):
    """With an energy of 1, 3, 0, 1.5, 0 J at the five steps, the snap from 3 to 0 J releases more than 1.5 J."""
    levels = np.array([1.0, 3.0, 0.0, 1.5, 0.0])
    monkeypatch.setattr("forficula.statics.tree.inertial_help.potential", lambda _, on, __: (levels[-len(on) :],))
    helped = inertial_help(WINGS, path([0, -10, -20, -30, -40], [0, 5, 5, 9, 9], (1, 2)), PUSH)
    assert helped is not None
    assert (helped.torque, helped.released, helped.barrier) == pytest.approx((0.05, 3.0, 1.5))
    levels[1] = 1.4
    assert inertial_help(WINGS, path([0, -10, -20, -30, -40], [0, 5, 5, 9, 9], (1, 2)), PUSH) is None


def test_a_snap_at_nearly_the_least_torque_is_no_help(monkeypatch):
    levels = np.array([1.0, 3.0, 0.0, 1.5, 0.0])
    monkeypatch.setattr("forficula.statics.tree.inertial_help.potential", lambda _, on, __: (levels[-len(on) :],))
    assert inertial_help(WINGS, path([0, -10, -20, -30, -40], [0, 8.8, 8.8, 9, 9], (1, 2)), PUSH) is None


@pytest.fixture(scope="module")
def folding():
    """Return the reference design and its path while a slowly growing torque folds it."""
    start = start_state(WINGS).position
    return start, least_slow_torque(WINGS, start, WINGS.structure.transitions[0], 0.2, recorded=True)


def test_a_recorded_path_goes_from_the_start_to_the_goal_in_short_steps(folding):
    start, slow = folding
    (result,) = slow.paths
    assert result.position[0] == pytest.approx(start[0])
    assert result.position[-1] == pytest.approx(slow.position[0])
    assert result.torque[-1] == slow.torque[0]
    assert (np.diff(result.torque) >= 0).all()
    assert np.abs(np.diff(result.position, axis=0)).max() <= quasi_static._NEAR + 1e-12
    first, last = result.snaps[-1]
    assert np.abs(result.position[last] - result.position[first]).max() > math.radians(90)
    assert np.abs(np.diff(result.position[first : last + 1], axis=0)).max() <= quasi_static._SNAP_STEP + 1e-12


def test_the_energy_less_the_torques_work_falls_all_along_a_snap(folding):
    (result,) = folding[1].paths
    unit = np.array(drive_of(WINGS.structure, "fold").shares)
    for first, last in result.snaps:
        on = result.position[first : last + 1]
        energy = potential(WINGS.repeated(len(on)), on, result.torque[last] * unit)[0]
        assert (np.diff(energy) <= 1e-12).all()
