"""Names that a sheet's design gives to what is in it."""

from __future__ import annotations

import re

from forficula.errors import InputError
from forficula.quantities import as_written

# what dotted keys and bounds in a protocol can hold
_NAME = re.compile(r"[A-Za-z][\w -]{0,59}")
# how creases and places are written, and what joins several
_WRITTEN = re.compile(r"(crease|vertex|edge|facet) \d+|.*\b(and|or)\b.*|ground")
_RESERVED = ("none", "time", "rest", "target", "creases", "mountains", "valleys", "unassigned")


def checked_name(name: str) -> str:
    """Take a name.

    Raises:
        InputError: a key or a bound cannot hold it, or it means something; the caller knows the key.
    """
    if not _NAME.fullmatch(name):
        raise InputError(
            f"need a name of letters, digits, spaces, - and _ that begins with a letter, got {as_written(name)}"
        )
    if name in _RESERVED or _WRITTEN.fullmatch(name):
        raise InputError(f"need a name that means nothing yet, got {as_written(name)}")
    return name
