"""The law of a tendon in the tables of a design: read from where it is named, and what follows from it."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from pydantic import ValidationError

from forficula.design.fan import Tendon
from forficula.design.law import Law, law_fields
from forficula.design.part import as_tables, field_quantity
from forficula.design.tables import RejectedError, WholeTable, overlaid
from forficula.errors import InputError
from forficula.material.law.law_file import load_law
from forficula.material.law.law_keys import show_range
from forficula.material.law.material_law import MaterialLaw, chosen, require, scaled
from forficula.quantities import format_quantity, show_quantity

# by key of the tendon, what to set instead
_FOLLOWING = {
    "stiffness": "tendon.area or tendon.law.linear_modulus",
    "damping": "tendon.area or tendon.law.linear_viscosity",
}
# what is given by hand is what follows, but for how it was written
_ROUNDING = 1e-9
# in place of a law's name: no law
_NONE = "none"


class _NamedLaw(WholeTable):
    """The law of a material, which may still need a choice."""

    material: MaterialLaw


def with_law_read(key: str, value: object, *, folder: Path | None = None, si: bool = False) -> object:
    """Replace the name of a law by the law.

    Args:
        key: of the value: "tendon", "tendon.law", or another, whose value stays.
        value: of the key; a law is named by the name of a material, the path of a law file, or a table with either
            under `based_on`; "none" stays, see `law_taken_off`.
        folder: that paths start from; the working folder if not given.
        si: whether the law is wanted as SI floats instead of text.

    Raises:
        InputError: the law cannot be read, or is for no tendon.
    """
    if key == "tendon" and isinstance(value, dict) and "law" in value:
        return {**value, "law": with_law_read("tendon.law", value["law"], folder=folder, si=si)}
    if key != "tendon.law" or value == _NONE:
        return value
    try:
        if isinstance(value, dict) and isinstance(value.get("based_on"), str):
            own = {name: each for name, each in value.items() if name != "based_on"}
            return overlaid(_named_law(value["based_on"], folder, si), own)
        if isinstance(value, str | MaterialLaw):
            return _named_law(value, folder, si)
    except InputError as error:
        raise InputError(f"tendon.law: {error}") from None
    return value


def law_taken_off(
    tables: dict[str, Any], over: Mapping[str, Any], *, si: bool = False
) -> tuple[dict[str, Any], dict[str, Any]]:
    """Take the law off a tendon where "none" is to be laid over it; what is left is its spring at small extension.

    Args:
        tables: of a design, not checked yet.
        over: what is to be laid over them, nested or by dotted key.
        si: whether numbers are SI floats instead of text.

    Returns:
        The tables without law and area, and `over` without the word; both as they are where it is not there.

    Raises:
        RejectedError: as `with_following`.
    """
    tendon = over.get("tendon")
    inside = isinstance(tendon, dict) and tendon.get("law") == _NONE
    if over.get("tendon.law") != _NONE and not inside:
        return tables, dict(over)
    rest = {key: value for key, value in over.items() if key != "tendon.law"}
    if inside:
        rest["tendon"] = {key: value for key, value in over["tendon"].items() if key != "law"}
    linear = with_following(tables, si=si).get("tendon", {})
    return tables | {"tendon": {key: linear[key] for key in linear if key not in ("law", "area")}}, rest


def law_from_folder(key: str, value: object, folder: Path) -> object:
    """A value of a study with the path of a law file, where it holds one, starting from a folder.

    Args:
        key: dotted.
        value: of the key, or a list of values.
        folder: of the file that the value stands in.
    """
    if key != "tendon.law":
        return value
    if isinstance(value, list):
        return [law_from_folder(key, each, folder) for each in value]
    if isinstance(value, dict) and isinstance(value.get("based_on"), str):
        return {**value, "based_on": _from_folder(value["based_on"], folder)}
    return _from_folder(value, folder) if isinstance(value, str) else value


def names_law(value: object) -> bool:
    """Whether a value is a law that was named, or a tendon with one."""
    return isinstance(value, _NamedLaw) or (isinstance(value, dict) and isinstance(value.get("law"), _NamedLaw))


def without_following(tables: dict[str, Any], over: Mapping[str, Any]) -> dict[str, Any]:
    """Leave out a tendon's stiffness and damping where `over` changes what they follow from: a law and its sizes."""
    tendon, own = tables.get("tendon"), over.get("tendon")
    if not isinstance(tendon, dict) or not isinstance(own, dict):
        return tables
    if "law" not in own and ("law" not in tendon or not {"area", "rest_length"} & own.keys()):
        return tables
    return tables | {"tendon": {key: value for key, value in tendon.items() if key not in _FOLLOWING}}


