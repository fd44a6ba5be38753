"""Tendons in the tables of design files, laid over each other: one for all or by vein, with a spring or a law."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, TypeGuard

from pydantic import ValidationError

from forficula.design.fans.fan_sections import MOST_UNITS
from forficula.design.files.tables import (
    REMOVED,
    RejectedError,
    entry_index,
    with_settings_over,
    without_removed,
    written_key,
)
from forficula.design.law import law_tables, tendon_material
from forficula.design.section import field_quantity
from forficula.design.sheets.sheet_drives import SheetTendon
from forficula.design.tendon import ElasticTendon, TendonSection, small_extension
from forficula.errors import InputError
from forficula.material.law.material_law import MaterialLaw
from forficula.names import unknown_key
from forficula.quantities import as_written, format_quantity

# text in place of a law's name that removes the law
NO_LAW = "none"
_LAST_VEIN = 2 * MOST_UNITS


def by_vein(entries: list[Any]) -> dict[str, dict[str, Any]]:
    """Convert a list of tables with the key `vein` to tables, without this key, by the number of the vein as text.

    Raises:
        InputError: an entry that is not a table, that names no vein, or that names the vein of another entry.
    """
    tables: dict[str, dict[str, Any]] = {}
    for number, entry in enumerate(entries):
        if not isinstance(entry, dict):
            raise InputError(f"tendon: need tables, each under [[tendon]], got {as_written(entry)}")
        if "vein" not in entry:
            which = f"entry {number + 1} of {len(entries)}"
            raise InputError(f"tendon.vein: is missing in {which} under [[tendon]]; name its vein, as in vein = 0")
        vein = entry["vein"]
        if isinstance(vein, bool) or not isinstance(vein, int) or not 0 <= vein <= _LAST_VEIN:
            raise InputError(f"tendon.vein: need the number of a vein, from 0 on, got {as_written(vein)}")
        if str(vein) in tables:
            raise InputError(f"tendon.vein: need one [[tendon]] for each vein, got {vein} twice")
        tables[str(vein)] = {key: value for key, value in entry.items() if key != "vein"}
    return dict(sorted(tables.items(), key=lambda item: int(item[0])))


def is_by_vein(tendons: object) -> TypeGuard[dict[str, dict[str, Any]]]:
    """Return whether tables of tendons are by vein, as `by_vein` returns them, instead of one table for all veins."""
    return isinstance(tendons, dict) and all(key.isdecimal() for key in tendons)


def value_from_folder(key: str, value: object, folder: Path) -> object:
    """Return a value of a design file with paths of law files made relative to the folder of the design file.

    Args:
        key: dotted key of the value.
        value: value as in the file, or a list of such values.
        folder: folder of the design file.
    """
    if isinstance(value, list):
        return [value_from_folder(key, entry, folder) for entry in value]
    *sections, last = key.split(".")
    if last == "law" and {"tendon", "crease"}.intersection(sections):
        if isinstance(value, dict) and "based_on" in value:
            return {**value, "based_on": value_from_folder(key, value["based_on"], folder)}
        return str(folder / value) if isinstance(value, str) and value.lower().endswith(".toml") else value
    if isinstance(value, dict):
        return {name: value_from_folder(f"{key}.{name}", inner, folder) for name, inner in value.items()}
    return value


def tendons_over(below: object, upper: object, *, veins: int, si: bool) -> object:
    """Lay the tendons of a fan over those of its base.

    A table changes all tendons, a number in it changes the tendon of one vein, and a list replaces all tendons. "none"
    removes all tendons, or that of one vein.

    Args:
        below: present value of the key `tendon`: a table for all veins, tables by vein, or None.
        upper: value that is laid over it: a table in which a number may select a vein, or a list of tables that name
            their veins. Values that an entry of a list leaves out are those of the table of its vein below.
        veins: number of veins of the fan.
        si: whether numbers are SI floats instead of text.

    Returns:
        A table for all veins, or tables by vein.

    Raises:
        RejectedError: a vein that does not exist or has no tendon, or a list that `by_vein` refuses.
    """
    if isinstance(upper, list):
        try:
            tables = by_vein(upper)
        except InputError as error:
            raise RejectedError(["tendon"], str(error)) from None
        before = below if is_by_vein(below) else dict.fromkeys(tables, below)
        return {vein: tendon_over(before.get(vein), entry, vein, si=si) for vein, entry in tables.items()}
    if not isinstance(upper, dict):
        return {} if upper == REMOVED else upper
    shared = {key: value for key, value in upper.items() if not key.isdecimal()}
    numbered = {key: value for key, value in upper.items() if key.isdecimal()}
    if is_by_vein(below):
        tendons = {vein: tendon_over(entry, shared, vein, si=si) for vein, entry in below.items()}
    else:
        table = tendon_over(below, shared, "", si=si)
        if not numbered:
            return table or None
        tendons = {str(vein): table for vein in range(veins)}
    for vein, value in numbered.items():
        if vein not in tendons:
            raise RejectedError(["tendon", vein], _no_tendon(vein, tendons, veins))
        if value == REMOVED:
            del tendons[vein]
            continue
        if not isinstance(value, dict):
            message = f'tendon.{vein}: need a table under [tendon.{vein}], or "none", got {as_written(value)}'
            raise RejectedError(["tendon", vein], message)
        tendons[vein] = tendon_over(tendons[vein], value, vein, si=si)
    return tendons


def entries_over(below: object, upper: object, *, si: bool) -> object:
    """Lay the tendons of a sheet over those of its base: a list replaces them, a number or a name changes one of them.

    "none" removes all tendons, or the one that a number or a name selects.

    Args:
        below: present value of the key `tendon`: a list of tables, or None.
        upper: value that is laid over it.
        si: whether numbers are SI floats instead of text.

    Raises:
        RejectedError: there is no such tendon, or its values cannot be laid over it.
    """
    if isinstance(upper, list):
        return [
            tendon_over({}, entry, f"{number}", si=si, model=SheetTendon) if isinstance(entry, dict) else entry
            for number, entry in enumerate(upper)
        ]
    if upper == REMOVED:
        return []
    if not isinstance(upper, dict) or not isinstance(below, list):
        return with_settings_over(below, upper, ("tendon",))
    entries = list(below)
    for text, value in upper.items():
        try:
            number = entry_index(("tendon",), text, below, list(value)[:1] if isinstance(value, dict) else ())
        except InputError as error:
            raise RejectedError(("tendon", text), str(error)) from None
        entries[number] = (
            tendon_over(entries[number], value, f"{number}", si=si, model=SheetTendon)
            if isinstance(value, dict)
            else value
        )
    return without_removed(below, entries)


def tendon_over(
    below: object, upper: Mapping[str, Any], vein: str, *, si: bool, model: type[ElasticTendon] = TendonSection
) -> dict[str, Any]:
    """Lay the values of a tendon over those of its base; a stiffness replaces a law, and a law replaces a stiffness.

    Args:
        below: present table; any other value counts as an empty table.
        upper: values that are laid over it. The law "none" replaces a law by its stiffness at small extension.
        vein: number of the vein or of the entry; empty for a table for all veins.
        si: whether numbers are SI floats instead of text.
        model: class of the tendon's section.

    Raises:
        RejectedError: a law that cannot be read, the key `vein`, or a key that continues where there is a value.
    """
    place = ("tendon", vein) if vein else ("tendon",)
    table = dict(below) if isinstance(below, dict) else {}
    upper = dict(upper)
    if "vein" in upper and model is TendonSection:
        rule = "the key vein is for a table under [[tendon]], a tendon of one vein"
        raise RejectedError((*place, "vein"), unknown_key(written_key((*place, "vein")), upper["vein"], rule))
    if upper.get("law") == NO_LAW:
        table = _without_law(table, si=si, model=model)
        del upper["law"]
    elif "law" in upper:
        upper["law"] = _law_over(table.get("law"), upper["law"], (*place, "law"), si=si)
        table = _without_keys(table, "law", "stiffness", "damping")
    elif "law" in table and "stiffness" in upper:
        table = _without_law(table, si=si, model=model)
    elif "law" in table and {"area", "rest_length"} & upper.keys():
        # stiffness and damping of a file that has both follow from the new values
        table = _without_keys(table, "stiffness", "damping")
    law = {"law": upper.pop("law")} if "law" in upper else {}
    return {**with_settings_over(table, upper, place), **law}


def _law_over(below: object, upper: object, place: tuple[str, ...], *, si: bool) -> object:
    """Lay a law, by name or by its values, over another one; read a named law if a nested table changes it."""
    if isinstance(upper, dict) and isinstance(upper.get("based_on"), str | MaterialLaw):
        below, upper = upper["based_on"], _without_keys(upper, "based_on")
    if not isinstance(upper, dict):
        return upper
    table = {"based_on": below} if isinstance(below, str | MaterialLaw) else below
    if not isinstance(table, dict):
        return upper
    named = table.get("based_on")
    if isinstance(named, str | MaterialLaw) and any(isinstance(value, dict) for value in upper.values()):
        try:
            table = law_tables(tendon_material(named), si=si) | table
        except InputError as error:
            raise RejectedError(place, f"{written_key(place)}: {error}") from None
    return with_settings_over(table, upper, place)


def _without_law(table: dict[str, Any], *, si: bool, model: type[ElasticTendon]) -> dict[str, Any]:
    """Return a tendon's table with stiffness and damping at small extension instead of its law, if the law is valid."""
    rest = _without_keys(table, "law", "area")
    if "law" not in table:
        return rest
    try:
        tendon = model.model_validate(table, context={"si": si})
    except ValidationError:  # validation of the remaining table reports the error
        return rest
    for key, value in small_extension(tendon).items():
        reader = field_quantity(model.model_fields[key])
        rest[key] = value if si or reader is None else format_quantity(value, reader.unit)
    if tendon.weighs:
        # the mass depends on the volume
        rest["area"] = table["area"]
    return rest


def _no_tendon(number: str, present: Iterable[str], veins: int) -> str:
    """Return the message for a number that selects no tendon."""
    shown = ", ".join(present) or "none"
    if number in (str(vein) for vein in range(veins)):
        return f"tendon.{number}: vein {number} has no tendon, those with one are {shown}; give it a [[tendon]] first"
    return f"tendon.{number}: need the number of a vein with a tendon, {shown}, got {as_written(number)}"


def _without_keys(table: Mapping[str, Any], *keys: str) -> dict[str, Any]:
    return {key: value for key, value in table.items() if key not in keys}
