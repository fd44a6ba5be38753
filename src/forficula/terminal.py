"""What the command line writes to, and how much: letters that it lacks spelled, warnings on one line, data or words."""

from __future__ import annotations

import codecs
import io
import json
import os
import sys
import unicodedata
import warnings
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stdout, suppress
from contextvars import ContextVar
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TextIO

# letters of ours, and units above all, that must not turn into another one
_SPELLED = {
    **{"µ": "u", "μ": "u", "°": " deg", "·": "*", "×": "x", "²": "^2", "³": "^3", "⁴": "^4", "±": "+-", "∞": "inf"},
    **{"−": "-", "–": "-", "—": "-", "…": "...", "≤": "<=", "≥": ">=", "≈": "~", "→": "->", "“": '"', "”": '"'},
    **{"‘": "'", "’": "'", "█": "#", "━": "-", "╸": "-", "╺": "-"},
}
_HANDLER = "forficula-spelled"


@dataclass(kw_only=True)
class _Manner:
    """How a command speaks: whether of what it is doing, and what it came to, as plain data, once it has said so."""

    quiet: bool = False
    data: Any = None


_manner: ContextVar[_Manner] = ContextVar("manner", default=_Manner())  # noqa: B039


@contextmanager
def speaking(*, quiet: bool, as_json: bool) -> Iterator[None]:
    """Let a command write its words, nothing but warnings, or what it came to as JSON and nothing else.

    Args:
        quiet: leave out what is no warning and no error.
        as_json: on standard output write only what the command hands to `came_to`.
    """
    before = _manner.set(manner := _Manner(quiet=quiet))
    try:
        if not (quiet or as_json):
            yield
            return
        with redirect_stdout(io.StringIO()):
            yield
    finally:
        _manner.reset(before)
    if as_json:
        print(json.dumps(manner.data, indent=2, ensure_ascii=False, allow_nan=False))


def came_to(data: Any) -> None:
    """Say what a command came to: plain data, or the path of a JSON file that it wrote."""
    _manner.get().data = json.loads(data.read_text("utf-8")) if isinstance(data, Path) else data


def is_quiet() -> bool:
    """Whether nothing but warnings and errors is wanted."""
    return _manner.get().quiet


def remark(text: str) -> None:
    """Write what is no result and no warning, beside the results."""
    if not is_quiet():
        print(text, file=sys.stderr)


@contextmanager
def plain_terminal() -> Iterator[None]:
    """Write letters that an output's encoding lacks as others, and warnings of libraries as one line each."""
    codecs.register_error(_HANDLER, _spelled)
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors=_HANDLER)
    told: set[tuple[type[Warning], str]] = set()

    def on_one_line(
        message: Warning | str,
        category: type[Warning],
        filename: str,  # noqa: ARG001
        lineno: int,  # noqa: ARG001
        file: TextIO | None = None,  # noqa: ARG001
        line: str | None = None,  # noqa: ARG001
    ) -> None:
        text = " ".join(str(message).split())
        # of arithmetic beyond what numbers hold: the verdict says that a run diverged, or the residual that it is off
        if issubclass(category, RuntimeWarning) and "encountered in" in text:
            return
        # a library may say the same of every letter or number
        if (category, text.partition(" ")[0]) not in told:
            told.add((category, text.partition(" ")[0]))
            print(f"warning: {text}", file=sys.stderr)

    with warnings.catch_warnings():
        warnings.showwarning = on_one_line
        yield


def flush_output() -> None:
    """Write what is left of the output; raise OSError where it has no room, and nothing more of it later on."""
    if sys.stdout is not None and not sys.stdout.closed:
        sys.stdout.flush()


def drop_output() -> None:
    """Leave what cannot be written, of which Python would complain once more when it closes the output."""
    with suppress(OSError, ValueError, AttributeError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _spelled(error: UnicodeError) -> tuple[str, int]:
    """Spell the letters that an encoding lacks."""
    if not isinstance(error, UnicodeEncodeError):
        raise error
    return "".join(_letter(letter) for letter in error.object[error.start : error.end]), error.end


def _letter(letter: str) -> str:
    if letter in _SPELLED:
        return _SPELLED[letter]
    plain = unicodedata.normalize("NFKD", letter).encode("ascii", "ignore").decode()
    return plain or "?"
