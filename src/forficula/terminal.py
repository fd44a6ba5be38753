"""Output of the command line: text or JSON, warnings on one line, and letters that the encoding of a terminal lacks."""

from __future__ import annotations

import codecs
import io
import json
import os
import signal
import sys
import threading
import unicodedata
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager, redirect_stdout, suppress
from contextvars import ContextVar
from dataclasses import dataclass
from pathlib import Path
from textwrap import indent
from typing import Any, TextIO

# spellings of letters that the package writes; units above all must not turn into other units
_SPELLED = {
    **{"µ": "u", "μ": "u", "°": " deg", "·": "*", "×": "x", "²": "^2", "³": "^3", "⁴": "^4", "±": "+-", "∞": "inf"},
    **{"−": "-", "–": "-", "—": "-", "…": "...", "≤": "<=", "≥": ">=", "≈": "~", "→": "->", "“": '"', "”": '"'},
    **{"‘": "'", "’": "'", "█": "#", "━": "-", "╸": "-", "╺": "-"},
}
_HANDLER = "forficula-spelled"


@dataclass(kw_only=True)
class _Output:
    """Output of the command that is running.

    Attributes:
        quiet: whether to write warnings and errors only.
        data: result as plain data, which --json writes.
        last: line that ends the output; empty without one.
        held: messages on standard error that are held back until the result is written; None while none is held back.
    """

    quiet: bool = False
    data: Any = None
    last: str = ""
    held: list[str] | None = None


_output: ContextVar[_Output] = ContextVar("output", default=_Output())  # noqa: B039


@contextmanager
def command_output(*, quiet: bool, as_json: bool) -> Iterator[None]:
    """Let a command write text, warnings only, or its result as JSON.

    Args:
        quiet: whether to leave out all text except warnings and errors.
        as_json: whether to write only the data of `set_result` to standard output.
    """
    before = _output.set(output := _Output(quiet=quiet))
    try:
        if quiet or as_json:
            with redirect_stdout(io.StringIO()):
                yield
        else:
            yield
            if output.last:
                print(output.last)
    finally:
        _output.reset(before)
    if as_json:
        for text in _json_texts(output.data):
            print(text, end="")
        print()


def _json_texts(data: Any) -> Iterator[str]:
    """Yield parts of a result as JSON text; an iterator becomes a list."""
    if not isinstance(data, Iterator):
        yield _json_text(data)
        return
    first = True
    for item in data:
        yield "[\n" if first else ",\n"
        yield indent(_json_text(item), "  ")
        first = False
    yield "[]" if first else "\n]"


def _json_text(data: Any) -> str:
    return json.dumps(data, indent=2, ensure_ascii=False, allow_nan=False)


def set_result(data: Any) -> None:
    """Set the result that --json writes: plain data, an iterator over the items of a list, or the path of a JSON file.

    An iterator is only used if the result is written, and its items are written one after another.
    """
    _output.get().data = json.loads(data.read_text("utf-8")) if isinstance(data, Path) else data


def end_with(line: str) -> None:
    """Set the line that ends the output of a command."""
    _output.get().last = line


def is_quiet() -> bool:
    """Return whether only warnings and errors are written."""
    return _output.get().quiet


def note(text: str) -> None:
    """Write a line to standard error that is neither a result nor a warning."""
    if not is_quiet():
        _write_beside(text)


def warn(text: str) -> None:
    """Write a warning to standard error."""
    _write_beside(f"warning: {text}")


def _write_beside(text: str) -> None:
    held = _output.get().held
    if held is None:
        print(text, file=sys.stderr)
    else:
        held.append(text)


