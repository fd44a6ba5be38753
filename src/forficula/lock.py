"""A lock between processes that dies with its owner: who is killed holds nothing."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

if sys.platform == "win32":
    import msvcrt
else:
    import fcntl

_LOOK_SECONDS = 0.02
_SILENT_SECONDS = 2.0
_REMOVED_SECONDS = 1.0


@contextmanager
def held(path: Path, *, wait: bool = True) -> Iterator[bool | None]:
    """Hold a lock, which is a file that is there as long as it is held, or until the next who takes it lets it go.

    Whoever waits for longer than two seconds says so on stderr.

    Args:
        path: of the lock; nothing is written to it.
        wait: whether to wait where another process, or another block of this one, holds it.

    Yields:
        True where it is held here, False where another one holds it, None where the disk knows no locks.

    Raises:
        OSError: the file cannot be made.
    """
    start, refused, told = time.monotonic(), 0.0, False
    while True:
        try:
            # not through a link that someone has planted
            descriptor = os.open(path, os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0), 0o666)
        except PermissionError:
            # Windows refuses to open a file that is being removed
            refused = refused or time.monotonic()
            if sys.platform != "win32" or time.monotonic() - refused > _REMOVED_SECONDS:
                raise
            time.sleep(_LOOK_SECONDS)
            continue
        taken = _take(descriptor)
        # who held it before may have removed the file that is open here
        if taken is None or (taken and _is_open(path, descriptor)):
            break
        os.close(descriptor)
        if not taken:
            if not wait:
                yield False
                return
            if not told and time.monotonic() - start > _SILENT_SECONDS:
                print(f"waiting for another process that writes to {path.parent}", file=sys.stderr)
                told = True
            time.sleep(_LOOK_SECONDS)
    try:
        yield taken
    finally:
        _let_go(path, descriptor)


def _take(descriptor: int) -> bool | None:
    try:
        if sys.platform == "win32":
            msvcrt.locking(descriptor, msvcrt.LK_NBLCK, 1)
        else:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except (BlockingIOError, PermissionError):
        return False
    except OSError:  # some network disks
        return None
    return True


def _is_open(path: Path, descriptor: int) -> bool:
    """Whether an open file is the one of that name; Windows removes none that is open."""
    if sys.platform == "win32":
        return True
    try:
        return os.path.samestat(path.lstat(), os.fstat(descriptor))
    except OSError:
        return False


def _let_go(path: Path, descriptor: int) -> None:
    """Remove the file, unless another one waits for it on Windows, and close it."""
    if sys.platform == "win32":
        os.close(descriptor)
    with suppress(OSError):
        path.unlink()
    if sys.platform != "win32":
        os.close(descriptor)
