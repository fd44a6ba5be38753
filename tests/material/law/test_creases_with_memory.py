"""Nonlinear moments, Maxwell branches and damage of creases against closed forms of their laws."""

import numpy as np
import pytest
from scipy.integrate import quad

from forficula.errors import InputError
from forficula.material.law.crease_law import CreaseBranch, CreaseLaw
from forficula.material.law.crease_memory import (
    acting_moment,
    memory_losses,
    next_memory,
    remaining_share,
    start_memory,
)
from forficula.material.law.relaxation import followed_share, square_integrals, working_share

STIFFNESS, TIME = np.array([[0.5, 0.3]]), np.array([[0.2, 1.0]])
RELAXING = CreaseLaw(stiffness=np.ones(1), branch_stiffness=STIFFNESS, branch_time=TIME)
BENT = CreaseLaw(stiffness=2.0, rest_angle=0.3, quadratic=-0.4, cubic=0.5, lock_above=2.0)


def driven(law, angles, step):
    """Turn a crease through angles at a constant rate between them; return its memories and the losses of each step."""
    memory, memories, losses = start_memory(law, np.zeros(1)), [], []
    before = 0.0
    for angle in angles:
        after = next_memory(law, np.array([angle]), 0.0, memory, np.array([angle - before]), step)
        losses.append([float(part[0]) for part in memory_losses(law, np.array([angle]), 0.0, memory, after, step)])
        memories.append(after)
        memory, before = after, angle
    return np.array(memories)[..., 0], np.array(losses)


@pytest.mark.parametrize("angle", [-2.5, -0.4, 0.3, 1.5, 2.9])
def test_the_energy_of_a_nonlinear_spring_is_the_integral_of_its_moment(angle):
    integral = quad(lambda at: float(BENT.moment(at)), 0.3, angle, points=[2.0] if angle > 2 else None)[0]
    assert float(BENT.energy(angle)) == pytest.approx(integral, rel=1e-9, abs=1e-15)
    slope = (float(BENT.moment(angle + 1e-6)) - float(BENT.moment(angle - 1e-6))) / 2e-6
    assert float(BENT.slope(angle)) == pytest.approx(slope, rel=1e-7)
    ends = [float(BENT.energy(angle, change)) for change in (-1e-6, 1e-6)]
    if angle < 2:
        assert float(BENT.rest_moment(angle)) == pytest.approx((ends[0] - ends[1]) / 2e-6, rel=1e-7, abs=1e-7)


def test_branches_follow_a_ramp_exactly_in_steps_of_any_length():
    """Compare with F = k tau v (1 - exp(-t / tau)) and with relaxation at a constant angle."""
    rate, time = 0.7, 1.5
    for count in (1, 3, 50):
        memories, losses = driven(RELAXING, rate * time * np.arange(1, count + 1) / count, time / count)
        force = STIFFNESS[0] * TIME[0] * rate * -np.expm1(-time / TIME[0])
        assert memories[-1, 2:] == pytest.approx(force, rel=1e-12)
        work = rate**2 * STIFFNESS[0] * TIME[0] * (time + TIME[0] * np.expm1(-time / TIME[0]))
        assert losses[:, 1].sum() == pytest.approx(np.sum(work - force**2 / (2 * STIFFNESS[0])), rel=1e-9)
    relaxed, lost = driven(RELAXING, [0.8, *[0.8] * 4], 0.4)
    assert relaxed[-1, 2:] == pytest.approx(relaxed[0, 2:] * np.exp(-1.6 / TIME[0]), rel=1e-12)
    stored = np.sum((relaxed[0, 2:] ** 2 - relaxed[-1, 2:] ** 2) / (2 * STIFFNESS[0]))
    assert lost[1:, 1].sum() == pytest.approx(stored, rel=1e-9)


def test_a_harmonic_turn_dissipates_the_loss_modulus():
    """Loss per cycle: pi G'' a^2 with G'' = sum of k w tau / (1 + (w tau)^2)."""
    frequency, amplitude, count = 2.0, 0.6, 120
    period = 2 * np.pi / frequency
    # the last of four cycles counts, when the slowest transient has faded to exp(-3 period / 1 s)
    angles = amplitude * np.sin(2 * np.pi * np.arange(1, 4 * count + 1) / count)
    product = frequency * TIME[0]
    modulus = np.sum(STIFFNESS[0] * product / (1 + product**2))
    _, losses = driven(RELAXING, angles, period / count)
    assert losses[-count:, 1].sum() == pytest.approx(np.pi * modulus * amplitude**2, rel=1e-3)


