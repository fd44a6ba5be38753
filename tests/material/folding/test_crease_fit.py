"""Fits of laws of creases recover planted values with their intervals, and refuse values that tests leave open."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from forficula.errors import InputError
from forficula.material import characterise_crease, fit_crease_law
from forficula.material.folding.crease_fit import permanent_folds
from tests.material.folding.strips import LAW, folded_strip

_SEEDS = 24
_TWO_SPEEDS = (0.01, 0.01, 0.05, 0.05)


def values(fit):
    return {value.key: value.value for value in fit.values}


@cache
def fits():
    return [fit_crease_law([folded_strip(seed, rows=40)]) for seed in range(_SEEDS)]


def test_the_planted_law_is_selected_and_recovered():
    fit = fits()[0]
    assert fit.law == "elastic and plastic"
    assert values(fit) == pytest.approx(LAW, rel=0.05)
    # the noise is 2e-3 N m/m
    assert fit.misfit == pytest.approx(2e-3, rel=0.1)


@pytest.mark.parametrize("key", LAW)
def test_intervals_contain_the_planted_value_as_often_as_they_say(key):
    inside = 0
    for fit in fits():
        (low, high) = next(value.interval for value in fit.values if value.key == key)
        inside += low <= LAW[key] <= high
    # 95 % of 24 is 23; fewer than 20 has a probability below 1 %
    assert inside >= 20


def test_two_rates_determine_the_viscous_loss():
    fit = fit_crease_law([folded_strip(speeds=_TWO_SPEEDS, damping=2.0, rows=80)])
    assert fit.law == "elastic and plastic, viscous"
    assert values(fit) == pytest.approx(LAW | {"damping": 2.0}, rel=0.05)


def test_a_crease_that_folds_elastically_has_no_yield_moment():
    crease = characterise_crease([folded_strip(yield_moment=5.0)])
    assert crease.fit.law == "elastic"
    assert any("folds elastically up to" in remark for remark in crease.remarks)


def test_without_unloading_no_yield_moment_is_fitted_and_the_reason_is_given():
    crease = characterise_crease([folded_strip(peaks=(1.6,), rows=200)])
    assert set(values(crease.fit)) == {"stiffness", "rest_angle"}
    assert "yield_moment: cannot be determined, because no test unloads; fold back after folding" in crease.remarks
    assert any("deviates from the data" in remark for remark in crease.remarks)


def test_one_rate_does_not_determine_the_viscous_loss():
    remarks = characterise_crease([folded_strip()]).remarks
    assert "damping: cannot be determined, because all motions have one rate, 0.573 deg/s; fold at two rates" in remarks


def test_permanent_folds_are_those_of_a_loop_over_the_rows():
    turned = np.cumsum(np.random.default_rng(3).standard_normal(300)) / 5
    fold, expected = 0.0, []
    for angle in turned:
        fold = min(max(fold, angle - 0.4), angle + 0.4)
        expected.append(fold)
    assert permanent_folds(turned, 0.4) == pytest.approx(np.array(expected), abs=1e-15)


@pytest.mark.parametrize(
    ("test", "message"),
    [
        (
            replace(folded_strip(), moment=-folded_strip().moment),
            "stiffness: need a moment that grows with the angle, or the sign of one of them is wrong",
        ),
        (folded_strip(peaks=(0.5,), rows=6), "need at least 10 rows, got 6"),
    ],
)
def test_tests_that_determine_no_law_are_refused(test, message):
    with pytest.raises(InputError, match=message):
        fit_crease_law([test])
