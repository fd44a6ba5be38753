"""Tendons with fixed ends follow the standard linear solid.

Held taut, a branch relaxes as exp(-t / tau). Free, a spring k beside one branch k1 recovers with the retardation time
tau (k + k1) / k (Tschoegl, The Phenomenological Theory of Linear Viscoelastic Behavior, 1989) and loses their energy.
"""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.material.law.ageing import aged
from forficula.material.law.maxwell_element import MaxwellElement
from forficula.material.law.tendon_law import TendonLaw

REST, K, K1, TAU = 0.06, 500.0, 300.0, 3600.0


def law(*branches, rest=REST, stiffness=(K, 0.0, 0.0), **values):
    tendon_branches = tuple(MaxwellElement(stiffness=stiffness, time=time) for stiffness, time in branches)
    return TendonLaw(rest_length=rest, stiffness=stiffness, branches=tendon_branches, **values)


SOLID = law((K1, TAU))
times = st.floats(1.0, 1e7)


@pytest.mark.parametrize("share", [1e-6, 0.1, 1.0, 30.0])
@pytest.mark.parametrize("others", [{}, {"yield_extension": 0.1}])
def test_a_taut_tendon_relaxes_with_its_relaxation_time(share, others):
    first = np.array([K1 * 0.02, 2.0])
    after = aged(law((K1, TAU), (50.0, 1e6), **others), 0.08, first, share * TAU)
    assert after.forces == pytest.approx(first * np.exp([-share, -share * TAU / 1e6]), rel=1e-12)
    energies = first**2 / (2 * np.array([K1, 50.0]))
    expected = float(np.sum(energies * -np.expm1([-2 * share, -2 * share * TAU / 1e6])))
    assert after.lost == pytest.approx(expected, rel=1e-9)
    assert after.stored_excess == 0


@pytest.mark.parametrize("share", [0.01, 0.1, 1.0, 4.0])
def test_a_slack_tendon_recovers_with_its_retardation_time(share):
    """Stretched until the branch has relaxed, then released: the tendon first keeps K1 / (K + K1) of its stretch."""
    stretched, distance, time = 0.02, 0.01, share * TAU
    # no force at the free length 0.06 + x: K x = K1 (0.02 - x)
    kept = stretched * K1 / (K + K1)
    before = np.array([K1 * (kept - stretched) - K1 * (REST + kept - distance)])
    after = aged(SOLID, distance, before, time)
    later = kept * np.exp(-time * K / ((K + K1) * TAU))
    # the branch at its own length is as the spring, pushing, and counts from the distance
    expected = -K * later - K1 * (REST + later - distance)
    # of second order in a 64th of the time
    assert after.forces[0] == pytest.approx(expected, rel=1e-5 + 1e-4 * share**2 / 16)
    held = (K + K**2 / K1) / 2
    assert after.lost == pytest.approx(held * (kept**2 - later**2), rel=2e-3)
    # the energy balance closes: the branch at the distance of the ends, the loss and the stored excess
    change = (after.forces[0] ** 2 - before[0] ** 2) / (2 * K1)
    assert change + after.lost - after.stored_excess == pytest.approx(0, abs=1e-12)


def test_a_recovered_tendon_pulls_when_it_is_as_short_as_the_distance_of_its_ends():
    """With the ends 1 mm beyond the resting length it first pulls with K 1 mm, and its branch relaxes from there."""
    before = np.array([-K1 * 0.019])
    after = aged(SOLID, REST + 0.001, before, 1e7)
    assert after.forces[0] == pytest.approx(0, abs=1e-9)
    early = aged(SOLID, REST + 0.001, before, 0.01 * TAU)
    assert early.forces[0] < -K * 0.001, "it is still slack"


@settings(max_examples=50, deadline=None)
@given(times, times, st.floats(0.0, 0.1), st.floats(-20, 20), st.floats(-5, 5))
def test_one_time_and_then_another_are_both_together(first, second, distance, one, other):
    tendon, before = law((K1, TAU), (100.0, 1e5)), np.array([one, other])
    half = aged(tendon, distance, before, first)
    apart = aged(tendon, distance, half.forces, second)
    together = aged(tendon, distance, before, first + second)
    # slack, of second order in parts of a seventh at most
    scale = np.abs(before).max() + K1 * REST
    assert apart.forces == pytest.approx(together.forces, abs=5e-3 * scale)
    assert half.lost + apart.lost >= -1e-12
    assert half.stored_excess + apart.stored_excess == pytest.approx(together.stored_excess, abs=5e-3 * scale**2 / K1)


@settings(max_examples=30, deadline=None)
@given(times, st.floats(0.0, 0.1), st.floats(-20, 20), st.sampled_from([(K, 0.0, 0.0), (K, -500.0, 1e4)]))
def test_it_never_gains_energy_by_waiting_and_in_the_end_rests(time, distance, force, stiffness):
    tendon = law((K1, TAU), stiffness=stiffness)
    after = aged(tendon, distance, np.array([force]), time)
    assert after.lost >= -1e-12
    rested = aged(tendon, distance, after.forces, 1e12)
    # slack, it has its resting length, also where it was shorter before; taut, no excess remains
    assert rested.forces[0] == pytest.approx(-K1 * max(REST - distance, 0.0), abs=1e-3 * K1 * REST)
