"""Names that a user gives to things."""

from __future__ import annotations

import re

from forficula.errors import InputError
from forficula.quantities import as_written

# what moves a terminal's cursor or ends a line, and halves of characters that no file can hold
_NO_LETTER = re.compile(r"[\x00-\x1f\x7f-\x9f\ud800-\udfff]")

_ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth")


def ordinal(number: int) -> str:
    """The place of a number that counts from 0, in words: 0 is "first"; beyond the tenth in digits, as "11th"."""
    if number < len(_ORDINALS):
        return _ORDINALS[number]
    place = number + 1
    ending = {1: "st", 2: "nd", 3: "rd"}.get(place % 10, "th") if place % 100 not in (11, 12, 13) else "th"
    return f"{place}{ending}"


def folder_name(name: object) -> str:
    """Take a name that outputs, and the folder that they lie in, are called by.

    Raises:
        InputError: it is no text, or none that a folder can have; the caller knows the key.
    """
    if not isinstance(name, str) or not name.strip(" .") or re.search(r"[/\\]", name) or _NO_LETTER.search(name):
        raise InputError(f"need a name that a folder can have, without slashes, got {as_written(name)}")
    return name


def shown_name(name: str) -> str:
    """Take a name that figures and tables show.

    Raises:
        InputError: it holds what is no letter; the caller knows the key.
    """
    if not name.strip() or _NO_LETTER.search(name):
        raise InputError(f"need a name on one line, without control characters, got {as_written(name)}")
    return name
