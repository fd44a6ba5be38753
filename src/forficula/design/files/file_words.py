"""Words for the kinds of TOML files, and a check that a file is of the expected kind."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from forficula.errors import InputError

# for each kind of file: keys that only this kind has, and the command that reads the file; a file has one of the keys
_TYPICAL_KEYS = {
    "design": (("pattern", "based_on"), "run"),
    "study": (("factors", "change"), "study"),
    "goal": (("objectives",), "optimise"),
    "observations file": (("fact",), "identify"),
    "clicks file": (("ring", "frame"), "trace"),
}


def check_file_kind(tables: Mapping[str, Any], word: str) -> None:
    """Refuse a file of another kind, and name the command that reads it.

    Args:
        tables: content of the file.
        word: expected kind.

    Raises:
        InputError: the file has keys of another kind, and none of the expected one.
    """
    if any(key in tables for key in _TYPICAL_KEYS[word][0]):
        return
    for other, (keys, command) in _TYPICAL_KEYS.items():
        if present := [key for key in keys if key in tables]:
            raise InputError(
                f"need {with_article(word)}, got {with_article(other)}, because it has {present[0]}; give it to"
                f" forficula {command}"
            )


def with_article(what: str) -> str:
    """Return a noun with its indefinite article."""
    return f"{'an' if what[0] in 'aeiou' else 'a'} {what}"
