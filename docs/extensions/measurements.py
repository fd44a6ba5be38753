"""What pages tell as measured (see measured.py), for tests, which have no Sphinx."""

from __future__ import annotations

import re
from dataclasses import dataclass

_BLOCK = re.compile(
    r"^:::\{measured\} (?P<command>[^\n]+)\n(?P<options>(?::[a-z]+:[^\n]*\n)*)(?P<text>.*?)^:::$", re.M | re.S
)
_OPTION = re.compile(r"^:([a-z]+):[ ]*(.*)$", re.M)


@dataclass(frozen=True, kw_only=True)
class Measured:
    """What a page tells as measured: its text, what command found it, with which version, and in what time."""

    text: str
    command: str
    version: str
    took: str


def measured_in(page: str) -> list[Measured]:
    """All that a page's source tells as measured."""
    return [
        Measured(
            text=found["text"],
            command=found["command"],
            version=options.get("version", ""),
            took=options.get("took", ""),
        )
        for found in _BLOCK.finditer(page)
        for options in [dict(_OPTION.findall(found["options"]))]
    ]


def not_measured(page: str) -> str:
    """A page's source without what it tells as measured."""
    return _BLOCK.sub("", page)
