import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from forficula.errors import InputError
from forficula.material import TensileTest, cycle_drift, cycle_medians, find_cycles
from forficula.material.tensile.turning_points import turning_points
from tests.material.synthetic import AREA, LENGTH, cyclic_test

MODULUS = 4.8e6  # Pa, the paper's TPU
NOISE = 0.002 * MODULUS


def linear(strain, _):
    return MODULUS * strain


def slack_below(slack):
    """No force up to a strain, then linear to the same peak."""
    return lambda strain, _: MODULUS * np.maximum(strain - slack, 0) / (1 - slack)


def cubic(strain, _):
    return MODULUS * (0.5 * strain - 0.8 * strain**2 + 1.3 * strain**3)


@given(
    cycles=st.integers(1, 6),
    largest=st.floats(0.05, 3),
    noise=st.floats(0, 0.01),
    seed=st.integers(0, 99),
    samples=st.integers(50, 300),
)
@settings(deadline=None, max_examples=50)
def test_noise_of_the_travel_neither_splits_nor_joins_cycles(cycles, largest, noise, seed, samples):
    test = cyclic_test(linear, cycles=cycles, largest=largest, samples=samples)
    # five standard deviations stay below half of the band, 5 % of the travel; 1 % of noise is bounded by that
    shaken = np.clip(np.random.default_rng(seed).standard_normal(len(test.time)), -2.4, 2.4) * noise * largest * LENGTH
    shaken_test = TensileTest(
        name="s", time=test.time, extension=test.extension + shaken, force=test.force, length=LENGTH, area=AREA
    )
    result = find_cycles(shaken_test, drop_first=False)
    assert [cycle.number for cycle in result] == list(range(1, cycles + 1))
    for cycle in result:
        assert cycle.largest_strain == pytest.approx(largest, abs=2.4 * noise * largest + largest / samples)


def test_the_first_cycle_is_dropped_and_the_others_keep_their_numbers():
    assert [cycle.number for cycle in find_cycles(cyclic_test(linear))] == [2, 3, 4, 5]


def test_loading_and_unloading_share_the_turn_and_the_next_cycle_begins_where_one_ends():
    second, third, *_ = find_cycles(cyclic_test(linear))
    assert second.loading.time[-1] == second.unloading.time[0]
    assert second.unloading.time[-1] == third.loading.time[0]
    assert (np.diff(second.loading.strain) > 0).all()
    assert (np.diff(second.unloading.strain) < 0).all()


def test_an_unloading_that_is_cut_short_makes_no_cycle_and_one_that_keeps_half_does():
    whole = cyclic_test(linear, cycles=2, samples=100)
    for rows, numbers in ((340, [1]), (360, [1, 2])):
        test = TensileTest(
            name="s",
            time=whole.time[:rows],
            extension=whole.extension[:rows],
            force=whole.force[:rows],
            length=LENGTH,
            area=AREA,
        )
        assert [cycle.number for cycle in find_cycles(test, drop_first=False)] == numbers


def test_a_pull_to_break_has_no_cycle():
    whole = cyclic_test(linear, cycles=1, samples=100)
    pull = TensileTest(
        name="pull",
        time=whole.time[:90],
        extension=whole.extension[:90],
        force=whole.force[:90],
        length=LENGTH,
        area=AREA,
    )
    with pytest.raises(InputError, match=r"^pull: need a cycle of loading and unloading, found none$"):
        find_cycles(pull)
    with pytest.raises(InputError, match=r"^s: need a cycle .* found one, which drop_first leaves out$"):
        find_cycles(whole)


@pytest.mark.parametrize("band", [0.0, 1.0, -0.1, math.nan])
def test_a_band_is_a_share(band):
    with pytest.raises(InputError, match=r"band: need a share of the largest travel, > 0 and < 1, got"):
        find_cycles(cyclic_test(linear), band=band)


def test_a_test_that_pushes_is_refused():
    with pytest.raises(InputError, match="cycle 2: need a pull, got no force at the largest travel"):
        find_cycles(cyclic_test(lambda strain, _: -MODULUS * strain))


@given(signal=st.lists(st.floats(-1, 1), max_size=60), band=st.floats(0, 1))
def test_turning_points_alternate_and_differ_by_more_than_the_band(signal, band):
    turns = turning_points(np.array(signal), band)
    steps = np.diff(np.array(signal)[turns])
    assert (np.abs(steps) > band).all()
    assert (np.sign(steps[1:]) == -np.sign(steps[:-1])).all()
    assert turns == sorted(turns)


@given(ratio=st.floats(0.2, 0.99), noise=st.floats(0, NOISE), offset=st.floats(-1e5, 1e5))
@settings(deadline=None, max_examples=30)
def test_the_loss_is_the_area_between_both_branches(ratio, noise, offset):
    # unloading along sigma(1) r(e), r a cubic with r(0) = 0 and r(1) = 1
    def down(strain, _):
        return cubic(np.ones(1), 1) * (ratio * strain**3 + (1 - ratio) * strain)

    area = MODULUS * (0.5 / 2 - 0.8 / 3 + 1.3 / 4) - MODULUS * (ratio / 4 + (1 - ratio) / 2)
    samples = 500
    for cycle in find_cycles(cyclic_test(cubic, down, samples=samples, noise=noise, offset=offset)):
        # trapezoids: largest second derivative h^2 / 12 on each way; noise: five standard deviations of the mean
        trapezoid = 2 * (7.8 * MODULUS / 12) / samples**2
        assert cycle.loss == pytest.approx(area, abs=trapezoid + 5 * noise * math.sqrt(2 / samples))


