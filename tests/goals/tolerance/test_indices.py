"""Sobol indices of functions whose indices are known in closed form."""

import numpy as np
import pytest

from forficula.goals.tolerance.indices import line_indices, sobol_indices, total_effects
from forficula.goals.tolerance.plan import exchanged, two_samples

A, B = 7.0, 0.1


def ishigami(points):
    """Ishigami and Homma (1990, doi:10.1109/ISUMA.1990.151285)."""
    first, second, third = (2 * points.T - 1) * np.pi
    return np.sin(first) + A * np.sin(second) ** 2 + B * third**4 * np.sin(first)


ALONE = np.array([0.5 * (1 + B * np.pi**4 / 5) ** 2, A**2 / 8, 0.0])
FIRST_WITH_THIRD = B**2 * np.pi**8 * (1 / 18 - 1 / 50)
VARIANCE = np.sum(ALONE) + FIRST_WITH_THIRD
FIRST = ALONE / VARIANCE
TOTAL = (ALONE + np.array([1, 0, 1]) * FIRST_WITH_THIRD) / VARIANCE
WEIGHTS = np.array([1.0, 2.0, 3.0, 0.5, 0.0])


def linear(points):
    return points @ WEIGHTS


def indices(function, factors, rows, seed=0, groups=None):
    first, second = two_samples(factors, rows, seed)
    groups = groups or [[factor] for factor in range(factors)]
    mixed = np.array([[function(exchanged(first, second, group))] for group in groups])
    names = [str(group) for group in groups]
    return sobol_indices(["result"], names, function(first)[None], function(second)[None], mixed, seed)


def test_ishigamis_function_has_its_closed_form_indices():
    result = indices(ishigami, 3, 16384)
    np.testing.assert_allclose(result.first[0], FIRST, atol=0.025)
    np.testing.assert_allclose(result.total[0], TOTAL, atol=0.01)


def test_the_intervals_hold_ishigamis_indices_in_nine_of_ten_repetitions_or_more(monkeypatch):
    """Nine in ten of 60 repetitions, minus two standard errors of this number."""
    # 5 of them are beyond either end
    monkeypatch.setattr("forficula.goals.tolerance.indices._RESAMPLES", 199)
    result = [indices(ishigami, 3, 128, seed) for seed in range(60)]
    for exact, low, high in (
        (FIRST, [item.first_low[0] for item in result], [item.first_high[0] for item in result]),
        (TOTAL, [item.total_low[0] for item in result], [item.total_high[0] for item in result]),
    ):
        assert np.mean((np.array(low) <= exact) & (exact <= np.array(high)), axis=0).min() >= 0.82


def test_factors_of_a_sum_have_their_weights_squared_and_no_interactions():
    shares = WEIGHTS**2 / np.sum(WEIGHTS**2)
    result = indices(linear, 5, 4096)
    np.testing.assert_allclose(result.first[0], shares, atol=0.03)
    np.testing.assert_allclose(result.total[0], shares, atol=0.01)
    assert result.total[0, 4] == result.first[0, 4] == 0


def test_a_group_of_a_sum_has_the_indices_of_its_factors_together():
    shares = WEIGHTS**2 / np.sum(WEIGHTS**2)
    result = indices(linear, 5, 4096, groups=[[2], [0, 1], [3, 4]])
    np.testing.assert_allclose(result.total[0], [shares[2], shares[0] + shares[1], shares[3]], atol=0.01)


def test_a_group_includes_interactions_of_its_factors():
    """Ishigami's first and third factor explain all that the second does not, including their interaction."""
    result = indices(ishigami, 3, 4096, groups=[[0, 2], [1]])
    np.testing.assert_allclose(result.first[0], [1 - FIRST[1], FIRST[1]], atol=0.03)
    np.testing.assert_allclose(result.total[0], [1 - FIRST[1], FIRST[1]], atol=0.01)


def test_a_group_of_all_factors_explains_the_whole_variance():
    result = indices(linear, 5, 256, groups=[[0, 1, 2, 3, 4]])
    np.testing.assert_allclose([result.first[0, 0], result.total[0, 0]], 1, atol=0.1)


