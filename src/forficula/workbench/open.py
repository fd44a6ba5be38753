"""Open a workbench: serve it, print its address, and show it in a browser."""

from __future__ import annotations

import threading
import webbrowser
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path

from forficula.workbench.requests import opened_with
from forficula.workbench.server import serve


def open_workbench(
    design: str, settings: Mapping[str, str], unit: float | None, port: int | None, *, browser: bool
) -> None:
    """Serve a workbench until it is interrupted.

    Args:
        design: a named design, or the path of a file.
        settings: values by dotted key, as text, with which its page begins.
        unit: length of the unit of a FOLD file or drawing that states none, m.
        port: port of the server; any free one if not given.
        browser: whether to open a browser.

    Raises:
        InputError: the design cannot be read, or the port is not available.
        KeyboardInterrupt: ctrl-C.
    """
    announced = False

    def announce(address: str) -> None:
        nonlocal announced
        if announced:
            text = f"that address has been used; for another browser open {address}"
        else:
            text = f"open at {address}\nthe address works once, then the next one is shown here\nctrl-C ends it"
        announced = True
        # the terminal may have been closed
        with suppress(OSError, ValueError):
            print(text, flush=True)

    def browse(file: Path) -> None:
        # some browsers block until they are closed
        threading.Thread(target=webbrowser.open, args=(file.as_uri(),), daemon=True).start()

    # an unreadable design is reported in the terminal, not on the page
    serve(opened_with(design, settings, unit), port, announce, browse if browser else None)
