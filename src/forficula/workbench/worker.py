"""A process that works for a workbench, one task after another, and that can be ended in the midst of one."""

from __future__ import annotations

import multiprocessing
import os
import signal
import tempfile
import threading
import traceback
from collections.abc import Callable
from contextlib import suppress
from multiprocessing.connection import Connection
from pathlib import Path
from time import monotonic
from typing import Any, Literal

from forficula.analysis import measure
from forficula.errors import InputError
from forficula.reproduction import shown_tendon
from forficula.show.folder.landscape_folder import write_landscape
from forficula.show.folder.run_folder import write_run
from forficula.statics import energy_landscape
from forficula.study.running.runs import run
from forficula.workbench.asked import Asked, Opened, asked_design, reading_for_page

Task = Literal["design", "model", "pattern", "landscape", "run"]
_BETWEEN = 0.1  # s, from one word of how far it is to the next
# is told what is being done
Tell = Callable[[str], None]


class StoppedError(Exception):
    """A task came to no end, because its process was ended."""


class Worker:
    """A process that begins with the first task, and again with the next one after it was ended."""

    def __init__(self, opened: Opened, folder: Path) -> None:
        self._opened = opened
        # where what an ended task leaves is removed with all else
        self._folder = folder
        self._lock = threading.Lock()
        self._process: multiprocessing.process.BaseProcess | None = None
        self._pipe: Connection | None = None

    def start(self) -> None:
        """Begin the process, where there is none, so that the first task need not wait for it."""
        with self._lock:
            self._begin()

    def do(self, task: Task, asked: Asked, folder: Path | None, tell: Callable[[str], None]) -> Any:
        """Have a task done, and wait for what comes of it.

        Args:
            task: what to do.
            asked: the design.
            folder: where results go that are files; None of a task that leaves none.
            tell: is told what is being done.

        Raises:
            InputError: what the task raises.
            StoppedError: `stop` was called meanwhile, or the process ended.
        """
        with self._lock:
            pipe = self._begin()
        try:
            pipe.send((task, asked, folder))
            while True:
                kind, content = pipe.recv()
                if kind != "told":
                    break
                tell(content)
        except (EOFError, OSError):
            self.stop()
            raise StoppedError from None
        if kind == "refused":
            raise InputError(content)
        if kind == "failed":
            raise RuntimeError(content)
        return content

    def stop(self) -> None:
        """End the process, whatever it does."""
        with self._lock:
            process, self._process, self._pipe = self._process, None, None
        if process is not None:
            process.kill()
            process.join()

    def _begin(self) -> Connection:
        if self._process is not None and self._pipe is not None and self._process.is_alive():
            return self._pipe
        context = multiprocessing.get_context("spawn")
        self._pipe, own = context.Pipe()
        self._process = context.Process(target=_work, args=(own, self._opened, self._folder), daemon=True)
        self._process.start()
        # held here it would not end with the process
        own.close()
        return self._pipe


def _work(pipe: Connection, opened: Opened, temporary: Path) -> None:
    """Do tasks until whoever asks for them is gone."""
    # whoever presses ctrl-C means the server, which then ends this
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    tempfile.tempdir = str(temporary)
    threading.Thread(target=_leave_with_parent, daemon=True).start()
    # what is imported before the first task need not be waited for then
    import forficula.workbench.told  # noqa: F401

    with suppress(EOFError, OSError):
        while True:
            task, asked, folder = pipe.recv()
            pipe.send(_done(task, asked, opened, folder, _teller(pipe)))


def _leave_with_parent() -> None:
    parent = multiprocessing.parent_process()
    if parent is not None:
        parent.join()
    os._exit(1)


def _teller(pipe: Connection) -> Callable[[str], None]:
    """Pass on what is being done: whatever is new, and now and then how far it is."""
    last, doing = 0.0, ""

    def tell(text: str) -> None:
        nonlocal last, doing
        if text.partition(":")[0] != doing or monotonic() - last >= _BETWEEN:
            last, doing = monotonic(), text.partition(":")[0]
            pipe.send(("told", text))

    return tell


def _done(task: Task, asked: Asked, opened: Opened, folder: Path, tell: Callable[[str], None]) -> tuple[str, Any]:
    """What comes of a task, and of which kind that is."""
    try:
        # whatever else a task reads of what a page named, such as a material
        with reading_for_page(opened):
            return "done", _result(task, asked, opened, folder, tell)
    except InputError as error:
        return "refused", str(error)
    except MemoryError:
        return "refused", "no memory left; take fewer parts, or fewer rows by a longer sample_interval"
    except RecursionError:
        return "refused", "keys or values are nested too deeply"
    except Exception as error:
        traceback.print_exc()
        return "failed", f"{type(error).__name__}: {error}"


def _result(task: Task, asked: Asked, opened: Opened, folder: Path, tell: Callable[[str], None]) -> Any:
    """What comes of a task; None where that lies in the folder."""
    from forficula.workbench.told import design_told, model_told, pattern_told

    match task:
        case "design":
            return design_told(asked, opened)
        case "model":
            return model_told(asked, opened)
        case "pattern":
            return pattern_told(asked, opened)
        case "landscape":
            leave_landscape(asked, opened, folder, tell)
        case "run":
            leave_run(asked, opened, folder, tell)
    return None


def leave_landscape(asked: Asked, opened: Opened, folder: Path, tell: Tell) -> None:
    """Survey a design's energy by statics, as `forficula landscape --no-simulation` does, and write its results.

    Raises:
        InputError: the design cannot be read or built.
    """
    design = asked_design(asked, opened)
    tell("building the structure")
    landscape = energy_landscape(design, progress=lambda step: tell(f"surveying: {step}"))
    tell("drawing")
    write_landscape(landscape, folder, None, shown_tendon(design))


def leave_run(asked: Asked, opened: Opened, folder: Path, tell: Tell) -> None:
    """Take a design through its protocol, as `forficula run` does, and write what that leaves.

    Raises:
        InputError: the design cannot be read or built.
    """
    design = asked_design(asked, opened)
    tell("building the structure")
    record = run(
        design,
        lambda stage, time, longest: tell(f"{stage}: {time:.3g} s of at most {longest:.3g} s simulated"),
        confirm=True,
    )
    tell("drawing")
    write_run(record, measure(record), folder, engine=False)
