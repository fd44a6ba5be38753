"""Server of a workbench on this machine: its page, and the requests of the page."""

from __future__ import annotations

import asyncio
import json
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
from tornado.httputil import HTTPServerRequest
from tornado.web import RequestHandler

from forficula.design import load_design, named_designs
from forficula.errors import InputError
from forficula.show.page.page import page_html
from forficula.workbench.access import Access, redirect_page, refusal, refused_page, write_redirect
from forficula.workbench.requests import DesignRequest, DragRequest, FoldRequest, Opened, PageRequest, design_source
from forficula.workbench.session import WorkerSession
from forficula.workbench.trace_requests import PICTURE_REQUESTS
from forficula.workbench.traffic import LARGEST_REFUSED, BoundedApplication
from forficula.workbench.worker import StoppedError, Task, Worker

LOOPBACK = "127.0.0.1"
_ENDED = "the task ended before it was finished; it may need more memory than is available"
# errors of a task that are reported to the page; tasks are cancelled when the server ends
_REPORTED = (InputError, StoppedError, RuntimeError, asyncio.CancelledError)
_REPORT = "report.html"
_ENTRANCE = "open.html"
_BUFFER = 2**20  # bytes that are read ahead from a connection


@dataclass(kw_only=True)
class Bench:
    """State that all requests share.

    Attributes:
        opened: design with which the workbench was opened.
        port: port of the server.
        quick: queue of tasks for which the page waits.
        statics: queue of fold paths, which grow while the page shows them, and of drags along them.
        slow: queue of tasks that run while the page remains usable.
        access: tokens and cookie.
        folder: folder of the results.
        results: number of results so far.
    """

    opened: Opened
    port: int
    access: Access
    quick: WorkerSession
    statics: WorkerSession
    slow: WorkerSession
    folder: Path
    results: int = 0


def serve(
    opened: Opened, port: int | None, announce: Callable[[str], None], browse: Callable[[Path], None] | None
) -> None:
    """Serve a workbench until it is interrupted.

    Args:
        opened: design with which the workbench begins.
        port: port of the server; any free one if not given.
        announce: receives an address that lets one browser in, and after its use the next one.
        browse: receives a file that only its owner can read and that leads a browser in; None to open no browser.

    Raises:
        InputError: the port is in use or not allowed.
        KeyboardInterrupt: ctrl-C, or another signal that ends the server.
    """
    asyncio.run(_serve(opened, port, announce, browse))
    raise KeyboardInterrupt


async def _serve(
    opened: Opened, port: int | None, announce: Callable[[str], None], browse: Callable[[Path], None] | None
) -> None:
    try:
        listening = socket.create_server((LOOPBACK, port or 0))
    except OSError as error:
        raise InputError(f"--port: {port} is not available: {error.strerror or error}") from None
    own_port = listening.getsockname()[1]
    listening.setblocking(False)
    access = Access(f"http://{LOOPBACK}:{own_port}", own_port)
    with TemporaryDirectory(prefix="forficula-", ignore_cleanup_errors=True) as folder:
        workers = [Worker(opened, Path(folder)) for _ in range(3)]
        quick, statics, slow = (WorkerSession(worker) for worker in workers)
        bench = Bench(
            opened=opened,
            port=own_port,
            access=access,
            quick=quick,
            statics=statics,
            slow=slow,
            folder=Path(folder),
        )
        # the bound of a body depends on its sender
        server = HTTPServer(application(bench), max_body_size=LARGEST_REFUSED, max_buffer_size=_BUFFER)
        ended = _end_signals()
        try:
            server.add_socket(listening)
            for worker in workers[:2]:
                worker.start()
            _announce(access, announce)
            if browse is not None:
                entrance = Path(folder, _ENTRANCE)
                write_redirect(access.new_address(lambda: entrance.unlink(missing_ok=True)), entrance)
                browse(entrance)
            await ended.wait()
        finally:
            server.stop()
            for worker in workers:
                worker.end()


def _announce(access: Access, announce: Callable[[str], None]) -> None:
    """Announce an address, and the next one after its use."""
    announce(access.new_address(lambda: _announce(access, announce)))


