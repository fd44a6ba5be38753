import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy import stats

from forficula.design import FanDesign, key_quantity
from forficula.errors import InputError
from forficula.quantities import Unit, parse_quantity
from forficula.study.factors import Distribution, range_values, read_factor
from forficula.study.points import SampledPoints

LENGTH = Unit(display="cm", si="m", example="12 cm")


def lengths(text):
    return [parse_quantity(value, LENGTH) for value in range_values("tendon.rest_length", text)]


@pytest.mark.parametrize(
    ("text", "values"),
    [
        ("0..9 cm step 1", [f"{number} cm" for number in range(10)]),
        ("10..60 cm step 10", ["10 cm", "20 cm", "30 cm", "40 cm", "50 cm", "60 cm"]),
        ("1..2 m step 0.25 m", ["1 m", "1.25 m", "1.5 m", "1.75 m", "2 m"]),
        ("0..1 cm step 0.1", [f"{tenths / 10:g} cm" for tenths in range(11)]),
        ("4..4 cm step 1", ["4 cm"]),
        ("  .5..1.5mm  step 5e-1 ", ()),
        ("-1..1 cm step 1", ["-1 cm", "0 cm", "1 cm"]),
    ],
)
def test_a_range_has_both_its_ends(text, values):
    if values:
        assert list(range_values("tendon.rest_length", text)) == values
    else:
        with pytest.raises(InputError, match="need three numbers"):
            range_values("tendon.rest_length", text)


@settings(max_examples=200, deadline=None)
@given(st.integers(-500, 500), st.integers(1, 99), st.integers(0, 200), st.integers(0, 4))
def test_the_decimals_of_a_range_are_those_that_a_person_would_write(first, step, count, digits):
    def decimal(number):
        return f"{number / 10**digits:.{digits}f}"

    values = lengths(f"{decimal(first)}..{decimal(first + count * step)} m step {decimal(step)}")
    assert values == [float(decimal(first + index * step)) for index in range(count + 1)]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("9..0 cm step 1", "need a range that rises"),
        ("0..9 cm step 0", "need a range that rises"),
        ("0..9 cm step -1", "need a range that rises"),
        ("nan..9 cm step 1", "need a range that rises"),
        ("0..inf cm step 1", "need a range that rises"),
        ("0..9 cm", "need a range such as"),
        ("0-9 cm step 1", "need a range such as"),
        ("", "need a range such as"),
        ("." * 100_000, "need a range such as"),
        ("0..9 cm step 1" + " " * 100_000, "need a range such as"),
        ("a..b cm step c", "need three numbers"),
        ("0..9 cm step 1 mm", "need the step in the unit of the range"),
        ("0..1 m step 1e-7", "need at most 1000000 values"),
        ("0..1e308 m step 1e-308", "need at most 1000000 values"),
        ("-1e308..1e308 m step 1", "need at most 1000000 values"),
        (
            "5..9 cm step 3 cm",
            "need a step that divides the range, such as an end of 8 or 11 or a step of 4 or 2, got"
            ' "5..9 cm step 3 cm"',
        ),
        ("5..9 cm step 30 cm", "need a step that divides the range, such as an end of 35 or a step of 4, got "),
        ("1..5.9 cm step 2", "need a step that divides the range, such as an end of 5 or 7 or a step of 2.45, got "),
        ("0..1 m step 0.3", "need a step that divides the range, such as an end of 0.9 or 1.2 or a step of 0.25, got "),
    ],
)
def test_a_text_that_is_no_range_is_refused_with_the_key(text, message):
    with pytest.raises(InputError) as caught:
        range_values("tendon.rest_length", text)
    assert str(caught.value).startswith(f"tendon.rest_length: {message}")
    assert len(str(caught.value)) < 250


def test_an_integer_factor_takes_whole_numbers():
    values = read_factor("pattern.units", "1..4 step 1", FanDesign).values
    assert values == (1, 2, 3, 4)
    assert all(type(value) is int for value in values)
    assert read_factor("pattern.units", [1, 3], FanDesign).values == (1, 3)


def test_a_list_keeps_its_values():
    factor = read_factor("tendon.stiffness", ["10 N/cm", "1500 N/m"], FanDesign)
    assert factor.values == ("10 N/cm", "1500 N/m")
    assert factor.dimension == "tendon_stiffness"
    assert read_factor("pattern.tangent", ["left", "right"], FanDesign).values == ("left", "right")
    assert read_factor("protocol.timestep", ["0.2 ms", "auto"], FanDesign).values == ("0.2 ms", "auto")


