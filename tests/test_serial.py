"""JSON and its schema follow from the annotated fields of data classes."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from typing import Annotated

import jsonschema
import numpy as np
import pytest

from forficula.arrays import Array
from forficula.quantities import Unit
from forficula.serial import (
    Joules,
    Key,
    Radians,
    Seconds,
    WithUnit,
    Written,
    json_text,
    key_with_unit,
    plain,
    schema_of,
    unit_suffix,
)


class Colour(StrEnum):
    RED = "red"


@dataclass(frozen=True, kw_only=True)
class Name:
    """Name of a part.

    Attributes:
        part: its name.
    """

    part: str


@dataclass(frozen=True, kw_only=True)
class Swing:
    """One swing.

    Attributes:
        angle: at its end, rad.
        lengths: of the arms,
            one after another, m.
        note: what to know.
    """

    name: Annotated[Name, Written.BESIDE]
    angle: Radians
    time: Seconds | None
    lengths: Annotated[Array, Unit("m")]
    colour: Colour
    energy: Annotated[Joules | None, Key("stored"), Written.IF_KNOWN] = None
    note: Annotated[str, Written.OR_NULL] = ""
    mesh: Annotated[object, Written.NEVER] = None
    others: Annotated[Mapping[str, WithUnit], Written.BESIDE]

    @property
    def half(self) -> Annotated[float, Unit("rad"), Written.FIRST]:
        """Half the angle."""
        return self.angle / 2

    @property
    def twice(self) -> float:
        return 2 * self.angle


def swing(**values):
    default = {"name": Name(part="arm"), "angle": math.pi, "time": None, "lengths": np.array([1.0, math.nan])}
    return Swing(**default | {"colour": Colour.RED, "others": {}} | values)


def test_keys_have_the_unit_of_their_field_and_angles_are_in_degrees():
    assert plain(swing()) == {
        "half_deg": 90.0,
        "part": "arm",
        "angle_deg": 180.0,
        "time_s": None,
        "lengths_m": [1.0, None],
        "colour": "red",
        "note": None,
    }


def test_a_whole_number_of_radians_is_an_angle_too():
    assert plain(swing(angle=1))["angle_deg"] == math.degrees(1.0)


def test_a_value_that_exists_only_sometimes_has_its_key_only_then():
    assert "stored_J" not in plain(swing())
    assert plain(swing(energy=2.0, note="slow"))["stored_J"] == 2.0


def test_extra_values_have_separate_units_and_fields_take_precedence():
    others = {"torque": WithUnit(1.5, "N m"), "rest": WithUnit([0.0, math.pi], "rad"), "colour": WithUnit(1.0, "")}
    content = plain(swing(others=others))
    assert (content["torque_N_m"], content["rest_deg"], content["colour"]) == (1.5, [0.0, 180.0], "red")


@pytest.mark.parametrize(
    ("unit", "suffix"),
    [
        ("N m", "_N_m"),
        ("kg/m^3", "_kg_per_m3"),
        ("kg m^2", "_kg_m2"),
        ("1/s", "_per_s"),
        ("rad/s", "_rad_per_s"),
        ("m/s^2", "_m_per_s2"),
        ("", ""),
    ],
)
def test_a_suffix_spells_its_unit(unit, suffix):
    assert unit_suffix(unit) == suffix
    assert key_with_unit("value", unit) == f"value{suffix}"


def test_numbers_that_do_not_exist_are_null():
    assert plain({"a": math.nan, "b": (math.inf, np.float64(1.0), np.int64(2), np.bool_(True))}) == {
        "a": None,
        "b": [None, 1.0, 2, True],
    }


@pytest.mark.parametrize("value", [swing(), swing(energy=1.0, time=0.5, others={"torque": WithUnit(1.0, "N m")})])
def test_a_schema_accepts_written_results(value):
    schema = schema_of(Swing, "swing")
    jsonschema.Draft202012Validator.check_schema(schema)
    jsonschema.Draft202012Validator(schema).validate(json.loads(json_text(value)))


@pytest.mark.parametrize(
    "wrong",
    [
        lambda content: content.pop("angle_deg"),
        lambda content: content.pop("part"),
        lambda content: content.update(angle_deg="wide"),
        lambda content: content.update(colour="green"),
        lambda content: content.update(another="text"),
    ],
)
def test_a_schema_refuses_other_data(wrong):
    content = json.loads(json_text(swing()))
    wrong(content)
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.Draft202012Validator(schema_of(Swing, "swing")).validate(content)


def test_a_schema_describes_the_keys():
    schema = schema_of(Swing, "swing")
    assert schema["$id"] == "forficula-swing"
    assert schema["description"] == "One swing."
    meanings = {key: item.get("description") for key, item in schema["properties"].items()}
    assert meanings["lengths_m"] == "of the arms, one after another, m."
    assert meanings["half_deg"] == "Half the angle."
    assert meanings["part"] == "its name."
    assert "stored_J" not in schema["required"]
