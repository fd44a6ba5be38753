import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from forficula.errors import InputError
from forficula.material.law.material_law import (
    Bounds,
    MaterialLaw,
    MaxwellBranch,
    area_for,
    require,
    scaled,
    with_linear_modulus,
)
from forficula.material.law.stress import check_history
from tests.material.law_response import stress_of

TPU = MaterialLaw(name="tpu", moduli=(4.8e6, 0.0, 0.0))
ZENER = MaterialLaw(name="zener", moduli=(5e6, 0, 0), branches=(MaxwellBranch(modulus=3e6, time=0.2),))
RICH = MaterialLaw(
    name="rich",
    moduli=(6e6, -5e6, 3e6),
    viscosity=(1e5, 2e4, 3e3),
    branches=(MaxwellBranch(modulus=3e6, time=0.02), MaxwellBranch(modulus=2e6, time=1.0)),
    yield_strain=0.7,
)


@given(st.floats(1e-3, 1e3), st.floats(1e-3, 10), st.floats(0.01, 1))
def test_a_held_branch_relaxes_as_an_exponential(time, share, strain):
    ramp = share * time
    law = MaterialLaw(name="arm", moduli=(0, 0, 0), branches=(MaxwellBranch(modulus=1e6, time=time),))
    held = np.linspace(0, 5 * time, 200)[1:]
    stress = stress_of(law, np.array([0, ramp, *(ramp + held)]), np.array([0, *np.full(200, strain)]))
    # a straight ramp, then no strain: the solution of dq/dt = E de/dt - q / tau
    start = 1e6 * strain * time / ramp * -math.expm1(-ramp / time)
    assert stress.branches[0, 1] == pytest.approx(start, rel=1e-12)
    assert stress.branches[0, 2:] == pytest.approx(start * np.exp(-held / time), rel=1e-11)


def test_a_branch_is_exact_whatever_the_steps():
    rng = np.random.default_rng(1)
    fine = np.linspace(0, 10, 20_001)
    coarse = fine[np.unique([0, *rng.integers(1, 20_000, 30), 20_000])]
    strains = rng.uniform(0, 1, len(coarse))
    once = stress_of(ZENER, coarse, strains).branches[0]
    often = stress_of(ZENER, fine, np.interp(fine, coarse, strains)).branches[0]
    assert often[np.searchsorted(fine, coarse)] == pytest.approx(once, abs=1e-9 * 3e6)


def loss_per_cycle(law, frequency, amplitude):
    """Loss of a sinusoid, J/m^3: pi E'' e0^2 (Ferry 1980, ch. 3), and the loss of the other terms of the damper."""
    w = 2 * math.pi * frequency
    first, second, third = law.viscosity or (0.0, 0.0, 0.0)
    loss = first * w + sum(branch.modulus * w * branch.time / (1 + (w * branch.time) ** 2) for branch in law.branches)
    nonlinear = amplitude**3 * w**2 * (8 / 3 * second + 3 * math.pi / 4 * third * w * amplitude)
    return math.pi * loss * amplitude**2 + nonlinear


@pytest.mark.parametrize("frequency", [0.01, 1.0, 100.0])
@pytest.mark.parametrize(
    "law",
    [ZENER, replace(ZENER, viscosity=(2e5, 0, 0)), replace(RICH, yield_strain=None)],
    ids=["Zener", "both", "rich"],
)
def test_a_sinusoid_loses_pi_times_the_loss_modulus_times_the_amplitude_squared(law, frequency):
    amplitude, cycles, samples = 0.1, 6, 2000
    time = np.linspace(0, cycles / frequency, cycles * samples + 1)
    slow = max((branch.time for branch in law.branches), default=0.0)
    # the initial stress of the branches has decayed by then
    time = np.concatenate([np.linspace(-30 * slow - 1 / frequency, 0, 200)[:-1], time])
    strain = 0.5 + np.where(time > 0, amplitude * np.sin(2 * np.pi * frequency * time), 0.0)
    last = time >= (cycles - 1) / frequency - 1e-9 / frequency
    stress = stress_of(law, time, strain).total
    loss = np.trapezoid(stress[last], strain[last])
    # at least 5 cycles of the longest relaxation, or nothing left of it: transients below 1e-3
    settled = loss_per_cycle(law, frequency, amplitude)
    assert loss == pytest.approx(settled, rel=1e-3) or frequency * slow > 1


def test_a_spring_yields_at_its_yield_strain_and_is_slack_below_its_set():
    law = MaterialLaw(name="plastic", moduli=(5e6, 0, 0), yield_strain=0.65)
    strain = np.array([0, 0.5, 1.0, 0.6, 0.35, 0.1, 0.6, 1.0])
    stress = stress_of(law, np.arange(8.0), strain)
    assert stress.spring == pytest.approx(5e6 * np.array([0, 0.5, 0.65, 0.25, 0, 0, 0.25, 0.65]))
    assert stress.set_strain == pytest.approx([0, 0, 0.35, 0.35, 0.35, 0.35, 0.35, 0.35])


def test_a_tendon_has_modulus_times_area_by_length():
    # Binder et al. 2025, section 3.3: 4.8 MPa and 6 cm
    for area, stiffness in ((5e-6, 400.0), (12.5e-6, 1000.0), (75e-6, 6000.0)):
        assert scaled(TPU, length=0.06, area=area).stiffness == pytest.approx((stiffness, 0, 0))
        assert area_for(TPU, length=0.06, stiffness=stiffness) == pytest.approx(area)