@pytest.mark.parametrize(
    ("key", "nearest"),
    [("tendon.stifness", "tendon.stiffness"), ("tendons.rest_length", "tendon.rest_length"), ("vein.diametre", "vein")],
)
def test_an_unknown_key_is_answered_with_the_nearest(key, nearest):
    with pytest.raises(InputError, match=rf"^{key}: unknown key, got .*; .*{nearest}"):
        read_factor(key, ["1 cm"], FanDesign)


def test_laws_are_a_factor_by_their_names():
    factor = read_factor("tendon.law", ["none", "tpu-82a", "tpu-95a"], FanDesign)
    assert (factor.values, factor.unit) == (("none", "tpu-82a", "tpu-95a"), None)
    with pytest.raises(InputError, match=r'^tendon\.law: "tpu-83a" is neither .*; did you mean tpu-82a\?'):
        read_factor("tendon.law", ["tpu-82a", "tpu-83a"], FanDesign)
    with pytest.raises(InputError, match=r"^tendon\.law: need a list such as"):
        read_factor("tendon.law", "tpu-82a", FanDesign)


@pytest.mark.parametrize(
    ("key", "message"),
    [
        ("tendon", "holds several values; name one of them: tendon.stiffness, tendon.rest_length, "),
        ("protocol.stages", "holds several values; name one of them: protocol.stages.0.name, "),
        ("protocol.stages.3", "holds several values; name one of them: protocol.stages.3.name, "),
        ("protocol.stages.0.hodl", r'unknown key, got \["1 s"\]; did you mean protocol.stages.0.hold\?'),
        ("protocol.stages.time_limit", "need the number of an entry of protocol.stages"),
        ("tendon.stiffness.x", r'unknown key, got \["1 s"\]; did you mean tendon.stiffness\?'),
        ("name", "need a key on which runs depend"),
        ("based_on", "is not a value of a design; name the design to start from"),
        ("", r'unknown key, got \["1 s"\]; allowed here: '),
    ],
)
def test_an_invalid_factor_is_rejected_with_a_valid_example(key, message):
    with pytest.raises(InputError, match=f"^{key}: {message}"):
        read_factor(key, ["1 s"], FanDesign)


@pytest.mark.parametrize(
    ("key", "value", "unit"),
    [
        ("protocol.stages.1.time_limit", "0.1 s", "s"),
        ("protocol.stages.12.hold", "10 ms", "s"),
        ("protocol.stages.0.drive", "none", None),
        ("membrane.proximal_rows.0", 0.4, None),
    ],
)
def test_a_value_in_an_entry_of_a_list_is_a_factor(key, value, unit):
    quantity = key_quantity(key)
    assert (quantity and quantity.unit.si) == unit
    assert read_factor(key, [value], FanDesign).values == (value,)


@pytest.mark.parametrize(
    ("key", "values", "message"),
    [
        ("tendon.stiffness", [], "need at least one value"),
        ("tendon.stiffness", 5, "need a list, a range such as"),
        ("tendon.stiffness", True, "need a list, a range such as"),
        ("tendon.stiffness", [5], "the unit is missing"),
        ("tendon.stiffness", ["10 N/cm", "10 cm"], '"cm" is not a unit of the right kind'),
        ("tendon.stiffness", ["much"], "need a number and a unit"),
        ("tendon.stiffness", [{"a": 1}], "need text with a unit"),
        ("tendon.stiffness", "1..5 cm step 1", '"cm" is not a unit of the right kind'),
        ("tendon.stiffness", "1..5 step 1", "the unit is missing"),
        ("protocol.timestep", ["0.2 ms", "automatic"], 'need a number and a unit .*; "auto" is allowed, too'),
        ("protocol.window", ["0.2 s", "auto"], "need a number and a unit"),
        ("pattern.units", [None], "need numbers or words"),
        ("tendon.rest_length", ["5 cm", "5 cm", "6 cm"], 'need values that differ, got "5 cm" twice'),
        ("tendon.rest_length", ["5 cm", "6 cm", "50 mm"], 'need values that differ, got "5 cm" and "50 mm"'),
        ("protocol.timestep", ["auto", "0.2 ms", "auto"], 'need values that differ, got "auto" twice'),
        ("pattern.units", [1, 2, 1], "need values that differ, got 1 twice"),
        ("tendon.law", ["tpu-82a", "tpu-82a"], 'need values that differ, got "tpu-82a" twice'),
    ],
)
def test_values_that_no_table_can_label_are_refused_before_anything_runs(key, values, message):
    with pytest.raises(InputError, match=f"^{key}: {message}"):
        read_factor(key, values, FanDesign)


DISTRIBUTIONS = {
    "uniform": ({"low": "1 cm", "high": "3 cm"}, stats.uniform(0.01, 0.02)),
    "log-uniform": ({"low": "1 mm", "high": "10 cm"}, stats.loguniform(1e-3, 0.1)),
    "normal": ({"mean": "5 cm", "deviation": "2 mm"}, stats.norm(0.05, 2e-3)),
}