@contextmanager
def result_first() -> Iterator[Callable[[], None]]:
    """Hold back notes and warnings until the first line of the result is written.

    Yields:
        A function that writes them. They are also written at the end, and where an error ends the command.
    """
    output = _output.get()
    output.held = []

    def release() -> None:
        messages, output.held = output.held or [], None
        if messages and sys.stdout is not None and not sys.stdout.closed:
            sys.stdout.flush()
        for message in messages:
            print(message, file=sys.stderr)

    try:
        yield release
    except ValueError:
        # of a refused command (InputError) the error is the only line
        output.held = None
        raise
    finally:
        release()


class _UntilClosed(io.FileIO):
    """Output that discards all text after its reader, such as head, has closed the pipe."""

    def write(self, data: Any, /) -> int:
        """Write bytes to the output, or to nothing if no process reads the output."""
        try:
            return super().write(data)
        except BrokenPipeError:
            os.dup2(os.open(os.devnull, os.O_WRONLY), self.fileno())
            return len(data)


@contextmanager
def output_until_closed() -> Iterator[None]:
    """Let a command finish and write its files, even if the reader of its output has closed the output."""
    before = sys.stdout
    # the buffer is the file itself where Python writes without buffers (PYTHONUNBUFFERED)
    if not isinstance(before, io.TextIOWrapper) or not isinstance(before.buffer, io.BufferedWriter | io.FileIO):
        yield
        return
    before.flush()
    file = _UntilClosed(before.fileno(), "w", closefd=False)
    sys.stdout = io.TextIOWrapper(
        io.BufferedWriter(file) if isinstance(before.buffer, io.BufferedWriter) else file,
        encoding=before.encoding,
        errors=before.errors,
        line_buffering=before.line_buffering,
        write_through=before.write_through,
    )
    try:
        yield
    finally:
        # a failed write has been reported as an error
        with suppress(OSError):
            sys.stdout.flush()
        sys.stdout = before


@contextmanager
def ended_by_signal() -> Iterator[None]:
    """Let SIGTERM, which engines of clusters send before they kill a job, end the block as an exception does."""

    def end(number: int, frame: object) -> None:  # noqa: ARG001
        sys.exit(128 + number)

    if threading.current_thread() is not threading.main_thread():
        yield
        return
    before = signal.signal(signal.SIGTERM, end)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before)


@contextmanager
def plain_terminal() -> Iterator[None]:
    """Spell letters that the encoding of an output lacks, and write each warning of a library as one line."""
    codecs.register_error(_HANDLER, _spelled)
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors=_HANDLER)
    written: set[tuple[type[Warning], str]] = set()

    def on_one_line(
        message: Warning | str,
        category: type[Warning],
        filename: str,  # noqa: ARG001
        lineno: int,  # noqa: ARG001
        file: TextIO | None = None,  # noqa: ARG001
        line: str | None = None,  # noqa: ARG001
    ) -> None:
        text = " ".join(str(message).split())
        # overflow: the verdict reports that the run diverged, or the residual that its energies do not balance
        if issubclass(category, RuntimeWarning) and "encountered in" in text:
            return
        # a library may repeat a warning for every letter or number
        if (category, text.partition(" ")[0]) not in written:
            written.add((category, text.partition(" ")[0]))
            warn(text)

    with warnings.catch_warnings():
        warnings.showwarning = on_one_line
        yield


def flush_output() -> None:
    """Write the rest of the output; raises OSError where the device is full."""
    if sys.stdout is not None and not sys.stdout.closed:
        sys.stdout.flush()


def drop_output() -> None:
    """Discard output that cannot be written; Python would report it again when it closes the output."""
    with suppress(OSError, ValueError, AttributeError):
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _spelled(error: UnicodeError) -> tuple[str, int]:
    """Spell letters that an encoding lacks; an error handler of `codecs`."""
    if not isinstance(error, UnicodeEncodeError):
        raise error
    return "".join(_letter(letter) for letter in error.object[error.start : error.end]), error.end


def _letter(letter: str) -> str:
    if letter in _SPELLED:
        return _SPELLED[letter]
    plain = unicodedata.normalize("NFKD", letter).encode("ascii", "ignore").decode()
    return plain or "?"
