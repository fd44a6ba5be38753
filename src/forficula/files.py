"""Files written whole or not at all, and TOML files read."""

from __future__ import annotations

import io
import os
import re
import secrets
import shutil
import stat
import tempfile
from collections.abc import Collection, Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import IO, Any

from forficula.allowed_files import check_may_read
from forficula.errors import InputError, error_prefix
from forficula.lock import held
from forficula.quantities import as_written
from forficula.toml_text import parse_toml

# How files come to lie in a folder, so that whoever is killed, wherever, leaves the old ones or the new ones, and
# nothing that stays for ever:
# - What is unfinished lies in the folder itself, for what is beside it may be on another disk, or not ours to write to,
#   and what is in use, mounted or the current folder cannot be renamed. Its name begins with a mark of its writer, and
#   the writer holds a lock of that name: what nobody holds is a dead writer's, and the next writer clears it away.
# - One file takes its place by one renaming. Several do so one after another, by one writer at a time; each file that
#   was there is set aside first, and a file "undo" says so until all are in place. Where that fails, or was broken off
#   by a kill, what was set aside goes back: the files that were there stand as they stood. Files of other names are
#   never touched.
_MARK = re.compile(r"(\.forficula-[0-9a-f]{12})(\.lock|-.*)")
_TURN = ".forficula.lock"

LARGEST_FILE = 2**26  # bytes: a FOLD file of a thousand frames of a thousand vertices each has this size
_PIECE = 2**20
_HANDED_OVER = re.compile(r"/dev/stdin|(?:/dev|/proc/self)/fd/[0-9]+")

AnyPath = str | os.PathLike[str]


class _UnwrittenError(InputError):
    """A file that cannot be written, and why."""

    def __init__(self, path: Path, reason: str) -> None:
        super().__init__(f"{path}: cannot be written: {reason}")
        self.path, self.reason = path, reason


def as_path(path: object, what: str) -> Path:
    """Take a path.

    Args:
        path: text, or a path.
        what: is wanted there, as errors say it.

    Raises:
        InputError: it is none.
    """
    if not isinstance(path, str | os.PathLike):
        raise InputError(f"need {what}, got {as_written(path)} ({type(path).__name__})")
    return Path(path)


@contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """Give a temporary name in the same folder, and put the file in place when the block ends well.

    Args:
        path: the file to write; its folder is made where it is missing. A link there is replaced, not followed.

    Raises:
        InputError: the folder or the file cannot be written.
    """
    _check_name(path)
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except FileExistsError:
        raise _UnwrittenError(path, f"{path.parent} is a file, not a folder") from None
    except OSError as error:
        raise _UnwrittenError(path, str(error.strerror)) from None
    temporary = path
    try:
        with _writing(path.parent) as mark:
            # writers go by the ending
            temporary = mark.with_name(f"{mark.name}-file{path.suffix}")
            try:
                temporary.touch(exist_ok=False)
                yield temporary
                temporary.replace(path)
            finally:
                temporary.unlink(missing_ok=True)
    except OSError as error:
        # HDF5 gives its reason as text only, with the name that it was given
        raise _UnwrittenError(path, error.strerror or str(error).replace(str(temporary), str(path))) from None


@contextmanager
def replacing_all(folder: Path, remove: Collection[str] = ()) -> Iterator[Path]:
    """Give a temporary folder, and put its files into a folder when the block ends well: all of them, or none.

    Args:
        folder: made where it is missing; files of the same names are replaced, others stay.
        remove: names of files that go, where they are there and are not replaced.

    Raises:
        InputError: the folder or a file in it cannot be written; what was there stands as it stood.
    """
    _check_name(folder)
    missing, new = _missing(folder), folder
    try:
        folder.mkdir(parents=True, exist_ok=True)
        with _writing(folder) as mark:
            work = mark.with_name(f"{mark.name}-work")
            new = work / "new"
            try:
                new.mkdir(parents=True)
                yield new
                with held(folder / _TURN):
                    _clear(folder)
                    _exchange(folder, work, remove)
            finally:
                if not (work / "undo").exists():
                    shutil.rmtree(work, ignore_errors=True)
    # what is full or refuses is told of the files as they would be called
    except _UnwrittenError as error:
        raise _UnwrittenError(_in_place(error.path, new, folder) or error.path, error.reason) from None
    except OSError as error:
        place = _in_place(Path(error.filename or folder), new, folder) or folder
        raise _UnwrittenError(place, str(error.strerror or error)) from None
    finally:
        for place in missing:
            with suppress(OSError):  # it holds files
                place.rmdir()


