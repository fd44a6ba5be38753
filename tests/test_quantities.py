import math
import subprocess
import sys
import time

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from pint import UnitRegistry

from forficula.design import design as units_of_a_design
from forficula.errors import InputError
from forficula.quantities import (
    _USUAL,
    Unit,
    as_written,
    dimension,
    format_quantity,
    parse_quantity,
    reading_unit,
    show_quantity,
    show_value,
)

UNITS = [value for value in vars(units_of_a_design).values() if isinstance(value, Unit)]
LENGTH = Unit(display="cm", si="m", example="12 cm")
STIFFNESS = Unit(display="N/cm", si="N/m", example="10 N/cm")
TORQUE = Unit(display="N cm", si="N m", example="50 N cm")
ANGLE = Unit(display="deg", si="rad", example="15 deg")
ANGULAR_SPEED = Unit(display="deg/s", si="rad/s", example="1 deg/s")
DENSITY = Unit(display="g/cm^3", si="kg/m^3", example="1.27 g/cm^3")
finite = st.floats(allow_nan=False, allow_infinity=False)


def refusal(text, unit):
    with pytest.raises(InputError) as caught:
        parse_quantity(text, unit)
    message = str(caught.value)
    assert len(message.splitlines()) == 1
    assert len(message) < 250
    return message


# factors by definition of the units
@pytest.mark.parametrize(
    ("text", "unit", "value"),
    [
        ("10 N/cm", STIFFNESS, 1000.0),
        ("1 kN/m", STIFFNESS, 1000.0),
        ("10N/cm", STIFFNESS, 1000.0),
        ("  10   N / cm ", STIFFNESS, 1000.0),
        ("1.27 g/cm^3", DENSITY, 1270.0),
        ("1.27 g/cm**3", DENSITY, 1270.0),
        ("1.27 g/cm³", DENSITY, 1270.0),
        ("12 cm", LENGTH, 0.12),
        ("5 mm", LENGTH, 0.005),
        ("1 in", LENGTH, 0.0254),
        ("3 µm", LENGTH, 3e-6),
        ("-.5e1 m", LENGTH, -5.0),
        ("180 deg", ANGLE, math.pi),
        ("180°", ANGLE, math.pi),
        ("0.5 turn", ANGLE, math.pi),
        ("1 rad", ANGLE, 1.0),
        ("1 N/mm^2", Unit(display="MPa", si="Pa", example="1 MPa"), 1e6),
    ],
)
def test_text_with_a_unit_is_read_as_si(text, unit, value):
    # one rounding each of the number, the factor and their product
    assert parse_quantity(text, unit) == pytest.approx(value, rel=4e-16)


@pytest.mark.parametrize(
    "text", ["50 N cm", "50 Ncm", "50 N*cm", "50 N·cm", "0.5 N m", "0.5 Nm", "500 Nmm", "500 mN m"]
)
def test_torque_is_read_however_the_field_writes_it(text):
    assert parse_quantity(text, TORQUE) == pytest.approx(0.5, rel=4e-16)  # as above


def test_decimal_factors_are_exact():
    assert parse_quantity("1.27 g/cm^3", DENSITY) == 1270.0
    assert parse_quantity("12 cm", LENGTH) == 0.12


@pytest.mark.parametrize(("si", "name"), [(si, name) for si, names in _USUAL.items() for name in (si, *names) if name])
def test_usual_units_have_the_factors_that_pint_has_for_them(si, name):
    unit = Unit(display=name, si=si, example=f"1 {name}")
    # which are not looked up; pint does not know "times"
    spelled = {"%": "percent", "times": "times"}.get(name, f"({name})")
    assert parse_quantity(f"1 {name}", unit) == parse_quantity(f"1 {spelled}", unit)


def test_a_design_is_read_without_what_is_slow_to_load():
    code = "import sys, forficula; forficula.load_design('letter-fold'); print(*sys.modules)"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert "forficula.design" in loaded
    assert not {"matplotlib", "mujoco", "pint", "scipy.optimize", "scipy.stats", "xarray"} & set(loaded)


@settings(deadline=None)
@given(finite, st.sampled_from(UNITS))
def test_any_finite_number_comes_back_from_its_text_with_the_same_bits(value, unit):
    back = parse_quantity(format_quantity(value, unit), unit)
    assert back == value
    assert math.copysign(1, back) == math.copysign(1, value)


@settings(deadline=None)
@given(st.integers(1, 9999), st.integers(-6, 6), st.sampled_from(UNITS))
def test_a_short_number_in_the_usual_unit_is_written_as_it_was_typed(digits, power, unit):
    number = float(f"{digits}e{power}")
    written = format_quantity(parse_quantity(f"{number!r} {unit.display}", unit), unit)
    assert float(written.split()[0]) == number
    assert written.endswith(f" {unit.display}")


@pytest.mark.parametrize(("value", "unit", "text"), [(1000.0, STIFFNESS, "10 N/cm"), (0.0, LENGTH, "0 cm")])
def test_a_whole_number_is_written_without_a_point(value, unit, text):
    assert format_quantity(value, unit) == text


