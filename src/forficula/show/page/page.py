"""One HTML file with its style, script and data inside, without access to the network."""

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
_NO_SCRIPT = "Without JavaScript there is no motion and there are no plots; all numbers are below."


def page_path(path: object) -> Path:
    """Check the path of a page.

    Raises:
        InputError: it is not a path, or does not end with .html.
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

    Only the packed script may run, identified by its hash, and nothing may be fetched: a design's name that looks like
    a script stays text, and the page works offline.

    Args:
        title: title of the window.
        body: contents, as escaped HTML.
        data: data for the script; "kind" selects its view. None for a page of figures and tables only, whose script
            saves figures.
        live: data of a structure that the engine simulates in the page, from `live_data`; None for a page without the
                engine.
        served: whether the page may send requests to the server that it comes from, which then provides the data of
                structures; the page contains the engine.
    """
    script, style = built("still.js" if data is None else "page.js"), built("page.css")
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
{_live(live)}{_engine() if served or _moves(live) else ""}{_data(data)}<script>{script}</script>
</body>
</html>
"""


def _moves(live: dict[str, Any] | None) -> bool:
    return live is not None and "refused" not in live


def _live(live: dict[str, Any] | None) -> str:
    """Return the element with the data of the structure to simulate, which the script reads only when needed."""
    return "" if live is None else f'<script type="application/json" id="live">{_json(live)}</script>\n'


def _engine() -> str:
    """Return the elements with the engine, which the script reads only when needed."""
    script = base64.b64encode(zlib.compress(built("engine.js").encode(), 9)).decode("ascii")
    program = base64.b64encode((_BUILT / "engine.wasm.gz").read_bytes()).decode("ascii")
    return (
        f'<script type="text/plain" id="engine-script">{script}</script>\n'
        f'<script type="text/plain" id="engine-program">{program}</script>\n'
    )


def _json(data: dict[str, Any]) -> str:
    # "<" could close the element that contains the data
    return json.dumps(data, separators=(",", ":"), ensure_ascii=False, allow_nan=False).replace("<", "\\u003c")


def _data(data: dict[str, Any] | None) -> str:
    """Return the element with the data of the script; empty for a page without data."""
    if data is None:
        return ""
    return f'<script type="application/json" id="data">{_json(data | {"reading_units": READING_UNITS})}</script>\n'


def built(name: str) -> str:
    """Return a file that is built from the folder web/."""
    return (_BUILT / name).read_text("utf-8")


def _policy(script: str, *, engine: bool, served: bool) -> str:
    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode("ascii")
    # the engine is compiled from text in the page and runs in a worker made from text in the page
    compiled, worker = (" 'wasm-unsafe-eval'", " worker-src blob:;") if engine else ("", "")
    requests = " connect-src 'self'; frame-src 'self';" if served else ""
    return (
        f"default-src 'none'; script-src 'sha256-{digest}'{compiled};{worker}{requests} style-src 'unsafe-inline';"
        " img-src data: blob:; base-uri 'none'; form-action 'none'"
    )