def _check_name(path: Path) -> None:
    """Refuse a path that no file can have."""
    try:
        if "\0" not in os.fsencode(path).decode("latin-1"):
            return
        reason = "its name holds a null byte"
    except UnicodeEncodeError:
        reason = "its name holds a lone surrogate"
    raise InputError(f"{as_written(str(path))}: cannot be written: {reason}")


def _in_place(path: Path, new: Path, folder: Path) -> Path | None:
    """Where a file among the new ones of a folder would come to lie; None of what is none of them."""
    if path.name == _TURN or _MARK.fullmatch(path.name):
        return None
    return folder / path.relative_to(new) if path.is_relative_to(new) else None


def _missing(folder: Path) -> list[Path]:
    """The folders that are to be made, innermost first."""
    return [place for place in (folder, *folder.parents) if not place.exists()]


def check_writable(folder: Path) -> None:
    """Refuse a folder to which nothing can be written, or that cannot be made; nothing stays there.

    Tried beside it, under a name of our own: another process may be making the folder.

    Raises:
        InputError: it cannot, and why.
    """
    try:
        there = next(place for place in (folder, *folder.parents, Path()) if place.is_dir())
        probe = Path(tempfile.mkdtemp(prefix=".forficula-probe-", dir=there))
        try:
            (probe / folder.relative_to(there) / "report.html").parent.mkdir(parents=True, exist_ok=True)
        finally:
            shutil.rmtree(probe, ignore_errors=True)
    except OSError as error:
        raise _UnwrittenError(folder, str(error.strerror or error)) from None
    except ValueError as error:  # a null byte
        raise InputError(f"{as_written(str(folder))}: cannot be written: {error}") from None


def clear_leftovers(folder: Path) -> None:
    """Clear away what writers that were killed left in a folder, and put files back that they had set aside.

    What a living process is writing stays, and so does all that is not ours. Where nothing can be written, nothing is.
    """
    with suppress(OSError):
        if _marks(folder) or os.path.lexists(folder / _TURN):
            with held(folder / _TURN):
                _clear(folder)


@contextmanager
def _writing(folder: Path) -> Iterator[Path]:
    """Give what the names of one writer's unfinished files begin with."""
    clear_leftovers(folder)
    mark = folder / f".forficula-{secrets.token_hex(6)}"
    with held(_lock(mark)):
        yield mark


def _lock(mark: Path) -> Path:
    return mark.with_name(f"{mark.name}.lock")


def _marks(folder: Path) -> list[Path]:
    """The marks of all writers that are at work in a folder or died there."""
    found = (_MARK.fullmatch(place.name) for place in folder.iterdir())
    return [folder / name for name in sorted({each[1] for each in found if each})]


def _clear(folder: Path) -> None:
    """Remove what dead writers left; it is our turn."""
    for mark in _marks(folder):
        with held(_lock(mark), wait=False) as dead:
            if not dead:
                continue
            work = mark.with_name(f"{mark.name}-work")
            _undo(folder, work)
            shutil.rmtree(work, ignore_errors=True)
            for file in folder.glob(f"{mark.name}-file*"):
                file.unlink()


def _exchange(folder: Path, work: Path, remove: Collection[str]) -> None:
    """Put the new files in place, all of them or none; it is our turn."""
    new, old, nothing, undo = (work / name for name in ("new", "old", "nothing", "undo"))
    places = _files(new)
    for place in places:
        if (folder / place).is_dir():
            raise InputError(f"{folder / place}: need a file or nothing there, got a folder")
        if (folder / place.parent).is_file():
            raise InputError(f"{folder / place.parent}: need a folder or nothing there, got a file")
        if not os.path.lexists(folder / place):
            (nothing / place).parent.mkdir(parents=True, exist_ok=True)
            (nothing / place).touch()
    undo.touch()
    place = Path()
    try:
        for place in dict.fromkeys([*places, *map(Path, remove)]):
            if os.path.lexists(folder / place):
                (old / place).parent.mkdir(parents=True, exist_ok=True)
                (folder / place).replace(old / place)
            if place in places:
                (folder / place).parent.mkdir(exist_ok=True)
                (new / place).replace(folder / place)
        undo.unlink()
    except BaseException as error:
        try:
            _undo(folder, work)
        except OSError:
            why = "; what was there is set aside, and the next run puts it back"
        else:
            why = "; what was there stands as it stood"
        if isinstance(error, OSError):
            raise InputError(f"{folder / place}: cannot be replaced: {error.strerror}{why}") from None
        raise


