"""Check of the names that a sheet's design gives to groups, tendons, drives and measures."""

from __future__ import annotations

import re

from forficula.errors import InputError
from forficula.quantities import as_written

# names that are allowed in dotted keys and in bounds of a protocol
_NAME = re.compile(r"[A-Za-z][\w -]{0,59}")
# texts that mean creases or places, or join several terms
_WRITTEN = re.compile(r"(crease|vertex|edge|facet) \d+|.*\b(and|or)\b.*|ground")
_RESERVED = ("none", "time", "rest", "target", "creases", "mountains", "valleys", "unassigned")


def checked_name(name: str) -> str:
    """Return a name if it is allowed.

    Raises:
        InputError: the name is not allowed in keys and bounds, or it has a meaning already; the caller adds the key.
    """
    if not _NAME.fullmatch(name):
        raise InputError(
            f"need a name of letters, digits, spaces, - and _ that begins with a letter, got {as_written(name)}"
        )
    if name in _RESERVED or _WRITTEN.fullmatch(name):
        raise InputError(f"need a name that has no other meaning, got {as_written(name)}")
    return name
