"""Agreeing ranges between samples contain planted values, and too few samples exclude nothing."""

import numpy as np
import pytest

from forficula.goals.identify.agreement import AgreementWindow, agreement, least_apart, snapped
from forficula.goals.identify.emulator import fit_emulator, least_samples
from forficula.goals.latin_points import latin_points

TOLERANCE = 0.04


def numbers(points):
    """A time and an energy as functions of stiffness and damping, (points, 2)."""
    stiffness, damping = 0.2 + 0.8 * points[:, 0], 10 ** points[:, 1]
    return np.column_stack([0.2 + 0.1 * damping**0.6 / stiffness**0.5, stiffness + stiffness**2 + 0.02 * damping])


@pytest.fixture(scope="module")
def samples():
    return latin_points(2, 64, 3)[:48]


@pytest.fixture(scope="module")
def emulators(samples):
    return [fit_emulator(samples, column) for column in numbers(samples).T]


def looked_for(emulators, bounds, tolerances):
    result = zip(emulators, bounds, tolerances, strict=True)
    return [AgreementWindow(emulator=item, low=bound - within, high=bound + within) for item, bound, within in result]


def test_planted_values_lie_in_ranges_much_narrower_than_the_priors(emulators):
    held, widths = [], []
    for seed in range(8):
        generator = np.random.default_rng([seed, 7])
        truth = generator.random((1, 2))
        (exact,) = numbers(truth)
        within = TOLERANCE * exact
        result = agreement(looked_for(emulators, exact + within * generator.uniform(-1, 1, 2), within), (0, 0), seed)
        low, high = np.quantile(result.points, [0.025, 0.975], axis=0)
        held += ((low <= truth[0]) & (truth[0] <= high)).tolist()
        widths += (high - low).tolist()
    # benchmarks/identify.py runs a hundred of these
    assert np.mean(held) >= 0.9
    assert np.median(widths) < 0.2


def test_values_between_samples_are_not_excluded_if_no_sample_but_the_truth_meets_both_facts(samples, emulators):
    exact = numbers(np.array([[0.43, 0.61]]))[0]
    within = 0.01 * exact
    assert not (np.abs(numbers(samples) - exact) <= within).all(axis=1).any()
    result = agreement(looked_for(emulators, exact, within), (0, 0), 0)
    assert result.apart <= 1
    # too few of 48 samples meet the facts to expect one that meets both
    assert 0 < 48 * result.share < 1
    assert least_apart(looked_for(emulators, exact, within), (0, 0), 0) <= 1


def test_contradicting_facts_deviate_by_many_standard_errors(emulators):
    # the longest time with the largest energy: a soft tendon has the former, a stiff one the latter
    far = looked_for(emulators, [numbers(np.array([[0.0, 1.0]]))[0, 0], 2.0], [0.02, 0.02])
    assert agreement(far, (0, 0), 0).apart > 3
    assert least_apart(far, (0, 0), 0) > 3


def test_fraction_of_priors_that_meets_a_fact_equals_closed_form(samples):
    emulator = fit_emulator(samples, samples[:, 0])
    result = agreement([AgreementWindow(emulator=emulator, low=0.4, high=0.5)], (0, 0), 0)
    assert result.share == pytest.approx(0.1, rel=0.2)
    assert 0.4 - 1e-3 <= result.points[:, 0].min() <= result.points[:, 0].max() <= 0.5 + 1e-3
    # the other value is not constrained
    assert np.quantile(result.points[:, 1], [0.025, 0.975]).tolist() == pytest.approx([0.025, 0.975], abs=0.06)
    # facts with one bound
    below = agreement([AgreementWindow(emulator=emulator, low=-np.inf, high=0.25)], (0, 0), 0)
    assert below.share == pytest.approx(0.25, rel=0.2)
    assert below.errors.tolist() == [0]


def test_choices_snap_to_the_middle_of_their_part(samples):
    middles = snapped(samples, (2, 0))
    assert set(middles[:, 0].tolist()) == {0.25, 0.75}
    assert (middles[:, 1] == samples[:, 1]).all()
    emulator = fit_emulator(middles, middles[:, 0])
    result = agreement([AgreementWindow(emulator=emulator, low=0.7, high=0.8)], (2, 0), 0)
    assert (result.points[:, 0] >= 0.5).all()
    assert result.share == pytest.approx(0.5, rel=0.2)


def test_standard_errors_cover_unseen_values_even_at_a_jump():
    held = []
    for seed in range(4):
        points, elsewhere = latin_points(2, 64, seed), np.random.default_rng([seed, 1]).random((200, 2))
        emulator = fit_emulator(points, np.where(points.sum(axis=1) > 1.3, 2.0, points[:, 0]))
        mean, error = emulator.predict(elsewhere)
        truth = np.where(elsewhere.sum(axis=1) > 1.3, 2.0, elsewhere[:, 0])
        held.append(np.mean(np.abs(truth - mean) <= 1.67 * error))
    assert np.mean(held) >= 0.87


def test_a_smooth_quantity_is_predicted_far_better_than_it_scatters():
    points, elsewhere = latin_points(3, 64, 0), np.random.default_rng(1).random((200, 3))
    values = [np.sin(3 * item[:, 0]) + 2 * item[:, 1] ** 2 + item[:, 0] * item[:, 2] for item in (points, elsewhere)]
    mean, error = fit_emulator(points, values[0]).predict(elsewhere)
    assert np.std(values[1] - mean) < 0.03 * np.std(values[1])
    assert np.mean(np.abs(values[1] - mean) <= 2 * error) >= 0.9


def test_too_few_samples_give_no_emulator():
    assert least_samples(15) == 34
    assert fit_emulator(latin_points(15, 32, 0), np.zeros(32)) is None
    # a constant quantity has an emulator
    mean, error = fit_emulator(latin_points(2, 16, 0), np.full(16, 3.0)).predict(np.full((1, 2), 0.3))
    assert mean.tolist() == pytest.approx([3.0])
    assert error[0] < 1e-3
