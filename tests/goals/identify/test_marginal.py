"""Unknowns on which facts give information, among many on which they give none."""

import numpy as np
import xarray

from forficula.goals.identify.marginal import marginals

REPETITIONS, UNKNOWNS, SAMPLES = 200, 15, 256


def result(shares, agrees):
    """Return samples at coordinates, (samples, unknowns); some of them agree."""
    count = len(shares)
    return xarray.Dataset(
        {
            "agrees": ("sample", agrees),
            "directed": ("sample", np.zeros(count, dtype=bool)),
            "status": ("sample", np.full(count, "ran", dtype=object)),
        },
        coords={
            name: ("sample", column, {"key": name})
            for number, column in enumerate(shares.T)
            for name in (f"u{number}", f"u{number}_share")
        },
        attrs={"unknowns": [f"u{number}" for number in range(shares.shape[1])]},
    )


def test_uninformative_facts_give_a_significant_unknown_in_at_most_one_of_twenty_cases():
    output = 0
    for seed in range(REPETITIONS):
        shares = np.random.default_rng(seed).random((SAMPLES, UNKNOWNS))
        output += any(
            marginal.significant for marginal in marginals(result(shares, np.arange(SAMPLES) < SAMPLES // 10))
        )
    # 0.05, plus three of its standard errors
    assert output / REPETITIONS <= 0.05 + 3 * np.sqrt(0.05 * 0.95 / REPETITIONS)


def test_the_decisive_unknown_comes_first_with_its_range():
    shares = np.random.default_rng(0).random((SAMPLES, UNKNOWNS))
    first, *others = marginals(result(shares, shares[:, 7] < 0.2))
    assert (first.name, first.significant) == ("u7", True)
    assert first.agrees[1] < 0.2
    assert not any(other.significant for other in others)
