"""Names that a user gives to things, and how sentences list them."""

from __future__ import annotations

import difflib
import re
from collections.abc import Iterable, Mapping, Sequence

from forficula.errors import InputError
from forficula.quantities import as_written, is_whole

# what moves a terminal's cursor or ends a line, and halves of characters that no file can hold
_NO_LETTER = re.compile(r"[\x00-\x1f\x7f-\x9f\ud800-\udfff]")
_NOT_IN_FOLDERS = re.compile(r'[/\\<>:"|?*]')
# names of devices on Windows, with any ending (Microsoft, "Naming Files, Paths, and Namespaces")
_DEVICE = re.compile(r"(con|prn|aux|nul|com[0-9¹²³]|lpt[0-9¹²³])(\..*)?", re.IGNORECASE)

_ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth")


def ordinal(number: int) -> str:
    """The place of a number that counts from 0, in words: 0 is "first"; beyond the tenth in digits, as "11th"."""
    if number < len(_ORDINALS):
        return _ORDINALS[number]
    place = number + 1
    ending = {1: "st", 2: "nd", 3: "rd"}.get(place % 10, "th") if place % 100 not in (11, 12, 13) else "th"
    return f"{place}{ending}"


def listed(words: Iterable[str], last: str = "and") -> str:
    """Words as a sentence has them, such as "a, b and c", or "a, b or c" with another last word; "" of none."""
    *most, end = [*words] or [""]
    return f"{', '.join(most)} {last} {end}" if most else end


def counted(number: int, what: str) -> str:
    """A number of something, such as "1 run" or "2 runs"."""
    return f"{number} {what}" if number == 1 else f"{number} {what}s"


def unknown_key(key: str, value: object, hint: str) -> str:
    """What errors say of a key that is none: it, the value that it was given, and what is allowed or near.

    Example:
        >>> unknown_key("tendon.stifness", "20 N/cm", "did you mean tendon.stiffness?")
        'tendon.stifness: unknown key, got "20 N/cm"; did you mean tendon.stiffness?'
    """
    got = "" if value is None else f", got {as_written(value)}"  # of a key alone there is none
    return f"{key}: unknown key{got}; {hint}"


def check_known(given: Mapping[str, object], names: Sequence[str], prefix: str) -> None:
    """Refuse keys of a table other than some names.

    Args:
        given: the table.
        names: that its keys may be.
        prefix: what is before a key in errors, such as "search.".

    Raises:
        InputError: which key is unknown, and which is near.
    """
    for key, value in given.items():
        if key not in names:
            near = difflib.get_close_matches(key.lower(), names, n=1)
            hint = f"did you mean {prefix}{near[0]}?" if near else f"allowed here: {', '.join(names)}"
            shown = key if re.fullmatch(r"[\w-]+", key) else as_written(key)
            raise InputError(unknown_key(f"{prefix}{shown}", value, hint))


def check_whole(key: str, value: object, least: int) -> int:
    """Return a whole number that is not below a bound.

    Args:
        key: by which errors call it.
        value: as given.
        least: allowed.

    Raises:
        InputError: the value is no whole number, or below the bound.
    """
    if not is_whole(value, least):
        raise InputError(f"{key}: need a whole number >= {least}, got {as_written(value)}")
    return value


def one_of(names: Iterable[str], got: object, others: Iterable[str] = (), near_to: Iterable[str] = ()) -> str:
    """What is allowed, names in quotes before what else is, and which of the names, or of some more, is near."""
    names = list(names)
    allowed = listed([*(f'"{name}"' for name in names), *others], "or")
    return f"{allowed}, got {as_written(got)}{near_name(str(got), [*names, *near_to])}"


def near_name(got: str, names: Iterable[str]) -> str:
    """The end of a sentence that asks for the nearest of some names; "" where none is near."""
    near = difflib.get_close_matches(got, list(names), n=1)
    return f'; did you mean "{near[0]}"?' if near else ""


def folder_name(name: object) -> str:
    """Return a name of outputs and of their folder, checked.

    A folder may be copied to another system, so names that Windows cannot have are refused everywhere.

    Raises:
        InputError: it is no text, or none that a folder can have; the caller knows the key.
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
    """Take a name that figures and tables show.

    Raises:
        InputError: it holds what is no letter; the caller knows the key.
    """
    if not name.strip() or _NO_LETTER.search(name):
        raise InputError(f"need a name on one line, without control characters, got {as_written(name)}")
    return name


def one_line(text: str) -> str:
    """A text of someone else's file on one line, without what steers a terminal."""
    return " ".join("".join(letter if letter.isprintable() else " " for letter in text).split())
