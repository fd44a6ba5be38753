"""Tables of design files, laid over each other, and the error that names a place in them."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from typing import Any

from forficula.errors import InputError
from forficula.quantities import as_written


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
                    raise _nothing_inside(key.split("."), depth)
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
        raise _nothing_inside([*place, *_first_leaf(own)], len(place))
    entries = list(below)
    for text, value in own.items():
        try:
            number = entry_index(written_key([*place, *_first_leaf({text: value})]), text, below)
        except InputError as error:
            raise RejectedError((*place, text), str(error)) from None
        entries[number] = laid_over(entries[number], value, (*place, text))
    return entries


def entry_index(key: str, text: str, entries: Sequence[Any]) -> int:
    """Find an entry of a list by its number or its name.

    Args:
        key: that it is a part of.
        text: the number, or the name where the entries have names.
        entries: of the list: of a design, or of the tables of a file.

    Raises:
        InputError: there is none, and which there are.
    """
    if text in (allowed := [str(index) for index in range(len(entries))]):
        return int(text)
    names = [entry.get("name") if isinstance(entry, dict) else getattr(entry, "name", None) for entry in entries]
    if names.count(text) == 1:
        return names.index(text)
    shown = ", ".join(f"{index} ({name})" if name else index for index, name in zip(allowed, names, strict=True))
    rule = f"need one of the numbers {shown} in it" if shown else "has no entries"
    raise InputError(f"{key}: {rule}, got {as_written(text)}")


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
    return {key: _copied(each) for key, each in value.items()} if isinstance(value, Mapping) else value


def _first_leaf(tables: object) -> list[str]:
    if not isinstance(tables, dict) or not tables:
        return []
    key, value = next(iter(tables.items()))
    return [str(key), *_first_leaf(value)]


def _nothing_inside(place: Sequence[str], depth: int) -> RejectedError:
    shown = written_key(place[:depth])
    return RejectedError(place, f"{written_key(place)}: unknown key; did you mean {shown}?")
