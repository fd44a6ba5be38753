"""Queue of a worker: tasks run one after another, and a task ends when its page is closed."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from pathlib import Path
from typing import Any

from forficula.workbench.requests import DesignRequest
from forficula.workbench.worker import StoppedError, Task, Worker


class WorkerSession:
    """A worker process, and the request that it serves."""

    def __init__(self, worker: Worker) -> None:
        self.worker = worker
        self._free = asyncio.Lock()
        self._holder: object = None
        self._gone: set[object] = set()

    async def do(
        self,
        holder: object,
        task: Task,
        request: DesignRequest,
        folder: Path | None = None,
        report: Callable[[str], None] = lambda _: None,
    ) -> Any:
        """Run a task for a request when the worker is free.

        Args:
            holder: the request.
            task: the task.
            request: the design.
            folder: folder for results that are files.
            report: receives descriptions of the progress, in the event loop.

        Raises:
            InputError: the task raises it.
            StoppedError: the page was closed, or the worker ended.
        """
        loop = asyncio.get_running_loop()
        try:
            async with self._free:
                if holder in self._gone:
                    raise StoppedError
                self._holder = holder
                return await asyncio.to_thread(
                    self.worker.do, task, request, folder, lambda text: _pass_on(loop, report, text)
                )
        finally:
            self._holder = None if self._holder is holder else self._holder
            self._gone.discard(holder)

    def leave(self, holder: object) -> None:
        """End the task of a request whose page was closed."""
        if self._holder is holder:
            self.worker.stop()
        else:
            self._gone.add(holder)


def _pass_on(loop: asyncio.AbstractEventLoop, report: Callable[[str], None], text: str) -> None:
    # when the server ends, the loop closes before the thread does
    if not loop.is_closed():
        loop.call_soon_threadsafe(report, text)
