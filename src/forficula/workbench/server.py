"""The workbench as a server on this machine: its page, and what that asks."""

from __future__ import annotations

import asyncio
import json
import secrets
import signal
import socket
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from pydantic import ValidationError
from tornado.httpserver import HTTPServer
from tornado.web import Application, RequestHandler

from forficula.errors import InputError
from forficula.workbench.asked import Asked, Opened
from forficula.workbench.desk import Desk
from forficula.workbench.guard import refusal
from forficula.workbench.page import workbench_page
from forficula.workbench.worker import StoppedError, Task, Worker

LOOPBACK = "127.0.0.1"
LARGEST = 20_000_000  # bytes of what a page sends
_ENDED = "the work on it ended before it was done; it may need more memory than there is"
# what work comes to that has no result; cancelled it is with the server
_TOLD = (InputError, StoppedError, RuntimeError, asyncio.CancelledError)
_REPORT = "report.html"


@dataclass(kw_only=True)
class Bench:
    """What all requests share.

    Attributes:
        opened: what the workbench was opened with.
        port: where it listens.
        quick: for what a page waits for.
        slow: for what it can do without meanwhile.
        folder: where results lie.
        results: how many there were.
    """

    opened: Opened
    port: int
    quick: Desk
    slow: Desk
    folder: Path
    results: int = 0


def serve(opened: Opened, port: int | None, ready: Callable[[str], None]) -> None:
    """Serve a workbench until it is interrupted.

    Args:
        opened: what it begins with.
        port: where it listens; any that is free if not given.
        ready: is told its address once it answers.

    Raises:
        InputError: the port is taken or not allowed.
        KeyboardInterrupt: ctrl-C, or another signal that ends it.
    """
    asyncio.run(_serve(opened, port, ready))
    raise KeyboardInterrupt


async def _serve(opened: Opened, port: int | None, ready: Callable[[str], None]) -> None:
    try:
        listening = socket.create_server((LOOPBACK, port or 0))
    except OSError as error:
        raise InputError(f"--port: {port} cannot be had: {error.strerror or error}") from None
    own_port = listening.getsockname()[1]
    listening.setblocking(False)
    # others who have an account on this machine reach its ports, too, but do not know this
    secret = secrets.token_urlsafe(16)
    with TemporaryDirectory(prefix="forficula-", ignore_cleanup_errors=True) as folder:
        workers = Worker(opened, Path(folder)), Worker(opened, Path(folder))
        quick, slow = (Desk(worker) for worker in workers)
        bench = Bench(opened=opened, port=own_port, quick=quick, slow=slow, folder=Path(folder))
        server = HTTPServer(application(bench, secret), max_body_size=LARGEST, max_buffer_size=2 * LARGEST)
        ended = _told_to_end()
        try:
            server.add_socket(listening)
            workers[0].start()
            ready(f"http://{LOOPBACK}:{own_port}/{secret}/")
            await ended.wait()
        finally:
            server.stop()
            for worker in workers:
                worker.stop()


def _told_to_end() -> asyncio.Event:
    """Set when its terminal is closed or somebody ends it, so that nothing of it is left then either."""
    told, loop = asyncio.Event(), asyncio.get_running_loop()
    for name in ("SIGTERM", "SIGHUP"):
        number = getattr(signal, name, None)
        # what is ignored, as with nohup, stays so
        if number is not None and signal.getsignal(number) == signal.SIG_DFL:
            with suppress(NotImplementedError):
                loop.add_signal_handler(number, told.set)
    return told


def application(bench: Bench, secret: str) -> Application:
    """What answers requests, all of which begin with a word that only its page knows."""
    shared = {"bench": bench}
    return Application(
        [
            (rf"/{secret}/", _Page, shared),
            (rf"/{secret}/(design|model|pattern)", _Answer, shared),
            (rf"/{secret}/(landscape|run)", _Results, shared),
            (rf"/{secret}/results/([0-9]{{1,9}})/{_REPORT}", _Report, shared),
        ],
        default_handler_class=_Nothing,
        default_handler_args=shared,
        # what is refused the page says
        log_function=lambda _: None,
    )


