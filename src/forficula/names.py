"""Checks of names, and phrases for sentences and error messages."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable, Mapping, Sequence

from forficula.errors import InputError
from forficula.quantities import as_written, is_whole

# control characters, and lone surrogates, which no file can contain
_NO_LETTER = re.compile(r"[\x00-\x1f\x7f-\x9f\ud800-\udfff]")
_NOT_IN_FOLDERS = re.compile(r'[/\\<>:"|?*]')
# names of devices on Windows, with any ending (Microsoft, "Naming Files, Paths, and Namespaces")
_DEVICE = re.compile(r"(con|prn|aux|nul|com[0-9¹²³]|lpt[0-9¹²³])(\..*)?", re.IGNORECASE)

_ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth")


def ordinal(number: int) -> str:
    """Return the ordinal of an index that counts from 0: 0 is "first", 10 is "11th"."""
    if number < len(_ORDINALS):
        return _ORDINALS[number]
    place = number + 1
    ending = {1: "st", 2: "nd", 3: "rd"}.get(place % 10, "th") if place % 100 not in (11, 12, 13) else "th"
    return f"{place}{ending}"


def listed(words: Iterable[str], last: str = "and") -> str:
    """Join words for a sentence, such as "a, b and c", or "a, b or c" with another conjunction; "" without words."""
    *most, end = [*words] or [""]
    return f"{', '.join(most)} {last} {end}" if most else end


def counted(number: int, what: str) -> str:
    """Return a number with a noun, such as "1 run" or "2 runs"."""
    return f"{number} {what}" if number == 1 else f"{number} {what}s"


def unknown_key(key: str, value: object, hint: str) -> str:
    """Return the error message for an unknown key, with its value and a hint.

    Example:
        >>> unknown_key("tendon.stifness", "20 N/cm", "did you mean tendon.stiffness?")
        'tendon.stifness: unknown key, got "20 N/cm"; did you mean tendon.stiffness?'
    """
    got = "" if value is None else f", got {as_written(value)}"
    return f"{key}: unknown key{got}; {hint}"


def check_known(table: Mapping[str, object], names: Sequence[str], prefix: str) -> None:
    """Refuse unknown keys of a table.

    Args:
        table: the table.
        names: allowed keys.
        prefix: text before a key in error messages, such as "search.".

    Raises:
        InputError: an unknown key; the message names the nearest one.
    """
    for key, value in table.items():
        if key not in names:
            near = difflib.get_close_matches(key.lower(), names, n=1)
            hint = f"did you mean {prefix}{near[0]}?" if near else f"allowed here: {', '.join(names)}"
            shown = key if re.fullmatch(r"[\w-]+", key) else as_written(key)
            raise InputError(unknown_key(f"{prefix}{shown}", value, hint))


def check_whole(key: str, value: object, least: int) -> int:
    """Return a whole number that is not below a bound.

    Args:
        key: key in error messages.
        value: value from the user.
        least: least allowed value.

    Raises:
        InputError: the value is not a whole number, or below the bound.
    """
    if not is_whole(value, least):
        raise InputError(f"{key}: need a whole number >= {least}, got {as_written(value)}")
    return value


def one_of(names: Iterable[str], got: object, others: Iterable[str] = (), near_to: Iterable[str] = ()) -> str:
    """Return the end of an error message: the allowed names in quotes, other allowed values, and the nearest name.

    Args:
        names: allowed names.
        got: value from the user.
        others: descriptions of other allowed values.
        near_to: further names that may be the nearest one.
    """
    names = list(names)
    allowed = listed([*(f'"{name}"' for name in names), *others], "or")
    return f"{allowed}, got {as_written(got)}{near_name(str(got), [*names, *near_to])}"


def near_name(got: str, names: Iterable[str]) -> str:
    """Return the end of an error message that suggests the nearest of some names; "" if none is near."""
    near = difflib.get_close_matches(got, list(names), n=1)
    return f'; did you mean "{near[0]}"?' if near else ""


def folder_name(name: object) -> str:
    """Return a name for outputs and their folder, if it is valid.

    A folder may be copied to another system, so names that Windows cannot have are refused everywhere.

    Raises:
        InputError: the name is not text, or not a valid name of a folder; the caller adds the key.
    """
    if not isinstance(name, str) or not name.strip(" .") or _NOT_IN_FOLDERS.search(name) or _NO_LETTER.search(name):
        raise InputError(
            'need a name that a folder can have on every system, without any of / \\ < > : " | ? *, got '
            + as_written(name)
        )
    if name != name.rstrip(" .") or is_device_name(name):
        raise InputError(
            "need a name that a folder can have on every system: Windows refuses device names such as aux and nul, and"
            f" a dot or space at the end; got {as_written(name)}"
        )
    return name


def is_device_name(name: str) -> bool:
    """Return whether Windows takes a name, with any ending, for a device, so that no file or folder can have it."""
    return _DEVICE.fullmatch(name) is not None


def shown_name(name: str) -> str:
    """Return a name for figures and tables, if it is valid.

    Raises:
        InputError: the name is empty or has control characters; the caller adds the key.
    """
    if not name.strip() or _NO_LETTER.search(name):
        raise InputError(f"need a name on one line, without control characters, got {as_written(name)}")
    return name


def one_line(text: str) -> str:
    """Return a text on one line, without characters that a terminal would interpret."""
    return " ".join("".join(letter if letter.isprintable() else " " for letter in text).split())
