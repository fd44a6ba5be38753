"""One HTML file that needs nothing else: style, script and data in it, and no way to the network."""

from __future__ import annotations

import base64
import hashlib
import json
import zlib
from importlib import resources
from pathlib import Path
from typing import Any

from forficula.errors import InputError
from forficula.files import as_path
from forficula.quantities import READING_UNITS
from forficula.show.page.parts.html import escaped

_BUILT = resources.files("forficula.show.page") / "built"
_NO_SCRIPT = "Without JavaScript nothing moves and there are no plots; the numbers below are all there."


def page_path(path: object) -> Path:
    """Take the path of a page.

    Raises:
        InputError: it is none, or does not end with .html.
    """
    file = as_path(path, "a file that ends with .html")
    if file.suffix != ".html":
        raise InputError(f"need a file that ends with .html, got {file}")
    return file


def page_html(
    title: str,
    body: str,
    data: dict[str, Any] | None,
    live: dict[str, Any] | None = None,
    *,
    served: bool = False,
) -> str:
    """Assemble a page.

    Only the packed script may run, named by its hash, and nothing may be fetched: a name of a design that looks like a
    script stays text, and the page works without a network as it does with one.

    Args:
        title: of the window.
        body: HTML, already escaped.
        data: what the script shows; its "kind" says how. None for a page on which nothing moves, which has no script.
        live: of a structure that the engine is to move in the page, from `live_data`; None where there is none, and so
            no engine in the page.
        served: whether the page may ask the server that it comes from, which then tells what is live; the engine is in
            it.
    """
    script, style = "" if data is None else built("page.js"), built("page.css")
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="{_policy(script, engine=served or _moves(live), served=served)}">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta name="generator" content="forficula">
<link rel="icon" href="data:,">
<title>{escaped(title)}</title>
<style>{style}</style>
</head>
<body>
{"" if data is None else f'<noscript><aside class="note">{_NO_SCRIPT}</aside></noscript>'}
{body}
{_live(live)}{_engine() if served or _moves(live) else ""}{"" if data is None else _scripted(data, script)}</body>
</html>
"""


def _moves(live: dict[str, Any] | None) -> bool:
    return live is not None and "refused" not in live


def _live(live: dict[str, Any] | None) -> str:
    """What is live, only read once it is asked for."""
    return "" if live is None else f'<script type="application/json" id="live">{_json(live)}</script>\n'


def _engine() -> str:
    """The engine, alike."""
    script = base64.b64encode(zlib.compress(built("engine.js").encode(), 9)).decode("ascii")
    program = base64.b64encode((_BUILT / "engine.wasm.gz").read_bytes()).decode("ascii")
    return (
        f'<script type="text/plain" id="engine-script">{script}</script>\n'
        f'<script type="text/plain" id="engine-program">{program}</script>\n'
    )


def _json(data: dict[str, Any]) -> str:
    # "<" could end the element that the data stand in
    return json.dumps(data, separators=(",", ":"), ensure_ascii=False, allow_nan=False).replace("<", "\\u003c")


def _scripted(data: dict[str, Any], script: str) -> str:
    return f"""<script type="application/json" id="data">{_json(data | {"reading_units": READING_UNITS})}</script>
<script>{script}</script>
"""


def built(name: str) -> str:
    """A file that is built from the folder web/."""
    return (_BUILT / name).read_text("utf-8")


def _policy(script: str, *, engine: bool, served: bool) -> str:
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode("ascii")
    # the engine is compiled of what stands in the page, and runs in a worker that is made of it
    compiled, worker = (" 'wasm-unsafe-eval'", " worker-src blob:;") if engine else ("", "")
    asked = " connect-src 'self'; frame-src 'self';" if served else ""
    return (
        f"default-src 'none'; script-src 'sha256-{digest}'{compiled};{worker}{asked} style-src 'unsafe-inline';"
        " img-src data: blob:; base-uri 'none'; form-action 'none'"
    )
