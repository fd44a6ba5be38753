import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.special import erf

from forficula.errors import InputError
from forficula.material.law.drift import Drift, fit_drift
from forficula.material.law.law_cycle import law_at_cycle, stretched_before
from forficula.material.law.material_law import MaterialLaw, MaxwellBranch
from forficula.material.law.softening import OgdenRoxburgh, spring_energy, spring_stress
from tests.material.law_response import softened_stress, stress_of

MODULI = (6e6, -5e6, 3e6)
SOFT = OgdenRoxburgh(r=2.0, m=3e5, beta=0.1)
LAW = MaterialLaw(name="soft", moduli=MODULI, softening=SOFT)


def test_the_virgin_curve_is_not_softened():
    strain = np.linspace(0, 1, 101)
    assert softened_stress(MODULI, SOFT, strain) == pytest.approx(spring_stress(MODULI, strain))


@given(st.floats(1.01, 10), st.floats(1e3, 1e7), st.floats(0, 1), st.floats(0.05, 1), st.floats(0, 1))
def test_unloading_follows_ogden_and_roxburgh(r, m, beta, peak, share):
    strain = np.array([0, peak, share * peak])
    stress = softened_stress(MODULI, OgdenRoxburgh(r=r, m=m, beta=beta), strain)
    # Ogden and Roxburgh 1999, with the energies of a cubic spring
    most, now = (e**2 * (3e6 - 5e6 / 3 * e + 0.75e6 * e**2) for e in strain[1:])
    eta = 1 - erf((most - now) / (m + beta * most)) / r
    virgin = strain[2] * (6e6 - 5e6 * strain[2] + 3e6 * strain[2] ** 2)
    assert stress[2] == pytest.approx(eta * virgin, rel=1e-9, abs=1e-3)


def test_it_softens_in_the_first_cycle_and_returns_to_the_virgin_curve_beyond():
    up, strain = np.linspace(0, 0.8, 81), []
    for peak in (1.0, 1.0, 1.25):
        strain += [*(up * peak), *(up[::-1] * peak)]
    stress = stress_of(LAW, np.arange(len(strain), dtype=float), strain).spring.reshape(3, 2, 81)
    assert stress[0, 1][::-1] == pytest.approx(stress[1, 0])
    assert stress[1, 0] == pytest.approx(stress[1, 1][::-1])
    assert np.all(stress[1, 0, 1:-1] < stress[0, 0, 1:-1])
    assert stress[2, 0, -1] == pytest.approx(float(spring_stress(MODULI, 1.0)))


def test_a_softened_law_is_a_spring_that_simulations_accept():
    soft = OgdenRoxburgh(r=2.0, m=1.5e6)
    softened, error = stretched_before(replace(LAW, softening=soft), 1.0)
    strain = np.linspace(0, 1, 51)
    exact = softened_stress(MODULI, soft, np.array([1.0, *strain]))[1:]
    assert stress_of(softened, np.arange(51.0), strain).spring == pytest.approx(exact, abs=1.01 * error * 4e6)
    # the curve bends at its end, where a cubic does not follow
    assert error < 0.05
    assert softened.softening is None


def test_energy_is_the_integral_of_the_stress():
    strain = np.linspace(0, 1, 100_001)
    integral = np.trapezoid(spring_stress(MODULI, strain), strain)
    assert float(spring_energy(MODULI, 1.0)) == pytest.approx(integral, rel=1e-9)


@pytest.mark.parametrize(
    ("numbers", "message"),
    [
        ({"r": 0.9}, "softening.r: need a finite number >= 1, got 0.9"),
        ({"m": 0.0, "beta": 0.0}, "softening.m: need m or beta > 0, got 0 for both"),
        ({"beta": math.nan}, "softening.beta: need a finite number >= 0, got nan"),
    ],
)
def test_an_invalid_softening_is_refused(numbers, message):
    with pytest.raises(InputError, match=message):
        OgdenRoxburgh(**{"r": 2.0, "m": 1e5, "beta": 0.1, **numbers})


def drifting(course, specimens=4, cycles=8, noise=0.003, seed=0):
    rng = np.random.default_rng(seed)
    numbers = np.arange(1, cycles + 1)
    levels = rng.uniform(3e6, 4e6, (specimens, 1))
    return list(numbers), levels * np.exp(course(numbers) + noise * rng.standard_normal((specimens, cycles)))


