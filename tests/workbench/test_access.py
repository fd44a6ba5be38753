"""Who is let in to a workbench, and how much of what others send it keeps."""

import json
import os
import re
import socket
import stat
import sys
import time
from pathlib import Path
from urllib.parse import urlsplit
from urllib.request import url2pathname

import pytest

from forficula.workbench.traffic import LARGEST, LARGEST_REFUSED
from tests.workbench.serving import SECONDS, enter, serving

JSON = {"Content-Type": "application/json"}


@pytest.fixture(scope="module")
def served(tmp_path_factory):
    with serving("letter-fold", folder=tmp_path_factory.mktemp("bench")) as it:
        yield it


def test_an_address_works_once_and_the_terminal_shows_the_next_one(served):
    address = served.invitation()
    status, cookie, path = enter(address)
    assert status == 200
    assert served.address.endswith(path)
    assert cookie.startswith(f"forficula-{served.port}=")
    assert set(cookie.split("; ")[1:]) == {"HttpOnly", "SameSite=Strict", f"Path={path}"}
    status, cookie, page = enter(address)
    assert (status, cookie) == (403, "")
    assert "has been used before" in page
    assert "The terminal in which" in page
    assert served.cookie.partition("=")[2] not in page
    assert path not in page
    again = served.invitation()
    assert again != address
    assert enter(again)[0] == 200


def test_the_path_of_the_page_alone_lets_nobody_in(served):
    for cookie in ("", f"forficula-{served.port}=wrong", "forficula-1=" + served.cookie.partition("=")[2]):
        status, page = served.request("GET", headers={"Cookie": cookie})
        assert status == 403
        assert b"The terminal in which" in page
        for what in ("design", "run", "results/1/report.html"):
            method = "GET" if "results" in what else "POST"
            status, answer = served.request(method, what, "{}", JSON | {"Cookie": cookie})
            assert status == 403
            assert b"this browser is not let in" in answer


def test_a_browser_comes_in_from_a_file_but_not_by_another_host(served):
    address = served.invitation()
    path = urlsplit(address).path
    assert served.request("GET", path, headers={"Host": "workbench.example"})[0] == 403
    assert served.request("HEAD", path)[0] == 405
    assert served.request("GET", path, headers={"Sec-Fetch-Site": "cross-site"})[0] == 200


@pytest.mark.skipif(sys.platform != "linux", reason="there BROWSER names the browser")
def test_the_command_line_of_the_browser_holds_no_secret(tmp_path, monkeypatch):
    """Every account of a machine reads the command lines of all."""
    (tmp_path / "browser.py").write_text("import sys, pathlib; pathlib.Path('shown').write_text(sys.argv[1])", "utf-8")
    monkeypatch.setenv("BROWSER", f"{sys.executable} {tmp_path / 'browser.py'} %s")
    monkeypatch.setenv("TMPDIR", str(tmp_path))
    with serving("letter-fold", folder=tmp_path, quietly=False) as served:
        end = time.monotonic() + SECONDS
        while not (tmp_path / "shown").exists() or not (tmp_path / "shown").read_text():
            assert time.monotonic() < end
            time.sleep(0.05)
        file = Path(url2pathname(urlsplit((tmp_path / "shown").read_text()).path))
        assert stat.S_IMODE(file.stat().st_mode) == 0o600
        assert stat.S_IMODE(file.parent.stat().st_mode) == 0o700
        (address,) = re.findall(r"url=(\S+)\"", file.read_text("utf-8"))
        token = address.rpartition("/")[2]
        for process in Path("/proc").glob("[0-9]*/cmdline"):
            try:
                assert token.encode() not in process.read_bytes()
            except OSError:  # it has ended
                continue
        status, _, path = enter(address)
        assert (status, served.address.endswith(path)) == (200, True)
        assert not file.exists()
        assert enter(address)[0] == 403


