"""Simulated tendons follow the laws of their materials.

A Maxwell branch at constant length relaxes as exp(-t / tau), and dissipates pi k w tau / (1 + w^2 tau^2) x0^2 in a
cycle of amplitude x0 (Tschoegl, The Phenomenological Theory of Linear Viscoelastic Behavior, 1989). The logarithmic
decrement of a damped oscillator is 2 pi zeta / sqrt(1 - zeta^2). The energy of a polynomial spring is the integral of
its force; its motion is compared with that of an independent integrator (Dormand and Prince 1980). A spring with ideal
plasticity keeps its largest stretch minus its elastic range. The stiffness is k = E A / L.
"""

import math
from functools import cache

import mujoco
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import forficula as ff
from forficula.design import scale_design, with_values
from forficula.dynamics import compile_model, simulate
from forficula.dynamics.energies.tendon_losses import AlikeTendons
from forficula.structure import structure_of

LENGTH, AREA, ARM = 0.06, 12.5e-6, 0.055  # m, m2, m
BY_LENGTH = AREA / LENGTH  # N/m per Pa


def of(law, **values):
    return {"tendon.rest_length": LENGTH, "tendon.area": AREA, "tendon.law": law} | values


@pytest.fixture(scope="module")
def compiled_hinge(one_hinge):
    """Compiled wing of one hinge with a tendon of polynomial moduli, with or without damper and branches."""

    @cache
    def build(moduli, *, with_past=False):
        past = {"linear_viscosity": 300.0, "branches": BRANCHES} if with_past else {}
        return one_hinge(LENGTH, values=of(as_law(moduli, **past))).wing

    return build


def pulled(one_hinge, law, lengths, timestep):
    """Move a tendon through lengths, m, one per step, by turning a hinge of very large inertia.

    Returns the wing, the forces of the branches by step, N, positive where they pull, and the resting length, m.
    """
    heavy = {"hinge.armature": 1e6, "protocol.timestep": timestep}
    wing = one_hinge(LENGTH, timestep=timestep, values=of(law) | heavy).wing
    units, data = wing.units, mujoco.MjData(wing.engine)
    angles = np.arccos((lengths**2 - 2 * ARM**2) / (2 * ARM**2))
    levers = ARM**2 * np.sin(angles) / lengths
    pulls, rests = [], []
    for angle, lever, rate in zip(angles, levers, np.diff(lengths, append=lengths[-1]) / timestep, strict=True):
        data.qpos[0], data.qvel[0] = -angle, rate / lever * units.time
        pulls.append(-data.act.copy() * units.energy / units.length)
        rests.append(data.plastic[1] * units.length if len(data.plastic) else math.nan)
        mujoco.mj_step(wing.engine, data)
    return wing, np.array(pulls), np.array(rests)


@pytest.mark.parametrize("times", [(0.02,), (1.7,), (0.02, 1.7, 16.0)])
def test_a_maxwell_branch_at_constant_length_relaxes_with_its_relaxation_time(one_hinge, agree, times):
    law = {"linear_modulus": 1e6, "branches": [{"modulus": 2e6, "time": time} for time in times]}
    steps, timestep = 2000, 1e-4
    lengths = np.full(steps, 0.09)
    lengths[0] = 0.07
    _, pulls, _ = pulled(one_hinge, law, lengths, timestep)
    for pull, time in zip(pulls.T, times, strict=True):
        # rounding of 2000 steps
        faded = pull[1] * np.exp(-timestep * np.arange(steps - 1) / time)
        agree(
            f"pull of a branch of {time} s at constant length", pull[1:], faded, unit="N", by="Maxwell 1867", rel=1e-11
        )
        # it takes k x, less the relaxation within the step: half of the step divided by the relaxation time
        taken = 2e6 * BY_LENGTH * 0.02 * (1 - timestep / time / 2)
        agree("initial pull of the branch", pull[1], taken, unit="N", by="k x", rel=1e-5)


