"""Tendons in the tables of design files: one for all or by vein, a spring or a law, laid over each other."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import Any, TypeGuard

from pydantic import ValidationError

from forficula.design.fans.fan_sections import MOST_UNITS
from forficula.design.files.tables import RejectedError, entry_index, laid_over, written_key
from forficula.design.law import law_tables, tendon_material
from forficula.design.section import field_quantity
from forficula.design.sheets.sheet_course import SheetTendon
from forficula.design.tendon import ElasticTendon, TendonSection, small_extension
from forficula.errors import InputError
from forficula.material.law.material_law import MaterialLaw
from forficula.names import unknown_key
from forficula.quantities import as_written, format_quantity

# in place of a law's name: no law
NO_LAW = "none"
_LAST_VEIN = 2 * MOST_UNITS


def by_vein(entries: list[Any]) -> dict[str, dict[str, Any]]:
    """The tables of a list of tendons by the number of their vein, as text, which they no longer name.

    Raises:
        InputError: an entry that is no table, or names no vein, or one that another one names.
    """
    found: dict[str, dict[str, Any]] = {}
    for number, entry in enumerate(entries):
        if not isinstance(entry, dict):
            raise InputError(f"tendon: need tables, each under [[tendon]], got {as_written(entry)}")
        if "vein" not in entry:
            which = f"entry {number + 1} of {len(entries)}"
            raise InputError(f"tendon.vein: is missing in {which} under [[tendon]]; name its vein, as in vein = 0")
        vein = entry["vein"]
        if isinstance(vein, bool) or not isinstance(vein, int) or not 0 <= vein <= _LAST_VEIN:
            raise InputError(f"tendon.vein: need the number of a vein, from 0 on, got {as_written(vein)}")
        if str(vein) in found:
            raise InputError(f"tendon.vein: need one [[tendon]] for each vein, got {vein} twice")
        found[str(vein)] = {key: value for key, value in entry.items() if key != "vein"}
    return dict(sorted(found.items(), key=lambda item: int(item[0])))


def is_by_vein(tendons: object) -> TypeGuard[dict[str, dict[str, Any]]]:
    """Whether tables of tendons are those of `by_vein`, each of one vein, and not one table for all veins."""
    return isinstance(tendons, dict) and all(key.isdecimal() for key in tendons)


def value_from_folder(key: str, value: object, folder: Path) -> object:
    """A value of a design with the paths of law files that it holds starting from a folder.

    Args:
        key: of the value, dotted.
        value: as a file has it, or a list of such values.
        folder: of the file that it stands in.
    """
    if not f"{key}.".startswith("tendon."):
        return value
    if isinstance(value, list):
        return [value_from_folder(key, each, folder) for each in value]
    if key.endswith(".law"):
        if isinstance(value, dict) and "based_on" in value:
            return {**value, "based_on": value_from_folder(key, value["based_on"], folder)}
        return str(folder / value) if isinstance(value, str) and value.lower().endswith(".toml") else value
    if isinstance(value, dict):
        return {name: value_from_folder(f"{key}.{name}", each, folder) for name, each in value.items()}
    return value


def tendons_over(below: object, own: object, *, veins: int, si: bool) -> object:
    """Lay tendons over those below: a table over all of them, a list in place of them, a number over that of a vein.

    Args:
        below: the value of the key `tendon` so far: a table for all veins, tables by vein, or None.
        own: what is laid over it: a table in which a number may pick a vein, or a list of tables that name their
            veins. Entries of a list take what they leave out from the table of their vein.
        veins: of the fan.
        si: whether numbers are SI floats instead of text.

    Returns:
        A table for all veins, or tables by vein.

    Raises:
        RejectedError: a vein that is not there or has no tendon, or what `by_vein` refuses.
    """
    if isinstance(own, list):
        try:
            given = by_vein(own)
        except InputError as error:
            raise RejectedError(["tendon"], str(error)) from None
        before = below if is_by_vein(below) else dict.fromkeys(given, below)
        return {vein: tendon_over(before.get(vein), entry, vein, si=si) for vein, entry in given.items()}
    if not isinstance(own, dict):
        return own
    shared = {key: value for key, value in own.items() if not key.isdecimal()}
    numbered = {key: value for key, value in own.items() if key.isdecimal()}
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
        if not isinstance(value, dict):
            message = f"tendon.{vein}: need a table under [tendon.{vein}], got {as_written(value)}"
            raise RejectedError(["tendon", vein], message)
        tendons[vein] = tendon_over(tendons[vein], value, vein, si=si)
    return tendons


def entries_over(below: object, own: object, *, si: bool) -> object:
    """Lay the tendons of a sheet over those below: a list in place of them, a number or a name over one of them.

    Args:
        below: the value of the key `tendon` so far, a list of tables, or None.
        own: what is laid over it.
        si: whether numbers are SI floats instead of text.

    Raises:
        RejectedError: there is no such tendon, or what is laid over it cannot be.
    """
    if isinstance(own, list):
        return [
            tendon_over({}, entry, f"{number}", si=si, model=SheetTendon) if isinstance(entry, dict) else entry
            for number, entry in enumerate(own)
        ]
    if not isinstance(own, dict) or not isinstance(below, list):
        return laid_over(below, own, ("tendon",))
    entries = list(below)
    for text, value in own.items():
        try:
            number = entry_index(("tendon",), text, below, list(value)[:1] if isinstance(value, dict) else ())
        except InputError as error:
            raise RejectedError(("tendon", text), str(error)) from None
        entries[number] = (
            tendon_over(entries[number], value, f"{number}", si=si, model=SheetTendon)
            if isinstance(value, dict)
            else value
        )
    return entries


def tendon_over(
    below: object, own: Mapping[str, Any], vein: str, *, si: bool, model: type[ElasticTendon] = TendonSection
) -> dict[str, Any]:
    """Lay a tendon's values over those below: a spring takes off a law, a law a spring.

    Args:
        below: the table so far; what is none counts as empty.
        own: what is laid over it; with "none" for a law the tendon keeps the spring that it had at small extension.
        vein: number of its vein, or of its entry; empty for a table that stands for all.
        si: whether numbers are SI floats instead of text.
        model: its section.

    Raises:
        RejectedError: a law that cannot be read, a vein, or a key that goes on where there is a value.
    """
    place = ("tendon", vein) if vein else ("tendon",)
    table = dict(below) if isinstance(below, dict) else {}
    own = dict(own)
    if "vein" in own and model is TendonSection:
        rule = "a tendon of one vein stands under [[tendon]], where it names its vein"
        raise RejectedError((*place, "vein"), unknown_key(written_key((*place, "vein")), own["vein"], rule))
    if own.get("law") == NO_LAW:
        table = _without_law(table, si=si, model=model)
        del own["law"]
    elif "law" in own:
        own["law"] = _law_over(table.get("law"), own["law"], (*place, "law"), si=si)
        table = _but(table, "law", "stiffness", "damping")
    elif "law" in table and "stiffness" in own:
        table = _without_law(table, si=si, model=model)
    elif "law" in table and {"area", "rest_length"} & own.keys():
        # of a file that holds both: they follow from what changes
        table = _but(table, "stiffness", "damping")
    law = {"law": own.pop("law")} if "law" in own else {}
    return {**laid_over(table, own, place), **law}


def _law_over(below: object, own: object, place: tuple[str, ...], *, si: bool) -> object:
    """Lay a law, by name or by its values, over another one; what is named is read where a value goes inside it."""
    if isinstance(own, dict) and isinstance(own.get("based_on"), str | MaterialLaw):
        below, own = own["based_on"], _but(own, "based_on")
    if not isinstance(own, dict):
        return own
    table = {"based_on": below} if isinstance(below, str | MaterialLaw) else below
    if not isinstance(table, dict):
        return own
    named = table.get("based_on")
    if isinstance(named, str | MaterialLaw) and any(isinstance(value, dict) for value in own.values()):
        try:
            table = law_tables(tendon_material(named), si=si) | table
        except InputError as error:
            raise RejectedError(place, f"{written_key(place)}: {error}") from None
    return laid_over(table, own, place)


def _without_law(table: dict[str, Any], *, si: bool, model: type[ElasticTendon]) -> dict[str, Any]:
    """A tendon's table with its spring and damping at small extension instead of its law, if it is a right one."""
    rest = _but(table, "law", "area")
    if "law" not in table:
        return rest
    try:
        tendon = model.model_validate(table, context={"si": si})
    except ValidationError:  # whoever checks what is left says what is wrong with it
        return rest
    for key, value in small_extension(tendon).items():
        reader = field_quantity(model.model_fields[key])
        rest[key] = value if si or reader is None else format_quantity(value, reader.unit)
    if tendon.weighs:
        # what it weighs goes by its volume
        rest["area"] = table["area"]
    return rest


def _no_tendon(number: str, there: Iterable[str], veins: int) -> str:
    """Why a number picks no tendon."""
    shown = ", ".join(there) or "none"
    if number in (str(vein) for vein in range(veins)):
        return f"tendon.{number}: vein {number} has no tendon, those with one are {shown}; give it a [[tendon]] first"
    return f"tendon.{number}: need the number of a vein with a tendon, {shown}, got {as_written(number)}"


def _but(table: Mapping[str, Any], *keys: str) -> dict[str, Any]:
    return {key: value for key, value in table.items() if key not in keys}
