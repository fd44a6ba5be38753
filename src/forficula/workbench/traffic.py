"""Bounds on the memory that requests to a workbench may take, checked from their headers."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from tornado.http1connection import HTTP1Connection, HTTP1ServerConnection
from tornado.httputil import HTTPConnection, HTTPMessageDelegate, HTTPServerRequest
from tornado.web import Application

LARGEST = 20_000_000  # bytes of a request of the page
_IN_ALL = 4 * LARGEST  # bytes of all simultaneous requests of pages
# bytes of any other request: enough to answer it with the reason for a refusal
LARGEST_REFUSED = 4096
# connections without a valid cookie; each takes at most about 100 kB
_STRANGERS = 64


class BoundedApplication(Application):
    """Web application that reads no more of a request than its sender is allowed to send.

    The bound of a body is set after the headers of its request are read, and before the body is read. When there are
    too many connections without a valid cookie, the oldest one is closed, so that nobody can block others by keeping
    connections open.
    """

    def __init__(
        self,
        handlers: list[Any],
        default: Any,
        shared: dict[str, Any],
        admits: Callable[[HTTPServerRequest], bool],
    ) -> None:
        # the page reports refusals, so that no log is needed
        super().__init__(
            handlers, default_handler_class=default, default_handler_args=shared, log_function=lambda _: None
        )
        self._admits = admits
        # in order of arrival
        self._strangers: dict[HTTP1ServerConnection, None] = {}
        self._bodies: dict[HTTP1ServerConnection, int] = {}
        self._known: set[HTTP1ServerConnection] = set()

    def start_request(self, server_conn: object, request_conn: HTTPConnection) -> HTTPMessageDelegate:
        """Begin to read a request."""
        assert isinstance(server_conn, HTTP1ServerConnection)
        self._forget_closed()
        if server_conn not in self._known:
            self._strangers[server_conn] = None
        for oldest in list(self._strangers)[:-_STRANGERS]:
            del self._strangers[oldest]
            oldest.stream.close()
        return super().start_request(server_conn, request_conn)

    def find_handler(self, request: HTTPServerRequest, **_: Any) -> Any:
        """Bound the body of a request whose headers have been read, and return its handler."""
        connection, request_conn = request.server_connection, request.connection
        assert isinstance(connection, HTTP1ServerConnection)
        assert isinstance(request_conn, HTTP1Connection)
        largest, length = LARGEST_REFUSED, request.headers.get("Content-Length", "")
        if self._admits(request):
            self._strangers.pop(connection, None)
            self._known.add(connection)
            # the page states the length of its body; a chunked body has no stated length, and keeps the small bound
            size = int(length) if re.fullmatch("[0-9]{1,12}", length) else 0
            if size and size + sum(self._bodies.values()) <= _IN_ALL:
                self._bodies[connection], largest = size, LARGEST
        request_conn.set_max_body_size(largest)
        return super().find_handler(request)

    def forget_body(self, request: HTTPServerRequest) -> None:
        """Remove the body of an answered request from the total."""
        assert isinstance(request.server_connection, HTTP1ServerConnection)
        self._bodies.pop(request.server_connection, None)

    def _forget_closed(self) -> None:
        self._strangers = {connection: None for connection in self._strangers if not connection.stream.closed()}
        self._bodies = {connection: size for connection, size in self._bodies.items() if not connection.stream.closed()}
        self._known = {connection for connection in self._known if not connection.stream.closed()}
