"""Keys of a study file: which there are, and those of nested tables with dots."""

from __future__ import annotations

import difflib
from collections.abc import Mapping
from typing import Any

from forficula.errors import InputError
from forficula.names import unknown_key


def check_keys(table: Mapping[str, object], keys: tuple[str, ...], prefix: str) -> None:
    """Refuse keys that are none.

    Args:
        table: of the file.
        keys: that it may have.
        prefix: what stands before them in errors, such as "search.".

    Raises:
        InputError: one of them is unknown, and which is near.
    """
    for key in table:
        if key not in keys:
            near = difflib.get_close_matches(key, keys, n=1)
            hint = f"did you mean {prefix}{near[0]}?" if near else f"allowed here: {', '.join(keys)}"
            raise InputError(unknown_key(f"{prefix}{key}", table[key], hint))


# keys of tables that are values themselves: distributions, and laws with what they are based on
_VALUES = frozenset({"distribution", "based_on"})


def dotted_values(
    table: Mapping[str, Any],
    header: str,
    prefix: str = "",
    values: frozenset[str] = _VALUES,
    *,
    empty: bool = False,
) -> dict[str, Any]:
    """The values of nested tables by dotted key.

    Args:
        table: of the file.
        header: what errors call it.
        prefix: what stands before its keys, such as "tendon.".
        values: a table with any of these keys is a value itself.
        empty: whether a table without any is one, too, to be refused by what reads it; otherwise it says nothing.

    Raises:
        InputError: one of them is given twice.
    """
    flat: dict[str, Any] = {}
    for key, value in table.items():
        nested = isinstance(value, dict) and not values & value.keys() and not (empty and not value)
        more = (
            dotted_values(value, header, f"{prefix}{key}.", values, empty=empty)
            if nested
            else {f"{prefix}{key}": value}
        )
        if twice := flat.keys() & more.keys():
            raise InputError(f"{header}.{min(twice)}: is given twice, once with dots in its name and once in a table")
        flat |= more
    return flat
