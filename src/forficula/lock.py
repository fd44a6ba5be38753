"""A lock between processes, which the operating system releases when its owner ends."""

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

_POLL_SECONDS = 0.02
_SILENT_SECONDS = 2.0
_REMOVED_SECONDS = 1.0


@contextmanager
def hold_lock(path: Path, *, wait: bool = True) -> Iterator[bool | None]:
    """Hold a lock on a file, which exists while the lock is held.

    After a crash the file remains until the next holder releases the lock. Waiting for longer than two seconds is
    reported on stderr.

    Args:
        path: path of the lock file; nothing is written to it.
        wait: whether to wait while another process, or another block of this process, holds the lock.

    Yields:
        True if this block holds the lock, False if another one does, None if the file system does not support locks.

    Raises:
        OSError: the file cannot be created.
    """
    start, refused, reported = time.monotonic(), 0.0, False
    while True:
        try:
            # without following links, which an attacker may have created
            descriptor = os.open(path, os.O_RDWR | os.O_CREAT | getattr(os, "O_NOFOLLOW", 0), 0o666)
        except PermissionError:
            # Windows refuses to open a file that is being removed
            refused = refused or time.monotonic()
            if sys.platform != "win32" or time.monotonic() - refused > _REMOVED_SECONDS:
                raise
            time.sleep(_POLL_SECONDS)
            continue
        taken = _take(descriptor)
        # the previous holder may have removed the file after it was opened here
        if taken is None or (taken and _is_open(path, descriptor)):
            break
        os.close(descriptor)
        if not taken:
            if not wait:
                yield False
                return
            if not reported and time.monotonic() - start > _SILENT_SECONDS:
                print(f"waiting for another process that writes to {path.parent}", file=sys.stderr)
                reported = True
            time.sleep(_POLL_SECONDS)
    try:
        yield taken
    finally:
        _release(path, descriptor)


def _take(descriptor: int) -> bool | None:
    try:
        if sys.platform == "win32":
            msvcrt.locking(descriptor, msvcrt.LK_NBLCK, 1)
        else:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except (BlockingIOError, PermissionError):
        return False
    except OSError:  # some network file systems
        return None
    return True


def _is_open(path: Path, descriptor: int) -> bool:
    """Return whether an open file is still the one at a path; Windows does not remove open files."""
    if sys.platform == "win32":
        return True
    try:
        return os.path.samestat(path.lstat(), os.fstat(descriptor))
    except OSError:
        return False


def _release(path: Path, descriptor: int) -> None:
    """Remove the file, unless another process waits for it on Windows, and close it."""
    if sys.platform == "win32":
        os.close(descriptor)
    with suppress(OSError):
        path.unlink()
    if sys.platform != "win32":
        os.close(descriptor)
