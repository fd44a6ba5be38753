"""Files written whole or not at all, and TOML files read."""

from __future__ import annotations

import os
import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from forficula.errors import InputError
from forficula.quantities import as_written
from forficula.toml_text import parse_toml


@contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """Give a temporary name in the same folder, and put the file in place when the block ends well.

    Args:
        path: the file to write; its folder is made where it is missing.

    Raises:
        InputError: the folder or the file cannot be written.
    """
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except FileExistsError:
        raise InputError(f"{path}: cannot be written: {path.parent} is a file, not a folder") from None
    except OSError as error:
        raise InputError(f"{path}: cannot be written: {error.strerror}") from None
    try:
        handle, name = tempfile.mkstemp(dir=path.parent, prefix=f".{path.stem}-", suffix=path.suffix)
        os.close(handle)
    except OSError as error:
        raise InputError(f"{path}: cannot be written: {error.strerror}") from None
    temporary = Path(name)
    try:
        yield temporary
        temporary.chmod(0o666 & ~_umask())
        temporary.replace(path)
    except OSError as error:
        # HDF5 gives its reason as text only
        raise InputError(f"{path}: cannot be written: {error.strerror or error}") from None
    finally:
        temporary.unlink(missing_ok=True)


@contextmanager
def replacing_all(folder: Path) -> Iterator[Path]:
    """Give a temporary folder, and put its files into a folder when the block ends well: all of them, or none.

    Args:
        folder: made where it is missing; files of the same names are replaced, others stay.

    Raises:
        InputError: the folder or a file in it cannot be written.
    """
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        unfinished = Path(tempfile.mkdtemp(dir=folder.parent, prefix=f".{folder.name}-"))
    except OSError as error:
        raise InputError(f"{folder}: cannot be written: {error.strerror}") from None
    try:
        yield unfinished
        folder.mkdir(exist_ok=True)
        files = {file.relative_to(unfinished): file for file in sorted(unfinished.rglob("*")) if file.is_file()}
        for place in files:
            if (folder / place).is_dir():
                raise InputError(f"{folder / place}: need a file or nothing there, got a folder")
            if (folder / place.parent).is_file():
                raise InputError(f"{folder / place.parent}: need a folder or nothing there, got a file")
        for place, file in files.items():
            (folder / place).parent.mkdir(exist_ok=True)
            file.replace(folder / place)
    except OSError as error:
        raise InputError(f"{folder}: cannot be written: {error.strerror}") from None
    finally:
        shutil.rmtree(unfinished, ignore_errors=True)


def write_text(path: Path, text: str) -> None:
    """Write a text file whole or not at all.

    Raises:
        InputError: it cannot be written.
    """
    with replacing(path) as temporary:
        temporary.write_text(text, encoding="utf-8", newline="\n")


def write_bytes(path: Path, content: bytes | memoryview) -> None:
    """Write a file whole or not at all.

    Raises:
        InputError: it cannot be written.
    """
    with replacing(path) as temporary:
        temporary.write_bytes(content)


def _umask() -> int:
    mask = os.umask(0)
    os.umask(mask)
    return mask


def read_toml(path: Path, what: str) -> dict[str, Any]:
    """Read the tables of a TOML file.

    Args:
        path: of the file.
        what: it should describe, such as "a design".

    Raises:
        InputError: no such file, it cannot be read, or it is not UTF-8 or not TOML.
    """
    try:
        # Windows' editors begin UTF-8 with a byte order mark
        text = path.read_text("utf-8-sig")
    except FileNotFoundError:
        raise InputError(f"{path}: no such file") from None
    except OSError as error:
        raise InputError(f"{path}: cannot be read: {error.strerror}") from None
    except UnicodeDecodeError as error:
        raise InputError(f"{path}: not UTF-8 text from byte {error.start} on; save it as UTF-8") from None
    except ValueError as error:  # a null byte
        raise InputError(f"{as_written(str(path))}: cannot be read: {error}") from None
    try:
        return parse_toml(text, what)
    except InputError as error:
        raise InputError(f"{path}: {error}") from None
