"""Factors of sparse symmetric matrices: solutions, inertia, eigenvectors."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.sparse import csc_array, random_array

from forficula.statics.net.factor import definite, factored, lowest, softest


def symmetric(size, seed):
    part = random_array((size, size), density=min(1.0, 3 / size), rng=np.random.default_rng(seed), format="csc")
    diagonal = np.random.default_rng(seed + 1).standard_normal(size)
    return csc_array(part + part.T + csc_array(np.diag(diagonal)))


@settings(deadline=None, max_examples=20)
@given(st.integers(2, 150), st.integers(0, 1000))
def test_the_index_counts_the_eigenvalues_below_zero(size, seed):
    matrix = symmetric(size, seed)
    values = np.linalg.eigvalsh(matrix.toarray())
    assert factored(matrix).index == np.count_nonzero(values < 0)
    assert factored(matrix, -values[size // 2] - 1e-6).index == size // 2 + 1


@settings(deadline=None, max_examples=20)
@given(st.integers(1, 60), st.integers(0, 1000))
def test_the_inertia_of_a_dense_matrix_is_that_of_its_sparse_one(size, seed):
    matrix = symmetric(size, seed)
    for shift in (0.0, 0.3, -0.7):
        assert factored(matrix.toarray(), shift).index == factored(matrix, shift).index


def test_a_singular_dense_matrix_is_factorised_after_a_small_shift():
    factors = factored(np.zeros((3, 3)), 0.0)
    assert factors.index == 0
    assert np.all(np.isfinite(factors.solve(np.ones(3))))


@pytest.mark.parametrize("form", [csc_array, np.asarray])
def test_the_factorisation_solves_linear_systems(form):
    matrix, right = form(symmetric(50, 3).toarray()), np.arange(100.0).reshape(50, 2)
    solution = factored(matrix).solve(right)
    np.testing.assert_allclose(matrix @ solution, right, atol=1e-8)
    np.testing.assert_allclose(factored(matrix).solve(right[:, 1]), solution[:, 1], rtol=1e-10)
    assert factored(csc_array((0, 0))).solve(np.zeros(0)).shape == (0,)


@pytest.mark.parametrize("size", [40, 150])
def test_softest_are_the_eigenvalues_nearest_to_zero(size):
    matrix = symmetric(size, 5)
    values = np.linalg.eigvalsh(matrix.toarray())
    nearest = np.sort(values[np.argsort(np.abs(values))[:6]])
    result, vectors = softest(matrix, 6)
    np.testing.assert_allclose(result, nearest, atol=1e-9)
    np.testing.assert_allclose(matrix @ vectors, vectors * result, atol=1e-8)


@pytest.mark.parametrize("size", [40, 150])
def test_the_lowest_is_found_however_far_below_zero(size):
    matrix = csc_array(np.diag(np.linspace(1.0, 50.0, size) - 1000.0 * (np.arange(size) == 7)))
    assert abs(lowest(matrix)[7]) == pytest.approx(1.0)


@settings(deadline=None, max_examples=10)
@given(st.integers(101, 300), st.integers(0, 1000))
def test_a_large_positive_definite_matrix_is_solved_as_a_band(size, seed):
    matrix, right = symmetric(size, seed), np.arange(2.0 * size).reshape(size, 2)
    shift = 1.0 - np.linalg.eigvalsh(matrix.toarray())[0]
    factors = factored(matrix, shift)
    assert factors.index == 0
    solution = factors.solve(right)
    np.testing.assert_allclose(matrix @ solution + shift * solution, right, atol=1e-8)
    np.testing.assert_allclose(factors.solve(right[:, 1]), solution[:, 1], rtol=1e-9, atol=1e-9)


@settings(deadline=None, max_examples=10)
@given(st.integers(2, 150), st.integers(0, 1000))
def test_only_a_positive_definite_matrix_is_factorised_as_one(size, seed):
    matrix = symmetric(size, seed)
    least = np.linalg.eigvalsh(matrix.toarray())[0]
    assert definite(matrix, -least - 1e-3) is None
    parts = definite(matrix, -least + 1e-3)
    assert parts is not None
    assert parts.index == 0
