"""Creases with Maxwell branches, yield and wear agree with closed forms of linear viscoelasticity and plasticity."""

import numpy as np
import pytest

from forficula.dynamics import energy_balance, simulate
from forficula.dynamics.engine.model import compile_model
from forficula.material.law.crease_law import CreaseLaw
from forficula.material.law.crease_memory import (
    acting_moment,
    memory_losses,
    next_memory,
    remaining_share,
    start_memory,
)
from tests.memory_strips import BRANCH, BRANCHES, FACETS, MOMENT, STIFFNESS, TIME, WIDTH, changed, record

STIFFNESSES, TIMES = np.array([[0.5, 0.3]]), np.array([[0.2, 1.0]])
RELAXING = CreaseLaw(stiffness=np.ones(1), branch_stiffness=STIFFNESSES, branch_time=TIMES)


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


@pytest.mark.parametrize("facets", FACETS)
def test_a_constant_moment_makes_a_crease_with_a_branch_creep_and_recover(facets, agree, holds):
    """Standard linear solid with a damper c beside it: the angle is M / K and two exponentials.

    Their rates s are the roots of (c s + K)(s + 1 / tau) + k s; the slow one is about -K / (tau (K + k)). A moment that
    rises linearly in 10 ms is the mean of steps in that time. Inertia is neglected.
    """
    run = record(facets, relaxes=True)
    angle, times, damping = run.series["hinge_angle"][:, 0], run.time, 5e-3 * WIDTH
    rates = np.roots([damping, STIFFNESS + BRANCH + damping / TIME, STIFFNESS / TIME])
    parts = [(rate + 1 / TIME) / (rate * damping * (rate - other)) for rate, other in (rates, rates[::-1])]
    rise = np.expm1(-0.01 * rates) / (-0.01 * rates)
    shown = (times > 0.035) & (times < 0.1)
    creep = MOMENT * (1 / STIFFNESS + (parts * rise) @ np.exp(np.outer(rates, times[shown])))
    over = ("time (s)", times[shown])
    agree(
        "fold angle under a constant moment",
        angle[shown],
        creep,
        by="creep of the solid",
        unit="rad",
        rel=2.5e-3,
        over=over,
    )
    late = times > 0.13
    recovery = -np.polyfit(times[late], np.log(angle[late]), 1)[0]
    agree("rate of recovery after release", recovery, -rates.max(), by="slow root of the solid", unit="1/s", rel=5e-3)
    balance = energy_balance(run)
    assert balance.crease_branches > 0.1 * balance.work
    holds("share of the energy that is missing", balance.residual, below=2e-3, by="energy balance")


def test_a_crease_that_is_held_at_its_stop_relaxes(agree):
    """The energy of the branch decays by exp(-2 t / tau) at a constant angle."""
    design = changed("plates", laws=BRANCHES, stop={"crease.fold_limit": "30 deg", "drive.0.value": "0.05 N m"})
    run = simulate([compile_model(design)])[0]
    energy, angle = run.series["hinge_energy"][:, 0], run.series["hinge_angle"][:, 0]
    held = (run.time > 0.04) & (run.time < 0.1)
    assert np.ptp(angle[held]) < 1e-4
    of_branch = energy[held] - STIFFNESS / 2 * angle[held] ** 2
    decay = -np.polyfit(run.time[held], np.log(of_branch), 1)[0]
    agree("rate at which the energy of a branch decays", decay, 2 / TIME, by="Maxwell 1867", unit="1/s", rel=2e-3)
    assert energy_balance(run).residual < 5e-3


