"""Queue of a worker: tasks run one after another, and a task ends when its page is closed."""

from __future__ import annotations

import asyncio
from pathlib import Path
from typing import Any

from forficula.workbench.requests import PageRequest
from forficula.workbench.worker import Report, StoppedError, Task, Worker

# s, until the process of a task is ended that was stopped but does not report
_PATIENCE = 1.0


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
        request: PageRequest,
        folder: Path | None = None,
        report: Report = lambda _: None,
    ) -> Any:
        """Run a task for a request when the worker is free.

        Args:
            holder: the request.
            task: the task.
            request: the request of the page.
            folder: folder for results that are files.
            report: receives descriptions of the progress, or parts of the result, in the event loop.

        Raises:
            InputError: the task raises it.
            StoppedError: the page was closed or sent a later request, or the worker ended.
        """
        loop = asyncio.get_running_loop()
        try:
            async with self._free:
                if holder in self._gone:
                    raise StoppedError
                self._holder = holder
                return await asyncio.to_thread(
                    self.worker.do, task, request, folder, lambda content: _pass_on(loop, report, content)
                )
        finally:
            self._holder = None if self._holder is holder else self._holder
            self._gone.discard(holder)

    def leave(self, holder: object) -> None:
        """Stop the task of a request whose page was closed or sent a later request."""
        if self._holder is holder:
            self.worker.stop()
            asyncio.get_running_loop().call_later(_PATIENCE, self._end, holder)
        else:
            self._gone.add(holder)

    def _end(self, holder: object) -> None:
        """End the process if it still works for a request."""
        if self._holder is holder:
            self.worker.end()


def _pass_on(loop: asyncio.AbstractEventLoop, report: Report, content: Any) -> None:
    # when the server ends, the loop closes before the thread does
    if not loop.is_closed():
        loop.call_soon_threadsafe(report, content)