@given(st.floats(0.005, 0.5), st.floats(1e-7, 1e-3), st.floats(0, 0.69), st.floats(-30, 30))
def test_a_tendon_pulls_with_the_material_s_stress_times_its_area(length, area, strain, rate):
    tendon = scaled(RICH, length=length, area=area)
    elastic = area * stress_of(RICH, [0, 1], [0, strain]).spring[-1]
    assert tendon.elastic.force(length * (1 + strain)) == pytest.approx(elastic, abs=1e-9 * area * 6e6)
    v, (a, b, c) = rate * length, tendon.damping
    damper = area * rate * (1e5 + 2e4 * abs(rate) + 3e3 * rate**2)
    assert v * (a + b * abs(v) + c * v**2) == pytest.approx(damper)
    for branch, of_material in zip(tendon.branches, RICH.branches, strict=True):
        assert branch.stiffness * length / area == pytest.approx(of_material.modulus)
        assert branch.time == of_material.time
    assert tendon.yield_extension == pytest.approx(0.7 * length)
    assert tendon.yield_force == pytest.approx(area * (0.7 * 6e6 - 0.49 * 5e6 + 0.343 * 3e6))


def test_a_residual_strain_lengthens_the_tendon():
    tendon = scaled(replace(TPU, residual_strain=0.35), length=0.06, area=5e-6)
    assert (tendon.rest_length, tendon.stiffness[0]) == pytest.approx((0.081, 400))


def test_a_law_without_viscosity_does_not_set_the_damping():
    assert scaled(TPU, length=0.06, area=5e-6).damping is None


def test_a_range_of_values_needs_a_choice():
    law = MaterialLaw(name="resilin", ranges=(Bounds(key="modulus.linear", low=0.4e6, high=1.5e6),))
    with pytest.raises(InputError, match=r"resilin: modulus.linear: known only as a range, 0.4 to 1.5 MPa; choose"):
        scaled(law, length=0.06, area=5e-6)
    with pytest.raises(InputError, match=r"resilin: modulus.linear: need a value in 0.4 to 1.5 MPa, got 2 MPa"):
        with_linear_modulus(law, 2e6)
    assert scaled(with_linear_modulus(law, 1e6), length=0.01, area=1e-6).stiffness[0] == pytest.approx(100)


def test_a_missing_value_is_refused_by_name():
    law = MaterialLaw(name="mine", source="a data sheet", moduli=(1e6, 0, 0))
    with pytest.raises(InputError, match="mine: viscosity: is not given by its source, a data sheet"):
        require(law, "viscosity")
    with pytest.raises(InputError, match="strength: is not a section of a material law; need modulus, viscosity"):
        require(law, "strength")


@pytest.mark.parametrize(
    ("size", "message"),
    [
        ({"length": 0.0, "area": 5e-6}, r"length: need a resting length > 0, .*, got 0 cm"),
        ({"length": math.nan, "area": 5e-6}, "length: need a resting length > 0"),
        ({"length": 0.06, "area": 0.0}, r"area: need a cross-section > 0, got 0 mm\^2"),
    ],
)
def test_a_tendon_without_length_or_area_is_refused(size, message):
    with pytest.raises(InputError, match=message):
        scaled(TPU, **size)


@pytest.mark.parametrize(
    ("numbers", "message"),
    [
        ({"moduli": (-1.0, 0, 0)}, "modulus.linear: need a finite number >= 0, got -1"),
        ({"moduli": (1e6, -3e6, 2e6)}, r"modulus.quadratic: need >= 0 or > -2 sqrt\(linear cubic\)"),
        ({"moduli": (1e6, math.inf, 2e6)}, "modulus.quadratic: need a finite number, got inf"),
        ({"viscosity": (1.0, -1.0, 0)}, "viscosity.quadratic: need a finite number >= 0, got -1"),
        ({"yield_strain": 0.0}, "yield_strain: need a finite strain > 0, got 0"),
        ({"residual_strain": -0.1}, "residual_strain: need a finite strain >= 0, got -0.1"),
    ],
)
def test_an_invalid_law_is_refused(numbers, message):
    with pytest.raises(InputError, match=message):
        MaterialLaw(**{"name": "none", "moduli": (1e6, 0, 0), **numbers})


@pytest.mark.parametrize(
    ("time", "strain", "message"),
    [
        ([0.0, 1.0, 1.0], [0, 0.1, 0.2], "time: need to rise from row to row, got 1 s after 1 s in row 2"),
        ([0.0, math.nan], [0, 0.1], "time: need finite numbers, got nan in row 1"),
        ([0.0, 1.0], [0, 0.1, 0.2], "need two rows of equal length"),
    ],
)
def test_an_invalid_history_is_refused(time, strain, message):
    with pytest.raises(InputError, match=message):
        check_history(np.array(time), np.array(strain))


def test_a_branch_needs_a_modulus_and_a_time():
    with pytest.raises(InputError, match=r"branches.time: need a finite number > 0, got 0 s"):
        MaxwellBranch(modulus=1e6, time=0.0)