def head_of(served, path, length, cookie="", host=None):
    """The headers of a request, as they are sent."""
    host = host or f"127.0.0.1:{served.port}"
    lines = [f"POST {path} HTTP/1.1", f"Host: {host}", "Content-Type: application/json", f"Content-Length: {length}"]
    return "\r\n".join([*lines, *[f"Cookie: {cookie}"] * bool(cookie), "", ""]).encode()


def connect(served):
    return socket.create_connection(("127.0.0.1", served.port), timeout=SECONDS)


@pytest.mark.parametrize("what", ["host", "path", "cookie"])
def test_a_large_body_is_refused_before_it_is_sent_where_its_sender_is_not_let_in(served, what):
    path = "/nope" if what == "path" else urlsplit(served.address).path + "design"
    cookie = "" if what == "cookie" else served.cookie
    with connect(served) as stranger:
        stranger.sendall(head_of(served, path, LARGEST_REFUSED + 1, cookie, "evil" if what == "host" else None))
        # not a byte of the body is there
        assert stranger.recv(100).startswith(b"HTTP/1.1 400 ")
    with connect(served) as page:
        page.sendall(head_of(served, urlsplit(served.address).path + "design", LARGEST, served.cookie))
        page.settimeout(0.2)
        with pytest.raises(TimeoutError):
            page.recv(100)


@pytest.mark.skipif(sys.platform != "linux", reason="there memory is read from /proc")
def test_many_strangers_with_large_bodies_cost_little_memory(served):
    def resident():
        pages = int(Path(f"/proc/{served.process.pid}/statm").read_text().split()[1])
        return pages * os.sysconf("SC_PAGE_SIZE")

    served.ask("design")
    before, held = resident(), []
    for path in ("/nope", urlsplit(served.address).path + "design"):
        for _ in range(20):
            stranger = connect(served)
            held.append(stranger)
            try:
                stranger.sendall(head_of(served, path, LARGEST) + bytes(LARGEST // 10))
            except OSError:  # cut off
                continue
    # with every body 80 MB were sent
    assert resident() - before < 20e6
    assert served.ask("design")["name"] == "letter-fold"
    for stranger in held:
        stranger.close()


def test_pages_together_send_no_more_than_a_bound(served):
    """Four bodies of the largest size are taken at a time, and others once these have gone."""
    path = urlsplit(served.address).path + "design"
    pages = [connect(served) for _ in range(5)]
    for page in pages:
        page.sendall(head_of(served, path, LARGEST, served.cookie))
        time.sleep(0.05)
    assert pages[-1].recv(100).startswith(b"HTTP/1.1 400 ")
    for page in pages:
        page.close()
    end = time.monotonic() + SECONDS
    while True:
        with connect(served) as page:
            page.sendall(head_of(served, path, LARGEST, served.cookie))
            page.settimeout(0.2)
            try:
                assert page.recv(100).startswith(b"HTTP/1.1 400 ")
            except TimeoutError:
                break
        assert time.monotonic() < end


def test_idle_connections_of_strangers_keep_nobody_out(served):
    held = [connect(served) for _ in range(300)]
    assert served.ask("design")["name"] == "letter-fold"
    # the oldest were closed
    held[0].settimeout(SECONDS)
    assert held[0].recv(1) == b""
    held[-1].settimeout(0.2)
    with pytest.raises(TimeoutError):
        held[-1].recv(1)
    for stranger in held:
        stranger.close()


def test_what_no_page_can_send_is_refused_with_a_reason(served):
    """Each of these was a traceback in the terminal, which an answer of status 500 or a failed task comes from."""
    status, answer = served.request("POST", "design", "{}", JSON | {"Origin": "http://["})
    assert status == 403
    assert b"this workbench answers requests of its own page" in answer
    for requested, reason in (
        (
            {"files": [{"name": "\N{GRINNING FACE}" * 90 + ".toml", "text": ""}]},
            b"need a file name of at most 255 bytes",
        ),
        ({"settings": {"a." * 3000 + "b": "1"}}, b"need keys of at most 300 letters"),
    ):
        status, answer = served.request("POST", "design", json.dumps(requested), JSON)
        assert status == 400
        assert reason in answer
