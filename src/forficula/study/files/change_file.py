"""Read and check the tables `change` of a study file, and combine the changes in pairs."""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Annotated, Any, ClassVar

from pydantic import BeforeValidator, Field

from forficula.design import Design, key_quantity, key_value, numbered_key, value_from_folder
from forficula.design.file_fields import ByKey, entry
from forficula.design.files.tables import REMOVED
from forficula.design.section import Section
from forficula.errors import InputError, error_prefix
from forficula.quantities import as_written, format_quantity
from forficula.study.changes import Change, ChangePlan, OmittedPair, together_values
from forficula.study.factors import MOST_VALUES

Values = Annotated[dict[str, Any], BeforeValidator(ByKey(allowed='as in a design; "none" removes the element'))]
Multiples = Annotated[dict[str, Any], BeforeValidator(ByKey(allowed="number"))]


class ChangeTable(Section):
    """A named change of the design."""

    about: ClassVar[str] = "A named change of the design"

    name: Annotated[str, Field(min_length=1)] = entry("name of the change in tables and figures", ...)
    values: Values = entry('new value of the key; "none" removes the element of the key', {})
    multiply: Multiples = entry("factor by which the value of the key is multiplied", {})


def read_changes(tables: Sequence[ChangeTable], folder: Path, base: Design, *, pairs: bool) -> ChangePlan:
    """Read the changes of a study: the unchanged design, every change alone and, on request, every pair.

    Args:
        tables: tables of the file.
        folder: folder that paths are relative to.
        base: the design that is changed.
        pairs: whether to combine every two changes.

    Raises:
        InputError: a change that the design does not allow, that changes nothing or that repeats another one.
    """
    changes: list[Change] = []
    hashes = {base.hash: "the design"}
    for number, table in enumerate(tables):
        with error_prefix(f"change {number} ({table.name}): "):
            if any(change.name == table.name for change in changes):
                raise InputError("name: need a name that no other change has")
            change = Change(name=table.name, values=_values(table, folder, base))
            changed = _changed(base, change)
            if (same := hashes.get(changed.hash)) is not None:
                raise InputError(f"need values that differ from those of {same}")
            hashes[changed.hash] = f"change {number} ({table.name})"
        changes.append(change)
    together: list[tuple[int, ...]] = [(), *((index,) for index in range(len(changes)))]
    omitted: list[OmittedPair] = []
    if pairs:
        if (count := math.comb(len(changes), 2)) > MOST_VALUES:
            raise InputError(f"change: need at most {MOST_VALUES} pairs, got {count}")
        for first, second in itertools.combinations(range(len(changes)), 2):
            pair = (changes[first], changes[second])
            if why := _why_not_together(base, *pair):
                omitted.append(OmittedPair(names=(pair[0].name, pair[1].name), why=why))
            else:
                together.append((first, second))
    return ChangePlan(changes=tuple(changes), together=tuple(together), omitted=tuple(omitted))


def _values(table: ChangeTable, folder: Path, base: Design) -> dict[str, object]:
    """Return the values of a change by dotted key."""
    values = {key: value_from_folder(key, value, folder) for key, value in table.values.items()}
    for key, value in values.items():
        with error_prefix("values."):
            _check_unit(key, value, base)
    for key, factor in table.multiply.items():
        with error_prefix(f"multiply.{key}: "):
            if key in values:
                raise InputError("is under values, too; need it in one of them")
            values[key] = _multiple(key, factor, base)
    if not values:
        raise InputError("need at least one key under values or multiply")
    return values


def _check_unit(key: str, value: object, base: Design) -> None:
    """Reject a number without a unit for a key whose values have one, because it would be read in SI units."""
    if isinstance(value, int | float) and not isinstance(value, bool):
        quantity = key_quantity(key, type(base), value)
        if quantity is not None:
            with error_prefix(f"{key}: "):
                quantity.parse(value)


def _multiple(key: str, factor: object, base: Design) -> object:
    """Return a multiple of the value of a key, as text with its unit."""
    if isinstance(factor, bool) or not isinstance(factor, int | float) or not math.isfinite(factor):
        raise InputError(f"need a number such as 0.5, got {as_written(factor)}")
    quantity, value = key_quantity(key, type(base)), key_value(base, key)
    if value is None:
        raise InputError(f"{base.name} has no common value to multiply; give a value under values")
    if isinstance(value, bool) or not isinstance(value, int | float):
        raise InputError(f"need a key with a number, got {as_written(value)}; give a value under values")
    return factor * value if quantity is None else format_quantity(factor * value, quantity.unit)


def _changed(base: Design, change: Change) -> Design:
    """Return the changed design."""
    try:
        return base.with_values(change.values)
    except InputError as error:
        raise InputError(str(error).removeprefix(f"{base.name}: ")) from None


def _why_not_together(base: Design, first: Change, second: Change) -> str:
    """Return the reason why two changes cannot be made together; empty if they can."""
    for key, other_key in itertools.product(first.values, second.values):
        one, other = (numbered_key(base, name) for name in (key, other_key))
        if one == other or one.startswith(f"{other}.") or other.startswith(f"{one}."):
            return f"both change {key if len(one) <= len(other) else other_key}"
    try:
        together = base.with_values(together_values((first, second))).hash
        alone = [base.with_values(change.values).hash for change in (first, second)]
    except InputError:
        return ""  # its row says why the design cannot be built
    if together in alone:
        name = (first, second)[alone.index(together)].name
        return f"together they give the same design as {as_written(name)} alone"
    return ""


def in_units(table: Mapping[str, object], base: Design) -> Mapping[str, object]:
    """Return a table `change` of a Python call in the form of a file: numbers in SI become text with their units."""
    values = table.get("values")
    if not isinstance(values, Mapping):
        return table
    return {**table, "values": {key: _in_unit(key, value, base) for key, value in values.items()}}


def _in_unit(key: str, value: object, base: Design) -> object:
    if value == REMOVED or isinstance(value, bool) or not isinstance(value, int | float):
        return value
    quantity = key_quantity(key, type(base), value)
    return value if quantity is None else format_quantity(float(value), quantity.unit)