@pytest.mark.parametrize("times", [(0.02,), (0.005, 0.2)])
@pytest.mark.parametrize("turns", [0.1, 1.0, 10.0])
def test_branches_dissipate_the_energy_of_their_loss_modulus_in_a_sinusoidal_test(one_hinge, agree, times, turns):
    rate = turns / times[0]  # rad/s
    steps, cycles, amplitude = 4000, 40, 0.004
    if turns > 1:
        times = times[:1]  # a cycle is too short for a steady state of the second branch
    timestep = 2 * math.pi / rate / steps
    cycles = max(3, math.ceil(12 * max(times) * rate / (2 * math.pi)))
    moments = timestep * np.arange(steps * cycles + 1)
    lengths = 0.085 + amplitude * np.sin(rate * moments)
    law = {"linear_modulus": 1e6, "branches": [{"modulus": 2e6, "time": time} for time in times]}
    wing, pulls, _ = pulled(one_hinge, law, lengths, timestep)
    last = slice(-steps - 1, None)
    for number, time in enumerate(times):
        stiffness, turn = 2e6 * BY_LENGTH, rate * time
        loss = math.pi * stiffness * turn / (1 + turn**2) * amplitude**2
        work = np.trapezoid(pulls[last, number], lengths[last])
        # second order in the step of 1/4000 cycle: (2 pi / 4000)^2
        what = f"loss of a branch of {time} s in a cycle at {rate:g} rad/s"
        agree(what, 1e6 * work, 1e6 * loss, unit="µJ", by="π E'' x₀²", rel=1e-5)
        # the recorded losses agree
        force = wing.units.energy / wing.units.length
        losses = AlikeTendons.of([wing]).branch_losses(np.array([0]), -pulls[None, last] / force)
        lost = losses[0].sum(axis=0)[0, number]
        agree(
            "dissipation in the energy balance",
            1e6 * wing.units.energy * lost,
            1e6 * loss,
            unit="µJ",
            by="π E'' x₀²",
            rel=1e-5,
        )
        # storage modulus: k (w tau)^2 / (1 + (w tau)^2)
        stored = 2 / steps * np.sum(pulls[last][:-1, number] * np.sin(rate * moments[last][:-1]))
        known = stiffness * turn**2 / (1 + turn**2)
        agree("storage stiffness of the branch", stored / amplitude, known, unit="N/m", by="E'", rel=1e-4)


@pytest.mark.parametrize("viscosity", [20.0, 200.0])
def test_a_kelvin_voigt_tendon_damps_a_free_hinge_with_its_logarithmic_decrement(agree, one_hinge, viscosity):
    """The bar swings about the angle where its weight, which gravity pulls upwards, balances the tendon."""
    gravity, timestep = 9.81, 2e-5
    values = of(
        {"linear_modulus": 3e3, "linear_viscosity": viscosity},
        **{"protocol.gravity": -gravity, "protocol.sample_interval": 1e-4},
    )
    free = one_hinge(LENGTH, values=values)
    vein, reach = free.wing.design.vein, free.wing.design.pattern.distal_length
    weight = vein.density * math.pi * vein.diameter**2 / 4 * reach * gravity
    stiffness, damping = 3e3 * BY_LENGTH, viscosity * BY_LENGTH

    def moment(angle):
        length = 2 * ARM * np.cos(angle / 2)
        return stiffness * np.maximum(length - LENGTH, 0) * ARM * np.sin(angle / 2) + weight * reach / 2 * np.cos(angle)

    rest = brentq(moment, 1.0, 3.0)
    assert 2 * ARM * math.cos(rest / 2) > LENGTH  # taut: spring and damper in parallel
    hinge_stiffness = -(moment(rest + 1e-5) - moment(rest - 1e-5)) / 2e-5
    rate = math.sqrt(hinge_stiffness / free.inertia)
    ratio = damping * (ARM * math.sin(rest / 2)) ** 2 / (2 * free.inertia * rate)
    assert 0.001 < ratio < 0.2
    period = 2 * math.pi / rate / math.sqrt(1 - ratio**2)
    swinging = one_hinge(
        LENGTH, timestep=timestep, duration=4.2 * period, start=rest + math.radians(0.5), values=values
    )
    angles, record = swinging.run()
    away, time = angles - rest, record.data["time"].values
    peaks = [0, *(1 + np.flatnonzero((away[1:-1] > away[:-2]) & (away[1:-1] >= away[2:])))]
    assert len(peaks) == 5
    decrement = np.log(away[peaks[0]] / away[peaks[4]]) / 4
    # small swings: second-order error of the lever, (0.5 deg)^2 / 8
    known = 2 * math.pi * ratio / math.sqrt(1 - ratio**2)
    agree(f"decrement at {viscosity:g} Pa s", decrement, known, by="2π ζ / √(1 - ζ²)", rel=2e-3)
    result = (time[peaks[4]] - time[peaks[0]]) / 4
    agree(f"period at {viscosity:g} Pa s", 1e3 * result, 1e3 * period, unit="ms", by="damped oscillator", rel=1e-3)


