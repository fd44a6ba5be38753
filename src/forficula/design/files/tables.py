"""Tables of design files: laying tables over each other, and the error that names a place in them."""

from __future__ import annotations

import difflib
import re
from collections.abc import Collection, Iterable, Mapping, Sequence
from typing import Any

from forficula.errors import InputError
from forficula.names import listed, unknown_key
from forficula.quantities import as_written, plain_value

# text in place of a section, or of an entry of a list of sections, that removes it
REMOVED = "none"


class RejectedError(InputError):
    """A design that is not allowed, with the place of the wrong value."""

    def __init__(self, place: Sequence[str], message: str) -> None:
        super().__init__(message)
        self.place = tuple(place)


def merged(below: object, upper: object, place: tuple[str, ...] = ()) -> Any:
    """Lay the values of a file over those of its base: tables are merged, all other values are replaced.

    A table of tables over a list of tables changes the entries that its keys name.

    Raises:
        RejectedError: a list has no such entry.
    """
    if isinstance(below, list) and isinstance(upper, dict) and _holds_tables(below) and _holds_tables(upper.values()):
        return with_settings_over(below, upper, place)
    if not (isinstance(below, dict) and isinstance(upper, dict)):
        return upper
    return {**below, **{key: merged(below.get(key), value, (*place, key)) for key, value in upper.items()}}


def _holds_tables(values: Collection[object]) -> bool:
    return bool(values) and all(isinstance(value, dict) for value in values)


def nested(settings: Mapping[str, object]) -> dict[str, Any]:
    """Convert values by dotted key to nested tables; a number remains a key.

    Raises:
        RejectedError: a key continues where another one has a value.
    """
    tables: dict[str, Any] = {}
    # short keys first: a table before values inside it
    for key, value in sorted(settings.items(), key=lambda item: item[0].count(".")):
        *sections, last = key.split(".")
        table = tables
        for depth, section in enumerate(sections, start=1):
            inside = table.setdefault(section, {})
            if isinstance(inside, list):
                # the settings give a list and also a value in one of its entries
                within = nested({".".join([*sections[depth:], last]): value})
                table[section] = with_settings_over(inside, within, tuple(sections[:depth]))
                break
            if not isinstance(inside, dict):
                # a law that is given by name may also have values
                if section != "law":
                    raise _nothing_inside(key.split("."), depth, value)
                inside = table[section] = {"based_on": inside}
            table = inside
        else:
            table[last] = merged(table.get(last), _copied(value))
    return tables


def with_settings_over(below: object, upper: object, place: tuple[str, ...] = ()) -> Any:
    """Lay settings over tables: like `merged`, but a number or name selects an entry of a list, and "none" removes it.

    Raises:
        RejectedError: a list has no such entry, or a key continues where there is a value.
    """
    # a law that is given by name with further values replaces another law
    if not isinstance(upper, dict) or below is None or (place[-1:] == ("law",) and "based_on" in upper):
        return upper
    if isinstance(below, dict):
        return {
            **below,
            **{key: with_settings_over(below.get(key), value, (*place, key)) for key, value in upper.items()},
        }
    if not isinstance(below, list):
        if not upper:
            return upper
        raise _nothing_inside([*place, *_first_leaf(upper)], len(place), _first_value(upper))
    entries = list(below)
    for text, value in upper.items():
        try:
            number = entry_index(place, text, below, _first_leaf(value))
        except InputError as error:
            raise RejectedError((*place, text), str(error)) from None
        entries[number] = with_settings_over(entries[number], value, (*place, text))
    return without_removed(below, entries)


def without_removed(below: list[Any], entries: list[Any]) -> list[Any]:
    """Return the entries of a list of tables without those that "none" has replaced."""
    return [
        entry
        for before, entry in zip(below, entries, strict=True)
        if not (entry == REMOVED and isinstance(before, dict))
    ]


def entry_index(place: Sequence[str], text: str, entries: Sequence[Any], inside: Sequence[str] = ()) -> int:
    """Return the index of an entry of a list by its number or its name.

    Args:
        place: parts of the key of the list.
        text: the number, or the name if the entries have names.
        entries: entries of a list of a design, or of the tables of a file.
        inside: continuation of the key, for error messages.

    Raises:
        InputError: there is no such entry; the message lists the entries.
    """
    if text in (allowed := [str(index) for index in range(len(entries))]):
        return int(text)
    values = (entry.get("name") if isinstance(entry, dict) else getattr(entry, "name", None) for entry in entries)
    names = [name if isinstance(name, str) else "" for name in values]
    if names.count(text) == 1:
        return names.index(text)
    key = written_key([*place, text, *inside])
    if not entries:
        raise InputError(f"{key}: has no entries, got {as_written(text)}")
    known = [f"{index} ({name})" if name else index for index, name in zip(allowed, names, strict=True)]
    need = f"need {'one of ' * (len(known) > 1)}{listed(known, 'or')} after {written_key(place)}"
    if near := difflib.get_close_matches(text, [name for name in names if name], n=1):
        raise InputError(f"{key}: {need}; did you mean {written_key([*place, *near, *inside])}?")
    # a key of an entry where the number or name of the entry is missing
    left_out = any(text in entry if isinstance(entry, dict) else hasattr(entry, text) for entry in entries)
    if inside or left_out:
        first = names[0] if names[0] and names.count(names[0]) == 1 else "0"
        raise InputError(f"{key}: {need}, such as {written_key([*place, first, *(inside or [text])])}")
    raise InputError(f"{key}: {need}, got {as_written(text)}")


def numbered(key: str, tables: Mapping[str, Any]) -> str:
    """Return a dotted key of tables with the numbers of entries in place of their names."""
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
    """Refuse two keys for the same value: by number and by name of an entry, or with dots and in a table.

    Args:
        keys: dotted keys, including those of values in nested tables.
        tables: tables in which the keys are looked up.

    Raises:
        InputError: a value with two keys.
    """
    seen: dict[str, str] = {}
    for key in keys:
        if (other := seen.get(number := numbered(key, tables))) is not None:
            how = "once with dots in its name and once in a table" if other == key else f"also as {other}"
            raise InputError(f"{key}: is given twice, {how}")
        seen[number] = key


def written_key(place: Sequence[str]) -> str:
    """Join the parts of a key as in a TOML file."""
    return ".".join(part if re.fullmatch(r"[A-Za-z0-9_-]{1,60}", part) else as_written(part) for part in place)


def dotted_keys(tables: Mapping[str, object], prefix: str = "") -> list[str]:
    """Return the dotted keys of all values in nested tables."""
    keys: list[str] = []
    for key, value in tables.items():
        keys += dotted_keys(value, f"{prefix}{key}.") if isinstance(value, Mapping) else [f"{prefix}{key}"]
    return keys


def _copied(value: object) -> object:
    """Copy a value of settings; convert numbers and arrays of numpy to plain ones."""
    return {key: _copied(inner) for key, inner in value.items()} if isinstance(value, Mapping) else plain_value(value)


def _first_leaf(tables: object) -> list[str]:
    if not isinstance(tables, dict) or not tables:
        return []
    key, value = next(iter(tables.items()))
    return [str(key), *_first_leaf(value)]


def _first_value(tables: object) -> object:
    """Return the value at `_first_leaf`."""
    return _first_value(next(iter(tables.values()))) if isinstance(tables, dict) and tables else tables


def _nothing_inside(place: Sequence[str], depth: int, value: object) -> RejectedError:
    return RejectedError(place, unknown_key(written_key(place), value, f"did you mean {written_key(place[:depth])}?"))
