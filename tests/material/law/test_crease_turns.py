"""Turns of creases with memory in one sense: their potential, their moment and what they dissipate."""

import numpy as np
import pytest

from forficula.material.law.crease_law import CreaseLaw
from forficula.material.law.crease_memory import stored_energy
from forficula.material.law.crease_turn import CreaseTurn, memory_after, relaxed, turn_expansion, turn_losses

BRANCHES = {"branch_stiffness": np.array([[0.5, 0.3]]), "branch_time": np.array([[0.2, 1.0]])}
YIELD = {"yield_angle": 0.3, "hardening": 0.4, "lock_above": 2.0, "quadratic": 0.1}


def law(**terms):
    return CreaseLaw(stiffness=np.ones(1), damage_loss=0.6, **terms)


def turn(branches=0, time=0.0):
    """Return a turn of a worn and set crease with branches under moments, from two angles."""
    memory = np.zeros((2 + branches, 2, 1))
    memory[0], memory[1] = 0.15, 0.2
    memory[2:] = np.array([0.1, -0.2])[:branches, None, None]
    return CreaseTurn(memory=memory, angle=np.array([[0.2], [-0.1]]), time=time)


@pytest.mark.parametrize("by_set", [False, True])
@pytest.mark.parametrize("further", [1.07, -0.9, 1e-3])
@pytest.mark.parametrize("terms", [{}, BRANCHES])
def test_the_moment_is_the_slope_of_the_potential(by_set, further, terms):
    crease, step = law(damage_turn=1.6, damage_by_set=by_set, **YIELD, **terms), 1e-6
    start = turn(2 * bool(terms), 0.3 * bool(terms))
    end = start.angle + further
    _, moment, slope = turn_expansion(crease, end, start)
    one, other = (turn_expansion(crease, end + sign * step, start) for sign in (1, -1))
    assert (one[0] - other[0]) / (2 * step) == pytest.approx(moment, abs=1e-8)
    assert (one[1] - other[1]) / (2 * step) == pytest.approx(slope, abs=1e-7)


@pytest.mark.parametrize("by_set", [False, True])
@pytest.mark.parametrize(("worn_after", "error"), [(600.0, 1e-12), (1.6, 1e-9), (0.05, 1e-5)])
def test_the_potential_grows_by_the_stored_and_the_dissipated_energy(by_set, worn_after, error):
    crease = law(damage_turn=worn_after, damage_by_set=by_set, **YIELD)
    start = turn()
    for further in (1.1, -0.9, 0.01):
        end = start.angle + further
        losses = turn_losses(crease, end, start)
        stored = stored_energy(crease, end, 0.0, memory_after(crease, end, start))
        potential = turn_expansion(crease, end, start)[0]
        assert potential == pytest.approx(stored + sum(losses), abs=error)
        assert min(float(np.min(loss)) for loss in losses) >= 0


def test_two_turns_in_one_sense_are_one_turn():
    crease, start = law(damage_turn=1.6, **YIELD), turn()
    middle, end = start.angle + 0.4, start.angle + 1.0
    later = CreaseTurn(memory=memory_after(crease, middle, start), angle=middle)
    both = [
        np.add(*pair) for pair in zip(turn_losses(crease, middle, start), turn_losses(crease, end, later), strict=True)
    ]
    assert np.array(both) == pytest.approx(np.array(turn_losses(crease, end, start)), abs=1e-9)
    assert turn_expansion(crease, end, later)[1] == pytest.approx(turn_expansion(crease, end, start)[1], abs=1e-14)


@pytest.mark.parametrize("time", [1e-3, 0.3, 500.0])
def test_branches_dissipate_their_work_less_their_energy_in_turns_of_any_duration(time):
    """Compare with the integral of M^2 / (k tau) over the ramp."""
    crease, start = CreaseLaw(stiffness=np.ones(1), **BRANCHES), turn(2, time)
    stiffness, tau = (BRANCHES[f"branch_{name}"].ravel() for name in ("stiffness", "time"))
    instants = np.concatenate([[0.0], np.geomspace(1e-6 * min(time, tau[0]), time, 20001)])[:, None]
    decay = np.exp(-instants / tau)
    moments = decay * start.memory[2:, 0, 0] + stiffness * tau * (0.7 / time) * (1 - decay)
    lost = np.trapezoid(np.sum(moments**2 / (stiffness * tau), axis=1), instants[:, 0])
    ours = turn_losses(crease, start.angle + 0.7, start).branches
    assert ours[0, 0] == pytest.approx(lost, rel=1e-5)


def test_infinitely_slow_creases_have_neither_branches_nor_friction():
    crease = law(**BRANCHES, damage_turn=3.0)
    assert (relaxed(crease).slots, relaxed(crease).relaxes) == (2, False)
    assert relaxed(CreaseLaw(stiffness=1.0)).slots == 1