def polynomial(first, second, third, extension):
    return first * extension + second * extension**2 + third * extension**3


LAWS = [(1e6, 0.0, 0.0), (1e6, -1.2e6, 0.8e6), (0.0, 0.0, 2e6), (3e5, 2e6, 0.0)]


def as_law(moduli, **values):
    return dict(zip(("linear_modulus", "quadratic_modulus", "cubic_modulus"), moduli, strict=True)) | values


def spring(moduli):
    """Coefficients of a tendon of 12.5 mm2 and 6 cm, N/m, N/m2, N/m3, by hand."""
    return tuple(modulus * AREA / LENGTH**power for power, modulus in enumerate(moduli, start=1))


@settings(max_examples=30, deadline=None)
@given(st.sampled_from(LAWS), st.floats(0, math.pi))
def test_the_engine_gives_the_moment_of_a_polynomial_tendon(agree, compiled_hinge, moduli, angle):
    wing = compiled_hinge(moduli)
    data = mujoco.MjData(wing.engine)
    data.qpos[0] = -angle
    mujoco.mj_forward(wing.engine, data)
    length = 2 * ARM * math.cos(angle / 2)
    expected = polynomial(*spring(moduli), max(length - LENGTH, 0)) * ARM * math.sin(angle / 2)
    # rounding
    result = -data.qfrc_passive[0] * wing.units.energy
    agree("moment of a tendon", result, expected, unit="N m", by="its polynomial", abs=1e-13)


