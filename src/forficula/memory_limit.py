"""Room for the libraries of linear algebra under a limit on memory."""

from __future__ import annotations

import contextlib
import mmap
import os
import sys

# [chosen] what numpy and scipy map when they are loaded: 175 MiB were measured with one thread, 82 MiB more by thread
_LIBRARIES, _THREAD = 192 << 20, 88 << 20
_THREADS = "OPENBLAS_NUM_THREADS"


def check_room_for_libraries() -> None:
    """Let OpenBLAS begin with one thread where there is no room for all, and refuse to load it where that has none.

    OpenBLAS asks for its buffers again and again, without an end, where a limit (`ulimit -v`) leaves no room for them.

    Raises:
        MemoryError: no room for one thread.
    """
    if "scipy.linalg" in sys.modules or not _is_limited():
        return
    if _has_room(_LIBRARIES + (_threads() - 1) * _THREAD):
        return
    if not _has_room(_LIBRARIES):
        raise MemoryError
    os.environ[_THREADS] = "1"


def _is_limited() -> bool:
    try:
        import resource
    except ImportError:  # not on Windows
        return False
    return resource.getrlimit(resource.RLIMIT_AS)[0] != resource.RLIM_INFINITY


def _threads() -> int:
    cores = os.cpu_count() or 1
    with contextlib.suppress(ValueError):
        return min(cores, max(1, int(os.environ.get(_THREADS, ""))))
    return cores


def _has_room(size: int) -> bool:
    try:
        mmap.mmap(-1, size).close()
    except OSError:
        return False
    return True
