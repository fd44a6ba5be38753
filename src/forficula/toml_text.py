"""Reading of TOML text, with errors that name the line and the key, and writing with remarks."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from typing import Any

from forficula.errors import InputError
from forficula.quantities import as_written

MOST_LEVELS = 32  # largest number of parts of a key; keys of forficula have at most six
_LONG_LINE = 2000
_KEY_START = re.compile(r"[\s\[]*[\w.\s\"'-]*")
_LINE = re.compile(r"\(at line (\d+), ")
_KEY = re.compile(r"\s*((?:[\w-]+|\"[^\"]*\"|'[^']*')(?:\s*\.\s*(?:[\w-]+|\"[^\"]*\"|'[^']*'))*)\s*=")
_HEADER = re.compile(r"\s*(\[\[?)\s*([^\[\]]+?)\s*\]\]?\s*(?:#.*)?")
_TABLE_TWICE = re.compile(r"Cannot declare \((.*?),?\) twice")


def parse_toml(text: str, what: str) -> dict[str, Any]:
    """Read the tables of a TOML text.

    Args:
        text: TOML text.
        what: description of the content, such as "a design", for error messages.

    Raises:
        InputError: the text is not TOML, or a key has too many parts; the caller adds the name of the file.
    """
    for number, line in enumerate(text.splitlines(), 1):
        # tomllib needs seconds and gigabytes for a key with ten thousand parts
        if len(line) > _LONG_LINE and (start := _KEY_START.match(line)) and start[0].count(".") > _LONG_LINE // 2:
            raise InputError(f"line {number}: need a key of at most {MOST_LEVELS} parts, got {as_written(start[0])}")
    try:
        tables = tomllib.loads(text)
        check_levels(tables)
        return tables
    except tomllib.TOMLDecodeError as error:
        reason = _table_and_list(text, str(error)) or f"{error}{_given_twice(text, str(error))}"
        raise InputError(f"not TOML: {reason}") from None
    except InputError:
        raise
    except ValueError:  # Python refuses to convert numbers with thousands of digits
        raise InputError("not TOML: a whole number has too many digits") from None
    except RecursionError:
        raise InputError(f"not TOML for {what}: nested too deeply") from None


def check_levels(tables: Mapping[str, object]) -> None:
    """Refuse tables and lists that are nested more deeply than `MOST_LEVELS`.

    Args:
        tables: tables by key; keys may be dotted.

    Raises:
        InputError: a key with too many parts.
    """
    within: list[tuple[str, int, object]] = [("", 0, tables)]
    while within:
        key, levels, value = within.pop()
        if levels > MOST_LEVELS:
            raise InputError(f"{as_written(key)}: need a key of at most {MOST_LEVELS} parts; it is nested more deeply")
        if isinstance(value, Mapping):
            within += [(key or str(part), levels + str(part).count(".") + 1, inner) for part, inner in value.items()]
        elif isinstance(value, list | tuple):
            within += [(key, levels + 1, entry) for entry in value if isinstance(entry, Mapping | list | tuple)]


def with_remarks(text: str, remarks: Mapping[str, str]) -> str:
    """Append remarks to the lines of values in a TOML text; values over several lines get none.

    Args:
        text: TOML text with sections under headers, as tomli_w writes it.
        remarks: remarks by the dotted key of the value.
    """
    lines, section = [], ""
    for line in text.splitlines():
        if header := _HEADER.fullmatch(line):
            section = f"{header[2]}."
        key = _KEY.match(line)
        remark = remarks.get(f"{section}{key[1]}") if key else None
        lines.append(f"{line}  # {remark}" if remark else line)
    return "\n".join(lines) + "\n"


def _table_and_list(text: str, reason: str) -> str:
    """Return the message for a section that is both a table and a list of tables; "" for other errors."""
    line = _LINE.search(reason)
    if line is None:
        return ""
    *headers, last = (_HEADER.fullmatch(above) for above in text.splitlines()[: int(line[1])])
    for above in headers:
        if above and last and above[1] != last[1] and f"{above[2]}.".startswith(f"{last[2]}."):
            table, tables = sorted((above, last), key=lambda header: header[1])
            return f"[{table[2]}] and [[{tables[2]}]] in one file (at line {line[1]}): use one of the two"
    return ""


def _given_twice(text: str, reason: str) -> str:
    """Return the name of a key or a table that is given twice; "" for other errors."""
    if table := _TABLE_TWICE.search(reason):
        return f"; the table [{table[1].replace(', ', '.').replace(chr(39), '')}] is given twice"
    line = _LINE.search(reason)
    if line is None or not reason.startswith(("Cannot overwrite a value", "Cannot mutate immutable")):
        return ""
    # the line of the error has a header, or the end of a value that may begin on a line above
    above = text.splitlines()[: int(line[1])][::-1]
    if header := _HEADER.fullmatch(above[0]):
        return f"; the key {header[2]} is given twice"
    key = next((match[1] for previous in above if (match := _KEY.match(previous))), None)
    return f"; the key {key} is given twice" if key else ""