@pytest.mark.parametrize("moduli", LAWS)
@pytest.mark.parametrize("viscosity", [None, (300.0, 0.0, 0.0), (0.0, 20.0, 0.3)])
def test_a_hinge_with_a_tendon_of_any_law_moves_as_with_an_integrator_of_fifth_order(
    agree, one_hinge, moduli, viscosity
):
    names = ("linear_viscosity", "quadratic_viscosity", "cubic_viscosity")
    law = as_law(moduli) | dict(zip(names, viscosity or (), strict=False))
    # nonlinear damping also pushes, which the design must allow
    allowed = {"tendon.pushes_when_slack": bool(viscosity and any(viscosity[1:]))}
    hinge = one_hinge(LENGTH, values=of(law) | allowed, start=math.radians(20), duration=0.02, timestep=1e-5)
    angles, record = hinge.run()
    damping = [value * AREA / LENGTH**power for power, value in enumerate(viscosity or (0, 0, 0), start=1)]

    def motion(_, state):
        angle, speed = state
        lever = ARM * math.sin(angle / 2)
        rate = -lever * speed  # of the tendon
        pull = polynomial(*spring(moduli), max(2 * ARM * math.cos(angle / 2) - LENGTH, 0))
        pull += damping[0] * rate + damping[1] * rate * abs(rate) + damping[2] * rate**3
        if not allowed["tendon.pushes_when_slack"]:
            pull = max(pull, 0.0) if 2 * ARM * math.cos(angle / 2) > LENGTH else 0.0
        return [speed, pull * lever / hinge.inertia]

    time = record.data["time"].values
    exact = solve_ivp(motion, (0, time[-1]), [angles[0], 0.0], t_eval=time, rtol=1e-9, atol=1e-12).y[0]
    assert exact[-1] > math.radians(40)
    assert exact[-1] < math.pi
    # semi-implicit Euler from rest: half a step ahead, 5e-6 s at up to some 100 rad/s
    over = ("time (ms)", 1e3 * time) if moduli == LAWS[1] and viscosity == (0.0, 20.0, 0.3) else None
    agree("angle of the hinge", angles, exact, unit="rad", by="Dormand and Prince 1980", abs=1e-3, over=over)
    # the recorded energy is the integral of the force
    extension = np.maximum(2 * ARM * np.cos(angles / 2) - LENGTH, 0)
    first, second, third = spring(moduli)
    energy = first * extension**2 / 2 + second * extension**3 / 3 + third * extension**4 / 4
    result = record.data["tendon_energy"].values[:, 0]
    agree("energy of the tendon", result, energy, unit="J", by="integral of its force", abs=1e-13)


# laws of second order, exact in the engine, and cubic ones, as from a fit, which it approximates in pieces
LETTING_GO = [
    ((1e6, 0.0, 0.0), 1e-7),
    ((3e5, 2e6, 0.0), 1e-7),
    ((0.0, 2e6, 0.0), 1e-7),
    ((3.2e6, -5.8e6, 5.9e6), 1e-4),
    ((1e6, 1e6, 2e6), 1e-4),
    ((1e6, -1.9e6, 1e6), 1e-4),
    ((0.0, 0.0, 2e6), 1.1e-4),
]


@settings(max_examples=300, deadline=None)
@given(
    st.sampled_from(LETTING_GO),
    st.floats(0, math.pi - 0.01),
    st.floats(-100, 100),
    st.floats(-3, 3),
    st.floats(-3, 3),
)
def test_the_sum_of_spring_damper_and_branches_pulls_or_is_zero(
    agree, compiled_hinge, spec, angle, speed, first_act, second_act
):
    """The pull is the sum if this is > 0 and the tendon is taut, and otherwise 0, for any rate and any history."""
    moduli, miss = spec
    wing = compiled_hinge(moduli, with_past=True)
    units, data = wing.units, mujoco.MjData(wing.engine)
    data.qpos[0], data.qvel[0] = -angle, -speed * units.time
    data.act[:] = first_act, second_act
    mujoco.mj_forward(wing.engine, data)
    after = mujoco.MjData(wing.engine)
    mujoco.mj_copyData(after, wing.engine, data)
    mujoco.mj_step(wing.engine, after)  # the engine uses the branches' forces after the step
    length, lever = 2 * ARM * math.cos(angle / 2), ARM * math.sin(angle / 2)
    pull = polynomial(*spring(moduli), max(length - LENGTH, 0)) - 300.0 * BY_LENGTH * lever * speed
    pull -= after.act.sum() * units.energy / units.length
    moment = data.qfrc_actuator[0] + data.qfrc_passive[0]
    # the spring's onset is smoothed over 1e-6 of the resting length; laws in pieces deviate by a share of
    # its largest force
    largest = polynomial(*spring(moduli), np.linspace(0, 2 * ARM - LENGTH)).max()
    result, known = moment * -units.energy, (max(pull, 0) if length > LENGTH else 0) * lever
    agree("moment of a tendon", result, known, unit="N m", by="sum of its parts", abs=max(1e-7, miss * largest * lever))