def test_every_result_has_its_own_indices():
    first, second = two_samples(3, 4096, 3)
    points = [first, second, *(exchanged(first, second, [factor]) for factor in range(3))]
    values = [np.array([ishigami(point), point[:, 0]]) for point in points]
    result = sobol_indices(["wave", "line"], ["a", "b", "c"], values[0], values[1], np.array(values[2:]), 0)
    np.testing.assert_allclose(result.total[0], TOTAL, atol=0.03)
    np.testing.assert_allclose(result.total[1], [1, 0, 0], atol=0.02)


def test_a_result_that_does_not_vary_has_no_indices():
    result = indices(lambda points: np.full(len(points), 0.7), 3, 64)
    assert np.isnan([result.first, result.total, result.first_low, result.total_high]).all()


@pytest.mark.parametrize("bad", [np.nan, np.inf])
def test_a_result_that_is_not_finite_is_refused_by_name(bad):
    """scipy would silently return zeros."""
    first, second = two_samples(3, 64, 0)
    mixed = np.array([[ishigami(exchanged(first, second, [factor]))] for factor in range(3)])
    mixed[1, 0, 5] = bad
    with pytest.raises(ValueError, match=f"margin: need finite results, got {bad} at point 5 of .* with b exchanged"):
        sobol_indices(["margin"], ["a", "b", "c"], ishigami(first)[None], ishigami(second)[None], mixed, 0)


def test_the_same_seed_gives_the_same_intervals_bit_for_bit():
    one, other = indices(ishigami, 3, 64, 5), indices(ishigami, 3, 64, 5)
    assert one.first_low.tobytes() == other.first_low.tobytes()
    assert one.total_high.tobytes() == other.total_high.tobytes()


def screened(function, rows, seed):
    first, second = two_samples(25, rows, seed)
    mixed = np.array([function(exchanged(first, second, [factor])) for factor in range(25)])
    return total_effects(function(first), mixed, (second - first).T)


def test_screening_keeps_a_factor_that_acts_only_in_an_interaction():
    """Ishigami's third factor alone has no effect; 22 others share a twentieth of the variance."""
    deciding = [4, 9, 17]
    others = [factor for factor in range(25) if factor not in deciding]
    weight = np.sqrt(12 * 0.05 * VARIANCE / len(others))

    def among_others(points):
        return ishigami(points[:, deciding]) + weight * np.sum(points[:, others], axis=1)

    ranks = [np.argsort(np.argsort(-screened(among_others, 16, seed)))[deciding] for seed in range(50)]
    assert np.max(ranks) < 8
    assert np.mean(np.max(ranks, axis=1) < 3) > 0.9


def test_linear_fit_separates_factors_of_a_sum_with_correlated_columns():
    """Of 64 points in 21 factors, the worst pair of columns has a correlation of more than 0.3."""
    weights = np.array([3.0, 2.0, 1.0, *np.zeros(18)])
    points = two_samples(21, 64, 0)[0]
    assert np.abs(np.corrcoef(points.T) - np.eye(21)).max() > 0.3
    result = line_indices(["sum"], [str(factor) for factor in range(21)], points, (points @ weights)[None], 0)
    np.testing.assert_allclose(result.first[0], weights**2 / np.sum(weights**2), atol=0.02)
    assert np.isnan(result.total).all()


def test_linear_fit_explains_nothing_of_noise_on_average():
    points, rng = two_samples(10, 64, 0)[0], np.random.default_rng(1)
    noise = rng.standard_normal((200, 64))
    result = line_indices([str(index) for index in range(200)], [str(index) for index in range(10)], points, noise, 0)
    # mean of 2000 fractions of a variance; a single fraction scatters by 0.02
    assert abs(np.mean(result.first)) < 0.002
    held = (result.first_low <= 0) & (result.first_high >= 0)
    assert np.mean(held) > 0.9


def test_too_few_points_give_no_linear_fit():
    points = two_samples(10, 16, 0)[0]
    result = line_indices(["sum"], [str(index) for index in range(10)], points, np.sum(points, axis=1)[None], 0)
    assert np.isnan(result.first).all()


@pytest.mark.parametrize("rows", [2, 16])
def test_screening_of_a_sum_is_exact_however_few_its_rows(rows):
    weights = np.linspace(0, 3, 25)
    np.testing.assert_allclose(screened(lambda points: points @ weights, rows, 1), weights**2 / 12, atol=1e-12)
