"""JSON of results and its schema, both derived from the annotated fields of data classes.

The unit of a field is part of its type, as in `time: Annotated[float, Unit("s")]`. In JSON the unit is the end of the
key, `time_s`, and angles are in degrees. A number that does not exist is null.
"""

from __future__ import annotations

import json
import math
import re
import types
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, is_dataclass
from enum import Enum
from functools import cache, cached_property
from typing import Annotated, Any, Literal, Union, get_args, get_origin, get_type_hints

from forficula.quantities import Unit

_DIALECT = "https://json-schema.org/draft/2020-12/schema"
_NUMBER = {"type": ["number", "null"]}
_SCALARS = {bool: "boolean", int: "integer", str: "string", type(None): "null"}
# a description in the section "Attributes" of a docstring, up to the next one
_ATTRIBUTE = re.compile(r"^ {8}(\w+): (.*(?:\n {12}.*)*)", re.M)

Metres = Annotated[float, Unit("m")]
SquareMetres = Annotated[float, Unit("m^2")]
Radians = Annotated[float, Unit("rad")]
Seconds = Annotated[float, Unit("s")]
Joules = Annotated[float, Unit("J")]
Newtons = Annotated[float, Unit("N")]
NewtonMetres = Annotated[float, Unit("N m")]
NewtonsPerMetre = Annotated[float, Unit("N/m")]
Pascals = Annotated[float, Unit("Pa")]
JoulesPerCubicMetre = Annotated[float, Unit("J/m^3")]


@dataclass(frozen=True)
class Key:
    """Key of a field in JSON, without its unit, if it differs from the name of the field."""

    name: str


class Written(Enum):
    """Rule for writing a field or a property to JSON, if it is not simply its value under its key.

    A property is written only if its type has one of these rules, a `Key` or a `Unit`.
    """

    ALWAYS = "always"  # a property that is written like a field
    FIRST = "first"  # a property that is written before the fields
    NEVER = "never"
    IF_KNOWN = "if known"  # the key is left out if the value is None
    BESIDE = "beside"  # entries of a mapping or a data class become keys of the whole, whose other keys have priority
    OR_NULL = "or null"  # an empty text is null


@dataclass(frozen=True)
class WithUnit:
    """A value of a mapping with its unit, which is known only at run time.

    Attributes:
        value: number or array in SI.
        unit: unit, such as "N m"; empty for a number without a unit.
    """

    value: Any
    unit: str


@dataclass(frozen=True)
class _Entry:
    """A field or a property in JSON.

    Attributes:
        name: name of the field.
        key: key in JSON, with the unit.
        unit: unit of the numbers; empty without one.
        how: further rules.
        hint: type.
        meaning: description from the docstring; empty without one.
    """

    name: str
    key: str
    unit: str
    how: frozenset[Written]
    hint: Any
    meaning: str


def key_with_unit(name: str, unit: str) -> str:
    """Return the key of a quantity, such as "torque_N_m"; angles are in degrees.

    >>> key_with_unit("stiffness", "N/m"), key_with_unit("angle", "rad"), key_with_unit("rate", "1/s")
    ('stiffness_N_per_m', 'angle_deg', 'rate_per_s')
    """
    return name + unit_suffix("deg" if unit == "rad" else unit)


def unit_suffix(unit: str) -> str:
    """Return the end of a key whose values are in a unit; empty without a unit.

    >>> unit_suffix("kg/m^3"), unit_suffix("1/s")
    ('_kg_per_m3', '_per_s')
    """
    words = unit.removeprefix("1").replace("/", "_per_").replace("^", "").replace(" ", "_").strip("_")
    return f"_{words}" if words else ""


