"""Stages of many structures, from their steps."""

import numpy as np

from forficula.dynamics.stepping.passage import _count_finite_steps


def test_non_finite_numbers_end_a_simulation_without_a_warning():
    time = np.arange(5.0)[None]
    position, velocity = np.zeros((1, 4, 2)), np.zeros((1, 4, 2))
    assert _count_finite_steps(time[:, 0], time[:, 1:], position, velocity).tolist() == [4]
    velocity[0, 2:] = [np.inf, -np.inf]
    assert _count_finite_steps(time[:, 0], time[:, 1:], position, velocity).tolist() == [2]
    velocity[0, 1:] = [np.nan, 0]
    assert _count_finite_steps(time[:, 0], time[:, 1:], position, velocity).tolist() == [1]


def test_a_stopped_simulation_time_ends_a_simulation():
    position, velocity = np.zeros((2, 4, 2)), np.zeros((2, 4, 2))
    time = np.array([[0.0, 1.0, 2.0, 2.0, 2.0], [0.0, 1.0, 2.0, 3.0, 4.0]])
    assert _count_finite_steps(time[:, 0], time[:, 1:], position, velocity).tolist() == [2, 4]