def fold_time(angles, record):
    """Time at which the hinge passes 150 deg, s, between two rows; nan if it does not."""
    to = math.radians(150)
    time = record.data["time"].values
    beyond = np.flatnonzero(angles >= to)
    if not len(beyond):
        return math.nan
    row = beyond[0]
    share = (to - angles[row - 1]) / (angles[row] - angles[row - 1])
    return time[row - 1] + share * (time[row] - time[row - 1])


@pytest.mark.parametrize("viscosity", [1e4, 3e4])  # Pa s
def test_a_slack_kelvin_voigt_tendon_does_not_push_the_hinge(agree, one_hinge, viscosity):
    law = {"linear_modulus": 1e6, "linear_viscosity": viscosity}
    hinge = one_hinge(LENGTH, values=of(law), start=math.radians(60), duration=0.08, timestep=1e-5)
    angles, record = hinge.run()
    stiffness, damping = 1e6 * BY_LENGTH, viscosity * BY_LENGTH

    def motion(_, state, pushes):
        angle, speed = state
        lever, length = ARM * math.sin(angle / 2), 2 * ARM * math.cos(angle / 2)
        pull = stiffness * max(length - LENGTH, 0) - damping * lever * speed
        if not pushes:
            pull = max(pull, 0) if length > LENGTH else 0.0
        return [speed, pull * lever / hinge.inertia]

    def arrives(_, state, _pushes):
        return state[0] - math.radians(150)

    known, pushed = (
        solve_ivp(motion, (0, 0.1), [angles[0], 0], args=(pushes,), events=arrives, rtol=1e-9, max_step=1e-4).t_events[
            0
        ]
        for pushes in (False, True)
    )
    assert not len(pushed) or pushed[0] > 1.1 * known[0]
    result = fold_time(angles, record)
    agree(
        f"time to 150° at {viscosity:g} Pa s",
        1e3 * result,
        1e3 * known[0],
        unit="ms",
        by="pull-only equation",
        rel=2e-3,
    )
    balance = ff.measure(record).energy_balance
    assert balance.letting_go is None
    assert abs(balance.missing) < 2e-3 * abs(balance.tendon)


@pytest.mark.parametrize("moduli", [(4.8e6, 0.0, 0.0), (4.8e6, -8.7e6, 8.9e6)])
def test_the_energy_balance_includes_the_clamped_push_of_branches(holds, reference, moduli):
    """A stiff branch goes slack when the wing folds; the balance closes with the work saved by clamping."""
    values = WING | {"tendon.law": as_law(moduli, linear_viscosity=50.0, branches=BRANCHES)}
    record = ff.run(with_values(reference, values | {"protocol.timestep": 1e-4}), confirm=False)
    balance = ff.measure(record).energy_balance
    assert -balance.letting_go > 0.02 * balance.work
    holds("missing energy", balance.residual, below=5e-3, by="conservation of energy")
    assert abs(balance.missing) < 0.2 * abs(balance.letting_go)


def test_a_tendon_stretched_beyond_its_yield_keeps_a_permanent_set(agree, one_hinge):
    law = {"linear_modulus": 1e6, "quadratic_modulus": 5e5, "yield_strain": 0.2}
    out = np.linspace(0.05, 0.1, 500)
    _, _, rests = pulled(one_hinge, law, np.concatenate([out, out[::-1]]), 1e-4)
    # no permanent stretch up to 20 %, beyond it all excess; constant on the way back
    expected = np.maximum.accumulate(np.maximum(LENGTH, np.concatenate([out, out[::-1]]) - 0.2 * LENGTH))
    agree("resting length", 100 * rests, 100 * expected, unit="cm", by="ideal plasticity", abs=1e-7)
    assert rests[-1] == pytest.approx(0.1 - 0.012, abs=1e-9)


