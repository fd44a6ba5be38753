"""Worker process of a workbench: runs one task after another, and can be stopped or ended during a task."""

from __future__ import annotations

import multiprocessing
import os
import signal
import tempfile
import threading
import traceback
import warnings
from collections.abc import Callable
from contextlib import suppress
from multiprocessing.connection import Connection
from pathlib import Path
from time import monotonic
from typing import TYPE_CHECKING, Any, Literal

from forficula.errors import InputError
from forficula.workbench.requests import Opened, PageRequest, reading_for_page

if TYPE_CHECKING:
    from forficula.workbench.fold_responses import FoldResponses

Task = Literal[
    "design",
    "model",
    "pattern",
    "landscape",
    "run",
    "fold",
    "drag",
    "picture-scale",
    "picture-junctions",
    "picture-trace",
    "picture-pattern",
    "picture-straighten",
]
_BETWEEN = 0.1  # s, between reports of progress
_STOP = "stop"  # message that stops the present task
# receives descriptions of the progress, or parts of the result as data for JSON
Report = Callable[[Any], None]


class StoppedError(Exception):
    """A task was not finished, because it was stopped or its process was ended."""


class Worker:
    """A process that starts with the first task, and restarts with the next task after it was ended."""

    def __init__(self, opened: Opened, folder: Path) -> None:
        self._opened = opened
        # temporary files of an ended task are removed with this folder
        self._folder = folder
        self._lock = threading.Lock()
        self._process: multiprocessing.process.BaseProcess | None = None
        self._pipe: Connection | None = None

    def start(self) -> None:
        """Start the process if it is not running, so that the first task does not wait for it."""
        with self._lock:
            self._begin()

    def do(self, task: Task, request: PageRequest, folder: Path | None, report: Report) -> Any:
        """Run a task, and return its result.

        Args:
            task: the task.
            request: the request of the page.
            folder: folder for results that are files; None for a task without files.
            report: receives descriptions of the progress, or parts of the result.

        Raises:
            InputError: the task raises it.
            StoppedError: `stop` or `end` was called during the task, or the process ended.
        """
        with self._lock:
            pipe = self._begin()
        try:
            pipe.send((task, request, folder))
            while True:
                kind, content = pipe.recv()
                if kind != "progress":
                    break
                report(content)
        except (EOFError, OSError):
            self.end()
            raise StoppedError from None
        if kind == "stopped":
            raise StoppedError
        if kind == "refused":
            raise InputError(content)
        if kind == "failed":
            raise RuntimeError(content)
        return content

    def stop(self) -> None:
        """Stop the present task at its next report; the process continues with the next task."""
        with self._lock, suppress(OSError):
            if self._pipe is not None:
                self._pipe.send(_STOP)

    def end(self) -> None:
        """End the process immediately."""
        with self._lock:
            process, self._process, self._pipe = self._process, None, None
        if process is not None:
            process.kill()
            process.join()

    def _begin(self) -> Connection:
        if self._process is not None and self._pipe is not None and self._process.is_alive():
            return self._pipe
        context = multiprocessing.get_context("spawn")
        self._pipe, far_end = context.Pipe()
        self._process = context.Process(target=_work, args=(far_end, self._opened, self._folder), daemon=True)
        self._process.start()
        # otherwise the pipe would stay open when the process ends
        far_end.close()
        return self._pipe


def _work(pipe: Connection, opened: Opened, temporary: Path) -> None:
    """Run tasks until the server ends."""
    # ctrl-C ends the server, which then ends this process
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    tempfile.tempdir = str(temporary)
    # the page shows warnings about a design; the terminal has shown those of the opened one
    warnings.simplefilter("ignore", UserWarning)
    threading.Thread(target=_leave_with_parent, daemon=True).start()
    # imported before the first task arrives, and in this process only: the server needs 1.5 s less to start
    import forficula.workbench.tasks  # noqa: F401
    from forficula.workbench.fold_responses import FoldResponses

    folds = FoldResponses()
    with suppress(EOFError, OSError):
        while True:
            message = pipe.recv()
            # a task that ended just before it was stopped
            if message == _STOP:
                continue
            task, request, folder = message
            pipe.send(_answer(task, request, opened, folder, folds, _reporter(pipe)))


def _leave_with_parent() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
    os._exit(1)


def _reporter(pipe: Connection) -> Report:
    """Return a function that sends progress, unless the task was stopped, in which case it raises `StoppedError`.

    Data and each new activity are sent at once, and descriptions of a repeated activity at intervals.
    """
    last, activity = 0.0, ""

    def report(content: Any) -> None:
        nonlocal last, activity
        if pipe.poll():
            pipe.recv()
            raise StoppedError
        if isinstance(content, str):
            if content.partition(":")[0] == activity and monotonic() - last < _BETWEEN:
                return
            last, activity = monotonic(), content.partition(":")[0]
        pipe.send(("progress", content))

    return report


def _answer(
    task: Task, request: PageRequest, opened: Opened, folder: Path, folds: FoldResponses, report: Report
) -> tuple[str, Any]:
    """Return the kind and the content of the answer to a task."""
    from forficula.workbench.tasks import task_result

    try:
        # a task may read other files that a page names, such as a material
        with reading_for_page(opened):
            return "done", task_result(task, request, opened, folder, folds, report)
    except StoppedError:
        return "stopped", None
    except InputError as error:
        return "refused", str(error)
    except MemoryError:
        return "refused", "no memory left; take fewer parts, a smaller picture, or a longer sample_interval"
    except RecursionError:
        return "refused", "keys or values are nested too deeply"
    except Exception as error:
        traceback.print_exc()
        return "failed", f"{type(error).__name__}: {error}"