def test_branches_follow_a_ramp_exactly_in_steps_of_any_length(agree):
    """Compare with F = k tau v (1 - exp(-t / tau)) and with relaxation at a constant angle."""
    rate, time = 0.7, 1.5
    for count in (1, 3, 50):
        memories, losses = driven(RELAXING, rate * time * np.arange(1, count + 1) / count, time / count)
        force = STIFFNESSES[0] * TIMES[0] * rate * -np.expm1(-time / TIMES[0])
        agree("moments of branches after a ramp", memories[-1, 2:], force, by="Maxwell 1867", unit="N m", rel=1e-12)
        work = rate**2 * STIFFNESSES[0] * TIMES[0] * (time + TIMES[0] * np.expm1(-time / TIMES[0]))
        lost = np.sum(work - force**2 / (2 * STIFFNESSES[0]))
        agree("energy lost by branches in a ramp", losses[:, 1].sum(), lost, by="work less energy", unit="J", rel=1e-9)
    relaxed, lost = driven(RELAXING, [0.8, *[0.8] * 4], 0.4)
    assert relaxed[-1, 2:] == pytest.approx(relaxed[0, 2:] * np.exp(-1.6 / TIMES[0]), rel=1e-12)
    stored = np.sum((relaxed[0, 2:] ** 2 - relaxed[-1, 2:] ** 2) / (2 * STIFFNESSES[0]))
    assert lost[1:, 1].sum() == pytest.approx(stored, rel=1e-9)


def test_a_harmonic_turn_dissipates_the_loss_modulus(agree):
    """Loss per cycle: pi G'' a^2 with G'' = sum of k w tau / (1 + (w tau)^2)."""
    frequency, amplitude, count = 2.0, 0.6, 120
    period = 2 * np.pi / frequency
    # the last of four cycles counts, when the slowest transient has faded to exp(-3 period / 1 s)
    angles = amplitude * np.sin(2 * np.pi * np.arange(1, 4 * count + 1) / count)
    product = frequency * TIMES[0]
    modulus = np.sum(STIFFNESSES[0] * product / (1 + product**2))
    _, losses = driven(RELAXING, angles, period / count)
    closed = np.pi * modulus * amplitude**2
    agree("energy lost per cycle", losses[-count:, 1].sum(), closed, by="pi G'' a^2", unit="J", rel=1e-3)


def test_the_loop_of_a_yielding_crease_with_branches_is_the_sum_of_both_losses(agree):
    law = CreaseLaw(
        stiffness=np.ones(1), yield_angle=0.3, hardening=0.4, branch_stiffness=STIFFNESSES, branch_time=TIMES
    )
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
    plastic = 4 * 0.6 * 0.3 * (amplitude - 0.3)
    agree("energy lost by yielding", losses[-count:, 0].sum(), plastic, by="bilinear loop", unit="J", rel=1e-9)
    agree(
        "energy lost by yielding and branches",
        losses[-count:, :2].sum(),
        area,
        by="area of the loop",
        unit="J",
        rel=2e-3,
    )


@pytest.mark.parametrize("by_set", [False, True])
def test_planted_cycles_leave_the_moment_of_the_damage_law(by_set, agree):
    law = CreaseLaw(
        stiffness=np.ones(1), yield_angle=0.3, hardening=0.4, damage_loss=0.6, damage_turn=9.0, damage_by_set=by_set
    )
    cycles, amplitude = 7, 0.8
    memories, losses = driven(law, np.tile([amplitude, -amplitude], cycles), 0.1)
    # the first turn begins at rest; each turn by 2 a changes the set by 2 (a - 0.3)
    wear = (amplitude - 0.3) * (2 * 2 * cycles - 1) if by_set else amplitude * (2 * 2 * cycles - 1)
    assert memories[-1, 1] == pytest.approx(wear, rel=1e-12)
    left = 1 - 0.6 * (1 - np.exp(-wear / 9.0))
    agree(
        "moment left after seven cycles", remaining_share(law, memories[-1][:, None]), left, by="damage law", rel=1e-12
    )
    angle = np.array([-amplitude])
    moment, slope = acting_moment(law, angle, 0.0, memories[-1][:, None])
    new, steep = acting_moment(law, angle, 0.0, np.array([[memories[-1, 0]], [0.0]]))
    assert (moment / new, slope / steep) == (pytest.approx(left), pytest.approx(left))
    assert (losses[:, 2] > 0).all()
