"""Writing of files completely or not at all, and reading of text and TOML files."""

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
from forficula.lock import hold_lock
from forficula.names import folder_name
from forficula.quantities import as_written
from forficula.toml_text import parse_toml

# How files are written, so that a process that is killed at any time leaves either the old or the new files, and no
# permanent leftovers:
# - Unfinished files are in the target folder itself. A folder beside it might be on another disk or not writable, and a
#   folder that is in use, mounted or the current one cannot be renamed. Their names begin with a mark of the writer,
#   and the writer holds a lock with this name. Files with a mark whose lock nobody holds were left by a killed process,
#   and the next writer removes them.
# - A single file is put in place by one renaming. Several files are renamed one after another, by one writer at a time;
#   existing files are moved aside first, and a file "undo" exists until all new files are in place. If this fails or
#   the process is killed, the old files are moved back. Files with other names are never touched.
_MARK = re.compile(r"(\.forficula-[0-9a-f]{12})(\.lock|-.*)")
_TURN = ".forficula.lock"

LARGEST_FILE = 2**26  # bytes: the size of a FOLD file with a thousand frames of a thousand vertices each
_PIECE = 2**20
_HANDED_OVER = re.compile(r"/dev/stdin|(?:/dev|/proc/self)/fd/[0-9]+")

AnyPath = str | os.PathLike[str]


class _UnwrittenError(InputError):
    """A file that cannot be written, with the reason."""

    def __init__(self, path: Path, reason: str) -> None:
        super().__init__(f"{path}: cannot be written: {reason}")
        self.path, self.reason = path, reason


def as_path(path: object, what: str) -> Path:
    """Convert text or a path to a `Path`.

    Args:
        path: text, or a path.
        what: description of the path for error messages.

    Raises:
        InputError: a value of another type.
    """
    if not isinstance(path, str | os.PathLike):
        raise InputError(f"need {what}, got {as_written(path)} ({type(path).__name__})")
    return Path(path)


@contextmanager
def replacing(path: Path) -> Iterator[Path]:
    """Yield a temporary name in the same folder, and put the file in place when the block ends without an error.

    Args:
        path: file to write; its folder is created if it is missing. An existing link is replaced, not followed.

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
            # libraries choose the format by the ending
            temporary = mark.with_name(f"{mark.name}-file{path.suffix}")
            try:
                temporary.touch(exist_ok=False)
                yield temporary
                temporary.replace(path)
            finally:
                temporary.unlink(missing_ok=True)
    except OSError as error:
        # HDF5 gives the reason only as text, which contains the temporary name
        raise _UnwrittenError(path, error.strerror or str(error).replace(str(temporary), str(path))) from None


@contextmanager
def replacing_all(folder: Path, remove: Collection[str] = ()) -> Iterator[Path]:
    """Yield a temporary folder, and move all its files, or none, into a folder when the block ends without an error.

    Args:
        folder: target folder, created if it is missing; files with the same names are replaced, others stay.
        remove: names of files to remove, if they exist and are not replaced.

    Raises:
        InputError: the folder or a file in it cannot be written; existing files are then unchanged.
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
                with hold_lock(folder / _TURN):
                    _clear(folder)
                    _exchange(folder, work, remove)
            finally:
                if not (work / "undo").exists():
                    shutil.rmtree(work, ignore_errors=True)
    # errors name the files at their final places
    except _UnwrittenError as error:
        raise _UnwrittenError(_in_place(error.path, new, folder) or error.path, error.reason) from None
    except OSError as error:
        place = _in_place(Path(error.filename or folder), new, folder) or folder
        raise _UnwrittenError(place, str(error.strerror or error)) from None
    finally:
        for place in missing:
            with suppress(OSError):  # the folder is not empty
                place.rmdir()


def _check_name(path: Path) -> None:
    """Refuse a path that is not valid for a file."""
    try:
        if "\0" not in os.fsencode(path).decode("latin-1"):
            return
        reason = "its name holds a null byte"
    except UnicodeEncodeError:
        reason = "its name holds a lone surrogate"
    raise InputError(f"{as_written(str(path))}: cannot be written: {reason}")