def drawn(name, method, count, seed=0):
    factor = read_factor("tendon.rest_length", {"distribution": name, **DISTRIBUTIONS[name][0]}, FanDesign)
    points = SampledPoints((factor,), method, count, seed)
    return np.array([parse_quantity(point["tendon.rest_length"], LENGTH) for point in points])


@pytest.mark.parametrize("name", DISTRIBUTIONS)
@pytest.mark.parametrize("method", ["random", "sobol"])
def test_drawn_values_follow_their_distribution(name, method):
    values = drawn(name, method, 256)
    # Kolmogorov and Smirnov: 1.95 / sqrt(n) is exceeded once in a thousand cases; Sobol points are much closer
    limit = 1.95 / 16 if method == "random" else 2 / 256
    assert stats.kstest(values, DISTRIBUTIONS[name][1].cdf).statistic < limit


@given(st.floats(1e-6, 1 - 1e-6), st.floats(1e-3, 10), st.floats(1e-3, 10))
def test_quantiles_are_those_of_the_closed_forms(share, low, width):
    shares, high = np.array([share]), low + width
    quantile = {
        name: float(Distribution(name=name, first=low, second=second).quantiles(shares)[0])
        for name, second in (("uniform", high), ("log-uniform", high), ("normal", width))
    }
    assert quantile["uniform"] == pytest.approx(low + share * width, rel=1e-12)
    assert quantile["log-uniform"] == pytest.approx(low * (high / low) ** share, rel=1e-12)
    # cumulative normal distribution: (1 + erf(z / sqrt 2)) / 2, ill conditioned in its tails
    below = 0.5 * math.erfc(-(quantile["normal"] - low) / width / math.sqrt(2))
    assert below == pytest.approx(share, rel=1e-8)


@pytest.mark.parametrize("method", ["random", "sobol"])
def test_the_same_seed_draws_the_same_points_and_another_one_others(method):
    first, again, other = (drawn("uniform", method, 10, seed) for seed in (7, 7, 8))
    assert np.array_equal(first, again)
    assert not np.any(first == other)


def test_every_column_of_sobol_points_has_one_in_each_of_as_many_equal_parts():
    # the property that makes it a (t, s)-sequence, for powers of two; Sobol 1967
    keys = ("tendon.rest_length", "pattern.hub_radius", "vein.diameter")
    drawn = {"distribution": "uniform", "low": "0 m", "high": "1 m"}
    factors = tuple(read_factor(key, drawn, FanDesign) for key in keys)
    points = SampledPoints(factors, "sobol", 64, 3)
    for key in keys:
        parts = sorted(int(64 * parse_quantity(point[key], LENGTH)) for point in points)
        assert parts == list(range(64))


@pytest.mark.parametrize(
    ("distribution", "message"),
    [
        (
            {"distribution": "cauchy", "low": "1 cm", "high": "2 cm"},
            '.distribution: need "uniform", "log-uniform" or "normal"',
        ),
        (
            {"distribution": ["uniform"], "low": "1 cm", "high": "2 cm"},
            '.distribution: need "uniform", "log-uniform" or "normal"',
        ),
        ({"distribution": "uniform", "low": "1 cm"}, ": a uniform distribution needs low and high"),
        ({"distribution": "normal", "low": "1 cm", "high": "2 cm"}, ": a normal distribution needs mean and deviation"),
        ({"distribution": "uniform", "low": "2 cm", "high": "1 cm"}, ".high: need > low, 2 cm, got 1 cm"),
        ({"distribution": "uniform", "low": "2 cm", "high": "3 N"}, '.high: "N" is not a unit of the right kind'),
        ({"distribution": "uniform", "low": 1, "high": 2}, ".low: the unit is missing"),
        ({"distribution": "log-uniform", "low": "0 cm", "high": "1 cm"}, ".low: need > 0"),
        ({"distribution": "normal", "mean": "1 cm", "deviation": "0 cm"}, ".deviation: need > 0"),
    ],
)
def test_an_invalid_distribution_is_rejected_with_its_parameter(distribution, message):
    with pytest.raises(InputError) as caught:
        read_factor("tendon.rest_length", distribution, FanDesign)
    assert str(caught.value).startswith(f"tendon.rest_length{message}")


def test_numbers_that_no_axis_can_have_are_refused():
    for number in (math.nan, math.inf):
        with pytest.raises(InputError, match=r"^guard\.stretch: need finite numbers, got "):
            read_factor("guard.stretch", [1.1, number], FanDesign)
