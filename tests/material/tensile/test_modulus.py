import math

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from forficula.errors import InputError
from forficula.material import find_cycles, moduli_by_strain
from tests.material.synthetic import cyclic_test

MODULUS = 4.8e6
WIDTH = 0.1


def class_of(entries, way, place, cycle=None):
    (entry,) = (
        entry
        for entry in entries
        if entry.way == way and entry.cycle == cycle and entry.from_strain == pytest.approx(place * WIDTH)
    )
    return entry


@given(a=st.floats(0.1, 2), b=st.floats(-1, 1), c=st.floats(0, 2), noise=st.floats(0, 0.003))
@settings(deadline=None, max_examples=25)
def test_moduli_are_those_of_a_planted_cubic(a, b, c, noise):
    def law(strain, _):
        return MODULUS * (a * strain + b * strain**2 + c * strain**3)

    peak = MODULUS * (a + b + c)
    assume(peak > 0.2 * MODULUS)
    samples = 1000
    specimens = [
        find_cycles(cyclic_test(law, cycles=3, samples=samples, noise=noise * peak, seed=seed)) for seed in range(3)
    ]
    entries = moduli_by_strain(specimens, pool_cycles=True)
    assert len(entries) == 20
    for place in range(1, 10):
        middle = (place + 0.5) * WIDTH
        # the line through a parabola has its slope in the middle, through a cubic 3/5 (w/2)^2 c more: the integral of
        # x^4 over that of x^2; noise: five standard errors of one value, sqrt(12 / n) over the width
        derivative = MODULUS * (a + 2 * b * middle + 3 * c * middle**2 + 0.6 * c * (WIDTH / 2) ** 2)
        # and the samples' middle is up to one of their distances away
        local_error = 5 * math.sqrt(12 / (samples * WIDTH)) * noise * peak / WIDTH
        local_error += MODULUS * (2 * abs(b) + 6 * c) / samples
        # the median of a monotone secant is that of the middle strain; otherwise it is within the range of the class
        edges = np.linspace(place * WIDTH, (place + 1) * WIDTH, 50)
        secants = MODULUS * (a + b * edges + c * edges**2)
        secant_error = 5 * noise * peak / (place * WIDTH) * 1.25 / math.sqrt(samples * WIDTH) + 1e-3 * MODULUS
        for way in ("loading", "unloading"):
            entry = class_of(entries, way, place)
            assert entry.local_modulus.median == pytest.approx(derivative, abs=local_error + 1e-9 * MODULUS)
            assert secants.min() - secant_error <= entry.secant_modulus.median <= secants.max() + secant_error
            assert entry.values == 6
            assert entry.points == pytest.approx(6 * samples * WIDTH, abs=12)


def test_loading_unloading_and_cycles_are_distinguished():
    test = cyclic_test(lambda e, n: n * MODULUS * e, lambda e, n: n * MODULUS * e**2, cycles=3)
    entries = moduli_by_strain([find_cycles(test)])
    assert [entry.cycle for entry in entries] == [2] * 20 + [3] * 20
    for number in (2, 3):
        assert class_of(entries, "loading", 5, number).local_modulus.median == pytest.approx(number * MODULUS)
        # at the middle of the class, twice the strain
        unloading = class_of(entries, "unloading", 5, number)
        assert unloading.local_modulus.median == pytest.approx(number * MODULUS * 1.1, rel=1e-2)
        assert unloading.secant_modulus.median == pytest.approx(number * MODULUS * 0.55, rel=1e-2)


def test_quartiles_are_over_specimens():
    specimens = [
        find_cycles(cyclic_test(lambda e, _, factor=factor: factor * MODULUS * e, cycles=2))
        for factor in (1, 2, 3, 4, 5)
    ]
    entry = moduli_by_strain(specimens)[3]
    for modulus in (entry.secant_modulus, entry.local_modulus):
        assert modulus.lower == pytest.approx(2 * MODULUS)
        assert modulus.median == pytest.approx(3 * MODULUS)
        assert modulus.upper == pytest.approx(4 * MODULUS)
    assert entry.values == 5


def test_slack_and_offset_leave_no_force_in_the_low_classes():
    offset = 1e5

    def slack(strain, _):
        return MODULUS * np.maximum(strain - 0.35, 0)

    entries = moduli_by_strain([find_cycles(cyclic_test(lambda e, _: MODULUS * 0.65 * e, slack, offset=offset))])
    for place in range(3):
        entry = class_of(entries, "unloading", place, 2)
        assert entry.secant_modulus.median == pytest.approx(0, abs=1)
        assert entry.local_modulus.median == pytest.approx(0, abs=1)
    assert class_of(entries, "unloading", 7, 2).local_modulus.median == pytest.approx(MODULUS)


def test_a_class_that_is_hardly_touched_has_no_moduli():
    entries = moduli_by_strain([find_cycles(cyclic_test(lambda e, _: MODULUS * e, largest=0.43))])
    assert max(entry.to_strain for entry in entries) == 0.4
    coarse = find_cycles(cyclic_test(lambda e, _: MODULUS * e, samples=20, cycles=2))
    with pytest.raises(
        InputError, match=r"need cycles with at least 5 samples in half a class of 10% strain, got none"
    ):
        moduli_by_strain([coarse])


@pytest.mark.parametrize("width", [0.0, -0.1, math.nan, math.inf])
def test_a_class_has_a_width(width):
    with pytest.raises(InputError, match="width: need a strain > 0, got"):
        moduli_by_strain([], width=width)