def test_the_loop_of_a_yielding_crease_with_branches_is_the_sum_of_both_losses():
    law = CreaseLaw(stiffness=np.ones(1), yield_angle=0.3, hardening=0.4, branch_stiffness=STIFFNESS, branch_time=TIME)
    amplitude, count, step = 0.8, 160, 0.02
    ramp = np.concatenate([np.linspace(0, 1, 41), np.linspace(1, -1, 81)[1:], np.linspace(-1, 0, 41)[1:]])[1:]
    angles = np.tile(amplitude * ramp, 3)
    memories, losses = driven(law, angles, step)
    moments = [
        float(acting_moment(law, np.array([at]), 0.0, memory[:, None])[0][0])
        for at, memory in zip(angles, memories, strict=True)
    ]
    last, turned = np.array(moments[-count - 1 :]), angles[-count - 1 :]
    area = np.trapezoid(last, turned)
    assert losses[-count:, 0].sum() == pytest.approx(4 * 0.6 * 0.3 * (amplitude - 0.3), rel=1e-9)
    assert losses[-count:, :2].sum() == pytest.approx(area, rel=2e-3)


@pytest.mark.parametrize("by_set", [False, True])
def test_planted_cycles_leave_the_moment_of_the_damage_law(by_set):
    law = CreaseLaw(
        stiffness=np.ones(1), yield_angle=0.3, hardening=0.4, damage_loss=0.6, damage_turn=9.0, damage_by_set=by_set
    )
    cycles, amplitude = 7, 0.8
    memories, losses = driven(law, np.tile([amplitude, -amplitude], cycles), 0.1)
    # the first turn begins at rest; each turn by 2 a changes the set by 2 (a - 0.3)
    wear = (amplitude - 0.3) * (2 * 2 * cycles - 1) if by_set else amplitude * (2 * 2 * cycles - 1)
    assert memories[-1, 1] == pytest.approx(wear, rel=1e-12)
    left = 1 - 0.6 * (1 - np.exp(-wear / 9.0))
    assert remaining_share(law, memories[-1][:, None]) == pytest.approx(left, rel=1e-12)
    angle = np.array([-amplitude])
    moment, slope = acting_moment(law, angle, 0.0, memories[-1][:, None])
    new, steep = acting_moment(law, angle, 0.0, np.array([[memories[-1, 0]], [0.0]]))
    assert (moment / new, slope / steep) == (pytest.approx(left), pytest.approx(left))
    assert (losses[:, 2] > 0).all()


def test_shares_of_a_ramp_have_their_limits():
    time = np.array([0.1, 1.0, 1e9])
    shares = followed_share(time, 1.0)
    assert shares == pytest.approx([0.1 * (1 - np.exp(-10)), 1 - np.exp(-1), 1.0], rel=1e-9)
    assert followed_share(time, 0.0) == pytest.approx(1.0)
    # the work of a spring of that slope is the loss and the energy of the branch
    force = shares
    loss = square_integrals(time, 1.0)[2] * force**2 / time
    assert working_share(time, 1.0) / 2 == pytest.approx(loss + force**2 / 2, rel=1e-8)
    below, above = working_share(np.array([100.001, 99.999]), 1.0)
    assert below == pytest.approx(above, rel=1e-6)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"cubic": np.nan}, "cubic: need a finite number"),
        ({"branch_stiffness": np.array([-1.0]), "branch_time": np.ones(1)}, "branch_stiffness: need a finite number"),
        ({"branch_stiffness": np.ones(1), "branch_time": np.zeros(1)}, "branch_time: need > 0, got 0 s"),
        ({"damage_loss": 1.5}, "damage_loss: need a share from 0 to 1, got 1.5"),
        ({"damage_turn": 0.0}, "damage_turn: need > 0, got 0 rad"),
    ],
)
def test_numbers_without_a_meaning_are_refused(values, message):
    with pytest.raises(InputError, match=message):
        CreaseLaw(stiffness=1.0, **values)


def test_a_branch_needs_a_stiffness_and_a_time():
    with pytest.raises(InputError, match=r"branch\.time: need a finite number > 0, got 0 s"):
        CreaseBranch(stiffness=1.0, time=0.0)