def test_yielding_dissipates_the_yield_force_times_the_set(agree, one_hinge):
    """A bar falls from 60 deg to straight and stretches its tendon beyond its yield."""
    law = {"linear_modulus": 5e4, "cubic_modulus": 5e4, "yield_strain": 0.3}
    fall = {"protocol.gravity": 200.0, "hinge.damping": 1e-3, "protocol.sample_interval": 1e-3}
    hinge = one_hinge(LENGTH, values=of(law) | fall, start=math.radians(60), duration=1.0, timestep=2e-5)
    angles, record = hinge.run()
    data = record.data
    rest = data["tendon_rest_length"].values[:, 0]
    assert np.degrees(angles[-1]) == pytest.approx(-3, abs=0.1)
    longest = np.maximum.accumulate(data["tendon_length"].values[:, 0])
    # placed where it is overstretched, it has yielded; the largest length may be between two rows
    known = np.maximum(LENGTH, longest - 0.3 * LENGTH)
    agree("resting length", 100 * rest, 100 * known, unit="cm", by="ideal plasticity", abs=1e-4)
    extension = 0.3 * LENGTH
    force = polynomial(5e4 * BY_LENGTH, 0, 5e4 * AREA / LENGTH**3, extension)
    taken, known = -1e3 * data["yield_work"].values, 1e3 * force * (rest - rest[0])
    agree("work of yielding", taken, known, unit="mJ", by="force times set", rel=1e-9, abs=1e-12)
    assert rest[-1] - rest[0] > 0.2 * LENGTH
    balance = ff.measure(record).energy_balance
    assert balance.yielding == pytest.approx(force * (rest[-1] - rest[0]), rel=1e-9)
    assert abs(balance.missing) < 2e-3 * abs(balance.gravitational)


WING = {"tendon.rest_length": 0.09, "tendon.area": 18.75e-6}
BRANCHES = [{"modulus": 2e6, "time": 0.02}, {"modulus": 1e6, "time": 0.5}]
TIMESTEPS = [2e-4, 1e-4, 5e-5, 2.5e-5]  # s


def with_law(reference, law, **values):
    return with_values(reference, WING | {"tendon.law": law} | values)


def test_the_energy_balance_of_a_free_wing_closes_with_branches_as_without(holds, reference):
    free = [{"name": "let go", "drive": "none", "until": "time", "hold": 0.0, "time_limit": 0.012}]
    no_stops = {"guard.stretch": 1e3, "hinge.turn_limit": math.pi, "hinge.turn_back": math.pi}
    bent = {"protocol.initial_overbend": math.radians(-20), "protocol.stages": free, "tendon.rest_length": 0.06}
    missing = {}
    for name, branches in (("without", []), ("with", BRANCHES)):
        base = with_law(reference, {"linear_modulus": 4.8e6, "branches": branches}, **no_stops, **bent)
        records = simulate([compile_model(with_values(base, {"protocol.timestep": step})) for step in TIMESTEPS])
        balances = [ff.measure(record).energy_balance for record in records]
        missing[name] = [abs(balance.missing / balance.tendon) for balance in balances]
        if branches:
            assert balances[-1].branch_damping > 0.01 * abs(balances[-1].tendon)
            assert balances[-1].branches > 0
        # the integrator is of first order
        order = np.polyfit(np.log(TIMESTEPS), np.log(missing[name]), 1)[0]
        holds(f"order of the missing energy, {name} branches", order, above=0.8, by="first order")
    # in flight the branches' omitted push cannot compensate the spring's error of half a step
    holds(
        "missing energy divided by the tendons' energy at 0.2 ms",
        missing["with"][0],
        below=0.02,
        by="conservation of energy",
    )