def _end_signals() -> asyncio.Event:
    """Return an event that is set by SIGTERM and SIGHUP, so that temporary files are removed then, too."""
    ended, loop = asyncio.Event(), asyncio.get_running_loop()
    for name in ("SIGTERM", "SIGHUP"):
        number = getattr(signal, name, None)
        # signals that are ignored, as by nohup, stay ignored
        if number is not None and signal.getsignal(number) == signal.SIG_DFL:
            with suppress(NotImplementedError):
                loop.add_signal_handler(number, ended.set)
    return ended


def application(bench: Bench) -> BoundedApplication:
    """Return the web application; most of its paths begin with a secret that only its page has."""
    shared = {"bench": bench}
    secret = bench.access.path
    return BoundedApplication(
        [
            (r"/open/([A-Za-z0-9_-]+)", _Entrance, shared),
            (secret, _Page, shared),
            (rf"{secret}(design|model|pattern|picture-scale|picture-pattern)", _Answer, shared),
            (rf"{secret}(drag)", _Drag, shared),
            (rf"{secret}(picture-(?:junctions|trace|straighten))", _Traced, shared),
            (rf"{secret}(fold)", _Fold, shared),
            (rf"{secret}(landscape|run)", _Results, shared),
            (rf"{secret}results/([0-9]{{1,9}})/{_REPORT}", _Report, shared),
        ],
        _Nothing,
        shared,
        lambda request: request.path.startswith(secret) and not _refusal(bench, request) and _is_let_in(bench, request),
    )


def _refusal(bench: Bench, request: HTTPServerRequest, *, by_site: bool = True) -> str:
    """Return the reason for which a request is refused, with or without a cookie; "" if it is not."""
    headers = request.headers
    site = headers.get("Sec-Fetch-Site", "") if by_site else ""
    return refusal(bench.port, request.host, headers.get("Origin", ""), site)


def _is_let_in(bench: Bench, request: HTTPServerRequest) -> bool:
    cookie = request.cookies.get(bench.access.cookie_name)
    return cookie is not None and bench.access.admits(cookie.value)


def _reason(error: BaseException) -> str:
    match error:
        case InputError():
            return str(error)
        case RuntimeError():
            return f"the workbench failed: {error}"
        case _:
            return _ENDED


class _Guarded(RequestHandler):
    """Handler that answers only its own page; answers cannot be cached, framed or given another type."""

    def initialize(self, bench: Bench) -> None:
        self.bench = bench
        # whether the page was closed
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
        if why := _refusal(self.bench, self.request):
            self.refuse(403, why)
        elif not _is_let_in(self.bench, self.request):
            self.turn_away()

    def on_finish(self) -> None:
        assert isinstance(self.application, BoundedApplication)
        self.application.forget_body(self.request)

    def turn_away(self) -> None:
        """Refuse a browser without a valid cookie."""
        self.refuse(403, "this browser is not let in; open the address that the terminal shows")

    def refuse(self, status: int, why: str) -> None:
        self.set_status(status)
        self.finish({"refused": why})

    def explain(self, status: int, page: str) -> None:
        """Answer with a page that contains only text."""
        self.set_status(status)
        self.set_header("Content-Security-Policy", "default-src 'none'; img-src data:; frame-ancestors 'none'")
        self.set_header("Content-Type", "text/html; charset=utf-8")
        self.finish(page)

    def write_error(self, status_code: int, **_: Any) -> None:
        refused = f"need GET or POST, got {self.request.method}" if status_code == 405 else "the workbench failed"
        self.finish({"refused": f"{refused} ({status_code})"})

    def read_request(self, kind: type[PageRequest]) -> PageRequest | None:
        """Return the request of the page; None after a refusal if it cannot be read."""
        if self.request.headers.get("Content-Type", "").partition(";")[0] != "application/json":
            self.refuse(415, "need application/json")
            return None
        try:
            return kind.model_validate_json(self.request.body)
        except ValidationError as error:
            first = error.errors(include_url=False)[0]
            self.refuse(400, f"{'.'.join(map(str, first['loc']))}: {first['msg'].removeprefix('Value error, ')}")
            return None


class _Nothing(_Guarded):
    def turn_away(self) -> None:
        self.refuse(404, "not found")

    def prepare(self) -> None:
        super().prepare()
        if not self._finished:
            self.turn_away()


