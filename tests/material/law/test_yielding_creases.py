"""A crease that yields: two springs in parallel, and one of them takes a set (Iwan 1966)."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from forficula.errors import InputError
from forficula.material.law.crease_law import CreaseLaw
from forficula.material.law.crease_turn import CreaseTurn, turn_expansion

STIFFNESS, HARDENING, YIELD = 2.0, 0.5, 0.3
LAW = CreaseLaw(stiffness=STIFFNESS, rest_angle=0.1, yield_angle=YIELD, hardening=HARDENING)


def moments(angles, law=LAW):
    """Return moments and sets along a path of angles, from a state without a set."""
    sets, result = np.zeros(()), []
    for angle in angles:
        sets = law.next_set(np.asarray(angle), 0.0, sets)
        result.append((float(law.moment(angle, law.rest_shift(sets))), float(sets)))
    return np.array(result).T


def test_the_moment_rises_with_the_stiffness_and_then_with_the_hardening():
    angles = 0.1 + np.array([0.0, 0.2, YIELD, 0.7, 1.5])
    moment, sets = moments(angles)
    beyond = np.maximum(angles - 0.1 - YIELD, 0.0)
    assert moment == pytest.approx(STIFFNESS * np.minimum(angles - 0.1, YIELD) + HARDENING * beyond)
    assert sets == pytest.approx(beyond)


@pytest.mark.parametrize("size", [0.5, 1.2])
def test_the_loop_of_a_cycle_has_the_area_of_a_parallelogram(size):
    # between +-size: 4 (k - h) yield (size - yield), the area between the two slopes
    quarter = np.linspace(0, size, 301)
    around = np.concatenate([size - np.linspace(0, 2 * size, 1201), np.linspace(-size, size, 1201)])
    moment, sets = moments(0.1 + np.concatenate([quarter, around]))
    area = np.trapezoid(moment[301:], around)
    closed = 4 * (STIFFNESS - HARDENING) * YIELD * (size - YIELD)
    assert area == pytest.approx(closed, rel=2e-3)  # corners of the loop lie between angles
    assert np.sum(LAW.yield_loss(np.diff(sets[301:]))) == pytest.approx(closed, rel=1e-12)


@given(st.lists(st.floats(-2.5, 2.5), min_size=2, max_size=20))
def test_the_work_on_any_path_is_stored_or_dissipated(targets):
    angles = np.concatenate(
        [np.linspace(one, other, 200) for one, other in zip([0.1, *targets], targets, strict=False)]
    )
    moment, sets = moments(angles)
    work = np.trapezoid(moment, angles)
    stored = float(LAW.energy(angles[-1], LAW.rest_shift(sets[-1])) + LAW.set_energy(sets[-1]))
    lost = float(np.sum(LAW.yield_loss(np.diff(sets))))
    largest = STIFFNESS * (np.diff(angles) ** 2).max()
    assert work == pytest.approx(stored + lost, abs=1e-9 + len(targets) * largest)


@given(st.floats(-2.5, 2.5), st.floats(-1.5, 1.5))
def test_moment_and_slope_of_a_turn_are_the_derivatives_of_its_energy(angle, before):
    step = 1e-6
    ends = np.array([angle - step, angle + step])
    energy, moment, _ = turn_expansion(LAW, ends, CreaseTurn(memory=np.full((1, 2), before), angle=ends))
    at = np.array([angle])
    _, middle, slope = turn_expansion(LAW, at, CreaseTurn(memory=np.full((1, 1), before), angle=at))
    assert (energy[1] - energy[0]) / (2 * step) == pytest.approx(middle[0], abs=1e-5)
    corner = abs(abs(angle - 0.1 - before) - YIELD) < 2 * step
    assert corner or (moment[1] - moment[0]) / (2 * step) == pytest.approx(slope[0], abs=1e-5)


def test_a_crease_without_a_yield_angle_never_takes_a_set():
    elastic = CreaseLaw(stiffness=STIFFNESS)
    assert not elastic.yields
    assert elastic.next_set(np.array([3.0]), 0.0, np.zeros(1)) == 0.0
    assert elastic.yield_loss(np.array([1.0])) == 0.0
    assert elastic.rest_shift(np.array([1.0])) == 0.0


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"yield_angle": 0.0}, "yield_angle: need > 0"),
        ({"yield_angle": 0.1, "hardening": 2.0}, "hardening: need a slope below the stiffness"),
        ({"yield_angle": 0.1, "hardening": -1.0}, "hardening: need a finite number >= 0"),
        ({"yield_angle": math.nan}, "yield_angle: need > 0"),
    ],
)
def test_numbers_without_a_meaning_are_refused(values, message):
    with pytest.raises(InputError, match=message):
        CreaseLaw(**({"stiffness": STIFFNESS} | values))
