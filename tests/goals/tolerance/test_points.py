import numpy as np
import pytest

from forficula.goals.tolerance.plan import exchanged, two_samples


def test_more_rows_begin_with_those_of_fewer():
    for few, many in zip(two_samples(25, 16, 7), two_samples(25, 256, 7), strict=True):
        np.testing.assert_array_equal(few, many[:16])


def test_both_samples_are_balanced_along_every_factor():
    for sample in two_samples(25, 256, 1):
        assert np.all((sample > 0) & (sample < 1))
        # one point lies in each of equally many parts of every axis
        assert np.all(np.sort(np.floor(sample * 256), axis=0) == np.arange(256)[:, None])


def test_the_two_samples_are_independent():
    first, second = two_samples(25, 4096, 1)
    assert np.abs(np.corrcoef(first.T, second.T)[:25, 25:]).max() < 4 / np.sqrt(4096)


def test_another_seed_gives_other_points():
    assert not np.any(two_samples(3, 8, 0)[0] == two_samples(3, 8, 1)[0])


def test_exchanging_a_group_leaves_all_other_columns():
    first, second = two_samples(4, 8, 0)
    mixed = exchanged(first, second, [1, 3])
    np.testing.assert_array_equal(mixed[:, [0, 2]], first[:, [0, 2]])
    np.testing.assert_array_equal(mixed[:, [1, 3]], second[:, [1, 3]])


def test_a_number_of_rows_that_is_no_power_of_two_is_refused():
    with pytest.raises(ValueError, match="power of two, got 100"):
        two_samples(3, 100, 0)