def with_following(tables: dict[str, Any], *, si: bool) -> dict[str, Any]:
    """Give a tendon with a law the stiffness and the damping that follow from it: E1 A / L and eta1 A / L.

    Args:
        tables: of a design, not checked yet.
        si: whether numbers are SI floats instead of text.

    Raises:
        RejectedError: a law that needs a choice, or other values of stiffness or damping.
    """
    tendon = tables.get("tendon")
    if not isinstance(tendon, dict) or "law" not in tendon:
        return tables
    if isinstance(tendon["law"], _NamedLaw):
        _check_choice(tendon["law"], si)
    values = dict(tendon)
    for key, follows in _following(tendon, si).items():
        quantity = field_quantity(Tendon.model_fields[key])
        assert quantity is not None
        try:
            given = quantity.read(tendon[key], in_si=si) if key in tendon else follows
        except InputError:  # whoever checks the tables says what is wrong with it
            continue
        if isinstance(given, float) and not math.isclose(given, follows, rel_tol=_ROUNDING):
            raise RejectedError(
                ["tendon", key],
                f"tendon.{key}: follows from tendon.law, {show_quantity(follows, quantity.unit)}; set"
                f" {_FOLLOWING[key]} instead, got {show_quantity(given, quantity.unit)}",
            )
        values[key] = follows if si else format_quantity(follows, quantity.unit)
    return tables | {"tendon": values}


def _named_law(named: str | MaterialLaw, folder: Path | None, si: bool) -> _NamedLaw:
    material = named if isinstance(named, MaterialLaw) else load_law(_from_folder(named, folder))
    if material.no_tendon:
        raise InputError(f"{material.name}: no tendon can be made of it: {material.no_tendon}")
    values = law_fields(material)
    if material.moduli is None and not any(bounds.key == "modulus.linear" for bounds in material.ranges):
        require(material, "modulus")
    if not si:
        # a law that needs a choice has no modulus yet
        text = as_tables(Law.model_validate({"linear_modulus": 1.0} | values, context={"si": True}))
        values = {name: value for name, value in text.items() if name in values}
    law = _NamedLaw(values)
    law.material = material
    return law


def _from_folder(name: str, folder: Path | None) -> str:
    return str(folder / name) if folder is not None and name.lower().endswith(".toml") else name


def _check_choice(law: _NamedLaw, si: bool) -> None:
    """Refuse a law without a modulus, and one that was chosen out of its range."""
    key, material = "linear_modulus", law.material
    if material.moduli is not None:
        return
    place = ["tendon", "law", key]
    if key not in law:
        bounds = next(bounds for bounds in material.ranges if bounds.key == "modulus.linear")
        raise RejectedError(
            place,
            f"tendon.law.{key}: of {material.name} only a range is known, "
            f"{show_range(bounds.key, bounds.low, bounds.high)}; choose a value in it, as in"
            f' tendon.law = {{based_on = "{material.name}", {key} = "1 MPa"}} or --set tendon.law.{key}="1 MPa"',
        )
    quantity = field_quantity(Law.model_fields[key])
    try:
        value = quantity.read(law[key], in_si=si) if quantity else None
    except InputError:  # whoever checks the tables says what is wrong with it
        return
    try:
        chosen(material, float(value or 0.0))
    except InputError as error:
        raise RejectedError(place, f"tendon.law.{key}: {error}") from None


def _following(tendon: Mapping[str, Any], si: bool) -> dict[str, float]:
    """Stiffness and damping that follow from a tendon's law, SI; 0 where the law or the tendon is not right yet."""
    try:
        law = Law.model_validate(tendon["law"], context={"si": si}).material
        sizes = {}
        for size, key in (("length", "rest_length"), ("area", "area")):
            quantity = field_quantity(Tendon.model_fields[key])
            sizes[size] = float(quantity.read(tendon[key], in_si=si)) if quantity else 0.0
        found = scaled(law, **sizes)
    except (ValidationError, InputError, KeyError):  # whoever checks the tables says what is wrong with them
        return dict.fromkeys(_FOLLOWING, 0.0)
    return {"stiffness": found.stiffness[0], "damping": 0.0 if found.damping is None else found.damping[0]}
