"""A workbench in a process of its own, as the command line opens it, and what asks it."""

import http.client
import json
import os
import re
import signal
import subprocess
import sys
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from urllib.parse import urlsplit

SECONDS = 120  # for what takes a few, on a machine that is busy


@dataclass(frozen=True, kw_only=True)
class Served:
    """A workbench that answers.

    Attributes:
        process: its own.
        address: of its page.
        cookie: of a browser that has been let in.
    """

    process: subprocess.Popen
    address: str
    cookie: str

    @property
    def port(self) -> int:
        port = urlsplit(self.address).port
        assert port is not None
        return port

    def invitation(self):
        """The address that its terminal shows next, which lets one more browser in."""
        return printed_address(self.process)

    def request(self, method, path="", body=None, headers=None):
        """Status and bytes of an answer; a path without a slash is below that of the page."""
        headers = {"Cookie": self.cookie} | (headers or {})
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=SECONDS)
        whole = path if path.startswith("/") else urlsplit(self.address).path + path
        connection.request(method, whole, body, headers)
        answer = connection.getresponse()
        result = answer.status, answer.read()
        connection.close()
        return result

    def ask(self, what, **values):
        """What it says to a design."""
        status, content = self.request("POST", what, json.dumps(values), {"Content-Type": "application/json"})
        assert status == 200, content
        return json.loads(content)

    def interrupt(self, by=signal.SIGINT):
        """Press ctrl-C, or end it otherwise; its errors, and its exit code."""
        self.process.send_signal(by)
        _, errors = self.process.communicate(timeout=SECONDS)
        return errors, self.process.returncode


def printed_address(process):
    """The next address on the terminal of a workbench."""
    while line := process.stdout.readline():
        if result := re.search(r"http://\S+/open/\S+", line):
            return result[0]
    raise AssertionError(process.communicate()[1])


def enter(address):
    """Open an address as a browser does: the status, the cookie that is set, and the path that the answer leads to."""
    parts = urlsplit(address)
    connection = http.client.HTTPConnection("127.0.0.1", parts.port, timeout=SECONDS)
    connection.request("GET", parts.path)
    answer = connection.getresponse()
    status, cookie, page = answer.status, answer.headers.get("Set-Cookie", ""), answer.read().decode()
    connection.close()
    leads = re.search(r'http-equiv="refresh" content="0; url=([^"]+)"', page)
    return status, cookie, leads[1] if leads else page


@contextmanager
def serving(*arguments, folder, quietly=True):
    """Open a workbench with these arguments of the command line, without a browser unless that is wanted."""
    import forficula

    command = [sys.executable, "-m", "forficula", "open", *arguments, *["--no-browser"] * quietly]
    # wherever it begins, it is this package
    environment = os.environ | {"PYTHONPATH": str(Path(forficula.__file__).parents[1])}
    pipes = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE}
    process = subprocess.Popen(command, cwd=folder, env=environment, text=True, **pipes)
    try:
        _, cookie, page = enter(address := printed_address(process))
        yield Served(process=process, address=address.partition("/open/")[0] + page, cookie=cookie.partition(";")[0])
    finally:
        if process.poll() is None:
            # a job in the background ignores ctrl-C
            process.send_signal(signal.SIGKILL if signal.getsignal(signal.SIGINT) == signal.SIG_IGN else signal.SIGINT)
        process.communicate(timeout=SECONDS)
