"""Measured blocks in the source of pages (see measured.py), for tests, which run without Sphinx."""

from __future__ import annotations

import re
from dataclasses import dataclass

# Versions that compute the same runs as an earlier one: the runs of all named designs and of the study
# binder2025-search were compared bit for bit. Searches of `optimise` are not among them.
SAME_RUNS = {"1.0.0rc1": "0.1.0"}
_BLOCK = re.compile(
    r"^:::\{measured\} (?P<command>[^\n]+)\n(?P<options>(?::[a-z]+:[^\n]*\n)*)(?P<text>.*?)^:::$", re.M | re.S
)
_OPTION = re.compile(r"^:([a-z]+):[ ]*(.*)$", re.M)


@dataclass(frozen=True, kw_only=True)
class Measured:
    """Measured block of a page: its text, and the command, the version and the time that produced it."""

    text: str
    command: str
    version: str
    took: str


def measured_in(page: str) -> list[Measured]:
    """Return the measured blocks in the source of a page."""
    return [
        Measured(
            text=match["text"],
            command=match["command"],
            version=options.get("version", ""),
            took=options.get("took", ""),
        )
        for match in _BLOCK.finditer(page)
        for options in [dict(_OPTION.findall(match["options"]))]
    ]


def not_measured(page: str) -> str:
    """Return the source of a page without its measured blocks."""
    return _BLOCK.sub("", page)
