"""Who has a worker now: tasks wait for one another, and one whose page has gone is ended."""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from pathlib import Path
from typing import Any

from forficula.workbench.asked import Asked
from forficula.workbench.worker import StoppedError, Task, Worker


class Desk:
    """A worker and the request that it works for."""

    def __init__(self, worker: Worker) -> None:
        self.worker = worker
        self._free = asyncio.Lock()
        self._holder: object = None
        self._gone: set[object] = set()

    async def do(
        self,
        holder: object,
        task: Task,
        asked: Asked,
        folder: Path | None = None,
        tell: Callable[[str], None] = lambda _: None,
    ) -> Any:
        """Have a task done for a request, once the worker is free.

        Args:
            holder: the request.
            task: what to do.
            asked: the design.
            folder: where results go that are files.
            tell: is told what is being done, in the loop of events.

        Raises:
            InputError: what the task raises.
            StoppedError: the request was left, or the worker ended.
        """
        loop = asyncio.get_running_loop()
        try:
            async with self._free:
                if holder in self._gone:
                    raise StoppedError
                self._holder = holder
                return await asyncio.to_thread(
                    self.worker.do, task, asked, folder, lambda text: _pass_on(loop, tell, text)
                )
        finally:
            self._holder = None if self._holder is holder else self._holder
            self._gone.discard(holder)

    def leave(self, holder: object) -> None:
        """End what is done for a request whose page has gone."""
        if self._holder is holder:
            self.worker.stop()
        else:
            self._gone.add(holder)


def _pass_on(loop: asyncio.AbstractEventLoop, tell: Callable[[str], None], text: str) -> None:
    # at the end of a server the loop is closed before the thread hears of it
    if not loop.is_closed():
        loop.call_soon_threadsafe(tell, text)