def plain(value: Any, unit: str = "") -> Any:
    """Convert a value to JSON types: data classes and mappings to dict, arrays and tuples to list, NaN to None.

    Args:
        value: value to write.
        unit: unit of its numbers; angles are converted to degrees.
    """
    if isinstance(value, Enum):
        return value.value
    if value is None or isinstance(value, bool | str):
        return value
    if isinstance(value, int | float):
        number = math.degrees(value) if unit == "rad" else value
        if isinstance(number, int):
            return number
        return float(number) if math.isfinite(number) else None  # also converts numbers of NumPy
    if isinstance(value, Mapping):
        return {
            key_with_unit(key, entry.unit) if isinstance(entry, WithUnit) else key: plain(entry, unit)
            for key, entry in value.items()
        }
    if isinstance(value, WithUnit):
        return plain(value.value, value.unit)
    if is_dataclass(value):
        return _plain_fields(value)
    if hasattr(value, "tolist"):  # an array of NumPy
        return plain(value.tolist(), unit)
    return [plain(entry, unit) for entry in value]


def json_text(value: Any) -> str:
    """Return the text of a JSON file with a value as `plain` returns it."""
    return json.dumps(plain(value), indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def _plain_fields(value: Any) -> dict[str, Any]:
    entries = _entries(value.__class__)
    keys = {entry.key for entry in entries if Written.BESIDE not in entry.how}
    written: dict[str, Any] = {}
    for entry in entries:
        content = getattr(value, entry.name)
        if Written.BESIDE in entry.how:
            others = {} if content is None else plain(content, entry.unit)
            written |= {key: other for key, other in others.items() if key not in keys}
        elif content is not None or Written.IF_KNOWN not in entry.how:
            written[entry.key] = plain(None if Written.OR_NULL in entry.how and content == "" else content, entry.unit)
    return written


def schema_of(shape: Any, name: str) -> dict[str, Any]:
    """Return the JSON schema (draft 2020-12) of the results of `plain` for values of a type.

    Args:
        shape: a data class, or another type.
        name: name of the schema.
    """
    parts: dict[str, Any] = {}
    schema = _schema(shape, parts)
    if "$ref" in schema:
        schema = parts.pop(shape.__name__)
    return {"$schema": _DIALECT, "$id": f"forficula-{name}", **schema, **({"$defs": parts} if parts else {})}


def _schema(hint: Any, parts: dict[str, Any]) -> dict[str, Any]:
    """Return the schema of a type; those of data classes are added to `parts`, by their names."""
    origin, arguments = get_origin(hint), get_args(hint)
    if hint in _SCALARS:
        return {"type": _SCALARS[hint]}
    if hint is float:
        return dict(_NUMBER)
    if hint is Any:
        return {}
    if origin is Annotated:
        return _schema(arguments[0], parts)
    if hint is WithUnit:
        return _any_of([_NUMBER, {"type": "array", "items": _NUMBER}])
    if origin in (Union, types.UnionType):
        return _any_of([_schema(argument, parts) for argument in arguments])
    if origin is Literal:
        return {"enum": list(arguments)}
    if isinstance(hint, type) and issubclass(hint, Enum):
        return {"enum": [member.value for member in hint]}
    if is_dataclass(hint):
        return _reference(hint, parts)
    if origin is not None and issubclass(origin, Mapping):
        return {"type": "object", "additionalProperties": _schema(arguments[1], parts)}
    if origin is not None and issubclass(origin, Sequence):
        kinds = dict.fromkeys(argument for argument in arguments if argument is not Ellipsis)
        return {"type": "array", "items": _any_of([_schema(kind, parts) for kind in kinds])}
    return {"type": "array", "items": {"type": ["number", "boolean", "array", "null"]}}


def _reference(shape: Any, parts: dict[str, Any]) -> dict[str, Any]:
    """Return the reference to the schema of a data class, which is added to `parts`."""
    name = shape.__name__
    if name not in parts:
        parts[name] = {}  # a data class can contain others
        parts[name] |= _object(shape, parts)
    return {"$ref": f"#/$defs/{name}"}


def _object(shape: Any, parts: dict[str, Any]) -> dict[str, Any]:
    """Return the schema of a data class, whose descriptions are those of its docstring."""
    properties: dict[str, Any] = {}
    required: list[str] = []
    others: list[dict[str, Any]] = []
    for entry in _entries(shape):
        alternatives = _alternatives(entry.hint)
        known = [kind for kind in alternatives if kind is not type(None)]
        if Written.BESIDE not in entry.how:
            allowed = known if Written.IF_KNOWN in entry.how else alternatives
            null = [{"type": "null"}] if Written.OR_NULL in entry.how else []
            schema = _any_of([*(_schema(kind, parts) for kind in allowed), *null])
            properties[entry.key] = {"description": entry.meaning, **schema} if entry.meaning else schema
            required += [entry.key] if Written.IF_KNOWN not in entry.how else []
        elif is_dataclass(known[0]):
            added = _object(known[0], parts)
            properties |= added["properties"]
            required += added["required"] if len(alternatives) == 1 else []
            others += [added["additionalProperties"]] if added["additionalProperties"] else []
        else:
            others.append(_schema(get_args(known[0])[1], parts))
    return {
        "type": "object",
        "description": (shape.__doc__ or "").split("\n\n")[0],
        "properties": properties,
        "required": required,
        "additionalProperties": _any_of(others) if others else False,
    }


def _any_of(schemas: Sequence[dict[str, Any]]) -> dict[str, Any]:
    """Return the schema of values that at least one of several schemas allows."""
    different = [schema for number, schema in enumerate(schemas) if schema not in schemas[:number]]
    if _NUMBER in different:
        different = [schema for schema in different if schema != {"type": "null"}]
    return different[0] if len(different) == 1 else {"anyOf": different}


def _alternatives(hint: Any) -> tuple[Any, ...]:
    """Return the members of a union, or the type itself."""
    if get_origin(hint) is Annotated:
        return _alternatives(get_args(hint)[0])
    return get_args(hint) if get_origin(hint) in (Union, types.UnionType) else (hint,)


@cache
def _entries(shape: type) -> tuple[_Entry, ...]:
    """Return the entries of a data class in JSON: its fields in their order, then its properties."""
    hints = get_type_hints(shape, include_extras=True)
    meanings = {name: " ".join(text.split()) for name, text in _ATTRIBUTE.findall(shape.__doc__ or "")}
    every = [(field.name, hints[field.name], True, meanings.get(field.name, "")) for field in fields(shape)]
    for base in reversed(shape.__mro__):
        for name, member in vars(base).items():
            if isinstance(member, property | cached_property):
                function = member.fget if isinstance(member, property) else member.func
                every.append((name, _returned(function), False, (function.__doc__ or "").split("\n")[0]))
    entries = [entry for arguments in every if (entry := _entry(*arguments)) is not None]
    return tuple(sorted(entries, key=lambda entry: Written.FIRST not in entry.how))


def _entry(name: str, hint: Any, is_field: bool, meaning: str) -> _Entry | None:
    """Return the entry of a field or a property in JSON; None if it is not written."""
    notes = list(_notes(hint))
    how = frozenset(note for note in notes if isinstance(note, Written))
    if Written.NEVER in how or not (is_field or notes):
        return None
    unit = next((note.si for note in notes if isinstance(note, Unit)), "")
    key = next((note.name for note in notes if isinstance(note, Key)), name)
    return _Entry(name=name, key=key_with_unit(key, unit), unit=unit, how=how, hint=hint, meaning=meaning)


def _returned(function: Callable[..., Any] | None) -> Any:
    """Return the type that a property returns; None if only a type checker imports it, as it is then not in JSON."""
    try:
        return get_type_hints(function, include_extras=True).get("return")
    except NameError:
        return None


def _notes(hint: Any) -> Iterator[Any]:
    """Yield the units, keys and rules in a type, the outer ones first, without those inside data classes."""
    if get_origin(hint) is Annotated:
        yield from (note for note in hint.__metadata__ if isinstance(note, Unit | Key | Written))
    for argument in get_args(hint):
        yield from _notes(argument)