def test_an_elastic_cycle_loses_nothing_and_its_secant_modulus_is_the_modulus():
    for cycle in find_cycles(cyclic_test(linear)):
        assert cycle.loss == pytest.approx(0, abs=1e-9 * MODULUS)
        assert cycle.secant_modulus == pytest.approx(MODULUS, rel=1e-9)
        assert cycle.residual_strain == pytest.approx(0, abs=1e-9)
        # the threshold is 1 % of the peak
        assert cycle.slack_strain == pytest.approx(0.01, abs=0.003)


@given(slack=st.floats(0.15, 0.6), noise=st.floats(0, NOISE), offset=st.floats(-2e5, 2e5))
@settings(deadline=None, max_examples=30)
def test_slack_is_found_under_noise_and_an_offset_of_the_load_cell(slack, noise, offset):
    samples = 500
    for cycle in find_cycles(cyclic_test(linear, slack_below(slack), samples=samples, noise=noise, offset=offset)):
        # the force is detected at 1 % of the peak or at five standard deviations, whose estimate may deviate by a fifth
        threshold = max(0.01, 6 * noise / MODULUS) * (1 - slack)
        assert slack - 2 / samples <= cycle.slack_strain <= slack + threshold + 2 / samples
        # the mean of 25 hanging samples has a fifth of the noise; the foot's line is through some 40 samples
        away = 3 * (noise / MODULUS) * (1 - slack)
        assert cycle.residual_strain == pytest.approx(slack, abs=away + 1e-9)
        assert cycle.zero_stress == pytest.approx(offset, abs=noise + 1)
        assert cycle.secant_modulus == pytest.approx(MODULUS, abs=8 * noise + 1)


def test_the_start_of_loading_and_the_end_of_unloading_are_distinguished():
    recovered = cyclic_test(slack_below(0.2), slack_below(0.35))
    for cycle in find_cycles(recovered):
        assert cycle.onset_strain == pytest.approx(0.2, abs=0.01)
        assert cycle.slack_strain == pytest.approx(0.35, abs=0.01)


def test_a_cycle_that_ends_under_force_has_no_slack_strain():
    for cycle in find_cycles(cyclic_test(lambda strain, _: MODULUS * (0.3 + strain))):
        assert math.isnan(cycle.slack_strain)
        assert math.isnan(cycle.onset_strain)
        assert math.isnan(cycle.residual_strain)


def test_an_offset_without_slack_is_not_taken_off():
    offset = 0.05 * MODULUS
    for cycle in find_cycles(cyclic_test(linear, offset=offset)):
        assert cycle.zero_stress == 0
        assert cycle.secant_modulus == pytest.approx(MODULUS + offset, rel=1e-9)


def test_the_noise_of_the_force_is_found():
    for cycle in find_cycles(cyclic_test(cubic, samples=5000, noise=NOISE)):
        # standard deviation of the median absolute deviation of n samples of normal noise: 1.17 / sqrt(n), here five of
        # them, and second differences of neighbours are correlated, which doubles it
        assert cycle.noise == pytest.approx(NOISE, rel=10 * 1.17 / math.sqrt(10_000))


def softening(share):
    """A law whose stress falls by a share of its first value with every cycle, and whose slack grows by 2 %."""

    def loading(strain, number):
        return (1 - share * number) * MODULUS * strain

    def unloading(strain, number):
        slack = 0.2 + 0.02 * number
        return loading(1, number) * np.maximum(strain - slack, 0) / (1 - slack)

    return loading, unloading


@given(share=st.floats(-0.05, 0.05))
@settings(deadline=None, max_examples=20)
def test_drift_is_that_of_the_law(share):
    specimens = [
        find_cycles(cyclic_test(*softening(share), noise=0.0005 * MODULUS, seed=seed, samples=200)) for seed in range(3)
    ]
    drift = cycle_drift(specimens)
    # five standard deviations of one sample, over three cycles
    assert drift.secant_modulus == pytest.approx(-share * MODULUS, abs=5 * 0.0005 * MODULUS)
    assert drift.residual_strain == pytest.approx(0.02, abs=1e-3)
    assert drift.slack_strain == pytest.approx(0.02, abs=5e-3)  # a sample's distance
    assert drift.largest_strain == pytest.approx(0, abs=1e-9)
    assert drift.specimens == 3
    # triangles under both branches: half the peak times 1, and times 1 - slack
    losses = [(1 - share * number) * MODULUS * (0.2 + 0.02 * number) / 2 for number in (2, 3, 4, 5)]
    assert drift.loss == pytest.approx(np.median(np.diff(losses)), abs=5e-4 * MODULUS)


def test_medians_are_over_the_specimens_that_have_the_cycle():
    tests = [
        cyclic_test(lambda e, _, factor=factor: factor * MODULUS * e, cycles=n)
        for factor, n in ((1, 3), (2, 2), (4, 3))
    ]
    first, second, third = cycle_medians([find_cycles(test, drop_first=False) for test in tests])
    assert (first.number, first.specimens, third.number, third.specimens) == (1, 3, 3, 2)
    assert first.secant_modulus == pytest.approx(2 * MODULUS)
    assert second.secant_modulus == pytest.approx(2 * MODULUS)
    assert third.secant_modulus == pytest.approx(2.5 * MODULUS)


def test_medians_ignore_missing_values_and_need_a_cycle():
    ends_under_force = find_cycles(cyclic_test(lambda strain, _: MODULUS * (0.3 + strain)))
    slack = find_cycles(cyclic_test(linear, slack_below(0.35)))
    assert cycle_medians([ends_under_force, slack])[0].slack_strain == slack[0].slack_strain
    assert math.isnan(cycle_medians([ends_under_force])[0].slack_strain)
    assert math.isnan(cycle_drift([ends_under_force[:1]]).secant_modulus)
    with pytest.raises(InputError, match="need the cycles of at least one specimen, got none"):
        cycle_medians([])
