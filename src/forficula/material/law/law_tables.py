"""Tables of law files of tendons and creases, with errors that name the key."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from forficula.errors import InputError
from forficula.material.law.material_law import LawFact
from forficula.names import check_known
from forficula.quantities import as_written

_FACT = ("what", "value", "source")


def read_table(key: str, value: object, allowed: Sequence[str], needed: Sequence[str] = ()) -> dict[str, Any]:
    """Return a table with allowed keys, and all of those that are needed.

    Raises:
        InputError: another value, an unknown key, or a missing one.
    """
    if not isinstance(value, dict):
        got = "nothing" if value is None else as_written(value)
        raise InputError(f"{key}: need a table under [{key}], got {got}")
    check_known(value, allowed, f"{key}.")
    for name in needed:
        if name not in value:
            raise InputError(f"{key}.{name}: is missing; needed here: {', '.join(needed)}")
    return value


def read_list(key: str, tables: Mapping[str, Any]) -> list[Any]:
    """Return a list of tables; an empty one if it is absent.

    Raises:
        InputError: another value.
    """
    value = tables.get(key, [])
    if not isinstance(value, list):
        raise InputError(f"{key}: need a list of tables, each under [[{key}]], got {as_written(value)}")
    return value


def read_text(key: str, value: object) -> str:
    """Return a text.

    Raises:
        InputError: another value.
    """
    if not isinstance(value, str):
        raise InputError(f"{key}: need text in quotes, got {as_written(value)}")
    return value


def read_facts(tables: Mapping[str, Any]) -> tuple[LawFact, ...]:
    """Return the facts of a law file, under [[facts]].

    Raises:
        InputError: a value that is not allowed.
    """
    facts = []
    for number, value in enumerate(read_list("facts", tables)):
        table = read_table(f"facts.{number}", value, _FACT, needed=_FACT)
        facts.append(LawFact(**{name: read_text(f"facts.{number}.{name}", table[name]) for name in _FACT}))
    return tuple(facts)