def test_the_energy_balance_of_a_whole_run_closes_with_branches_as_with_a_linear_law(holds, reference):
    outcomes = [
        ff.measure(ff.run(with_law(reference, {"linear_modulus": 4.8e6, "branches": branches}), confirm=False))
        for branches in ([], [{"modulus": 1e6, "time": 0.002}])
    ]
    assert [outcome.status for outcome in outcomes] == ["folded and opened"] * 2
    linear, branched = (outcome.energy_balance for outcome in outcomes)
    assert (linear.branches, linear.branch_damping, linear.yielding) == (None, None, None)
    assert branched.branch_damping > 0.01 * branched.work
    # 0.5 % at 0.2 ms: hinges meet the stops within a step
    by = "conservation of energy"
    holds("missing energy, linear", linear.residual, below=5e-3, by=by)
    holds("missing energy, with a branch", branched.residual, below=5e-3, by=by)


def test_a_linear_law_equals_direct_values_of_stiffness_and_damping(agree, reference):
    law = with_law(reference, {"linear_modulus": 4.8e6, "linear_viscosity": 480.0})
    # k = 4.8 MPa 18.75 mm2 / 9 cm = 10 N/cm, c = 480 Pa s 18.75 mm2 / 9 cm = 0.1 N s/m
    direct = with_values(reference, {"tendon.stiffness": 1000.0, "tendon.damping": 0.1, "tendon.rest_length": 0.09})
    for tendon in structure_of(law).tendons:
        agree("stiffness", tendon.law.stiffness[0], 1000.0, unit="N/m", by="E A / L", rel=1e-15)
        agree("damping", tendon.law.damping[0], 0.1, unit="N s/m", by="η A / L", rel=1e-15)
        assert (*tendon.law.stiffness[1:], *tendon.law.damping[1:]) == (0, 0, 0, 0)
    models = [compile_model(design).engine for design in (law, direct)]
    for name in ("tendon_stiffness", "tendon_damping", "tendon_lengthspring"):
        assert getattr(models[0], name) == pytest.approx(getattr(models[1], name), rel=1e-15)
    ours, theirs = (ff.run(design, confirm=False) for design in (law, direct))
    assert ours.stages == theirs.stages
    for name, values in theirs.series.items():
        # rounding, 1e-16, amplified by the snaps
        assert np.abs(ours.series[name] - values).max() < 1e-10 * max(1, np.abs(values).max()), name


@pytest.mark.parametrize("size", [0.1, 1 / 3])
def test_a_wing_with_a_material_law_has_the_same_scaled_motion(agree, holds, reference, size):
    law = as_law((4.8e6, -1e6, 1e6), linear_viscosity=200.0, quadratic_viscosity=2.0, branches=BRANCHES[:1])
    allowed = {"tendon.pushes_when_slack": True}
    large = with_law(reference, law | {"yield_strain": 0.15, "residual_strain": 0.02}, **allowed)
    small = scale_design(large, size)
    # by hand: at fixed modulus and density time scales with size, and viscosity is modulus times time
    assert small.tendon.law.linear_modulus == pytest.approx(4.8e6, rel=1e-12)
    assert small.tendon.law.linear_viscosity == pytest.approx(200.0 * size, rel=1e-12)
    assert small.tendon.law.quadratic_viscosity == pytest.approx(2.0 * size**2, rel=1e-12)
    assert small.tendon.law.branches[0].time == pytest.approx(0.02 * size, rel=1e-12)
    assert small.tendon.area == pytest.approx(18.75e-6 * size**2, rel=1e-12)
    records = [ff.run(design, confirm=False) for design in (large, small)]
    agree("times divided by the size", records[1].time / size, records[0].time, unit="s", by="full size", rel=1e-12)
    for name, power in {
        "hinge_angle": 0,
        "tendon_rest_length": 1,
        "branch_energy": 3,
        "branch_damping_work": 3,
    }.items():
        series = records[0].series[name]
        assert np.abs(series).max() > 0
        # rounding, amplified by the snaps
        apart = np.abs(records[1].series[name] / size**power - series).max() / np.abs(series).max()
        holds(
            f"difference of {name.replace('_', ' ')} divided by its largest value",
            apart,
            below=1e-6,
            by="dimensional analysis",
        )