@pytest.mark.parametrize(
    ("value", "unit", "text"),
    [
        (8e-7, Unit(display="ms", si="s", example="0.2 ms"), "8e-07 s"),
        (8e-5, Unit(display="ms", si="s", example="0.2 ms"), "0.08 ms"),
        (0.12345678901234567, LENGTH, "12.345678901234566 cm"),  # the same length in m
        (0.123456789012, LENGTH, "12.3456789012 cm"),
    ],
)
def test_si_is_written_only_where_the_usual_unit_takes_many_digits_and_a_longer_text(value, unit, text):
    assert format_quantity(value, unit) == text
    assert parse_quantity(text, unit) == value


@pytest.mark.parametrize(("text", "value"), [("1 rpm", math.pi / 30), ("1 turn/s", 2 * math.pi), ("1 rad/s", 1.0)])
def test_an_angular_speed_is_read_in_any_angle_by_any_time(text, value):
    # three roundings: the number, pint's factor and their product
    assert parse_quantity(text, ANGULAR_SPEED) == pytest.approx(value, rel=1e-15)


@pytest.mark.parametrize("unit", ["Hz", "1/s", "deg^-1/s", "deg^2/s", "percent/s"])
def test_an_angular_speed_without_an_angle_is_refused(unit):
    message = f'"{unit}" is not a unit of the right kind; write it such as "1 deg/s", got "1 {unit}"'
    assert refusal(f"1 {unit}", ANGULAR_SPEED) == message


def test_a_unit_can_omit_per_angle():
    unit = Unit(display="N m s/rad", si="N m s/rad", example="1e-3 N m s/rad")
    assert parse_quantity("2 N m s", unit) == parse_quantity("2 N m s/rad", unit) == 2.0


@pytest.mark.parametrize(
    ("unit", "largest", "name", "factor"),
    [
        ("J", 14.0, "J", 1.0),
        ("J", 2e-3, "mJ", 1e3),
        ("J", 5e-5, "µJ", 1e6),
        ("J", 1e-30, "nJ", 1e9),
        ("J", 0.0, "J", 1.0),
        ("N m", 0.5, "N cm", 1e2),
        ("N m", 5e-5, "mN cm", 1e5),
        ("m", 22.0, "m", 1.0),
        ("m", 0.22, "cm", 1e2),
        ("m", 0.01, "mm", 1e3),
        ("m", 1e-6, "µm", 1e6),
        ("s", 2.7, "s", 1.0),
        ("s", 0.13, "ms", 1e3),
        ("s", 1e-5, "µs", 1e6),
    ],
)
def test_values_read_well_in_a_unit_near_the_largest(unit, largest, name, factor):
    assert reading_unit(unit, largest) == (name, factor)


@given(st.sampled_from(["J", "N m", "m", "s"]), st.floats(0, 1e3))
def test_the_name_and_the_factor_of_a_reading_unit_match(unit, largest):
    name, factor = reading_unit(unit, largest)
    assert parse_quantity(f"1 {name}", Unit(display=unit, si=unit, example="")) == pytest.approx(1 / factor, rel=1e-12)


def test_a_quantity_is_shown_to_people_with_four_digits():
    assert show_quantity(1 / 3, LENGTH) == "33.33 cm"


@pytest.mark.parametrize("si", [si for si in _USUAL if si])
def test_a_unit_has_the_exponents_of_length_mass_and_time_that_pint_has_for_it(si):
    powers = UnitRegistry().parse_units(si).dimensionality
    assert dimension(Unit(si=si)) == tuple(powers.get(name, 0) for name in ("[length]", "[mass]", "[time]"))


def test_a_run_needs_no_library_of_units():
    code = "import sys, forficula as ff; ff.run('letter-fold', confirm=False); print(*sys.modules)"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert "mujoco" in loaded
    assert "pint" not in loaded


@pytest.mark.parametrize("unit", UNITS)
def test_the_display_the_si_unit_and_the_example_of_every_unit_are_of_its_kind(unit):
    assert parse_quantity(f"1 {unit.si}", unit) == 1.0
    assert parse_quantity(f"1 {unit.display}", unit) > 0
    assert parse_quantity(unit.example, unit) > 0