def _in_place(path: Path, new: Path, folder: Path) -> Path | None:
    """Return the final place of one of the new files of a folder; None for another path."""
    if path.name == _TURN or _MARK.fullmatch(path.name):
        return None
    return folder / path.relative_to(new) if path.is_relative_to(new) else None


def _missing(folder: Path) -> list[Path]:
    """Return the folders that must be created, innermost first."""
    return [place for place in (folder, *folder.parents) if not place.exists()]


def check_writable(folder: Path) -> None:
    """Refuse a folder that is not writable or cannot be created, without leaving files.

    The check creates a folder of another name, because another process may be creating the same folder.

    Raises:
        InputError: the folder is not writable; the message gives the reason.
    """
    try:
        existing = next(place for place in (folder, *folder.parents, Path()) if place.is_dir())
        probe = Path(tempfile.mkdtemp(prefix=".forficula-probe-", dir=existing))
        try:
            (probe / folder.relative_to(existing) / "report.html").parent.mkdir(parents=True, exist_ok=True)
        finally:
            shutil.rmtree(probe, ignore_errors=True)
    except OSError as error:
        raise _UnwrittenError(folder, str(error.strerror or error)) from None
    except ValueError as error:  # a null byte
        raise InputError(f"{as_written(str(folder))}: cannot be written: {error}") from None


def clear_leftovers(folder: Path) -> None:
    """Remove files that killed processes left in a folder, and move back files that they had moved aside.

    Files of running processes and all other files are not touched. Nothing happens in a folder that is not writable.
    """
    with suppress(OSError):
        if _marks(folder) or os.path.lexists(folder / _TURN):
            with hold_lock(folder / _TURN):
                _clear(folder)


@contextmanager
def _writing(folder: Path) -> Iterator[Path]:
    """Yield the beginning of the names of one writer's unfinished files, and hold its lock."""
    clear_leftovers(folder)
    mark = folder / f".forficula-{secrets.token_hex(6)}"
    with hold_lock(_lock(mark)):
        yield mark


def _lock(mark: Path) -> Path:
    return mark.with_name(f"{mark.name}.lock")


def _marks(folder: Path) -> list[Path]:
    """Return the marks of all running or killed writers in a folder."""
    matches = (_MARK.fullmatch(place.name) for place in folder.iterdir())
    return [folder / name for name in sorted({match[1] for match in matches if match})]


def _clear(folder: Path) -> None:
    """Remove the leftovers of killed writers; the caller holds the lock of the folder."""
    for mark in _marks(folder):
        with hold_lock(_lock(mark), wait=False) as dead:
            if not dead:
                continue
            work = mark.with_name(f"{mark.name}-work")
            _undo(folder, work)
            shutil.rmtree(work, ignore_errors=True)
            for file in folder.glob(f"{mark.name}-file*"):
                file.unlink()


def _exchange(folder: Path, work: Path, remove: Collection[str]) -> None:
    """Put all new files in place, or none; the caller holds the lock of the folder."""
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
            why = "; the old files are moved aside, and the next run moves them back"
        else:
            why = "; the old files are unchanged"
        if isinstance(error, OSError):
            raise InputError(f"{folder / place}: cannot be replaced: {error.strerror}{why}") from None
        raise


def _undo(folder: Path, work: Path) -> None:
    """Move back files that were moved aside, if not all new files are in place; can be repeated after a crash."""
    new, old, nothing, undo = (work / name for name in ("new", "old", "nothing", "undo"))
    if not undo.exists():
        return
    for place in _files(nothing):
        if not (new / place).exists():
            (folder / place).unlink(missing_ok=True)
        if place.parent != Path():
            with suppress(OSError):  # the folder has other files
                (folder / place).parent.rmdir()
    for place in _files(old):
        (old / place).replace(folder / place)
    undo.unlink()


def _files(folder: Path) -> list[Path]:
    """Return the paths of all files in a folder, relative to it; links count as files."""
    return sorted(Path(top, name).relative_to(folder) for top, _, names in os.walk(folder) for name in names)


