"""Firefox from the system, controlled by WebDriver BiDi (https://w3c.github.io/webdriver-bidi/) without a driver."""

import base64
import io
import itertools
import json
import os
import re
import shutil
import subprocess
import time
from contextlib import contextmanager, suppress
from pathlib import Path

from PIL import Image
from websockets.sync.client import connect

SECONDS = 30.0
INSTALL = "apt-get install firefox-esr xvfb libegl1 libgl1-mesa-dri"
KEYS = {"Tab": "\ue004", "Enter": "\ue007", " ": " ", "ArrowRight": "\ue014", "Home": "\ue011", "End": "\ue010"}
LEFT = 0  # button of a mouse
# nothing listens at port 9, and no name is looked up: the network is cut
PREFERENCES = {
    "network.proxy.type": 1,
    "network.proxy.http": "127.0.0.1",
    "network.proxy.http_port": 9,
    "network.proxy.ssl": "127.0.0.1",
    "network.proxy.ssl_port": 9,
    "network.dns.disabled": True,
    "ui.prefersReducedMotion": 1,
    "webgl.force-enabled": True,
    "browser.shell.checkDefaultBrowser": False,
    "datareporting.policy.dataSubmissionEnabled": False,
}
SCHEMES = {"dark": 0, "light": 1}


def firefox_path():
    """Return the path of the browser's program, or None."""
    names = ("firefox", "firefox-esr")
    return os.environ.get("FORFICULA_FIREFOX") or next(filter(None, map(shutil.which, names)), None)


class Firefox:
    """A browser with one window; `messages` are those of its console, `requests` the requested addresses."""

    def __init__(self, socket):
        self._socket = socket
        self._numbers = itertools.count(1)
        self.messages: list[str] = []
        self.requests: list[str] = []
        self._command("session.new", capabilities={})
        self._command("session.subscribe", events=["log.entryAdded", "network.beforeRequestSent"])
        self._window = self._command("browsingContext.getTree")["contexts"][0]["context"]

    def open(self, path, width, height):
        """Open a file, or an address, in a new window of a size in pixels; returns itself."""
        viewport = {"width": width, "height": height}
        self._command("browsingContext.setViewport", context=self._window, viewport=viewport)
        self.messages, self.requests = [], []
        url = path if isinstance(path, str) else path.as_uri()
        self._command("browsingContext.navigate", context=self._window, url=url, wait="complete")
        return self

    def evaluate(self, expression):
        """Return the value of an expression of the page's script as JSON; promises are awaited."""
        text = f"(async () => JSON.stringify((await ({expression})) ?? null))()"
        target = {"context": self._window}
        answer = self._command("script.evaluate", expression=text, target=target, awaitPromise=True)
        assert answer["type"] == "success", f"{expression}: {answer}"
        return json.loads(answer["result"]["value"])

    def until(self, expression, seconds=SECONDS):
        end = time.monotonic() + seconds
        while not self.evaluate(expression):
            assert time.monotonic() < end, f"never came: {expression}"
            time.sleep(0.05)

    def press(self, *keys):
        """Press keys one after another; a letter is itself, others have the names of `KEYS`."""
        strokes = [{"type": kind, "value": KEYS.get(key, key)} for key in keys for kind in ("keyDown", "keyUp")]
        self._act({"type": "key", "id": "keyboard", "actions": strokes})

    def click(self, selector):
        """Click the centre of an element."""
        self.evaluate(f"document.querySelector({json.dumps(selector)}).scrollIntoView({{ block: 'center' }})")
        box = self._box(selector)
        middle = {axis: round(box[axis] + box[size] / 2) for axis, size in (("x", "width"), ("y", "height"))}
        strokes = [
            {"type": "pointerMove", **middle},
            {"type": "pointerDown", "button": LEFT},
            {"type": "pointerUp", "button": LEFT},
        ]
        self._act({"type": "pointer", "id": "mouse", "actions": strokes})

    def picture(self, selector):
        """Take a screenshot of an element."""
        self.evaluate(f"document.querySelector({json.dumps(selector)}).scrollIntoView({{ block: 'center' }})")
        clip = {"type": "box", **self._box(selector)}
        answer = self._command("browsingContext.captureScreenshot", context=self._window, clip=clip)
        return Image.open(io.BytesIO(base64.b64decode(answer["data"]))).convert("RGB")

    def _box(self, selector):
        words = "(({ x, y, width, height }) => ({ x, y, width, height }))"
        return self.evaluate(f"{words}(document.querySelector({json.dumps(selector)}).getBoundingClientRect())")

    def _act(self, actions):
        self._command("input.performActions", context=self._window, actions=[actions])

    def _command(self, method, **parameters):
        """Send a command and wait for its reply; events received meanwhile are kept."""
        number = next(self._numbers)
        self._socket.send(json.dumps({"id": number, "method": method, "params": parameters}))
        while True:
            output = json.loads(self._socket.recv(timeout=SECONDS))
            if output.get("id") == number:
                assert output["type"] == "success", f"{method}: {output}"
                return output["result"]
            self._hear(output)

    def _hear(self, event):
        if event["method"] == "log.entryAdded":
            self.messages.append(f"{event['params']['level']}: {event['params']['text']}")
        else:
            self.requests.append(event["params"]["request"]["url"])


@contextmanager
def running(program, folder: Path, scheme="light"):
    """Firefox with a profile of its own in a folder, light or dark."""
    preferences = PREFERENCES | {"layout.css.prefers-color-scheme.content-override": SCHEMES[scheme]}
    folder.mkdir()
    lines = [f'user_pref("{name}", {json.dumps(value)});' for name, value in preferences.items()]
    (folder / "user.js").write_text("\n".join(lines), "utf-8")
    with _screen() as (options, environment):
        command = [program, *options, "--no-remote", "--profile", str(folder), "--remote-debugging-port", "0"]
        with (
            _process([*command, "about:blank"], stderr=subprocess.PIPE, env=environment) as process,
            connect(f"{_address(process)}/session", max_size=None, proxy=None) as socket,
        ):
            yield Firefox(socket)


@contextmanager
def _screen():
    """Return options of Firefox and its environment for an invisible screen.

    Without any screen Firefox on Linux has no WebGL, not even by the processor: where Xvfb is, it makes one.
    """
    if not shutil.which("Xvfb"):
        yield ([] if "DISPLAY" in os.environ else ["--headless"]), None
        return
    command = ["Xvfb", "-displayfd", "1", "-screen", "0", "1600x1200x24", "-nolisten", "tcp"]
    with _process(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL) as process:
        yield [], {**os.environ, "DISPLAY": f":{int(process.stdout.readline())}"}


@contextmanager
def _process(command, **streams):
    """A program that ends with the context."""
    with subprocess.Popen(command, **({"stdout": subprocess.DEVNULL} | streams)) as process:
        try:
            yield process
        finally:
            process.terminate()
            with suppress(subprocess.TimeoutExpired):
                process.wait(SECONDS)
            process.kill()


def _address(process):
    """Return the address at which it listens, which it prints on its standard error."""
    said = []
    for line in process.stderr:
        said.append(line.decode(errors="replace"))
        if result := re.search(r"WebDriver BiDi listening on (ws://\S+)", said[-1]):
            return result[1]
    raise AssertionError(f"Firefox ended: {''.join(said)}")
