"""Bounds on what a workbench keeps in memory of requests, checked from their headers."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from tornado.http1connection import HTTP1Connection, HTTP1ServerConnection
from tornado.httputil import HTTPConnection, HTTPMessageDelegate, HTTPServerRequest
from tornado.web import Application

LARGEST = 20_000_000  # bytes of what a page sends
_IN_ALL = 4 * LARGEST  # bytes of what all pages send at the same time
# bytes of what anyone else sends: enough to be answered with the reason for a refusal
LARGEST_REFUSED = 4096
# connections that have shown no cookie; each keeps at most some 100 kB
_STRANGERS = 64


class BoundedApplication(Application):
    """Answers requests, of which it reads no more than their sender may send.

    The bound of a body is set once the headers of its request are read, and before anything of the body is. Of
    connections without a valid cookie the oldest is closed for a new one, so that nobody can keep others out by holding
    connections.
    """

    def __init__(
        self,
        handlers: list[Any],
        default: Any,
        shared: dict[str, Any],
        admits: Callable[[HTTPServerRequest], bool],
    ) -> None:
        # what is refused the page says
        super().__init__(
            handlers, default_handler_class=default, default_handler_args=shared, log_function=lambda _: None
        )
        self._admits = admits
        # in the order in which they came
        self._strangers: dict[HTTP1ServerConnection, None] = {}
        self._bodies: dict[HTTP1ServerConnection, int] = {}
        self._known: set[HTTP1ServerConnection] = set()

    def start_request(self, server_conn: object, request_conn: HTTPConnection) -> HTTPMessageDelegate:
        """Begin with a request, of which nothing has been read yet."""
        assert isinstance(server_conn, HTTP1ServerConnection)
        self._forget_closed()
        if server_conn not in self._known:
            self._strangers[server_conn] = None
        for oldest in list(self._strangers)[:-_STRANGERS]:
            del self._strangers[oldest]
            oldest.stream.close()
        return super().start_request(server_conn, request_conn)

    def find_handler(self, request: HTTPServerRequest, **_: Any) -> Any:
        """Bound the body of a request whose headers have been read, and find who answers it."""
        connection, request_conn = request.server_connection, request.connection
        assert isinstance(connection, HTTP1ServerConnection)
        assert isinstance(request_conn, HTTP1Connection)
        largest, length = LARGEST_REFUSED, request.headers.get("Content-Length", "")
        if self._admits(request):
            self._strangers.pop(connection, None)
            self._known.add(connection)
            # a page says how much it sends; a body in chunks does not, and stays small
            size = int(length) if re.fullmatch("[0-9]{1,12}", length) else 0
            if size and size + sum(self._bodies.values()) <= _IN_ALL:
                self._bodies[connection], largest = size, LARGEST
        request_conn.set_max_body_size(largest)
        return super().find_handler(request)

    def forget_body(self, request: HTTPServerRequest) -> None:
        """Count a body no longer, because its request has been answered."""
        assert isinstance(request.server_connection, HTTP1ServerConnection)
        self._bodies.pop(request.server_connection, None)

    def _forget_closed(self) -> None:
        self._strangers = {each: None for each in self._strangers if not each.stream.closed()}
        self._bodies = {each: size for each, size in self._bodies.items() if not each.stream.closed()}
        self._known = {each for each in self._known if not each.stream.closed()}