def check_new(path: Path, ending: str) -> None:
    """Refuse a path at which a new file of a kind cannot be created.

    Raises:
        InputError: the name has another ending or cannot name results, the file exists already, or the path is not
            valid.
    """
    if path.suffix != ending:
        raise InputError(f"{path}: need a name that ends with {ending}")
    with error_prefix(f"{path}: "):
        folder_name(path.stem)
    try:
        exists = path.exists()
    except OSError as error:
        raise InputError(f"{path}: cannot be written: {error.strerror}") from None
    if exists:
        raise InputError(f"{path}: exists already; choose another name or remove it")


def open_to_append(path: Path, *, new: bool = False) -> IO[bytes]:
    """Open a file to append lines; it is created if it is missing.

    Args:
        path: path of the file.
        new: whether to refuse an existing file. Of several processes, on any machines, one creates the file.

    Raises:
        FileExistsError: `new` is true, and the file exists.
        InputError: the file cannot be written, or is a link. Links are not followed, because an attacker may have
            created them.
    """
    if path.is_symlink():
        raise InputError(f"{path}: need a file or nothing there, got a link to {path.readlink()}; remove it")
    flags = os.O_WRONLY | os.O_APPEND | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0) | getattr(os, "O_BINARY", 0)
    flags |= os.O_EXCL if new else 0
    try:
        return os.fdopen(os.open(path, flags, 0o666), "ab")
    except FileExistsError:
        raise
    except OSError as error:
        raise InputError(f"{path}: cannot be written: {error.strerror}") from None


def write_text(path: Path, text: str) -> None:
    """Write a text file completely or not at all.

    Raises:
        InputError: the file cannot be written.
    """
    with replacing(path) as temporary:
        temporary.write_text(text, encoding="utf-8", newline="\n")


def write_bytes(path: Path, content: bytes | memoryview) -> None:
    """Write a file completely or not at all.

    Raises:
        InputError: the file cannot be written.
    """
    with replacing(path) as temporary:
        temporary.write_bytes(content)


def read_bytes(path: Path, largest: float = LARGEST_FILE) -> bytes:
    """Read a regular file of the user.

    A pipe or a device is refused, because it may never end, except for /dev/stdin and /dev/fd/63 and the like, which a
    shell uses for redirection and process substitution.

    Args:
        path: path of the file.
        largest: largest allowed number of bytes.

    Raises:
        InputError: there is no such file, or it cannot be read, is not a regular file, or is too large; the caller adds
            the name of the file.
    """
    handed_over = _HANDED_OVER.fullmatch(str(path)) is not None
    # without this flag, opening a named pipe would wait for a writer
    more = 0 if handed_over else getattr(os, "O_NONBLOCK", 0)
    content = bytearray()
    try:
        with io.FileIO(path, opener=lambda name, flags: os.open(name, flags | more)) as file:
            status = os.fstat(file.fileno())
            if not (stat.S_ISREG(status.st_mode) or handed_over):
                raise InputError(f"need a regular file, got {_kind_of(status.st_mode)}")
            # the size of a pipe and of some regular files is unknown, so read in pieces
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
    """Read a text file of the user.

    Args:
        path: path of the file, UTF-8.

    Raises:
        InputError: the errors of `read_bytes`, a file that may not be read, or a file that is not UTF-8; the message
            names the file.
    """
    check_may_read(path)
    try:
        # editors on Windows write a byte order mark at the beginning of UTF-8 files
        text = read_bytes(path).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise InputError(f"{path}: not UTF-8 text from byte {error.start} on; save it as UTF-8") from None
    except InputError as error:
        raise InputError(f"{shown_path(path)}: {error}") from None
    return text.replace("\r\n", "\n").replace("\r", "\n")


def shown_path(path: Path) -> str:
    """Return a path for error messages, in quotes if it has characters that are not printable."""
    return str(path) if str(path).isprintable() else as_written(str(path))


def read_toml(path: Path, what: str) -> dict[str, Any]:
    """Read the tables of a TOML file.

    Args:
        path: path of the file.
        what: description of the content, such as "a design", for error messages.

    Raises:
        InputError: there is no such file, or it cannot be read, or it is not UTF-8 or not TOML.
    """
    text = read_text(path)
    with error_prefix(f"{path}: "):
        return parse_toml(text, what)