class _Entrance(_Guarded):
    """Exchanges a token for the cookie, and leads to the page."""

    def prepare(self) -> None:
        # the address may come from a file, a terminal or a bookmark, so that Sec-Fetch-Site is not checked
        if why := _refusal(self.bench, self.request, by_site=False):
            self.refuse(403, why)

    def get(self, token: str) -> None:
        access = self.bench.access
        if not access.exchange(token):
            self.explain(403, refused_page("Its address has been used before, or was never valid."))
            return
        self.set_cookie(access.cookie_name, access.cookie, path=access.path, httponly=True, samesite="Strict")
        self.explain(200, redirect_page(access.path))


class _Page(_Guarded):
    def turn_away(self) -> None:
        self.explain(403, refused_page("It has not been let in since this workbench was started."))

    def get(self) -> None:
        self.set_header("Content-Type", "text/html; charset=utf-8")
        self.finish(workbench_page(self.bench.opened))


class _Answer(_Guarded):
    request_type: type[PageRequest] = DesignRequest

    @property
    def session(self) -> WorkerSession:
        return self.bench.quick

    async def post(self, task: Task) -> None:
        if (request := self.read_request(PICTURE_REQUESTS.get(task, self.request_type))) is None:
            return
        try:
            await self.finish(await self.session.do(self, task, request))
        except _REPORTED as error:
            # a value that is not allowed is a regular answer
            if not self.gone:
                await self.finish({"refused": _reason(error)})

    def on_connection_close(self) -> None:
        self.gone = True
        self.session.leave(self)


class _Drag(_Answer):
    """Answers with the equilibrium of a structure that is dragged."""

    request_type = DragRequest

    @property
    def session(self) -> WorkerSession:
        return self.bench.statics


class _Traced(_Answer):
    """Answers with what is found in a picture, or with the pattern after vertices have moved."""

    @property
    def session(self) -> WorkerSession:
        return self.bench.slow


class _Lines(_Guarded):
    """Answers line by line while work continues."""

    @property
    def session(self) -> WorkerSession:
        raise NotImplementedError

    def line(self, content: dict[str, Any]) -> None:
        if not self.gone:
            self.write(f"{json.dumps(content)}\n")
            self.flush()

    def on_connection_close(self) -> None:
        self.gone = True
        self.session.leave(self)


class _Fold(_Lines):
    """Answers with the picture of a structure, then with its fold path, which grows and is refined."""

    @property
    def session(self) -> WorkerSession:
        return self.bench.statics

    async def post(self, task: Task) -> None:
        if (request := self.read_request(FoldRequest)) is None:
            return
        self.set_header("Content-Type", "application/x-ndjson")
        try:
            await self.session.do(self, task, request, report=self.line)
            self.line({"done": True})
        except _REPORTED as error:
            self.line({"refused": _reason(error)})


class _Results(_Lines):
    """Answers with progress, and at the end with the path of the results."""

    @property
    def session(self) -> WorkerSession:
        return self.bench.slow

    async def post(self, task: Task) -> None:
        if (request := self.read_request(DesignRequest)) is None:
            return
        self.set_header("Content-Type", "application/x-ndjson")
        self.bench.results += 1
        number = self.bench.results
        try:
            await self.session.do(
                self, task, request, self.bench.folder / str(number), lambda text: self.line({"doing": text})
            )
            self.line({"done": f"results/{number}/{_REPORT}"})
        except _REPORTED as error:
            self.line({"refused": _reason(error)})


class _Report(_Guarded):
    def get(self, number: str) -> None:
        report = self.bench.folder / number / _REPORT
        if not report.is_file():
            self.refuse(404, "not found")
            return
        self.set_header("Content-Security-Policy", "frame-ancestors 'self'")
        self.set_header("Content-Type", "text/html; charset=utf-8")
        self.finish(report.read_bytes())


def workbench_page(opened: Opened) -> str:
    """Return the page of a workbench, which requests all data of a design from the server."""
    name = design_source(DesignRequest(), opened)
    data = {
        "kind": "workbench",
        "opened": name,
        "settings": dict(opened.settings),
        "designs": [{"name": known, "shows": load_design(known).shows or ""} for known in named_designs()],
    }
    body = '<header><h1></h1></header>\n<main id="workbench"></main>\n'
    return page_html(f"{Path(name).stem}: workbench", body, data, served=True)
