"""Points are computed from their index: any part of a study has the points of the whole."""

import itertools
import math

import numpy as np
import pytest
from scipy import stats

from forficula.design import FanDesign
from forficula.quantities import parse_quantity
from forficula.study.factors import read_factor
from forficula.study.points import GridPoints, SampledPoints

LENGTHS = {
    "tendon.rest_length": {"distribution": "uniform", "low": "4 cm", "high": "9 cm"},
    "pattern.hub_radius": {"distribution": "log-uniform", "low": "1 mm", "high": "10 cm"},
    "vein.diameter": {"distribution": "normal", "mean": "5 mm", "deviation": "0.2 mm"},
}
FACTORS = tuple(read_factor(key, table, FanDesign) for key, table in LENGTHS.items())
GRID = (
    read_factor("tendon.stiffness", "10..30 N/cm step 10", FanDesign),
    read_factor("pattern.units", [1, 2], FanDesign),
    read_factor("protocol.timestep", ["auto", "0.2 ms"], FanDesign),
)
COUNT = 10_000


def in_si(point):
    return [parse_quantity(point[factor.key], factor.unit) for factor in FACTORS]


@pytest.mark.parametrize("method", ["random", "sobol"])
def test_parts_of_sampled_points_are_those_of_one_sequence(method):
    if method == "sobol":
        shares = stats.qmc.Sobol(3, rng=np.random.default_rng(7)).random_base2(14)[:COUNT]
    else:
        shares = np.random.default_rng(7).random((COUNT, 3))
    columns = [factor.distribution.quantiles(column) for factor, column in zip(FACTORS, shares.T, strict=True)]
    expected = np.stack(columns, axis=1)
    points = SampledPoints(FACTORS, method, COUNT, 7)
    assert len(points) == COUNT
    assert np.array_equal(points.si_values(range(COUNT)), expected)
    # ranges begin, end and pass over the boundaries of blocks
    for numbers in (range(4095, 4098), range(3, COUNT, 997), range(9000, 9000), range(5000, COUNT, 8192)):
        assert np.array_equal(points.si_values(numbers), expected[numbers])
    for number in (0, 4095, 4096, COUNT - 1):
        assert in_si(points[number]) == expected[number].tolist()
    assert points[-1] == points[COUNT - 1]
    assert [in_si(point) for point in points[4090:4100:3]] == expected[4090:4100:3].tolist()
    with pytest.raises(IndexError):
        points[COUNT]


def test_a_grid_has_every_combination_and_its_last_factor_varies_fastest():
    points = GridPoints(GRID)
    values = itertools.product(*(factor.values for factor in GRID))
    assert list(points) == [dict(zip([factor.key for factor in GRID], row, strict=True)) for row in values]
    assert len(points) == 12
    assert points[5:7] == [points[5], points[6]]
    assert points == GridPoints(GRID) != GridPoints(GRID[:2])


def test_words_and_whole_numbers_have_no_value_in_si():
    values = GridPoints(GRID).si_values(range(1, 12, 2))
    assert values[:, 0].tolist() == pytest.approx([1000, 1000, 2000, 2000, 3000, 3000])
    assert np.isnan(values[:, 1]).all()
    assert values[:, 2].tolist() == pytest.approx([2e-4] * 6)
    assert math.isnan(GridPoints(GRID).si_values(range(1))[0, 2])
