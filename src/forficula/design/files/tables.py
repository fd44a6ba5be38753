"""Tables of design files, laid over each other, and the error that names a place in them."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from forficula.errors import InputError
from forficula.names import listed, unknown_key
from forficula.quantities import as_written, plain_value


class RejectedError(InputError):
    """A design that is not allowed, and the place that is to blame."""

    def __init__(self, place: Sequence[str], message: str) -> None:
        super().__init__(message)
        self.place = tuple(place)


def merged(below: object, own: object) -> Any:
    """Lay what a file gives over what it is based on: tables change what they name, all else replaces."""
    if not (isinstance(below, dict) and isinstance(own, dict)):
        return own
    return {**below, **{key: merged(below.get(key), value) for key, value in own.items()}}


def nested(settings: Mapping[str, object]) -> dict[str, Any]:
    """Values by dotted key as tables in tables; a number stays a key.

    Raises:
        RejectedError: a key goes on where another one has a value.
    """
    tables: dict[str, Any] = {}
    # a value before what is in it
    for key, value in sorted(settings.items(), key=lambda item: item[0].count(".")):
        *sections, last = key.split(".")
        table = tables
        for depth, section in enumerate(sections, start=1):
            inside = table.setdefault(section, {})
            if isinstance(inside, list):
                # a list that is given, too, with a value in an entry of it
                within = nested({".".join([*sections[depth:], last]): value})
                table[section] = laid_over(inside, within, tuple(sections[:depth]))
                break
            if not isinstance(inside, dict):
                # a law that is named takes values, too
                if section != "law":
                    raise _nothing_inside(key.split("."), depth, value)
                inside = table[section] = {"based_on": inside}
            table = inside
        else:
            table[last] = merged(table.get(last), _copied(value))
    return tables


def laid_over(below: object, own: object, place: tuple[str, ...] = ()) -> Any:
    """Lay settings over tables: as `merged`, but a number picks an entry of a list, and nothing goes into a value.

    Raises:
        RejectedError: a list has no such entry, or a key goes on where there is a value.
    """
    if not isinstance(own, dict) or below is None:
        return own
    if isinstance(below, dict):
        return {**below, **{key: laid_over(below.get(key), value, (*place, key)) for key, value in own.items()}}
    if not isinstance(below, list):
        if not own:
            return own
        raise _nothing_inside([*place, *_first_leaf(own)], len(place), _first_value(own))
    entries = list(below)
    for text, value in own.items():
        try:
            number = entry_index(place, text, below, _first_leaf(value))
        except InputError as error:
            raise RejectedError((*place, text), str(error)) from None
        entries[number] = laid_over(entries[number], value, (*place, text))
    return entries


def entry_index(place: Sequence[str], text: str, entries: Sequence[Any], inside: Sequence[str] = ()) -> int:
    """Find an entry of a list by its number or its name.

    Args:
        place: of the list, part by part.
        text: the number, or the name where the entries have names.
        entries: of the list: of a design, or of the tables of a file.
        inside: what the key goes on with, for errors.

    Raises:
        InputError: there is none, and which there are.
    """
    if text in (allowed := [str(index) for index in range(len(entries))]):
        return int(text)
    called = (entry.get("name") if isinstance(entry, dict) else getattr(entry, "name", None) for entry in entries)
    names = [name if isinstance(name, str) else "" for name in called]
    if names.count(text) == 1:
        return names.index(text)
    key = written_key([*place, text, *inside])
    if not entries:
        raise InputError(f"{key}: has no entries, got {as_written(text)}")
    known = [f"{index} ({name})" if name else index for index, name in zip(allowed, names, strict=True)]
    need = f"need {'one of ' * (len(known) > 1)}{listed(known, 'or')} after {written_key(place)}"
    if near := difflib.get_close_matches(text, [name for name in names if name], n=1):
        raise InputError(f"{key}: {need}; did you mean {written_key([*place, *near, *inside])}?")
    # a key of the entries stands where one of them is to be named
    left_out = any(text in entry if isinstance(entry, dict) else hasattr(entry, text) for entry in entries)
    if inside or left_out:
        first = names[0] if names[0] and names.count(names[0]) == 1 else "0"
        raise InputError(f"{key}: {need}, such as {written_key([*place, first, *(inside or [text])])}")
    raise InputError(f"{key}: {need}, got {as_written(text)}")


def numbered(key: str, tables: Mapping[str, Any]) -> str:
    """A dotted key of tables with the numbers of entries in place of their names."""
    parts: list[str] = []
    at: Any = tables
    for part in key.split("."):
        names = [entry.get("name") for entry in at if isinstance(entry, dict)] if isinstance(at, list) else []
        parts.append(str(names.index(part)) if names.count(part) == 1 else part)
        if isinstance(at, list):
            at = next((entry for number, entry in enumerate(at) if str(number) == parts[-1]), None)
        else:
            at = at.get(part) if isinstance(at, dict) else None
    return ".".join(parts)


def check_once(keys: Iterable[str], tables: Mapping[str, Any]) -> None:
    """Refuse two keys that lead to the same value: by the number and the name of an entry, or with dots and in a table.

    Args:
        keys: dotted, those of values in nested tables among them.
        tables: that they lead into.

    Raises:
        InputError: which two.
    """
    found: dict[str, str] = {}
    for key in keys:
        if (other := found.get(number := numbered(key, tables))) is not None:
            how = "once with dots in its name and once in a table" if other == key else f"the other time as {other}"
            raise InputError(f"{key}: is given twice, {how}")
        found[number] = key


def written_key(place: Sequence[str]) -> str:
    """A key as a TOML file has it."""
    return ".".join(part if re.fullmatch(r"[A-Za-z0-9_-]{1,60}", part) else as_written(part) for part in place)


def dotted_keys(tables: Mapping[str, object], prefix: str = "") -> list[str]:
    """The dotted keys of all values in nested tables."""
    keys: list[str] = []
    for key, value in tables.items():
        keys += dotted_keys(value, f"{prefix}{key}.") if isinstance(value, Mapping) else [f"{prefix}{key}"]
    return keys


def _copied(value: object) -> object:
    """A value of settings, numbers and arrays of numpy as those of a file."""
    return {key: _copied(each) for key, each in value.items()} if isinstance(value, Mapping) else plain_value(value)


def _first_leaf(tables: object) -> list[str]:
    if not isinstance(tables, dict) or not tables:
        return []
    key, value = next(iter(tables.items()))
    return [str(key), *_first_leaf(value)]


def _first_value(tables: object) -> object:
    """The value at `_first_leaf`."""
    return _first_value(next(iter(tables.values()))) if isinstance(tables, dict) and tables else tables


def _nothing_inside(place: Sequence[str], depth: int, value: object) -> RejectedError:
    return RejectedError(place, unknown_key(written_key(place), value, f"did you mean {written_key(place[:depth])}?"))