def _why(error: BaseException) -> str:
    match error:
        case InputError():
            return str(error)
        case RuntimeError():
            return f"the workbench failed: {error}"
        case _:
            return _ENDED


class _Guarded(RequestHandler):
    """Answers nobody but its own page, and lets nothing keep, frame or guess what it answers."""

    def initialize(self, bench: Bench) -> None:
        self.bench = bench
        # whether its page has left
        self.gone = False

    def set_default_headers(self) -> None:
        self.clear_header("Server")
        self.set_header("Cache-Control", "no-store")
        self.set_header("X-Content-Type-Options", "nosniff")
        self.set_header("Referrer-Policy", "same-origin")
        self.set_header("Cross-Origin-Resource-Policy", "same-origin")
        self.set_header("Cross-Origin-Opener-Policy", "same-origin")
        self.set_header("Content-Security-Policy", "frame-ancestors 'none'")

    def prepare(self) -> None:
        headers = self.request.headers
        why = refusal(self.bench.port, self.request.host, headers.get("Origin", ""), headers.get("Sec-Fetch-Site", ""))
        if why:
            self.refuse(403, why)

    def refuse(self, status: int, why: str) -> None:
        self.set_status(status)
        self.finish({"refused": why})

    def write_error(self, status_code: int, **_: Any) -> None:
        refused = f"need GET or POST, got {self.request.method}" if status_code == 405 else "the workbench failed"
        self.finish({"refused": f"{refused} ({status_code})"})

    def asked(self) -> Asked | None:
        """What the page asks; None, and an answer that says why, where that cannot be read."""
        if self.request.headers.get("Content-Type", "").partition(";")[0] != "application/json":
            self.refuse(415, "need application/json")
            return None
        try:
            return Asked.model_validate_json(self.request.body)
        except ValidationError as error:
            first = error.errors(include_url=False)[0]
            self.refuse(400, f"{'.'.join(map(str, first['loc']))}: {first['msg'].removeprefix('Value error, ')}")
            return None


class _Nothing(_Guarded):
    def prepare(self) -> None:
        super().prepare()
        if not self._finished:
            self.refuse(404, "there is nothing here")


class _Page(_Guarded):
    def get(self) -> None:
        self.set_header("Content-Type", "text/html; charset=utf-8")
        self.finish(workbench_page(self.bench.opened))


class _Answer(_Guarded):
    async def post(self, task: Task) -> None:
        if (asked := self.asked()) is None:
            return
        try:
            await self.finish(await self.bench.quick.do(self, task, asked))
        except _TOLD as error:
            # a page asks whether a value is allowed, and this is an answer
            if not self.gone:
                await self.finish({"refused": _why(error)})

    def on_connection_close(self) -> None:
        self.gone = True
        self.bench.quick.leave(self)


class _Results(_Guarded):
    """Answers line by line: what is being done, and at last where the results are."""

    async def post(self, task: Task) -> None:
        if (asked := self.asked()) is None:
            return
        self.set_header("Content-Type", "application/x-ndjson")
        self.bench.results += 1
        number = self.bench.results
        try:
            await self.bench.slow.do(
                self, task, asked, self.bench.folder / str(number), lambda text: self.line({"doing": text})
            )
            self.line({"done": f"results/{number}/{_REPORT}"})
        except _TOLD as error:
            self.line({"refused": _why(error)})

    def line(self, content: dict[str, str]) -> None:
        if not self.gone:
            self.write(f"{json.dumps(content)}\n")
            self.flush()

    def on_connection_close(self) -> None:
        self.gone = True
        self.bench.slow.leave(self)


class _Report(_Guarded):
    def get(self, number: str) -> None:
        report = self.bench.folder / number / _REPORT
        if not report.is_file():
            self.refuse(404, "there is nothing here")
            return
        self.set_header("Content-Security-Policy", "frame-ancestors 'self'")
        self.set_header("Content-Type", "text/html; charset=utf-8")
        self.finish(report.read_bytes())