@pytest.mark.parametrize(
    ("text", "unit", "message"),
    [
        ("10 N", STIFFNESS, '"N" is not a unit of the right kind; write it such as "10 N/cm", got "10 N"'),
        ("3 %", ANGLE, '"%" is not a unit of the right kind; write it such as "15 deg", got "3 %"'),
        ("3 m", ANGLE, '"m" is not a unit of the right kind; write it such as "15 deg", got "3 m"'),
        ("3 deg", LENGTH, '"deg" is not a unit of the right kind; write it such as "12 cm", got "3 deg"'),
        ("20 degC", LENGTH, '"degC" is not a unit of the right kind; write it such as "12 cm", got "20 degC"'),
        ("10", STIFFNESS, 'the unit is missing; write it such as "10 N/cm", got "10"'),
        (10, STIFFNESS, 'the unit is missing; write it as text such as "10 N/cm", got 10'),
        (0.5, LENGTH, 'the unit is missing; write it as text such as "12 cm", got 0.5'),
        ("3 parsnips", LENGTH, '"parsnips" is not a unit; write it such as "12 cm", got "3 parsnips"'),
        ("soft", STIFFNESS, 'need a number and a unit such as "10 N/cm", got "soft"'),
        ("", LENGTH, 'need a number and a unit such as "12 cm", got ""'),
        ("cm", LENGTH, 'need a number and a unit such as "12 cm", got "cm"'),
        ("1,27 g/cm^3", DENSITY, 'write decimals with a point such as "1.27 g/cm^3", got "1,27 g/cm^3"'),
        ("nan cm", LENGTH, 'need a finite number with a unit such as "12 cm", got "nan cm"'),
        ("-inf cm", LENGTH, 'need a finite number with a unit such as "12 cm", got "-inf cm"'),
        ("1e400 cm", LENGTH, 'need a finite number with a unit such as "12 cm", got "1e400 cm"'),
        ("1e308 km", LENGTH, 'need a finite number with a unit such as "12 cm", got "1e308 km"'),
        (math.inf, LENGTH, 'need a finite number with a unit such as "12 cm", got inf'),
        (True, LENGTH, 'need text with a unit such as "12 cm", got true'),
        (None, LENGTH, 'need text with a unit such as "12 cm", got None'),
        (["9 cm"], LENGTH, 'need text with a unit such as "12 cm", got ["9 cm"]'),
        ({"a": 1}, LENGTH, 'need text with a unit such as "12 cm", got {a = 1}'),
    ],
)
def test_an_invalid_quantity_is_refused_with_the_value_and_an_example(text, unit, message):
    assert refusal(text, unit) == message


HOSTILE = [
    "10 N/cm**9**9**9",
    "10 cm^9^9^9^9",
    "10 cm^999999999",
    "10 N/cm⁹⁹⁹⁹⁹⁹⁹⁹⁹",
    "10 " + "m^9" * 20,
    "10 " + "(" * 50,
    "10 " + "(m" * 20,
    "10 m()",
    "10 m//m",
    "10 degCHz\nµm()deg",
    "10 __import__",
    "10 m if m else m",
    "10 m\0",
    "10 " + "N" * 100_000,
    "10 " + "m*" * 50_000,
    "9" * 100_000 + " N/cm",
    " " * 100_000,
    10**5000,
]


@pytest.mark.parametrize("text", HOSTILE, ids=range(len(HOSTILE)))
def test_hostile_text_is_refused_at_once(text):
    parse_quantity("1 m", LENGTH)  # the registry is made at first use
    start = time.process_time()
    refusal(text, STIFFNESS)
    assert time.process_time() - start < 1  # s; a tower of powers would take for ever, this takes milliseconds


@settings(deadline=None)
@given(st.text(alphabet="mNcg9-^*/()²· \n°%degrad", max_size=30))
def test_any_text_is_read_or_refused_in_one_line(text):
    value, message = 0.0, ""
    try:
        value = parse_quantity(f"1{text}", STIFFNESS)
    except InputError as error:
        message = str(error)
    assert math.isfinite(value)
    assert len(message.splitlines()) <= 1


@settings(deadline=None)
@given(st.recursive(st.none() | st.booleans() | st.integers() | finite | st.text(), st.lists, max_leaves=5))
def test_a_value_is_shown_in_one_short_line(value):
    shown = as_written(value)
    assert len(shown) <= 60
    assert len(shown.splitlines()) == 1


@pytest.mark.parametrize(
    ("value", "shown"),
    [
        (True, "true"),
        ("a", '"a"'),
        ([1, "a"], '[1, "a"]'),
        ({"a": False}, "{a = false}"),
        (1.5, "1.5"),
        ("\n", '"\\n"'),
    ],
)
def test_a_value_is_shown_as_a_design_file_has_it(value, shown):
    assert as_written(value) == shown


def test_a_value_nested_thousands_deep_is_written_on_one_short_line():
    nested, tables = [1], {"b": 1}
    for _ in range(5000):
        nested, tables = [nested], {"a": tables}
    assert as_written(nested).startswith("[[[[[[[[[[")
    assert as_written(tables).startswith("{a = {a = {a = ")
    assert len(as_written(nested)) == len(as_written(tables)) == 60


def test_half_a_character_is_written_by_its_number():
    assert as_written("a\ud800b") == r'"a\ud800b"'


def test_values_that_are_only_rounding_are_written_as_zero_in_the_si_unit():
    assert show_value(3e-67, "J") == "0 J"
    assert show_value(1e-3, "J", largest=2e-3) == "1 mJ"
    assert show_value(1e-16, "J", largest=2e-3) == "0 J"
    assert show_value(0.0, "Pa") == "0 Pa"
    assert show_value(1e-30, "1/s") == "1e-30 1/s"