def _undo(folder: Path, work: Path) -> None:
    """Put back what was set aside, where not all files took their places; broken off, it can be done again."""
    new, old, nothing, undo = (work / name for name in ("new", "old", "nothing", "undo"))
    if not undo.exists():
        return
    for place in _files(nothing):
        if not (new / place).exists():
            (folder / place).unlink(missing_ok=True)
        if place.parent != Path():
            with suppress(OSError):  # other files are there
                (folder / place).parent.rmdir()
    for place in _files(old):
        (old / place).replace(folder / place)
    undo.unlink()


def _files(folder: Path) -> list[Path]:
    """Where the files in a folder lie within it; links are files, too."""
    return sorted(Path(top, name).relative_to(folder) for top, _, names in os.walk(folder) for name in names)


def check_new(path: Path, ending: str) -> None:
    """Refuse a path at which no new file of a kind can be written.

    Raises:
        InputError: its name has another ending, something is there, or it is no path.
    """
    if path.suffix != ending:
        raise InputError(f"{path}: need a name that ends with {ending}")
    try:
        exists = path.exists()
    except OSError as error:
        raise InputError(f"{path}: cannot be written: {error.strerror}") from None
    if exists:
        raise InputError(f"{path}: exists already; choose another name or remove it")


def open_to_append(path: Path) -> IO[bytes]:
    """Open a file to which lines are added; it is made where it is missing.

    Raises:
        InputError: it cannot be written, or is a link, which is not followed: someone else may have planted it.
    """
    if path.is_symlink():
        raise InputError(f"{path}: need a file or nothing there, got a link to {path.readlink()}; remove it")
    flags = os.O_WRONLY | os.O_APPEND | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0)
    try:
        return os.fdopen(os.open(path, flags, 0o666), "ab")
    except OSError as error:
        raise InputError(f"{path}: cannot be written: {error.strerror}") from None


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


def read_bytes(path: Path, largest: float = LARGEST_FILE) -> bytes:
    """Read a regular file that someone wrote.

    A pipe or a device is refused, because it may never end. An exception is what a shell hands over as /dev/stdin or
    /dev/fd/63 (process substitution).

    Args:
        path: of the file.
        largest: number of bytes that it may have.

    Raises:
        InputError: no such file, it cannot be read, is no regular file, or is larger; the caller names the file.
    """
    handed_over = _HANDED_OVER.fullmatch(str(path)) is not None
    # to open a named pipe would otherwise wait for someone who writes to it
    more = 0 if handed_over else getattr(os, "O_NONBLOCK", 0)
    content = bytearray()
    try:
        with io.FileIO(path, opener=lambda name, flags: os.open(name, flags | more)) as file:
            status = os.fstat(file.fileno())
            if not (stat.S_ISREG(status.st_mode) or handed_over):
                raise InputError(f"need a regular file, got {_kind_of(status.st_mode)}")
            # the size of a pipe and of some regular files is unknown: read piece by piece
            while status.st_size <= largest and len(content) <= largest and (piece := file.read(_PIECE)):
                content += piece
    except InputError:
        raise
    except FileNotFoundError:
        raise InputError("no such file") from None
    except OSError as error:
        raise InputError(f"cannot be read: {error.strerror}") from None
    except UnicodeEncodeError:
        raise InputError("cannot be read: its name holds a lone surrogate") from None
    except ValueError as error:  # a null byte
        raise InputError(f"cannot be read: {error}") from None
    if max(status.st_size, len(content)) > largest:
        raise InputError(f"need a file of at most {largest / 2**20:g} MiB, got a larger one")
    return bytes(content)


def _kind_of(mode: int) -> str:
    return "a named pipe" if stat.S_ISFIFO(mode) else "a socket" if stat.S_ISSOCK(mode) else "a device"


def read_text(path: Path) -> str:
    """Read a text that someone wrote.

    Args:
        path: of the file, UTF-8.

    Raises:
        InputError: what `read_bytes` raises, it may not be read, or it is not UTF-8; the message names the file.
    """
    check_may_read(path)
    try:
        # Windows' editors begin UTF-8 with a byte order mark
        text = read_bytes(path).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise InputError(f"{path}: not UTF-8 text from byte {error.start} on; save it as UTF-8") from None
    except InputError as error:
        raise InputError(f"{shown_path(path)}: {error}") from None
    return text.replace("\r\n", "\n").replace("\r", "\n")


def shown_path(path: Path) -> str:
    """Write a path for an error: in quotes where it holds what no line of text can show."""
    return str(path) if str(path).isprintable() else as_written(str(path))


def read_toml(path: Path, what: str) -> dict[str, Any]:
    """Read the tables of a TOML file.

    Args:
        path: of the file.
        what: it should describe, such as "a design".

    Raises:
        InputError: no such file, it cannot be read, or it is not UTF-8 or not TOML.
    """
    text = read_text(path)
    with error_prefix(f"{path}: "):
        return parse_toml(text, what)