@pytest.mark.parametrize("rate", [-0.05, 0.04])
def test_a_drift_with_the_logarithm_of_the_cycle_is_found_whether_it_softens_or_stiffens(rate):
    inside = 0
    for seed in range(40):
        drift = fit_drift(*drifting(lambda n: rate * np.log(n), noise=0.001, seed=seed))
        assert drift.kind == "logarithm"
        inside += drift.interval[0] <= rate <= drift.interval[1]
    # 95 % of 40, less three standard deviations of a binomial
    assert inside >= 34
    factor, low, high = drift.change(100)
    assert low < factor < high
    assert factor == pytest.approx(100**rate, rel=0.02)
    assert drift.seen == (1, 8)


def test_a_drift_to_a_plateau_is_found():
    drift = fit_drift(*drifting(lambda n: -0.2 * (1 - np.exp(-(n - 1) / 1.5))))
    assert drift.kind == "plateau"
    assert drift.cycles == pytest.approx(1.5, rel=0.1)
    assert drift.change(1000)[0] == pytest.approx(math.exp(-0.2), rel=0.01)


def test_no_drift_is_found_in_constant_cycles():
    result = [fit_drift(*drifting(lambda n: 0.0 * n, noise=0.02, seed=seed)).kind for seed in range(40)]
    # BIC takes a drift out of noise of 32 points in about 1 of 15
    assert result.count("none") >= 30
    drift = fit_drift([1, 2, 3], [3.0, 3.0, 3.0])
    assert (drift.kind, drift.change(50)) == ("none", (1, 1, 1))


def test_a_law_at_a_cycle_is_weaker_and_longer():
    law = MaterialLaw(name="a", moduli=MODULI, branches=(MaxwellBranch(modulus=1e6, time=2.0),), residual_strain=0.1)
    weaker = fit_drift(*drifting(lambda n: -0.05 * np.log(n), noise=1e-6))
    longer = fit_drift([1, 2, 3, 4], 0.1 + 0.02 * np.log([1, 2, 3, 4]), relative=False)
    law = replace(law, stiffness_drift=weaker, residual_strain_drift=longer)
    later = law_at_cycle(law, 100)
    assert later.moduli == pytest.approx(tuple(100**-0.05 * item for item in MODULI), rel=1e-4)
    assert later.branches[0].modulus == pytest.approx(100**-0.05 * 1e6, rel=1e-4)
    assert later.residual_strain == pytest.approx(0.1 + 0.02 * math.log(100))
    assert (later.stiffness_drift, later.residual_strain_drift) == (None, None)
    first = law_at_cycle(law, 1)
    assert first.moduli == MODULI


@pytest.mark.parametrize(
    ("cycles", "values", "message"),
    [
        ([1, 2], [1.0, 1.0], "cycles: need at least 3 rising numbers >= 1"),
        ([1, 2, 3], [1.0, 1.0], "values: need 3 in each row"),
        ([1, 2, 3], [1.0, 0.0, 1.0], "values: need finite numbers > 0, got 0"),
    ],
)
def test_invalid_cycles_are_refused(cycles, values, message):
    with pytest.raises(InputError, match=message):
        fit_drift(cycles, values)


def test_before_the_first_measured_cycle_a_law_is_constant():
    drift = Drift(kind="logarithm", rate=-0.05, interval=(-0.06, -0.04), cycles=0.0, relative=True, seen=(3, 8))
    law = replace(LAW, stiffness_drift=drift)
    assert law_at_cycle(law, 1).moduli == law_at_cycle(law, 3).moduli == MODULI
    assert law_at_cycle(law, 6).moduli == pytest.approx(tuple(2**-0.05 * item for item in MODULI))
    for cycle in (0, math.nan):
        with pytest.raises(InputError, match="cycle: need >= 1, got"):
            law_at_cycle(law, cycle)


@pytest.mark.parametrize(
    ("values", "message"),
    [
        ({"kind": "linear"}, 'kind: need one of none, logarithm, plateau, got "linear"'),
        ({"seen": (5, 2)}, r"seen: need the first and the last cycle, from 1 on, got \[5, 2\]"),
        ({"rate": 1.0}, r"rate: need a number within its interval \[-0.06, -0.04\], got 1"),
        ({"kind": "none"}, 'rate: need 0 with kind = "none", got -0.05'),
        ({"kind": "plateau"}, "cycles: need > 0 for a plateau, 0 for the others, got 0"),
    ],
)
def test_an_invalid_drift_is_refused(values, message):
    right = {"kind": "logarithm", "rate": -0.05, "interval": (-0.06, -0.04), "cycles": 0.0, "seen": (2, 5)}
    with pytest.raises(InputError, match=message):
        Drift(relative=True, **right | values)
